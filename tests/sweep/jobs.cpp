// Jobs that end in a triangulation or a mesh, checked or with a diagram in all degrees.
#include "sweep/jobs.hpp"

#include <map>
#include <vector>

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/kinds.hpp"
#include "common/session.hpp"
#include "exact/families.hpp"
#include "sweep/harness.hpp"

std::uint64_t figures_of_run = 0;

void add_figure(std::uint64_t figure) { figures_of_run = (figures_of_run ^ figure) * 0x100000001B3u + 1; }

Run::Run(const Job& of, netmesh_context* in) : Calls(of.dim, in), job(of) { request.monitor.poll = sweep_poll; }

namespace {

using Make = inputs::Points (*)(const Job& job);

// What `make` makes for a job, once for each number of points.
template <Make make> const inputs::Points& made(const Job& job) {
    static std::map<std::pair<int, std::size_t>, inputs::Points> all;
    inputs::Points& points = all[{job.dim, job.points}];
    if (points.empty()) points = make(job);
    return points;
}

inputs::Points uniform_points(const Job& job) { return inputs::uniform(job.dim, job.points, 40); }
inputs::Points repeated_points(const Job& job) { return inputs::repeated(job.dim, uniform_points(job), 3); }
// With cages: points at distances that shrink twentyfold.
inputs::Points spread_points(const Job& job) { return inputs::geometric(job.dim, 20, job.points - 1); }
// The same with gaps that are just too narrow: Steiner points release a cage.
inputs::Points narrow_pairs(const Job& job) {
    const double gap =
        by_dimension<double>(job.dim, {0.07, 0x1.bda73b8bfa5b9p-4, 0.0625, 0x1.c1a8aed55a266p-4, 0x1.2bc89d5a28729p-4});
    const std::uint64_t seed = by_dimension<std::uint64_t>(job.dim, {1, 572, 641, 185, 795});
    return inputs::close_pairs(job.dim, job.points / 2, gap, seed);
}
inputs::Points far_pairs(const Job& job) { return inputs::close_pairs(job.dim, job.points / 2, 1e-3, 2); }
inputs::Points close_pairs(const Job& job) { return inputs::close_pairs(job.dim, job.points / 2, 0.02, 2); }

// On a sphere but for some units in the last place: radii of cells are nearly equal.
inputs::Points moved_sphere(const Job& job) { return families::moved(inputs::shell(job.dim, job.points, 1, 1, 9), 2); }

netmesh_status delaunay(Run& run) { return run.delaunay_in_block(run.points()); }
netmesh_status repeated(Run& run) { return run.delaunay_in_block(made<repeated_points>(run.job)); }

// Points as floats, each the first numbers of a record.
std::vector<float> read_floats(const Run& run, netmesh::Request* request) {
    const std::size_t dim = static_cast<std::size_t>(run.job.dim), stride = dim + 2;
    const inputs::Points& points = run.points();
    std::vector<float> rows(points.size() / dim * stride, -1e30f);
    for (std::size_t i = 0; i < points.size(); ++i) rows[i / dim * stride + i % dim] = static_cast<float>(points[i]);
    request->points.coordinates = rows.data();
    request->points.format = NETMESH_POINTS_FLOAT32;
    request->points.stride_bytes = sizeof(float) * stride;
    return rows;
}
netmesh_status cells_of_floats(Run& run) {
    netmesh::Request request = run.delaunay_request(run.points());
    const std::vector<float> rows = read_floats(run, &request);
    return netmesh_mesh(run.context, &request);
}
netmesh_status mesh_of_floats(Run& run) {
    netmesh::Request request = run.mesh_request(run.points());
    const std::vector<float> rows = read_floats(run, &request);
    return netmesh_mesh(run.context, &request);
}

netmesh_status alpha(Run& run) {
    const netmesh_status status = delaunay(run);
    return status == NETMESH_OK ? run.persist(&netmesh_filter_alpha) : status;
}
netmesh_status alpha_of_moved(Run& run) {
    const netmesh_status status = run.delaunay_in_block(made<moved_sphere>(run.job));
    return status == NETMESH_OK ? run.persist(&netmesh_filter_alpha) : status;
}
netmesh_status alpha_low(Run& run) {
    const netmesh_status status = delaunay(run);
    netmesh::Request low(&netmesh_filter_alpha);
    low.max_degree = 0;
    return status == NETMESH_OK ? run.persist(low) : status;
}

netmesh_status mesh(Run& run) { return run.mesh_in_block(run.points(), &netmesh_filter_complete); }

netmesh_status persist_all(Run& run, const netmesh_filter* filter, netmesh_values values) {
    netmesh::Request all = persist_by(filter, 0, values);
    all.keep_zero_pairs = 1;
    const netmesh_status status = mesh(run);
    return status == NETMESH_OK ? run.persist(all) : status;
}
netmesh_status complete(Run& run) { return persist_all(run, &netmesh_filter_complete, NETMESH_VALUES_CERTIFIED); }
netmesh_status basic(Run& run) { return persist_all(run, &netmesh_filter_basic, NETMESH_VALUES_THESIS); }
netmesh_status basic_bounds(Run& run) {
    const netmesh_status status = persist_all(run, &netmesh_filter_basic, NETMESH_VALUES_CERTIFIED);
    return status == NETMESH_OK ? run.bound_bars() : status;
}
// Refined by the certificate.
netmesh_status by_ratio(Run& run) {
    run.request.goal.ratio = 3;
    return complete(run);
}
// The same, more at some scales.
netmesh_status focused(Run& run) {
    netmesh_goal& goal = run.request.goal;
    goal.ratio = 4;
    goal.focus_ratio = run.job.dim < 5 ? 2.6 : 3.5;
    goal.focus_from = 0.05;
    goal.focus_to = 4;
    return run.mesh_in_block(made<close_pairs>(run.job), &netmesh_filter_complete);
}
// As fine as the block allows: a request refused gives another diagram, and a whole one.
netmesh_status fit(Run& run) { return run.fit(run.points(), true); }

// The same, at some scales.
netmesh_status fit_focused(Run& run) {
    netmesh::Request request = run.fit_request(run.points());
    request.goal.focus_from = 0.5;
    request.goal.focus_to = 2;
    return run.persist(request);
}
// The same, for bars to be decided.
netmesh_status decide(Run& run) {
    netmesh::Request request = run.fit_request(run.points());
    request.goal.longer_than = 1.05;
    request.goal.ratio = 4;
    request.bounds = &netmesh_bounds;
    return run.persist(request);
}

// Alpha, or a mesh where a request is refused; a mesh of points in a line; one after a triangulation is given up.
netmesh_status persist_auto(Run& run) { return run.persist(run.auto_request(run.points())); }
netmesh_status auto_of_flat(Run& run) {
    inputs::Points points = run.points();
    for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(run.job.dim)) points[i] = 0.5;
    return run.persist(run.auto_request(points));
}
netmesh_status auto_given_up(Run& run) {
    const inputs::Points points = kinds::moment_curve(run.job.dim, run.job.points);
    return run.persist(run.auto_request(points));
}

netmesh_status check(Run& run) {
    const netmesh_status status = mesh(run);
    return status == NETMESH_OK ? run.check(NETMESH_CHECK_ALL & ~NETMESH_CHECK_BOUNDS) : status;
}
// Most of its requests are for one box of an integral each, alike.
netmesh_status check_bounds(Run& run) {
    const netmesh_status status = mesh(run);
    return status == NETMESH_OK ? run.check(NETMESH_CHECK_BOUNDS) : status;
}

netmesh_status hierarchy(Run& run) {
    run.request.mesh.method = &netmesh_method_netmesh;
    return run.mesh_in_block(made<spread_points>(run.job));
}
netmesh_status finished(Run& run) {
    run.request.mesh.finish = 1;
    return hierarchy(run);
}
netmesh_status thesis_cages(Run& run) {
    run.request.mesh.method = &netmesh_method_thesis;
    run.request.mesh.tau = 7;
    return run.mesh_in_block(made<far_pairs>(run.job));
}
netmesh_status thesis_finished(Run& run) {
    run.request.mesh.finish = 1;
    return thesis_cages(run);
}
netmesh_status audited(Run& run) {
    run.request.mesh.method = &netmesh_method_netmesh;
    run.request.mesh.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
    return run.mesh_in_block(run.points());
}
netmesh_status released(Run& run) {
    run.request.mesh.method = &netmesh_method_netmesh;
    run.request.mesh.tau = run.job.dim < 4 ? 2.2 : run.job.dim < 6 ? 6 : 8;
    return run.mesh_in_block(made<narrow_pairs>(run.job));
}
netmesh_status released_audited(Run& run) {
    run.request.mesh.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
    return released(run);
}

netmesh_status reference(Run& run) {
    run.request.mesh.method = &netmesh_method_refine;
    return run.mesh_in_block(run.points());
}
netmesh_status fine(Run& run) {
    run.request.mesh.sizes.eps = 0.5;
    return run.mesh_in_block(run.points());
}
double small_nearby(void*, const double* x) { return 0.3 + 0.5 * (x[0] < 0 ? -x[0] : x[0]); }
netmesh_status sized(Run& run) {
    run.request.mesh.sizes.eps = 0.8;
    run.request.mesh.sizes.size = small_nearby;
    return run.mesh_in_block(run.points());
}

// A mesh as a file would bring it: made by the same steps in the first run of a job, when nothing is refused.
template <netmesh_status (*steps)(Run&)> const Arrays& mesh_to_load(const Run& run) {
    static std::map<int, Arrays> all;
    const auto found = all.find(run.job.dim);
    if (found != all.end()) return found->second;
    Session block(run.job.dim);
    block.reserve(std::size_t{1} << 22);
    Run maker(run.job, block.context);
    require(steps(maker) == NETMESH_OK, "no mesh to load");
    return all.emplace(run.job.dim, Arrays(maker)).first->second;
}

netmesh_status load(Run& run) { return mesh_to_load<mesh>(run).load(run); }

// Sizes and a ratio that any mesh keeps, asked of one that is loaded.
netmesh_status check_loaded(Run& run) {
    run.request.mesh.sizes.eps = 1e6;
    netmesh_status status = load(run);
    if (status == NETMESH_OK) status = run.check(NETMESH_CHECK_QUALITY);
    run.request.mesh.sizes.eps = 0;
    run.request.goal.ratio = 1e6;
    return status == NETMESH_OK ? run.check(NETMESH_CHECK_QUALITY) : status;
}

netmesh_status load_cages(Run& run) {
    const Arrays& arrays = mesh_to_load<hierarchy>(run);
    const netmesh_status status = arrays.load(run);
    return status == NETMESH_OK ? arrays.load_cages(run) : status;
}

const Job low_dimensions[] = {
    {"delaunay", 2, 24, delaunay},
    {"delaunay", 3, 14, delaunay},
    {"delaunay", 4, 9, delaunay},
    Job{"delaunay", 4, 30, delaunay}.large(),
    {"repeated", 2, 12, repeated},
    {"alpha", 2, 24, alpha},
    {"alpha", 3, 12, alpha},
    {"alpha", 4, 8, alpha},
    Job{"alpha", 3, 40, alpha}.large(),
    {"alpha-moved", 2, 12, alpha_of_moved},
    {"alpha-moved", 3, 9, alpha_of_moved},
    {"alpha-low", 2, 12, alpha_low},
    {"alpha-low", 3, 9, alpha_low},
    {"alpha-low", 4, 7, alpha_low},
    {"mesh", 2, 8, mesh},
    {"mesh", 3, 5, mesh},
    {"mesh", 4, 3, mesh},
    Job{"audited", 2, 4, audited}.tries(40),
    Job{"audited", 3, 3, audited}.large().tries(10),
    Job{"audited", 4, 3, audited}.large().tries(25),
    {"complete", 2, 6, complete},
    {"complete", 3, 4, complete},
    {"complete", 4, 2, complete},
    Job{"complete", 2, 30, complete}.large(),
    Job{"complete", 3, 9, complete}.large(),
    Job{"complete", 4, 4, complete}.large(),
    {"cells-of-floats", 2, 8, cells_of_floats},
    {"cells-of-floats", 3, 7, cells_of_floats},
    {"mesh-of-floats", 2, 4, mesh_of_floats},
    {"mesh-of-floats", 3, 3, mesh_of_floats},
    {"basic", 2, 6, basic},
    {"basic", 3, 4, basic},
    {"basic", 4, 2, basic},
    Job{"bounds-basic", 2, 5, basic_bounds}.keeping_diagram(),
    Job{"bounds-basic", 3, 4, basic_bounds}.keeping_diagram(),
    Job{"bounds-basic", 4, 3, basic_bounds}.keeping_diagram().large(),
    Job{"check", 2, 6, check}.keeping_diagram(),
    Job{"check", 3, 4, check}.keeping_diagram(),
    Job{"check", 4, 2, check}.keeping_diagram(),
    Job{"check-bounds", 2, 6, check_bounds}.keeping_diagram().tries(200),
    Job{"check-bounds", 3, 4, check_bounds}.keeping_diagram().tries(100),
    Job{"check-bounds", 4, 2, check_bounds}.keeping_diagram().tries(100),
    {"load", 2, 6, load},
    {"load", 3, 4, load},
    {"load", 4, 2, load},
    {"check-loaded", 2, 5, check_loaded},
    {"check-loaded", 3, 3, check_loaded},
    {"check-loaded", 4, 2, check_loaded},
    {"hierarchy", 2, 8, hierarchy},
    {"hierarchy", 3, 6, hierarchy},
    Job{"hierarchy", 4, 4, hierarchy}.large().tries(50),
    Job{"finished", 2, 4, finished}.tries(100),
    Job{"finished", 3, 4, finished}.large().tries(50),
    Job{"finished", 4, 3, finished}.large().tries(25),
    Job{"thesis-cages", 2, 4, thesis_cages}.tries(100),
    Job{"thesis-cages", 3, 4, thesis_cages}.large().tries(25),
    Job{"thesis-cages", 4, 2, thesis_cages}.large().tries(10),
    Job{"thesis-finished", 2, 4, thesis_finished}.large().tries(25),
    {"cages", 2, 8, load_cages},
    {"cages", 3, 6, load_cages},
    Job{"cages", 4, 4, load_cages}.large().tries(50),
    {"reference", 2, 4, reference},
    Job{"reference", 3, 2, reference}.large().tries(50),
    Job{"fine", 2, 4, fine}.tries(200),
    Job{"fine", 3, 2, fine}.large().tries(50),
    Job{"sized", 2, 3, sized}.tries(100),
    Job{"sized", 3, 3, sized}.large().tries(25),
    {"by-ratio", 2, 6, by_ratio},
    {"by-ratio", 3, 4, by_ratio},
    Job{"by-ratio", 4, 3, by_ratio}.large().tries(100),
    Job{"focused", 2, 4, focused}.tries(100),
    Job{"focused", 3, 4, focused}.large().tries(100),
    Job{"focused", 4, 4, focused}.large().tries(25),
    Job{"fit", 2, 5, fit}.keeping_diagram().tries(40).using_up(64 << 10),
    Job{"fit focused", 2, 5, fit_focused}.keeping_diagram().tries(40).using_up(64 << 10),
    Job{"fit", 3, 3, fit}.keeping_diagram().tries(40).using_up(64 << 10).large(),
    Job{"fit", 4, 2, fit}.keeping_diagram().tries(40).using_up(80 << 10).large(),
    Job{"auto", 2, 12, persist_auto}.tries(60).using_up(64 << 10),
    Job{"auto", 3, 8, persist_auto}.tries(40).using_up(96 << 10),
    Job{"auto-flat", 2, 6, auto_of_flat}.tries(40).using_up(64 << 10),
    Job{"auto-given-up", 3, 80, auto_given_up}.large().tries(20).using_up(1 << 20),
    Job{"decide", 2, 25, decide}.keeping_diagram().tries(40).using_up(128 << 10),
    Job{"decide", 3, 12, decide}.keeping_diagram().tries(40).using_up(256 << 10).large(),
    Job{"released", 2, 8, released}.large().tries(100),
    Job{"released", 3, 8, released}.large().tries(50),
    Job{"released", 4, 8, released}.large().tries(50),
    Job{"released-audited", 3, 8, released_audited}.large().tries(25),
    Job{"released-audited", 4, 8, released_audited}.large().tries(25),
};

}  // namespace

const inputs::Points& Run::points() const { return made<uniform_points>(job); }

void add_mesh_jobs(std::vector<Job>* jobs) {
    jobs->insert(jobs->end(), std::begin(low_dimensions), std::end(low_dimensions));
    for (const int dim : dimensions(5, 6)) {
        jobs->push_back({"delaunay", dim, 9, delaunay});
        jobs->push_back({"repeated", dim, 8, repeated});
        jobs->push_back({"alpha", dim, 8, alpha});
        jobs->push_back({"alpha-low", dim, 8, alpha_low});
        jobs->push_back({"complete", dim, 2, complete});
        jobs->push_back({"basic", dim, 2, basic});
        jobs->push_back(Job{"check", dim, 2, check}.keeping_diagram().large());
        jobs->push_back(Job{"check-bounds", dim, 2, check_bounds}.keeping_diagram().large().tries(100));
        jobs->push_back({"by-ratio", dim, 2, by_ratio});
        jobs->push_back({"load", dim, 2, load});
        jobs->push_back({"hierarchy", dim, 4, hierarchy});
        jobs->push_back(Job{"released", dim, 4, released}.large().tries(50));
        jobs->push_back(Job{"released-audited", dim, 4, released_audited}.large().tries(25));
        jobs->push_back(Job{"audited", dim, 3, audited}.large().tries(25));
        jobs->push_back(Job{"focused", dim, 4, focused}.large().tries(10));
        jobs->push_back(Job{"sized", dim, 2, sized}.large().tries(10));
        jobs->push_back({"cages", dim, 4, load_cages});
        const std::size_t bars = dim == 5 ? 8 : 2;
        jobs->push_back(Job{"bounds-basic", dim, bars, basic_bounds}.keeping_diagram().large().tries(40));
        jobs->push_back({"check-loaded", dim, 2, check_loaded});
        jobs->push_back(Job{"fit", dim, 2, fit}.keeping_diagram().tries(20).using_up(std::size_t{160} << 10).large());
    }
}
