// Bounds of single bars: what the interface says, and that those of exact filters are as wide as the values' error.
#include <doctest/doctest.h>

#include <cmath>

#include "common/dimensions.hpp"
#include "common/read.hpp"
#include "common/session.hpp"

TEST_CASE("bounds of bars") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 50);
    auto b = netmesh::sized<netmesh_bar_bounds>();
    netmesh::Request request = persist_by(&netmesh_filter_complete);
    request.bounds = &netmesh_bounds;
    CHECK(session.persist(request) == NETMESH_NO_RESULT);
    CHECK(netmesh_get_bar_bounds(session.context, 0, &b) == NETMESH_INVALID_ARGUMENT);
    auto step = netmesh::sized<netmesh_scale_step>();
    CHECK(netmesh_get_scale_step(session.context, 0, &step) == NETMESH_INVALID_ARGUMENT);

    REQUIRE(session.alpha(points) == NETMESH_OK);
    REQUIRE(session.bound_bars() == NETMESH_OK);
    const std::vector<netmesh_pair> exact = session.pairs();
    const double error = 0x1p-52;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
        CHECK(b.birth_low <= exact[i].birth);
        CHECK(b.birth_low >= exact[i].birth * (1 - 2 * error));
        CHECK(b.birth_high >= exact[i].birth);
        CHECK(b.birth_high <= exact[i].birth * (1 + 2 * error));
        CHECK(b.death_low <= exact[i].death);
        CHECK(b.death_high >= exact[i].death);
        CHECK(b.certain == 1);
        if (!std::isfinite(exact[i].death)) continue;
        CHECK(b.death_low >= exact[i].death * (1 - 2 * error));
        CHECK(b.death_high <= exact[i].death * (1 + 2 * error));
    }
    CHECK(netmesh_get_bar_bounds(session.context, exact.size(), &b) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_scale_step(session.context, 0, &step) == NETMESH_INVALID_ARGUMENT);  // 1 at every scale

    // No bar is bounded more widely than the ratio of the whole diagram says.
    for (const netmesh_filter* const filter :
         {&netmesh_filter_complete, &netmesh_filter_knn, &netmesh_filter_kdistance}) {
        REQUIRE(session.mesh_and_persist(points, persist_by(filter, filter == &netmesh_filter_complete ? 0 : 4)) ==
                NETMESH_OK);
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

TEST_CASE("bounds of simplices are made with the diagram or later, and not of another one") {
    // A triangle that is filled at 3.
    const std::uint32_t vertices[] = {0, 1, 2, 0, 1, 0, 2, 1, 2, 0, 1, 2};
    const std::uint64_t starts[] = {0, 1, 2, 3, 5, 7, 9, 12};
    const double entries[] = {0, 0, 0.5, 1, 2, 2.5, 3};
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.vertices = vertices, simplices.starts = starts, simplices.entries = entries;
    simplices.simplex_count = 7;
    netmesh::Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    Session session(2), at_once(2);
    REQUIRE(session.persist(request) == NETMESH_OK);
    netmesh::Request more(&netmesh_filter_simplices);
    more.bounds = &netmesh_bounds;
    REQUIRE(session.persist(more) == NETMESH_OK);
    request.bounds = &netmesh_bounds;
    REQUIRE(at_once.persist(request) == NETMESH_OK);
    std::uint64_t bars = 0;
    for (std::uint64_t i = 0;; ++i) {
        auto a = netmesh::sized<netmesh_bar_bounds>(), b = a;
        const netmesh_status status = netmesh_get_bar_bounds(session.context, i, &a);
        REQUIRE(netmesh_get_bar_bounds(at_once.context, i, &b) == status);
        if (status != NETMESH_OK) break;
        ++bars;
        CHECK(a.birth_low == b.birth_low);
        CHECK(a.death_high == b.death_high);
    }
    CHECK(bars == 4);
    more.bounds = nullptr;
    more.cycles = &netmesh_cycles;
    CHECK(session.persist(more) == NETMESH_NO_RESULT);
    more.bounds = &netmesh_bounds, more.cycles = nullptr;
    more.max_degree = 0;
    CHECK(session.persist(more) == NETMESH_NO_RESULT);
    Session empty(2);
    CHECK(empty.persist(more) == NETMESH_NO_RESULT);
    more.bounds = nullptr;
    CHECK(session.persist(more) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_FILTER);
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
        netmesh_status status = session.mesh_in_block(points, &netmesh_filter_complete);
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
    REQUIRE(session.mesh_and_persist(inputs::circle(40), &netmesh_filter_basic) == NETMESH_OK);
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

// The step of a scale; before the first one, one in which all is exact.
static netmesh_scale_step step_at(const std::vector<netmesh_scale_step>& steps, double alpha) {
    netmesh_scale_step at = {0, 0, HUGE_VAL, 0, 0, 1, 0};
    for (const netmesh_scale_step& step : steps)
        if (step.from <= alpha) at = step;
    return at;
}
static double ratio_at(const std::vector<netmesh_scale_step>& steps, double alpha) {
    const netmesh_scale_step at = step_at(steps, alpha);
    return std::fmax(std::fmax(at.high, alpha) / alpha, alpha / std::fmin(at.low, alpha));
}

TEST_CASE("the ratio by scale") {
    Session session(2);
    std::size_t compared = 0;
    session.bounds = true;
    for (const netmesh_filter* const filter : {&netmesh_filter_complete, &netmesh_filter_basic, &netmesh_filter_knn}) {
        const netmesh::Request diagram = persist_by(filter, filter == &netmesh_filter_knn ? 3 : 0);
        REQUIRE(session.mesh_and_persist(inputs::shell(2, 80, 0.8, 1, 15), diagram) == NETMESH_OK);
        REQUIRE(session.bound_bars() == NETMESH_OK);
        const netmesh_diagram_report report = session.report().diagram;
        const std::vector<netmesh_scale_step> steps = read_all(session.context, netmesh_get_scale_step);
        double worst = 0;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const netmesh_scale_step& step = steps[i];
            CAPTURE(i);
            CHECK(step.ratio >= 1);
            if (step.from >= report.certified_from) {
                CHECK(step.ratio <= report.certified_ratio);
                worst = std::fmax(worst, step.ratio);
            }
            // low and high say the same to within a step.
            const double end = i + 1 < steps.size() ? steps[i + 1].from : step.from;
            if (step.from > 0) {
                const double loose = std::fmax(std::fmax(step.high / step.from, end / step.low), 1);
                CHECK(step.ratio <= loose * (1 + 1e-9));
                CHECK(step.ratio * (1 + 1.0 / 16) >= loose * (1 - 1e-9));
            }
            if (i > 0) {
                const netmesh_scale_step& before = steps[i - 1];
                CHECK(step.from > before.from);
                CHECK(step.low >= before.low);
                CHECK(step.high >= before.high);
                CHECK(step.reach >= before.reach);
            }
        }
        CHECK(steps.size() > 3);
        CHECK(steps.size() < 400);
        if (filter == &netmesh_filter_complete) CHECK(ratio_at(steps, 1e-9) == 1);
        CHECK(worst > 1.2);
        CHECK(ratio_at(steps, 10) == 1);
        // What bars need to be real, and the bounds of those that are not said to be, are those of the curve at birth
        // and death, to within a step; the others can have narrower bounds.
        const double wide = (1 + 1.0 / 16) * (1 + 1e-9);
        const auto follows = [&](double at, double low, double high) {
            const netmesh_scale_step step = step_at(steps, at);
            CHECK(std::fmin(step.low, at) <= low);
            CHECK(std::fmin(step.low, at) * wide >= low);
            CHECK(std::fmax(step.high, at) >= high);
            CHECK(std::fmax(step.high, at) <= high * wide);
        };
        const std::vector<netmesh_pair> pairs = session.pairs();
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            auto b = netmesh::sized<netmesh_bar_bounds>();
            REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
            const double reach = std::fmax(step_at(steps, pairs[i].birth).reach, pairs[i].birth);
            CHECK(reach >= b.certain_after);
            CHECK(reach <= b.certain_after * wide);
            if (b.certain == 1) continue;
            ++compared;
            follows(pairs[i].birth, b.birth_low, b.birth_high);
            follows(pairs[i].death, b.death_low, b.death_high);
        }
    }
    CHECK(compared > 10);
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

TEST_CASE("one-dimensional classes of the Clifford torus and that of the 3-sphere around it are certified to exist") {
    if (dimensions({4}).empty()) return;
    inputs::Points points = inputs::clifford(500);
    Session session(4);
    session.bounds = true;
    session.request.mesh.tau = 4;
    session.request.mesh.sizes.size = fine_far_away;
    session.request.mesh.sizes.user = &points;
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
