// How far the cell of a cage reaches.
#pragma once
#include "delaunay/cell_list.hpp"
#include "mesh/any_domain.hpp"
#include "mesh/cage.hpp"
#include "mesh/corner.hpp"

namespace netmesh {

// Calls visit(cell) for each cell on the cage's boundary, which are connected; there is one at any shell vertex. They
// are listed in the gap until the next search. Stops early, returning false, when the gap is too small.
template <int D, class Visit> bool visit_cage_boundary(Store<D>& store, const Cage& cage, Visit&& visit) {
    CellId first = none;
    const bool fits = visit_star(store, VertexId(cage.shell), [&](CellId c) {
        if (first == none && is_on_boundary<D>(store, cage, c)) first = c;
    });
    if (!fits) return false;
    if (first == none) return true;
    CellList<D> boundary(store);
    if (!boundary.add(first)) return false;
    for (std::uint32_t k = 0; k < boundary.size(); ++k) {
        const CellId c = boundary[k];
        visit(c);
        for (int i = 0; i <= D; ++i) {
            if (store.cell(c).neighbour[i] == none) continue;
            const CellId n = store.cell(c).neighbour[i].cell();
            if (is_on_boundary<D>(store, cage, n) && !boundary.add(n)) return false;
        }
    }
    return true;
}

// The cell of a cage is that of its vertices together, clipped to the ball of the domain around it. The farthest point
// from the cage's centre of those that are corners within the ball or on edges of the cell; *corner is left as it is
// when there is none. *leaves_ball: there is a corner outside of the ball, or one that is not known. False when the gap
// is too small for the search.
template <int D>
bool find_cage_corner(Store<D>& store, const Cage& cage, const Domain<D>& ball, Corner<D>* corner, bool* leaves_ball);

// Raises *out2, the squared distance from the cage's centre to which its clipped cell is known to reach, to that to
// which it does. boundary[-1 - k], k < count: the cells on its boundary, as visit_cage_boundary has listed them.
// O(count), and what find_cage_pole takes where a pole may be farther than anything else.
template <int D>
void raise_to_cage_cell(const Store<D>& store, const Cage& cage, const Domain<D>& ball, const CellId* boundary,
                        std::uint32_t count, double* out2);
void raise_to_cage_cell(const AnyStore& store, const Cage& cage, const AnyDomain& ball, const CellId* boundary,
                        std::uint32_t count, double* out2);

// Offers what of the clipped cell of a cage is neither a corner nor on an edge but farther from the cage's centre than
// the root of bound2 (clipped_cell.hpp). O(cells), and vertices for each pole of a face of the cage's cell beyond
// that.
template <int D>
void find_cage_pole(const Store<D>& store, const Cage& cage, const Domain<D>& ball, double bound2, Corner<D>* corner);
// The squared distance of that from the cage's centre; negative when there is none.
double distance2_of_cage_pole(const AnyStore& store, const Cage& cage, const AnyDomain& ball, double bound2);

}  // namespace netmesh
