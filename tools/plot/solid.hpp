// Pictures of what is in space: parallel projection, the farther first.
#pragma once
#include <array>
#include <vector>

#include "tools/io/mesh_files.hpp"
#include "tools/plot/svg.hpp"

namespace netmesh::tool {

using Vec3 = std::array<double, 3>;

// Along a direction that shows three sides of a box, upright.
struct Projection {
    Vec3 right, up, towards;  // an orthonormal frame; the viewer is towards +infinity
    double low_x = 0, low_y = 0, scale = 1, left = 0, bottom = 0;

    Projection();
    // Puts the places into a square, whole; of the plane they are seen from above.
    void fit(const std::vector<Vec3>& places, double x, double y, double side, bool is_plane);
    double x(const Vec3& place) const;
    double y(const Vec3& place) const;
    double depth(const Vec3& place) const;  // the larger the nearer
};

double dot(const Vec3& a, const Vec3& b);

// A picture of the tetrahedra whose middle is behind a plane through the middle of the mesh.
void write_cut_picture(const MeshSource& mesh, TextWriter& out);

}  // namespace netmesh::tool
