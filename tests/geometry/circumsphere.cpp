// Smallest circumspheres against rational arithmetic: the radius rounded to nearest, signs, what the float stage says
// that it is certain of, and the exact stage alone.
#include "geometry/circumsphere_close.hpp"
#include "geometry/circumsphere_exact.hpp"
#include "geometry/circumsphere_fast.hpp"
#include "geometry/half_distance.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>
#include <iterator>
#include <limits>

#include "complex/triangulations.hpp"
#include "geometry/middles.hpp"

using namespace netmesh;
using netmesh_test::Random;

namespace {

using Point = std::vector<double>;
using Points = std::vector<Point>;

// The exact answer. Flat simplices have none.
struct Truth {
    bool flat = false;
    mpq_class squared;
    std::uint32_t within = 0;
};

Truth truth_of(const Points& points) {
    const std::size_t k = points.size() - 1, dim = points[0].size();
    std::vector<std::vector<mpq_class>> edge(k, std::vector<mpq_class>(dim)), m(k, std::vector<mpq_class>(k + 1));
    for (std::size_t i = 0; i < k; ++i)
        for (std::size_t d = 0; d < dim; ++d) edge[i][d] = mpq_class(points[i + 1][d]) - mpq_class(points[0][d]);
    for (std::size_t i = 0; i < k; ++i) {
        for (std::size_t j = 0; j < k; ++j)
            for (std::size_t d = 0; d < dim; ++d) m[i][j] += edge[i][d] * edge[j][d];
        m[i][k] = m[i][i] / 2;
    }
    const std::vector<std::vector<mpq_class>> gram = m;
    for (std::size_t i = 0; i < k; ++i) {
        std::size_t pivot = i;
        while (pivot < k && m[pivot][i] == 0) ++pivot;
        if (pivot == k) return {true, {}, 0};
        std::swap(m[i], m[pivot]);
        for (std::size_t r = 0; r < k; ++r) {
            if (r == i || m[r][i] == 0) continue;
            const mpq_class f = m[r][i] / m[i][i];
            for (std::size_t j = i; j <= k; ++j) m[r][j] -= f * m[i][j];
        }
    }
    Truth truth;
    mpq_class first = 1;
    for (std::size_t i = 0; i < k; ++i) {
        const mpq_class beta = m[i][k] / m[i][i];
        first -= beta;
        if (beta <= 0) truth.within |= 2u << i;
        truth.squared += beta * gram[i][i] / 2;
    }
    if (first <= 0) truth.within |= 1;
    return truth;
}

// Whether x is the root of the number rounded to nearest, ties to even: compared with the midpoints around it.
bool is_nearest_root(double x, const mpq_class& squared) {
    const double largest = std::numeric_limits<double>::max();
    const auto midpoint = [&](double low, double high) {
        mpq_class middle = (mpq_class(low) + (high <= largest ? mpq_class(high) : mpq_class(mpz_class(1) << 1024))) / 2;
        return mpq_class(middle * middle);
    };
    const bool even = (bits_of(x) & 1) == 0;
    if (x <= largest) {
        const mpq_class above = midpoint(x, std::nextafter(x, HUGE_VAL));
        if (squared > above || (squared == above && !even)) return false;
    }
    if (x == 0) return true;
    const mpq_class below = midpoint(std::nextafter(x, 0.0), x);
    return squared > below || (squared == below && even);
}

struct Tally {
    int signs = 0, radii = 0, close_signs = 0, close_radii = 0, all = 0;
};

ExactSphere exact_sphere(const Points& points) {
    const double* address[7] = {};
    for (std::size_t i = 0; i < points.size(); ++i) address[i] = points[i].data();
    return ExactSphere(address, static_cast<int>(points.size()) - 1, static_cast<int>(points[0].size()));
}

void check_exact_stage(const Points& points, const Truth& truth) {
    const ExactSphere sphere = exact_sphere(points);
    const bool always = points[0].size() <= 3;  // the range of doubles is in that of the table of primes
    if (!sphere.in_range()) {
        CHECK(!always);
        return;
    }
    // No question takes more scratch than it says.
    constexpr std::uint64_t guard = 0x5AC3A55AC35AC3A5u;
    REQUIRE(sphere.words() <= ExactSphere::room(static_cast<int>(points[0].size())));
    std::vector<std::uint64_t> scratch(sphere.words() + 4, guard);
    std::uint32_t within = 99;
    CHECK(sphere.find_within(scratch.data(), &within) == !truth.flat);
    if (truth.flat) return;
    CHECK(within == truth.within);
    double radius = -1;
    if (sphere.find_radius(scratch.data(), &radius))
        CHECK(is_nearest_root(radius, truth.squared));
    else
        CHECK(points[0].size() >= 3);
    for (std::size_t i = sphere.words(); i < scratch.size(); ++i) CHECK(scratch[i] == guard);
}

void check_close_look(const Points& points, const Truth& truth, Tally* tally) {
    const double* address[7] = {};
    for (std::size_t i = 0; i < points.size(); ++i) address[i] = points[i].data();
    Circumsphere close;
    const Certainty certain = look_closely(static_cast<std::uint32_t>(points.size() - 1),
                                           static_cast<std::uint32_t>(points[0].size()), address, &close);
    if (certain.within != 0) {
        ++tally->close_signs;
        REQUIRE(!truth.flat);
        CHECK(close.within == truth.within);
    }
    if (certain.radius != 0) {
        ++tally->close_radii;
        REQUIRE(!truth.flat);
        CHECK(is_nearest_root(close.radius, truth.squared));
    }
}

// A batch of simplices of one kind through both ways of the float stage.
template <int K, int D> void check(const std::vector<Points>& simplices, Tally* tally) {
    CAPTURE(K);
    CAPTURE(D);
    for (std::size_t at = 0; at < simplices.size(); at += 2) {
        const double *one[2][K + 1], *const *pair[2] = {one[0], one[1]};
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j <= K; ++j)
                one[i][j] = simplices[std::min(at + i, simplices.size() - 1)][j].data();
        Circumsphere both[2], alone;
        const Certainty two = circumspheres_fast<DoublePair, K, D>(K, D, pair, both);
        CHECK((two.within < 4 && two.radius < 4));
        for (std::size_t i = 0; i < 2 && at + i < simplices.size(); ++i) {
            const Points& points = simplices[at + i];
            const Truth truth = truth_of(points);
            const Certainty single = circumspheres_fast<double, any_dimension, any_dimension>(K, D, pair + i, &alone);
            CHECK(single.within == (two.within >> i & 1u));
            CHECK(single.radius == (two.radius >> i & 1u));
            ++tally->all;
            if (single.within != 0) {
                ++tally->signs;
                REQUIRE(!truth.flat);
                CHECK(both[i].within == truth.within);
                CHECK(alone.within == truth.within);
            }
            if (single.radius != 0) {
                ++tally->radii;
                REQUIRE(!truth.flat);
                CHECK(is_nearest_root(both[i].radius, truth.squared));
                CHECK(alone.radius == both[i].radius);
            }
            check_close_look(points, truth, tally);
            check_exact_stage(points, truth);
        }
    }
}

// Calls f(K, D) for simplices of all kinds.
template <class F> void each_kind(F f) {
    f(std::integral_constant<int, 2>(), std::integral_constant<int, 2>());
    f(std::integral_constant<int, 2>(), std::integral_constant<int, 3>());
    f(std::integral_constant<int, 3>(), std::integral_constant<int, 3>());
    if constexpr (dimension_most() >= 4) {
        f(std::integral_constant<int, 3>(), std::integral_constant<int, 4>());
        f(std::integral_constant<int, 4>(), std::integral_constant<int, 4>());
    }
    if constexpr (dimension_most() >= 6) {
        f(std::integral_constant<int, 2>(), std::integral_constant<int, 6>());
        f(std::integral_constant<int, 5>(), std::integral_constant<int, 5>());
        f(std::integral_constant<int, 6>(), std::integral_constant<int, 6>());
    }
}

double nudged(double x, std::uint64_t units) {
    for (; units > 0; --units) x = std::nextafter(x, 2.0);
    return x;
}

template <class Make>
void check_family(int trials, Make make, double* signs, double* radii, double* close_signs = nullptr,
                  double* close_radii = nullptr) {
    Tally tally;
    each_kind([&](auto k, auto d) {
        constexpr int K = decltype(k)::value, D = decltype(d)::value;
        std::vector<Points> simplices;
        for (int trial = 0; trial < trials; ++trial) {
            Points points(K + 1, Point(D));
            make(points, trial);
            simplices.push_back(points);
        }
        check<K, D>(simplices, &tally);
    });
    *signs = double(tally.signs) / tally.all;
    *radii = double(tally.radii) / tally.all;
    if (close_signs != nullptr) *close_signs = double(tally.close_signs) / tally.all;
    if (close_radii != nullptr) *close_radii = double(tally.close_radii) / tally.all;
}

}  // namespace

TEST_CASE("random simplices: radius and signs, nearly always without the exact stage") {
    Random random;
    double signs, radii;
    check_family(
        301,
        [&](Points& points, int) {
            for (Point& p : points)
                for (double& x : p) x = random.unit();
        },
        &signs, &radii);
    CHECK(signs > 0.98);
    CHECK(radii > 0.99);
}

// Towards a plane that is askew, so that all coordinates are of one size and lose digits.
TEST_CASE("flat simplices, until the float stage gives up") {
    for (int flatten = 2; flatten < 40; flatten += 3) {
        CAPTURE(flatten);
        Random random;
        double signs, radii, close_signs, close_radii;
        check_family(
            40,
            [&](Points& points, int) {
                const std::size_t dim = points[0].size();
                for (Point& p : points) {
                    double along = 0, length2 = 0;
                    for (std::size_t d = 0; d < dim; ++d) {
                        p[d] = random.unit();
                        along += (1 + 0.375 * double(d)) * p[d];
                        length2 += (1 + 0.375 * double(d)) * (1 + 0.375 * double(d));
                    }
                    for (std::size_t d = 0; d < dim; ++d)
                        p[d] -= (1 - std::ldexp(1.0, -flatten)) * along / length2 * (1 + 0.375 * double(d));
                }
            },
            &signs, &radii, &close_signs, &close_radii);
        if (flatten < 6) CHECK(radii > 0.5);
        // What the float stage gives up is left to twice the digits, and not to the exact stage.
        CHECK((flatten >= 30 || close_signs > 0.95));
        CHECK((flatten >= 27 || close_radii > 0.95));
    }
}

TEST_CASE("between the families: spheres, right angles, lattices and flats some units in the last place away") {
    Random random;
    double signs, radii;
    check_family(
        160,
        [&](Points& points, int trial) {
            double length = 0;
            for (Point& p : points) {
                switch (trial % 4) {
                case 0:
                    for (double& x : p) x = random.below(3) + 1.0;
                    break;
                case 1:
                    for (double& x : p) x = 0.1 * random.below(4);
                    break;
                case 2:
                    length = 0;
                    for (double& x : p) {
                        x = random.unit() - 0.5;
                        length += x * x;
                    }
                    for (double& x : p) x = x / std::sqrt(length) + 2;
                    break;
                default:
                    for (double& x : p) x = 1;
                }
                for (double& x : p) x = nudged(x, random.below(4));
            }
        },
        &signs, &radii);
    CHECK(signs > 0.2);
    CHECK(radii > 0.5);
}

TEST_CASE("any finite size, and mixed ones") {
    Random random;
    double signs, radii;
    check_family(
        48,
        [&](Points& points, int trial) {
            constexpr int size[] = {-1074, -1073, -1060, -1022, -540, -500, -210, -190, 190, 210, 500, 520, 900, 1022};
            for (Point& p : points)
                for (double& x : p) {
                    const int e = trial < 14 ? size[trial] : size[random.below(14)];
                    x = trial % 3 == 0 ? std::ldexp(double(random.below(5)), e < 1000 ? e : 1000)
                                       : std::ldexp(2 * random.unit() - 1, e);
                }
        },
        &signs, &radii);
    CHECK(radii < 0.5);
}

// Points next to one another on curves make flat simplices, whose circumsphere is far larger than they are.
TEST_CASE("simplices of points on curves") {
    Random random;
    double signs, radii, close_signs, close_radii;
    check_family(
        200,
        [&](Points& points, int trial) {
            const double step = std::ldexp(1.0, -2 - trial % 12);
            double t = random.unit();
            for (Point& p : points) {
                t += step * (0.5 + random.unit());
                for (std::size_t d = 0; d < p.size(); ++d)
                    p[d] = trial % 2 == 0 ? std::pow(t, double(d + 1))
                           : d % 2 == 0   ? std::cos(double(d / 2 + 1) * t)
                                          : std::sin(double(d / 2 + 1) * t);
            }
        },
        &signs, &radii, &close_signs, &close_radii);
    MESSAGE("float stage " << signs << ", " << radii << ", two doubles " << close_signs << ", " << close_radii);
    CHECK(close_signs > signs);
    CHECK(close_radii > radii);
}

TEST_CASE("answers that are known") {
    std::vector<std::uint64_t> scratch(ExactSphere::room(3));
    const auto known = [&](const Points& points, double radius, std::uint32_t within) {
        std::uint32_t found_within = 99;
        double found = -1;
        REQUIRE(exact_sphere(points).find_within(scratch.data(), &found_within));
        REQUIRE(exact_sphere(points).find_radius(scratch.data(), &found));
        CHECK(found == radius);
        CHECK(found_within == within);
    };
    known({{0, 0}, {3, 0}, {0, 4}}, 2.5, 1);  // on the sphere of the longest side
    known({{4, 0}, {0, 0}, {2, 1}}, 2.5, 4);  // obtuse at the last vertex
    known({{2, 1, 7}, {4, 0, 7}, {0, 0, 7}}, 2.5, 1);
    known({{0, 0}, {3, 0}, {0x1p-60, 4}}, 2.5, 0);
    known({{0, 0}, {3, 0}, {-0x1p-60, 4}}, 2.5, 1);
    known({{-1, 0}, {1, 0}, {0, 0x1p-200}}, 0x1p199, 4);
    // Beyond the largest double, and below the least one: half of it is a tie, and goes to 0.
    known({{-1, 0}, {1, 0}, {0, 0x1p-1040}}, std::numeric_limits<double>::infinity(), 4);
    known({{0, 0, 0}, {0x1p-1074, 0, 0}}, 0, 0);
    known({{0, 0, 0}, {3 * 0x1p-1074, 0, 0}}, 2 * 0x1p-1074, 0);
    std::uint32_t within;
    CHECK(!exact_sphere({{0, 0}, {1, 1}, {3, 3}}).find_within(scratch.data(), &within));
}

// Circumcentres half a unit and a little off: the squared radius (x + u / 2)^2 is a tie, which goes to even, and one
// quantum of a coordinate tells on which side of it another is.
TEST_CASE("radii at the middle between two doubles, and next to it") {
    std::vector<std::uint64_t> scratch(ExactSphere::room(2));
    for (int i = 0; i < 50; ++i) {
        const double x = 1 + i * 0x1p-52, half = 0x1p-53;
        for (const double off : {-0x1p-90, 0.0, 0x1p-90}) {
            // A right triangle, whose longest side is from (-x, off) to (x + 2 half, 0).
            const Points points = {{-x, 0}, {x + 2 * half, off}, {-x, off}};
            const Truth truth = truth_of(points);
            if (truth.flat) continue;
            double radius = -1;
            REQUIRE(exact_sphere(points).find_radius(scratch.data(), &radius));
            CHECK(is_nearest_root(radius, truth.squared));
        }
        const double a[] = {-x, 0}, b[] = {x + 2 * half, 0};
        CHECK(half_distance(2, a, b) == (i % 2 == 0 ? x : x + 2 * half));
    }
}

namespace {

// Simplices among the corners of a box, whose circumsphere is the box's: at one corner; apart from each other, where no
// edges are at right angles; and of three points, the longest side a diagonal.
template <int D> void check_boxes(const std::int64_t (*edges)[D], std::size_t count) {
    Tally tally;
    std::vector<Points> at_corner, apart, right;
    for (std::size_t i = 0; i < count; ++i)
        for (int turn = 0; turn < D; ++turn)
            for (const int scale : {0, -52, 300}) {
                double edge[D];
                for (int k = 0; k < D; ++k) edge[k] = std::ldexp(double(edges[i][(k + turn) % D]), scale);
                const auto corner = [&](unsigned which) {
                    Point x(D, 0.0);
                    for (int k = 0; k < D; ++k)
                        if (which >> k & 1u) x[static_cast<std::size_t>(k)] = edge[k];
                    return x;
                };
                const unsigned all = (1u << D) - 1;
                const Point low = corner(0), high = corner(all);
                mpq_class squared = 0;
                for (int k = 0; k < D; ++k) squared += mpq_class(edge[k]) * mpq_class(edge[k]) / 4;
                CHECK(is_nearest_root(half_distance(D, low.data(), high.data()), squared));
                CHECK(is_nearest_root(half_distance(D, high.data(), low.data()), squared));
                CHECK(is_nearest_root(exact_half_distance(D, low.data(), high.data()), squared));
                Points simplex = {low};
                for (int k = 0; k < D; ++k) simplex.push_back(corner(1u << k));
                at_corner.push_back(simplex);
                simplex = {low};
                for (int k = 1; k < D; ++k) simplex.push_back(corner(1u | 1u << k));
                simplex.push_back(corner(all & ~1u));
                if (D > 2) apart.push_back(simplex);
                right.push_back({low, high, corner(1u + static_cast<unsigned>(turn))});
            }
    check<D, D>(at_corner, &tally);
    if constexpr (D > 2) check<D, D>(apart, &tally);
    check<2, D>(right, &tally);
}

}  // namespace

TEST_CASE("radii of boxes whose diagonal is twice the middle between two doubles, or a hair more or less") {
    check_boxes<2>(netmesh_test::middle_2d, std::size(netmesh_test::middle_2d));
    check_boxes<3>(netmesh_test::middle_3d, std::size(netmesh_test::middle_3d));
    if constexpr (dimension_most() >= 4) check_boxes<4>(netmesh_test::middle_4d, std::size(netmesh_test::middle_4d));
}

TEST_CASE("half distances are rounded to nearest in any number of coordinates and at any size") {
    Random random;
    int fast = 0, all = 0;
    for (const std::size_t dim : {1u, 2u, 3u, 6u, 7u, 40u})
        for (int trial = 0; trial < 400; ++trial) {
            Point a(dim), b(dim);
            const int kind = trial % 8;
            constexpr int size[] = {-1074, -1070, -1000, -500, -400, 400, 600, 1023};
            for (std::size_t d = 0; d < dim; ++d) {
                a[d] = random.unit();
                b[d] = kind == 0 ? random.unit() : kind == 1 ? a[d] : nudged(0.1 * random.below(9), random.below(3));
                if (kind == 2) a[d] = nudged(0.1 * random.below(9), random.below(3));
                if (kind >= 3) {
                    a[d] = std::ldexp(2 * random.unit() - 1, size[trial / 8 % 8]);
                    b[d] = kind == 3 ? -a[d] : std::ldexp(2 * random.unit() - 1, size[(trial / 8 + kind) % 8]);
                }
            }
            if (kind == 1) b[random.below(static_cast<std::uint32_t>(dim))] += 3 * random.unit();
            mpq_class squared = 0;
            for (std::size_t d = 0; d < dim; ++d) {
                const mpq_class along = mpq_class(a[d]) - mpq_class(b[d]);
                squared += along * along / 4;
            }
            CAPTURE(dim);
            CAPTURE(trial);
            CHECK(is_nearest_root(half_distance(static_cast<int>(dim), a.data(), b.data()), squared));
            CHECK(is_nearest_root(exact_half_distance(static_cast<int>(dim), a.data(), b.data()), squared));
            double half;
            const auto difference = [&](std::uint32_t d) { return exact_difference(b[d], a[d]); };
            if (kind == 0) {
                ++all;
                fast +=
                    static_cast<int>(half_distances_fast<double>(static_cast<std::uint32_t>(dim), difference, &half));
            }
        }
    CHECK(fast == all);
}

namespace {

// Coordinates behind those that are there, so that the squared length comes as near to `squared` as doubles of six more
// coordinates do: below it, or with `over` above it.
void complete_length(const mpq_class& squared, bool over, Point* x) {
    mpq_class rest = squared;
    for (const double c : *x) rest -= mpq_class(c) * mpq_class(c);
    REQUIRE(rest > 0);
    for (int i = 0; i < 6 && rest > 0; ++i) {
        double c = std::sqrt(rest.get_d());
        while (mpq_class(c) * mpq_class(c) > rest) c = std::nextafter(c, 0.0);
        x->push_back(c);
        rest -= mpq_class(c) * mpq_class(c);
    }
    if (rest > 0 && !over) return;
    double& last = x->back();
    rest += mpq_class(last) * mpq_class(last);
    last = std::nextafter(last, over ? HUGE_VAL : 0.0);
    rest -= mpq_class(last) * mpq_class(last);
    REQUIRE(rest != 0);
    REQUIRE((rest < 0) == over);
}

}  // namespace

// Twice the middle between two doubles is the length, but for some 2^-300 of it.
TEST_CASE("half distances of many coordinates next to the middle between two doubles") {
    Random random;
    for (const std::size_t dim : {0u, 1u, 5u, 500u, 5000u, 50000u})
        for (int trial = 0; trial < (dim < 1000 ? 200 : 24); ++trial) {
            Point b;
            mpq_class squared = 0;
            for (std::size_t d = 0; d < dim; ++d) {
                b.push_back(random.unit());
                squared += mpq_class(b[d]) * mpq_class(b[d]);
            }
            const double x = trial % 3 == 0 ? std::ldexp(1.0, 9) : std::sqrt(squared.get_d()) / 2 + random.unit();
            const double next = std::nextafter(x, trial % 2 == 0 ? 0.0 : HUGE_VAL);
            const mpq_class length = mpq_class(x) + mpq_class(next);
            complete_length(length * length, trial / 6 % 2 == 0, &b);
            const Point a(b.size(), 0.0);
            const double half = half_distance(static_cast<int>(b.size()), a.data(), b.data());
            CAPTURE(dim);
            CAPTURE(trial);
            CHECK(half == (trial / 6 % 2 == 0 ? std::fmax(x, next) : std::fmin(x, next)));
        }
}

// Powers of two among them, below which doubles are twice as near to each other.
TEST_CASE("a root that is said to be known is that of all numbers within the slack") {
    Random random;
    int known = 0, all = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const double s = trial % 2 == 0 ? std::ldexp(1.0, trial % 40 - 20) : 1 + random.unit();
        const mpq_class aim = mpq_class(s) * (1 + mpq_class((2 * random.unit() - 1) * 0x1p-52));
        const mpq_class squared = aim * aim;
        double high = squared.get_d();  // towards 0
        if (mpq_class(std::nextafter(high, HUGE_VAL)) - squared < squared - mpq_class(high))
            high = std::nextafter(high, HUGE_VAL);
        const double low = mpq_class(squared - mpq_class(high)).get_d();
        if (high + low != high) continue;
        const double slack = high * std::ldexp(1 + random.unit(), -50 - static_cast<int>(random.below(50)));
        const NearestRoot<double> nearest = nearest_root(high, low, slack);
        ++all;
        if ((nearest.known & 1) == 0) continue;
        ++known;
        const mpq_class middle = mpq_class(high) + mpq_class(low);
        CAPTURE(trial);
        CHECK(is_nearest_root(nearest.root, middle - mpq_class(slack)));
        CHECK(is_nearest_root(nearest.root, middle + mpq_class(slack)));
    }
    CHECK(known > all / 2);
}

TEST_CASE("half distances along an axis whose whole does not fit a double") {
    const double a[] = {0x1.8p1023, 2}, b[] = {-0x1.4p1023, 2}, c[] = {3 * 0x1p-1074, 2}, d[] = {0, 2};
    CHECK(half_distance(2, a, b) == 0x1.6p1023);
    CHECK(half_distance(2, c, d) == 2 * 0x1p-1074);
    CHECK(exact_half_distance(2, a, b) == 0x1.6p1023);
}

TEST_CASE("a comparison out of range is said to be") {
    std::vector<std::uint64_t> scratch(ExactSphere::room(6));
    Points points(static_cast<std::size_t>(dimension_most()) + 1, Point(static_cast<std::size_t>(dimension_most()), 0));
    for (std::size_t i = 1; i < points.size(); ++i) points[i][i - 1] = i % 2 == 0 ? 0x1p1000 : 0x1.8p-1000;
    points[1][1] = 1;
    if (dimension_most() >= 4) CHECK(!exact_sphere(points).in_range());
    CHECK(exact_sphere({{0, 0}, {0x1p1000, 0}, {1, 0x1p-1000}}).in_range());
}
