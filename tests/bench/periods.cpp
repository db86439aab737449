// Times of diagrams with all periods over times without, of uniform points. Runs go in pairs, one of each after the
// other, and the least of each counts.
//
//   bench_periods [--runs N]
#include <vector>

#include "bench/pairs.hpp"

int main(int argc, char** argv) {
    const int runs = argc > 2 ? std::atoi(argv[2]) : 5;
    void* const block = std::aligned_alloc(4096, pairs::block_bytes);
    const pairs::Job jobs[] = {{2, 10000}, {2, 100000}, {3, 1000}, {3, 10000}, {3, 100000}, {4, 1000}};
    std::printf("%-14s %9s %9s %6s %7s %10s\n", "uniform points", "without", "with", "ratio", "copies", "bytes/pt");
    for (const pairs::Job& job : jobs) {
        std::uint64_t state = 1;
        std::vector<double> x(job.points * job.dim), lattice(job.dim * job.dim, 0.0);
        for (double& c : x) c = pairs::uniform(&state);
        for (std::uint32_t k = 0; k < job.dim; ++k) lattice[k * job.dim + k] = 1;
        netmesh_request without = netmesh_default_request();
        without.filter = &netmesh_filter_alpha;
        without.points.coordinates = x.data();
        without.points.count = job.points;
        without.points.dim = job.dim;
        netmesh_request with = without;
        with.points.lattice = lattice.data();
        with.points.lattice_count = job.dim;
        with.periods = &netmesh_periodic;
        const pairs::Pair pair = pairs::run(block, without, with, runs);
        const double n = static_cast<double>(job.points);
        std::printf("%uD %-11zu %9.4f %9.4f %6.2f %7.2f %+10.1f\n", job.dim, job.points, pair.without.least,
                    pair.with.least, pair.ratio(), static_cast<double>(pair.with.report.input.copies) / n,
                    (pair.with.peak() - pair.without.peak()) / n);
        std::fflush(stdout);
    }
    return 0;
}
