#include "api/dispatch.hpp"
#include "jobs/k_vineyard.hpp"
#include "numerics/fingerprint.hpp"

namespace netmesh {
namespace {

const Pair* pairs_of(const netmesh_context* context) {
    return reinterpret_cast<const Pair*>(reinterpret_cast<const unsigned char*>(context) + context->pairs_offset);
}

const VinePoint* vine_points_of(const netmesh_context* context) {
    return reinterpret_cast<const VinePoint*>(reinterpret_cast<const unsigned char*>(context) +
                                              context->vine_points_offset);
}

void add_vineyard(const netmesh_context* context, Fingerprint& f) {
    f.add(context->certified_ratio);
    for (std::uint64_t i = 0; i < context->vine_points; ++i) {
        const VinePoint& point = vine_points_of(context)[i];
        f.add(static_cast<std::uint64_t>(point.vine) << 32 | point.k);
        f.add(static_cast<std::uint64_t>(point.degree));
        f.add(point.birth);
        f.add(point.death);
    }
}

// The store of a context that is only read. Its arena is given the block's present address.
template <int D> Store<D> store_of(const netmesh_context* context, Arena& arena, StoreState& state) {
    arena = context->arena;
    arena.rebase(const_cast<netmesh_context*>(context));
    state = context->store;
    return Store<D>(arena, state);
}

bool holds_result(const netmesh_context* context) {
    return context != nullptr && context->magic == context_magic && context->dim != 0;
}
bool holds_diagram(const netmesh_context* context) {
    return context != nullptr && context->magic == context_magic && (context->dim != 0 || context->is_complex) &&
           context->has_diagram;
}

template <int D> std::uint64_t fingerprint_of(const netmesh_context* context) {
    Arena arena;
    StoreState state;
    const Store<D> store = store_of<D>(context, arena, state);
    Fingerprint f;
    f.add(static_cast<std::uint64_t>(D));
    for (std::uint32_t v = 0; v < state.vertex_count; ++v) {
        for (int k = 0; k < D; ++k) f.add(store.vertex(v).x[k]);
        f.add(static_cast<std::uint64_t>(store.vertex(v).marker));
    }
    for (std::uint32_t c = 0; c < state.cell_slots; ++c)
        for (int i = 0; i <= D; ++i) {
            const FacetId facet = store.cell(c).neighbour[i];
            f.add(static_cast<std::uint64_t>(store.cell(c).vertex[i]) << 32 | (facet == none ? none : facet.cell()));
        }
    const Cage* const cages = cages_of(*context);
    for (std::uint32_t d = 0; d < context->hierarchy.cages; ++d) {
        f.add(static_cast<std::uint64_t>(cages[d].centre) << 32 | cages[d].parent);
        f.add(cages[d].radius);
    }
    if (context->has_diagram) {
        f.add(context->certified_ratio);
        for (std::uint64_t k = 0; k < context->pair_count; ++k) {
            const Pair& pair = pairs_of(context)[k];
            f.add(static_cast<std::uint64_t>(pair.degree));
            f.add(pair.birth);
            f.add(pair.death);
        }
    }
    if (context->has_vineyard) add_vineyard(context, f);
    return f.value();
}

template <int D> void count_markers(const netmesh_context* context, netmesh_report* report) {
    Arena arena;
    StoreState state;
    const Store<D> store = store_of<D>(context, arena, state);
    for (std::uint32_t v = context->inputs; v < state.vertex_count; ++v)
        ++(store.vertex(v).marker == Marker::exempt ? report->exempt : report->steiner);
}

void report_diagram(const netmesh_context* context, netmesh_report* report) {
    report->has_diagram = context->has_diagram;
    if (!context->has_diagram && !context->has_vineyard) return;
    report->filter = context->filter;
    report->values = context->values;
    report->max_degree = context->max_degree;
    report->k = context->k;
    for (std::uint64_t k = 0; k < context->pair_count; ++k) {
        const Pair& pair = pairs_of(context)[k];
        ++report->pairs[pair.degree];
        report->essential[pair.degree] += pair.death == infinity;
    }
    report->simplices = context->simplices;
    report->certified_ratio = context->certified_ratio;
    report->certified_ratio_best = context->certified_ratio_best;
    report->certified_from = context->certified_from;
}

void report_audit(const netmesh_context* context, netmesh_audit* audit) {
    static_assert(LocationAudit::rounds_max == NETMESH_ROUNDS_MAX);
    const LocationAudit& location = context->mesh_audit.location;
    const QualityAudit& quality = context->mesh_audit.quality;
    audit->what = context->audit;
    audit->rounds = location.rounds;
    audit->nets = location.nets;
    audit->nets_max = location.nets_max;
    for (std::uint32_t k = 0; k < location.rounds; ++k) audit->load[k] = location.load[k];
    audit->ply_max = location.ply_max;
    audit->ply_mean = location.ply_mean;
    audit->touches_max = location.touches_max;
    audit->touches_mean = location.touches_mean;
    audit->tests_mean = location.tests_mean;
    audit->meshes = quality.meshes;
    audit->aspect_ratio_max = quality.worst;
    audit->feature_ratio = quality.feature;
    audit->cage_ratio = quality.cage;
    audit->steiner_ratio = quality.steiner;
    audit->input_ratio = quality.input;
}

void report_complex(const netmesh_context* context, netmesh_report* report) {
    report->dim = context->point_dim;
    report->complete = context->complete;
    report->points = context->points;
    report->duplicates = context->duplicates;
    report->input_fingerprint = context->input_fingerprint;
    report->vertices = report->inputs = context->inputs;
    report->fingerprint = context->result_fingerprint;
    report_diagram(context, report);
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_get_report(const netmesh_context* context, netmesh_report* report) {
    if (context == nullptr || context->magic != context_magic || report == nullptr ||
        report->struct_bytes != sizeof(netmesh_report))
        return NETMESH_INVALID_ARGUMENT;
    *report = netmesh_report{};
    report->struct_bytes = sizeof(netmesh_report);
    report->block_bytes = context->block_bytes;
    report->peak_bytes = context->arena.bytes_peak();
    report->used_bytes = context->arena.bytes_used();
    if (context->is_complex) report_complex(context, report);
    if (!holds_result(context)) return NETMESH_OK;

    report->dim = context->dim;
    report->is_mesh = context->is_mesh;
    report->complete = context->complete;
    report->points = context->points;
    report->duplicates = context->duplicates;
    report->input_fingerprint = context->input_fingerprint;
    report->vertices = context->store.vertex_count;
    report->inputs = context->inputs;
    report->cells = context->store.cell_slots;
    report->cells_created = context->store.cells_created;
    with_dimension(context->dim, [&](auto dimension) { count_markers<decltype(dimension)::value>(context, report); });
    if (context->is_mesh) {
        report->tau = context->tau;
        report->ratio = context->goal.ratio;
        report->focus_ratio = context->goal.focus;
        report->focus_from = context->goal.from;
        report->focus_to = context->goal.to;
        report->aspect_ratio_max = context->aspect_ratio_max;
        report->over_refine_eps = context->over_refine_eps;
        report->size_ratio_max = context->size_ratio_max;
        for (std::uint32_t k = 0; k < context->dim; ++k) report->domain[k] = context->domain_centre[k];
        report->domain[context->dim] = context->domain_radius;
        report->method = context->method;
        report->cages = context->hierarchy.cages;
        report->cages_made = context->hierarchy.cages_made;
        report->touches = context->hierarchy.touches;
        report_audit(context, &report->audit);
    }
    report->has_vineyard = context->has_vineyard;
    if (context->scales > 0) {
        report->scales = context->scales;
        report->separation = context->separation;
        report->scale_points_max = context->scale_points_max;
        report->scale_vertices_max = context->scale_vertices_max;
        report->scale_vertices = context->scale_vertices;
    }
    if (context->has_vineyard) {
        report->k_first = context->k_first;
        report->k_last = context->k_last;
        report->vines = context->vines;
        report->vine_points = context->vine_points;
        report->transpositions = context->transpositions;
    }
    report_diagram(context, report);
    for (int s = 0; s < NETMESH_PREDICATE_STAGES; ++s) {
        report->predicate_calls[s] = context->store.in_ball_counts.calls[s];
        report->orient_calls[s] = context->store.orient_counts.calls[s];
    }
    report->fingerprint = with_dimension(
        context->dim, [&](auto dimension) { return fingerprint_of<decltype(dimension)::value>(context); });
    return NETMESH_OK;
}

netmesh_status netmesh_get_vertex(const netmesh_context* context, uint64_t index, netmesh_vertex* vertex) {
    if (vertex == nullptr || !holds_result(context) || index >= context->store.vertex_count)
        return NETMESH_INVALID_ARGUMENT;
    *vertex = netmesh_vertex{};
    with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Arena arena;
        StoreState state;
        const Store<D> store = store_of<D>(context, arena, state);
        const Vertex<D>& v = store.vertex(static_cast<std::uint32_t>(index));
        for (int k = 0; k < D; ++k) vertex->coordinates[k] = v.x[k];
        vertex->marker = static_cast<std::uint32_t>(v.marker);
    });
    if (context->has_values) {
        vertex->has_value = 1;
        vertex->value = reinterpret_cast<const double*>(reinterpret_cast<const unsigned char*>(context) +
                                                        context->values_offset)[index];
    }
    return NETMESH_OK;
}

netmesh_status netmesh_get_cell(const netmesh_context* context, uint64_t index, netmesh_cell* cell) {
    if (cell == nullptr || !holds_result(context) || index >= context->store.cell_slots)
        return NETMESH_INVALID_ARGUMENT;
    *cell = netmesh_cell{};
    with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Arena arena;
        StoreState state;
        const TriangulationView<D> view = store_of<D>(context, arena, state).view();
        const CellId c(static_cast<std::uint32_t>(index));
        for (int i = 0; i <= D; ++i) {
            cell->vertices[i] = view.vertices(c)[i];
            cell->neighbours[i] = view.neighbour(c, i);
        }
    });
    return NETMESH_OK;
}

netmesh_status netmesh_get_cage(const netmesh_context* context, uint64_t index, netmesh_cage* cage) {
    if (cage == nullptr || !holds_result(context) || index >= context->hierarchy.cages) return NETMESH_INVALID_ARGUMENT;
    const Cage& kept = cages_of(*context)[index];
    *cage = {kept.centre, kept.parent, kept.radius};
    return NETMESH_OK;
}

netmesh_status netmesh_get_pair(const netmesh_context* context, uint64_t index, netmesh_pair* pair) {
    if (pair == nullptr || !holds_diagram(context) || index >= context->pair_count) return NETMESH_INVALID_ARGUMENT;
    const Pair& p = pairs_of(context)[index];
    pair->degree = p.degree;
    pair->birth = p.birth;
    pair->death = p.death;
    return NETMESH_OK;
}

netmesh_status netmesh_get_vine_point(const netmesh_context* context, uint64_t index, netmesh_vine_point* point) {
    if (point == nullptr || !holds_result(context) || !context->has_vineyard || index >= context->vine_points)
        return NETMESH_INVALID_ARGUMENT;
    const VinePoint& p = vine_points_of(context)[index];
    *point = {p.vine, p.degree, p.k, p.birth, p.death};
    return NETMESH_OK;
}

netmesh_status netmesh_get_vine_ratio(const netmesh_context* context, uint32_t k, double* ratio) {
    if (ratio == nullptr || !holds_result(context) || !context->has_vineyard || k < context->k_first ||
        k > context->k_last)
        return NETMESH_INVALID_ARGUMENT;
    *ratio = reinterpret_cast<const double*>(reinterpret_cast<const unsigned char*>(context) +
                                             context->vine_ratios_offset)[k - context->k_first];
    return NETMESH_OK;
}

}  // extern "C"
