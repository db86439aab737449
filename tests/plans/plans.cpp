// Planned bytes against the peaks of jobs on uniform points, and planned polls against those that come. A block of that
// size does for every set, and is at most 1.1 times the largest peak where there are enough points: how many vertices a
// mesh of a hundred points has differs from set to set by more than that, and plans do not read points. Polls are at
// most twice as many or as few, but for three, and never above their bound. Fails when one is wrong.
//
//   plans [long] [every] [D]... [JOB]...
//
// long: up to 100,000 points, an hour or so; without it up to 300, an eighth of the sets, and limits twice as wide.
// every: a line for each plan, also where all is well.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/calls.hpp"
#include "common/dimensions.hpp"

namespace {

constexpr double settled_limit = 1.1;

struct Plan {
    std::size_t bytes = 0;
    std::uint64_t polls = 0, polls_most = 0;
};

// Plans, then runs; without a context it plans alone.
using Run = std::function<netmesh_status(Calls&, const inputs::Points&, Plan* plan)>;

std::uint64_t polls = 0;
int count_poll(void*, const netmesh_progress*) {
    ++polls;
    return 0;
}

Plan plan_of(const netmesh::Request& request) {
    Plan plan;
    plan.bytes = netmesh_plan(&request);
    plan.polls = netmesh_plan_polls(&request, &plan.polls_most);
    return plan;
}
Plan plan_of_mesh(const netmesh::Request& request) {
    Plan plan;
    plan.bytes = netmesh_plan_mesh(&request);
    plan.polls = netmesh_plan_mesh_polls(&request, &plan.polls_most);
    return plan;
}
template <class Call> netmesh_status count_polls(netmesh::Request request, netmesh_context* context, const Call& call) {
    request.monitor.poll = count_poll;
    return call(context, &request);
}

struct Job {
    const char* name;
    // A plan does from a few points on. It is at most 1.1 times the largest peak of the sets from so many points on, by
    // dimension from the plane on, as far as that has been seen; from 100 points to there, at most `few` times.
    std::vector<std::size_t> settled;
    double few;
    std::vector<std::size_t> most;  // points of the long form
    Run run;
    bool estimates_polls = false;  // and no more
};

using Change = std::function<void(netmesh::Request&)>;

Run mesh(const Change& change) {
    return [change](Calls& calls, const inputs::Points& points, Plan* plan) {
        netmesh::Request request = calls.mesh_request(points);
        change(request);
        *plan = plan_of_mesh(request);
        return count_polls(request, calls.context, netmesh_mesh);
    };
}
// The mesh for a filter, and its diagram.
Run persist(const Change& change, const netmesh_filter* filter = &netmesh_filter_complete) {
    return [change, filter](Calls& calls, const inputs::Points& points, Plan* plan) {
        netmesh::Request request = calls.mesh_request(points, filter);
        change(request);
        if (request.goal.ratio > 0) request.mesh.method = nullptr;
        *plan = plan_of(request);
        return count_polls(request, calls.context, netmesh_persist);
    };
}
Run triangulation() {
    return [](Calls& calls, const inputs::Points& points, Plan* plan) {
        const netmesh::Request request = calls.delaunay_request(points);
        *plan = plan_of_mesh(request);
        return count_polls(request, calls.context, netmesh_mesh);
    };
}
// Of points alone.
Run diagram(const std::function<netmesh::Request(const Calls&, const inputs::Points&)>& request_of) {
    return [request_of](Calls& calls, const inputs::Points& points, Plan* plan) {
        const netmesh::Request request = request_of(calls, points);
        *plan = plan_of(request);
        return count_polls(request, calls.context, netmesh_persist);
    };
}
Run alpha(bool keep_mesh, const netmesh_want* cycles = nullptr) {
    return diagram([keep_mesh, cycles](const Calls& calls, const inputs::Points& points) {
        netmesh::Request request = calls.alpha_request(points);
        request.keep_mesh = keep_mesh ? 1 : 0;
        request.cycles = cycles;
        return request;
    });
}
Run either() {
    return diagram([](const Calls& calls, const inputs::Points& points) { return calls.auto_request(points); });
}
Run scales(const Change& change) {
    return diagram([change](const Calls& calls, const inputs::Points& points) {
        netmesh::Request request = calls.scales_request(points);
        change(request);
        return request;
    });
}
void ask_ratio(netmesh::Request& request, double ratio) {
    request.goal = {};
    request.goal.ratio = ratio;
}
constexpr std::size_t never = SIZE_MAX;
const std::vector<std::size_t> meshes = {1000, 3000, 3000};
const Run by_ratio = persist([](auto& r) { r.goal.ratio = 2.25; });

const std::vector<Job> jobs = {
    {"delaunay", {0, 0, 0, 0, 0}, 0, {100000, 100000, 3000, 1000, 100}, triangulation()},
    {"delaunay-alpha", {0, 0, 0, 0, 0}, 0, {100000, 100000, 3000, 300, 100}, alpha(true)},
    {"alpha", {0, 0, 0, 0, 0}, 0, {100000, 100000, 3000, 300, 100}, alpha(false)},
    {"alpha-cycles", {0, 0, 0, 0, 0}, 0, {100000, 100000, 3000, 300, 100}, alpha(false, &netmesh_cycles)},
    {"auto", {0, 0, 0, 0, 0}, 0, {100000, 100000, 3000, 300, 100}, either()},
    {"mesh", meshes, 1.7, {100000, 100000, 3000}, mesh([](auto&) {})},
    {"mesh-tau3.5", meshes, 1.7, {100000, 100000, 3000}, mesh([](auto& r) { r.mesh.tau = 3.5; })},
    {"mesh-tau6", meshes, 1.7, {100000, 100000, 3000}, mesh([](auto& r) { r.mesh.tau = 6; })},
    {"persist", meshes, 1.7, {100000, 30000, 1000}, persist([](auto&) {})},
    {"persist-tau3.5", meshes, 1.7, {100000, 30000, 1000}, persist([](auto& r) { r.mesh.tau = 3.5; })},
    {"persist-tau6", meshes, 1.7, {100000, 30000, 1000}, persist([](auto& r) { r.mesh.tau = 6; })},
    {"ratio1.6", {never, never}, 3.5, {3000, 300}, persist([](auto& r) { r.goal.ratio = 1.6; })},
    {"ratio1.8", {10000, never, never}, 3, {10000, 3000, 100}, persist([](auto& r) { r.goal.ratio = 1.8; })},
    {"ratio1.9-whole", {3000, never, never}, 2.4, {10000, 1000, 173}, persist([](auto& r) {
         r.goal.ratio = 1.9;
         r.mesh.whole_cells = 1;
     })},
    {"ratio2", meshes, 1.9, {30000, 10000, 300}, persist([](auto& r) { r.goal.ratio = 2; })},
    {"ratio2.25", meshes, 1.7, {100000, 30000, 1000}, by_ratio},
    {"ratio3", meshes, 1.7, {100000, 30000, 1000}, persist([](auto& r) { r.goal.ratio = 3; })},
    {"ratio2.25-whole", meshes, 1.7, {100000, 30000, 1000}, persist([](auto& r) {
         r.goal.ratio = 2.25;
         r.mesh.whole_cells = 1;
     })},
    {"hierarchy", {1730, 10000, 3000}, 2, {100000, 30000, 1000}, mesh([](auto& r) {
         r.mesh.method = &netmesh_method_netmesh;
     })},
    {"hierarchy-finished", {never, never, never}, 2, {30000, 10000, 1000}, mesh([](auto& r) {
         r.mesh.method = &netmesh_method_netmesh;
         r.mesh.finish = 1;
     })},
    {"hierarchy-thesis",
     {1000, 3000},
     1.5,
     {10000, 1000},
     mesh([](auto& r) {
         r.mesh.method = &netmesh_method_thesis;
         r.mesh.tau = 6;
     }),
     true},
    {"refine",
     {1730, 3000},
     1.6,
     {100000, 10000, 300},
     mesh([](auto& r) { r.mesh.method = &netmesh_method_refine; }),
     true},
    {"quality-audit", meshes, 2, {10000, 3000}, mesh([](auto& r) { r.mesh.audit = NETMESH_AUDIT_QUALITY; })},
    {"location-audit",
     {never, never},
     4,
     {3000, 1000},
     mesh([](auto& r) { r.mesh.audit = NETMESH_AUDIT_LOCATION; }),
     true},
    {"sizes-eps0.4", {1000, 1730}, 1.4, {30000, 3000}, mesh([](auto& r) { r.mesh.sizes.eps = 0.4; }), true},
    {"tight", {300, never}, 1.4, {3000, 100}, persist([](auto&) {}, &netmesh_filter_tight)},
    {"scales-ratio3", {3000, never}, 2.6, {10000, 3000}, scales([](auto& r) { ask_ratio(r, 3); })},
    {"scales-ratio3-bounds",
     {3000, never},
     2.6,
     {3000, 1000},
     scales([](auto& r) {
         ask_ratio(r, 3);
         r.bounds = &netmesh_bounds;
     }),
     true},
    {"scales", {1000, never}, 1.4, {1000, 100}, scales([](auto&) {})},
};

struct Options {
    bool is_long = false, every = false;
    std::vector<int> dims;
    std::vector<std::string> names;

    bool wants(const Job& job, int dim) const {
        return static_cast<std::size_t>(dim - 2) < job.most.size() &&
               (dims.empty() || std::find(dims.begin(), dims.end(), dim) != dims.end()) &&
               (names.empty() || std::find(names.begin(), names.end(), job.name) != names.end());
    }
};

// Sets of n points: the fewer the points, the more they differ. None of them is one that plans are fitted to.
constexpr std::uint64_t first_seed = 1001;
std::uint64_t sets_of(std::size_t n, bool is_long) {
    const std::uint64_t sets = n < 200 ? 60 : n < 400 ? 40 : n < 2000 ? 16 : n < 4000 ? 6 : 2;
    return is_long ? sets : (sets + 7) / 8;
}

// The peak in a block of the planned bytes; 0: it did not do.
std::uint64_t peak_of(const Job& job, int dim, std::size_t n, std::uint64_t seed, Plan* plan) {
    const inputs::Points points = inputs::uniform(dim, n, seed);
    Calls calls(dim);
    if (plan->bytes == 0) job.run(calls, points, plan);
    const std::size_t bytes = plan->bytes;
    const std::unique_ptr<void, void (*)(void*)> block(std::aligned_alloc(16, plan->bytes), std::free);
    if (block == nullptr || netmesh_init(block.get(), plan->bytes, &calls.context) != NETMESH_OK) return 0;
    polls = 0;
    const netmesh_status status = job.run(calls, points, plan);
    if (plan->bytes != bytes) return peak_of(job, dim, n, seed, plan);  // it is of points, not of their number
    return status == NETMESH_OK ? calls.report().memory.peak_bytes : 0;
}

// Whether the plan for n points does, and is not too much.
bool check(const Job& job, int dim, std::size_t n, const Options& options) {
    Plan plan;
    std::uint64_t least = UINT64_MAX, largest = 0, failed = 0, all_polls = 0;
    bool polls_fit = true;
    const std::uint64_t sets = sets_of(n, options.is_long);
    for (std::uint64_t seed = first_seed; seed < first_seed + sets; ++seed) {
        const std::uint64_t peak = peak_of(job, dim, n, seed, &plan);
        if (peak == 0) ++failed;
        all_polls += polls;
        polls_fit = polls_fit && polls <= plan.polls_most;
        if (peak > 0 && peak < least) least = peak;
        if (peak > largest) largest = peak;
    }
    const double share = largest > 0 ? static_cast<double>(plan.bytes) / static_cast<double>(largest) : 0;
    const bool is_settled = options.is_long && n >= job.settled[static_cast<std::size_t>(dim - 2)];
    const double limit = is_settled || job.few == 0 ? settled_limit : options.is_long ? job.few : 2 * job.few;
    const double mean = static_cast<double>(all_polls) / static_cast<double>(sets),
                 typical = static_cast<double>(plan.polls);
    polls_fit = polls_fit && (n < 100 || job.estimates_polls || (typical <= 2 * mean + 3 && mean <= 2 * typical + 3));
    const bool good = failed == 0 && polls_fit && (n < 100 || share <= limit);
    if (good && !options.every) return true;
    std::printf("%s%-22s D %d %6zu points, %2llu sets: %11zu planned, %.3f to %.3f times the peaks, at most %.1f",
                good ? "" : "WRONG ", job.name, dim, n, static_cast<unsigned long long>(sets), plan.bytes, share,
                static_cast<double>(plan.bytes) / static_cast<double>(least), limit);
    std::printf("; %.1f polls, %.0f planned, at most %.3g", mean, typical, static_cast<double>(plan.polls_most));
    std::printf(failed > 0 ? "; too small for %llu\n" : "\n", static_cast<unsigned long long>(failed));
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "long") {
            options.is_long = true;
        } else if (word == "every") {
            options.every = true;
        } else if (word.size() == 1) {
            options.dims.push_back(word[0] - '0');
        } else {
            options.names.push_back(word);
        }
    }
    setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    unsigned checked = 0, wrong = 0;
    for (const Job& job : jobs)
        for (const int dim : dimensions()) {
            if (!options.wants(job, dim)) continue;
            const std::size_t most = job.most[static_cast<std::size_t>(dim - 2)];
            for (const std::size_t n : {10, 30, 100, 173, 300, 547, 1000, 1730, 3000, 10000, 30000, 100000}) {
                const std::size_t few = dim == 2 ? 300 : dim == 3 ? 173 : 100;
                if (n > most || (!options.is_long && n > few)) break;
                if (n < 100 && job.few == 0) continue;
                if (n * std::size_t(dim) < 30) continue;
                ++checked;
                if (!check(job, dim, n, options)) ++wrong;
            }
        }
    std::printf("%u plans checked, %u wrong\n", checked, wrong);
    return wrong == 0 && checked > 0 ? 0 : 1;
}
