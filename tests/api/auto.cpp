// The filter auto: the filter that it takes and why, by counts of work, and that the result is that filter's.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "common/dimensions.hpp"
#include "common/kinds.hpp"
#include "common/session.hpp"

namespace {

netmesh_status persist_auto(Session& s, const inputs::Points& points) {
    const netmesh::Request request = s.auto_request(points);
    return netmesh_persist(s.context, &request);
}

// The same by the filter itself.
netmesh_status persist_by_filter(Session& s, const inputs::Points& points, netmesh_filter_id filter) {
    netmesh::Request request = on(points, s.plain(filter_of(filter)));
    request.keep_mesh = 1;
    return netmesh_persist(s.context, &request);
}

void expect_result_of(Session& s, const inputs::Points& points) {
    const netmesh_report chosen = s.report();
    const std::vector<netmesh_pair> pairs = s.pairs();
    REQUIRE(persist_by_filter(s, points, chosen.diagram.filter) == NETMESH_OK);
    const netmesh_report asked = s.report();
    CHECK(chosen.fingerprint == asked.fingerprint);
    CHECK(chosen.complete == 1);
    CHECK(asked.diagram.why == NETMESH_WHY_ASKED);
    CHECK(asked.diagram.tried_cells == 0);
    CHECK(chosen.diagram.certified_ratio == asked.diagram.certified_ratio);
    const std::vector<netmesh_pair> same = s.pairs();
    REQUIRE(pairs.size() == same.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        CHECK(pairs[i].degree == same[i].degree);
        CHECK(pairs[i].birth == same[i].birth);
        CHECK(pairs[i].death == same[i].death);
    }
}

struct Choice {
    const char* kind;
    int dim;
    std::size_t count;
    netmesh_filter_id filter;
};

constexpr netmesh_filter_id exact = NETMESH_FILTER_ALPHA, meshed = NETMESH_FILTER_COMPLETE;
constexpr Choice choices[] = {
    {"uniform", 2, 1000, exact},      {"clusters", 2, 1000, exact},       {"circle", 2, 500, exact},
    {"noisy circle", 2, 100, exact},  {"noisy eight", 2, 1000, exact},    {"grid", 2, 4900, exact},
    {"uniform", 3, 1000, exact},      {"clusters", 3, 1000, exact},       {"sphere", 3, 500, exact},
    {"torus", 3, 2000, exact},        {"noisy helix", 3, 1000, exact},    {"closed curve", 3, 300, exact},
    {"grid", 3, 3375, exact},         {"helix", 3, 500, meshed},          {"skew lines", 3, 100, exact},
    {"skew lines", 3, 1000, meshed},  {"moment curve", 3, 500, meshed},   {"uniform", 4, 200, exact},
    {"clusters", 4, 100, exact},      {"closed curve", 4, 200, meshed},   {"orthogonal circles", 4, 200, meshed},
    {"moment curve", 4, 200, meshed}, {"Clifford curve", 4, 500, meshed}, {"uniform", 5, 50, exact},
    {"moment curve", 5, 50, meshed},
};

inputs::Points points_of(const Choice& choice) {
    for (const kinds::Kind& kind : kinds::all())
        if (std::strcmp(kind.name, choice.kind) == 0 && kind.dim == choice.dim) return kind.make(choice.count);
    return {};
}

// Two skew lines and two points that are the least number apart.
inputs::Points skew_lines_and_a_close_pair() {
    inputs::Points points = kinds::skew_lines(400);
    for (const double x : {0.75, std::nextafter(0.75, 1)}) points.insert(points.end(), {x, 0.5, 0.25});
    return points;
}

}  // namespace

TEST_CASE("everyday clouds and lattices take alpha, curves with many cells the mesh") {
    for (const Choice& choice : choices) {
        if (!netmesh::serves_dimension(static_cast<std::uint32_t>(choice.dim))) continue;
        INFO(choice.kind << ", D = " << choice.dim << ", " << choice.count);
        const inputs::Points points = points_of(choice);
        REQUIRE(!points.empty());
        Session s(choice.dim);
        s.reserve(std::size_t{1} << 29);
        REQUIRE(persist_auto(s, points) == NETMESH_OK);
        const netmesh_report report = s.report();
        const netmesh_diagram_report& diagram = report.diagram;
        CHECK(diagram.filter == choice.filter);
        CHECK(diagram.why == (choice.filter == exact ? NETMESH_WHY_AFFORDABLE : NETMESH_WHY_CELLS));
        if (choice.filter == exact) {
            CHECK(diagram.tried_points == report.input.distinct);
            CHECK(diagram.tried_cells == report.mesh.cells_created);
            CHECK(diagram.certified_ratio == 1);
        } else {  // what was given up is a quarter of all cells at most
            CHECK(diagram.tried_points < report.input.distinct);
            CHECK(3 * diagram.tried_cells <= report.mesh.cells_created);
            CHECK(diagram.certified_ratio > 1);
        }
        expect_result_of(s, points);
    }
}

TEST_CASE("where the alpha complex does not fit and the mesh does it is the mesh") {
    for (const int dim : dimensions({2, 3})) {
        const inputs::Points points = inputs::jittered(dim, dim == 2 ? 30 : 9, 0.05, 3);
        Session s(dim);
        s.reserve(std::size_t{1} << 26);
        REQUIRE(persist_by_filter(s, points, exact) == NETMESH_OK);
        const std::size_t alpha_bytes = s.report().memory.peak_bytes;
        REQUIRE(persist_by_filter(s, points, meshed) == NETMESH_OK);
        const std::size_t mesh_bytes = s.report().memory.peak_bytes;
        INFO("D = " << dim << ", alpha takes " << alpha_bytes << " bytes, a mesh " << mesh_bytes);
        REQUIRE(mesh_bytes < alpha_bytes);
        s.reserve(alpha_bytes + alpha_bytes / 16);
        REQUIRE(persist_auto(s, points) == NETMESH_OK);
        CHECK(s.report().diagram.why == NETMESH_WHY_AFFORDABLE);
        s.reserve((alpha_bytes + mesh_bytes) / 2);
        REQUIRE(persist_auto(s, points) == NETMESH_OK);
        CHECK(s.report().diagram.filter == meshed);
        CHECK(s.report().diagram.why == NETMESH_WHY_MEMORY);
        CHECK(s.report().memory.peak_bytes <= (alpha_bytes + mesh_bytes) / 2 + 16);
        s.reserve(mesh_bytes - mesh_bytes / 8);
        CHECK(persist_auto(s, points) == NETMESH_OUT_OF_MEMORY);
        CHECK(s.report().input.present == 0);
        CHECK(s.detail().bytes_wanted > mesh_bytes - mesh_bytes / 8);
    }
}

// A block that holds a part of the triangulation gives it up before it is full.
TEST_CASE("a triangulation that would leave no room for its alpha complex is given up") {
    const inputs::Points points = inputs::jittered(3, 12, 0.05, 4);
    Session s(3);
    s.reserve(std::size_t{1} << 26);
    REQUIRE(persist_by_filter(s, points, meshed) == NETMESH_OK);
    const std::size_t mesh_bytes = s.report().memory.peak_bytes;
    s.reserve(mesh_bytes + mesh_bytes / 16);
    REQUIRE(persist_auto(s, points) == NETMESH_OK);
    CHECK(s.report().diagram.why == NETMESH_WHY_MEMORY);
    CHECK(s.report().diagram.tried_points < s.report().input.distinct);
}

TEST_CASE("what has no Delaunay triangulation has a mesh") {
    for (const int dim : dimensions()) {
        Session s(dim);
        s.reserve(std::size_t{1} << 26);
        inputs::Points points = inputs::uniform(dim, by_dimension<std::size_t>(dim, {20, 20, 10, 4, 3}));
        for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(dim)) points[i] = 1;
        REQUIRE(persist_auto(s, points) == NETMESH_OK);
        CHECK(s.report().diagram.filter == meshed);
        CHECK(s.report().diagram.why == NETMESH_WHY_FLAT);
        CHECK(s.report().diagram.tried_points == 0);
        expect_result_of(s, points);
    }
}

TEST_CASE("what is out of both filters' ranges is refused as that") {
    for (const int dim : dimensions({5, 6})) {
        Session s(dim);
        s.reserve(std::size_t{1} << 28);
        inputs::Points points = inputs::uniform(dim, static_cast<std::size_t>(dim) + 2, 3);
        for (std::size_t i = 0; i < points.size(); ++i) points[i] *= i < points.size() / 2 ? 0x1p-900 : 0x1p900;
        REQUIRE(persist_by_filter(s, points, exact) == NETMESH_OUT_OF_RANGE);
        CHECK(persist_auto(s, points) == NETMESH_OUT_OF_RANGE);
        CHECK(s.report().input.present == 0);
    }
}

TEST_CASE("what has no mesh has its alpha complex, however large") {
    const inputs::Points points = skew_lines_and_a_close_pair();
    Session s(3);
    s.reserve(std::size_t{1} << 28);
    REQUIRE(persist_by_filter(s, points, meshed) == NETMESH_TOO_CLOSE);
    REQUIRE(persist_auto(s, points) == NETMESH_OK);
    CHECK(s.report().diagram.filter == exact);
    CHECK(s.report().diagram.why == NETMESH_WHY_NO_MESH);
    CHECK(s.report().diagram.tried_points < s.report().input.distinct);
    expect_result_of(s, points);
}

TEST_CASE("what has no mesh says how much memory its alpha complex wants") {
    const inputs::Points sets[] = {{0, 0, 1, 0, 0, 1, 0x1p600, 0x1p600, 3, 4, 5, 1},
                                   {1, 1, 1 + 0x1p-50, 1, 2, 1, 1, 2, 3, 3, 0, 5}};
    for (const inputs::Points& points : sets) {
        Session s(2);
        bool good = false;
        for (std::size_t bytes = 2560; bytes < 40000; bytes += 512) {
            s.reserve(bytes);
            const netmesh_status status = persist_auto(s, points);
            CHECK((status == NETMESH_OUT_OF_MEMORY || status == NETMESH_OK));
            CHECK((status == NETMESH_OK || s.detail().bytes_wanted > 0));
            CHECK((status == NETMESH_OK || !good));
            good = status == NETMESH_OK;
        }
        CHECK(good);
        CHECK(s.report().diagram.filter == exact);
    }
}

TEST_CASE("degrees, zero pairs and later calls are those of the filter") {
    const inputs::Points clouds[] = {inputs::uniform(2, 60), inputs::grid(2, 40)};
    for (const inputs::Points& points : clouds) {
        Session s(2);
        s.reserve(std::size_t{1} << 26);
        netmesh::Request request = s.auto_request(points);
        request.max_degree = 0;
        request.keep_zero_pairs = 1;
        REQUIRE(s.persist(request) == NETMESH_OK);
        CHECK(s.report().diagram.max_degree == 0);
        const std::uint64_t all = s.report().diagram.pairs[0];
        request.keep_zero_pairs = 0;
        REQUIRE(s.persist(request) == NETMESH_OK);
        CHECK(s.report().diagram.pairs[0] <= all);
        REQUIRE(s.represent() == NETMESH_OK);
        REQUIRE(s.bound_bars() == NETMESH_OK);
        CHECK(s.report().diagram.why != NETMESH_WHY_ASKED);
        if (s.report().diagram.filter == meshed) {
            REQUIRE(s.persist() == NETMESH_OK);
            CHECK(s.report().diagram.why == NETMESH_WHY_ASKED);
        }
    }
}

TEST_CASE("without OK the context is empty") {
    Session s(3);
    s.reserve(std::size_t{1} << 26);
    inputs::Points points = inputs::uniform(3, 200);
    REQUIRE(persist_auto(s, points) == NETMESH_OK);
    points[7] = std::numeric_limits<double>::quiet_NaN();
    CHECK(persist_auto(s, points) == NETMESH_NOT_FINITE);
    CHECK(s.detail().index_a == 2);
    CHECK(s.report().input.present == 0);
    points = kinds::skew_lines(1000);
    // Stopped in each stage in turn: while it triangulates, while it refines, while it filters.
    for (const netmesh_stage stage : {NETMESH_STAGE_DELAUNAY, NETMESH_STAGE_REFINE, NETMESH_STAGE_CERTIFY}) {
        netmesh_stage stop_in = stage;
        s.request.monitor = {[](void* at, const netmesh_progress* progress) -> int {
                                 return progress->stage == *static_cast<netmesh_stage*>(at) ? 1 : 0;
                             },
                             &stop_in};
        CHECK(persist_auto(s, points) == NETMESH_CANCELLED);
        CHECK(s.report().input.present == 0);
        CHECK(s.report().mesh.present == 0);
    }
    s.request.monitor = {};
    CHECK(persist_auto(s, points) == NETMESH_OK);
}

TEST_CASE("a planned block does for uniform points, of which alpha is taken") {
    for (const int dim : dimensions()) {
        const inputs::Points points = inputs::uniform(dim, by_dimension<std::size_t>(dim, {2000, 1000, 100, 20, 10}));
        Session s(dim);
        netmesh::Request request = s.auto_request(points);
        const std::size_t planned = netmesh_plan(&request);
        s.reserve(planned);
        CHECK(netmesh_persist(s.context, &request) == NETMESH_OK);
        CHECK(s.report().memory.peak_bytes <= planned);
        CHECK(s.report().diagram.why == NETMESH_WHY_AFFORDABLE);
        request.points.count = 0;
        CHECK(netmesh_plan(&request) == 0);
        request.points.dim = 7;
        CHECK(netmesh_plan(&request) == 0);
    }
    CHECK(netmesh_plan(nullptr) == 0);
}

TEST_CASE("every reason has a text of its own") {
    std::vector<std::string> texts;
    for (int why = NETMESH_WHY_ASKED; why <= NETMESH_WHY_ALONE + 1; ++why) {
        const std::string text = netmesh_why_text(static_cast<netmesh_why>(why));
        for (const std::string& other : texts) CHECK(other != text);
        texts.push_back(text);
    }
    CHECK(texts.back() == "unknown reason");
}
