// Cells and vertices of a Delaunay triangulation inside the arena.
//
//   low end: cells 0, 1, 2, ...  -->     gap     <--  ..., 2, 1, 0 :vertices, high end
//
// Both grow into the same gap, so neither has a limit of its own. While a point is inserted the list of its conflicting
// cells stands in the gap too, below the last vertex.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/triangulation.hpp"
#include "memory/arena.hpp"
#include "numerics/real.hpp"
#include "predicates/predicates.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// A cell is positively oriented. Where the point at infinity takes the place of a vertex (`none`), it is a ghost: the
// outer side of the hull facet formed by its other vertices, oriented as if infinity were a point beyond that facet.
template <int D> struct Cell {
    VertexId vertex[D + 1];
    FacetId neighbour[D + 1];  // the same facet as seen from the neighbour; `none` on the hull of a compact store
    double centre[D];          // of the circumscribed ball, approximately; ghosts: unspecified
    double radius2;            // squared distance of `centre` to a vertex; ghosts: +infinity
    float error;               // |centre - true centre| <= error * radius; +infinity when unknown
    std::uint32_t mark;        // stamp of the last search that met the cell
};

enum class Marker : std::uint8_t { input = 0, steiner = 1, exempt = 2 };

template <int D> struct Vertex {
    double x[D];
    double nearest2;       // squared distance to the nearest other vertex (meshes)
    CellId cell;           // a cell at this vertex, `none` before its insertion
    VertexId next;         // link of the list that the vertex is in (meshes)
    std::uint32_t origin;  // input: its row in the caller's array; otherwise the nearest input vertex
    Marker marker;
    std::uint8_t queued;
    std::uint16_t size_hint;  // 0, or the squared out-radius asked for (meshes)
};

// The part of a triangulation that outlives a call: offsets and counts, no addresses.
struct StoreState {
    std::uint64_t cells_offset;  // of cell 0 in the block
    std::uint64_t vertices_end;  // offset just past vertex 0
    std::uint32_t cell_slots;    // cells ever made: live and free ones
    std::uint32_t cells_free;
    CellId free_head;  // last freed slot, linked by the words of neighbour[0]
    std::uint32_t vertex_count;
    std::uint32_t stamp;
    CellId last_cell;  // where the next search starts
    std::uint64_t cells_created;
    PredicateCounts in_ball_counts, orient_counts;
};

// What Store<D> does for every D.
struct StoreNeeds {
    std::uint32_t cells;
    std::size_t cell_bytes, other_bytes;
};
bool has_room_for(Arena& arena, const StoreState& state, const StoreNeeds& needs);
Status open_vertices_of(Arena& arena, StoreState& state, std::uint32_t vertex_count, std::size_t vertex_bytes);
Status open_cells_of(Arena& arena, StoreState& state);

template <int D> class Store {
public:
    using CellT = Cell<D>;
    using VertexT = Vertex<D>;
    static constexpr int dim = D;
    static constexpr std::uint32_t slots_max = FacetId::cells_max;
    static constexpr VertexId freed{none - 1};  // vertex[0] of a free slot

    Store(Arena& arena, StoreState& state) : arena(arena), state(state) { locate_arrays(); }

    // To be called where others have opened or compacted the store: its state says where arrays are.
    void locate_arrays() {
        cells_ = reinterpret_cast<CellT*>(arena.at(state.cells_offset));
        vertices_end_ = reinterpret_cast<VertexT*>(arena.at(state.vertices_end));
    }
    // Starts an empty store with vertex_count uninitialised vertices; then cells begin at the present low end.
    // out_of_memory.
    Status open_vertices(std::uint32_t vertex_count);
    Status open_cells();
    // Forgets all vertices from vertex_count on; there is nothing else at the high end.
    void truncate_vertices(std::uint32_t vertex_count);
    // Ends the job: drops ghosts, fills free slots from the end, moves the cells down to `offset` and gives what is
    // free to the gap. Hull facets then have neighbour `none`. O(cells), needs no memory. It polls, but does not stop.
    void compact(std::size_t offset);

    CellT& cell(std::uint32_t c) const {
        NETMESH_ASSERT(c < state.cell_slots || c == 0);
        return cells_[c];
    }
    CellT& cell(VertexId) const = delete;
    VertexT& vertex(std::uint32_t v) const {
        NETMESH_ASSERT(v < state.vertex_count || v == 0);
        return vertices_end_[-1 - static_cast<std::ptrdiff_t>(v)];
    }
    VertexT& vertex(CellId) const = delete;
    const double* point(std::uint32_t v) const { return vertex(v).x; }
    const double* point(CellId) const = delete;
    bool is_live(std::uint32_t c) const { return cells_[c].vertex[0] != freed; }
    bool is_live(VertexId) const = delete;
    bool is_ghost(std::uint32_t c) const { return ghost_position(c) >= 0; }
    bool is_ghost(VertexId) const = delete;
    // Where the cell has infinity for a vertex; -1 for a finite cell.
    int ghost_position(std::uint32_t c) const {
        for (int i = 0; i <= D; ++i)
            if (cells_[c].vertex[i] == none) return i;
        return -1;
    }
    std::uint32_t live_cells() const { return state.cell_slots - state.cells_free; }

    // Room for that many more cells and vertices together and list_bytes of list? Remembers what was wanted if not.
    bool has_room(std::uint32_t cells, std::uint32_t vertices, std::size_t list_bytes) {
        return has_room_for(arena, state, {cells, sizeof(CellT), vertices * sizeof(VertexT) + list_bytes});
    }
    // After has_room these cannot fail. A new cell is a new slot, whatever slots are free.
    CellId new_cell() {
        ++state.cells_created;
        arena.extend_low(sizeof(CellT));
        return CellId(state.cell_slots++);
    }
    VertexId new_vertex() {
        arena.extend_high(sizeof(VertexT));
        return VertexId(state.vertex_count++);
    }

    // A stamp that no cell carries yet, even; stamp + 1 is unused too.
    std::uint32_t new_stamp();

    // Lists of cells stand in the gap, entry k at list_top()[-1 - k].
    CellId* list_top() const { return reinterpret_cast<CellId*>(arena.at(arena.high_mark())); }
    std::size_t list_capacity() const { return arena.bytes_free() / 4; }

    TriangulationView<D> view() const {
        return {reinterpret_cast<const unsigned char*>(cells_), sizeof(CellT), state.cell_slots, state.vertex_count};
    }
    const unsigned char* coordinate_base() const { return reinterpret_cast<const unsigned char*>(&vertex(0)); }
    static constexpr std::ptrdiff_t vertex_stride = -static_cast<std::ptrdiff_t>(sizeof(VertexT));

    Arena& arena;
    StoreState& state;

private:
    CellT* cells_;
    VertexT* vertices_end_;
};

// Drops the ghosts among cells[0..count), so that hull facets have neighbour `none`, and fills free slots from the end.
// How many cells are left; O(count). C has the first two members of Cell<D>.
template <int D, class C> std::uint32_t close_gaps(C* cells, std::uint32_t count, const Arena& arena) {
    const auto is_free = [cells](std::uint32_t c) {
        if (cells[c].vertex[0] == Store<D>::freed) return true;
        std::uint32_t infinite = 0;
        while (infinite <= D && cells[c].vertex[infinite] != none) ++infinite;
        if (infinite > D) return false;
        const FacetId behind = cells[c].neighbour[infinite];
        cells[behind.cell()].neighbour[behind.position()] = none;
        return true;
    };
    std::uint32_t hole = 0, end = count;
    for (;;) {
        while (hole < end && !is_free(hole)) arena.step(++hole, 6 * D);
        if (hole == end) return end;
        while (hole < --end && is_free(end)) arena.step(end, 6 * D);
        if (hole == end) return end;
        cells[hole] = cells[end];
        for (std::uint32_t i = 0; i <= D; ++i) {
            const FacetId other = cells[hole].neighbour[i];
            if (other != none) cells[other.cell()].neighbour[other.position()] = FacetId(CellId(hole), i);
        }
        arena.step(++hole, 20 * D);
    }
}

// Slots taken, free ones first, and given back, with the counts in registers; for a store that has_room.
template <int D> class CellSupply {
public:
    explicit CellSupply(Store<D>& store)
        : store_(store), cells_(&store.cell(0)), head_(store.state.free_head), slots_(store.state.cell_slots) {}
    CellSupply(const CellSupply&) = delete;
    CellSupply& operator=(const CellSupply&) = delete;
    ~CellSupply() {
        StoreState& state = store_.state;
        store_.arena.extend_low((slots_ - state.cell_slots) * sizeof(Cell<D>));
        state.cells_free += given_ + (slots_ - state.cell_slots) - taken_;
        state.cells_created += taken_;
        state.free_head = head_;
        state.cell_slots = slots_;
    }
    CellId take() {
        ++taken_;
        const CellId c = head_;
        if (c == none) return CellId(slots_++);
        head_ = CellId(cells_[c].neighbour[0].word());
        if constexpr (D > 3)
            if (head_ != none) __builtin_prefetch(&cells_[head_], 1);  // of the one after it, for its turn
        return c;
    }
    void give_back(CellId c) {
        cells_[c].vertex[0] = Store<D>::freed;
        cells_[c].neighbour[0] = FacetId::from_word(head_);
        head_ = c;
        ++given_;
    }

private:
    Store<D>& store_;
    Cell<D>* const cells_;
    CellId head_;
    std::uint32_t slots_, taken_ = 0, given_ = 0;
};

}  // namespace netmesh
