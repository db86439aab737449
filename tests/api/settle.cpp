// Requests that contradict themselves, or give what is not read: the field that each refusal names, and that the
// result that was there stays. The tables follow what settles requests (engine/api), refusal by refusal.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"
#include "refusals.hpp"

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

double one(void*, const double*) { return 1; }

constexpr double distance[] = {1};
netmesh_distances two_points() {
    auto distances = netmesh::sized<netmesh_distances>();
    distances.layout = NETMESH_DISTANCES_LOWER;
    distances.numbers = distance;
    distances.count = 2;
    return distances;
}
const netmesh_distances a_pair = two_points();

using R = netmesh_request;

// How a good request is made bad, by each of some numbers, and the field that is named.
struct Row {
    netmesh_field field;
    std::vector<double> numbers;
    void (*change)(R&, double);
};
Row row(netmesh_field field, void (*change)(R&, double)) { return {field, {0}, change}; }

// Without points.
void unsourced(R& r) { r.points = {}; }
void of_distances(R& r) {
    unsourced(r);
    r.distances = &a_pair;
    r.filter = &netmesh_filter_rips;
}
void of_simplices(R& r, const netmesh_simplices& simplices = an_edge) {
    unsourced(r);
    r.simplices = &simplices;
    r.filter = &netmesh_filter_simplices;
}
netmesh_simplices by_vertex_without_steps() {
    netmesh_simplices simplices = an_edge;
    simplices.by_vertex = 1;
    return simplices;
}
const netmesh_simplices unread_vertices = by_vertex_without_steps();
// A number for each point, which nobody reads.
void weighted(R& r) {
    static const double numbers[1] = {};
    r.points.weights = numbers;
    r.weighting = &netmesh_radii;
    r.filter = &netmesh_filter_alpha;
}
void seed(R& r, double x) { r.seed = static_cast<std::uint64_t>(x); }
void set_values(R& r, int values) { std::memcpy(&r.values, &values, sizeof values); }

// What is refused by netmesh_persist is no request to be settled, and has no plan.
void persist_refuses(Fixture& f, const R& good, const std::vector<Row>& rows) {
    auto detail = netmesh::sized<netmesh_detail>();
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const double x : rows[i].numbers) {
            INFO("row " << i << ", " << std::string(netmesh_field_text(rows[i].field)) << ", " << x);
            R bad = good, settled = netmesh::sized<R>();
            rows[i].change(bad, x);
            f.refused(netmesh_persist(f.c, &bad), rows[i].field);
            CHECK(netmesh_settle(&bad, &settled, &detail) == NETMESH_INVALID_ARGUMENT);
            CHECK(detail.field == rows[i].field);
            CHECK(detail.message[0] != 0);
            CHECK(netmesh_plan(&bad) == 0);
        }
}
void mesh_refuses(Fixture& f, const R& good, const std::vector<Row>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const double x : rows[i].numbers) {
            INFO("row " << i << ", " << std::string(netmesh_field_text(rows[i].field)) << ", " << x);
            R bad = good;
            rows[i].change(bad, x);
            f.refused(netmesh_mesh(f.c, &bad), rows[i].field);
            CHECK(netmesh_plan_mesh(&bad) == 0);
        }
}

// Goals and rules, each by itself.
const std::vector<Row> parts = {
    row(NETMESH_FIELD_RATIO, [](R& r, double) { r.goal.ratio = 3; }),
    row(NETMESH_FIELD_EPS, [](R& r, double) { r.goal.eps = 0.25; }),
    row(NETMESH_FIELD_THETA, [](R& r, double) { r.goal.theta = 0.1; }),
    row(NETMESH_FIELD_ERROR, [](R& r, double) { r.goal.error = 0.1; }),
    row(NETMESH_FIELD_FOCUS_RATIO, [](R& r, double) { r.goal.focus_ratio = 2; }),
    row(NETMESH_FIELD_FOCUS_FROM, [](R& r, double) { r.goal.focus_from = 1; }),
    row(NETMESH_FIELD_FOCUS_TO, [](R& r, double) { r.goal.focus_to = 2; }),
    row(NETMESH_FIELD_LONGER_THAN, [](R& r, double) { r.goal.longer_than = 2; }),
    row(NETMESH_FIELD_TAU, [](R& r, double) { r.mesh.tau = 3; }),
    row(NETMESH_FIELD_METHOD, [](R& r, double) { r.mesh.method = &netmesh_method_svr; }),
    row(NETMESH_FIELD_DOMAIN_FACTOR, [](R& r, double) { r.mesh.domain_factor = 2; }),
    row(NETMESH_FIELD_NET_SPACING, [](R& r, double) { r.mesh.net_spacing = 1; }),
    row(NETMESH_FIELD_SIZE_EPS, [](R& r, double) { r.mesh.sizes.eps = 0.5; }),
    row(NETMESH_FIELD_SIZE_AT_INPUTS, [](R& r, double) { r.mesh.sizes.at_inputs = 0.5; }),
    row(NETMESH_FIELD_SIZE_GROWTH, [](R& r, double) { r.mesh.sizes.growth = 0.5; }),
    row(NETMESH_FIELD_SIZES, [](R& r, double) { r.mesh.sizes.size = one; }),
    row(NETMESH_FIELD_FINISH, [](R& r, double) { r.mesh.finish = 1; }),
    row(NETMESH_FIELD_WHOLE_CELLS, [](R& r, double) { r.mesh.whole_cells = 1; }),
    row(NETMESH_FIELD_AUDIT, [](R& r, double) { r.mesh.audit = NETMESH_AUDIT_QUALITY; }),
};
// All but those of some fields.
std::vector<Row> parts_without(std::initializer_list<netmesh_field> fields) {
    std::vector<Row> left;
    for (const Row& part : parts) {
        bool is_read = false;
        for (const netmesh_field field : fields) is_read = is_read || part.field == field;
        if (!is_read) left.push_back(part);
    }
    return left;
}

// Of points and the filter complete, unless a row says otherwise.
const std::vector<Row> bad_diagrams = {
    // source
    row(NETMESH_FIELD_POINTS, [](R& r, double) { r.distances = &a_pair; }),
    row(NETMESH_FIELD_POINTS, [](R& r, double) { r.simplices = &an_edge; }),
    row(NETMESH_FIELD_POINTS, [](R& r, double) { of_distances(r), r.simplices = &an_edge; }),
    row(NETMESH_FIELD_DIM, [](R& r, double) { r.points.dim = 0, r.points.count = 0; }),
    row(NETMESH_FIELD_DIM, [](R& r, double) { r.points.dim = 0, r.points.coordinates = nullptr; }),
    row(NETMESH_FIELD_DIM,
        [](R& r, double) { r.filter = &netmesh_filter_rips, r.points.dim = NETMESH_RIPS_DIM_MAX + 1; }),
    // filter
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = nullptr; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { unsourced(r), r.filter = nullptr; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_simplices; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { unsourced(r), r.filter = &netmesh_filter_simplices; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { of_simplices(r), r.filter = &netmesh_filter_rips; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { of_distances(r), r.filter = &netmesh_filter_cech; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { of_distances(r), r.filter = &netmesh_filter_auto; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { of_distances(r), r.filter = &netmesh_filter_simplices; }),
    // values
    {NETMESH_FIELD_VALUES, {-1, 3}, [](R& r, double x) { set_values(r, static_cast<int>(x)); }},
    {NETMESH_FIELD_VALUES,
     {-1, 3},
     [](R& r, double x) { r.filter = &netmesh_filter_rips, set_values(r, static_cast<int>(x)); }},
    row(NETMESH_FIELD_VALUES,
        [](R& r, double) { r.filter = &netmesh_filter_alpha, r.values = NETMESH_VALUES_THESIS; }),
    row(NETMESH_FIELD_VALUES, [](R& r, double) { r.filter = &netmesh_filter_auto, r.values = NETMESH_VALUES_THESIS; }),
    row(NETMESH_FIELD_VALUES, [](R& r, double) { r.filter = &netmesh_filter_rips, r.values = NETMESH_VALUES_THESIS; }),
    row(NETMESH_FIELD_VALUES, [](R& r, double) { r.filter = &netmesh_filter_cech, r.values = NETMESH_VALUES_THESIS; }),
    row(NETMESH_FIELD_VALUES,
        [](R& r, double) { r.filter = &netmesh_filter_barycentric_cech, r.values = NETMESH_VALUES_THESIS; }),
    row(NETMESH_FIELD_VALUES, [](R& r, double) { of_distances(r), r.values = NETMESH_VALUES_THESIS; }),
    row(NETMESH_FIELD_VALUES, [](R& r, double) { of_simplices(r), r.values = NETMESH_VALUES_THESIS; }),
    // neighbours
    row(NETMESH_FIELD_K, [](R& r, double) { r.k = 1; }),
    row(NETMESH_FIELD_K, [](R& r, double) { r.filter = &netmesh_filter_alpha, r.k = 1; }),
    row(NETMESH_FIELD_K, [](R& r, double) { r.filter = &netmesh_filter_auto, r.k = 1; }),
    row(NETMESH_FIELD_K, [](R& r, double) { r.filter = &netmesh_filter_rips, r.k = 1; }),
    row(NETMESH_FIELD_K, [](R& r, double) { of_simplices(r), r.k = 1; }),
    row(NETMESH_FIELD_K_LAST, [](R& r, double) { r.k_last = 2; }),
    row(NETMESH_FIELD_K_LAST, [](R& r, double) { r.filter = &netmesh_filter_knn, r.k_last = 2; }),
    row(NETMESH_FIELD_K_LAST, [](R& r, double) { r.vines = &netmesh_vines, r.k_last = 2; }),
    row(NETMESH_FIELD_K_LAST,
        [](R& r, double) { of_simplices(r, two_steps), r.vines = &netmesh_vines, r.k_last = 2; }),
    row(NETMESH_FIELD_K_LAST,
        [](R& r, double) { r.filter = &netmesh_filter_knn, r.vines = &netmesh_vines, r.k = 3, r.k_last = 2; }),
    // degree
    row(NETMESH_FIELD_MAX_DEGREE, [](R& r, double) { r.filter = &netmesh_filter_rips, r.max_degree = 31; }),
    row(NETMESH_FIELD_MAX_DEGREE, [](R& r, double) { r.filter = &netmesh_filter_cech, r.max_degree = 31; }),
    row(NETMESH_FIELD_MAX_DEGREE, [](R& r, double) { of_distances(r), r.max_degree = 31; }),
    row(NETMESH_FIELD_K,
        [](R& r, double) { r.filter = &netmesh_filter_barycentric_cech, r.k = 31, r.max_degree = 0; }),
    row(NETMESH_FIELD_MAX_DEGREE,
        [](R& r, double) { r.filter = &netmesh_filter_barycentric_cech, r.k = 30, r.max_degree = 1; }),
    // threshold and function
    {NETMESH_FIELD_THRESHOLD,
     {-1, -infinite, not_a_number},
     [](R& r, double x) { r.filter = &netmesh_filter_rips, r.threshold = x; }},
    {NETMESH_FIELD_THRESHOLD, {-1, not_a_number}, [](R& r, double x) { of_distances(r), r.threshold = x; }},
    {NETMESH_FIELD_THRESHOLD, {-1, not_a_number, 0, 1}, [](R& r, double x) { r.threshold = x; }},
    {NETMESH_FIELD_THRESHOLD, {0, 1}, [](R& r, double x) { r.filter = &netmesh_filter_cech, r.threshold = x; }},
    {NETMESH_FIELD_THRESHOLD, {0, 1}, [](R& r, double x) { r.filter = &netmesh_filter_auto, r.threshold = x; }},
    {NETMESH_FIELD_THRESHOLD, {0, 1}, [](R& r, double x) { unsourced(r), r.threshold = x; }},
    row(NETMESH_FIELD_FUNCTION, [](R& r, double) { r.function = &a_function; }),
    row(NETMESH_FIELD_FUNCTION, [](R& r, double) { r.filter = &netmesh_filter_rips, r.function = &a_function; }),
    row(NETMESH_FIELD_FUNCTION, [](R& r, double) { r.filter = &netmesh_filter_function; }),
    // seed: where nothing is random
    {NETMESH_FIELD_SEED, {0, 7}, [](R& r, double x) { r.filter = &netmesh_filter_rips, seed(r, x); }},
    {NETMESH_FIELD_SEED, {0, 7}, [](R& r, double x) { r.filter = &netmesh_filter_cech, seed(r, x); }},
    {NETMESH_FIELD_SEED, {7}, [](R& r, double x) { r.filter = &netmesh_filter_barycentric_cech, seed(r, x); }},
    {NETMESH_FIELD_SEED, {7}, [](R& r, double x) { r.filter = &netmesh_filter_barycentric_rips, seed(r, x); }},
    {NETMESH_FIELD_SEED, {7}, [](R& r, double x) { of_distances(r), seed(r, x); }},
    {NETMESH_FIELD_SEED, {7}, [](R& r, double x) { of_simplices(r), seed(r, x); }},
    {NETMESH_FIELD_SEED, {0, 7}, [](R& r, double x) { unsourced(r), seed(r, x); }},
    {NETMESH_FIELD_SEED, {7}, [](R& r, double x) { unsourced(r), r.filter = &netmesh_filter_alpha, seed(r, x); }},
    // weights
    {NETMESH_FIELD_SQUARES, {1, 2}, [](R& r, double x) { r.squares = std::uint32_t(x); }},
    {NETMESH_FIELD_SQUARES, {2}, [](R& r, double x) { weighted(r), r.squares = std::uint32_t(x); }},
    row(NETMESH_FIELD_WEIGHTING, [](R& r, double) { weighted(r), r.weighting = nullptr; }),
    row(NETMESH_FIELD_WEIGHTING, [](R& r, double) { weighted(r), unsourced(r); }),
    row(NETMESH_FIELD_WEIGHTING, [](R& r, double) { weighted(r), r.filter = &netmesh_filter_complete; }),
    row(NETMESH_FIELD_WEIGHTING, [](R& r, double) { weighted(r), r.filter = &netmesh_filter_rips; }),
    row(NETMESH_FIELD_WEIGHTING, [](R& r, double) { weighted(r), r.filter = &netmesh_filter_cech; }),
    row(NETMESH_FIELD_WEIGHTING, [](R& r, double) { weighted(r), r.filter = &netmesh_filter_scales; }),
    row(NETMESH_FIELD_WEIGHT_STRIDE_BYTES, [](R& r, double) { r.points.weight_stride_bytes = 8; }),
    {NETMESH_FIELD_WEIGHT_STRIDE_BYTES,
     {1, 4, 6, 9},
     [](R& r, double x) { weighted(r), r.points.weight_stride_bytes = std::size_t(x); }},
    row(NETMESH_FIELD_BOUNDS, [](R& r, double) { weighted(r), r.bounds = &netmesh_bounds; }),
    row(NETMESH_FIELD_CYCLES, [](R& r, double) { weighted(r), r.cycles = &netmesh_cycles; }),
    row(NETMESH_FIELD_BOUNDS,
        [](R& r, double) { weighted(r), r.filter = &netmesh_filter_auto, r.bounds = &netmesh_bounds; }),
    row(NETMESH_FIELD_METHOD, [](R& r, double) { weighted(r), r.mesh.method = &netmesh_method_svr; }),
    // for a function that is not there
    row(NETMESH_FIELD_SIZES, [](R& r, double) { r.mesh.sizes.user = &r; }),
    row(NETMESH_FIELD_SIZES, [](R& r, double) { r.filter = &netmesh_filter_alpha, r.mesh.sizes.user = &r; }),
    row(NETMESH_FIELD_MONITOR, [](R& r, double) { r.monitor.user = &r; }),
    // accuracy
    row(NETMESH_FIELD_THETA, [](R& r, double) { r.goal.theta = 0.1; }),
    row(NETMESH_FIELD_THETA, [](R& r, double) { r.filter = &netmesh_filter_tight, r.goal.theta = 0.1; }),
    row(NETMESH_FIELD_EPS, [](R& r, double) { r.goal.eps = 0.25; }),
    {NETMESH_FIELD_EPS,
     {-1, 0.75, not_a_number, infinite},
     [](R& r, double x) { r.filter = &netmesh_filter_tight, r.goal.eps = x; }},
    row(NETMESH_FIELD_EPS,
        [](R& r, double) { r.filter = &netmesh_filter_tight, r.goal.eps = 0.5, r.goal.ratio = 2; }),
    // flags, and what later versions may give a meaning
    {NETMESH_FIELD_KEEP_ZERO_PAIRS, {2, 4294967295}, [](R& r, double x) { r.keep_zero_pairs = std::uint32_t(x); }},
    {NETMESH_FIELD_FINISH, {2}, [](R& r, double x) { r.mesh.finish = std::uint32_t(x); }},
    {NETMESH_FIELD_WHOLE_CELLS, {2}, [](R& r, double x) { r.mesh.whole_cells = std::uint32_t(x); }},
    {NETMESH_FIELD_KEEP_MESH, {2}, [](R& r, double x) { r.keep_mesh = std::uint32_t(x); }},
    {NETMESH_FIELD_REQUEST, {1}, [](R& r, double x) { r.mesh.reserved = std::uint32_t(x); }},
    // ratio
    {NETMESH_FIELD_RATIO,
     {1.41429, 1.4142135623730951, 1, -1, not_a_number, infinite},
     [](R& r, double x) { r.goal.ratio = x; }},
    row(NETMESH_FIELD_RATIO, [](R& r, double) { r.goal.ratio = 3, r.mesh.method = &netmesh_method_svr; }),
    row(NETMESH_FIELD_RATIO, [](R& r, double) { r.goal.ratio = 3, r.mesh.method = &netmesh_method_refine; }),
    row(NETMESH_FIELD_RATIO, [](R& r, double) { r.goal.ratio = 3, r.values = NETMESH_VALUES_THESIS; }),
    row(NETMESH_FIELD_RATIO, [](R& r, double) { r.goal.ratio = 3, r.filter = &netmesh_filter_basic; }),
    row(NETMESH_FIELD_RATIO, [](R& r, double) { r.goal.ratio = 3, r.filter = &netmesh_filter_knn; }),
    row(NETMESH_FIELD_TAU, [](R& r, double) { r.goal.ratio = 3, r.mesh.tau = 3; }),
    {NETMESH_FIELD_TAU, {2, -1, not_a_number, infinite}, [](R& r, double x) { r.mesh.tau = x; }},
    row(NETMESH_FIELD_SIZE_EPS, [](R& r, double) { r.goal.ratio = 3, r.mesh.sizes.eps = 1; }),
    row(NETMESH_FIELD_SIZE_AT_INPUTS, [](R& r, double) { r.mesh.sizes.at_inputs = 1; }),
    row(NETMESH_FIELD_DOMAIN_FACTOR, [](R& r, double) { r.goal.ratio = 3, r.mesh.domain_factor = 2; }),
    row(NETMESH_FIELD_WHOLE_CELLS,
        [](R& r, double) { r.mesh.method = &netmesh_method_svr, r.mesh.whole_cells = 1; }),
    row(NETMESH_FIELD_WHOLE_CELLS, [](R& r, double) { r.filter = &netmesh_filter_basic, r.mesh.whole_cells = 1; }),
    // scales of interest
    row(NETMESH_FIELD_FOCUS_RATIO, [](R& r, double) { r.goal.focus_from = 1; }),
    {NETMESH_FIELD_FOCUS_RATIO,
     {1, 3, 4, -1, not_a_number},
     [](R& r, double x) { r.goal.ratio = 3, r.goal.focus_ratio = x, r.goal.focus_from = 1, r.goal.focus_to = 2; }},
    {NETMESH_FIELD_FOCUS_FROM,
     {0, -1, not_a_number, infinite},
     [](R& r, double x) { r.goal.ratio = 3, r.goal.focus_ratio = 2, r.goal.focus_from = x, r.goal.focus_to = 2; }},
    {NETMESH_FIELD_FOCUS_TO,
     {0, 1, -1, not_a_number},
     [](R& r, double x) { r.goal.ratio = 3, r.goal.focus_ratio = 2, r.goal.focus_from = 1, r.goal.focus_to = x; }},
    row(NETMESH_FIELD_FOCUS_RATIO,
        [](R& r, double) { r.mesh.method = &netmesh_method_svr, r.goal.focus_ratio = 2; }),
    row(NETMESH_FIELD_FOCUS_TO, [](R& r, double) { r.filter = &netmesh_filter_knn, r.goal.focus_to = 2; }),
    // error
    row(NETMESH_FIELD_ERROR, [](R& r, double) { r.goal.error = 0.1; }),
    {NETMESH_FIELD_ERROR,
     {-1, not_a_number, infinite},
     [](R& r, double x) {
         r.filter = &netmesh_filter_function, r.function = &a_function;
         r.goal.error = x;
     }},
    row(NETMESH_FIELD_VALUES,
        [](R& r, double) {
            r.filter = &netmesh_filter_function, r.function = &a_function;
            r.goal.error = 0.1, r.values = NETMESH_VALUES_CERTIFIED;
        }),
    // method
    row(NETMESH_FIELD_METHOD, [](R& r, double) { r.mesh.method = &netmesh_method_delaunay; }),
    row(NETMESH_FIELD_METHOD,
        [](R& r, double) { r.mesh.method = &netmesh_method_certificate, r.values = NETMESH_VALUES_THESIS; }),
    row(NETMESH_FIELD_FINISH, [](R& r, double) { r.mesh.method = &netmesh_method_netmesh; }),
    row(NETMESH_FIELD_FINISH, [](R& r, double) { r.mesh.method = &netmesh_method_svr, r.mesh.finish = 1; }),
    row(NETMESH_FIELD_METHOD, [](R& r, double) { r.mesh.method = &netmesh_method_thesis, r.mesh.finish = 1; }),
    row(NETMESH_FIELD_AUDIT, [](R& r, double) { r.mesh.audit = NETMESH_AUDIT_LOCATION; }),
    row(NETMESH_FIELD_AUDIT,
        [](R& r, double) { r.mesh.method = &netmesh_method_svr, r.mesh.audit = NETMESH_AUDIT_LOCATION; }),
    row(NETMESH_FIELD_AUDIT, [](R& r, double) { r.mesh.audit = 4; }),
    // wants
    row(NETMESH_FIELD_BOUNDS, [](R& r, double) { r.bounds = &netmesh_cycles; }),
    row(NETMESH_FIELD_CYCLES, [](R& r, double) { r.cycles = &netmesh_vines; }),
    row(NETMESH_FIELD_VINES, [](R& r, double) { r.filter = &netmesh_filter_knn, r.vines = &netmesh_bounds; }),
    row(NETMESH_FIELD_FIT, [](R& r, double) { r.filter = &netmesh_filter_rips, r.fit = &netmesh_bounds; }),
    row(NETMESH_FIELD_FIT, [](R& r, double) { r.filter = &netmesh_filter_alpha, r.fit = &netmesh_fit; }),
    row(NETMESH_FIELD_FIT, [](R& r, double) { r.filter = &netmesh_filter_auto, r.fit = &netmesh_fit; }),
    row(NETMESH_FIELD_FIT, [](R& r, double) { r.filter = &netmesh_filter_rips, r.fit = &netmesh_fit; }),
    row(NETMESH_FIELD_FIT, [](R& r, double) { r.filter = &netmesh_filter_scales, r.fit = &netmesh_fit; }),
    row(NETMESH_FIELD_FIT, [](R& r, double) { unsourced(r), r.fit = &netmesh_fit; }),
    row(NETMESH_FIELD_CYCLES,
        [](R& r, double) { r.filter = &netmesh_filter_barycentric_cech, r.cycles = &netmesh_cycles; }),
    row(NETMESH_FIELD_CYCLES,
        [](R& r, double) { r.filter = &netmesh_filter_barycentric_rips, r.cycles = &netmesh_cycles; }),
    row(NETMESH_FIELD_KEEP_MESH, [](R& r, double) { r.filter = &netmesh_filter_rips, r.keep_mesh = 1; }),
    row(NETMESH_FIELD_KEEP_MESH, [](R& r, double) { r.filter = &netmesh_filter_scales, r.keep_mesh = 1; }),
    row(NETMESH_FIELD_KEEP_MESH, [](R& r, double) { of_simplices(r), r.keep_mesh = 1; }),
    row(NETMESH_FIELD_STEP_COUNT, [](R& r, double) { of_simplices(r, two_steps); }),
    row(NETMESH_FIELD_STEP_COUNT, [](R& r, double) { of_simplices(r, unread_vertices); }),
    row(NETMESH_FIELD_STEP_COUNT, [](R& r, double) { of_simplices(r), r.vines = &netmesh_vines; }),
    row(NETMESH_FIELD_VINES, [](R& r, double) { r.vines = &netmesh_vines; }),
    row(NETMESH_FIELD_VINES, [](R& r, double) { r.filter = &netmesh_filter_alpha, r.vines = &netmesh_vines; }),
    row(NETMESH_FIELD_VINES, [](R& r, double) { r.filter = &netmesh_filter_auto, r.vines = &netmesh_vines; }),
    row(NETMESH_FIELD_VINES, [](R& r, double) { r.filter = &netmesh_filter_scales, r.vines = &netmesh_vines; }),
    row(NETMESH_FIELD_VINES, [](R& r, double) { r.filter = &netmesh_filter_rips, r.vines = &netmesh_vines; }),
    row(NETMESH_FIELD_VINES, [](R& r, double) { of_distances(r), r.vines = &netmesh_vines; }),
    row(NETMESH_FIELD_VINES,
        [](R& r, double) { r.filter = &netmesh_filter_knn, r.vines = &netmesh_vines, r.bounds = &netmesh_bounds; }),
    row(NETMESH_FIELD_VINES,
        [](R& r, double) { r.filter = &netmesh_filter_knn, r.vines = &netmesh_vines, r.cycles = &netmesh_cycles; }),
    row(NETMESH_FIELD_VINES,
        [](R& r, double) { r.filter = &netmesh_filter_knn, r.vines = &netmesh_vines, r.fit = &netmesh_fit; }),
    row(NETMESH_FIELD_VINES,
        [](R& r, double) { of_simplices(r, two_steps), r.vines = &netmesh_vines, r.cycles = &netmesh_cycles; }),
    row(NETMESH_FIELD_KEEP_ZERO_PAIRS,
        [](R& r, double) { r.filter = &netmesh_filter_knn, r.vines = &netmesh_vines, r.keep_zero_pairs = 1; }),
    row(NETMESH_FIELD_KEEP_ZERO_PAIRS,
        [](R& r, double) { of_simplices(r, two_steps), r.vines = &netmesh_vines, r.keep_zero_pairs = 1; }),
};

// Of the filter scales.
const std::vector<Row> bad_scales = {
    {NETMESH_FIELD_TAU, {2, -1, not_a_number, infinite}, [](R& r, double x) { r.mesh.tau = x; }},
    {NETMESH_FIELD_EPS, {-1, 0.75, not_a_number}, [](R& r, double x) { r.goal.eps = x; }},
    {NETMESH_FIELD_THETA, {-1, 0.25, not_a_number}, [](R& r, double x) { r.goal.theta = x; }},
    {NETMESH_FIELD_VALUES, {3}, [](R& r, double) { set_values(r, 3); }},
    {NETMESH_FIELD_RATIO, {-1, 1.88, infinite, not_a_number}, [](R& r, double x) { r.goal.ratio = x; }},
    row(NETMESH_FIELD_RATIO, [](R& r, double) { r.goal.theta = 0.01, r.goal.ratio = 1.4; }),
    row(NETMESH_FIELD_EPS, [](R& r, double) { r.goal.ratio = 2, r.goal.eps = 0.5; }),
    row(NETMESH_FIELD_TAU, [](R& r, double) { r.goal.ratio = 3, r.mesh.tau = 3; }),
};

// With fit.
const std::vector<Row> bad_fits = {
    {NETMESH_FIELD_RATIO, {1.2, -1, not_a_number, infinite}, [](R& r, double x) { r.goal.ratio = x; }},
    {NETMESH_FIELD_FOCUS_FROM,
     {0, -1, not_a_number, infinite},
     [](R& r, double x) { r.goal.focus_from = x, r.goal.focus_to = 1; }},
    {NETMESH_FIELD_FOCUS_TO,
     {0, 1, 2, not_a_number},
     [](R& r, double x) { r.goal.focus_from = 2, r.goal.focus_to = x; }},
    {NETMESH_FIELD_LONGER_THAN,
     {1, 0.5, -1, not_a_number, infinite},
     [](R& r, double x) { r.bounds = &netmesh_bounds, r.goal.longer_than = x; }},
    row(NETMESH_FIELD_BOUNDS, [](R& r, double) { r.goal.longer_than = 2; }),
    row(NETMESH_FIELD_LONGER_THAN,
        [](R& r, double) {
            r.filter = &netmesh_filter_knn;
            r.bounds = &netmesh_bounds, r.goal.longer_than = 2;
        }),
    row(NETMESH_FIELD_FOCUS_FROM,
        [](R& r, double) {
            r.bounds = &netmesh_bounds, r.goal.longer_than = 2;
            r.goal.focus_from = 1, r.goal.focus_to = 2;
        }),
    row(NETMESH_FIELD_VALUES, [](R& r, double) { set_values(r, 3); }),
    row(NETMESH_FIELD_FUNCTION, [](R& r, double) { r.filter = &netmesh_filter_function; }),
    row(NETMESH_FIELD_RATIO,
        [](R& r, double) { r.filter = &netmesh_filter_function, r.function = &a_function, r.goal.ratio = 3; }),
    row(NETMESH_FIELD_ERROR,
        [](R& r, double) { r.filter = &netmesh_filter_function, r.function = &a_function, r.goal.error = 0.1; }),
    {NETMESH_FIELD_FOCUS_FROM,
     {1},
     [](R& r, double x) {
         r.filter = &netmesh_filter_function, r.function = &a_function;
         r.goal.focus_from = x, r.goal.focus_to = 2;
     }},
    row(NETMESH_FIELD_METHOD,
        [](R& r, double) {
            r.filter = &netmesh_filter_function, r.function = &a_function;
            r.mesh.method = &netmesh_method_certificate;
        }),
};

// Vines of the filter barycentric-cech for k = 1 and 2.
const std::vector<Row> bad_ranges = {
    row(NETMESH_FIELD_VALUES, [](R& r, double) { set_values(r, 3); }),
    row(NETMESH_FIELD_K_LAST, [](R& r, double) { r.k = 3; }),
    row(NETMESH_FIELD_K_LAST, [](R& r, double) { r.k_last = 31, r.max_degree = 0; }),
    row(NETMESH_FIELD_MAX_DEGREE, [](R& r, double) { r.k_last = 30; }),
    row(NETMESH_FIELD_MAX_DEGREE, [](R& r, double) { r.max_degree = NETMESH_DEGREE_MAX; }),
    row(NETMESH_FIELD_K_LAST, [](R& r, double) { r.filter = &netmesh_filter_rips; }),
    row(NETMESH_FIELD_K_LAST, [](R& r, double) { r.filter = &netmesh_filter_cech; }),
};

// Of netmesh_mesh: without a filter, by SVR.
const std::vector<Row> bad_meshes = {
    row(NETMESH_FIELD_POINTS, [](R& r, double) { r.distances = &a_pair; }),
    row(NETMESH_FIELD_DIM, [](R& r, double) { unsourced(r); }),
    row(NETMESH_FIELD_DIM, [](R& r, double) { of_distances(r); }),
    row(NETMESH_FIELD_DIM, [](R& r, double) { of_simplices(r); }),
    row(NETMESH_FIELD_METHOD, [](R& r, double) { r.mesh.method = nullptr; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_auto; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_scales; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_rips; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_cech; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_barycentric_cech; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_barycentric_rips; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_simplices; }),
    {NETMESH_FIELD_VALUES, {-1, 3}, [](R& r, double x) { set_values(r, static_cast<int>(x)); }},
    row(NETMESH_FIELD_VALUES, [](R& r, double) { r.values = NETMESH_VALUES_THESIS; }),
    row(NETMESH_FIELD_FUNCTION, [](R& r, double) { r.filter = &netmesh_filter_function, r.goal.error = 0.1; }),
    row(NETMESH_FIELD_METHOD, [](R& r, double) { r.filter = &netmesh_filter_alpha; }),
    {NETMESH_FIELD_TAU, {2, -1, not_a_number, infinite}, [](R& r, double x) { r.mesh.tau = x; }},
    {NETMESH_FIELD_SIZE_EPS, {-1, not_a_number, infinite}, [](R& r, double x) { r.mesh.sizes.eps = x; }},
    {NETMESH_FIELD_SIZE_AT_INPUTS, {-1, not_a_number, infinite}, [](R& r, double x) { r.mesh.sizes.at_inputs = x; }},
    {NETMESH_FIELD_SIZE_GROWTH,
     {-1, not_a_number, infinite},
     [](R& r, double x) { r.mesh.sizes.at_inputs = 1, r.mesh.sizes.growth = x; }},
    row(NETMESH_FIELD_SIZE_GROWTH, [](R& r, double) { r.mesh.sizes.growth = 0.5; }),
    row(NETMESH_FIELD_SIZES, [](R& r, double) { r.mesh.sizes.user = &r; }),
    row(NETMESH_FIELD_MONITOR, [](R& r, double) { r.monitor.user = &r; }),
    {NETMESH_FIELD_THRESHOLD, {0, 1}, [](R& r, double x) { r.threshold = x; }},
    {NETMESH_FIELD_THRESHOLD, {0, 1}, [](R& r, double x) { r.filter = &netmesh_filter_complete, r.threshold = x; }},
    {NETMESH_FIELD_DOMAIN_FACTOR, {0.5, 9, not_a_number}, [](R& r, double x) { r.mesh.domain_factor = x; }},
    {NETMESH_FIELD_NET_SPACING,
     {-1, 0.015, 8.5, not_a_number, infinite},
     [](R& r, double x) { r.mesh.method = &netmesh_method_refine, r.mesh.net_spacing = x; }},
    row(NETMESH_FIELD_NET_SPACING, [](R& r, double) { r.mesh.net_spacing = 1; }),
    row(NETMESH_FIELD_DOMAIN_FACTOR,
        [](R& r, double) { r.mesh.method = &netmesh_method_refine, r.mesh.domain_factor = 2; }),
    {NETMESH_FIELD_EPS,
     {-1, 0.75, not_a_number},
     [](R& r, double x) { r.filter = &netmesh_filter_tight, r.goal.eps = x; }},
    row(NETMESH_FIELD_EPS, [](R& r, double) { r.goal.eps = 0.25; }),
    row(NETMESH_FIELD_THETA, [](R& r, double) { r.goal.theta = 0.1; }),
    row(NETMESH_FIELD_ERROR, [](R& r, double) { r.goal.error = 0.1; }),
    row(NETMESH_FIELD_LONGER_THAN, [](R& r, double) { r.goal.longer_than = 2; }),
    row(NETMESH_FIELD_FIT, [](R& r, double) { r.fit = &netmesh_fit; }),
    row(NETMESH_FIELD_FIT, [](R& r, double) { r.filter = &netmesh_filter_complete, r.fit = &netmesh_fit; }),
    // By the certificate.
    row(NETMESH_FIELD_RATIO, [](R& r, double) { r.goal.ratio = 3; }),
    {NETMESH_FIELD_RATIO,
     {1.4, -1, not_a_number, infinite},
     [](R& r, double x) { r.mesh.method = &netmesh_method_certificate, r.goal.ratio = x; }},
    row(NETMESH_FIELD_TAU,
        [](R& r, double) { r.mesh.method = &netmesh_method_certificate, r.goal.ratio = 3, r.mesh.tau = 3; }),
    row(NETMESH_FIELD_SIZES,
        [](R& r, double) { r.mesh.method = &netmesh_method_certificate, r.mesh.sizes.size = one; }),
    row(NETMESH_FIELD_FOCUS_FROM, [](R& r, double) { r.goal.focus_from = 1; }),
    row(NETMESH_FIELD_WHOLE_CELLS, [](R& r, double) { r.mesh.whole_cells = 1; }),
    row(NETMESH_FIELD_AUDIT,
        [](R& r, double) { r.mesh.method = &netmesh_method_certificate, r.mesh.audit = NETMESH_AUDIT_LOCATION; }),
    // With cages.
    row(NETMESH_FIELD_FINISH,
        [](R& r, double) { r.filter = &netmesh_filter_complete, r.mesh.method = &netmesh_method_netmesh; }),
    row(NETMESH_FIELD_SIZES, [](R& r, double) { r.mesh.method = &netmesh_method_netmesh, r.mesh.sizes.eps = 0.5; }),
    row(NETMESH_FIELD_SIZES,
        [](R& r, double) { r.mesh.method = &netmesh_method_netmesh, r.mesh.sizes.at_inputs = 0.5; }),
    row(NETMESH_FIELD_FINISH, [](R& r, double) { r.mesh.finish = 1; }),
    // Audits.
    row(NETMESH_FIELD_AUDIT, [](R& r, double) { r.mesh.audit = 4; }),
    row(NETMESH_FIELD_AUDIT,
        [](R& r, double) { r.mesh.method = &netmesh_method_refine, r.mesh.audit = NETMESH_AUDIT_QUALITY; }),
    row(NETMESH_FIELD_AUDIT, [](R& r, double) { r.mesh.sizes.eps = 0.5, r.mesh.audit = NETMESH_AUDIT_LOCATION; }),
    row(NETMESH_FIELD_AUDIT,
        [](R& r, double) { r.filter = &netmesh_filter_complete, r.mesh.audit = NETMESH_AUDIT_LOCATION; }),
};

// By the method thesis, D = 2, 3, 4.
const std::vector<Row> bad_theses = {
    {NETMESH_FIELD_TAU, {3.39, 2.5}, [](R& r, double x) { r.mesh.tau = x; }},
    row(NETMESH_FIELD_METHOD, [](R& r, double) { r.mesh.finish = 1, r.filter = &netmesh_filter_complete; }),
    row(NETMESH_FIELD_SIZE_EPS, [](R& r, double) { r.mesh.finish = 1, r.mesh.sizes.eps = 0.5; }),
    {NETMESH_FIELD_AUDIT,
     {NETMESH_AUDIT_LOCATION, NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY},
     [](R& r, double x) { r.mesh.audit = static_cast<std::uint32_t>(x); }},
};

// What a mesh promises.
const std::vector<Row> bad_promises = {
    {NETMESH_FIELD_TAU, {2, -1, not_a_number, infinite}, [](R& r, double x) { r.mesh.tau = x; }},
    {NETMESH_FIELD_SIZE_EPS, {-1, not_a_number, infinite}, [](R& r, double x) { r.mesh.sizes.eps = x; }},
    {NETMESH_FIELD_RATIO, {-1, 1.4, not_a_number, infinite}, [](R& r, double x) { r.goal.ratio = x; }},
    row(NETMESH_FIELD_FOCUS_RATIO,
        [](R& r, double) { r.goal.ratio = 2, r.goal.focus_ratio = 3, r.goal.focus_from = 1, r.goal.focus_to = 2; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_rips; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_scales; }),
    row(NETMESH_FIELD_FILTER, [](R& r, double) { r.filter = &netmesh_filter_auto; }),
    row(NETMESH_FIELD_PROMISED, [](R& r, double) { r.points.dim = r.points.dim == 6 ? 2 : r.points.dim + 1; }),
    row(NETMESH_FIELD_POINTS, [](R& r, double) { r.simplices = &an_edge; }),
    row(NETMESH_FIELD_SIZES, [](R& r, double) { r.mesh.sizes.user = &r; }),
    row(NETMESH_FIELD_STRUCT_BYTES, [](R& r, double) { r.struct_bytes = 0; }),
};

}  // namespace

TEST_CASE("points and what is asked of meshes") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Fixture f(dim);
        const netmesh::Request good = f.session.mesh_request(f.points);
        f.needs_points(netmesh_mesh, f.session.delaunay_request(f.points));
        f.needs_points(netmesh_mesh, good);
        f.needs_points(netmesh_mesh, f.session.mesh_request(f.points, &netmesh_filter_complete));
        mesh_refuses(f, good, bad_meshes);
        netmesh::Request thesis = good;
        thesis.mesh.method = &netmesh_method_thesis;
        if (dim <= 4) mesh_refuses(f, thesis, bad_theses);
        if (dim > 4)
            mesh_refuses(f, good,
                         {row(NETMESH_FIELD_METHOD, [](R& r, double) { r.mesh.method = &netmesh_method_thesis; })});
        // A triangulation has no rules.
        const netmesh::Request delaunay = f.session.delaunay_request(f.points);
        mesh_refuses(f, delaunay, parts_without({NETMESH_FIELD_METHOD}));
        netmesh::Request alpha = delaunay;
        alpha.filter = &netmesh_filter_alpha;
        mesh_refuses(f, alpha, parts);
    }
}

TEST_CASE("what is asked of diagrams") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Fixture f(dim);
        const netmesh::Request good = on(f.points, f.session.plain(&netmesh_filter_complete));
        persist_refuses(f, good, bad_diagrams);
        netmesh::Request by = good;
        by.filter = &netmesh_filter_scales;
        persist_refuses(f, by, bad_scales);
        persist_refuses(
            f, by, parts_without({NETMESH_FIELD_RATIO, NETMESH_FIELD_EPS, NETMESH_FIELD_THETA, NETMESH_FIELD_TAU}));
        by = f.session.nested_request(f.points, &netmesh_filter_barycentric_cech, 2);
        persist_refuses(f, by, bad_ranges);
        by = good;
        by.fit = &netmesh_fit;
        persist_refuses(f, by, bad_fits);
        persist_refuses(f, by,
                        parts_without({NETMESH_FIELD_RATIO, NETMESH_FIELD_FOCUS_FROM, NETMESH_FIELD_FOCUS_TO,
                                       NETMESH_FIELD_LONGER_THAN, NETMESH_FIELD_WHOLE_CELLS}));
        // The block's size says how far a fit goes, its points how large k may be.
        by.filter = &netmesh_filter_knn;
        by.k = 1000000;
        f.refused(netmesh_persist(f.c, &by), NETMESH_FIELD_K);
    }
}

TEST_CASE("what few jobs read is refused by the others, which are told who does") {
    Fixture f(dimensions().front());
    const auto says = [&](const netmesh::Request& r, const char* who) {
        CHECK(netmesh_persist(f.c, &r) == NETMESH_INVALID_ARGUMENT);
        CHECK(std::string(f.session.detail().message).find(who) != std::string::npos);
    };
    netmesh::Request r = on(f.points, f.session.plain(&netmesh_filter_alpha));
    r.threshold = 0.5;
    says(r, "filter rips alone");
    r = on(f.points, f.session.plain(&netmesh_filter_rips));
    r.seed = 2;
    says(r, "triangulations and meshes");
    // Those that do.
    for (const netmesh_filter* const filter : {&netmesh_filter_alpha, &netmesh_filter_auto, &netmesh_filter_complete,
                                               &netmesh_filter_knn, &netmesh_filter_scales}) {
        r.filter = filter;
        CHECK(netmesh_settle(&r, &r, nullptr) == NETMESH_OK);
        CHECK(r.seed == 2);
        r = on(f.points, f.session.plain(&netmesh_filter_rips));
        r.seed = 2;
    }
    netmesh::Request mesh = f.session.delaunay_request(f.points);
    mesh.seed = 2;
    CHECK(netmesh_settle(&mesh, &mesh, nullptr) == NETMESH_OK);
    r.seed = 1;
    r.threshold = 0.5;
    CHECK(netmesh_settle(&r, &r, nullptr) == NETMESH_OK);
}

TEST_CASE("goals and rules where no mesh is made") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Fixture f(dim);
        netmesh::Request r = on(f.points, netmesh::Request());
        r.points.dim = static_cast<std::uint32_t>(dim);
        r.points.count = 3;
        for (const netmesh_filter* const filter :
             {&netmesh_filter_alpha, &netmesh_filter_auto, &netmesh_filter_rips, &netmesh_filter_cech,
              &netmesh_filter_barycentric_cech, &netmesh_filter_barycentric_rips}) {
            r.filter = filter;
            persist_refuses(f, r, parts);
        }
        r.filter = &netmesh_filter_alpha;
        r.mesh.method = &netmesh_method_delaunay;
        persist_refuses(f, r, parts);
        r.mesh.method = nullptr;
        of_distances(r);
        persist_refuses(f, r, parts);
        r.distances = nullptr;
        of_simplices(r);
        persist_refuses(f, r, parts);
        r.simplices = nullptr;
        // Of the mesh that is there.
        for (const netmesh_filter* const filter :
             {&netmesh_filter_complete, &netmesh_filter_knn, &netmesh_filter_tight}) {
            r.filter = filter;
            persist_refuses(f, r, parts);
        }
    }
}

TEST_CASE("points scale by scale, to fit, and by themselves") {
    for (const int dim : dimensions()) {
        Fixture f(dim);
        const Session& s = f.session;
        f.needs_points(netmesh_persist, on(f.points, s.plain(&netmesh_filter_complete)));
        f.needs_points(netmesh_persist, s.alpha_request(f.points));
        f.needs_points(netmesh_persist, s.auto_request(f.points));
        f.needs_points(netmesh_persist, s.scales_request(f.points));
        f.needs_points(netmesh_persist, s.fit_request(f.points));
        f.needs_points(netmesh_persist, s.points_request(f.points, &netmesh_filter_cech));
        f.needs_points(netmesh_persist, s.nested_request(f.points, &netmesh_filter_barycentric_cech, 2));
        const netmesh::Request rips = s.points_request(f.points, &netmesh_filter_rips);
        f.needs_request<R>(netmesh_persist, rips);
        f.needs_rows(netmesh_persist, rips);
    }
}

TEST_CASE("what a request is settled into stays as it is") {
    for (const int dim : dimensions()) {
        const inputs::Points points = inputs::uniform(dim, 3);
        netmesh::for_each_filter([&](const netmesh_filter_info& info) {
            CAPTURE(dim);
            CAPTURE(info.name);
            netmesh::Request open = on(points, Calls(dim).plain(info.filter));
            if (info.needs_function == 1) open.function = &a_function;
            netmesh_request settled, again;
            REQUIRE(netmesh::settle(open, &settled) == NETMESH_OK);
            REQUIRE(netmesh::settle(settled, &again) == NETMESH_OK);
            CHECK(std::memcmp(&settled, &again, sizeof settled) == 0);
            CHECK(settled.max_degree == (info.is_on_points == 1 ? 1u : static_cast<std::uint32_t>(dim) - 1));
            CHECK(settled.values == NETMESH_VALUES_CERTIFIED);
            CHECK(settled.k == info.needs_k);
            CHECK((settled.mesh.method != nullptr) == (info.is_on_mesh == 1));
            CHECK(netmesh_plan(&settled) == netmesh_plan(&open));
        });
    }
    netmesh::Request request(&netmesh_filter_complete);
    auto detail = netmesh::sized<netmesh_detail>();
    netmesh_request settled = {};
    CHECK(netmesh_settle(nullptr, &settled, &detail) == NETMESH_INVALID_ARGUMENT);
    CHECK(detail.field == NETMESH_FIELD_REQUEST);
    CHECK(netmesh_settle(&request, &settled, &detail) == NETMESH_INVALID_ARGUMENT);
    CHECK(detail.field == NETMESH_FIELD_RESULT);
    CHECK(netmesh_settle(&request, nullptr, &detail) == NETMESH_INVALID_ARGUMENT);
    CHECK(detail.field == NETMESH_FIELD_RESULT);
    CHECK(netmesh_settle(&request, &request, nullptr) == NETMESH_OK);
    CHECK(request.values == NETMESH_VALUES_CERTIFIED);
}

TEST_CASE("what is promised of a mesh") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Fixture f(dim);
        const Arrays arrays(f.session);
        auto analysis = netmesh::sized<netmesh_analysis>();
        netmesh::Request promised;
        promised.points.dim = static_cast<std::uint32_t>(dim);
        for (const Row& bad : bad_promises)
            for (const double x : bad.numbers) {
                INFO(std::string(netmesh_field_text(bad.field)) << ", " << x);
                netmesh_request changed = promised;
                bad.change(changed, x);
                auto check = netmesh::sized<netmesh_check_request>();
                check.promised = &changed;
                f.refused(netmesh_check(f.c, &check), bad.field);
                auto analyse = netmesh::sized<netmesh_analyse_request>();
                analyse.promised = &changed;
                f.refused(netmesh_analyse(f.c, &analyse, &analysis), bad.field);
                const netmesh_load_request load = arrays.load_request(changed);
                f.refused(netmesh_load(f.c, &load), bad.field);
            }
    }
}
