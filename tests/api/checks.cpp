// What netmesh_check says, in every dimension, about meshes that break one promise each.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

std::string said(const Session& s) { return s.detail().message; }

// As many as make Steiner points, with a tau that asks for them.
std::size_t points_of(int dim) { return by_dimension<std::size_t>(dim, {8, 6, 6, 8, 5}); }

struct Refined : Session {
    explicit Refined(int dim) : Session(dim) {
        if (dim == 6) request.mesh.tau = 2.2;
        reserve(std::size_t{1} << 25);
        REQUIRE(mesh(inputs::uniform(dim, points_of(dim)), &netmesh_filter_complete) == NETMESH_OK);
        REQUIRE(report().mesh.steiner > 0);
    }
};

}  // namespace

TEST_CASE("ratios asked of a loaded mesh") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Arrays mesh{Refined(dim)};
        Session s(dim);
        s.reserve(std::size_t{1} << 25);
        s.request.goal.ratio = 100;
        REQUIRE(mesh.load(s) == NETMESH_OK);
        CHECK(s.report().mesh.tau == 0);
        CHECK(s.check(NETMESH_CHECK_QUALITY) == NETMESH_OK);
        const auto fails = [&](double ratio, double focus, double from, double to) {
            s.request.goal = {ratio, 0, 0, 0, focus, from, to, 0};
            return s.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED ? said(s) : std::string();
        };
        CHECK(fails(1.42, 0, 0, 0) == "the certified ratio is above the one asked for");
        CHECK(fails(100, 1.001, 1e-9, 1e9) == "a cell's ratio is above the one asked for at its scale");
        CHECK(fails(100, 99, 1e-9, 1e9).empty());
        CHECK(fails(100, 1.001, 1e9, 2e9).empty());     // above all cells
        CHECK(fails(100, 1.001, 1e-12, 1e-9).empty());  // below
        for (std::uint8_t& m : mesh.markers) m = m == 2 ? 1 : m;
        s.request.goal = {100, 0, 0, 0, 0, 0, 0, 0};
        REQUIRE(mesh.load(s) == NETMESH_OK);
        CHECK(s.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
        CHECK(said(s) == "a vertex of the mesh's hull is not exempt");
    }
}

TEST_CASE("quality and size asked of cells in a wider domain") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Arrays mesh{Refined(dim)};
        mesh.domain.back() *= 2;  // which holds corners that were clipped
        Session s(dim);
        s.reserve(std::size_t{1} << 25);
        REQUIRE(mesh.load(s) == NETMESH_OK);
        CHECK(s.report().mesh.aspect_ratio_max > 2.0001);
        s.request.mesh.tau = 2.0001;
        CHECK(s.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
        CHECK(said(s) == "a clipped Voronoi cell has an aspect ratio above tau");
        s.request.mesh.tau = 1e9;
        CHECK(s.check(NETMESH_CHECK_QUALITY) == NETMESH_OK);
        s.request.mesh.sizes.eps = 1e-3;
        CHECK(s.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
        CHECK(said(s) == "a clipped Voronoi cell is larger than the size asked for");
    }
}

TEST_CASE("a cell twice, apart from the mesh") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        REQUIRE(s.mesh(inputs::uniform(dim, 3)) == NETMESH_OK);
        Arrays mesh(s);
        const std::uint32_t first = static_cast<std::uint32_t>(mesh.markers.size());
        for (int i = 0; i <= dim; ++i) {
            for (int k = 0; k < dim; ++k) mesh.vertices.push_back(100 + (k == i));
            mesh.markers.push_back(2);
        }
        for (int copy = 0; copy < 2; ++copy)
            for (int i = 0; i <= dim; ++i) mesh.cells.push_back(first + static_cast<std::uint32_t>(i));
        s.reserve(std::size_t{1} << 22);
        REQUIRE(mesh.load(s) == NETMESH_OK);
        for (const std::uint32_t what : {1u, 2u, 4u, 8u, 16u, 31u}) {
            CHECK(s.check(what) == NETMESH_CHECK_FAILED);
            CHECK(said(s) == "neighbours share more than a facet");
        }
    }
}

TEST_CASE("vertices in no cell, and triangulations, are loaded and checked") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        REQUIRE(s.delaunay(inputs::uniform(dim, 12)) == NETMESH_OK);
        Arrays cells(s);
        cells.domain.clear();
        for (int k = 0; k < dim; ++k) cells.vertices.push_back(7);
        cells.markers.push_back(1);
        s.reserve(std::size_t{1} << 22);
        REQUIRE(cells.load(s) == NETMESH_OK);
        CHECK(s.report().mesh.vertices == 13);
        CHECK(s.report().mesh.is_mesh == 0);
        CHECK(s.check() == NETMESH_OK);
        CHECK(s.persist() == NETMESH_NO_RESULT);
    }
}

TEST_CASE("a triangulation that is not Delaunay is refused, whatever else is asked for") {
    if (dimensions({2}).empty()) return;
    Session s(2);
    REQUIRE(s.delaunay({0, 0, 2, 0, 0, 2, 3, 3}) == NETMESH_OK);
    Arrays cells(s);
    cells.domain.clear();
    for (double& x : cells.vertices)
        if (x == 3) x = 1.2;  // into the circle of the other three
    REQUIRE(cells.load(s) == NETMESH_OK);
    CHECK(s.check(NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC) == NETMESH_OK);
    for (const std::uint32_t what : {NETMESH_CHECK_DELAUNAY + 0u, NETMESH_CHECK_ALL + 0u})
        CHECK(s.check(what) == NETMESH_CHECK_FAILED);
}

// Of a flat cell no radius is known, and with any number for it faces could enter after their cofaces.
TEST_CASE("alpha refuses cells that were loaded flat") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const std::size_t d = static_cast<std::size_t>(dim);
        inputs::Points points = inputs::uniform(dim, 14, 5);
        for (double& x : points) x = std::floor(512 * x);
        Session s(dim);
        REQUIRE(s.delaunay(points) == NETMESH_OK);
        Arrays whole(s);
        whole.domain.clear();
        s.reserve(std::size_t{1} << 24);
        Arrays flat = whole, one = whole, point = whole, nothing = whole;
        for (std::size_t v = 0; v < flat.markers.size(); ++v) flat.vertices[d * v + d - 1] = 3;
        // One vertex of a cell in the middle between two others, or where another one is, or all of them in one place.
        const auto at = [](Arrays& cells, std::size_t corner, std::size_t k) -> double& {
            return cells.vertices[cells.dim * cells.cells[corner] + k];
        };
        for (std::size_t k = 0; k < d; ++k) {
            at(one, 0, k) = 0.5 * (at(whole, 1, k) + at(whole, 2, k));
            at(point, 0, k) = at(whole, 1, k);
            for (std::size_t corner = 0; corner <= d; ++corner) at(nothing, corner, k) = 0;
        }
        for (const Arrays* const cells : {&flat, &one, &point, &nothing}) {
            REQUIRE(cells->load(s) == NETMESH_OK);
            CHECK(s.persist(&netmesh_filter_alpha) == NETMESH_CHECK_FAILED);
            CHECK(said(s).find("flat") != std::string::npos);
            CHECK(s.report().diagram.present == 0);
            CHECK(s.check(NETMESH_CHECK_COMBINATORIAL) == NETMESH_OK);
            CHECK(s.check(NETMESH_CHECK_GEOMETRIC) == NETMESH_CHECK_FAILED);
        }
        REQUIRE(whole.load(s) == NETMESH_OK);
        CHECK(s.persist(&netmesh_filter_alpha) == NETMESH_OK);
    }
}

TEST_CASE("a domain about its only input") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        REQUIRE(s.mesh(inputs::uniform(dim, 1)) == NETMESH_OK);
        const Arrays mesh(s);
        for (int k = 0; k < dim; ++k)
            REQUIRE(mesh.domain[static_cast<std::size_t>(k)] == mesh.vertices[static_cast<std::size_t>(k)]);
        s.reserve(std::size_t{1} << 22);
        REQUIRE(mesh.load(s) == NETMESH_OK);
        CHECK(s.check() == NETMESH_OK);
        REQUIRE(s.persist() == NETMESH_OK);
        CHECK(s.pairs().size() == 1);
        CHECK(std::isinf(s.pairs()[0].death));
    }
}

TEST_CASE("two inputs too near for so few vertices") {
    for (const int dim : dimensions(2, 4)) {
        CAPTURE(dim);
        inputs::Points points = inputs::uniform(dim, static_cast<std::size_t>(dim) + 2);
        for (int k = 0; k < dim; ++k) points[static_cast<std::size_t>(k)] = 1e-30 * (k == 0);
        for (int k = 0; k < dim; ++k) points[static_cast<std::size_t>(dim + k)] = 0;
        Session s(dim);
        REQUIRE(s.delaunay(points) == NETMESH_OK);
        Arrays mesh(s);
        mesh.domain.assign(static_cast<std::size_t>(dim), 0.5);
        mesh.domain.push_back(1.5);
        s.reserve(std::size_t{1} << 22);
        s.request.mesh.tau = 2.0001;
        REQUIRE(mesh.load(s) == NETMESH_OK);
        CHECK(s.check(NETMESH_CHECK_BOUNDS) == NETMESH_CHECK_FAILED);
        CHECK(said(s).find("3.4.2") != std::string::npos);
    }
}

TEST_CASE("rows of points that scales cannot be meshed with") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const std::size_t d = static_cast<std::size_t>(dim);
        Session s(dim);
        s.reserve(std::size_t{1} << 22);
        for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
            const inputs::Points one(d, 0.25);
            netmesh::Request request = s.scales_request(one);
            request.values = values;
            request.max_degree = 9;
            REQUIRE(s.persist(request) == NETMESH_OK);
            CHECK(s.pairs().size() == 1);
            CHECK(s.report().scales.count == 1);
            CHECK(s.represent() == NETMESH_NO_RESULT);
            CHECK(s.check() == NETMESH_NO_RESULT);
            netmesh_analysis analysis;
            CHECK(s.analyse(&analysis, NETMESH_ANALYSE_FATNESS) == NETMESH_NO_RESULT);
        }
        const auto refused = [&](const inputs::Points& p, netmesh_status status, std::uint64_t a, std::uint64_t b) {
            const netmesh::Request request = s.scales_request(p);
            CHECK(netmesh_persist(s.context, &request) == status);
            CHECK(s.detail().index_a == a);
            CHECK(s.detail().index_b == b);
        };
        inputs::Points p(3 * d, 0.0);
        p[d] = 1;
        p[2 * d] = 0x1p600;
        refused(p, NETMESH_OUT_OF_RANGE, 2, 0);
        // Differences that are not exact, so that the points stay far from the origin, where 1e-5 is too little.
        for (std::size_t i = 0; i < 3; ++i) p[i * d] = 1e9;
        p[1] = 1e-30;
        p[d + 1] = 1e-5;
        p[2 * d + 1] = 0.99e-5;
        refused(inputs::Points(p.begin(), p.begin() + 2 * static_cast<std::ptrdiff_t>(d)), NETMESH_TOO_CLOSE, 0, 1);
        p[d + 1] = 6e-5;
        p[2 * d + 1] = 7e-5;  // chosen before the one above
        refused(p, NETMESH_TOO_CLOSE, 1, 2);
        p[d + 1] = p[2 * d + 1] = 1e-4;  // the size asked for is too little
        refused(p, NETMESH_INVALID_ARGUMENT, 0, 0);
        CHECK(s.detail().field == NETMESH_FIELD_SIZES);
        p[2 * d] = HUGE_VAL;
        refused(p, NETMESH_NOT_FINITE, 2, 0);
    }
}

namespace {

void alpha_refuses(const Arrays& cells) {
    Session s(static_cast<int>(cells.dim));
    s.reserve(std::size_t{1} << 24);
    REQUIRE(cells.load(s) == NETMESH_OK);
    CHECK(s.persist(&netmesh_filter_alpha) == NETMESH_CHECK_FAILED);
    CHECK(!said(s).empty());
    CHECK(s.report().diagram.present == 0);
    CHECK(s.report().mesh.cells == cells.cells.size() / (cells.dim + 1));
    CHECK(s.check(NETMESH_CHECK_GEOMETRIC) == NETMESH_CHECK_FAILED);
}

Arrays by_hand(std::uint32_t dim, const std::vector<double>& vertices, const std::vector<std::uint32_t>& cells) {
    Arrays made(dim);
    made.vertices = vertices;
    made.cells = cells;
    made.markers.assign(vertices.size() / dim, 0);
    return made;
}

}  // namespace

TEST_CASE("alpha refuses cells that are no ball") {
    alpha_refuses(by_hand(2, {0, 0, 10, 1, 10, 3, 10, -1, 10, -3}, {0, 1, 2, 0, 3, 4}));
    alpha_refuses(by_hand(2, {0, 0, 4, 0.1, 2, 3.3, 2, -1, 4, 2.5, 0, 2.4}, {0, 1, 3, 1, 2, 4, 2, 0, 5}));
    // A ring of triangles about a square.
    alpha_refuses(by_hand(2, {-1, -1, 1, -1, 1, 1.1, -1, 1, -3, -3, 3, -3, 3, 3.1, -3, 3},
                          {0, 1, 4, 1, 5, 4, 1, 2, 5, 2, 6, 5, 2, 3, 6, 3, 7, 6, 3, 0, 7, 0, 4, 7}));
    alpha_refuses(
        by_hand(3, {0, 0, 0, 0, 0, 1, 3, 1, 0, 3, -1, 0.2, -3, 1, 0, -3, -1.1, 0.2}, {0, 1, 2, 3, 0, 1, 4, 5}));
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const std::size_t d = static_cast<std::size_t>(dim), corners = d + 1;
        Session s(dim);
        REQUIRE(s.delaunay(inputs::uniform(dim, d + 8, 3)) == NETMESH_OK);
        REQUIRE(s.persist(&netmesh_filter_alpha) == NETMESH_OK);
        const auto bars = read_all(s.context, netmesh_get_pair);
        Arrays whole(s);
        whole.domain.clear();
        Session loaded(dim);
        loaded.reserve(std::size_t{1} << 24);
        REQUIRE(whole.load(loaded) == NETMESH_OK);
        CHECK(loaded.persist(&netmesh_filter_alpha) == NETMESH_OK);
        const auto again = read_all(loaded.context, netmesh_get_pair);
        REQUIRE(again.size() == bars.size());
        for (std::size_t i = 0; i < bars.size(); ++i) {
            CHECK(again[i].birth == bars[i].birth);
            CHECK(again[i].death == bars[i].death);
        }
        Arrays twice = whole, two = whole;
        twice.cells.insert(twice.cells.end(), whole.cells.end() - static_cast<std::ptrdiff_t>(corners),
                           whole.cells.end());
        {
            Session other(dim);
            other.reserve(std::size_t{1} << 24);
            const netmesh_status status = twice.load(other);
            CHECK((status == NETMESH_CHECK_FAILED || other.persist(&netmesh_filter_alpha) == NETMESH_CHECK_FAILED));
        }
        const std::uint32_t first = static_cast<std::uint32_t>(whole.markers.size());
        for (const double x : whole.vertices) two.vertices.push_back(x + 9);
        for (const std::uint32_t v : whole.cells) two.cells.push_back(v + first);
        two.markers.resize(2 * whole.markers.size(), 0);
        alpha_refuses(two);
        // Without one cell, all of whose vertices are in others.
        for (std::size_t out = 0; out < whole.cells.size(); out += corners) {
            Arrays rest = whole;
            const auto at = rest.cells.begin() + static_cast<std::ptrdiff_t>(out);
            rest.cells.erase(at, at + static_cast<std::ptrdiff_t>(corners));
            std::vector<bool> used(first);
            for (const std::uint32_t v : rest.cells) used[v] = true;
            if (std::find(used.begin(), used.end(), false) == used.end()) alpha_refuses(rest);
        }
    }
}
