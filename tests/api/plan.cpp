// Planned bytes, job by job and dimension by dimension: a block of that size suffices for uniform points, and not much
// of it is left over.
#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>

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

// Meshes by what `change` makes of the request; then `more`.
void expect_mesh(
    int dim, std::size_t n, const char* name, double share, const std::function<void(netmesh_mesh_request&)>& change,
    const Job& more = [](Calls&) { return NETMESH_OK; }) {
    const inputs::Points points = inputs::uniform(dim, n, 17);
    netmesh_mesh_request request = Calls(dim).mesh_request(points);
    change(request);
    expect_enough(dim, name, netmesh_plan_mesh(&request), share, [&](Calls& calls) {
        const netmesh_status status = netmesh_mesh(calls.context, &request);
        return status == NETMESH_OK ? more(calls) : status;
    });
}

void expect_points(int dim, std::size_t n, netmesh_filter filter, std::uint32_t k, std::uint32_t max_degree,
                   double share, const char* name) {
    const inputs::Points points = inputs::uniform(dim, n, 17);
    const netmesh_points_request request = Calls(dim).points_request(points, filter, k, max_degree);
    expect_enough(dim, name, netmesh_plan_points(&request), share,
                  [&](Calls& calls) { return netmesh_persist_points(calls.context, &request); });
}

}  // namespace

TEST_CASE("the plan of a triangulation suffices, with its alpha complex too") {
    for (const int dim : dimensions()) {
        const inputs::Points points = inputs::uniform(dim, count(dim, {4000, 2000, 600, 150, 60}), 17);
        for (const netmesh_purpose purpose : {NETMESH_PURPOSE_MESH, NETMESH_PURPOSE_PERSIST}) {
            const bool alpha = purpose == NETMESH_PURPOSE_PERSIST;
            const double share = by_dimension(dim, {0.91, 0.91, 0.91, 0.91, 0.5});
            const netmesh_delaunay_request request = Calls(dim).delaunay_request(points, purpose);
            expect_enough(dim, alpha ? "alpha" : "delaunay", netmesh_plan_delaunay(&request), share, [&](Calls& calls) {
                const netmesh_status status = netmesh_delaunay(calls.context, &request);
                return status == NETMESH_OK && alpha ? calls.persist(NETMESH_FILTER_ALPHA) : status;
            });
        }
    }
}

TEST_CASE("the plan of an alpha complex without a triangulation suffices") {
    for (const int dim : dimensions()) {
        const inputs::Points points = inputs::uniform(dim, count(dim, {4000, 2000, 600, 150, 60}), 17);
        const netmesh_alpha_request request = Calls(dim).alpha_request(points);
        expect_enough(dim, "alpha of points", netmesh_plan_alpha(&request),
                      by_dimension(dim, {0.91, 0.91, 0.91, 0.91, 0.5}),
                      [&](Calls& calls) { return netmesh_persist_alpha(calls.context, &request); });
    }
}

TEST_CASE("the plan of a mesh suffices, whatever it is for") {
    for (const int dim : dimensions()) {
        const std::size_t n = count(dim, {2000, 400, 40, 8, 3});
        const double most = dim > 4 ? 0 : 1;
        const Job complete = [](Calls& calls) { return calls.persist(); };
        const Job tight = [](Calls& calls) { return calls.persist(NETMESH_FILTER_TIGHT); };
        expect_mesh(dim, n, "mesh", most * by_dimension(dim, {0.75, 0.55, 0.25, 0., 0.}), [](auto&) {});
        expect_mesh(dim, n, "mesh, tau", most * by_dimension(dim, {0.75, 0.55, 0.25, 0., 0.}),
                    [](auto& r) { r.tau = 3.5; });
        expect_mesh(
            dim, n, "persist", most * by_dimension(dim, {0.85, 0.6, 0.25, 0., 0.}),
            [](auto& r) { r.purpose = NETMESH_PURPOSE_PERSIST; }, complete);
        expect_mesh(
            dim, n, "persist by ratio", most * by_dimension(dim, {0.9, 0.7, 0.3, 0., 0.}),
            [](auto& r) {
                r.purpose = NETMESH_PURPOSE_PERSIST;
                r.certificate.ratio = 2.3;
            },
            complete);
        expect_mesh(dim, n, "netmesh", most * by_dimension(dim, {0.75, 0.55, 0.25, 0., 0.}),
                    [](auto& r) { r.method = NETMESH_METHOD_HIERARCHY; });
        expect_mesh(dim, n, "netmesh, finished", most * by_dimension(dim, {0.75, 0.55, 0.25, 0., 0.}), [](auto& r) {
            r.method = NETMESH_METHOD_HIERARCHY;
            r.finish = 1;
        });
        if (dim > 4) continue;
        expect_mesh(dim, count(dim, {300, 40, 4}), "netmesh, cages of the thesis",
                    by_dimension(dim, {0.7, 0.4, 0.1, 0., 0.}), [](auto& r) {
                        r.method = NETMESH_METHOD_HIERARCHY;
                        r.cage_kind = NETMESH_CAGES_THESIS;
                        r.tau = 6;
                    });
        expect_mesh(dim, count(dim, {300, 80, 8}), "netmesh, audited", 0.1, [](auto& r) {
            r.method = NETMESH_METHOD_HIERARCHY;
            r.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
        });
        expect_mesh(dim, count(dim, {600, 60, 4}), "over-refined", 0.1, [](auto& r) { r.sizes.eps = 0.4; });
        if (dim > 3) continue;
        expect_mesh(
            dim, count(dim, {200, 12}), "tight", 0.5, [](auto& r) { r.purpose = NETMESH_PURPOSE_TIGHT; }, tight);
    }
}

TEST_CASE("the plan of scales suffices") {
    for (const int dim : dimensions()) {
        const inputs::Points few = inputs::uniform(dim, count(dim, {600, 200, 60, 20, 10}), 17);
        netmesh_scales_request by_ratio = Calls(dim).scales_request(few);
        by_ratio.ratio = 3;
        const std::size_t plain = netmesh_plan_scales(&by_ratio);
        expect_enough(dim, "scales by ratio", plain, 0.01,
                      [&](Calls& calls) { return netmesh_persist_scales(calls.context, &by_ratio); });
        by_ratio.bounds = 1;
        CHECK(netmesh_plan_scales(&by_ratio) > plain);
        expect_enough(dim, "scales by ratio, bounds", netmesh_plan_scales(&by_ratio), 0.01,
                      [&](Calls& calls) { return netmesh_persist_scales(calls.context, &by_ratio); });
        const std::size_t bounded = netmesh_plan_scales(&by_ratio);
        by_ratio.representatives = 1;
        CHECK(netmesh_plan_scales(&by_ratio) > bounded);
        expect_enough(dim, "scales by ratio, cycles", netmesh_plan_scales(&by_ratio), 0.01,
                      [&](Calls& calls) { return netmesh_persist_scales(calls.context, &by_ratio); });
    }
    for (const int dim : dimensions(2, 3)) {
        const inputs::Points points = inputs::uniform(dim, count(dim, {120, 10}), 17);
        netmesh_scales_request request = Calls(dim).scales_request(points);
        expect_enough(dim, "scales", netmesh_plan_scales(&request), 0.5,
                      [&](Calls& calls) { return netmesh_persist_scales(calls.context, &request); });
        request.bounds = 1;
        expect_enough(dim, "scales, bounds", netmesh_plan_scales(&request), 0.5,
                      [&](Calls& calls) { return netmesh_persist_scales(calls.context, &request); });
        request.representatives = 1;
        expect_enough(dim, "scales, cycles", netmesh_plan_scales(&request), 0.5,
                      [&](Calls& calls) { return netmesh_persist_scales(calls.context, &request); });
    }
}

TEST_CASE("the plan of complexes on points suffices") {
    for (const int dim : dimensions()) {
        expect_points(dim, 200, NETMESH_FILTER_RIPS, 1, 1, 0.1, "rips, degree 1");
        expect_points(dim, 50, NETMESH_FILTER_RIPS, 1, 2, 0.01, "rips, degree 2");
        expect_points(dim, 60, NETMESH_FILTER_CECH, 1, 1, 0.35, "cech, degree 1");
        expect_points(dim, 20, NETMESH_FILTER_CECH, 1, 2, 0.3, "cech, degree 2");
        expect_points(dim, 16, NETMESH_FILTER_BARYCENTRIC_CECH, 2, 1, 0.25, "barycentric cech");
        expect_points(dim, 16, NETMESH_FILTER_BARYCENTRIC_RIPS, 2, 1, 0.25, "barycentric rips");
    }
}

TEST_CASE("the plan of nested sets for a range of k suffices") {
    for (const int dim : dimensions()) {
        for (const auto& [k_first, k_last, degree] :
             {std::array<std::uint32_t, 3>{1, 3, 1}, {1, 1, 1}, {2, 4, 1}, {1, 3, 0}, {1, 2, 2}}) {
            const inputs::Points points = inputs::uniform(dim, 9, 17);
            netmesh_points_vineyard_request request =
                Calls(dim).nested_request(points, NETMESH_FILTER_BARYCENTRIC_RIPS, k_last, degree);
            request.k_first = k_first;
            const std::string name = "nested sets, k = " + std::to_string(k_first) + ".." + std::to_string(k_last) +
                                     ", degree " + std::to_string(degree);
            expect_enough(dim, name, netmesh_plan_points_vineyard(&request), 0.35,
                          [&](Calls& calls) { return netmesh_points_vineyard(calls.context, &request); });
        }
    }
    const inputs::Points points = inputs::uniform(2, 14, 17);
    const netmesh_points_vineyard_request request =
        Calls(2).nested_request(points, NETMESH_FILTER_BARYCENTRIC_CECH, 3, 1);
    expect_enough(2, "nested sets of 14 points", netmesh_plan_points_vineyard(&request), 0.5,
                  [&](Calls& calls) { return netmesh_points_vineyard(calls.context, &request); });
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
    netmesh::requests::Homology request;
    request.vertices = vertices.data();
    request.starts = starts.data();
    request.entries = values.data();
    request.simplex_count = values.size();
    request.vertex_count = vertices.size();
    expect_enough(2, "homology", netmesh_plan_homology(&request), 0.35,
                  [&](Calls& calls) { return netmesh_homology(calls.context, &request); });
    std::vector<double> steps = values;
    for (std::size_t i = 0; i < values.size(); ++i) steps.push_back(values[i] + double(i * 7 % 11) / 16);
    netmesh::requests::ValueVineyard vineyard;
    vineyard.vertices = vertices.data();
    vineyard.starts = starts.data();
    vineyard.entries = steps.data();
    vineyard.simplex_count = values.size();
    vineyard.vertex_count = vertices.size();
    vineyard.step_count = 2;
    expect_enough(2, "values", netmesh_plan_value_vineyard(&vineyard), 0.35,
                  [&](Calls& calls) { return netmesh_value_vineyard(calls.context, &vineyard); });
}
