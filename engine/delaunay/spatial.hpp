// Space's own way of finding and filling a cavity. The powers that the search computes are those that make the new
// balls, so they are kept; and the new cells stand on the triangles of a sphere, so what borders what is read off the
// sphere's edges. A part of kernel.cpp; templates, so that nothing of it is made where space is not served.
#pragma once
#include "delaunay/kernel.hpp"
#include "delaunay/pencils.hpp"

namespace netmesh {

#ifndef __OPTIMIZE_SIZE__

// They stand in the gap below the first lines of the cavity's list, as the stack has no room for them (netmesh/job.h),
// and serve cavities whose list ends above them.
struct SpatialTables {
    static constexpr std::uint32_t lines_max = 64;
    static constexpr int slot_bits = 7;
    static constexpr std::uint32_t slots = 1u << slot_bits;  // a sphere of 64 triangles has 34 vertices
    static constexpr VertexId vacant{none - 1};

    // What power() has said of each cell in conflict.
    double power[lines_max], bound[lines_max];
    std::uint8_t inside[lines_max];  // of each bounding facet: the line of its cell in conflict
    // Of each bounding facet: the balls inside and beyond it.
    Pencils<3, lines_max> pencils;

    std::uint8_t unsolved[lines_max];  // lines of new cells whose ball is not made of others
    struct {
        std::uint16_t edge[3];
        std::uint16_t position;
    } triangle[lines_max];
    std::uint8_t behind[slots * slots];  // 4 * triangle + position in its cell
    static_assert(4 * lines_max <= 256);
    VertexId vertex[slots];  // a hash table; a vertex's slot is its number

    void forget_vertices() {
        for (VertexId& v : vertex) v = vacant;
    }
    // Whether a vertex is there already cannot be predicted; so there is no branch on it: a product is 0 either way.
    std::uint32_t number_of(VertexId v) {
        std::uint32_t slot = v * 0x9E3779B1u >> (32 - slot_bits);
        while (!is_for(slot, v)) slot = (slot + 1) & (slots - 1);
        vertex[slot] = v;
        return slot;
    }

private:
    bool is_for(std::uint32_t slot, VertexId v) const {
        const std::uint64_t other = vertex[slot] ^ v, taken = vertex[slot] ^ vacant;
        return other * taken == 0;
    }
};

// Where they stand; null: the gap is too small, were `cells` cells made.
template <int D> SpatialTables* spatial_tables(const Store<D>& store, std::uint32_t cells) {
    static_assert(alignof(SpatialTables) <= 8 && sizeof(CavityLine) * SpatialTables::lines_max % 8 == 0);
    constexpr std::size_t below = SpatialTables::lines_max * sizeof(CavityLine) + sizeof(SpatialTables);
    const Arena& arena = store.arena;
    if (below + cells * sizeof(Cell<D>) > arena.high_mark() - arena.low_mark()) return nullptr;
    return reinterpret_cast<SpatialTables*>(arena.at(arena.high_mark() - below));
}

// As in kernel.cpp, but without branches, as guesses at what is in conflict cost more than asking cells again that are
// known: every cell is asked, and lines are overwritten when they were not meant. The cell that the search came from
// need not be looked at.
template <int D, class W>
void SpatialCavity<D, W>::search(Kernel<D, W>& kernel, const double* point, VertexId id, CavitySearch* progress) {
    Store<D>& store = kernel.store_;
    SpatialTables* const tables = spatial_tables<D>(store, 0);
    if (tables == nullptr) return;
    Cell<D>* const cells = &store.cell(0);
    CavityLine* const end = kernel.list_end();
    const std::uint32_t stamp = progress->stamp;
    double q[D];
    for (int i = 0; i < D; ++i) q[i] = point[i];
    const AskedPoint<W> asked = kernel;
    const auto power_at = [&q, &asked](const Cell<D>& cell, double* bound) {
        if constexpr (W::has)
            return power<D>(cell, q, asked.height, bound);
        else
            return power<D>(cell, q, bound);
    };
    std::uint64_t decided = 0;
    std::ptrdiff_t count = 1, facets = 0, k = 0;
    tables->power[0] = power_at(cells[end[0].entry.cell()], &tables->bound[0]);
    for (; k < count; ++k) {
        if ((count > facets ? count : facets) + D + 1 > std::ptrdiff_t{SpatialTables::lines_max}) break;
        const CellId c = end[-k].entry.cell();
        const std::uint32_t entry = k == 0 ? D + 1 : end[-k].entry.position(), others = k == 0 ? D + 1 : D;
        ask_for_neighbours<D>(cells, cells[end[-(k + 1 < count ? k + 1 : k)].entry.cell()]);
        for (std::uint32_t j = 0; j < others; ++j) {
            const std::uint32_t i = j + (j >= entry);
            const FacetId facet = cells[c].neighbour[i];
            Cell<D>& other = cells[facet.cell()];
            const std::uint32_t known = other.mark - stamp;  // 0: in conflict, 1: not, else not met yet
            const std::uint32_t fresh = known > 1;
            double bound;
            const double value = power_at(other, &bound);
            std::uint32_t inside = value < 0;
            decided += fresh;
            if (__builtin_expect(fresh & static_cast<std::uint32_t>(!(__builtin_fabs(value) > bound)), 0)) {
                inside = kernel.undecided_conflict(facet.cell(), point, id);
                --decided;
            }
            inside = (inside & fresh) | static_cast<std::uint32_t>(known == 0);
            other.mark = stamp + 1 - inside;
            end[-count].entry = facet;
            tables->power[count] = value;
            tables->bound[count] = bound;
            count += inside & fresh;
            end[-facets].facet = FacetId(c, i);
            tables->pencils.out.power[facets] = value;
            tables->pencils.out.bound[facets] = bound;
            tables->inside[facets] = static_cast<std::uint8_t>(k);
            facets += 1 - inside;
        }
    }
    store.state.in_ball_counts.calls[0] += decided;
    progress->cells = count;
    progress->facets = facets;
    progress->searched = k;
}

// Seen from the new point all triangles of the sphere turn the same way, so each edge is met once in either direction:
// what stands behind it is written down under one of them and read under the other.
template <int D, class W>
bool SpatialCavity<D, W>::make_cells(Kernel<D, W>& kernel, const Cavity& cavity, VertexId id, CellSupply<D>& supply) {
    // turn[i]: the positions other than i, so that i and they are an even permutation.
    static constexpr std::uint8_t turn[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};
    if (!cavity.has_tables) return false;
    Store<D>& store = kernel.store_;
    SpatialTables* const tables = spatial_tables<D>(store, cavity.facets);
    if (tables == nullptr) return false;
    Cell<D>* const cells = &store.cell(0);
    CavityLine* const end = kernel.list_end();
    const double error_max = kernel.error_max_, error2_max = error_max * error_max;
    const std::uint32_t facets = cavity.facets;
    tables->forget_vertices();
    for (std::uint32_t k = 0; k < facets; ++k) {
        CavityLine& line = end[-static_cast<std::ptrdiff_t>(k)];
        const CellId n = line.made = supply.take();
        const std::uint32_t i = line.facet.position();
        const Cell<D>& old = cells[line.facet.cell()];
        Cell<D>& fresh = cells[n];
        const FacetId outer = old.neighbour[i];
        const std::uint32_t number[3] = {tables->number_of(old.vertex[turn[i][0]]),
                                         tables->number_of(old.vertex[turn[i][1]]),
                                         tables->number_of(old.vertex[turn[i][2]])};
        __builtin_memcpy(fresh.vertex, old.vertex, sizeof fresh.vertex);
        fresh.vertex[i] = id;
        fresh.neighbour[i] = outer;
        fresh.mark = 0;
        Cell<D>& beyond = cells[outer.cell()];
        beyond.neighbour[outer.position()] = FacetId(n, i);
        tables->pencils.in.put(old, k);
        tables->pencils.out.put(beyond, k);
        tables->pencils.in.power[k] = tables->power[tables->inside[k]];
        tables->pencils.in.bound[k] = tables->bound[tables->inside[k]];
        tables->triangle[k].position = static_cast<std::uint16_t>(i);
        for (std::uint32_t r = 0; r < 3; ++r) {
            const std::uint32_t from = number[(r + 1) % 3], to = number[(r + 2) % 3];
            tables->triangle[k].edge[r] = static_cast<std::uint16_t>(to * SpatialTables::slots + from);
            tables->behind[from * SpatialTables::slots + to] = static_cast<std::uint8_t>(4 * k + turn[i][r]);
        }
    }
    if constexpr (W::has)
        tables->pencils.template mix<true>(store.point(id), facets, kernel.height);
    else
        tables->pencils.mix(store.point(id), facets);
    std::uint32_t unsolved = 0;
    for (std::uint32_t k = 0; k < facets; ++k) {
        const CavityLine& line = end[-static_cast<std::ptrdiff_t>(k)];
        const std::uint32_t i = tables->triangle[k].position;
        Cell<D>& fresh = cells[line.made];
        for (std::uint32_t r = 0; r < 3; ++r) {
            const std::uint32_t other = tables->behind[tables->triangle[k].edge[r]];
            fresh.neighbour[turn[i][r]] = FacetId(end[-static_cast<std::ptrdiff_t>(other / 4)].made, other % 4);
        }
        const bool solved = tables->pencils.get(k, error2_max, fresh);
        tables->unsolved[unsolved] = static_cast<std::uint8_t>(k);
        unsolved += 1 - solved;
    }
    for (std::uint32_t j = 0; j < unsolved; ++j)
        for (const VertexId v : cells[end[-std::ptrdiff_t{tables->unsolved[j]}].made].vertex)
            if (v != none) __builtin_prefetch(store.point(v));
    // Ghosts are among them, as both balls of a ghost's pencil are unknown.
    for (std::uint32_t j = 0; j < unsolved; ++j) {
        const CellId n = end[-std::ptrdiff_t{tables->unsolved[j]}].made;
        if (store.is_ghost(n))
            make_ghost<D>(cells[n]);
        else
            solve_cell<D>(store, kernel.weights_used(), error_max, cells[n]);
    }
    return true;
}

#endif

}  // namespace netmesh
