// Wasserstein distances against answers by hand, against exact assignments, and by what their potentials prove.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "common/wasserstein.hpp"

namespace {

using Real = long double;
using Diagram = std::vector<netmesh_pair>;
constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr double relative_error_least = 0x1p-30;

Real move_of(const netmesh_pair& p, const netmesh_pair& q) {
    return std::max(std::fabs(Real{p.birth} - q.birth), std::fabs(Real{p.death} - q.death));
}
Real move_to_diagonal(const netmesh_pair& p) { return (Real{p.death} - p.birth) / 2; }
Real power(Real x, std::uint32_t order) { return std::pow(x, static_cast<Real>(order)); }

// The least sum over all assignments by shortest augmenting paths (Kuhn, Munkres): rows and columns are the bars of one
// diagram and a place at the diagonal for each of the other's.
Real least_assignment(const Diagram& a, const Diagram& b, std::uint32_t order) {
    const std::size_t n = a.size() + b.size();
    const auto cost = [&](std::size_t i, std::size_t j) -> Real {
        if (i < a.size() && j < b.size()) return power(move_of(a[i], b[j]), order);
        if (i < a.size()) return power(move_to_diagonal(a[i]), order);
        return j < b.size() ? power(move_to_diagonal(b[j]), order) : 0;
    };
    std::vector<Real> row(n + 1, 0), column(n + 1, 0);
    std::vector<std::size_t> owner(n + 1, 0), before(n + 1, 0);
    for (std::size_t i = 1; i <= n; ++i) {
        owner[0] = i;
        std::size_t at = 0;
        std::vector<Real> least(n + 1, infinity);
        std::vector<bool> done(n + 1, false);
        do {
            done[at] = true;
            const std::size_t r = owner[at];
            Real step = infinity;
            std::size_t next = 0;
            for (std::size_t j = 1; j <= n; ++j) {
                if (done[j]) continue;
                const Real reduced = cost(r - 1, j - 1) - row[r] - column[j];
                if (reduced < least[j]) least[j] = reduced, before[j] = at;
                if (least[j] < step) step = least[j], next = j;
            }
            for (std::size_t j = 0; j <= n; ++j) {
                if (done[j]) {
                    row[owner[j]] += step;
                    column[j] -= step;
                } else {
                    least[j] -= step;
                }
            }
            at = next;
        } while (owner[at] != 0);
        for (; at != 0; at = before[at]) owner[at] = owner[before[at]];
    }
    Real sum = 0;
    for (std::size_t j = 1; j <= n; ++j) sum += cost(owner[j] - 1, j - 1);
    return sum;
}

// What the outputs of a distance in one degree say, by their definition alone; both diagrams have that degree only and
// no essential pairs.
void check_outputs(const Diagram& a, const Diagram& b, std::uint32_t order, const Transport& found,
                   const std::vector<std::uint32_t>& mates, const std::vector<double>& f,
                   const std::vector<double>& g) {
    const Real unit = std::ldexp(Real{1}, found.exponent);
    Real proven = 0, paid = 0;
    std::vector<bool> taken(b.size(), false);
    for (std::size_t i = 0; i < a.size(); ++i) {
        proven += f[i];
        CHECK(f[i] <= power(unit * move_to_diagonal(a[i]), order));
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (!(Real{f[i]} + g[j] <= power(unit * move_of(a[i], b[j]), order))) FAIL_CHECK("potentials ", i, " ", j);
        }
        if (mates[i] == NETMESH_NONE) {
            paid += power(unit * move_to_diagonal(a[i]), order);
            continue;
        }
        REQUIRE(mates[i] < b.size());
        CHECK(!taken[mates[i]]);
        taken[mates[i]] = true;
        paid += power(unit * move_of(a[i], b[mates[i]]), order);
    }
    for (std::size_t j = 0; j < b.size(); ++j) {
        proven += g[j];
        CHECK(g[j] <= power(unit * move_to_diagonal(b[j]), order));
        if (!taken[j]) paid += power(unit * move_to_diagonal(b[j]), order);
    }
    const Real root = 1 / static_cast<Real>(order);
    CHECK(found.value >= std::pow(paid, root) / unit * (1 - 0x1p-60L));
    CHECK(found.value <= std::pow(paid, root) / unit * (1 + 1e-12L));
    if (proven > 0) {
        CHECK(found.lower <= std::pow(proven, root) / unit * (1 + 1e-12L));
        CHECK(found.lower >= std::pow(proven, root) / unit * (1 - 1e-10L));
    } else {
        CHECK(found.lower == 0);
    }
}

Transport distance(const Diagram& a, const Diagram& b, std::uint32_t order, double error = 0x1p-20,
                   std::uint32_t degree = NETMESH_ALL_DEGREES) {
    const Transport found = wasserstein(wasserstein_request(a, b, order, error, degree));
    REQUIRE(found.status == NETMESH_OK);
    CHECK(found.lower <= found.value);
    if (std::isfinite(found.value)) CHECK(found.value <= found.lower * (1 + error) * (1 + 0x1p-50));
    return found;
}
void check_is(const Transport& found, Real exact) {
    CHECK(found.lower <= exact);
    CHECK(found.value >= exact);
}

// Bars of one degree of many kinds: spread, short and long, on a grid, with one birth, at a scale.
Diagram sample(std::mt19937_64& random, std::size_t count, int kind, double scale) {
    std::uniform_real_distribution<double> u(0, 1);
    Diagram made;
    for (std::size_t i = 0; i < count; ++i) {
        double birth = u(random), length = u(random);
        if (kind == 1) length = std::pow(length, 8);
        if (kind == 2) birth = std::floor(birth * 5), length = 1 + std::floor(length * 4);
        if (kind == 3) birth = 0, length = -std::log(length + 1e-9);
        if (kind == 4) birth = 1 + 1e-13 * birth, length = 1e-13 * length;
        if (kind == 5) birth -= 3, length *= i % 4 == 0 ? 100 : 0.01;
        made.push_back(bar(1, birth * scale, (birth + length) * scale));
    }
    return made;
}

}  // namespace

TEST_CASE("Wasserstein distances by hand") {
    const Diagram none, one = {bar(1, 1, 3)}, far = {bar(1, 10, 12)}, both = {bar(1, 1, 3), bar(1, 10, 12)};
    for (std::uint32_t order = 1; order <= NETMESH_ORDER_MAX; ++order) {
        CAPTURE(order);
        const Real root_of_two = std::pow(Real{2}, 1 / static_cast<Real>(order));
        CHECK(distance(none, none, order).value == 0);
        CHECK(distance(both, both, order).value == 0);
        CHECK(distance(both, both, order).lower == 0);
        check_is(distance(none, one, order), 1);
        check_is(distance(one, none, order), 1);
        check_is(distance(one, far, order), root_of_two);  // both to the diagonal
        check_is(distance(both, one, order), 1);
        check_is(distance(none, both, order), root_of_two);
        check_is(distance(one, {bar(1, 1.25, 2.5)}, order), 0.5);
        // Bars of no length do not count; those of different degrees do not meet.
        check_is(distance({bar(1, 1, 3), bar(1, 7, 7)}, one, order), 0);
        check_is(distance(one, {bar(2, 1, 3)}, order), root_of_two);
        check_is(distance(one, {bar(2, 1, 3)}, order, 0.01, 1), 1);
        CHECK(distance(one, {bar(2, 1, 3)}, order, 0.01, 0).value == 0);
    }
}

TEST_CASE("bars born together, the longest left out: all move by one, which costs less than to leave one") {
    // Of 39 bars (0, x); costs of ways to the diagonal tie with the ceiling of costs.
    const double deaths[] = {
        0.056286233387769766, 0.07069794553615319, 0.07643658473755216, 0.0866375567904094,  0.09165625168642637,
        0.10927002133578395,  0.11348380879638993, 0.1240825941433366,  0.14074942865023912, 0.14448349155975662,
        0.14730883818154855,  0.14847112869768253, 0.14882822463070872, 0.15727380444994649, 0.15910387720977556,
        0.16087207258216257,  0.1645986097248525,  0.16560300840617068, 0.1721807402552658,  0.17235060695173313,
        0.17255758171193175,  0.18057694015362227, 0.18130164021429734, 0.18630766176506502, 0.19036103435376261,
        0.19244368257621602,  0.1976521424366231,  0.2020408449848005,  0.20465400079549,    0.20532580413655693,
        0.2105191523768772,   0.21253711067991798, 0.21358360202223117, 0.21695781383458124, 0.22652435025634488,
        0.2275086134990119,   0.2322597245056345,  0.25024210508652045, 0.25642028662960026};
    Diagram a;
    for (const double death : deaths) a.push_back(bar(0, 0, death));
    const Diagram b(a.begin(), a.end() - 1);
    for (std::uint32_t order = 1; order <= 4; ++order)
        for (const double error : {0.1, 0.001, relative_error_least}) {
            CAPTURE(order);
            const Real exact = std::pow(least_assignment(a, b, order), 1 / static_cast<Real>(order));
            for (const Transport& found : {distance(a, b, order, error), distance(b, a, order, error)}) {
                CHECK(found.lower <= exact * (1 + 1e-15L));
                CHECK(found.value >= exact * (1 - 1e-15L));
            }
        }
    CHECK(distance(a, b, 2, 0.001).value == doctest::Approx(0.0521912186531));
}

TEST_CASE("a thousand bars, the longest left out, by hand") {
    Diagram a, b;
    for (int i = 1; i <= 1000; ++i) {
        a.push_back(bar(0, 0, i));
        if (i < 1000) b.push_back(bar(0, 0, i));
    }
    // When bar k goes to the diagonal and longer ones move by one, that costs (k / 2)^p + 1000 - k: least for k = 1000
    // in the first order, for k = 2 in the others.
    check_is(distance(a, b, 1), 500);
    check_is(distance(a, b, 2), std::sqrt(Real{999}));
    check_is(distance(a, b, 16, relative_error_least), std::pow(Real{999}, 1 / Real{16}));
}

TEST_CASE("essential pairs are matched by birth, and their numbers have to agree") {
    const double forever = std::numeric_limits<double>::infinity();
    const Diagram a = {bar(0, 1, forever), bar(0, 5, forever), bar(1, 0, 2)};
    const Diagram b = {bar(0, 6, forever), bar(0, 3, forever), bar(1, 0, 2)};
    check_is(distance(a, b, 1), 3);
    check_is(distance(a, b, 2), std::sqrt(Real{5}));
    check_is(distance(a, b, 1, 0.01, 0), 3);
    CHECK(distance(a, b, 3, 0.01, 1).value == 0);
    CHECK(distance(a, {bar(0, 1, forever)}, 1).value == forever);
    CHECK(distance(a, {bar(0, 1, forever)}, 1).lower == forever);
    netmesh_wasserstein_request request = wasserstein_request(a, b, 2, 0.01, 0);
    std::vector<std::uint32_t> mates(3);
    request.mates_a = mates.data();
    CHECK(wasserstein(request).status == NETMESH_OK);
    CHECK(mates == std::vector<std::uint32_t>{1, 0, NETMESH_NONE});
}

TEST_CASE("the sum of a hundred thousand essential pairs is within the least error") {
    // Moves of 3 and of 2^-26: what each small one adds to a sum in doubles, and to each root of it, is rounded.
    const double forever = std::numeric_limits<double>::infinity(), small = 0x1p-26;
    Diagram a = {bar(0, -9, forever)}, b = {bar(0, -6, forever)};
    for (int i = 0; i < 100000; ++i) {
        a.push_back(bar(0, i, forever));
        b.push_back(bar(0, i + small, forever));
    }
    const Transport found = distance(a, b, 2, relative_error_least);
    check_is(found, std::sqrt(Real{9} + Real{100000} * small * small));
    CHECK(found.value <= found.lower * (1 + 0x1p-46));
}

TEST_CASE("a distance of nothing has potentials of nothing") {
    const Diagram a = {bar(1, 0, 2), bar(1, 5, 6), bar(0, 0, 1), bar(1, 3, 3)};
    for (const std::uint32_t order : {1u, 2u, 16u}) {
        netmesh_wasserstein_request request = wasserstein_request(a, a, order, 0.001, 1);
        std::vector<std::uint32_t> mates(4);
        std::vector<double> f(4, 7), g(4, 7);
        request.mates_a = mates.data();
        request.potentials_a = f.data();
        request.potentials_b = g.data();
        const Transport found = wasserstein(request);
        CHECK((found.status == NETMESH_OK && found.lower == 0 && found.value == 0));
        CHECK(mates == std::vector<std::uint32_t>{0, 1, NETMESH_NONE, NETMESH_NONE});
        CHECK(f == std::vector<double>(4, 0));
        CHECK(g == std::vector<double>(4, 0));
    }
}

TEST_CASE("distances beyond the doubles are finite, and half of the least double is no nothing") {
    const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    const double forever = std::numeric_limits<double>::infinity();
    for (const std::uint32_t order : {1u, 3u, 16u}) {
        CAPTURE(order);
        const Diagram far = {bar(0, -most, forever)}, near = {bar(0, most, forever)};
        const Diagram wide = {bar(1, -most, most), bar(1, -most, most)};
        for (const Transport& found : {wasserstein(wasserstein_request(far, near, order, 0.001)),
                                       wasserstein(wasserstein_request(wide, {}, order, 0.001))}) {
            CHECK(found.status == NETMESH_OK);
            CHECK(found.value == forever);
            CHECK(found.lower == most);
        }
        const Transport found = wasserstein(wasserstein_request({bar(1, 0, least)}, {}, order, 0.001));
        CHECK(found.status == NETMESH_OK);
        CHECK(found.lower == 0);
        CHECK(found.value == least);
    }
}

TEST_CASE("500 pairs of diagrams against exact assignments, with the potentials that prove it") {
    std::mt19937_64 random(6);
    const double errors[] = {0.1, 0.001, 1e-6, relative_error_least};
    for (int trial = 0; trial < 500; ++trial) {
        CAPTURE(trial);
        const int kind = trial % 6;
        const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
        const auto order = static_cast<std::uint32_t>(trial % 7 == 0 ? 1 + below(NETMESH_ORDER_MAX) : 1 + below(3));
        const double scale = trial % 10 == 9 ? std::ldexp(1.0, static_cast<int>(below(1200)) - 600) : 1;
        const Diagram a = sample(random, below(26), kind, scale);
        Diagram b = sample(random, below(26), kind, scale);
        if (trial % 5 == 4) {  // nearly the same
            b = a;
            for (netmesh_pair& p : b) p.death += 1e-9 * (p.death - p.birth) * static_cast<double>(below(3));
            std::shuffle(b.begin(), b.end(), random);
        }
        const double error = errors[below(4)];
        netmesh_wasserstein_request request = wasserstein_request(a, b, order, error, 1);
        std::vector<std::uint32_t> mates(a.size());
        std::vector<double> f(a.size()), g(b.size());
        request.mates_a = mates.data();
        request.potentials_a = f.data();
        request.potentials_b = g.data();
        const Transport found = wasserstein(request);
        REQUIRE(found.status == NETMESH_OK);
        // In a unit in which powers stay in the range of long doubles, and are not summed up with what is far larger.
        const Real exact = std::pow(least_assignment(a, b, order), 1 / static_cast<Real>(order));
        const Real slack = 1e-15L * static_cast<Real>(a.size() + b.size()) * exact;
        CHECK(found.lower <= exact + slack);
        CHECK(found.value >= exact - slack);
        CHECK(found.value <= found.lower * (1 + error) * (1 + 0x1p-50));
        if (exact > 0) check_outputs(a, b, order, found, mates, f, g);
        // The other way round it is another auction of the same distance.
        const Transport turned = distance(b, a, order, error);
        CHECK(turned.lower <= found.value);
        CHECK(found.lower <= turned.value);
    }
}

TEST_CASE("the unit of length does not matter, to the ends of the doubles") {
    std::mt19937_64 random(7);
    const Diagram a = sample(random, 30, 0, 1), b = sample(random, 25, 0, 1);
    for (const std::uint32_t order : {1u, 2u, 16u}) {
        const Transport found = distance(a, b, order, 0.01);
        for (const int k : {-1000, -300, 300, 1020}) {
            const auto scaled = [k](Diagram d) {
                for (netmesh_pair& p : d) p.birth = std::ldexp(p.birth, k), p.death = std::ldexp(p.death, k);
                return d;
            };
            const Transport other = distance(scaled(a), scaled(b), order, 0.01);
            if (k > -1000) {
                CHECK(other.value == std::ldexp(found.value, k));
                CHECK(other.lower == std::ldexp(found.lower, k));
            }
            CHECK(other.exponent == found.exponent - k);
        }
    }
    const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
    const Diagram tiny = {bar(1, 0, 4 * least)}, huge = {bar(1, -most, most)}, high = {bar(1, -most, most / 2)};
    check_is(distance(tiny, {}, 2, 2), 2 * Real{least});
    check_is(distance(huge, {}, 1), Real{most});
    check_is(distance(huge, high, 3), Real{most} / 2);
    // Both together: the large one stays, the small one counts.
    check_is(distance({huge[0], tiny[0]}, huge, 2, 2), 2 * Real{least});
}

TEST_CASE("diagrams of thousands of bars are within the error, and near the bottleneck distance in high order") {
    std::mt19937_64 random(8);
    for (const int kind : {0, 1, 2, 5}) {
        CAPTURE(kind);
        const Diagram a = sample(random, 1500, kind, 1), b = sample(random, 1400, kind, 1);
        const double n = 2900, widest = bottleneck(a, b).value;
        const Transport one = distance(a, b, 1, 0.001), two = distance(a, b, 2, 0.001),
                        last = distance(a, b, 16, 0.001);
        CHECK(two.lower <= one.value);
        CHECK(last.lower <= two.value);
        CHECK(last.value >= widest);
        CHECK(last.lower <= widest * std::pow(n, 1 / 16.0));
    }
}
