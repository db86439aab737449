// The nerve of clipped cells in exact rationals, from its definition.
//
// A simplex s of the triangulation is in the nerve when the least distance m from o to F_s, the points that are as near
// to the vertices of s as to each other and to all points, is at most r. The nearest point of F_s lies inside of some
// face of it, whose points are nearest to a set of points with s among them, and is the point nearest to o of the flat
// equidistant from those, or from D+1 or fewer of them that are affinely independent, with s. So m(s) is the least of
// |x_t - o| over all independent sets t of points with s in t whose x_t no point is nearer to than t.
//
//     NETMESH_NERVE_SETS=100 oracle_clipped_nerve     so many sets in each dimension; 12 otherwise
#include "mesh/clip/clipped_nerve.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/nerve.hpp"
#include "common/simplices.hpp"
#include "delaunay/sphere.hpp"
#include "delaunay/triangulate.hpp"
#include "mesh/clip/equal_foot.hpp"

using namespace netmesh;

namespace {

using Rational = mpq_class;

struct Count {
    int balls = 0, ties = 0, uncertain = 0, partial = 0;
    std::size_t simplices = 0;
};

int sets_asked() {
    const char* const asked = std::getenv("NETMESH_NERVE_SETS");
    return asked != nullptr ? std::atoi(asked) : 12;
}

using Vector = std::vector<Rational>;

template <int D> Vector from(const double* origin, const double* x) {
    Vector v;
    for (int k = 0; k < D; ++k) v.push_back(Rational(x[k]) - Rational(origin[k]));
    return v;
}
Rational norm2(const Vector& a) {
    Rational sum;
    for (const Rational& x : a) sum += x * x;
    return sum;
}
Rational edge(const std::vector<Vector>& at, std::size_t i, std::size_t k) { return at[i + 1][k] - at[0][k]; }

// x = sum of factor_i (v_i - v_0), the origin being o, with (v_i - v_0).x = (|v_i|^2 - |v_0|^2) / 2. False when the
// points are dependent.
bool nearest_equidistant(const std::vector<Vector>& at, Rational* x) {
    const std::size_t n = at.size() - 1, dim = at[0].size();
    std::vector<Vector> a(n, Vector(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = 0; k < dim; ++k) a[i][j] += edge(at, i, k) * edge(at, j, k);
        a[i][n] = (norm2(at[i + 1]) - norm2(at[0])) / 2;
    }
    for (std::size_t p = 0; p < n; ++p) {
        if (a[p][p] == 0) return false;  // positive semidefinite
        for (std::size_t i = 0; i < n; ++i) {
            if (i == p || a[i][p] == 0) continue;
            const Rational factor = a[i][p] / a[p][p];
            for (std::size_t j = p; j <= n; ++j) a[i][j] -= factor * a[p][j];
        }
    }
    for (std::size_t k = 0; k < dim; ++k) {
        x[k] = 0;
        for (std::size_t i = 0; i < n; ++i) x[k] += a[i][n] / a[i][i] * edge(at, i, k);
    }
    return true;
}

// Squares of m for all simplices.
template <int D> class Truth {
public:
    Truth(const Store<D>& store, const Simplices& all, const double* centre) : count_(store.state.vertex_count) {
        for (std::uint32_t v = 0; v < count_; ++v) {
            at_.push_back(from<D>(centre, store.point(v)));
            square_.push_back(norm2(at_[v]));
        }
        for (const Simplex& s : all) m2[s] = -1;
        Simplex t;
        visit(&t, 0);
    }

    std::map<Simplex, Rational> m2;

private:
    // All sets that begin with t and go on with vertices from `next` on.
    void visit(Simplex* t, std::uint32_t next) {
        if (!t->empty()) show(*t);
        if (t->size() == D + 1) return;
        for (std::uint32_t v = next; v < count_; ++v) {
            t->push_back(v);
            visit(t, v + 1);
            t->pop_back();
        }
    }

    void show(const Simplex& t) {
        Rational x[D];
        std::vector<Vector> at;
        for (const std::uint32_t v : t) at.push_back(at_[v]);
        if (!nearest_equidistant(at, x)) return;
        // |x - v|^2 - |x|^2
        const auto power = [&](std::uint32_t v) {
            Rational sum = square_[v];
            for (int k = 0; k < D; ++k) sum -= 2 * x[k] * at_[v][static_cast<std::size_t>(k)];
            return sum;
        };
        const Rational own = power(t[0]);
        for (std::uint32_t v = 0; v < count_; ++v)
            if (power(v) < own) return;
        Rational away2;
        for (int k = 0; k < D; ++k) away2 += x[k] * x[k];
        Simplices faces;
        add_faces(t, &faces);
        for (const Simplex& s : faces) {
            const auto found = m2.find(s);
            if (found != m2.end() && (found->second < 0 || away2 < found->second)) found->second = away2;
        }
    }

    std::uint32_t count_;
    std::vector<Vector> at_;  // relative to o
    std::vector<Rational> square_;
};

template <int D>
void compare(Store<D>& store, const Domain<D>& ball, const Work& work, const Simplices& all, const Truth<D>& truth,
             Count* count) {
    CAPTURE(ball.radius);
    const Rational r2 = Rational(ball.radius) * Rational(ball.radius);
    Simplices expected;
    bool tie = false;
    for (const auto& [s, m2] : truth.m2) {
        REQUIRE(sgn(m2) >= 0);
        if (m2 <= r2) expected.insert(s);
        tie |= m2 == r2;
    }
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    Subcomplex<D> part;
    bool certain = false;
    REQUIRE(find_nerve<D>(store, ball, work, &part, &certain) == Status::ok);
    ++count->balls;
    if (tie) {
        ++count->ties;
        CHECK(!certain);
    }
    if (certain) {
        count->simplices += expected.size();
        count->partial += !expected.empty() && expected.size() < all.size();
        CHECK((simplices_of<D>(store, part, all) == expected));
        std::vector<bool> in(store.state.vertex_count, false), out(in);
        for (const Simplex& s : all)
            for (const std::uint32_t v : s) (expected.count(s) != 0 ? in : out)[v] = true;
        for (std::uint32_t v = 0; v < store.state.vertex_count; ++v)
            CHECK(int(part.vertex[v]) == (!in[v] ? VertexPart::absent : out[v] ? VertexPart::cut : VertexPart::whole));
    } else {
        count->uncertain += !tie;
        CHECK(work.arena.low_mark() == low);
    }
    CHECK(work.arena.high_mark() == high);
    work.arena.release_low(low);
}

// Records of cells as bad as they may be: centres off by any part of their radius, and errors that say so, or nothing
// known.
template <int D> void blur(Store<D>& store, inputs::Random& random) {
    for (CellId c(0); c < store.state.cell_slots; ++c) {
        Cell<D>& cell = store.cell(c);
        const double share = std::ldexp(1.0, -2 - static_cast<int>(random.below(30)));
        const bool unknown = random.below(8) == 0 || !(cell.radius2 < HUGE_VAL);
        const double off = share * std::sqrt(cell.radius2 / D) * 0.7;
        for (int k = 0; k < D; ++k)
            cell.centre[k] = unknown ? store.point(cell.vertex[0])[k] : cell.centre[k] + (random.below(2) ? off : -off);
        cell.radius2 = unknown ? HUGE_VAL : distance2<D>(cell.centre, store.point(cell.vertex[0]));
        cell.error = unknown ? HUGE_VALF : cell.error * 2 + static_cast<float>(share);
    }
}

// Four balls: radii between those at which the nerve changes, close above one of them, and exactly there where that is
// a double.
template <int D> void try_set(const inputs::Points& points, std::uint64_t seed, Count* count) {
    Block block(std::size_t{1} << 24);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport report;
    const Status status = triangulate<D>(store, points.data(), points.size() / D, seed, monitor, &report);
    if (status == Status::flat) return;
    REQUIRE(status == Status::ok);
    recompute_balls<D>(store);
    const Simplices all = simplices_of<D>(store);
    inputs::Random random(seed);
    if (seed % 2 == 1) blur<D>(store, random);
    for (int centre = 0; centre < 2; ++centre) {
        Domain<D> ball = {};
        // A point of the grid of eighths about the middle, or any.
        for (int k = 0; k < D; ++k) {
            double low = points[static_cast<std::size_t>(k)], high = low;
            for (std::size_t i = static_cast<std::size_t>(k); i < points.size(); i += D) {
                low = std::min(low, points[i]);
                high = std::max(high, points[i]);
            }
            const double share = centre == 0 ? 0.125 * static_cast<double>(2 + random.below(5)) : random.uniform();
            ball.centre[k] = low + share * (high - low);
        }
        const Truth<D> truth(store, all, ball.centre);
        std::vector<double> radii;
        for (const auto& [s, m2] : truth.m2) radii.push_back(std::sqrt(m2.get_d()));
        std::sort(radii.begin(), radii.end());
        const double here = radii[random.below(radii.size())];
        const auto above = std::upper_bound(radii.begin(), radii.end(), here * (1 + 1e-9));
        ball.radius = above == radii.end() ? 2 * here : (here + *above) / 2;
        compare<D>(store, ball, {block.arena, monitor}, all, truth, count);
        ball.radius = here * ((seed + seed / 6) % 3 == 0 ? 1 : seed % 2 == 1 ? 1 + 1e-11 : 1 - 1e-11);
        compare<D>(store, ball, {block.arena, monitor}, all, truth, count);
    }
}

template <int D> inputs::Points points_of(int kind, std::uint64_t seed) {
    inputs::Random random(seed);
    const std::size_t n = D == 2 ? 8 + random.below(23) : D == 3 ? 8 + random.below(11) : 8 + random.below(6);
    inputs::Points points;
    switch (kind) {
    case 0: return inputs::uniform(D, n, seed);
    case 1:  // of a small grid
        for (std::size_t i = 0; i < n * D; ++i) points.push_back(static_cast<double>(random.below(D == 2 ? 5 : 3)));
        return points;
    case 2: return inputs::shell(D, n, 1, 1, seed);
    case 3: return inputs::clusters(D, n, seed);
    case 4: return inputs::jittered(D, 2, 0x1p-48, seed);
    case 5:  // nearly in a plane: Voronoi edges through the ball have their ends far outside
        points = inputs::uniform(D, n, seed);
        for (std::size_t i = 0; i < points.size(); i += D) points[i] *= 0x1p-10;
        return points;
    default:  // corners of a box and some points in it
        points = inputs::grid(D, 2);
        for (std::size_t i = 0; i < 2 * D; ++i) points.push_back(random.uniform());
        return points;
    }
}

template <int D> void try_sets() {
    Count count;
    const int sets = sets_asked();
    for (int set = 0; set < sets; ++set) {
        CAPTURE(set);
        try_set<D>(points_of<D>(set % 7, static_cast<std::uint64_t>(set + 1)), static_cast<std::uint64_t>(set), &count);
    }
    MESSAGE("D = " << D << ": " << count.balls << " balls, " << count.partial << " with a part of the simplices, "
                   << count.simplices << " simplices in, " << count.ties << " at a radius of a change, "
                   << count.uncertain << " others not certain");
    CHECK(count.partial * 4 > count.balls);
    CHECK(count.uncertain == 0);
}

struct Answers {
    int asked = 0, known = 0, wrong = 0;
    void count(int answer, int truth) {
        ++asked;
        known += answer != 0;
        wrong += answer != 0 && answer != truth;
    }
};

// Simplices of any flatness, radii and points that are any little bit off the distance in question.
template <int D> void try_feet(int trials) {
    inputs::Random random(D);
    Answers beyond[2], nearer[2];  // in doubles, in 1,024 bits
    for (int trial = 0; trial < trials; ++trial) {
        const int n = 2 + static_cast<int>(random.below(D));
        const auto bit = [&](std::uint64_t most) { return std::ldexp(1.0, -static_cast<int>(random.below(most))); };
        const double size = bit(30), flat = bit(50);
        double x[D + 1][D], w[D];
        const double* point[D + 1];
        for (int i = 0; i < n; ++i) {
            point[i] = x[i];
            const double share = random.uniform();
            for (int k = 0; k < D; ++k) {
                const double edge = 2 * random.uniform() - 1;
                x[i][k] = i == 0   ? edge
                          : i == 1 ? x[0][k] + size * edge
                          : i == 2 ? x[0][k] + share * (x[1][k] - x[0][k]) + flat * size * edge
                                   : x[0][k] + bit(10) * edge;
            }
        }
        Domain<D> ball = {};
        for (double& c : ball.centre) c = 2 * random.uniform() - 1;
        std::vector<Vector> at;
        for (int i = 0; i < n; ++i) at.push_back(from<D>(ball.centre, point[i]));
        Vector foot(D);
        if (!nearest_equidistant(at, foot.data())) continue;
        const double sign = random.below(2) == 0 ? 1 : -1;
        ball.radius = std::sqrt(norm2(foot).get_d()) * (1 + sign * bit(54));
        if (ball.radius == 0) ball.radius = bit(200);  // balls are not points
        // About as far from the foot as the vertices are.
        double away[D], length2 = 0;
        for (double& a : away) {
            a = 2 * random.uniform() - 1;
            length2 += a * a;
        }
        Vector to_vertex(D), to_w(D);
        for (std::size_t k = 0; k < D; ++k) to_vertex[k] = at[0][k] - foot[k];
        const double stretch = std::sqrt(norm2(to_vertex).get_d() / length2) * (1 + sign * bit(54));
        for (std::size_t k = 0; k < D; ++k) {
            w[k] = ball.centre[k] + foot[k].get_d() + stretch * away[k];
            to_w[k] = Rational(w[k]) - Rational(ball.centre[k]) - foot[k];
        }
        const int is_beyond = sgn(norm2(foot) - Rational(ball.radius) * Rational(ball.radius));
        const int is_nearer = sgn(norm2(to_vertex) - norm2(to_w));
        const EqualFoot<double> fast(ball, point, n);
        const EqualFoot<WideFloat> slow(ball, point, n);
        beyond[0].count(fast.beyond(), is_beyond);
        beyond[1].count(slow.beyond(), is_beyond);
        nearer[0].count(fast.nearer(w), is_nearer);
        nearer[1].count(slow.nearer(w), is_nearer);
    }
    for (int k = 0; k < 2; ++k) {
        CAPTURE(k);
        CHECK(beyond[k].wrong == 0);
        CHECK(nearer[k].wrong == 0);
        const double share = k == 0 ? 0.3 : 1;
        CHECK(beyond[k].known >= share * beyond[k].asked);
        CHECK(nearer[k].known >= share * nearer[k].asked);
        MESSAGE("D = " << D << ": " << beyond[k].known << " and " << nearer[k].known << " of " << beyond[k].asked
                       << " answers");
    }
}

}  // namespace

TEST_CASE("certain answers are right") {
    try_feet<2>(3000);
    try_feet<3>(3000);
    for_each_dimension<4, 4>([](auto dim) { try_feet<dim>(3000); });
}

TEST_CASE("plane") { try_sets<2>(); }
TEST_CASE("space") { try_sets<3>(); }
TEST_CASE("four dimensions") {
    for_each_dimension<4, 4>([](auto dim) { try_sets<dim>(); });
}
