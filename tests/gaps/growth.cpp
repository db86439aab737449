// The order of growth: instructions a point on 100,000 points over those on 10,000, of ten jobs on uniform points. What
// is linear has 1; sorts and searches add a little, and a step that looks at all of the rest has 10. No clock, so that
// no machine is too slow for it.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "common/calls.hpp"
#include "gaps/counted.hpp"

namespace {

constexpr std::size_t few = 10000, many = 100000, block_bytes = std::size_t{3} << 30;

struct Growing {
    const char* name;
    int dim;
    double limit;  // 5% above what was measured
    netmesh_status (*run)(Calls&, const inputs::Points&);
};

template <class Change> netmesh_status mesh(Calls& calls, const inputs::Points& points, const Change& change) {
    netmesh::Request request = calls.mesh_request(points);
    change(request);
    return netmesh_mesh(calls.context, &request);
}

const Growing jobs[] = {
    {"Delaunay", 2, 1.07, [](Calls& c, const inputs::Points& p) { return c.delaunay_in_block(p); }},
    {"Delaunay", 3, 1.06, [](Calls& c, const inputs::Points& p) { return c.delaunay_in_block(p); }},
    {"alpha", 2, 1.11, [](Calls& c, const inputs::Points& p) { return c.persist(c.alpha_request(p)); }},
    {"alpha", 3, 1.08, [](Calls& c, const inputs::Points& p) { return c.persist(c.alpha_request(p)); }},
    {"auto", 2, 1.06,
     [](Calls& c, const inputs::Points& p) {
         const netmesh::Request request = c.auto_request(p);
         return netmesh_persist(c.context, &request);
     }},
    {"quality mesh", 2, 1.05, [](Calls& c, const inputs::Points& p) { return mesh(c, p, [](auto&) {}); }},
    {"mesh by ratio", 2, 1.05,
     [](Calls& c, const inputs::Points& p) {
         netmesh::Request request = c.mesh_request(p, &netmesh_filter_complete);
         request.mesh.method = nullptr;
         request.goal.ratio = 2.25;
         return netmesh_persist(c.context, &request);
     }},
    {"hierarchy", 2, 1.05,
     [](Calls& c, const inputs::Points& p) {
         return mesh(c, p, [](auto& r) { r.mesh.method = &netmesh_method_netmesh; });
     }},
    {"complete, with bounds", 2, 1.22,
     [](Calls& c, const inputs::Points& p) {
         const netmesh_status made = c.mesh_in_block(p, &netmesh_filter_complete);
         if (made != NETMESH_OK) return made;
         const netmesh_status filtered = c.persist(&netmesh_filter_complete);
         return filtered == NETMESH_OK ? c.bound_bars() : filtered;
     }},
    {"rips, short edges", 2, 1.13,
     [](Calls& c, const inputs::Points& p) {
         netmesh::Request request(&netmesh_filter_rips);
         request.set_points(2, p);
         request.max_degree = 1;
         request.threshold = 0.75 / std::sqrt(static_cast<double>(p.size() / 2));
         return netmesh_persist(c.context, &request);
     }},
};

// Instructions a point; 0: the job failed.
double instructions(const Growing& job, std::size_t n) {
    const inputs::Points points = inputs::uniform(job.dim, n);
    void* const block = std::aligned_alloc(16, block_bytes);
    Calls calls(job.dim);
    if (block == nullptr || netmesh_init(block, block_bytes, &calls.context) != NETMESH_OK) return 0;
    const std::uint64_t begin = counted();
    const netmesh_status status = job.run(calls, points);
    const std::uint64_t taken = counted() - begin;
    std::free(block);
    return status == NETMESH_OK ? static_cast<double>(taken) / static_cast<double>(n) : 0;
}

}  // namespace

int check_growth() {
    std::printf("instructions a point   D  of 10,000  of 100,000  ratio  at most\n");
    int wrong = 0;
    for (const Growing& job : jobs) {
        const double before = instructions(job, few), after = instructions(job, many), ratio = after / before;
        const bool good = before > 0 && after > 0 && ratio <= job.limit;
        std::printf("%-22s %d %10.0f %11.0f %7.3f %7.2f%s\n", job.name, job.dim, before, after, ratio, job.limit,
                    good ? "" : "  WRONG");
        std::fflush(stdout);
        wrong += good ? 0 : 1;
    }
    std::printf("%d of %d jobs grow by more\n", wrong, static_cast<int>(sizeof jobs / sizeof jobs[0]));
    return wrong == 0 ? 0 : 1;
}
