// The log-bottleneck distance of two diagrams, by GUDHI's exact algorithm.
#pragma once
#include <doctest/doctest.h>
#include <gudhi/Bottleneck.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "common/session.hpp"

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
        distance = std::max(distance, Gudhi::persistence_diagram::bottleneck_distance(logarithms(a), logarithms(b), 0));
    }
    return distance;
}

// A bar that is said to be real.
struct Claim {
    std::uint32_t degree;
    netmesh_bar_bounds bounds;
};

// Can the claims be matched to true bars within their bounds, all of them at once? The truth is known to within the
// factor slack.
inline bool all_real(const std::vector<Claim>& claims, const Diagram& truth, double slack) {
    // Augmenting paths. The alpha complex's values are exact to about 1e-12.
    std::map<std::uint32_t, std::vector<std::size_t>> taken;
    for (const auto& [degree, bars] : truth) taken[degree].assign(bars.size(), claims.size());
    const auto fits = [more = slack](const netmesh_bar_bounds& b, const std::pair<double, double>& bar) {
        return b.birth_low <= bar.first * more && bar.first <= b.birth_high * more &&
               b.death_low <= bar.second * more && bar.second <= b.death_high * more;
    };
    for (std::size_t start = 0; start < claims.size(); ++start) {
        const std::uint32_t degree = claims[start].degree;
        if (truth.count(degree) == 0) return false;
        const Bars& bars = truth.at(degree);
        std::vector<std::size_t> queue = {start}, reached_by(bars.size(), claims.size());
        bool done = false;
        for (std::size_t q = 0; q < queue.size() && !done; ++q)
            for (std::size_t j = 0; j < bars.size() && !done; ++j) {
                if (reached_by[j] != claims.size() || !fits(claims[queue[q]].bounds, bars[j])) continue;
                reached_by[j] = queue[q];
                if (taken[degree][j] != claims.size()) {
                    queue.push_back(taken[degree][j]);
                    continue;
                }
                // Turn the path round.
                for (std::size_t at = j;;) {
                    const std::size_t claim = reached_by[at];
                    std::size_t before = bars.size();
                    for (std::size_t m = 0; m < bars.size(); ++m)
                        if (taken[degree][m] == claim) before = m;
                    taken[degree][at] = claim;
                    if (claim == start) break;
                    at = before;
                }
                done = true;
            }
        if (!done) return false;
    }
    return true;
}

// Do the bounds of the session's bars hold? *certain: how many are said to be real. slack: the truth is known to within
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
