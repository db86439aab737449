// What a request stands for: the one place that knows what goes together.
#pragma once
#include <cstddef>

#include "api/call.hpp"
#include "api/objects.hpp"
#include "filtration/filter.hpp"
#include "numerics/input_rows.hpp"

namespace netmesh {

enum class Source { context, points, distances, simplices };
Source source_of(const netmesh_request& request);

// Who reads a request: netmesh_persist, netmesh_mesh, or a call that checks what it promises of a mesh.
enum class Call { persist, mesh, promise };

// Fills in what was left open, in this order: source, filter, values, wants; what is not read; then what the filter,
// or without one the method, knows: neighbours, degree, threshold, function, goal, method, rules of meshes. A complaint
// names the field that contradicts the rest, or is not read, and what to do. What is settled stays as it is when it is
// settled again. held_dim: of the mesh that the context holds, 0: unknown.
Complaint settle(Call call, std::uint32_t held_dim, netmesh_request* request);
// The same of what is promised of a mesh.
Complaint settle_promise(std::uint32_t held_dim, netmesh_request* request);

// ---- of a request that is settled ----

// tau, or the dimension's default. Requires a dimension that is served.
double tau_of(std::uint32_t dim, double tau);
inline bool fits_error(const netmesh_request& request) {
    return request.fit != nullptr && request.filter != nullptr && request.filter->id == NETMESH_FILTER_FUNCTION;
}
inline FilterValues values_of(netmesh_values values) {
    return values == NETMESH_VALUES_THESIS ? FilterValues::thesis : FilterValues::certified;
}
// Of a mesh or triangulation in `dim` dimensions.
inline std::uint32_t degree_of(std::uint32_t max_degree, std::uint32_t dim) {
    return max_degree < dim ? max_degree : dim - 1;
}
// Of points that nothing is wrong with.
inline InputRows rows_of(const netmesh_points& points) {
    return {points.coordinates, points.stride_bytes, points.format == NETMESH_POINTS_FLOAT32};
}

// The sizes of an additive error of the diagram of a function, and of the caller.
struct ErrorSizes {
    netmesh_function function = {};
    double error = 0;
    SizeRule caller = {};  // the lesser of both is asked for
    static double at(void* self, const double* x);
};

// What it asks of the mesher. `sizes` has to live as long as the result; it is read where goal.error is.
MeshRequest mesh_request_of(const netmesh_request& request, std::uint32_t dim, ErrorSizes* sizes);

// ---- parts of requests ----

Complaint complaint_about_dim(std::uint32_t dim);
// Of points, or of what has distances: 1 .. NETMESH_POINTS_MAX.
Complaint complaint_about_point_count(std::uint64_t count);
// How many there are and how they lie; their dimension is known.
Complaint complaint_about_rows(const netmesh_points& points);
// What the platform aligns a number to inside of a struct: of doubles 4 bytes in 32 bits on x86, 8 elsewhere.
struct AlignedDouble {
    char before;
    double x;
};
constexpr std::size_t alignment_of_double = offsetof(AlignedDouble, x);
std::size_t alignment_of(const netmesh_points& points);
// Where the numbers lie, which a plan does not read.
Complaint complaint_about_coordinates(const netmesh_points& points);
// Copies the caller's function, as this version knows it.
Complaint read_function(const netmesh_function* from, netmesh_function* function);

}  // namespace netmesh
