// What is measured of each Voronoi cell and of each D-ball.
#include "api/measure.hpp"
#include "delaunay/any_kernel.hpp"
#include "include/netmesh/laboratory.h"
#include "laboratory/fat_cell.hpp"
#include "laboratory/structure.hpp"
#include "laboratory/weighted_cells.hpp"

namespace netmesh {
namespace {

// Element `index` of the caller's array, whose first one says how many bytes each has.
template <class Item> void give_element(const Item& from, std::uint64_t index, std::uint32_t bytes, Item* array) {
    start_struct(&from, sizeof from, reinterpret_cast<unsigned char*>(array) + index * bytes, bytes);
}

void copy_ball(int dim, const double* centre, double radius, double* ball) {
    copy(dim, centre, ball);
    ball[dim] = radius;
}

// Calls give(vertex, cell, piece) for each vertex that is inserted.
template <class Give> Status measure_each(Context& context, Give&& give) {
    const AnyStore store = store_of(context);
    recompute_balls(store);
    AnyDomain domain = domain_of(context);
    if (!context.mesh.is_mesh) domain.radius = 0;
    FattestCells cells(store, domain, context.arena);
    Status status = Status::ok;
    for (VertexId v(0); v < store.state.vertex_count && status == Status::ok; ++v) {
        if (store.vertex(v).cell == none) continue;
        FatCell cell;
        FattestCells::Piece piece;
        status = cells.measure(v, &cell, &piece);
        if (status == Status::ok) give(v, cell, static_cast<std::uint32_t>(piece));
    }
    return status;
}

// Of a triangulation.
Status measure_whole_cells(Context& context, double* ratios, std::uint32_t* domains) {
    for (std::uint32_t v = 0; v < context.mesh.store.vertex_count; ++v) {
        ratios[v] = 0;
        domains[v] = none;
    }
    return measure_each(context, [&](VertexId v, const FatCell& cell, std::uint32_t) {
        ratios[v] = cell.known && cell.bounded ? 2 * cell.reach / cell.nearest : infinity;
    });
}

Status measure_voronoi(Context& context, std::uint32_t bytes, netmesh_voronoi* array) {
    const int dim = static_cast<int>(context.input.dim);
    for (std::uint32_t v = 0; v < context.mesh.store.vertex_count; ++v) give_element({}, v, bytes, array);
    return measure_each(context, [&](VertexId v, const FatCell& cell, std::uint32_t piece) {
        netmesh_voronoi found = {};
        if (!cell.known) return;
        found.piece = piece;
        found.bounded = cell.bounded;
        found.corners = cell.corners;
        found.degree = cell.degree;
        found.nearest = cell.nearest;
        found.reach = cell.reach;
        copy_ball(dim, cell.in_centre, cell.in_radius, found.in_ball);
        copy_ball(dim, cell.out_centre, cell.out_radius, found.out_ball);
        if (cell.in_radius > 0) found.beta = cell.out_radius / cell.in_radius * (1 + 0x1p-40);
        give_element(found, v, bytes, array);
    });
}

Status measure_balls(Context& context, std::uint32_t bytes, netmesh_ball* array) {
    const AnyStore store = store_of(context);
    recompute_balls(store);
    for (CellId c(0); c < store.state.cell_slots; ++c) {
        BallFigures figures;
        const Status status = measure_ball(store, c, &figures);
        if (status != Status::ok) return status;
        const AnyCell cell = store.cell(c);
        netmesh_ball found = {};
        found.ply = figures.ply;
        found.meets = figures.meets;
        copy_ball(store.dim, cell.centre, square_root(cell.radius2), found.ball);
        found.error = static_cast<double>(cell.error) * found.ball[store.dim];
        give_element(found, c, bytes, array);
    }
    return Status::ok;
}

// The domain of a vertex that is in none.
constexpr std::uint32_t not_inserted = none - 1;

Status measure_weighted(Context& context, std::uint32_t bytes, netmesh_weighted_cell* array) {
    Arena& arena = context.arena;
    const ArenaScope scope(arena);
    const AnyStore store = store_of(context);
    const std::uint32_t cages = cage_count_of(context), vertices = store.state.vertex_count;
    if (cages == 0) return Status::ok;
    double* const ratios = arena.take_low<double>(vertices);
    std::uint32_t* const domains = arena.take_low<std::uint32_t>(vertices);
    double* const radii = arena.take_low<double>(2 * cages);
    WeightedCell* const cells = arena.take_low<WeightedCell>(cages);
    if (ratios == nullptr || domains == nullptr || radii == nullptr || cells == nullptr) return Status::out_of_memory;
    HierarchyQuality quality;
    HierarchyRequest request = hierarchy_of(context, domain_of(context));
    request.ratios = ratios;
    request.domains = domains;
    request.cage_radii = radii;
    const Status status = measure_hierarchy(store, request, arena, &quality);
    if (status != Status::ok || !quality.is_hierarchy) return status == Status::ok ? Status::no_result : status;
    for (std::uint32_t v = 0; v < vertices; ++v)
        if (store.vertex(v).cell == none) domains[v] = not_inserted;
    measure_weighted_cells(hierarchy_view(store, cages_of(context), cages, domains), cells);
    for (std::uint32_t d = 0; d < cages; ++d) {
        const WeightedCell& cell = cells[d];
        const netmesh_weighted_cell found = {
            0, cell.weight, cell.in_radius, cell.feature_size, cell.epsilon, radii[2 * d], radii[2 * d + 1]};
        give_element(found, d, bytes, array);
    }
    return Status::ok;
}

// Calls measure(bytes an element has) when there is room for a result and something to measure.
template <class Item, class Measure>
netmesh_status fill(netmesh_context* context, const Item* array, Measure&& measure) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    std::uint32_t bytes = 0;
    if (has_room(array)) __builtin_memcpy(&bytes, array, sizeof bytes);
    if (bytes == 0)
        return refuse(context, NETMESH_FIELD_RESULT, "the array is null or the first one's size is not set");
    if (!context->mesh.present) return finish(context, Status::no_result, "there is no triangulation or mesh");
    if (context->input.weighting != NETMESH_WEIGHTING_NONE) return finish(context, Status::no_result, weighted_cells);
    return finish(context, measure(bytes));
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_measure_cells(netmesh_context* context, double* ratios, uint32_t* domains) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (ratios == nullptr || domains == nullptr) return refuse(context, NETMESH_FIELD_RESULT, "an array is null");
    if (!context->mesh.present) return finish(context, Status::no_result, "there is no triangulation or mesh");
    if (context->input.weighting != NETMESH_WEIGHTING_NONE) return finish(context, Status::no_result, weighted_cells);
    if (!context->mesh.is_mesh) return finish(context, measure_whole_cells(*context, ratios, domains));
    HierarchyQuality quality;
    HierarchyRequest asked = hierarchy_of(*context, domain_of(*context));
    asked.ratios = ratios;
    asked.domains = domains;
    return finish(context, measure_hierarchy(store_of(*context), asked, context->arena, &quality));
}

netmesh_status netmesh_measure_voronoi(netmesh_context* context, netmesh_voronoi* cells) {
    return fill(context, cells, [=](std::uint32_t bytes) { return measure_voronoi(*context, bytes, cells); });
}

netmesh_status netmesh_weighted_cells(netmesh_context* context, netmesh_weighted_cell* cells) {
    return fill(context, cells, [=](std::uint32_t bytes) { return measure_weighted(*context, bytes, cells); });
}

netmesh_status netmesh_measure_balls(netmesh_context* context, netmesh_ball* balls) {
    return fill(context, balls, [=](std::uint32_t bytes) { return measure_balls(*context, bytes, balls); });
}

}  // extern "C"
