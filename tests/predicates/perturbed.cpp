// Ties broken by index: the answers of generic weights, and hence of one triangulation.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

#include "common/dimensions.hpp"
#include "inputs.hpp"
#include "oracle.hpp"
#include "predicates/predicates.hpp"

using namespace netmesh;
using inputs::Kind;
using inputs::Point;

namespace {

// The weight of the point of rank r among the indices is 2^(r b), in lifts times 2^((D + 3) b). No orient of the
// integer points reaches 2^(b - 4), so that a weight outdoes all lower ones together and all weights together no lift.
int oracle_perturbed(const std::vector<Point>& points, const std::vector<VertexId>& ids) {
    const oracle::Matrix x = oracle::integers(points);
    std::size_t width = 0;
    for (const auto& row : x)
        for (const mpz_class& c : row) width = std::max(width, mpz_sizeinbase(c.get_mpz_t(), 2));
    const auto dim = x[0].size();
    const auto b = static_cast<int>((width + 1) * dim + 20);
    std::vector<mpz_class> weights(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto rank = std::count_if(ids.begin(), ids.end(), [&](VertexId id) { return id < ids[i]; });
        weights[i] = mpz_class(1) << static_cast<unsigned>(rank * b);
    }
    return oracle::in_ball(points, weights, static_cast<int>(dim + 3) * b);
}

template <int D> struct Query {
    std::vector<Point> points;  // the last one is the query
    std::vector<VertexId> ids;

    Sign ask(PredicateCounts& counts) const {
        const double* p[D + 2];
        for (int i = 0; i < D + 2; ++i) p[i] = points[static_cast<std::size_t>(i)].data();
        return in_ball_perturbed<D>(p, ids.data(), p[D + 1], ids[D + 1], counts);
    }
    void exchange(std::size_t i, std::size_t j) {
        std::swap(points[i], points[j]);
        std::swap(ids[i], ids[j]);
    }
};

template <int D> void check_weights(Kind kind, int cases) {
    CAPTURE(D);
    CAPTURE(inputs::name(kind));
    inputs::Source source(77 * D + static_cast<std::uint64_t>(kind));
    PredicateCounts counts{};
    int asked = 0, zero = 0, other_than_weights = 0, changed_by_rotation = 0;
    for (int t = 0; t < cases; ++t) {
        Query<D> query{source.points(kind, D), std::vector<VertexId>(D + 2)};
        std::iota(query.ids.begin(), query.ids.end(), VertexId(static_cast<std::uint32_t>(source.below(5))));
        for (std::size_t i = D + 1; i > 0; --i) std::swap(query.ids[i], query.ids[source.below(i + 1)]);
        if (source.coin()) query.ids[source.below(D + 2)] = none;
        const int o = oracle::orient({query.points.begin(), query.points.end() - 1});
        if (o == 0) continue;
        if (o < 0) query.exchange(0, 1);
        if (std::find(query.points.begin(), query.points.end() - 1, query.points.back()) != query.points.end() - 1)
            continue;
        ++asked;
        const Sign sign = query.ask(counts);
        zero += sign == Sign::zero;
        other_than_weights += static_cast<int>(sign) != oracle_perturbed(query.points, query.ids);
        const std::size_t i = source.below(D + 1), j = (i + 1) % (D + 1), k = (i + 2) % (D + 1);
        query.exchange(i, j);
        query.exchange(j, k);
        changed_by_rotation += query.ask(counts) != sign;
    }
    CHECK(asked > cases / 20);
    CHECK(zero == 0);
    CHECK(other_than_weights == 0);
    CHECK(changed_by_rotation == 0);
    if (kind == Kind::flips || kind == Kind::cospherical) CHECK(counts.calls[4] > static_cast<std::uint64_t>(asked));
}

template <int D> void check_weights() {
    for (const Kind kind : {Kind::grid, Kind::cospherical, Kind::flips, Kind::flips_ulp, Kind::mixed_scales})
        check_weights<D>(kind, 500);
    check_weights<D>(Kind::full_range_flips, 5);
    check_weights<D>(Kind::denormal_flips, 100);
}

// D! times the signed volume of a cell with small integer coordinates.
long cell_volume(const std::vector<Point>& corners) {
    oracle::Matrix x;
    for (const Point& p : corners) x.emplace_back(p.begin(), p.end());
    return oracle::orient_integer(x).get_si();
}

// All cells whose perturbed ball holds no other point. They have to fill the hull: `volume` is D! times that.
template <int D> void check_fills(const std::vector<Point>& points, long volume, std::uint64_t seed) {
    CAPTURE(D);
    const std::size_t n = points.size();
    std::vector<VertexId> ids(n);
    for (std::size_t i = 0; i < n; ++i) ids[i] = VertexId(static_cast<std::uint32_t>(i));
    inputs::Source source(seed);
    for (std::size_t i = n - 1; i > 0; --i) std::swap(ids[i], ids[source.below(i + 1)]);

    std::array<std::size_t, D + 1> pick;
    std::iota(pick.begin(), pick.end(), std::size_t{0});
    PredicateCounts counts{};
    long filled = 0;
    for (;;) {
        std::vector<Point> corners;
        std::array<const double*, D + 1> cell;
        std::array<VertexId, D + 1> cell_ids;
        for (std::size_t i = 0; i <= D; ++i) {
            corners.push_back(points[pick[i]]);
            cell[i] = points[pick[i]].data();
            cell_ids[i] = ids[pick[i]];
        }
        const long size = cell_volume(corners);
        if (size < 0) {
            std::swap(cell[0], cell[1]);
            std::swap(cell_ids[0], cell_ids[1]);
        }
        if (size != 0) {
            bool empty = true;
            for (std::size_t q = 0; q < n && empty; ++q)
                if (std::find(pick.begin(), pick.end(), q) == pick.end())
                    empty = in_ball_perturbed<D>(cell.data(), cell_ids.data(), points[q].data(), ids[q], counts) ==
                            Sign::negative;
            if (empty) filled += std::labs(size);
        }
        int i = D;
        while (i >= 0 && pick[static_cast<std::size_t>(i)] == n - static_cast<std::size_t>(D + 1 - i)) --i;
        if (i < 0) break;
        auto at = static_cast<std::size_t>(i);
        for (++pick[at]; at < D; ++at) pick[at + 1] = pick[at] + 1;
    }
    CHECK(filled == volume);
    CHECK(counts.calls[4] > 0);
}

template <int D> std::vector<Point> grid(int side) {
    std::vector<Point> points;
    Point x(D, 0.0);
    for (;;) {
        points.push_back(x);
        std::size_t c = 0;
        while (c < D && x[c] == side - 1) x[c++] = 0;
        if (c == D) return points;
        x[c] += 1;
    }
}

template <int D> std::vector<Point> cross_polytope() {
    std::vector<Point> points;
    for (std::size_t c = 0; c < D; ++c)
        for (const double s : {-1.0, 1.0}) {
            points.emplace_back(D, 0.0);
            points.back()[c] = s;
        }
    return points;
}

}  // namespace

TEST_CASE("the perturbed predicate is that of generic weights") {
    for_each_dimension([](auto dim) { check_weights<dim>(); });
}

TEST_CASE("perturbed Delaunay cells of cospherical points fill their hull") {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        check_fills<2>(grid<2>(2), 2, seed);
        check_fills<2>(grid<2>(4), 2 * 9, seed);
        check_fills<3>(grid<3>(2), 6, seed);
        check_fills<3>(grid<3>(3), 6 * 8, seed);
        for_each_dimension<4, 4>([&](auto dim) { check_fills<dim>(grid<4>(2), 24, seed); });
        for_each_dimension<5, 5>([&](auto dim) { check_fills<dim>(cross_polytope<5>(), 32, seed); });
        for_each_dimension<6, 6>([&](auto dim) { check_fills<dim>(cross_polytope<6>(), 64, seed); });
    }
}
