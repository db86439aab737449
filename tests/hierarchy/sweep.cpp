// Hierarchical meshes measured: sizes, touches, invariants, finishing, termination, time. Everything but the times is
// the same on every machine.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "common/inputs.hpp"
#include "mesh/hierarchy_quality.hpp"
#include "mesh/netmesh.hpp"
#include "mesh/quality.hpp"

using namespace netmesh;
using inputs::Points;

namespace {

bool failed = false;

void expect(bool holds, const char* what) {
    if (holds) return;
    failed = true;
    std::printf("  FAILED: %s\n", what);
}

struct Run {
    Status status;
    double inputs, vertices, cells, seconds, worst;
    HierarchyReport report;
};

// Reserved, hardly used.
class Block {
public:
    Block() : memory_(std::aligned_alloc(16, bytes)) { arena.adopt(memory_, bytes); }
    ~Block() { std::free(memory_); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;

    Arena arena;

private:
    static constexpr std::size_t bytes = std::size_t{6} << 30;
    void* memory_;
};

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

template <int D> Run run_netmesh(Block& block, const Points& points, const HierarchyOptions& options) {
    ArenaScope scope(block.arena);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    Domain<D> domain = {};
    Cage* cages;
    Run run = {};
    const double start = now();
    run.status = netmesh::netmesh<D>(store, points.data(), points.size() / D, options, monitor, &input, &domain, &cages,
                                     &run.report);
    run.seconds = now() - start;
    if (run.status != Status::ok) return run;
    HierarchyQuality quality;
    measure_hierarchy<D>(store, cages, run.report.cages, domain, block.arena, &quality);
    if (quality.encroached.violation != nullptr) run.status = Status::check_failed;
    run.worst = quality.worst;
    run.inputs = static_cast<double>(input.rows - input.duplicates);
    run.vertices = state.vertex_count;
    run.cells = state.cell_slots;
    return run;
}

template <int D> Run run_refine(Block& block, const Points& points, double tau, std::uint64_t seed = 1) {
    ArenaScope scope(block.arena);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    Domain<D> domain = {};
    Run run = {};
    const double start = now();
    run.status =
        refine<D>(store, points.data(), points.size() / D, {tau, 1, false, seed}, monitor, &input, &domain);
    run.seconds = now() - start;
    std::uint32_t v;
    recomputed_aspect_ratio<D>(store, domain, block.arena, &run.worst, &v);
    run.inputs = static_cast<double>(input.rows - input.duplicates);
    run.vertices = state.vertex_count;
    run.cells = state.cell_slots;
    return run;
}

// n points in cubes of ten sizes about the origin, the smallest 1 / spread of the largest or so.
Points spread_out(int dim, std::size_t n, double spread) {
    return inputs::nested(dim, 10, n / 10, std::pow(spread * std::pow(static_cast<double>(n) / 10, -1.0 / dim), 1.0 / 9));
}

// Vertices per input, which must not depend on the gaps.
template <int D> void sizes(Block& block, bool quick) {
    constexpr double most[] = {0, 0, 9, 25, 55};
    std::printf("vertices per input, D = %d, tau 3 (plain: without cages; limit %g)\n", D, most[D]);
    double low = infinity, high = 0;
    const auto row = [&](const char* name, const Points& points, bool plain, bool gaps) {
        const Run run = run_netmesh<D>(block, points, {3, 1, false, 1});
        expect(run.status == Status::ok && run.worst <= 3, "the mesh is hierarchical, of quality tau");
        const double size = run.vertices / run.inputs;
        std::printf("  %-24s n %5.0f  %8.2f", name, run.inputs, size);
        if (plain) {
            const Run other = run_refine<D>(block, points, 3);
            std::printf("   plain %8.2f", other.vertices / other.inputs);
            if (!gaps) expect(size <= 1.05 * other.vertices / other.inputs, "no larger than plain refinement");
        }
        std::printf("\n");
        if (!gaps) return;
        expect(size <= most[D], "size per input within the limit");
        low = std::min(low, size);
        high = std::max(high, size);
    };
    for (const double ratio : {2.0, 10.0, 100.0, 1e3, 1e6}) {
        char name[32];
        std::snprintf(name, sizeof name, "at distance %g^-i", ratio);
        const bool small = ratio < 100;
        row(name, inputs::geometric(D, ratio, small ? (D == 4 || quick ? 10 : 40) : 60), small && (!quick || D < 4), !small);
    }
    row("50 pairs at 1e-12", inputs::close_pairs(D, 50, 1e-12), false, true);
    expect(high <= 2 * low, "within a factor 2 for all gaps of 100 and more");
    constexpr std::size_t count[] = {0, 0, 20, 20, 10};
    row("nested clusters 1e3", inputs::nested(D, 5, count[D], 1e3), false, false);
    row("nested clusters 1e6", inputs::nested(D, 5, count[D], 1e6), false, false);
}

// Touches per input against n and spread.
template <int D> void touches(Block& block, bool quick) {
    constexpr std::size_t largest[] = {0, 0, 1000000, 100000, 10000};
    std::printf("touches per input, D = %d, tau 3\n  %8s %8s %8s %8s | touches by number of points, spread 1e6\n", D, "n",
                "1e3", "1e6", "1e30");
    for (std::size_t n = 1000; n <= (quick ? std::size_t{1000} : largest[D]); n *= 10) {
        double low = infinity, high = 0;
        std::printf("  %8zu", n);
        for (const double spread : {1e3, 1e6, 1e30}) {
            const Run run = run_netmesh<D>(block, spread_out(D, n, spread), {3, 1, false, 1});
            expect(run.status == Status::ok, "a mesh");
            const double each = static_cast<double>(run.report.touches) / run.inputs;
            std::printf(" %8.1f (%5.1f)", each, run.vertices / run.inputs);
            low = std::min(low, each);
            high = std::max(high, each);
        }
        std::printf("  highest over lowest %.2f\n", high / low);
    }
}

}  // namespace

int main(int argc, char** argv) {
    Block block;
    const std::string what = argc > 1 ? argv[1] : "";
    const int only = argc > 2 ? std::atoi(argv[2]) : 0;
    const auto each = [&](auto&& job) {
        if (only == 0 || only == 2) job(std::integral_constant<int, 2>{});
        if (only == 0 || only == 3) job(std::integral_constant<int, 3>{});
        if (only == 0 || only == 4) job(std::integral_constant<int, 4>{});
    };
    if (what == "sizes") each([&](auto d) { sizes<decltype(d)::value>(block, false); });
    if (what == "touches") each([&](auto d) { touches<decltype(d)::value>(block, argc > 3); });
    return failed;
}
