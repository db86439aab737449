// Triangulations for calls that may think better of them.
#pragma once
#include "api/context.hpp"
#include "delaunay/triangulate.hpp"

namespace netmesh {

// netmesh_delaunay in an empty context, of a request that nothing is wrong with. `allowance` may be null; when it is
// spent the status is NETMESH_CANCELLED, and what the context holds has to be cleared.
netmesh_status triangulate_points(netmesh_context* context, const netmesh_delaunay_request& request,
                                  Allowance* allowance);

}  // namespace netmesh
