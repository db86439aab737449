// Hierarchical meshes measured: sizes, touches, invariants, finishing, termination, time. Everything but the times is
// the same on every machine.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/mesh_points.hpp"
#include "common/mesh_requests.hpp"
#include "mesh/check/hierarchy_quality.hpp"

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
    HierarchyCounts report;
    LocationCounts location;
    MeshAudit audit;
};

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

template <int D> Run run_mesh(Block& block, const Points& points, const MeshRequest& request) {
    ArenaScope scope(block.arena);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    MeshResult<D> result = {};
    Run run = {};
    const double start = now();
    run.status = mesh_points<D>(store, points.data(), points.size() / D, request, {block.arena, monitor}, &result);
    run.seconds = now() - start;
    run.report = result.hierarchy;
    run.location = result.location;
    run.audit = result.audit;
    if (run.status != Status::ok) return run;
    HierarchyQuality quality;
    measure_hierarchy(store, {result.cages, result.hierarchy.cages, result.domain}, block.arena, &quality);
    if (quality.encroached.violation != nullptr) run.status = Status::check_failed;
    run.worst = quality.worst;
    run.inputs = static_cast<double>(result.input.rows - result.input.duplicates);
    run.vertices = state.vertex_count;
    run.cells = state.cell_slots;
    return run;
}

// n points in cubes of ten sizes about the origin, the smallest 1 / spread of the largest or so.
Points spread_out(int dim, std::size_t n, double spread) {
    return inputs::nested(dim, 10, n / 10,
                          std::pow(spread * std::pow(static_cast<double>(n) / 10, -1.0 / dim), 1.0 / 9));
}

// Vertices per input, which must not depend on the gaps.
template <int D> void sizes(Block& block, bool quick) {
    constexpr double most[] = {0, 0, 9, 25, 55};
    std::printf("vertices per input, D = %d, tau 3 (plain: without cages; limit %g)\n", D, most[D]);
    double low = infinity, high = 0;
    const auto row = [&](const char* name, const Points& points, bool plain, bool gaps) {
        const Run run = run_mesh<D>(block, points, by_hierarchy(3));
        expect(run.status == Status::ok && run.worst <= 3, "the mesh is hierarchical, of quality tau");
        const double size = run.vertices / run.inputs;
        std::printf("  %-24s n %5.0f  %8.2f", name, run.inputs, size);
        if (plain) {
            const Run other = run_mesh<D>(block, points, by_quality(3));
            std::printf("   plain %8.2f", other.vertices / other.inputs);
            // As it was when plain refinement did not wait for inputs either (mesh/loop/quality_rule.hpp).
            constexpr double few[] = {0, 0, 12.273, 32.909, 283.818}, many[] = {0, 0, 25.146, 155.585, 283.818};
            const double before = run.inputs < 20 ? few[D] : many[D], now = other.vertices / other.inputs;
            if (!gaps) expect(size <= 1.05 * (now > before ? now : before), "no larger than plain refinement");
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
        row(name, inputs::geometric(D, ratio, small ? (D == 4 || quick ? 10 : 40) : 60), small && (!quick || D < 4),
            !small);
    }
    row("50 pairs at 1e-12", inputs::close_pairs(D, 50, 1e-12), false, true);
    expect(high <= 2 * low, "within a factor 2 for all gaps of 100 and more");
    constexpr std::size_t count[] = {0, 0, 20, 20, 10};
    row("nested clusters 1e3", inputs::nested(D, 5, count[D], 1e3), false, false);
    row("nested clusters 1e6", inputs::nested(D, 5, count[D], 1e6), false, false);
}

// Touches per input against the number of points and the spread, all looks counted, whoever makes them, but for those
// of a mesh that is done: with walks, as it is done in production, and with lists of D-balls, where the comparisons
// with balls come on top of the looks of the tree. Theorem 4.13.1 is about insertions that touch an input: the last
// column of lists. The D-balls that one of them makes are not few in space, as those of compact cages may be large, so
// comparisons are shown and not judged.
template <int D> void touches(Block& block, bool quick, bool lists) {
    constexpr std::size_t largest[2][5] = {{0, 0, 1000000, 100000, 10000}, {0, 0, 100000, 10000, 1000}};
    std::printf("touches per input (of the tree%s; vertices per input), D = %d, tau 3, %s, spread across\n%10s",
                lists ? ", of lists; insertions" : "", D, lists ? "lists of D-balls" : "walks", "n");
    const double spreads[] = {1e3, 1e6, 1e30};
    for (const double spread : spreads) std::printf(lists ? "%42g" : "%26g", spread);
    std::printf("   1e30 / 1e3   highest / lowest\n");
    double before = 0, added = 0;
    for (std::size_t n = lists && !quick ? 100 : 1000; n <= (quick ? std::size_t{1000} : largest[lists][D]); n *= 10) {
        double each[3], low = infinity, high = 0;
        std::printf("%10zu", n);
        for (int k = 0; k < 3; ++k) {
            const Run run = run_mesh<D>(block, spread_out(D, n / (quick && lists ? 5 : 1), spreads[k]),
                                        audited(by_hierarchy(3), lists, false));
            expect(run.status == Status::ok, "the mesh is hierarchical");
            const LocationCounts& all = run.location;
            const double touched = static_cast<double>(all.touches() - all.last) / run.inputs;
            each[k] = lists ? run.audit.location.touches_mean : touched;
            std::printf("  %8.1f (%6.1f", touched, static_cast<double>(all.tree - all.last) / run.inputs);
            if (lists) std::printf(", %7.1f; %5.1f", static_cast<double>(all.lists) / run.inputs, each[k]);
            std::printf("; %4.1f)", run.vertices / run.inputs);
            low = std::min(low, each[k]);
            high = std::max(high, each[k]);
        }
        std::printf("%13.2f %13.2f\n", each[2] / each[0], high / low);
        if (n >= 1000)  // fewer are a handful for each scale
            expect(each[2] <= (lists ? 1.3 : 1.2) * each[0], "touches grow by at most 20% (lists 30%) with the spread");
        if (!lists) expect(each[0] <= 1.2 * each[2], "touches fall by at most 20% with the spread");
        if (!lists) expect(high <= 1.35 * low, "touches change by at most a third");
        // As log n, but for the hull, which takes more of few points: ten times the points add the same again and
        // again.
        if (before > 0 && !lists) expect(each[0] - before <= 0.5 * before, "touches grow slowly");
        if (added > 0 && lists) expect(each[0] - before <= 1.5 * added, "touches grow as a logarithm");
        added = before > 0 ? each[0] - before : 0;
        before = each[0];
    }
}

// The audited modes.
template <int D> void audits(Block& block, bool quick) {
    const double spreads[] = {1e3, 1e6, 1e30};
    constexpr std::size_t largest[] = {0, 0, 100000, 10000, 1000};
    std::printf(
        "all D-balls, D = %d, tau 3: ply mean and most, touches of a point mean and most, tests mean, nets, loads\n",
        D);
    for (std::size_t n = 1000; n <= (quick ? std::size_t{1000} : largest[D]); n *= 10)
        for (const double spread : spreads) {
            if (quick && spread == 1e6) continue;
            const Run run =
                run_mesh<D>(block, spread_out(D, n / (quick ? 5 : 1), spread), audited(by_hierarchy(3), true, false));
            expect(run.status == Status::ok, "each point is in the D-balls that it is stored in");
            const LocationAudit& a = run.audit.location;
            std::printf("%8.0f %6g  %5.1f %4u  %6.1f %5u  %7.0f  %3u ", run.inputs, spread, a.ply_mean, a.ply_max,
                        a.touches_mean, a.touches_max, a.tests_mean, a.nets);
            for (std::uint32_t k = 0; k < a.rounds; ++k) {
                std::printf(" %u", a.load[k]);
                if (k > 0) expect(a.load[k] <= a.load[k - 1] / 2, "the load halves in every round");
            }
            std::printf("\n");
        }
    constexpr std::size_t small[] = {0, 0, 200, 60, 20};
    const std::size_t n = quick ? small[D] / 4 : small[D];
    std::printf("after every insertion, D = %d, tau 3: meshes, worst aspect ratio, degree, K; K' of shells, cleaning,"
                " inputs\n",
                D);
    const std::pair<const char*, Points> sets[] = {{"uniform", inputs::uniform(D, n)},
                                                   {"clusters", inputs::clusters(D, n)},
                                                   {"grid", inputs::grid(D, D == 2 ? 10 : D)},
                                                   {"1000^-i", inputs::geometric(D, 1e3, 20)},
                                                   {"15^-i", inputs::geometric(D, 15, D == 4 ? 3 : 8)},
                                                   {"nested 1e3", inputs::nested(D, 4, n / 4, 1e3)},
                                                   {"nested 1e6", inputs::nested(D, 4, n / 4, 1e6)},
                                                   {"nested 20", inputs::nested(D, 3, 1 + n / 6, 20)},
                                                   {"pairs", inputs::close_pairs(D, n / 2, 1e-12)}};
    for (const auto& [name, points] : sets)
        for (const bool rounds : {false, true}) {
            if (quick && rounds) continue;
            const Run run = run_mesh<D>(block, points, audited(by_hierarchy(3), rounds, true));
            const QualityAudit& a = run.audit.quality;
            std::printf("  %-11s%-5s n %4.0f  %5u %7.2f %3u  %5.2f   %5.2f %5.2f %5.2f\n", name, rounds ? "nets" : "",
                        run.inputs, a.meshes, a.worst, a.degree_max, a.feature, a.cage, a.steiner, a.input);
            expect(run.status == Status::ok && a.encroached == 0, "no cage is ever encroached");
            expect(a.worst < 1000 && a.feature < 10, "quality and feature sizes stay bounded");
        }
}

// The same set, mirrored and with its axes exchanged: the order of insertion is another one.
template <int D> Points turned(const Points& points, std::uint64_t seed) {
    Points p(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t k = i % D, to = i - k + (k + seed) % D;
        p[to] = ((seed / D >> k) & 1u) != 0 ? -points[i] : points[i];
    }
    return p;
}

// FinishMesh against refinement without cages. Sizes of one input differ from order to order, so they are means over
// several ways to turn it; the last column is how far the direct ones are apart, largest over smallest.
template <int D> void finishing(Block& block, bool quick) {
    constexpr std::uint64_t ways = D == 2 ? 8 : 24;
    std::printf("FinishMesh, D = %d, tau 3: vertices finished, direct, ratio; direct ones among themselves\n", D);
    double finished_sum = 0, direct_sum = 0, worst = 0;
    constexpr std::size_t scale[] = {0, 0, 10, 2, 1};
    const auto row = [&](const char* name, const Points& points) {
        double finished = 0, direct = 0, low = infinity, high = 0, cages = 0;
        const std::uint64_t seeds = quick ? 3 : points.size() <= 60 * D ? ways : 8;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const Points same = turned<D>(points, seed);
            const Run a = run_mesh<D>(block, same, by_hierarchy(3, true, seed));
            const Run b = run_mesh<D>(block, same, by_quality(3));
            expect(a.status == Status::ok && a.worst <= 3, "the finished mesh is of quality tau");
            finished += a.vertices / static_cast<double>(seeds);
            direct += b.vertices / static_cast<double>(seeds);
            cages += a.report.cages_made / static_cast<double>(seeds);
            low = std::min(low, b.vertices);
            high = std::max(high, b.vertices);
        }
        std::printf("  %-16s n %5zu  cages %5.1f  %8.1f %8.1f  %.3f   %.3f\n", name, points.size() / D, cages, finished,
                    direct, finished / direct, high / low);
        finished_sum += finished;
        direct_sum += direct;
        worst = std::max(worst, finished / direct);
        // A few points keep more of their shells than others gain.
        if (seeds == ways) expect(finished <= 1.1 * direct, "each finished mesh is within 10% of the direct one");
    };
    const std::size_t s = scale[D] * (quick ? 1 : 2);
    row("uniform", inputs::uniform(D, 50 * s));
    row("clusters", inputs::clusters(D, 10 * s));
    row("nested 1e2", inputs::nested(D, 3, 5 * s, 1e2));
    row("100^-i", inputs::geometric(D, 100, 3));
    row("1000^-i", inputs::geometric(D, 1e3, 3));
    if (D < 4) row("pairs 1e-3", inputs::close_pairs(D, 5 * s, 1e-3));
    for (std::uint64_t set = 1; set <= (quick ? 2u : 6u); ++set) row("clusters of 20", inputs::clusters(D, 20, set));
    std::printf("  together %.3f, worst %.3f\n", finished_sum / direct_sum, worst);
    expect(finished_sum <= 1.05 * direct_sum, "finished meshes are together within 5% of direct ones");
}

// Time for each vertex against plain refinement, in turns on one machine, on inputs without extreme spread.
template <int D> void times(Block& block) {
    constexpr std::size_t sizes[] = {0, 0, 50000, 8000, 600};
    std::printf("time for each vertex, netmesh / svr, D = %d, tau 3, median of 9 pairs\n", D);
    const std::pair<const char*, Points> sets[] = {{"uniform", inputs::uniform(D, sizes[D])},
                                                   {"shell", inputs::shell(D, sizes[D] / 2, 0.95, 1, 1)},
                                                   {"nested by 2", inputs::nested(D, 10, sizes[D] / 20, 2)},
                                                   {"clusters", inputs::clusters(D, sizes[D] / (D == 4 ? 6 : 4))}};
    for (const auto& [name, points] : sets) {
        std::vector<double> ratios;
        double us = 0;
        for (int k = 0; k < 9; ++k) {
            const Run a = run_mesh<D>(block, points, by_hierarchy(3));
            const Run b = run_mesh<D>(block, points, by_quality(3));
            ratios.push_back(a.seconds / a.vertices / (b.seconds / b.vertices));
            us = 1e6 * a.seconds / a.vertices;
        }
        std::nth_element(ratios.begin(), ratios.begin() + 4, ratios.end());
        std::printf("  %-12s %.2f   (%.2f microseconds)\n", name, ratios[4], us);
        expect(ratios[4] <= 1.5, "at most 1.5 times");
    }
}

// A fuzzed input: points from a few formulas that are degenerate in every way that meshing admits.
Points fuzzed(int dim, std::uint64_t seed, std::size_t most) {
    inputs::Random random(seed);
    Points p;
    std::vector<double> x(static_cast<std::size_t>(dim));
    const std::size_t n = 1 + random.below(most);
    const int kind = static_cast<int>(random.below(6));
    const double side = static_cast<double>(2 + random.below(4));
    for (std::size_t i = 0; i < n; ++i) {
        const int scale = kind == 1 ? -static_cast<int>(random.below(40)) : 0;
        const std::size_t from = p.empty() ? 0 : random.below(p.size() / x.size());
        for (std::size_t k = 0; k < x.size(); ++k) {
            const double u = 2 * random.uniform() - 1;
            switch (kind) {
            case 0: x[k] = u; break;
            case 1: x[k] = std::ldexp(u, scale); break;                         // all scales
            case 2: x[k] = std::floor(u * side); break;                         // grids
            case 3: x[k] = k == 0 ? u : k == 1 ? std::floor(2 * u) : 0; break;  // flat
            case 4:
                x[k] = (p.empty() ? 0 : p[from * x.size() + k]) + std::ldexp(u, -static_cast<int>(random.below(30)));
                break;
            default: x[k] = std::floor(u * side) + (random.below(3) == 0 ? std::ldexp(u, -20) : 0);  // nearly grids
            }
        }
        p.insert(p.end(), x.begin(), x.end());
    }
    return p;
}

// Every admitted input ends in a mesh of quality tau >= 2.2.
template <int D> void terminate(Block& block, std::uint64_t count) {
    constexpr std::size_t most[] = {0, 0, 40, 16, 6};
    std::uint64_t meshed = 0, vertices = 0, largest = 0, cages = 0;
    const double start = now();
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        const double tau = seed % 4 == 0 ? 2.2 : 2.2 + 0.3 * static_cast<double>(seed % 4);
        const Run run = run_mesh<D>(block, fuzzed(D, seed, most[D]), by_hierarchy(tau, seed % 16 == 1 && D == 2, seed));
        if (run.status == Status::too_close) continue;
        expect(run.status == Status::ok && run.worst <= tau, "a fuzzed input ends in a mesh of quality tau");
        if (run.status != Status::ok || !(run.worst <= tau))
            std::printf("  D %d seed %llu status %d worst %g\n", D, static_cast<unsigned long long>(seed),
                        static_cast<int>(run.status), run.worst);
        ++meshed;
        vertices += static_cast<std::uint64_t>(run.vertices);
        cages += run.report.cages_made;
        largest = std::max(largest, static_cast<std::uint64_t>(run.vertices));
    }
    std::printf("terminated, D = %d, tau 2.2 to 3.1: %llu fuzzed inputs, %llu meshed (others have points too close), "
                "%llu cages, %llu vertices, at most %llu, %.0f s\n",
                D, static_cast<unsigned long long>(count), static_cast<unsigned long long>(meshed),
                static_cast<unsigned long long>(cages), static_cast<unsigned long long>(vertices),
                static_cast<unsigned long long>(largest), now() - start);
    expect(meshed > count / 2, "most fuzzed inputs are admitted");
}

constexpr const char* usage =
    "hierarchy sizes|touches|audits|finish|times [D]    a table\n"
    "hierarchy terminate [D [COUNT]]                    fuzzed inputs, 10,000 of each dimension\n"
    "hierarchy all                                      everything\n"
    "hierarchy slice                                    a little of everything but times\n";

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    const int only = argc > 2 ? std::atoi(argv[2]) : 0;
    const bool quick = what == "slice", all = what == "all";
    const std::uint64_t count = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : quick ? 100 : 10000;
    Block block(std::size_t{6} << 30, Block::untouched);
    bool any = false;
    const auto each = [&](const char* name, auto&& job) {
        if (what != name && !all && !(quick && std::string(name) != "times")) return;
        any = true;
        for_each_dimension<2, 4>([&](auto dim) {
            if (only == 0 || only == dim) job(dim);
        });
        std::fflush(stdout);
    };
    each("sizes", [&](auto d) { sizes<decltype(d)::value>(block, quick); });
    const int slow = quick ? 4 : 0;  // the dimension that a slice leaves out
    each("touches", [&](auto d) { d != slow ? touches<decltype(d)::value>(block, quick, false) : void(); });
    each("touches", [&](auto d) { d != slow ? touches<decltype(d)::value>(block, quick, true) : void(); });
    each("audits", [&](auto d) { d != slow ? audits<decltype(d)::value>(block, quick) : void(); });
    each("finish", [&](auto d) { d != slow ? finishing<decltype(d)::value>(block, quick) : void(); });
    each("times", [&](auto d) { times<decltype(d)::value>(block); });
    each("terminate", [&](auto d) { terminate<decltype(d)::value>(block, d == slow ? count / 10 : count); });
    if (!any) std::fputs(usage, stderr);
    return any ? failed : 2;
}
