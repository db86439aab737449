#include "api/request.hpp"

#include "filtration/filters.hpp"

namespace netmesh {

netmesh_status TakenRequest::take(netmesh_context* context, const netmesh_request* from, Call call) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    netmesh_request& request = context->request;
    const netmesh_field fault = read_struct(from, &request, sizeof request);
    // More of a diagram that is there is of its values.
    const KeptDiagram& kept = context->diagram;
    const bool wants_more = request.bounds != nullptr || request.cycles != nullptr;
    if (fault == NETMESH_FIELD_NONE && wants_more && source_of(request) == Source::context && kept.present &&
        request.filter != nullptr && request.filter->id == kept.filter &&
        in_range(request.values, NETMESH_VALUES_OPEN, NETMESH_VALUES_OPEN))
        request.values = kept.values;
    Complaint complaint =
        fault == NETMESH_FIELD_NONE ? settle(call, context->input.dim, &request) : complaint_about_struct(fault);
    if (complaint.text == nullptr && request.points.dim != 0) complaint = complaint_about_coordinates(request.points);
    if (complaint.text == nullptr) return NETMESH_OK;
    __builtin_memset(&request, 0, sizeof request);
    return refuse(context, complaint);
}

Complaint read_promises(netmesh_context* context, const netmesh_request* promised, std::uint32_t dim,
                        Promises* promises, ErrorSizes* sizes) {
    *promises = {};
    promises->tau = promises->net.tau = tau_of(dim, 0);
    if (promised == nullptr) return {};
    netmesh_request& request = context->request;
    const netmesh_field fault = read_struct(promised, &request, sizeof request);
    Complaint complaint = fault != NETMESH_FIELD_NONE ? complaint_about_struct(fault) : Complaint{};
    if (complaint.text == nullptr && request.points.dim != 0 && request.points.dim != dim)
        complaint = {NETMESH_FIELD_PROMISED, "what is promised is of another dimension"};
    if (complaint.text == nullptr) complaint = settle_promise(dim, &request);
    if (complaint.text == nullptr) {
        const MeshRequest asked = mesh_request_of(request, dim, sizes);
        *promises = {asked.tau, asked.size, asked.goal, {}, asked.cages};
        promises->net.tau = asked.tau;
        promises->net.spacing = request.mesh.net_spacing;
    }
    __builtin_memset(&request, 0, sizeof request);
    return complaint;
}

bool has_diagram_of(const netmesh_context* context) {
    const KeptDiagram& kept = context->diagram;
    const netmesh_request& r = context->request;
    if (!kept.present || kept.filter != r.filter->id || kept.values != r.values || kept.k != r.k) return false;
    // Of simplices the degree that was left open is that of the diagram.
    const bool is_open = kept.filter == NETMESH_FILTER_NONE && r.max_degree == NETMESH_DEGREE_MAX;
    const std::uint32_t degree = is_open                 ? kept.max_degree
                                 : context->mesh.present ? degree_of(r.max_degree, context->input.dim)
                                                         : r.max_degree;
    return kept.max_degree == degree && kept.keeps_zero == (r.keep_zero_pairs != 0);
}

const char* missing_cells(const netmesh_context* context) {
    if (!context->complete) return "there is no complete triangulation or mesh";
    return context->mesh.present ? nullptr : "there is no triangulation or mesh";
}

const char* missing_mesh(const netmesh_context* context) {
    const char* const missing = missing_cells(context);
    if (missing != nullptr) return missing;
    if (!context->mesh.is_mesh) return "this filter needs a mesh";
    return context->mesh.cages.count > 0 ? "this filter needs a mesh without cages" : nullptr;
}

WeightRows weights_of(const netmesh_request& r) {
    const netmesh_points& p = r.points;
    return {{p.weights, p.weight_stride_bytes, p.format == NETMESH_POINTS_FLOAT32}, r.weighting->are_radii};
}

[[gnu::cold]] bool refuses_square(netmesh_context* context, Status status) {
    const netmesh_request& r = context->request;
    if (status != Status::out_of_range || r.squares == 0 || !r.weighting->are_radii) return false;
    const WeightRows weights = weights_of(r);
    std::uint64_t row = 0;
    for (double radius; row < r.points.count; ++row)
        if (weights.rows.read(row, 1, &radius) && radius * radius == infinity) break;
    if (row == r.points.count) return false;
    refuse(context,
           {NETMESH_FIELD_WEIGHTS, "the square of this radius is beyond the largest double; leave out squares"}, row);
    return true;
}

}  // namespace netmesh
