#include "truth.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>

namespace referee {
namespace {

// f(x) = |x - centre|^2 + weight.
struct Site {
    ExactPoint centre;
    Rational weight;
};

// Where the largest f of some sites is least, and that value.
struct Ball {
    ExactPoint centre;
    Rational square;
    std::vector<signed char> holds;  // of each site: its f is not above `square` there; -1: not asked yet
};

class Balls {
public:
    Balls(const std::vector<Site>& sites, int dim) : sites_(sites), dim_(dim) {}

    // Sets must come after their subsets. If the ball of a facet holds the site that is left out, it is that of the
    // whole set; else every site of the set is on its boundary, and they are affinely independent.
    std::size_t of(const Simplex& set, const std::map<Simplex, std::size_t>& known) {
        for (std::size_t i = 0; set.size() > 1 && i < set.size(); i++) {
            Simplex facet = set;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            const std::size_t ball = known.at(facet);
            if (holds(ball, set[i])) return ball;
        }
        made_.push_back(circumscribed(set));
        return made_.size() - 1;
    }
    const Rational& square(std::size_t ball) const { return made_[ball].square; }

private:
    Rational value(const Site& site, const ExactPoint& x) const {
        Rational sum = site.weight;
        for (int k = 0; k < dim_; k++) sum += square_of(x[k] - site.centre[k]);
        return sum;
    }
    static Rational square_of(const Rational& a) { return a * a; }

    bool holds(std::size_t ball, std::uint32_t site) {
        signed char& known = made_[ball].holds[site];
        if (known < 0) known = value(sites_[site], made_[ball].centre) <= made_[ball].square ? 1 : 0;
        return known == 1;
    }

    // x = p_0 + sum l_j (p_j - p_0) with f_i(x) = f_0(x): 2 (p_i - p_0) (x - p_0) = |p_i - p_0|^2 + w_i - w_0.
    Ball circumscribed(const Simplex& set) const {
        const int n = static_cast<int>(set.size()) - 1;
        const Site& first = sites_[set[0]];
        if (n > dim_) std::fprintf(stderr, "referee: a ball with too many sites\n"), std::abort();
        std::vector<ExactPoint> edge(static_cast<std::size_t>(n));
        Matrix<Rational> rows;
        Vector<Rational> right, factor;
        for (int i = 0; i < n; i++)
            for (int k = 0; k < dim_; k++) edge[i][k] = sites_[set[i + 1]].centre[k] - first.centre[k];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) rows[i][j] = dot<Rational>(edge[i], edge[j], dim_);
            right[i] = (rows[i][i] + sites_[set[i + 1]].weight - first.weight) / 2;
        }
        if (n > 0 && !solve<Rational>(rows, right, n, &factor))
            std::fprintf(stderr, "referee: dependent sites on a ball\n"), std::abort();
        Ball ball = {first.centre, 0, std::vector<signed char>(sites_.size(), -1)};
        for (int i = 0; i < n; i++)
            for (int k = 0; k < dim_; k++) ball.centre[k] += factor[i] * edge[i][k];
        ball.square = value(first, ball.centre);
        return ball;
    }

    const std::vector<Site>& sites_;
    int dim_;
    std::vector<Ball> made_;
};

// A complex of sets, each with a number of a list of squares.
Truth truth_of(const std::vector<Simplex>& sets, const std::vector<std::size_t>& numbers,
               const std::function<const Rational&(std::size_t)>& square, int top) {
    std::vector<std::size_t> used(numbers);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::sort(used.begin(), used.end(), [&](std::size_t a, std::size_t b) { return square(a) < square(b); });
    Truth truth;
    truth.top = top;
    std::map<std::size_t, std::uint32_t> rank;
    for (const std::size_t n : used) {
        if (truth.squares.empty() || truth.squares.back() != square(n)) truth.squares.push_back(square(n));
        rank[n] = static_cast<std::uint32_t>(truth.squares.size() - 1);
    }
    Complex complex;
    for (std::size_t i = 0; i < sets.size(); i++) complex.add(sets[i], rank[numbers[i]]);
    complex.reduce();
    for (const PositionPair& pair : complex.pairs()) {
        const int degree = static_cast<int>(complex.simplex(pair.birth).size()) - 1;
        const std::uint32_t birth = complex.rank(pair.birth);
        const std::uint32_t death = pair.death == never ? never : complex.rank(pair.death);
        if (degree <= top && birth != death) truth.bars.push_back({degree, birth, death});
    }
    return truth;
}

// Balls in R^D have homology in degrees below D alone, which sets of up to D + 1 of them show.
Truth nerve_of_balls(const std::vector<Site>& sites, int dim) {
    Balls balls(sites, dim);
    std::map<Simplex, std::size_t> known;
    std::vector<Simplex> sets;
    std::vector<std::size_t> numbers;
    const std::size_t most = static_cast<std::size_t>(dim) + 1;
    for (std::size_t size = 1; size <= most; size++)
        for_each_set(static_cast<std::uint32_t>(sites.size()), size, [&](const Simplex& set) {
            if (set.size() != size) return;
            numbers.push_back(known[set] = balls.of(set, known));
            sets.push_back(set);
        });
    return truth_of(
        sets, numbers, [&](std::size_t n) -> const Rational& { return balls.square(n); }, dim - 1);
}

std::vector<Site> sites_of(const std::vector<Point>& points, int dim) {
    std::vector<Site> sites(points.size());
    for (std::size_t i = 0; i < points.size(); i++)
        for (int k = 0; k < dim; k++) sites[i].centre[k] = exact(points[i][k]);
    return sites;
}

std::vector<Simplex> sets_of(std::size_t count, std::size_t k) {
    std::vector<Simplex> sets;
    for_each_set(static_cast<std::uint32_t>(count), k, [&](const Simplex& set) {
        if (set.size() == k) sets.push_back(set);
    });
    return sets;
}

}  // namespace

bool is_feasible(std::size_t points, std::size_t k, int dim, std::size_t sets_max) {
    double members = 1, sets = 1;
    for (std::size_t i = 0; i < k; i++) members *= static_cast<double>(points - i) / static_cast<double>(i + 1);
    for (int i = 0; i <= dim && i < members; i++) sets *= (members - i) / (i + 1);
    return k <= points && sets <= static_cast<double>(sets_max);
}

std::map<Simplex, double> enclosing_radii(const std::vector<Point>& points, int dim, std::size_t size) {
    const std::vector<Site> sites = sites_of(points, dim);
    Balls balls(sites, dim);
    std::map<Simplex, std::size_t> known;
    std::map<Simplex, double> radii;
    for (std::size_t n = 1; n <= size; n++)
        for_each_set(static_cast<std::uint32_t>(sites.size()), n, [&](const Simplex& set) {
            if (set.size() != n) return;
            known[set] = balls.of(set, known);
            radii[set] = std::sqrt(balls.square(known[set]).get_d());
        });
    return radii;
}

Truth true_offsets(const std::vector<Point>& points, int dim) { return nerve_of_balls(sites_of(points, dim), dim); }

Truth true_k_distance(const std::vector<Point>& points, int dim, std::size_t k) {
    const std::vector<Site> all = sites_of(points, dim);
    std::vector<Site> sites;
    for (const Simplex& set : sets_of(points.size(), k)) {
        Site mean;
        for (const std::uint32_t p : set)
            for (int c = 0; c < dim; c++) mean.centre[c] += all[p].centre[c] / static_cast<unsigned long>(k);
        for (const std::uint32_t p : set)
            for (int c = 0; c < dim; c++)
                mean.weight += square(Rational(all[p].centre[c] - mean.centre[c])) / static_cast<unsigned long>(k);
        sites.push_back(mean);
    }
    return nerve_of_balls(sites, dim);
}

Truth true_kth(const std::vector<Point>& points, int dim, std::size_t k) {
    const std::vector<Site> sites = sites_of(points, dim);
    Balls balls(sites, dim);
    std::map<Simplex, std::size_t> known;
    for (std::size_t size = 1; size <= points.size(); size++)
        for (const Simplex& set : sets_of(points.size(), size)) known[set] = balls.of(set, known);
    const std::vector<Simplex> members = sets_of(points.size(), k);
    std::vector<Simplex> sets;
    std::vector<std::size_t> numbers;
    for_each_set(static_cast<std::uint32_t>(members.size()), static_cast<std::size_t>(dim) + 1,
                 [&](const Simplex& set) {
                     Simplex all;
                     for (const std::uint32_t m : set) all.insert(all.end(), members[m].begin(), members[m].end());
                     std::sort(all.begin(), all.end());
                     all.erase(std::unique(all.begin(), all.end()), all.end());
                     sets.push_back(set);
                     numbers.push_back(known.at(all));
                 });
    return truth_of(
        sets, numbers, [&](std::size_t n) -> const Rational& { return balls.square(n); }, dim - 1);
}

Truth true_rips(const std::vector<Point>& points, int dim, int top) {
    const std::size_t n = points.size();
    std::vector<Rational> squares(n * n);
    for (std::size_t i = 0; i < n; i++)
        for (std::size_t j = 0; j < n; j++)
            squares[i * n + j] = norm2<Rational>(difference<Rational>(points[i], points[j], dim), dim) / 4;
    std::vector<Simplex> sets;
    std::vector<std::size_t> numbers;
    for_each_set(static_cast<std::uint32_t>(n), static_cast<std::size_t>(top) + 2, [&](const Simplex& set) {
        std::size_t longest = 0;  // an entry of the diagonal is 0
        for (const std::uint32_t i : set)
            for (const std::uint32_t j : set)
                if (squares[i * n + j] > squares[longest]) longest = i * n + j;
        sets.push_back(set);
        numbers.push_back(longest);
    });
    return truth_of(
        sets, numbers, [&](std::size_t i) -> const Rational& { return squares[i]; }, top);
}

}  // namespace referee
