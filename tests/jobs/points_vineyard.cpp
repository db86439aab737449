// Barycentric filtrations for a range of k in one run: each diagram is that of a run of its own, and the maps between
// consecutive k have the ranks that linear algebra on all nested sets finds.
#include "jobs/points_vineyard.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "exact/families.hpp"
#include "filtration/point_complexes.hpp"
#include "homology/map_ranks.hpp"
#include "jobs/diagram_of_points.hpp"
#include "numerics/real.hpp"

using namespace netmesh;

namespace {

using Bar = std::tuple<std::uint32_t, double, double>;  // degree, birth, death
using Bars = std::vector<Bar>;

struct Run {
    Status status;
    std::vector<VinePoint> points;
    std::vector<double> ratios;
    std::uint32_t vines = 0;

    std::vector<Bar> diagram(std::uint32_t k) const {
        std::vector<Bar> bars;
        for (const VinePoint& p : points)
            if (p.k == k) bars.emplace_back(p.degree, p.birth, p.death);
        std::sort(bars.begin(), bars.end());
        return bars;
    }
    // Of the map from k + 1 to k.
    std::vector<Bar> image(std::uint32_t k) const {
        std::vector<Bar> bars;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const VinePoint &here = points[i - 1], &next = points[i];
            if (here.vine == next.vine && here.k == k) bars.emplace_back(here.degree, next.birth, here.death);
        }
        std::sort(bars.begin(), bars.end());
        return bars;
    }
};

Run run(int dim, const inputs::Points& points, const PointsFilter& filter, std::uint32_t k_last,
        std::size_t bytes = std::size_t{1} << 24) {
    Block block(bytes, Block::untouched);
    Monitor monitor;
    PointsVineyard out;
    const std::uint32_t count = static_cast<std::uint32_t>(points.size() / static_cast<std::size_t>(dim));
    const PointsVineyardRequest request = {{points.data(), count, static_cast<std::uint32_t>(dim)}, filter, k_last};
    Run made;
    made.status = points_vineyard(request, {block.arena, monitor}, &out);
    CHECK(block.arena.high_mark() == block.arena.bytes());
    if (made.status != Status::ok) {
        CHECK(block.arena.low_mark() == 0);
        return made;
    }
    made.points.assign(out.vines.points, out.vines.points + out.vines.count);
    made.ratios.assign(out.vines.ratio, out.vines.ratio + (k_last - filter.k + 1));
    made.vines = out.vines.vine_count;
    return made;
}

inputs::Points square() { return {0, 0, 1, 0, 1, 1, 0, 1}; }

// Diagrams, ratios and errors against runs for one k; and how vines are numbered.
void equals_separate_runs(int dim, const inputs::Points& points, netmesh_filter_id kind, FilterValues values,
                          std::uint32_t k_first, std::uint32_t k_last, std::uint32_t degree) {
    CAPTURE(dim);
    CAPTURE(kind);
    CAPTURE(k_first);
    CAPTURE(degree);
    const Run all = run(dim, points, {kind, values, k_first, degree}, k_last);
    REQUIRE(all.status == Status::ok);
    for (std::uint32_t k = k_first; k <= k_last; ++k) {
        CAPTURE(k);
        Block block(std::size_t{1} << 23, Block::untouched);
        Monitor monitor;
        PointsDiagram one;
        const std::uint32_t count = static_cast<std::uint32_t>(points.size() / static_cast<std::size_t>(dim));
        const PointsRequest request = {
            {kind, values, k, degree}, points.data(), count, static_cast<std::uint32_t>(dim), HUGE_VAL, false, false};
        REQUIRE(diagram_of_points(request, {block.arena, monitor}, &one) == Status::ok);
        std::vector<Bar> expected;
        for (std::uint64_t i = 0; i < one.diagram.pairs.count; ++i) {
            const Pair& pair = one.diagram.pairs.pairs[i];
            expected.emplace_back(pair.degree, pair.birth, pair.death);
        }
        CHECK(all.diagram(k) == expected);
        CHECK(static_cast<double>(expected.size()) <= barycentric_pairs(count, k, degree));
        CHECK(all.ratios[k - k_first] == one.ratio);
    }
    std::vector<VinePoint> begin;
    for (std::size_t i = 0; i < all.points.size(); ++i) {
        const VinePoint& p = all.points[i];
        if (i > 0 && p.vine == all.points[i - 1].vine) {
            CHECK(p.k == all.points[i - 1].k + 1);
            CHECK(p.degree == all.points[i - 1].degree);
            CHECK(p.birth >= all.points[i - 1].birth);
            CHECK(p.death >= all.points[i - 1].death);
            CHECK(p.birth < all.points[i - 1].death);
            continue;
        }
        CHECK(p.vine == begin.size());
        begin.push_back(p);
    }
    CHECK(begin.size() == all.vines);
    const auto key = [](const VinePoint& p) { return std::make_tuple(p.degree, p.k, p.birth, p.death); };
    for (std::size_t v = 1; v < begin.size(); ++v) CHECK(key(begin[v - 1]) <= key(begin[v]));
}

// The smallest ball around the points of a mask, by every support; or half their diameter.
class SetRadii {
public:
    SetRadii(int dim, const inputs::Points& points, bool edges) : dim_(dim), points_(points), edges_(edges) {}
    double operator()(std::uint32_t mask) const {
        const std::vector<std::uint32_t> s = members(mask);
        double best = edges_ ? 0 : infinity;
        for (const std::uint32_t i : s)
            for (const std::uint32_t j : s)
                if (edges_) best = std::max(best, distance(at(i), at(j)) / 2);
        if (edges_) return best;
        if (s.size() == 1) return 0;
        for (std::uint32_t part = 1; part < 1u << s.size(); ++part) {
            std::vector<std::uint32_t> support;
            for (std::size_t i = 0; i < s.size(); ++i)
                if (part >> i & 1) support.push_back(s[i]);
            std::vector<double> centre;
            if (support.size() > static_cast<std::size_t>(dim_) + 1 || !circumcentre(support, &centre)) continue;
            const double r = distance(centre, at(support[0]));
            bool holds = r < best;
            for (const std::uint32_t i : s) holds = holds && distance(centre, at(i)) <= r * (1 + 1e-10);
            if (holds) best = r;
        }
        return best;
    }

    static std::vector<std::uint32_t> members(std::uint32_t mask) {
        std::vector<std::uint32_t> s;
        for (std::uint32_t i = 0; mask >> i != 0; ++i)
            if (mask >> i & 1) s.push_back(i);
        return s;
    }

private:
    std::vector<double> at(std::uint32_t i) const {
        const auto first = points_.begin() + static_cast<std::ptrdiff_t>(i) * dim_;
        return {first, first + dim_};
    }
    static double distance(const std::vector<double>& a, const std::vector<double>& b) {
        double s = 0;
        for (std::size_t d = 0; d < a.size(); ++d) s += (a[d] - b[d]) * (a[d] - b[d]);
        return std::sqrt(s);
    }
    // Equally far from all, in their affine hull: normal equations by elimination. False: dependent.
    bool circumcentre(const std::vector<std::uint32_t>& support, std::vector<double>* centre) const {
        const std::size_t m = support.size() - 1;
        *centre = at(support[0]);
        std::vector<std::vector<double>> edge(m), row(m, std::vector<double>(m + 1));
        for (std::size_t i = 0; i < m; ++i) {
            edge[i] = at(support[i + 1]);
            for (std::size_t d = 0; d < edge[i].size(); ++d) edge[i][d] -= (*centre)[d];
        }
        for (std::size_t i = 0; i < m; ++i) {
            for (std::size_t j = 0; j < m; ++j)
                for (std::size_t d = 0; d < edge[i].size(); ++d) row[i][j] += 2 * edge[i][d] * edge[j][d];
            row[i][m] = row[i][i] / 2;
        }
        for (std::size_t i = 0; i < m; ++i) {
            for (std::size_t r = i + 1; r < m; ++r)
                if (std::fabs(row[r][i]) > std::fabs(row[i][i])) std::swap(row[i], row[r]);
            if (std::fabs(row[i][i]) < 1e-12) return false;
            for (std::size_t r = 0; r < m; ++r) {
                const double f = row[r][i] / row[i][i];
                for (std::size_t c = 0; c <= m && r != i; ++c) row[r][c] -= f * row[i][c];
            }
        }
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t d = 0; d < centre->size(); ++d) (*centre)[d] += row[i][m] / row[i][i] * edge[i][d];
        return true;
    }

    int dim_;
    const inputs::Points& points_;
    bool edges_;
};

// All chains of nested sets of at least k points, of any size, up to chains of `dimension`: not only those that the
// engine lists. In the part: sets of more than k points.
std::vector<oracle::PartSimplex> all_chains(std::uint32_t n, std::uint32_t k, std::uint32_t dimension,
                                            const std::vector<double>& radius) {
    std::vector<oracle::PartSimplex> chains;
    std::vector<std::vector<std::uint32_t>> last = {{}}, next;
    for (std::uint32_t m = 0; m <= dimension; ++m, last.swap(next), next.clear()) {
        for (const std::vector<std::uint32_t>& chain : last) {
            for (std::uint32_t mask = 1; mask < 1u << n; ++mask) {
                const std::uint32_t below = chain.empty() ? 0 : chain.back();
                if ((mask & below) != below || mask == below) continue;
                if (SetRadii::members(mask).size() < k) continue;
                next.push_back(chain);
                next.back().push_back(mask);
                const std::vector<std::uint32_t>& made = next.back();
                chains.push_back({made, radius[mask], SetRadii::members(made[0]).size() > k});
            }
        }
    }
    return chains;
}

// Scales between the values that differ by more than rounding.
std::vector<double> scales_between(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    std::vector<double> scales;
    for (std::size_t i = 1; i < values.size(); ++i)
        if (values[i] > values[i - 1] * (1 + 1e-9) + 1e-9) scales.push_back((values[i] + values[i - 1]) / 2);
    scales.push_back(values.back() + 1);
    return scales;
}

// Sums of all ranks of maps and of all of the source's own, so that a test sees that there was something to compare.
struct Compared {
    int images = 0, lost = 0;
};

Compared compare_ranks(int dim, const inputs::Points& points, bool edges, std::uint32_t k_last, std::uint32_t degree) {
    CAPTURE(dim);
    CAPTURE(edges);
    const std::uint32_t n = static_cast<std::uint32_t>(points.size() / static_cast<std::size_t>(dim));
    std::vector<double> radius(1u << n);
    for (std::uint32_t mask = 1; mask < 1u << n; ++mask) radius[mask] = SetRadii(dim, points, edges)(mask);
    // Sets do not enter before their subsets, rounding or not.
    for (std::uint32_t mask = 1; mask < 1u << n; ++mask)
        for (std::uint32_t i = 0; i < n; ++i)
            if (mask >> i & 1) radius[mask] = std::max(radius[mask], radius[mask & ~(1u << i)]);
    const std::vector<double> scales = scales_between({radius.begin() + 1, radius.end()});
    const netmesh_filter_id kind = edges ? NETMESH_FILTER_BARYCENTRIC_RIPS : NETMESH_FILTER_BARYCENTRIC_CECH;
    const Run all = run(dim, points, {kind, FilterValues::thesis, 1, degree}, k_last);
    REQUIRE(all.status == Status::ok);
    Compared compared;
    for (std::uint32_t k = 1; k < k_last; ++k) {
        CAPTURE(k);
        const std::vector<oracle::PartSimplex> chains = all_chains(n, k, degree + 1, radius);
        const std::vector<Bar> bars = all.image(k), source = all.diagram(k + 1);
        for (std::uint32_t p = 0; p <= degree; ++p) {
            CAPTURE(p);
            const std::vector<std::vector<int>> due = oracle::map_ranks(chains, p, scales);
            int wrong = 0;
            for (std::size_t a = 0; a < scales.size(); ++a) {
                for (std::size_t b = a; b < scales.size(); ++b) {
                    const auto alive = [&](const std::vector<Bar>& of) {
                        return static_cast<int>(std::count_if(of.begin(), of.end(), [&](const Bar& bar) {
                            return std::get<0>(bar) == p && std::get<1>(bar) <= scales[a] &&
                                   std::get<2>(bar) > scales[b];
                        }));
                    };
                    const int have = alive(bars);
                    wrong += have != due[a][b];
                    compared.images += have;
                    compared.lost += alive(source) - have;
                }
            }
            CHECK(wrong == 0);
        }
    }
    return compared;
}

// The places of the square [-1, 2]^2 as a grid of points, by their distance to the k-th nearest input.
class Places {
public:
    static constexpr int side = 450;
    static constexpr double step = 3.0 / side;

    Places(const inputs::Points& points, std::uint32_t k) : distance_(side * side) {
        for (int i = 0; i < side * side; ++i) {
            const double x = -1 + (i % side + 0.5) * step, y = -1 + (i / side + 0.5) * step;
            std::vector<double> all;
            for (std::size_t p = 0; p < points.size(); p += 2)
                all.push_back(std::hypot(points[p] - x, points[p + 1] - y));
            std::nth_element(all.begin(), all.begin() + (k - 1), all.end());
            distance_[static_cast<std::size_t>(i)] = all[k - 1];
        }
    }
    std::vector<bool> within(double radius) const {
        std::vector<bool> is_in;
        for (const double d : distance_) is_in.push_back(d <= radius);
        return is_in;
    }

private:
    std::vector<double> distance_;
};

// Components of `whole` that `part` meets; places next to each other in all eight directions or in four.
int components_met(const std::vector<bool>& whole, const std::vector<bool>& part, bool diagonal) {
    std::vector<bool> seen(whole.size());
    std::vector<int> open;
    int met = 0;
    for (int first = 0; first < Places::side * Places::side; ++first) {
        const auto is_new = [&](int i) {
            return whole[static_cast<std::size_t>(i)] && !seen[static_cast<std::size_t>(i)];
        };
        if (!part[static_cast<std::size_t>(first)] || !is_new(first)) continue;
        ++met;
        open.push_back(first);
        seen[static_cast<std::size_t>(first)] = true;
        while (!open.empty()) {
            const int x = open.back() % Places::side, y = open.back() / Places::side;
            open.pop_back();
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy) {
                    const int u = x + dx, v = y + dy;
                    const bool out = u < 0 || v < 0 || u >= Places::side || v >= Places::side;
                    if (out || (!diagonal && dx != 0 && dy != 0) || !is_new(v * Places::side + u)) continue;
                    seen[static_cast<std::size_t>(v * Places::side + u)] = true;
                    open.push_back(v * Places::side + u);
                }
        }
    }
    return met;
}

inputs::Points polygon(int corners, bool centre) {
    inputs::Points points = inputs::circle(static_cast<std::size_t>(corners));
    if (centre) points.insert(points.end(), {0, 0});
    return points;
}

}  // namespace

TEST_CASE("one run for all k has the diagrams of separate runs, bit for bit") {
    for (const netmesh_filter_id kind : {NETMESH_FILTER_BARYCENTRIC_CECH, NETMESH_FILTER_BARYCENTRIC_RIPS}) {
        for (const FilterValues values : {FilterValues::certified, FilterValues::thesis}) {
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                CAPTURE(seed);
                equals_separate_runs(2, inputs::uniform(2, 8, seed), kind, values, 1, 4, 1);
                equals_separate_runs(3, inputs::uniform(3, 7, seed), kind, values, 1, 3, 2);
                equals_separate_runs(3, inputs::uniform(3, 9, seed), kind, values, 2, 5, 0);
            }
            equals_separate_runs(2, inputs::grid(2, 3), kind, values, 1, 4, 1);
            equals_separate_runs(2, families::moved(inputs::grid(2, 3), 3), kind, values, 1, 4, 1);
            equals_separate_runs(3, families::moved(inputs::shell(3, 7, 1, 1, 9), 2), kind, values, 1, 3, 2);
            equals_separate_runs(2, square(), kind, values, 1, 4, 2);
            equals_separate_runs(2, polygon(6, true), kind, values, 1, 7, 1);
            equals_separate_runs(2, inputs::uniform(2, 8), kind, values, 3, 3, 1);
            equals_separate_runs(2, {0.5, 0.25}, kind, values, 1, 1, 1);
            for_each_dimension<4, 4>(
                [&](auto dim) { equals_separate_runs(dim, inputs::uniform(dim, 7), kind, values, 1, 3, 1); });
        }
    }
}

// Balls about the corners of a square meet along its sides at 1/2, all at its centre at the root of 1/2. Twice covered
// are four lenses, which open at 1/2 and meet in the centre; three times, the centre on.
TEST_CASE("the maps of a square") {
    const Run all = run(2, square(), {NETMESH_FILTER_BARYCENTRIC_CECH, FilterValues::certified, 1, 1}, 4);
    REQUIRE(all.status == Status::ok);
    const double half = 0.5, centre = std::sqrt(0.5);
    CHECK(all.diagram(1) == Bars{{0, 0, half}, {0, 0, half}, {0, 0, half}, {0, 0, infinity}, {1, half, centre}});
    CHECK(all.diagram(2) == Bars{{0, half, centre}, {0, half, centre}, {0, half, centre}, {0, half, infinity}});
    CHECK(all.diagram(3) == Bars{{0, centre, infinity}});
    CHECK(all.diagram(4) == Bars{{0, centre, infinity}});
    // The lenses lie in one component, the loop is not covered twice.
    CHECK(all.image(1) == Bars{{0, half, infinity}});
    CHECK(all.image(2) == Bars{{0, centre, infinity}});
    CHECK(all.image(3) == Bars{{0, centre, infinity}});
    CHECK(all.vines == 8);
    CHECK(all.ratios == std::vector<double>(4, 1));
}

// Two pairs far apart: what is covered twice at first are two lenses in two components.
TEST_CASE("the maps of two pairs of points") {
    const inputs::Points points = {0, 0, 1, 0, 9, 0, 11, 0};
    const Run all = run(2, points, {NETMESH_FILTER_BARYCENTRIC_CECH, FilterValues::certified, 1, 0}, 2);
    REQUIRE(all.status == Status::ok);
    CHECK(all.diagram(1) == Bars{{0, 0, 0.5}, {0, 0, 1}, {0, 0, 4}, {0, 0, infinity}});
    // The lens of the middle two points opens at 4, where it joins nothing yet.
    CHECK(all.image(1) == Bars{{0, 0.5, infinity}, {0, 1, 4}});
}

TEST_CASE("ranks of the maps equal linear algebra on 200 small sets") {
    Compared sum[2];
    const auto add = [&](int dim, const inputs::Points& points, bool edges, std::uint32_t k_last,
                         std::uint32_t degree) {
        const Compared compared = compare_ranks(dim, points, edges, k_last, degree);
        sum[edges].images += compared.images;
        sum[edges].lost += compared.lost;
    };
    for (std::uint64_t seed = 1; seed <= 92; ++seed) {
        CAPTURE(seed);
        const int dim = seed % 2 == 0 ? 2 : 3;
        for (const bool edges : {false, true}) {
            if (seed % 23 == 0) {
                add(dim, inputs::uniform(dim, 6, seed), edges, 4, 1);
            } else {
                add(dim, inputs::uniform(dim, 5, seed), edges, 4, seed % 4 == 1 ? 2 : 1);
            }
        }
    }
    for (const bool edges : {false, true}) {
        add(2, square(), edges, 4, 2);
        for (int corners = 3; corners <= 6; ++corners) add(2, polygon(corners, false), edges, 4 - (corners < 4), 1);
        add(2, polygon(4, true), edges, 4, 1);
        add(2, {0, 0, 1, 0, 2, 0, 3, 0, 4, 0}, edges, 4, 1);
        add(3, {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1}, edges, 4, 1);
    }
    for (const Compared& compared : sum) {
        CHECK(compared.images > 1000);
        CHECK(compared.lost > 100);
    }
}

// In the plane the rank in degree 0 is the number of components of the larger set that the smaller one meets; in degree
// 1, by Alexander duality, that of components of the smaller one's complement that the larger one's meets, less one.
TEST_CASE("the maps are those of the places within a radius of k + 1 and of k points") {
    int compared[2] = {}, lost = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        CAPTURE(seed);
        inputs::Points points = inputs::uniform(2, 6, seed);
        if (seed > 6) {  // rings, whose holes are surrounded more than once
            const inputs::Points ring = inputs::circle(8), moved = inputs::uniform(2, 8, seed);
            points.clear();
            for (std::size_t i = 0; i < ring.size(); ++i) points.push_back(0.5 + ring[i] / 2 + moved[i] / 10);
        }
        const Run all = run(2, points, {NETMESH_FILTER_BARYCENTRIC_CECH, FilterValues::certified, 1, 1}, 4);
        REQUIRE(all.status == Status::ok);
        std::vector<double> values;
        for (const VinePoint& p : all.points) {
            values.push_back(p.birth);
            if (p.death < infinity) values.push_back(p.death);
        }
        std::sort(values.begin(), values.end());
        std::vector<double> scales;  // so far from all changes that the grid has their topology
        for (std::size_t i = 1; i < values.size(); ++i)
            if (values[i] - values[i - 1] > 5 * Places::step) scales.push_back((values[i] + values[i - 1]) / 2);
        for (std::uint32_t k = 1; k <= 3; ++k) {
            CAPTURE(k);
            const Places larger(points, k), smaller(points, k + 1);
            const Bars bars = all.image(k);
            for (const double a : scales) {
                for (const double b : scales) {
                    if (b < a) continue;
                    CAPTURE(a);
                    CAPTURE(b);
                    std::vector<bool> part = smaller.within(a), whole = larger.within(b);
                    int due[2] = {components_met(whole, part, true), 0}, have[2] = {};
                    part.flip();
                    whole.flip();
                    due[1] = components_met(part, whole, false) - 1;
                    for (const Bar& bar : bars) have[std::get<0>(bar)] += std::get<1>(bar) <= a && std::get<2>(bar) > b;
                    for (const int p : {0, 1}) {
                        CHECK(have[p] == due[p]);
                        compared[p] += have[p];
                    }
                    for (const Bar& bar : all.diagram(k + 1)) lost += std::get<1>(bar) <= a && std::get<2>(bar) > b;
                }
            }
        }
    }
    CHECK(compared[0] > 100);
    CHECK(compared[1] > 0);
    CHECK(lost > compared[0] + compared[1]);
}

TEST_CASE("what a range of k refuses") {
    const inputs::Points points = inputs::uniform(2, 5);
    CHECK(run(2, points, {NETMESH_FILTER_BARYCENTRIC_CECH, FilterValues::certified, 1, 1}, 5).status == Status::ok);
    CHECK(run(2, points, {NETMESH_FILTER_BARYCENTRIC_CECH, FilterValues::certified, 1, 1}, 6).status ==
          Status::invalid_argument);
    inputs::Points repeated = points;
    repeated.insert(repeated.end(), {points[0], points[1]});
    CHECK(run(2, repeated, {NETMESH_FILTER_BARYCENTRIC_CECH, FilterValues::certified, 1, 1}, 6).status ==
          Status::invalid_argument);
    inputs::Points bad = points;
    bad[3] = infinity;
    CHECK(run(2, bad, {NETMESH_FILTER_BARYCENTRIC_CECH, FilterValues::certified, 1, 1}, 2).status ==
          Status::not_finite);
    // Every block is too small or large enough, and gives the same.
    const PointsFilter filter = {NETMESH_FILTER_BARYCENTRIC_RIPS, FilterValues::certified, 1, 1};
    const Run whole = run(2, points, filter, 3);
    int refused = 0, good = 0;
    for (std::size_t bytes = 64; bytes < std::size_t{1} << 17; bytes += 1 + bytes / 40) {
        const Run made = run(2, points, filter, 3, bytes);
        if (made.status == Status::out_of_memory) {
            CHECK(good == 0);
            ++refused;
            continue;
        }
        REQUIRE(made.status == Status::ok);
        ++good;
        CHECK(made.points.size() == whole.points.size());
        for (std::uint32_t k = 1; k <= 3; ++k) CHECK(made.diagram(k) == whole.diagram(k));
        for (std::uint32_t k = 1; k <= 2; ++k) CHECK(made.image(k) == whole.image(k));
    }
    CHECK(refused > 20);
    CHECK(good > 1);
}
