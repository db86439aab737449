#include "sweep/jobs.hpp"

#include <map>

#include "common/inputs.hpp"

namespace {

const inputs::Points& points_of(const Job& job) {
    static std::map<std::pair<int, std::size_t>, inputs::Points> made;
    inputs::Points& points = made[{job.dim, job.points}];
    if (points.empty()) points = inputs::uniform(job.dim, job.points, 40);
    return points;
}

netmesh_status delaunay(const Job& job, netmesh_context* context, netmesh_options* options) {
    return netmesh_delaunay(context, points_of(job).data(), job.points, options);
}

netmesh_status repeated(const Job& job, netmesh_context* context, netmesh_options* options) {
    static std::map<int, inputs::Points> made;
    inputs::Points& points = made[job.dim];
    if (points.empty()) points = inputs::repeated(job.dim, points_of(job), 3);
    return netmesh_delaunay(context, points.data(), 3 * job.points, options);
}

netmesh_status alpha(const Job& job, netmesh_context* context, netmesh_options* options) {
    const netmesh_status status = delaunay(job, context, options);
    if (status != NETMESH_OK) return status;
    return netmesh_persist(context, NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, 0, options);
}

netmesh_status audited(const Job& job, netmesh_context* context, netmesh_options* options) {
    netmesh_options copy = *options;
    copy.method = NETMESH_METHOD_NETMESH;
    copy.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
    return netmesh_mesh(context, points_of(job).data(), job.points, NETMESH_JOB_MESH, &copy);
}

netmesh_status alpha_low(const Job& job, netmesh_context* context, netmesh_options* options) {
    const netmesh_status status = delaunay(job, context, options);
    if (status != NETMESH_OK) return status;
    return netmesh_persist(context, NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED, 0, 0, options);
}

netmesh_status mesh(const Job& job, netmesh_context* context, netmesh_options* options) {
    return netmesh_mesh(context, points_of(job).data(), job.points, NETMESH_JOB_PERSIST, options);
}

template <netmesh_filter filter, netmesh_values values>
netmesh_status persist(const Job& job, netmesh_context* context, netmesh_options* options) {
    const netmesh_status status = mesh(job, context, options);
    return status != NETMESH_OK ? status : netmesh_persist(context, filter, values, NETMESH_DIM_MAX, 1, options);
}

netmesh_status check(const Job& job, netmesh_context* context, netmesh_options* options) {
    const netmesh_status status = mesh(job, context, options);
    return status != NETMESH_OK ? status : netmesh_check(context, NETMESH_CHECK_ALL, options);
}

netmesh_status basic_bounds(const Job& job, netmesh_context* context, netmesh_options* options) {
    const netmesh_status status = persist<NETMESH_FILTER_BASIC, NETMESH_VALUES_CERTIFIED>(job, context, options);
    return status != NETMESH_OK ? status : netmesh_bound_bars(context, options);
}

// With cages: points at distances that shrink twentyfold.
const inputs::Points& spread_points(const Job& job) {
    static std::map<std::pair<int, std::size_t>, inputs::Points> made;
    inputs::Points& points = made[{job.dim, job.points}];
    if (points.empty()) points = inputs::geometric(job.dim, 20, job.points - 1);
    return points;
}

netmesh_status hierarchy(const Job& job, netmesh_context* context, netmesh_options* options) {
    options->method = NETMESH_METHOD_NETMESH;
    return netmesh_mesh(context, spread_points(job).data(), job.points, NETMESH_JOB_MESH, options);
}

netmesh_status finished(const Job& job, netmesh_context* context, netmesh_options* options) {
    options->finish = 1;
    return hierarchy(job, context, options);
}

netmesh_status reference(const Job& job, netmesh_context* context, netmesh_options* options) {
    options->method = NETMESH_METHOD_REFINE;
    return netmesh_mesh(context, points_of(job).data(), job.points, NETMESH_JOB_MESH, options);
}

netmesh_status fine(const Job& job, netmesh_context* context, netmesh_options* options) {
    options->over_refine_eps = 0.5;
    return netmesh_mesh(context, points_of(job).data(), job.points, NETMESH_JOB_MESH, options);
}

// As fine as the block allows: a request refused gives another diagram, and a whole one.
netmesh_status fit(const Job& job, netmesh_context* context, netmesh_options* options) {
    return netmesh_fit(context, points_of(job).data(), job.points, NETMESH_DIM_MAX, 0, 1, options);
}

// Refined by the certificate.
netmesh_status by_ratio(const Job& job, netmesh_context* context, netmesh_options* options) {
    options->ratio = 3;
    return persist<NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED>(job, context, options);
}

// As hierarchy, with gaps that are just too narrow: Steiner points release a cage.
const inputs::Points& pairs_of(const Job& job) {
    static std::map<std::pair<int, std::size_t>, inputs::Points> made;
    inputs::Points& points = made[{job.dim, job.points}];
    const double gap[] = {0, 0, 0.07, 0x1.bda73b8bfa5b9p-4, 0.0625, 0x1.c1a8aed55a266p-4, 0x1.2bc89d5a28729p-4};
    const std::uint64_t seed[] = {0, 0, 1, 572, 641, 185, 795};
    if (points.empty()) points = inputs::close_pairs(job.dim, job.points / 2, gap[job.dim], seed[job.dim]);
    return points;
}

template <std::uint32_t audit>
netmesh_status released(const Job& job, netmesh_context* context, netmesh_options* options) {
    options->method = NETMESH_METHOD_NETMESH;
    options->tau = job.dim < 4 ? 2.2 : job.dim < 6 ? 6 : 8;
    options->audit = audit;
    return netmesh_mesh(context, pairs_of(job).data(), job.points, NETMESH_JOB_MESH, options);
}

// Refined by the certificate, more at some scales.
netmesh_status focused(const Job& job, netmesh_context* context, netmesh_options* options) {
    static std::map<int, inputs::Points> made;
    inputs::Points& points = made[job.dim];
    if (points.empty()) points = inputs::close_pairs(job.dim, job.points / 2, 0.02, 2);
    options->ratio = 4;
    options->focus_ratio = job.dim < 5 ? 2.6 : 3.5;
    options->focus_from = 0.05;
    options->focus_to = 4;
    return netmesh_mesh(context, points.data(), job.points, NETMESH_JOB_PERSIST, options);
}

double small_nearby(void*, const double* x) { return 0.3 + 0.5 * (x[0] < 0 ? -x[0] : x[0]); }

netmesh_status sized(const Job& job, netmesh_context* context, netmesh_options* options) {
    options->size = small_nearby;
    options->over_refine_eps = 0.8;
    return netmesh_mesh(context, points_of(job).data(), job.points, NETMESH_JOB_MESH, options);
}

// A mesh as a file would bring it.
struct Loaded {
    std::vector<double> vertices, domain;
    std::vector<std::uint8_t> markers;
    std::vector<std::uint32_t> cells;
    std::vector<netmesh_cage> cages;
};

Loaded mesh_to_load(const Job& job, netmesh_status (*make)(const Job&, netmesh_context*, netmesh_options*)) {
    Loaded loaded;
    std::vector<std::uint64_t> block((std::size_t{1} << 22) / 8 + 2);
    netmesh_options options;
    netmesh_options_init(&options, static_cast<std::uint32_t>(job.dim));
    void* const base = reinterpret_cast<void*>((reinterpret_cast<std::uintptr_t>(block.data()) + 15) / 16 * 16);
    netmesh_context* context;
    if (netmesh_init(base, std::size_t{1} << 22, &context) != NETMESH_OK || make(job, context, &options) != NETMESH_OK)
        return loaded;
    netmesh_vertex vertex;
    for (std::uint64_t i = 0; netmesh_get_vertex(context, i, &vertex) == NETMESH_OK; ++i) {
        loaded.vertices.insert(loaded.vertices.end(), vertex.coordinates, vertex.coordinates + job.dim);
        loaded.markers.push_back(static_cast<std::uint8_t>(vertex.marker));
    }
    netmesh_cell cell;
    for (std::uint64_t i = 0; netmesh_get_cell(context, i, &cell) == NETMESH_OK; ++i)
        loaded.cells.insert(loaded.cells.end(), cell.vertices, cell.vertices + job.dim + 1);
    netmesh_cage cage;
    for (std::uint64_t i = 0; netmesh_get_cage(context, i, &cage) == NETMESH_OK; ++i) loaded.cages.push_back(cage);
    netmesh_report report;
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    loaded.domain.assign(report.domain, report.domain + job.dim + 1);
    return loaded;
}

netmesh_status load_mesh(const Loaded& m, const Job& job, netmesh_context* context, netmesh_options* options) {
    return netmesh_load(context, m.vertices.data(), m.markers.data(), m.markers.size(), m.cells.data(),
                        m.cells.size() / (static_cast<std::size_t>(job.dim) + 1), m.domain.data(), options);
}

netmesh_status load(const Job& job, netmesh_context* context, netmesh_options* options) {
    static std::map<int, Loaded> made;
    Loaded& m = made[job.dim];
    if (m.markers.empty()) m = mesh_to_load(job, mesh);  // in the first run, when nothing is refused
    return load_mesh(m, job, context, options);
}

// Sizes and a ratio that any mesh keeps, asked of one that is loaded.
netmesh_status check_loaded(const Job& job, netmesh_context* context, netmesh_options* options) {
    options->over_refine_eps = 1e6;
    netmesh_status status = load(job, context, options);
    if (status == NETMESH_OK) status = netmesh_check(context, NETMESH_CHECK_QUALITY, options);
    options->over_refine_eps = 0;
    options->ratio = 1e6;
    return status == NETMESH_OK ? netmesh_check(context, NETMESH_CHECK_QUALITY, options) : status;
}

netmesh_status load_cages(const Job& job, netmesh_context* context, netmesh_options* options) {
    static std::map<int, Loaded> made;
    Loaded& m = made[job.dim];
    if (m.markers.empty()) m = mesh_to_load(job, hierarchy);
    const netmesh_status status = load_mesh(m, job, context, options);
    if (status != NETMESH_OK) return status;
    return netmesh_load_cages(context, m.cages.data(), m.cages.size(), options);
}

}  // namespace

const std::vector<Job>& all_jobs() {
    constexpr auto complete = persist<NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED>;
    constexpr auto basic = persist<NETMESH_FILTER_BASIC, NETMESH_VALUES_THESIS>;
    static const std::vector<Job> jobs = [] {
        std::vector<Job> list = {
            {"delaunay", 2, 24, delaunay},
            {"delaunay", 3, 14, delaunay},
            {"delaunay", 4, 9, delaunay},
            {"repeated", 2, 12, repeated},
            {"alpha", 2, 24, alpha},
            {"alpha", 3, 12, alpha},
            {"alpha", 4, 8, alpha},
            {"alpha-low", 2, 12, alpha_low},
            {"alpha-low", 3, 9, alpha_low},
            {"alpha-low", 4, 7, alpha_low},
            {"mesh", 2, 8, mesh},
            {"mesh", 3, 5, mesh},
            {"mesh", 4, 3, mesh},
            {"audited", 2, 4, audited, false, 40},
            {"audited", 3, 3, audited, true, 10},
            {"complete", 2, 6, complete},
            {"complete", 3, 4, complete},
            {"complete", 4, 2, complete},
            {"basic", 2, 6, basic},
            {"basic", 3, 4, basic},
            {"basic", 4, 2, basic},
            {"bounds-basic", 2, 5, basic_bounds, false, 0, true},
            {"bounds-basic", 3, 4, basic_bounds, false, 0, true},
            {"bounds-basic", 4, 3, basic_bounds, true, 0, true},
            {"check", 2, 6, check, false, 0, true},
            {"check", 3, 4, check, false, 0, true},
            {"check", 4, 2, check, false, 0, true},
            {"load", 2, 6, load},
            {"load", 3, 4, load},
            {"load", 4, 2, load},
            {"alpha", 3, 40, alpha, true},
            {"delaunay", 4, 30, delaunay, true},
            {"complete", 2, 30, complete, true},
            {"complete", 3, 9, complete, true},
            {"complete", 4, 4, complete, true},
            {"hierarchy", 2, 8, hierarchy},
            {"hierarchy", 3, 6, hierarchy},
            {"hierarchy", 4, 4, hierarchy, true, 50},
            {"finished", 2, 4, finished, false, 100},
            {"finished", 3, 4, finished, true, 50},
            {"finished", 4, 3, finished, true, 25},
            {"cages", 2, 8, load_cages},
            {"cages", 3, 6, load_cages},
            {"cages", 4, 4, load_cages, true, 50},
            {"reference", 2, 4, reference},
            {"reference", 3, 2, reference, true, 50},
            {"fine", 2, 4, fine, false, 200},
            {"fine", 3, 2, fine, true, 50},
            {"by-ratio", 2, 6, by_ratio},
            {"by-ratio", 3, 4, by_ratio},
            {"by-ratio", 4, 3, by_ratio, true, 100},
            {"check-loaded", 2, 5, check_loaded},
            {"check-loaded", 3, 3, check_loaded},
            {"check-loaded", 4, 2, check_loaded},
            {"fit", 2, 5, fit, false, 40, true, 64 << 10},
            {"fit", 3, 3, fit, true, 40, true, 64 << 10},
            {"fit", 4, 2, fit, true, 40, true, 80 << 10},
            {"focused", 2, 4, focused, false, 100},
            {"focused", 3, 4, focused, true, 100},
            {"focused", 4, 4, focused, true, 25},
            {"sized", 2, 3, sized, false, 100},
            {"sized", 3, 3, sized, true, 25},
            {"audited", 4, 3, audited, true, 25},
            {"released", 2, 8, released<0>, true, 100},
            {"released", 3, 8, released<0>, true, 50},
            {"released", 4, 8, released<0>, true, 50},
            {"released-audited", 3, 8, released<NETMESH_AUDIT_LOCATION>, true, 25},
            {"released-audited", 4, 8, released<NETMESH_AUDIT_LOCATION>, true, 25},
        };
        for (int dim = 5; dim <= 6; ++dim) {
            list.push_back({"delaunay", dim, 9, delaunay});
            list.push_back({"repeated", dim, 8, repeated});
            list.push_back({"alpha", dim, 8, alpha});
            list.push_back({"alpha-low", dim, 8, alpha_low});
            list.push_back({"complete", dim, 2, complete});
            list.push_back({"basic", dim, 2, basic});
            list.push_back({"check", dim, 2, check, true, 0, true});
            list.push_back({"by-ratio", dim, 2, by_ratio});
            list.push_back({"load", dim, 2, load});
            list.push_back({"hierarchy", dim, 4, hierarchy});
            list.push_back({"released", dim, 4, released<0>, true, 50});
            list.push_back({"released-audited", dim, 4, released<NETMESH_AUDIT_LOCATION>, true, 25});
            list.push_back({"audited", dim, 3, audited, true, 25});
            list.push_back({"focused", dim, 4, focused, true, 10});
            list.push_back({"sized", dim, 2, sized, true, 10});
            list.push_back({"cages", dim, 4, load_cages});
            list.push_back({"bounds-basic", dim, std::size_t(dim == 5 ? 8 : 2), basic_bounds, true, 40, true});
            list.push_back({"check-loaded", dim, 2, check_loaded});
            list.push_back({"fit", dim, 2, fit, true, 20, true, std::size_t{160} << 10});
        }
        add_diagram_jobs(&list);
        return list;
    }();
    return jobs;
}
