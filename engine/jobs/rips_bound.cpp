#include "jobs/rips_bound.hpp"

#include "jobs/alpha_of_points.hpp"
#include "numerics/nearest_double.hpp"
#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> Status bounding_diagram(const PointSet& points, const Work& work, AlphaDiagram* out) {
    AlphaOfPoints request = {};
    request.points = {points.coordinates, sizeof(double) * D, false};
    request.count = points.count;
    request.diagram.max_degree = 1;
    return alpha_of_points<D>(request, work, out);
}

}  // namespace

std::size_t bound_bytes(std::uint64_t n, std::uint32_t dim) {
    constexpr std::uint64_t points_least = 200, points_most = std::uint64_t{1} << 26;
    if (n < points_least || n > points_most || dim > 3 || !serves_dimension(dim)) return 0;
    const double bytes = 0x1p17 + (dim == 2 ? 200.0 : 1600.0) * static_cast<double>(n);
    return bytes < static_cast<double>(SIZE_MAX / 2) ? static_cast<std::size_t>(bytes) : 0;
}

Status bound_rips(const PointSet& points, double threshold, const Work& work, RipsBound* out) {
    *out = {threshold, nullptr, 0};
    const std::size_t bytes = bound_bytes(points.count, points.dim);
    if (bytes == 0) return Status::ok;
    Arena& arena = work.arena;
    const HighScope scope(arena);
    unsigned char* const block = arena.take_high<unsigned char>(bytes);
    if (block == nullptr) return Status::out_of_memory;
    // Of so much memory alone, as time grows with it: points on curves have cells without number.
    Arena own;
    own.adopt(block, bytes);
    own.watch(&work.monitor);
    AlphaDiagram made;
    const Work inside = {own, work.monitor};
    const Status status = with_dimension(points.dim, [&](auto dimension) {
        constexpr int dim = decltype(dimension)::value;
        if constexpr (dim <= 3)
            return bounding_diagram<dim>(points, inside, &made);
        else
            return Status::internal;
    });
    if (status == Status::cancelled || work.monitor.has_stopped()) return Status::cancelled;
    if (status != Status::ok) return Status::ok;
    const PairList& pairs = made.found.pairs;
    double last = 0;
    arena.each(pairs.count, 4, [&](std::uint64_t i) {
        const Pair& pair = pairs.pairs[i];
        if (pair.degree == 1 && pair.death > last) last = pair.death;
    });
    // Deaths are rounded to nearest.
    const double limit = last + unit_above(last);
    if (!(limit < threshold)) return Status::ok;
    const auto is_late = [&](const Pair& pair) {
        return pair.degree == 0 && pair.death > limit && pair.death <= threshold && pair.death < infinity;
    };
    std::uint32_t joins = 0;
    arena.each(pairs.count, 4, [&](std::uint64_t i) { joins += is_late(pairs.pairs[i]); });
    out->joined_at = arena.take_low<double>(joins);
    if (out->joined_at == nullptr) return Status::out_of_memory;
    arena.each(pairs.count, 4, [&](std::uint64_t i) {
        if (is_late(pairs.pairs[i])) out->joined_at[out->joins++] = pairs.pairs[i].death;
    });
    out->limit = limit;
    return Status::ok;
}

}  // namespace netmesh
