// Bounds on the size of meshes with cages against vertices that are counted, and against sums over domains whose
// members, points and integrals come from plain loops over everything.
#include "laboratory/hierarchy_size.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "laboratory/common.hpp"
#include "laboratory/size.hpp"

using namespace netmesh;

namespace {

// Clusters of clusters: `ways` points or clusters in each, the next level smaller by 10 to 1e6.
inputs::Points clustered(int dim, int levels, std::size_t ways, std::uint64_t seed) {
    inputs::Random random(seed);
    inputs::Points points(static_cast<std::size_t>(dim), 0.0);
    double size = 1;
    for (int level = 0; level < levels; ++level) {
        inputs::Points next;
        for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(dim)) {
            const std::size_t count = 1 + random.below(2 * ways);
            for (std::size_t j = 0; j < count + (level == 0); ++j)
                for (int k = 0; k < dim; ++k)
                    next.push_back(points[i + static_cast<std::size_t>(k)] + size * (random.uniform() - 0.5));
        }
        points = next;
        size *= std::pow(10, -1 - 5 * random.uniform());
    }
    return points;
}

template <int D> SizeAnalysis analyse(Held<D>& held, double tau, double tolerance = infinity) {
    SizeAnalysis a;
    REQUIRE(analyse_size(held.store, held.domain, held.inputs(),
                         {tau, {}, tolerance, 1u << 20, held.cages, held.cage_count}, {held.block.arena, held.monitor},
                         &a) == Status::ok);
    return a;
}

// The bounds by definition.
template <int D> struct Sums {
    Sums(const Held<D>& held, double tau, int side) : held_(held), side_(side) {
        const double pi = std::acos(-1.0), volume = D == 2 ? pi : D == 3 ? 4 * pi / 3 : pi * pi / 2;
        for (std::uint32_t d = 0; d <= held.cage_count; ++d) add(d < held.cage_count ? d : none, tau, volume);
    }
    double lower = 0, upper = 0, ratio = 0;

private:
    const double* point(std::uint32_t v) const { return held_.store.point(VertexId(v)); }
    const double* centre(std::uint32_t d) const { return point(held_.cages[d].centre); }
    // The smallest cage around x larger than `above`.
    std::uint32_t innermost(const double* x, double above) const {
        std::uint32_t best = none;
        for (std::uint32_t d = 0; d < held_.cage_count; ++d) {
            const double r = held_.cages[d].radius;
            if (r > above && distance(x, centre(d), D) < r && (best == none || r < held_.cages[best].radius)) best = d;
        }
        return best;
    }
    double nearest(std::uint32_t v) const {
        double least = HUGE_VAL;
        for (std::uint32_t w = 0; w < held_.state.vertex_count; ++w)
            if (w != v) least = std::min(least, distance(point(v), point(w), D));
        return least;
    }
    // Of f_Q^-D over a ball about `at` by the midpoint rule, in coordinates of its own.
    double integral(const double* at, double radius, const inputs::Points& q) const {
        inputs::Points moved = q;
        for (std::size_t i = 0; i < q.size(); ++i) moved[i] -= at[i % D];
        const double step = 2 * radius / side_, origin[D] = {};
        double sum = 0, x[D];
        std::size_t boxes = 1;
        for (int k = 0; k < D; ++k) boxes *= static_cast<std::size_t>(side_);
        for (std::size_t box = 0; box < boxes; ++box) {
            std::size_t rest = box;
            for (int k = 0; k < D; ++k, rest /= static_cast<std::size_t>(side_))
                x[k] = (static_cast<double>(rest % static_cast<std::size_t>(side_)) + 0.5) * step - radius;
            if (distance(x, origin, D) < radius) sum += std::pow(step / second_nearest(moved, D, x), D);
        }
        return sum;
    }
    void add(std::uint32_t d, double tau, double volume) {
        const double* const at = d == none ? held_.domain.centre : centre(d);
        const double clip = d == none ? held_.domain.radius : held_.cages[d].radius / 2;
        inputs::Points q;
        double foreign = d == none ? HUGE_VAL : held_.cages[d].radius, off = HUGE_VAL, shares = 0;
        std::vector<std::uint32_t> members, children;
        const auto take = [&](std::uint32_t v) {
            q.insert(q.end(), point(v), point(v) + D);
            off = std::min(off, distance(point(v), at, D));
        };
        for (std::uint32_t v = 0; v < held_.state.vertex_count; ++v) {
            if (innermost(point(v), 0) != d) continue;
            const Marker marker = held_.store.vertex(VertexId(v)).marker;
            if (marker == Marker::exempt)
                foreign = std::min(foreign, distance(point(v), at, D));
            else
                members.push_back(v);
            if (marker == Marker::input) take(v);
        }
        for (std::uint32_t e = 0; e < held_.cage_count; ++e)
            if (innermost(centre(e), held_.cages[e].radius) == d) {
                children.push_back(e);
                take(held_.cages[e].centre);
            }
        REQUIRE(q.size() >= 2 * std::size_t{D});
        for (const std::uint32_t e : children) {
            const double r = held_.cages[e].radius;
            double outside = HUGE_VAL, other = HUGE_VAL;
            for (std::uint32_t v = 0; v < held_.state.vertex_count; ++v)
                if (distance(point(v), centre(e), D) >= r)
                    outside = std::min(outside, distance(point(v), centre(e), D));
            for (std::size_t i = 0; i < q.size(); i += D)
                if (distance(&q[i], centre(e), D) > 0) other = std::min(other, distance(&q[i], centre(e), D));
            // Shells are on spheres of .9 r, moved by a sixteenth at most.
            shares += std::pow((outside + 0.9 * (1 - 1.0 / 16) * r) / (other - r), D);
        }
        double c = 0, reach = 0;
        for (const std::uint32_t v : members) {
            const double near = nearest(v);
            c = std::max(c, second_nearest(q, D, point(v)) / near);
            reach = std::max(reach, distance(point(v), at, D) + near / 2);
        }
        const double inner = std::min(clip, (foreign - off) / 2);
        if (d != none) lower += 2 * D;
        if (d != none) upper += 2 * D;
        if (members.empty()) return;
        lower += std::max(0.0, integral(at, inner, q) / (volume * std::pow(tau, D)) - shares);
        upper += integral(at, std::max(inner, reach), q) / volume * std::pow(2 * c + 1, D);
        ratio = std::max(ratio, c);
    }
    const Held<D>& held_;
    int side_;
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("bounds by domains bracket |M|, with cages and finished", T, bracket) {
    constexpr int D = T::value;
    constexpr int count = by_dimension<int>(D, {110, 80, 10, 0, 0});
    constexpr double tau = by_dimension<double>(D, {2.5, 3, 4, 4, 4});
    int caged = 0;
    double worst = 0, logs = 0;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = 100 + static_cast<std::uint64_t>(i);
        const inputs::Points points = clustered(D, D == 4 ? 2 : 2 + i % 2, D == 4 ? 1 : 2, seed);
        for (const bool finish : {false, true}) {
            if (finish && D == 4) continue;
            Held<D> held(std::size_t{1} << 24);
            REQUIRE(held.mesh(points, by_hierarchy(tau, finish)) == Status::ok);
            const SizeAnalysis a = analyse<D>(held, tau);
            INFO("seed " << seed << " finish " << finish << " cages " << held.cage_count << " size " << a.size
                         << " lower " << a.size_lower << " upper " << a.size_upper);
            // All vertices but the frame.
            CHECK(a.size == held.state.vertex_count - 2 * D);
            if (held.inputs() < 2) continue;
            CHECK(a.size_lower > 0);
            CHECK(a.size_lower <= static_cast<double>(a.size));
            CHECK(static_cast<double>(a.size) <= a.size_upper);
            CHECK(violated_size_bound(a) == nullptr);
            if (finish || held.cage_count == 0) continue;
            CHECK(a.size_upper < 1e4 * a.size_lower);
            ++caged;
            worst = std::max(worst, a.size_upper / a.size_lower);
            logs += std::log(a.size_upper / a.size_lower);
        }
    }
    CHECK(caged > 3 * count / 5);
    MESSAGE("D = " << D << ": " << caged << " of " << count << " with cages, upper over lower "
                   << std::exp(logs / caged) << " (geometric mean), at most " << worst);
}
TEST_CASE_TEMPLATE_APPLY(bracket, Dimensions<2, 4>);

TEST_CASE_TEMPLATE_DEFINE("bounds by domains are sums over what plain loops find", T, sums) {
    constexpr int D = T::value;
    const double tau = D == 2 ? 2.5 : 3;
    for (std::uint64_t seed = 1; seed <= (D == 2 ? 3 : 1); ++seed) {
        inputs::Points points;
        inputs::Random random(seed);
        // A jittered triangle or so of clusters, one of them with a cluster inside.
        const double at[4][3] = {{0, 0, 0}, {1, 0.1, 0.2}, {0.3, 1, 0.1}, {0.2, 0.3, 1}};
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                for (int l = 0; l < (i == 0 && j == 0 ? 3 : 1); ++l)
                    for (int k = 0; k < D; ++k)
                        points.push_back(at[i][k] + 1e-3 * at[j][k] + 1e-6 * at[l][k] +
                                         (i == 1 ? 0 : 1e-4 * random.uniform()) * (l == 0));
        Held<D> held;
        REQUIRE(held.mesh(points, by_hierarchy(tau)) == Status::ok);
        REQUIRE(held.cage_count >= 3);
        const SizeAnalysis a = analyse<D>(held, tau, 0.1);
        const Sums<D> own(held, tau, D == 2 ? 500 : 80);
        INFO("seed " << seed << " cages " << held.cage_count << " lower " << a.size_lower << ", " << own.lower
                     << ", upper " << a.size_upper << ", " << own.upper);
        CHECK(a.feature_ratio == doctest::Approx(own.ratio).epsilon(1e-9));
        CHECK(a.size_lower <= 1.002 * own.lower);
        CHECK(a.size_lower >= (D == 2 ? 0.9 : 0.7) * own.lower);
        CHECK(a.size_upper >= 0.998 * own.upper);
        CHECK(a.size_upper <= (D == 2 ? 1.1 : 1.3) * own.upper);
        // An integral halved is a bound that breaks, or one that is far off.
        SizeAnalysis bad = a;
        bad.size_upper = static_cast<double>(a.size - 1);
        CHECK(violated_size_bound(bad) != nullptr);
        bad = a;
        bad.size_lower = static_cast<double>(a.size + 1);
        CHECK(violated_size_bound(bad) != nullptr);
    }
}
TEST_CASE_TEMPLATE_APPLY(sums, Dimensions<2, 3>);

// No input is near the middle, so the ball that the lower bound is about reaches halfway from them to what is exempt.
TEST_CASE("the lower bound is about what no exempt vertex is nearest to") {
    inputs::Points points;
    for (std::uint64_t i = 0; i < 100; ++i) {
        const auto [x, y] = inputs::turn(i, 100);
        points.insert(points.end(), {0.3 * x, 0.3 * y});
        if (i % 25 == 0) points.insert(points.end(), {x, y});
    }
    points.insert(points.end(), {1, 1e-4});  // in a cage
    Held<2> held;
    REQUIRE(held.mesh(points, by_hierarchy(2.5)) == Status::ok);
    REQUIRE(held.cage_count == 1);
    for (const double least : {0.5, 0.7, 0.9}) {
        std::uint32_t exempt = none;
        double away = HUGE_VAL;
        for (std::uint32_t v = held.inputs() + 4; v < held.state.vertex_count; ++v) {
            const double d = distance(held.store.point(VertexId(v)), held.domain.centre, 2);
            if (d < least || d > away) continue;
            away = d;
            exempt = v;
        }
        REQUIRE(away < least + 0.2);
        held.store.vertex(VertexId(exempt)).marker = Marker::exempt;
        const SizeAnalysis a = analyse<2>(held, 2.5);
        const Sums<2> own(held, 2.5, 500);
        held.store.vertex(VertexId(exempt)).marker = Marker::steiner;
        INFO("exempt " << away);
        // The ball's edge is in the ring, where the integrand is large: boxes that it cuts are left out.
        CHECK(a.size_lower <= 1.002 * own.lower);
        CHECK(a.size_lower >= 0.7 * own.lower);
    }
}

TEST_CASE("cages that are forgotten or cross: other sums, or none") {
    Held<2> held;
    REQUIRE(held.mesh(clustered(2, 2, 3, 5), by_hierarchy(2.5)) == Status::ok);
    REQUIRE(held.cage_count >= 2);
    const SizeAnalysis whole = analyse<2>(held, 2.5);
    REQUIRE(violated_size_bound(whole) == nullptr);
    // Without its cage the shell belongs to the outermost domain, as if to the frame.
    --held.cage_count;
    const SizeAnalysis less = analyse<2>(held, 2.5);
    ++held.cage_count;
    CHECK(less.size + 4 == whole.size);
    CHECK(less.size_upper != whole.size_upper);
    // Two cages that cross.
    const double radius = held.cages[0].radius;
    held.cages[0].radius =
        distance(held.store.point(VertexId(held.cages[0].centre)), held.store.point(VertexId(held.cages[1].centre)), 2);
    const SizeAnalysis none_there = analyse<2>(held, 2.5);
    held.cages[0].radius = radius;
    CHECK(none_there.size_lower == 0);
    CHECK(std::isinf(none_there.size_upper));
}
