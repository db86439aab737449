// Diagrams of a few points by brute force and from definitions alone, in integers of any length. No code of the engine,
// no triangulation, no float: doubles are read exactly at the beginning and made by correct rounding at the end.
//
// A cover of space by convex sets that grow is given by a list of sets of points, the masks of its members: a member
// with mask M is the set of places within r of all points of M. Members meet where the places within r of the union of
// their masks are, so a simplex of the nerve enters at the radius of the smallest ball that encloses this union. By the
// nerve theorem
//   masks of one point    give the diagram of the union of balls: that of the Cech complex, and of the alpha complex;
//   masks of k points     give the diagram of the places within r of k points: the sublevel sets of the distance to the
//                         k-th nearest point.
// With half of the longest edge for the radius of a set, masks of one point give the Rips complex; masks of k points
// give what is homotopy equivalent to the nested sets of at least k points (a set of k-subsets goes to its union, and a
// set of points to all its k-subsets: a Galois connection of the two orders).
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace exact {

using Set = std::uint32_t;  // of points: bit i is point i
constexpr std::size_t points_max = 12;

inline int size_of(Set set) {
    int count = 0;
    for (; set != 0; set &= set - 1) ++count;
    return count;
}

// A bar as netmesh_pair has it; death is infinite for an essential class.
struct Bar {
    std::uint32_t degree;
    double birth, death;
};
inline std::uint64_t bits_of(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}
// Equal are doubles with equal bits.
inline bool operator==(const Bar& a, const Bar& b) {
    return a.degree == b.degree && bits_of(a.birth) == bits_of(b.birth) && bits_of(a.death) == bits_of(b.death);
}
inline bool operator<(const Bar& a, const Bar& b) {
    if (a.degree != b.degree) return a.degree < b.degree;
    if (bits_of(a.birth) != bits_of(b.birth)) return bits_of(a.birth) < bits_of(b.birth);
    return bits_of(a.death) < bits_of(b.death);
}
using Bars = std::vector<Bar>;

// over / under >= 0, in squares of the cloud's unit.
struct Square {
    mpz_class over, under = 1;
};
inline int order(const Square& a, const Square& b) { return cmp(a.over * b.under, b.over * a.under); }

// value * 2^shift for shift of any sign goes on the side where it is whole.
inline void scale(mpz_class* over, mpz_class* under, long shift) {
    if (shift >= 0) {
        *over <<= static_cast<unsigned long>(shift);
    } else {
        *under <<= static_cast<unsigned long>(-shift);
    }
}

// The double nearest to 2^unit sqrt(square), ties to even; infinite from half a unit above the largest double on. With
// m units u just below the root, it is at least (m + 1/2) u where 4 square >= (2 m + 1)^2 u^2: integers decide.
inline double nearest_root(const Square& square, long unit) {
    if (square.over == 0) return 0;
    const long length =
        static_cast<long>(mpz_sizeinbase(square.over.get_mpz_t(), 2)) -
        static_cast<long>(mpz_sizeinbase(square.under.get_mpz_t(), 2));  // 2^(length - 1) < square < 2^(length + 1)
    const long half = length - 1 >= 0 ? (length - 1) / 2 : -((2 - length) / 2);
    mpz_class over, under, m;
    for (long u = std::max(half + unit - 53, -1074L);; ++u) {
        over = square.over;
        under = square.under;
        scale(&over, &under, 2 * (unit - u));
        m = sqrt(mpz_class(over / under));
        if (mpz_sizeinbase(m.get_mpz_t(), 2) > 53) continue;
        const mpz_class middle = 2 * m + 1;
        const int side = cmp(4 * over, middle * middle * under);
        if (side > 0 || (side == 0 && mpz_odd_p(m.get_mpz_t()))) ++m;
        return std::ldexp(m.get_d(), static_cast<int>(u));  // m <= 2^53: exact, or beyond the largest double
    }
}

// c = m 2^e with an odd m: e. Of c != 0.
inline long unit_of(double c) {
    int e;
    std::int64_t m = static_cast<std::int64_t>(std::ldexp(std::frexp(c, &e), 53));
    e -= 53;
    while (m % 2 == 0) m /= 2, ++e;
    return e;
}
// The largest unit that all are multiples of; 0 of zeros.
inline long common_unit(const std::vector<double>& numbers) {
    long unit = std::numeric_limits<long>::max();
    for (const double c : numbers)
        if (c != 0) unit = std::min(unit, unit_of(c));
    return unit == std::numeric_limits<long>::max() ? 0 : unit;
}
// c / 2^unit.
inline mpz_class whole(double c, long unit) {
    if (c == 0) return 0;
    int e;
    const mpz_class m(std::ldexp(std::frexp(c, &e), 53));
    const long shift = e - 53 - unit;
    if (shift >= 0) return m << static_cast<unsigned long>(shift);
    return m >> static_cast<unsigned long>(-shift);  // what is cut are zeros
}

// Coordinates as integers: x = whole * 2^unit, the largest unit that all are multiples of.
struct Cloud {
    int dim;
    long unit = 0;
    std::vector<std::vector<mpz_class>> points;  // different ones, in the order of their first rows

    Cloud(int d, const std::vector<double>& x) : dim(d) {
        const std::size_t columns = static_cast<std::size_t>(d);
        std::vector<std::vector<double>> rows;
        for (std::size_t i = 0; i < x.size(); i += columns) {
            std::vector<double> row(x.begin() + static_cast<std::ptrdiff_t>(i),
                                    x.begin() + static_cast<std::ptrdiff_t>(i + columns));
            for (double& c : row) {
                if (!std::isfinite(c)) throw std::invalid_argument("a coordinate is not finite");
                c += 0.0;  // -0 is 0
            }
            if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
        }
        if (rows.empty() || rows.size() > points_max) throw std::invalid_argument("1 to 12 different points");
        unit = common_unit(x);
        for (const auto& row : rows) {
            std::vector<mpz_class> point;
            for (const double c : row) point.push_back(whole(c, unit));
            points.push_back(point);
        }
    }
    std::size_t count() const { return points.size(); }
    mpz_class distance_squared(std::size_t a, std::size_t b) const {
        mpz_class sum = 0;
        for (std::size_t c = 0; c < points[a].size(); ++c) {
            const mpz_class d = points[a][c] - points[b][c];
            sum += d * d;
        }
        return sum;
    }
    // Bits of the largest difference of coordinates.
    std::size_t spread_bits() const {
        mpz_class widest = 0;
        for (std::size_t a = 0; a < count(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                for (std::size_t c = 0; c < points[a].size(); ++c)
                    widest = std::max(widest, mpz_class(abs(points[a][c] - points[b][c])));
        return mpz_sizeinbase(widest.get_mpz_t(), 2);
    }
};

// A value of each set of points: the different ones ascending, exact and rounded, and their indices.
struct Levels {
    std::vector<Square> squares;
    std::vector<double> rounded;
    std::vector<std::uint32_t> of_set;  // [2^n]; of the empty set nothing is meant

    // From squares of sets in any order, `of_set` being indices into them.
    void arrange(long unit) {
        std::vector<std::uint32_t> by_value(squares.size()), rank(squares.size());
        for (std::uint32_t i = 0; i < by_value.size(); ++i) by_value[i] = i;
        std::sort(by_value.begin(), by_value.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return order(squares[a], squares[b]) < 0; });
        std::vector<Square> ascending;
        for (const std::uint32_t i : by_value) {
            if (ascending.empty() || order(ascending.back(), squares[i]) != 0) ascending.push_back(squares[i]);
            rank[i] = static_cast<std::uint32_t>(ascending.size() - 1);
        }
        for (std::uint32_t& i : of_set) i = rank[i];
        squares.swap(ascending);
        for (const Square& s : squares) rounded.push_back(nearest_root(s, unit));
    }
    double value(Set set) const { return rounded[of_set[set]]; }
};

// Half of the longest edge of each set, of n points with squares[n][n] of distances.
inline Levels edge_levels(std::size_t n, const std::vector<mpz_class>& squares, long unit) {
    Levels levels;
    levels.squares.push_back({0, 4});
    std::vector<std::uint32_t> edge(n * n, 0);
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            edge[a * n + b] = static_cast<std::uint32_t>(levels.squares.size());
            levels.squares.push_back({squares[a * n + b], 4});
        }
    for (Set set = 0; set < Set(1) << n; ++set) {
        std::uint32_t longest = 0;
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < a; ++b)
                if ((set >> a & 1) != 0 && (set >> b & 1) != 0 &&
                    levels.squares[longest].over < levels.squares[edge[a * n + b]].over)
                    longest = edge[a * n + b];
        levels.of_set.push_back(longest);
    }
    levels.arrange(unit);
    return levels;
}

// The ball that has an affinely independent set of points on its boundary and its centre in their hull's plane.
struct Circumball {
    Set on = 0;
    bool centred = false;      // all barycentric coordinates of the centre are positive
    Set within = 0, less = 0;  // points in the closed and in the open ball
    Square squared;
};

// The smallest enclosing balls of the sets of a cloud, and their longest edges.
class Balls {
public:
    explicit Balls(const Cloud& cloud) : cloud_(cloud), n_(cloud.count()) {
        squares_.resize(n_ * n_);
        for (std::size_t a = 0; a < n_; ++a)
            for (std::size_t b = 0; b < a; ++b)
                squares_[a * n_ + b] = squares_[b * n_ + a] = cloud.distance_squared(a, b);
        const Set all = (Set(1) << n_) - 1;
        rips = edge_levels(n_, squares_, cloud.unit);
        if (cloud.dim > dim_max) return;
        for (Set set = 1; set <= all; ++set) {
            if (size_of(set) > cloud.dim + 1) continue;
            Circumball ball;
            if (circumscribe(set, &ball)) {
                balls.push_back(ball);
                rank = std::max(rank, size_of(set) - 1);
            }
        }
        enclose(all);
    }

    static constexpr int dim_max = 6;  // in more dimensions there are edges alone
    std::vector<Circumball> balls;     // of the affinely independent sets
    int rank = 0;                      // dimension of the affine hull
    Levels cech;                       // the smallest enclosing ball of each set
    Levels rips;                       // half of its longest edge

    const mpz_class& square(std::size_t a, std::size_t b) const { return squares_[a * n_ + b]; }

    // The smallest ball that has the points of `set` on its boundary and none of the cloud inside: how a simplex
    // enters an alpha complex. False where there is none.
    bool alpha(Set set, double* value) const {
        const Square* least = nullptr;
        for (const Circumball& ball : balls)
            if ((set & ~ball.on) == 0 && ball.less == 0 && (least == nullptr || order(ball.squared, *least) < 0))
                least = &ball.squared;
        if (least == nullptr) return false;
        *value = nearest_root(*least, cloud_.unit);
        return true;
    }

private:
    // With p the first point, v_i the vectors from it to the others and c - p = sum x_i v_i, c is as far from all when
    // sum_j (2 v_i v_j) x_j = v_i v_i. Gauss and Jordan in integers (Bareiss); the diagonal ends as the determinant,
    // the last column as the determinant times x. False when the points are affinely dependent.
    bool circumscribe(Set set, Circumball* ball) const {
        std::vector<std::size_t> v;
        for (std::size_t i = 0; i < n_; ++i)
            if ((set >> i & 1) != 0) v.push_back(i);
        const std::size_t p = v[0], k = v.size() - 1;
        mpz_class a[dim_max][dim_max + 1], last = 1, t;
        for (std::size_t i = 0; i < k; ++i) {
            for (std::size_t j = 0; j < k; ++j)
                a[i][j] = square(p, v[i + 1]) + square(p, v[j + 1]) - square(v[i + 1], v[j + 1]);
            a[i][k] = square(p, v[i + 1]);
        }
        for (std::size_t s = 0; s < k; ++s) {
            if (a[s][s] == 0) return false;  // a leading minor of a Gram matrix
            for (std::size_t i = 0; i < k; ++i) {
                if (i == s) continue;
                for (std::size_t j = s + 1; j <= k; ++j) {
                    t = a[s][s] * a[i][j] - a[i][s] * a[s][j];
                    mpz_divexact(a[i][j].get_mpz_t(), t.get_mpz_t(), last.get_mpz_t());
                }
                if (i < s) a[i][i] = a[s][s];
            }
            last = a[s][s];
        }
        const mpz_class& determinant = last;
        ball->on = set;
        ball->squared.over = 0;
        ball->squared.under = 2 * determinant;
        mpz_class rest = determinant;
        ball->centred = true;
        for (std::size_t i = 0; i < k; ++i) {
            ball->squared.over += a[i][k] * square(p, v[i + 1]);
            rest -= a[i][k];
            ball->centred = ball->centred && a[i][k] > 0;
        }
        ball->centred = ball->centred && rest > 0;
        // |q - c| <= |p - c|  <=>  |q - p|^2 <= 2 (q - p)(c - p)
        for (std::size_t q = 0; q < n_; ++q) {
            mpz_class side = determinant * square(p, q);
            for (std::size_t i = 0; i < k; ++i)
                side -= a[i][k] * (square(p, q) + square(p, v[i + 1]) - square(q, v[i + 1]));
            if (side <= 0) ball->within |= Set(1) << q;
            if (side < 0) ball->less |= Set(1) << q;
        }
        return true;
    }

    // A ball whose centre is inside the hull of points on its boundary is the smallest that encloses these, and any
    // other points that it contains with them. Each set has such a ball; where it has several they are equal.
    void enclose(Set all) {
        constexpr std::uint32_t none = UINT32_MAX;
        cech.of_set.assign(all + 1, none);
        for (const Circumball& ball : balls) {
            if (!ball.centred) continue;
            const std::uint32_t index = static_cast<std::uint32_t>(cech.squares.size());
            cech.squares.push_back(ball.squared);
            const Set others = ball.within & ~ball.on;
            for (Set more = others;; more = (more - 1) & others) {
                std::uint32_t& of = cech.of_set[ball.on | more];
                if (of != none && order(cech.squares[of], ball.squared) != 0)
                    throw std::logic_error("two smallest enclosing balls");
                of = index;
                if (more == 0) break;
            }
        }
        cech.of_set[0] = 0;
        for (const std::uint32_t of : cech.of_set)
            if (of == none) throw std::logic_error("no smallest enclosing ball");
        cech.arrange(cloud_.unit);
    }

    const Cloud& cloud_;
    std::size_t n_;
    std::vector<mpz_class> squares_;
};

// All simplices of up to `size` of m vertices, by size and then in the order of their lists of vertices.
struct Skeleton {
    struct Simplex {
        std::vector<std::uint32_t> vertices, facets;  // facets: indices of simplices; none of a vertex
    };
    std::vector<Simplex> simplices;

    Skeleton(std::uint32_t m, std::uint32_t size) {
        std::map<std::vector<std::uint32_t>, std::uint32_t> place;
        for (std::uint32_t s = 1; s <= std::min(size, m); ++s) {
            std::vector<std::uint32_t> v(s);
            for (std::uint32_t i = 0; i < s; ++i) v[i] = i;
            for (;;) {
                Simplex simplex;
                simplex.vertices = v;
                for (std::uint32_t i = 0; i < s && s > 1; ++i) {
                    std::vector<std::uint32_t> facet = v;
                    facet.erase(facet.begin() + i);
                    simplex.facets.push_back(place.at(facet));
                }
                place[v] = static_cast<std::uint32_t>(simplices.size());
                simplices.push_back(simplex);
                std::uint32_t i = s;
                while (i > 0 && v[i - 1] == m - s + i - 1) --i;
                if (i == 0) break;
                ++v[i - 1];
                for (; i < s; ++i) v[i] = v[i - 1] + 1;
            }
        }
    }
    static std::size_t count(std::size_t m, std::size_t size) {
        std::size_t sum = 0, choose = 1;
        for (std::size_t s = 1; s <= std::min(size, m); ++s) {
            choose = choose * (m - s + 1) / s;
            sum += choose;
        }
        return sum;
    }
    // Made once.
    static const Skeleton& of(std::uint32_t m, std::uint32_t size) {
        static std::map<std::pair<std::uint32_t, std::uint32_t>, Skeleton> made;
        const auto key = std::make_pair(m, std::min(size, m));
        const auto found = made.find(key);
        return found != made.end() ? found->second : made.emplace(key, Skeleton(m, size)).first->second;
    }
};

struct Truth {
    Bars bars;               // sorted
    std::size_t hidden = 0;  // bars of positive length whose ends are one double
    std::size_t close = 0;   // bars whose ends are neighbouring doubles
};

// Degrees 0..max_degree of the nerve of members `masks`, whose simplices enter at the levels of the unions of their
// masks. The standard algorithm: columns from the left to the right, each reduced by those before it. The order of
// entry is that of the exact levels, then of dimensions, then of the list.
inline Truth nerve_diagram(const std::vector<Set>& masks, const Levels& levels, std::uint32_t max_degree) {
    const Skeleton& skeleton = Skeleton::of(static_cast<std::uint32_t>(masks.size()), max_degree + 2);
    const std::size_t count = skeleton.simplices.size(), words = (count + 63) / 64;
    std::vector<std::uint32_t> level(count), entry(count), place(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        Set together = 0;
        for (const std::uint32_t v : skeleton.simplices[i].vertices) together |= masks[v];
        level[i] = levels.of_set[together];
        entry[i] = i;
    }
    std::stable_sort(entry.begin(), entry.end(), [&](std::uint32_t a, std::uint32_t b) {
        return level[a] != level[b] ? level[a] < level[b]
                                    : skeleton.simplices[a].vertices.size() < skeleton.simplices[b].vertices.size();
    });
    for (std::uint32_t j = 0; j < count; ++j) place[entry[j]] = j;

    Truth truth;
    const auto note = [&](std::size_t i, const std::size_t* j) {
        const std::uint32_t degree = static_cast<std::uint32_t>(skeleton.simplices[entry[i]].vertices.size() - 1);
        if (degree > max_degree) return;
        const double birth = levels.rounded[level[entry[i]]];
        const double death = j ? levels.rounded[level[entry[*j]]] : std::numeric_limits<double>::infinity();
        if (j != nullptr && level[entry[i]] == level[entry[*j]]) return;
        if (bits_of(birth) == bits_of(death)) {
            ++truth.hidden;
            return;
        }
        truth.close += bits_of(birth) + 1 == bits_of(death);
        truth.bars.push_back({degree, birth, death});
    };

    constexpr std::uint32_t none = UINT32_MAX;
    std::vector<std::vector<std::uint64_t>> column(count);
    std::vector<std::uint32_t> with_lowest(count, none);
    std::vector<bool> killed(count);
    std::vector<std::size_t> positive;
    for (std::size_t j = 0; j < count; ++j) {
        std::vector<std::uint64_t> sum(words);
        for (const std::uint32_t facet : skeleton.simplices[entry[j]].facets)
            sum[place[facet] / 64] ^= std::uint64_t(1) << place[facet] % 64;
        std::size_t word = words;
        std::uint32_t lowest = none;
        for (;;) {
            while (word > 0 && sum[word - 1] == 0) --word;
            if (word == 0) break;
            std::uint32_t bit = 63;
            while ((sum[word - 1] >> bit & 1) == 0) --bit;
            lowest = static_cast<std::uint32_t>(64 * (word - 1) + bit);
            const std::uint32_t other = with_lowest[lowest];
            if (other == none) break;
            for (std::size_t w = 0; w < word; ++w) sum[w] ^= column[other][w];
        }
        if (word == 0) {
            positive.push_back(j);
            continue;
        }
        with_lowest[lowest] = static_cast<std::uint32_t>(j);
        column[j] = std::move(sum);
        killed[lowest] = true;
        note(lowest, &j);
    }
    for (const std::size_t j : positive)
        if (!killed[j]) note(j, nullptr);
    std::sort(truth.bars.begin(), truth.bars.end());
    return truth;
}

// The masks of all sets of k of n points.
inline std::vector<Set> members(std::size_t n, int k) {
    std::vector<Set> masks;
    for (Set set = 1; set < Set(1) << n; ++set)
        if (size_of(set) == k) masks.push_back(set);
    return masks;
}

// Simplices of the nerve that nerve_diagram would reduce.
inline std::size_t nerve_size(std::size_t n, int k, std::uint32_t max_degree) {
    std::size_t choose = 1;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(k); ++i) choose = choose * (n - i + 1) / i;
    return Skeleton::count(choose, max_degree + 2);
}

}  // namespace exact
