// What requests stand for: defaults filled in, and what several jobs check of them.
#pragma once
#include <cstddef>

#include "api/call.hpp"
#include "certificate/certificate.hpp"
#include "filtration/filter.hpp"
#include "mesh/check/check_domain.hpp"
#include "mesh/mesh_request.hpp"
#include "mesh/sizing.hpp"
#include "numerics/input_rows.hpp"

namespace netmesh {

// tau, or the dimension's default. Requires a dimension that is served.
double tau_of(std::uint32_t dim, double tau);
inline double eps_of(double eps) { return eps != 0 ? eps : 0.5; }
inline double theta_of(double theta) { return theta != 0 ? theta : 1.0 / 9; }
inline FilterValues values_of(netmesh_values values) {
    return values == NETMESH_VALUES_THESIS ? FilterValues::thesis : FilterValues::certified;
}
// Of a mesh or triangulation in `dim` dimensions.
inline std::uint32_t degree_of(std::uint32_t max_degree, std::uint32_t dim) {
    return max_degree < dim ? max_degree : dim - 1;
}
inline SizeRule size_rule_of(const netmesh_mesh_request& mesh) {
    return {mesh.sizes.eps, mesh.sizes.size, mesh.sizes.user, mesh.size_at_inputs, mesh.size_growth};
}
inline RatioGoal goal_of(const netmesh_mesh_request& mesh) {
    const netmesh_certificate_goal& goal = mesh.certificate;
    return {goal.ratio, goal.focus_ratio, goal.focus_from, goal.focus_to, goal.ratio > 0 && mesh.whole_cells == 0};
}

bool is_valid_tau(double tau);      // finite, above 2
bool is_valid_ratio(double ratio);  // finite, above the root of 2
bool is_valid_eps(double eps);
bool is_valid_theta(double theta);
bool is_valid_scales_ratio(double ratio, double theta);  // what 1 + 3 theta leaves is a valid ratio

Complaint complaint_about_dim(std::uint32_t dim);

// Points as they lie in the caller's memory.
struct GivenRows {
    const void* points;
    std::size_t count;
    std::uint32_t dim;
    const netmesh_point_format* format;  // may be none of the enumeration's
    std::size_t stride_bytes;

    bool has_floats() const { return *format == NETMESH_POINTS_FLOAT32; }
    std::size_t alignment() const {
        // What the platform aligns a double to inside of a struct: 4 bytes in 32 bits on x86, 8 elsewhere.
        struct AlignedDouble {
            char before;
            double x;
        };
        return has_floats() ? alignof(float) : offsetof(AlignedDouble, x);
    }
};
template <class Request> GivenRows given_rows(const Request& request) {
    return {request.points, request.point_count, request.dim, &request.point_format, request.point_stride_bytes};
}
// Of points, or of what has distances: 1 .. NETMESH_POINTS_MAX.
Complaint complaint_about_point_count(std::uint64_t count);
// Of format and stride, all that a plan knows of where the points lie. count: 1 .. NETMESH_POINTS_MAX.
Complaint complaint_about_layout(const GivenRows& given);
// dim_max: more than NETMESH_DIM_MAX where any dimension from there on is served.
Complaint complaint_about_rows(const GivenRows& given, std::uint32_t dim_max = NETMESH_DIM_MAX);
template <class Request>
Complaint complaint_about_points(const Request& request, std::uint32_t dim_max = NETMESH_DIM_MAX) {
    return complaint_about_rows(given_rows(request), dim_max);
}
// Of a request that nothing is wrong with.
template <class Request> InputRows rows_of(const Request& request) {
    return {request.points, request.point_stride_bytes, request.point_format == NETMESH_POINTS_FLOAT32};
}

// Is what evaluates the filter in this build? k: 1 where it has none.
Complaint complaint_about_built_filter(netmesh_filter filter, std::uint32_t k);
Complaint complaint_about_values(const netmesh_values& values);
Complaint complaint_about_focus(double from, double to);
// Copies the caller's function, as this version knows it.
Complaint read_function(const netmesh_function* from, netmesh_function* function);

// Why the context does not hold what a filter is evaluated on; null when it does.
const char* missing_result(const netmesh_context* context, const Filter& filter);

// What a mesh promises, for requests that point to a mesh request.
struct Promises {
    double tau = 0;
    SizeRule sizes = {};
    RatioGoal goal = {};  // ratio 0: none
    NetPromise net = {};
    CageKind cages = CageKind::compact;
};

// Reads the promises of `mesh`, or the dimension's when it is null.
Complaint read_promises(const netmesh_mesh_request* mesh, std::uint32_t dim, Promises* promises);

}  // namespace netmesh
