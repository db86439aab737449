// What the context holds, item by item.
#include "api/items.hpp"

#include "api/plane.hpp"
#include "jobs/bar_bounds.hpp"

namespace netmesh {
namespace {

// Item `index` of a result that is there; null: there is none.
template <class T>
const T* item_of(const netmesh_context* context, bool present, const Slice<T>& items, std::uint64_t index) {
    return present && index < items.count ? items.in(context) + index : nullptr;
}

// Of a triangulation or a mesh, which are there as a whole or not.
std::uint64_t count_of_cells(const netmesh_context* context) {
    return context->mesh.present || context->plane.present ? context->mesh.store.cell_slots : 0;
}
std::uint64_t count_of_vertices(const netmesh_context* context) {
    return count_of_cells(context) > 0 ? context->mesh.store.vertex_count : 0;
}

// Ends a call by index: what was found for the caller's struct, or INVALID_ARGUMENT.
template <class Item> netmesh_status give_item(const Item& found, Item* item) {
    return give_result(found, item) ? NETMESH_OK : NETMESH_INVALID_ARGUMENT;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_get_vertex(const netmesh_context* context, uint64_t index, netmesh_vertex* vertex) {
    if (!usable(context) || index >= count_of_vertices(context)) return NETMESH_INVALID_ARGUMENT;
    netmesh_vertex found = {};
    if (keeps_plane && context->plane.present) {
        const double* const point = PlaneReader(context).point(static_cast<std::uint32_t>(index));
        for (int k = 0; k < 2; ++k) found.coordinates[k] = point[k];
        return give_item(found, vertex);
    }
    with_dimension(context->input.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const KeptStore<D> kept(context);
        const Vertex<D>& v = kept.store().vertex(static_cast<std::uint32_t>(index));
        for (int k = 0; k < D; ++k) found.coordinates[k] = v.x[k];
        found.marker = static_cast<std::uint32_t>(v.marker);
    });
    const Slice<double>& values = context->diagram.vertex_values;
    found.has_value = values.count > 0;
    if (values.count > 0) found.value = values.in(context)[index];
    return give_item(found, vertex);
}

netmesh_status netmesh_get_cell(const netmesh_context* context, uint64_t index, netmesh_cell* cell) {
    if (!usable(context) || index >= count_of_cells(context)) return NETMESH_INVALID_ARGUMENT;
    netmesh_cell found = {};
    if (keeps_plane && context->plane.present) {
        const PlaneReader plane(context);
        for (int i = 0; i < 3; ++i) {
            found.vertices[i] = plane.vertex(static_cast<std::uint32_t>(index), i);
            found.neighbours[i] = plane.neighbour(static_cast<std::uint32_t>(index), i);
        }
        return give_item(found, cell);
    }
    with_dimension(context->input.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const KeptStore<D> kept(context);
        const TriangulationView<D> view = kept.store().view();
        const CellId c(static_cast<std::uint32_t>(index));
        for (int i = 0; i <= D; ++i) {
            found.vertices[i] = view.vertices(c)[i];
            found.neighbours[i] = view.neighbour(c, i);
        }
    });
    return give_item(found, cell);
}

netmesh_status netmesh_get_cage(const netmesh_context* context, uint64_t index, netmesh_cage* cage) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const Cage* const kept = item_of(context, context->mesh.present, context->mesh.cages, index);
    if (kept == nullptr) return NETMESH_INVALID_ARGUMENT;
    return give_item({0, kept->centre, kept->parent, kept->radius}, cage);
}

netmesh_status netmesh_get_hidden(const netmesh_context* context, uint64_t index, uint64_t* row) {
    if (!usable(context) || row == nullptr) return NETMESH_INVALID_ARGUMENT;
    const std::uint32_t* const kept = item_of(context, context->input.present, context->input.hidden, index);
    if (kept == nullptr) return NETMESH_INVALID_ARGUMENT;
    *row = *kept;
    return NETMESH_OK;
}

netmesh_status netmesh_get_pair(const netmesh_context* context, uint64_t index, netmesh_pair* pair) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const KeptDiagram& diagram = context->diagram;
    if (!diagram.present || index >= diagram.pairs.count) return NETMESH_INVALID_ARGUMENT;
    const Pair kept = diagram.bars(context)[index];
    return give_item({0, kept.degree, kept.birth, kept.death}, pair);
}

netmesh_status netmesh_get_bar_bounds(const netmesh_context* context, uint64_t index, netmesh_bar_bounds* bounds) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const BarBounds* const b = item_of(context, context->bounds.present, context->bounds.bars, index);
    if (b == nullptr) return NETMESH_INVALID_ARGUMENT;
    return give_item({0, b->certain, b->birth_low, b->birth_high, b->death_low, b->death_high, b->certain_after},
                     bounds);
}

netmesh_status netmesh_get_scale_step(const netmesh_context* context, uint64_t index, netmesh_scale_step* step) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const ScaleStep* const s = item_of(context, context->bounds.present, context->bounds.steps, index);
    if (s == nullptr) return NETMESH_INVALID_ARGUMENT;
    return give_item({0, s->from, s->low, s->high, s->reach, s->ratio, s->error}, step);
}

netmesh_status netmesh_get_vine_point(const netmesh_context* context, uint64_t index, netmesh_vine_point* point) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const VinePoint* const p = item_of(context, context->vineyard.present, context->vineyard.points, index);
    if (p == nullptr) return NETMESH_INVALID_ARGUMENT;
    return give_item({0, p->vine, p->degree, p->k, p->birth, p->death}, point);
}

netmesh_status netmesh_get_vine_ratio(const netmesh_context* context, uint32_t k, double* ratio) {
    if (!usable(context) || ratio == nullptr || k < context->vineyard.k_first) return NETMESH_INVALID_ARGUMENT;
    const KeptVineyard& vineyard = context->vineyard;
    const double* const kept = item_of(context, vineyard.present, vineyard.ratios, k - vineyard.k_first);
    if (kept == nullptr) return NETMESH_INVALID_ARGUMENT;
    *ratio = *kept;
    return NETMESH_OK;
}

}  // extern "C"
