// Rips complexes of distances: the same diagram from every layout as from points, brute force, and what is refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "common/read.hpp"
#include "common/session.hpp"

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Matrix {
    std::uint32_t n;
    std::vector<double> full, lower;
    std::vector<netmesh_distance_entry> entries;

    double at(std::uint32_t i, std::uint32_t j) const { return full[i * std::size_t{n} + j]; }
};

template <class F> Matrix matrix_of(std::uint32_t n, F distance) {
    Matrix m = {n, std::vector<double>(n * std::size_t{n}), {}, {}};
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < i; ++j) {
            const double d = distance(i, j);
            m.full[i * std::size_t{n} + j] = m.full[j * std::size_t{n} + i] = d;
            m.lower.push_back(d);
            if (d < HUGE_VAL) m.entries.push_back({(i + j) % 2 == 0 ? i : j, (i + j) % 2 == 0 ? j : i, d});
        }
    }
    std::reverse(m.entries.begin(), m.entries.end());
    return m;
}
double evaluate(void* user, std::uint32_t i, std::uint32_t j) { return static_cast<const Matrix*>(user)->at(i, j); }

// Small whole numbers: no metric, many ties.
Matrix random_matrix(std::uint32_t n, std::uint64_t seed, std::uint32_t most) {
    return matrix_of(n, [&](std::uint32_t, std::uint32_t) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(1 + (seed >> 33) % most);
    });
}

constexpr netmesh_distance_layout layouts[] = {NETMESH_DISTANCES_FULL, NETMESH_DISTANCES_LOWER,
                                               NETMESH_DISTANCES_SPARSE, NETMESH_DISTANCES_FUNCTION};

// Distances, and what is asked of them.
struct Asked {
    netmesh_distances of = netmesh::sized<netmesh_distances>();
    netmesh::Request request = netmesh::Request(&netmesh_filter_rips);

    // Points into this object.
    const netmesh_request* whole() {
        request.distances = &of;
        return &request;
    }
};

Asked asked_of(const Matrix& m, netmesh_distance_layout layout, std::uint32_t degree) {
    Asked a;
    a.of.layout = layout;
    a.of.numbers = layout == NETMESH_DISTANCES_FULL ? m.full.data() : m.lower.data();
    a.of.entries = m.entries.data();
    a.of.entry_count = m.entries.size();
    a.of.evaluate = evaluate;
    a.of.user = const_cast<Matrix*>(&m);
    a.of.count = m.n;
    a.request.max_degree = degree;
    return a;
}

netmesh_status run(Session& s, Asked a) {
    const netmesh_request* const r = a.whole();
    return s.until_it_fits(netmesh_plan(r), [&] { return netmesh_persist(s.context, r); });
}

bool same(const std::vector<netmesh_pair>& a, const std::vector<netmesh_pair>& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) {
               return x.degree == y.degree && std::memcmp(&x.birth, &y.birth, sizeof x.birth) == 0 &&
                      std::memcmp(&x.death, &y.death, sizeof x.death) == 0;
           });
}

// The complex listed simplex by simplex, as far as `limit`, and its homology.
std::vector<netmesh_pair> by_list(const Matrix& m, std::uint32_t degree, double limit) {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint64_t> starts = {0};
    std::vector<double> entries;
    for (std::uint32_t set = 1; set < 1u << m.n; ++set) {
        std::vector<std::uint32_t> in;
        for (std::uint32_t v = 0; v < m.n; ++v)
            if ((set >> v & 1) != 0) in.push_back(v);
        double value = 0;
        for (const std::uint32_t i : in)
            for (const std::uint32_t j : in) value = std::max(value, m.at(i, j) / 2);
        if (in.size() > degree + 2 || !(value <= limit) || value == HUGE_VAL) continue;
        vertices.insert(vertices.end(), in.begin(), in.end());
        starts.push_back(vertices.size());
        entries.push_back(value);
    }
    Session s(2);
    auto simplices = netmesh::sized<netmesh_simplices>();
    simplices.vertices = vertices.data();
    simplices.starts = starts.data();
    simplices.entries = entries.data();
    simplices.simplex_count = entries.size();
    netmesh::Request r(&netmesh_filter_simplices);
    r.simplices = &simplices;
    r.max_degree = degree;
    REQUIRE(s.persist_until_it_fits(r) == NETMESH_OK);
    return s.pairs();
}

// So that squares of differences and their sums are exact, and a root of one is rounded to nearest.
double in_few_bits(double x) { return std::round(x * 1024) / 1024; }

}  // namespace

TEST_CASE("distances of points have the diagram of the points, in every layout") {
    for (const std::uint32_t degree : {0u, 1u, 2u}) {
        CAPTURE(degree);
        inputs::Points points = inputs::uniform(2, 40);
        for (double& x : points) x = in_few_bits(x);
        Session by_points(2), by_distances(2);
        REQUIRE(by_points.persist_until_it_fits(by_points.points_request(points, &netmesh_filter_rips, 1, degree)) ==
                NETMESH_OK);
        const Matrix m = matrix_of(40, [&](std::uint32_t i, std::uint32_t j) {
            const double x = points[2 * i] - points[2 * j], y = points[2 * i + 1] - points[2 * j + 1];
            return std::sqrt(x * x + y * y);
        });
        for (const netmesh_distance_layout layout : layouts) {
            CAPTURE(layout);
            REQUIRE(run(by_distances, asked_of(m, layout, degree)) == NETMESH_OK);
            CHECK(same(by_distances.pairs(), by_points.pairs()));
            CHECK(by_distances.report().diagram.simplices == by_points.report().diagram.simplices);
            CHECK(by_distances.report().diagram.filter == NETMESH_FILTER_RIPS);
            CHECK(by_distances.report().input.distinct == 40);
        }
        // Half of a distance that there is, and what lies next to it.
        const double half = m.at(3, 1) / 2;
        for (const double threshold : {0x1p-1074, std::nextafter(half, 0.0), half, std::nextafter(half, 1.0), 0.3}) {
            CAPTURE(threshold);
            Asked a = asked_of(m, NETMESH_DISTANCES_FULL, degree);
            netmesh::Request p = by_points.points_request(points, &netmesh_filter_rips, 1, degree);
            a.request.threshold = p.threshold = threshold;
            for (const netmesh_want* const cycles : {static_cast<const netmesh_want*>(nullptr), &netmesh_cycles}) {
                a.request.cycles = p.cycles = cycles;
                REQUIRE(run(by_distances, a) == NETMESH_OK);
                REQUIRE(by_points.persist_until_it_fits(p) == NETMESH_OK);
                CHECK(same(by_distances.pairs(), by_points.pairs()));
                CHECK(by_distances.report().diagram.essential[0] == by_points.report().diagram.essential[0]);
            }
        }
    }
}

TEST_CASE("distances that are no metric, thresholds and points that are never joined, against a list of simplices") {
    Session s(2);
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Matrix m = random_matrix(7, seed, seed % 2 == 0 ? 5 : 1000);
        if (seed % 3 == 0)
            m = matrix_of(
                7, [&](std::uint32_t i, std::uint32_t j) { return (i * j + seed) % 4 == 1 ? HUGE_VAL : m.at(i, j); });
        for (const double threshold : {HUGE_VAL, 400.0, 1.5, 0.0}) {
            for (const std::uint32_t degree : {0u, 1u, 2u, 3u}) {
                CAPTURE(seed);
                CAPTURE(threshold);
                CAPTURE(degree);
                const std::vector<netmesh_pair> expected = by_list(m, degree, threshold);
                for (const netmesh_distance_layout layout : layouts) {
                    Asked a = asked_of(m, layout, degree);
                    a.request.threshold = threshold;
                    REQUIRE(run(s, a) == NETMESH_OK);
                    CHECK(same(s.pairs(), expected));
                    a.request.cycles = &netmesh_cycles;
                    REQUIRE(run(s, a) == NETMESH_OK);
                    CHECK(same(s.pairs(), expected));
                    CHECK(s.report().diagram.representatives == 1);
                }
            }
        }
    }
}

TEST_CASE("the fingerprint of distances tells one from another, not how they were handed over") {
    Session s(2);
    Matrix m = random_matrix(9, 3, 100);
    const auto print = [&](netmesh_distance_layout layout, std::uint32_t degree) {
        REQUIRE(run(s, asked_of(m, layout, degree)) == NETMESH_OK);
        return s.report().input.fingerprint;
    };
    const std::uint64_t full = print(NETMESH_DISTANCES_FULL, 1);
    CHECK(print(NETMESH_DISTANCES_LOWER, 1) == full);
    CHECK(print(NETMESH_DISTANCES_FUNCTION, 0) == full);
    m.lower[5] += 1;
    CHECK(print(NETMESH_DISTANCES_LOWER, 1) != full);
}

TEST_CASE("distances that are none are refused with their place") {
    Session s(2);
    const auto refused = [&](const Asked& asked, netmesh_field field, std::uint64_t a, std::uint64_t b) {
        CHECK(run(s, asked) == NETMESH_INVALID_ARGUMENT);
        CHECK(s.detail().field == field);
        CHECK(s.detail().index_a == a);
        CHECK(s.detail().index_b == b);
        CHECK(s.detail().message[0] != 0);
        CHECK(s.report().diagram.present == 0);
    };
    const Matrix good = random_matrix(6, 1, 9);
    for (const std::uint32_t degree : {0u, 1u}) {
        for (const double wrong : {-1.0, -std::numeric_limits<double>::denorm_min(), not_a_number}) {
            Matrix m = good;
            m.full[3 * 6 + 1] = m.full[1 * 6 + 3] = m.lower[3 + 1] = wrong;
            refused(asked_of(m, NETMESH_DISTANCES_FULL, degree), NETMESH_FIELD_NUMBERS, 3, 1);
            refused(asked_of(m, NETMESH_DISTANCES_LOWER, degree), NETMESH_FIELD_NUMBERS, 3, 1);
            refused(asked_of(m, NETMESH_DISTANCES_FUNCTION, degree), NETMESH_FIELD_NUMBERS, 3, 1);
            m = good;
            m.full[1 * 6 + 3] = wrong;
            refused(asked_of(m, NETMESH_DISTANCES_FULL, degree), NETMESH_FIELD_NUMBERS, 1, 3);
            m.entries[4].distance = wrong;
            refused(asked_of(m, NETMESH_DISTANCES_SPARSE, degree), NETMESH_FIELD_ENTRIES, 4, 4);
        }
        Matrix m = good;
        m.full[5 * 6 + 2] += 1;
        refused(asked_of(m, NETMESH_DISTANCES_FULL, degree), NETMESH_FIELD_NUMBERS, 5, 2);
        m = good;
        m.full[4 * 6 + 4] = 1;
        refused(asked_of(m, NETMESH_DISTANCES_FULL, degree), NETMESH_FIELD_NUMBERS, 4, 4);
        m = good;
        m.entries[2].i = 6;
        refused(asked_of(m, NETMESH_DISTANCES_SPARSE, degree), NETMESH_FIELD_ENTRIES, 2, 2);
        m = good;
        m.entries.push_back({m.entries[3].j, m.entries[3].i, m.entries[3].distance + 1});
        refused(asked_of(m, NETMESH_DISTANCES_SPARSE, degree), NETMESH_FIELD_ENTRIES, 15, 3);
        m.entries.back().distance -= 1;
        CHECK(run(s, asked_of(m, NETMESH_DISTANCES_SPARSE, degree)) == NETMESH_OK);
    }
}

TEST_CASE("requests on distances name the field at fault") {
    Session s(2);
    const Matrix m = random_matrix(6, 1, 9);
    const auto refused = [&](netmesh_distance_layout layout, auto change, netmesh_field field) {
        Asked a = asked_of(m, layout, 1);
        change(a);
        CHECK(netmesh_persist(s.context, a.whole()) == NETMESH_INVALID_ARGUMENT);
        CHECK(s.detail().field == field);
    };
    refused(
        NETMESH_DISTANCES_FULL, [](auto& a) { a.of.numbers = nullptr; }, NETMESH_FIELD_NUMBERS);
    refused(
        NETMESH_DISTANCES_SPARSE, [](auto& a) { a.of.entries = nullptr; }, NETMESH_FIELD_ENTRIES);
    refused(
        NETMESH_DISTANCES_SPARSE, [](auto& a) { a.of.entry_count = 1u << 31; }, NETMESH_FIELD_ENTRY_COUNT);
    refused(
        NETMESH_DISTANCES_FUNCTION, [](auto& a) { a.of.evaluate = nullptr; }, NETMESH_FIELD_EVALUATE);
    for (const netmesh_distance_layout layout : layouts)
        refused(
            layout, [](auto& a) { a.of.evaluate = nullptr, a.of.user = &a; }, NETMESH_FIELD_EVALUATE);
    for (const netmesh_distance_layout layout : layouts) {
        refused(
            layout, [](auto& a) { a.of.struct_bytes = 0; }, NETMESH_FIELD_STRUCT_BYTES);
        refused(
            layout, [](auto& a) { a.of.count = 0; }, NETMESH_FIELD_POINT_COUNT);
        refused(
            layout, [&](auto& a) { a.of.count = layout == NETMESH_DISTANCES_SPARSE ? (1u << 26) + 1 : 65537; },
            NETMESH_FIELD_POINT_COUNT);
        refused(
            layout, [](auto& a) { a.request.threshold = -1; }, NETMESH_FIELD_THRESHOLD);
        refused(
            layout, [](auto& a) { a.request.threshold = not_a_number; }, NETMESH_FIELD_THRESHOLD);
        refused(
            layout, [](auto& a) { a.request.max_degree = 31; }, NETMESH_FIELD_MAX_DEGREE);
        const int unknown = 9;
        refused(
            layout, [&](auto& a) { std::memcpy(&a.of.layout, &unknown, sizeof unknown); }, NETMESH_FIELD_LAYOUT);
    }
    Asked a = asked_of(m, NETMESH_DISTANCES_LOWER, 1);
    a.of.count = 1;
    a.of.numbers = nullptr;
    REQUIRE(run(s, a) == NETMESH_OK);
    CHECK(s.pairs().size() == 1);
}

TEST_CASE("distances stop at every poll") {
    Session s(2);
    const Matrix m = random_matrix(120, 5, 1000);
    struct Count {
        int left;
        static int poll(void* user, const netmesh_progress*) { return --static_cast<Count*>(user)->left < 0 ? 1 : 0; }
    };
    for (const netmesh_distance_layout layout : layouts) {
        Asked a = asked_of(m, layout, 1);
        Count count = {1 << 30};
        a.request.monitor = {Count::poll, &count};
        REQUIRE(run(s, a) == NETMESH_OK);  // in a block that is large enough from now on
        count.left = 1 << 30;
        REQUIRE(run(s, a) == NETMESH_OK);
        const int polls = (1 << 30) - count.left;
        const std::uint64_t print = s.report().fingerprint;
        CHECK(polls > 2);
        for (int after = 0; after < polls; after += 1 + polls / 20) {
            count.left = after;
            CHECK(run(s, a) == NETMESH_CANCELLED);
            CHECK(s.report().diagram.present == 0);
        }
        count.left = 1 << 30;
        REQUIRE(run(s, a) == NETMESH_OK);
        CHECK(s.report().fingerprint == print);
    }
}

TEST_CASE(
    "points of many coordinates have the Rips diagram of their distances, and that of the plane that holds them") {
    const std::uint32_t n = 40;
    const inputs::Points plane = inputs::uniform(2, n);
    Session small(2), large(2), by_distances(2);
    for (const std::uint32_t dim : {7u, 64u}) {
        inputs::Points points(std::size_t{n} * dim, 0.0), mixed(std::size_t{n} * dim);
        for (std::size_t i = 0; i < points.size(); ++i)
            mixed[i] = in_few_bits(std::sin(static_cast<double>(i * i % 1009)));
        for (std::uint32_t i = 0; i < n; ++i) {
            points[i * std::size_t{dim} + 3] = plane[2 * i];
            points[i * std::size_t{dim} + dim - 1] = plane[2 * i + 1];
        }
        for (const std::uint32_t degree : {0u, 1u, 2u}) {
            CAPTURE(dim);
            CAPTURE(degree);
            REQUIRE(small.persist_until_it_fits(small.points_request(plane, &netmesh_filter_rips, 1, degree)) ==
                    NETMESH_OK);
            netmesh::Request r(&netmesh_filter_rips);
            r.set_points(dim, points);
            CHECK(r.points.count == n);
            r.max_degree = degree;
            REQUIRE(large.persist_until_it_fits(r) == NETMESH_OK);
            CHECK(same(large.pairs(), small.pairs()));
            CHECK(large.report().input.dim == dim);
            r.set_points(dim, mixed);
            const Matrix m = matrix_of(n, [&](std::uint32_t i, std::uint32_t j) {
                double sum = 0;
                for (std::uint32_t k = 0; k < dim; ++k) {
                    const double d = mixed[i * std::size_t{dim} + k] - mixed[j * std::size_t{dim} + k];
                    sum += d * d;
                }
                return std::sqrt(sum);
            });
            REQUIRE(run(by_distances, asked_of(m, NETMESH_DISTANCES_LOWER, degree)) == NETMESH_OK);
            for (const netmesh_want* const cycles : {static_cast<const netmesh_want*>(nullptr), &netmesh_cycles}) {
                r.cycles = cycles;
                REQUIRE(large.persist_until_it_fits(r) == NETMESH_OK);
                CHECK(same(large.pairs(), by_distances.pairs()));
            }
        }
    }
}

TEST_CASE("distances in many dimensions where squares are out of range") {
    Session s(2);
    const std::uint32_t dim = 16;
    const auto half = [&](double unit) {  // of two points that are 4 units apart in each coordinate
        inputs::Points points(2 * dim, -2 * unit);
        for (std::uint32_t k = 0; k < dim; ++k) points[dim + k] = 2 * unit;
        netmesh::Request r(&netmesh_filter_rips);
        r.set_points(dim, points);
        REQUIRE(s.persist_until_it_fits(r) == NETMESH_OK);
        REQUIRE(s.pairs().size() == 2);
        return std::min(s.pairs()[0].death, s.pairs()[1].death);
    };
    for (const int exponent : {-1070, -900, -512, -400, 0, 400, 512, 900, 1018}) {
        CAPTURE(exponent);
        CHECK(half(std::ldexp(1, exponent)) == std::ldexp(8, exponent));
    }
    CHECK(half(std::ldexp(1, 1022)) == HUGE_VAL);  // beyond the largest double
}

TEST_CASE("only Rips complexes take points of more than six coordinates") {
    Session s(2);
    const inputs::Points points(14, 0.5);
    netmesh::Request r(&netmesh_filter_cech);
    r.set_points(7, points);
    CHECK(netmesh_persist(s.context, &r) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_DIM);
    CHECK(netmesh_plan(&r) == 0);
    r.filter = &netmesh_filter_rips;
    CHECK(netmesh_plan(&r) > 0);
    CHECK(netmesh_persist(s.context, &r) == NETMESH_OK);
    CHECK(s.report().input.duplicates == 1);
    r.points.dim = NETMESH_RIPS_DIM_MAX + 1;
    CHECK(netmesh_persist(s.context, &r) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_DIM);
    CHECK(netmesh_plan(&r) == 0);
}

TEST_CASE("a function is asked for each distance once, row by row") {
    struct Order {
        std::uint32_t i = 1, j = 0;
        bool holds = true;
    } order;
    Asked a;
    a.of.layout = NETMESH_DISTANCES_FUNCTION;
    a.of.evaluate = [](void* user, std::uint32_t i, std::uint32_t j) {
        Order& o = *static_cast<Order*>(user);
        o.holds = o.holds && i == o.i && j == o.j;
        if (++o.j == o.i) o = {o.i + 1, 0, o.holds};
        return 1.0 + (i * 7 + j * 3) % 11;
    };
    a.of.user = &order;
    a.of.count = 40;
    Session s(2);
    REQUIRE(netmesh_persist(s.context, a.whole()) == NETMESH_OK);
    CHECK(order.holds);
    CHECK(order.i == 40);
}

TEST_CASE("the plan of distances suffices, and is not much more than a random metric takes") {
    std::uint64_t seed = 7;
    const Matrix m = matrix_of(200, [&seed](std::uint32_t, std::uint32_t) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        return 1 + static_cast<double>(seed >> 11) * 0x1p-53;
    });
    for (const netmesh_distance_layout layout : layouts)
        for (const std::uint32_t degree : {0u, 1u}) {
            CAPTURE(layout);
            CAPTURE(degree);
            Asked a = asked_of(m, layout, degree);
            const std::size_t planned = netmesh_plan(a.whole());
            Session s(2);
            s.reserve(planned);
            REQUIRE(netmesh_persist(s.context, a.whole()) == NETMESH_OK);
            const double used = static_cast<double>(s.report().memory.peak_bytes);
            CHECK(static_cast<double>(planned) <= (degree == 0 ? 5 : 1.5) * used);
        }
}
