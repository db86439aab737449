#include "jobs/cover_sequence.hpp"

namespace netmesh {

Status CoverSequence::open(const FilterBounds& filter, Arena& arena) {
    const auto lo = [&](std::uint32_t v) { return filter.interval[v].lo; };
    const auto hi = [&](std::uint32_t v) { return filter.interval[v].hi; };
    const bool room =
        by_low_.open_largest(filter.count, lo, hi, arena) && by_high_.open_least(filter.count, hi, lo, arena);
    window_ = arena.take_high<CoverWindow>(scales_max);
    return room && window_ != nullptr ? Status::ok : Status::out_of_memory;
}

void CoverSequence::go_through(double s, const FilterBounds& filter, const Arena& arena) {
    constexpr int half = scales_max / 2;
    double below[half];
    int count = 0;
    for (double b = s; count < half && b >= by_high_.first();) {
        below[count++] = b;
        // The largest scale whose Y is in the X of this one.
        const double first = by_high_.least_after(b),
                     least = spacing_.is_difference() ? -next_up(-first) : first * down;
        const double next = spacing_.before(b, stride);
        b = first < infinity && least < next ? least : next;
    }
    scales_ = 0;
    while (count > 0) scale_[scales_++] = below[--count];
    if (scales_ == 0) scale_[scales_++] = s;
    const double top = by_high_.last();
    while (scales_ < scales_max && scale_[scales_ - 1] < top) {
        const double b = spacing_.after(scale_[scales_ - 1], stride);
        const double most = by_low_.largest_up_to(scale_[scales_ - 1], spacing_.least());
        const double next = most > b ? most : b;
        scale_[scales_++] = next < top ? next : top;
    }
    find_windows(filter, arena);
}

// From a stride below the scale as far above it as cells allow; where one is in the way, to the scale, from as far as
// cells allow.
void CoverSequence::find_windows(const FilterBounds& filter, const Arena& arena) {
    double least[scales_max], largest[scales_max];
    for (int i = 0; i < scales_; ++i) least[i] = spacing_.least(), largest[i] = infinity;
    // The largest lo of cells up to this hi; the least hi of those whose lo is past the scale less a stride.
    for (std::uint32_t v = 0; v < filter.count;)
        for (const std::uint64_t piece = arena.piece(v, filter.count, 60); v < piece; ++v) {
            const Interval cell = filter.interval[v];
            const int y = scales_until(cell.hi);
            if (y < scales_ && cell.lo > least[y]) least[y] = cell.lo;
            int last = scales_until(spacing_.after(cell.lo, stride));
            if (last < scales_) ++last;  // both ways are rounded
            while (last > 0 && !(spacing_.before(scale_[last - 1], stride) < cell.lo)) --last;
            if (last > 0 && cell.hi < largest[last - 1]) largest[last - 1] = cell.hi;
        }
    for (int i = 1; i < scales_; ++i)
        if (least[i - 1] > least[i]) least[i] = least[i - 1];
    for (int i = scales_ - 1; i-- > 0;)
        if (largest[i + 1] < largest[i]) largest[i] = largest[i + 1];
    for (int i = 0; i < scales_; ++i) {
        const double most = -next_up(-largest[i]);
        window_[i] = most >= scale_[i] ? CoverWindow{spacing_.before(scale_[i], stride), most}
                                       : CoverWindow{least[i], scale_[i]};
    }
}

}  // namespace netmesh
