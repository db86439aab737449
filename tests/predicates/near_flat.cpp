// Points next to a line of the plane, at sizes down to where products underflow: what floating point believes is so.
// And orientations in projections.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "predicates/oracle.hpp"
#include "predicates/predicates.hpp"

using namespace netmesh;

TEST_CASE("orientations of points next to a line, at every size") {
    inputs::Random random(9);
    PredicateCounts counts{};
    for (const int size : {0, 300, -300, -508, -510, -511, -512, -513, -514, -516, -520, -537}) {
        CAPTURE(size);
        int wrong = 0;
        for (int i = 0; i < 3000; ++i) {
            // c = a + t (b - a), rounded; coordinates of different exponents, so that differences round too.
            std::vector<oracle::Point> p(3, oracle::Point(2));
            const double t = 3 * random.uniform() - 1;
            for (int k = 0; k < 2; ++k) {
                const auto at = static_cast<std::size_t>(k);
                p[0][at] = random.uniform() * (i % 2 == 0 ? 1 : 0x1p-4);
                p[1][at] = random.uniform() * (i % 3 == 0 ? 1 : 0x1p-3);
                p[2][at] = p[0][at] + t * (p[1][at] - p[0][at]);
            }
            for (oracle::Point& x : p)
                for (double& c : x) c = std::ldexp(c, size);
            const double* const points[] = {p[0].data(), p[1].data(), p[2].data()};
            wrong += static_cast<int>(orient<2>(points, counts)) != oracle::orient(p);
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE_TEMPLATE_DEFINE("orientations in projections", T, projections) {
    constexpr int D = T::value;
    inputs::Random random(10);
    PredicateCounts counts{};
    for (int i = 0; i < 2000; ++i) {
        std::vector<oracle::Point> p(D + 1, oracle::Point(D));
        for (oracle::Point& x : p)
            for (double& c : x) c = static_cast<double>(random.below(i % 2 == 0 ? 4 : 1000));
        const int k = 1 + static_cast<int>(random.below(D));
        int axes[D];
        for (int j = 0; j < D; ++j) axes[j] = j;
        for (int j = 0; j < D; ++j)
            std::swap(axes[j], axes[j + static_cast<int>(random.below(static_cast<std::uint64_t>(D - j)))]);
        std::vector<oracle::Point> projected;
        std::vector<const double*> pointers;
        for (int v = 0; v <= k; ++v) {
            projected.emplace_back();
            for (int j = 0; j < k; ++j)
                projected.back().push_back(p[static_cast<std::size_t>(v)][static_cast<std::size_t>(axes[j])]);
        }
        for (const oracle::Point& x : p) pointers.push_back(x.data());
        CHECK(static_cast<int>(orient_projected(k, pointers.data(), axes, counts)) == oracle::orient(projected));
    }
}
TEST_CASE_TEMPLATE_APPLY(projections, Dimensions<2, 4>);
