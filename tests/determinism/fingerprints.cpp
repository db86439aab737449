// Prints the fingerprints of a fixed set of jobs, one a line: job, input, dimension, fingerprint of the input,
// fingerprint of the result, sizes. Inputs are made with + - * / alone, so every line must be the same on every
// compiler, optimisation level and processor.
//
//   fingerprints [small]      small: without the Clifford set
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "common/session.hpp"

namespace {

bool failed = false;

void print(const char* job, const char* input, const Session& session, netmesh_status status) {
    if (status != NETMESH_OK) {
        std::printf("%s %s D%" PRIu32 " failed: %s\n", job, input, session.options.dim, netmesh_status_text(status));
        failed = true;
        return;
    }
    const netmesh_report r = session.report();
    std::uint64_t pairs = 0;
    for (std::uint32_t k = 0; k < r.dim; ++k) pairs += r.has_diagram ? r.pairs[k] : 0;
    std::printf("%s %s D%" PRIu32 " input %016" PRIx64 " result %016" PRIx64 " vertices %" PRIu64 " cells %" PRIu64 " pairs %" PRIu64 "\n",
                job, input, r.dim, r.input_fingerprint, r.fingerprint, r.vertices, r.cells, pairs);
    std::fflush(stdout);
}

void dimension(int dim) {
    const std::size_t d = static_cast<std::size_t>(dim);
    const std::size_t points[] = {0, 0, 2000, 1000, 300, 120, 50}, meshed[] = {0, 0, 400, 150, 40, 12, 6};
    const int side[] = {0, 0, 20, 6, 4, 3, 2};
    Session session(dim);
    print("delaunay", "uniform", session, session.delaunay(inputs::uniform(dim, points[d])));
    print("delaunay", "clusters", session, session.delaunay(inputs::clusters(dim, points[d])));
    print("delaunay", "grid", session, session.delaunay(inputs::grid(dim, side[d])));
    print("delaunay", "zoom", session, session.delaunay(inputs::zoom(dim, 1000, 20)));
    print("delaunay", "repeated", session, session.delaunay(inputs::repeated(dim, inputs::uniform(dim, points[d] / 2), 2)));
    print("mesh", "uniform", session, session.mesh(inputs::uniform(dim, meshed[d])));
    print("mesh", "clusters", session, session.mesh(inputs::clusters(dim, meshed[d])));
    session.options.method = NETMESH_METHOD_NETMESH;
    print("netmesh", "clusters", session, session.mesh(inputs::clusters(dim, meshed[d])));
    print("netmesh", "geometric", session, session.mesh(inputs::geometric(dim, 1000, dim < 5 ? 40 : 10)));
    session.options.finish = 1;
    print("netmesh-finish", "clusters", session, session.mesh(inputs::clusters(dim, meshed[d] / 4)));
    session.options.finish = 0;
    session.options.method = NETMESH_METHOD_REFINE;
    if (dim < 4) print("refine", "uniform", session, session.mesh(inputs::uniform(dim, meshed[d] / 4)));
    session.options.method = NETMESH_METHOD_SVR;
    print("persist", "uniform", session, session.mesh_and_persist(inputs::uniform(dim, meshed[d])));
    print("persist", "grid", session, session.mesh_and_persist(inputs::grid(dim, dim < 4 ? 5 : 2)));
    print("persist-basic", "uniform", session, session.mesh_and_persist(inputs::uniform(dim, meshed[d]), NETMESH_FILTER_BASIC, NETMESH_VALUES_THESIS));
    print("alpha", "uniform", session, session.alpha(inputs::uniform(dim, points[d] / 2)));
    print("alpha", "grid", session, session.alpha(inputs::grid(dim, dim < 4 ? side[d] : 3)));
}

}  // namespace

int main(int argc, char** argv) {
    const bool small = argc > 1 && std::strcmp(argv[1], "small") == 0;
    for (int dim = NETMESH_DIM_MIN; dim <= NETMESH_DIM_MAX; ++dim) dimension(dim);
    if (!small) {
        Session session(4);
        session.options.tau = 3.08;
        print("persist", "clifford", session, session.mesh_and_persist(inputs::clifford(2000)));
    }
    return failed ? 1 : 0;
}
