// Any filtered simplicial complex, listed dimension by dimension. Thesis 6.2.
#pragma once
#include <cstddef>
#include <cstdint>

namespace netmesh {

// of[k] are the k-simplices in an order of non-decreasing value; simplex i of dimension k has the faces
// of[k].faces[(k+1)*i .. (k+1)*i + k], positions in of[k-1] in any order. of[0].faces is not read. A face enters no
// later than its cofaces: of[k-1].value[face] <= of[k].value[i].
struct FilteredComplex {
    static constexpr std::uint32_t dimension_max = 31;
    struct Simplices {
        std::uint32_t count;         // < 2^31
        const std::uint32_t* faces;  // [count][k+1]
        const double* value;         // [count], non-decreasing, no NaN
    };
    std::uint32_t dimension;  // of[0..dimension] are read
    Simplices of[dimension_max + 1];

    // Edges of a complex that may have none.
    std::uint32_t edge_count() const { return dimension > 0 ? of[1].count : 0; }
};

}  // namespace netmesh
