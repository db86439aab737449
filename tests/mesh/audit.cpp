// Point location in all D-balls, rounds of range nets, and invariants after every insertion (thesis 4.7 to 4.9).
#include <doctest/doctest.h>

#include <algorithm>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "mesh/hierarchy_quality.hpp"
#include "mesh/input_tree.hpp"
#include "mesh/netmesh.hpp"
#include "mesh/opening.hpp"

using namespace netmesh;

namespace {

template <int D> struct Audited {
    Audited(const inputs::Points& points, double tau, bool cages, bool location, bool quality,
            std::size_t bytes = std::size_t{1} << 24)
        : block(bytes), store(block.arena, state) {
        status =
            netmesh::netmesh<D>(store, points.data(), points.size() / D, {tau, 1, false, 1, cages, location, quality},
                                monitor, &input, &domain, &this->cages, &report);
    }
    double worst() {
        HierarchyQuality q;
        REQUIRE(measure_hierarchy<D>(store, cages, report.cages, domain, block.arena, &q) == Status::ok);
        CHECK(q.encroached.violation == nullptr);
        return q.worst;
    }
    Block block;
    StoreState state = {};
    Store<D> store;
    Monitor monitor;
    InputReport input;
    Domain<D> domain = {};
    Cage* cages;
    HierarchyReport report;
    Status status;
};

template <int D> using Dimensions = std::integral_constant<int, D>;

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("inputs stored in all D-balls: loads halve in every round, and the mesh is as good", T,
                          location) {
    constexpr int D = T::value;
    constexpr std::size_t sizes[] = {0, 0, 2000, 200, 30, 8};
    constexpr double taus[] = {0, 0, 2.5, 3, 3, 4};
    const inputs::Points sets[] = {inputs::uniform(D, sizes[D]), inputs::grid(D, D < 4 ? 5 : 2),
                                   inputs::nested(D, 5, sizes[D] / 5, 1e3), inputs::geometric(D, 1e3, 20),
                                   inputs::close_pairs(D, sizes[D] / 4, 1e-12)};
    for (const bool cages : {true, false})
        for (const inputs::Points& points : sets) {
            if (!cages && &points >= sets + 2) break;  // gaps make plain refinement large
            Audited<D> m(points, taus[D], cages, true, false);
            REQUIRE(m.status == Status::ok);  // each input was in exactly the balls that it was stored in
            CHECK(m.worst() <= taus[D]);
            const LocationAudit& audit = m.report.location;
            REQUIRE(audit.rounds > 0);
            CHECK(audit.load[0] == m.input.rows - m.input.duplicates);
            for (std::uint32_t k = 0; k + 1 < audit.rounds; ++k) CHECK(audit.load[k + 1] <= audit.load[k] / 2);
            CHECK(audit.load[audit.rounds - 1] > 0);
            CHECK(audit.nets >= audit.rounds);
            CHECK(audit.ply_max >= audit.ply_mean);
            CHECK(audit.ply_mean >= 1);
            CHECK(audit.touches_max >= audit.touches_mean);
            CHECK(audit.tests_mean >= audit.touches_mean);
        }
}
TEST_CASE_TEMPLATE_INVOKE(location, Dimensions<2>, Dimensions<3>, Dimensions<4>, Dimensions<5>);

TEST_CASE("with cages neither rounds nor touches depend on the spread, without them touches do") {
    double least = infinity, most = 0;
    for (const double ratio : {1e2, 1e6}) {
        Audited<2> m(inputs::nested(2, 5, 20, ratio), 3, true, true, false);
        REQUIRE(m.status == Status::ok);
        least = std::min(least, m.report.location.touches_mean);
        most = std::max(most, m.report.location.touches_mean);
    }
    CHECK(most < 1.2 * least);
    Audited<2> plain(inputs::nested(2, 5, 20, 1e6), 3, false, true, false);
    REQUIRE(plain.status == Status::ok);
    CHECK(plain.report.location.touches_mean > 1.5 * most);
}

TEST_CASE("lists that miss an insertion disagree with the balls") {
    constexpr int D = 2;
    const inputs::Points points = inputs::uniform(D, 200);
    Block block(std::size_t{1} << 20);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    std::uint32_t* order;
    REQUIRE(take_input<D>(store, points.data(), 200, 1, monitor, &input, &order) == Status::ok);
    InputTree<D> tree;
    REQUIRE(tree.build(store, block.arena, 200) == Status::ok);
    BallLists<D> lists;
    CHECK_FALSE(lists.is_open());
    REQUIRE(lists.open(store, block.arena, 200) == Status::ok);
    REQUIRE(store.open_cells() == Status::ok);
    Kernel<D> kernel(store, corner_error_max, true);
    Domain<D> domain;
    smallest_enclosing_ball<D>(store, 200, domain);
    REQUIRE(open_frame<D>(store, kernel, tree, domain, 4 * domain.enclosing_radius) == Status::ok);
    REQUIRE(lists.start(kernel));
    CHECK(lists.load() == 200);
    const auto find = [&](std::uint32_t v) {
        Cavity cavity;
        REQUIRE(kernel.find_cavity(store.point(v), v, kernel.locate(store.point(v), v, state.last_cell), &cavity));
        return cavity;
    };
    std::uint32_t missed = 0;
    for (std::uint32_t v = 0; v < 100; ++v) {
        const Cavity cavity = find(v);
        REQUIRE(lists.agrees(kernel, cavity, v));
        lists.detach(kernel, cavity, v);
        kernel.fill(cavity, v);
        REQUIRE(lists.attach(kernel, cavity, v));
    }
    for (std::uint32_t v = 100; v < 110; ++v) kernel.fill(find(v), v);
    for (std::uint32_t v = 110; v < 200; ++v) missed += !lists.agrees(kernel, find(v), v);
    CHECK(missed > 5);
    CHECK(missed < 90);
}

TEST_CASE("nets reach every ball that is too full, and no ball is drawn from twice for the same inputs") {
    constexpr int D = 3;
    const inputs::Points points = inputs::uniform(D, 500);
    Block block(std::size_t{1} << 22);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    std::uint32_t* order;
    REQUIRE(take_input<D>(store, points.data(), 500, 1, monitor, &input, &order) == Status::ok);
    InputTree<D> tree;
    REQUIRE(tree.build(store, block.arena, 500) == Status::ok);
    BallLists<D> lists;
    REQUIRE(lists.open(store, block.arena, 500) == Status::ok);
    REQUIRE(store.open_cells() == Status::ok);
    Kernel<D> kernel(store, corner_error_max, true);
    Domain<D> domain;
    smallest_enclosing_ball<D>(store, 500, domain);
    REQUIRE(open_frame<D>(store, kernel, tree, domain, 4 * domain.enclosing_radius) == Status::ok);
    REQUIRE(lists.start(kernel));
    std::vector<std::uint32_t> chosen(500);
    // All of the frame's balls hold all inputs.
    CHECK(lists.draw_nets(250, 1, chosen.data()) == 12);
    std::sort(chosen.begin(), chosen.begin() + 12);
    CHECK(std::adjacent_find(chosen.begin(), chosen.begin() + 12) == chosen.begin() + 12);
    CHECK(lists.draw_nets(500, 1, chosen.data()) == 0);
}

TEST_CASE_TEMPLATE_DEFINE("quality, feature sizes and insertion radii are bounded after every insertion", T, quality) {
    constexpr int D = T::value;
    constexpr std::size_t sizes[] = {0, 0, 60, 20, 8};
    for (const inputs::Points& points :
         {inputs::uniform(D, sizes[D]), inputs::nested(D, 4, sizes[D] / 4, 1e3), inputs::geometric(D, 1e3, 10),
          inputs::geometric(D, 5, D == 2 ? 10 : 2), inputs::close_pairs(D, sizes[D] / 4, 1e-12), inputs::grid(D, 2)})
        for (const bool location : {false, true}) {
            Audited<D> m(points, 3, true, location, true);
            REQUIRE(m.status == Status::ok);
            const QualityAudit& audit = m.report.quality;
            CHECK(audit.meshes >= points.size() / D);
            CHECK(audit.meshes <= m.state.vertex_count - 2 * D);
            CHECK(audit.encroached == 0);
            CHECK(audit.worst >= m.worst());
            CHECK(audit.worst < 400);
            CHECK(audit.feature < 6);
            CHECK(audit.feature >= std::max({audit.cage, audit.steiner, audit.input}));
            CHECK(audit.cage <= cage_insertion_bound<D>());
            CHECK((m.report.cages_made > 0) == (audit.cage > 0));
            CHECK(audit.input >= 1);
        }
}
TEST_CASE_TEMPLATE_INVOKE(quality, Dimensions<2>, Dimensions<3>, Dimensions<4>);

TEST_CASE("planted violations of the invariants are found") {
    Audited<3> m(inputs::nested(3, 3, 12, 1e3), 3, true, false, true);
    REQUIRE(m.status == Status::ok);
    REQUIRE(m.report.cages > 0);
    QualityAudit audit = {};
    const Newcomers none_new = {m.state.vertex_count, none, false};
    const auto measure = [&](const Newcomers& fresh) {
        REQUIRE(audit_quality<3>(m.store, m.cages, m.report.cages, m.domain, m.block.arena, fresh, &audit) ==
                Status::ok);
    };
    measure(none_new);
    REQUIRE(audit.encroached == 0);
    REQUIRE(audit.worst <= 3);
    REQUIRE(audit.feature <= m.report.quality.feature);
    std::uint32_t steiner = 0;
    while (m.store.vertex(steiner).marker != Marker::steiner) ++steiner;
    const std::uint32_t shell = m.cages[0].shell;
    REQUIRE(m.store.vertex(shell).marker == Marker::exempt);
    const auto move_to = [&](std::uint32_t v, const double* x, double offset) {
        for (int k = 0; k < 3; ++k) m.store.vertex(v).x[k] = x[k] + offset;
    };
    SUBCASE("a Steiner point too close to an input") {
        move_to(steiner, m.store.point(0), 1e-3);
        measure({m.state.vertex_count, steiner, true});
        CHECK(audit.feature > 20);
        CHECK(audit.steiner > 20);
    }
    SUBCASE("a shell that is not where it belongs") {
        move_to(shell, m.store.point(m.cages[0].centre), 1e-3 * m.cages[0].radius);
        measure({shell, none, false});
        CHECK(audit.cage > cage_insertion_bound<3>());
        CHECK(audit.encroached == 1);
    }
    SUBCASE("a cage without its clearance") {
        m.cages[0].radius *= 1e3;
        measure(none_new);
        CHECK(audit.encroached == 1);
    }
}

TEST_CASE("any arena size leaves a whole mesh of what was inserted, with lists and without") {
    const inputs::Points points = inputs::nested(2, 3, 8, 1e3);
    std::uint32_t partial = 0, whole = 0;
    for (std::size_t bytes = 0; bytes < 120000; bytes += 464) {
        Audited<2> m(points, 2.5, true, true, bytes % 928 == 0, bytes);
        REQUIRE((m.status == Status::ok || m.status == Status::out_of_memory));
        if (m.status == Status::ok) CHECK(m.worst() <= 2.5);
        if (m.state.cell_slots > 0) ++(m.status == Status::ok ? whole : partial);
    }
    CHECK(partial > 20);
    CHECK(whole > 20);
}
