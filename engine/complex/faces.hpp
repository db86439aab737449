// Every face of a triangulated D-ball, once, with its boundary. No coordinates.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/triangulation.hpp"
#include "memory/prefetch.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Whether the vertex lists of faces along an order ascend in that; otherwise they ascend by number, as all others do.
template <int D> constexpr bool lists_follow_order = jumps_matter&& D <= 4;

// The faces of dimension 0..dimension_max, those of one dimension numbered densely. First, last and greatest mean the
// order in which vertex lists ascend.
template <int D> struct Faces {
    int dimension_max;
    std::uint32_t count[DimensionOf<D>::most + 1];  // by dimension; 0 above dimension_max
    // [count[k]], the greatest vertex of each k-face. Where lists follow an order only last_vertex[0] is not null: the
    // others are found by facets.
    std::uint32_t* last_vertex[DimensionOf<D>::most + 1];
    std::uint32_t* facets[DimensionOf<D>::most +
                          1];  // k >= 1: [count[k]][k+1], entry i is the (k-1)-face opposite the i-th vertex

    const std::uint32_t* facets_of(int k, std::uint32_t face) const {
        return facets[k] + static_cast<std::size_t>(face) * static_cast<std::size_t>(k + 1);
    }
    bool follows_order() const { return jumps_matter && last_vertex[1] == nullptr; }
    // The greatest vertex of a face.
    std::uint32_t last_of(int k, std::uint32_t face) const {
        if (follows_order())
            for (; k > 0; --k) face = facets_of(k, face)[0];
        return last_vertex[k][face];
    }
    // The k+1 vertices of a face, ascending.
    void vertices(int k, std::uint32_t face, std::uint32_t* out) const {
        for (; k > 0; --k) {
            out[k] = last_of(k, face);
            face = facets_of(k, face)[k];
        }
        out[0] = last_vertex[0][face];
    }
    // The same of E dimensions or of any number; dimension_max stays.
    template <int E> Faces<E> of_dimension() const {
        Faces<E> faces = {};
        faces.dimension_max = dimension_max;
        for (int k = 0; k <= dimension_max; ++k) {
            faces.count[k] = count[k];
            faces.last_vertex[k] = last_vertex[k];
            faces.facets[k] = facets[k];
        }
        return faces;
    }
};

using AnyFaces = Faces<any_dimension>;

// Lists the faces of dimension 0..dimension_max (0 <= dimension_max <= D) of a triangulation whose neighbour words are
// not read. Vertices that are in no cell are no faces. `facets` is left at the low end of the arena, ascending in k;
// `last_vertex` at the high end, so that it can be released alone, in the order of k. Nothing else stays.
// Vertex lists ascend by number, and so do faces by their lists: numbers depend on the set of cells alone, not on the
// order in which cells are stored.
// Cost: O(sum over cells of 2^(D+1)) and a few words a simplex of scratch: one word per vertex of a cell while stars
// are walked, about two words a face while boundaries are made.
// out_of_memory, cancelled: the arena is as before and *out is not written. A dimension with 2^32 - 1 faces or more
// counts as out_of_memory.
template <int D>
Status enumerate_faces(const TriangulationView<D>& complex, int dimension_max, const Work& work, Faces<D>* out);

// What is known of the numbers of faces before they are made. hull_facets: how many facets have one cell. is_ball: not
// where cells are some of a triangulation; up to D = 3. whole_stars: of vertices below, all cells are there.
struct FaceCounting {
    FaceCounting(std::uint64_t facets, bool ball = true, std::uint32_t whole = 0)  // NOLINT: of balls
        : hull_facets(facets), is_ball(ball), whole_stars(whole) {}
    std::uint64_t hull_facets;
    bool is_ball;
    std::uint32_t whole_stars;
};

// All faces, numbered so that those of vertices that are near in `order` mostly have near numbers and less jumps about
// in memory; see lists_follow_order. A 0-face is not its vertex: last_vertex[0] says which one it is, and is `order`.
// Built for small size: as above.
// counting: read only where lists follow the order.
// order: [vertex_count] all vertices, the last piece at the arena's high end, where it is taken over; without
// Status::ok it stays. drops_complex: the cells are the last piece at the arena's low end; they are given back once
// they are read, in any case. Cost: as above; in D = 2, 3 and 4 a lookup for each face of each cell, and a word per
// vertex of a cell, per cell and per face of up to D - 2 dimensions of scratch. As above, and internal: it is not the
// triangulation of a ball.
template <int D>
Status enumerate_faces_along(const TriangulationView<D>& complex, const FaceCounting& counting, std::uint32_t* order,
                             bool drops_complex, const Work& work, Faces<D>* out);

// Facets on the hull, by the neighbours of the cells; 0 where lists do not follow an order and nobody asks. O(cells).
template <int D> std::uint64_t count_hull_facets(const TriangulationView<D>& complex, const Arena& arena) {
    std::uint64_t count = 0;
    if constexpr (lists_follow_order<D>)
        arena.each(complex.cell_count, 2 * (D + 1), [&](std::uint64_t c) {
            for (std::uint32_t i = 0; i <= D; ++i)
                count += complex.facet_beyond(CellId(static_cast<std::uint32_t>(c)), i) == none ? 1 : 0;
        });
    return count;
}

}  // namespace netmesh
