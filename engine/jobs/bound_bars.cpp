#include "jobs/bound_bars.hpp"

#include "filtration/cell_intervals.hpp"
#include "homology/rank.hpp"
#include "jobs/certified_bars.hpp"

namespace netmesh {
namespace {

// Is it the function that the diagram is of?
bool is_same(const BoundBarsRequest& request, const FilterBounds& filter, double error, const Arena& arena) {
    bool same = request.value != nullptr && request.error == error;
    for (std::uint32_t v = 0; same && v < filter.count; ++v) {
        arena.step(v, 5);
        same = request.value[v] == filter.value[v];
    }
    return same;
}

// From the filter's values and intervals, those of `cells` where these are not null.
Status bound_by_cells(const AnyMesh& filtered, const BoundBarsRequest& request, const FilterBounds& bounds,
                      Spacing spacing, CellIntervals* cells, const Work& work, BoundedBars* out) {
    Status status = bound_by_scale(bounds, request.bars, spacing, work.arena, out->bounds, &out->curve);
    if (status != Status::ok) return status;
    const Filter& filter = evaluated_filter(request.filter.filter, request.filter.k);
    const std::uint32_t zero_born = filter.has(filter_trait::zero_at_inputs) ? filtered.inputs : 0;
    return find_certified_bars({filtered.store.view(), bounds, zero_born, request.bars, filtered.filtered_part(),
                                spacing, nullptr, cells, &filtered.store},
                               work, out->bounds);
}

// Of a filter whose intervals can be narrowed: the diagram has its values, and few cells need to be narrow.
Status bound_by_narrowed(const AnyMesh& filtered, const BoundBarsRequest& request, const Work& work, BoundedBars* out) {
    CellIntervals cells(filtered, work.arena);
    Status status = cells.open(work.monitor);
    if (status != Status::ok) return status;
    {
        const HighScope scope(work.arena);
        std::uint32_t* const order = work.arena.take_high<std::uint32_t>(filtered.vertices());
        std::uint32_t* const rank = work.arena.take_high<std::uint32_t>(filtered.vertices());
        if (order == nullptr || rank == nullptr ||
            !rank_vertices(request.value, filtered.vertices(), work.arena, order, rank))
            return Status::out_of_memory;
        cells.narrow_extremes(order);
    }
    if (cells.status() != Status::ok) return cells.status();
    status =
        bound_by_cells(filtered, request, {request.value, cells.all(), filtered.vertices()}, {}, &cells, work, out);
    return status == Status::ok ? cells.status() : status;
}

// Of another: it is evaluated once more, for the intervals of all cells.
Status bound_by_evaluation(const AnyMesh& filtered, const BoundBarsRequest& request, const Work& work,
                           BoundedBars* out) {
    Evaluation evaluation = {work.arena.take_high<double>(filtered.vertices()),
                             work.arena.take_high<Interval>(filtered.vertices())};
    if (evaluation.value == nullptr || evaluation.interval == nullptr) return Status::out_of_memory;
    const Status status = evaluate(filtered, request.filter, work, &evaluation);
    if (status != Status::ok) return status;
    const FilterBounds bounds = {evaluation.value, evaluation.interval, filtered.vertices()};
    Spacing spacing;
    if (evaluated_filter(request.filter.filter, request.filter.k).has(filter_trait::needs_function)) {
        const double error = evaluation.certificate.error;
        if (!is_same(request, bounds, error, work.arena)) return Status::invalid_argument;
        // Either all is exact, or what is said of the function cannot be and no interval holds.
        if (!(error > 0 && error < infinity))
            return bound_by_ratio({evaluation.certificate.ratio, 0, error}, request.bars, work.arena, out->bounds,
                                  &out->curve);
        spacing.difference = error;
    }
    return bound_by_cells(filtered, request, bounds, spacing, nullptr, work, out);
}

}  // namespace

Status bound_bars(const AnyMesh& mesh, const BoundBarsRequest& request, const Work& work, BoundedBars* out) {
    ArenaScope scope(work.arena);
    *out = {work.arena.take_low<BarBounds>(static_cast<std::size_t>(request.bars.count)), {}};
    if (out->bounds == nullptr) return Status::out_of_memory;
    AnyMesh filtered = mesh;
    Status status = clip_cells(request.filter, work, &filtered);
    if (status != Status::ok) return status;
    const Filter& filter = evaluated_filter(request.filter.filter, request.filter.k);
    status = filter.has(filter_trait::has_tighter_cells) ? bound_by_narrowed(filtered, request, work, out)
                                                         : bound_by_evaluation(filtered, request, work, out);
    if (status == Status::ok) scope.keep_low_from_now();
    return status;
}

Status bound_bars_by_ratio(const UniformBound& bound, const BarList& bars, const Work& work, BoundedBars* out) {
    ArenaScope scope(work.arena);
    *out = {work.arena.take_low<BarBounds>(static_cast<std::size_t>(bars.count)), {}};
    if (out->bounds == nullptr) return Status::out_of_memory;
    const Status status = bound_by_ratio(bound, bars, work.arena, out->bounds, &out->curve);
    if (status == Status::ok) scope.keep_low_from_now();
    return status;
}

}  // namespace netmesh
