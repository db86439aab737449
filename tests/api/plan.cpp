// Planned bytes, job by job and dimension by dimension: a block of that size suffices for uniform points, and not much
// of it is left over. And polls: no points whatever lead to more than the bound.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/calls.hpp"
#include "common/dimensions.hpp"

namespace {

// A context in a block of exactly so many bytes.
class Block {
public:
    Block(int dim, std::size_t bytes) : calls(dim), memory_(std::aligned_alloc(16, bytes), std::free) {
        REQUIRE(memory_ != nullptr);
        REQUIRE(netmesh_init(memory_.get(), bytes, &calls.context) == NETMESH_OK);
    }
    Calls calls;

private:
    std::unique_ptr<void, void (*)(void*)> memory_;
};

// What runs in a block that was planned for it.
using Job = std::function<netmesh_status(Calls&)>;

// `share`: the least part of the plan that the job has to use, 1 / 1.1 where there are enough points (tests/plans has
// more of them and many sets), less where sets differ more; 0 where they are so small that plans are for their
// boundary.
void expect_enough(int dim, const std::string& name, std::size_t planned, double share, const Job& job) {
    INFO("D = " << dim << ", " << name << ", " << planned << " bytes");
    REQUIRE(planned > 0);
    REQUIRE(planned < std::size_t{1} << 33);
    REQUIRE(planned % 16 == 0);
    Block block(dim, planned);
    CHECK(job(block.calls) == NETMESH_OK);
    const double used = static_cast<double>(block.calls.report().memory.peak_bytes);
    CHECK(used > share * static_cast<double>(planned));
    if (std::getenv("NETMESH_PLANS") != nullptr)
        std::printf("%d %-28s %12zu %.3f\n", dim, name.c_str(), planned, used / static_cast<double>(planned));
}

std::size_t count(int dim, std::initializer_list<std::size_t> from_plane) { return by_dimension(dim, from_plane); }

// Meshes by what `change` makes of the request; with a filter on to its diagram.
void expect_mesh(int dim, std::size_t n, const char* name, double share,
                 const std::function<void(netmesh::Request&)>& change) {
    const inputs::Points points = inputs::uniform(dim, n, 17);
    netmesh::Request request = Calls(dim).mesh_request(points);
    change(request);
    const auto& [plan, job] = request.filter != nullptr ? std::pair(netmesh_plan, netmesh_persist)
                                                        : std::pair(netmesh_plan_mesh, netmesh_mesh);
    expect_enough(dim, name, plan(&request), share,
                  [&, run = job](Calls& calls) { return run(calls.context, &request); });
}

// The diagram that `request` asks for.
void expect_diagram(int dim, const std::string& name, double share, const netmesh::Request& request) {
    expect_enough(dim, name, netmesh_plan(&request), share,
                  [&](Calls& calls) { return netmesh_persist(calls.context, &request); });
}

void expect_points(int dim, std::size_t n, const netmesh_filter* filter, std::uint32_t k, std::uint32_t max_degree,
                   double share, const char* name) {
    const inputs::Points points = inputs::uniform(dim, n, 17);
    expect_diagram(dim, name, share, Calls(dim).points_request(points, filter, k, max_degree));
}

}  // namespace

TEST_CASE("the plan of a triangulation suffices, with its alpha complex too") {
    for (const int dim : dimensions()) {
        const inputs::Points points = inputs::uniform(dim, count(dim, {4000, 2000, 600, 150, 60}), 17);
        const double share = by_dimension(dim, {0.91, 0.91, 0.91, 0.91, 0.5});
        const netmesh::Request delaunay = Calls(dim).delaunay_request(points);
        expect_enough(dim, "delaunay", netmesh_plan_mesh(&delaunay), share,
                      [&](Calls& calls) { return netmesh_mesh(calls.context, &delaunay); });
        netmesh::Request alpha = Calls(dim).alpha_request(points);
        alpha.keep_mesh = 1;
        expect_diagram(dim, "alpha", share, alpha);
        expect_enough(dim, "delaunay, then alpha", netmesh_plan(&alpha), share, [&](Calls& calls) {
            const netmesh_status status = netmesh_mesh(calls.context, &delaunay);
            return status == NETMESH_OK ? calls.persist(&netmesh_filter_alpha) : status;
        });
    }
}

TEST_CASE("the plan of an alpha complex without a triangulation suffices") {
    for (const int dim : dimensions()) {
        const inputs::Points points = inputs::uniform(dim, count(dim, {4000, 2000, 600, 150, 60}), 17);
        expect_diagram(dim, "alpha of points", by_dimension(dim, {0.91, 0.91, 0.91, 0.91, 0.5}),
                       Calls(dim).alpha_request(points));
    }
}

TEST_CASE("the plan of a mesh suffices, whatever it is for") {
    for (const int dim : dimensions()) {
        const std::size_t n = count(dim, {2000, 400, 40, 8, 3});
        const double most = dim > 4 ? 0 : 1;
        expect_mesh(dim, n, "mesh", most * by_dimension(dim, {0.75, 0.55, 0.25, 0., 0.}), [](auto&) {});
        expect_mesh(dim, n, "mesh, tau", most * by_dimension(dim, {0.75, 0.55, 0.25, 0., 0.}),
                    [](auto& r) { r.mesh.tau = 3.5; });
        expect_mesh(dim, n, "persist", most * by_dimension(dim, {0.85, 0.6, 0.25, 0., 0.}),
                    [](auto& r) { r.filter = &netmesh_filter_complete; });
        expect_mesh(dim, n, "persist by ratio", most * by_dimension(dim, {0.9, 0.7, 0.3, 0., 0.}), [](auto& r) {
            r.filter = &netmesh_filter_complete;
            r.mesh.method = nullptr;
            r.goal.ratio = 2.3;
        });
        expect_mesh(dim, n, "netmesh", most * by_dimension(dim, {0.75, 0.55, 0.25, 0., 0.}),
                    [](auto& r) { r.mesh.method = &netmesh_method_netmesh; });
        expect_mesh(dim, n, "netmesh, finished", most * by_dimension(dim, {0.75, 0.55, 0.25, 0., 0.}), [](auto& r) {
            r.mesh.method = &netmesh_method_netmesh;
            r.mesh.finish = 1;
        });
        if (dim > 4) continue;
        expect_mesh(dim, count(dim, {300, 40, 4}), "netmesh, cages of the thesis",
                    by_dimension(dim, {0.7, 0.4, 0.1, 0., 0.}), [](auto& r) {
                        r.mesh.method = &netmesh_method_thesis;
                        r.mesh.tau = 6;
                    });
        expect_mesh(dim, count(dim, {300, 80, 8}), "netmesh, audited", 0.1, [](auto& r) {
            r.mesh.method = &netmesh_method_netmesh;
            r.mesh.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
        });
        expect_mesh(dim, count(dim, {600, 60, 4}), "over-refined", 0.1, [](auto& r) { r.mesh.sizes.eps = 0.4; });
        if (dim > 3) continue;
        expect_mesh(dim, count(dim, {200, 12}), "tight", 0.5, [](auto& r) { r.filter = &netmesh_filter_tight; });
    }
}

TEST_CASE("the plan of scales suffices") {
    for (const int dim : dimensions()) {
        const inputs::Points few = inputs::uniform(dim, count(dim, {600, 200, 60, 20, 10}), 17);
        netmesh::Request by_ratio = Calls(dim).scales_request(few);
        by_ratio.goal.eps = 0;
        by_ratio.goal.ratio = 3;
        const std::size_t plain = netmesh_plan(&by_ratio);
        expect_diagram(dim, "scales by ratio", 0.01, by_ratio);
        by_ratio.bounds = &netmesh_bounds;
        const std::size_t bounded = netmesh_plan(&by_ratio);
        CHECK(bounded > plain);
        expect_diagram(dim, "scales by ratio, bounds", 0.01, by_ratio);
        by_ratio.cycles = &netmesh_cycles;
        CHECK(netmesh_plan(&by_ratio) > bounded);
        expect_diagram(dim, "scales by ratio, cycles", 0.01, by_ratio);
    }
    for (const int dim : dimensions(2, 3)) {
        const inputs::Points points = inputs::uniform(dim, count(dim, {120, 10}), 17);
        netmesh::Request request = Calls(dim).scales_request(points);
        expect_diagram(dim, "scales", 0.5, request);
        request.bounds = &netmesh_bounds;
        expect_diagram(dim, "scales, bounds", 0.5, request);
        request.cycles = &netmesh_cycles;
        expect_diagram(dim, "scales, cycles", 0.5, request);
    }
}

TEST_CASE("the plan of complexes on points suffices") {
    for (const int dim : dimensions()) {
        expect_points(dim, 200, &netmesh_filter_rips, 1, 1, 0.1, "rips, degree 1");
        expect_points(dim, 50, &netmesh_filter_rips, 1, 2, 0.01, "rips, degree 2");
        expect_points(dim, 60, &netmesh_filter_cech, 1, 1, 0.35, "cech, degree 1");
        expect_points(dim, 20, &netmesh_filter_cech, 1, 2, 0.3, "cech, degree 2");
        expect_points(dim, 16, &netmesh_filter_barycentric_cech, 2, 1, 0.25, "barycentric cech");
        expect_points(dim, 16, &netmesh_filter_barycentric_rips, 2, 1, 0.25, "barycentric rips");
    }
}

TEST_CASE("the plan of nested sets for a range of k suffices") {
    for (const int dim : dimensions()) {
        for (const auto& [k_first, k_last, degree] :
             {std::array<std::uint32_t, 3>{1, 3, 1}, {1, 1, 1}, {2, 4, 1}, {1, 3, 0}, {1, 2, 2}}) {
            const inputs::Points points = inputs::uniform(dim, 9, 17);
            netmesh::Request request =
                Calls(dim).nested_request(points, &netmesh_filter_barycentric_rips, k_last, degree);
            request.k = k_first;
            const std::string name = "nested sets, k = " + std::to_string(k_first) + ".." + std::to_string(k_last) +
                                     ", degree " + std::to_string(degree);
            expect_diagram(dim, name, 0.35, request);
        }
    }
    const inputs::Points points = inputs::uniform(2, 14, 17);
    expect_diagram(2, "nested sets of 14 points", 0.5,
                   Calls(2).nested_request(points, &netmesh_filter_barycentric_cech, 3, 1));
}

TEST_CASE("the plan of a complex of simplices suffices") {
    // All faces of a simplex of 12 vertices, by dimension.
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint64_t> starts = {0};
    std::vector<double> values;
    for (int size = 1; size <= 12; ++size)
        for (unsigned set = 1; set < 1u << 12; ++set) {
            if (__builtin_popcount(set) != size) continue;
            for (std::uint32_t v = 0; v < 12; ++v)
                if (set >> v & 1u) vertices.push_back(v);
            starts.push_back(vertices.size());
            values.push_back(size);
        }
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.vertices = vertices.data();
    simplices.starts = starts.data();
    simplices.entries = values.data();
    simplices.simplex_count = values.size();
    simplices.vertex_count = vertices.size();
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    expect_diagram(2, "simplices", 0.35, request);
    std::vector<double> steps = values;
    for (std::size_t i = 0; i < values.size(); ++i) steps.push_back(values[i] + double(i * 7 % 11) / 16);
    simplices.entries = steps.data();
    simplices.step_count = 2;
    request.vines = &netmesh_vines;
    expect_diagram(2, "values", 0.35, request);
}

namespace {

// n points of kinds that cost most: order, cells, values that doubles do not decide, reduction.
std::vector<std::pair<const char*, inputs::Points>> dear_points(int dim, std::size_t n) {
    std::vector<std::pair<const char*, inputs::Points>> all;
    const auto make = [&](const char* name, const std::function<double(double, int)>& coordinate) {
        inputs::Points points;
        for (std::size_t i = 0; i < n; ++i)
            for (int c = 0; c < dim; ++c) points.push_back(coordinate(static_cast<double>(i), c));
        all.emplace_back(name, points);
    };
    make("moment curve", [](double i, int c) { return std::pow(i, c + 1); });
    make("powers of two", [](double i, int c) { return std::ldexp(1 + c * i / 64, -static_cast<int>(i)); });
    make("least numbers", [](double i, int c) { return std::ldexp(std::fmod(i * i, 7 + 2 * c), -1074); });
    make("one key", [](double i, int c) { return 1 + std::ldexp(std::fmod(i * (c + 3), 17 + c), -52); });
    make("skew lines", [](double i, int c) {
        const double half = std::floor(i / 2), side = std::fmod(i, 2);
        return c == 2 ? side : (c == 0) == (side == 0) ? half : 0;
    });
    // Places at all sizes, 31 points at some of the innermost: many have the last key of their box, on each level anew.
    inputs::Points nested;
    for (int level = 0; dim == 2 && level < 346; ++level)
        for (int copy = 0; copy < (level < 20 && level % 2 == 0 ? 31 : 1); ++copy)
            nested.insert(nested.end(), {std::ldexp(1, 1023 - 6 * (346 - level)), 0});
    if (dim == 2) {
        nested.insert(nested.end(), {0, 0x1p-1059});
        all.emplace_back("nested places", nested);
    }
    all.emplace_back("grid", inputs::grid(dim, std::max(2, static_cast<int>(std::pow(double(n), 1.0 / dim)))));
    all.emplace_back("nested", inputs::nested(dim, 30, n / 30 + 1, 1e8));
    all.emplace_back("pairs", inputs::close_pairs(dim, n / 2, 1e-15));
    all.emplace_back("uniform", inputs::uniform(dim, n));
    return all;
}

std::uint64_t polls_so_far;
int count_poll(void*, const netmesh_progress*) {
    ++polls_so_far;
    return 0;
}

}  // namespace

TEST_CASE("no points lead to more polls than the bound") {
    for (const int dim : dimensions())
        for (const auto& [name, points] : dear_points(dim, count(dim, {600, 150, 60, 30, 24}))) {
            INFO("D = " << dim << ", " << name);
            const std::unique_ptr<void, void (*)(void*)> block(std::aligned_alloc(16, 1 << 28), std::free);
            for (const bool is_diagram : {false, true}) {
                Calls calls(dim);
                REQUIRE(netmesh_init(block.get(), 1 << 28, &calls.context) == NETMESH_OK);
                netmesh::Request request = is_diagram ? calls.alpha_request(points) : calls.delaunay_request(points);
                request.monitor.poll = count_poll;
                std::uint64_t most = 0;
                const std::uint64_t typical =
                    is_diagram ? netmesh_plan_polls(&request, &most) : netmesh_plan_mesh_polls(&request, &most);
                CHECK(typical < most);
                CHECK(most < UINT64_MAX);
                polls_so_far = 0;
                const auto job = is_diagram ? netmesh_persist : netmesh_mesh;
                const netmesh_status done = job(calls.context, &request);
                CHECK((done == NETMESH_OK || done == NETMESH_OUT_OF_RANGE || done == NETMESH_FLAT));
                CHECK(polls_so_far <= most);
                if (!is_diagram && name == std::string("nested places")) CHECK(polls_so_far < 400);  // 1,511 at first
                if (std::getenv("NETMESH_PLANS") != nullptr)
                    std::printf("%d %-14s %d status %d polls %llu typical %llu most %llu\n", dim, name, is_diagram,
                                done, static_cast<unsigned long long>(polls_so_far),
                                static_cast<unsigned long long>(typical), static_cast<unsigned long long>(most));
            }
        }
}
