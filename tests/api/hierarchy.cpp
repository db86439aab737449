// Hierarchical meshes through the C interface: cages read, carried, loaded and checked.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "common/arrays.hpp"

namespace {

// A mesh's arrays, its cages too.
struct Copied : Arrays {
    explicit Copied(const Session& session) : Arrays(session) {}
    netmesh_status load(Session& session) const {
        const netmesh_status status = Arrays::load(session);
        return status != NETMESH_OK ? status
                                    : netmesh_load_cages(session.context, cages.data(), cages.size(), &session.options);
    }
};

}  // namespace

TEST_CASE("a hierarchical mesh is read, loaded elsewhere and found good there") {
    for (const int dim : {2, 3, 4}) {
        Session session(dim);
        session.options.tau = 3;
        session.options.method = NETMESH_METHOD_NETMESH;
        REQUIRE(session.mesh(inputs::nested(dim, 5, 6, 1e3)) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        const netmesh_report report = session.report();
        CHECK(report.method == NETMESH_METHOD_NETMESH);
        CHECK(report.cages >= 4);
        CHECK(report.cages_made >= report.cages);
        CHECK(report.touches > report.inputs);
        CHECK(report.aspect_ratio_max <= 3);
        const Copied copied(session);
        CHECK(copied.cages.size() == report.cages);
        for (const netmesh_cage& cage : copied.cages) {
            CHECK(cage.centre < report.inputs);
            if (cage.parent != NETMESH_NONE) CHECK(copied.cages[cage.parent].radius > 4 * cage.radius);
        }
        Session other(dim);
        other.options.tau = 3;
        other.reserve(std::size_t(1) << 22);
        REQUIRE(copied.load(other) == NETMESH_OK);
        CHECK(other.check() == NETMESH_OK);
        CHECK(other.report().cages == report.cages);
        CHECK(other.report().aspect_ratio_max == doctest::Approx(report.aspect_ratio_max).epsilon(1e-9));
        netmesh_cage cage;
        REQUIRE(netmesh_get_cage(other.context, 1, &cage) == NETMESH_OK);
        CHECK(cage.parent == copied.cages[1].parent);
        CHECK(netmesh_get_cage(other.context, report.cages, &cage) == NETMESH_INVALID_ARGUMENT);
    }
}

TEST_CASE("planted violations of a hierarchy fail the check") {
    Session session(2), other(2);
    session.options.tau = other.options.tau = 3;
    session.options.method = NETMESH_METHOD_NETMESH;
    REQUIRE(session.mesh(inputs::geometric(2, 1e3, 12)) == NETMESH_OK);
    Copied copied(session);
    REQUIRE(copied.cages.size() == 11);
    other.reserve(std::size_t(1) << 22);
    SUBCASE("a cage too many") {
        copied.cages.push_back({copied.cages[3].centre, NETMESH_NONE, 30 * copied.cages[3].radius});
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
        CHECK(other.report().cages == 0);
    }
    SUBCASE("a radius that is no number") {
        copied.cages[5].radius = std::nan("");
        CHECK(copied.load(other) == NETMESH_CHECK_FAILED);
    }
}

TEST_CASE("methods, finishing and what goes with them") {
    const inputs::Points points = inputs::geometric(2, 100, 6);
    Session session(2);
    session.options.method = NETMESH_METHOD_NETMESH;
    CHECK(session.mesh(points, NETMESH_JOB_PERSIST) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(session.mesh(points) == NETMESH_OK);
    CHECK(netmesh_persist(session.context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED, 1, 0, &session.options) ==
          NETMESH_NO_RESULT);
    const std::uint64_t caged = session.report().vertices;
    session.options.finish = 1;
    REQUIRE(session.mesh_and_persist(points) == NETMESH_OK);
    CHECK(session.check() == NETMESH_OK);
    CHECK(session.report().cages == 0);
    CHECK(session.report().cages_made > 0);
    CHECK(session.report().vertices > 10 * caged);
    session.options.method = static_cast<netmesh_method>(3);
    CHECK(session.mesh(points) == NETMESH_INVALID_ARGUMENT);
}

TEST_CASE("audits report what they found, and go with what they are for") {
    const inputs::Points points = inputs::nested(2, 4, 12, 1e3);
    Session session(2);
    session.options.tau = 3;
    REQUIRE(session.mesh(points) == NETMESH_OK);
    CHECK(session.report().audit.what == 0);
    CHECK(session.report().audit.rounds == 0);
    for (const netmesh_method method : {NETMESH_METHOD_SVR, NETMESH_METHOD_NETMESH}) {
        session.options.method = method;
        session.options.audit = NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY;
        REQUIRE(session.mesh(method == NETMESH_METHOD_SVR ? inputs::uniform(2, 30) : points) == NETMESH_OK);
        CHECK(session.check() == NETMESH_OK);
        const netmesh_audit audit = session.report().audit;
        CHECK(audit.what == session.options.audit);
        CHECK(session.report().method == method);
        CHECK((session.report().cages > 0) == (method == NETMESH_METHOD_NETMESH));
        REQUIRE(audit.rounds > 1);
        CHECK(audit.load[0] == session.report().inputs);
        for (int k = 0; k + 1 < NETMESH_ROUNDS_MAX; ++k) CHECK(audit.load[k + 1] <= audit.load[k] / 2);
        CHECK(audit.ply_mean > 1);
        CHECK(audit.touches_mean > 1);
        CHECK(audit.meshes > session.report().inputs);
        CHECK(audit.aspect_ratio_max >= session.report().aspect_ratio_max);
        CHECK(audit.feature_ratio >= audit.steiner_ratio);
    }
    session.options.finish = 1;
    REQUIRE(session.mesh(points) == NETMESH_OK);
    CHECK(session.report().cages == 0);
    CHECK(session.report().audit.rounds > 1);
    CHECK(session.mesh(points, NETMESH_JOB_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.options.audit = 4;
    CHECK(session.mesh(points) == NETMESH_INVALID_ARGUMENT);
    session.options.audit = NETMESH_AUDIT_LOCATION;
    session.options.method = NETMESH_METHOD_REFINE;
    CHECK(session.mesh(points) == NETMESH_INVALID_ARGUMENT);
}

TEST_CASE("bounds on the size are not claimed for a mesh with cages") {
    Session session(2);
    session.options.method = NETMESH_METHOD_NETMESH;
    REQUIRE(session.mesh(inputs::geometric(2, 1e3, 8)) == NETMESH_OK);
    REQUIRE(session.report().cages > 0);
    netmesh_analysis a;
    a.struct_bytes = sizeof a;
    REQUIRE(netmesh_analyse(session.context, NETMESH_ANALYSE_SIZE, 0.5, &session.options, &a) == NETMESH_OK);
    CHECK(a.size_lower == 0);
    CHECK(std::isinf(a.size_upper));
    CHECK(std::isinf(a.feature_ratio_bound));
    CHECK(a.integral_lower[0] > 0);
    session.options.finish = 1;
    REQUIRE(session.mesh(inputs::geometric(2, 1e3, 8)) == NETMESH_OK);
    REQUIRE(netmesh_analyse(session.context, NETMESH_ANALYSE_SIZE, 0.5, &session.options, &a) == NETMESH_OK);
    CHECK(a.size_upper > a.size);
    CHECK(a.size_upper < 1e12);
}

TEST_CASE("cells are measured one by one") {
    Session session(2);
    session.options.method = NETMESH_METHOD_NETMESH;
    REQUIRE(session.mesh(inputs::nested(2, 3, 20, 1e3)) == NETMESH_OK);
    const netmesh_report report = session.report();
    std::vector<double> ratios(report.vertices);
    std::vector<std::uint32_t> domains(report.vertices);
    REQUIRE(netmesh_measure_cells(session.context, ratios.data(), domains.data()) == NETMESH_OK);
    double worst = 0;
    netmesh_vertex vertex;
    for (std::uint64_t v = 0; v < report.vertices; ++v) {
        REQUIRE(netmesh_get_vertex(session.context, v, &vertex) == NETMESH_OK);
        CHECK((vertex.marker == 2) == (ratios[v] == 0));
        CHECK((domains[v] == NETMESH_NONE || domains[v] < report.cages));
        worst = std::max(worst, ratios[v]);
    }
    CHECK(worst > 2);
    CHECK(worst <= report.aspect_ratio_max);
    CHECK(netmesh_measure_cells(session.context, nullptr, domains.data()) == NETMESH_INVALID_ARGUMENT);
}

TEST_CASE("a block with cages works wherever it is copied") {
    alignas(16) static unsigned char first[1 << 16], second[1 << 16];
    netmesh_options options;
    netmesh_options_init(&options, 2);
    options.method = NETMESH_METHOD_NETMESH;
    const inputs::Points points = inputs::geometric(2, 1e3, 10);
    netmesh_context* context;
    REQUIRE(netmesh_init(first, sizeof first, &context) == NETMESH_OK);
    REQUIRE(netmesh_mesh(context, points.data(), points.size() / 2, NETMESH_JOB_MESH, &options) == NETMESH_OK);
    netmesh_cage before, after;
    REQUIRE(netmesh_get_cage(context, 2, &before) == NETMESH_OK);
    std::memcpy(second, first, sizeof first);
    std::memset(first, 0xEE, sizeof first);
    REQUIRE(netmesh_adopt(second, &context) == NETMESH_OK);
    REQUIRE(netmesh_get_cage(context, 2, &after) == NETMESH_OK);
    CHECK(after.centre == before.centre);
    CHECK(after.radius == before.radius);
    CHECK(netmesh_check(context, NETMESH_CHECK_ALL, &options) == NETMESH_OK);
}
