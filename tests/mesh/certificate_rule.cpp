// Refinement by the certificate: the ratio asked for is reached, by independent recomputation, on every kind of input.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "common/dimensions.hpp"
#include "common/meshed.hpp"
#include "common/session.hpp"

namespace {

// Meshes by the certificate, filters, checks. The diagram must claim the ratio asked for.
void check_ratio(Session& session, const inputs::Points& points) {
    session.checks = true;
    REQUIRE(session.mesh_and_persist(points) == NETMESH_OK);
    CAPTURE(std::string(session.detail().message));
    CHECK(session.checked == NETMESH_OK);
    const netmesh_report report = session.report();
    CHECK(report.complete == 1);
    CHECK(report.mesh.goal.ratio == session.request.goal.ratio);
    CHECK(report.mesh.tau == 0);
    CHECK(report.diagram.certified_ratio <= session.request.goal.ratio);
    CHECK(report.diagram.certified_ratio_best <= report.diagram.certified_ratio);
}

}  // namespace

TEST_CASE("certified ratios on all kinds of input") {
    for (const int dim : dimensions()) {
        const std::size_t n = dim == 2 ? 200 : dim == 3 ? 60 : dim == 4 ? 25 : dim == 5 ? 12 : 8;
        for (const double ratio : {2.25, 3.0, 1.95}) {
            if (ratio < 2 && dim > 3) continue;
            CAPTURE(dim);
            CAPTURE(ratio);
            Session session(dim);
            session.request.goal.ratio = ratio;
            check_ratio(session, inputs::uniform(dim, n));
            check_ratio(session, inputs::grid(dim, dim == 2 ? 6 : dim == 3 ? 3 : 2));
            check_ratio(session, inputs::shell(dim, n, 1, 1, 7));
            check_ratio(session, inputs::uniform(dim, 1));
            check_ratio(session, inputs::uniform(dim, 2));
        }
    }
}

// Steiner points could spiral into an input when the ratio is below sqrt 3 (these inputs were found by fuzzing).
TEST_CASE("ratios down to the root of 2") {
    const inputs::Points five = {0, -2, -1, 0, -1, 1, -1, 1, -2, -1};
    const inputs::Points four = {-3, 3, -1, 3.0000000000000004, -3, -3, 1, 1};
    for (const double ratio : {1.75, 1.65, 1.6306723114402859, 1.58, 1.5, 1.42}) {
        CAPTURE(ratio);
        Session session(2);
        session.request.goal.ratio = ratio;
        for (const inputs::Points& points : {five, four, inputs::uniform(2, 3)}) {
            check_ratio(session, points);
            CHECK(session.report().mesh.vertices < (ratio < 1.5 ? 10000 : 200));
        }
    }
    for (const double ratio : {1.7, 1.55}) {
        Session session(3);
        session.request.goal.ratio = ratio;
        check_ratio(session, inputs::uniform(3, 4));
        CHECK(session.report().mesh.vertices < 1000);
    }
}

TEST_CASE("distances and scales that coordinates do not resolve") {
    Session session(2);
    session.request.goal.ratio = 1.5;  // Steiner points come nearer by (2.25 / 2 - 1)
    const auto mesh = [&](double gap) {
        const inputs::Points points = {1, 1, 1 + gap, 1};
        return session.mesh_in_block(points, &netmesh_filter_complete);
    };
    CHECK(mesh(64 * 0x1p-52 * 7.9) == NETMESH_TOO_CLOSE);
    CHECK(mesh(64 * 0x1p-52 * 8.1) == NETMESH_OK);
    session.request.goal.ratio = 2;
    CHECK(mesh(65 * 0x1p-52) == NETMESH_OK);
    CHECK(mesh(63 * 0x1p-52) == NETMESH_TOO_CLOSE);

    session.request.goal.focus_to = 1;
    for (const double focus : {1.25, 1.5}) {
        session.request.goal.focus_ratio = focus;
        const double step = focus == 1.25 ? 0.5625 / 2.5625 : 0.125;
        session.request.goal.focus_from = 1.5 * 64 * 0x1p-52 / step;
        CHECK(mesh(0.25) == NETMESH_OK);
        session.request.goal.focus_from = 0.9 * 64 * 0x1p-52 * 1.25 / step;
        CHECK(mesh(0.25) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == NETMESH_FIELD_FOCUS_FROM);
        CHECK(std::string(session.detail().message).find("focus_from") == 0);
        CHECK(session.report().mesh.vertices == 0);
    }
}

TEST_CASE("clusters of a large spread") {
    Session session(2);
    session.request.goal.ratio = 2.25;
    inputs::Points points;
    for (int i = 0; i < 40; ++i) points.insert(points.end(), {std::ldexp(1.0, -i), 0});
    check_ratio(session, points);
}

TEST_CASE("fewer vertices than a mesh of the aspect ratio that proves as much") {
    for (const int dim : dimensions(2, 4)) {
        Session session(dim);
        const inputs::Points points = inputs::shell(dim, dim == 2 ? 300 : dim == 3 ? 200 : 60, 1, 1, 7);
        session.request.mesh.tau = 3.0625;
        REQUIRE(session.mesh_and_persist(points) == NETMESH_OK);
        const std::uint64_t quality = session.report().mesh.vertices;
        session.request.goal.ratio = 2.25;
        check_ratio(session, points);
        CHECK(session.report().mesh.vertices < quality);
    }
}

TEST_CASE("scales of interest") {
    const inputs::Points points = inputs::shell(3, 100, 1, 1, 7);
    Session session(3);
    session.request.goal.ratio = 2.25;
    check_ratio(session, points);
    const std::uint64_t without = session.report().mesh.vertices;
    session.request.goal.focus_ratio = 1.5;
    session.request.goal.focus_from = 0.4;
    session.request.goal.focus_to = 0.9;
    CHECK(session.check() == NETMESH_CHECK_FAILED);
    check_ratio(session, points);
    CHECK(session.report().mesh.vertices > without);
    CHECK(session.report().mesh.goal.focus_ratio == 1.5);

    session.request.goal.focus_ratio = 1.3;  // more than what the mesh was made for
    CHECK(session.check() == NETMESH_CHECK_FAILED);
    CHECK(std::string(session.detail().message).find("at its scale") != std::string::npos);
    session.request.goal.focus_ratio = 1.5;
    session.request.goal.ratio = 1.9;
    CHECK(session.check() == NETMESH_CHECK_FAILED);
}

TEST_CASE("scales of interest in every dimension: early, late, all and none") {
    struct Window {
        double focus, from, to;
    };
    for (const int dim : dimensions()) {
        const double ratio = 4, focus = dim < 4 ? 1.6 : 2.1;
        const inputs::Points points = inputs::close_pairs(dim, 2, 0.02, 2);
        Session session(dim);
        session.request.goal.ratio = ratio;
        check_ratio(session, points);
        const std::uint64_t without = session.report().mesh.vertices;
        for (const Window& w :
             {Window{focus, 0.02, 0.05}, Window{focus, 0.1, 0.2}, Window{focus, 0.05, 4}, Window{focus, 3, 5}}) {
            if (dim == 6 && w.to != 4) continue;
            CAPTURE(dim);
            CAPTURE(w.focus);
            CAPTURE(w.from);
            session.request.goal.focus_ratio = w.focus;
            session.request.goal.focus_from = w.from;
            session.request.goal.focus_to = w.to;
            check_ratio(session, points);
            if (w.to == 4) CHECK(session.report().mesh.vertices > without);
        }
        session.request.goal.focus_ratio = 0;
    }
}

template <int D> struct Certified : Meshed<D> {
    Certified(const inputs::Points& points, const netmesh::RatioGoal& goal)
        : Meshed<D>(points, by_certificate(goal), std::size_t{1} << 23) {}
};

TEST_CASE_TEMPLATE_DEFINE(
    "goals that change nothing, that are beyond what coordinates resolve, and below the root of 2", T, goals) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::close_pairs(D, 2, 0.02, 2);
    const Certified<D> plain(points, {4, 0, 0, 0});
    REQUIRE(plain.status == netmesh::Status::ok);
    for (const double focus : {4.0, 8.0}) {  // no better than everywhere
        const Certified<D> same(points, {4, focus, 0.2, 4});
        CHECK(same.status == netmesh::Status::ok);
        CHECK(same.state.vertex_count == plain.state.vertex_count);
    }
    CHECK(Certified<D>(points, {4, 2, 1e-15, 4}).status == netmesh::Status::invalid_argument);
    CHECK(Certified<D>(points, {4, 1.3, 1e-15, 4}).status == netmesh::Status::invalid_argument);
    CHECK(Certified<D>(points, {4, 2, 1e4, 2e4}).status == netmesh::Status::ok);  // beyond all cells
    inputs::Points two(2 * D, 1.0);
    two[2 * D - 1] += 64 * 0x1p-52 * 7;
    CHECK(Certified<D>(two, {1.5, 0, 0, 0}).status == netmesh::Status::too_close);
    CHECK(Certified<D>(two, {4, 0, 0, 0}).status == netmesh::Status::ok);
    // Large scales alone are refined, and those about the inputs left as they are.
    const Certified<D> late(points,
                            {4, D < 5 ? 1.35 : 1.7, 0.9 * plain.result.domain.radius, plain.result.domain.radius});
    REQUIRE((late.status == netmesh::Status::ok || (D > 3 && late.status == netmesh::Status::out_of_memory)));
    CHECK(late.state.vertex_count >= plain.state.vertex_count);
}
TEST_CASE_TEMPLATE_APPLY(goals, Dimensions<>);

TEST_CASE("a mesh that promises less fails the check") {
    Session session(2);
    session.request.goal.ratio = 3;
    const inputs::Points points = inputs::uniform(2, 200);
    check_ratio(session, points);
    REQUIRE(session.report().diagram.certified_ratio > 2.5);
    session.request.goal.ratio = 2.5;
    CHECK(session.check() == NETMESH_CHECK_FAILED);
}
