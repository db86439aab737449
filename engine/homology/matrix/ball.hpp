// Persistence of a triangulated ball whose faces are listed with values, in any order.
#pragma once
#include <cstdint>

#include "complex/filtered_complex.hpp"
#include "homology/persistence.hpp"
#include "memory/work.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// All faces of dimensions 0..dimension of a triangulated `dim`-ball, as Faces<D> lists them. A value is never below
// those of the face's facets; vertices have the same value. Edges may have it, too, where they are too short for half
// of them to be a double, and values may be infinite.
struct FilteredBall {
    struct Simplices {
        std::uint32_t count;   // < 2^31
        std::uint32_t* faces;  // [count][k+1], positions in of[k-1]; those of cells are overwritten
        const double* value;   // [count], no NaN, none negative, no -0
    };
    std::uint32_t dim, dimension;  // 1 <= dimension <= dim
    // They are at the arena's low end, faces and values of dimension k behind those of k-1 and nothing behind the last:
    // what is no longer needed makes room for pairs.
    bool stacked;
    Simplices of[dimension_most() + 1];
    bool repeats = false;  // of quotients: whether some simplex has a facet more than once
};

// Degrees 0..dimension-1. Faces and cofaces of equal value are paired before anything is put in order: in alpha
// filtrations more than half of all. What is left is sorted; union-find in degree 0 and, where cells are listed, in
// degree dim-1; between them reduction of columns.
// Takes about 8 bytes for each simplex of the most frequent dimension, plus fill. out_of_memory, cancelled.
Status persist_ball(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out);

// The same of a ball of dimension 2, or of edges alone: nothing but union-find.
Status persist_disk(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out);

// The same with values of any sign, no -0, and vertices of different values.
Status persist_signed_ball(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out);
Status persist_signed_disk(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out);

// The same of a quotient of such a complex, or of a larger one, by what moves every simplex, as translations do:
// classes last, of degrees to `dim`, and a simplex may have a facet more than once, in its boundary if that is an odd
// number of times. No facet is one of more than two cells, each counted as often as it has the facet.
Status persist_quotient(const FilteredBall& quotient, DiagramRequest request, const Work& work, PairList* out);

}  // namespace netmesh
