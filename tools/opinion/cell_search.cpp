#include "tools/opinion/cell_search.hpp"

#include <algorithm>
#include <utility>

namespace netmesh::tool {

namespace {

constexpr std::size_t goals_max = 8, between_max = 8;
// So many of the places with the largest values are taken in pairs.
constexpr std::size_t highest_max = 12;

// Where the squares to the sources of both are equal on the way from one to the other: their difference is affine.
Place between(const Known& a, const Known& b) {
    const Real at_a = distance2(a.x, a.source) - distance2(a.x, b.source);
    const Real at_b = distance2(b.x, a.source) - distance2(b.x, b.source);
    if (!((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))) return {};
    Place x = a.x;
    for (std::size_t k = 0; k < x.size(); k++) x[k] += at_a / (at_a - at_b) * (b.x[k] - a.x[k]);
    return x;
}

}  // namespace

Known known_at(const FilteredFunction& function, Place x) {
    Known known = {std::move(x), 0, {}};
    known.f = function(known.x, &known.source);
    return known;
}

void seek_least(const FilteredFunction& function, const Place& first,
                const std::function<Place(const Place&)>& nearest_to, std::vector<Known>* known) {
    const auto lower = [](const Known& a, const Known& b) { return a.f < b.f; };
    std::vector<Place> goals = {first};
    for (std::size_t step = 0; step < goals.size(); step++) {
        Place x = nearest_to(goals[step]);
        if (x.empty()) return;
        const Known there = known_at(function, x);
        x.clear();
        if (!function.is_least_of_distances()) {
            const auto least = std::min_element(known->begin(), known->end(), lower);
            if (least != known->end()) x = between(*least, there);
            if (!x.empty()) known->push_back(known_at(function, std::move(x)));
        }
        known->push_back(there);
        if (goals.size() == goals_max) continue;
        const Known* lowest = nullptr;
        for (const Known& place : *known) {
            const bool is_tried = std::find(goals.begin(), goals.end(), place.source) != goals.end();
            if (!is_tried && (lowest == nullptr || place.f < lowest->f)) lowest = &place;
        }
        if (lowest != nullptr) goals.push_back(lowest->source);
    }
}

void seek_most(const FilteredFunction& function, std::vector<Known>* known) {
    const auto higher = [](const Known& a, const Known& b) { return a.f > b.f; };
    std::vector<Known> high = *known;
    std::vector<std::pair<Place, Place>> tried;
    for (std::size_t step = 0; step < between_max; step++) {
        std::sort(high.begin(), high.end(), higher);
        if (high.size() > highest_max) high.resize(highest_max);
        Place x;
        // The pair whose lower value is largest.
        for (std::size_t j = 1; j < high.size() && x.empty(); j++) {
            for (std::size_t i = 0; i < j && x.empty(); i++) {
                const Known &a = high[i], &b = high[j];
                if (a.source == b.source) continue;
                if (std::find(tried.begin(), tried.end(), std::make_pair(a.x, b.x)) != tried.end()) continue;
                tried.emplace_back(a.x, b.x);
                x = between(a, b);
            }
        }
        if (x.empty()) return;
        high.push_back(known_at(function, std::move(x)));
        known->push_back(high.back());
    }
}

}  // namespace netmesh::tool
