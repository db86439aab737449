// What calls on complexes that are given by their simplices have in common.
#pragma once
#include "api/call.hpp"
#include "jobs/list_simplices.hpp"

namespace netmesh {

// The simplices of the context's request.
Complaint read_simplices(const netmesh_request& request, netmesh_simplices* simplices);

// Ends a call without OK: the context is empty, and its detail tells the fault where the list is to blame.
netmesh_status fail_at_simplex(netmesh_context* context, Status status, const SimplexFault& fault,
                               std::uint32_t step = 0);

}  // namespace netmesh
