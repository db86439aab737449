// Jobs that end in diagrams, or in figures of a mesh.
#include <algorithm>
#include <map>
#include <set>

#include "common/inputs.hpp"
#include "sweep/jobs.hpp"

std::uint64_t figures_of_run = 0;

namespace {

void add_figure(std::uint64_t figure) { figures_of_run = (figures_of_run ^ figure) * 0x100000001B3u + 1; }

const inputs::Points& points_of(const Job& job) {
    static std::map<std::pair<int, std::size_t>, inputs::Points> made;
    inputs::Points& points = made[{job.dim, job.points}];
    if (points.empty()) points = inputs::uniform(job.dim, job.points, 40);
    return points;
}

netmesh_status mesh(const Job& job, netmesh_context* context, netmesh_options* options,
                    netmesh_job purpose = NETMESH_JOB_PERSIST) {
    return netmesh_mesh(context, points_of(job).data(), job.points, purpose, options);
}

template <netmesh_filter filter>
netmesh_status persist(const Job& job, netmesh_context* context, netmesh_options* options) {
    options->k = 2;
    const netmesh_status status = mesh(job, context, options);
    if (status != NETMESH_OK) return status;
    return netmesh_persist(context, filter, NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, 0, options);
}

// A cycle and bounds for each bar.
template <netmesh_filter filter>
netmesh_status represent(const Job& job, netmesh_context* context, netmesh_options* options) {
    netmesh_status status = persist<filter>(job, context, options);
    if (status == NETMESH_OK) status = netmesh_represent(context, options);
    return status;
}
// With pairs of no length the complex is listed simplex by simplex.
netmesh_status represent_all(const Job& job, netmesh_context* context, netmesh_options* options) {
    netmesh_status status = mesh(job, context, options);
    if (status != NETMESH_OK) return status;
    status = netmesh_persist(context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED, 1, 1, options);
    return status == NETMESH_OK ? netmesh_represent(context, options) : status;
}
netmesh_status represent_alpha(const Job& job, netmesh_context* context, netmesh_options* options) {
    netmesh_status status = netmesh_delaunay(context, points_of(job).data(), job.points, options);
    if (status != NETMESH_OK) return status;
    status = netmesh_persist(context, NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, 1, options);
    return status == NETMESH_OK ? netmesh_represent(context, options) : status;
}
netmesh_status bounds(const Job& job, netmesh_context* context, netmesh_options* options) {
    const netmesh_status status = persist<NETMESH_FILTER_KNN>(job, context, options);
    return status == NETMESH_OK ? netmesh_bound_bars(context, options) : status;
}

// Three points on a line, two minima of the distance to the second nearest: a bar that only a chain of covers can show.
netmesh_status chain(const Job& job, netmesh_context* context, netmesh_options* options) {
    inputs::Points points(3 * static_cast<std::size_t>(job.dim), 0.0);
    points[static_cast<std::size_t>(job.dim)] = 1;
    points[2 * static_cast<std::size_t>(job.dim)] = -1.3;
    options->k = 2;
    netmesh_status status = netmesh_mesh(context, points.data(), 3, NETMESH_JOB_PERSIST, options);
    if (status != NETMESH_OK) return status;
    status = netmesh_persist(context, NETMESH_FILTER_KNN, NETMESH_VALUES_CERTIFIED, 0, 0, options);
    return status == NETMESH_OK ? netmesh_bound_bars(context, options) : status;
}

double distance_to_origin(void*, const double* x) { return std::fabs(x[0]) + std::fabs(x[1]); }

netmesh_status function(const Job& job, netmesh_context* context, netmesh_options* options) {
    const netmesh_status status = mesh(job, context, options);
    if (status != NETMESH_OK) return status;
    const netmesh_function f = {distance_to_origin, nullptr, 1.5, 0, 1};
    return netmesh_persist_function(context, &f, NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, 0, options);
}

// Bits of the place, mixed: every star is irregular.
double rough(void*, const double* x) {
    double sum = 0;
    for (int k = 0; k < 2; ++k) sum += (x[k] - std::floor(x[k])) * 1e3;
    return sum - std::floor(sum);
}

netmesh_status irregular(const Job& job, netmesh_context* context, netmesh_options* options) {
    const netmesh_status status = mesh(job, context, options);
    if (status != NETMESH_OK) return status;
    const netmesh_function f = {rough, nullptr, 1e6, 0, 2};
    return netmesh_persist_function(context, &f, NETMESH_VALUES_THESIS, NETMESH_DIM_MAX, 1, options);
}

// The points above all other vertices: classes of degree D-1.
double rough_with_peaks(void* job, const double* x) {
    const Job& of = *static_cast<const Job*>(job);
    const inputs::Points& points = points_of(of);
    for (auto p = points.begin(); p != points.end(); p += of.dim)
        if (std::equal(p, p + of.dim, x)) return 1 + rough(nullptr, x);
    return rough(nullptr, x);
}
netmesh_status irregular_cycles(const Job& job, netmesh_context* context, netmesh_options* options) {
    netmesh_status status = mesh(job, context, options);
    if (status != NETMESH_OK) return status;
    const netmesh_function f = {rough_with_peaks, const_cast<Job*>(&job), 1e6, 0, 2};
    status = netmesh_persist_function(context, &f, NETMESH_VALUES_THESIS, NETMESH_DIM_MAX, 0, options);
    return status == NETMESH_OK ? netmesh_represent(context, options) : status;
}

netmesh_status vineyard(const Job& job, netmesh_context* context, netmesh_options* options) {
    const netmesh_status status = mesh(job, context, options);
    if (status != NETMESH_OK) return status;
    return netmesh_vineyard(context, NETMESH_FILTER_KNN, 1, 2, NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, options);
}

// Two scales far from each other.
netmesh_status scales(const Job& job, netmesh_context* context, netmesh_options* options) {
    inputs::Points points = points_of(job);
    for (std::size_t i = 0; i < points.size() / 2; ++i) points[i] *= 0x1p-30;
    return netmesh_persist_scales(context, points.data(), job.points, NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, 0,
                                  options);
}

template <netmesh_filter filter, int representatives, std::uint32_t degree = 1>
netmesh_status of_points(const Job& job, netmesh_context* context, netmesh_options* options) {
    return netmesh_persist_points(context, points_of(job).data(), job.points, filter, NETMESH_VALUES_CERTIFIED, 2,
                                  degree, 0, representatives, options);
}

// All faces of the simplices i, i + 1, i + 2, i + 5 modulo `points`, every one at the number of its vertices.
struct Complex {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint64_t> starts = {0};
    std::vector<double> values;
};
Complex complex_of(const Job& job) {
    std::set<std::set<std::uint32_t>> faces;
    const std::uint32_t n = static_cast<std::uint32_t>(job.points), step[] = {0, 1, 2, 5};
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t mask = 1; mask < 16; ++mask) {
            std::set<std::uint32_t> face;
            for (std::uint32_t k = 0; k < 4; ++k)
                if ((mask >> k & 1) != 0) face.insert((i + step[k]) % n);
            faces.insert(face);
        }
    Complex c;
    for (const auto& face : faces) {
        c.vertices.insert(c.vertices.end(), face.begin(), face.end());
        c.starts.push_back(c.vertices.size());
        c.values.push_back(static_cast<double>(face.size() + *face.rbegin() / 3));
    }
    return c;
}

template <int representatives>
netmesh_status homology(const Job& job, netmesh_context* context, netmesh_options* options) {
    static const Complex complex = complex_of(job);
    return netmesh_homology(context, complex.vertices.data(), complex.starts.data(), complex.values.data(),
                            complex.values.size(), 3, 0, representatives, options);
}

netmesh_status analyse(const Job& job, netmesh_context* context, netmesh_options* options) {
    figures_of_run = 0;
    netmesh_status status = mesh(job, context, options);
    if (status != NETMESH_OK) return status;
    netmesh_analysis analysis = {};
    analysis.struct_bytes = sizeof analysis;
    status = netmesh_analyse(context, NETMESH_ANALYSE_ALL, 30, options, &analysis);
    if (status == NETMESH_OK) add_figure(analysis.fingerprint);
    return status;
}

netmesh_status measure(const Job& job, netmesh_context* context, netmesh_options* options) {
    figures_of_run = 0;
    options->method = NETMESH_METHOD_NETMESH;
    netmesh_status status = mesh(job, context, options, NETMESH_JOB_MESH);
    if (status != NETMESH_OK) return status;
    netmesh_report report = {};
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    std::vector<double> numbers(report.vertices);
    std::vector<std::uint32_t> places(report.vertices);
    const auto add = [&](std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            add_figure(static_cast<std::uint64_t>(numbers[i] * 0x1p40));
            add_figure(places[i]);
        }
    };
    status = netmesh_measure_cells(context, numbers.data(), places.data());
    if (status != NETMESH_OK) return status;
    add(report.vertices);
    status = netmesh_well_paced_order(context, places.data(), numbers.data());
    if (status != NETMESH_OK) return status;
    add(job.points);
    status = netmesh_pace(context, places.data(), numbers.data());
    if (status == NETMESH_OK) add(job.points);
    return status;
}

}  // namespace

void add_diagram_jobs(std::vector<Job>* jobs) {
    constexpr auto knn = persist<NETMESH_FILTER_KNN>, kdistance = persist<NETMESH_FILTER_KDISTANCE>,
                   tight = persist<NETMESH_FILTER_TIGHT>;
    constexpr auto rips = of_points<NETMESH_FILTER_RIPS, 1>, rips_edges = of_points<NETMESH_FILTER_RIPS, 0>,
                   cech = of_points<NETMESH_FILTER_CECH, 1>,
                   barycentric_cech = of_points<NETMESH_FILTER_BARYCENTRIC_CECH, 0>,
                   barycentric_rips = of_points<NETMESH_FILTER_BARYCENTRIC_RIPS, 0>;
    for (int dim = 2; dim <= 6; ++dim) {
        const std::size_t few = dim == 2 ? 5 : dim == 3 ? 3 : 2;
        const bool large = dim >= 4;
        jobs->push_back({"knn", dim, few, knn, large});
        jobs->push_back({"kdistance", dim, few, kdistance, large});
        jobs->push_back({"tight", dim, few, tight, large});
        jobs->push_back({"bounds", dim, few, bounds, large, 0, true});
        jobs->push_back({"bounds-chain", dim, 3, chain, large, 0, true});
        jobs->push_back({"function", dim, few, function, large});
        static const std::size_t some[] = {0, 0, 6, 24, 10, 6, 4};
        jobs->push_back({"irregular", dim, some[dim], irregular, dim > 2, 60});
        static const std::size_t more[] = {0, 0, 16, 24, 20, 14, 9};
        jobs->push_back({"rough-cycles", dim, more[dim], irregular_cycles, true, dim == 3 ? 300 : 100, true});
        jobs->push_back({"scales-one", dim, 1, scales, true, 30});
        jobs->push_back({"cycles", dim, few, represent<NETMESH_FILTER_COMPLETE>, large, 100, true});
        jobs->push_back({"cycles-all", dim, few, represent_all, large, 40, true});
        jobs->push_back({"cycles-alpha", dim,
                         std::size_t(dim == 2   ? 16
                                     : dim == 3 ? 8
                                                : 7),
                         represent_alpha, large, 0, true});
        jobs->push_back({"vineyard", dim, few, vineyard, dim > 2, dim > 2 ? 40 : 100});
        jobs->push_back({"analyse", dim, few, analyse, large, 100});
        jobs->push_back({"measure", dim, few, measure, large, 100});
        jobs->push_back({"rips", dim, 9, rips});
        jobs->push_back({"rips-edges", dim, 9, rips_edges, dim > 3, 40});
        jobs->push_back({"cech", dim, 7, cech});
        jobs->push_back({"bary-cech", dim, 5, barycentric_cech});
        jobs->push_back({"bary-rips", dim, 5, barycentric_rips});
    }
    jobs->push_back({"homology", 2, 12, homology<0>});
    jobs->push_back({"homology-cycles", 2, 12, homology<1>});
    jobs->push_back({"rips-large", 2, 18, of_points<NETMESH_FILTER_RIPS, 0, 2>, true, 60});
    jobs->push_back({"rips-large", 3, 18, of_points<NETMESH_FILTER_RIPS, 1, 2>, true, 60});
    jobs->push_back({"scales", 2, 3, scales, true, 30});
    jobs->push_back({"scales", 3, 2, scales, true, 10});
}
