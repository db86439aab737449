// The alpha complex of points whose triangulation nobody wants.
#include "api/points.hpp"
#include "api/requests.hpp"
#include "jobs/alpha_of_points.hpp"

namespace netmesh {
namespace {

void keep_alpha(netmesh_context* context, const netmesh_alpha_request& request, const AlphaOfPoints& wanted,
                const AlphaDiagram& made) {
    context->complete = true;
    context->input = {true,         true, request.dim, made.input.rows, made.input.duplicates, made.input.fingerprint,
                      made.distinct};
    KeptDiagram& diagram = context->diagram;
    diagram.present = true;
    diagram.filter = NETMESH_FILTER_ALPHA;
    diagram.keeps_zero = wanted.diagram.keep_zero;
    diagram.max_degree = wanted.diagram.max_degree;
    diagram.pairs = Slice<Pair>::of(context->arena, made.found.pairs.pairs, made.found.pairs.count);
    diagram.simplices = made.found.simplices;
    diagram.certified_ratio = diagram.certified_ratio_best = 1;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_persist_alpha(netmesh_context* context, const netmesh_alpha_request* from) {
    netmesh_alpha_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about_points(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    const AlphaOfPoints wanted = {rows_of(request),
                                  request.point_count,
                                  request.seed,
                                  {degree_of(request.max_degree, request.dim), request.keep_zero_pairs != 0}};
    AlphaDiagram made = {};
    const Status found = with_dimension(request.dim, [&](auto dimension) {
        return alpha_of_points<decltype(dimension)::value>(wanted, {context->arena, monitor}, &made);
    });
    const Status status = watch.heed(found);
    if (status != Status::ok) return fail_and_clear(context, status, nullptr, made.input.row_a);
    keep_alpha(context, request, wanted, made);
    return finish(context, status);
}
