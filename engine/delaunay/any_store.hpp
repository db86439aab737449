// A store whose dimension is a number at run time. Audits, checks and analyses take it: they run seldom, and are in the
// program once rather than once for each dimension. So do templates on D that are made for any_dimension.
#pragma once
#include <cstddef>
#include <cstdint>

#include "delaunay/store.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

constexpr int dimension_max = dimension_most();

// The members of Cell<D> and Vertex<D>, by the same names, where they stand in the block.
template <class T> struct MemberRow {
    T* first;
    int count;
    T& operator[](std::uint32_t i) const { return first[i]; }
    T* begin() const { return first; }
    T* end() const { return first + count; }
};
template <> struct Cell<any_dimension> {
    MemberRow<VertexId> vertex;
    MemberRow<FacetId> neighbour;
    double* centre;
    double& radius2;
    float& error;
    std::uint32_t& mark;
};
template <> struct Vertex<any_dimension> {
    double* x;
    double& nearest2;
    CellId& cell;
    VertexId& next;
    std::uint32_t& origin;
    Marker& marker;
    std::uint8_t& queued;
    std::uint16_t& size_hint;
};
using AnyCell = Cell<any_dimension>;
using AnyVertex = Vertex<any_dimension>;

template <> class Store<any_dimension> {
public:
    Store(int dim, Arena& arena, StoreState& state) : dim(dim), arena(arena), state(state) { locate_arrays(); }
    template <int D> Store(const Store<D>& store) : Store(D, store.arena, store.state) {
        static_assert(sizeof(Cell<D>) == cell_bytes(D) && offsetof(Cell<D>, centre) == centre_offset(D) &&
                      offsetof(Cell<D>, radius2) == radius_offset(D) && sizeof(Vertex<D>) == vertex_bytes(D));
    }
    void locate_arrays();
    // The store itself, for what there is for each dimension anyhow; dim is D.
    template <int D> Store<D> of_dimension() const {
        if constexpr (D == any_dimension)
            return *this;
        else
            return Store<D>(arena, state);
    }

    AnyCell cell(std::uint32_t c) const {
        NETMESH_ASSERT(c < state.cell_slots);
        unsigned char* const at = cells_ + c * cell_bytes(dim);
        unsigned char* const ball = at + radius_offset(dim);
        return {{reinterpret_cast<VertexId*>(at), dim + 1},
                {reinterpret_cast<FacetId*>(at) + (dim + 1), dim + 1},
                reinterpret_cast<double*>(at + centre_offset(dim)),
                *reinterpret_cast<double*>(ball),
                *reinterpret_cast<float*>(ball + 8),
                *reinterpret_cast<std::uint32_t*>(ball + 12)};
    }
    AnyCell cell(VertexId) const = delete;
    AnyVertex vertex(std::uint32_t v) const {
        NETMESH_ASSERT(v < state.vertex_count);
        unsigned char* const at = vertices_ - v * vertex_bytes(dim);
        unsigned char* const rest = at + 8 * static_cast<std::size_t>(dim);
        return {reinterpret_cast<double*>(at),
                *reinterpret_cast<double*>(rest),
                *reinterpret_cast<CellId*>(rest + 8),
                *reinterpret_cast<VertexId*>(rest + 12),
                *reinterpret_cast<std::uint32_t*>(rest + 16),
                *reinterpret_cast<Marker*>(rest + 20),
                *(rest + 21),
                *reinterpret_cast<std::uint16_t*>(rest + 22)};
    }
    AnyVertex vertex(CellId) const = delete;
    void copy_vertex(std::uint32_t from, std::uint32_t to) const {
        __builtin_memcpy(vertices_ - to * vertex_bytes(dim), vertices_ - from * vertex_bytes(dim), vertex_bytes(dim));
    }
    void exchange_vertices(std::uint32_t a, std::uint32_t b) const {
        unsigned char kept[8 * dimension_max + 24];
        unsigned char *const of_a = vertices_ - a * vertex_bytes(dim), *const of_b = vertices_ - b * vertex_bytes(dim);
        __builtin_memcpy(kept, of_a, vertex_bytes(dim));
        __builtin_memcpy(of_a, of_b, vertex_bytes(dim));
        __builtin_memcpy(of_b, kept, vertex_bytes(dim));
    }
    const double* point(std::uint32_t v) const {
        return reinterpret_cast<const double*>(vertices_ - v * vertex_bytes(dim));
    }
    const double* point(CellId) const = delete;
    TriangulationView<any_dimension> view() const {
        return {cells_, cell_bytes(dim), state.cell_slots, state.vertex_count, static_cast<std::uint32_t>(dim)};
    }
    const unsigned char* first_point() const { return vertices_; }
    const unsigned char* first_cell() const { return cells_; }
    std::ptrdiff_t point_stride() const { return -static_cast<std::ptrdiff_t>(vertex_bytes(dim)); }
    bool is_live(std::uint32_t c) const { return cell(c).vertex[0] != none - 1; }
    bool is_ghost(std::uint32_t c) const {
        for (const VertexId v : cell(c).vertex)
            if (v == none) return true;
        return false;
    }
    CellId* list_top() const { return reinterpret_cast<CellId*>(arena.at(arena.high_mark())); }
    std::size_t list_capacity() const { return arena.bytes_free() / 4; }
    std::uint32_t live_cells() const { return state.cell_slots - state.cells_free; }

    // As those of Store<dim>.
    std::uint32_t new_stamp() const;
    Status open_vertices(std::uint32_t vertex_count);
    Status open_cells();
    bool has_room(std::uint32_t cells, std::uint32_t vertices, std::size_t list_bytes) const {
        const StoreNeeds needs = {cells, cell_bytes(dim), vertices * vertex_bytes(dim) + list_bytes};
        return has_room_for(arena, state, needs);
    }
    VertexId new_vertex() const {
        arena.extend_high(vertex_bytes(dim));
        return VertexId(state.vertex_count++);
    }
    void truncate_vertices(std::uint32_t vertex_count) const {
        state.vertex_count = vertex_count;
        arena.release_high(state.vertices_end - vertex_count * vertex_bytes(dim));
    }
    void compact(std::size_t offset);

    const AnyDimension dim;
    Arena& arena;
    StoreState& state;

    static constexpr std::size_t cell_bytes(int d) { return radius_offset(d) + 16; }

private:
    static constexpr std::size_t centre_offset(int d) { return 8 * static_cast<std::size_t>(d + 1); }
    static constexpr std::size_t radius_offset(int d) { return centre_offset(d) + 8 * static_cast<std::size_t>(d); }
    static constexpr std::size_t vertex_bytes(int d) { return 8 * static_cast<std::size_t>(d) + 24; }

    unsigned char *cells_, *vertices_;  // of cell and vertex 0
};
using AnyStore = Store<any_dimension>;

// CellList of cell_list.hpp.
class AnyCellList {
public:
    explicit AnyCellList(const AnyStore& store);
    ~AnyCellList() { store_.arena.raise_peak(below_ + size_ * sizeof(CellId)); }
    AnyCellList(const AnyCellList&) = delete;
    AnyCellList& operator=(const AnyCellList&) = delete;
    bool add(CellId c);
    bool has(CellId c) const { return store_.cell(c).mark == stamp_; }
    std::uint32_t size() const { return size_; }
    CellId operator[](std::uint32_t k) const { return end_[-1 - static_cast<std::ptrdiff_t>(k)]; }

private:
    const AnyStore& store_;
    CellId* const end_;
    const std::size_t capacity_, below_;
    const std::uint32_t stamp_;
    std::uint32_t size_ = 0;
};

// Lists the cells at v, in visit_star's order, at list_top()[-1 - k]: their number, 0 when the gap is too small. In a
// compact store v may be on the hull: the cells there hang together through facets too.
std::uint32_t list_star(const AnyStore& store, VertexId v);

template <class Visit> bool visit_any_star(const AnyStore& store, VertexId v, Visit&& visit) {
    const CellId* const star = store.list_top();
    const std::uint32_t count = list_star(store, v);
    for (std::uint32_t k = 0; k < count; ++k) visit(star[-1 - static_cast<std::ptrdiff_t>(k)]);
    return count > 0;
}

}  // namespace netmesh
