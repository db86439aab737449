// From a request to its diagram, or to its mesh alone.
#include "api/plan.hpp"
#include "api/request.hpp"

namespace netmesh {
namespace {

// A diagram that is there stays where more is wanted of it.
bool keeps_diagram(const netmesh_context* context) {
    const netmesh_request& r = context->request;
    return source_of(r) == Source::context && (r.bounds != nullptr || r.cycles != nullptr) && has_diagram_of(context);
}

netmesh_status make_diagram(netmesh_context* context) {
    const netmesh_request& r = context->request;
    if (r.vines != nullptr) return dispatch(*r.vines, context);
    if (r.fit != nullptr) return dispatch(*r.fit, context);
    return dispatch(*r.filter, context);
}

// Settled, or all 0. Without a filter, but with a method, it is one of netmesh_mesh.
Complaint read_settled(const netmesh_request* from, bool may_be_mesh, netmesh_request* request) {
    const netmesh_field fault = read_struct(from, request, sizeof *request);
    if (fault != NETMESH_FIELD_NONE) return complaint_about_struct(fault);
    const bool is_mesh = may_be_mesh && request->filter == nullptr && request->mesh.method != nullptr;
    return settle(is_mesh ? Call::mesh : Call::persist, 0, request);
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_persist(netmesh_context* context, const netmesh_request* from) {
    const TakenRequest taken(context, from, Call::persist);
    if (taken.status() != NETMESH_OK) return taken.status();
    netmesh_status status = keeps_diagram(context) ? NETMESH_OK : make_diagram(context);
    const netmesh_request& r = context->request;
    if (status == NETMESH_OK && r.bounds != nullptr) status = dispatch(*r.bounds, context);
    if (status == NETMESH_OK && r.cycles != nullptr) status = dispatch(*r.cycles, context);
    return status;
}

netmesh_status netmesh_mesh(netmesh_context* context, const netmesh_request* from) {
    const TakenRequest taken(context, from, Call::mesh);
    if (taken.status() != NETMESH_OK) return taken.status();
    const netmesh_request& r = context->request;
    if (r.weighting != nullptr) return dispatch_mesh(*r.weighting, context);
    return dispatch(r.mesh.method != nullptr ? *r.mesh.method : *r.filter->by_tau, context);
}

netmesh_status netmesh_settle(const netmesh_request* from, netmesh_request* settled, netmesh_detail* detail) {
    netmesh_request request;
    Complaint complaint = read_settled(from, true, &request);
    if (complaint.text == nullptr && !has_room(settled))
        complaint = {NETMESH_FIELD_RESULT, "settled is null or its size is not set"};
    if (complaint.text == nullptr) give_result(request, settled);
    const Status status = complaint.text == nullptr ? Status::ok
                          : complaint.not_built     ? Status::not_built
                                                    : Status::invalid_argument;
    netmesh_detail said = detail_of(status, complaint.text);
    said.field = complaint.field;
    give_result(said, detail);
    return static_cast<netmesh_status>(status);
}

size_t netmesh_plan(const netmesh_request* from) {
    netmesh_request request;
    return read_settled(from, false, &request).text != nullptr ? 0 : bytes_of_diagram(request);
}

}  // extern "C"
