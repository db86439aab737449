// Cells of a triangulation of points in the plane that is kept for one diagram: no circles, and words as short as the
// number of points allows.
#pragma once
#include <cstdint>

#include "vocabulary/ids.hpp"

namespace netmesh {

// 32 bits each.
struct WideWords {
    static constexpr bool are_short = false;
    using Vertex = VertexId;
    using Facet = FacetId;
    using Index = std::uint32_t;
};

// 16 bits each, of up to points_max points: with ghosts these have 2 points_max - 2 cells.
struct NarrowWords {
    static constexpr bool are_short = true;
    static constexpr std::uint32_t points_max = 8192;
    using Index = std::uint16_t;

    // The two highest numbers stay apart, as `none` and Store<2>::freed.
    class Vertex {
    public:
        Vertex() = default;
        constexpr Vertex(VertexId v) : word_(static_cast<Index>(v.index)) {}
        constexpr Vertex(None) : word_(0xFFFF) {}
        constexpr operator VertexId() const { return VertexId(static_cast<std::uint32_t>(*this)); }
        constexpr operator std::uint32_t() const { return word_ < 0xFFFE ? word_ : word_ | 0xFFFF0000u; }

    private:
        Index word_;
    };
    // 4 * cell + position.
    class Facet {
    public:
        Facet() = default;
        constexpr Facet(FacetId f) : word_(static_cast<Index>(f.cell().index << 2 | f.position())) {}
        constexpr Facet(None) : word_(0xFFFF) {}
        constexpr operator FacetId() const {
            return word_ == 0xFFFF ? FacetId(none) : FacetId(CellId(word_ >> 2), word_ & 3u);
        }
        constexpr CellId cell() const { return CellId(word_ >> 2); }

    private:
        Index word_;
    };
};

// The beginning of a Cell<2>, its vertices numbered in the order of insertion; hull facets have neighbour `none`.
template <class Words> struct PlaneCell {
    typename Words::Vertex vertex[3];
    typename Words::Facet neighbour[3];
};

// order: which vertex of the input each point is.
template <class Words> struct PlaneTriangulation {
    PlaneCell<Words>* cells;
    std::uint32_t cell_count;
    const double* points;  // [point_count][2]
    std::uint32_t point_count;
    const typename Words::Index* order;
};

}  // namespace netmesh
