// How far Voronoi cells reach in a ball.
//
// A clipped cell is convex. The place of it that is farthest from q is a corner of the cell or lies on the sphere, in
// the relative interior of a face of the cell. There |y - q|^2 = |y - c|^2 + 2 (y - c) . (c - q) + |c - q|^2, c the
// centre, is linear in y: on a face of dimension 2 or more the place is the pole of the flat's own sphere in the
// direction c - q, on an edge it is where the edge leaves the ball. Where the flat is orthogonal to c - q any place of
// its sphere will do: if it is not in the face, the sphere leaves the face through one of lower dimension.
//
// The place that is nearest to q lies in the relative interior of a face, too: it is the foot of q on the face's flat
// or, where the foot is outside of the ball, the pole on the side of q.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "tools/io/mesh_files.hpp"
#include "tools/opinion/spheres.hpp"

namespace netmesh::tool {

// A facet that one cell has alone: the cell and the place of its vertex that the facet lacks.
struct HullFacet {
    std::size_t cell;
    std::uint32_t opposite;
};
std::vector<HullFacet> hull_facets(const CellTable& cells);

struct CellShape;  // flats of a cell's faces that meet the ball

class ClippedCells {
public:
    // The mesh is taken to be Delaunay. corners[c]: the centre of cell c's circumscribed ball, an empty place where it
    // is not known; star[v]: the cells around v. They must stay where they are.
    ClippedCells(const MeshFiles& files, const std::vector<Place>& places, const std::vector<Place>& corners,
                 const std::vector<std::vector<std::uint32_t>>& star);

    const Place& centre() const { return centre_; }
    Real radius() const { return radius_; }
    bool holds(const Place& x) const { return distance2(x, centre_) <= radius_ * radius_; }
    // Not all of v's cell is known to be in the ball.
    bool is_cut(std::size_t v) const { return cut_[v]; }
    std::shared_ptr<const CellShape> shape(std::size_t v) const;
    // Places of v's clipped cell: its corners in the ball, where its edges cross the sphere, and the poles of its faces
    // as seen from each of `from`. The ones that are farthest from those are among them.
    std::vector<Place> places(const CellShape& shape, const std::vector<Place>& from) const;
    // The place of v's clipped cell that is nearest to q, a place in the ball; empty when none is found.
    Place nearest(const CellShape& shape, const Place& q) const;

private:
    const MeshFiles& files_;
    const std::vector<Place>&places_, &corners_;
    const std::vector<std::vector<std::uint32_t>>& star_;
    Place centre_;
    Real radius_;
    std::vector<bool> cut_;
};

}  // namespace netmesh::tool
