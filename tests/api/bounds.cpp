// Bounds of single bars: what the interface says, and that the exact filter's are the bars themselves.
#include <doctest/doctest.h>

#include <cmath>

#include "common/dimensions.hpp"
#include "common/session.hpp"

TEST_CASE("bounds of bars") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 50);
    auto b = netmesh::sized<netmesh_bar_bounds>();
    CHECK(session.bound_bars() == NETMESH_NO_RESULT);
    CHECK(netmesh_get_bar_bounds(session.context, 0, &b) == NETMESH_INVALID_ARGUMENT);
    auto step = netmesh::sized<netmesh_scale_step>();
    CHECK(netmesh_get_scale_step(session.context, 0, &step) == NETMESH_INVALID_ARGUMENT);

    REQUIRE(session.alpha(points) == NETMESH_OK);
    REQUIRE(session.bound_bars() == NETMESH_OK);
    const std::vector<netmesh_pair> exact = session.pairs();
    for (std::size_t i = 0; i < exact.size(); ++i) {
        REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
        CHECK(b.birth_low == exact[i].birth);
        CHECK(b.birth_high == exact[i].birth);
        CHECK(b.death_low == exact[i].death);
        CHECK(b.death_high == exact[i].death);
        CHECK(b.certain == 1);
    }
    CHECK(netmesh_get_bar_bounds(session.context, exact.size(), &b) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_scale_step(session.context, 0, &step) == NETMESH_INVALID_ARGUMENT);  // 1 at every scale

    // No bar is bounded more widely than the ratio of the whole diagram says.
    for (const netmesh_filter filter : {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_KNN, NETMESH_FILTER_KDISTANCE}) {
        REQUIRE(session.mesh_and_persist(points, persist_by(filter, 4)) == NETMESH_OK);
        const std::uint64_t print = session.report().fingerprint;
        const double c = session.report().diagram.certified_ratio * (1 + 1e-9);
        REQUIRE(session.bound_bars() == NETMESH_OK);
        CHECK(session.report().fingerprint == print);
        const std::vector<netmesh_pair> pairs = session.pairs();
        std::size_t certain = 0, by_ratio = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
            CHECK((b.certain == 1 || pairs[i].death <= b.certain_after));
            certain += b.certain;
            if (b.certain == 1 && pairs[i].death <= b.certain_after) continue;  // by a chain of covers
            CHECK(b.birth_low * c >= pairs[i].birth);
            CHECK(b.birth_high <= c * pairs[i].birth);
            if (std::isfinite(pairs[i].death)) CHECK(b.death_low * c >= pairs[i].death);
            if (std::isfinite(pairs[i].death)) CHECK(b.death_high <= c * pairs[i].death);
            CHECK(b.certain_after <= c * c * pairs[i].birth);
            by_ratio += pairs[i].death > c * c * pairs[i].birth;
        }
        CHECK(certain >= by_ratio);
        CHECK(by_ratio > 0);
    }
}

TEST_CASE("bounds that do not fit leave the diagram") {
    const inputs::Points points = inputs::uniform(2, 30);
    Session roomy(2);
    REQUIRE(roomy.mesh_and_persist(points) == NETMESH_OK);
    const std::uint64_t used = roomy.report().memory.used_bytes, peak = roomy.report().memory.peak_bytes;
    bool refused = false;
    for (std::size_t bytes = used; bytes < peak + 100000 && !refused; bytes += 256) {
        Session session(2);
        session.reserve(bytes);
        netmesh_status status = session.mesh_in_block(points, NETMESH_PURPOSE_PERSIST);
        if (status == NETMESH_OK) status = session.persist();
        if (status != NETMESH_OK) continue;
        const netmesh_status bound = session.bound_bars();
        if (bound == NETMESH_OK) break;
        refused = true;
        CHECK(bound == NETMESH_OUT_OF_MEMORY);
        CHECK(session.report().fingerprint == roomy.report().fingerprint);
    }
    CHECK(refused);
}

TEST_CASE("the basic filter's bounds begin where its ratio does") {
    Session session(2);
    REQUIRE(session.mesh_and_persist(inputs::circle(40), NETMESH_FILTER_BASIC) == NETMESH_OK);
    REQUIRE(session.bound_bars() == NETMESH_OK);
    const double from = session.report().diagram.certified_from;
    const std::vector<netmesh_pair> pairs = session.pairs();
    std::size_t born_at_zero = 0, certain = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        auto b = netmesh::sized<netmesh_bar_bounds>();
        REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
        CHECK(b.birth_high >= from * (1 - 1e-9));
        born_at_zero += pairs[i].birth == 0;
        if (pairs[i].birth == 0) CHECK(b.birth_low == 0);
        certain += pairs[i].degree == 1 && b.certain == 1;
    }
    CHECK(born_at_zero > 0);
    CHECK(certain == 1);
}

// The ratio at a scale as netmesh_scale_step says.
static double ratio_at(const Session& session, double alpha) {
    const double c = session.report().diagram.certified_ratio;
    double reach = alpha;
    auto step = netmesh::sized<netmesh_scale_step>();
    for (std::uint64_t i = 0; netmesh_get_scale_step(session.context, i, &step) == NETMESH_OK && step.from <= alpha;
         ++i)
        reach = step.reach;
    return std::fmin(c, std::sqrt(std::fmax(reach, alpha) / alpha));
}

TEST_CASE("the ratio by scale") {
    Session session(2);
    session.bounds = true;
    for (const netmesh_filter filter : {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_BASIC, NETMESH_FILTER_KNN}) {
        REQUIRE(session.mesh_and_persist(inputs::shell(2, 80, 0.8, 1, 15), persist_by(filter, 3)) == NETMESH_OK);
        REQUIRE(session.bound_bars() == NETMESH_OK);
        const double c = session.report().diagram.certified_ratio;
        auto step = netmesh::sized<netmesh_scale_step>(), before = step;
        before.from = before.reach = -1;
        double worst = 0;
        std::uint64_t steps = 0;
        for (; netmesh_get_scale_step(session.context, steps, &step) == NETMESH_OK; ++steps) {
            CHECK(step.from > before.from);
            CHECK(step.reach > before.reach);
            CHECK(step.ratio >= 1);
            CHECK(step.ratio <= c);
            CHECK(step.ratio >= ratio_at(session, step.from) * (1 - 1e-9));
            worst = std::fmax(worst, step.ratio);
            before = step;
        }
        CHECK(steps > 3);
        CHECK(steps < 200);
        if (filter == NETMESH_FILTER_COMPLETE) CHECK(ratio_at(session, 1e-9) == 1);
        CHECK(worst > 1.2);
        CHECK(ratio_at(session, 10) == 1);
        // What a bar needs to be real by interleaving is the curve at its birth.
        const std::vector<netmesh_pair> pairs = session.pairs();
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            auto b = netmesh::sized<netmesh_bar_bounds>();
            REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
            if (!(pairs[i].birth > 0)) continue;
            const double here = ratio_at(session, pairs[i].birth);
            const bool capped = here >= c * (1 - 1e-9);
            CHECK((capped || b.certain_after <= here * here * pairs[i].birth * (1 + 1e-9)));
            CHECK(b.certain_after * (1 + 1.0 / 16) * (1 + 1e-9) >= here * here * pairs[i].birth);
        }
    }
}

TEST_CASE("covers within and around the offsets find more than the bounds of all cells together") {
    // Points of a torus: its void is longer than what interleaving needs nowhere near its scale.
    Session session(3);
    session.bounds = true;
    REQUIRE(session.mesh_and_persist(inputs::torus(250, 27)) == NETMESH_OK);
    REQUIRE(session.bound_bars() == NETMESH_OK);
    const std::vector<netmesh_pair> pairs = session.pairs();
    std::size_t by_covers = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        auto b = netmesh::sized<netmesh_bar_bounds>();
        REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
        by_covers += b.certain == 1 && !(pairs[i].death > b.certain_after);
    }
    CHECK(by_covers > 0);
}

// The cells' out-radius wanted at large scales: 0.18 where the inputs are 0.95 or more away and inside the 3-sphere.
static double fine_far_away(void* user, const double* x) {
    const inputs::Points& points = *static_cast<const inputs::Points*>(user);
    double nearest2 = 1e300, norm2 = 0;
    for (int k = 0; k < 4; ++k) norm2 += x[k] * x[k];
    for (std::size_t i = 0; i < points.size(); i += 4) {
        double d2 = 0;
        for (std::size_t k = 0; k < 4; ++k) d2 += (x[k] - points[i + k]) * (x[k] - points[i + k]);
        nearest2 = std::fmin(nearest2, d2);
    }
    return 0.18 + std::fmax(0.0, 0.95 - std::sqrt(nearest2)) + 2 * std::fmax(0.0, std::sqrt(norm2) - 1.45);
}

TEST_CASE("one-dimensional classes of the Clifford torus and that of the 3-sphere around it are surely real") {
    if (dimensions({4}).empty()) return;
    inputs::Points points = inputs::clifford(500);
    Session session(4);
    session.bounds = true;
    session.request.tau = 4;
    session.request.sizes.size = fine_far_away;
    session.request.sizes.user = &points;
    REQUIRE(session.mesh_and_persist(points) == NETMESH_OK);
    const std::vector<netmesh_pair> pairs = session.pairs();
    std::size_t certain[4] = {0, 0, 0, 0};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        auto b = netmesh::sized<netmesh_bar_bounds>();
        REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
        certain[pairs[i].degree] += b.certain;
    }
    CHECK(certain[0] == 500);
    CHECK(certain[1] == 2);
    CHECK(certain[3] == 1);
}
