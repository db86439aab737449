// Persistence of points scale by scale.
#include "api/keep_complex.hpp"
#include "api/requests.hpp"
#include "delaunay/triangulate.hpp"
#include "jobs/diagram_of_scales.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

// Scales whose accuracy is given by eps are over-refined for the tight filter, others refined by the certificate.
Complaint complaint_about_built_scales(bool by_ratio) {
    if (by_ratio && !built::certificate)
        return {NETMESH_FIELD_RATIO, "left out of this build: NETMESH_WITH_CERTIFICATE", true};
    if (!by_ratio && !built::sizes) return {NETMESH_FIELD_EPS, "left out of this build: NETMESH_WITH_SIZES", true};
    if (!by_ratio && !built::tight) return {NETMESH_FIELD_EPS, "left out of this build: NETMESH_WITH_TIGHT", true};
    return {};
}

Complaint complaint_about_scales(const netmesh_scales_request& request) {
    Complaint complaint = complaint_about_points(request);
    if (complaint.text == nullptr) complaint = complaint_about_values(request.values);
    if (complaint.text != nullptr) return complaint;
    if (!is_valid_tau(tau_of(request.dim, request.tau)))
        return {NETMESH_FIELD_TAU, "tau is not a finite number above 2"};
    if (!is_valid_eps(eps_of(request.eps))) return {NETMESH_FIELD_EPS, "eps is not in (0, 1/2]"};
    if (!is_valid_theta(theta_of(request.theta))) return {NETMESH_FIELD_THETA, "theta is not in (0, 1/9]"};
    if (request.ratio == 0) return complaint_about_built_scales(false);
    if (request.eps != 0) return {NETMESH_FIELD_EPS, "eps and ratio both say what is asked of the diagram"};
    if (!is_valid_scales_ratio(request.ratio, theta_of(request.theta)))
        return {NETMESH_FIELD_RATIO, "ratio is not a finite number above (1 + 3 theta) times the root of 2"};
    return complaint_about_built_scales(true);
}

void keep_scales(netmesh_context* context, const netmesh_scales_request& request, const InputReport& input,
                 const ScalesResult& result) {
    context->complete = true;
    context->input = {true,
                      false,
                      request.dim,
                      input.rows,
                      input.duplicates,
                      input.fingerprint,
                      static_cast<std::uint32_t>(input.rows - input.duplicates)};
    context->scales = {
        true, result.clusters, result.most_points, result.most_vertices, result.vertices, result.separation};
    KeptDiagram& diagram = context->diagram;
    diagram.present = true;
    diagram.filter = NETMESH_FILTER_SCALES;
    diagram.values = request.values;
    diagram.max_degree = degree_of(request.max_degree, request.dim);
    diagram.pairs = Slice<Pair>::of(context->arena, result.pairs.pairs, result.pairs.count);
    diagram.simplices = result.simplices;
    diagram.certified_ratio = result.ratio;
    diagram.certified_ratio_best = result.ratio_best;
    if (request.representatives != 0) keep_cycles(context, result.cycles, context->arena.bytes());
    if (request.bounds == 0) return;
    context->bounds.present = true;
    context->bounds.bars = Slice<BarBounds>::of(context->arena, result.bounds, result.pairs.count);
    context->bounds.steps = Slice<ScaleStep>::of(context->arena, result.curve.steps, result.curve.count);
}

// The points live in a store of their own, which is empty again when the pairs are there.
Status persist(netmesh_context* context, const netmesh_scales_request& request, const ScalesRequest& wanted,
               Monitor& monitor, InputReport* input, ScalesResult* result) {
    StoreState state = {};
    std::uint32_t* order;
    AnyStore points(static_cast<int>(request.dim), context->arena, state);
    Status status = take_input(points, rows_of(request), request.point_count, request.seed, monitor, input, &order);
    context->arena.release_low(context->start);  // the order
    if (status != Status::ok) return status;
    status = diagram_of_scales(points, state.vertex_count, wanted, {context->arena, monitor}, result);
    if (status != Status::ok) return status;
    points.truncate_vertices(0);
    return status;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_persist_scales(netmesh_context* context, const netmesh_scales_request* from) {
    netmesh_scales_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about_scales(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    const ScalesRequest wanted = {theta_of(request.theta),
                                  eps_of(request.eps),
                                  request.ratio,
                                  tau_of(request.dim, request.tau),
                                  request.seed,
                                  values_of(request.values),
                                  degree_of(request.max_degree, request.dim),
                                  request.keep_zero_pairs != 0,
                                  request.bounds != 0,
                                  request.representatives != 0};
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    InputReport input = {};
    ScalesResult result = {};
    const Status found = persist(context, request, wanted, monitor, &input, &result);
    const Status status = watch.heed(found);
    if (status == Status::ok) {
        keep_scales(context, request, input, result);
        return finish(context, status);
    }
    if (status == Status::not_finite) return fail_and_clear(context, status, nullptr, input.row_a);
    if (status != Status::invalid_argument) return fail_and_clear(context, status, nullptr, result.row_a, result.row_b);
    clear(context);
    return refuse(context, {NETMESH_FIELD_SIZES, "the size asked for is below what coordinates resolve"}, result.row_a);
}
