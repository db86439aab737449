// The log-bottleneck distance of two diagrams, by GUDHI's exact algorithm.
#pragma once
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "common/session.hpp"
#include "oracle/peers/gudhi.hpp"

using Bars = std::vector<std::pair<double, double>>;
using Diagram = std::map<std::uint32_t, Bars>;

inline Diagram diagram(const Session& session) {
    Diagram bars;
    for (const netmesh_pair& pair : session.pairs()) bars[pair.degree].push_back({pair.birth, pair.death});
    return bars;
}

// Births at 0 are infinitely far from all others on the log scale, so these bars are matched to each other, in order of
// death, which is best; the one that never dies to its like.
inline double log_distance_of_degree_0(Bars a, Bars b) {
    REQUIRE(a.size() == b.size());
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    double distance = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        REQUIRE(a[i].first == 0);
        REQUIRE(b[i].first == 0);
        if (a[i].second != b[i].second)
            distance = std::max(distance, std::fabs(std::log(a[i].second) - std::log(b[i].second)));
    }
    return distance;
}

inline Bars logarithms(const Bars& bars) {
    Bars logs;
    for (const auto& [birth, death] : bars) logs.push_back({std::log(birth), std::log(death)});
    return logs;
}

// Bars of degree 0 that are not born at 0 come from Steiner vertices that are minima; they count as noise.
inline void split_degree_0(const Bars& bars, Bars* from_zero, Bars* others) {
    for (const auto& bar : bars) (bar.first == 0 ? from_zero : others)->push_back(bar);
}

// The largest over degrees 0..dim-1.
inline double log_distance(Diagram ours, Diagram truth, std::uint32_t dim) {
    double distance = 0;
    for (std::uint32_t degree = 0; degree < dim; ++degree) {
        Bars a = ours[degree], b = truth[degree];
        if (degree == 0) {
            Bars zero;
            Bars rest;
            split_degree_0(a, &zero, &rest);
            distance = std::max(distance, log_distance_of_degree_0(zero, b));
            a = rest;
            b.clear();
        }
        distance = std::max(distance, gudhi_bottleneck(logarithms(a), logarithms(b)));
    }
    return distance;
}

// A bar that is said to exist.
struct Claim {
    std::uint32_t degree;
    netmesh_bar_bounds bounds;
};

// Can all of `left` be matched, each to one of `right` of its own? fits(i, j): i to j. Augmenting paths.
template <class Fits> bool all_matched(std::size_t left, std::size_t right, Fits fits) {
    std::vector<std::size_t> taken(right, left), has(left, right);
    for (std::size_t start = 0; start < left; ++start) {
        std::vector<std::size_t> queue = {start}, reached_by(right, left);
        bool done = false;
        for (std::size_t q = 0; q < queue.size() && !done; ++q)
            for (std::size_t j = 0; j < right && !done; ++j) {
                if (reached_by[j] != left || !fits(queue[q], j)) continue;
                reached_by[j] = queue[q];
                done = taken[j] == left;
                if (!done) queue.push_back(taken[j]);
                for (std::size_t at = j; done && at != right;) {  // turn the path round
                    taken[at] = reached_by[at];
                    std::swap(at, has[reached_by[at]]);
                }
            }
        if (!done) return false;
    }
    return true;
}

// Can the claims be matched to true bars within their bounds, all of them at once? The truth is known to within the
// factor slack.
inline bool all_real(const std::vector<Claim>& claims, const Diagram& truth, double slack) {
    std::map<std::uint32_t, std::vector<netmesh_bar_bounds>> bounds;
    for (const Claim& claim : claims) bounds[claim.degree].push_back(claim.bounds);
    for (const auto& [degree, list] : bounds) {
        const Bars bars = truth.count(degree) ? truth.at(degree) : Bars();
        const auto fits = [&, &boxes = list](std::size_t i, std::size_t j) {
            return boxes[i].birth_low <= bars[j].first * slack && bars[j].first <= boxes[i].birth_high * slack &&
                   boxes[i].death_low <= bars[j].second * slack && bars[j].second <= boxes[i].death_high * slack;
        };
        if (!all_matched(list.size(), bars.size(), fits)) return false;
    }
    return true;
}

// Do the bounds of the session's bars hold? *certain: how many are said to exist. slack: the truth is known to within
// this factor, and bars so short may be missing from it.
inline bool bounds_hold(Session& session, const Diagram& truth, std::size_t* certain, double slack = 1 + 1e-9) {
    REQUIRE(session.bound_bars() == NETMESH_OK);
    *certain = 0;
    std::vector<Claim> claims;
    const std::vector<netmesh_pair> pairs = session.pairs();
    const std::vector<netmesh_bar_bounds> bounds = read_all(session.context, netmesh_get_bar_bounds);
    REQUIRE(bounds.size() == pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const netmesh_pair& pair = pairs[i];
        const Claim claim = {pair.degree, bounds[i]};
        CHECK(claim.bounds.birth_low <= pair.birth);
        CHECK(claim.bounds.birth_high >= pair.birth);
        CHECK(claim.bounds.death_low <= pair.death);
        CHECK(claim.bounds.death_high >= pair.death);
        *certain += claim.bounds.certain;
        const bool seen = claim.bounds.death_low > claim.bounds.birth_high * slack * slack;
        if (claim.bounds.certain && (slack < 1.001 || seen)) claims.push_back(claim);
    }
    return all_real(claims, truth, slack);
}

// Where the true value of a birth or death surely is.
struct Range {
    double low, high;
};

// A ratio as a function of scale: what netmesh_scale_step says, before the first step 1.
struct Curve {
    std::vector<netmesh_scale_step> steps;

    static Range in_step(const netmesh_scale_step& step, double a) {
        const double low = std::min(step.low, a), high = std::max(step.high, a);
        return {a > 0 ? std::max(low, a / step.ratio) : 0, a > 0 ? std::min(high, a * step.ratio) : high};
    }
    Range at(double a) const {
        Range range = {a, a};
        for (std::size_t i = 0; i < steps.size() && steps[i].from <= a && a < HUGE_VAL; ++i)
            range = in_step(steps[i], a);
        return range;
    }
    // Is there a scale whose range holds this whole true bar? Then it need not be in the diagram.
    bool may_be_missed(double birth, double death) const {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            // The last scale of the step whose range begins at the birth or before.
            const double next = i + 1 < steps.size() ? steps[i + 1].from : HUGE_VAL;
            const double last = std::min(next, steps[i].low <= birth ? birth * steps[i].ratio : birth);
            if (last >= steps[i].from && in_step(steps[i], last).high >= death) return true;
        }
        return false;
    }
};

inline Curve curve(const Session& session) { return {read_all(session.context, netmesh_get_scale_step)}; }

// Is no bar farther from the truth than the curve allows at its own scale? Every bar has a true bar of its own within
// the ranges of its birth and death, or these meet; every true bar has such a bar, or may be missed. (Where each side's
// bars can be matched, both sides' can at once.) slack as below.
inline bool moves_within(const Curve& curve, const Diagram& ours, const Diagram& truth, double slack = 1 + 1e-9) {
    struct Box {
        Range birth, death;
    };
    std::map<std::uint32_t, std::pair<std::vector<Box>, Bars>> degrees;
    for (const auto& [degree, bars] : ours)
        for (const auto& [birth, death] : bars) degrees[degree].first.push_back({curve.at(birth), curve.at(death)});
    for (const auto& [degree, bars] : truth) degrees[degree].second = bars;
    for (auto& [degree, both] : degrees) {
        auto& [boxes, bars] = both;
        // Those that need a partner to the front.
        const auto some = [slack](const Box& b) { return b.death.low > b.birth.high * slack * slack; };
        const auto needed = static_cast<std::size_t>(std::partition(boxes.begin(), boxes.end(), some) - boxes.begin());
        const auto seen = [&curve, slack](const std::pair<double, double>& bar) {
            return bar.second > bar.first * slack * slack &&
                   !curve.may_be_missed(bar.first * slack, bar.second / slack);
        };
        const auto due = static_cast<std::size_t>(std::partition(bars.begin(), bars.end(), seen) - bars.begin());
        const auto fits = [slack, &boxes = boxes, &bars = bars](std::size_t i, std::size_t j) {
            const auto [birth, death] = bars[j];
            return boxes[i].birth.low <= birth * slack && birth <= boxes[i].birth.high * slack &&
                   boxes[i].death.low <= death * slack && death <= boxes[i].death.high * slack;
        };
        if (!all_matched(needed, bars.size(), fits)) return false;
        if (!all_matched(due, boxes.size(), [&](std::size_t j, std::size_t i) { return fits(i, j); })) return false;
    }
    return true;
}
