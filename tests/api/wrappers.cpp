// The C++ layer: every call of the C interface has one, and does the same.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "common/inputs.hpp"
#include "netmesh.hpp"

namespace {

struct Memory {
    explicit Memory(std::size_t bytes) : storage(bytes / 16 + 1) {}
    struct alignas(16) Unit {
        unsigned char bytes[16];
    };
    std::vector<Unit> storage;
    void* block() { return storage.data(); }
    std::size_t bytes() const { return storage.size() * 16; }
};

double from_middle(void*, const double* x) {
    return std::sqrt((x[0] - 0.5) * (x[0] - 0.5) + (x[1] - 0.5) * (x[1] - 0.5));
}

}  // namespace

TEST_CASE("the C++ layer") {
    const inputs::Points points = inputs::uniform(2, 30);
    Memory memory(std::size_t{1} << 23), copy(std::size_t{1} << 23);
    netmesh::Options options(2);
    netmesh::Engine engine(memory.block(), memory.bytes());
    REQUIRE(engine.status() == NETMESH_OK);
    CHECK(std::strcmp(netmesh::status_text(NETMESH_OK), "done") == 0);
    CHECK(netmesh::homology_bytes(10, 20) == netmesh_homology_bytes(10, 20));
    CHECK(netmesh::points_bytes(NETMESH_FILTER_RIPS, options, 20, 1) ==
          netmesh_points_bytes(NETMESH_FILTER_RIPS, &options, 20, 1, 1));

    REQUIRE(engine.mesh(points.data(), 30, options, NETMESH_JOB_PERSIST) == NETMESH_OK);
    REQUIRE(engine.persist(NETMESH_FILTER_COMPLETE, options) == NETMESH_OK);
    REQUIRE(engine.bound_bars(options) == NETMESH_OK);
    std::uint64_t pairs = 0, bounds = 0, steps = 0, simplices = 0;
    engine.for_each_pair([&](const netmesh_pair&) { ++pairs; });
    engine.for_each_bar_bounds([&](std::uint64_t i, const netmesh_bar_bounds&) { CHECK(i == bounds++); });
    engine.for_each_scale_step([&](const netmesh_scale_step& step) { steps += step.ratio >= 1; });
    CHECK(bounds == pairs);
    CHECK(steps > 0);
    REQUIRE(engine.represent(options) == NETMESH_OK);
    CHECK(engine.for_each_in_cycle(0, [&](const netmesh_simplex&) { ++simplices; }) == NETMESH_OK);
    CHECK(simplices > 0);
    CHECK(engine.for_each_in_cycle(pairs, [](const netmesh_simplex&) {}) != NETMESH_OK);

    std::memcpy(copy.block(), memory.block(), memory.bytes());
    const netmesh::Engine twin = netmesh::Engine::adopt(copy.block());
    CHECK(twin.status() == NETMESH_OK);
    CHECK(twin.report().fingerprint == engine.report().fingerprint);

    const netmesh_report report = engine.report();
    std::vector<double> ratios(report.vertices), vertices, theta(report.inputs);
    std::vector<std::uint32_t> domains(report.vertices), order(report.inputs), cells;
    CHECK(engine.measure_cells(ratios.data(), domains.data()) == NETMESH_OK);
    REQUIRE(engine.well_paced_order(order.data(), theta.data()) == NETMESH_OK);
    CHECK(engine.pace(order.data(), theta.data()) == NETMESH_OK);
    CHECK(engine.vineyard(NETMESH_FILTER_KNN, 1, 3, options) == NETMESH_OK);
    std::uint64_t vine_points = 0;
    engine.for_each_vine_point([&](const netmesh_vine_point&) { ++vine_points; });
    CHECK(vine_points == engine.report().vine_points);
    CHECK(engine.vine_ratio(2) >= 1);
    CHECK(engine.vine_ratio(4) == 0);
    const netmesh_function function = {from_middle, nullptr, 1, 0, 1.5};
    CHECK(engine.persist_function(function, options) == NETMESH_OK);

    std::vector<std::uint8_t> markers;
    engine.for_each_vertex([&](std::uint64_t, const netmesh_vertex& v) {
        vertices.insert(vertices.end(), v.coordinates, v.coordinates + 2);
        markers.push_back(static_cast<std::uint8_t>(v.marker));
    });
    engine.for_each_cell(
        [&](std::uint64_t, const netmesh_cell& c) { cells.insert(cells.end(), c.vertices, c.vertices + 3); });
    CHECK(engine.load(vertices.data(), markers.data(), markers.size(), cells.data(), cells.size() / 3, report.domain,
                      options) == NETMESH_OK);
    CHECK(engine.load_cages(nullptr, 0, options) == NETMESH_OK);
    CHECK(engine.persist_scales(points.data(), 30, options) == NETMESH_OK);
    CHECK(engine.report().scales > 0);
}
