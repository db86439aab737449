// Times with weights over times without, of uniform points: triangulation, and diagram of points alone. Runs go in
// pairs, one of each after the other, and the least of each counts.
//
//   bench_weights [--runs N]
#include <vector>

#include "bench/pairs.hpp"

int main(int argc, char** argv) {
    const int runs = argc > 2 ? std::atoi(argv[2]) : 5;
    void* const block = std::aligned_alloc(4096, pairs::block_bytes);
    const pairs::Job jobs[] = {{2, 100000}, {3, 50000}, {4, 3000}};
    std::printf("%-46s %9s %9s %6s %7s %9s\n", "uniform points", "without", "with", "ratio", "hidden", "bytes/pt");
    for (const pairs::Job& job : jobs)
        for (int is_mesh = 1; is_mesh >= 0; --is_mesh)
            for (int kind = 0; kind < 3; ++kind) {
                std::uint64_t state = 1;
                std::vector<double> x(job.points * job.dim), numbers(job.points);
                for (double& c : x) c = pairs::uniform(&state);
                // The mean distance of neighbours, about.
                double spacing = 1;
                for (int i = 0; i < 2000; ++i) {
                    double volume = 1;
                    for (std::uint32_t c = 0; c < job.dim; ++c) volume *= spacing;
                    if (volume * static_cast<double>(job.points) < 1) break;
                    spacing *= 0.98;
                }
                const double most = kind == 0 ? 0 : kind == 1 ? 0.5 : 1.5;
                for (double& r : numbers) r = most * spacing * pairs::uniform(&state);
                netmesh_request without = netmesh_default_request();
                without.filter = &netmesh_filter_alpha;
                without.points.coordinates = x.data();
                without.points.count = job.points;
                without.points.dim = job.dim;
                netmesh_request with = without;
                with.points.weights = numbers.data();
                with.weighting = &netmesh_radii;
                const pairs::Pair pair = pairs::run(block, without, with, runs, is_mesh != 0);
                char name[80];
                std::snprintf(name, sizeof name, "%uD %zu, %s, radii to %.1f spacings", job.dim, job.points,
                              is_mesh != 0 ? "triangulation" : "diagram", most);
                std::printf("%-46s %9.4f %9.4f %6.2f %7llu %+9.1f\n", name, pair.without.least, pair.with.least,
                            pair.ratio(), static_cast<unsigned long long>(pair.with.report.input.hidden),
                            (pair.with.peak() - pair.without.peak()) / static_cast<double>(job.points));
                std::fflush(stdout);
            }
    return 0;
}
