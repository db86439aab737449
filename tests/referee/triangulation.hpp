// Are the cells a Delaunay triangulation of the convex hull of the vertices?
//
// They are when
//   - no cell has a vertex twice, every vertex has a cell, a facet has one cell or two, and .neigh says which;
//   - every cell is positively oriented, and the two cells of a facet lie on its two sides;
//   - all vertices are on the inner side of every facet of one cell, or on it: then the number of cells over a point
//     is the same for all points inside the hull that are on no facet, because going from one to another crosses only
//     facets with a cell on each side; and some such point is in one cell exactly;
//   - no vertex is strictly inside the sphere of a cell. On the sphere is allowed. Facet by facet this says the same
//     (Delaunay's lemma), so large meshes are looked at facet by facet and, in a sample of cells, vertex by vertex.
// All signs are exact.
#pragma once
#include "mesh_file.hpp"
#include "random.hpp"
#include "verdict.hpp"

namespace referee {

// Orientation of a cell of the mesh with vertex i replaced by `other` (i < 0: none is).
int orientation(const Mesh& mesh, const Entries& cell, int i, const Point& other);

// Vertices of facets of one cell; every facet by its cell and the position of the opposite vertex.
struct Hull {
    std::vector<bool> has;
    std::vector<std::pair<std::uint32_t, int>> facets;
};

// sphere_tests: cells times vertices that are looked at one by one.
Hull judge_triangulation(const Mesh& mesh, double sphere_tests, Random& random, Verdict* verdict);

}  // namespace referee
