// Which simplices of a mesh belong to its cells clipped to a ball: those whose dual Voronoi face meets the ball.
#pragma once
#include <cstdint>
#include <set>
#include <vector>

#include "tools/io/mesh_files.hpp"
#include "tools/opinion/filtered_complex.hpp"
#include "tools/opinion/spheres.hpp"

namespace netmesh::tool {

// Of a Voronoi face and a ball. `unknown`: the distance of the face is the ball's radius, but for rounding.
enum class Meeting : std::uint8_t { apart, meets, unknown };

// The hull of points, plus the cone of rays. Lengths are over the ball's radius, from its centre on.
struct HullAndCone {
    std::vector<Place> points;
    std::vector<Real> point_errors;  // the true point is no farther away
    std::vector<Place> rays;         // unit vectors
    Real ray_error = 0;              // of each of them
    // No point of the set within the ball needs rays of more than this length in sum.
    Real ray_length = 0;
    bool complete = true;  // false: a point of the set is not known, so that nothing is known to be apart
};

// Of the set and the ball of radius 1 about the origin.
Meeting meeting_of(const HullAndCone& set);

struct ClippedNerve {
    std::set<Vertices> simplices;  // that belong to it, of up to top + 1 vertices; vertices ascending
    std::vector<Meeting> vertices;
    std::uint64_t unknown = 0;  // simplices that may belong to it and may not
};

// The mesh is taken to be Delaunay; the ball is its domain.
ClippedNerve clipped_nerve(const MeshFiles& files, std::uint32_t top);

}  // namespace netmesh::tool
