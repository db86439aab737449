// Which bars of the experiment of 7.7 are certified to exist: 2,000 points of the curve on the Clifford torus, on a
// mesh of tau 4 whose cells have an out-radius of at most SIZE (0.16) where the points are FROM (0.95) or more away.
//
//   bench_sure [SIZE [FROM]]
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "common/session.hpp"

namespace {

struct Wish {
    inputs::Points points;
    double size, from;
};

double size_of(void* user, const double* x) {
    const Wish& wish = *static_cast<const Wish*>(user);
    double nearest2 = 1e300, norm2 = 0;
    for (int k = 0; k < 4; ++k) norm2 += x[k] * x[k];
    for (std::size_t i = 0; i < wish.points.size(); i += 4) {
        double d2 = 0;
        for (std::size_t k = 0; k < 4; ++k) d2 += (x[k] - wish.points[i + k]) * (x[k] - wish.points[i + k]);
        nearest2 = std::fmin(nearest2, d2);
    }
    // Nothing is asked for outside of the 3-sphere that the curve lies on.
    return wish.size + std::fmax(0.0, wish.from - std::sqrt(nearest2)) + 2 * std::fmax(0.0, std::sqrt(norm2) - 1.45);
}

}  // namespace

int main(int argc, char** argv) {
    Wish wish = {inputs::clifford(2000), argc > 1 ? std::atof(argv[1]) : 0.16, argc > 2 ? std::atof(argv[2]) : 0.95};
    Session session(4);
    session.bounds = true;
    session.request.mesh.tau = 4;
    session.request.mesh.sizes.size = size_of;
    session.request.mesh.sizes.user = &wish;
    if (session.mesh_and_persist(wish.points) != NETMESH_OK) return 1;
    const netmesh_report report = session.report();
    std::printf("%" PRIu64 " vertices, certified ratio %.4f\n", report.mesh.vertices, report.diagram.certified_ratio);
    const std::vector<netmesh_pair> pairs = session.pairs();
    const std::vector<netmesh_bar_bounds> bounds = read_all(session.context, netmesh_get_bar_bounds);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const netmesh_bar_bounds& b = bounds[i];
        if (pairs[i].degree == 0 || b.certain == 0) continue;
        std::printf("H%" PRIu32 " %.4f %.4f certified to exist: born in %.4f .. %.4f, dies in %.4f .. %.4f\n",
                    pairs[i].degree, pairs[i].birth, pairs[i].death, b.birth_low, b.birth_high, b.death_low,
                    b.death_high);
    }
    return 0;
}
