// Points that repeat through the C interface: refusals, formats, what must not change a diagram at sizes where copies
// are taken by margins, memory, stops. Values against rationals: tests/periods.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <set>
#include <vector>

#include "common/inputs.hpp"
#include "common/kept.hpp"
#include "netmesh.hpp"

namespace {

using inputs::Points;
using kept::Bar;
using kept::bars_of;
using kept::Context;
using kept::hidden_of;
using kept::report_of;

netmesh::Request request_of(int dim, const Points& points, const Points& lattice) {
    netmesh::Request request(&netmesh_filter_alpha);
    request.set_points(static_cast<std::uint32_t>(dim), points).set_lattice(lattice);
    return request;
}
Points cube(int dim, double side = 1) {
    Points lattice(static_cast<std::size_t>(dim * dim), 0.0);
    for (int k = 0; k < dim; ++k) lattice[static_cast<std::size_t>(k * dim + k)] = side;
    return lattice;
}
// Multiples of 2^-30 within the box of side 1.
Points on_grid(Points points) {
    for (double& x : points) x = std::floor(x * 0x1p30) * 0x1p-30;
    return points;
}

constexpr std::size_t block = std::size_t(1) << 26;

// A simplex whose first vertex is at its own place.
using Corner = std::vector<std::int64_t>;  // its number, translations
std::vector<Corner> corners_of(const netmesh_simplex& simplex, std::size_t axes) {
    std::vector<Corner> corners;
    for (std::uint32_t v = 0; v <= simplex.degree; ++v) {
        corners.push_back({static_cast<std::int64_t>(simplex.vertices[v])});
        corners.back().insert(corners.back().end(), simplex.translations[v], simplex.translations[v] + axes);
    }
    return corners;
}
std::vector<Corner> normal(std::vector<Corner> corners) {
    std::sort(corners.begin(), corners.end());
    const Corner first = corners.front();
    for (Corner& corner : corners)
        for (std::size_t j = 1; j < corner.size(); ++j) corner[j] -= first[j];
    return corners;
}

// Cycles are closed, as late as their bars are born, made of edges no longer than their values say, and go around the
// torus, modulo 2, where they last and only there.
int faults_of_cycles(const netmesh::Engine& engine, int dim, const Points& points, const Points& lattice) {
    const std::size_t d = static_cast<std::size_t>(dim), axes = lattice.size() / d;
    int faults = 0;
    std::vector<unsigned> around;  // of loops that last, a bit an axis
    const std::vector<Bar> bars = bars_of(engine);
    for (std::size_t i = 0; i < bars.size(); ++i) {
        std::set<std::vector<Corner>> simplices, boundary;
        double last = -std::numeric_limits<double>::infinity();
        unsigned winding = 0;
        engine.for_each_in_cycle(i, [&](std::uint64_t, const netmesh_simplex& simplex) {
            const std::vector<Corner> corners = corners_of(simplex, axes);
            faults += normal(corners) != corners || !simplices.insert(corners).second;
            last = std::max(last, simplex.value);
            for (std::size_t v = 0; v < corners.size() && corners.size() > 1; ++v) {
                std::vector<Corner> facet = corners;
                facet.erase(facet.begin() + std::ptrdiff_t(v));
                facet = normal(facet);
                if (!boundary.insert(facet).second) boundary.erase(facet);
            }
            if (corners.size() != 2) return;
            double length2 = 0;
            for (std::size_t k = 0; k < d; ++k) {
                double x = points[std::size_t(corners[1][0]) * d + k] - points[std::size_t(corners[0][0]) * d + k];
                for (std::size_t j = 0; j < axes; ++j) x += double(corners[1][1 + j]) * lattice[j * d + k];
                length2 += x * x;
            }
            faults += engine.report().input.weighting == 0 && std::sqrt(length2) > 2 * simplex.value * (1 + 1e-14);
            for (std::size_t j = 0; j < axes; ++j) winding ^= unsigned(corners[1][1 + j] & 1) << j;
        });
        const bool lasts = bars[i].death == std::numeric_limits<double>::infinity();
        faults += simplices.empty() || !boundary.empty() || last != bars[i].birth;
        if (bars[i].degree != 1) continue;
        faults += !lasts && winding != 0;
        if (lasts) around.push_back(winding);
    }
    // Each sum of some of them goes around.
    faults += around.size() != axes;
    for (unsigned some = 1; some < 1u << around.size(); ++some) {
        unsigned sum = 0;
        for (std::size_t i = 0; i < around.size(); ++i) sum ^= (some >> i & 1) != 0 ? around[i] : 0;
        faults += sum == 0;
    }
    return faults;
}

}  // namespace

TEST_CASE("which basis, which copy, which order: the same bars, from one point to where copies are taken by margins") {
    for (const int dim : {2, 3})
        for (const std::size_t n : {1, 7, 60, 300, 1500}) {
            if (dim == 3 && n > 300) continue;
            const std::size_t d = static_cast<std::size_t>(dim);
            const Points points = on_grid(inputs::uniform(dim, n, n));
            Points lattice = cube(dim);
            lattice[d] = 0.25;  // not at right angles
            lattice[d * d - 1] = 1.5;
            Context a(block), b(block);
            REQUIRE(a.engine.persist(request_of(dim, points, lattice)) == NETMESH_OK);
            CHECK(report_of(a.engine).input.moved == 0);
            CHECK(report_of(a.engine).input.periods == d);
            const std::vector<Bar> bars = bars_of(a.engine);
            std::size_t lasting = 0;
            for (const Bar& bar : bars) lasting += bar.death == std::numeric_limits<double>::infinity();
            CHECK(lasting == std::size_t(1) << dim);  // of the torus

            Points skew = lattice;  // another basis, left-handed
            for (std::size_t k = 0; k < d; ++k) {
                skew[k] += 3 * lattice[d + k];
                skew[d + k] = -lattice[d + k];
            }
            REQUIRE(b.engine.persist(request_of(dim, points, skew)) == NETMESH_OK);
            CHECK(bars_of(b.engine) == bars);

            Points copies = points;  // elsewhere, each by other periods, and the last first
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < d; ++j)
                    for (std::size_t k = 0; k < d; ++k)
                        copies[i * d + k] += static_cast<double>((i * (j + 3)) % 7) * lattice[j * d + k] - 0.375;
            for (std::size_t i = 0; i < n / 2; ++i)
                std::swap_ranges(copies.begin() + std::ptrdiff_t(i * d), copies.begin() + std::ptrdiff_t(i * d + d),
                                 copies.begin() + std::ptrdiff_t((n - 1 - i) * d));
            netmesh::Request other = request_of(dim, copies, lattice);
            other.seed = 77;
            REQUIRE(b.engine.persist(other) == NETMESH_OK);
            CHECK(bars_of(b.engine) == bars);

            const Points zero(n, 0.0);
            netmesh::Request weighted = request_of(dim, points, lattice);
            weighted.set_weights(&netmesh_weights, zero);
            REQUIRE(b.engine.persist(weighted) == NETMESH_OK);
            CHECK(bars_of(b.engine) == bars);
            CHECK(report_of(b.engine).input.weighting == NETMESH_WEIGHTING_WEIGHTS);
            CHECK(report_of(b.engine).input.squares == 0);
            weighted.set_weights(&netmesh_radii, zero).squares = 1;
            REQUIRE(b.engine.persist(weighted) == NETMESH_OK);
            CHECK(report_of(b.engine).input.weighting == NETMESH_WEIGHTING_RADII);
            CHECK(report_of(b.engine).input.squares == 1);
            other = request_of(dim, points, lattice);
            other.filter = &netmesh_filter_auto;
            REQUIRE(b.engine.persist(other) == NETMESH_OK);
            CHECK(bars_of(b.engine) == bars);
            CHECK(b.engine.report().diagram.why == NETMESH_WHY_ALONE);
        }
}

TEST_CASE("cycles: the same bars, closed modulo translations; loops that last go around") {
    for (const int dim : {2, 3, 4})
        for (const std::size_t n : {1, 6, 80, 700}) {
            if (n * (dim - 1) > 1500) continue;
            const std::size_t d = static_cast<std::size_t>(dim);
            Points points = on_grid(inputs::uniform(dim, n, n + 3)), lattice = cube(dim);
            lattice[d] = 3.25;                                                                   // not short
            for (std::size_t i = 0; i < points.size(); ++i) points[i] += double(i * 7 % 5) - 2;  // by whole periods
            if (n == 6) lattice.resize(d);                                                       // one period
            Context a(block), b(block);
            netmesh::Request request = request_of(dim, points, lattice);
            REQUIRE(a.engine.persist(request) == NETMESH_OK);
            request.cycles = &netmesh_cycles;
            REQUIRE(b.engine.persist(request) == NETMESH_OK);
            CHECK(bars_of(a.engine) == bars_of(b.engine));
            CHECK(a.engine.report().fingerprint == b.engine.report().fingerprint);
            CHECK(faults_of_cycles(b.engine, dim, points, lattice) == 0);
            // Later there are none, and what is there stays.
            netmesh::Request more(&netmesh_filter_alpha);
            more.cycles = &netmesh_cycles;
            CHECK(a.engine.persist(more) == NETMESH_NO_RESULT);
            CHECK(bars_of(a.engine) == bars_of(b.engine));
        }
}

TEST_CASE("no bar of points that repeat is born at minus infinity") {
    Context c(block);
    const Points points = {0, 0, 0.5, 0.25}, lattice = cube(2), radii = {0, 1e155};
    netmesh::Request request = request_of(2, points, lattice);
    request.set_weights(&netmesh_radii, radii);
    CHECK(c.engine.persist(request) == NETMESH_OK);
    request.squares = 1;
    CHECK(c.engine.persist(request) == NETMESH_INVALID_ARGUMENT);
    CHECK(c.engine.detail().field == NETMESH_FIELD_WEIGHTS);
    CHECK(c.engine.detail().index_a == 1);
    const Points far = {1e100, 0, 0, 1e100};  // refused for itself
    netmesh::Request wide = request_of(2, points, far);
    wide.set_weights(&netmesh_radii, radii).squares = 1;
    CHECK(c.engine.persist(wide) == NETMESH_OUT_OF_RANGE);
}

TEST_CASE("a cycle cannot say translations of 2^30 and more") {
    const Points points = {0.25, 0.5, 0.25 + 0x1p31, 0.75}, lattice = cube(2);
    Context c(block);
    netmesh::Request request = request_of(2, points, lattice);
    REQUIRE(c.engine.persist(request) == NETMESH_OK);
    request.cycles = &netmesh_cycles;
    CHECK(c.engine.persist(request) == NETMESH_OUT_OF_RANGE);
    CHECK(c.engine.detail().index_a == 1);
    CHECK(report_of(c.engine).input.present == 0);
}

TEST_CASE("a large void, a cluster, a grid and one point: the same bars by another basis") {
    for (int kind = 0; kind < 4; ++kind) {
        Points points = on_grid(inputs::uniform(3, 900, 5));
        if (kind == 0) {  // none in a ball of radius 0.4
            Points kept;
            for (std::size_t i = 0; i < points.size(); i += 3) {
                double away2 = 0;
                for (std::size_t k = 0; k < 3; ++k) away2 += (points[i + k] - 0.5) * (points[i + k] - 0.5);
                if (away2 > 0.16) kept.insert(kept.end(), &points[i], &points[i] + 3);
            }
            points = kept;
        } else if (kind == 1) {  // all but five in a corner
            for (std::size_t i = 0; i + 15 < points.size(); ++i) points[i] = std::floor(points[i] * 0x1p24) * 0x1p-30;
        } else if (kind == 2) {
            points.clear();
            for (int i = 0; i < 729; ++i)
                for (const int at : {i % 9, i / 9 % 9, i / 81}) points.push_back(at / 8.0);
            points.push_back(0.0625);
            points.push_back(0.0625);
            points.push_back(0.0625);
        }
        const double side = kind == 2 ? 1.125 : 1;
        const Points lattice = cube(3, side), other = {side, 0, 0, side, side, 0, -side, 2 * side, -side};
        Context a(block), b(block);
        netmesh::Request first = request_of(3, points, lattice), second = request_of(3, points, other);
        Points radii;
        if (kind == 3) {
            radii = inputs::uniform(1, points.size() / 3, 8);
            for (double& r : radii) r *= 0.2;
            first.set_weights(&netmesh_radii, radii);
            second.set_weights(&netmesh_radii, radii);
        }
        REQUIRE(a.engine.persist(first) == NETMESH_OK);
        REQUIRE(b.engine.persist(second) == NETMESH_OK);
        CHECK(bars_of(a.engine) == bars_of(b.engine));
        CHECK(hidden_of(a.engine) == hidden_of(b.engine));
        CHECK(hidden_of(a.engine).empty() == (kind != 3));
        const netmesh_input_report input = report_of(a.engine).input;
        CHECK(input.distinct + input.duplicates + input.hidden == input.points);
    }
}

TEST_CASE("one axis with a period: as a strip of many copies has it inside") {
    // A loop around that is there at half of the period, and those of the strip that do not go around.
    Points points = on_grid(inputs::uniform(2, 400, 3));
    const Points one = {1, 0};
    Context c(block);
    REQUIRE(c.engine.persist(request_of(2, points, one)) == NETMESH_OK);
    std::size_t lasting[3] = {};
    std::vector<double> deaths;
    for (const Bar& bar : bars_of(c.engine)) {
        if (bar.death == std::numeric_limits<double>::infinity())
            ++lasting[bar.degree];
        else if (bar.degree == 1 && bar.death > 0.03)
            deaths.push_back(bar.death);
    }
    CHECK(lasting[0] == 1);
    CHECK(lasting[1] == 1);
    CHECK(lasting[2] == 0);
    Points strip;
    for (int k = -5; k <= 5; ++k)
        for (std::size_t i = 0; i < points.size(); i += 2) {
            strip.push_back(points[i] + k);
            strip.push_back(points[i + 1]);
        }
    netmesh::Request plain(&netmesh_filter_alpha);
    plain.set_points(2, strip);
    Context s(block);
    REQUIRE(s.engine.persist(plain) == NETMESH_OK);
    // Each loop of a period is there eleven times but near the ends.
    for (const double death : deaths) {
        std::size_t times = 0;
        for (const Bar& bar : bars_of(s.engine)) times += bar.degree == 1 && bar.death == death;
        CHECK(times >= 9);
    }
}

TEST_CASE("few points far above a strip: balls beyond the hull want copies far along") {
    // Between the upper points centres are above all points, and what counts is their part within.
    for (const std::uint64_t seed : {1, 2, 3}) {
        Points points = inputs::uniform(2, 200, seed);
        for (std::size_t i = 0; i < points.size(); i += 2) points[i] *= 64;
        for (const double x : {3.0, 25.0, 41.0}) {
            points.push_back(x + static_cast<double>(seed));
            points.push_back(4);
        }
        points = on_grid(points);
        const Points along = {64, 0};
        Context a(block), b(block);
        REQUIRE(a.engine.persist(request_of(2, points, along)) == NETMESH_OK);
        CHECK(report_of(a.engine).input.copies > 100);
        for (int k = 1; k < 8; ++k) {  // cut elsewhere
            Points moved = points;
            for (std::size_t i = 0; i < moved.size(); i += 2) moved[i] += 8 * k;
            REQUIRE(b.engine.persist(request_of(2, moved, along)) == NETMESH_OK);
            CHECK(bars_of(b.engine) == bars_of(a.engine));
        }
    }
}

TEST_CASE("floats, rows apart, and equal copies") {
    const std::vector<float> rows = {0.25f, 0.5f, -1, 1.25f, 2.5f, -1, 0.75f, 0.125f, -1};
    const Points exact = {0.25, 0.5, 0.75, 0.125}, lattice = cube(2);
    Context a(block), b(block);
    netmesh::Request floats(&netmesh_filter_alpha);
    floats.points.coordinates = rows.data();
    floats.points.count = 3;
    floats.points.dim = 2;
    floats.points.format = NETMESH_POINTS_FLOAT32;
    floats.points.stride_bytes = 12;
    floats.set_lattice(lattice);
    REQUIRE(a.engine.persist(floats) == NETMESH_OK);
    REQUIRE(b.engine.persist(request_of(2, exact, lattice)) == NETMESH_OK);
    CHECK(bars_of(a.engine) == bars_of(b.engine));
    CHECK(report_of(a.engine).input.duplicates == 1);
    CHECK(report_of(a.engine).input.distinct == 2);
}

TEST_CASE("refusals") {
    const Points points = inputs::uniform(3, 20);
    Context c(block);
    const auto refused = [&](const netmesh::Request& request, netmesh_field field) {
        CHECK(c.engine.persist(request) == NETMESH_INVALID_ARGUMENT);
        CHECK(c.engine.detail().field == field);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    Points lattice = cube(3);
    netmesh::Request request = request_of(3, points, lattice);
    for (const double bad : {nan, inf}) {
        lattice[4] = bad;
        refused(request, NETMESH_FIELD_LATTICE);
        CHECK(c.engine.detail().index_a == 1);
    }
    lattice = {1, 0, 0, 0, 1, 0, 2, 3, 0};  // flat
    request = request_of(3, points, lattice);
    refused(request, NETMESH_FIELD_LATTICE);
    CHECK(c.engine.detail().index_a == 2);
    lattice = {0, 0, 0};
    refused(request_of(3, points, lattice), NETMESH_FIELD_LATTICE);
    CHECK(c.engine.detail().index_a == 0);
    lattice = {1, 0, 0, 1, 0x1p-50, 0, 0, 0, 1};  // a difference of vectors is shorter than 2^-45 of others
    refused(request_of(3, points, lattice), NETMESH_FIELD_LATTICE);
    CHECK(c.engine.detail().index_a == 1);
    for (const double far : {1e200, 1e-200}) {
        lattice = cube(3, far);
        CHECK(c.engine.persist(request_of(3, points, lattice)) == NETMESH_OUT_OF_RANGE);
    }
    lattice = cube(3);
    request = request_of(3, points, lattice);
    struct AlignedDouble {
        char before;
        double x;
    };
    for (const std::size_t by : {std::size_t(1), offsetof(AlignedDouble, x) / 2}) {
        request.points.lattice =
            reinterpret_cast<const double*>(reinterpret_cast<const unsigned char*>(lattice.data()) + by);
        refused(request, NETMESH_FIELD_LATTICE);
    }
    request.points.lattice = lattice.data();
    request.points.lattice_count = 4;
    refused(request, NETMESH_FIELD_LATTICE_COUNT);
    request.points.lattice_count = 0;
    refused(request, NETMESH_FIELD_LATTICE_COUNT);
    request.points.lattice_count = 3;
    request.points.lattice = nullptr;
    refused(request, NETMESH_FIELD_LATTICE);
    request.points.lattice = lattice.data();
    request.periods = nullptr;
    refused(request, NETMESH_FIELD_PERIODS);
    request.periods = &netmesh_periodic;
    request.keep_mesh = 1;
    refused(request, NETMESH_FIELD_KEEP_MESH);
    request.keep_mesh = 0;
    request.bounds = &netmesh_bounds;
    refused(request, NETMESH_FIELD_BOUNDS);
    request.bounds = nullptr;
    for (const netmesh_filter* filter : {&netmesh_filter_rips, &netmesh_filter_cech, &netmesh_filter_complete}) {
        request.filter = filter;
        refused(request, NETMESH_FIELD_PERIODS);
    }
    request.filter = &netmesh_filter_alpha;
    CHECK(c.engine.mesh(request) == NETMESH_INVALID_ARGUMENT);
    CHECK(c.engine.detail().field == NETMESH_FIELD_PERIODS);
    REQUIRE(c.engine.persist(request) == NETMESH_OK);
    // Rows.
    Points wrong = points;
    wrong[3 * 7 + 1] = nan;
    CHECK(c.engine.persist(request_of(3, wrong, lattice)) == NETMESH_NOT_FINITE);
    CHECK(c.engine.detail().index_a == 7);
    wrong[3 * 7 + 1] = 1e16;
    CHECK(c.engine.persist(request_of(3, wrong, lattice)) == NETMESH_OUT_OF_RANGE);
    CHECK(c.engine.detail().index_a == 7);
    Points radii(20, 0.1);
    radii[3] = -0.1;
    request.set_weights(&netmesh_radii, radii);
    refused(request, NETMESH_FIELD_WEIGHTS);
    CHECK(c.engine.detail().index_a == 3);
    // A plane that repeats in itself.
    const Points plane = {0, 0, 0, 0.5, 0.25, 0}, two = {1, 0, 0, 0, 1, 0};
    CHECK(c.engine.persist(request_of(3, plane, two)) == NETMESH_FLAT);
}

TEST_CASE("a skew basis costs no digits") {
    // Found by a second reading: lattices whose short vectors are differences of long ones.
    for (const double skew : {1e3, 1e6, 1e9, 1e12}) {
        const Points one = {0.1, 0.2}, lattice = {0.7, 0, 0.7 * skew + 0.3, 0.9};
        // Of the vectors as doubles.
        const double second = lattice[2] - std::nearbyint(lattice[2] / 0.7) * 0.7;
        Context c(block);
        REQUIRE(c.engine.persist(request_of(2, one, lattice)) == NETMESH_OK);
        const double moved = report_of(c.engine).input.moved;
        CHECK(moved < 1e-14);
        std::vector<double> births;
        for (const Bar& bar : bars_of(c.engine))
            if (bar.degree == 1 && bar.death == std::numeric_limits<double>::infinity()) births.push_back(bar.birth);
        REQUIRE(births.size() == 2);
        CHECK(std::fabs(births[0] - 0.35) < 1e-14);
        if (skew < 1e4) CHECK(std::fabs(births[1] - 0.5 * std::hypot(second, 0.9)) < 1e-12);
    }
    const Points grid = {0.25, 0.5, 0.125, 0.75}, skew = {1, 0, 1e12, 1};
    Context a(block), b(block);
    REQUIRE(a.engine.persist(request_of(2, grid, skew)) == NETMESH_OK);
    REQUIRE(b.engine.persist(request_of(2, grid, cube(2))) == NETMESH_OK);
    CHECK(report_of(a.engine).input.moved == 0);
    CHECK(bars_of(a.engine) == bars_of(b.engine));
}

TEST_CASE("halves to eighths and thirds of vectors stay what they are") {
    for (const double side : {10.86, 2.87, 5.43, 0.1, 3.7e5, 1.0})
        for (const int parts : {2, 3, 4, 6, 8}) {
            Points points;
            for (int i = 0; i < parts * parts; ++i)
                for (const int at : {i % parts, i / parts}) points.push_back(at / static_cast<double>(parts) * side);
            Context c(block);
            REQUIRE(c.engine.persist(request_of(2, points, cube(2, side))) == NETMESH_OK);
            double first = 0;
            for (const Bar& bar : bars_of(c.engine)) {
                if (bar.degree > 0 || bar.death == std::numeric_limits<double>::infinity()) continue;
                if (first == 0) first = bar.death;
                CHECK(bar.death == first);
            }
            CHECK(std::fabs(first - side / parts / 2) < 1e-14 * side);
            CHECK(report_of(c.engine).input.moved < 1e-14 * side);
        }
}

TEST_CASE("the middle of a skew cell stays its middle") {
    // It is as far from one corner as from the opposite one, to the last bit.
    inputs::Random random(4);
    for (int i = 0; i < 40; ++i) {
        const double side = 1 + random.uniform(), turn = 0.3 * random.uniform();
        const Points lattice = {side, turn, side * (0.2 + 0.3 * random.uniform()),
                                side * (0.8 + 0.4 * random.uniform())};
        const Points points = {0, 0, 0.5 * (lattice[0] + lattice[2]), 0.5 * (lattice[1] + lattice[3])};
        Context c(block);
        REQUIRE(c.engine.persist(request_of(2, points, lattice)) == NETMESH_OK);
        double joined = 0, loop = std::numeric_limits<double>::infinity();
        for (const Bar& bar : bars_of(c.engine)) {
            if (bar.degree == 0 && bar.death < std::numeric_limits<double>::infinity()) joined = bar.death;
            if (bar.degree == 1 && bar.birth < loop) loop = bar.birth;
        }
        CHECK(joined == loop);
    }
}

TEST_CASE("far points: taken near, or refused by row") {
    const Points points = {0.25, 0.5, 0.25 + 3e9, 0.75 - 4e8}, near = {0.25, 0.5, 0.25, 0.75};
    Context a(block), b(block);
    REQUIRE(a.engine.persist(request_of(2, points, cube(2))) == NETMESH_OK);
    REQUIRE(b.engine.persist(request_of(2, near, cube(2))) == NETMESH_OK);
    CHECK(bars_of(a.engine) == bars_of(b.engine));
    // Beside a lattice that is oblique to the axes copies have few digits left.
    Points beside = {0, 0, 0.2, 0.3, 0.4, 1e6};
    const Points oblique = {1.05, 0.0731};
    REQUIRE(a.engine.persist(request_of(2, beside, oblique)) == NETMESH_OK);
    CHECK(report_of(a.engine).input.moved < 1e-9);
    beside[5] = 1e14;
    CHECK(a.engine.persist(request_of(2, beside, oblique)) == NETMESH_OUT_OF_RANGE);
    CHECK(a.engine.detail().index_a == 2);
    // As far beside an axis nothing is moved.
    REQUIRE(a.engine.persist(request_of(2, beside, Points{1, 0})) == NETMESH_OK);
}

TEST_CASE("every block: a diagram or out of memory") {
    for (int dim = 2; dim <= 3; ++dim)
        for (int kind = 0; kind < 4; ++kind) {
            const bool weighted = kind % 2 == 1, cycles = kind >= 2;
            const Points points = on_grid(inputs::uniform(dim, 40)), lattice = cube(dim);
            Points radii = inputs::uniform(1, 40, 9);
            for (double& r : radii) r *= 0.3;
            netmesh::Request request = request_of(dim, points, lattice);
            if (weighted) request.set_weights(&netmesh_radii, radii);
            request.cycles = cycles ? &netmesh_cycles : nullptr;
            Context whole(block);
            REQUIRE(whole.engine.persist(request) == NETMESH_OK);
            const std::vector<Bar> bars = bars_of(whole.engine);
            const std::vector<std::uint64_t> hidden = hidden_of(whole.engine);
            const std::size_t enough = report_of(whole.engine).memory.peak_bytes;
            CHECK(netmesh_plan(&request) >= enough);
            int fitted = 0, failed = 0;
            for (std::size_t bytes = 4096; bytes < enough + 20000; bytes += 16 * (dim == 2 ? 31 : 331)) {
                Context c(bytes);
                const netmesh_status status = c.engine.persist(request);
                if (status == NETMESH_OK) {
                    ++fitted;
                    CHECK(bars_of(c.engine) == bars);
                    CHECK(hidden_of(c.engine) == hidden);
                    if (cycles) CHECK(faults_of_cycles(c.engine, dim, points, lattice) == 0);
                } else {
                    ++failed;
                    REQUIRE(status == NETMESH_OUT_OF_MEMORY);
                    CHECK(report_of(c.engine).input.present == 0);
                }
            }
            CHECK(fitted > 0);
            CHECK(failed > 10);
            Context exact(enough);
            CHECK(exact.engine.persist(request) == NETMESH_OK);
        }
}

TEST_CASE("every poll can stop it") {
    for (const bool cycles : {false, true}) {
        const Points points = on_grid(inputs::uniform(3, cycles ? 60 : 300)), lattice = cube(3);
        netmesh::Request request = request_of(3, points, lattice);
        request.cycles = cycles ? &netmesh_cycles : nullptr;
        Context c(block);
        kept::stop_at_every_poll(&c, request);
    }
}
