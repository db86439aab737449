#include "tools/commands/diagram_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace netmesh::tool {

std::string diagram_complaint(const std::vector<Bar>& bars, std::size_t* at, bool any_sign, bool any_essential) {
    std::size_t essential = 0;
    double least = bars.empty() ? 0 : bars[0].birth;
    for (const Bar& bar : bars) least = bar.birth < least ? bar.birth : least;
    for (std::size_t i = 0; i < bars.size(); i++) {
        const Bar& bar = bars[i];
        if (at != nullptr) *at = i;
        if (!(std::isfinite(bar.birth) && (any_sign || bar.birth >= 0))) return "a birth that is not a finite radius";
        if (!(bar.death >= bar.birth)) return "a death before the birth";
        if (i > 0 && comes_before(bar, bars[i - 1])) return "bars that are not sorted by degree, birth, death";
        if (std::isfinite(bar.death)) continue;
        essential++;
        if (any_essential) continue;
        if (bar.degree != 0 || bar.birth != least) return "an essential class that is not of degree 0, born first";
        if (essential > 1) return "more than one essential class";
    }
    if (at != nullptr) *at = bars.size();
    return essential == 1 || any_essential ? "" : "no essential class";
}

std::size_t first_difference(const std::vector<Bar>& a, const std::vector<Bar>& b) {
    std::size_t i = 0;
    while (i < a.size() && i < b.size() && a[i] == b[i]) i++;
    return i == a.size() && i == b.size() ? SIZE_MAX : i;
}

std::string bar_text(const std::vector<Bar>& bars, std::size_t index) {
    if (index >= bars.size()) return "nothing";
    std::string text = std::to_string(bars[index].degree) + " ";
    append_number(text, bars[index].birth);
    text += ' ';
    append_number(text, bars[index].death);
    return text;
}

std::vector<Bar> diagram_at(const Vines& vines, std::uint32_t k) {
    std::vector<Bar> bars;
    for (const netmesh_vine_point& p : vines.points) {
        if (p.k == k) bars.push_back({p.degree, p.birth, p.death});
    }
    std::sort(bars.begin(), bars.end(), comes_before);
    return bars;
}

}  // namespace netmesh::tool
