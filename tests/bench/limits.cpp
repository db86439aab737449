// What this machine can do at best, and how far from it each job is.
//
//   limits [--scale S]
//
// First the machine, one core: nanoseconds of a load that waits for the one before, by the size of the memory that is
// jumped about in; bytes a second of copying; of touching pages for the first time; products and sums of doubles a
// second, as the compiler makes them of a plain loop without contraction.
//
// Then jobs on uniform points. `floor` is the time in which the machine would read the input once, touch the pages of
// the job's block for the first time and write the result once: no program is faster that keeps its result in fresh
// memory. `times` is how often the floor goes into the time taken. `waits` is the time for each thing made (cells or
// simplices), in loads from the largest memory that wait for one another: a job that jumped to one fresh place for each
// thing it makes would have 1. --scale: factor on the numbers of points (1).
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <numeric>
#include <vector>

#include "common/calls.hpp"

namespace {

double now() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// The least of some runs: a limit is what the machine can do when nothing disturbs it.
template <class Job> double best_of(int runs, Job job) {
    double best = 1e300;
    for (int r = 0; r < runs; ++r) {
        const double start = now();
        job();
        best = std::min(best, now() - start);
    }
    return best;
}

volatile std::size_t sink;

// One cycle through lines of 64 bytes in random order (Sattolo).
double load_seconds(std::size_t bytes) {
    struct Line {
        std::uint32_t next;
        char rest[60];
    };
    const auto count = static_cast<std::uint32_t>(bytes / sizeof(Line));
    std::vector<Line> lines(count);
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    inputs::Random random(1);
    for (std::uint32_t i = count - 1; i > 0; --i)
        std::swap(order[i], order[static_cast<std::uint32_t>(random.uniform() * i)]);
    for (std::uint32_t i = 0; i < count; ++i) lines[order[i]].next = order[(i + 1) % count];
    constexpr int loads = 2000000;
    const double seconds = best_of(3, [&] {
        std::uint32_t at = order[0];
        for (int i = 0; i < loads; ++i) at = lines[at].next;
        sink = at;
    });
    return seconds / loads;
}

struct Machine {
    double load_seconds, copy_bytes, fresh_bytes;  // a load from far away; a second
};

Machine measure_machine() {
    constexpr std::size_t large = std::size_t{256} << 20;
    Machine machine = {};
    std::printf("a load that waits for the one before:");
    for (const std::size_t bytes : {std::size_t{16} << 10, std::size_t{256} << 10, std::size_t{8} << 20, large}) {
        machine.load_seconds = load_seconds(bytes);
        std::printf("  %.1f ns in %zu KiB", 1e9 * machine.load_seconds, bytes >> 10);
    }
    std::vector<char> from(large, 1), to(large, 2);
    machine.copy_bytes = static_cast<double>(large) / best_of(5, [&] { std::memcpy(to.data(), from.data(), large); });
    machine.fresh_bytes = static_cast<double>(large) / best_of(5, [&] {
                              const std::unique_ptr<char, decltype(&std::free)> block(
                                  static_cast<char*>(std::aligned_alloc(4096, large)), &std::free);
                              for (std::size_t at = 0; at < large; at += 4096) block.get()[at] = 1;
                              sink = static_cast<std::size_t>(block.get()[large / 2]);
                          });
    constexpr std::size_t doubles = 2048;
    constexpr int rounds = 20000;
    std::vector<double> x(doubles, 0.5), y(doubles, 1e-9);
    const double arithmetic = best_of(5, [&] {
        for (int r = 0; r < rounds; ++r)
            for (std::size_t i = 0; i < doubles; ++i) x[i] = x[i] * 0.999 + y[i];
        sink = x[7] > 0 ? 1 : 0;
    });
    std::printf("\ncopying %.1f GB/s; pages touched for the first time %.1f GB/s; %.1f products and sums of doubles "
                "a ns\n\n",
                1e-9 * machine.copy_bytes, 1e-9 * machine.fresh_bytes, 2e-9 * doubles * rounds / arithmetic);
    return machine;
}

// A job in a fresh block. made: cells or simplices.
struct Job {
    const char* name;
    int dim;
    double points;
    const char* what;
    netmesh_status (*run)(Calls&, const inputs::Points&);
    double (*made)(const netmesh_report&);
};

netmesh_status triangulate(Calls& calls, const inputs::Points& points) { return calls.delaunay_in_block(points); }
netmesh_status mesh(Calls& calls, const inputs::Points& points) { return calls.mesh_in_block(points); }
netmesh_status alpha(Calls& calls, const inputs::Points& points) {
    netmesh::Request r = calls.alpha_request(points);
    r.keep_mesh = 1;
    return calls.persist(r);
}
netmesh_status complete(Calls& calls, const inputs::Points& points) {
    const netmesh::Request r = calls.mesh_request(points, &netmesh_filter_complete);
    const netmesh_status status = netmesh_mesh(calls.context, &r);
    return status == NETMESH_OK ? calls.persist(&netmesh_filter_complete) : status;
}
double cells_created(const netmesh_report& r) { return static_cast<double>(r.mesh.cells_created); }
double simplices(const netmesh_report& r) { return static_cast<double>(r.diagram.simplices); }

constexpr Job jobs[] = {
    {"Delaunay", 2, 1e6, "cell created", triangulate, cells_created},
    {"Delaunay", 3, 2e5, "cell created", triangulate, cells_created},
    {"Delaunay", 4, 1e4, "cell created", triangulate, cells_created},
    {"quality mesh", 2, 1e5, "cell created", mesh, cells_created},
    {"quality mesh", 3, 1e4, "cell created", mesh, cells_created},
    {"alpha diagram", 2, 1e5, "simplex", alpha, simplices},
    {"alpha diagram", 3, 1e5, "simplex", alpha, simplices},
    {"complete diagram", 2, 1e5, "simplex", complete, simplices},
    {"complete diagram", 3, 5e3, "simplex", complete, simplices},
};

bool measure_job(const Job& job, double scale, const Machine& machine) {
    const inputs::Points points = inputs::uniform(job.dim, static_cast<std::size_t>(job.points * scale));
    constexpr std::size_t bytes = std::size_t{8} << 30;  // pages that are not touched cost nothing
    double seconds = 1e300;
    netmesh_report report = {};
    for (int r = 0; r < 3; ++r) {
        const std::unique_ptr<void, decltype(&std::free)> block(std::aligned_alloc(4096, bytes), &std::free);
        Calls calls(job.dim);
        if (block == nullptr || netmesh_init(block.get(), bytes, &calls.context) != NETMESH_OK) return false;
        const double start = now();
        if (job.run(calls, points) != NETMESH_OK) {
            std::printf("%-17s %dD %s\n", job.name, job.dim, calls.detail().message);
            return false;
        }
        seconds = std::min(seconds, now() - start);
        report = calls.report();
    }
    const double input = static_cast<double>(points.size() * sizeof(double));
    const double peak = static_cast<double>(report.memory.peak_bytes);
    const double kept = static_cast<double>(report.memory.used_bytes);
    const double least = (input + kept) / machine.copy_bytes + peak / machine.fresh_bytes;
    const double made = job.made(report), each = seconds / made;
    std::printf("%-17s %dD %8zu %8.3f %9.3f %7.1f %9.0f ns a %-12s %6.2f\n", job.name, job.dim,
                points.size() / static_cast<std::size_t>(job.dim), seconds, least, seconds / least, 1e9 * each,
                job.what, each / machine.load_seconds);
    std::fflush(stdout);
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const double scale = argc == 3 && std::strcmp(argv[1], "--scale") == 0 ? std::atof(argv[2]) : 1;
    if (!(scale > 0) || argc == 2 || argc > 3) {
        std::fprintf(stderr, "limits [--scale S], S > 0\n");
        return 2;
    }
    const Machine machine = measure_machine();
    std::printf("%-20s %8s %8s %9s %7s %9s %-17s %6s\n", "", "points", "seconds", "floor", "times", "", "", "waits");
    bool ok = true;
    for (const Job& job : jobs) ok = measure_job(job, scale, machine) && ok;
    return ok ? 0 : 1;
}
