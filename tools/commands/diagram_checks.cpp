#include "tools/commands/diagram_checks.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>

namespace netmesh::tool {

std::string diagram_complaint(const std::vector<Bar>& bars, std::size_t* at) {
    std::size_t essential = 0;
    for (std::size_t i = 0; i < bars.size(); i++) {
        const Bar& bar = bars[i];
        if (at != nullptr) *at = i;
        if (!(std::isfinite(bar.birth) && bar.birth >= 0)) return "a birth that is not a finite radius";
        if (!(bar.death >= bar.birth)) return "a death before the birth";
        if (i > 0 && comes_before(bar, bars[i - 1])) return "bars that are not sorted by degree, birth, death";
        if (std::isfinite(bar.death)) continue;
        essential++;
        if (bar.degree != 0 || bar.birth != 0) return "an essential class that is not of degree 0, born at 0";
        if (essential > 1) return "more than one essential class";
    }
    if (at != nullptr) *at = bars.size();
    return essential == 1 ? "" : "no essential class";
}

std::size_t first_difference(const std::vector<Bar>& a, const std::vector<Bar>& b) {
    std::size_t i = 0;
    while (i < a.size() && i < b.size() && a[i] == b[i]) i++;
    return i == a.size() && i == b.size() ? SIZE_MAX : i;
}

bool nearly_equal(const std::vector<Bar>& a, const std::vector<Bar>& b, double tolerance) {
    const auto negligible = [tolerance](double birth, double death) {
        return std::isfinite(death) && death - birth <= 2 * tolerance * death;
    };
    std::multiset<std::tuple<std::uint32_t, double, double>> left;
    for (const Bar& bar : b) left.emplace(bar.degree, bar.birth, bar.death);
    for (const Bar& bar : a) {
        const double birth_slack = tolerance * bar.birth;
        const double death_slack = std::isfinite(bar.death) ? tolerance * bar.death : 0;
        // Births at 0 are equal or not, so that the search goes straight to the death.
        const double least_death = bar.birth == 0 ? bar.death - death_slack : 0;
        auto at = left.lower_bound({bar.degree, bar.birth - birth_slack, least_death});
        while (at != left.end() && std::get<0>(*at) == bar.degree && std::get<1>(*at) <= bar.birth + birth_slack &&
               !(std::get<2>(*at) >= bar.death - death_slack && std::get<2>(*at) <= bar.death + death_slack)) {
            ++at;
        }
        if (at != left.end() && std::get<0>(*at) == bar.degree && std::get<1>(*at) <= bar.birth + birth_slack) {
            left.erase(at);
        } else if (!negligible(bar.birth, bar.death)) {
            return false;
        }
    }
    for (const auto& [degree, birth, death] : left) {
        if (!negligible(birth, death)) return false;
    }
    return true;
}

std::string bar_text(const std::vector<Bar>& bars, std::size_t index) {
    if (index >= bars.size()) return "nothing";
    std::string text = std::to_string(bars[index].degree) + " ";
    append_number(text, bars[index].birth);
    text += ' ';
    append_number(text, bars[index].death);
    return text;
}

}  // namespace netmesh::tool
