#include "jobs/scale_grid.hpp"

#include "certificate/rounding.hpp"
#include "numerics/bits.hpp"
#include "numerics/real.hpp"

namespace netmesh {
namespace {

double larger_of(double a, double b) { return a > b ? a : b; }
double smaller_of(double a, double b) { return a < b ? a : b; }

}  // namespace

// Positive doubles are ordered as their bits are; the highest of these are the number of a cell.
bool ScaleGrid::open(double least, double most, Arena& arena) {
    constexpr int sixteenths = 48;
    shift_ = sixteenths;
    const std::uint64_t low = bits_of(least), high = bits_of(most);
    while ((high >> shift_) - (low >> shift_) >= cells_max) ++shift_;
    base_ = low >> shift_;
    count_ = static_cast<std::uint32_t>((high >> shift_) - base_) + 1;
    cells_ = arena.take_high<ScaleStep>(count_);
    if (cells_ == nullptr) return false;
    for (std::uint32_t i = 0; i < count_; ++i) cells_[i] = {0, infinity, 0, 0, 1, 0};
    first_ = edge(0);
    return true;
}

double ScaleGrid::edge(std::uint32_t i) const { return double_of_bits((base_ + i) << shift_); }

std::uint32_t ScaleGrid::cell_of(double scale) const {
    const std::uint64_t number = bits_of(scale) >> shift_;
    return number <= base_ ? 0 : number - base_ < count_ ? static_cast<std::uint32_t>(number - base_) : count_ - 1;
}

double ScaleGrid::next(std::uint32_t i) const { return i + 1 < count_ ? edge(i + 1) : infinity; }

void ScaleGrid::add(std::uint32_t i, const ScaleStep& step) {
    ScaleStep& cell = cells_[i];
    cell.low = smaller_of(cell.low, step.low);
    cell.high = larger_of(cell.high, step.high);
    cell.reach = larger_of(cell.reach, step.reach);
    cell.ratio = larger_of(cell.ratio, step.ratio);
}

bool ScaleGrid::finish(const JoinShift& join, double ratio, Arena& arena, ScaleCurve* curve) {
    begin_at(join.first_scale());
    // Beyond a mesh's last value its bounds stay as they are there.
    for (std::uint32_t i = 0; i < count_; ++i) {
        ScaleStep& cell = cells_[i];
        const double end = next(i);
        cell.from = from(i);
        const bool exact = join.is_exact_until(end);
        if (!exact) add(i, {0, join.before(cell.from), 0, join.after(end), join.factor(cell.from, end), 0});
        if (i > 0) {
            cell.high = larger_of(cell.high, cells_[i - 1].high);
            cell.reach = larger_of(cell.reach, cells_[i - 1].reach);
        }
        cell.ratio = smaller_of(cell.ratio, ratio);
    }
    for (std::uint32_t i = count_ - 1; i-- > 0;) cells_[i].low = smaller_of(cells_[i].low, cells_[i + 1].low);
    *curve = {arena.take_low<ScaleStep>(0), 0};
    if (curve->steps == nullptr) return false;
    for (std::uint32_t i = 0; i < count_; ++i) {
        const ScaleStep& cell = cells_[i];
        const ScaleStep* const last = curve->count > 0 ? &curve->steps[curve->count - 1] : nullptr;
        if (last == nullptr ? cell.low >= next(i) && cell.reach <= cell.from && cell.ratio == 1
                            : cell.low == last->low && cell.high == last->high && cell.reach == last->reach &&
                                  cell.ratio == last->ratio)
            continue;
        if (!arena.extend_low(sizeof(ScaleStep))) return false;
        curve->steps[curve->count] = cell;
        curve->steps[curve->count++].error = infinity;
    }
    return true;
}

}  // namespace netmesh
