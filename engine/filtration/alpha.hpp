// The alpha complex filtration of a Delaunay triangulation, exact: the baseline that approximations are measured by.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/faces.hpp"
#include "complex/triangulation.hpp"
#include "memory/work.hpp"
#include "predicates/weights.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// A Delaunay triangulation and where its points are: D doubles at the start of each vertex record, record v at
// v * stride_bytes (which may be negative). Neighbour words of the cells are not read.
template <int D> struct AlphaFiltration {
    TriangulationView<D> complex;
    const double* coordinates;
    std::ptrdiff_t stride_bytes;
    std::uint64_t hull_facets = 0;  // count_hull_facets
    bool drops_cells = false;       // they are the last piece at the arena's low end, and are wanted no more
    // Null, or all vertices, each in a cell, in an order as of spatial_order: record i is that of vertex order[i] then.
    // Behind cells that are dropped.
    const std::uint32_t* order = nullptr;
};

// Values of the alpha filtration, as radii. A simplex enters at the radius of its smallest circumsphere when no point
// lies inside that (Gabriel; on it does not count), otherwise with the first of its cofacets; points enter at 0.
// value[k][i] belongs to the i-th k-face; the arrays hold faces.count[k] numbers each, k = 0..D.
//
// Exact: whether a sphere is empty is decided exactly, and a value is the true one rounded to the nearest double, ties
// to even, a function of the simplex whose radius it is. Rounding exchanges no order, so values never decrease from a
// face to its cofaces, and the diagram is that of exact arithmetic with both ends of each bar rounded.
//
// coordinates, stride_bytes: as above; where the lists of faces follow an order, record i is that of 0-face i. Nothing
// is out_of_range as long as differences of coordinates are below 2^(16,600 / (2D+2)) units, the unit being the highest
// power of two of which all coordinates are multiples: 2^2766 in the plane, 2^2075 in space, 2^1185 in R^6.
//
// With weights the triangulation is the regular one, and records have D + 1 numbers. A simplex enters at the power of
// the smallest sphere that is orthogonal to its vertices when no point has less power at its centre (as much does not
// count), otherwise with the first of its cofacets; so do points, at less than their weight. Values are signed roots of
// powers, or powers, of either sign.
//
// Requires all faces (faces.dimension_max == D), fewer than 2^32; last_vertex[D] is not read. One small linear solve a
// face, see circumsphere_fast.hpp, which is nearly always enough. Scratch at the high end: see
// settle_circumsphere; with weights that of ExactSphere.
// out_of_memory, out_of_range, cancelled; check_failed: a simplex is flat, as those of loaded cells may be.
template <int D>
Status alpha_values(const Faces<D>& faces, const double* coordinates, std::ptrdiff_t stride_bytes, const Work& work,
                    double* const* value);

struct PowerValues : Weights {
    bool squares;  // powers, not their signed roots
};
template <int D>
Status alpha_values_weighted(const Faces<D>& faces, const double* coordinates, std::ptrdiff_t stride_bytes,
                             const PowerValues& powers, const Work& work, double* const* value);

}  // namespace netmesh
