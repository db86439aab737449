// Distances of persistence diagrams by their definition, in whole numbers without bound (GMP), and what a distance by
// the library has to be like beside them. Shares nothing with engine/diagram.
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "netmesh.h"

namespace exact {

using Whole = mpz_class;
using Ratio = mpq_class;
using Bars = std::vector<netmesh_pair>;

inline bool is_essential(const netmesh_pair& bar) { return std::isinf(bar.death); }

// x 2^k.
inline Ratio scaled(const Ratio& x, long k) {
    Ratio y;
    if (k >= 0)
        mpq_mul_2exp(y.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(k));
    else
        mpq_div_2exp(y.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-k));
    return y;
}
inline Ratio power(const Ratio& x, std::uint32_t order) {
    Ratio y = 1;
    for (std::uint32_t i = 0; i < order; ++i) y *= x;
    return y;
}
inline Whole power(const Whole& x, std::uint32_t order) {
    Whole y;
    mpz_pow_ui(y.get_mpz_t(), x.get_mpz_t(), order);
    return y;
}

// Every finite number of two diagrams is a whole multiple of the unit, and so is half of every bar's length.
class Unit {
public:
    Unit(const Bars& a, const Bars& b) {
        for (const Bars* bars : {&a, &b})
            for (const netmesh_pair& bar : *bars)
                for (const double x : {bar.birth, bar.death}) take(x);
        exponent_ -= 1;
    }
    long exponent() const { return exponent_; }
    Whole of(double x) const {
        Whole y;
        int k = 0;
        mpz_set_d(y.get_mpz_t(), std::ldexp(std::frexp(x, &k), 53));
        const long up = k - 53 - exponent_;
        return up >= 0 ? Whole(y << static_cast<mp_bitcnt_t>(up)) : Whole(y >> static_cast<mp_bitcnt_t>(-up));
    }

private:
    void take(double x) {
        if (x == 0 || std::isinf(x)) return;
        int k = 0;
        auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &k), 53));
        for (k -= 53; digits % 2 == 0; digits /= 2) ++k;
        exponent_ = std::min(exponent_, static_cast<long>(k));
    }
    long exponent_ = 2000;
};

// A bar in units.
struct Bar {
    Whole birth, death;
};
inline Whole distance(const Bar& x, const Bar& y) {
    return std::max(Whole(abs(x.birth - y.birth)), Whole(abs(x.death - y.death)));
}
inline Whole to_diagonal(const Bar& x) { return (x.death - x.birth) / 2; }

// The least sum of a square of costs, row by row along shortest augmenting paths (Kuhn 1955, Munkres 1957).
inline Whole least_assignment(const std::vector<std::vector<Whole>>& cost) {
    const std::size_t n = cost.size(), nobody = n;
    std::vector<Whole> of_row(n), of_column(n + 1);
    std::vector<std::size_t> owner(n + 1, nobody);
    for (std::size_t first = 0; first < n; ++first) {
        std::vector<Whole> least(n + 1);
        std::vector<std::size_t> before(n + 1, n);
        std::vector<bool> seen(n + 1, false), done(n + 1, false);
        std::size_t column = n;  // one more, where the path begins
        owner[n] = first;
        do {
            done[column] = true;
            const std::size_t row = owner[column];
            std::size_t next = n;
            for (std::size_t j = 0; j < n; ++j) {
                if (done[j]) continue;
                const Whole reduced = cost[row][j] - of_row[row] - of_column[j];
                if (!seen[j] || reduced < least[j]) least[j] = reduced, before[j] = column, seen[j] = true;
                if (next == n || least[j] < least[next]) next = j;
            }
            const Whole step = least[next];
            for (std::size_t j = 0; j <= n; ++j) {
                if (done[j])
                    of_row[owner[j]] += step, of_column[j] -= step;
                else
                    least[j] -= step;
            }
            column = next;
        } while (owner[column] != nobody);
        for (; column != n; column = before[column]) owner[column] = owner[before[column]];
    }
    Whole sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += cost[owner[j]][j];
    return sum;
}

inline std::set<std::uint32_t> degrees_of(const Bars& a, const Bars& b) {
    std::set<std::uint32_t> degrees;
    for (const Bars* bars : {&a, &b})
        for (const netmesh_pair& bar : *bars) degrees.insert(bar.degree);
    return degrees;
}
inline std::vector<Bar> part_of(const Bars& all, std::uint32_t degree, bool essential, const Unit& unit) {
    std::vector<Bar> part;
    for (const netmesh_pair& bar : all)
        if (bar.degree == degree && is_essential(bar) == essential)
            part.push_back({unit.of(bar.birth), essential ? Whole(0) : unit.of(bar.death)});
    return part;
}
// The costs of all ways to match two lists; with places on the diagonal, each list has one for every bar of the other.
template <class Cost, class Way>
std::vector<std::vector<Whole>> square_of(const std::vector<Bar>& a, const std::vector<Bar>& b, bool with_diagonal,
                                          Cost cost, Way way) {
    const std::size_t n = with_diagonal ? a.size() + b.size() : a.size();
    std::vector<std::vector<Whole>> square(n, std::vector<Whole>(n));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            if (i < a.size() && j < b.size())
                square[i][j] = cost(a[i], b[j]);
            else if (i < a.size())
                square[i][j] = way(a[i]);
            else if (j < b.size())
                square[i][j] = way(b[j]);
        }
    return square;
}

// The least sum of p-th powers over all matchings, in units^p.
struct TransportSum {
    bool is_infinite = false;
    Ratio sum;  // of lengths in the diagrams' own unit
};
inline TransportSum least_transport(const Bars& a, const Bars& b, std::uint32_t order, std::uint32_t degree) {
    const Unit unit(a, b);
    TransportSum all;
    Whole sum = 0;
    const auto cost = [order](const Bar& x, const Bar& y) { return power(distance(x, y), order); };
    const auto way = [order](const Bar& x) { return power(to_diagonal(x), order); };
    for (const std::uint32_t k : degrees_of(a, b)) {
        if (degree != NETMESH_ALL_DEGREES && degree != k) continue;
        const std::vector<Bar> forever_a = part_of(a, k, true, unit), forever_b = part_of(b, k, true, unit);
        if (forever_a.size() != forever_b.size()) return {true, 0};
        sum += least_assignment(square_of(forever_a, forever_b, false, cost, way));
        sum += least_assignment(square_of(part_of(a, k, false, unit), part_of(b, k, false, unit), true, cost, way));
    }
    all.sum = scaled(Ratio(sum), static_cast<long>(order) * unit.exponent());
    return all;
}

// What is wrong with bounds `lower` and `value` of a Wasserstein distance; null: nothing.
inline const char* fault_of_width(double lower, double value, double relative_error) {
    if (!(lower >= 0) || !(value >= lower)) return "the bounds are no interval";
    if (std::isinf(lower)) return nullptr;
    Ratio widest = (1 + Ratio(relative_error)) * Ratio(lower);
    if (std::isinf(value))
        return widest > Ratio(std::numeric_limits<double>::max()) ? nullptr : "infinite far above the lower bound";
    if (value < 0x1p-1021) widest += (2 + Ratio(relative_error)) * Ratio(std::numeric_limits<double>::denorm_min());
    return Ratio(value) <= widest ? nullptr : "the bounds are farther apart than the error";
}
inline const char* fault_of_bounds(const TransportSum& truth, std::uint32_t order, double lower, double value,
                                   double relative_error) {
    if (!(lower >= 0) || !(value >= lower)) return "the bounds are no interval";
    if (truth.is_infinite) return std::isinf(lower) && std::isinf(value) ? nullptr : "finite, though it is infinite";
    if (std::isinf(lower)) return "infinite, though it is finite";
    if (truth.sum == 0) return lower == 0 && value == 0 ? nullptr : "not 0, though it is";
    if (power(Ratio(lower), order) > truth.sum) return "the lower bound is above the distance";
    if (!std::isinf(value) && power(Ratio(value), order) < truth.sum) return "the upper bound is below the distance";
    return fault_of_width(lower, value, relative_error);
}

// ---- the proof that comes with a Wasserstein distance

struct Proof {
    std::vector<std::uint32_t> mates;
    std::vector<double> f, g;
};
struct Proven {
    double lower, value;
    int exponent;
};

inline Ratio move_of(const netmesh_pair& p, const netmesh_pair& q) {
    const Ratio births = Ratio(p.birth) - Ratio(q.birth);
    if (is_essential(p)) return abs(births);
    const Ratio deaths = Ratio(p.death) - Ratio(q.death);
    return std::max(Ratio(abs(births)), Ratio(abs(deaths)));
}
inline Ratio way_of(const netmesh_pair& p) { return (Ratio(p.death) - Ratio(p.birth)) / 2; }

// Is e^p c surely above f + g, in long doubles?
inline bool is_surely_below(double f, double g, const netmesh_pair& p, const netmesh_pair& q, std::uint32_t order,
                            int exponent) {
    using Real = long double;
    const Real births = std::fabs(Real{p.birth} - q.birth), deaths = std::fabs(Real{p.death} - q.death);
    const Real move = std::ldexp(std::max(births, deaths), exponent);
    Real cost = move;
    for (std::uint32_t k = 1; k < order; ++k) cost *= move;
    return std::isfinite(cost) && Real{f} + g < cost - 1e-15L * (std::fabs(Real{f}) + std::fabs(Real{g}) + cost);
}

// What is wrong with the mates and the potentials of a finite distance in one degree; null: nothing.
inline const char* fault_of_proof(const Bars& a, const Bars& b, std::uint32_t order, std::uint32_t degree,
                                  const Proven& found, const Proof& proof) {
    const long lift = static_cast<long>(order) * found.exponent;
    const auto is_point = [degree](const netmesh_pair& p) {
        return p.degree == degree && !is_essential(p) && p.birth != p.death;
    };
    const auto is_high = [&](double f, const netmesh_pair& p) {
        return Ratio(f) > scaled(power(way_of(p), order), lift);
    };
    Ratio paid = 0, proven = 0;  // in the diagrams' unit
    std::vector<bool> taken(b.size(), false);
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::uint32_t mate = proof.mates[i];
        if (mate != NETMESH_NONE) {
            if (mate >= b.size() || taken[mate]) return "no matching";
            if (a[i].degree != degree || b[mate].degree != degree) return "a mate in another degree";
            if (is_essential(a[i]) != is_essential(b[mate])) return "a mate of another kind";
            if (!is_essential(a[i]) && (!is_point(a[i]) || !is_point(b[mate]))) return "a mate on the diagonal";
            taken[mate] = true;
            const Ratio cost = power(move_of(a[i], b[mate]), order);
            paid += cost;
            if (is_essential(a[i])) proven += cost;
        }
        if (!is_point(a[i])) {
            if (proof.f[i] != 0) return "a potential of what has none";
            continue;
        }
        if (mate == NETMESH_NONE) paid += power(way_of(a[i]), order);
        if (is_high(proof.f[i], a[i])) return "a potential above the diagonal";
        proven += scaled(Ratio(proof.f[i]), -lift);
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (!is_point(b[j]) || is_surely_below(proof.f[i], proof.g[j], a[i], b[j], order, found.exponent)) continue;
            if (Ratio(proof.f[i]) + Ratio(proof.g[j]) > scaled(power(move_of(a[i], b[j]), order), lift))
                return "two potentials above the cost";
        }
    }
    for (std::size_t j = 0; j < b.size(); ++j) {
        if (b[j].degree == degree && is_essential(b[j]) && !taken[j]) return "an essential bar without a mate";
        if (!is_point(b[j])) {
            if (proof.g[j] != 0) return "a potential of what has none";
            continue;
        }
        if (!taken[j]) paid += power(way_of(b[j]), order);
        if (is_high(proof.g[j], b[j])) return "a potential above the diagonal";
        proven += scaled(Ratio(proof.g[j]), -lift);
    }
    if (std::isfinite(found.value)) {
        if (power(Ratio(found.value), order) < paid) return "the upper bound is below what the matching costs";
        if (found.value > 0x1p-1021 && power(Ratio(found.value) * (1 - scaled(Ratio(1), -40)), order) > paid)
            return "the upper bound is not what the matching costs";
    }
    if (power(Ratio(found.lower), order) > proven) return "potentials do not prove the lower bound";
    return nullptr;
}

// ---- bottleneck distances

// The least limit among the costs within which all rows have columns of their own.
inline Ratio least_limit(const std::vector<std::vector<Ratio>>& cost, const Ratio& least) {
    const std::size_t n = cost.size();
    std::vector<Ratio> limits = {least};
    for (const auto& row : cost) limits.insert(limits.end(), row.begin(), row.end());
    std::sort(limits.begin(), limits.end());
    limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
    std::size_t low = 0, high = limits.size() - 1;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        std::vector<std::size_t> owner(n, n);
        bool all = true;
        for (std::size_t row = 0; row < n && all; ++row) {
            // Breadth first along alternating paths.
            std::vector<std::size_t> from(n, n), queue = {row};
            std::size_t end = n;
            for (std::size_t at = 0; at < queue.size() && end == n; ++at)
                for (std::size_t j = 0; j < n && end == n; ++j) {
                    if (from[j] != n || cost[queue[at]][j] > limits[middle]) continue;
                    from[j] = queue[at];
                    if (owner[j] == n)
                        end = j;
                    else
                        queue.push_back(owner[j]);
                }
            all = end != n;
            while (all) {
                const std::size_t i = from[end];
                const std::size_t before =
                    static_cast<std::size_t>(std::find(owner.begin(), owner.end(), i) - owner.begin());
                owner[end] = i;
                if (i == row) break;
                end = before;
            }
        }
        if (all)
            high = middle;
        else
            low = middle + 1;
    }
    return limits[high];
}

// The square of the bottleneck distance; on the log scale the square of the ratio e^distance.
struct Bottleneck {
    bool is_infinite = false;
    Ratio square;
};
inline Bottleneck least_bottleneck(const Bars& a, const Bars& b, bool log, std::uint32_t degree) {
    const Ratio least = log ? 1 : 0, never = -1;  // never: no limit is enough
    const auto between = [&](double x, double y) -> Ratio {
        if (x == y) return least;
        if (!log) return power(Ratio(x) - Ratio(y), 2);
        if (x == 0 || y == 0) return never;
        return power(Ratio(std::max(x, y)) / Ratio(std::min(x, y)), 2);
    };
    const auto way = [&](const netmesh_pair& p) -> Ratio {
        if (p.birth == p.death) return least;
        if (!log) return power((Ratio(p.death) - Ratio(p.birth)) / 2, 2);
        return p.birth == 0 ? never : Ratio(Ratio(p.death) / Ratio(p.birth));
    };
    const auto distance_of = [&](const netmesh_pair& p, const netmesh_pair& q) -> Ratio {
        const Ratio births = between(p.birth, q.birth), deaths = is_essential(p) ? least : between(p.death, q.death);
        return births == never || deaths == never ? never : std::max(births, deaths);
    };
    Bottleneck found;
    found.square = least;
    for (const std::uint32_t k : degrees_of(a, b)) {
        if (degree != NETMESH_ALL_DEGREES && degree != k) continue;
        for (const bool essential : {true, false}) {
            Bars x, y;
            for (const netmesh_pair& p : a)
                if (p.degree == k && is_essential(p) == essential) x.push_back(p);
            for (const netmesh_pair& p : b)
                if (p.degree == k && is_essential(p) == essential) y.push_back(p);
            if (essential && x.size() != y.size()) return {true, 0};
            const std::size_t n = essential ? x.size() : x.size() + y.size();
            std::vector<std::vector<Ratio>> cost(n, std::vector<Ratio>(n, least));
            Ratio most = least;
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j) {
                    if (i < x.size() && j < y.size())
                        cost[i][j] = distance_of(x[i], y[j]);
                    else if (i < x.size())
                        cost[i][j] = way(x[i]);
                    else if (j < y.size())
                        cost[i][j] = way(y[j]);
                    most = std::max(most, cost[i][j]);
                }
            for (auto& row : cost)
                for (Ratio& c : row)
                    if (c == never) c = most + 1;
            if (n == 0) continue;
            const Ratio limit = least_limit(cost, least);
            if (limit > most) return {true, 0};
            found.square = std::max(found.square, limit);
        }
    }
    return found;
}

// Is `value` 2^exponent the number of `digits` binary digits, or the multiple of the least double, that is nearest to
// the root of `square`, the even one of two? An infinite value stands for what rounds to 2^1024.
inline bool is_nearest(double value, long exponent, const Ratio& square, bool is_double) {
    if (std::isinf(value)) {
        const Ratio last = Ratio(std::numeric_limits<double>::max());
        return is_double && power(last + scaled(Ratio(1), 970), 2) <= square;
    }
    if (value < 0) return false;
    int k = 0;
    std::frexp(value, &k);
    const long least = -1074, step = is_double && (value == 0 || k - 53 < least) ? least : k - 53;
    const Ratio x = scaled(Ratio(value), exponent), half = scaled(Ratio(1), step - 1 + exponent);
    const bool is_even = std::fmod(std::ldexp(value, static_cast<int>(-step)), 2) == 0;
    // Below a power of two the next number is nearer.
    const bool narrow = value != 0 && std::frexp(value, &k) == 0.5 && !(is_double && step == least);
    const Ratio low = x - (narrow ? half / 2 : half), high = x + half;
    if (low > 0) {
        const Ratio bound = power(low, 2);
        if (is_even ? square < bound : square <= bound) return false;
    }
    const Ratio bound = power(high, 2);
    return is_even ? square <= bound : square < bound;
}
inline bool is_bottleneck(const Bottleneck& truth, bool log, double value, int exponent) {
    if (truth.is_infinite) return std::isinf(value) && exponent == 0;
    if (!log) return exponent == 0 && is_nearest(value, 0, truth.square, true);
    return value >= 1 && value < 2 && is_nearest(value, exponent, truth.square, false);
}

}  // namespace exact
