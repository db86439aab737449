// Copies of points within a margin about their box.
#include "numerics/vector.hpp"
#include "periods/periodic_points.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Calls visit(times, v) for each translation, sum of times[j] b[j] = v, that takes the box of the points to where it
// meets the box with its margin; not for 0. False as soon as visit says so.
template <int D, class Visit> bool each_translation(const PeriodicPoints& points, const double* margin, Visit&& visit) {
    const Lattice& lattice = points.lattice;
    int most[Lattice::most], times[Lattice::most];
    for (int j = lattice.count - 1; j >= 0; --j) {
        double reach = (margin[j] + points.high[j] - points.low[j]) * (1 + 0x1p-20) / lattice.h[j];
        for (int i = j + 1; i < lattice.count; ++i) reach += absolute(lattice.place(j, lattice.b[i])) * most[i];
        if (!(reach < 500)) return false;
        most[j] = static_cast<int>(reach) + 1;
        times[j] = -most[j];
    }
    for (;;) {
        double v[D] = {};
        bool meets = true, is_zero = true;
        for (int j = 0; j < lattice.count; ++j) {
            is_zero &= times[j] == 0;
            for (int k = 0; k < D; ++k) v[k] += times[j] * lattice.b[j][k];
        }
        for (int j = 0; j < lattice.count; ++j)
            meets &= absolute(dot<D>(lattice.e[j], v)) <= (points.high[j] - points.low[j] + margin[j]) * (1 + 0x1p-20);
        if (meets && !is_zero && !visit(times, v)) return false;
        int j = 0;
        while (j < lattice.count && times[j] == most[j]) {
            times[j] = -most[j];
            ++j;
        }
        if (j == lattice.count) return true;
        ++times[j];
    }
}

}  // namespace

template <int D> Status make_copies(const PeriodicPoints& points, const double* margin, const Work& work, Copies* out) {
    constexpr int numbers = D + 1;
    const Lattice& lattice = points.lattice;
    Arena& arena = work.arena;
    // Points that have a copy near enough: of a translation the last part that is not 0 takes them at least a layer
    // along, and the others not at all.
    const HighScope scope(arena);
    std::uint32_t* const outer = arena.take_high<std::uint32_t>(points.count);
    if (outer == nullptr) return Status::out_of_memory;
    std::uint32_t outers = 0;
    arena.each(points.count, 4 * D, [&](std::uint64_t i) {
        outer[outers] = static_cast<std::uint32_t>(i);
        bool is_outer = false;
        for (int j = 0; j < lattice.count; ++j) {
            const double y = dot<D>(lattice.e[j], points.x + i * numbers), more = margin[j] * (1 + 0x1p-19);
            const double layer = lattice.h[j] * (1 - 0x1p-20);
            is_outer |= y + layer <= points.high[j] + more || y - layer >= points.low[j] - more;
        }
        outers += is_outer;
    });
    // Calls act(i, place, times) for each copy, of point i.
    const auto each_copy = [&](auto&& act) {
        return each_translation<D>(points, margin, [&](const int* times, const double* v) {
            double low[Lattice::most], high[Lattice::most];
            for (int j = 0; j < lattice.count; ++j) {
                const double along = dot<D>(lattice.e[j], v), more = margin[j] * (1 + 0x1p-20);
                low[j] = points.low[j] - more - along;
                high[j] = points.high[j] + more - along;
            }
            arena.each(outers, 12 * static_cast<std::uint32_t>(lattice.count), [&](std::uint64_t at) {
                const std::uint32_t i = outer[at];
                const double* const x = points.x + std::size_t{i} * numbers;
                for (int j = 0; j < lattice.count; ++j) {
                    const double y = dot<D>(lattice.e[j], x);
                    if (!(y >= low[j] && y <= high[j])) return;
                }
                act(i, v, times);
            });
            return !arena.has_stopped();
        });
    };
    std::uint64_t copies = 0;
    if (!each_copy([&](std::uint32_t, const double*, const int*) { ++copies; }))
        return arena.has_stopped() ? Status::cancelled : Status::out_of_range;
    const std::uint64_t count = copies + points.count;
    if (count > std::uint64_t{1} << 28) return Status::out_of_memory;
    out->count = static_cast<std::uint32_t>(count);
    out->x = arena.take_low<double>(static_cast<std::size_t>(count) * numbers);
    out->index = arena.take_low<std::uint32_t>(static_cast<std::size_t>(count));
    out->own = arena.take_low<std::uint32_t>(static_cast<std::size_t>(copies));
    out->shift = arena.take_low<std::int64_t>(static_cast<std::size_t>(copies));
    if (out->x == nullptr || out->index == nullptr || out->own == nullptr || out->shift == nullptr)
        return Status::out_of_memory;
    move_bytes(out->x, points.x, sizeof(double) * numbers * points.count, arena);
    move_bytes(out->index, points.row, sizeof(std::uint32_t) * points.count, arena);
    std::uint32_t at = 0;
    each_copy([&](std::uint32_t i, const double* v, const int* times) {
        const double* const from = points.x + std::size_t{i} * numbers;
        double* const to = out->x + std::size_t{points.count + at} * numbers;
        for (int k = 0; k < D; ++k) to[k] = from[k] + v[k] + 0.0;
        to[D] = from[D];
        out->index[points.count + at] = points.row[i];
        out->own[at] = i;
        std::int64_t shift = 0;
        for (int j = lattice.count; j-- > 0;) shift = shift * 1024 + times[j];
        out->shift[at++] = shift;
    });
    return arena.has_stopped() ? Status::cancelled : Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status make_copies<D>(const PeriodicPoints&, const double*, const Work&, Copies*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
