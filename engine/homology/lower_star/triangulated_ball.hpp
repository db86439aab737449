// What every stage of a lower-star computation reads: the triangulated ball, the order of its vertices, and the cells
// around each vertex.
//
// The ball is thought of as closed to a sphere by a vertex `outside`, later than all others, which is joined to the
// hull. Every link is then a (D-1)-sphere, and by Alexander duality the part of it above a vertex knows the homology of
// the part below.
//
// When only a part K of the ball is filtered, with the homology of a point, it is thought of as standing in that same
// sphere. K_a are the simplices of K that have entered. By duality a class of degree D-1 of K_a is a component of the
// rest of the sphere, all open simplices that are not in K_a. The rest of the sphere beyond K itself, with `outside`,
// is in one piece, as K has no class of degree D-1; it is in the complement at all times, and what is joined to it is
// joined to `outside`. The open star of a vertex is connected, and as long as the vertex has not entered all of it is
// in the complement. So a cell that is not in K stands for `outside`, and so does a vertex with a simplex that is not
// in K, from the moment when it leaves. The link of such a vertex, as far as it is in K, has no dual in the link sphere
// that knows only which vertices are above; its star is opened in full. Stars that are in K with all of their simplices
// are what they would be without a part.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/subcomplex.hpp"
#include "complex/triangulation.hpp"
#include "memory/arena.hpp"
#include "memory/prefetch.hpp"

namespace netmesh {

// At least as many simplices as a lower star has whose vertex has `lower` lower neighbours and whose link sphere has
// with_lower[k] cells with k lower vertices: a face of n vertices is in at least D+1-n cells of the sphere.
template <int D>
std::uint64_t simplices_bound(DimensionOf<D> dim, std::uint32_t lower, const std::uint32_t* with_lower) {
    std::uint64_t bound = 1 + std::uint64_t{lower};
    for (std::uint32_t n = 2; n <= dim; ++n) {
        std::uint64_t occurrences = 0;
        for (std::uint32_t k = n; k <= dim; ++k) {
            std::uint64_t choose = 1;
            for (std::uint32_t i = 0; i < n; ++i) choose = choose * (k - i) / (i + 1);
            occurrences += choose * with_lower[k];
        }
        bound += occurrences / (dim + 1 - n);
    }
    return bound;
}

template <int D> struct TriangulatedBall {
    static constexpr std::uint8_t on_hull = 1, irregular = 2, large = 4, cut = 8, absent = 16;

    TriangulationView<D> complex;
    const double* value;        // [vertex_count]
    const Subcomplex<D>* part;  // null: everything is in
    std::uint32_t vertex_count;
    std::uint32_t outside;     // == vertex_count
    std::uint32_t degree_max;  // most cells around a vertex
    std::uint32_t* order;      // [vertex_count] vertices by rank
    std::uint32_t* rank;       // [vertex_count]
    std::uint32_t* begin;      // [vertex_count + 1] into incidence
    FacetId* incidence;        // [(dim+1) * cells] by vertex: a cell and the position of the vertex in it
    std::uint8_t* flags;       // [vertex_count]
    std::uint32_t* slot;       // [vertex_count] labels in the star at work; all 0 between stars

    DimensionOf<D> dim() const { return complex.dim; }
    // Whether the cell is in the part.
    bool has(CellId cell) const { return part == nullptr || part->cell[cell] != 0; }
    // Asks for the vertices of the cell of incidence t, or of the last one.
    void prefetch(std::uint32_t t) const {
        const std::uint32_t last = begin[vertex_count] - 1;
        netmesh::prefetch(complex.vertices(incidence[t < last ? t : last].cell()));
    }
    // Lists the incidences; the arrays taken stay at the arena's high end. False: out of memory.
    bool list_incidences(Arena& arena) {
        const std::size_t n = vertex_count;
        const std::size_t m = std::size_t{complex.cell_count} * (dim() + 1);
        begin = arena.take_high<std::uint32_t>(n + 1);
        incidence = arena.take_high<FacetId>(m);
        flags = arena.take_high<std::uint8_t>(n);
        slot = arena.take_high<std::uint32_t>(n);
        if (begin == nullptr || incidence == nullptr || flags == nullptr || slot == nullptr || m >= none) return false;
        for (std::size_t v = 0; v < n;)
            for (const std::uint64_t piece = arena.piece(v, n, 5); v < piece; ++v) {
                begin[v] = flags[v] = 0, slot[v] = 0;
            }
        if (part != nullptr) flag_part(arena);
        NETMESH_VALIDATE_WHOLE(part_violation());
        begin[n] = 0;
        for (CellId c(0); c < complex.cell_count;)
            for (const std::uint64_t piece = arena.piece(c, complex.cell_count, 5 * (dim() + 1)); c < piece; ++c) {
                const VertexId* p = complex.vertices(c);
                for (std::uint32_t i = 0; i <= dim(); ++i) ++begin[p[i] + 1];
            }
        degree_max = 0;
        std::uint32_t sum = 0;
        for (std::size_t v = 1; v <= n; ++v) {
            arena.step(v, 6);
            const std::uint32_t count = begin[v];
            if (count > degree_max) degree_max = count;
            begin[v] = sum;  // moves to the end of v-1's list while that is filled
            sum += count;
        }
        for (CellId c(0); c < complex.cell_count;)
            for (const std::uint64_t piece = arena.piece(c, complex.cell_count, 12 * (dim() + 1)); c < piece; ++c) {
                place(c);
            }
        return true;
    }

#ifdef NETMESH_VALIDATE
    // Whether no cell that is in has an absent vertex, and none that is not in has one that is whole.
    const char* part_violation() const {
        for (CellId c(0); part != nullptr && c < complex.cell_count; ++c) {
            for (std::uint32_t i = 0; i <= dim(); ++i) {
                const std::uint8_t vertex = part->vertex[complex.vertices(c)[i]];
                if (vertex > VertexPart::whole) return "a vertex is neither absent, cut nor whole";
                if (vertex == (has(c) ? VertexPart::absent : VertexPart::whole))
                    return "a part has a cell without one of its vertices, or not all cells of a whole vertex";
            }
        }
        return nullptr;
    }
#endif

private:
    void flag_part(const Arena& arena) {
        for (std::size_t v = 0; v < vertex_count;)
            for (const std::uint64_t piece = arena.piece(v, vertex_count, 8); v < piece; ++v) {
                if (part->vertex[v] == VertexPart::cut) flags[v] = cut;
                if (part->vertex[v] == VertexPart::absent) flags[v] = absent;
            }
    }
    void place(CellId c) {
        const VertexId* p = complex.vertices(c);
        for (std::uint32_t i = 0; i <= dim(); ++i) {
            incidence[begin[p[i] + 1]++] = FacetId(c, i);
            if (complex.facet_beyond(c, i) != none) continue;
            for (std::uint32_t j = 0; j <= dim(); ++j) {
                if (j != i) flags[p[j]] |= on_hull;
            }
        }
    }
};

}  // namespace netmesh
