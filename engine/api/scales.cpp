// Persistence of points scale by scale.
#include "api/keep_complex.hpp"
#include "api/plan.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "delaunay/triangulate.hpp"
#include "jobs/diagram_of_scales.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

void keep_scales(netmesh_context* context, const netmesh_request& request, const InputReport& input,
                 const ScalesResult& result) {
    context->complete = true;
    context->input = {true,
                      false,
                      request.points.dim,
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
    diagram.max_degree = request.max_degree;
    diagram.pairs = Slice<Pair>::of(context->arena, result.pairs.pairs, result.pairs.count);
    diagram.simplices = result.simplices;
    diagram.certified_ratio = result.ratio;
    diagram.certified_ratio_best = result.ratio_best;
    if (request.cycles != nullptr) keep_cycles(context, result.cycles, context->arena.bytes());
    if (request.bounds == nullptr) return;
    context->bounds.present = true;
    context->bounds.bars = Slice<BarBounds>::of(context->arena, result.bounds, result.pairs.count);
    context->bounds.steps = Slice<ScaleStep>::of(context->arena, result.curve.steps, result.curve.count);
}

// The points live in a store of their own, which is empty again when the pairs are there.
Status persist(netmesh_context* context, const netmesh_request& request, const ScalesRequest& wanted, Monitor& monitor,
               InputReport* input, ScalesResult* result) {
    StoreState state = {};
    std::uint32_t* order;
    AnyStore points(static_cast<int>(request.points.dim), context->arena, state);
    Status status =
        take_input(points, rows_of(request.points), request.points.count, request.seed, monitor, input, &order);
    context->arena.release_low(context->start);  // the order
    if (status != Status::ok) return status;
    status = diagram_of_scales(points, state.vertex_count, wanted, {context->arena, monitor}, result);
    if (status != Status::ok) return status;
    points.truncate_vertices(0);
    return status;
}

// Scales whose accuracy is given by eps are over-refined for the tight filter, others refined by the certificate.
Complaint settle_scales(const Settling& s) {
    settle_mesh_degree(s);
    if (s.source != Source::points) return fine();
    const Complaint complaint = settle_accuracy(s);
    if (complaint.text != nullptr) return complaint;
    const double share = 1 + 3 * s.goal.theta, by_tau = s.ratio_of_tau() * share;
    const bool by_ratio = is_given(s.goal.ratio);
    if (by_ratio && is_given(s.rules.tau) && s.goal.ratio != by_tau)
        return {NETMESH_FIELD_TAU, "ratio says what the meshes are made for; leave out tau"};
    if (by_ratio && !is_valid_ratio(s.goal.ratio / share * (1 - 0x1p-40)))
        return {NETMESH_FIELD_RATIO, "ratio is not a finite number above 1.4143 (1 + 3 theta)"};
    if (!by_ratio || s.goal.ratio == by_tau) s.rules.tau = tau_of(s.dim, s.rules.tau);
    if (by_ratio && !built::certificate)
        return {NETMESH_FIELD_RATIO, "left out of this build: NETMESH_WITH_CERTIFICATE", true};
    if (!by_ratio && !built::sizes) return {NETMESH_FIELD_EPS, "left out of this build: NETMESH_WITH_SIZES", true};
    return fine();
}

netmesh_status run_scales(netmesh_context* context) {
    const netmesh_request& request = context->request;
    if (source_of(request) != Source::points)
        return refuse(context, NETMESH_FIELD_POINTS, "this filter begins with points");
    clear(context);
    const netmesh_goal& goal = request.goal;
    const ScalesRequest wanted = {goal.theta,
                                  goal.eps,
                                  goal.ratio,
                                  tau_of(request.points.dim, request.mesh.tau),
                                  request.seed,
                                  values_of(request.values),
                                  request.max_degree,
                                  request.keep_zero_pairs != 0,
                                  request.bounds != nullptr,
                                  request.cycles != nullptr};
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

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {
extern const netmesh_filter netmesh_filter_scales;
const netmesh_filter netmesh_filter_scales = {NETMESH_FILTER_SCALES,
                                              given::ratio | given::eps | given::theta | given::tau | given::cycles |
                                                  given::seed,
                                              run_scales,
                                              settle_scales,
                                              nullptr,
                                              nullptr,
                                              nullptr};
}
