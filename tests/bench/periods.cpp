// Times of diagrams with all periods over times without, of uniform points. Runs go in pairs, one of each after the
// other, and the least of each counts.
//
//   bench_periods [--runs N]
#include <netmesh.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

double uniform(std::uint64_t* state) {
    std::uint64_t z = (*state += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

struct Job {
    std::uint32_t dim;
    std::size_t points;
};

double seconds_of(void* block, std::size_t bytes, const netmesh_request& request, netmesh_report* report) {
    netmesh_context* context;
    if (netmesh_init(block, bytes, &context) != NETMESH_OK) std::abort();
    const auto start = std::chrono::steady_clock::now();
    const netmesh_status status = netmesh_persist(context, &request);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    report->struct_bytes = sizeof *report;
    netmesh_get_report(context, report);
    if (status != NETMESH_OK) std::printf("status %d\n", status);
    return taken.count();
}

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 2 ? std::atoi(argv[2]) : 5;
    const std::size_t bytes = std::size_t(1) << 30;
    void* const block = std::aligned_alloc(4096, bytes);
    const Job jobs[] = {{2, 10000}, {2, 100000}, {3, 1000}, {3, 10000}, {3, 100000}, {4, 1000}};
    std::printf("%-14s %9s %9s %6s %7s %10s\n", "uniform points", "without", "with", "ratio", "copies", "bytes/pt");
    for (const Job& job : jobs) {
        std::uint64_t state = 1;
        std::vector<double> x(job.points * job.dim), lattice(job.dim * job.dim, 0.0);
        for (double& c : x) c = uniform(&state);
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
        double least[2] = {1e9, 1e9};
        netmesh_report report[2] = {};
        for (int run = 0; run < runs; ++run) {
            const double a = seconds_of(block, bytes, without, &report[0]);
            const double b = seconds_of(block, bytes, with, &report[1]);
            if (a < least[0]) least[0] = a;
            if (b < least[1]) least[1] = b;
        }
        const double n = static_cast<double>(job.points), taken = static_cast<double>(report[1].memory.peak_bytes) -
                                                                  static_cast<double>(report[0].memory.peak_bytes);
        std::printf("%uD %-11zu %9.4f %9.4f %6.2f %7.2f %+10.1f\n", job.dim, job.points, least[0], least[1],
                    least[1] / least[0], static_cast<double>(report[1].input.copies) / n, taken / n);
        std::fflush(stdout);
    }
    return 0;
}
