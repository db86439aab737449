// Filters by a function: what the interface takes and refuses.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "api/settle.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

// The distance to the middle of the points, and one more: one component, no cycle.
double from_middle(void* calls, const double* x) {
    ++*static_cast<int*>(calls);
    return std::sqrt((x[0] - 0.5) * (x[0] - 0.5) + (x[1] - 0.5) * (x[1] - 0.5)) + 1;
}
double boundless(void*, const double* x) { return x[0] > 0.5 ? HUGE_VAL : 1; }
double undefined(void*, const double*) { return std::nan(""); }

}  // namespace

TEST_CASE("a function of the caller's") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 60);
    int calls = 0;
    netmesh_function function = {sizeof function, from_middle, &calls, 1, 1, 1.7};
    const auto persist = [&] { return session.persist(function, netmesh::Request()); };
    CHECK(persist() == NETMESH_NO_RESULT);
    REQUIRE(session.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
    REQUIRE(persist() == NETMESH_OK);
    const netmesh_report report = session.report();
    CHECK(calls == static_cast<int>(report.mesh.vertices));
    CHECK(report.diagram.filter == NETMESH_FILTER_FUNCTION);
    CHECK(report.diagram.certified_ratio > 1);
    // Bars that the certificate lets count: the essential one.
    int real = 0;
    for (const netmesh_pair& pair : session.pairs())
        real += pair.death > pair.birth * report.diagram.certified_ratio * report.diagram.certified_ratio;
    CHECK(real == 1);

    const auto refused = [&](const netmesh_function& f, netmesh_field field) {
        CHECK(session.persist(f, netmesh::Request()) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == field);
    };
    const std::uint32_t bytes = sizeof function;
    refused({bytes, nullptr, nullptr, 1, 0, 2}, NETMESH_FIELD_FUNCTION);
    refused({bytes, from_middle, &calls, -1, 0, 2}, NETMESH_FIELD_LIPSCHITZ);
    refused({bytes, from_middle, &calls, 1, INFINITY, 2}, NETMESH_FIELD_DISTANCE_FACTOR);
    refused({bytes, from_middle, &calls, 1, 0, std::nan("")}, NETMESH_FIELD_CUT);
    CHECK(session.report().diagram.present == 1);  // refused before anything was given up
    for (const auto evaluate : {boundless, undefined}) {
        function.evaluate = evaluate;
        CHECK(persist() == NETMESH_NOT_FINITE);
        CHECK(session.report().diagram.present == 0);
    }
    CHECK(session.report().complete == 1);
    CHECK(session.persist(&netmesh_filter_function) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_FUNCTION);
    // Bounds and cycles of a diagram that is not there.
    for (const bool cycles : {false, true}) {
        netmesh::Request request = persist_by(&netmesh_filter_function);
        (cycles ? request.cycles : request.bounds) = cycles ? &netmesh_cycles : &netmesh_bounds;
        CHECK(session.persist(request) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == NETMESH_FIELD_FUNCTION);
    }
    function.evaluate = from_middle;
    REQUIRE(persist() == NETMESH_OK);
    CHECK(session.represent() == NETMESH_OK);
}

// Nasty functions, of one point to five.
TEST_CASE("every function has a finite error, unless what is said of it cannot be") {
    struct Saddle {
        double level, slope;
        static double at(void* self, const double* x) {
            const Saddle& s = *static_cast<const Saddle*>(self);
            return s.level + s.slope * (x[0] > x[1] ? x[0] : x[1]);
        }
    };
    for (const int dim : dimensions(2, 4))
        for (std::size_t n = 1; n <= 5; ++n) {
            CAPTURE(dim);
            CAPTURE(n);
            Session session(dim);
            const inputs::Points points = inputs::uniform(dim, n, n);
            REQUIRE(session.mesh(points, n % 2 == 0 ? nullptr : &netmesh_filter_complete) == NETMESH_OK);
            const netmesh_report report = session.report();
            const double radius = report.mesh.domain[dim];
            const auto persist = [&](Saddle saddle, double lipschitz, double cut) {
                const netmesh_function f = {sizeof f, Saddle::at, &saddle, lipschitz, 0, cut};
                REQUIRE(session.persist(f, netmesh::Request()) == NETMESH_OK);
                return session.report().diagram.certified_error;
            };
            // Constant, below and at the cut.
            CHECK(persist({0, 0}, 0, 0) == 0);
            CHECK(persist({7, 0}, 0, 7) == 0);
            CHECK(persist({7, 0}, 3, -7) <= 3 * radius);
            CHECK(session.pairs().size() == 1);
            CHECK(session.pairs()[0].birth == -7);
            // Steep, the cut below all values: they are the cut; and values down to it at the sphere.
            CHECK(persist({0, 1e6}, 1e6, -1e9) <= 1e6 * radius * (1 + 1e-9));
            const double error = persist({0, 1}, 1, -1e3);
            CHECK(error <= radius * (1 + 1e-9));
            // A constant below the cut by more than L allows from the sphere on.
            CHECK(persist({0, 0}, 1, 1.5 * radius) == HUGE_VAL);
            CHECK(persist({0, 0}, 0, 1e-3) == HUGE_VAL);
            CHECK(session.bound_bars() == NETMESH_OK);
        }
    // The sizes for an error.
    Saddle pit = {-1, 2};
    const netmesh_function f = {sizeof f, Saddle::at, &pit, 2, 0, 3};
    const double low[] = {0, 0}, high[] = {0, 4};
    netmesh::ErrorSizes sizes = {f, 0.5};
    CHECK(netmesh::ErrorSizes::at(&sizes, low) == doctest::Approx(0.25).epsilon(1e-4));
    CHECK(netmesh::ErrorSizes::at(&sizes, high) == doctest::Approx(2).epsilon(1e-4));
    sizes.function.lipschitz = 0;
    CHECK(netmesh::ErrorSizes::at(&sizes, low) == HUGE_VAL);
}

TEST_CASE("an error that is asked for is kept to, with the mesh or the diagram asked for it") {
    const inputs::Points points = inputs::uniform(2, 12);
    int calls = 0;
    const netmesh_function function = {sizeof function, from_middle, &calls, 1, 0, 1.2};
    Session session(2), plain(2);
    netmesh::Request request = on(points, session.plain(&netmesh_filter_function));
    request.function = &function;
    REQUIRE(plain.persist_until_it_fits(request) == NETMESH_OK);
    const double error = plain.report().diagram.certified_error / 2;
    request.goal.error = error;
    REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
    const netmesh_report report = session.report();
    CHECK(report.diagram.values == NETMESH_VALUES_THESIS);
    CHECK(report.diagram.certified_error <= error);
    CHECK(report.mesh.vertices > plain.report().mesh.vertices);
    session.request.filter = &netmesh_filter_function;
    session.request.function = &function;
    session.request.goal.error = error;
    CHECK(session.check(NETMESH_CHECK_QUALITY) == NETMESH_OK);
    REQUIRE(session.mesh(points, &netmesh_filter_function) == NETMESH_OK);
    REQUIRE(session.persist(function, persist_by(nullptr, 0, NETMESH_VALUES_THESIS)) == NETMESH_OK);
    CHECK(session.report().fingerprint == report.fingerprint);
    // The mesh without it is too coarse.
    REQUIRE(plain.mesh(points, &netmesh_filter_function) == NETMESH_OK);
    plain.request = session.request;
    CHECK(plain.check(NETMESH_CHECK_QUALITY) == NETMESH_CHECK_FAILED);

    // With sizes of the caller's the lesser of both: a tenth of the error's here and there.
    const netmesh_size by_caller = [](void*, const double* x) { return x[0] < 0.5 ? 0.02 : HUGE_VAL; };
    request.mesh.sizes.size = by_caller;
    REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
    CHECK(session.report().diagram.certified_error <= error);
    CHECK(session.report().mesh.vertices > report.mesh.vertices);
    request.mesh.sizes.size = [](void*, const double*) { return 0.0; };
    CHECK(session.persist(request) == NETMESH_INVALID_ARGUMENT);
    request.mesh.sizes.size = nullptr;

    const auto refused = [&](netmesh_field field) {
        CHECK(session.persist(request) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == field);
    };
    for (const double bad : {-1.0, HUGE_VAL, std::nan("")}) {
        request.goal.error = bad;
        refused(NETMESH_FIELD_ERROR);
    }
    request.goal.error = error;
    request.values = NETMESH_VALUES_CERTIFIED;
    refused(NETMESH_FIELD_VALUES);
    request.values = NETMESH_VALUES_OPEN;
    request.function = nullptr;
    refused(NETMESH_FIELD_FUNCTION);
    request.filter = &netmesh_filter_complete;
    refused(NETMESH_FIELD_ERROR);
}

// Bars by the bounds of cells: the function is asked again, and has to be the one of the diagram.
TEST_CASE("bounds of a function's bars: by cells with the function, by the one error without") {
    int narrower = 0;
    for (const int dim : dimensions(2, 4)) {
        CAPTURE(dim);
        Session session(dim);
        const inputs::Points points = inputs::uniform(dim, 30);
        REQUIRE(session.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
        const double radius = session.report().mesh.domain[dim];
        // A cone over the first input, where cells are small, and the wall that the cut needs.
        struct Pit {
            const netmesh_report report;
            const double* middle;
            double depth;
            std::uint64_t calls;
            static double at(void* self, const double* x) {
                Pit& p = *static_cast<Pit*>(self);
                ++p.calls;
                double d2 = 0, away2 = 0;
                for (std::uint32_t k = 0; k < p.report.input.dim; ++k) {
                    d2 += (x[k] - p.middle[k]) * (x[k] - p.middle[k]);
                    away2 += (x[k] - p.report.mesh.domain[k]) * (x[k] - p.report.mesh.domain[k]);
                }
                const double wall = std::sqrt(away2) - p.report.mesh.domain[p.report.input.dim];
                return std::max(std::fabs(std::sqrt(d2) - 0.2) - p.depth, wall);
            }
        } pit = {session.report(), points.data(), 0.5 * radius, 0};
        const netmesh_function f = {sizeof f, Pit::at, &pit, 1, 0, 0};
        netmesh::Request request(&netmesh_filter_function);
        request.values = NETMESH_VALUES_THESIS;
        REQUIRE(session.persist(f, request) == NETMESH_OK);
        const double error = session.report().diagram.certified_error;
        const std::vector<netmesh_pair> pairs = session.pairs();
        REQUIRE(session.bound_bars() == NETMESH_OK);
        const auto by_one = read_all(session.context, netmesh_get_bar_bounds);
        const std::uint64_t vertices = session.report().mesh.vertices;
        pit.calls = 0;
        REQUIRE(session.bound_bars(f) == NETMESH_OK);  // they are there already
        CHECK(pit.calls == 0);
        REQUIRE(session.persist(f, request) == NETMESH_OK);
        // Not the function that the diagram is of.
        const auto refused = [&](const netmesh_function& other, netmesh_field field) {
            CHECK(session.bound_bars(other) == NETMESH_INVALID_ARGUMENT);
            CHECK(session.detail().field == field);
            auto none = netmesh::sized<netmesh_bar_bounds>();
            CHECK(netmesh_get_bar_bounds(session.context, 0, &none) == NETMESH_INVALID_ARGUMENT);
            CHECK(session.pairs().size() == pairs.size());
        };
        netmesh_function other = f;
        other.lipschitz = 0.5;
        refused(other, NETMESH_FIELD_FUNCTION);
        other = f;
        other.cut = 0.1;
        refused(other, NETMESH_FIELD_FUNCTION);
        other = f;
        other.evaluate = undefined;
        refused(other, NETMESH_FIELD_FUNCTION);
        other.evaluate = nullptr;
        refused(other, NETMESH_FIELD_FUNCTION);
        pit.depth *= 1.0001;
        refused(f, NETMESH_FIELD_FUNCTION);
        pit.depth = 0.5 * radius;
        pit.calls = 0;
        REQUIRE(session.bound_bars(f) == NETMESH_OK);
        CHECK(pit.calls == vertices);
        const auto by_cell = read_all(session.context, netmesh_get_bar_bounds);
        double widest = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            // Bars that covers alone tell have their bounds, of which one may be wider.
            if (by_cell[i].certain == (pairs[i].death > by_cell[i].certain_after)) {
                CHECK(by_cell[i].birth_low >= by_one[i].birth_low);
                CHECK(by_cell[i].birth_high <= by_one[i].birth_high);
            }
            CHECK(std::isfinite(by_cell[i].birth_low));
            CHECK(by_cell[i].certain_after <= by_one[i].certain_after);
            CHECK(by_cell[i].certain >= by_one[i].certain);
            CHECK(by_cell[i].birth_low <= pairs[i].birth);
            CHECK(by_cell[i].birth_high >= pairs[i].birth);
            narrower += by_cell[i].birth_high - by_cell[i].birth_low < 1.5 * error;
        }
        for (const netmesh_scale_step& step : read_all(session.context, netmesh_get_scale_step)) {
            CHECK(step.error <= error);
            widest = std::max(widest, step.error);
        }
        CHECK(widest > 0.5 * error);
        // Nothing is open about a constant; nothing is known where what is said of the function cannot be.
        other = f;
        other.evaluate = [](void*, const double*) { return 3.0; };
        REQUIRE(session.persist(other, request) == NETMESH_OK);
        REQUIRE(session.bound_bars(other) == NETMESH_OK);
        auto b = read_all(session.context, netmesh_get_bar_bounds)[0];
        CHECK(b.birth_low == doctest::Approx(0));
        CHECK(b.birth_high == doctest::Approx(0));
        other.evaluate = [](void*, const double*) { return -3.0; };
        REQUIRE(session.persist(other, request) == NETMESH_OK);
        REQUIRE(session.bound_bars(other) == NETMESH_OK);
        b = read_all(session.context, netmesh_get_bar_bounds)[0];
        CHECK(b.birth_low == -HUGE_VAL);
        CHECK(b.birth_high == HUGE_VAL);
    }
    CHECK(narrower > 0);
}

TEST_CASE("filters by neighbours certify no more than the complete filter's ratio lets them") {
    double closest[2] = {0, 0};  // the share of the bound that is used
    for (const int dim : dimensions(2, 4)) {
        for (std::uint64_t set = 0; set < by_dimension<std::uint64_t>(dim, {60, 12, 3}); ++set) {
            CAPTURE(dim);
            CAPTURE(set);
            const std::size_t n = dim == 4 ? 8 : 4 + 7 * (set % 8);
            const inputs::Points points = set % 3 == 0   ? inputs::uniform(dim, n, set)
                                          : set % 3 == 1 ? inputs::clusters(dim, n, set)
                                                         : inputs::shell(dim, n, 1, 1.1, set);
            Session session(dim);
            // Meshes by quality and by the certificate, from coarse to fine.
            if (set % 2 == 0) {
                session.request.mesh.tau = dim == 4 ? 4 : 2.1 + 0.2 * static_cast<double>(set % 7);
            } else {
                session.request.goal.ratio = 1.8 + 0.3 * static_cast<double>(set % 5);
                session.request.mesh.whole_cells = 1;
            }
            REQUIRE(session.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
            REQUIRE(session.persist(&netmesh_filter_complete) == NETMESH_OK);
            const double c = session.report().diagram.certified_ratio;
            for (const netmesh_filter* const filter : {&netmesh_filter_knn, &netmesh_filter_kdistance})
                for (std::uint32_t k = 2; k <= 4; ++k) {
                    REQUIRE(session.persist(persist_by(filter, k)) == NETMESH_OK);
                    const bool mean = filter == &netmesh_filter_kdistance;
                    const double s = mean ? std::sqrt(k / (k - 1.0)) : 1;
                    const double share = session.report().diagram.certified_ratio / std::sqrt(2 + s * c * c);
                    CHECK(share <= 1 + 1e-9);
                    closest[mean] = std::max(closest[mean], share);
                }
        }
    }
    // Both bounds are reached.
    CHECK(closest[0] > 0.99);
    CHECK(closest[1] > 0.99);
}

TEST_CASE("k: one mesh for all, as many neighbours as there are points") {
    Session session(3);
    inputs::Points points = inputs::uniform(3, 40);
    points.insert(points.end(), points.begin(), points.begin() + 3);  // a duplicate is no neighbour
    REQUIRE(session.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
    double last = -1;
    for (std::uint32_t k = 1; k <= 40; k += 13) {
        REQUIRE(session.persist(persist_by(&netmesh_filter_knn, k, NETMESH_VALUES_THESIS)) == NETMESH_OK);
        const std::vector<netmesh_pair> pairs = session.pairs();
        double least = 1e9;
        for (const netmesh_pair& pair : pairs)
            if (std::isinf(pair.death)) least = pair.birth;
        CHECK(least > last);
        last = least;
    }
    CHECK(session.persist(persist_by(&netmesh_filter_kdistance, 41, NETMESH_VALUES_THESIS)) ==
          NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_K);
    CHECK(session.persist(persist_by(&netmesh_filter_complete, 1, NETMESH_VALUES_THESIS)) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_K);
    CHECK(session.persist(persist_by(&netmesh_filter_complete, 0, NETMESH_VALUES_THESIS)) == NETMESH_OK);
}
