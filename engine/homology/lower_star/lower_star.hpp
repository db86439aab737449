// Diagrams of lower-star filtrations of triangulated balls; the complex is never stored.
#pragma once
#include <cstdint>

#include "complex/subcomplex.hpp"
#include "complex/triangulation.hpp"
#include "homology/persistence.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// A simplex of more than one vertex enters at the largest value[v] of its vertices; a vertex v < zero_born_count enters
// at 0 (input points of the complete filter, 7.4.2; all values must then be >= 0), any other vertex v at value[v].
template <int D> struct LowerStarFiltration {
    TriangulationView<D> complex;
    const double* value;  // [complex.vertex_count], no NaN; may contain ties of any number
    std::uint32_t zero_born_count;
    // The simplices that there are; null: all of the complex. An absent vertex has a value too, of which only its being
    // a number matters.
    const Subcomplex<D>* part = nullptr;

    // The same, its dimension a number or not.
    template <int E> class Converted;
    template <int E> Converted<E> of_dimension(DimensionOf<E> dim) const { return Converted<E>(*this, dim); }
};

template <int D> template <int E> class LowerStarFiltration<D>::Converted {
public:
    Converted(const LowerStarFiltration& from, DimensionOf<E> dim) {
        filtration_.complex = from.complex.template of_dimension<E>(dim);
        filtration_.value = from.value;
        filtration_.zero_born_count = from.zero_born_count;
        if (from.part != nullptr) {
            part_ = from.part->template of_dimension<E>(dim);
            filtration_.part = &part_;
        }
    }
    Converted(const Converted&) = delete;
    Converted& operator=(const Converted&) = delete;
    const LowerStarFiltration<E>& get() const { return filtration_; }

private:
    LowerStarFiltration<E> filtration_;
    Subcomplex<E> part_;
};

// The diagram in degrees 0..max_degree (larger counts as D-1); all simplices are counted.
//
// Requires: the cells triangulate a ball whose vertex links are spheres or balls (any Delaunay triangulation or mesh),
// every vertex is in a cell. A part is closed under faces and has the homology of a point (over Z/2); its simplices
// alone are counted and paired. The only essential class is then one of degree 0.
// O(simplices) plus the reduction of the critical simplices; a part adds O(2^D) look-ups for each cell that is not in,
// at each of its vertices that is cut. out_of_memory, cancelled, internal (not a ball, or a part that is seen not to be
// closed).
template <int D>
Status persist_lower_star(const LowerStarFiltration<D>& filtration, DiagramRequest request, const Work& work,
                          CountedPairs* out);
Status persist_lower_star(const LowerStarFiltration<any_dimension>& filtration, DiagramRequest request,
                          const Work& work, CountedPairs* out);

}  // namespace netmesh
