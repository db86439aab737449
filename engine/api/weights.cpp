// Points with weights: regular triangulations and their alpha diagrams.
#include "api/request.hpp"
#include "api/settling.hpp"
#include "jobs/alpha_of_points.hpp"
#include "jobs/alpha_of_triangulation.hpp"

namespace netmesh {
namespace {

// Whether what is said of weights goes together; the numbers themselves are read by the job alone.
Complaint settle_weighting(const Settling& s) {
    if (s.is_promise()) return {NETMESH_FIELD_WEIGHTING, "nothing is promised with weights; leave them out"};
    if (s.source != Source::points) return {NETMESH_FIELD_WEIGHTING, "weights are of points; give points"};
    const netmesh_points& p = s.r.points;
    const std::size_t stride = p.weight_stride_bytes;
    const std::size_t number = p.format == NETMESH_POINTS_FLOAT32 ? sizeof(float) : sizeof(double);
    if (stride != 0 && (stride < number || stride % alignment_of(p) != 0 || stride > SIZE_MAX / 2 / p.count))
        return {NETMESH_FIELD_WEIGHT_STRIDE_BYTES, "less than a number, not aligned as it is, or too large"};
    if (!s.takes_alpha()) return fine();
    if (s.r.bounds != nullptr)
        return {NETMESH_FIELD_BOUNDS, "with weights each bar is the exact one, rounded; leave out bounds"};
    if (s.r.cycles != nullptr && s.r.periods == nullptr)
        return {NETMESH_FIELD_CYCLES, "with weights there are cycles where there are periods alone; leave them out"};
    return fine();
}

// Why there is neither a triangulation nor a diagram.
[[gnu::cold]] netmesh_status fail(netmesh_context* context, Status status, const InputReport& input,
                                  const HiddenPoints& hidden) {
    const std::uint64_t row = input.row_a;
    if (refuses_square(context, status)) {
        clear(context);
        return NETMESH_INVALID_ARGUMENT;
    }
    if (!hidden.has_negative)
        return fail_and_clear(context, status, hidden.has_weight ? "a weight is not a finite number" : nullptr, row);
    clear(context);
    return refuse(context, {NETMESH_FIELD_WEIGHTS, "a radius is negative"}, row);
}

void keep_weights(netmesh_context* context, const netmesh_request& r, const HiddenPoints& hidden) {
    context->input.weighting = r.weighting->are_radii ? NETMESH_WEIGHTING_RADII : NETMESH_WEIGHTING_WEIGHTS;
    context->input.squares = r.squares != 0;
    context->input.hidden = Slice<std::uint32_t>::of(context->arena, hidden.rows, hidden.count);
}

netmesh_status triangulate_with_weights(netmesh_context* context) {
    const netmesh_request& r = context->request;
    const Complaint missing = missing_weights(r);
    if (missing.text != nullptr) return refuse(context, missing);
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    return with_dimension(r.points.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        InputReport input;
        HiddenPoints hidden;
        Store<D> store(context->arena, context->mesh.store);
        const Status status = watch.heed(triangulate_weighted<D>(store, rows_of(r.points), r.points.count,
                                                                 weights_of(r), r.seed, monitor, &input, &hidden));
        if (hidden.has_negative || hidden.has_weight) return fail(context, status, input, hidden);
        const netmesh_status ended = finish_triangulation(context, input, hidden.count, status);
        if (context->mesh.present) keep_weights(context, r, hidden);
        return ended;
    });
}

PowerValues powers_of(const netmesh_request& r) {
    PowerValues powers = {};
    powers.are_radii = r.weighting->are_radii;
    powers.squares = r.squares != 0;
    return powers;
}

// Of the triangulation that was just made.
netmesh_status filter_with_weights(netmesh_context* context) {
    const netmesh_request& r = context->request;
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    const std::uint32_t dim = context->input.dim;
    const DiagramRequest wanted = {degree_of(r.max_degree, dim), r.keep_zero_pairs != 0};
    CountedPairs made = {};
    const Status found = with_dimension(dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const Store<D> store(context->arena, context->mesh.store);
        return alpha_of_triangulation<D>(
            {store.view(), store.point(0), Store<D>::vertex_stride, count_hull_facets(store.view(), context->arena)},
            powers_of(r), wanted, {context->arena, monitor}, &made);
    });
    const Status status = watch.heed(found);
    status == Status::ok ? keep_alpha(context, wanted, made) : clear_diagram(context);
    return refuses_square(context, status) ? NETMESH_INVALID_ARGUMENT : finish(context, status);
}

netmesh_status diagram_with_weights(netmesh_context* context) {
    const netmesh_request& r = context->request;
    if (r.keep_mesh != 0) {
        const netmesh_status status = triangulate_with_weights(context);
        return status == NETMESH_OK ? filter_with_weights(context) : status;
    }
    const Complaint missing = missing_weights(r);
    if (missing.text != nullptr) return refuse(context, missing);
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    WeightedAlphaOfPoints wanted = {};
    wanted.points = rows_of(r.points);
    wanted.count = r.points.count;
    wanted.seed = r.seed;
    wanted.diagram = {r.max_degree, r.keep_zero_pairs != 0};
    wanted.weights = weights_of(r);
    wanted.squares = r.squares != 0;
    WeightedAlphaDiagram made = {};
    const Status found = with_dimension(r.points.dim, [&](auto dimension) {
        return alpha_of_weighted_points<decltype(dimension)::value>(wanted, {context->arena, monitor}, &made);
    });
    const Status status = watch.heed(found);
    if (status != Status::ok) return fail(context, status, made.input, made.hidden);
    context->complete = true;
    context->input = {true,         true, r.points.dim, made.input.rows, made.input.duplicates, made.input.fingerprint,
                      made.distinct};
    keep_weights(context, r, made.hidden);
    keep_alpha(context, wanted.diagram, made.found);
    return finish(context, status);
}

}  // namespace
}  // namespace netmesh

extern "C" {
extern const netmesh_weighting netmesh_radii, netmesh_weights;
const netmesh_weighting netmesh_radii = {true, netmesh::settle_weighting, netmesh::diagram_with_weights,
                                         netmesh::triangulate_with_weights};
const netmesh_weighting netmesh_weights = {false, netmesh::settle_weighting, netmesh::diagram_with_weights,
                                           netmesh::triangulate_with_weights};
}
