// The alpha complex filtration of a Delaunay triangulation, exact: the baseline that approximations are measured by.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/faces.hpp"
#include "homology/persistence.hpp"
#include "memory/work.hpp"

namespace netmesh {

// Values of the alpha filtration, as radii. A simplex enters at the radius of its smallest circumsphere when no point
// lies inside that (Gabriel), otherwise with the first of its cofacets; points enter at 0. value[k][i] belongs to the
// i-th k-face; the arrays hold faces.count[k] numbers each, k = 0..D. Never decreasing from a face to its cofaces.
//
// coordinates: D doubles at the start of each vertex record, record v at v * stride_bytes (which may be negative).
// Relative error about 1e-12 at most (see circumsphere.hpp for nearly flat simplices); where vertices are cospherical
// to the last bit, values that agree in theory agree in all bits if one simplex is a face of the other. Ties of
// cospherical points may be broken in any consistent way.
//
// Requires all faces (faces.dimension_max == D). One small linear solve a face: see circumsphere.hpp. cancelled.
template <int D>
Status alpha_values(const Faces<D>& faces, const double* coordinates, std::ptrdiff_t stride_bytes, Monitor& monitor,
                    double* const* value);

// Persistent homology of that filtration in degrees 0..max_degree (at most D-1; larger is clamped). Neighbour words of
// the complex are not read. keep_zero: list pairs whose birth and death are equal too; otherwise also pairs shorter
// than the rounding errors of their values (2^-36 relative) are left out, which no input can be known to have.
// simplex_count: of dimensions 0..max_degree+1, which are what is filtered; may be null.
//
// The diagram is put at the arena's low end in the canonical order (diagram/pair.hpp), everything else is given back;
// without Status::ok nothing stays. It does not depend on the order in which cells are stored.
// Memory: 20, 23, 26, 29, 32 bytes a simplex of the triangulation in D = 2..6 until all are in order; then 16, 19, 22,
// 25, 28 and what persist_filtration takes. Peaks seen: 30, 27, 27, 29, 32.
// out_of_memory, cancelled.
template <int D>
Status persist_alpha(const TriangulationView<D>& complex, const double* coordinates, std::ptrdiff_t stride_bytes,
                     std::uint32_t max_degree, bool keep_zero, const Work& work, PairList* out,
                     std::uint64_t* simplex_count);

// Leaves out the pairs of such a diagram that are shorter than rounding errors, which persist_alpha does by itself.
void drop_rounding(PairList* pairs);

}  // namespace netmesh
