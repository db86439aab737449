// Identifiers of vertices, cells and facets. A vertex or cell id converts to its index, so that it can be compared and
// used as a subscript. Nothing but `none` converts to an id by itself, so a cell is never taken for a vertex.
#pragma once
#include <cstdint>

#include "vocabulary/validate.hpp"

namespace netmesh {

// No vertex, no cell, no facet, no index. As an index it is 0xFFFFFFFF.
struct None {
    constexpr operator std::uint32_t() const { return 0xFFFFFFFFu; }
};
constexpr None none{};

template <class Kind> struct Id {
    std::uint32_t index;

    Id() = default;
    constexpr explicit Id(std::uint32_t i) : index(i) {}
    constexpr Id(None) : index(none) {}
    constexpr operator std::uint32_t() const { return index; }
    constexpr Id& operator++() {
        ++index;
        return *this;
    }
};
using VertexId = Id<struct VertexKind>;
using CellId = Id<struct CellKind>;

// A facet of a cell: the cell, and the position in it of the vertex opposite the facet. Only this class knows how both
// fit into one word: 8 * cell + position. That is why there are at most cells_max cells.
class FacetId {
public:
    static constexpr std::uint32_t cells_max = 0x1FFFFFFFu;

    FacetId() = default;
    constexpr FacetId(CellId cell, std::uint32_t position) : word_(cell.index << 3 | position) {
        NETMESH_ASSERT(position < 8 && cell.index <= cells_max);
    }
    constexpr FacetId(None) : word_(none) {}
    constexpr CellId cell() const { return CellId(word_ >> 3); }
    constexpr std::uint32_t position() const { return word_ & 7u; }
    friend constexpr bool operator==(FacetId a, FacetId b) { return a.word_ == b.word_; }
    friend constexpr bool operator!=(FacetId a, FacetId b) { return a.word_ != b.word_; }

    // For sorting facets as plain numbers and for what else is kept in place of a facet.
    constexpr std::uint32_t word() const { return word_; }
    static constexpr FacetId from_word(std::uint32_t word) {
        FacetId facet = none;
        facet.word_ = word;
        return facet;
    }

private:
    std::uint32_t word_;
};

static_assert(sizeof(VertexId) == 4 && sizeof(CellId) == 4 && sizeof(FacetId) == 4, "records in the block hold them");

}  // namespace netmesh
