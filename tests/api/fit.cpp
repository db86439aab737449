// Ratios and budgets: what the interface admits, and that more memory never gives a worse certificate.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/polls.hpp"
#include "common/session.hpp"

TEST_CASE("ratios that make no sense") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 20);
    const auto mesh = [&](netmesh_purpose purpose) { return session.mesh_in_block(points, purpose); };
    const auto fit_refused = [&](netmesh_field field) {
        CHECK(session.fit(points) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == field);
    };
    session.request.certificate.focus_ratio = 1.5;
    CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.request.certificate.focus_ratio = 0;
    for (const double ratio : {-2.0, 1.0, 1.414, 1e300, 1e300 * 1e300, std::nan("")}) {
        session.request.certificate.ratio = ratio;
        CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == NETMESH_FIELD_RATIO);
        fit_refused(NETMESH_FIELD_RATIO);
    }
    session.request.certificate.ratio = 2.25;
    CHECK(mesh(NETMESH_PURPOSE_MESH) == NETMESH_INVALID_ARGUMENT);
    CHECK(mesh(NETMESH_PURPOSE_TIGHT) == NETMESH_INVALID_ARGUMENT);
    session.request.sizes.eps = 0.5;
    CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.request.sizes.eps = 0;
    session.request.method = NETMESH_METHOD_REFINE;
    CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.request.method = NETMESH_METHOD_SVR;
    const double bad[][3] = {{1.5, 0, 1}, {1.5, 1, 0.5}, {2.5, 0.1, 1}, {1, 0.1, 1}, {0, 0.1, 1}};
    for (const auto& [focus, from, to] : bad) {
        session.request.certificate.focus_ratio = focus;
        session.request.certificate.focus_from = from;
        session.request.certificate.focus_to = to;
        CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    }
    session.request.certificate = {2.25, 0, 0.1, 0};
    fit_refused(NETMESH_FIELD_FOCUS_TO);
    session.request.certificate = {2.25, 0, 0, 1};
    fit_refused(NETMESH_FIELD_FOCUS_FROM);
    CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    const netmesh_fit_request request = session.fit_request(points);
    CHECK(netmesh_fit(session.context, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_fit(nullptr, &request) == NETMESH_INVALID_ARGUMENT);
    session.request.certificate.focus_to = 0;
    CHECK(netmesh_tau(&session.request) == 2.5);
    CHECK(netmesh_tau(nullptr) == 0);
}

namespace {

// |x - 1/2| + 0.3, of slope 1; on points of [0, 1]^D the domain reaches no farther than 4 from the centre.
double distance_to_centre(void* user, const double* x) {
    double d2 = 0;
    for (int k = 0; k < *static_cast<const int*>(user); ++k) d2 += (x[k] - 0.5) * (x[k] - 0.5);
    return 0.3 + std::sqrt(d2);
}

// A fit in a block of so many bytes, and what its report says, compared with the same mesh and diagram asked for.
struct Fitted {
    netmesh_status status;
    double certified = 0;  // the ratio that counts
};
Fitted fit_in(std::size_t bytes, int dim, const inputs::Points& points, netmesh_fit_request asked) {
    Session session(dim);
    session.reserve(bytes);
    asked.points = points.data();
    asked.point_count = points.size() / static_cast<std::size_t>(dim);
    Fitted out = {netmesh_fit(session.context, &asked), 0};
    if (out.status != NETMESH_OK) return out;
    const netmesh_report report = session.report();
    CHECK(report.memory.peak_bytes <= (bytes + 15) / 16 * 16);  // a multiple of 16
    CHECK(report.diagram.filter == asked.filter);
    const bool focused = asked.focus_to > 0;
    CHECK((report.diagram.certified_focus > 0) == focused);
    out.certified = focused ? report.diagram.certified_focus : report.diagram.certified_ratio;
    const netmesh_certificate_goal goal = report.mesh.certificate;
    if (asked.filter == NETMESH_FILTER_COMPLETE && asked.values == NETMESH_VALUES_CERTIFIED) {
        CHECK(report.diagram.certified_ratio <= goal.ratio);
        if (goal.focus_ratio > 0) CHECK(report.diagram.certified_focus <= goal.focus_ratio * (1 + 1e-12));
    }
    auto bounds = netmesh::sized<netmesh_bar_bounds>();
    CHECK((netmesh_get_bar_bounds(session.context, 0, &bounds) == NETMESH_OK) == (asked.bounds != 0));

    Session direct(dim);
    direct.request.certificate = goal;
    direct.request.whole_cells = report.mesh.clipped == 0 ? 1 : 0;
    direct.request.seed = asked.seed;
    REQUIRE(direct.mesh(points, NETMESH_PURPOSE_PERSIST) == NETMESH_OK);
    netmesh_persist_request persist = persist_by(asked.filter, asked.k, asked.values);
    persist.function = asked.function;
    REQUIRE(direct.persist(persist) == NETMESH_OK);
    CHECK(direct.report().fingerprint == report.fingerprint);
    CHECK(direct.check(NETMESH_CHECK_QUALITY) == NETMESH_OK);
    return out;
}

}  // namespace

TEST_CASE("more memory never certifies less, whatever the filter, and the block is kept to") {
    const netmesh_filter filters[] = {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_COMPLETE, NETMESH_FILTER_KNN,
                                      NETMESH_FILTER_BASIC,    NETMESH_FILTER_FUNCTION, NETMESH_FILTER_KDISTANCE,
                                      NETMESH_FILTER_COMPLETE, NETMESH_FILTER_TIGHT};
    int improved = 0;
    for (std::uint64_t set = 0; set < 40; ++set) {
        CAPTURE(set);
        const int dim = set % 5 == 4 ? 3 : 2;
        const std::size_t n = dim == 3 ? 5 : set == 0 ? 5 : 5 + 3 * (set % 9);
        const inputs::Points points = inputs::uniform(dim, n, 100 + set);
        netmesh::requests::Fit asked(static_cast<std::uint32_t>(dim));
        asked.filter = filters[set % 8];
        asked.k = 3;
        asked.seed = set;
        asked.bounds = set % 16 == 0 ? 1 : 0;
        if (set % 3 == 1) asked.values = NETMESH_VALUES_THESIS;
        if (set % 4 == 3 || set % 8 == 6) asked.focus_from = 0.05, asked.focus_to = 0.2;
        int user = dim;
        netmesh_function function;
        netmesh_function_init(&function, sizeof function);
        function.evaluate = distance_to_centre;
        function.user = &user;
        function.lipschitz = 1;
        function.cut = 10;
        asked.function = &function;
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
        netmesh::requests::Function function;
        function.evaluate = Basins::at;
        function.user = &basins;
        function.lipschitz = 1;
        function.cut = 0.02;
        netmesh::requests::Fit asked(static_cast<std::uint32_t>(dim));
        asked.filter = NETMESH_FILTER_FUNCTION;
        asked.function = &function;
        asked.by_error = 1;
        asked.bounds = set % 2;
        asked.values = set % 4 == 3 ? NETMESH_VALUES_CERTIFIED : NETMESH_VALUES_THESIS;
        asked.points = points.data();
        asked.point_count = points.size() / static_cast<std::size_t>(dim);
        double last = HUGE_VAL, rung_above = HUGE_VAL;
        std::size_t bytes = 20000;
        for (int block = 0; block < 24; ++block) {
            bytes += block >= 20 ? 16 : bytes / 4;
            CAPTURE(bytes);
            Session session(dim);
            session.reserve(bytes);
            const netmesh_status status = netmesh_fit(session.context, &asked);
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
            CHECK((netmesh_get_bar_bounds(session.context, 0, &bounds) == NETMESH_OK) == (asked.bounds != 0));
            if (block % 5 != 0) continue;
            struct Sized {
                const netmesh_function* function;
                double error;
                static double at(void* self, const double* x) {
                    return netmesh_size_for_error(static_cast<Sized*>(self)->function, static_cast<Sized*>(self)->error,
                                                  x);
                }
            } sized = {&function, rung};
            Session direct(dim);
            direct.reserve(2 * bytes);
            direct.request.seed = asked.seed;
            if (rung > 0) direct.request.sizes = {0, Sized::at, &sized};
            REQUIRE(direct.mesh(points, NETMESH_PURPOSE_PERSIST) == NETMESH_OK);
            netmesh_persist_request persist = persist_by(NETMESH_FILTER_FUNCTION, 1, asked.values);
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
    netmesh::requests::Function function;
    function.evaluate = constant;
    function.user = &value;
    Session session(2);
    session.reserve(std::size_t{1} << 18);
    netmesh_fit_request asked = session.fit_request(points);
    asked.filter = NETMESH_FILTER_FUNCTION;
    asked.function = &function;
    asked.by_error = 1;
    REQUIRE(netmesh_fit(session.context, &asked) == NETMESH_OK);
    CHECK(session.report().diagram.certified_error == 0);
    CHECK(session.report().diagram.fitted_error == 0);
    value = -1;  // below the cut beyond the sphere too
    REQUIRE(netmesh_fit(session.context, &asked) == NETMESH_OK);
    CHECK(session.report().diagram.certified_error == HUGE_VAL);
    CHECK(session.report().diagram.fitted_error == 0);
    // A cone down to the cut in one point: sizes shrink towards it, and the ladder ends.
    const auto cone = [](void*, const double* x) { return std::hypot(x[0] - 0.5, x[1] - 0.5); };
    function.evaluate = cone;
    function.lipschitz = 1;
    session.reserve(std::size_t{1} << 23);
    REQUIRE(netmesh_fit(session.context, &asked) == NETMESH_OK);
    const netmesh_report cone_report = session.report();
    CHECK(cone_report.diagram.certified_error < 1e-8);
    CHECK(cone_report.diagram.fitted_error > 0x1p-33 * 0.05);
    CHECK(cone_report.memory.peak_bytes < (std::size_t{1} << 22));

    const auto refused = [&](netmesh_field field) {
        CHECK(netmesh_fit(session.context, &asked) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == field);
    };
    asked.ratio = 3;
    refused(NETMESH_FIELD_RATIO);
    asked.ratio = 0;
    asked.focus_from = 1;
    asked.focus_to = 2;
    refused(NETMESH_FIELD_FOCUS_FROM);
    asked.focus_from = asked.focus_to = 0;
    asked.filter = NETMESH_FILTER_COMPLETE;
    refused(NETMESH_FIELD_FILTER);
}

TEST_CASE("what another filter certifies does not end the climb: finer meshes certify more of a function") {
    const auto nearly_constant = [](void*, const double* x) { return 1 + 0.01 * std::hypot(x[0] - 0.5, x[1] - 0.5); };
    const inputs::Points points = inputs::uniform(2, 12);
    netmesh::requests::Function function;
    function.evaluate = nearly_constant;
    function.lipschitz = 0.01;
    function.cut = 10;
    Session session(2);
    session.reserve(std::size_t{1} << 18);
    netmesh_fit_request asked = session.fit_request(points);
    asked.ratio = 4;
    asked.filter = NETMESH_FILTER_FUNCTION;
    asked.function = &function;
    REQUIRE(netmesh_fit(session.context, &asked) == NETMESH_OK);
    Session coarsest(2);
    coarsest.request.certificate.ratio = 4;
    coarsest.request.whole_cells = 1;
    REQUIRE(coarsest.mesh(points, NETMESH_PURPOSE_PERSIST) == NETMESH_OK);
    netmesh_persist_request persist = persist_by(NETMESH_FILTER_FUNCTION);
    persist.function = &function;
    REQUIRE(coarsest.persist(persist) == NETMESH_OK);
    CHECK(coarsest.report().diagram.certified_ratio < 1.1);  // less than any rung
    CHECK(session.report().diagram.certified_ratio < coarsest.report().diagram.certified_ratio - 0.002);
}

// By places: of each Steiner vertex's cell, where the distance to the points is least and largest.
TEST_CASE("certified_focus is of every cell that reaches into the scales of interest, also of those that lie across") {
    const inputs::Points points = inputs::close_pairs(2, 6, 0.01);
    for (const double to : {0.0501, 0.07}) {
        CAPTURE(to);
        Session session(2);
        session.reserve(std::size_t{1} << 16);
        netmesh_fit_request asked = session.fit_request(points);
        asked.focus_from = 0.05;
        asked.focus_to = to;
        REQUIRE(netmesh_fit(session.context, &asked) == NETMESH_OK);
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
            if (vertices[v].marker == 1 && most[v] > asked.focus_from && least[v] < asked.focus_to)
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
