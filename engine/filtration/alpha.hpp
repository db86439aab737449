// The alpha complex filtration of a Delaunay triangulation, exact: the baseline that approximations are measured by.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/faces.hpp"
#include "complex/triangulation.hpp"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// A Delaunay triangulation and where its points are: D doubles at the start of each vertex record, record v at
// v * stride_bytes (which may be negative). Neighbour words of the cells are not read.
template <int D> struct AlphaFiltration {
    TriangulationView<D> complex;
    const double* coordinates;
    std::ptrdiff_t stride_bytes;
};

// Values of the alpha filtration, as radii. A simplex enters at the radius of its smallest circumsphere when no point
// lies inside that (Gabriel), otherwise with the first of its cofacets; points enter at 0. value[k][i] belongs to the
// i-th k-face; the arrays hold faces.count[k] numbers each, k = 0..D. Never decreasing from a face to its cofaces.
//
// coordinates, stride_bytes: as above.
// Relative error about 1e-12 at most (see circumsphere.hpp for nearly flat simplices); where vertices are cospherical
// to the last bit, values that agree in theory agree in all bits if one simplex is a face of the other. Ties of
// cospherical points may be broken in any consistent way.
//
// Requires all faces (faces.dimension_max == D). One small linear solve a face: see circumsphere.hpp. cancelled.
template <int D>
Status alpha_values(const Faces<D>& faces, const double* coordinates, std::ptrdiff_t stride_bytes, Monitor& monitor,
                    double* const* value);

}  // namespace netmesh
