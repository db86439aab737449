// The filter alpha: of points, whose triangulation is kept where somebody wants it; of the context's triangulation.
#include "filtration/alpha.hpp"

#include "api/plan.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "jobs/alpha_of_points.hpp"
#include "jobs/alpha_of_triangulation.hpp"

namespace netmesh {
namespace {

using MakeAlpha = Status(std::uint32_t dim, const AlphaOfPoints&, const Work&, AlphaDiagram*);

Status any_alpha(std::uint32_t dim, const AlphaOfPoints& wanted, const Work& work, AlphaDiagram* made) {
    return with_dimension(
        dim, [&](auto dimension) { return alpha_of_points<decltype(dimension)::value>(wanted, work, made); });
}

Status small_alpha(std::uint32_t dim, const AlphaOfPoints& wanted, const Work& work, AlphaDiagram* made) {
    return with_dimension(
        dim, [&](auto dimension) { return alpha_of_few_points<decltype(dimension)::value>(wanted, work, made); });
}

template <MakeAlpha make_alpha> netmesh_status alpha_of_given_points(netmesh_context* context) {
    clear(context);
    const netmesh_request& r = context->request;
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    const AlphaOfPoints wanted = {rows_of(r.points), r.points.count, r.seed, {r.max_degree, r.keep_zero_pairs != 0}};
    AlphaDiagram made = {};
    const Status status = watch.heed(make_alpha(r.points.dim, wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_and_clear(context, status, nullptr, made.input.row_a);
    context->complete = true;
    context->input = {true,         true, r.points.dim, made.input.rows, made.input.duplicates, made.input.fingerprint,
                      made.distinct};
    keep_alpha(context, wanted.diagram, made.found);
    return finish(context, status);
}

Complaint settle_alpha(const Settling& s) {
    const bool is_other = s.rules.method != nullptr && (!s.rules.method->triangulates() || s.rules.method->keeps_few);
    return is_other ? Complaint{NETMESH_FIELD_METHOD, "the filter alpha is of a triangulation; leave out the method"}
                    : settle_mesh_degree(s);
}

Complaint settle_small_alpha(const Settling& s) {
    if (s.source == Source::points && s.dim == 2 && s.r.points.count > few_points_max)
        return {NETMESH_FIELD_POINTS, "more than 8,192 points in the plane; name netmesh_filter_alpha"};
    return settle_mesh_degree(s);
}

netmesh_status run_small_alpha(netmesh_context* context) {
    if (source_of(context->request) != Source::points)
        return refuse(context, NETMESH_FIELD_POINTS, "this filter begins with points");
    return alpha_of_given_points<small_alpha>(context);
}

netmesh_status run_alpha(netmesh_context* context) {
    const netmesh_request& r = context->request;
    if (r.periods != nullptr) return dispatch(*r.periods, context);
    if (r.weighting != nullptr) return dispatch(*r.weighting, context);
    const bool of_points = source_of(r) == Source::points;
    if (of_points && r.keep_mesh == 0 && r.cycles == nullptr) return alpha_of_given_points<any_alpha>(context);
    if (of_points) {
        const netmesh_status status = triangulate_points(context, nullptr);
        return status == NETMESH_OK ? filter_triangulation(context) : status;
    }
    const char* missing = missing_cells(context);
    if (missing == nullptr && context->mesh.is_mesh)
        missing = "the alpha filter needs a Delaunay triangulation of the points alone";
    if (missing == nullptr && context->input.weighting != NETMESH_WEIGHTING_NONE) missing = weighted_cells;
    if (missing != nullptr) return finish(context, Status::no_result, missing);
    // Simplices of anything but a triangulation of the convex hull pair otherwise than those of the points do.
    const KeptFlaw& flaw = context->mesh.flaw;
    if (flaw.text_from == 0) return filter_triangulation(context);
    clear_diagram(context);
    return finish(context, Status::check_failed, text_kept(flaw.text_from), flaw.cell);
}

}  // namespace

netmesh_status filter_triangulation(netmesh_context* context) {
    clear_diagram(context);
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
            wanted, {context->arena, monitor}, &made);
    });
    const Status status = watch.heed(found);
    status == Status::ok ? keep_alpha(context, wanted, made) : clear_diagram(context);
    return finish(context, status);
}

}  // namespace netmesh

using namespace netmesh;

extern "C" {
extern const netmesh_filter netmesh_filter_alpha;
const netmesh_filter netmesh_filter_alpha = {NETMESH_FILTER_ALPHA,
                                             given::method | given::cycles | given::keep_mesh | given::seed |
                                                 given::weighting | given::squares | given::periods,
                                             run_alpha,
                                             settle_alpha,
                                             nullptr,
                                             &netmesh_method_delaunay,
                                             nullptr};
extern const netmesh_filter netmesh_filter_alpha_small;
const netmesh_filter netmesh_filter_alpha_small = {
    NETMESH_FILTER_ALPHA, given::seed, run_small_alpha, settle_small_alpha, nullptr, nullptr, nullptr, true};
}
