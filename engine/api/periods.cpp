// Points with periods: their alpha diagrams, with weights or without.
#include "api/keep_complex.hpp"
#include "api/plan.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "jobs/alpha_of_periodic_points.hpp"

namespace netmesh {
namespace {

// Whether what is said of periods goes together; the vectors themselves are read by the job alone.
Complaint settle_lattice(const Settling& s) {
    if (s.is_promise()) return {NETMESH_FIELD_PERIODS, "nothing is promised with periods; leave them out"};
    if (s.source != Source::points) return {NETMESH_FIELD_PERIODS, "periods are of points; give points"};
    if (s.call == Call::mesh)
        return {NETMESH_FIELD_PERIODS, "there are no triangulations and meshes with periods; call netmesh_persist"};
    if (s.r.points.lattice_count == 0)
        return {NETMESH_FIELD_LATTICE_COUNT, "periods without vectors; give points.lattice"};
    if (s.r.points.lattice_count > s.r.points.dim) return {NETMESH_FIELD_LATTICE_COUNT, "more vectors than dimensions"};
    if (s.r.keep_mesh != 0) return {NETMESH_FIELD_KEEP_MESH, "with periods no triangulation is kept; leave it out"};
    if (!s.takes_alpha()) return fine();
    if (s.r.bounds != nullptr)
        return {NETMESH_FIELD_BOUNDS, "with periods each bar is the exact one, rounded; leave out bounds"};
    return fine();
}

// Nothing where numbers are there. What the context holds stays.
Complaint missing_numbers(const netmesh_request& r) {
    const Complaint complaint = missing_weights(r);
    if (complaint.text != nullptr) return complaint;
    if (r.points.lattice == nullptr) return {NETMESH_FIELD_LATTICE, "periods without a lattice; give points.lattice"};
    return reinterpret_cast<std::uintptr_t>(r.points.lattice) % alignment_of_double != 0
               ? Complaint{NETMESH_FIELD_LATTICE, "the lattice is not aligned to its numbers"}
               : Complaint{};
}

[[gnu::cold]] netmesh_status fail_with_periods(netmesh_context* context, Status status,
                                               const PeriodicAlphaDiagram& made) {
    const PeriodicReport& report = made.report;
    const std::uint64_t row = report.input.row_a;
    if (made.is_far)
        return fail_and_clear(context, status, "a point is 2^30 periods away or more, which cycles cannot say", row);
    if (report.copies > 0 && refuses_square(context, status)) {  // values come after copies
        clear(context);
        return NETMESH_INVALID_ARGUMENT;
    }
    if (report.has_bad_lattice && status == Status::invalid_argument) {
        clear(context);
        return refuse(context, {NETMESH_FIELD_LATTICE, "a vector is not finite, or depends on those before it"},
                      static_cast<std::uint64_t>(report.culprit));
    }
    if (report.has_negative) {
        clear(context);
        return refuse(context, {NETMESH_FIELD_WEIGHTS, "a radius is negative"}, row);
    }
    return fail_and_clear(context, status, report.has_weight ? "a weight is not a finite number" : nullptr, row);
}

void keep_quotient(netmesh_context* context, const QuotientCycles& cycles) {
    const Arena& arena = context->arena;
    keep_cycles(context, cycles.store, static_cast<std::size_t>(cycles.store.top));
    keep_complex(context, cycles.complex);
    KeptCopies& copies = context->cycles.copies;
    copies.axes = cycles.axes;
    copies.labels = arena.offset_of(cycles.copies);
    for (std::uint32_t k = 0; k <= cycles.complex.dimension; ++k)
        copies.vertices[k] = arena.offset_of(cycles.vertices[k]);
}

netmesh_status diagram_with_periods(netmesh_context* context) {
    const netmesh_request& r = context->request;
    const Complaint missing = missing_numbers(r);
    if (missing.text != nullptr) return refuse(context, missing);
    clear(context);
    const netmesh_points& p = r.points;
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    WeightRows weights = {};
    if (r.weighting != nullptr) weights = weights_of(r);
    const AlphaOfPeriodicPoints wanted = {{rows_of(p), p.count, r.weighting != nullptr ? &weights : nullptr, p.lattice,
                                           static_cast<int>(p.lattice_count)},
                                          r.seed,
                                          {r.max_degree, r.keep_zero_pairs != 0},
                                          r.squares != 0};
    PeriodicAlphaDiagram made = {};
    QuotientCycles cycles = {};
    const bool has_cycles = r.cycles != nullptr;
    const Status found = with_dimension(p.dim, [&](auto dimension) {
        return alpha_of_periodic_points<decltype(dimension)::value>(wanted, {context->arena, monitor}, &made,
                                                                    has_cycles ? &cycles : nullptr);
    });
    const Status status = watch.heed(found);
    if (status != Status::ok) return fail_with_periods(context, status, made);
    context->complete = true;
    KeptInput& input = context->input;
    const InputReport& read = made.report.input;
    input = {true, true, p.dim, read.rows, read.duplicates, read.fingerprint, made.distinct};
    if (r.weighting != nullptr)
        input.weighting = r.weighting->are_radii ? NETMESH_WEIGHTING_RADII : NETMESH_WEIGHTING_WEIGHTS;
    input.squares = r.squares != 0;
    input.hidden = Slice<std::uint32_t>::of(context->arena, made.hidden.rows, made.hidden.count);
    input.periods = p.lattice_count;
    input.copies = made.report.copies;
    input.moved = made.report.moved;
    keep_alpha(context, wanted.diagram, made.found);
    if (has_cycles) keep_quotient(context, cycles);
    return finish(context, status);
}

}  // namespace

// Points spread evenly, a margin of three times their spacing around them, or few points and all copies that matter.
// Of each 64 bytes: its weight and place, that it is a copy of which by which translation, and marks of faces.
double plan_with_periods(const netmesh_request& r) {
    const double points = static_cast<double>(r.points.count);
    double side = 1;
    for (double cubes = 1; cubes < points; side += 0.125) {
        cubes = 1;
        for (std::uint32_t k = 0; k < r.points.dim; ++k) cubes *= side;
    }
    const double around = 1 + 5.8 / side, all = 3.2;
    double copies = points, in_all = points;
    for (std::uint32_t j = 0; j < r.points.lattice_count; ++j) in_all *= all;
    for (std::uint32_t j = 0; j < r.points.lattice_count; ++j) copies *= in_all < 3000 || around > all ? all : around;
    netmesh_request planned = r;
    planned.points.count = copies < NETMESH_POINTS_MAX ? static_cast<std::size_t>(copies) : NETMESH_POINTS_MAX;
    return plan_of_alpha(planned) + 64 * copies;
}

}  // namespace netmesh

extern "C" {
extern const netmesh_periods netmesh_periodic;
const netmesh_periods netmesh_periodic = {netmesh::settle_lattice, netmesh::diagram_with_periods};
}
