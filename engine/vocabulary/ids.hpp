// Identifiers of vertices, cells and facets. A vertex or cell id converts to its index, so that it can be compared and
// used as a subscript. Nothing converts to an id by itself, so a cell is never taken for a vertex.
#pragma once
#include <cstdint>

namespace netmesh {

constexpr std::uint32_t none = 0xFFFFFFFFu;  // no vertex, no cell, no facet, no index

struct VertexId {
    std::uint32_t index;
    VertexId() = default;
    constexpr explicit VertexId(std::uint32_t i) : index(i) {}
    constexpr operator std::uint32_t() const { return index; }
};

struct CellId {
    std::uint32_t index;
    CellId() = default;
    constexpr explicit CellId(std::uint32_t i) : index(i) {}
    constexpr operator std::uint32_t() const { return index; }
};

// A facet of a cell: the cell, and the position in it of the vertex opposite the facet. Only this class knows how both fit
// into one word: 8 * cell + position. That is why there are at most cells_max cells.
class FacetId {
public:
    static constexpr std::uint32_t cells_max = 0x1FFFFFFFu;

    FacetId() = default;
    constexpr FacetId(std::uint32_t cell, std::uint32_t position) : word_(cell << 3 | position) {}
    static constexpr FacetId absent() { return from_word(none); }
    static constexpr FacetId from_word(std::uint32_t word) {
        FacetId f(0, 0);
        f.word_ = word;
        return f;
    }
    constexpr CellId cell() const { return CellId(word_ >> 3); }
    constexpr std::uint32_t position() const { return word_ & 7u; }
    constexpr bool is_absent() const { return word_ == none; }
    constexpr std::uint32_t word() const { return word_; }

private:
    std::uint32_t word_;
};

static_assert(sizeof(VertexId) == 4 && sizeof(CellId) == 4 && sizeof(FacetId) == 4, "records in the block hold them");

}  // namespace netmesh
