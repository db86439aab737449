#include "delaunay/load.hpp"

#include "delaunay/sphere.hpp"
#include "numerics/radix_sort.hpp"
#include "numerics/random.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// The same for each order of the facet's vertices.
std::uint64_t facet_key(const AnyCell& cell, int facet) {
    std::uint64_t key = 0;
    for (int i = 0; i < cell.vertex.count; ++i)
        if (i != facet) key += mix64(cell.vertex[i]);
    return key;
}

bool same_facet(const AnyCell& a, int i, const AnyCell& b, int j) {
    const int count = a.vertex.count;
    for (int k = 0; k < count; ++k) {
        if (k == i) continue;
        bool found = false;
        for (int l = 0; l < count; ++l) found |= l != j && b.vertex[l] == a.vertex[k];
        if (!found) return false;
    }
    return true;
}

Status link_loaded_cells(const AnyStore& store, CheckResult* why) {
    ArenaScope scope(store.arena);
    const int dim = store.dim;
    const std::size_t count = std::size_t{store.state.cell_slots} * static_cast<std::size_t>(dim + 1);
    if (count > none / 8) return Status::out_of_memory;
    std::uint64_t* const keys = store.arena.take_high<std::uint64_t>(count);
    std::uint32_t* const facets = store.arena.take_high<std::uint32_t>(count);
    std::uint64_t* const spare_keys = store.arena.take_high<std::uint64_t>(count);
    std::uint32_t* const spare_facets = store.arena.take_high<std::uint32_t>(count);
    if (keys == nullptr || facets == nullptr || spare_keys == nullptr || spare_facets == nullptr)
        return Status::out_of_memory;
    std::size_t k = 0;
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 2 * (dim + 1) * (8 + 8 * dim));
             c < piece; ++c) {
            const AnyCell cell = store.cell(c);
            for (int i = 0; i <= dim; ++i, ++k) {
                keys[k] = facet_key(cell, i);
                facets[k] = FacetId(c, static_cast<std::uint32_t>(i)).word();
                cell.neighbour[i] = none;
            }
        }
    radix_sort(keys, facets, spare_keys, spare_facets, count, store.arena);
    // Of three equal facets the first meets the second, then the third.
    for (std::size_t a = 0; a < count;)
        for (const std::uint64_t piece = store.arena.piece(a, count, 40 + 10 * dim * dim); a < piece; ++a) {
            for (std::size_t b = a + 1; b < count && keys[b] == keys[a]; ++b) {
                const FacetId one = FacetId::from_word(facets[a]), two = FacetId::from_word(facets[b]);
                const AnyCell first = store.cell(one.cell()), second = store.cell(two.cell());
                const int i = static_cast<int>(one.position()), j = static_cast<int>(two.position());
                if (!same_facet(first, i, second, j)) continue;
                if (first.neighbour[i] != none) {
                    *why = {"a facet belongs to more than two cells", two.cell()};
                    return Status::check_failed;
                }
                first.neighbour[i] = two;
                second.neighbour[j] = one;
            }
        }
    return Status::ok;
}

void load_vertex(int dim, const double* x, std::uint32_t v, const AnyVertex& vertex) {
    for (int k = 0; k < dim; ++k) vertex.x[k] = x[k] + 0.0;
    vertex.cell = none;
    vertex.next = none;
    vertex.origin = v;
    vertex.marker = Marker::input;
    vertex.queued = 0;
    vertex.size_hint = 0;
}

// Gives a cell its vertices, and each of these the cell. What is wrong with them; null: nothing.
const char* take_vertices(const AnyStore& store, const std::uint32_t* vertices, CellId made) {
    const AnyCell cell = store.cell(made);
    for (int i = 0; i <= store.dim; ++i) {
        cell.vertex[i] = VertexId(vertices[i]);
        if (cell.vertex[i] >= store.state.vertex_count) return "a cell has a vertex that does not exist";
        for (int j = 0; j < i; ++j)
            if (cell.vertex[j] == cell.vertex[i]) return "a cell has a vertex twice";
        store.vertex(cell.vertex[i]).cell = made;
    }
    return nullptr;
}

// Turns a cell to positive orientation and finds its ball.
template <int D> void orient_cell(Store<D>& store, Cell<D>& cell) {
    const double* p[D + 1];
    for (int i = 0; i <= D; ++i) p[i] = store.point(cell.vertex[i]);
    if (orient<D>(p, store.state.orient_counts) == Sign::negative) {
        const VertexId v = cell.vertex[0];
        cell.vertex[0] = cell.vertex[1];
        cell.vertex[1] = v;
        const double* const q = p[0];
        p[0] = p[1];
        p[1] = q;
    }
    cell.mark = 0;
    solve_sphere<D>(p, corner_error_max, cell);
}

// Vertices and cells, balls included, but for neighbours and nearest2.
Status fill_store(const AnyStore& store, const double* coordinates, const std::uint32_t* cells, CheckResult* why) {
    const int dim = store.dim;
    const std::size_t width = static_cast<std::size_t>(dim);
    for (std::uint32_t v = 0; v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 30); v < piece; ++v) {
            load_vertex(dim, coordinates + v * width, v, store.vertex(v));
        }
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 80 * dim * dim); c < piece; ++c) {
            *why = {take_vertices(store, cells + c * (width + 1), c), c};
            if (why->violation != nullptr) return Status::check_failed;
            with_dimension(static_cast<std::uint32_t>(dim), [&](auto dimension) {
                constexpr int D = decltype(dimension)::value;
                Store<D> of_dimension = store.of_dimension<D>();
                orient_cell<D>(of_dimension, of_dimension.cell(c));
            });
        }
    *why = {nullptr, none};
    return Status::ok;
}

}  // namespace

template <int D>
Status load_cells(Store<D>& store, const double* coordinates, std::uint32_t vertex_count, const std::uint32_t* cells,
                  std::uint32_t cell_count, CheckResult* why) {
    *why = {nullptr, none};
    if (store.open_vertices(vertex_count) != Status::ok || store.open_cells() != Status::ok ||
        !store.has_room(cell_count, 0, 0))
        return Status::out_of_memory;
    for (std::uint32_t c = 0; c < cell_count;)
        for (const std::uint64_t piece = store.arena.piece(c, cell_count, 8); c < piece; ++c) {
            store.new_cell();
        }
    const Status status = fill_store(store, coordinates, cells, why);
    if (status != Status::ok) return status;
    measure_edges(store);
    return link_loaded_cells(store, why);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status load_cells<D>(Store<D>&, const double*, std::uint32_t, const std::uint32_t*, std::uint32_t,        \
                                  CheckResult*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
