// Jobs that end in diagrams, or in figures of a mesh.
#include <algorithm>
#include <cmath>
#include <set>

#include "common/dimensions.hpp"
#include "sweep/jobs.hpp"

namespace {

netmesh_status mesh(Run& run) { return run.mesh_in_block(run.points(), &netmesh_filter_complete); }

netmesh_status persist(Run& run, const netmesh::Request& request) {
    const netmesh_status status = mesh(run);
    return status == NETMESH_OK ? run.persist(request) : status;
}
netmesh_status knn(Run& run) { return persist(run, persist_by(&netmesh_filter_knn, 2)); }
netmesh_status kdistance(Run& run) { return persist(run, persist_by(&netmesh_filter_kdistance, 2)); }
netmesh_status tight(Run& run) { return persist(run, persist_by(&netmesh_filter_tight)); }

netmesh_status bounds(Run& run) {
    const netmesh_status status = knn(run);
    return status == NETMESH_OK ? run.bound_bars() : status;
}

// Three points on a line, two minima of the distance to the second nearest: a bar that only a chain of covers can show.
netmesh_status chain(Run& run) {
    inputs::Points points(3 * static_cast<std::size_t>(run.job.dim), 0.0);
    points[static_cast<std::size_t>(run.job.dim)] = 1;
    points[2 * static_cast<std::size_t>(run.job.dim)] = -1.3;
    netmesh::Request components = persist_by(&netmesh_filter_knn, 2);
    components.max_degree = 0;
    netmesh_status status = run.mesh_in_block(points, &netmesh_filter_complete);
    if (status == NETMESH_OK) status = run.persist(components);
    return status == NETMESH_OK ? run.bound_bars() : status;
}

// A cycle for each bar.
netmesh_status represent(Run& run) {
    const netmesh_status status = persist(run, persist_by(&netmesh_filter_complete));
    return status == NETMESH_OK ? run.represent() : status;
}
// With pairs of no length the complex is listed simplex by simplex.
netmesh_status represent_all(Run& run) {
    netmesh::Request all = persist_by(&netmesh_filter_complete);
    all.max_degree = all.keep_zero_pairs = 1;
    const netmesh_status status = persist(run, all);
    return status == NETMESH_OK ? run.represent() : status;
}
netmesh_status represent_alpha(Run& run) {
    netmesh::Request all = persist_by(&netmesh_filter_alpha);
    all.keep_zero_pairs = 1;
    netmesh_status status = run.delaunay_in_block(run.points());
    if (status == NETMESH_OK) status = run.persist(all);
    return status == NETMESH_OK ? run.represent() : status;
}

double distance_to_origin(void*, const double* x) { return std::fabs(x[0]) + std::fabs(x[1]); }

// Bits of the place, mixed: every star is irregular.
double rough(void*, const double* x) {
    double sum = 0;
    for (int k = 0; k < 2; ++k) sum += (x[k] - std::floor(x[k])) * 1e3;
    return sum - std::floor(sum);
}
// The points above all other vertices: classes of degree D-1.
double rough_with_peaks(void* user, const double* x) {
    const Run& run = *static_cast<const Run*>(user);
    const inputs::Points& points = run.points();
    for (auto p = points.begin(); p != points.end(); p += run.job.dim)
        if (std::equal(p, p + run.job.dim, x)) return 1 + rough(nullptr, x);
    return rough(nullptr, x);
}

struct Sublevels {
    double (*evaluate)(void* user, const double* x);
    double lipschitz, cut;
};
netmesh_function function_of(Run& run, const Sublevels& of) {
    auto function = netmesh::sized<netmesh_function>();
    function.evaluate = of.evaluate;
    function.user = &run;
    function.lipschitz = of.lipschitz;
    function.cut = of.cut;
    return function;
}
netmesh_status persist_function(Run& run, const Sublevels& of, netmesh::Request request) {
    const netmesh_function function = function_of(run, of);
    request.function = &function;
    return persist(run, request);
}
netmesh_status function(Run& run) {
    return persist_function(run, {distance_to_origin, 1.5, 1}, persist_by(&netmesh_filter_function));
}
netmesh_status function_bounds(Run& run) {
    const netmesh_status status = function(run);
    return status == NETMESH_OK ? run.bound_bars(function_of(run, {distance_to_origin, 1.5, 1})) : status;
}
netmesh_status irregular(Run& run) {
    netmesh::Request all = persist_by(&netmesh_filter_function, 0, NETMESH_VALUES_THESIS);
    all.keep_zero_pairs = 1;
    return persist_function(run, {rough, 1e6, 2}, all);
}
netmesh_status irregular_cycles(Run& run) {
    const netmesh_status status = persist_function(run, {rough_with_peaks, 1e6, 2},
                                                   persist_by(&netmesh_filter_function, 0, NETMESH_VALUES_THESIS));
    return status == NETMESH_OK ? run.represent() : status;
}

netmesh_status vineyard(Run& run) {
    const netmesh_status status = mesh(run);
    return status == NETMESH_OK ? run.vineyard(&netmesh_filter_knn, 1, 2) : status;
}

// Two scales far from each other.
netmesh_status scales(Run& run) {
    inputs::Points points = run.points();
    for (std::size_t i = 0; i < points.size() / 2; ++i) points[i] *= 0x1p-30;
    return run.persist(run.scales_request(points));
}

// With all that is known of bars.
netmesh_status known_scales(Run& run) {
    inputs::Points points = run.points();
    for (std::size_t i = 0; i < points.size() / 2; ++i) points[i] *= 0x1p-30;
    netmesh::Request request = run.plain(&netmesh_filter_scales);
    request.set_points(run.dim(), points);
    request.goal.ratio = 3;
    request.bounds = &netmesh_bounds;
    request.cycles = &netmesh_cycles;
    return run.persist(request);
}

std::function<netmesh_status(Run&)> of_points(const netmesh_filter* filter, bool cycles, std::uint32_t degree = 1) {
    return [=](Run& run) {
        netmesh::Request request = run.points_request(run.points(), filter, 2, degree);
        request.cycles = cycles ? &netmesh_cycles : nullptr;
        return run.persist(request);
    };
}

// Of as many points as the job has, no metric.
std::function<netmesh_status(Run&)> of_distances(netmesh_distance_layout layout, std::uint32_t degree, bool cycles) {
    return [=](Run& run) {
        const std::uint32_t n = static_cast<std::uint32_t>(run.points().size()) / 2;
        std::vector<double> lower;
        std::vector<netmesh_distance_entry> entries;
        for (std::uint32_t i = 0; i < n; ++i) {
            for (std::uint32_t j = 0; j < i; ++j) {
                lower.push_back(1 + (i * 7 + j * 13) % 11);
                if ((i + j) % 5 != 0) entries.push_back({i, j, lower.back()});
            }
        }
        auto distances = netmesh::sized<netmesh_distances>();
        distances.layout = layout;
        distances.numbers = lower.data();
        distances.entries = entries.data();
        distances.entry_count = entries.size();
        distances.count = n;
        netmesh::Request request(&netmesh_filter_rips);
        request.distances = &distances;
        request.max_degree = degree;
        request.cycles = cycles ? &netmesh_cycles : nullptr;
        return run.persist(request);
    };
}

// Without a triangulation.
netmesh_status alpha_of_points(Run& run) {
    netmesh::Request request = run.alpha_request(run.points());
    request.keep_zero_pairs = run.job.dim == 3 ? 1 : 0;
    return run.persist(request);
}

// From points to all that is wanted of their diagram, in one call: with a triangulation that is kept, with a mesh.
netmesh_status alpha_at_once(Run& run) {
    netmesh::Request request = run.alpha_request(run.points());
    request.keep_mesh = 1;
    request.bounds = &netmesh_bounds;
    request.cycles = &netmesh_cycles;
    return run.persist(request);
}
netmesh_status complete_at_once(Run& run) {
    netmesh::Request request = run.plain(&netmesh_filter_complete);
    request.set_points(run.dim(), run.points());
    request.goal.ratio = 3;
    request.bounds = &netmesh_bounds;
    request.cycles = &netmesh_cycles;
    return run.persist(request);
}

// Three k of nested sets.
std::function<netmesh_status(Run&)> nested_sets(const netmesh_filter* filter) {
    return [=](Run& run) { return run.persist(run.nested_request(run.points(), filter, 3)); };
}

// All faces of the simplices i, i + 1, i + 2, i + 5 modulo `points`, every one at the number of its vertices.
struct Complex {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint64_t> starts = {0};
    std::vector<double> entries;
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
        c.entries.push_back(static_cast<double>(face.size() + *face.rbegin() / 3));
    }
    return c;
}

netmesh_simplices simplices_of(const Complex& complex) {
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.vertices = complex.vertices.data();
    simplices.starts = complex.starts.data();
    simplices.entries = complex.entries.data();
    simplices.simplex_count = complex.entries.size();
    return simplices;
}

netmesh_status homology_of_complex(Run& run, bool cycles) {
    static const Complex complex = complex_of(run.job);
    const netmesh_simplices simplices = simplices_of(complex);
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    request.max_degree = 3;
    request.cycles = cycles ? &netmesh_cycles : nullptr;
    return run.persist(request);
}
netmesh_status homology(Run& run) { return homology_of_complex(run, false); }
netmesh_status homology_cycles(Run& run) { return homology_of_complex(run, true); }

// Steps of numbers that change their order, by simplex and by vertex.
netmesh_status value_vineyard(Run& run, bool by_vertex) {
    static const Complex complex = complex_of(run.job);
    std::vector<double> values;
    for (std::uint32_t step = 0; step < 3; ++step)
        for (std::size_t i = 0; i < complex.entries.size(); ++i) {
            const std::uint64_t size = complex.starts[i + 1] - complex.starts[i];
            const double moved = static_cast<double>((complex.vertices[complex.starts[i]] + i * 7) * (step + 1) % 11);
            if (!by_vertex || size == 1) values.push_back(moved + static_cast<double>(16 * size));
        }
    netmesh_simplices simplices = simplices_of(complex);
    simplices.entries = values.data();
    simplices.step_count = 3;
    simplices.by_vertex = by_vertex ? 1 : 0;
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    request.max_degree = 2;
    return run.vineyard(request);
}
netmesh_status vines_of_simplices(Run& run) { return value_vineyard(run, false); }
netmesh_status vines_of_vertices(Run& run) { return value_vineyard(run, true); }

netmesh_status analyse(Run& run) {
    const netmesh_status status = mesh(run);
    if (status != NETMESH_OK) return status;
    netmesh_analysis analysis;
    const netmesh_status done = run.analyse(&analysis, NETMESH_ANALYSE_ALL, 30);
    if (done == NETMESH_OK) add_figure(analysis.fingerprint);
    return done;
}

netmesh_status measure(Run& run) {
    run.request.mesh.method = &netmesh_method_netmesh;
    netmesh_status status = run.mesh_in_block(run.points());
    if (status != NETMESH_OK) return status;
    const std::size_t vertices = run.report().mesh.vertices, inputs = run.job.points;
    std::vector<double> numbers(vertices);
    std::vector<std::uint32_t> places(vertices);
    const auto add = [&](std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            add_figure(static_cast<std::uint64_t>(numbers[i] * 0x1p40));
            add_figure(places[i]);
        }
    };
    status = netmesh_measure_cells(run.context, numbers.data(), places.data());
    if (status != NETMESH_OK) return status;
    add(vertices);
    std::vector<netmesh_voronoi> voronoi(vertices);
    voronoi[0].struct_bytes = sizeof(netmesh_voronoi);
    status = netmesh_measure_voronoi(run.context, voronoi.data());
    if (status != NETMESH_OK) return status;
    for (const netmesh_voronoi& cell : voronoi) add_figure(static_cast<std::uint64_t>(cell.beta * 0x1p20));
    std::vector<netmesh_ball> balls(run.report().mesh.cells);
    balls[0].struct_bytes = sizeof(netmesh_ball);
    status = netmesh_measure_balls(run.context, balls.data());
    if (status != NETMESH_OK) return status;
    for (const netmesh_ball& ball : balls) add_figure(ball.meets);
    if (const std::size_t cages = run.report().mesh.hierarchy.cages) {
        std::vector<netmesh_weighted_cell> weighted(cages);
        weighted[0].struct_bytes = sizeof(netmesh_weighted_cell);
        status = netmesh_weighted_cells(run.context, weighted.data());
        if (status != NETMESH_OK) return status;
        for (const netmesh_weighted_cell& cell : weighted)
            add_figure(static_cast<std::uint64_t>(cell.in_radius * 0x1p40));
    }
    status = netmesh_well_paced_order(run.context, places.data(), numbers.data());
    if (status != NETMESH_OK) return status;
    add(inputs);
    status = netmesh_pace(run.context, places.data(), numbers.data());
    if (status == NETMESH_OK) add(inputs);
    return status;
}

}  // namespace

void add_diagram_jobs(std::vector<Job>* jobs) {
    for (const int dim : dimensions()) {
        const std::size_t few = dim == 2 ? 5 : dim == 3 ? 3 : 2;
        const bool large = dim >= 4;
        jobs->push_back(Job{"knn", dim, few, knn}.large(large));
        jobs->push_back(Job{"kdistance", dim, few, kdistance}.large(large));
        jobs->push_back(Job{"tight", dim, few, tight}.large(large));
        jobs->push_back(Job{"bounds", dim, few, bounds}.keeping_diagram().large(large));
        jobs->push_back(Job{"bounds-chain", dim, 3, chain}.keeping_diagram().large(large));
        jobs->push_back(Job{"function", dim, few, function}.large(large));
        jobs->push_back(Job{"function-bounds", dim, few, function_bounds}.keeping_diagram().large(large).tries(100));
        const std::size_t some = by_dimension<std::size_t>(dim, {6, 24, 10, 6, 4});
        jobs->push_back(Job{"irregular", dim, some, irregular}.large(dim > 2).tries(60));
        const std::size_t more = by_dimension<std::size_t>(dim, {16, 24, 20, 14, 9});
        const Job rough_cycles = Job{"rough-cycles", dim, more, irregular_cycles}.keeping_diagram().large();
        jobs->push_back(rough_cycles.tries(dim == 3 ? 300 : 100));
        jobs->push_back(Job{"scales-one", dim, 1, scales}.large().tries(30));
        jobs->push_back(Job{"scales-known", dim, some, known_scales}.large(dim > 2).tries(60));
        jobs->push_back(Job{"cycles", dim, few, represent}.keeping_diagram().large(large).tries(100));
        jobs->push_back(Job{"cycles-all", dim, few, represent_all}.keeping_diagram().large(large).tries(40));
        const std::size_t alpha = by_dimension<std::size_t>(dim, {16, 8, 7, 7, 7});
        jobs->push_back(Job{"cycles-alpha", dim, alpha, represent_alpha}.keeping_diagram().large(large));
        jobs->push_back(Job{"vineyard", dim, few, vineyard}.large(dim > 2).tries(dim > 2 ? 40 : 100));
        jobs->push_back(Job{"analyse", dim, few, analyse}.large(large).tries(100));
        jobs->push_back(Job{"measure", dim, few, measure}.large(large).tries(100));
        jobs->push_back({"alpha-of-points", dim, dim < 4 ? 16u : 8u, alpha_of_points});
        jobs->push_back(Job{"alpha-at-once", dim, alpha, alpha_at_once}.keeping_diagram().large(large));
        jobs->push_back(Job{"complete-at-once", dim, few, complete_at_once}.keeping_diagram().large(large).tries(100));
        jobs->push_back({"rips", dim, 9, of_points(&netmesh_filter_rips, true)});
        jobs->push_back(Job{"rips-edges", dim, 9, of_points(&netmesh_filter_rips, false)}.large(dim > 3).tries(40));
        jobs->push_back({"cech", dim, 7, of_points(&netmesh_filter_cech, true)});
        jobs->push_back({"bary-cech", dim, 5, of_points(&netmesh_filter_barycentric_cech, false)});
        jobs->push_back({"bary-rips", dim, 5, of_points(&netmesh_filter_barycentric_rips, false)});
        jobs->push_back(Job{"vines-of-sets", dim, 5, nested_sets(&netmesh_filter_barycentric_cech)}.large(dim > 3));
    }
    jobs->push_back({"distances", 2, 9, of_distances(NETMESH_DISTANCES_LOWER, 1, false)});
    jobs->push_back({"distances-tree", 2, 9, of_distances(NETMESH_DISTANCES_LOWER, 0, false)});
    jobs->push_back({"distances-cycles", 2, 8, of_distances(NETMESH_DISTANCES_LOWER, 1, true)});
    jobs->push_back({"distances-sparse", 2, 9, of_distances(NETMESH_DISTANCES_SPARSE, 1, false)});
    jobs->push_back({"homology", 2, 12, homology});
    jobs->push_back({"homology-cycles", 2, 12, homology_cycles});
    jobs->push_back({"vines-of-simplices", 2, 8, vines_of_simplices});
    jobs->push_back({"vines-of-vertices", 2, 8, vines_of_vertices});
    jobs->push_back(Job{"rips-large", 2, 18, of_points(&netmesh_filter_rips, false, 2)}.large().tries(60));
    jobs->push_back(Job{"rips-large", 3, 18, of_points(&netmesh_filter_rips, true, 2)}.large().tries(60));
    jobs->push_back(Job{"scales", 2, 3, scales}.large().tries(30));
    jobs->push_back(Job{"scales", 3, 2, scales}.large().tries(10));
}
