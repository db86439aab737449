// Times of certified diagrams with bounds over times without, filter complete, and what bounds take of memory. Runs go
// in pairs, one of each after the other, and the least of each counts.
//
//   bench_bounds [--runs N]
#include "bench/pairs.hpp"
#include "common/inputs.hpp"

int main(int argc, char** argv) {
    const int runs = argc > 2 ? std::atoi(argv[2]) : 5;
    void* const block = std::aligned_alloc(4096, pairs::block_bytes);
    const struct {
        const char* name;
        int dim;
        inputs::Points points;
    } sets[] = {
        {"2D 10,000 uniform", 2, inputs::uniform(2, 10000)},
        {"2D 3,000 of an annulus", 2, inputs::shell(2, 3000, 0.8, 1, 1)},
        {"2D 2,000 of an eight with noise", 2, inputs::eight(2000, 0.1, 1)},
        {"2D 3,000 in clusters", 2, inputs::clusters(2, 3000)},
        {"3D 2,000 uniform", 3, inputs::uniform(3, 2000)},
        {"3D 2,000 of a torus", 3, inputs::torus(2000, 1)},
        {"3D 1,000 of a shell", 3, inputs::shell(3, 1000, 0.9, 1, 1)},
        {"3D 1,000 of a grid with noise", 3, inputs::jittered(3, 10, 0.2, 1)},
        {"4D 300 uniform", 4, inputs::uniform(4, 300)},
        {"4D 2,000 of the set of 7.7", 4, inputs::clifford(2000)},
    };
    std::printf("%-32s %9s %9s %6s %7s %9s %9s\n", "set", "without", "with", "ratio", "memory", "bars", "exist");
    for (const auto& set : sets) {
        netmesh_request without = netmesh_default_request();
        without.filter = &netmesh_filter_complete;
        without.mesh.tau = 3.08;
        without.points.coordinates = set.points.data();
        without.points.dim = static_cast<std::uint32_t>(set.dim);
        without.points.count = set.points.size() / static_cast<std::size_t>(set.dim);
        netmesh_request with = without;
        with.bounds = &netmesh_bounds;
        const pairs::Pair pair = pairs::run(block, without, with, runs);
        // Bars of degree 1 and above, and how many of these are certified to exist.
        netmesh_context* context;
        std::uint64_t bars = 0, exist = 0;
        if (netmesh_init(block, pairs::block_bytes, &context) == NETMESH_OK &&
            netmesh_persist(context, &with) == NETMESH_OK) {
            netmesh_pair bar = {};
            bar.struct_bytes = sizeof bar;
            for (std::uint64_t i = 0; netmesh_get_pair(context, i, &bar) == NETMESH_OK; ++i) {
                netmesh_bar_bounds bounds = {};
                bounds.struct_bytes = sizeof bounds;
                if (bar.degree == 0 || netmesh_get_bar_bounds(context, i, &bounds) != NETMESH_OK) continue;
                ++bars;
                exist += bounds.certain;
            }
        }
        std::printf("%-32s %9.4f %9.4f %6.2f %7.2f %9llu %9llu\n", set.name, pair.without.least, pair.with.least,
                    pair.ratio(), pair.with.peak() / pair.without.peak(), static_cast<unsigned long long>(bars),
                    static_cast<unsigned long long>(exist));
        std::fflush(stdout);
    }
    return 0;
}
