// The same small jobs in every dimension: what checks say about meshes that are not what they should be, loading what
// is damaged, filters with each kind of values, degenerate places of points.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "common/arrays.hpp"

namespace {

std::string said(const Session& s) { return netmesh_get_detail(s.context).message; }

// Few in high dimensions: meshes grow fast.
constexpr std::size_t points_of[] = {0, 0, 8, 5, 3, 3, 3};

struct Meshed : Session {
    explicit Meshed(int dim, netmesh_job job = NETMESH_JOB_PERSIST) : Session(dim) {
        reserve(std::size_t{1} << 23);
        REQUIRE(mesh(inputs::uniform(dim, points_of[dim]), job) == NETMESH_OK);
    }
};

}  // namespace

TEST_CASE("each check alone") {
    for (int dim = 2; dim <= 6; ++dim) {
        Meshed s(dim);
        for (const std::uint32_t what : {1u, 2u, 4u, 8u, 9u})
            CHECK(netmesh_check(s.context, what, &s.options) == NETMESH_OK);
        Session points(dim);
        REQUIRE(points.delaunay(inputs::uniform(dim, 2 * points_of[dim] + 4)) == NETMESH_OK);
        for (const std::uint32_t what : {1u, 2u, 4u, 8u, 16u})
            CHECK(netmesh_check(points.context, what, &points.options) == NETMESH_OK);
    }
}

TEST_CASE("quality that is not there") {
    for (int dim = 2; dim <= 6; ++dim) {
        CAPTURE(dim);
        Meshed s(dim);
        if (dim < 4) {  // above, these few points have no corners in the domain
            s.options.tau = 2.0001;
            CHECK(netmesh_check(s.context, NETMESH_CHECK_QUALITY, &s.options) == NETMESH_CHECK_FAILED);
            CHECK(said(s) == "a clipped Voronoi cell has an aspect ratio above tau");
            s.options.tau = 0;
            s.options.over_refine_eps = 1e-3;
            CHECK(netmesh_check(s.context, NETMESH_CHECK_QUALITY, &s.options) == NETMESH_CHECK_FAILED);
            CHECK(said(s) == "a clipped Voronoi cell is larger than the size asked for");
            s.options.over_refine_eps = 0;
        }
        Arrays mesh(s);
        for (std::uint8_t& m : mesh.markers) m = m == 2 ? 1 : m;
        REQUIRE(mesh.load(s) == NETMESH_OK);
        CHECK(netmesh_check(s.context, NETMESH_CHECK_QUALITY, &s.options) == NETMESH_CHECK_FAILED);
        CHECK(said(s) == "a vertex of the mesh's hull is not exempt");
    }
}

TEST_CASE("vertices that were moved") {
    for (int dim = 2; dim <= 5; ++dim) {
        CAPTURE(dim);
        Meshed s(dim);
        const Arrays mesh(s);
        const std::size_t d = static_cast<std::size_t>(dim);
        int failed = 0;
        for (std::size_t v = 0; v < mesh.markers.size(); v += 1 + mesh.markers.size() / 4) {
            Arrays moved = mesh;
            for (std::size_t k = 0; k < d; ++k) moved.vertices[v * d + k] += 0.37 * (k % 2 == 0 ? 1 : -1);
            Session other(dim);
            other.reserve(std::size_t{1} << 23);
            REQUIRE(moved.load(other) == NETMESH_OK);
            failed += netmesh_check(other.context, 7, &other.options) == NETMESH_CHECK_FAILED;
            netmesh_check(other.context, NETMESH_CHECK_QUALITY, &other.options);
            if (dim < 4) netmesh_check(other.context, NETMESH_CHECK_BOUNDS, &other.options);
            for (const netmesh_filter filter : {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_BASIC, NETMESH_FILTER_TIGHT}) {
                const netmesh_status status =
                    netmesh_persist(other.context, filter, NETMESH_VALUES_CERTIFIED, 6, 1, &other.options);
                CHECK((status == NETMESH_OK || status == NETMESH_INTERNAL || status == NETMESH_OUT_OF_MEMORY));
            }
        }
        CHECK(failed > 0);
    }
}

TEST_CASE("arrays that cannot be loaded") {
    for (int dim = 2; dim <= 6; ++dim) {
        Meshed s(dim);
        const Arrays mesh(s);
        const std::size_t n = mesh.markers.size(), cells = mesh.cells.size() / (mesh.dim + 1);
        const double* const x = mesh.vertices.data();
        const std::uint8_t* const m = mesh.markers.data();
        const std::uint32_t* const c = mesh.cells.data();
        const double* const ball = mesh.domain.data();
        const auto refused = [&](netmesh_status status, std::uint64_t position) {
            CHECK(status == NETMESH_INVALID_ARGUMENT);
            CHECK(netmesh_get_detail(s.context).index_a == position);
            CHECK(s.report().cells == cells);
        };
        const netmesh_options& o = s.options;
        refused(netmesh_load(s.context, nullptr, m, n, c, cells, ball, &o), 2);
        refused(netmesh_load(s.context, x, m, 0, c, cells, ball, &o), 2);
        refused(netmesh_load(s.context, x, nullptr, n, c, cells, ball, &o), 3);
        Arrays wrong = mesh;
        wrong.markers[0] = 3;
        refused(wrong.load(s), 3);
        wrong.markers[0] = 2;
        refused(wrong.load(s), 3);  // inputs come first
        wrong.markers.assign(n, 1);
        refused(wrong.load(s), 3);  // there are none
        refused(netmesh_load(s.context, x, m, n, nullptr, cells, ball, &o), 5);
        refused(netmesh_load(s.context, x, m, n, c, 0, ball, &o), 5);
        refused(netmesh_load(s.context, x, m, n, c, (std::size_t{1} << 29) + 1, ball, &o), 6);
        for (const double radius : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
            wrong = mesh;
            wrong.domain.back() = radius;
            refused(wrong.load(s), 7);
        }
        wrong = mesh;
        wrong.domain[0] = std::numeric_limits<double>::quiet_NaN();
        refused(wrong.load(s), 7);
        refused(netmesh_load(s.context, x, m, n, c, cells, ball, nullptr), 8);
        wrong = mesh;
        wrong.vertices[static_cast<std::size_t>(dim)] = std::numeric_limits<double>::infinity();
        CHECK(wrong.load(s) == NETMESH_NOT_FINITE);
        CHECK(netmesh_get_detail(s.context).index_a == 1);
        wrong = mesh;
        wrong.cells[1] = static_cast<std::uint32_t>(n);
        CHECK(wrong.load(s) == NETMESH_CHECK_FAILED);
        CHECK(s.report().cells == 0);
        wrong = mesh;
        wrong.cells[0] = wrong.cells[1];
        CHECK(wrong.load(s) == NETMESH_CHECK_FAILED);
        wrong = mesh;
        wrong.cells.insert(wrong.cells.end(), mesh.cells.begin(), mesh.cells.begin() + dim + 1);
        CHECK(wrong.load(s) == NETMESH_CHECK_FAILED);
        CHECK(mesh.load(s) == NETMESH_OK);
    }
}

TEST_CASE("cages of another size") {
    for (int dim = 2; dim <= 6; ++dim) {
        CAPTURE(dim);
        Session s(dim);
        s.reserve(std::size_t{1} << 23);
        s.options.method = NETMESH_METHOD_NETMESH;
        const std::size_t count = dim < 4 ? 6 : dim == 4 ? 4 : 3;
        REQUIRE(s.mesh(inputs::geometric(dim, 40, count)) == NETMESH_OK);
        CHECK(netmesh_check(s.context, NETMESH_CHECK_ALL, &s.options) == NETMESH_OK);
        const Arrays mesh(s);
        REQUIRE(!mesh.cages.empty());
        s.options.tau = 2.0001;
        CHECK(netmesh_check(s.context, NETMESH_CHECK_QUALITY, &s.options) == NETMESH_CHECK_FAILED);
        s.options.tau = 0;
        REQUIRE(mesh.load(s) == NETMESH_OK);
        CHECK(netmesh_load_cages(s.context, mesh.cages.data(), mesh.cages.size(), &s.options) == NETMESH_OK);
        CHECK(netmesh_check(s.context, NETMESH_CHECK_ALL, &s.options) == NETMESH_OK);
        int failed = 0;
        for (const double factor : {0.01, 0.7, 3.0, 1e4})
            for (std::size_t d = 0; d < mesh.cages.size(); ++d) {
                std::vector<netmesh_cage> other = mesh.cages;
                other[d].radius *= factor;
                const netmesh_status status = netmesh_load_cages(s.context, other.data(), other.size(), &s.options);
                CHECK((status == NETMESH_OK || status == NETMESH_CHECK_FAILED));
                if (status == NETMESH_OK)
                    failed += netmesh_check(s.context, NETMESH_CHECK_QUALITY, &s.options) == NETMESH_CHECK_FAILED;
                else
                    ++failed;
                std::vector<double> ratios(mesh.markers.size());
                std::vector<std::uint32_t> domains(mesh.markers.size());
                CHECK(netmesh_measure_cells(s.context, ratios.data(), domains.data()) == NETMESH_OK);
            }
        CHECK(failed > 0);
        REQUIRE(netmesh_load_cages(s.context, mesh.cages.data(), mesh.cages.size(), &s.options) == NETMESH_OK);
        std::vector<netmesh_cage> moved = mesh.cages;
        for (netmesh_cage& cage : moved) cage.centre = s.report().inputs;  // no input
        CHECK(netmesh_load_cages(s.context, moved.data(), moved.size(), &s.options) == NETMESH_CHECK_FAILED);
    }
}

TEST_CASE("filters, values and bounds") {
    for (int dim = 2; dim <= 6; ++dim) {
        CAPTURE(dim);
        Meshed s(dim);
        for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS})
            for (const netmesh_filter filter : {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_BASIC, NETMESH_FILTER_TIGHT,
                                                NETMESH_FILTER_KNN, NETMESH_FILTER_KDISTANCE})
                for (const std::uint32_t k : {0u, 2u, 3u}) {
                    s.options.k = k;
                    const bool counts = filter == NETMESH_FILTER_KNN || filter == NETMESH_FILTER_KDISTANCE;
                    if (!counts && k > 0) continue;
                    REQUIRE(netmesh_persist(s.context, filter, values, k == 2 ? 1 : 9, k == 3, &s.options) ==
                            NETMESH_OK);
                    CHECK(s.report().essential[0] == 1);
                    const std::uint64_t before = s.report().fingerprint;
                    CHECK(netmesh_represent(s.context, &s.options) == NETMESH_OK);
                    CHECK(s.report().fingerprint == before);
                    if (filter == NETMESH_FILTER_BASIC) continue;
                    REQUIRE(netmesh_bound_bars(s.context, &s.options) == NETMESH_OK);
                    const std::vector<netmesh_pair> pairs = s.pairs();
                    for (std::uint64_t i = 0; i < pairs.size(); ++i) {
                        netmesh_bar_bounds b;
                        REQUIRE(netmesh_get_bar_bounds(s.context, i, &b) == NETMESH_OK);
                        CHECK(b.birth_low <= pairs[i].birth);
                        CHECK(b.birth_high >= pairs[i].birth);
                    }
                }
        if (dim > 4) continue;
        for (const netmesh_filter filter : {NETMESH_FILTER_KNN, NETMESH_FILTER_KDISTANCE})
            for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
                REQUIRE(netmesh_vineyard(s.context, filter, 1, 3, values, 2, &s.options) == NETMESH_OK);
                CHECK(s.report().vines > 0);
            }
        CHECK(netmesh_bound_bars(s.context, &s.options) == NETMESH_NO_RESULT);
    }
}

namespace {

struct Shape {
    int kind;
    int calls;
};
double shape(void* user, const double* x) {
    Shape& s = *static_cast<Shape*>(user);
    const double r = std::fabs(x[0] - 0.5) + std::fabs(x[1] - 0.25);
    ++s.calls;
    switch (s.kind) {
    case 0: return r;
    case 1: return 0.25;
    case 2: return s.calls == 3 ? -1 : r;
    case 3: return s.calls == 5 ? std::numeric_limits<double>::quiet_NaN() : r;
    case 4: return r + 10;
    default: return std::floor(r * 8) / 8;
    }
}

}  // namespace

TEST_CASE("functions of every shape") {
    for (int dim = 2; dim <= 6; ++dim)
        for (int kind = 0; kind <= 5; ++kind)
            for (const double cut : {0.0, 0.5, 3.0, 20.0})
                for (const double factor : {0.0, 8.0}) {
                    if (dim > 4 && (cut != 0.5 || kind == 1)) continue;
                    CAPTURE(dim);
                    CAPTURE(kind);
                    Session s(dim);
                    s.reserve(std::size_t{1} << 23);
                    REQUIRE(s.mesh(inputs::uniform(dim, dim < 4 ? 4 : 2), NETMESH_JOB_PERSIST) == NETMESH_OK);
                    Shape user = {kind, 0};
                    const netmesh_function f = {shape, &user, kind == 1 ? 0 : 1.5, factor, cut};
                    const auto values = cut == 3 ? NETMESH_VALUES_THESIS : NETMESH_VALUES_CERTIFIED;
                    const netmesh_status status = netmesh_persist_function(s.context, &f, values, 6, 1, &s.options);
                    if (kind == 2 || kind == 3) {
                        CHECK(status == NETMESH_NOT_FINITE);
                        CHECK(netmesh_get_detail(s.context).index_a == (kind == 2 ? 2 : 4));
                        CHECK(s.report().cells > 0);
                    } else if (factor == 0) {
                        CHECK(status == NETMESH_OK);
                    } else {  // the promise of a factor is false at inputs' neighbours for some shapes
                        CHECK((status == NETMESH_OK || status == NETMESH_INTERNAL));
                    }
                    if (status == NETMESH_OK) CHECK(netmesh_bound_bars(s.context, &s.options) == NETMESH_OK);
                }
}

TEST_CASE("places that are nearly the same") {
    for (int dim = 2; dim <= 6; ++dim) {
        CAPTURE(dim);
        const std::size_t d = static_cast<std::size_t>(dim);
        inputs::Points p(d, 0.0);
        for (std::size_t k = 0; k < d; ++k) {
            p.resize(p.size() + d, 0.0);
            p[p.size() - d + k] = 1;
        }
        inputs::Random random(3);
        for (int i = 0; i < 90; ++i) {  // few denormals about one place, many of them equal
            for (std::size_t k = 0; k < d; ++k)
                p.push_back(k < 2 ? static_cast<double>(random.below(3)) * 0x1p-1074 : 0.0);
        }
        Session s(dim);
        s.reserve(std::size_t{1} << 23);
        REQUIRE(s.delaunay(p) == NETMESH_OK);
        CHECK(s.report().vertices == d + 9);
        CHECK(netmesh_check(s.context, 7, &s.options) == NETMESH_OK);
        CHECK(s.mesh(p) == NETMESH_TOO_CLOSE);
        for (double& x : p) x = x < 0.5 && x > 0 ? 1 - 0x1p-53 : x;
        CHECK(s.mesh(p) == NETMESH_TOO_CLOSE);
        // Flat sets: a line, a plane's grid, one place.
        inputs::Points line;
        for (int i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < d; ++k) line.push_back(i * i * 0.5 + static_cast<double>(k));
        CHECK(s.delaunay(line) == NETMESH_FLAT);
        CHECK(s.delaunay(inputs::Points(5 * d, 0.5)) == NETMESH_FLAT);
        if (dim < 5) {
            CHECK(s.mesh(line) == NETMESH_OK);
            CHECK(s.check() == NETMESH_OK);
        }
        CHECK(s.mesh(inputs::Points(5 * d, 0.5)) == NETMESH_OK);
        CHECK(s.report().inputs == 1);
        for (const netmesh_method method : {NETMESH_METHOD_NETMESH, NETMESH_METHOD_REFINE}) {
            if (dim > 3 && method == NETMESH_METHOD_REFINE) continue;  // large meshes
            s.options.method = method;
            CHECK(s.mesh(inputs::Points(5 * d, 0.5)) == NETMESH_OK);
            CHECK(s.check() == NETMESH_OK);
        }
    }
}
