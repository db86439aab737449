#include "bottleneck.hpp"

#include <algorithm>

#include "matching.hpp"

namespace referee {
namespace {

struct ExactBar {
    Rational birth, death;
    bool essential;
};

class Distances {
public:
    explicit Distances(bool log) : log_(log) {}

    // How far apart two radii are; false: infinitely.
    bool between(const Rational& x, const Rational& y, Rational* d) const {
        if (!log_) {
            *d = abs(x - y);
            return true;
        }
        *d = 1;
        if (x == y) return true;
        if (sgn(x) == 0 || sgn(y) == 0) return false;
        const Rational quotient = x > y ? Rational(x / y) : Rational(y / x);
        *d = quotient * quotient;
        return true;
    }
    bool between(const ExactBar& a, const ExactBar& b, Rational* d) const {
        Rational births, deaths;
        if (a.essential != b.essential || !between(a.birth, b.birth, &births)) return false;
        *d = births;
        if (a.essential) return true;
        if (!between(a.death, b.death, &deaths)) return false;
        *d = std::max(births, deaths);
        return true;
    }
    // To the diagonal: half of the length.
    bool length(const ExactBar& a, Rational* d) const {
        if (a.essential || (log_ && sgn(a.birth) == 0 && sgn(a.death) > 0)) return false;
        *d = log_ ? a.birth == a.death ? Rational(1) : Rational(a.death / a.birth) : Rational((a.death - a.birth) / 2);
        return true;
    }

private:
    bool log_;
};

std::vector<ExactBar> exact_bars(const std::vector<Bar>& bars, int degree) {
    std::vector<ExactBar> out;
    for (const Bar& bar : bars)
        if (bar.degree == degree) {
            const bool essential = std::isinf(bar.death);
            out.push_back({exact(bar.birth), essential ? Rational(0) : exact(bar.death), essential});
        }
    return out;
}

}  // namespace

ExactDistance bottleneck(const std::vector<Bar>& first, const std::vector<Bar>& second, int degree, bool log) {
    const std::vector<ExactBar> a = exact_bars(first, degree), b = exact_bars(second, degree);
    const Distances distances(log);
    std::vector<Rational> candidates = {log ? Rational(1) : Rational(0)};
    Rational d;
    for (const ExactBar& x : a)
        for (const ExactBar& y : b)
            if (distances.between(x, y, &d)) candidates.push_back(d);
    for (const auto* bars : {&a, &b})
        for (const ExactBar& x : *bars)
            if (distances.length(x, &d)) candidates.push_back(d);
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    const auto is_enough = [&](const Rational& most) {
        Choices choices(a.size());
        std::vector<char> left, right;
        Rational length;
        for (std::size_t i = 0; i < a.size(); i++)
            for (std::uint32_t j = 0; j < b.size(); j++)
                if (distances.between(a[i], b[j], &length) && length <= most) choices[i].push_back(j);
        for (const ExactBar& x : a) left.push_back(distances.length(x, &length) && length <= most ? 0 : 1);
        for (const ExactBar& y : b) right.push_back(distances.length(y, &length) && length <= most ? 0 : 1);
        std::size_t missing;
        bool is_left;
        return can_match_both(choices, left, right, &missing, &is_left);
    };
    if (!is_enough(candidates.back())) return {true, 0};
    std::size_t low = 0, high = candidates.size() - 1;  // the least that is enough is between
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (is_enough(candidates[middle])) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return {false, candidates[low]};
}

bool is_nearest(double x, const Rational& q) {
    const Rational off = abs(exact(x) - q);
    return off <= abs(exact(std::nextafter(x, INFINITY)) - q) && off <= abs(exact(std::nextafter(x, -INFINITY)) - q);
}

}  // namespace referee
