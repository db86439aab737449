// Fatness of every cell of hierarchical meshes, shells and boundary included: in-balls, out-balls, edges, degrees and
// corners by this file's own geometry, and what chapter 5 says of them.
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "common/dimensions.hpp"
#include "common/mesh_requests.hpp"
#include "laboratory/common.hpp"
#include "laboratory/fat_cell.hpp"
#include "laboratory/fatness.hpp"

using namespace netmesh;

namespace {

using Point = std::vector<long double>;

long double length_of(const Point& a, const Point& b) {
    long double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum);
}

// Solves a square system, rows with the right side behind, by complete pivoting; false: singular.
bool solved(std::vector<Point> a, Point* x) {
    const std::size_t m = a.size();
    std::vector<std::size_t> column(m);
    for (std::size_t k = 0; k < m; ++k) column[k] = k;
    for (std::size_t k = 0; k < m; ++k) {
        std::size_t row = k, col = k;
        for (std::size_t i = k; i < m; ++i)
            for (std::size_t j = k; j < m; ++j)
                if (std::fabs(a[i][j]) > std::fabs(a[row][col])) row = i, col = j;
        if (!(std::fabs(a[row][col]) > 1e-13L)) return false;
        std::swap(a[k], a[row]);
        for (Point& r : a) std::swap(r[k], r[col]);
        std::swap(column[k], column[col]);
        for (std::size_t i = 0; i < m; ++i) {
            const long double factor = i == k ? 0 : a[i][k] / a[k][k];
            for (std::size_t j = k; j <= m && factor != 0; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    x->assign(m, 0);
    for (std::size_t k = 0; k < m; ++k) (*x)[column[k]] = a[k][m] / a[k][k];
    return true;
}

// The point as far from all of these: of D + 1 points their circumcentre, of fewer that in their flat.
Point equidistant(const std::vector<Point>& p) {
    const std::size_t m = p.size() - 1, dim = p[0].size();
    if (m == 0) return p[0];
    if (m == dim) {
        std::vector<Point> rows;
        for (std::size_t i = 1; i <= m; ++i) {
            const long double length = length_of(p[i], p[0]);
            Point row;
            for (std::size_t k = 0; k < dim; ++k) row.push_back((p[i][k] - p[0][k]) / length);
            row.push_back(length / 2);
            rows.push_back(row);
        }
        Point centre;
        if (!solved(rows, &centre)) return {};
        for (std::size_t k = 0; k < dim; ++k) centre[k] += p[0][k];
        return centre;
    }
    long double scale = 0;
    for (std::size_t i = 0; i < m; ++i) scale = std::max(scale, length_of(p[i + 1], p[0]));
    std::vector<Point> a(m, Point(m + 1, 0));
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < m; ++j) {
            for (std::size_t k = 0; k < dim; ++k)
                a[i][j] += (p[i + 1][k] - p[0][k]) * (p[j + 1][k] - p[0][k]) / (scale * scale);
            if (i == j) a[i][m] = a[i][i] / 2;
        }
    Point weight, centre = p[0];
    if (!solved(a, &weight)) return {};
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t k = 0; k < dim; ++k) centre[k] += weight[i] * (p[i + 1][k] - p[0][k]);
    return centre;
}

// A hierarchical mesh and its Voronoi cells.
template <int D> struct Diagram {
    Diagram(const inputs::Points& points, double tau, bool cages = true) : held(std::size_t{1} << 27) {
        MeshRequest request = cages ? by_hierarchy(tau) : by_quality(tau);
        MeshResult<D> mesh = {};
        REQUIRE(mesh_points<D>(held.store, points.data(), points.size() / D, request, {held.block.arena, held.monitor},
                               &mesh) == Status::ok);
        held.domain = mesh.domain;
        cage_count = mesh.hierarchy.cages;
        for (int k = 0; k < D; ++k) centre.push_back(mesh.domain.centre[k]);
        for (std::uint32_t v = 0; v < held.state.vertex_count; ++v)
            vertex.push_back(Point(held.store.point(v), held.store.point(v) + D));
        star.resize(vertex.size());
        near.resize(vertex.size());
        hull.resize(vertex.size(), false);
        for (std::uint32_t c = 0; c < held.state.cell_slots; ++c) {
            std::vector<Point> corners;
            const Cell<D>& cell = held.store.cell(c);
            for (const std::uint32_t v : cell.vertex) corners.push_back(vertex[v]);
            corner.push_back(equidistant(corners));
            REQUIRE(!corner.back().empty());
            for (int i = 0; i <= D; ++i) {
                star[cell.vertex[i]].push_back(c);
                for (int j = 0; j <= D; ++j) {
                    if (i != j) near[cell.vertex[i]].insert(cell.vertex[j]);
                    if (i != j && cell.neighbour[i] == none) hull[cell.vertex[j]] = true;
                }
            }
        }
    }
    bool in_domain(const Point& x) const { return length_of(x, centre) <= held.domain.radius; }
    bool is_whole(std::uint32_t v) const {
        bool whole = !hull[v];
        for (const std::uint32_t c : star[v]) whole = whole && in_domain(corner[c]);
        return whole;
    }
    // The in-ball by all sets of D + 1 neighbours whose bisectors it may touch.
    long double in_radius(std::uint32_t v) const {
        const std::vector<std::uint32_t> w(near[v].begin(), near[v].end());
        const long double scale = reach(v);
        const auto normal = [&](std::uint32_t u, std::size_t k) {
            return (vertex[u][k] - vertex[v][k]) / length_of(vertex[u], vertex[v]);
        };
        long double best = 0;
        any_subset(static_cast<int>(w.size()), D + 1, [&](const std::vector<int>& chosen) {
            std::vector<Point> a;
            for (const int i : chosen) {
                const std::uint32_t u = w[static_cast<std::size_t>(i)];
                Point row;
                for (std::size_t k = 0; k < D; ++k) row.push_back(normal(u, k));
                row.push_back(1);
                row.push_back(length_of(vertex[u], vertex[v]) / 2 / scale);
                a.push_back(row);
            }
            Point y;
            if (!solved(a, &y) || !(y[D] > best)) return false;
            for (const std::uint32_t u : w) {
                long double height = length_of(vertex[u], vertex[v]) / 2 / scale - y[D];
                for (std::size_t k = 0; k < D; ++k) height -= normal(u, k) * y[k];
                if (height < -1e-12L) return false;
            }
            best = y[D];
            return false;
        });
        return best * scale;
    }
    long double reach(std::uint32_t v) const {
        long double most = 0;
        for (const std::uint32_t c : star[v]) most = std::max(most, length_of(corner[c], vertex[v]));
        return most;
    }
    // The smallest ball around the corners, by all sets of at most D + 1 of them that a farthest-point search has met.
    long double out_radius(std::uint32_t v) const {
        std::vector<Point> basis = {corner[star[v][0]]};
        for (;;) {
            long double best = HUGE_VALL;
            std::vector<Point> support;
            Point centre_of_best;
            for (int size = 1; size <= D + 1; ++size)
                any_subset(static_cast<int>(basis.size()), size, [&](const std::vector<int>& chosen) {
                    std::vector<Point> p;
                    for (const int i : chosen) p.push_back(basis[static_cast<std::size_t>(i)]);
                    const Point at = equidistant(p);
                    if (at.empty()) return false;
                    const long double radius = length_of(at, p[0]);
                    for (const Point& q : basis)
                        if (length_of(at, q) > radius * (1 + 1e-14L)) return false;
                    if (radius < best) best = radius, support = p, centre_of_best = at;
                    return false;
                });
            const Point* farthest = nullptr;
            long double most = best * (1 + 1e-12L);
            for (const std::uint32_t c : star[v])
                if (length_of(corner[c], centre_of_best) > most)
                    most = length_of(corner[c], centre_of_best), farthest = &corner[c];
            if (farthest == nullptr) return best;
            basis = support;
            basis.push_back(*farthest);
        }
    }
    // Has the segment between two corners points in the domain?
    bool crosses(const Point& a, const Point& b) const {
        const long double length = length_of(a, b);
        long double t = 0;
        for (std::size_t k = 0; k < D; ++k) t += (centre[k] - a[k]) * (b[k] - a[k]) / length;
        t = std::min(std::max(t, 0.0L), length);
        Point x = a;
        for (std::size_t k = 0; k < D && length > 0; ++k) x[k] += t * (b[k] - a[k]) / length;
        return in_domain(x);
    }
    // Edges whose facet has a corner in the domain or an edge that enters it.
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges() const {
        std::set<std::pair<std::uint32_t, std::uint32_t>> found;
        for (std::uint32_t c = 0; c < held.state.cell_slots; ++c)
            for (int left = -1; left <= D; ++left) {
                const Cell<D>& cell = held.store.cell(c);
                if (left >= 0 && cell.neighbour[left] == none) continue;
                if (left < 0 ? !in_domain(corner[c]) : !crosses(corner[c], corner[cell.neighbour[left].cell()]))
                    continue;
                for (int i = 0; i <= D; ++i)
                    for (int j = 0; j < i; ++j)
                        if (i != left && j != left)
                            found.insert(std::minmax<std::uint32_t>(cell.vertex[i], cell.vertex[j]));
            }
        return found;
    }
    FatnessAnalysis analysed() {
        FatnessAnalysis a;
        REQUIRE(analyse_fatness<D>(held.store, held.domain, {held.block.arena, held.monitor}, &a) == Status::ok);
        return a;
    }

    Held<D> held;
    std::uint32_t cage_count = 0;
    Point centre;
    std::vector<Point> vertex, corner;
    std::vector<std::vector<std::uint32_t>> star;
    std::vector<std::set<std::uint32_t>> near;
    std::vector<bool> hull;
};

// A point in a ball, with many near its centre.
template <int D> Point point_in(inputs::Random& random, const double* centre, double radius) {
    Point x(D);
    long double length2 = 0;
    do {
        length2 = 0;
        for (long double& c : x) {
            c = 2 * random.uniform() - 1;
            length2 += c * c;
        }
    } while (!(length2 <= 1));
    const double shrink = random.below(2) == 0 ? 1 : std::pow(10, -12 * random.uniform());
    for (int k = 0; k < D; ++k)
        x[static_cast<std::size_t>(k)] = centre[k] + radius * shrink * x[static_cast<std::size_t>(k)];
    return x;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("each cell of a hierarchical mesh: balls and neighbours by brute force", T, each_cell) {
    constexpr int D = T::value;
    std::size_t whole_cells = 0;
    for (const inputs::Points& points :
         {inputs::geometric(D, 100, 5), inputs::geometric(D, 1e6, 4), inputs::close_pairs(D, 4, 1e-4),
          inputs::nested(D, 2, 7, 1e4), inputs::geometric(D, 1e6, D == 3 ? 12 : 4, 10)}) {
        Diagram<D> diagram(points, 2.5);
        REQUIRE(diagram.cage_count > 0);
        const FatnessAnalysis a = diagram.analysed();
        Held<D>& held = diagram.held;
        FattestCells cells(held.store, held.domain, held.block.arena);
        inputs::Random random(31);
        double beta_max = 0, beta_sum = 0;
        std::size_t shells = 0;
        std::map<std::uint32_t, std::size_t> degree;
        const auto edges = diagram.edges();
        for (const auto& [u, v] : edges) ++degree[u], ++degree[v];
        for (VertexId v(0); v < held.state.vertex_count; ++v) {
            INFO("vertex " << v.index);
            FatCell cell;
            auto piece = FattestCells::Piece::whole;
            REQUIRE(cells.measure(v, &cell, &piece) == Status::ok);
            REQUIRE(cell.known);
            const bool whole = diagram.is_whole(v);
            CHECK(whole == (piece == FattestCells::Piece::whole));
            CHECK(cell.bounded == !diagram.hull[v]);
            CHECK(cell.corners == diagram.star[v].size());
            CHECK(cell.degree == diagram.near[v].size());
            CHECK(cell.met == degree[v]);
            REQUIRE(cell.in_radius > 0);
            shells += held.store.vertex(v).marker == Marker::exempt && !diagram.hull[v];
            beta_max = std::max(beta_max, cell.out_radius / cell.in_radius);
            beta_sum += cell.out_radius / cell.in_radius;
            if (whole) {
                ++whole_cells;
                const double in = static_cast<double>(diagram.in_radius(v)),
                             out = static_cast<double>(diagram.out_radius(v));
                CHECK(cell.in_radius == doctest::Approx(in).epsilon(1e-6));
                CHECK(cell.in_radius <= in * (1 + 1e-9));
                CHECK(cell.out_radius == doctest::Approx(out).epsilon(1e-6));
                CHECK(cell.out_radius >= out * (1 - 1e-9));
                CHECK(cell.reach == doctest::Approx(static_cast<double>(diagram.reach(v))).epsilon(1e-6));
            }
            // Points of the in-ball are nearest to v and in the piece; points of the piece are in the out-ball.
            const double clip = piece == FattestCells::Piece::in_domain ? held.domain.radius
                                : piece == FattestCells::Piece::in_ball ? cells.radius()
                                                                        : HUGE_VAL;
            const auto nearest = [&](const Point& x) {
                std::size_t best = 0;
                for (std::size_t w = 1; w < diagram.vertex.size(); ++w)
                    if (length_of(x, diagram.vertex[w]) < length_of(x, diagram.vertex[best])) best = w;
                return length_of(x, diagram.vertex[best]);
            };
            for (int sample = 0; sample < 60; ++sample) {
                const Point x = point_in<D>(random, cell.in_centre, cell.in_radius);
                CHECK(length_of(x, diagram.vertex[v]) <= nearest(x) + 1e-9L * cell.reach);
                if (clip < HUGE_VAL) CHECK(length_of(x, diagram.centre) <= clip * (1 + 1e-9L));
                const double* const about = sample % 2 == 0 ? held.store.point(v) : cell.out_centre;
                const Point y = point_in<D>(random, about, 2 * cell.reach);
                if (length_of(y, diagram.centre) > clip || length_of(y, diagram.vertex[v]) > nearest(y)) continue;
                CHECK(length_of(y, Point(cell.out_centre, cell.out_centre + D)) <= cell.out_radius * (1 + 1e-9L));
                CHECK(length_of(y, diagram.vertex[v]) <= cell.reach * (1 + 1e-9L));
            }
        }
        CHECK(shells == diagram.cage_count * 2 * D);
        CHECK(a.left_out == 0);
        CHECK(a.all.cells == diagram.vertex.size());
        CHECK(a.all.beta_max == doctest::Approx(beta_max).epsilon(1e-9));
        CHECK(a.all.beta_mean == doctest::Approx(beta_sum / static_cast<double>(a.all.cells)).epsilon(1e-9));
        CHECK(a.all.edges == edges.size());
    }
    CHECK(whole_cells > 50);
}
TEST_CASE_TEMPLATE_APPLY(each_cell, Dimensions<2, 3>);

// The statements with numbers of this test's own: betas of whole cells are recomputed above.
TEST_CASE_TEMPLATE_DEFINE("5.3.1, 5.3.3, 5.4.5 and 5.5.1 on hierarchical meshes", T, statements) {
    constexpr int D = T::value;
    for (const double gap : {10.0, 1e3, 1e9}) {
        Diagram<D> diagram(inputs::geometric(D, gap, 8), 2.5);
        REQUIRE(diagram.cage_count > 0);
        const FatnessAnalysis a = diagram.analysed();
        CHECK(violated_fatness_bound(a.all) == nullptr);
        Held<D>& held = diagram.held;
        FattestCells cells(held.store, held.domain, held.block.arena);
        std::vector<double> beta(diagram.vertex.size()), reach(diagram.vertex.size());
        for (VertexId v(0); v < held.state.vertex_count; ++v) {
            FatCell cell;
            auto piece = FattestCells::Piece::whole;
            REQUIRE(cells.measure(v, &cell, &piece) == Status::ok);
            beta[v] = cell.out_radius / cell.in_radius;
            reach[v] = cell.reach;
        }
        const double most = *std::max_element(beta.begin(), beta.end());
        const auto edges = diagram.edges();
        const double n = static_cast<double>(diagram.vertex.size()), pi = 3.14159265358979324;
        CHECK(static_cast<double>(edges.size()) <= std::pow(4 * most, D) * n);
        std::map<std::uint32_t, double> degree;
        for (const auto& [u, v] : edges) ++degree[u], ++degree[v];
        double degree_share = 0, planar_share = 0, corners_share = 0;
        for (std::uint32_t v = 0; v < diagram.vertex.size(); ++v) {
            double nearest = HUGE_VAL;
            for (std::uint32_t w = 0; w < diagram.vertex.size(); ++w)
                if (w != v)
                    nearest = std::min(nearest, static_cast<double>(length_of(diagram.vertex[v], diagram.vertex[w])));
            const double layers = std::floor(std::log2(2 * reach[v] / nearest)) + 1;
            degree_share = std::max(degree_share, degree[v] / (std::pow(8 * most, D) * layers));
            if (!diagram.is_whole(v)) continue;
            if (D == 2) planar_share = std::max(planar_share, degree[v] * std::asin(1 / (4 * most)) / (6 * pi));
            // S, the regular simplex in the unit ball of R^(D-1): a segment of length 2, a triangle of area 3 sqrt 3
            // / 4.
            const double ball = D == 2 ? 2 : pi, simplex = D == 2 ? 2 : 3 * std::sqrt(3.0) / 4;
            const double least = 2 * ball / (simplex * std::pow(2 * beta[v], D));
            corners_share = std::max(corners_share, least / static_cast<double>(diagram.star[v].size()));
        }
        CHECK(degree_share <= 1);
        CHECK(planar_share <= 1);
        CHECK(corners_share <= 1);
        CHECK(a.all.degree_share == doctest::Approx(degree_share).epsilon(1e-6));
        CHECK(a.all.planar_share == doctest::Approx(planar_share).epsilon(1e-6));
        CHECK(a.all.corners_share == doctest::Approx(corners_share).epsilon(1e-6));
    }
}
TEST_CASE_TEMPLATE_APPLY(statements, Dimensions<2, 3>);

// What chapters 4 and 5 are after: a superset of the inputs, of linear size whatever the gaps, with a fat diagram.
TEST_CASE_TEMPLATE_DEFINE("hierarchical meshes are fat and of linear size at all gaps", T, linear) {
    constexpr int D = T::value;
    std::vector<double> size, mean, largest;
    for (const double gap : {10.0, 30.0, 100.0, 1e3, 1e4, 1e6, 1e9}) {
        double vertices = 0, means = 0, most = 0;
        for (std::uint64_t seed = 1; seed <= 9; ++seed) {
            Diagram<D> diagram(inputs::geometric(D, gap, 12, seed), 2.5);
            const FatnessAnalysis a = diagram.analysed();
            CHECK(a.left_out == 0);
            CHECK(a.all.cells == diagram.vertex.size());
            vertices += static_cast<double>(diagram.vertex.size());
            means += a.all.beta_mean;
            most = std::max(most, a.all.beta_max);
        }
        size.push_back(vertices / 9 / 13);
        mean.push_back(means / 9);
        largest.push_back(most);
    }
    const auto spread = [](const std::vector<double>& x) {
        return *std::max_element(x.begin(), x.end()) / *std::min_element(x.begin(), x.end());
    };
    CHECK(spread(size) < 1.1);
    CHECK(spread(mean) < 1.1);
    CHECK(spread(largest) < 1.5);
}
TEST_CASE_TEMPLATE_APPLY(linear, Dimensions<2, 3>);

// Cells of shells and of inputs far out in a cage leave it, where the hull of its shell is nearer than the sphere. Of
// other sets the largest beta is one of chance, but not one of the gaps: clusters in clusters, and pairs, whose narrow
// gaps have no cages and fatter cells. Medians of some sets.
TEST_CASE_TEMPLATE_DEFINE("largest betas of other hierarchical meshes do not grow with the gaps", T, no_trend) {
    constexpr int D = T::value;
    const auto median_of = [](bool nested, double gap) {
        std::vector<double> largest;
        for (std::uint64_t seed = 1; seed <= 9; ++seed) {
            Diagram<D> diagram(nested ? inputs::nested(D, 4, 8, gap, seed) : inputs::close_pairs(D, 8, 1 / gap, seed),
                               2.5);
            const FatnessAnalysis a = diagram.analysed();
            CHECK(a.left_out == 0);
            CHECK(a.all.beta_max < (D == 2 ? 20 : 40));
            largest.push_back(a.all.beta_max);
        }
        std::sort(largest.begin(), largest.end());
        return largest[4];
    };
    for (const bool nested : {false, true}) {
        const double at_first = median_of(nested, 1e3);
        for (const double gap : {1e5, 1e7, 1e9}) CHECK(median_of(nested, gap) < 1.5 * at_first);
    }
}
TEST_CASE_TEMPLATE_APPLY(no_trend, Dimensions<2, 3>);
