// What comes after a diagram, in processor time: bottleneck distances against GUDHI's exact ones, Wasserstein
// distances, which Debian has no peer for, and cycles for every bar of the Clifford set against the diagram alone.
//
//   diagrams [bars of a diagram, 10000] [points of the Clifford set, 2000] [GUDHI up to so many bars, 1000]
#include <gudhi/Bottleneck.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>
#include <vector>

#include "common/inputs.hpp"
#include "common/session.hpp"
#include "common/wasserstein.hpp"

namespace {

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

using Diagram = std::vector<netmesh_pair>;

// Bars far from the diagonal, short ones with few long ones, such as degree 0 has, all born at 0, or those of `moved`
// moved by up to 0.02.
Diagram bars(int kind, std::size_t count, std::uint64_t seed, const Diagram* moved) {
    inputs::Random random(seed);
    Diagram diagram;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.uniform(), y = random.uniform();
        if (moved != nullptr) {
            diagram.push_back(bar(1, (*moved)[i].birth + 0.01 * x, (*moved)[i].death + 0.01 * (1 + y)));
        } else if (kind == 2) {
            diagram.push_back(bar(1, 0, -std::log(1 - x)));
        } else {
            diagram.push_back(bar(1, 0.1 + x, 0.1 + x + (kind == 1 ? 0.2 * y * y * y : y)));
        }
    }
    return diagram;
}

void compare(const char* name, const Diagram& a, const Diagram& b, std::size_t gudhi_most) {
    netmesh_bottleneck_request request = bottleneck_request(a, b, NETMESH_SCALE_PLAIN, 1);
    const Scratch scratch(request);
    scratch.lend(&request);
    auto plain = netmesh::sized<netmesh_distance>(), log = plain;
    const double start = seconds();
    netmesh_status status = netmesh_bottleneck(&request, &plain, nullptr);
    const double between = seconds();
    request.scale = NETMESH_SCALE_LOG;
    if (status == NETMESH_OK) status = netmesh_bottleneck(&request, &log, nullptr);
    const double end = seconds();
    if (status != NETMESH_OK)
        return static_cast<void>(std::printf("bottleneck %s: %s\n", name, netmesh_status_text(status)));
    std::printf("bottleneck %-8s %6zu bars  plain %8.4f s  log %8.4f s  distance %.12g", name, a.size(),
                between - start, end - between, plain.value);
    if (a.size() <= gudhi_most) {
        std::vector<std::pair<double, double>> x, y;
        for (const netmesh_pair& p : a) x.emplace_back(p.birth, p.death);
        for (const netmesh_pair& p : b) y.emplace_back(p.birth, p.death);
        const double before = seconds();
        const double theirs = Gudhi::persistence_diagram::bottleneck_distance(x, y, 0.);
        std::printf("  GUDHI %8.4f s  %.12g", seconds() - before, theirs);
    }
    std::printf("\n");
}

void transport(const char* name, const Diagram& a, const Diagram& b) {
    for (const std::uint32_t order : {1u, 2u}) {
        const double start = seconds();
        const Transport found = wasserstein(wasserstein_request(a, b, order, 0.001, 1));
        std::printf("wasserstein %-8s order %u %6zu bars  %8.4f s  from %.12g to %.12g\n", name, order, a.size(),
                    seconds() - start, found.lower, found.value);
    }
}

void cycles(std::size_t points) {
    Session session(4);
    session.request.mesh.tau = 3.08;
    session.reserve(points << 20);  // a quarter of that is used, the rest costs nothing
    const inputs::Points p = inputs::clifford(points);
    const double start = seconds();
    session.mesh_in_block(p, &netmesh_filter_complete);
    const double meshed = seconds();
    double diagram = HUGE_VAL, represent = HUGE_VAL;
    netmesh_status status = NETMESH_OK;
    for (int round = 0; round < 3; ++round) {
        const double begin = seconds();
        session.persist();
        const double between = seconds();
        status = session.represent();
        diagram = std::min(diagram, between - begin);
        represent = std::min(represent, seconds() - between);
    }
    std::uint64_t total = 0, count = 0, pairs = 0;
    for (; netmesh_get_cycle(session.context, pairs, &count) == NETMESH_OK; ++pairs) total += count;
    std::printf("clifford %zu points: mesh %.2f s, diagram %.2f s, cycles %.2f s (%s), together %.2f of the diagram, "
                "%llu bars with %llu simplices in cycles\n",
                points, meshed - start, diagram, represent, netmesh_status_text(status), 1 + represent / diagram,
                static_cast<unsigned long long>(pairs), static_cast<unsigned long long>(total));
}

}  // namespace

int main(int argc, char** argv) {
    const auto argument = [&](int i, std::size_t otherwise) {
        return argc > i ? static_cast<std::size_t>(std::strtoull(argv[i], nullptr, 10)) : otherwise;
    };
    const std::size_t most = argument(1, 10000), gudhi_most = argument(3, 1000);
    for (const std::size_t count : {most / 10, most}) {
        const Diagram far = bars(0, count, 1, nullptr), near = bars(1, count, 3, nullptr);
        compare("far", far, bars(0, count, 2, nullptr), gudhi_most);
        compare("short", near, bars(1, count, 4, nullptr), gudhi_most);
        compare("moved", far, bars(0, count, 5, &far), gudhi_most);
    }
    for (const std::size_t count : {most / 10, most / 2}) {
        const Diagram far = bars(0, count, 1, nullptr), near = bars(1, count, 3, nullptr);
        transport("far", far, bars(0, count, 2, nullptr));
        transport("short", near, bars(1, count, 4, nullptr));
        transport("moved", far, bars(0, count, 5, &far));
        transport("births 0", bars(2, count, 6, nullptr), bars(2, count, 7, nullptr));
    }
    cycles(argument(2, 2000));
    return 0;
}
