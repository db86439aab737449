// Simplicial complexes as lists of vertices, one array a dimension, on their way to a FilteredComplex. Thesis 6.2.
#pragma once
#include <cstdint>

#include "complex/filtered_complex.hpp"
#include "memory/arena.hpp"
#include "memory/work.hpp"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// rows[k] holds the vertices of the k-simplices, ascending, until link_faces puts their facets there instead: facet i
// of a simplex lacks its i-th vertex. rows[0] always holds the vertices' labels.
struct ListedComplex {
    static constexpr std::uint32_t dimension_max = FilteredComplex::dimension_max;
    std::uint32_t dimension;
    std::uint32_t count[dimension_max + 1];  // < 2^31
    std::uint32_t* rows[dimension_max + 1];  // [count][k + 1]
    double* value[dimension_max + 1];        // [count], no NaN, no -0.0

    FilteredComplex filtered() const;  // once linked and ordered
};

// Why a list of simplices is not a filtered complex.
struct ComplexFault {
    enum Kind { nothing, repeated, face_missing, face_later };
    Kind kind;
    std::uint32_t dimension, index;  // the simplex
    std::uint32_t other;  // repeated: the equal simplex before it; face_missing: which of its vertices the missing
                          // facet lacks; face_later: the facet, as a position
};

// Turns rows into facets, from the top down. With `check` the first fault in the order of dimension and index is told;
// without it the caller vouches for the rows, and values are not read. Scratch: 8 to 16 bytes for each simplex of one
// dimension. Expected O(k^2) for each k-simplex. out_of_memory, cancelled, check_failed (a fault).
Status link_faces(ListedComplex& complex, bool check, const Work& work, ComplexFault* fault);

// Puts every dimension of a linked complex in order of value, ties as they are. Scratch: 8 bytes a simplex of two
// dimensions. out_of_memory.
Status order_by_value(ListedComplex& complex, Arena& arena);

// The same for one dimension. out_of_memory.
Status order_dimension(ListedComplex& complex, std::uint32_t k, Arena& arena);

// Puts rows of `width` words that stand beside the simplices of one dimension, of these values before they are put in
// order, where order_dimension puts their simplices. Scratch: 12 bytes a row. out_of_memory.
Status order_beside(const double* value, std::uint32_t count, std::uint32_t* rows, std::uint32_t width, Arena& arena);

// The labels of the vertices of one k-simplex of a linked complex, in the order in which facets lack them. O(k^2).
void vertices_of(const FilteredComplex& complex, const std::uint32_t* labels, std::uint32_t k, std::uint32_t simplex,
                 std::uint32_t* vertices);
void vertices_of(const ListedComplex& complex, std::uint32_t k, std::uint32_t simplex, std::uint32_t* vertices);

}  // namespace netmesh
