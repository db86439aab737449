// The C++ layer: every call of the C interface has one, and does the same.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <utility>
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
    netmesh::Engine engine(memory.block(), memory.bytes());
    REQUIRE(engine.status() == NETMESH_OK);
    CHECK(std::strcmp(netmesh::status_text(NETMESH_OK), "done") == 0);
    CHECK(std::strcmp(netmesh::field_text(NETMESH_FIELD_TAU), "tau") == 0);
    netmesh::Request mesh(&netmesh_filter_complete);
    mesh.set_points(2, points);
    mesh.mesh.method = &netmesh_method_svr;
    netmesh_request settled;
    netmesh_detail detail;
    REQUIRE(netmesh::settle(mesh, &settled, &detail) == NETMESH_OK);
    CHECK(detail.status == NETMESH_OK);
    CHECK(settled.mesh.tau == 2.5);
    CHECK(settled.points.coordinates == points.data());
    CHECK(netmesh::plan(mesh) == netmesh_plan(&mesh));
    CHECK(netmesh::plan_mesh(mesh) == netmesh_plan_mesh(&mesh));
    std::uint64_t most = 0;
    CHECK(netmesh::plan_polls(mesh, &most) == netmesh_plan_polls(&mesh, nullptr));
    CHECK(most == UINT64_MAX);
    most = 0;
    CHECK(netmesh::plan_mesh_polls(mesh, &most) == netmesh_plan_mesh_polls(&mesh, nullptr));
    CHECK(most == UINT64_MAX);
    mesh.mesh.tau = 1;
    CHECK(netmesh::settle(mesh, &settled) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh::settle(mesh, &settled, &detail) == NETMESH_INVALID_ARGUMENT);
    CHECK(detail.field == NETMESH_FIELD_TAU);
    mesh.mesh.tau = 0;

    netmesh::Request either(&netmesh_filter_auto);
    either.set_points(2, points);
    CHECK(netmesh::plan(either) == netmesh_plan(&either));
    REQUIRE(engine.persist(either) == NETMESH_OK);
    CHECK(std::strcmp(netmesh::why_text(engine.report().diagram.why), "the exact alpha complex is affordable") == 0);

    REQUIRE(engine.mesh(mesh) == NETMESH_OK);
    netmesh::Request complete(&netmesh_filter_complete);
    REQUIRE(engine.persist(complete) == NETMESH_OK);
    complete.bounds = &netmesh_bounds;
    REQUIRE(engine.persist(complete) == NETMESH_OK);
    std::uint64_t pairs = 0, bounds = 0, steps = 0, simplices = 0;
    engine.for_each_pair([&](std::uint64_t i, const netmesh_pair&) { CHECK(i == pairs++); });
    engine.for_each_bar_bounds([&](std::uint64_t i, const netmesh_bar_bounds&) { CHECK(i == bounds++); });
    engine.for_each_scale_step([&](std::uint64_t, const netmesh_scale_step& step) { steps += step.ratio >= 1; });
    CHECK(bounds == pairs);
    CHECK(steps > 0);
    complete.bounds = nullptr;
    complete.cycles = &netmesh_cycles;
    REQUIRE(engine.persist(complete) == NETMESH_OK);
    const auto count = [&](std::uint64_t, const netmesh_simplex&) { ++simplices; };
    CHECK(engine.for_each_in_cycle(0, count) == NETMESH_OK);
    CHECK(simplices > 0);
    CHECK(engine.for_each_in_cycle(pairs, count) != NETMESH_OK);

    std::memcpy(copy.block(), memory.block(), memory.bytes());
    const netmesh::Engine twin = netmesh::Engine::adopt(copy.block());
    CHECK(twin.status() == NETMESH_OK);
    CHECK(twin.report().fingerprint == engine.report().fingerprint);
}

TEST_CASE("the C++ layer: what is measured of a mesh, vines, functions, loading") {
    const inputs::Points points = inputs::uniform(2, 30);
    Memory memory(std::size_t{1} << 23);
    netmesh::Engine engine(memory.block(), memory.bytes());
    netmesh::Request mesh(&netmesh_filter_complete);
    mesh.set_points(2, points);
    mesh.mesh.method = &netmesh_method_svr;
    REQUIRE(engine.mesh(mesh) == NETMESH_OK);
    const netmesh_report report = engine.report();
    std::vector<double> ratios(report.mesh.vertices), vertices, theta(report.mesh.inputs);
    std::vector<std::uint32_t> domains(report.mesh.vertices), order(report.mesh.inputs), cells;
    CHECK(engine.measure_cells(ratios.data(), domains.data()) == NETMESH_OK);
    std::vector<netmesh_voronoi> voronoi(report.mesh.vertices);
    std::vector<netmesh_ball> balls(report.mesh.cells);
    voronoi[0] = netmesh::sized<netmesh_voronoi>();
    balls[0] = netmesh::sized<netmesh_ball>();
    CHECK(engine.measure_voronoi(voronoi.data()) == NETMESH_OK);
    CHECK(engine.measure_balls(balls.data()) == NETMESH_OK);
    CHECK(voronoi.back().beta > 1);
    netmesh_weighted_cell weighted = {};
    CHECK(engine.weighted_cells(&weighted) == NETMESH_INVALID_ARGUMENT);
    CHECK(balls.back().ply > 0);
    REQUIRE(engine.well_paced_order(order.data(), theta.data()) == NETMESH_OK);
    CHECK(engine.pace(order.data(), theta.data()) == NETMESH_OK);
    netmesh::Request vineyard(&netmesh_filter_knn);
    vineyard.k_last = 3;
    vineyard.vines = &netmesh_vines;
    CHECK(engine.persist(vineyard) == NETMESH_OK);
    std::uint64_t vine_points = 0;
    engine.for_each_vine_point([&](std::uint64_t, const netmesh_vine_point&) { ++vine_points; });
    CHECK(vine_points == engine.report().vineyard.points);
    CHECK(engine.vine_ratio(2) >= 1);
    CHECK(engine.vine_ratio(4) == 0);
    auto function = netmesh::sized<netmesh_function>();
    function.evaluate = from_middle;
    function.lipschitz = 1;
    function.cut = 1.5;
    netmesh::Request sublevels(&netmesh_filter_function);
    sublevels.function = &function;
    CHECK(engine.persist(sublevels) == NETMESH_OK);

    std::vector<std::uint8_t> markers;
    engine.for_each_vertex([&](std::uint64_t, const netmesh_vertex& v) {
        vertices.insert(vertices.end(), v.coordinates, v.coordinates + 2);
        markers.push_back(static_cast<std::uint8_t>(v.marker));
    });
    engine.for_each_cell(
        [&](std::uint64_t, const netmesh_cell& c) { cells.insert(cells.end(), c.vertices, c.vertices + 3); });
    auto load = netmesh::sized<netmesh_load_request>();
    load.dim = 2;
    load.vertices = vertices.data();
    load.markers = markers.data();
    load.vertex_count = markers.size();
    load.cells = cells.data();
    load.cell_count = cells.size() / 3;
    load.domain = report.mesh.domain;
    CHECK(engine.load(load) == NETMESH_OK);
    CHECK(engine.load_cages(netmesh::sized<netmesh_cages_request>()) == NETMESH_OK);
    CHECK(engine.check() == NETMESH_OK);
    netmesh_analysis analysis;
    CHECK(engine.analyse(&analysis) == NETMESH_OK);
    CHECK(analysis.what == NETMESH_ANALYSE_ALL);
    netmesh::Request scales(&netmesh_filter_scales);
    scales.set_points(2, points);
    CHECK(engine.persist(scales) == NETMESH_OK);
    CHECK(engine.report().scales.count > 0);
}

TEST_CASE("the C++ layer: ranges are the items of the calls") {
    const inputs::Points points = inputs::uniform(2, 30);
    static netmesh::EngineIn<std::size_t{1} << 23> engine;
    REQUIRE(engine.status() == NETMESH_OK);
    CHECK(engine.pairs().empty());
    CHECK(engine.pairs().size() == 0);
    CHECK(engine.pairs()[0].struct_bytes == 0);
    netmesh::Request complete(&netmesh_filter_complete);
    complete.set_points(2, netmesh::Span<const double>(points.data(), 60));
    CHECK(complete.points.count == 30);
    CHECK(complete.points.format == NETMESH_POINTS_FLOAT64);
    complete.mesh.method = &netmesh_method_svr;
    complete.bounds = &netmesh_bounds;
    complete.cycles = &netmesh_cycles;
    REQUIRE(engine.persist(complete) == NETMESH_OK);
    const netmesh_report report = engine.report();
    CHECK(engine.vertices().size() == report.mesh.vertices);
    CHECK(engine.cells().size() == report.mesh.cells);
    CHECK(engine.cages().empty());
    CHECK(engine.pairs().size() == report.diagram.pairs[0] + report.diagram.pairs[1]);
    CHECK(engine.bar_bounds().size() == engine.pairs().size());
    CHECK(engine.scale_steps().size() == report.bounds.steps);

    // Coordinates of the inputs and corners of the cells, as the calls have them.
    std::uint64_t n = 0;
    netmesh_vertex vertex = netmesh::sized<netmesh_vertex>();
    for (const netmesh_vertex& v : engine.vertices()) {
        REQUIRE(netmesh_get_vertex(engine.context(), n, &vertex) == NETMESH_OK);
        const auto x = netmesh::coordinates(v, 2);
        CHECK(x.size() == 2);
        CHECK(x[0] == vertex.coordinates[0]);
        CHECK(*(x.end() - 1) == vertex.coordinates[1]);
        CHECK(engine.vertices()[n].value == v.value);
        ++n;
    }
    CHECK(n == report.mesh.vertices);
    n = 0;
    for (const netmesh_cell& cell : engine.cells()) {
        CHECK(netmesh::vertices(cell, 2).size() == 3);
        for (const std::uint32_t v : netmesh::vertices(cell, 2)) CHECK(v < report.mesh.vertices);
        for (const std::uint32_t c : netmesh::neighbours(cell, 2)) n += c == NETMESH_NONE;
    }
    CHECK(n > 2);  // edges of the hull

    // Pairs by degree, in their order and with the numbers of all.
    for (std::uint32_t degree = 0; degree < 3; ++degree) {
        const auto some = engine.pairs(degree);
        CHECK(some.size() == (degree < 2 ? report.diagram.pairs[degree] : 0));
        CHECK(some.empty() == (some.size() == 0));
        std::uint64_t at = degree == 0 ? 0 : report.diagram.pairs[0];
        for (auto i = some.begin(); i != some.end(); i++, ++at) {
            CHECK(i->degree == degree);
            CHECK(i.index() == at);
            CHECK(engine.pairs()[at].birth == i->birth);
        }
    }
    CHECK(engine.pairs(0)[report.diagram.pairs[0]].struct_bytes == 0);  // the next one is of another degree

    std::uint64_t simplices = 0;
    REQUIRE(netmesh_get_cycle(engine.context(), 0, &simplices) == NETMESH_OK);
    CHECK(engine.cycle(0).size() == simplices);
    for (const netmesh_simplex& simplex : engine.cycle(0)) CHECK(netmesh::vertices(simplex).size() == 1);
    CHECK(engine.cycle(engine.pairs().size()).empty());

    netmesh::Request vineyard(&netmesh_filter_knn);
    vineyard.k_last = 3;
    vineyard.vines = &netmesh_vines;
    REQUIRE(engine.persist(vineyard) == NETMESH_OK);
    const netmesh_vineyard_report vines = engine.report().vineyard;
    CHECK(engine.vine_points().size() == vines.points);
    n = 0;
    for (std::uint32_t v = 0; v < vines.vines; ++v) {
        CHECK(!engine.vine(v).empty());
        for (const netmesh_vine_point& point : engine.vine(v)) {
            CHECK(point.vine == v);
            ++n;
        }
    }
    CHECK(n == vines.points);
    CHECK(engine.vine(static_cast<std::uint32_t>(vines.vines)).empty());
}

TEST_CASE("the C++ layer: a block that goes with its engine") {
    const std::vector<float> points = {0, 0, 1, 0, 0, 1, 1, 1, 9};
    int released = 0;
    Memory memory(std::size_t{1} << 20);
    const auto release = [&](void* block) {
        CHECK(block == memory.block());
        ++released;
    };
    netmesh::Request alpha(&netmesh_filter_alpha);
    alpha.set_points(2, points);
    CHECK(alpha.points.count == 4);
    CHECK(alpha.points.format == NETMESH_POINTS_FLOAT32);
    {
        netmesh::OwningEngine engine(memory.block(), memory.bytes(), release);
        REQUIRE(engine.persist(alpha) == NETMESH_OK);
        const netmesh::OwningEngine moved(std::move(engine));
        CHECK(moved.pairs(1).size() == 1);
        CHECK(released == 0);
    }
    CHECK(released == 1);
    {
        const netmesh::OwningEngine none(nullptr, 0, release);
        CHECK(none.status() == NETMESH_INVALID_ARGUMENT);
        CHECK(none.pairs().empty());
    }
    CHECK(released == 1);
}

TEST_CASE("the C++ layer: vineyards of values") {
    std::vector<std::max_align_t> block(std::size_t{1} << 14);
    netmesh::Engine engine(block.data(), block.size() * sizeof block[0]);
    const std::uint32_t vertices[] = {0, 1, 0, 1};
    const std::uint64_t starts[] = {0, 1, 2, 4};
    const double values[] = {0, 1, 2, 1, 0, 2};
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.vertices = vertices;
    simplices.starts = starts;
    simplices.entries = values;
    simplices.simplex_count = 3;
    simplices.step_count = 2;
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    request.vines = &netmesh_vines;
    netmesh_request settled;
    REQUIRE(netmesh::settle(request, &settled) == NETMESH_OK);
    CHECK(settled.max_degree == NETMESH_DEGREE_MAX);
    REQUIRE(engine.persist(request) == NETMESH_OK);
    CHECK(engine.report().vineyard.vines == 2);
    CHECK(engine.vine_ratio(2) == 1);
    CHECK(engine.vine_ratio(3) == 0);
}

TEST_CASE("the C++ layer: vineyards of points") {
    std::vector<std::max_align_t> block(std::size_t{1} << 14);
    netmesh::Engine engine(block.data(), block.size() * sizeof block[0]);
    const double points[] = {0, 0, 1, 0, 1, 1, 0, 1};
    netmesh::Request request(&netmesh_filter_barycentric_cech);
    CHECK(request.filter == &netmesh_filter_barycentric_cech);
    request.points = netmesh::points_of(2, points, 8);
    request.vines = &netmesh_vines;
    netmesh_request settled;
    REQUIRE(netmesh::settle(request, &settled) == NETMESH_OK);
    CHECK(settled.points.dim == 2);
    CHECK(settled.k == 1);
    CHECK(settled.k_last == 1);
    CHECK(settled.max_degree == 1);
    request.k_last = 4;
    REQUIRE(engine.persist(request) == NETMESH_OK);
    CHECK(engine.report().vineyard.vines == 8);
    CHECK(engine.vine_ratio(4) == 1);
    CHECK(engine.vine_ratio(5) == 0);
    std::uint64_t points_of_vines = 0;
    engine.for_each_vine_point([&](std::uint64_t, const netmesh_vine_point&) { ++points_of_vines; });
    CHECK(points_of_vines == 11);
}

TEST_CASE("the C++ layer: plans") {
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.simplex_count = 10;
    simplices.vertex_count = 20;
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    const std::size_t homology = netmesh::plan(request);
    CHECK(homology == netmesh_plan(&request));
    CHECK(homology > 0);
    simplices.step_count = 3;
    request.vines = &netmesh_vines;
    CHECK(netmesh::plan(request) == netmesh_plan(&request));
    CHECK(netmesh::plan(request) > homology);
    netmesh::Request points(&netmesh_filter_rips);
    points.points = {nullptr, 20, 2, NETMESH_POINTS_FLOAT64, 0, nullptr, 0, nullptr, 0};
    CHECK(netmesh::plan(points) == netmesh_plan(&points));
    CHECK(netmesh::plan(points) > 0);
    points.filter = &netmesh_filter_barycentric_rips;
    points.vines = &netmesh_vines;
    CHECK(netmesh::plan(points) == netmesh_plan(&points));
    CHECK(netmesh::plan(points) > 0);
}

TEST_CASE("the C++ layer: options are members of a request") {
    netmesh::Request request;
    std::uint32_t options = 0, words = 0;
    netmesh::for_each_option([&](std::uint32_t index, const netmesh_option& option) {
        CAPTURE(option.name);
        CHECK(index == options++);
        CHECK(option.offset < sizeof request);
        CHECK((option.range[0] != 0 && option.default_is[0] != 0 && option.sentence[0] != 0));
        CHECK((option.object == nullptr || option.type == NETMESH_OPTION_FLAG));
        unsigned char* const member = reinterpret_cast<unsigned char*>(&request) + option.offset;
        std::uint32_t of_option = 0;
        netmesh::for_each_option_word(index, [&](const netmesh_option_word& word) {
            ++of_option;
            CHECK(word.name[0] != 0);
            if (std::strcmp(word.name, "barycentric-rips") == 0) std::memcpy(member, &word.object, sizeof word.object);
        });
        CHECK((of_option > 0) == (option.type == NETMESH_OPTION_NAME || option.type == NETMESH_OPTION_NAMES));
        words += of_option;
        const std::uint32_t last = 2;
        if (option.field == NETMESH_FIELD_K_LAST) std::memcpy(member, &last, sizeof last);
        if (option.field == NETMESH_FIELD_VINES) std::memcpy(member, &option.object, sizeof option.object);
    });
    CHECK(options > 30);
    CHECK(words > 20);
    CHECK(request.filter == &netmesh_filter_barycentric_rips);
    CHECK(request.vines == &netmesh_vines);
    CHECK(request.k_last == 2);
    auto option = netmesh::sized<netmesh_option>();
    auto word = netmesh::sized<netmesh_option_word>();
    CHECK(netmesh_get_option(options, &option) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_option(0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_option_word(options, 0, &word) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_option_word(0, 1000, &word) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_option_word(0, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
}
