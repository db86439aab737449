// Diagrams of a few points that repeat, with weights or without, from definitions alone and in rationals. No code of
// the engine, no triangulation, nothing is perturbed, no tie is broken. Doubles are read exactly at the beginning and
// made by correct rounding at the end.
//
// A complex is that of finite sets of copies p + k.b, up to translation by the lattice. Translations move every finite
// set, so modulo 2 the boundary is that of the sets, where facets that are translations of one another cancel. It is
// filtered by the least a from which on a set is there. Two definitions of it, of the same diagrams:
//
//   cells    the nerve of the balls cut by their power cells: a set is there when some x has the same power of all its
//            members, at most a, and of no other copy less. At the x with the least such power all copies with that
//            power make a set whose orthogonal centre, the point of their affine hull with equal powers, is x. So the
//            values are the least powers at centres that are nearest to no other copy. n copies on an empty sphere make
//            all sets of them.
//   balls    the nerve of the balls alone: a set is there as soon as its balls meet. The largest value above that of a
//            point is the one where balls cover all that they ever cover up to homotopy; no larger sets are listed.
//
// Only sets of at most dim + 2 copies are listed: there is no homology above degree dim.
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "weights/truth.hpp"

namespace periods {

using weights::Bar;
using weights::Bars;
using Numbers = std::vector<double>;
using Vector = std::vector<mpz_class>;
using Row = std::vector<mpq_class>;

struct Cloud {
    int dim = 2;
    Numbers x;        // [n][dim]
    Numbers lattice;  // [periods][dim]
    Numbers numbers;  // [n], or none: weights, or radii
    bool are_radii = false;

    std::size_t width() const { return static_cast<std::size_t>(dim); }
    std::size_t count() const { return x.size() / width(); }
    std::size_t periods() const { return lattice.size() / width(); }
};

// The index of a point, then the multiples of up to 4 lattice vectors.
using Copy = std::array<int, 5>;
// Ascending. The first copy has multiples 0, so there is one for all translations.
using Simplex = std::vector<Copy>;
using Values = std::map<Simplex, mpq_class>;

inline void settle(Simplex* simplex) {
    std::sort(simplex->begin(), simplex->end());
    const Copy first = simplex->front();
    for (Copy& copy : *simplex)
        for (std::size_t j = 1; j < copy.size(); ++j) copy[j] -= first[j];
}

struct ExactBar {
    std::size_t degree;
    mpq_class birth, death;
    bool is_essential;
};
inline bool operator==(const ExactBar& a, const ExactBar& b) {
    return a.degree == b.degree && a.birth == b.birth && a.is_essential == b.is_essential && a.death == b.death;
}
inline bool operator<(const ExactBar& a, const ExactBar& b) {
    if (a.degree != b.degree) return a.degree < b.degree;
    if (a.birth != b.birth) return a.birth < b.birth;
    if (a.is_essential != b.is_essential) return b.is_essential;
    return a.death < b.death;
}
using ExactBars = std::vector<ExactBar>;  // sorted

// Persistent homology of a complex of simplices up to translation, degrees to dim.
inline ExactBars reduce(const Values& values, std::size_t dim) {
    using Entry = Values::const_iterator;
    std::vector<Entry> order;
    for (Entry i = values.begin(); i != values.end(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [](const Entry& a, const Entry& b) {
        const int sign = cmp(a->second, b->second);
        return sign != 0 ? sign < 0 : a->first.size() < b->first.size();
    });
    std::map<const Simplex*, std::size_t> place;
    for (std::size_t j = 0; j < order.size(); ++j) place[&order[j]->first] = j;
    std::vector<std::vector<std::size_t>> column(order.size());
    std::vector<std::size_t> owner(order.size(), SIZE_MAX);
    std::vector<bool> is_death(order.size(), false);
    ExactBars bars;
    for (std::size_t j = 0; j < order.size(); ++j) {
        const Simplex& simplex = order[j]->first;
        std::set<std::size_t> facets;
        for (std::size_t i = 0; i < simplex.size() && simplex.size() > 1; ++i) {
            Simplex facet = simplex;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            settle(&facet);
            const Entry found = values.find(facet);
            if (found == values.end() || place[&found->first] >= j) std::abort();  // no filtered complex
            const std::size_t at = place[&found->first];
            if (!facets.insert(at).second) facets.erase(at);
        }
        std::vector<std::size_t>& own = column[j];
        own.assign(facets.begin(), facets.end());
        while (!own.empty() && owner[own.back()] != SIZE_MAX) {
            const std::vector<std::size_t>& other = column[owner[own.back()]];
            std::vector<std::size_t> sum;
            std::set_symmetric_difference(own.begin(), own.end(), other.begin(), other.end(), std::back_inserter(sum));
            own.swap(sum);
        }
        if (own.empty()) continue;
        owner[own.back()] = j;
        is_death[j] = true;
        const Entry birth = order[own.back()];
        if (birth->second != order[j]->second)
            bars.push_back({birth->first.size() - 1, birth->second, order[j]->second, false});
    }
    for (std::size_t j = 0; j < order.size(); ++j)
        if (!is_death[j] && owner[j] == SIZE_MAX && order[j]->first.size() <= dim + 1)
            bars.push_back({order[j]->first.size() - 1, order[j]->second, 0, true});
    std::sort(bars.begin(), bars.end());
    return bars;
}

// As an engine has them: rounded, and without bars whose ends are the same double.
inline Bars rounded(const ExactBars& exact, bool squares) {
    Bars bars;
    for (const ExactBar& bar : exact) {
        const double birth = weights::value_of(bar.birth, squares);
        const double death =
            bar.is_essential ? std::numeric_limits<double>::infinity() : weights::value_of(bar.death, squares);
        if (birth != death) bars.push_back({static_cast<std::uint32_t>(bar.degree), birth, death});
    }
    std::sort(bars.begin(), bars.end());
    return bars;
}

inline mpz_class dot(const Vector& a, const Vector& b) {
    mpz_class sum = 0;
    for (std::size_t c = 0; c < a.size(); ++c) sum += a[c] * b[c];
    return sum;
}
inline mpz_class floor_of(const mpq_class& a) {
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), a.get_num_mpz_t(), a.get_den_mpz_t());
    return whole;
}
inline Vector sum_of(const Vector& a, const Vector& b, const mpz_class& times) {
    Vector sum = a;
    for (std::size_t c = 0; c < a.size(); ++c) sum[c] += times * b[c];
    return sum;
}

// Gauss with any pivot: a[k][k + more]; false: singular.
inline bool eliminate(std::vector<Row>* a) {
    const std::size_t k = a->size();
    for (std::size_t s = 0; s < k; ++s) {
        std::size_t pivot = s;
        while (pivot < k && (*a)[pivot][s] == 0) ++pivot;
        if (pivot == k) return false;
        std::swap((*a)[s], (*a)[pivot]);
        const mpq_class head = (*a)[s][s];
        for (mpq_class& entry : (*a)[s]) entry /= head;
        for (std::size_t i = 0; i < k; ++i) {
            if (i == s || (*a)[i][s] == 0) continue;
            const mpq_class factor = (*a)[i][s];
            for (std::size_t j = s; j < (*a)[i].size(); ++j) (*a)[i][j] -= factor * (*a)[s][j];
        }
    }
    return true;
}

// All whole vectors from `least` to `last`, both counted.
template <class Visit> void for_each_between(const Vector& least, const Vector& last, Visit visit) {
    for (std::size_t j = 0; j < least.size(); ++j)
        if (least[j] > last[j]) return;
    Vector at = least;
    for (;;) {
        visit(at);
        std::size_t j = 0;
        while (j < at.size() && at[j] == last[j]) {
            at[j] = least[j];
            ++j;
        }
        if (j == at.size()) return;
        ++at[j];
    }
}

// Points and a short basis of the lattice in units in which all are whole; weights in units squared.
class Scene {
public:
    explicit Scene(const Cloud& cloud) : dim(cloud.width()) {
        set_unit(cloud);
        for (std::size_t i = 0; i < cloud.count(); ++i) {
            point.push_back(whole(cloud.x, i));
            const mpq_class number(cloud.numbers.empty() ? 0.0 : cloud.numbers[i]);
            weight.push_back(units(units(cloud.are_radii ? mpq_class(number * number) : number)).get_num());
        }
        for (std::size_t j = 0; j < cloud.periods(); ++j) basis.push_back(whole(cloud.lattice, j));
        shorten();
        invert();
    }

    std::size_t dim;
    std::vector<Vector> point, basis;
    std::vector<mpz_class> weight;

    mpq_class value(mpq_class in_units) const {
        mpz_class square = mpz_class(1) << (2 * unit_);
        return in_units / square;
    }
    // Sums of basis vectors with factors -1, 0 and 1, but 0.
    std::vector<Vector> short_vectors() const {
        std::vector<Vector> all;
        for_each_between(Vector(basis.size(), -1), Vector(basis.size(), 1), [&](const Vector& k) {
            Vector v = at(Vector(dim), k);
            if (dot(v, v) != 0) all.push_back(v);
        });
        return all;
    }
    Vector at(Vector from, const Vector& k) const {
        for (std::size_t j = 0; j < basis.size(); ++j) from = sum_of(from, basis[j], k[j]);
        return from;
    }
    Vector place(const Copy& copy) const {
        Vector at = point[static_cast<std::size_t>(copy[0])];
        for (std::size_t j = 0; j < basis.size(); ++j) at = sum_of(at, basis[j], copy[j + 1]);
        return at;
    }
    // The least k and the last that can have |k_j + t_j| <= reach[j], where sum t_j b_j is the part of v in the span.
    void range(const Vector& v, const Row& reach, Vector* least, Vector* last) const {
        const std::size_t m = basis.size();
        least->assign(m, 0);
        last->assign(m, 0);
        for (std::size_t j = 0; j < m; ++j) {
            mpq_class t = 0;
            for (std::size_t i = 0; i < m; ++i) t += inverse[j][i] * dot(basis[i], v);
            (*least)[j] = -floor_of(reach[j] + t);
            (*last)[j] = floor_of(reach[j] - t);
        }
    }
    std::vector<Row> inverse;  // of the basis's Gram matrix
    Vector whole(const Numbers& x, std::size_t row) const {
        Vector v;
        for (std::size_t c = 0; c < dim; ++c) v.push_back(units(mpq_class(x[row * dim + c])).get_num());
        return v;
    }

private:
    static long scale_of(double x) {  // the least s >= 0 with 2^s x whole
        if (x == 0) return 0;
        const mpz_class under = mpq_class(x).get_den();
        return static_cast<long>(mpz_sizeinbase(under.get_mpz_t(), 2)) - 1;
    }
    void set_unit(const Cloud& cloud) {
        long unit = 0;
        for (const double x : cloud.x) unit = std::max(unit, scale_of(x));
        for (const double x : cloud.lattice) unit = std::max(unit, scale_of(x));
        for (const double w : cloud.numbers)
            unit = std::max(unit, cloud.are_radii ? scale_of(w) : (scale_of(w) + 1) / 2);
        unit_ = static_cast<unsigned long>(unit);
    }
    mpq_class units(const mpq_class& x) const {
        mpz_class unit = mpz_class(1) << unit_;
        return x * unit;
    }
    // Replaces vectors by shorter ones of the same lattice for as long as that is simple.
    void shorten() {
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t i = 0; i < basis.size(); ++i) {
                for (std::size_t j = 0; j < basis.size(); ++j)
                    if (i != j) {
                        const mpq_class ratio(dot(basis[i], basis[j]), dot(basis[j], basis[j]));
                        mpq_class exact = ratio;
                        exact.canonicalize();
                        const mpz_class times = floor_of(exact + mpq_class(1, 2));
                        changed |= replace(i, sum_of(basis[i], basis[j], -times));
                    }
                const std::vector<Vector> rest = others(i);
                for (const Vector& v : rest) changed |= replace(i, sum_of(basis[i], v, 1));
            }
        }
    }
    std::vector<Vector> others(std::size_t i) const {  // sums of the other vectors, with factors -1, 0, 1
        std::vector<Vector> all;
        Vector least(basis.size(), -1), last(basis.size(), 1);
        least[i] = last[i] = 0;
        for_each_between(least, last, [&](const Vector& k) { all.push_back(at(Vector(dim), k)); });
        return all;
    }
    bool replace(std::size_t i, const Vector& by) {
        if (dot(by, by) >= dot(basis[i], basis[i])) return false;
        basis[i] = by;
        return true;
    }
    void invert() {
        const std::size_t m = basis.size();
        std::vector<Row> a(m, Row(2 * m));
        for (std::size_t i = 0; i < m; ++i) {
            for (std::size_t j = 0; j < m; ++j) a[i][j] = dot(basis[i], basis[j]);
            a[i][m + i] = 1;
        }
        if (!eliminate(&a)) std::abort();  // dependent vectors
        for (const Row& row : a) inverse.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(m), row.end());
    }
    unsigned long unit_ = 0;
};

// Whether all copies lie in a hyperplane.
inline bool is_flat(const Cloud& cloud) {
    const std::size_t d = cloud.width();
    std::vector<Row> rows;
    for (std::size_t i = 0; i < cloud.count() + cloud.periods(); ++i) {
        Row row;
        for (std::size_t c = 0; c < d; ++c) {
            const bool is_point = i < cloud.count();
            mpq_class x(is_point ? cloud.x[i * d + c] : cloud.lattice[(i - cloud.count()) * d + c]);
            if (is_point) x -= mpq_class(cloud.x[c]);
            row.push_back(x);
        }
        rows.push_back(row);
    }
    // Their Gram matrix in d dimensions is regular when they span all.
    std::vector<Row> a(d, Row(d));
    for (const Row& row : rows)
        for (std::size_t i = 0; i < d; ++i)
            for (std::size_t j = 0; j < d; ++j) a[i][j] += row[i] * row[j];
    return !eliminate(&a);
}

inline bool are_copies(const Scene& scene, std::size_t i, std::size_t j) {
    bool are = false;
    // The only copy that could be the point itself.
    Vector least, last;
    scene.range(sum_of(scene.point[j], scene.point[i], -1), Row(scene.basis.size()), &least, &last);
    for_each_between(least, last, [&](const Vector& k) { are = are || scene.at(scene.point[j], k) == scene.point[i]; });
    return are;
}
// Points that are a copy of another one before.
inline std::size_t count_duplicates(const Cloud& cloud) {
    const Scene scene(cloud);
    std::size_t count = 0;
    for (std::size_t i = 0; i < scene.point.size(); ++i) {
        bool is_again = false;
        for (std::size_t j = 0; j < i && !is_again; ++j) is_again = are_copies(scene, i, j);
        count += is_again;
    }
    return count;
}
// Of equal points only the first of the heaviest is there.
inline std::vector<bool> those_that_stay(const Cloud& cloud) {
    const Scene scene(cloud);
    std::vector<bool> stay(scene.point.size(), true);
    for (std::size_t i = 0; i < stay.size(); ++i)
        for (std::size_t j = 0; j < stay.size(); ++j) {
            const bool is_before = scene.weight[j] > scene.weight[i] || (scene.weight[j] == scene.weight[i] && j < i);
            if (is_before && are_copies(scene, i, j)) stay[i] = false;
        }
    return stay;
}

// ---- by cells ----

inline mpz_class whole_of(const mpz_class& z) { return z; }
inline mpz_class whole_of(__int128 z) {
    const bool below = z < 0;
    const unsigned __int128 size = below ? -static_cast<unsigned __int128>(z) : static_cast<unsigned __int128>(z);
    mpz_class sum(static_cast<unsigned long>(size >> 64));
    sum = (sum << 64) + static_cast<unsigned long>(size);
    return below ? mpz_class(-sum) : sum;
}
inline void narrow(const mpz_class& z, mpz_class* to) { *to = z; }
inline void narrow(const mpz_class& z, __int128* to) { *to = z.get_si(); }

// Of a power cell.
enum class Extent { nothing, flat, inside };

// Z: mpz_class, or __int128 where numbers are so small that no sum can leave it.
template <class Z> class Cells {
public:
    Cells(const Scene& scene, const std::vector<std::vector<Copy>>& near) : scene_(scene), near_(near) {}

    Values find() {
        vertices_.assign(near_.size(), 0);
        sum_.assign(near_.size(), Row(scene_.dim));
        for (std::size_t i = 0; i < near_.size(); ++i) {
            load(i);
            std::vector<std::size_t> chosen;
            choose(i, 0, &chosen);
        }
        return values_;
    }

    // After find, where there are as many periods as dimensions, which bounds power cells: how much of each point's
    // cell there is. At the mean of its vertices no other point has as little power where the cell has an inside.
    std::vector<Extent> extents() {
        std::vector<Extent> all;
        for (std::size_t i = 0; i < near_.size(); ++i) {
            if (vertices_[i] == 0) {
                all.push_back(Extent::nothing);
                continue;
            }
            load(i);
            bool has_inside = true;
            for (const Neighbour& neighbour : neighbours_) {
                mpq_class more(whole_of(neighbour.lift));
                bool is_there = false;
                for (std::size_t c = 0; c < scene_.dim; ++c) {
                    const mpq_class v(whole_of(neighbour.v[c]));
                    is_there = is_there || v != 0;
                    more -= 2 * v * sum_[i][c] / mpq_class(static_cast<unsigned long>(vertices_[i]));
                }
                has_inside = has_inside && (!is_there || more > 0);
            }
            all.push_back(has_inside ? Extent::inside : Extent::flat);
        }
        return all;
    }

private:
    struct Neighbour {
        Copy copy;
        std::vector<Z> v;  // from the point at hand
        Z lift;            // |v|^2 - its weight + that of the point
    };
    void load(std::size_t i) {
        neighbours_.clear();
        for (const Copy& copy : near_[i]) {
            const Vector v = sum_of(scene_.place(copy), scene_.point[i], -1);
            const mpz_class lift = dot(v, v) - scene_.weight[static_cast<std::size_t>(copy[0])] + scene_.weight[i];
            Neighbour neighbour{copy, std::vector<Z>(v.size()), Z()};
            for (std::size_t c = 0; c < v.size(); ++c) narrow(v[c], &neighbour.v[c]);
            narrow(lift, &neighbour.lift);
            neighbours_.push_back(neighbour);
        }
        std::sort(neighbours_.begin(), neighbours_.end(),
                  [](const Neighbour& a, const Neighbour& b) { return a.lift < b.lift; });
        // A set is looked at from its first copy.
        const Copy own{static_cast<int>(i)};
        later_.clear();
        for (std::size_t j = 0; j < neighbours_.size(); ++j)
            if (own < neighbours_[j].copy) later_.push_back(j);
        product_.assign(later_.size(), std::vector<Z>(later_.size()));
        for (std::size_t a = 0; a < later_.size(); ++a)
            for (std::size_t b = 0; b < later_.size(); ++b) product_[a][b] = times(vector(a), vector(b));
    }
    const std::vector<Z>& vector(std::size_t later) const { return neighbours_[later_[later]].v; }
    static Z times(const std::vector<Z>& a, const std::vector<Z>& b) {
        Z sum = 0;
        for (std::size_t c = 0; c < a.size(); ++c) sum += a[c] * b[c];
        return sum;
    }
    // Recursion is as deep as the dimension.
    void choose(std::size_t i, std::size_t from, std::vector<std::size_t>* chosen) {
        if (!judge(i, *chosen) || chosen->size() == scene_.dim) return;
        for (std::size_t j = from; j < later_.size(); ++j) {
            chosen->push_back(j);
            choose(i, j + 1, chosen);
            chosen->pop_back();
        }
    }
    using Matrix = std::array<std::array<Z, 4>, 4>;
    // Of rows from `row` on and of columns in the set.
    static Z determinant(const Matrix& a, std::size_t k, std::size_t row, unsigned columns) {
        if (row == k) return 1;
        Z sum = 0;
        bool is_odd = false;
        for (std::size_t j = 0; j < k; ++j) {
            if ((columns >> j & 1u) == 0) continue;
            const Z term = a[row][j] * determinant(a, k, row + 1, columns & ~(1u << j));
            if (is_odd)
                sum -= term;
            else
                sum += term;
            is_odd = !is_odd;
        }
        return sum;
    }
    // Takes the centre of point i and the chosen ones, if no copy has less power there. False: they are dependent.
    bool judge(std::size_t i, const std::vector<std::size_t>& chosen) {
        const std::size_t k = chosen.size();
        Matrix a;
        for (std::size_t r = 0; r < k; ++r)
            for (std::size_t c = 0; c < k; ++c) a[r][c] = product_[chosen[r]][chosen[c]];
        const unsigned all = (1u << k) - 1;
        const Z under = determinant(a, k, 0, all);
        if (under == 0) return false;
        std::vector<Z> over(scene_.dim, Z(0));  // twice the centre, times under
        for (std::size_t r = 0; r < k; ++r) {
            Matrix b = a;
            for (std::size_t c = 0; c < k; ++c) b[c][r] = neighbours_[later_[chosen[c]]].lift;
            const Z share = determinant(b, k, 0, all);
            for (std::size_t c = 0; c < scene_.dim; ++c) over[c] += share * vector(chosen[r])[c];
        }
        Simplex full{Copy{static_cast<int>(i)}};
        for (const Neighbour& neighbour : neighbours_) {
            const Z more = under * neighbour.lift - times(over, neighbour.v);
            if (more < 0) return true;
            if (more == 0) full.push_back(neighbour.copy);
        }
        if (k == scene_.dim) add_vertex(i, full, under, over);
        settle(&full);
        if (!full_.insert(full).second) return true;
        mpz_class square = 0;
        for (const Z& c : over) square += whole_of(c) * whole_of(c);
        mpq_class value(square, 4 * whole_of(under) * whole_of(under));
        value.canonicalize();
        add_sets(full, scene_.value(value - scene_.weight[i]));
        return true;
    }
    // Of the cells of all points in the set, as seen from each.
    void add_vertex(std::size_t i, const Simplex& full, const Z& under, const std::vector<Z>& over) {
        for (const Copy& copy : full) {
            const std::size_t own = static_cast<std::size_t>(copy[0]);
            const Vector away = sum_of(scene_.place(copy), scene_.point[i], -1);
            ++vertices_[own];
            for (std::size_t c = 0; c < scene_.dim; ++c) {
                mpq_class centre(whole_of(over[c]), 2 * whole_of(under));
                centre.canonicalize();
                sum_[own][c] += centre - mpq_class(away[c]);
            }
        }
    }
    void add_sets(const Simplex& full, const mpq_class& value) {
        std::vector<std::size_t> chosen;
        add(full, value, 0, &chosen);
    }
    void add(const Simplex& full, const mpq_class& value, std::size_t from, std::vector<std::size_t>* chosen) {
        if (!chosen->empty()) {
            Simplex simplex;
            for (const std::size_t j : *chosen) simplex.push_back(full[j]);
            settle(&simplex);
            const auto [place, is_new] = values_.emplace(simplex, value);
            if (!is_new && value < place->second) place->second = value;
        }
        if (chosen->size() == scene_.dim + 2) return;
        for (std::size_t j = from; j < full.size(); ++j) {
            chosen->push_back(j);
            add(full, value, j + 1, chosen);
            chosen->pop_back();
        }
    }

    const Scene& scene_;
    const std::vector<std::vector<Copy>>& near_;
    std::vector<Neighbour> neighbours_;
    std::vector<std::size_t> later_;
    std::vector<std::vector<Z>> product_;
    std::set<Simplex> full_;
    Values values_;
    std::vector<std::size_t> vertices_;  // of each point's power cell, some of them several times
    std::vector<Row> sum_;               // of them
};

// For each point all copies whose cells can meet its own, and short translations of itself. Where x is nearest to p
// among p and its translations, 2 (x - p).l <= l^2 for each vector l of the lattice; where it is nearest to q, too,
// (q - p).l <= l^2.
inline std::vector<std::vector<Copy>> near_copies(const Scene& scene) {
    const std::vector<Vector> tests = scene.short_vectors();
    const std::size_t m = scene.basis.size();
    Row reach(m);
    for (std::size_t j = 0; j < m; ++j)
        for (std::size_t i = 0; i < m; ++i) reach[j] += abs(scene.inverse[j][i]) * dot(scene.basis[i], scene.basis[i]);
    std::vector<std::vector<Copy>> near(scene.point.size());
    for (std::size_t i = 0; i < near.size(); ++i)
        for (std::size_t other = 0; other < near.size(); ++other) {
            const Vector from = sum_of(scene.point[other], scene.point[i], -1);
            Vector least, last;
            scene.range(from, reach, &least, &last);
            for (std::size_t j = 0; j < m && other == i; ++j) {
                least[j] = std::min(least[j], mpz_class(-1));
                last[j] = std::max(last[j], mpz_class(1));
            }
            for_each_between(least, last, [&](const Vector& k) {
                Copy copy{static_cast<int>(other)};
                bool is_short = other == i, is_own = other == i;
                for (std::size_t j = 0; j < m; ++j) {
                    copy[j + 1] = static_cast<int>(k[j].get_si());
                    is_short = is_short && abs(k[j]) <= 1;
                    is_own = is_own && k[j] == 0;
                }
                const Vector v = scene.at(from, k);
                bool is_near = true;
                for (const Vector& l : tests) is_near = is_near && dot(v, l) <= dot(l, l);
                if (!is_own && (is_near || is_short)) near[i].push_back(copy);
            });
        }
    return near;
}

// Whether all sums in Cells fit 127 bits: 8 b + 13 bits, in four dimensions 10 b + 20, of coordinates below 2^b.
inline bool fits(const Scene& scene, const std::vector<std::vector<Copy>>& near) {
    const mpz_class most = mpz_class(1) << (scene.dim <= 3 ? 13 : 10);
    for (const mpz_class& w : scene.weight)
        if (abs(w) >= most * most) return false;
    for (std::size_t i = 0; i < near.size(); ++i)
        for (const Copy& copy : near[i])
            for (const mpz_class& c : sum_of(scene.place(copy), scene.point[i], -1))
                if (abs(c) >= most) return false;
    return true;
}

// extents: null, or of the power cells of all points, with as many periods as dimensions.
inline Values values_of_cells(const Cloud& cloud, std::vector<Extent>* extents = nullptr) {
    const Scene scene(cloud);
    const std::vector<std::vector<Copy>> near = near_copies(scene);
    const auto find = [&](auto&& cells) {
        Values values = cells.find();
        if (extents != nullptr) *extents = cells.extents();
        return values;
    };
    return fits(scene, near) ? find(Cells<__int128>(scene, near)) : find(Cells<mpz_class>(scene, near));
}

inline ExactBars bars_of_cells(const Cloud& cloud, std::vector<Extent>* extents = nullptr) {
    return reduce(values_of_cells(cloud, extents), cloud.width());
}

}  // namespace periods
