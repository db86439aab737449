#include "filtration/sharp_bounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "filtration/nearest_in_hull.hpp"
#include "mesh/refine.hpp"

using namespace netmesh;

namespace {

template <int D> double distance(const double* a, const double* b) {
    double d2 = 0;
    for (int k = 0; k < D; ++k) d2 += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(d2);
}

// Samples points, near vertices where cells are small, and compares the distance to the inputs with the bounds of the cell that
// each is in.
template <int D> void sample_cells(const inputs::Points& points, double tau, int samples, double share) {
    Block block(std::size_t{1} << 27);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    Domain<D> domain = {};
    REQUIRE(refine<D>(store, points.data(), points.size() / D, {tau, 1, true, 1}, monitor, &input, &domain) ==
            Status::ok);
    const std::uint32_t inputs = static_cast<std::uint32_t>(points.size() / D), count = state.vertex_count;
    const double rho = domain.enclosing_radius * (1 + 1e-12);
    std::vector<double> value(count);
    std::vector<Interval> known(count), sharp;
    MeshCertificate certificate;
    REQUIRE(mesh_filter_values<D>(store, domain, MeshFilter::complete, FilterValues::certified, block.arena,
                                  value.data(), &certificate, known.data()) == Status::ok);
    sharp = known;
    const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
    REQUIRE(sharpen_intervals<D>(store, inputs, rho, block.arena, monitor, sharp.data()) == Status::ok);
    CHECK(block.arena.low_mark() == low);
    CHECK(block.arena.high_mark() == high);
    std::size_t narrower = 0;
    for (std::uint32_t v = 0; v < count; ++v) {
        CHECK(sharp[v].lo >= known[v].lo);
        CHECK(sharp[v].hi <= known[v].hi);
        CHECK(sharp[v].lo <= sharp[v].hi);
        narrower += sharp[v].hi / sharp[v].lo < 0.95 * known[v].hi / known[v].lo;
    }
    CHECK(static_cast<double>(narrower) > share * count);
    inputs::Random random(8);
    for (int s = 0; s < samples; ++s) {
        double x[D];
        const std::uint32_t near = inputs + static_cast<std::uint32_t>(random.below(count - inputs));
        const double scale = 2 * std::sqrt(store.vertex(near).nearest2);
        for (int k = 0; k < D; ++k) x[k] = store.point(near)[k] + scale * (2 * random.uniform() - 1);
        std::uint32_t v = 0;
        double best = infinity, offset = infinity;
        for (std::uint32_t w = 0; w < count; ++w) {
            const double d = distance<D>(x, store.point(w));
            if (d < best) {
                best = d;
                v = w;
            }
            if (w < inputs) offset = std::min(offset, d);
        }
        const double f = std::min(offset, rho);
        // An input's cell has a ball in it before lo.
        CHECK((v < inputs || sharp[v].lo <= f * (1 + 1e-12)));
        CHECK(f <= sharp[v].hi * (1 + 1e-12));
    }
}

}  // namespace

TEST_CASE("the nearest point of a hull, from below") {
    // A square, its centre (0, 0); from (3, 0.5) the nearest point is (1, 0.5), from (2, 3) the corner (1, 1).
    const double square[] = {1, 1, 1, -1, -1, 1, -1, -1};
    const auto bound = [&](double x, double y) {
        const double q[] = {x, y};
        HalfSpace<2> best;
        NearestInHull<2>().run(square, 4, q, &best);
        return best.distance(q);
    };
    CHECK(bound(3, 0.5) == doctest::Approx(2));
    CHECK(bound(2, 3) == doctest::Approx(std::sqrt(5)));
    CHECK(bound(0.5, -7) == doctest::Approx(6));
    CHECK(bound(0.2, 0.1) == 0);
    // Random hulls: never above the distance to a point of the hull.
    inputs::Random random(5);
    for (int i = 0; i < 2000; ++i) {
        double y[12][4], q[4], x[4] = {}, sum = 0, weight[12];
        for (double& w : weight) sum += w = random.uniform() * random.uniform();
        for (int j = 0; j < 12; ++j)
            for (int k = 0; k < 4; ++k) x[k] += weight[j] / sum * (y[j][k] = random.uniform());
        for (double& c : q) c = 3 * random.uniform() - 1;
        HalfSpace<4> best;
        NearestInHull<4>().run(y[0], 12, q, &best);
        CHECK(best.distance(q) <= distance<4>(x, q) * (1 + 1e-12));
        for (const auto& corner : y) CHECK(best.distance(corner) <= 1e-12);
    }
}

TEST_CASE("the distance to the inputs is within the bounds of every cell") {
    sample_cells<2>(inputs::uniform(2, 60), 2.5, 10000, 0.1);
    sample_cells<2>(inputs::clusters(2, 40), 3.08, 10000, 0.1);
    sample_cells<3>(inputs::torus(60, 27), 3.08, 5000, 0.1);
    sample_cells<4>(inputs::clifford(200), 3.08, 2000, 0.02);
}
