#include "filtration/circumsphere_fast.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <type_traits>

#include "complex/triangulations.hpp"

using namespace netmesh;
using netmesh_test::Random;

namespace {

using Points = std::vector<std::vector<double>>;

Circumsphere precise(const Points& points) {
    std::vector<const double*> address;
    for (const auto& p : points) address.push_back(p.data());
    return circumsphere_precise(address.data(), static_cast<int>(points.size()) - 1,
                                static_cast<int>(points[0].size()));
}

template <int K, int D> bool fast(const Points& points, Circumsphere* out) {
    std::vector<const double*> address;
    for (const auto& p : points) address.push_back(p.data());
    return circumsphere_fast<K, D>(address.data(), out);
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double s = 0;
    for (std::size_t d = 0; d < a.size(); ++d) s += (a[d] - b[d]) * (a[d] - b[d]);
    return std::sqrt(s);
}

Points scaled(Points points, double by, double shift = 0) {
    for (auto& p : points)
        for (double& x : p) x = x * by + shift;
    return points;
}

// k+1 unit vectors: the regular simplex of edge sqrt 2.
Points regular(int k, int dim) {
    Points points(static_cast<std::size_t>(k + 1), std::vector<double>(static_cast<std::size_t>(dim)));
    for (int i = 0; i <= k && i < dim; ++i) points[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)] = 1;
    if (k == dim)  // the last vertex on the diagonal
        for (double& x : points.back()) x = (1 - std::sqrt(dim + 1.0)) / dim;
    return points;
}

template <int K, int D> void compare_both(double flatten) {
    CAPTURE(K);
    CAPTURE(D);
    Random random;
    int decided = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        Points points(K + 1, std::vector<double>(D));
        for (auto& p : points)
            for (double& x : p) x = random.unit();
        for (auto& p : points) p[D - 1] *= flatten;
        Circumsphere a, b = precise(points);
        if (!fast<K, D>(points, &a)) continue;
        ++decided;
        CHECK(a.within == b.within);
        CHECK(std::fabs(a.radius - b.radius) <= radius_error<K, D>(a.volume) * b.radius);
        CHECK(radius_error<K, D>(a.volume) < 0x1p-28);
    }
    if (flatten == 1) CHECK(decided > 1500);
}

// Both of two simplices by themselves and at the same time: the same bits, and certain of the same.
template <int K, int D> void compare_pairs(double flatten, double size) {
    CAPTURE(K);
    CAPTURE(D);
    Random random;
    for (int trial = 0; trial < 1000; ++trial) {
        Points points[2];
        const double* address[2][K + 1];
        for (int i = 0; i < 2; ++i) {
            points[i].assign(K + 1, std::vector<double>(D));
            for (auto& p : points[i])
                for (double& x : p) x = trial % 3 == 0 ? random.below(3) * size : random.unit() * size;
            for (auto& p : points[i]) p[D - 1] *= i == 0 ? flatten : 1;
            for (std::size_t j = 0; j <= K; ++j) address[i][j] = points[i][j].data();
        }
        Circumsphere both[2], alone;
        const std::uint32_t known = circumspheres_fast<K, D>(address, both);
        for (std::uint32_t i = 0; i < 2; ++i) {
            const bool certain = fast<K, D>(points[i], &alone);
            CHECK(certain == ((known >> i & 1u) != 0));
            if (!certain) continue;
            CHECK(alone.radius == both[i].radius);
            CHECK(alone.within == both[i].within);
            CHECK(alone.volume == both[i].volume);
        }
        CHECK(known < 4);
    }
}

}  // namespace

TEST_CASE("two spheres at a time are those of one after the other") {
    for (const double flatten : {1.0, 1e-3, 1e-6, 0.0}) {
        for (const double size : {1.0, 1e-40, 1e-70, 1e70}) {
            CAPTURE(flatten);
            CAPTURE(size);
            compare_pairs<2, 2>(flatten, size);
            compare_pairs<2, 3>(flatten, size);
            compare_pairs<3, 3>(flatten, size);
            compare_pairs<2, 4>(flatten, size);
            compare_pairs<3, 4>(flatten, size);
            compare_pairs<4, 4>(flatten, size);
        }
    }
}

TEST_CASE("triangles whose answer is known") {
    CHECK(precise({{0, 0}, {4, 0}, {2, 3}}).radius == doctest::Approx(13.0 / 6).epsilon(1e-15));
    CHECK(precise({{0, 0}, {4, 0}, {2, 3}}).within == 0);
    CHECK(precise({{0, 0}, {3, 0}, {0, 4}}).radius == 2.5);
    CHECK(precise({{0, 0}, {3, 0}, {0, 4}}).within == 1);  // on the sphere of the longest side
    CHECK(precise({{4, 0}, {0, 0}, {2, 1}}).radius == 2.5);
    CHECK(precise({{4, 0}, {0, 0}, {2, 1}}).within == 4);  // obtuse at the last vertex
    CHECK(precise({{2, 1, 7}, {4, 0, 7}, {0, 0, 7}}).radius == 2.5);
    CHECK(precise({{2, 1, 7}, {4, 0, 7}, {0, 0, 7}}).within == 1);
    CHECK(precise({{1, 1}, {4, 5}}).radius == 2.5);
}

TEST_CASE("regular simplices") {
    for (int dim = 2; dim <= 6; ++dim)
        for (int k = 1; k <= dim; ++k) {
            const Circumsphere sphere = precise(regular(k, dim));
            CHECK(sphere.radius == doctest::Approx(std::sqrt(k / (k + 1.0))).epsilon(1e-14));
            CHECK(sphere.within == 0);
        }
}

TEST_CASE("a corner of a cube: every face with the origin has its apex opposite the origin on the sphere") {
    for (int dim = 2; dim <= 6; ++dim) {
        Points points(static_cast<std::size_t>(dim + 1), std::vector<double>(static_cast<std::size_t>(dim), 0.1));
        for (int d = 0; d < dim; ++d)  // a monotone path along the axes
            for (int i = d + 1; i <= dim; ++i) points[static_cast<std::size_t>(i)][static_cast<std::size_t>(d)] += 0.25;
        const Circumsphere sphere = precise(points);
        CHECK(sphere.radius == doctest::Approx(std::sqrt(dim) / 8).epsilon(1e-15));
        CHECK(sphere.within == (1u << dim) - 2);  // all but the two ends of the diagonal
    }
}

TEST_CASE("the float stage agrees with the precise one wherever it decides") {
    for (double flatten : {1.0, 1e-2, 1e-4, 1e-6}) {
        CAPTURE(flatten);
        compare_both<2, 2>(flatten);
        compare_both<2, 3>(flatten);
        compare_both<3, 3>(flatten);
        compare_both<2, 4>(flatten);
        compare_both<3, 4>(flatten);
        compare_both<4, 4>(flatten);
        compare_both<3, 5>(flatten);
        compare_both<5, 5>(flatten);
        compare_both<3, 6>(flatten);
    }
    compare_both<6, 6>(1e-4);
}

// The flatter, the more digits are lost: what is accepted at the limit has to be as good as what is round.
TEST_CASE("the float stage is as good as it says just before it leaves flat simplices to the precise one") {
    const auto worst = [](auto k, auto d, int flatten) {
        constexpr int K = decltype(k)::value, D = decltype(d)::value;
        Random random;
        double error = 0;
        int decided = 0;
        for (int trial = 0; trial < 1000; ++trial) {
            Points points(K + 1, std::vector<double>(D));
            for (auto& p : points)
                for (double& x : p) x = random.unit();
            // Towards a plane that is askew, so that all coordinates are of one size and lose digits.
            for (auto& p : points) {
                double along = 0, length2 = 0;
                for (std::size_t d = 0; d < D; ++d) {
                    along += (1 + 0.375 * double(d)) * p[d];
                    length2 += (1 + 0.375 * double(d)) * (1 + 0.375 * double(d));
                }
                for (std::size_t d = 0; d < D; ++d)
                    p[d] -= (1 - std::ldexp(1.0, -flatten)) * along / length2 * (1 + 0.375 * double(d));
            }
            Circumsphere a, b = precise(points);
            if (!fast<K, D>(points, &a)) continue;
            ++decided;
            CHECK(a.within == b.within);
            error = std::max(error, std::fabs(a.radius - b.radius) / b.radius);
        }
        CHECK((flatten > 4 || decided > 300));
        return error;
    };
    using Two = std::integral_constant<int, 2>;
    using Three = std::integral_constant<int, 3>;
    for (int flatten = 0; flatten < 26; ++flatten) {
        CAPTURE(flatten);
        CHECK(worst(Two(), Two(), flatten) <= 0x1p-38);
        CHECK(worst(Three(), Three(), flatten) <= 0x1p-38);
    }
}

TEST_CASE("the float stage leaves ties and flat simplices to the precise one") {
    Circumsphere sphere;
    CHECK(!fast<2, 2>({{0, 0}, {3, 0}, {0, 4}}, &sphere));
    CHECK(!fast<2, 2>({{0, 0}, {3, 0}, {1e-17, 4}}, &sphere));
    CHECK(!fast<2, 2>({{0, 0}, {3, 0}, {1, 1e-9}}, &sphere));
    CHECK(!fast<2, 2>(scaled({{0, 0}, {3, 0}, {1, 4}}, 1e-120), &sphere));
    CHECK(fast<2, 2>({{0, 0}, {3, 0}, {1, 4}}, &sphere));
}

TEST_CASE("near ties are told apart to the last bit of the coordinates") {
    CHECK(precise({{0, 0}, {3, 0}, {0x1p-60, 4}}).within == 0);
    CHECK(precise({{0, 0}, {3, 0}, {-0x1p-60, 4}}).within == 1);
    CHECK(precise({{1, 1}, {1 + 3 * 0x1p-51, 1}, {1 + 0x1p-51, 1 + 0x1p-52}}).within == 4);
}

TEST_CASE("radii of nearly flat simplices are right") {
    for (double h : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-20, 1e-25}) {
        CAPTURE(h);
        const Circumsphere low = precise({{-1, 0}, {1, 0}, {0, h}});
        CHECK(low.radius == doctest::Approx((1 + h * h) / (2 * h)).epsilon(1e-9));
        CHECK(low.within == 4);
        // An isosceles needle: the foot of its long axis is off the middle by nothing.
        const Circumsphere thin = precise({{0, h}, {0, -h}, {1, 0}});
        CHECK(thin.radius == doctest::Approx((1 + h * h) / 2).epsilon(1e-15));
        if (h > 1e-23) CHECK(thin.within == 0);  // below, its centre lies on two of its sides
        // A sliver: four points near the equator of the unit sphere.
        const Circumsphere sliver = precise({{1, 0, h}, {-1, 0, h}, {0, 1, -h}, {0, -1, -h}});
        CHECK(sliver.radius == doctest::Approx(std::sqrt(1 + h * h)).epsilon(1e-14));
    }
}

TEST_CASE("a vertex off a nearly straight triangle is seen to be outside its large sphere") {
    // The triangle's centre is at x = -2^49; the last vertex lies half a unit outside its sphere, so that the cell's
    // centre moves by 2^48, little against the coefficients of the triangle.
    const Circumsphere sphere = precise({{0, 0, -1}, {0, 0, 1}, {0x1p-50, 0, 0}, {0.5, 1, 0}});
    CHECK((sphere.within & 8u) == 0);
    CHECK(sphere.radius == doctest::Approx(std::sqrt(1.25) * 0x1p49).epsilon(1e-12));
}

TEST_CASE("beyond all precision a flat simplex is huge and has the signs of the limit") {
    for (double h : {1e-40, 1e-200, 1e-300}) {
        CAPTURE(h);
        const Circumsphere flat = precise({{-1, 0}, {1, 0}, {0.25, h}});
        CHECK(flat.radius > 1e25);
        CHECK(std::isfinite(flat.radius));
        CHECK(flat.within == 4);
        const Circumsphere other = precise({{0.25, h}, {1, 0}, {-1, 0}});
        CHECK(other.within == 1);
    }
}

TEST_CASE("any finite size of the coordinates") {
    const Points obtuse = {{4, 0, 0}, {0, 0, 0}, {2, 1, 0}};
    for (double size : {1e-320, 1e-307, 1e-200, 1e-100, 1e100, 1e200, 1e306}) {
        CAPTURE(size);
        const Circumsphere sphere = precise(scaled(obtuse, size));
        CHECK(sphere.radius == doctest::Approx(2.5 * size).epsilon(size < 1e-300 ? 1e-3 : 1e-14));
        CHECK(sphere.within == 4);
    }
    const Circumsphere wide = precise({{-1.7e308, 0}, {1.7e308, 0}, {0, 1e308}});
    CHECK(wide.within == 4);
    CHECK(wide.radius == std::numeric_limits<double>::max());
    // Distances of very different size in one simplex: the long edges are halved, the apex angle is a right one or
    // less.
    const Circumsphere spread = precise({{0, 0}, {0, 1e-200}, {1e100, 0}});
    CHECK(spread.radius == doctest::Approx(0.5e100).epsilon(1e-14));
    CHECK((spread.within & 5u) == 1);  // that the second vertex is outside its facet's sphere cannot be seen
}

TEST_CASE("the centre is as far from every vertex, whatever their order") {
    Random random;
    for (int trial = 0; trial < 500; ++trial) {
        Points points(4, std::vector<double>(3));
        for (auto& p : points)
            for (double& x : p) x = random.unit();
        const Circumsphere sphere = precise(points);
        Points turned = {points[2], points[0], points[3], points[1]};
        const Circumsphere again = precise(turned);
        CHECK(again.radius == doctest::Approx(sphere.radius).epsilon(1e-15));
        const std::uint32_t order[4] = {2, 0, 3, 1};
        for (int i = 0; i < 4; ++i) CHECK((again.within >> i & 1u) == (sphere.within >> order[i] & 1u));
        // A diametral ball of an edge is the least of all spheres through its ends.
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j)
                CHECK(sphere.radius >= distance(points[i], points[j]) / 2 * (1 - 1e-15));
    }
}

TEST_CASE("how far a radius is from that of the smallest enclosing ball") {
    const auto error = [](const std::vector<std::vector<double>>& points, double radius) {
        std::vector<const double*> at;
        for (const std::vector<double>& p : points) at.push_back(p.data());
        return netmesh::enclosing_error(at.data(), static_cast<int>(points.size()) - 1,
                                        static_cast<int>(points[0].size()), radius);
    };
    // Obtuse, right, on a line, and regular; a needle 2^-40 thin far from the origin; a sliver that holds its centre.
    const double far = 0x1p20, thin = 0x1p-32;
    const std::vector<std::pair<std::vector<std::vector<double>>, double>> known = {
        {{{0, 0}, {1, 0}, {0.5, 0.1}}, 0.5},
        {{{0, 0}, {4, 0}, {0, 3}}, 2.5},
        {{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, 1.5 * std::sqrt(3.0)},
        {{{0, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 1, 0}, {0, 1, 1, 0}}, std::sqrt(0.75)},
        {{{far, far}, {far + 1, far}, {far + 1, far + thin}}, 0.5},
        {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0x1p-40}, {0, -1, 0x1p-40}}, 1}};
    for (const auto& [points, radius] : known) {
        CAPTURE(radius);
        CHECK(error(points, radius) < 0x1p-49);
        for (const double wrong : {1e-12, -1e-12, 1e-3, -1e-3}) {
            const double found = error(points, radius * (1 + wrong));
            CHECK(found >= std::fabs(wrong) * (1 - 1e-2));
            CHECK(found <= std::fabs(wrong) * (1 + 1e-2) + 0x1p-49);
        }
    }
    CHECK(error({{0, 0}, {1e-300, 0}, {0, 1e-300}}, 1e-300) == netmesh::infinity);
}
