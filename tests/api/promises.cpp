// Promises at their very ends: what is just kept passes, what is just broken does not; and figures of reports by their
// meaning.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

constexpr std::size_t room = std::size_t{1} << 25;

inputs::Points some(int dim) { return inputs::uniform(dim, by_dimension<std::size_t>(dim, {20, 9, 6, 8, 5})); }

std::string said_of_quality(Session& s) {
    const netmesh_status status = s.check(NETMESH_CHECK_QUALITY);
    REQUIRE((status == NETMESH_OK || status == NETMESH_CHECK_FAILED));
    return status == NETMESH_OK ? "" : s.detail().message;
}

}  // namespace

TEST_CASE("ratios asked of a mesh: what it has, and a hundredth less") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        s.reserve(room);
        REQUIRE(s.mesh(some(dim), &netmesh_filter_complete) == NETMESH_OK);
        REQUIRE(s.persist() == NETMESH_OK);
        const double ratio = s.report().diagram.certified_ratio;
        s.request.goal.ratio = ratio * 1.0001;
        CHECK(said_of_quality(s).empty());
        s.request.goal.ratio = ratio * 0.99;
        CHECK(said_of_quality(s) == "the certified ratio is above the one asked for");
        // Cells that lie across a scale matter to it: there are some about half of the domain's radius, and they are
        // not as thin as that.
        const double middle = 0.5 * s.report().mesh.domain[dim];
        if (dim > 3) continue;  // the few points of more dimensions need not have such cells
        s.request.goal = {100, 0, 0, 0, 1.001, middle, middle * (1 + 1e-9), 0};
        CHECK(said_of_quality(s) == "a cell's ratio is above the one asked for at its scale");
    }
}

TEST_CASE("sizes asked of a mesh: what it has, and a fiftieth less") {
    for (const int dim : dimensions(2, 4)) {
        CAPTURE(dim);
        Session s(dim);
        s.reserve(std::size_t{1} << 27);
        const double eps = dim == 4 ? 0.8 : 0.4;
        s.request.mesh.sizes.eps = eps;
        REQUIRE(s.mesh(inputs::uniform(dim, 6)) == NETMESH_OK);
        const double reached = eps * s.report().mesh.sizes.ratio_max;
        REQUIRE(reached > 0.5 * eps);
        REQUIRE(reached <= eps * (1 + 1e-12));
        s.request.mesh.sizes.eps = reached * (1 + 1e-6);
        CHECK(said_of_quality(s).empty());
        s.request.mesh.sizes.eps = reached * 0.98;
        CHECK(said_of_quality(s) == "a clipped Voronoi cell is larger than the size asked for");
    }
}

TEST_CASE("aspect ratios asked of a mesh with cages: what it has, and a hundredth less") {
    for (const int dim : dimensions(2, 3)) {
        CAPTURE(dim);
        Session s(dim);
        s.reserve(room);
        s.request.mesh.tau = 3;
        s.request.mesh.method = &netmesh_method_netmesh;
        REQUIRE(s.mesh(inputs::nested(dim, 4, 6, 1e3)) == NETMESH_OK);
        REQUIRE(s.report().mesh.hierarchy.cages > 0);
        const double worst = s.report().mesh.aspect_ratio_max;
        REQUIRE(worst > 2.1);
        s.request.mesh.tau = worst * (1 + 1e-6);
        CHECK(said_of_quality(s).empty());
        s.request.mesh.tau = worst * 0.99;
        CHECK(said_of_quality(s) == "a clipped Voronoi cell has an aspect ratio above tau");
    }
}

// By definition 4.5 the cells of cages in the domains around them are held to tau like those of vertices. In some
// meshes such a cell is the worst.
TEST_CASE("aspect ratios asked of cages") {
    int of_cages = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        Session s(2);
        s.request.mesh.tau = 3;
        s.request.seed = seed;
        s.request.mesh.method = &netmesh_method_netmesh;
        REQUIRE(s.mesh(inputs::geometric(2, 50 + 20 * static_cast<double>(seed), 6, seed)) == NETMESH_OK);
        const netmesh_report report = s.report();
        std::vector<double> ratios(report.mesh.vertices);
        std::vector<std::uint32_t> domains(report.mesh.vertices);
        REQUIRE(netmesh_measure_cells(s.context, ratios.data(), domains.data()) == NETMESH_OK);
        const double of_vertices = *std::max_element(ratios.begin(), ratios.end());
        const double worst = report.mesh.aspect_ratio_max;
        CHECK(of_vertices <= worst);
        if (!(worst > 1.002 * of_vertices) || worst < 2.01) continue;
        ++of_cages;
        s.request.mesh.tau = worst * (1 + 1e-9);
        CHECK(said_of_quality(s).empty());
        s.request.mesh.tau = std::max(2.005, worst * 0.999);
        CHECK(said_of_quality(s) == "a clipped Voronoi cell has an aspect ratio above tau");
    }
    CHECK(of_cages > 0);
}

TEST_CASE("one cage is enough for filters to be refused") {
    Session s(2);
    s.request.mesh.method = &netmesh_method_netmesh;
    REQUIRE(s.mesh(inputs::geometric(2, 1e3, 2)) == NETMESH_OK);
    REQUIRE(s.report().mesh.hierarchy.cages == 1);
    CHECK(s.persist() == NETMESH_NO_RESULT);
    CHECK(s.detail().message == std::string("this filter needs a mesh without cages"));
    CHECK(s.vineyard(&netmesh_filter_knn, 1, 2) == NETMESH_NO_RESULT);
}

// The centre is moved so that one input alone, the first, is farthest from it: values are cut at its distance.
TEST_CASE("the ball of the certificates of a loaded mesh holds every input, the first as the last") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const std::size_t d = static_cast<std::size_t>(dim);
        Session made(dim);
        made.reserve(room);
        inputs::Points points = some(dim);
        std::fill_n(points.begin(), d, -0.5);  // away from the others
        REQUIRE(made.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
        REQUIRE(made.persist() == NETMESH_OK);
        const std::vector<netmesh_pair> pairs = made.pairs();
        Arrays mesh(made);
        const std::size_t inputs = made.report().mesh.inputs;
        Session same(dim);
        same.reserve(room);
        REQUIRE(mesh.load(same) == NETMESH_OK);
        REQUIRE(same.persist() == NETMESH_OK);
        REQUIRE(same.pairs().size() == pairs.size());  // nearest inputs of all vertices are found again
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            CHECK(same.pairs()[i].birth == doctest::Approx(pairs[i].birth).epsilon(1e-9));
            if (!std::isinf(pairs[i].death))
                CHECK(same.pairs()[i].death == doctest::Approx(pairs[i].death).epsilon(1e-9));
        }
        for (std::size_t k = 0; k < d; ++k) mesh.domain[k] += 2 * (mesh.domain[k] - mesh.vertices[k]);
        mesh.domain[d] *= 3;
        double farthest = 0;
        for (std::size_t v = 0; v < inputs; ++v) {
            double d2 = 0;
            for (std::size_t k = 0; k < d; ++k)
                d2 += (mesh.vertices[v * d + k] - mesh.domain[k]) * (mesh.vertices[v * d + k] - mesh.domain[k]);
            CHECK((v == 0 || std::sqrt(d2) < farthest));
            farthest = std::max(farthest, std::sqrt(d2));
        }
        Session moved(dim);
        moved.reserve(room);
        REQUIRE(mesh.load(moved) == NETMESH_OK);
        REQUIRE(moved.persist(persist_by(&netmesh_filter_complete, 0, NETMESH_VALUES_THESIS)) == NETMESH_OK);
        double most = 0;
        for (const netmesh_vertex& v : moved.vertices()) most = std::max(most, v.value);
        CHECK(most == doctest::Approx(farthest).epsilon(1e-9));
    }
}

TEST_CASE("inputs come before all other vertices of a loaded mesh, wherever one of them stands") {
    Session made(2);
    REQUIRE(made.mesh(some(2)) == NETMESH_OK);
    const Arrays mesh(made);
    const std::size_t inputs = made.report().mesh.inputs;
    Session s(2);
    s.reserve(room);
    for (const std::size_t at : {inputs + 1, mesh.markers.size() - 1}) {
        Arrays wrong = mesh;
        wrong.markers[at] = 0;
        CHECK(wrong.load(s) == NETMESH_INVALID_ARGUMENT);
        CHECK(s.detail().field == NETMESH_FIELD_MARKERS);
    }
    Arrays wrong = mesh;
    wrong.markers[inputs / 2] = 1;
    CHECK(wrong.load(s) == NETMESH_INVALID_ARGUMENT);
    CHECK(mesh.load(s) == NETMESH_OK);
}

TEST_CASE("an order that names an input twice is no order") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        REQUIRE(s.delaunay(inputs::uniform(dim, 9)) == NETMESH_OK);
        std::vector<std::uint32_t> order = {4, 2, 0, 1, 3, 8, 7, 6, 5};
        std::vector<double> theta(9);
        CHECK(netmesh_pace(s.context, order.data(), theta.data()) == NETMESH_OK);
        for (std::size_t i = 1; i < 9; ++i) {
            std::vector<std::uint32_t> twice = order;
            twice[i] = order[i - 1];
            CHECK(netmesh_pace(s.context, twice.data(), theta.data()) == NETMESH_INVALID_ARGUMENT);
            CHECK(s.detail().field == NETMESH_FIELD_ORDER);
        }
        order[8] = 9;
        CHECK(netmesh_pace(s.context, order.data(), theta.data()) == NETMESH_INVALID_ARGUMENT);
    }
}

// The lower bound counts vertices that quality asks for, and a mesh by its certificate promises none.
TEST_CASE("bounds on the size are not claimed for a mesh by the certificate") {
    Session s(2);
    s.request.goal.ratio = 3;
    REQUIRE(s.mesh(some(2), &netmesh_filter_complete) == NETMESH_OK);
    netmesh_analysis a;
    REQUIRE(s.analyse(&a, NETMESH_ANALYSE_SIZE, 0.5) == NETMESH_OK);
    CHECK(a.size.lower == 0);
    CHECK(std::isinf(a.size.upper));
    CHECK(std::isinf(a.size.feature_ratio_bound));
    s.request.goal.ratio = 0;
    REQUIRE(s.mesh(some(2), &netmesh_filter_complete) == NETMESH_OK);
    REQUIRE(s.analyse(&a, NETMESH_ANALYSE_SIZE, 0.5) == NETMESH_OK);
    CHECK(a.size.lower > 0);
    CHECK(a.size.upper > static_cast<double>(a.size.vertices));
}

TEST_CASE("cycles made again and again take the same memory") {
    for (const bool on_mesh : {true, false}) {
        Session s(2);
        s.reserve(room);
        const inputs::Points points = inputs::uniform(2, 40);
        REQUIRE((on_mesh ? s.mesh(points, &netmesh_filter_complete) : s.delaunay(points)) == NETMESH_OK);
        std::uint64_t used[2] = {};
        for (int turn = 0; turn < 4; ++turn) {
            REQUIRE(s.persist(on_mesh ? &netmesh_filter_complete : &netmesh_filter_alpha) == NETMESH_OK);
            const std::uint64_t diagram = s.report().memory.used_bytes;
            REQUIRE(s.represent() == NETMESH_OK);
            const std::uint64_t cycles = s.report().memory.used_bytes;
            CHECK(cycles > diagram);
            if (turn > 0) {
                CHECK(diagram == used[0]);
                CHECK(cycles == used[1]);
            }
            used[0] = diagram;
            used[1] = cycles;
        }
    }
}

// The points alone take dim doubles each: whoever gives the bytes that are said to be wanted gets there in few steps.
TEST_CASE("what is said to be wanted leads to a block that is large enough") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const inputs::Points points = inputs::uniform(dim, by_dimension<std::size_t>(dim, {20000, 4000, 600, 100, 40}));
        Session s(dim);
        std::size_t bytes = 8192;
        int turns = 0;
        for (;; ++turns) {
            s.reserve(bytes);
            const netmesh_status status = s.delaunay_in_block(points);
            if (status == NETMESH_OK) break;
            REQUIRE(status == NETMESH_OUT_OF_MEMORY);
            REQUIRE(turns < 100);
            const std::size_t wanted = s.detail().bytes_wanted;
            CHECK(wanted > bytes);
            if (turns == 0) CHECK(wanted >= points.size() * sizeof(double));
            bytes = wanted + wanted / 4;
        }
        CHECK(turns > 0);
        CHECK(turns < 30);
    }
}

TEST_CASE("k and the degree of barycentric complexes: thirty in all") {
    Session s(2);
    const inputs::Points points = some(2);
    const auto field = [&](std::uint32_t k, std::uint32_t degree) {
        const netmesh::Request r = s.points_request(points, &netmesh_filter_barycentric_rips, k, degree);
        CHECK((netmesh_plan(&r) > 0) == (k + degree <= 30));
        return netmesh_persist(s.context, &r) == NETMESH_INVALID_ARGUMENT ? s.detail().field : NETMESH_FIELD_NONE;
    };
    CHECK(field(30, 1) == NETMESH_FIELD_MAX_DEGREE);
    CHECK(field(16, 15) == NETMESH_FIELD_MAX_DEGREE);
    CHECK(field(1, 30) == NETMESH_FIELD_MAX_DEGREE);
    CHECK(field(30, 0) == NETMESH_FIELD_K);  // there are not as many points
}

TEST_CASE("vertices of simplices are read as far as there are some") {
    const std::uint32_t vertices[] = {0, 1, 0, 1};
    const std::uint64_t starts[] = {0, 1, 2, 4};
    const double entries[] = {0, 0, 1};
    Session s(2);
    auto given = netmesh::sized<netmesh_simplices>();
    given.vertices = vertices;
    given.starts = starts;
    given.entries = entries;
    given.simplex_count = 3;
    netmesh::Request r(&netmesh_filter_simplices);
    r.simplices = &given;
    for (const std::uint64_t count : {0u, 4u, 5u}) {
        given.vertex_count = count;
        CHECK(netmesh_persist(s.context, &r) == NETMESH_OK);
    }
    for (const std::uint64_t count : {1u, 2u, 3u}) {
        given.vertex_count = count;
        CHECK(netmesh_persist(s.context, &r) == NETMESH_INVALID_ARGUMENT);
        CHECK(s.detail().field == NETMESH_FIELD_VERTEX_COUNT);
    }
}

TEST_CASE("a report counts what can be read item by item") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        s.reserve(room);
        if (dim == 6) s.request.mesh.tau = 2.2;
        REQUIRE(s.mesh_and_persist(some(dim)) == NETMESH_OK);
        const netmesh_report r = s.report();
        std::uint64_t of[3] = {};
        for (const netmesh_vertex& v : s.vertices()) ++of[v.marker];
        CHECK(r.mesh.inputs == of[0]);
        CHECK(r.mesh.steiner == of[1]);
        CHECK(r.mesh.exempt == of[2]);
        CHECK(of[1] != of[2]);
        const std::vector<netmesh_pair> pairs = s.pairs();
        std::uint64_t all = 0;
        for (std::uint32_t k = 0; k <= r.diagram.max_degree; ++k) {
            std::uint64_t listed = 0, essential = 0;
            for (const netmesh_pair& p : pairs) {
                listed += p.degree == k;
                essential += p.degree == k && std::isinf(p.death);
            }
            CHECK(r.diagram.pairs[k] == listed);
            CHECK(r.diagram.essential[k] == essential);
            all += listed;
        }
        CHECK(all == pairs.size());
        CHECK(r.diagram.essential[0] == 1);
        auto pair = netmesh::sized<netmesh_pair>();
        CHECK(netmesh_get_pair(s.context, all, &pair) == NETMESH_INVALID_ARGUMENT);
    }
}

TEST_CASE("a fit is never coarser than the ratio that is asked for") {
    const inputs::Points points = inputs::uniform(2, 30);
    int fitted = 0, refused = 0;
    for (std::size_t bytes = 20000; bytes < 1000000; bytes += bytes / 4) {
        Session s(2);
        s.reserve(bytes);
        s.request.goal.ratio = 1.8;
        const netmesh_status status = s.fit(points);
        ++(status == NETMESH_OK ? fitted : refused);
        if (status != NETMESH_OK) {
            CHECK(status == NETMESH_OUT_OF_MEMORY);
            continue;
        }
        CHECK(s.report().mesh.goal.ratio <= 1.8);
        CHECK(s.report().diagram.certified_ratio <= 1.8);
    }
    CHECK(fitted > 2);
    CHECK(refused > 2);
}

TEST_CASE("duplicates among points of complexes are counted") {
    for (const int dim : dimensions()) {
        const inputs::Points once = inputs::uniform(dim, 5), thrice = inputs::repeated(dim, once, 3);
        Session s(dim);
        REQUIRE(s.persist_until_it_fits(s.points_request(thrice, &netmesh_filter_rips)) == NETMESH_OK);
        CHECK(s.report().input.points == 15);
        CHECK(s.report().input.distinct == 5);
        CHECK(s.report().input.duplicates == 10);
        REQUIRE(s.persist_until_it_fits(s.points_request(once, &netmesh_filter_cech)) == NETMESH_OK);
        CHECK(s.report().input.duplicates == 0);
    }
}
