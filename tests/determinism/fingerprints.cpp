// Prints the fingerprints of a fixed set of jobs, one a line: job, input, dimension, fingerprint of the input,
// fingerprint of the result (of an analysis: of all its figures), sizes. Inputs are made with + - * / alone, so every
// line must be the same on every compiler, optimisation level and processor.
//
//   fingerprints [small]      small: without the Clifford set
//
// With NETMESH_SLICES in the environment all of it runs in a job that pauses at every poll.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>

#include "common/session.hpp"
#include "common/wasserstein.hpp"

namespace {

bool failed = false;
netmesh_monitor monitor = {};  // of every call

// A session whose calls are watched by it.
struct Watched : Session {
    explicit Watched(int dim) : Session(dim) { request.monitor = monitor; }
};

std::uint64_t bits_of(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

void print(const char* job, const char* input, const Session& session, netmesh_status status) {
    if (status != NETMESH_OK) {
        std::printf("%s %s D%" PRIu32 " failed: %s\n", job, input, session.dim(), netmesh_status_text(status));
        failed = true;
        return;
    }
    const netmesh_report r = session.report();
    std::uint64_t pairs = 0;
    for (const std::uint64_t of_degree : r.diagram.pairs) pairs += of_degree;
    std::printf("%s %s D%" PRIu32 " input %016" PRIx64 " result %016" PRIx64 " vertices %" PRIu64 " cells %" PRIu64
                " pairs %" PRIu64 "\n",
                job, input, r.input.dim, r.input.fingerprint, r.fingerprint,
                r.mesh.vertices + r.simplicial_complex.vertices, r.mesh.cells, pairs);
    std::fflush(stdout);
}

// All simplices of all cycles.
std::uint64_t hash_of_cycles(const Session& session) {
    std::uint64_t hash = 1;
    const std::uint64_t pairs = session.pairs().size();
    for (std::uint64_t i = 0; i < pairs; ++i) {
        std::uint64_t n = 0;
        for (const netmesh_simplex& s : cycle_of(session.context, i)) {
            for (const std::uint32_t v : s.vertices) hash = (hash ^ v) * 0x100000001B3u + n;
            ++n;
        }
    }
    return hash;
}

void represent(const char* job, Session& session, netmesh_status status) {
    if (status == NETMESH_OK) status = session.represent();
    failed = failed || status != NETMESH_OK;
    std::printf("cycles %s D%" PRIu32 " %016" PRIx64 " status %d\n", job, session.dim(), hash_of_cycles(session),
                static_cast<int>(status));
}

// Every number of the bounds of bars and of the ratio by scale.
void bound(const char* job, Session& session) {
    const netmesh_status status = session.bound_bars();
    failed = failed || status != NETMESH_OK;
    std::uint64_t hash = 1, certain = 0;
    const auto add = [&](double x) { hash = (hash ^ bits_of(x)) * 0x100000001B3u + (hash >> 32); };
    const auto bars = read_all(session.context, netmesh_get_bar_bounds);
    for (const netmesh_bar_bounds& b : bars) {
        for (const double x : {b.birth_low, b.birth_high, b.death_low, b.death_high, b.certain_after}) add(x);
        certain += b.certain;
    }
    const auto steps = read_all(session.context, netmesh_get_scale_step);
    for (const netmesh_scale_step& s : steps)
        for (const double x : {s.from, s.low, s.high, s.reach, s.ratio}) add(x);
    std::printf("bounds %s D%" PRIu32 " %016" PRIx64 " bars %zu certain %" PRIu64 " steps %zu status %d\n", job,
                session.dim(), hash, bars.size(), certain, steps.size(), static_cast<int>(status));
    std::fflush(stdout);
}

void print_analysis(const char* input, Session& session, std::uint32_t what) {
    netmesh_analysis a;
    const netmesh_status status = session.analyse(&a, what, 30);
    failed = failed || status != NETMESH_OK;
    std::printf("analyse %s D%" PRIu32 " status %d result %016" PRIx64 " boxes %" PRIu64 " ply %" PRIu64
                " degree %" PRIu64 "\n",
                input, session.dim(), static_cast<int>(status), a.fingerprint, a.size.boxes, a.structure.ply_max,
                a.structure.degree_max);
    std::fflush(stdout);
}

void print_audit(const char* input, Session& session, const inputs::Points& points) {
    session.request.mesh.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
    const netmesh_status status = session.mesh(points);
    session.request.mesh.audit = 0;
    print("audit", input, session, status);
    const netmesh_audit_report a = session.report().mesh.audit;
    const double ratios[] = {a.ply_mean,      a.touches_mean, a.tests_mean,    a.aspect_ratio_max,
                             a.feature_ratio, a.cage_ratio,   a.steiner_ratio, a.input_ratio};
    std::uint64_t hash = 1;
    for (const double ratio : ratios) hash = (hash ^ bits_of(ratio)) * 0x100000001B3u;
    std::printf("audit %s D%" PRIu32 " rounds %" PRIu32 " nets %" PRIu32 " ply %" PRIu32 " touches %" PRIu32
                " meshes %" PRIu64 " degree %" PRIu64 " ratios %016" PRIx64 "\n",
                input, session.dim(), a.rounds, a.nets, a.ply_max, a.touches_max, a.meshes, a.degree_max, hash);
    std::fflush(stdout);
}

// Points of a triangulation, of a mesh, of a complex on the points; sides of a grid that is triangulated.
struct Sizes {
    std::size_t points, meshed, complex;
    int side;
};
Sizes sizes_of(int dim) {
    switch (dim) {
    case 2: return {2000, 400, 40, 20};
    case 3: return {1000, 150, 36, 6};
    case 4: return {300, 40, 32, 4};
    case 5: return {120, 12, 24, 3};
    default: return {50, 6, 20, 2};
    }
}

void triangulations(Session& session, int dim, const Sizes& sizes) {
    print("delaunay", "uniform", session, session.delaunay(inputs::uniform(dim, sizes.points)));
    print_analysis("uniform-delaunay", session, NETMESH_ANALYSE_ALL & ~NETMESH_ANALYSE_SIZE);
    print("delaunay", "clusters", session, session.delaunay(inputs::clusters(dim, sizes.points)));
    print("delaunay", "grid", session, session.delaunay(inputs::grid(dim, sizes.side)));
    print("delaunay", "zoom", session, session.delaunay(inputs::zoom(dim, 1000, 20)));
    const inputs::Points twice = inputs::repeated(dim, inputs::uniform(dim, sizes.points / 2), 2);
    print("delaunay", "repeated", session, session.delaunay(twice));
}

void meshes(Session& session, int dim, std::size_t meshed) {
    const auto mesh = [&](const char* job, const char* input, const inputs::Points& points) {
        print(job, input, session, session.mesh(points));
    };
    mesh("mesh", "uniform", inputs::uniform(dim, meshed));
    mesh("mesh", "clusters", inputs::clusters(dim, meshed));
    session.request.mesh.method = &netmesh_method_netmesh;
    mesh("netmesh", "clusters", inputs::clusters(dim, meshed));
    mesh("netmesh", "geometric", inputs::geometric(dim, 1000, dim < 5 ? 40 : 10));
    print_audit("uniform", session, inputs::uniform(dim, 4 + meshed / 16));
    print_audit("geometric", session, inputs::geometric(dim, 1000, 10));
    session.request.mesh.finish = 1;
    mesh("netmesh-finish", "clusters", inputs::clusters(dim, meshed / 4));
    session.request.mesh.finish = 0;
    session.request.mesh.method = &netmesh_method_refine;
    if (dim < 4) mesh("refine", "uniform", inputs::uniform(dim, meshed / 4));
    session.request.mesh.method = nullptr;
    print_analysis("clusters-mesh", session, NETMESH_ANALYSE_ALL);
    session.request.mesh.sizes.eps = dim < 4 ? 0.5 : 1;
    mesh("mesh-eps", "uniform", inputs::uniform(dim, meshed / 4 + 3));
    session.request.mesh.sizes.eps = 0;
}

void diagrams_of_meshes(Session& session, int dim, const Sizes& sizes) {
    const inputs::Points uniform = inputs::uniform(dim, sizes.meshed);
    print("persist", "uniform", session, session.mesh_and_persist(uniform));
    bound("uniform", session);
    print("persist", "grid", session, session.mesh_and_persist(inputs::grid(dim, dim < 4 ? 5 : 2)));
    print("persist-basic", "uniform", session,
          session.mesh_and_persist(uniform, persist_by(&netmesh_filter_basic, 0, NETMESH_VALUES_THESIS)));
    represent("alpha", session, session.alpha(inputs::uniform(dim, sizes.points / 4)));
    represent("persist", session, session.mesh_and_persist(inputs::uniform(dim, dim < 5 ? sizes.meshed / 4 : 2)));
    print("persist-knn", "uniform", session, session.mesh_and_persist(uniform, persist_by(&netmesh_filter_knn, 5)));
    bound("knn", session);
    print("persist-kdistance", "uniform", session,
          session.mesh_and_persist(uniform, persist_by(&netmesh_filter_kdistance, 5)));
    bound("kdistance", session);
    session.request.goal.ratio = 2.25;
    print("persist-ratio", "uniform", session, session.mesh_and_persist(uniform));
    print("persist-ratio", "shell", session, session.mesh_and_persist(inputs::shell(dim, sizes.meshed / 2, 1, 1, 7)));
    session.request.goal.ratio = 0;
}

// Where meshes are fine: D = 2, 3.
void dense_runs(Session& session, int dim) {
    const inputs::Points zoom = inputs::zoom(dim, 40, dim == 2 ? 4 : 10);
    print("persist-scales", "zoom", session, session.persist_until_it_fits(session.scales_request(zoom)));
    const inputs::Points sparse = inputs::uniform(dim, dim == 2 ? 20 : 5);
    print("persist-tight", "uniform", session,
          session.mesh_and_persist(sparse, persist_by(&netmesh_filter_tight), &netmesh_filter_tight));
    const inputs::Points few = inputs::uniform(dim, dim == 2 ? 20 : 6);
    print("vineyard", "uniform", session, session.until_it_fits(std::size_t(1) << 24, [&] {
        const netmesh_status status = session.mesh_in_block(few, &netmesh_filter_complete);
        return status == NETMESH_OK ? session.vineyard(&netmesh_filter_knn, 1, 5) : status;
    }));
}

void complexes_on_points(Session& session, int dim, std::size_t number) {
    const auto complex = [&](const char* job, const char* input, const netmesh::Request& request) {
        print(job, input, session, session.persist_until_it_fits(request));
    };
    const inputs::Points points = inputs::uniform(dim, number), nine = inputs::uniform(dim, 9),
                         ten = inputs::uniform(dim, 10);
    const inputs::Points grid = inputs::grid(dim, dim < 4 ? 4 : 2), small_grid = inputs::grid(dim, dim < 3 ? 4 : 2);
    complex("rips", "uniform", session.points_request(points, &netmesh_filter_rips, 1, dim < 4 ? 2 : 1));
    complex("rips", "grid", session.points_request(grid, &netmesh_filter_rips, 1, 1));
    complex("cech", "uniform", session.points_request(points, &netmesh_filter_cech, 1, 1));
    complex("cech", "grid", session.points_request(small_grid, &netmesh_filter_cech, 1, 2));
    complex("barycentric-cech", "uniform", session.points_request(nine, &netmesh_filter_barycentric_cech, 2, 1));
    complex("barycentric-rips", "uniform", session.points_request(ten, &netmesh_filter_barycentric_rips, 3, 0));
}

// Points with radii, some of which hide others, kept and not; a grid with weights that tie, as powers.
void weighted(Watched& session, int dim, const Sizes& sizes) {
    const inputs::Points points = inputs::uniform(dim, sizes.points / 2), grid = inputs::grid(dim, dim < 4 ? 6 : 3);
    inputs::Points radii = inputs::uniform(1, sizes.points / 2, 11), weights;
    for (double& r : radii) r *= dim == 2 ? 0.0625 : 0.25;
    for (std::size_t i = 0; i < grid.size() / static_cast<std::size_t>(dim); ++i)
        weights.push_back(0.25 * static_cast<double>(i % 3) - 0.25);
    netmesh::Request request = session.alpha_request(points);
    request.set_weights(&netmesh_radii, radii);
    print("weighted-points", "uniform", session, session.persist(request));
    request.keep_mesh = 1;
    print("weighted", "uniform", session, session.persist(request));
    netmesh::Request of_grid = session.alpha_request(grid);
    of_grid.set_weights(&netmesh_weights, weights);
    of_grid.keep_mesh = of_grid.squares = 1;
    print("weighted", "grid", session, session.persist(of_grid));
}

void dimension(int dim) {
    const Sizes sizes = sizes_of(dim);
    Watched session(dim);
    session.reserve(std::size_t(1) << 28);
    triangulations(session, dim, sizes);
    meshes(session, dim, sizes.meshed);
    diagrams_of_meshes(session, dim, sizes);
    if (dim <= 3) dense_runs(session, dim);
    print("alpha", "uniform", session, session.alpha(inputs::uniform(dim, sizes.points / 2)));
    const inputs::Points uniform = inputs::uniform(dim, sizes.points / 2);  // the request points into them
    print("alpha-of-points", "uniform", session, session.persist(session.alpha_request(uniform)));
    complexes_on_points(session, dim, sizes.complex);
    print("alpha", "grid", session, session.alpha(inputs::grid(dim, dim < 4 ? sizes.side : 3)));
    weighted(session, dim, sizes);
}

// Distances of the diagrams of two samples, to the last bit.
void distances() {
    Watched a(2), b(2);
    const bool made = a.alpha(inputs::shell(2, 500, 0.5, 1, 1)) == NETMESH_OK &&
                      b.alpha(inputs::shell(2, 500, 0.5, 1, 2)) == NETMESH_OK;
    const std::vector<netmesh_pair> x = a.pairs(), y = b.pairs();
    for (const netmesh_scale scale : {NETMESH_SCALE_PLAIN, NETMESH_SCALE_LOG}) {
        const Distance d = bottleneck(x, y, scale);
        failed = failed || !made || d.status != NETMESH_OK;
        std::printf("bottleneck %s distance %a exponent %d\n", scale == NETMESH_SCALE_LOG ? "log" : "plain", d.value,
                    d.exponent);
    }
    for (const std::uint32_t order : {1u, 2u, 5u}) {
        const Transport d = wasserstein(wasserstein_request(x, y, order, 0.01));
        failed = failed || d.status != NETMESH_OK;
        std::printf("wasserstein order %" PRIu32 " from %a to %a\n", order, d.lower, d.value);
    }
}

// The complex of all faces of some cells, with values by formula and negative ones among them, and a cycle for each
// bar.
void homology() {
    const std::uint32_t vertices = 60, size = 4;
    inputs::Random random(7);
    std::set<std::vector<std::uint32_t>> faces;
    while (faces.size() < 3000) {
        std::vector<std::uint32_t> cell;
        for (std::uint32_t i = 0; i < size; ++i)
            cell.push_back(static_cast<std::uint32_t>(random.below(vertices / size)) * size + i);
        for (std::uint32_t mask = 1; mask < 1u << size; ++mask) {
            std::vector<std::uint32_t> face;
            for (std::uint32_t i = 0; i < size; ++i) {
                if ((mask >> i & 1) != 0) face.push_back(cell[i]);
            }
            faces.insert(face);
        }
    }
    std::vector<std::uint32_t> list;
    std::vector<std::uint64_t> starts = {0};
    std::vector<double> values;
    for (const auto& face : faces) {
        list.insert(list.end(), face.begin(), face.end());
        starts.push_back(list.size());
        double value = -2;
        for (const std::uint32_t v : face) value = std::max(value, v * 0.25 / (1 + v % 7) - 2);
        values.push_back(value + static_cast<double>(face.size()) * 0.125);
    }
    Watched session(2);
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.vertices = list.data();
    simplices.vertex_count = list.size();
    simplices.starts = starts.data();
    simplices.entries = values.data();
    simplices.simplex_count = values.size();
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    request.max_degree = 3;
    request.cycles = &netmesh_cycles;
    print("homology", "joined", session, session.persist_until_it_fits(request));
    std::printf("homology cycles %016" PRIx64 "\n", hash_of_cycles(session));
}

void all(bool small) {
    for (int dim = NETMESH_DIM_MIN; dim <= NETMESH_DIM_MAX; ++dim)
        if (plans_for(dim)) dimension(dim);
    distances();
    homology();
    if (small || !plans_for(4)) return;
    Watched session(4);
    session.request.mesh.tau = 3.08;
    print("persist", "clifford", session, session.mesh_and_persist(inputs::clifford(2000)));
}

// Whether it paused, and ended well.
bool all_in_slices(bool small) {
    static unsigned char stack[1 << 20];
    netmesh_job* job = nullptr;
    const auto task = [](void* is_small) {
        all(*static_cast<bool*>(is_small));
        return NETMESH_OK;
    };
    if (netmesh_job_init(stack, sizeof stack, task, &small, &job) != NETMESH_OK) return false;
    monitor = {netmesh_poll_pause, job};
    long pauses = 0;
    netmesh_status status;
    while ((status = netmesh_resume(job)) == NETMESH_PAUSED) ++pauses;
    std::fprintf(stderr, "%ld pauses, %zu bytes of stack\n", pauses, netmesh_stack_used(job));
    return status == NETMESH_OK && pauses > 10;
}

}  // namespace

int main(int argc, char** argv) {
    const bool small = argc > 1 && std::strcmp(argv[1], "small") == 0;
    if (std::getenv("NETMESH_SLICES") == nullptr)
        all(small);
    else
        failed = !all_in_slices(small) || failed;
    return failed ? 1 : 0;
}
