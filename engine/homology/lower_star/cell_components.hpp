// Degree D-1 by duality: components of the superlevel sets of the closed sphere (triangulated_ball.hpp), as sets of
// cells that are joined at critical facets.
#pragma once
#include "homology/lower_star/star.hpp"
#include "homology/lower_star/star_cycles.hpp"
#include "homology/pair_writer.hpp"
#include "homology/union_find.hpp"

namespace netmesh {

template <int D> class CellComponents {
public:
    // above[vertex_count + 1]: for each vertex a higher vertex of its link or `outside`, itself if there is none;
    // becomes the union-find. cycles: null when none are wanted.
    CellComponents(const TriangulatedBall<D>& ball, Star<D>& star, std::uint32_t* above, PairWriter& writer,
                   StarCycles<D>* cycles)
        : ball_(ball), star_(star), above_(above), writer_(writer), cycles_(cycles) {}

    // Takes the critical facets of the star of v from the last to the first. One that joins two components is the
    // pivot of the younger one's creator and gets an owner in the star. out_of_memory, cancelled.
    Status unite_critical_facets(VertexId v);

private:
    std::uint32_t component_of(CellId cell, VertexId v);
    CellId cell_of(std::uint32_t facet, VertexId v) const;
    CellId cell_beyond(CellId cell, std::uint32_t facet, VertexId v) const;
    // The oldest of a component is `outside` or its vertex of the highest rank.
    std::uint32_t age_of(std::uint32_t root) const { return root == ball_.outside ? none : ball_.rank[root]; }

    const TriangulatedBall<D>& ball_;
    Star<D>& star_;
    std::uint32_t* above_;
    PairWriter& writer_;
    StarCycles<D>* cycles_;
};

// The component of a cell at a critical facet (`none`, or not in the part: outside), by following the gradient to a
// cell with an upper vertex, outside, or to a critical cell. A cell is critical only when no facet is free: then the
// lower cells around v have no boundary, so they are all cells of the star, one of them is critical, and v stands for
// its component.
template <int D> std::uint32_t CellComponents<D>::component_of(CellId cell, VertexId v) {
    while (cell != none && ball_.has(cell)) {
        const VertexId* p = ball_.complex.vertices(cell);
        std::uint32_t labels[DimensionOf<D>::most + 1] = {};
        std::uint32_t k = 0;
        for (std::uint32_t j = 0; j <= ball_.dim(); ++j) {
            if (ball_.rank[p[j]] > ball_.rank[v]) return find_root(above_, p[j]);
            if (p[j] != v) labels[k++] = ball_.slot[p[j]];
        }
        const std::uint32_t facet =
            star_.partner(star_.simplex_of_any_order(labels, ball_.dim()));  // the cell is in the star
        if (facet == none) return find_root(above_, v);
        cell = cell_beyond(cell, facet, v);
    }
    return ball_.outside;
}

// A cell at `facet` of the star.
template <int D> CellId CellComponents<D>::cell_of(std::uint32_t facet, VertexId v) const {
    CellId cell = star_.cell(facet);
    if (ball_.dim() == 2) {  // facets are edges, and of these the star notes the vertex, not a cell
        for (std::uint32_t t = ball_.begin[v + 1]; t-- > ball_.begin[v];) {
            const VertexId* const p = ball_.complex.vertices(ball_.incidence[t].cell());
            for (std::uint32_t j = 0; j <= ball_.dim(); ++j) {
                if (p[j] == star_.vertex(facet)) cell = ball_.incidence[t].cell();
            }
        }
    }
    return cell;
}

// The cell on the other side of `facet` of the star, `none` outside.
template <int D> CellId CellComponents<D>::cell_beyond(CellId cell, std::uint32_t facet, VertexId v) const {
    const VertexId* p = ball_.complex.vertices(cell);
    std::uint32_t opposite = 0;
    for (std::uint32_t j = 0; j <= ball_.dim(); ++j) {
        const std::uint32_t label = ball_.slot[p[j]];
        std::uint32_t i = facet;
        while (i != 0 && star_.label(i) != label) i = star_.parent(i);
        if (i == 0 && p[j] != v) opposite = j;
    }
    return ball_.complex.neighbour(cell, opposite);
}

template <int D> Status CellComponents<D>::unite_critical_facets(VertexId v) {
    for (std::uint32_t p = star_.count(); p-- > 0;) {
        const std::uint32_t i = star_.at(p);
        if (star_.partner(i) != none || star_.dimension(i) != ball_.dim() - 1) continue;
        CellId cell = cell_of(i, v);
        const CellId beyond = cell_beyond(cell, i, v);
        std::uint32_t a = component_of(beyond, v), b = component_of(cell, v);
        if (a == b) continue;
        if (age_of(a) < age_of(b)) {
            const std::uint32_t t = a;
            a = b;
            b = t;
            cell = beyond;
        }
        above_[b] = a;
        star_.owner(i) = 0;
        const double birth = ball_.value[v], death = ball_.value[b];
        std::uint32_t cycle = 0;
        if (cycles_ != nullptr && writer_.keeps(birth, death, ball_.dim() - 1)) {
            const Status status = cycles_->write_piece(cell, i, v, &cycle);
            if (status != Status::ok) return status;
        }
        if (!writer_.add(birth, death, ball_.dim() - 1, cycle)) return Status::out_of_memory;
    }
    return Status::ok;
}

}  // namespace netmesh
