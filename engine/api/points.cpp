// Filters on the points themselves, and of data that is known by its distances.
#include "jobs/diagram_of_points.hpp"

#include "api/keep_complex.hpp"
#include "api/plan.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "filtration/filters.hpp"
#include "jobs/diagram_of_distances.hpp"
#include "jobs/points_vineyard.hpp"

namespace netmesh {
namespace {

Complaint settle_on_points(const Settling& s) {
    netmesh_request& r = s.r;
    if (!(r.threshold >= 0)) return {NETMESH_FIELD_THRESHOLD, "threshold is negative or NaN"};
    if (r.max_degree == NETMESH_OPEN) r.max_degree = 1;
    if (r.max_degree > points_degree_max) return {NETMESH_FIELD_MAX_DEGREE, "max_degree is above 30"};
    if (!s.has(filter_trait::needs_k)) return fine();
    const Complaint complaint = settle_neighbours(s);
    if (complaint.text != nullptr) return complaint;
    const std::uint32_t k = r.k_last != 0 ? r.k_last : r.k;
    if (k > points_degree_max) return {r.k_last != 0 ? NETMESH_FIELD_K_LAST : NETMESH_FIELD_K, "k is above 30"};
    return k + r.max_degree > points_degree_max ? Complaint{NETMESH_FIELD_MAX_DEGREE, "k + max_degree is above 30"}
                                                : fine();
}

PointsFilter points_filter_of(const netmesh_request& r) {
    return {r.filter->id, values_of(r.values), r.k, r.max_degree};
}

using MakeDiagram = Status(const PointsRequest&, const Work&, PointsDiagram*);

template <MakeDiagram make_diagram> netmesh_status run_by(netmesh_context* context) {
    const netmesh_request& r = context->request;
    if (source_of(r) != Source::points) return refuse(context, NETMESH_FIELD_POINTS, "this filter begins with points");
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    const PointsRequest wanted = {points_filter_of(r), rows_of(r.points), static_cast<std::uint32_t>(r.points.count),
                                  r.points.dim,        r.threshold,       r.keep_zero_pairs != 0,
                                  r.cycles != nullptr};
    PointsDiagram made;
    const Status status = watch.heed(make_diagram(wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_at_points(context, status, NETMESH_FIELD_K, made);
    KeptDiagram diagram;
    diagram.filter = r.filter->id;
    diagram.values = r.values;
    diagram.max_degree = r.max_degree;
    diagram.k = r.k;
    diagram.certified_ratio = diagram.certified_ratio_best = made.ratio;
    keep_diagram(context, input_of(r.points, made), diagram, made.diagram, made.is_listed ? &made.complex : nullptr);
    return finish(context, status);
}

// ---- distances ----

bool is_sparse(const netmesh_distances& distances) { return distances.layout == NETMESH_DISTANCES_SPARSE; }

Complaint complaint_about_size(const netmesh_distances& d, const netmesh_request& r) {
    if (!in_range(d.layout, NETMESH_DISTANCES_FULL, NETMESH_DISTANCES_FUNCTION))
        return {NETMESH_FIELD_LAYOUT, "unknown layout of distances"};
    const bool is_tree = r.max_degree == 0 && r.cycles == nullptr && !is_sparse(d);
    if (is_sparse(d) && d.count > RipsGraph::vertices_max) return {NETMESH_FIELD_POINT_COUNT, "more than 2^26 points"};
    if (!is_tree && !is_sparse(d) && d.count > RipsGraph::table_max)
        return {NETMESH_FIELD_POINT_COUNT, "more than 65,536 points"};
    const Complaint complaint = complaint_about_point_count(d.count);
    if (complaint.text != nullptr) return complaint;
    if (d.layout == NETMESH_DISTANCES_FULL && d.count > SIZE_MAX / 16 / d.count)
        return {NETMESH_FIELD_POINT_COUNT, "such a matrix does not fit an address space"};
    if (d.layout == NETMESH_DISTANCES_LOWER && d.count > SIZE_MAX / 8 / d.count)
        return {NETMESH_FIELD_POINT_COUNT, "such a triangle does not fit an address space"};
    if (is_sparse(d) && d.entry_count >= std::uint64_t{1} << 31)
        return {NETMESH_FIELD_ENTRY_COUNT, "2^31 entries or more"};
    return {};
}

Complaint complaint_about_numbers(const netmesh_distances& d) {
    if (d.evaluate == nullptr && d.user != nullptr) return {NETMESH_FIELD_EVALUATE, user_alone};
    if (is_sparse(d)) {
        if (d.entries == nullptr && d.entry_count > 0) return {NETMESH_FIELD_ENTRIES, "entries is null"};
    } else if (d.layout == NETMESH_DISTANCES_FUNCTION) {
        if (d.evaluate == nullptr) return {NETMESH_FIELD_EVALUATE, "evaluate is null"};
    } else if (d.numbers == nullptr && d.count > 1) {
        return {NETMESH_FIELD_NUMBERS, "numbers is null"};
    }
    return {};
}

Complaint read_distances(const netmesh_request& r, netmesh_distances* d) {
    const netmesh_field fault = read_struct(r.distances, d, sizeof *d);
    return fault != NETMESH_FIELD_NONE ? complaint_about_struct(fault) : complaint_about_size(*d, r);
}

// Requires distances that complaint_about_size finds nothing wrong with.
DistancesRequest wanted_of(const netmesh_distances& d, const netmesh_request& r) {
    DistancesRequest wanted = {};
    const std::uint32_t n = static_cast<std::uint32_t>(d.count);
    if (is_sparse(d))
        wanted.entries = {d.entries, static_cast<std::uint32_t>(d.entry_count), n};
    else
        wanted.source = {d.layout == NETMESH_DISTANCES_FULL    ? DistanceSource::Kind::full
                         : d.layout == NETMESH_DISTANCES_LOWER ? DistanceSource::Kind::lower
                                                               : DistanceSource::Kind::function,
                         n,
                         d.numbers,
                         0,
                         d.evaluate,
                         d.user};
    wanted.threshold = r.threshold;
    wanted.max_degree = r.max_degree;
    wanted.keep_zero = r.keep_zero_pairs != 0;
    wanted.representatives = r.cycles != nullptr;
    return wanted;
}

// By DistanceFlaw. Rows, not a table of pointers: on Arm that would hold the texts of all other tables, too.
constexpr char flaw_texts[][46] = {"more simplices than can be numbered",
                                   "a distance is negative",
                                   "a distance is NaN",
                                   "a distance is not the one the other way round",
                                   "the distance of a point to itself is not 0",
                                   "an entry names a point that does not exist"};
static_assert(sizeof flaw_texts / sizeof flaw_texts[0] == static_cast<int>(DistanceFlaw::no_point) + 1);

netmesh_status fail_at_distance(netmesh_context* context, Status status, const DistanceFault& fault, bool sparse) {
    if (status != Status::invalid_argument) return fail_and_clear(context, status);
    clear(context);
    const bool has_place = fault.flaw != DistanceFlaw::none;
    const netmesh_field field = sparse ? NETMESH_FIELD_ENTRIES : NETMESH_FIELD_NUMBERS;
    const netmesh_status result = refuse(
        context, {has_place ? field : NETMESH_FIELD_MAX_DEGREE, flaw_texts[static_cast<int>(fault.flaw)]}, fault.a);
    context->detail.said.index_b = fault.b;
    return result;
}

netmesh_status run_on_distances(netmesh_context* context) {
    const netmesh_request& r = context->request;
    netmesh_distances distances;
    Complaint complaint = read_distances(r, &distances);
    if (complaint.text == nullptr) complaint = complaint_about_numbers(distances);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    DistancesDiagram made;
    const DistancesRequest wanted = wanted_of(distances, r);
    const Status status = watch.heed(diagram_of_distances(wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_at_distance(context, status, made.fault, is_sparse(distances));
    KeptDiagram diagram;
    diagram.filter = NETMESH_FILTER_RIPS;
    diagram.max_degree = r.max_degree;
    diagram.certified_ratio = diagram.certified_ratio_best = 1;
    const std::uint32_t n = static_cast<std::uint32_t>(distances.count);
    const KeptInput input = {true, true, 0, n, 0, made.input_fingerprint, n};
    keep_diagram(context, input, diagram, made.diagram, wanted.representatives ? &made.complex : nullptr);
    return finish(context, status);
}

netmesh_status run_rips(netmesh_context* context) {
    return context->request.distances != nullptr ? run_on_distances(context)
                                                 : run_by<bounded_diagram_of_points>(context);
}

netmesh_status run_small_rips(netmesh_context* context) {
    return context->request.distances != nullptr ? run_on_distances(context) : run_by<diagram_of_points>(context);
}

netmesh_status run_on_points(netmesh_context* context) { return run_by<diagram_of_points>(context); }

}  // namespace

double plan_of_points(const netmesh_request& r) {
    const PointsFilter filter = points_filter_of(r);
    const std::uint64_t n = r.points.count;
    const bool is_bounded = !r.filter->is_small && r.cycles == nullptr && r.keep_zero_pairs == 0;
    const double bytes = r.vines != nullptr ? points_vineyard_bytes(filter, r.k_last, n, r.points.dim)
                         : is_bounded       ? bounded_points_bytes(filter, n, r.points.dim)
                                            : points_bytes(filter, n, r.points.dim);
    return bytes + sizeof(netmesh_context) + complex_overhead;
}

double plan_of_distances(const netmesh_request& r) {
    netmesh_distances distances;
    if (read_distances(r, &distances).text != nullptr) return 0;
    return distances_bytes(wanted_of(distances, r), distances.count) + sizeof(netmesh_context) + complex_overhead;
}

}  // namespace netmesh

using namespace netmesh;

#define NETMESH_ON_POINTS(name, id, reads, run, is_small)                                                              \
    extern const netmesh_filter netmesh_filter_##name;                                                                 \
    const netmesh_filter netmesh_filter_##name = {                                                                     \
        NETMESH_FILTER_##id, reads, run, settle_on_points, nullptr, nullptr, nullptr, is_small};

extern "C" {
NETMESH_ON_POINTS(rips, RIPS, given::threshold | given::cycles, run_rips, false)
NETMESH_ON_POINTS(rips_small, RIPS, given::threshold | given::cycles, run_small_rips, true)
NETMESH_ON_POINTS(cech, CECH, given::cycles, run_on_points, false)
NETMESH_ON_POINTS(barycentric_cech, BARYCENTRIC_CECH, given::k | given::k_last | given::vines, run_on_points, false)
NETMESH_ON_POINTS(barycentric_rips, BARYCENTRIC_RIPS, given::k | given::k_last | given::vines, run_on_points, false)
}

#undef NETMESH_ON_POINTS
