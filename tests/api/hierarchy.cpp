// Hierarchical meshes through the C interface: cages read, carried, loaded and checked.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

// A mesh's arrays, its cages too.
struct Copied : Arrays {
    using Arrays::Arrays;
    netmesh_status load(Session& session) const {
        const netmesh_status status = Arrays::load(session);
        return status == NETMESH_OK ? load_cages(session) : status;
    }
};

}  // namespace

TEST_CASE("a hierarchical mesh is read, loaded elsewhere and found good there") {
    for (const int dim : dimensions({2, 3, 4})) {
        Session session(dim);
        session.request.mesh.tau = 3;
        session.request.mesh.method = &netmesh_method_netmesh;
        REQUIRE(session.mesh(inputs::nested(dim, 5, 6, 1e3)) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        const netmesh_report report = session.report();
        CHECK(report.mesh.method == NETMESH_METHOD_NETMESH);
        CHECK(report.mesh.hierarchy.cages >= 4);
        CHECK(report.mesh.hierarchy.cages_made >= report.mesh.hierarchy.cages);
        CHECK(report.mesh.touches > report.mesh.inputs);
        CHECK(report.mesh.aspect_ratio_max <= 3);
        const Copied copied(session);
        CHECK(copied.cages.size() == report.mesh.hierarchy.cages);
        for (const netmesh_cage& cage : copied.cages) {
            CHECK(cage.centre < report.mesh.inputs);
            if (cage.parent != NETMESH_NONE) CHECK(copied.cages[cage.parent].radius > 4 * cage.radius);
        }
        Session other(dim);
        other.request.mesh.tau = 3;
        other.reserve(std::size_t(1) << 22);
        REQUIRE(copied.load(other) == NETMESH_OK);
        CHECK(other.check() == NETMESH_OK);
        CHECK(other.report().mesh.hierarchy.cages == report.mesh.hierarchy.cages);
        CHECK(other.report().mesh.aspect_ratio_max == doctest::Approx(report.mesh.aspect_ratio_max).epsilon(1e-9));
        auto cage = netmesh::sized<netmesh_cage>();
        REQUIRE(netmesh_get_cage(other.context, 1, &cage) == NETMESH_OK);
        CHECK(cage.parent == copied.cages[1].parent);
        CHECK(netmesh_get_cage(other.context, report.mesh.hierarchy.cages, &cage) == NETMESH_INVALID_ARGUMENT);
    }
}

TEST_CASE("planted violations of a hierarchy fail the check") {
    Session session(2), other(2);
    session.request.mesh.tau = other.request.mesh.tau = 3;
    session.request.mesh.method = &netmesh_method_netmesh;
    REQUIRE(session.mesh(inputs::geometric(2, 1e3, 12)) == NETMESH_OK);
    Copied copied(session);
    REQUIRE(copied.cages.size() == 11);
    other.reserve(std::size_t(1) << 22);
    SUBCASE("a cage too many") {
        netmesh_cage more = copied.cages[3];
        more.parent = NETMESH_NONE;
        more.radius *= 30;
        copied.cages.push_back(more);
        REQUIRE(copied.load(other) == NETMESH_OK);
        CHECK(other.check() == NETMESH_CHECK_FAILED);
    }
    SUBCASE("a cage missing") {
        copied.cages.pop_back();
        REQUIRE(copied.load(other) == NETMESH_OK);
        CHECK(other.check() == NETMESH_CHECK_FAILED);
    }
    SUBCASE("an input moved towards a shell") {
        netmesh_cage& cage = copied.cages[5];
        cage.radius *= 0.8;
        REQUIRE(copied.load(other) == NETMESH_OK);
        CHECK(other.check() == NETMESH_CHECK_FAILED);
    }
    SUBCASE("a centre that is no input") {
        copied.cages[5].centre = static_cast<std::uint32_t>(copied.markers.size() - 1);
        CHECK(copied.load(other) == NETMESH_CHECK_FAILED);
        CHECK(other.report().mesh.hierarchy.cages == 0);
    }
    SUBCASE("a radius that is no number") {
        copied.cages[5].radius = std::nan("");
        CHECK(copied.load(other) == NETMESH_CHECK_FAILED);
    }
}

TEST_CASE("cages of the thesis are loaded elsewhere and found good there, and no other kind of cages is") {
    for (const int dim : dimensions({2, 3, 4})) {
        Session session(dim), other(dim);
        session.request.mesh.tau = other.request.mesh.tau = 6;
        session.request.mesh.method = other.request.mesh.method = &netmesh_method_thesis;
        REQUIRE(session.mesh(inputs::close_pairs(dim, dim == 4 ? 2 : 4, 1e-4)) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        const netmesh_report report = session.report();
        CHECK(report.mesh.aspect_ratio_max <= 6);
        Copied copied(session);
        CHECK(copied.cages.size() == (dim == 4 ? 3 : 5));
        other.reserve(std::size_t(1) << 23);
        REQUIRE(copied.load(other) == NETMESH_OK);
        CHECK(other.check() == NETMESH_OK);
        CHECK(other.report().mesh.aspect_ratio_max == doctest::Approx(report.mesh.aspect_ratio_max).epsilon(1e-9));
        const auto complaint = [&](const Copied& bad) {
            REQUIRE(bad.load(other) == NETMESH_OK);
            CHECK(other.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);
            return std::string(other.detail().message);
        };
        Copied bad = copied;
        const std::size_t cage = copied.cages[0].parent == NETMESH_NONE ? 1 : 0;
        bad.cages[cage].radius *= 1.3;
        CHECK(complaint(bad) == "an exempt vertex within a cage is not of its shell");
        bad = copied;
        const double* const centre = &copied.vertices[copied.cages[cage].centre * dim];
        std::size_t shell = 0;  // a vertex of that cage
        const auto offset = [&](std::size_t v, int k) { return copied.vertices[v * dim + k] - centre[k]; };
        const auto is_far = [&](std::size_t v) {
            double sum = 0;
            for (int k = 0; k < dim; ++k) sum += offset(v, k) * offset(v, k);
            return copied.markers[v] != 2 || std::sqrt(sum) > copied.cages[cage].radius;
        };
        while (is_far(shell)) ++shell;
        bad.markers[shell] = 1;
        CHECK(complaint(bad) == "a cage lacks its shell");
        bad = copied;
        for (int k = 0; k < dim; ++k) bad.vertices[shell * dim + k] = centre[k] + 0.9 * offset(shell, k);
        CHECK(complaint(bad) == "a shell has a hole");
        other.request.mesh.method = &netmesh_method_netmesh;
        complaint(copied);
        other.request.mesh.method = &netmesh_method_thesis;
        // In R^4 this mesh is better than any tau that is admitted.
        CHECK((report.mesh.aspect_ratio_max > 3.5) == (dim < 4));
        if (dim == 4) continue;
        other.request.mesh.tau = 3.5;
        CHECK(complaint(copied) == "a Voronoi cell has an aspect ratio above tau");
    }
}

TEST_CASE("methods, finishing and what goes with them") {
    const inputs::Points points = inputs::geometric(2, 100, 6);
    Session session(2);
    session.request.mesh.method = &netmesh_method_netmesh;
    CHECK(session.mesh(points, &netmesh_filter_complete) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(session.mesh(points) == NETMESH_OK);
    CHECK(session.persist() == NETMESH_NO_RESULT);
    CHECK(session.vineyard(&netmesh_filter_knn, 1, 2) == NETMESH_NO_RESULT);
    CHECK(session.detail().message == std::string("this filter needs a mesh without cages"));
    netmesh::Request by_ratio;
    by_ratio.goal.ratio = 1.5;
    auto check = netmesh::sized<netmesh_check_request>();
    check.promised = &by_ratio;
    CHECK(netmesh_check(session.context, &check) == NETMESH_OK);  // cages have ratios of their own
    const std::uint64_t caged = session.report().mesh.vertices;
    session.request.mesh.finish = 1;
    REQUIRE(session.mesh_and_persist(points) == NETMESH_OK);
    CHECK(session.check() == NETMESH_OK);
    CHECK(session.report().mesh.hierarchy.cages == 0);
    CHECK(session.report().mesh.hierarchy.cages_made > 0);
    CHECK(session.report().mesh.vertices > 10 * caged);
    session.request.mesh.method = &netmesh_method_svr;
    CHECK(session.mesh(points) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_FINISH);
}

TEST_CASE("audits report what they found, and go with what they are for") {
    const inputs::Points points = inputs::nested(2, 4, 12, 1e3);
    Session session(2);
    session.request.mesh.tau = 3;
    REQUIRE(session.mesh(points) == NETMESH_OK);
    CHECK(session.report().mesh.audit.what == 0);
    CHECK(session.report().mesh.audit.rounds == 0);
    for (const netmesh_method* const method : {&netmesh_method_svr, &netmesh_method_netmesh}) {
        const bool is_svr = method == &netmesh_method_svr;
        session.request.mesh.method = method;
        session.request.mesh.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
        REQUIRE(session.mesh(is_svr ? inputs::uniform(2, 30) : points) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        const netmesh_audit_report audit = session.report().mesh.audit;
        CHECK(audit.what == session.request.mesh.audit);
        CHECK(session.report().mesh.method == (is_svr ? NETMESH_METHOD_SVR : NETMESH_METHOD_NETMESH));
        CHECK((session.report().mesh.hierarchy.cages > 0) == !is_svr);
        REQUIRE(audit.rounds > 1);
        CHECK(audit.load[0] == session.report().mesh.inputs);
        for (int k = 0; k + 1 < NETMESH_ROUNDS_MAX; ++k) CHECK(audit.load[k + 1] <= audit.load[k] / 2);
        CHECK(audit.ply_mean > 1);
        CHECK(audit.touches_mean > 1);
        CHECK(audit.meshes > session.report().mesh.inputs);
        CHECK(audit.aspect_ratio_max >= session.report().mesh.aspect_ratio_max);
        CHECK(audit.feature_ratio >= audit.steiner_ratio);
        CHECK(audit.degree_max >= 3);
        CHECK(audit.degree_max < 30);
    }
    session.request.mesh.finish = 1;
    REQUIRE(session.mesh(points) == NETMESH_OK);
    CHECK(session.report().mesh.hierarchy.cages == 0);
    CHECK(session.report().mesh.audit.rounds > 1);
    CHECK(session.mesh(points, &netmesh_filter_complete) == NETMESH_INVALID_ARGUMENT);
    session.request.mesh.audit = 4;
    CHECK(session.mesh(points) == NETMESH_INVALID_ARGUMENT);
    session.request.mesh.method = &netmesh_method_refine;
    session.request.mesh.finish = 0;
    for (const std::uint32_t audit : {NETMESH_AUDIT_LOCATION, NETMESH_AUDIT_QUALITY}) {
        session.request.mesh.audit = audit;
        CHECK(session.mesh(points) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == NETMESH_FIELD_AUDIT);
    }
}

TEST_CASE("an audit of quality is for every filter, and of the mesh that is made without") {
    for (const int dim : {2, 3}) {
        const inputs::Points points = inputs::uniform(dim, dim == 2 ? 60 : 20);
        const auto audited = [&](double ratio, double eps, const netmesh_filter* filter) {
            netmesh_audit_report audit[2];
            std::uint64_t prints[2], vertices = 0;
            for (const std::uint32_t what : {0u, 2u}) {
                Session session(dim);
                session.request.mesh.audit = what;
                session.request.goal.ratio = ratio;
                session.request.mesh.sizes.eps = eps;
                REQUIRE(session.mesh(points, filter) == NETMESH_OK);
                audit[what / 2] = session.report().mesh.audit;
                prints[what / 2] = session.report().fingerprint;
                vertices = session.report().mesh.vertices;
            }
            CHECK(prints[0] == prints[1]);
            CHECK(audit[0].meshes == 0);
            CHECK(audit[0].degree_max == 0);
            CHECK(audit[1].meshes == vertices - 2 * static_cast<std::uint64_t>(dim));
            CHECK(audit[1].aspect_ratio_max > 1);
            CHECK(audit[1].degree_max > static_cast<std::uint64_t>(dim));
            CHECK(audit[1].feature_ratio >= 1);
            return audit[1];
        };
        const netmesh_audit_report plain = audited(0, 0, nullptr);
        const netmesh_audit_report sized = audited(0, 0.5, nullptr);
        CHECK(sized.meshes > 2 * plain.meshes);
        CHECK(sized.feature_ratio == plain.feature_ratio);  // until over-refinement begins
        CHECK(sized.aspect_ratio_max >= plain.aspect_ratio_max);
        audited(0, 0, &netmesh_filter_complete);
        audited(2.2, 0, &netmesh_filter_complete);
        audited(0, 0, &netmesh_filter_tight);
    }
}

TEST_CASE("bounds on the size of a mesh with cages are sums over its domains, and check holds it to them") {
    Session session(2);
    session.request.mesh.method = &netmesh_method_netmesh;
    REQUIRE(session.mesh(inputs::geometric(2, 1e3, 8)) == NETMESH_OK);
    const netmesh_mesh_report mesh = session.report().mesh;
    REQUIRE(mesh.hierarchy.cages > 0);
    netmesh_analysis a;
    REQUIRE(session.analyse(&a, NETMESH_ANALYSE_SIZE, 0.5) == NETMESH_OK);
    CHECK(a.size.domains == mesh.hierarchy.cages + 1);
    CHECK(a.size.vertices == mesh.vertices - 4);  // all but the frame
    CHECK(a.size.lower > 4.0 * static_cast<double>(mesh.hierarchy.cages));
    CHECK(a.size.lower <= static_cast<double>(a.size.vertices));
    CHECK(static_cast<double>(a.size.vertices) <= a.size.upper);
    CHECK(a.size.upper_over_lower == doctest::Approx(a.size.upper / a.size.lower));
    CHECK(std::isinf(a.size.feature_ratio_bound));
    CHECK(a.size.integral_lower[0] > 0);
    netmesh_figure figure = netmesh::sized<netmesh_figure>();
    bool reported = false;
    for (std::uint32_t i = 0; netmesh_get_analysis_figure(&a, i, &figure) == NETMESH_OK; ++i)
        if (std::strcmp(figure.path, "size.upper_over_lower") == 0)
            reported = figure.applies != 0 && *static_cast<const double*>(figure.values) == a.size.upper_over_lower;
    CHECK(reported);
    CHECK(session.check() == NETMESH_OK);
    session.request.mesh.finish = 1;
    REQUIRE(session.mesh(inputs::geometric(2, 1e3, 8)) == NETMESH_OK);
    REQUIRE(session.analyse(&a, NETMESH_ANALYSE_SIZE, 0.5) == NETMESH_OK);
    CHECK(a.size.domains == 1);
    CHECK(a.size.upper > static_cast<double>(a.size.vertices));
    CHECK(a.size.upper < 1e12);
}

TEST_CASE("cells are measured one by one") {
    Session session(2);
    session.request.mesh.method = &netmesh_method_netmesh;
    REQUIRE(session.mesh(inputs::nested(2, 3, 20, 1e3)) == NETMESH_OK);
    const netmesh_report report = session.report();
    std::vector<double> ratios(report.mesh.vertices);
    std::vector<std::uint32_t> domains(report.mesh.vertices);
    REQUIRE(netmesh_measure_cells(session.context, ratios.data(), domains.data()) == NETMESH_OK);
    double worst = 0;
    const std::vector<netmesh_vertex> vertices = session.vertices();
    REQUIRE(vertices.size() == report.mesh.vertices);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const double* const x = vertices[v].coordinates;
        const double* const ball = report.mesh.domain;
        const bool is_beyond = std::hypot(x[0] - ball[0], x[1] - ball[1]) > ball[2];  // of a cage that was released
        if (vertices[v].marker == 2) CHECK(ratios[v] == 0);
        if (ratios[v] == 0) CHECK((vertices[v].marker == 2 || is_beyond));
        CHECK((domains[v] == NETMESH_NONE || domains[v] < report.mesh.hierarchy.cages));
        worst = std::max(worst, ratios[v]);
    }
    CHECK(worst > 2);
    CHECK(worst <= report.mesh.aspect_ratio_max);
    CHECK(netmesh_measure_cells(session.context, nullptr, domains.data()) == NETMESH_INVALID_ARGUMENT);
}

namespace {

double distance(const double* a, const double* b, int dim) {
    double sum = 0;
    for (int k = 0; k < dim; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum);
}

// Lemma 4.6.1 with the test's own weights, in-radii and distances, over all points of the domain around each cage.
void compare_weighted_cells(int dim, const netmesh_method* method, const std::vector<inputs::Points>& sets) {
    CAPTURE(dim);
    const bool is_thesis = method == &netmesh_method_thesis;
    Session session(dim);
    session.request.mesh.method = method;
    if (is_thesis) session.request.mesh.tau = 7;
    std::size_t seen = 0;
    for (const inputs::Points& points : sets) {
        REQUIRE(session.mesh(points) == NETMESH_OK);
        const netmesh_report report = session.report();
        const std::size_t cages = report.mesh.hierarchy.cages;
        CHECK((cages > 0 || dim == 4));  // a few points of R^4 in clusters have none
        if (cages == 0) continue;
        const std::vector<netmesh_vertex> vertices = session.vertices();
        std::vector<double> ratios(vertices.size());
        std::vector<std::uint32_t> domains(vertices.size());
        REQUIRE(netmesh_measure_cells(session.context, ratios.data(), domains.data()) == NETMESH_OK);
        std::vector<netmesh_weighted_cell> cells(cages);
        cells[0] = netmesh::sized<netmesh_weighted_cell>();
        REQUIRE(netmesh_weighted_cells(session.context, cells.data()) == NETMESH_OK);
        std::vector<netmesh_cage> cage(cages, netmesh::sized<netmesh_cage>());
        std::vector<double> weight(cages, 0);
        for (std::size_t d = 0; d < cages; ++d) {
            REQUIRE(netmesh_get_cage(session.context, d, &cage[d]) == NETMESH_OK);
            for (std::size_t v = 0; v < vertices.size(); ++v)
                if (domains[v] == d && vertices[v].marker == 2)
                    weight[d] = std::max(weight[d],
                                         distance(vertices[v].coordinates, vertices[cage[d].centre].coordinates, dim));
        }
        for (std::size_t d = 0; d < cages; ++d) {
            CAPTURE(d);
            double in_radius = HUGE_VAL, feature_size = HUGE_VAL, epsilon = 0;
            const auto offer = [&](const netmesh_vertex& u, double w) {
                const double length = distance(u.coordinates, vertices[cage[d].centre].coordinates, dim);
                in_radius = std::min(in_radius, weight[d] + (length - weight[d] - w) / 2);
                feature_size = std::min(feature_size, length);
                epsilon = std::max({epsilon, weight[d] / (length - w), w / (length - weight[d])});
            };
            for (std::size_t v = 0; v < vertices.size(); ++v)
                if (domains[v] == cage[d].parent && (domains[v] != NETMESH_NONE || vertices[v].marker != 2))
                    offer(vertices[v], 0);
            for (std::size_t e = 0; e < cages; ++e)
                if (e != d && cage[e].parent == cage[d].parent) offer(vertices[cage[e].centre], weight[e]);
            const netmesh_weighted_cell& cell = cells[d];
            CHECK(cell.struct_bytes == sizeof cell);
            CHECK(cell.weight == doctest::Approx(weight[d]).epsilon(1e-12));
            CHECK(cell.cage_out_radius > cell.cage_in_radius);
            if (is_thesis && cage[d].parent == NETMESH_NONE) {  // the outermost one is alone
                CHECK(cell.in_radius == HUGE_VAL);
                CHECK(cell.feature_size == HUGE_VAL);
                CHECK(cell.epsilon == 0);
                continue;
            }
            CHECK(cell.in_radius == doctest::Approx(in_radius).epsilon(1e-12));
            CHECK(cell.feature_size == doctest::Approx(feature_size).epsilon(1e-12));
            CHECK(cell.epsilon == doctest::Approx(epsilon).epsilon(1e-12));
            CHECK(epsilon > 0);
            CHECK(epsilon < 1.0 / 3);
            CHECK(2 * in_radius * (1 - epsilon) / (1 + epsilon) <= feature_size);
            CHECK(feature_size <= 2 * in_radius / (1 - epsilon));
            CHECK(cell.cage_in_radius <= feature_size);
            CHECK(feature_size <= 3 * cell.cage_in_radius);
            CHECK(cell.cage_out_radius <= report.mesh.aspect_ratio_max * cell.cage_in_radius * (1 + 1e-12));
            ++seen;
        }
    }
    CHECK(seen > (is_thesis && dim == 4 ? 1 : 5));
}

}  // namespace

TEST_CASE("weighted cells of cages by all points of their domains") {
    for (const int dim : dimensions(2, 4))
        compare_weighted_cells(
            dim, &netmesh_method_netmesh,
            {inputs::nested(dim, 3, 8, 1e3), inputs::geometric(dim, 30, 8), inputs::clusters(dim, dim == 4 ? 15 : 40)});
}

TEST_CASE("cages of the thesis: their weighted cells by all points") {
    for (const int dim : dimensions(2, 4))
        compare_weighted_cells(dim, &netmesh_method_thesis,
                               dim == 4 ? std::vector<inputs::Points>{inputs::close_pairs(dim, 2, 1e-4)}
                                        : std::vector<inputs::Points>{inputs::nested(dim, 3, 8, 1e3),
                                                                      inputs::geometric(dim, 30, 8),
                                                                      inputs::close_pairs(dim, 6, 1e-4)});
}

TEST_CASE("a block with cages works wherever it is copied") {
    alignas(16) static unsigned char first[1 << 16], second[1 << 16];
    Calls calls(2);
    calls.request.mesh.method = &netmesh_method_netmesh;
    REQUIRE(netmesh_init(first, sizeof first, &calls.context) == NETMESH_OK);
    REQUIRE(calls.mesh_in_block(inputs::geometric(2, 1e3, 10)) == NETMESH_OK);
    auto before = netmesh::sized<netmesh_cage>(), after = before;
    REQUIRE(netmesh_get_cage(calls.context, 2, &before) == NETMESH_OK);
    std::memcpy(second, first, sizeof first);
    std::memset(first, 0xEE, sizeof first);
    REQUIRE(netmesh_adopt(second, &calls.context) == NETMESH_OK);
    REQUIRE(netmesh_get_cage(calls.context, 2, &after) == NETMESH_OK);
    CHECK(after.centre == before.centre);
    CHECK(after.radius == before.radius);
    CHECK(calls.check() == NETMESH_OK);
}
