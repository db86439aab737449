#include "filtration/bar_bounds.hpp"

#include "numerics/value_order.hpp"

namespace netmesh {
namespace {

// Keys in ascending order, with an extreme of all items up to (from) each.
struct Table {
    double* key;
    double* extreme;
    std::uint32_t count;

    // Items with key <= x (< x).
    std::uint32_t up_to(double x, bool strictly) const {
        std::uint32_t first = 0, last = count;
        while (first < last) {
            const std::uint32_t middle = first + (last - first) / 2;
            if (strictly ? key[middle] < x : key[middle] <= x) {
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        return first;
    }
};

class Interleaving {
public:
    Status open(const double* value, const Interval* interval, std::uint32_t count, Arena& arena);
    double phi(double b) const {
        const std::uint32_t n = by_value_.up_to(b, false);
        return n > 0 && by_value_.extreme[n - 1] > b ? by_value_.extreme[n - 1] : b;
    }
    double psi(double a) const {
        const std::uint32_t n = by_low_.up_to(a, false);
        return n > 0 && by_low_.extreme[n - 1] > a ? by_low_.extreme[n - 1] : a;
    }
    double psi_inverse(double b) const {
        const std::uint32_t n = by_value_.up_to(b, true);
        return n < by_value_.count && least_[n] < b ? least_[n] : b;
    }

private:
    Table by_value_ = {}, by_low_ = {};
    double* least_ = nullptr;  // of lo, from here on by value
};

Status Interleaving::open(const double* value, const Interval* interval, std::uint32_t count, Arena& arena) {
    std::uint32_t* const from = arena.take_high<std::uint32_t>(count);
    by_value_ = {arena.take_high<double>(count), arena.take_high<double>(count), count};
    by_low_ = {arena.take_high<double>(count), arena.take_high<double>(count), count};
    least_ = arena.take_high<double>(count);
    if (from == nullptr || by_value_.key == nullptr || by_value_.extreme == nullptr || by_low_.key == nullptr ||
        by_low_.extreme == nullptr || least_ == nullptr)
        return Status::out_of_memory;
    for (std::uint32_t v = 0; v < count; ++v) {
        by_value_.key[v] = value[v];
        by_low_.key[v] = interval[v].lo;
    }
    if (!sort_values(by_value_.key, from, count, arena)) return Status::out_of_memory;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double hi = interval[from[i]].hi;
        by_value_.extreme[i] = i > 0 && by_value_.extreme[i - 1] > hi ? by_value_.extreme[i - 1] : hi;
    }
    for (std::uint32_t i = count; i-- > 0;) {
        const double lo = interval[from[i]].lo;
        least_[i] = i + 1 < count && least_[i + 1] < lo ? least_[i + 1] : lo;
    }
    if (!sort_values(by_low_.key, from, count, arena)) return Status::out_of_memory;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double t = value[from[i]];
        by_low_.extreme[i] = i > 0 && by_low_.extreme[i - 1] > t ? by_low_.extreme[i - 1] : t;
    }
    return Status::ok;
}

}  // namespace

Status bound_bars(const double* value, const Interval* interval, std::uint32_t count, const Pair* pairs,
                  std::uint64_t pair_count, Arena& arena, BarBounds* bounds) {
    const ArenaScope scope(arena);
    Interleaving interleaving;
    const Status status = interleaving.open(value, interval, count, arena);
    if (status != Status::ok) return status;
    for (std::uint64_t i = 0; i < pair_count; ++i) {
        const double birth = pairs[i].birth, death = pairs[i].death;
        const double latest = interleaving.phi(birth);
        bounds[i] = {interleaving.psi_inverse(birth), latest, interleaving.psi_inverse(death),
                     death < infinity ? interleaving.phi(death) : infinity, interleaving.psi(latest)};
        if (birth == 0) bounds[i].birth_low = 0;
    }
    return Status::ok;
}

}  // namespace netmesh
