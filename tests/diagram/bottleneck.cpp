// The bottleneck distance against answers by hand and against all matchings of small diagrams.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "common/bottleneck.hpp"
#include "diagram/cost.hpp"

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// A diagram written down as {{degree, birth, death}, ...}.
struct Bar {
    std::uint32_t degree;
    double birth, death;
};
struct Diagram : std::vector<netmesh_pair> {
    Diagram(std::initializer_list<Bar> bars) {
        for (const Bar& b : bars) push_back(bar(b.degree, b.birth, b.death));
    }
    Diagram(std::size_t count, const Bar& b) : vector(count, bar(b.degree, b.birth, b.death)) {}
    Diagram() = default;
    explicit Diagram(std::size_t count) : vector(count) {}
};

Distance distance(const Diagram& a, const Diagram& b, netmesh_scale scale = NETMESH_SCALE_PLAIN,
                  std::uint32_t degree = NETMESH_ALL_DEGREES) {
    const Distance result = bottleneck(a, b, scale, degree), turned = bottleneck(b, a, scale, degree);
    REQUIRE(result.status == NETMESH_OK);
    REQUIRE(turned.status == NETMESH_OK);
    CHECK(result.value == turned.value);
    CHECK(result.exponent == turned.exponent);
    return result;
}
double plain(const Diagram& a, const Diagram& b, std::uint32_t degree = NETMESH_ALL_DEGREES) {
    const Distance d = distance(a, b, NETMESH_SCALE_PLAIN, degree);
    CHECK(d.exponent == 0);
    return d.value;
}
double ratio(const Diagram& a, const Diagram& b) {
    const Distance d = distance(a, b, NETMESH_SCALE_LOG);
    return std::ldexp(d.value, d.exponent);
}

// All ways to match the finite bars of one degree, bars of the diagonal included, by the definition.
template <class Cost, class Diagonal>
double brute_force(const Diagram& a, const Diagram& b, Cost cost, Diagonal diagonal) {
    const std::size_t n = a.size() + b.size();
    std::vector<std::size_t> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = i;
    double best = infinity;
    do {
        double worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const bool left = i < a.size(), right = order[i] < b.size();
            if (left && right) worst = std::max(worst, cost(a[i], b[order[i]]));
            if (left && !right) worst = std::max(worst, diagonal(a[i]));
            if (!left && right) worst = std::max(worst, diagonal(b[order[i]]));
        }
        best = std::min(best, worst);
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

double plain_cost(const netmesh_pair& p, const netmesh_pair& q) {
    return std::max(std::fabs(p.birth - q.birth), std::fabs(p.death - q.death));
}
double plain_diagonal(const netmesh_pair& p) { return (p.death - p.birth) / 2; }
double ratio_of(double x, double y) { return std::max(x, y) / std::min(x, y); }
double log_cost(const netmesh_pair& p, const netmesh_pair& q) {
    return std::max(ratio_of(p.birth, q.birth), ratio_of(p.death, q.death));
}
double log_diagonal(const netmesh_pair& p) {
    return static_cast<double>(sqrtl(static_cast<long double>(p.death) / p.birth));
}

}  // namespace

TEST_CASE("by hand") {
    CHECK(plain({}, {}) == 0);
    CHECK(ratio({}, {}) == 1);
    CHECK(plain({{0, 1, 3}}, {}) == 1);
    CHECK(plain({{0, 1, 3}}, {{0, 1.25, 3.5}}) == 0.5);
    CHECK(plain({{0, 1, 3}}, {{1, 1, 3}}) == 1);                // other degrees do not help
    CHECK(plain({{0, 1, 3}}, {{0, 11, 13}}) == 1);              // both go to the diagonal
    CHECK(plain({{0, 1, 3}, {1, 0, 8}}, {{0, 1, 3}}) == 4);     // the largest of all degrees
    CHECK(plain({{0, 1, 3}, {1, 0, 8}}, {{0, 1, 3}}, 0) == 0);  // or one
    CHECK(plain({{0, 1, 3}, {1, 0, 8}}, {{0, 1, 3}}, 7) == 0);
    CHECK(plain({{0, 2, 2}, {0, 5, 5}}, {}) == 0);  // bars of length zero are the diagonal
    CHECK(ratio({{0, 1, 9}}, {}) == 3);
    CHECK(ratio({{0, 1, 9}}, {{0, 2, 9}}) == 2);
    CHECK(ratio({{0, 2, 2}, {0, 0, 0}}, {}) == 1);
}

TEST_CASE("multiplicity counts") {
    const Bar b = {1, 1, 5};
    CHECK(plain({b, b, b}, {b, b, b}) == 0);
    CHECK(plain({b, b, b}, {b, b}) == 2);
    CHECK(ratio(Diagram(40, b), Diagram(40, b)) == 1);
    CHECK(ratio(Diagram(41, {1, 1, 4}), Diagram(40, {1, 1, 4})) == 2);
    // Matching equal points to each other is not best here.
    CHECK(plain({{0, 10, 100}, {0, 14, 100}}, {{0, 6, 100}, {0, 10, 100}}) == 4);
}

TEST_CASE("essential bars are matched by birth, as many as there are") {
    CHECK(plain({{0, 0, infinity}}, {}) == infinity);
    CHECK(plain({{0, 0, infinity}}, {{0, 0, 1e300}}) == infinity);
    CHECK(plain({{0, 0, infinity}, {0, 5, infinity}}, {{0, 6, infinity}, {0, 2, infinity}}) == 2);
    CHECK(plain({{3, 0, infinity}}, {{3, 0, infinity}}) == 0);
    CHECK(plain({{0, -3, infinity}, {0, -3, 1}}, {{0, 1, infinity}}) == 4);
    CHECK(ratio({{1, 2, infinity}, {1, 1, infinity}}, {{1, 3, infinity}, {1, 1, infinity}}) == 1.5);
}

TEST_CASE("in log scale births at 0 are matched to births at 0 alone") {
    CHECK(ratio({{0, 0, infinity}}, {{0, 1e-300, infinity}}) == infinity);
    CHECK(ratio({{0, 0, infinity}}, {{0, 0, infinity}}) == 1);
    CHECK(ratio({{0, 0, 1}}, {}) == infinity);
    CHECK(ratio({{0, 0, 1}}, {{0, 1e-9, 1}}) == infinity);
    CHECK(ratio({{0, 0, 1}, {0, 0, 3}}, {{0, 0, 4}, {0, 0, 1}}) == 4.0 / 3);
    CHECK(ratio({{0, 0, 1}, {1, 2, 6}}, {{0, 0, 1}, {1, 3, 6}}) == 1.5);
}

TEST_CASE("ratios that no double holds") {
    const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
    Distance d = distance({{0, least, infinity}}, {{0, most, infinity}}, NETMESH_SCALE_LOG);
    CHECK(d.value == most / 0x1p1023);
    CHECK(d.exponent == 1023 + 1074);
    d = distance({{0, least, 0x1p1000}}, {}, NETMESH_SCALE_LOG);
    CHECK(d.value == 1);
    CHECK(d.exponent == 1037);
    CHECK(plain({{0, -most, most}}, {}) == most);
}

TEST_CASE("half bars in log scale are rounded to the nearest double") {
    std::mt19937_64 random(5);
    for (int i = 0; i < 20000; ++i) {
        double b = double(random() >> 11) * 0x1p-53 + 0.5, d = b * (1 + double(random() >> 11) * 0x1p-53);
        if (i % 3 == 0) d = std::nextafter(b, 2.0);
        if (i % 3 == 1) d *= double(random() % 1000);
        if (d < b) continue;
        const std::uint64_t key = netmesh::LogScale::to_diagonal(b, d);
        const double root =
            std::ldexp(netmesh::double_of_bits(netmesh::bits_of(1.0) | (key << 12 >> 12)), int(key >> 52));
        // 64 bits of mantissa decide all but the closest calls, where either neighbour passes.
        const long double exact = sqrtl(static_cast<long double>(d) / b);
        const long double error = fabsl(root - exact), ulp = std::nextafter(root, 1e300) - root;
        CHECK(error <= ulp * (0.5L + 0x1p-10L));
    }
}

TEST_CASE("all matchings of small diagrams") {
    std::mt19937 random(6);
    for (int round = 0; round < 300; ++round) {
        const unsigned levels = round % 2 == 0 ? 6 : 1000;
        Diagram a(random() % 4), b(random() % 4);
        for (Diagram* diagram : {&a, &b}) {
            for (netmesh_pair& p : *diagram) {
                p = bar(0, double(1 + random() % levels), 0);
                p.death = p.birth + double(random() % levels);
            }
        }
        CHECK(plain(a, b) == brute_force(a, b, plain_cost, plain_diagonal));
        CHECK(ratio(a, b) == std::max(1.0, brute_force(a, b, log_cost, log_diagonal)));
    }
}

TEST_CASE("a large diagram moved by a known amount, in any order, whatever else lies near the diagonal") {
    std::mt19937_64 random(7);
    const auto uniform = [&] { return double(random() >> 11) * 0x1p-53; };
    Diagram a, b;
    for (int i = 0; i < 3000; ++i) {
        const double birth = uniform(), death = birth + 0.5 + uniform();
        const double step = 0.01 * uniform();
        a.push_back(bar(1, birth, death));
        b.push_back(bar(1, birth + step, death - step));
        if (i % 2 == 0) a.push_back(bar(1, birth, birth + 0.01 * uniform()));
    }
    a.push_back(bar(1, 9, 11));
    b.push_back(bar(1, 9.25, 11));
    std::shuffle(b.begin(), b.end(), random);
    CHECK(plain(a, b) == 0.25);
}

TEST_CASE("arguments and scratch") {
    const Diagram a = {{0, 1, 3}};
    netmesh_bottleneck_request request = bottleneck_request(a, a);
    const std::size_t bytes = netmesh_bottleneck_bytes(&request);
    const Scratch scratch(request);
    auto d = netmesh::sized<netmesh_distance>();
    const auto call = [&](const Diagram& x, netmesh_scale scale, std::size_t given) {
        request = bottleneck_request(x, a, scale, 0);
        scratch.lend(&request);
        request.scratch_bytes = given;
        return netmesh_bottleneck(&request, &d, nullptr);
    };
    CHECK(call(a, NETMESH_SCALE_PLAIN, bytes) == NETMESH_OK);
    CHECK(call(a, NETMESH_SCALE_PLAIN, bytes - 1) == NETMESH_OUT_OF_MEMORY);
    CHECK(call(a, NETMESH_SCALE_PLAIN, 0) == NETMESH_OUT_OF_MEMORY);
    CHECK(call({{0, 3, 1}}, NETMESH_SCALE_PLAIN, bytes) == NETMESH_INVALID_ARGUMENT);
    CHECK(call({{0, std::nan(""), 1}}, NETMESH_SCALE_PLAIN, bytes) == NETMESH_INVALID_ARGUMENT);
    CHECK(call({{0, 1, std::nan("")}}, NETMESH_SCALE_PLAIN, bytes) == NETMESH_INVALID_ARGUMENT);
    CHECK(call({{0, -infinity, 1}}, NETMESH_SCALE_PLAIN, bytes) == NETMESH_INVALID_ARGUMENT);
    CHECK(call({{0, -1, 1}}, NETMESH_SCALE_PLAIN, bytes) == NETMESH_OK);
    CHECK(call({{0, -1, 1}}, NETMESH_SCALE_LOG, bytes) == NETMESH_INVALID_ARGUMENT);
    request.count_a = std::uint64_t{1} << 60;
    CHECK(netmesh_bottleneck_bytes(&request) == SIZE_MAX);
    netmesh::Bottleneck empty;
    CHECK(netmesh_bottleneck(&empty, &d, nullptr) ==
          (netmesh_bottleneck_bytes(&empty) == 0 ? NETMESH_OK : NETMESH_OUT_OF_MEMORY));
}

TEST_CASE("a poll can cancel") {
    std::mt19937_64 random(8);
    Diagram a(4000), b(4000);
    for (Diagram* diagram : {&a, &b}) {
        for (netmesh_pair& p : *diagram) p = bar(0, double(random() % 1000003), 2e6 + double(random() % 1000003));
    }
    netmesh_bottleneck_request request = bottleneck_request(a, b, NETMESH_SCALE_PLAIN, 0);
    const Scratch scratch(request);
    scratch.lend(&request);
    int calls = 0;
    request.monitor.user = &calls;
    request.monitor.poll = [](void* user, const netmesh_progress*) { return ++*static_cast<int*>(user) == 2 ? 1 : 0; };
    netmesh_distance d = {sizeof d, -1, -1};
    CHECK(netmesh_bottleneck(&request, &d, nullptr) == NETMESH_CANCELLED);
    CHECK(calls == 2);
    CHECK(d.value == -1);
}

namespace {

// The distance by the textbook: the least of all distances within which the points of both diagrams and their places on
// the diagonal have a perfect matching.
double by_textbook(const Diagram& a, const Diagram& b) {
    const std::size_t n = a.size(), m = b.size(), all = n + m;
    const auto cost = [&](std::size_t i, std::size_t j) {
        if (i >= n && j >= m) return 0.0;
        if (i >= n) return (b[j].death - b[j].birth) / 2;
        if (j >= m) return (a[i].death - a[i].birth) / 2;
        return std::max(std::fabs(a[i].birth - b[j].birth), std::fabs(a[i].death - b[j].death));
    };
    std::vector<double> limits = {0};
    for (std::size_t i = 0; i < all; ++i)
        for (std::size_t j = 0; j < all; ++j) limits.push_back(cost(i, j));
    std::sort(limits.begin(), limits.end());
    limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
    const auto matches = [&](double limit) {
        std::vector<std::size_t> mate(all, all);
        for (std::size_t root = 0; root < all; ++root) {
            // Breadth first from `root` on the left to a free place on the right.
            std::vector<std::size_t> from(all, all), queue = {root};
            std::size_t free = all;
            for (std::size_t at = 0; at < queue.size() && free == all; ++at)
                for (std::size_t j = 0; j < all && free == all; ++j) {
                    if (from[j] != all || cost(queue[at], j) > limit) continue;
                    from[j] = queue[at];
                    if (mate[j] == all)
                        free = j;
                    else
                        queue.push_back(mate[j]);
                }
            if (free == all) return false;
            for (std::size_t j = free;;) {
                const std::size_t i = from[j];
                std::size_t before = all;
                for (std::size_t k = 0; k < all; ++k)
                    if (mate[k] == i) before = k;
                mate[j] = i;
                if (i == root) break;
                j = before;
            }
        }
        return true;
    };
    std::size_t low = 0, high = limits.size() - 1;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (matches(limits[middle]))
            high = middle;
        else
            low = middle + 1;
    }
    return limits[high];
}

}  // namespace

TEST_CASE("diagrams of a hundred points, many of them at equal distances") {
    std::mt19937_64 random(21);
    for (int trial = 0; trial < 12; ++trial) {
        CAPTURE(trial);
        const unsigned grid = trial % 3 == 0 ? 1000000 : trial % 3 == 1 ? 12 : 6;
        const auto some = [&](std::size_t count) {
            Diagram d;
            for (std::size_t i = 0; i < count; ++i) {
                const double birth = static_cast<double>(random() % grid);
                d.push_back(bar(1, birth, birth + 1 + static_cast<double>(random() % (grid + 40))));
            }
            return d;
        };
        const Diagram a = some(60 + random() % 40), b = some(60 + random() % 40);
        CHECK(plain(a, b) == by_textbook(a, b));
    }
    // Long bars close to one another: nearly every point is within the distance of every other one.
    for (int trial = 0; trial < 6; ++trial) {
        CAPTURE(trial);
        const auto some = [&](std::size_t count, unsigned wide) {
            Diagram d;
            for (std::size_t i = 0; i < count; ++i)
                d.push_back(bar(1, static_cast<double>(random() % wide), 100 + static_cast<double>(random() % 4)));
            return d;
        };
        Diagram a = some(170, 3), b = some(160 + random() % 20, 3 + trial % 2);
        for (std::size_t i = 0; i < 5; ++i) a[i].birth = 3, b[i].birth = 6;  // three apart, and farther from all others
        CHECK(plain(a, b) == by_textbook(a, b));
    }
    // Few bars, the second diagram's shorter: they may stay unmatched where those of the first may not.
    for (int trial = 0; trial < 3000; ++trial) {
        CAPTURE(trial);
        const auto some = [&](std::size_t count, unsigned length) {
            Diagram d;
            for (std::size_t i = 0; i < count; ++i) {
                const double birth = static_cast<double>(random() % 30);
                d.push_back(bar(0, birth, birth + length + static_cast<double>(random() % 30)));
            }
            return d;
        };
        const Diagram a = some(1 + random() % 5, 20), b = some(1 + random() % 6, 1 + trial % 20);
        CHECK(plain(a, b) == by_textbook(a, b));
    }
}
