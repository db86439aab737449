// Point location and insertion in a Delaunay triangulation with ghost cells.
#pragma once
#include <cstdint>

#include "delaunay/sphere.hpp"
#include "delaunay/store.hpp"

namespace netmesh {

// What an insertion would replace: cells in conflict with the new point, listed in the store's gap, and how many facets
// bound them.
struct Cavity {
    std::uint32_t cells;
    std::uint32_t facets;
    std::uint32_t stamp;  // mark of the cells in conflict; their neighbours outside carry stamp + 1
};

template <int D> class Kernel {
public:
    // error_max: a new ball whose error bound would exceed this (relative to its radius) is computed afresh. Conflicts are
    // decided exactly whatever it is; corners that results depend on want it small.
    Kernel(Store<D>& store, double error_max) : store_(store), error_max_(error_max) {}

    // Makes the D+1 points with these indices, affinely independent, the first cell with its ghosts. out_of_memory.
    Status start(const std::uint32_t* ids);

    // Does the open ball of cell c contain point q with index id, ties broken by index? A ghost is in conflict with what
    // lies strictly beyond its facet, or in the facet's plane and inside the ball of the cell behind it.
    bool in_conflict(std::uint32_t c, const double* q, std::uint32_t id);

    // A cell in conflict with q, found by descending powers from cell `from`; the powers of adjacent balls compare as q
    // lies to the sides of their common facet, so a local minimum contains q. Expected 2-7 steps from a near start.
    std::uint32_t locate(const double* q, std::uint32_t id, std::uint32_t from);

    // The cells in conflict with q, found from `first`, one of them. False when the gap is too small for the list;
    // nothing but marks has changed.
    bool find_cavity(const double* q, std::uint32_t id, std::uint32_t first, Cavity* cavity);
    std::uint32_t cavity_cell(std::uint32_t k) const { return store_.list_top()[-1 - static_cast<std::ptrdiff_t>(k)]; }
    // Is there room to fill this cavity (and for `vertices` new vertices)?
    bool can_fill(const Cavity& cavity, std::uint32_t vertices) {
        return store_.has_room(cavity.facets, vertices, (std::size_t{cavity.cells} + 2 * std::size_t{cavity.facets} + 8) * 4);
    }

    // Replaces the cavity by the star of vertex id. Needs can_fill. The new cells are then listed in the gap behind the
    // cavity's: new_cell(k), k < cavity.facets, until the next search.
    void fill(const Cavity& cavity, std::uint32_t id);
    std::uint32_t new_cell(const Cavity& cavity, std::uint32_t k) const { return cavity_cell(cavity.cells + 2 * k); }

    // Calls visit(cell) for each cell at vertex v, ghosts included; stops early, returning false, when the gap is too small.
    template <class Visit> bool visit_star(std::uint32_t v, Visit&& visit);

private:
    std::uint32_t walk(const double* q, std::uint32_t from);
    bool ghost_in_conflict(std::uint32_t c, int infinite, const double* q, std::uint32_t id);
    bool exact_conflict(std::uint32_t c, const double* q, std::uint32_t id);
    void make_sphere(Cell<D>& cell, const Cell<D>& inside, const Cell<D>& outside, const double* q);
    void link(std::uint32_t stamp, std::uint32_t made, std::uint32_t origin);

    Store<D>& store_;
    double error_max_;
};

template <int D> template <class Visit> bool Kernel<D>::visit_star(std::uint32_t v, Visit&& visit) {
    const std::uint32_t stamp = store_.new_stamp();
    const std::size_t capacity = store_.list_capacity();
    std::uint32_t* const list = store_.list_top();
    std::uint32_t count = 1;
    if (capacity < 1) return false;
    list[-1] = store_.vertex(v).cell;
    store_.cell(list[-1]).mark = stamp;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t c = list[-1 - static_cast<std::ptrdiff_t>(k)];
        const Cell<D>& cell = store_.cell(c);
        visit(c);
        for (int i = 0; i <= D; ++i) {
            if (cell.vertex[i] == v) continue;
            const std::uint32_t n = cell.neighbour[i] >> 3;
            if (store_.cell(n).mark == stamp) continue;
            if (count >= capacity) {
                store_.arena.refuse(4);
                return false;
            }
            store_.cell(n).mark = stamp;
            list[-1 - static_cast<std::ptrdiff_t>(count++)] = n;
        }
    }
    return true;
}

}  // namespace netmesh
