#include "jobs/bound_bars.hpp"

#include "filtration/tighten_cell_bounds.hpp"
#include "jobs/certified_bars.hpp"

namespace netmesh {
namespace {

// The filter's values and the narrowest intervals that there are for it.
Status measure(const AnyMesh& mesh, const FilterRequest& request, const Work& work, Evaluation* out) {
    out->value = work.arena.take_high<double>(mesh.vertices());
    out->interval = work.arena.take_high<Interval>(mesh.vertices());
    if (out->value == nullptr || out->interval == nullptr) return Status::out_of_memory;
    const Status status = evaluate(mesh, request, work, out);
    const Filter& filter = evaluated_filter(request.filter, request.k);
    return status == Status::ok && filter.has(filter_trait::has_tighter_cells)
               ? tighten_cell_bounds(mesh, work, out->interval)
               : status;
}

// Is it the function that the diagram is of?
bool is_same(const BoundBarsRequest& request, const FilterBounds& filter, double error, const Arena& arena) {
    bool same = request.value != nullptr && request.error == error;
    for (std::uint32_t v = 0; same && v < filter.count; ++v) {
        arena.step(v, 5);
        same = request.value[v] == filter.value[v];
    }
    return same;
}

}  // namespace

Status bound_bars(const AnyMesh& mesh, const BoundBarsRequest& request, const Work& work, BoundedBars* out) {
    ArenaScope scope(work.arena);
    *out = {work.arena.take_low<BarBounds>(static_cast<std::size_t>(request.bars.count)), {}};
    if (out->bounds == nullptr) return Status::out_of_memory;
    Evaluation evaluation = {};
    AnyMesh filtered = mesh;
    Status status = clip_cells(request.filter, work, &filtered);
    if (status == Status::ok) status = measure(filtered, request.filter, work, &evaluation);
    if (status != Status::ok) return status;
    const Filter& filter = evaluated_filter(request.filter.filter, request.filter.k);
    const FilterBounds bounds = {evaluation.value, evaluation.interval, mesh.vertices()};
    Spacing spacing;
    if (filter.has(filter_trait::needs_function)) {
        const double error = evaluation.certificate.error;
        if (!is_same(request, bounds, error, work.arena)) return Status::invalid_argument;
        // Either all is exact, or what is said of the function cannot be and no interval holds.
        if (!(error > 0 && error < infinity)) {
            status = bound_by_ratio({evaluation.certificate.ratio, 0, error}, request.bars, work.arena, out->bounds,
                                    &out->curve);
            if (status == Status::ok) scope.keep_low_from_now();
            return status;
        }
        spacing.difference = error;
    }
    status = bound_by_scale(bounds, request.bars, spacing, work.arena, out->bounds, &out->curve);
    if (status != Status::ok) return status;
    const std::uint32_t zero_born = filter.has(filter_trait::zero_at_inputs) ? mesh.inputs : 0;
    status = find_certified_bars(
        {mesh.store.view(), bounds, zero_born, request.bars, filtered.filtered_part(), spacing}, work, out->bounds);
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
