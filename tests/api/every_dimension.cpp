// The same small jobs in every dimension: what checks say about meshes that are not what they should be, loading what
// is damaged, filters with each kind of values, degenerate places of points.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

std::string said(const Session& s) { return s.detail().message; }

// Few in high dimensions: meshes grow fast.
std::size_t points_of(int dim) { return by_dimension<std::size_t>(dim, {8, 5, 3, 3, 3}); }

struct Meshed : Session {
    explicit Meshed(int dim, const netmesh_filter* filter = &netmesh_filter_complete) : Session(dim) {
        reserve(std::size_t{1} << 23);
        REQUIRE(mesh(inputs::uniform(dim, points_of(dim)), filter) == NETMESH_OK);
    }
};

}  // namespace

TEST_CASE("each check alone") {
    for (const int dim : dimensions()) {
        Meshed s(dim);
        for (const std::uint32_t what : {1u, 2u, 4u, 8u, 9u}) CHECK(s.check(what) == NETMESH_OK);
        Session points(dim);
        REQUIRE(points.delaunay(inputs::uniform(dim, 2 * points_of(dim) + 4)) == NETMESH_OK);
        for (const std::uint32_t what : {1u, 2u, 4u, 8u, 16u}) CHECK(points.check(what) == NETMESH_OK);
    }
}

TEST_CASE("quality that is not there") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Meshed s(dim);
        if (dim < 4) {  // above, these few points have no corners in the domain
            s.request.mesh.tau = 2.0001;
            CHECK(s.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
            CHECK(said(s) == "a clipped Voronoi cell has an aspect ratio above tau");
            s.request.mesh.tau = 0;
            s.request.mesh.sizes.eps = 1e-3;
            CHECK(s.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
            CHECK(said(s) == "a clipped Voronoi cell is larger than the size asked for");
            s.request.mesh.sizes.eps = 0;
        }
        Arrays mesh(s);
        for (std::uint8_t& m : mesh.markers) m = m == 2 ? 1 : m;
        REQUIRE(mesh.load(s) == NETMESH_OK);
        CHECK(s.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
        CHECK(said(s) == "a vertex of the mesh's hull is not exempt");
    }
}

TEST_CASE("vertices that were moved") {
    for (const int dim : dimensions(2, 5)) {
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
            failed += other.check(7) == NETMESH_CHECK_FAILED;
            other.check(NETMESH_CHECK_QUALITY);
            if (dim < 4) other.check(NETMESH_CHECK_BOUNDS);
            for (const netmesh_filter* const filter :
                 {&netmesh_filter_complete, &netmesh_filter_basic, &netmesh_filter_tight}) {
                netmesh::Request all = persist_by(filter);
                all.keep_zero_pairs = 1;
                const netmesh_status status = other.persist(all);
                CHECK((status == NETMESH_OK || status == NETMESH_INTERNAL || status == NETMESH_OUT_OF_MEMORY));
            }
        }
        CHECK(failed > 0);
    }
}

TEST_CASE("arrays that cannot be loaded") {
    for (const int dim : dimensions()) {
        Meshed s(dim);
        const Arrays mesh(s);
        const std::size_t n = mesh.markers.size(), cells = mesh.cells.size() / (mesh.dim + 1);
        const auto refused = [&](netmesh_status status, netmesh_field field) {
            CHECK(status == NETMESH_INVALID_ARGUMENT);
            CHECK(s.detail().field == field);
            CHECK(s.report().mesh.cells == cells);
        };
        const auto without = [&](auto member, auto value, netmesh_field field) {
            netmesh_load_request request = mesh.load_request(s.request);
            request.*member = value;
            refused(netmesh_load(s.context, &request), field);
        };
        using Request = netmesh_load_request;
        without(&Request::vertices, nullptr, NETMESH_FIELD_VERTICES);
        without(&Request::vertex_count, 0, NETMESH_FIELD_VERTEX_COUNT);
        without(&Request::markers, nullptr, NETMESH_FIELD_MARKERS);
        without(&Request::cells, nullptr, NETMESH_FIELD_CELLS);
        without(&Request::cell_count, 0, NETMESH_FIELD_CELL_COUNT);
        without(&Request::cell_count, (std::size_t{1} << 29) + 1, NETMESH_FIELD_CELL_COUNT);
        refused(netmesh_load(s.context, nullptr), NETMESH_FIELD_REQUEST);
        Arrays wrong = mesh;
        wrong.markers[0] = 3;
        refused(wrong.load(s), NETMESH_FIELD_MARKERS);
        wrong.markers[0] = 2;
        refused(wrong.load(s), NETMESH_FIELD_MARKERS);  // inputs come first
        wrong.markers.assign(n, 1);
        refused(wrong.load(s), NETMESH_FIELD_MARKERS);  // there are none
        for (const double radius : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
            wrong = mesh;
            wrong.domain.back() = radius;
            refused(wrong.load(s), NETMESH_FIELD_DOMAIN);
        }
        wrong = mesh;
        wrong.domain[0] = std::numeric_limits<double>::quiet_NaN();
        refused(wrong.load(s), NETMESH_FIELD_DOMAIN);
        wrong = mesh;
        wrong.vertices[static_cast<std::size_t>(dim)] = std::numeric_limits<double>::infinity();
        CHECK(wrong.load(s) == NETMESH_NOT_FINITE);
        CHECK(s.detail().index_a == 1);
        wrong = mesh;
        wrong.cells[1] = static_cast<std::uint32_t>(n);
        CHECK(wrong.load(s) == NETMESH_CHECK_FAILED);
        CHECK(s.report().mesh.cells == 0);
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
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        s.reserve(std::size_t{1} << 23);
        s.request.mesh.method = &netmesh_method_netmesh;
        const std::size_t count = dim < 4 ? 6 : dim == 4 ? 4 : 3;
        REQUIRE(s.mesh(inputs::geometric(dim, 40, count)) == NETMESH_OK);
        CHECK(s.check() == NETMESH_OK);
        const Arrays mesh(s);
        REQUIRE(!mesh.cages.empty());
        s.request.mesh.tau = 2.0001;
        CHECK(s.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
        s.request.mesh.tau = 0;
        REQUIRE(mesh.load(s) == NETMESH_OK);
        CHECK(mesh.load_cages(s) == NETMESH_OK);
        CHECK(s.check() == NETMESH_OK);
        int failed = 0;
        for (const double factor : {0.01, 0.7, 3.0, 1e4})
            for (std::size_t d = 0; d < mesh.cages.size(); ++d) {
                Arrays other = mesh;
                other.cages[d].radius *= factor;
                const netmesh_status status = other.load_cages(s);
                CHECK((status == NETMESH_OK || status == NETMESH_CHECK_FAILED));
                if (status == NETMESH_OK)
                    failed += s.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED;
                else
                    ++failed;
                std::vector<double> ratios(mesh.markers.size());
                std::vector<std::uint32_t> domains(mesh.markers.size());
                CHECK(netmesh_measure_cells(s.context, ratios.data(), domains.data()) == NETMESH_OK);
            }
        CHECK(failed > 0);
        REQUIRE(mesh.load_cages(s) == NETMESH_OK);
        Arrays moved = mesh;
        for (netmesh_cage& cage : moved.cages) cage.centre = s.report().mesh.inputs;  // no input
        CHECK(moved.load_cages(s) == NETMESH_CHECK_FAILED);
    }
}

TEST_CASE("filters, values and bounds") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Meshed s(dim);
        for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS})
            for (const netmesh_filter* const filter :
                 {&netmesh_filter_complete, &netmesh_filter_basic, &netmesh_filter_tight, &netmesh_filter_knn,
                  &netmesh_filter_kdistance})
                for (const std::uint32_t k : {0u, 2u, 3u}) {
                    const bool counts = filter == &netmesh_filter_knn || filter == &netmesh_filter_kdistance;
                    if (!counts && k > 0) continue;
                    netmesh::Request request = persist_by(filter, k, values);
                    request.max_degree = k == 2 ? 1 : 9;
                    request.keep_zero_pairs = k == 3 ? 1 : 0;
                    REQUIRE(s.persist(request) == NETMESH_OK);
                    CHECK(s.report().diagram.essential[0] == 1);
                    const std::uint64_t before = s.report().fingerprint;
                    CHECK(s.represent() == NETMESH_OK);
                    CHECK(s.report().fingerprint == before);
                    if (filter == &netmesh_filter_basic) continue;
                    REQUIRE(s.bound_bars() == NETMESH_OK);
                    const std::vector<netmesh_pair> pairs = s.pairs();
                    for (std::uint64_t i = 0; i < pairs.size(); ++i) {
                        auto b = netmesh::sized<netmesh_bar_bounds>();
                        REQUIRE(netmesh_get_bar_bounds(s.context, i, &b) == NETMESH_OK);
                        CHECK(b.birth_low <= pairs[i].birth);
                        CHECK(b.birth_high >= pairs[i].birth);
                    }
                }
        if (dim > 4) continue;
        for (const netmesh_filter* const filter : {&netmesh_filter_knn, &netmesh_filter_kdistance})
            for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
                netmesh::Request request(filter);
                request.k_last = 3;
                request.values = values;
                request.max_degree = 2;
                REQUIRE(s.vineyard(request) == NETMESH_OK);
                CHECK(s.report().vineyard.vines > 0);
            }
        CHECK(s.report().diagram.present == 0);
        CHECK(s.bound_bars() == NETMESH_OK);  // of the last diagram, which is made again
        CHECK(s.report().diagram.present + s.report().bounds.present == 2);
        CHECK(s.report().vineyard.present == 0);
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
    for (const int dim : dimensions())
        for (int kind = 0; kind <= 5; ++kind)
            for (const double cut : {0.0, 0.5, 3.0, 20.0})
                for (const double factor : {0.0, 8.0}) {
                    if (dim > 4 && (cut != 0.5 || kind == 1)) continue;
                    CAPTURE(dim);
                    CAPTURE(kind);
                    Session s(dim);
                    s.reserve(std::size_t{1} << 23);
                    REQUIRE(s.mesh(inputs::uniform(dim, dim < 4 ? 4 : 2), &netmesh_filter_complete) == NETMESH_OK);
                    Shape user = {kind, 0};
                    const netmesh_function f = {sizeof f, shape, &user, kind == 1 ? 0 : 1.5, factor, cut};
                    netmesh::Request request(&netmesh_filter_function);
                    request.values = cut == 3 ? NETMESH_VALUES_THESIS : NETMESH_VALUES_CERTIFIED;
                    request.keep_zero_pairs = 1;
                    const netmesh_status status = s.persist(f, request);
                    if (kind == 3) {
                        CHECK(status == NETMESH_NOT_FINITE);
                        CHECK(s.detail().index_a == 4);
                        CHECK(s.report().mesh.cells > 0);
                    } else if (factor == 0) {
                        CHECK(status == NETMESH_OK);
                    } else {  // the promise of a factor is false at inputs' neighbours for some shapes
                        CHECK((status == NETMESH_OK || status == NETMESH_INTERNAL));
                    }
                    if (status != NETMESH_OK) continue;
                    if (kind == 2) {  // another function at a second look
                        const netmesh_status again = s.bound_bars(f);
                        CHECK((again == NETMESH_OK || s.detail().field == NETMESH_FIELD_FUNCTION));
                        CHECK(s.report().diagram.present == 1);
                    }
                    user.calls = 0;
                    CHECK(s.bound_bars(f) == NETMESH_OK);
                }
}

TEST_CASE("places that are nearly the same") {
    for (const int dim : dimensions()) {
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
        CHECK(s.report().mesh.vertices == d + 9);
        CHECK(s.check(7) == NETMESH_OK);
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
        CHECK(s.report().mesh.inputs == 1);
        for (const netmesh_method* const method : {&netmesh_method_netmesh, &netmesh_method_refine}) {
            if (dim > 3 && method == &netmesh_method_refine) continue;  // large meshes
            s.request.mesh.method = method;
            CHECK(s.mesh(inputs::Points(5 * d, 0.5)) == NETMESH_OK);
            CHECK(s.check() == NETMESH_OK);
        }
    }
}
