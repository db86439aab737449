// What bounds for each bar cost: time and memory of a certified diagram with them by those of the diagram alone, mesh
// included, on ten sets in two to four dimensions; and how many bars beyond degree 0 are real.
//
//   bench_bounds [share of the points, 1]
#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "common/session.hpp"

namespace {

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Run {
    double time = HUGE_VAL;
    std::uint64_t bytes = 0, real = 0;
};

Run run(int dim, const inputs::Points& points, double tau, bool bounds) {
    Run best;
    for (int round = 0; round < 3; ++round) {
        Session session(dim);
        session.bounds = bounds;
        session.request.mesh.tau = tau;
        session.reserve(std::size_t{1} << 30);  // what is not used costs nothing
        const double start = seconds();
        if (session.mesh_and_persist(points) != NETMESH_OK) std::exit(1);
        best.time = std::min(best.time, seconds() - start);
        best.bytes = session.report().memory.peak_bytes;
        if (!bounds) continue;
        const std::vector<netmesh_pair> pairs = session.pairs();
        const std::vector<netmesh_bar_bounds> all = read_all(session.context, netmesh_get_bar_bounds);
        best.real = 0;
        for (std::size_t i = 0; i < all.size(); ++i) best.real += pairs[i].degree > 0 && all[i].certain != 0;
    }
    return best;
}

void compare(const char* name, int dim, const inputs::Points& points, double tau = 0) {
    const Run alone = run(dim, points, tau, false), bounded = run(dim, points, tau, true);
    std::printf("%-22s %dD %6zu points  %7.3f s  %7.3f s  time %5.2f  memory %5.2f  %" PRIu64 " real\n", name, dim,
                points.size() / static_cast<std::size_t>(dim), alone.time, bounded.time, bounded.time / alone.time,
                static_cast<double>(bounded.bytes) / static_cast<double>(alone.bytes), bounded.real);
}

}  // namespace

int main(int argc, char** argv) {
    const double share = argc > 1 ? std::atof(argv[1]) : 1;
    const auto n = [&](double count) { return static_cast<std::size_t>(count * share); };
    compare("uniform", 2, inputs::uniform(2, n(2000)));
    compare("clusters", 2, inputs::clusters(2, n(2000)));
    compare("gaussian", 2, inputs::gaussian(2, n(2000)));
    compare("uniform", 3, inputs::uniform(3, n(1000)));
    compare("clusters", 3, inputs::clusters(3, n(1000)));
    compare("gaussian", 3, inputs::gaussian(3, n(1000)));
    compare("uniform", 4, inputs::uniform(4, n(300)));
    compare("gaussian", 4, inputs::gaussian(4, n(300)));
    compare("clifford", 4, inputs::clifford(n(500)));
    compare("clifford, that of 7.7", 4, inputs::clifford(n(2000)), 3.08);
    return 0;
}
