// Prints the fingerprints of a fixed set of jobs, one a line: job, input, dimension, fingerprint of the input,
// fingerprint of the result (of an analysis: of all its figures), sizes. Inputs are made with + - * / alone, so every line
// must be the same on every compiler, optimisation level and processor.
//
//   fingerprints [small]      small: without the Clifford set
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>

#include "common/session.hpp"

namespace {

bool failed = false;

void print(const char* job, const char* input, const Session& session, netmesh_status status) {
    if (status != NETMESH_OK) {
        std::printf("%s %s D%" PRIu32 " failed: %s\n", job, input, session.request.dim, netmesh_status_text(status));
        failed = true;
        return;
    }
    const netmesh_report r = session.report();
    std::uint64_t pairs = 0;
    for (std::uint32_t k = 0; k <= r.diagram.max_degree; ++k) pairs += r.diagram.present ? r.diagram.pairs[k] : 0;
    std::printf("%s %s D%" PRIu32 " input %016" PRIx64 " result %016" PRIx64 " vertices %" PRIu64 " cells %" PRIu64
                " pairs %" PRIu64 "\n",
                job, input, r.input.dim, r.input.fingerprint, r.fingerprint, r.mesh.vertices, r.mesh.cells, pairs);
    std::fflush(stdout);
}

// All simplices of all cycles.
std::uint64_t hash_of_cycles(const Session& session) {
    std::uint64_t hash = 1;
    std::uint64_t count = 0;
    netmesh_simplex s;
    for (std::uint64_t i = 0; netmesh_get_cycle(session.context, i, &count) == NETMESH_OK; ++i)
        for (std::uint64_t n = 0; netmesh_get_cycle_simplex(session.context, i, n, &s) == NETMESH_OK; ++n)
            for (const std::uint32_t v : s.vertices) hash = (hash ^ v) * 0x100000001B3u + n;
    return hash;
}

void represent(const char* job, Session& session, netmesh_status status) {
    if (status == NETMESH_OK) status = session.represent();
    failed = failed || status != NETMESH_OK;
    std::printf("cycles %s D%" PRIu32 " %016" PRIx64 " status %d\n", job, session.request.dim, hash_of_cycles(session),
                static_cast<int>(status));
}

// Every number of the bounds of bars and of the ratio by scale.
void bound(const char* job, Session& session) {
    const netmesh_status status = session.bound_bars();
    failed = failed || status != NETMESH_OK;
    std::uint64_t hash = 1, bars = 0, steps = 0, certain = 0;
    const auto add = [&](double x) {
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        hash = (hash ^ bits) * 0x100000001B3u + (hash >> 32);
    };
    netmesh_bar_bounds b;
    for (; netmesh_get_bar_bounds(session.context, bars, &b) == NETMESH_OK; ++bars) {
        for (const double x : {b.birth_low, b.birth_high, b.death_low, b.death_high, b.certain_after}) add(x);
        certain += b.certain;
    }
    netmesh_scale_step s;
    for (; netmesh_get_scale_step(session.context, steps, &s) == NETMESH_OK; ++steps)
        for (const double x : {s.from, s.reach, s.ratio}) add(x);
    std::printf("bounds %s D%" PRIu32 " %016" PRIx64 " bars %" PRIu64 " certain %" PRIu64 " steps %" PRIu64
                " status %d\n",
                job, session.request.dim, hash, bars, certain, steps, static_cast<int>(status));
    std::fflush(stdout);
}

void print_analysis(const char* input, Session& session, std::uint32_t what) {
    netmesh_analysis a = {};
    a.struct_bytes = sizeof a;
    const netmesh_status status = session.analyse(&a, what, 30);
    failed = failed || status != NETMESH_OK;
    std::printf("analyse %s D%" PRIu32 " status %d result %016" PRIx64 " boxes %" PRIu64 " ply %" PRIu64
                " degree %" PRIu64 "\n",
                input, session.request.dim, static_cast<int>(status), a.fingerprint, a.size.boxes, a.structure.ply_max, a.structure.degree_max);
    std::fflush(stdout);
}

void print_audit(const char* input, Session& session, const inputs::Points& points) {
    session.request.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
    const netmesh_status status = session.mesh(points);
    session.request.audit = 0;
    print("audit", input, session, status);
    const netmesh_audit a = session.report().mesh.audit;
    const double ratios[] = {a.structure.ply_mean,      a.touches_mean, a.tests_mean,    a.aspect_ratio_max,
                             a.size.feature_ratio, a.cage_ratio,   a.steiner_ratio, a.input_ratio};
    std::uint64_t hash = 1;
    for (const double ratio : ratios) {
        std::uint64_t bits;
        std::memcpy(&bits, &ratio, sizeof bits);
        hash = (hash ^ bits) * 0x100000001B3u;
    }
    std::printf("audit %s D%" PRIu32 " rounds %" PRIu32 " nets %" PRIu32 " ply %" PRIu32 " touches %" PRIu32
                " meshes %" PRIu32 " ratios %016" PRIx64 "\n",
                input, session.request.dim, a.rounds, a.nets, a.structure.ply_max, a.touches_max, a.meshes, hash);
    std::fflush(stdout);
}

void dimension(int dim) {
    const std::size_t d = static_cast<std::size_t>(dim);
    const std::size_t points[] = {0, 0, 2000, 1000, 300, 120, 50}, meshed[] = {0, 0, 400, 150, 40, 12, 6};
    const int side[] = {0, 0, 20, 6, 4, 3, 2};
    Session session(dim);
    session.reserve(std::size_t(1) << 28);
    print("delaunay", "uniform", session, session.delaunay(inputs::uniform(dim, points[d])));
    print_analysis("uniform-delaunay", session, NETMESH_ANALYSE_ALL & ~NETMESH_ANALYSE_SIZE);
    print("delaunay", "clusters", session, session.delaunay(inputs::clusters(dim, points[d])));
    print("delaunay", "grid", session, session.delaunay(inputs::grid(dim, side[d])));
    print("delaunay", "zoom", session, session.delaunay(inputs::zoom(dim, 1000, 20)));
    print("delaunay", "repeated", session,
          session.delaunay(inputs::repeated(dim, inputs::uniform(dim, points[d] / 2), 2)));
    print("mesh", "uniform", session, session.mesh(inputs::uniform(dim, meshed[d])));
    print("mesh", "clusters", session, session.mesh(inputs::clusters(dim, meshed[d])));
    session.request.method = NETMESH_METHOD_NETMESH;
    print("netmesh", "clusters", session, session.mesh(inputs::clusters(dim, meshed[d])));
    print("netmesh", "geometric", session, session.mesh(inputs::geometric(dim, 1000, dim < 5 ? 40 : 10)));
    print_audit("uniform", session, inputs::uniform(dim, 4 + meshed[d] / 16));
    print_audit("geometric", session, inputs::geometric(dim, 1000, 10));
    session.request.finish = 1;
    print("netmesh-finish", "clusters", session, session.mesh(inputs::clusters(dim, meshed[d] / 4)));
    session.request.finish = 0;
    session.request.method = NETMESH_METHOD_REFINE;
    if (dim < 4) print("refine", "uniform", session, session.mesh(inputs::uniform(dim, meshed[d] / 4)));
    session.request.method = NETMESH_METHOD_SVR;
    print_analysis("clusters-mesh", session, NETMESH_ANALYSE_ALL);
    session.request.sizes.eps = dim < 4 ? 0.5 : 1;
    print("mesh-eps", "uniform", session, session.mesh(inputs::uniform(dim, meshed[d] / 4 + 3)));
    session.request.sizes.eps = 0;
    print("persist", "uniform", session, session.mesh_and_persist(inputs::uniform(dim, meshed[d])));
    bound("uniform", session);
    print("persist", "grid", session, session.mesh_and_persist(inputs::grid(dim, dim < 4 ? 5 : 2)));
    print("persist-basic", "uniform", session,
          session.mesh_and_persist(inputs::uniform(dim, meshed[d]), NETMESH_FILTER_BASIC, NETMESH_VALUES_THESIS));
    represent("alpha", session, session.alpha(inputs::uniform(dim, points[d] / 4)));
    represent("persist", session, session.mesh_and_persist(inputs::uniform(dim, dim < 5 ? meshed[d] / 4 : 2)));
    for (const netmesh_filter filter : {NETMESH_FILTER_KNN, NETMESH_FILTER_KDISTANCE}) {
        session.options.k = 5;
        print(filter == NETMESH_FILTER_KNN ? "persist-knn" : "persist-kdistance", "uniform", session,
              session.mesh_and_persist(inputs::uniform(dim, meshed[d]), filter));
        bound(filter == NETMESH_FILTER_KNN ? "knn" : "kdistance", session);
    }
    session.request.certificate.ratio = 2.25;
    print("persist-ratio", "uniform", session, session.mesh_and_persist(inputs::uniform(dim, meshed[d])));
    print("persist-ratio", "shell", session, session.mesh_and_persist(inputs::shell(dim, meshed[d] / 2, 1, 1, 7)));
    session.request.certificate.ratio = 0;
    if (dim <= 3) {
        const inputs::Points zoom = inputs::zoom(dim, 40, dim == 2 ? 4 : 10);
        print("persist-scales", "zoom", session, session.until_it_fits(std::size_t(1) << 24, [&] {
            return netmesh_persist_scales(session.context, zoom.data(), zoom.size() / d, NETMESH_VALUES_CERTIFIED,
                                          NETMESH_DIM_MAX, 0, &session.options);
        }));
        const inputs::Points sparse = inputs::uniform(dim, dim == 2 ? 20 : 5);
        print("persist-tight", "uniform", session, session.until_it_fits(std::size_t(1) << 24, [&] {
            const netmesh_status status = netmesh_mesh(session.context, sparse.data(), sparse.size() / d,
                                                       NETMESH_PURPOSE_TIGHT, &session.options);
            return status != NETMESH_OK
                       ? status
                       : netmesh_persist(session.context, NETMESH_FILTER_TIGHT, NETMESH_VALUES_CERTIFIED,
                                         NETMESH_DIM_MAX, 0, &session.options);
        }));
        const inputs::Points few = inputs::uniform(dim, dim == 2 ? 20 : 6);
        print("vineyard", "uniform", session, session.until_it_fits(std::size_t(1) << 24, [&] {
            const netmesh_status status =
                netmesh_mesh(session.context, few.data(), few.size() / d, NETMESH_PURPOSE_PERSIST, &session.options);
            return status != NETMESH_OK ? status
                                        : netmesh_vineyard(session.context, NETMESH_FILTER_KNN, 1, 5,
                                                           NETMESH_VALUES_CERTIFIED, NETMESH_DIM_MAX, &session.options);
        }));
    }
    print("alpha", "uniform", session, session.alpha(inputs::uniform(dim, points[d] / 2)));
    const std::size_t number[] = {0, 0, 40, 36, 32, 24, 20};
    print("rips", "uniform", session,
          session.points(NETMESH_FILTER_RIPS, 1, dim < 4 ? 2 : 1, inputs::uniform(dim, number[d])));
    print("rips", "grid", session, session.points(NETMESH_FILTER_RIPS, 1, 1, inputs::grid(dim, dim < 4 ? 4 : 2)));
    print("cech", "uniform", session, session.points(NETMESH_FILTER_CECH, 1, 1, inputs::uniform(dim, number[d])));
    print("cech", "grid", session, session.points(NETMESH_FILTER_CECH, 1, 2, inputs::grid(dim, dim < 3 ? 4 : 2)));
    print("barycentric-cech", "uniform", session,
          session.points(NETMESH_FILTER_BARYCENTRIC_CECH, 2, 1, inputs::uniform(dim, 9)));
    print("barycentric-rips", "uniform", session,
          session.points(NETMESH_FILTER_BARYCENTRIC_RIPS, 3, 0, inputs::uniform(dim, 10)));
    print("alpha", "grid", session, session.alpha(inputs::grid(dim, dim < 4 ? side[d] : 3)));
}

// Distances of the diagrams of two samples, as the bits that netmesh_bottleneck returns.
void distances() {
    Session a(2), b(2);
    const bool made = a.alpha(inputs::shell(2, 500, 0.5, 1, 1)) == NETMESH_OK &&
                      b.alpha(inputs::shell(2, 500, 0.5, 1, 2)) == NETMESH_OK;
    const std::vector<netmesh_pair> x = a.pairs(), y = b.pairs();
    const std::size_t bytes = netmesh_bottleneck_bytes(x.size(), y.size());
    void* const scratch = std::aligned_alloc(16, (bytes + 15) / 16 * 16);
    for (const netmesh_scale scale : {NETMESH_SCALE_PLAIN, NETMESH_SCALE_LOG}) {
        netmesh_distance d = {};
        const netmesh_status status = netmesh_bottleneck(x.data(), x.size(), y.data(), y.size(), NETMESH_ALL_DEGREES,
                                                         scale, scratch, bytes, nullptr, nullptr, &d);
        failed = failed || !made || status != NETMESH_OK;
        std::printf("bottleneck %s distance %a exponent %" PRId32 "\n", scale == NETMESH_SCALE_LOG ? "log" : "plain",
                    d.value, d.exponent);
    }
    std::free(scratch);
}

// The complex of all faces of some cells, with values by formula and negative ones among them, and a cycle for each bar.
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
    Session session(2);
    const netmesh_status status = session.until_it_fits(netmesh_homology_bytes(values.size(), list.size()), [&] {
        return netmesh_homology(session.context, list.data(), starts.data(), values.data(), values.size(), 3, 0, 1,
                                &session.options);
    });
    print("homology", "joined", session, status);
    std::printf("homology cycles %016" PRIx64 "\n", hash_of_cycles(session));
}

}  // namespace

int main(int argc, char** argv) {
    const bool small = argc > 1 && std::strcmp(argv[1], "small") == 0;
    for (int dim = NETMESH_DIM_MIN; dim <= NETMESH_DIM_MAX; ++dim) dimension(dim);
    distances();
    homology();
    if (!small) {
        Session session(4);
        session.request.tau = 3.08;
        print("persist", "clifford", session, session.mesh_and_persist(inputs::clifford(2000)));
    }
    return failed ? 1 : 0;
}
