// Numbers some units in the last place apart, and at the ends of the range of doubles: what the interface says of a
// result holds whichever way they are rounded.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "common/read.hpp"
#include "common/session.hpp"

namespace {

constexpr double least = 0x1p-1074, largest = std::numeric_limits<double>::max();
const double forever = std::numeric_limits<double>::infinity();

std::vector<netmesh_pair> pairs_of(const netmesh_context* context) {
    std::vector<netmesh_pair> pairs;
    auto pair = netmesh::sized<netmesh_pair>();
    while (netmesh_get_pair(context, pairs.size(), &pair) == NETMESH_OK) pairs.push_back(pair);
    return pairs;
}

// With bounds.
netmesh::Request points_by(const netmesh_filter* filter, const std::vector<double>& points) {
    netmesh::Request request(filter);
    request.set_points(2, points);
    request.bounds = &netmesh_bounds;
    return request;
}

std::vector<netmesh_bar_bounds> bounds_of(const netmesh_context* context) {
    std::vector<netmesh_bar_bounds> bounds;
    auto b = netmesh::sized<netmesh_bar_bounds>();
    while (netmesh_get_bar_bounds(context, bounds.size(), &b) == NETMESH_OK) bounds.push_back(b);
    return bounds;
}

// Of two points at a distance, each way to hand it over and each way to the diagram.
int count_components(double distance, double threshold, int way) {
    const double full[] = {0, distance, distance, 0};
    const netmesh_distance_entry entry = {1, 0, distance};
    auto given = netmesh::sized<netmesh_distances>();
    const auto evaluate = [](void* user, std::uint32_t, std::uint32_t) { return *static_cast<double*>(user); };
    given.layout = static_cast<netmesh_distance_layout>(way % 4);
    if (given.layout == NETMESH_DISTANCES_FULL) given.numbers = full;
    if (given.layout == NETMESH_DISTANCES_LOWER) given.numbers = &distance;
    if (given.layout == NETMESH_DISTANCES_SPARSE) {
        given.entries = &entry;
        given.entry_count = 1;
    }
    if (given.layout == NETMESH_DISTANCES_FUNCTION) {
        given.evaluate = evaluate;
        given.user = &distance;
    }
    given.count = 2;
    netmesh::Request request(&netmesh_filter_rips);
    request.distances = &given;
    request.threshold = threshold;
    request.max_degree = way / 4 % 2;
    request.cycles = way / 8 % 2 == 1 ? &netmesh_cycles : nullptr;
    Session session(2);
    REQUIRE(netmesh_persist(session.context, &request) == NETMESH_OK);
    int components = 0;
    for (const netmesh_pair& pair : pairs_of(session.context)) components += pair.degree == 0 && pair.death == forever;
    return components;
}

}  // namespace

// Half of an odd number of least doubles is rounded, to an even number of them.
TEST_CASE("points farther apart than twice the threshold are not joined, where half of that is no double either") {
    for (int way = 0; way < 16; ++way)
        for (int distance = 0; distance < 12; ++distance)
            for (int threshold = 0; threshold < 6; ++threshold) {
                CAPTURE(way);
                CAPTURE(distance);
                CAPTURE(threshold);
                CHECK(count_components(distance * least, threshold * least, way) ==
                      (distance <= 2 * threshold ? 1 : 2));
            }
    CHECK(count_components(1, 0.5, 0) == 1);
    CHECK(count_components(std::nextafter(1, 2), 0.5, 0) == 2);
    CHECK(count_components(largest, largest, 0) == 1);
}

// With k = 1 two points are an edge, whose true value is half their distance.
TEST_CASE("the ratio of barycentric Rips complexes covers what rounds their values") {
    int rounded_up = 0;
    for (int i = 0; i < 1000; ++i) {
        CAPTURE(i);
        const double distance = 1 + i * 0x1.5p-11 + i * 0x1p-52;
        const std::vector<double> points = {0, 0, distance, 0};
        netmesh::Request request = points_by(&netmesh_filter_barycentric_rips, points);
        request.max_degree = 0;
        Session session(2);
        REQUIRE(netmesh_persist(session.context, &request) == NETMESH_OK);
        const double ratio = session.report().diagram.certified_ratio, death = pairs_of(session.context).at(0).death;
        CHECK(ratio * ratio * ratio * ratio < 2 + 1e-14);
        CHECK(std::fma(ratio, distance / 2, -death) >= 0);  // rounded once, so its sign is right
        rounded_up += std::fma(std::sqrt(std::sqrt(2.0)), distance / 2, -death) < 0;
    }
    CHECK(rounded_up > 100);
}

// Points on a line, at multiples of the least double: the values of sets are halves of that, and are rounded.
TEST_CASE("bounds of bars hold true values of sets that are too small for doubles") {
    int rounded_to_zero = 0;
    for (int gap = 1; gap <= 9; ++gap)
        for (const netmesh_filter* const filter : {&netmesh_filter_cech, &netmesh_filter_barycentric_cech,
                                                   &netmesh_filter_barycentric_rips, &netmesh_filter_rips})
            for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS})
                for (std::uint32_t k = 1; k <= 2; ++k) {
                    const bool has_values = filter == &netmesh_filter_barycentric_rips;
                    const bool has_k = has_values || filter == &netmesh_filter_barycentric_cech;
                    if ((k > 1 && !has_k) || (values == NETMESH_VALUES_THESIS && !has_values)) continue;
                    CAPTURE(gap);
                    CAPTURE(filter);
                    CAPTURE(values);
                    CAPTURE(k);
                    const std::vector<double> points = {0, 0, gap * least, 0};
                    netmesh::Request request = points_by(filter, points);
                    request.values = values;
                    request.max_degree = 0;
                    if (has_k) request.k = k;
                    Session session(2);
                    REQUIRE(netmesh_persist(session.context, &request) == NETMESH_OK);
                    const std::vector<netmesh_pair> pairs = pairs_of(session.context);
                    const std::vector<netmesh_bar_bounds> bounds = bounds_of(session.context);
                    REQUIRE(bounds.size() == pairs.size());
                    // In halves of the least double.
                    const auto holds = [&](double low, double high, double halves) {
                        return low / least * 2 <= halves && halves <= high / least * 2;
                    };
                    const netmesh_bar_bounds& last = bounds.back();
                    CHECK(pairs.back().death == forever);
                    CHECK(last.death_low == forever);
                    CHECK(last.certain == 1);
                    CHECK(holds(last.birth_low, last.birth_high, k == 1 ? 0 : gap));
                    CHECK(last.birth_high < (k == 1 ? least : 4 * gap * least + 16 * least));
                    CHECK(last.certain_after >= last.birth_high);
                    rounded_to_zero += k == 2 && pairs.back().birth == 0;
                    if (pairs.size() < 2) continue;
                    REQUIRE(k == 1);
                    CHECK(holds(bounds[0].birth_low, bounds[0].birth_high, 0));
                    CHECK(holds(bounds[0].death_low, bounds[0].death_high, gap));
                    CHECK(bounds[0].death_high <= 4 * gap * least + 16 * least);
                }
    CHECK(rounded_to_zero > 0);
}

TEST_CASE("a class that ends beyond the largest double ends at infinity, and has a cycle") {
    // Half of the first edge is the largest double, half of the others is above it.
    const std::vector<double> points = {-largest, -largest, largest, -largest, 0, largest};
    for (const netmesh_filter* const filter : {&netmesh_filter_rips, &netmesh_filter_cech}) {
        CAPTURE(filter);
        netmesh::Request request = points_by(filter, points);
        request.cycles = &netmesh_cycles;
        Session session(2);
        REQUIRE(netmesh_persist(session.context, &request) == NETMESH_OK);
        const std::vector<netmesh_pair> pairs = pairs_of(session.context);
        const std::vector<netmesh_bar_bounds> bounds = bounds_of(session.context);
        REQUIRE(pairs.size() == 3);
        const netmesh_report report = session.report();
        CHECK(report.diagram.essential[0] == 2);
        CHECK(pairs[0].death == largest);
        for (std::size_t i = 0; i < 3; ++i) {
            CAPTURE(i);
            std::uint64_t simplices = 0;
            REQUIRE(netmesh_get_cycle(session.context, i, &simplices) == NETMESH_OK);
            CHECK((simplices == 1 || simplices == 2));
            CHECK(pairs[i].birth == 0);
            CHECK(bounds[i].birth_high == 0);
            CHECK(bounds[i].death_high == forever);
            CHECK(bounds[i].death_low == (i == 0 ? std::nextafter(largest, 0) : forever));
        }
    }
}

namespace {

// Meshes with scales of interest, and whether they are what was asked for.
class Focused {
public:
    explicit Focused(const inputs::Points& points, bool whole) : points_(points), session_(2) {
        session_.request.mesh.whole_cells = whole;
    }
    bool make(double from, double to) {
        ask(from, to);
        return session_.mesh(points_, &netmesh_filter_complete) == NETMESH_OK;
    }
    bool has(double from, double to) {
        ask(from, to);
        return session_.check() == NETMESH_OK;
    }

private:
    void ask(double from, double to) { session_.request.goal = {4, 0, 0, 0, 1.7, from, to, 0}; }

    const inputs::Points& points_;
    Session session_;
};

// The place between `good` and `bad` where has(x) changes, to the last place: the good side.
template <class Has> double last_good(double good, double bad, Has has) {
    for (;;) {
        const double middle = good + (bad - good) / 2;
        if (middle == good || middle == bad) return good;
        (has(middle) ? good : bad) = middle;
    }
}

}  // namespace

// A cell's bounds are rounded outwards, and may reach scales of interest that they did not reach while it was refined.
TEST_CASE("scales of interest that end within roundings of a cell's bounds") {
    int ends = 0;
    for (std::uint64_t seed = 1; seed <= 24; ++seed)
        for (const bool whole : {false, true}) {
            CAPTURE(seed);
            CAPTURE(whole);
            const inputs::Points points = inputs::uniform(2, 4 + seed % 7, seed);
            Focused mesh(points, whole);
            double from = 0.3 + 0.01 * static_cast<double>(seed), to = 100;
            for (int step = 0; step < 4; ++step) {
                REQUIRE(mesh.make(from, to));
                CHECK(mesh.has(from, to));
                if (mesh.has(from / 64, to)) break;
                // A cell's hi, from just above which on nothing is wrong; a bit lower, but not by what rounds it.
                from = last_good(from, from / 64, [&](double x) { return mesh.has(x, to); }) * (1 - 0x1p-41);
                ++ends;
            }
            from = 0.02;
            to = 0.1 + 0.01 * static_cast<double>(seed);
            for (int step = 0; step < 4; ++step) {
                REQUIRE(mesh.make(from, to));
                CHECK(mesh.has(from, to));
                if (mesh.has(from, 64 * to)) break;
                to = last_good(to, 64 * to, [&](double x) { return mesh.has(from, x); }) * (1 + 0x1p-42);
                ++ends;
            }
        }
    CHECK(ends > 20);
}

namespace {

// The distance from the middle of a square, and a number that may be far larger.
struct Raised {
    double offset, width, error;
    netmesh_function function;

    Raised(double from, double side, double least) : offset(from), width(side), error(least) {
        function = netmesh::sized<netmesh_function>();
        function.evaluate = [](void* user, const double* x) {
            const Raised& self = *static_cast<const Raised*>(user);
            return self.offset + std::hypot(x[0] - self.width / 2, x[1] - self.width / 2);
        };
        function.user = this;
        function.lipschitz = 1;
        function.cut = offset + 0.6 * width;
    }
};

}  // namespace

TEST_CASE("a mesh for an error certifies it, however large the function is beside it") {
    for (const double width : {1.0, 1e-4})
        for (const double offset : {0.0, 1e3, 1e9, -1e9, 1e10, -1e10}) {
            if (width < 1 && std::fabs(offset) > 1e9) continue;  // beyond what its digits resolve
            for (const double share : {0.05, 0.3}) {
                CAPTURE(width);
                CAPTURE(offset);
                CAPTURE(share);
                Raised raised(offset, width, share * width);
                inputs::Points points = inputs::uniform(2, 10, 7);
                for (double& x : points) x *= width;
                Session session(2);
                session.request.mesh.domain_factor = 2;
                session.request.function = &raised.function;
                session.request.goal.error = raised.error;
                REQUIRE(session.mesh(points, &netmesh_filter_function) == NETMESH_OK);
                netmesh::Request request = persist_by(&netmesh_filter_function, 0, NETMESH_VALUES_THESIS);
                request.function = &raised.function;
                REQUIRE(session.persist(request) == NETMESH_OK);
                const double certified = session.report().diagram.certified_error;
                CHECK(certified <= raised.error);
                CHECK(certified > 0.7 * raised.error);
            }
        }
    const Raised large(1e10, 1, 1e-6);
    Session session(2);
    session.request.function = &large.function;
    session.request.goal.error = large.error;
    CHECK(session.mesh(inputs::uniform(2, 10, 7), &netmesh_filter_function) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_ERROR);
}
