// What a filter's values, its certificate and its intervals have to be on a mesh, from the Voronoi cells of its
// vertices: the corners of each cell are the centres of the circumscribed balls of the Delaunay cells around the
// vertex.
#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "tools/filters.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/opinion/spheres.hpp"

namespace netmesh::tool {

// The function lies between lo and hi on a vertex's cell; an infinite lo is no claim, nor is a hi of 0.
struct CellRange {
    Real lo, hi;
};

// F, the function of the filter, cut where all inputs have been reached.
class FilteredFunction {
public:
    FilteredFunction(const NodeFile& node, netmesh_filter_id filter, std::uint32_t k);
    Real operator()(const Place& x) const { return std::min(cut_, uncut(x)); }
    Real uncut(const Place& x) const { return value_of(nearest(x)); }
    // Also where the value comes from: the k-th nearest input or the mean of the nearest k. Near x the function's
    // square is the squared distance to that place plus a constant.
    Real operator()(const Place& x, Place* source) const;
    bool is_least_of_distances() const { return mean_ || k_ == 1; }  // each to a source, with a constant
    Real cut() const { return cut_; }

private:
    std::vector<std::pair<Real, std::uint32_t>> nearest(const Place& x) const;  // squares, inputs; ascending
    Real value_of(const std::vector<std::pair<Real, std::uint32_t>>& nearest) const;

    std::vector<Place> inputs_;
    bool mean_;
    std::uint32_t k_;
    Real cut_ = 0;
};

// Vertices are often equally far from several inputs, as centres of balls through them. Which of these is the nearest
// then hangs on rounding, and with it the upper end of the cell's range: what follows is only known to lie between two
// numbers, which are mostly the same.
struct Span {
    Real least, most;
};

struct CellOpinion {
    std::vector<Span> values;  // t of each vertex; any number of one whose clipped cell is empty, or may be
    Span ratio = {1, 1};
    Span from = {0, 0};
    // What F surely takes on the cell: least and largest value found at the vertex, at the corners of its cell, where
    // the sphere crosses edges, at poles of faces, and at places of the cell nearest to inputs: to the vertex's nearest
    // one, then to those that are nearest where F is least so far. No formula for intervals enters.
    std::vector<CellRange> seen;
    std::uint64_t places = 0;  // at which F was looked at
    // Share by which numbers of the engine may differ from these: 1e-9, which is far more than the roundings that it
    // adds to its bounds, and what follows from its corners' coordinates being doubles. A corner c is off by up to
    // u |c|, u = 2^-53, and the engine adds 4.2 u |c| to what cells reach and takes it from how near they come. All
    // those lengths are at least half of the least distance n of two vertices: 10.4 u sqrt(D) magnitude / n of them.
    // Refinement keeps n above 24 sqrt(D) units in the last place. Where a clipped cell ends on the sphere, sums of
    // products with the ball's radius cancel: there are more of those units. Not what the shape of a nearly flat cell
    // adds to the error of its corner (corner_error.hpp): that is in the spans.
    Real tolerance = 1e-9L;
};

// Vertices 0 .. zero_born - 1 enter at 0, before their stars.
std::uint32_t zero_born(const NodeFile& node, netmesh_filter_id filter, std::uint32_t k);

// Steps that cell_opinion takes, but for a small factor: cells times inputs.
double opinion_cost(const MeshFiles& files);
// For the filters on meshes of distances to points. The mesh is taken to be Delaunay. `claimed` is the certified ratio
// that is to be judged: certified values follow from it.
CellOpinion cell_opinion(const MeshFiles& files, const FilterChoice& choice, std::uint32_t k, double claimed);

}  // namespace netmesh::tool
