// A list of distinct cells for searches that go from neighbour to neighbour.
#pragma once
#include <cstddef>
#include <cstdint>

#include "delaunay/store.hpp"

namespace netmesh {

// It stands in the store's gap and marks the cells that it holds. There is one at a time: the next list, and the
// kernel's next search, are written to the same place.
template <int D> class CellList {
public:
    [[gnu::always_inline]] explicit CellList(Store<D>& store)
        : store_(store), end_(store.list_top()), capacity_(store.list_capacity()), below_(store.arena.bytes_used()),
          stamp_(store.new_stamp()) {}
    ~CellList() { store_.arena.raise_peak(below_ + size_ * sizeof(CellId)); }
    CellList(const CellList&) = delete;
    CellList& operator=(const CellList&) = delete;

    // Lists c unless it is listed already. False when the gap has no room for it.
    bool add(CellId c) {
        Cell<D>& cell = store_.cell(c);
        if (cell.mark == stamp_) return true;
        if (size_ >= capacity_) {
            store_.arena.refuse(sizeof(CellId));
            return false;
        }
        cell.mark = stamp_;
        __builtin_prefetch(&cell);
        end_[-1 - static_cast<std::ptrdiff_t>(size_++)] = c;
        return true;
    }
    bool has(CellId c) const { return store_.cell(c).mark == stamp_; }
    std::uint32_t size() const { return size_; }
    CellId operator[](std::uint32_t k) const { return end_[-1 - static_cast<std::ptrdiff_t>(k)]; }

private:
    Store<D>& store_;
    CellId* const end_;
    const std::size_t capacity_, below_;  // what is used beside the list
    const std::uint32_t stamp_;
    std::uint32_t size_ = 0;
};

// The marks that the walk looks at when it comes to this cell's turn: by then they are in the cache.
template <int D> void ask_for_marks(const Store<D>& store, VertexId v, CellId c) {
    const Cell<D>& cell = store.cell(c);
    for (int i = 0; i <= D; ++i)
        if (cell.vertex[i] != v && cell.neighbour[i] != none)
            __builtin_prefetch(&store.cell(cell.neighbour[i].cell()).mark);
}

// Calls visit(cell) for each cell at vertex v, ghosts included, from Vertex::cell on. Stops early, returning false,
// when the gap is too small for the list of them. In a compact store v must not be on the hull.
template <int D, class Visit> bool visit_star(Store<D>& store, VertexId v, Visit&& visit) {
    CellList<D> star(store);
    if (!star.add(store.vertex(v).cell)) return false;
    for (std::uint32_t k = 0; k < star.size(); ++k) {
        const CellId c = star[k];
        const Cell<D>& cell = store.cell(c);
        if (k + 2 < star.size()) ask_for_marks(store, v, star[k + 2]);
        visit(c);
        for (int i = 0; i <= D; ++i)
            if (cell.vertex[i] != v && !star.add(cell.neighbour[i].cell())) return false;
    }
    return true;
}

}  // namespace netmesh
