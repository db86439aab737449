// Space's own way of filling a cavity: the new cells stand on the triangles of a sphere, so what borders what is read
// off the sphere's edges. A part of kernel.cpp; templates, so that nothing of it is made where space is not served.
#pragma once
#include "delaunay/kernel.hpp"

namespace netmesh {

#ifndef __OPTIMIZE_SIZE__

// A triangulated sphere of n vertices has 2 n - 4 triangles.
constexpr std::uint32_t boundary_vertices_max = 32;
constexpr std::uint32_t boundary_facets_max = 2 * boundary_vertices_max - 4;

// The vertices of a cavity's boundary with numbers from 1 on, in the order in which they are met. A hash table of many
// more slots than vertices. Whether a vertex is there already cannot be predicted; so there is no branch on it.
class BoundaryVertices {
public:
    void clear() {
        next_ = 1;
        for (std::uint8_t& number : number_) number = 0;
    }
    std::uint32_t number_of(VertexId v) {
        vertex_[next_] = v;
        std::uint32_t slot = v * 0x9E3779B1u >> (32 - slot_bits), number = number_in(slot);
        while (vertex_[number] != v) number = number_in(slot = (slot + 1) & (slots - 1));
        number_[slot] = static_cast<std::uint8_t>(number);
        next_ += number == next_;
        return number;
    }
    std::uint32_t count() const { return next_ - 1; }
    VertexId operator[](std::uint32_t number) const { return vertex_[number]; }

private:
    // Of a vacant slot the number that comes next.
    std::uint32_t number_in(std::uint32_t slot) const {
        const std::uint32_t number = number_[slot];
        return number | (next_ & (0u - static_cast<std::uint32_t>(number == 0)));
    }
    static constexpr int slot_bits = 8;
    static constexpr std::uint32_t slots = 1u << slot_bits;
    std::uint32_t next_;
    std::uint8_t number_[slots];  // 0: vacant
    VertexId vertex_[boundary_vertices_max + 2];
};

struct BoundaryTriangle {
    std::uint16_t edge[3];
    std::uint16_t position;
};

// They stand in the gap below the cavity's list, as the stack has no room for them (netmesh/job.h).
struct BoundaryTables {
    static constexpr std::uint32_t most = boundary_vertices_max + 1;
    BoundaryVertices vertices;
    BoundaryTriangle triangle[boundary_facets_max];
    std::uint8_t behind[most * most];  // 4 * triangle + position in its cell
};
static_assert(4 * boundary_facets_max < 256 && alignof(BoundaryTables) <= alignof(CavityLine));

// null: no room for them above what the new cells may take.
template <int D> BoundaryTables* boundary_tables(const Store<D>& store, const Cavity& cavity) {
    const std::size_t lines = (cavity.cells > cavity.facets ? cavity.cells : cavity.facets) + std::size_t{1};
    const std::size_t below = lines * sizeof(CavityLine) + sizeof(BoundaryTables);
    const Arena& arena = store.arena;
    if (below + cavity.facets * sizeof(Cell<D>) > arena.high_mark() - arena.low_mark()) return nullptr;
    return reinterpret_cast<BoundaryTables*>(arena.at(arena.high_mark() - below));
}

template <int D> [[gnu::noinline]] void solve_cell(const Store<D>& store, double error_max, Cell<D>& cell) {
    const double* p[D + 1];
    for (int i = 0; i <= D; ++i) p[i] = store.point(cell.vertex[i]);
    solve_sphere<D>(p, error_max, cell);
}

// Seen from the new point all triangles of the sphere turn the same way, so each edge is met once in either direction:
// what stands behind it is written down under one of them and read under the other.
template <int D>
bool SpatialCavity<D>::make_cells(Kernel<D>& kernel, const Cavity& cavity, VertexId id, CellSupply<D>& supply) {
    // turn[i]: the positions other than i, so that i and they are an even permutation.
    constexpr std::uint8_t turn[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};
    if (cavity.facets > boundary_facets_max) return false;
    Store<D>& store = kernel.store_;
    BoundaryTables* const tables = boundary_tables<D>(store, cavity);
    if (tables == nullptr) return false;
    Cell<D>* const cells = &store.cell(0);
    CavityLine* const end = kernel.list_end();
    const double* const q = store.point(id);
    const std::uint32_t facets = cavity.facets;
    BoundaryVertices& vertices = tables->vertices;
    BoundaryTriangle* const triangle = tables->triangle;
    std::uint8_t* const behind = tables->behind;
    constexpr std::uint32_t most = BoundaryTables::most;
    vertices.clear();
    for (std::uint32_t k = 0; k < facets; ++k) {
        CavityLine& line = end[-static_cast<std::ptrdiff_t>(k)];
        const CellId n = line.made = supply.take();
        const std::uint32_t i = line.facet.position();
        const Cell<D>& old = cells[line.facet.cell()];
        Cell<D>& fresh = cells[n];
        const FacetId outer = old.neighbour[i];
        const std::uint32_t number[3] = {vertices.number_of(old.vertex[turn[i][0]]),
                                         vertices.number_of(old.vertex[turn[i][1]]),
                                         vertices.number_of(old.vertex[turn[i][2]])};
        __builtin_memcpy(fresh.vertex, old.vertex, sizeof fresh.vertex);
        fresh.vertex[i] = id;
        fresh.neighbour[i] = outer;
        fresh.mark = 0;
        cells[outer.cell()].neighbour[outer.position()] = FacetId(n, i);
        triangle[k].position = static_cast<std::uint16_t>(i);
        for (std::uint32_t r = 0; r < 3; ++r) {
            const std::uint32_t from = number[(r + 1) % 3], to = number[(r + 2) % 3];
            triangle[k].edge[r] = static_cast<std::uint16_t>(to * most + from);
            behind[from * most + to] = static_cast<std::uint8_t>(4 * k + turn[i][r]);
        }
    }
    bool at_hull = false;
    for (std::uint32_t number = 1; number <= vertices.count(); ++number) {
        at_hull |= vertices[number] == none;
        if (vertices[number] != none) __builtin_prefetch(store.point(vertices[number]));
    }
    for (std::uint32_t k = 0; k < facets; ++k) {
        const CavityLine& line = end[-static_cast<std::ptrdiff_t>(k)];
        const std::uint32_t i = triangle[k].position;
        Cell<D>& fresh = cells[line.made];
        const Cell<D>& inside = cells[line.facet.cell()];
        const Cell<D>& outside = cells[fresh.neighbour[i].cell()];
        for (std::uint32_t r = 0; r < 3; ++r) {
            const std::uint32_t other = behind[triangle[k].edge[r]];
            fresh.neighbour[turn[i][r]] = FacetId(end[-static_cast<std::ptrdiff_t>(other / 4)].made, other % 4);
        }
        if (at_hull && store.is_ghost(line.made))
            make_ghost<D>(fresh);
        else if (!pencil_sphere<D>(inside, outside, q, kernel.error_max_, fresh))
            solve_cell<D>(store, kernel.error_max_, fresh);
    }
    return true;
}

#endif

}  // namespace netmesh
