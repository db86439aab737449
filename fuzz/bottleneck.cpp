// Diagrams to their bottleneck distance, in both scales, and their Wasserstein distance against the definition: all
// ways to match small diagrams. The scratch memory is allocated at the size that was asked for.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/wasserstein.hpp"
#include "fuzz/decoder.hpp"

namespace {

using fuzz::require;
using Diagram = std::vector<netmesh_pair>;
using Real = long double;  // ratios of any two doubles have to fit

constexpr Real infinity = std::numeric_limits<Real>::infinity();

// Distances in PLAIN scale, ratios in LOG scale.
struct Scale {
    bool log;

    Real least() const { return log ? 1 : 0; }
    Real between(double x, double y) const {
        if (x == y) return least();
        if (!log) return std::fabs(x - y);
        const double small = std::min(x, y);
        return small == 0 ? infinity : static_cast<Real>(std::max(x, y)) / small;
    }
    Real to_diagonal(const netmesh_pair& p) const {
        if (p.birth == p.death) return least();
        if (log) return p.birth == 0 ? infinity : std::sqrt(static_cast<Real>(p.death) / p.birth);
        const double length = p.death - p.birth;
        return std::isfinite(length) ? length / 2 : p.death / 2 - p.birth / 2;
    }
    Real cost(const netmesh_pair& p, const netmesh_pair& q) const {
        return std::max(between(p.birth, q.birth), between(p.death, q.death));
    }
};

// Bars of `a` and of the diagonal to bars of `b` and of the diagonal, in every way: the least of all that `add` makes
// of a matching's costs, from the scale's least on.
template <class Add>
Real least_over_matchings(const Diagram& a, const Diagram& b, Scale scale, bool with_diagonal, Add add) {
    if (!with_diagonal && a.size() != b.size()) return infinity;
    std::vector<std::size_t> order(with_diagonal ? a.size() + b.size() : a.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    Real best = infinity;
    do {
        Real worst = scale.least();
        for (std::size_t i = 0; i < order.size(); ++i) {
            const bool left = i < a.size(), right = order[i] < b.size();
            if (left && right) add(&worst, scale.cost(a[i], b[order[i]]));
            if (left && !right) add(&worst, scale.to_diagonal(a[i]));
            if (!left && right) add(&worst, scale.to_diagonal(b[order[i]]));
        }
        best = std::min(best, worst);
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

void widen(Real* worst, Real cost) { *worst = std::max(*worst, cost); }

Diagram part(const Diagram& all, std::uint32_t degree, bool essential) {
    Diagram result;
    for (const netmesh_pair& p : all)
        if (p.degree == degree && std::isinf(p.death) == essential) result.push_back(p);
    return result;
}

Diagram decode_diagram(fuzz::Tape& tape, bool log) {
    Diagram result;
    const std::uint32_t count = tape.below(4);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint8_t how = tape.byte();
        netmesh_pair p = bar(how & 1u, 0, 0);
        p.birth = fuzz::coordinate(tape.byte());
        p.death = fuzz::coordinate(tape.byte());
        if (how % 8 == 7) {  // neighbours in the last place, of few values
            p.birth = 1 + std::ldexp(how >> 4, -52);
            p.death = p.birth * (1 + (how & 16));
        }
        if (log) p.birth = std::fabs(p.birth), p.death = std::fabs(p.death);
        if (p.death < p.birth) std::swap(p.birth, p.death);
        if (how >> 5 == 7) p.death = std::numeric_limits<double>::infinity();
        result.push_back(p);
    }
    return Diagram(result);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Tape tape(data, size);
    const bool log = (tape.byte() & 1) != 0;
    const std::uint32_t choice = tape.below(4), degree = choice < 2 ? choice : NETMESH_ALL_DEGREES;
    Diagram a = decode_diagram(tape, log);
    const Diagram b = decode_diagram(tape, log);

    const netmesh_scale scaling = log ? NETMESH_SCALE_LOG : NETMESH_SCALE_PLAIN;
    const Distance found = bottleneck(a, b, scaling, degree), turned = bottleneck(b, a, scaling, degree);
    require(found.status == NETMESH_OK && turned.status == NETMESH_OK);
    require(found.value == turned.value && found.exponent == turned.exponent);
    const Scale scale = {log};
    Real expected = scale.least();
    for (std::uint32_t k = 0; k < 2; ++k) {
        if (degree != NETMESH_ALL_DEGREES && degree != k) continue;
        expected = std::max(expected, least_over_matchings(part(a, k, false), part(b, k, false), scale, true, widen));
        expected = std::max(expected, least_over_matchings(part(a, k, true), part(b, k, true), scale, false, widen));
    }
    if (!log || std::isinf(expected)) {
        require(found.value == expected && found.exponent == 0);
    } else {  // the library's is rounded from the exact ratio, ours from one of 64 bits
        require(found.value >= 1 && found.value < 2);
        require(std::fabs(std::ldexp(static_cast<Real>(found.value), found.exponent) - expected) <=
                expected * 0x1p-52L);
    }

    if (!log) {
        const auto order = 1 + tape.below(3);
        const Transport bounds = wasserstein(wasserstein_request(a, b, order, 0.01, degree));
        require(bounds.status == NETMESH_OK && bounds.lower <= bounds.value);
        Real sum = 0;
        for (std::uint32_t k = 0; k < 2; ++k) {
            if (degree != NETMESH_ALL_DEGREES && degree != k) continue;
            const auto add = [order](Real* all, Real cost) { *all += std::pow(cost, static_cast<Real>(order)); };
            sum += least_over_matchings(part(a, k, false), part(b, k, false), scale, true, add);
            sum += least_over_matchings(part(a, k, true), part(b, k, true), scale, false, add);
        }
        const Real exact = std::pow(sum, 1 / static_cast<Real>(order)), slack = exact * 0x1p-50L + 0x1p-1073L;
        require(std::isinf(bounds.value) ? std::isinf(exact) || exact > 0x1p1023L : bounds.value >= exact - slack);
        require(std::isinf(exact) ? std::isinf(bounds.lower) : bounds.lower <= exact + slack);
        const bool is_large = bounds.value > 0x1p-1000;
        require(!std::isfinite(bounds.value) || !is_large || bounds.value <= bounds.lower * 1.01 * (1 + 0x1p-50));
    }

    // What is no diagram is refused.
    if (!a.empty()) {
        netmesh_pair& p = a[tape.below(static_cast<std::uint32_t>(a.size()))];
        switch (tape.below(4)) {
        case 0: p.birth = std::numeric_limits<double>::quiet_NaN(); break;
        case 1: p.death = std::numeric_limits<double>::quiet_NaN(); break;
        case 2: p.birth = std::numeric_limits<double>::infinity(); break;
        default: p.death = std::nextafter(p.birth, -std::numeric_limits<double>::infinity()); break;
        }
        require(bottleneck(a, b, scaling).status == NETMESH_INVALID_ARGUMENT);
    }
    return 0;
}
