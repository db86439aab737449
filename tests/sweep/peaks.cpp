// Reported peaks against blocks: every job of the sweep runs in a large block, then in one of exactly the peak that it
// reported, where it ends well and leaves the same result to the byte. Blocks of less are counted that do as well: a
// peak that is far above what is needed would pass otherwise.
//
//   peaks [full] [JOB]...
//
// Without `full` each job as the sweep has it; with it at several numbers of points.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "common/dimensions.hpp"
#include "sweep/harness.hpp"
#include "sweep/jobs.hpp"

Disturbance disturbance;
Place place;
Tally total;
long faults = 0;

int sweep_poll(void*, const netmesh_progress*) { return 0; }

bool require(bool good, const char* what) {
    if (!good && ++faults <= 50)
        std::printf("FAULT %s D%d, %s %lld: %s\n", place.job, place.dim, place.phase, place.where, what);
    return good;
}

namespace {

struct Left {
    netmesh_status status = NETMESH_INTERNAL;
    std::uint64_t fingerprint = 0, input = 0, figures = 0, items = 0;
    std::size_t peak = 0, wanted = 0;
    friend bool operator==(const Left& a, const Left& b) {
        return a.status == b.status && a.fingerprint == b.fingerprint && a.input == b.input && a.figures == b.figures &&
               a.items == b.items && a.peak == b.peak;
    }
};

// What can be read and is not in the report's fingerprint.
std::uint64_t read_items(const netmesh_context* context) {
    std::uint64_t hash = 1, count = 0;
    const auto add = [&hash](const auto& x) {
        unsigned char bytes[sizeof x];
        std::memcpy(bytes, &x, sizeof x);
        for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001B3u + 1;
    };
    auto simplex = netmesh::sized<netmesh_simplex>();
    auto bounds = netmesh::sized<netmesh_bar_bounds>();
    auto pair = netmesh::sized<netmesh_pair>();
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i) {
        add(pair.birth);
        add(pair.death);
        if (netmesh_get_bar_bounds(context, i, &bounds) == NETMESH_OK) {
            for (const double x : {bounds.birth_low, bounds.birth_high, bounds.death_low, bounds.death_high}) add(x);
            add(bounds.certain);
        }
        if (netmesh_get_cycle(context, i, &count) != NETMESH_OK) continue;
        for (std::uint64_t n = 0; n < count; ++n)
            if (netmesh_get_cycle_simplex(context, i, n, &simplex) == NETMESH_OK)
                for (std::uint32_t k = 0; k <= simplex.degree; ++k) add(simplex.vertices[k]);
    }
    auto point = netmesh::sized<netmesh_vine_point>();
    for (std::uint64_t i = 0; netmesh_get_vine_point(context, i, &point) == NETMESH_OK; ++i) {
        add(point.birth);
        add(point.death);
    }
    return hash;
}

Left run_in(const Job& job, std::size_t bytes, bool tight) {
    Block block(bytes, tight ? 0x55 : 0xAA, tight);
    netmesh_context* context = nullptr;
    Left left;
    left.status = netmesh_init(block.base(), bytes, &context);
    if (left.status != NETMESH_OK) return left;
    Run run(job, context);
    figures_of_run = 0;
    left.status = job.steps(run);
    left.wanted = static_cast<std::size_t>(run.detail().bytes_wanted);
    const netmesh_report report = run.report();
    left.fingerprint = report.fingerprint;
    left.input = report.input.fingerprint;
    left.figures = figures_of_run;
    left.items = read_items(context);
    left.peak = static_cast<std::size_t>(report.memory.peak_bytes);
    require(block.guards_intact(), "wrote outside the block");
    return left;
}

long runs = 0, tight_runs = 0;

void check(const Job& job) {
    place = {job.name, job.dim, "points", static_cast<long long>(job.points)};
    // Inputs that a job makes for itself are made in the first run.
    std::size_t large = job.block > 0 ? job.block : std::size_t{1} << 20;
    while (run_in(job, large, false).status == NETMESH_OUT_OF_MEMORY && job.block == 0 && large < std::size_t{1} << 28)
        large *= 4;
    const Left free = run_in(job, large, false);
    if (free.status != NETMESH_OK && job.block > 0) return;  // made for the sweep's block
    if (!require(free.status == NETMESH_OK, "the run in a large block fails")) return;
    ++runs;
    const Left exact = run_in(job, free.peak, true);
    if (!require(exact == free, exact.status != NETMESH_OK ? "a block of the reported peak does not do"
                                                           : "a block of the reported peak gives another result"))
        std::printf("      peak %zu, status %d, wanted %zu, its peak %zu\n", free.peak, static_cast<int>(exact.status),
                    exact.wanted, exact.peak);
    if (free.peak >= 16 && run_in(job, free.peak - 16, true).status != NETMESH_OK) ++tight_runs;
}

}  // namespace

int main(int argc, char** argv) {
    const bool full = argc > 1 && std::strcmp(argv[1], "full") == 0;
    char** const names = argv + 1 + full;
    std::vector<Job> jobs;
    add_mesh_jobs(&jobs);
    add_diagram_jobs(&jobs);
    for (const Job& job : jobs) {
        if (!netmesh::serves_dimension(static_cast<std::uint32_t>(job.dim)) || (!full && job.is_large)) continue;
        if (*names != nullptr &&
            std::none_of(names, argv + argc, [&](const char* name) { return std::strcmp(name, job.name) == 0; }))
            continue;
        check(job);
        const std::size_t most = !full || (job.is_large && job.dim > 3) ? 0 : job.dim < 4 ? 3 : 2;
        for (std::size_t more = 1; more <= most; ++more) {
            Job larger = job;
            larger.points += more;
            check(larger);
        }
        std::fflush(stdout);
    }
    // A peak 16 bytes below which nearly every job fails is what the job needs.
    require(10 * tight_runs >= 9 * runs, "peaks are more than what jobs need");
    std::printf("%ld jobs in blocks of their peaks, %ld of which 16 bytes less do not do for; %ld faults\n", runs,
                tight_runs, faults);
    return faults == 0 && runs > 0 ? 0 : 1;
}
