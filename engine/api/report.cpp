// The report of what the context holds, and its fingerprint.
#include "api/figures.hpp"
#include "api/items.hpp"
#include "api/plane.hpp"

namespace netmesh {
namespace {

template <int D> void add_mesh(Fingerprint& f, const netmesh_context* context) {
    const KeptStore<D> kept(context);
    const Store<D>& store = kept.store();
    f.add(static_cast<std::uint64_t>(D));
    for (std::uint32_t v = 0; v < kept.vertex_count(); ++v) {
        for (int k = 0; k < D; ++k) f.add(store.vertex(v).x[k]);
        f.add(static_cast<std::uint64_t>(store.vertex(v).marker));
    }
    const TriangulationView<D> view = store.view();
    for (CellId c(0); c < kept.cell_count(); ++c)
        for (int i = 0; i <= D; ++i)
            f.add(static_cast<std::uint64_t>(view.vertices(c)[i]) << 32 | view.neighbour(c, i));
    const Cage* const cages = context->mesh.cages.in(context);
    for (std::uint64_t d = 0; d < context->mesh.cages.count; ++d) {
        f.add(static_cast<std::uint64_t>(cages[d].centre) << 32 | cages[d].parent);
        f.add(cages[d].radius);
    }
}

// As add_mesh of the same triangulation.
void add_plane(Fingerprint& f, const netmesh_context* context) {
    const PlaneReader plane(context);
    f.add(std::uint64_t{2});
    for (std::uint32_t v = 0; v < context->mesh.store.vertex_count; ++v) {
        for (int k = 0; k < 2; ++k) f.add(plane.point(v)[k]);
        f.add(static_cast<std::uint64_t>(Marker::input));
    }
    for (std::uint32_t c = 0; c < context->mesh.store.cell_slots; ++c)
        for (int i = 0; i <= 2; ++i)
            f.add(static_cast<std::uint64_t>(plane.vertex(c, i)) << 32 | plane.neighbour(c, i));
}

void add_pairs(Fingerprint& f, const netmesh_context* context) {
    const BarList pairs = context->diagram.bars(context);
    for (std::uint64_t i = 0; i < pairs.count; ++i) {
        const Pair pair = pairs[i];
        f.add(static_cast<std::uint64_t>(pair.degree));
        f.add(pair.birth);
        f.add(pair.death);
    }
}

[[gnu::cold, gnu::noinline]] void add_vines(Fingerprint& f, const netmesh_context* context) {
    const VinePoint* const points = context->vineyard.points.in(context);
    for (std::uint64_t i = 0; i < context->vineyard.points.count; ++i) {
        f.add(static_cast<std::uint64_t>(points[i].vine) << 32 | points[i].k);
        f.add(static_cast<std::uint64_t>(points[i].degree));
        f.add(points[i].birth);
        f.add(points[i].death);
    }
}

std::uint64_t fingerprint_of_report(const netmesh_context* context, const netmesh_report& report) {
    Fingerprint f;
    if (context->input.is_complex) {
        f.add(context->input.fingerprint);
        f.add(context->diagram.simplices);
    } else if (keeps_plane && context->plane.present) {
        add_plane(f, context);
    } else {
        with_dimension(context->input.dim, [&](auto dimension) { add_mesh<decltype(dimension)::value>(f, context); });
    }
    if (context->diagram.present) {
        add_figures(&f, report, FingerprintPart::diagram);
        add_pairs(f, context);
    }
    if (context->vineyard.present) {
        add_figures(&f, report, FingerprintPart::vineyard);
        add_vines(f, context);
    }
    return f.value();
}

template <int D> void count_markers(const netmesh_context* context, netmesh_mesh_report* report) {
    const KeptStore<D> kept(context);
    for (std::uint32_t v = context->input.distinct; v < kept.vertex_count(); ++v)
        ++(kept.store().vertex(v).marker == Marker::exempt ? report->exempt : report->steiner);
}

void report_audit(const MeshAudit& audit, std::uint32_t what, netmesh_audit_report* to) {
    static_assert(LocationAudit::rounds_max == NETMESH_ROUNDS_MAX);
    const LocationAudit& location = audit.location;
    const QualityAudit& quality = audit.quality;
    to->what = what;
    to->rounds = location.rounds;
    to->nets = location.nets;
    to->nets_max = location.nets_max;
    for (std::uint32_t k = 0; k < location.rounds; ++k) to->load[k] = location.load[k];
    to->ply_max = location.ply_max;
    to->ply_mean = location.ply_mean;
    to->touches_max = location.touches_max;
    to->touches_mean = location.touches_mean;
    to->tests_mean = location.tests_mean;
    to->meshes = quality.meshes;
    to->aspect_ratio_max = quality.worst;
    to->feature_ratio = quality.feature;
    to->cage_ratio = quality.cage;
    to->steiner_ratio = quality.steiner;
    to->input_ratio = quality.input;
    to->degree_max = quality.degree_max;
}

void report_mesh(const netmesh_context* context, netmesh_mesh_report* to) {
    const KeptMesh& mesh = context->mesh;
    const std::uint32_t dim = context->input.dim;
    to->present = 1;
    to->is_mesh = mesh.is_mesh;
    to->vertices = mesh.store.vertex_count;
    to->inputs = context->input.distinct;
    if (mesh.present)
        with_dimension(dim, [&](auto dimension) { count_markers<decltype(dimension)::value>(context, to); });
    to->cells = mesh.store.cell_slots;
    to->cells_created = mesh.store.cells_created;
    to->method = mesh.method;
    if (!mesh.is_mesh) return;
    for (std::uint32_t k = 0; k < dim; ++k) to->domain[k] = mesh.centre[k];
    to->domain[dim] = mesh.radius;
    to->aspect_ratio_max = mesh.aspect_ratio_max;
    to->tau = mesh.tau;
    to->goal.ratio = mesh.goal.ratio;
    to->goal.focus_ratio = mesh.goal.focus;
    to->goal.focus_from = mesh.goal.from;
    to->goal.focus_to = mesh.goal.to;
    to->sizes = {mesh.size_eps, mesh.size_ratio_max};
    to->hierarchy.present = mesh.method == NETMESH_METHOD_NETMESH || mesh.method == NETMESH_METHOD_THESIS;
    to->hierarchy.cages = mesh.hierarchy.cages;
    to->hierarchy.cages_made = mesh.hierarchy.cages_made;
    to->touches = mesh.touches;
    to->clipped = mesh.goal.clipped;
    report_audit(mesh.audit, mesh.audited, &to->audit);
}

void report_predicates(const StoreState& store, netmesh_predicates_report* to) {
    for (int s = 0; s < NETMESH_PREDICATE_STAGES; ++s) {
        to->in_ball[s] = store.in_ball_counts.calls[s];
        to->orient[s] = store.orient_counts.calls[s];
    }
}

[[gnu::cold, gnu::noinline]] void report_diagram(const netmesh_context* context, netmesh_diagram_report* to) {
    const KeptDiagram& diagram = context->diagram;
    const BarList pairs = diagram.bars(context);
    to->present = 1;
    to->filter = diagram.filter;
    to->values = diagram.values;
    to->max_degree = diagram.max_degree;
    to->k = diagram.k;
    to->representatives = context->cycles.present;
    for (std::uint64_t i = 0; i < pairs.count; ++i) {
        const Pair pair = pairs[i];
        ++to->pairs[pair.degree];
        to->essential[pair.degree] += pair.death == infinity;
    }
    to->simplices = diagram.simplices;
    to->certified_ratio = diagram.certified_ratio;
    to->certified_ratio_best = diagram.certified_ratio_best;
    to->certified_from = diagram.certified_from;
    to->certified_focus = diagram.certified_focus;
    to->certified_error = diagram.certified_error;
    to->fitted_error = diagram.fitted_error;
    to->why = diagram.why;
    to->tried_points = diagram.tried_points;
    to->tried_cells = diagram.tried_cells;
}

[[gnu::cold, gnu::noinline]] void report_bounds(const netmesh_context* context, netmesh_bounds_report* to) {
    const BarList pairs = context->diagram.bars(context);
    const BarBounds* const bars = context->bounds.bars.in(context);
    to->present = 1;
    to->max_degree = context->diagram.max_degree;
    for (std::uint64_t i = 0; i < context->bounds.bars.count; ++i) to->certain[pairs[i].degree] += bars[i].certain;
    to->steps = context->bounds.steps.count;
}

[[gnu::cold, gnu::noinline]] void report_decision(const netmesh_context* context, netmesh_decision_report* to) {
    const KeptBounds& bounds = context->bounds;
    const BarList pairs = context->diagram.bars(context);
    const DecisionView view = decision_of(context);
    to->present = 1;
    to->max_degree = context->diagram.max_degree;
    to->longer_than = bounds.longer_than;
    for (std::uint64_t i = 0; i < bounds.bars.count; ++i)
        to->undecided[pairs[i].degree] += is_undecided(view.bounds[i], bounds.longer_than);
    to->undecided_to = undecided_reach(view);
    to->decided_from = decided_from(view);
}

[[gnu::cold, gnu::noinline]] void report_scales(const KeptScales& scales, netmesh_scales_report* to) {
    to->present = 1;
    to->count = scales.count;
    to->points_max = scales.points_max;
    to->vertices_max = scales.vertices_max;
    to->vertices = scales.vertices;
    to->separation = scales.separation;
}

[[gnu::cold, gnu::noinline]] void report_vineyard(const KeptVineyard& vineyard, netmesh_vineyard_report* to) {
    to->present = 1;
    to->filter = vineyard.filter;
    to->values = vineyard.values;
    to->max_degree = vineyard.max_degree;
    to->k_first = vineyard.k_first;
    to->k_last = vineyard.k_last;
    to->vines = vineyard.vines;
    to->points = vineyard.points.count;
    to->transpositions = vineyard.transpositions;
    to->simplices = vineyard.simplices;
    to->certified_ratio = vineyard.certified_ratio;
}

netmesh_report report_of(const netmesh_context* context) {
    netmesh_report report = {};
    report.memory.block_bytes = context->block_bytes;
    report.memory.peak_bytes = context->arena.bytes_peak();
    report.memory.used_bytes = context->arena.bytes_used();
    const KeptInput& input = context->input;
    if (!input.present) return report;
    report.complete = context->complete;
    report.input.present = 1;
    report.input.dim = input.dim;
    report.input.points = input.points;
    report.input.duplicates = input.duplicates;
    report.input.distinct = input.distinct;
    report.input.fingerprint = input.fingerprint;
    report.input.hidden = input.hidden.count;
    report.input.weighting = input.weighting;
    report.input.squares = input.squares;
    report.input.periods = input.periods;
    report.input.copies = input.copies;
    report.input.moved = input.moved;
    if (context->mesh.present || context->plane.present) {
        report_mesh(context, &report.mesh);
        report_predicates(context->mesh.store, &report.predicates);
    }
    if (context->diagram.present) report_diagram(context, &report.diagram);
    if (context->bounds.present) report_bounds(context, &report.bounds);
    if (context->bounds.longer_than > 0) report_decision(context, &report.decision);
    if (context->scales.present) report_scales(context->scales, &report.scales);
    if (context->vineyard.present) report_vineyard(context->vineyard, &report.vineyard);
    report.simplicial_complex.present = input.is_complex;
    report.simplicial_complex.vertices = input.is_complex ? input.distinct : 0;
    report.fingerprint = fingerprint_of_report(context, report);
    return report;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_get_report(const netmesh_context* context, netmesh_report* report) {
    if (!usable(context) || !has_room(report)) return NETMESH_INVALID_ARGUMENT;
    give_result(report_of(context), report);
    return NETMESH_OK;
}
