// The cycles that the context keeps, simplex by simplex.
#include "api/keep_complex.hpp"
#include "filtration/filters.hpp"
#include "numerics/sort.hpp"

namespace netmesh {
namespace {

// The cycle of a pair, and the arena as it is at the context's present place.
netmesh_status find_cycle(const netmesh_context* context, std::uint64_t index, Arena* arena, std::uint32_t* degree,
                          Cycle* cycle) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (!context->cycles.present) return NETMESH_NO_RESULT;
    if (index >= context->diagram.pairs.count) return NETMESH_INVALID_ARGUMENT;
    const Pair pair = context->diagram.bars(context)[index];
    *arena = context->arena;
    arena->rebase(const_cast<netmesh_context*>(context));
    *degree = pair.degree;
    *cycle = {};
    if (pair.cycle == 0) return NETMESH_OK;  // of no length, joined of scales
    const std::uint32_t* labels;
    *cycle = context->cycles.is_listed ? cycle_of(kept_complex(context, &labels), context->cycles.store, *arena, pair)
                                       : lower_star_cycle(context->cycles.store, *arena, pair);
    return NETMESH_OK;
}

// A simplex of the complex that is kept.
void listed_simplex(const netmesh_context* context, std::uint32_t at, netmesh_simplex* simplex) {
    const std::uint32_t* labels;
    const FilteredComplex complex = kept_complex(context, &labels);
    simplex->value = complex.of[simplex->degree].value[at];
    vertices_of(complex, labels, simplex->degree, at, simplex->vertices);
}

// A simplex of a complex modulo a lattice: sets of copies, the least at its own place.
void copied_simplex(const netmesh_context* context, std::uint32_t at, netmesh_simplex* simplex) {
    const KeptCopies& copies = context->cycles.copies;
    const void* const block = context;
    const std::uint32_t k = simplex->degree, axes = copies.axes;
    const std::uint64_t count = context->cycles.complex.of[k].count;
    const std::uint32_t* const vertex = Slice<std::uint32_t>{copies.vertices[k], count}.in(block) + at * (k + 1);
    const std::int32_t* const labels = Slice<std::int32_t>{copies.labels, 1}.in(block);
    const auto label = [&](std::uint32_t i) { return labels + std::size_t{vertex[i]} * (axes + 1); };
    std::uint32_t order[dimension_most() + 1];
    for (std::uint32_t i = 0; i <= k; ++i) order[i] = i;
    insertion_sort(order, std::uint64_t{k} + 1, [&](std::uint32_t a, std::uint32_t b) {
        for (std::uint32_t j = 0; j <= axes; ++j)
            if (label(a)[j] != label(b)[j]) return label(a)[j] < label(b)[j];
        return false;
    });
    const std::int32_t* const first = label(order[0]);
    for (std::uint32_t i = 0; i <= k; ++i) {
        const std::int32_t* const own = label(order[i]);
        simplex->vertices[i] = static_cast<std::uint32_t>(own[0]);
        for (std::uint32_t j = 0; j < axes; ++j) simplex->translations[i][j] = own[j + 1] - first[j + 1];
    }
    simplex->value = Slice<double>{context->cycles.complex.of[k].values, count}.in(block)[at];
}

// A simplex of a mesh: it enters with its last vertex, unless it is an input that enters at 0.
void mesh_simplex(const netmesh_context* context, const std::uint32_t* vertices, netmesh_simplex* simplex) {
    const KeptDiagram& diagram = context->diagram;
    const double* const value = diagram.vertex_values.in(context);
    simplex->value = value[vertices[0]] + 0.0;
    for (std::uint32_t i = 0; i <= simplex->degree; ++i) {
        simplex->vertices[i] = vertices[i];
        if (value[vertices[i]] > simplex->value) simplex->value = value[vertices[i]];
    }
    const std::uint32_t zero_born = zero_born_count(diagram.filter, diagram.k, context->input.distinct);
    if (simplex->degree == 0 && vertices[0] < zero_born) simplex->value = 0;
}

// A simplex of points, of a diagram joined of scales.
void point_simplex(const netmesh_context* context, std::uint64_t pair, const std::uint32_t* vertices,
                   netmesh_simplex* simplex) {
    simplex->value = context->diagram.bars(context)[pair].birth;
    for (std::uint32_t i = 0; i <= simplex->degree; ++i) simplex->vertices[i] = vertices[i];
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_get_cycle(const netmesh_context* context, uint64_t pair, uint64_t* simplices) {
    Arena arena;
    std::uint32_t degree;
    Cycle cycle = {};
    if (simplices == nullptr) return NETMESH_INVALID_ARGUMENT;
    const netmesh_status status = find_cycle(context, pair, &arena, &degree, &cycle);
    *simplices = cycle.count;
    return status;
}

netmesh_status netmesh_get_cycle_simplex(const netmesh_context* context, uint64_t pair, uint64_t index,
                                         netmesh_simplex* simplex) {
    Arena arena;
    netmesh_simplex found = {};
    Cycle cycle = {};
    if (!has_room(simplex)) return NETMESH_INVALID_ARGUMENT;
    const netmesh_status status = find_cycle(context, pair, &arena, &found.degree, &cycle);
    if (status != NETMESH_OK) return status;
    if (index >= cycle.count) return NETMESH_INVALID_ARGUMENT;
    const auto at = static_cast<std::size_t>(index);
    if (context->cycles.copies.axes != 0) {
        copied_simplex(context, cycle.simplices[at], &found);
        give_result(found, simplex);
        return NETMESH_OK;
    }
    if (context->cycles.is_listed) {
        listed_simplex(context, cycle.simplices[at], &found);
    } else if (context->scales.present) {
        point_simplex(context, pair, cycle.simplices + at * (found.degree + 1), &found);
    } else {
        mesh_simplex(context, cycle.simplices + at * (found.degree + 1), &found);
    }
    insertion_sort(found.vertices, std::uint64_t{found.degree} + 1,
                   [](std::uint32_t a, std::uint32_t b) { return a < b; });
    give_result(found, simplex);
    return NETMESH_OK;
}

}  // extern "C"
