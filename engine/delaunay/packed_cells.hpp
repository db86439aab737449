// The cells of a compact store without their balls, for the time of a job that only needs to know how they hang
// together: what balls take joins the gap, and cells are read in half of the memory.
#pragma once
#include <cstddef>

#include "complex/triangulation.hpp"
#include "delaunay/any_kernel.hpp"

namespace netmesh {

// Requires balls that are those of recompute_balls, as all finished and loaded meshes have them: so they need not be
// kept, and are found anew, to the bit. Marks are 0 then. In between only view() may be used of the cells.
//
//   low end: cells | from `behind` on: tables   gap  -->  low end: packed cells | tables         gap
//
// Tables move by a multiple of Arena::alignment. Nothing is packed when something else stands between cells and tables.
// O(cells).
class PackedCells {
public:
    PackedCells(const AnyStore& store, std::size_t behind)
        : store_(store), cell_bytes_(AnyStore::cell_bytes(store.dim)),
          packed_bytes_((static_cast<std::size_t>(store.dim) + 1) * (sizeof(VertexId) + sizeof(FacetId))),
          behind_(behind) {
        const std::size_t count = store.state.cell_slots;
        Arena& arena = store.arena;
        if (arena.offset_of(store.first_cell()) + count * cell_bytes_ != behind) return;
        arena.each(count, 20, [this](std::uint64_t c) { __builtin_memmove(packed(c), whole(c), packed_bytes_); });
        given_ = (cell_bytes_ - packed_bytes_) * count / Arena::alignment * Arena::alignment;
        move_bytes(arena.at(behind - given_), arena.at(behind), arena.low_mark() - behind, arena);
        arena.release_low(arena.low_mark() - given_);
    }
    PackedCells(const PackedCells&) = delete;
    PackedCells& operator=(const PackedCells&) = delete;

    TriangulationView<any_dimension> view() const {
        TriangulationView<any_dimension> view = store_.view();
        if (given_ > 0) view.stride_bytes = packed_bytes_;
        return view;
    }
    // Where an item of a table stands while cells are packed, and after that.
    template <class T> T* packed_place(T* item) const {
        return reinterpret_cast<T*>(store_.arena.at(store_.arena.offset_of(item) - given_));
    }
    template <class T> T* place(T* item) const {
        return reinterpret_cast<T*>(store_.arena.at(store_.arena.offset_of(item) + given_));
    }

    // Cells are as before, and so is what stands behind them, with what was taken at the low end in between. False: the
    // gap is too small for that, and nothing is kept behind the cells. Comes last, once.
    bool unpack() {
        if (given_ == 0) return true;
        Arena& arena = store_.arena;
        const std::size_t packed_end = behind_ - given_, tables = arena.low_mark() - packed_end;
        const bool fits = arena.extend_low(given_);
        if (fits)
            move_bytes(arena.at(behind_), arena.at(packed_end), tables, arena);
        else
            arena.release_low(behind_);
        const std::uint64_t count = store_.state.cell_slots;
        arena.each(count, 20, [this, count](std::uint64_t k) {
            const std::uint64_t c = count - 1 - k;
            __builtin_memmove(whole(c), packed(c), packed_bytes_);
            __builtin_memset(whole(c) + packed_bytes_, 0, cell_bytes_ - packed_bytes_);
        });
        recompute_balls(store_);
        return fits;
    }

private:
    unsigned char* at(std::uint64_t bytes) const { return store_.arena.at(store_.state.cells_offset) + bytes; }
    unsigned char* whole(std::uint64_t c) const { return at(c * cell_bytes_); }
    unsigned char* packed(std::uint64_t c) const { return at(c * packed_bytes_); }

    const AnyStore store_;
    const std::size_t cell_bytes_, packed_bytes_;
    std::size_t behind_, given_ = 0;  // given_: to the gap
};

}  // namespace netmesh
