// Persistent homology over Z/2 of a filtered complex. No coordinates here: a complex, and the values at which its
// simplices enter. Thesis 6.3.
//
// Both calls put the diagram at the arena's low end in the canonical order (diagram/pair.hpp) and give everything else
// that they took back, whatever the outcome; without Status::ok nothing at all stays. The diagram depends on the
// filtration alone, never on the order of cells, simplices of equal value, or the size of the arena.
#pragma once
#include <cstdint>

#include "complex/triangulation.hpp"
#include "diagram/pair.hpp"
#include "memory/arena.hpp"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"
#include "memory/work.hpp"

namespace netmesh {

struct PairList {
    Pair* pairs;  // [count], at the arena's low end; not null, also when count is 0
    std::uint64_t count;
};

// Lower-star filtration of a triangulated D-ball whose complex is never stored. A simplex of more than one vertex
// enters at the largest value[v] of its vertices; a vertex v < zero_born_count enters at 0 (input points of the
// complete filter, 7.4.2; all values must then be >= 0), any other vertex v at value[v].
//
//   value        [complex.vertex_count], no NaN; may contain ties of any number
//   max_degree   0..D-1 (larger counts as D-1): classes of higher degree are left out
//   keep_zero    list the pairs with birth == death too, one for each two simplices: about simplex_count/2 of them
//   simplex_count  receives the number of simplices of all dimensions; may be null
//
// Requires: the cells triangulate a ball whose vertex links are spheres or balls (any Delaunay triangulation or mesh),
// every vertex is in a cell. The only essential class is then one of degree 0.
// O(simplices) plus the reduction of the critical simplices. out_of_memory, cancelled, internal (not a ball).
template <int D>
Status persist_lower_star(const TriangulationView<D>& complex, const double* value, std::uint32_t zero_born_count,
                          std::uint32_t max_degree, bool keep_zero, const Work& work, PairList* out,
                          std::uint64_t* simplex_count);

// Any filtered simplicial complex, listed dimension by dimension. of[k] are the k-simplices in an order of
// non-decreasing value; simplex i of dimension k has the faces of[k].faces[(k+1)*i .. (k+1)*i + k], positions in
// of[k-1] in any order. of[0].faces is not read. A face enters no later than its cofaces: of[k-1].value[face] <=
// of[k].value[i].
struct FilteredComplex {
    static constexpr std::uint32_t dimension_max = 31;
    struct Simplices {
        std::uint32_t count;         // < 2^31
        const std::uint32_t* faces;  // [count][k+1]
        const double* value;         // [count], non-decreasing, no NaN
    };
    std::uint32_t dimension;  // of[0..dimension] are read
    Simplices of[dimension_max + 1];
};

// Column reduction with clearing; union-find in degree 0, and in the top degree where no face has more than two
// cofaces. Takes about 5 bytes for each simplex of the most frequent dimension, 4 for each of the top two, plus fill.
// max_degree may equal the dimension: cycles of the top dimension are then listed as essential classes.
// invalid_argument (dimension), out_of_memory, cancelled.
Status persist_filtration(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, const Work& work, PairList* out);

// The same by columns of cofaces, which only simplices of dimension max_degree and less have: faster by orders of magnitude
// where the highest dimension has the most simplices, as in skeletons of simplices (Rips, Cech). Takes about 5 bytes for
// each simplex of the most frequent dimension, and 4 (k + 2) for each (k+1)-simplex, one k at a time, plus fill.
Status persist_skeleton(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, const Work& work, PairList* out);

}  // namespace netmesh
