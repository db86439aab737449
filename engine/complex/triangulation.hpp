// A triangulated D-ball as topology sees it: cells with their vertices and neighbours, no coordinates.
#pragma once
#include <cstddef>
#include <cstdint>

#include "vocabulary/status.hpp"

namespace netmesh {

// Record c starts at cells + c * stride_bytes: D+1 vertex indices, then D+1 neighbour words (both uint32). Neighbour
// word i belongs to the facet opposite vertex i: `none` on the hull, otherwise 8 * cell + j, where j is the position in
// that cell of the vertex opposite the shared facet.
template <int D> struct TriangulationView {
    const unsigned char* cells;
    std::size_t stride_bytes;
    std::uint32_t cell_count;
    std::uint32_t vertex_count;

    const std::uint32_t* vertices(std::uint32_t cell) const {
        return reinterpret_cast<const std::uint32_t*>(cells + cell * stride_bytes);
    }
    const std::uint32_t* neighbour_words(std::uint32_t cell) const { return vertices(cell) + (D + 1); }
    std::uint32_t neighbour(std::uint32_t cell, int i) const {
        const std::uint32_t w = neighbour_words(cell)[i];
        return w == none ? none : w >> 3;
    }
    // Position, in neighbour(cell, i), of the vertex that is not in `cell`.
    int mirror(std::uint32_t cell, int i) const { return static_cast<int>(neighbour_words(cell)[i] & 7u); }
};

}  // namespace netmesh
