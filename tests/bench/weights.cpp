// Times with weights over times without, of uniform points: triangulation, and diagram of points alone. Runs go in
// pairs, one of each after the other, and the least of each counts.
//
//   bench_weights [--runs N]
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

double seconds_of(void* block, std::size_t bytes, const netmesh_request& request, bool is_mesh, std::uint64_t* hidden,
                  std::uint64_t* peak) {
    netmesh_context* context;
    if (netmesh_init(block, bytes, &context) != NETMESH_OK) std::abort();
    const auto start = std::chrono::steady_clock::now();
    const netmesh_status status = is_mesh ? netmesh_mesh(context, &request) : netmesh_persist(context, &request);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    netmesh_report report = {};
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    if (status != NETMESH_OK) std::printf("status %d\n", status);
    *hidden = report.input.hidden;
    *peak = report.memory.peak_bytes;
    return taken.count();
}

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 2 ? std::atoi(argv[2]) : 5;
    const std::size_t bytes = std::size_t(1) << 30;
    void* const block = std::aligned_alloc(4096, bytes);
    const Job jobs[] = {{2, 100000}, {3, 50000}, {4, 3000}};
    std::printf("%-46s %9s %9s %6s %7s %9s\n", "uniform points", "without", "with", "ratio", "hidden", "bytes/pt");
    for (const Job& job : jobs)
        for (int is_mesh = 1; is_mesh >= 0; --is_mesh)
            for (int kind = 0; kind < 3; ++kind) {
                std::uint64_t state = 1;
                std::vector<double> x(job.points * job.dim), numbers(job.points);
                for (double& c : x) c = uniform(&state);
                // The mean distance of neighbours, about.
                double spacing = 1;
                for (int i = 0; i < 2000; ++i) {
                    double volume = 1;
                    for (std::uint32_t c = 0; c < job.dim; ++c) volume *= spacing;
                    if (volume * static_cast<double>(job.points) < 1) break;
                    spacing *= 0.98;
                }
                const double most = kind == 0 ? 0 : kind == 1 ? 0.5 : 1.5;
                for (double& r : numbers) r = most * spacing * uniform(&state);
                netmesh_request without = netmesh_default_request();
                without.filter = &netmesh_filter_alpha;
                without.points.coordinates = x.data();
                without.points.count = job.points;
                without.points.dim = job.dim;
                netmesh_request with = without;
                with.points.weights = numbers.data();
                with.weighting = &netmesh_radii;
                double least[2] = {1e9, 1e9};
                std::uint64_t hidden = 0, peak[2] = {};
                for (int run = 0; run < runs; ++run) {
                    const double a = seconds_of(block, bytes, without, is_mesh != 0, &hidden, &peak[0]);
                    const double b = seconds_of(block, bytes, with, is_mesh != 0, &hidden, &peak[1]);
                    if (a < least[0]) least[0] = a;
                    if (b < least[1]) least[1] = b;
                }
                char name[80];
                std::snprintf(name, sizeof name, "%uD %zu, %s, radii to %.1f spacings", job.dim, job.points,
                              is_mesh != 0 ? "triangulation" : "diagram", most);
                std::printf("%-46s %9.4f %9.4f %6.2f %7llu %+9.1f\n", name, least[0], least[1], least[1] / least[0],
                            static_cast<unsigned long long>(hidden),
                            (static_cast<double>(peak[1]) - static_cast<double>(peak[0])) /
                                static_cast<double>(job.points));
                std::fflush(stdout);
            }
    return 0;
}
