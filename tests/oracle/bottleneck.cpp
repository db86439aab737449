// The bottleneck distance against GUDHI's exact one.
#include <gudhi/Bottleneck.h>

#include <cmath>
#include <limits>
#include <vector>

#include <doctest/doctest.h>

#include "common/bottleneck.hpp"
#include "common/inputs.hpp"

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Diagram = std::vector<netmesh_pair>;

std::vector<std::pair<double, double>> for_gudhi(const Diagram& diagram, bool logarithms) {
    std::vector<std::pair<double, double>> points;
    for (const netmesh_pair& p : diagram) {
        points.push_back(logarithms ? std::make_pair(std::log(p.birth), std::log(p.death))
                                    : std::make_pair(p.birth, p.death));
    }
    return points;
}

double ours(const Diagram& a, const Diagram& b, netmesh_scale scale) {
    const Distance d = bottleneck(a, b, scale, 1);
    REQUIRE(d.status == NETMESH_OK);
    return scale == NETMESH_SCALE_LOG ? std::log(d.value) + d.exponent * std::log(2.0) : d.value;
}

// One of five kinds: bars anywhere, mostly short ones, a few long ones, few values, b a moved.
void make(std::uint64_t seed, Diagram* a, Diagram* b) {
    inputs::Random random(seed);
    const std::uint64_t kind = seed % 5;
    for (Diagram* diagram : {a, b}) {
        const std::uint64_t count = 1 + random.below(kind == 4 ? 120 : 160);
        for (std::uint64_t i = 0; i < count; ++i) {
            const double x = random.uniform(), y = random.uniform();
            double birth = 0.1 + x, length = y;
            if (kind == 1) length = 0.2 * y * y * y;
            if (kind == 2) length = i % 20 == 0 ? y : 0.02 * y;
            if (kind == 3) {
                birth = 0.1 * static_cast<double>(1 + random.below(8));
                length = 0.1 * static_cast<double>(1 + random.below(5));
            }
            diagram->push_back(bar(1, birth, birth + length));
        }
        if (seed % 7 == 0) {
            diagram->push_back(bar(1, random.uniform() + 0.5, infinity));
            diagram->push_back(bar(1, random.uniform() + 0.5, infinity));
        }
    }
    if (kind != 4) return;
    *b = *a;
    for (netmesh_pair& p : *b) {
        p.birth += 0.01 * random.uniform();
        p.death += 0.01 * (1 + random.uniform());
    }
}

// Whether the bars can be matched within t by the definition: every bar to a bar of the other diagram or to its own
// place on the diagonal. Augmenting paths one by one.
class Definition {
public:
    Definition(const std::vector<std::pair<double, double>>& a, const std::vector<std::pair<double, double>>& b,
               double t)
        : a_(a), b_(b), t_(t), mate_(a.size() + b.size(), -1) {}
    bool holds() {
        for (std::size_t i = 0; i < mate_.size(); ++i) {
            std::vector<bool> seen(mate_.size());
            if (!match(i, seen)) return false;
        }
        return true;
    }

private:
    static double diagonal(const std::pair<double, double>& p) { return (p.second - p.first) / 2; }
    bool allowed(std::size_t i, std::size_t j) const {
        const std::size_t n = a_.size(), m = b_.size();
        if (i < n && j < m) {
            return std::fabs(a_[i].first - b_[j].first) <= t_ &&
                   (a_[i].second == b_[j].second || std::fabs(a_[i].second - b_[j].second) <= t_);
        }
        if (i < n) return j - m == i && diagonal(a_[i]) <= t_;
        return j >= m || (i - n == j && diagonal(b_[j]) <= t_);
    }
    bool match(std::size_t i, std::vector<bool>& seen) {
        for (std::size_t j = 0; j < mate_.size(); ++j) {
            if (seen[j] || !allowed(i, j)) continue;
            seen[j] = true;
            if (mate_[j] >= 0 && !match(static_cast<std::size_t>(mate_[j]), seen)) continue;
            mate_[j] = static_cast<int>(i);
            return true;
        }
        return false;
    }
    const std::vector<std::pair<double, double>>&a_, &b_;
    double t_;
    std::vector<int> mate_;
};

// GUDHI 3.7 is now and then a little above the distance (1 of these 400 cases): there the definition decides.
std::size_t corrected = 0;

void compare(const Diagram& a, const Diagram& b, netmesh_scale scale) {
    const bool logarithms = scale == NETMESH_SCALE_LOG;
    const auto x = for_gudhi(a, logarithms), y = for_gudhi(b, logarithms);
    const double distance = ours(a, b, scale), theirs = Gudhi::persistence_diagram::bottleneck_distance(x, y, 0.);
    if (std::fabs(distance - theirs) <= 1e-9) return;
    CHECK(theirs > distance);
    CHECK(Definition(x, y, distance + 1e-12).holds());
    CHECK(!Definition(x, y, distance - 1e-12).holds());
    ++corrected;
}

}  // namespace

TEST_CASE("200 pairs of diagrams, plain and log scale") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        Diagram a, b;
        make(seed, &a, &b);
        compare(a, b, NETMESH_SCALE_PLAIN);
        compare(a, b, NETMESH_SCALE_LOG);
    }
    CHECK(corrected <= 1);
}

TEST_CASE("different numbers of essential bars") {
    const Diagram a = {bar(1, 0.5, infinity)}, b = {bar(1, 0.5, 1)};
    CHECK(Gudhi::persistence_diagram::bottleneck_distance(for_gudhi(a, false), for_gudhi(b, false), 0.) == infinity);
    CHECK(ours(a, b, NETMESH_SCALE_PLAIN) == infinity);
    CHECK(ours(a, b, NETMESH_SCALE_LOG) == infinity);
}
