// Does the cost of a point stay the same as there are more of them? Processor time a point over that at 1e5 uniform
// points: Delaunay triangulations, quality meshes and diagrams of the alpha complex in 2D and 3D. First in a block that
// has been written to before, then in one whose pages the system gives as they are met, which is its time, not ours.
//
//   growth [points at most, 1e6] [repetitions, 5] [names of jobs that begin with.., all]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <vector>

#include "common/calls.hpp"
#include "common/inputs.hpp"

namespace {

struct Job {
    const char* name;
    int dim;
    double points_max;  // a mesh has 4 to 7 times as many vertices as inputs
    std::size_t bytes_each;
    netmesh_status (*run)(Calls&, const inputs::Points&);
};

netmesh_status delaunay(Calls& calls, const inputs::Points& points) { return calls.delaunay_in_block(points); }
netmesh_status mesh(Calls& calls, const inputs::Points& points) { return calls.mesh_in_block(points); }
netmesh_status alpha(Calls& calls, const inputs::Points& points) { return calls.persist(calls.alpha_request(points)); }

constexpr Job jobs[] = {
    {"delaunay 2D", 2, 1e7, 260, delaunay}, {"delaunay 3D", 3, 1e7, 700, delaunay}, {"alpha 2D", 2, 1e7, 400, alpha},
    {"alpha 3D", 3, 1e6, 1000, alpha},      {"mesh 2D", 2, 1e6, 1200, mesh},        {"mesh 3D", 3, 4e5, 4000, mesh},
};

double seconds(const Job& job, const inputs::Points& points, bool touched) {
    const std::size_t n = points.size() / static_cast<std::size_t>(job.dim);
    const std::size_t bytes = (job.bytes_each * n + (std::size_t{1} << 20)) / 4096 * 4096;
    const std::unique_ptr<void, decltype(&std::free)> block(std::aligned_alloc(4096, bytes), &std::free);
    if (block == nullptr) return -1;
    if (touched) std::memset(block.get(), 1, bytes);
    netmesh_context* context;
    if (netmesh_init(block.get(), bytes, &context) != NETMESH_OK) return -1;
    Calls calls(job.dim, context);
    calls.request.mesh.tau = job.dim == 2 ? 2.5 : 3;
    const std::clock_t start = std::clock();
    const netmesh_status status = job.run(calls, points);
    const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return status == NETMESH_OK ? spent : -1;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.front() < 0 ? -1 : values[values.size() / 2];
}

void measure(const Job& job, double most, int repetitions) {
    std::vector<inputs::Points> sets;
    for (double n = 1e4; n <= std::min(most, job.points_max) * 1.001; n *= n < 1e5 || job.points_max > 4e5 ? 10 : 4)
        sets.push_back(inputs::uniform(job.dim, static_cast<std::size_t>(n)));
    for (const bool touched : {true, false}) {
        std::vector<std::vector<double>> times(sets.size());
        for (int r = 0; r < repetitions; ++r)
            for (std::size_t i = 0; i < sets.size(); ++i) times[i].push_back(seconds(job, sets[i], touched));
        std::printf("%-12s %-8s", job.name, touched ? "touched" : "fresh");
        const auto each = [&](std::size_t i) {
            return median(times[i]) / static_cast<double>(sets[i].size() / static_cast<std::size_t>(job.dim));
        };
        for (std::size_t i = 0; i < sets.size(); ++i) {
            const std::size_t n = sets[i].size() / static_cast<std::size_t>(job.dim);
            if (each(i) < 0)
                std::printf("  %8zu:  no result", n);
            else
                std::printf("  %8zu: %6.0f ns %4.2f", n, 1e9 * each(i), sets.size() > 1 ? each(i) / each(1) : 1);
        }
        std::printf("\n");
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const double most = argc > 1 ? std::atof(argv[1]) : 1e6;
    const int repetitions = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
    const char* const name = argc > 3 ? argv[3] : "";
    std::printf("processor time a point, and over that at 100000 points; medians of %d\n", repetitions);
    for (const Job& job : jobs)
        if (std::strncmp(job.name, name, std::strlen(name)) == 0) measure(job, most, repetitions);
}
