// Ratios and budgets: what the interface admits, and that more memory never gives a worse certificate.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/polls.hpp"
#include "common/session.hpp"

TEST_CASE("ratios that make no sense") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 20);
    const auto mesh = [&](const netmesh_filter* filter) { return session.mesh_in_block(points, filter); };
    const auto fit_refused = [&](netmesh_field field) {
        CHECK(session.fit(points) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == field);
    };
    session.request.goal.focus_ratio = 1.5;
    CHECK(mesh(&netmesh_filter_complete) == NETMESH_INVALID_ARGUMENT);
    session.request.goal.focus_ratio = 0;
    for (const double ratio : {-2.0, 1.0, 1.414, 1e300, 1e300 * 1e300, std::nan("")}) {
        session.request.goal.ratio = ratio;
        CHECK(mesh(&netmesh_filter_complete) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == NETMESH_FIELD_RATIO);
        fit_refused(NETMESH_FIELD_RATIO);
    }
    session.request.goal.ratio = 2.25;
    session.request.mesh.sizes.eps = 0.5;
    CHECK(mesh(&netmesh_filter_complete) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_SIZE_EPS);
    session.request.mesh.sizes.eps = 0;
    for (const netmesh_method* const method : {&netmesh_method_svr, &netmesh_method_refine}) {
        session.request.mesh.method = method;
        for (const netmesh_filter* const filter :
             {static_cast<const netmesh_filter*>(nullptr), &netmesh_filter_complete}) {
            CHECK(mesh(filter) == NETMESH_INVALID_ARGUMENT);
            CHECK(session.detail().field == NETMESH_FIELD_RATIO);
        }
    }
    CHECK(mesh(&netmesh_filter_tight) == NETMESH_INVALID_ARGUMENT);
    session.request.mesh.method = nullptr;
    const double bad[][3] = {{1.5, 0, 1}, {1.5, 1, 0.5}, {2.5, 0.1, 1}, {1, 0.1, 1}, {0, 0.1, 1}};
    for (const auto& [focus, from, to] : bad) {
        session.request.goal.focus_ratio = focus;
        session.request.goal.focus_from = from;
        session.request.goal.focus_to = to;
        CHECK(mesh(&netmesh_filter_complete) == NETMESH_INVALID_ARGUMENT);
    }
    session.request.goal = {2.25, 0, 0, 0, 0, 0.1, 0, 0};
    fit_refused(NETMESH_FIELD_FOCUS_TO);
    session.request.goal = {2.25, 0, 0, 0, 0, 0, 1, 0};
    fit_refused(NETMESH_FIELD_FOCUS_FROM);
    CHECK(mesh(&netmesh_filter_complete) == NETMESH_INVALID_ARGUMENT);
    const netmesh::Request request = session.fit_request(points);
    CHECK(netmesh_persist(session.context, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_persist(nullptr, &request) == NETMESH_INVALID_ARGUMENT);
    session.request.goal = {};
    netmesh_request settled;
    REQUIRE(netmesh::settle(session.mesh_request(points, &netmesh_filter_complete), &settled) == NETMESH_OK);
    CHECK(settled.mesh.tau == 2.5);
    CHECK(netmesh_settle(nullptr, &settled, nullptr) == NETMESH_INVALID_ARGUMENT);
}

namespace {

// A fit in a block of so many bytes, and what its report says, compared with the same mesh and diagram asked for.
struct Fitted {
    netmesh_status status;
    double certified = 0;  // the ratio that counts
};
Fitted fit_in(std::size_t bytes, int dim, const inputs::Points& points, netmesh::Request asked) {
    Session session(dim);
    session.reserve(bytes);
    asked.set_points(static_cast<std::uint32_t>(dim), points);
    Fitted out = {netmesh_persist(session.context, &asked), 0};
    if (out.status != NETMESH_OK) return out;
    const netmesh_report report = session.report();
    CHECK(report.memory.peak_bytes <= (bytes + 15) / 16 * 16);  // a multiple of 16
    CHECK(filter_of(report.diagram.filter) == asked.filter);
    const bool focused = asked.goal.focus_to > 0;
    CHECK((report.diagram.certified_focus > 0) == focused);
    out.certified = focused ? report.diagram.certified_focus : report.diagram.certified_ratio;
    const netmesh_goal goal = report.mesh.goal;
    if (asked.filter == &netmesh_filter_complete && asked.values != NETMESH_VALUES_THESIS) {
        CHECK(report.diagram.certified_ratio <= goal.ratio);
        if (goal.focus_ratio > 0) CHECK(report.diagram.certified_focus <= goal.focus_ratio * (1 + 1e-12));
    }
    auto bounds = netmesh::sized<netmesh_bar_bounds>();
    CHECK((netmesh_get_bar_bounds(session.context, 0, &bounds) == NETMESH_OK) == (asked.bounds != nullptr));

    Session direct(dim);
    direct.request.goal = goal;
    direct.request.mesh.whole_cells = report.mesh.clipped == 0 ? 1 : 0;
    direct.request.seed = asked.seed;
    REQUIRE(direct.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
    REQUIRE(direct.persist(persist_by(asked.filter, asked.k, asked.values)) == NETMESH_OK);
    CHECK(direct.report().fingerprint == report.fingerprint);
    CHECK(direct.check(NETMESH_CHECK_QUALITY) == NETMESH_OK);
    return out;
}

}  // namespace

TEST_CASE("more memory never certifies less, whatever the filter, and the block is kept to") {
    const netmesh_filter* const filters[] = {
        &netmesh_filter_complete, &netmesh_filter_complete,  &netmesh_filter_knn,      &netmesh_filter_basic,
        &netmesh_filter_knn,      &netmesh_filter_kdistance, &netmesh_filter_complete, &netmesh_filter_tight};
    int improved = 0;
    for (std::uint64_t set = 0; set < 40; ++set) {
        CAPTURE(set);
        const int dim = set % 5 == 4 ? 3 : 2;
        const std::size_t n = dim == 3 ? 5 : set == 0 ? 5 : 5 + 3 * (set % 9);
        const inputs::Points points = inputs::uniform(dim, n, 100 + set);
        netmesh::Request asked(filters[set % 8]);
        asked.fit = &netmesh_fit;
        if (asked.filter == &netmesh_filter_knn || asked.filter == &netmesh_filter_kdistance) asked.k = 3;
        asked.seed = set;
        asked.bounds = set % 16 == 0 ? &netmesh_bounds : nullptr;
        if (set % 3 == 1) asked.values = NETMESH_VALUES_THESIS;
        if (set % 4 == 3 || set % 8 == 6) asked.goal.focus_from = 0.05, asked.goal.focus_to = 0.2;
        double last = 0;
        // A ladder of blocks, then steps as small as an array's end, from what the set itself picks.
        std::size_t bytes = 6000;
        for (int block = 0; block < 60; ++block) {
            const bool fine = block >= 40;
            if (block == 40) bytes = 20000 + 7000 * (set % 7), last = 0;
            const Fitted out = fit_in(bytes, dim, points, asked);
            bytes += fine ? 16 : bytes / 10;
            CAPTURE(bytes);
            if (out.status == NETMESH_OUT_OF_MEMORY) {
                CHECK(last == 0);
                continue;
            }
            REQUIRE(out.status == NETMESH_OK);
            CHECK((last == 0 || out.certified <= last));
            improved += last != 0 && out.certified < last;
            last = out.certified;
        }
    }
    CHECK(improved > 100);
}

namespace {

// Of any sign, its Lipschitz constant 1; nowhere below the cut outside of the domain of points of the unit cube.
struct Basins {
    int dim;
    std::vector<double> middles;
    static double at(void* self, const double* x) {
        const Basins& b = *static_cast<const Basins*>(self);
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < b.middles.size(); i += static_cast<std::size_t>(b.dim)) {
            double d2 = 0;
            for (int k = 0; k < b.dim; ++k) d2 += (x[k] - b.middles[i + k]) * (x[k] - b.middles[i + k]);
            least = std::min(least, std::fabs(std::sqrt(d2) - 0.1));
        }
        return least - 0.15;
    }
};

}  // namespace

TEST_CASE("by the error: more memory never has a larger one, and the mesh is the one for its rung") {
    int improved = 0, first = 0;
    for (std::uint64_t set = 0; set < 10; ++set) {
        CAPTURE(set);
        const int dim = set % 5 == 4 ? 3 : 2;
        const inputs::Points points = inputs::uniform(dim, dim == 3 ? 5 : 4 + 3 * set, 300 + set);
        Basins basins = {dim, {}};
        inputs::Random random(set);
        for (int i = 0; i < 3 * dim; ++i) basins.middles.push_back(0.4 + 0.2 * random.uniform());
        auto function = netmesh::sized<netmesh_function>();
        function.evaluate = Basins::at;
        function.user = &basins;
        function.lipschitz = 1;
        function.cut = 0.02;
        netmesh::Request asked(&netmesh_filter_function);
        asked.function = &function;
        asked.fit = &netmesh_fit;
        asked.bounds = set % 2 == 1 ? &netmesh_bounds : nullptr;
        asked.values = set % 4 == 3 ? NETMESH_VALUES_CERTIFIED : NETMESH_VALUES_THESIS;
        asked.set_points(static_cast<std::uint32_t>(dim), points);
        double last = HUGE_VAL, rung_above = HUGE_VAL;
        std::size_t bytes = 20000;
        for (int block = 0; block < 24; ++block) {
            bytes += block >= 20 ? 16 : bytes / 4;
            CAPTURE(bytes);
            Session session(dim);
            session.reserve(bytes);
            const netmesh_status status = netmesh_persist(session.context, &asked);
            if (status == NETMESH_OUT_OF_MEMORY) {
                CHECK(last == HUGE_VAL);
                continue;
            }
            REQUIRE(status == NETMESH_OK);
            const netmesh_report report = session.report();
            const double error = report.diagram.certified_error, rung = report.diagram.fitted_error;
            CHECK(report.memory.peak_bytes <= (bytes + 15) / 16 * 16);  // what reserve() makes of it
            CHECK(error <= last);
            improved += last < HUGE_VAL && error < last;
            first += rung == 0;
            last = error;
            if (rung > 0 && asked.values == NETMESH_VALUES_THESIS) CHECK(error <= rung);
            // Eight rungs halve the error.
            if (rung > 0 && rung_above < HUGE_VAL && rung < rung_above) {
                const double eighths = 8 * std::log2(rung_above / rung);
                CHECK(std::fabs(eighths - std::round(eighths)) < 1e-6);
            }
            if (rung > 0) rung_above = rung;
            auto bounds = netmesh::sized<netmesh_bar_bounds>();
            CHECK((netmesh_get_bar_bounds(session.context, 0, &bounds) == NETMESH_OK) == (asked.bounds != nullptr));
            if (block % 5 != 0) continue;
            Session direct(dim);
            direct.reserve(2 * bytes);
            direct.request.seed = asked.seed;
            direct.request.function = &function;
            direct.request.goal.error = rung;
            REQUIRE(direct.mesh(points, &netmesh_filter_function) == NETMESH_OK);
            netmesh::Request persist = persist_by(&netmesh_filter_function, 0, asked.values);
            persist.function = &function;
            REQUIRE(direct.persist(persist) == NETMESH_OK);
            CHECK(direct.report().fingerprint == report.fingerprint);
            CHECK(direct.report().diagram.certified_error == error);
        }
    }
    CHECK(improved > 60);
    CHECK(first > 5);
}

TEST_CASE("by the error: what is exact or impossible is not refined, and what does not go together is refused") {
    const inputs::Points points = inputs::uniform(2, 12);
    const auto constant = [](void* value, const double*) { return *static_cast<double*>(value); };
    double value = 1;
    auto function = netmesh::sized<netmesh_function>();
    function.evaluate = constant;
    function.user = &value;
    Session session(2);
    session.reserve(std::size_t{1} << 18);
    netmesh::Request asked = session.fit_request(points);
    asked.filter = &netmesh_filter_function;
    asked.function = &function;
    REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
    CHECK(session.report().diagram.certified_error == 0);
    CHECK(session.report().diagram.fitted_error == 0);
    value = -1;  // below the cut beyond the sphere too
    REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
    CHECK(session.report().diagram.certified_error == HUGE_VAL);
    CHECK(session.report().diagram.fitted_error == 0);
    // A cone down to the cut in one point: sizes shrink towards it, and the ladder ends.
    const auto cone = [](void*, const double* x) { return std::hypot(x[0] - 0.5, x[1] - 0.5); };
    function.evaluate = cone;
    function.lipschitz = 1;
    session.reserve(std::size_t{1} << 23);
    REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
    const netmesh_report cone_report = session.report();
    CHECK(cone_report.diagram.certified_error < 1e-8);
    CHECK(cone_report.diagram.fitted_error > 0x1p-33 * 0.05);
    CHECK(cone_report.memory.peak_bytes < (std::size_t{1} << 22));

    const auto refused = [&](netmesh_field field) {
        CHECK(netmesh_persist(session.context, &asked) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == field);
    };
    asked.goal.ratio = 3;
    refused(NETMESH_FIELD_RATIO);
    asked.goal = {};
    asked.goal.error = 0.1;
    refused(NETMESH_FIELD_ERROR);
    asked.goal = {};
    asked.goal.focus_from = 1;
    asked.goal.focus_to = 2;
    refused(NETMESH_FIELD_FOCUS_FROM);
    asked.goal = {};
    asked.filter = &netmesh_filter_complete;
    refused(NETMESH_FIELD_FUNCTION);
}

TEST_CASE("what another filter certifies does not end the climb: finer meshes certify more of it") {
    const inputs::Points points = inputs::uniform(2, 12);
    Session session(2);
    session.reserve(std::size_t{1} << 18);
    netmesh::Request asked = session.fit_request(points);
    asked.goal.ratio = 4;
    asked.filter = &netmesh_filter_knn;
    asked.k = 12;  // far from all of the points, so that cells of one size are nearly exact
    REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
    Session coarsest(2);
    coarsest.request.goal.ratio = 4;
    coarsest.request.mesh.whole_cells = 1;
    REQUIRE(coarsest.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
    REQUIRE(coarsest.persist(persist_by(&netmesh_filter_knn, 12)) == NETMESH_OK);
    CHECK(coarsest.report().diagram.certified_ratio < 1.4);  // less than any rung
    CHECK(session.report().diagram.certified_ratio < coarsest.report().diagram.certified_ratio - 0.2);
}

// By places: of each Steiner vertex's cell, where the distance to the points is least and largest.
TEST_CASE("certified_focus is of every cell that reaches into the scales of interest, also of those that lie across") {
    const inputs::Points points = inputs::close_pairs(2, 6, 0.01);
    for (const double to : {0.0501, 0.07}) {
        CAPTURE(to);
        Session session(2);
        session.reserve(std::size_t{1} << 16);
        netmesh::Request asked = session.fit_request(points);
        asked.goal.focus_from = 0.05;
        asked.goal.focus_to = to;
        REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
        const netmesh_report r = session.report();
        const std::vector<netmesh_vertex> vertices = session.vertices();
        std::vector<double> least(vertices.size(), HUGE_VAL), most(vertices.size(), 0);
        inputs::Random random(7);
        for (int i = 0; i < 15000; ++i) {
            const double x = random.uniform(), y = random.uniform();
            if (std::hypot(x - r.mesh.domain[0], y - r.mesh.domain[1]) > r.mesh.domain[2]) continue;
            double to_vertex = HUGE_VAL, to_input = HUGE_VAL;
            std::size_t nearest = 0;
            for (std::size_t v = 0; v < vertices.size(); ++v) {
                const double d = std::hypot(vertices[v].coordinates[0] - x, vertices[v].coordinates[1] - y);
                if (d < to_vertex) to_vertex = d, nearest = v;
                if (vertices[v].marker == 0) to_input = std::fmin(to_input, d);
            }
            least[nearest] = std::fmin(least[nearest], to_input);
            most[nearest] = std::fmax(most[nearest], to_input);
        }
        double worst = 1;
        for (std::size_t v = 0; v < vertices.size(); ++v)
            if (vertices[v].marker == 1 && most[v] > asked.goal.focus_from && least[v] < asked.goal.focus_to)
                worst = std::fmax(worst, std::sqrt(most[v] / least[v]));
        CHECK(worst > 1.1);
        CHECK(worst <= r.diagram.certified_focus * (1 + 1e-12));
    }
}

TEST_CASE("a fit that is stopped on its way leaves no diagram") {
    Polls polls;
    const inputs::Points points = inputs::uniform(2, 300);
    Session session(2);
    session.reserve(std::size_t{1} << 22);
    session.request.monitor = polls.monitor();
    REQUIRE(session.fit(points) == NETMESH_OK);
    const long all = polls.made;
    const std::uint64_t print = session.report().fingerprint;
    REQUIRE(all > 2);
    for (const long stop_at : {0L, all / 2, all - 1}) {
        polls = {0, stop_at};
        CHECK(session.fit(points) == NETMESH_CANCELLED);
        CHECK(session.report().diagram.present == 0);
    }
    polls = {};
    REQUIRE(session.fit(points) == NETMESH_OK);
    CHECK(session.report().fingerprint == print);
}
