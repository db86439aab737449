// What calls on complexes that are given by their simplices have in common.
#pragma once
#include "api/call.hpp"
#include "jobs/list_simplices.hpp"

namespace netmesh {

// Of netmesh_homology_request and netmesh_value_vineyard_request.
template <class Request> Complaint complaint_about_simplices(const Request& request) {
    if (request.vertices == nullptr) return {NETMESH_FIELD_VERTICES, "vertices is null"};
    if (request.starts == nullptr) return {NETMESH_FIELD_STARTS, "starts is null"};
    if (request.entries == nullptr) return {NETMESH_FIELD_ENTRIES, "entries is null"};
    if (request.simplex_count == 0) return {NETMESH_FIELD_SIMPLEX_COUNT, "there are no simplices"};
    if (request.vertex_count != 0 && request.starts[request.simplex_count] > request.vertex_count)
        return {NETMESH_FIELD_VERTEX_COUNT, "starts leads beyond the last vertex"};
    return {};
}

// Ends a call without OK: the context is empty, and its detail tells the fault where the list is to blame.
netmesh_status fail_at_simplex(netmesh_context* context, Status status, const SimplexFault& fault,
                               std::uint32_t step = 0);

}  // namespace netmesh
