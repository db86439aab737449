// Diagrams of a few weighted points by brute force and from definitions alone, in rationals. No code of the engine, no
// triangulation, no float: doubles are read exactly at the beginning and made by correct rounding at the end.
//
// The union of the balls { x : |x - p|^2 - w <= a } has, by the nerve theorem, the homology of the nerve of these
// balls, hidden ones included. A set S of points is a simplex from the least a on at which its balls meet: the minimum
// over x of the largest power. That is a convex function of x, so it is the greatest such minimum of an affinely
// independent subset whose orthogonal centre, the point of their affine hull with equal powers of all, is in their
// convex hull.
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace weights {

using Set = std::uint32_t;
using Numbers = std::vector<double>;

struct Bar {
    std::uint32_t degree;
    double birth, death;
};
inline std::uint64_t bits_of(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}
inline bool operator==(const Bar& a, const Bar& b) {
    return a.degree == b.degree && bits_of(a.birth) == bits_of(b.birth) && bits_of(a.death) == bits_of(b.death);
}
inline bool operator<(const Bar& a, const Bar& b) {
    if (a.degree != b.degree) return a.degree < b.degree;
    return a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
}
using Bars = std::vector<Bar>;

// (whole + something below 1, if there is more) 2^unit, to the nearest double, ties to even. whole has 64 bits or more.
inline double rounded(const mpz_class& whole, bool is_more, long unit) {
    const long length = static_cast<long>(mpz_sizeinbase(whole.get_mpz_t(), 2));
    const long last = std::max(unit + length - 53, -1074L);
    const unsigned long shift = static_cast<unsigned long>(last - unit);
    mpz_class kept = whole >> shift;
    const mpz_class rest = whole - (kept << shift), half = mpz_class(1) << (shift - 1);
    if (rest > half || (rest == half && (is_more || mpz_odd_p(kept.get_mpz_t())))) ++kept;
    return std::ldexp(kept.get_d(), static_cast<int>(std::min(last, 5000L)));
}
// sign(a) sqrt(|a|), or a itself.
inline double value_of(const mpq_class& a, bool squares) {
    if (a == 0) return 0;
    mpz_class over = abs(a.get_num()), under = a.get_den();
    const long length = static_cast<long>(mpz_sizeinbase(over.get_mpz_t(), 2)) -
                        static_cast<long>(mpz_sizeinbase(under.get_mpz_t(), 2));
    // over / under in units of 2^(2 unit), or 2^unit.
    long unit = squares ? length - 150 : (length - 300) / 2;
    const long shift = squares ? unit : 2 * unit;
    if (shift < 0)
        over <<= static_cast<unsigned long>(-shift);
    else
        under <<= static_cast<unsigned long>(shift);
    mpz_class whole = over / under;
    bool is_more = whole * under != over;
    if (!squares) {
        const mpz_class root = sqrt(whole);
        is_more = is_more || root * root != whole;
        whole = root;
    }
    const double value = rounded(whole, is_more, unit);
    if (value == 0) return 0;
    return a < 0 ? -value : value;
}

class Truth {
public:
    // x[n][dim], numbers[n]: radii or weights.
    Truth(int dim, const Numbers& x, const Numbers& numbers, bool are_radii) : dim_(static_cast<std::size_t>(dim)) {
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            std::vector<mpq_class> point;
            for (std::size_t c = 0; c < dim_; ++c) point.emplace_back(x[i * dim_ + c]);
            const mpq_class number(numbers[i]), weight = are_radii ? mpq_class(number * number) : number;
            std::size_t same = 0;
            while (same < points_.size() && points_[same] != point) ++same;
            if (same == points_.size()) {
                points_.push_back(point);
                weights_.push_back(weight);
                rows_.push_back(i);
            } else if (weight > weights_[same]) {
                weights_[same] = weight;
                rows_[same] = i;
            }
        }
        duplicates = numbers.size() - points_.size();
        // By row, as ties are broken by it.
        for (std::size_t i = 0; i < rows_.size(); ++i)
            for (std::size_t j = i + 1; j < rows_.size(); ++j)
                if (rows_[j] < rows_[i]) {
                    std::swap(rows_[i], rows_[j]);
                    std::swap(points_[i], points_[j]);
                    std::swap(weights_[i], weights_[j]);
                }
        find_spheres();
        find_hidden();
    }

    std::size_t duplicates = 0;
    bool is_flat = true;
    std::vector<std::size_t> hidden;   // rows
    std::vector<std::size_t> visible;  // rows

    // Bars of degrees below dim whose ends differ as doubles.
    Bars bars(bool squares) const {
        struct Simplex {
            Set set;
            int dim;
            const mpq_class* value;
        };
        std::vector<Simplex> simplices;
        for (Set set = 1; set < value_.size(); ++set)
            if (size_of(set) <= dim_ + 1) simplices.push_back({set, static_cast<int>(size_of(set)) - 1, &value_[set]});
        std::sort(simplices.begin(), simplices.end(), [](const Simplex& a, const Simplex& b) {
            const int order = cmp(*a.value, *b.value);
            return order != 0 ? order < 0 : a.dim != b.dim ? a.dim < b.dim : a.set < b.set;
        });
        std::vector<std::size_t> place(value_.size());
        for (std::size_t j = 0; j < simplices.size(); ++j) place[simplices[j].set] = j;
        std::vector<std::vector<std::size_t>> column(simplices.size());
        std::vector<std::size_t> owner(simplices.size(), none);
        std::vector<bool> is_death(simplices.size(), false);
        Bars bars;
        for (std::size_t j = 0; j < simplices.size(); ++j) {
            std::vector<std::size_t>& own = column[j];
            for (std::size_t i = 0; i < points_.size() && simplices[j].dim > 0; ++i)
                if ((simplices[j].set >> i & 1) != 0) own.push_back(place[simplices[j].set & ~(Set(1) << i)]);
            std::sort(own.begin(), own.end());
            while (!own.empty() && owner[own.back()] != none) {
                const std::vector<std::size_t>& other = column[owner[own.back()]];
                std::vector<std::size_t> sum;
                std::set_symmetric_difference(own.begin(), own.end(), other.begin(), other.end(),
                                              std::back_inserter(sum));
                own.swap(sum);
            }
            if (own.empty()) continue;
            owner[own.back()] = j;
            is_death[j] = true;
            const double birth = value_of(*simplices[own.back()].value, squares),
                         death = value_of(*simplices[j].value, squares);
            const std::uint32_t degree = static_cast<std::uint32_t>(simplices[own.back()].dim);
            if (degree < dim_ && birth != death) bars.push_back({degree, birth, death});
        }
        bars.push_back({0, value_of(*simplices[0].value, squares), std::numeric_limits<double>::infinity()});
        std::sort(bars.begin(), bars.end());
        return bars;
    }

    // Whether no point has less power at the centre of these rows' orthogonal sphere than they have.
    bool is_regular(const std::vector<std::size_t>& rows) const {
        Set set = 0;
        for (const std::size_t row : rows)
            for (std::size_t i = 0; i < rows_.size(); ++i)
                if (rows_[i] == row) set |= Set(1) << i;
        Sphere sphere;
        if (size_of(set) != rows.size() || !solve(set, &sphere)) return false;
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (power(i, sphere.centre) < sphere.power) return false;
        return true;
    }

private:
    static constexpr std::size_t none = SIZE_MAX;
    struct Sphere {
        std::vector<mpq_class> share;  // barycentric coordinates of the centre, by ascending point
        std::vector<mpq_class> centre;
        mpq_class power;
    };
    static std::size_t size_of(Set set) {
        std::size_t size = 0;
        for (; set != 0; set &= set - 1) ++size;
        return size;
    }
    std::vector<std::size_t> members(Set set) const {
        std::vector<std::size_t> list;
        for (std::size_t i = 0; i < points_.size(); ++i)
            if ((set >> i & 1) != 0) list.push_back(i);
        return list;
    }
    mpq_class power(std::size_t i, const std::vector<mpq_class>& at) const {
        mpq_class sum = -weights_[i];
        for (std::size_t c = 0; c < dim_; ++c) {
            const mpq_class d = at[c] - points_[i][c];
            sum += d * d;
        }
        return sum;
    }
    // Gauss with any pivot: a[k][k + 1]; false: singular.
    static bool eliminate(std::vector<std::vector<mpq_class>>* a) {
        const std::size_t k = a->size();
        for (std::size_t s = 0; s < k; ++s) {
            std::size_t pivot = s;
            while (pivot < k && (*a)[pivot][s] == 0) ++pivot;
            if (pivot == k) return false;
            std::swap((*a)[s], (*a)[pivot]);
            for (std::size_t i = 0; i < k; ++i) {
                if (i == s || (*a)[i][s] == 0) continue;
                const mpq_class factor = (*a)[i][s] / (*a)[s][s];
                for (std::size_t j = s; j <= k; ++j) (*a)[i][j] -= factor * (*a)[s][j];
            }
        }
        for (std::size_t s = 0; s < k; ++s) (*a)[s][k] /= (*a)[s][s];
        return true;
    }
    // The orthogonal sphere of a set; false: it is affinely dependent.
    bool solve(Set set, Sphere* sphere) const {
        const std::vector<std::size_t> v = members(set);
        const std::size_t k = v.size() - 1;
        std::vector<std::vector<mpq_class>> edge(k, std::vector<mpq_class>(dim_)), a(k, std::vector<mpq_class>(k + 1));
        for (std::size_t i = 0; i < k; ++i)
            for (std::size_t c = 0; c < dim_; ++c) edge[i][c] = points_[v[i + 1]][c] - points_[v[0]][c];
        for (std::size_t i = 0; i < k; ++i) {
            for (std::size_t j = 0; j < k; ++j)
                for (std::size_t c = 0; c < dim_; ++c) a[i][j] += edge[i][c] * edge[j][c];
            a[i][k] = (a[i][i] + weights_[v[0]] - weights_[v[i + 1]]) / 2;
        }
        if (!eliminate(&a)) return false;
        sphere->share.assign(k + 1, 0);
        sphere->share[0] = 1;
        sphere->centre = points_[v[0]];
        for (std::size_t i = 0; i < k; ++i) {
            sphere->share[i + 1] = a[i][k];
            sphere->share[0] -= a[i][k];
            for (std::size_t c = 0; c < dim_; ++c) sphere->centre[c] += a[i][k] * edge[i][c];
        }
        sphere->power = power(v[0], sphere->centre);
        return true;
    }
    void find_spheres() {
        value_.resize(std::size_t(1) << points_.size());
        for (Set set = 1; set < value_.size(); ++set) {
            bool found = false;
            Sphere sphere;
            if (size_of(set) <= dim_ + 1 && solve(set, &sphere)) {
                is_flat = is_flat && size_of(set) <= dim_;
                found = *std::min_element(sphere.share.begin(), sphere.share.end()) >= 0;
                if (found) value_[set] = sphere.power;
            }
            for (const std::size_t i : members(set)) {
                const Set less = set & ~(Set(1) << i);
                if (less == 0 || (found && value_[less] <= value_[set])) continue;
                value_[set] = value_[less];
                found = true;
            }
        }
    }
    // A point is hidden where other points, affinely independent and with it in the interior of their convex hull, have
    // a combination of heights |x|^2 - w below its own, as each vertex of the linear program of the lowest one is such.
    // Heights are raised by something infinitely small, infinitely more for each row than for all before it.
    void find_hidden() {
        std::vector<mpq_class> height;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            mpq_class h = -weights_[i];
            for (const mpq_class& c : points_[i]) h += c * c;
            height.push_back(h);
        }
        for (std::size_t i = 0; i < points_.size(); ++i) {
            bool is_hidden = false;
            for (Set set = 1; set < value_.size() && !is_hidden; ++set)
                if ((set >> i & 1) == 0 && size_of(set) <= dim_ + 1) is_hidden = is_below(i, set, height);
            (is_hidden ? hidden : visible).push_back(rows_[i]);
        }
    }
    bool is_below(std::size_t i, Set set, const std::vector<mpq_class>& height) const {
        const std::vector<std::size_t> v = members(set);
        const std::size_t k = v.size() - 1;
        // Least squares of edges x = point i - v_0: exact where there is a solution at all.
        std::vector<std::vector<mpq_class>> edge(k, std::vector<mpq_class>(dim_)), a(k, std::vector<mpq_class>(k + 1));
        std::vector<mpq_class> to(dim_);
        for (std::size_t c = 0; c < dim_; ++c) to[c] = points_[i][c] - points_[v[0]][c];
        for (std::size_t r = 0; r < k; ++r)
            for (std::size_t c = 0; c < dim_; ++c) edge[r][c] = points_[v[r + 1]][c] - points_[v[0]][c];
        for (std::size_t r = 0; r < k; ++r)
            for (std::size_t c = 0; c < dim_; ++c) {
                for (std::size_t j = 0; j < k; ++j) a[r][j] += edge[r][c] * edge[j][c];
                a[r][k] += edge[r][c] * to[c];
            }
        if (!eliminate(&a)) return false;
        mpq_class first = 1, low = 0;
        for (std::size_t r = 0; r < k; ++r) {
            if (a[r][k] <= 0) return false;
            first -= a[r][k];
            low += a[r][k] * height[v[r + 1]];
            for (std::size_t c = 0; c < dim_; ++c) to[c] -= a[r][k] * edge[r][c];
        }
        if (first <= 0) return false;
        for (const mpq_class& c : to)
            if (c != 0) return false;
        low += first * height[v[0]];
        return low != height[i] ? low < height[i] : v.back() < i;
    }

    std::size_t dim_;
    std::vector<std::vector<mpq_class>> points_;
    std::vector<mpq_class> weights_;
    std::vector<std::size_t> rows_;
    std::vector<mpq_class> value_;  // of each set
};

}  // namespace weights
