// What calls on points of which no mesh is made have in common.
#pragma once
#include "api/call.hpp"

namespace netmesh {

// What is kept of a request's points; made: PointsDiagram or PointsVineyard.
template <class Request, class Made> KeptInput input_of(const Request& request, const Made& made) {
    const std::uint64_t duplicates = request.point_count - made.distinct;
    return {true, true, request.dim, request.point_count, duplicates, made.input_fingerprint, made.distinct};
}

// Ends a call without OK: the context is empty. The job has said invalid_argument where field k is too large.
template <class Made>
netmesh_status fail_at_points(netmesh_context* context, Status status, netmesh_field k, const Made& made) {
    if (status != Status::invalid_argument)
        return fail_and_clear(context, status, nullptr, status == Status::not_finite ? made.culprit : 0);
    clear(context);
    return refuse(context, k, "k is more than the number of different points");
}

}  // namespace netmesh
