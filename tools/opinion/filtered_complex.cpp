#include "tools/opinion/filtered_complex.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netmesh::tool {

namespace {

// Sum of two chains over Z/2.
void add_chain(std::vector<std::uint32_t>& chain, const std::vector<std::uint32_t>& other) {
    std::vector<std::uint32_t> sum;
    sum.reserve(chain.size() + other.size());
    std::set_symmetric_difference(chain.begin(), chain.end(), other.begin(), other.end(), std::back_inserter(sum));
    chain.swap(sum);
}

}  // namespace

FilteredComplex::FilteredComplex(std::vector<FilteredSimplex> simplices, double slack)
    : simplices_(std::move(simplices)), slack_(slack) {
    std::sort(simplices_.begin(), simplices_.end(), [](const FilteredSimplex& a, const FilteredSimplex& b) {
        if (a.value != b.value) return a.value < b.value;
        if (a.vertices.size() != b.vertices.size()) return a.vertices.size() < b.vertices.size();
        return a.vertices < b.vertices;
    });
    for (std::uint32_t i = 0; i < simplices_.size(); i++) place_.emplace(simplices_[i].vertices, i);
    reduce();
}

FilteredComplex::Column FilteredComplex::boundary(std::uint32_t simplex) const {
    const Vertices& vertices = simplices_[simplex].vertices;
    Column faces;
    for (std::size_t v = 0; v < vertices.size() && vertices.size() > 1; v++) {
        Vertices face = vertices;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(v));
        faces.push_back(place_.at(face));
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

// Columns of one dimension after the other, the highest first: a column whose simplex is a pivot already reduces to
// nothing and is not looked at.
void FilteredComplex::reduce() {
    reduced_.assign(count(), {});
    killed_by_.assign(count(), nobody);
    std::uint32_t top = 0;
    for (std::uint32_t i = 0; i < count(); i++) top = std::max(top, dimension(i));
    for (std::uint32_t d = top; d > 0; d--) {
        for (std::uint32_t i = 0; i < count(); i++) {
            if (dimension(i) != d || killed_by_[i] != nobody) continue;
            Column column = boundary(i);
            while (!column.empty() && killed_by_[column.back()] != nobody)
                add_chain(column, reduced_[killed_by_[column.back()]]);
            if (column.empty()) continue;
            killed_by_[column.back()] = i;
            reduced_[i] = std::move(column);
        }
    }
}

std::vector<Bar> FilteredComplex::bars(std::uint32_t max_degree, bool zero_bars) const {
    std::vector<Bar> bars;
    for (std::uint32_t i = 0; i < count(); i++) {
        if (dimension(i) > max_degree || !reduced_[i].empty()) continue;
        const double birth = simplices_[i].value;
        const double death = killed_by_[i] == nobody ? HUGE_VAL : simplices_[killed_by_[i]].value;
        if (zero_bars || death > birth) bars.push_back({dimension(i), birth, death});
    }
    std::sort(bars.begin(), bars.end(), comes_before);
    return bars;
}

bool FilteredComplex::is_same(double a, double b) const {
    if (a == b || !std::isfinite(a) || !std::isfinite(b)) return a == b;
    return std::fabs(a - b) <= slack_ * std::fmax(std::fabs(a), std::fabs(b));
}

// Each bar takes one of the same degree, birth and death that no other has taken. What is left over on either side is
// of no length but for rounding.
std::string FilteredComplex::bars_complaint(const std::vector<Bar>& have, std::uint32_t max_degree, bool zero_bars,
                                            std::size_t* at) const {
    const std::vector<Bar> due = bars(max_degree, zero_bars);
    std::vector<bool> taken(due.size(), false);
    std::size_t first = 0;  // no bar before can be taken any more
    for (std::size_t i = 0; i < have.size(); i++) {
        *at = i;
        const Bar& bar = have[i];
        while (first < due.size() &&
               (taken[first] || (comes_before(due[first], bar) && due[first].degree < bar.degree)))
            first++;
        std::size_t j = first;
        const auto equal = [&](const Bar& other) {
            return other.degree == bar.degree && is_same(other.birth, bar.birth) && is_same(other.death, bar.death);
        };
        const auto past = [&](const Bar& other) {
            return other.degree > bar.degree || (other.degree == bar.degree && other.birth > bar.birth * (1 + slack_));
        };
        while (j < due.size() && !past(due[j]) && (taken[j] || !equal(due[j]))) j++;
        const bool found = j < due.size() && !taken[j] && equal(due[j]);
        if (found) taken[j] = true;
        if (!found && (slack_ == 0 || !is_same(bar.birth, bar.death))) return "no pair of the reduction";
    }
    for (std::size_t j = 0; j < due.size(); j++) {
        if (taken[j] || (slack_ > 0 && is_same(due[j].birth, due[j].death))) continue;
        TextWriter text;
        text << due[j].degree << ' ' << due[j].birth << ' ' << due[j].death;
        return "the pair " + text.text() + " of the reduction is missing";
    }
    return "";
}

// Reduced columns have different pivots, so a chain is a sum of them only if it goes to nothing pivot by pivot.
bool FilteredComplex::is_boundary(Column chain, double until, bool included) const {
    while (!chain.empty()) {
        const std::uint32_t by = killed_by_[chain.back()];
        if (by == nobody || simplices_[by].value > until || (!included && simplices_[by].value == until)) return false;
        add_chain(chain, reduced_[by]);
    }
    return true;
}

std::string FilteredComplex::read_cycle(const std::vector<Vertices>& chain, std::uint32_t degree, Column* column,
                                        double* latest) const {
    Column faces;
    *latest = -HUGE_VAL;
    for (const Vertices& vertices : chain) {
        const auto found = place_.find(vertices);
        if (found == place_.end()) return "has a simplex in its cycle that the complex lacks";
        column->push_back(found->second);
        *latest = std::fmax(*latest, simplices_[found->second].value);
        add_chain(faces, boundary(found->second));
    }
    std::sort(column->begin(), column->end());
    if (std::adjacent_find(column->begin(), column->end()) != column->end()) return "has a simplex twice in its cycle";
    for (const std::uint32_t i : *column)
        if (dimension(i) != degree) return "has a cycle of another degree";
    return faces.empty() ? "" : "has a chain with a boundary";
}

std::string FilteredComplex::cycle_complaint(const std::vector<Vertices>& chain, const Bar& bar) const {
    const bool dies = std::isfinite(bar.death);
    Column column;
    double latest;
    const std::string complaint = read_cycle(chain, bar.degree, &column, &latest);
    if (!complaint.empty()) return complaint;
    if (column.empty()) return "has no cycle";
    if (bar.degree == 0 && column.size() != (dies ? 2 : 1)) return "has a chain of too many or too few vertices";
    if (!is_same(latest, bar.birth)) return "has a cycle that is not born with it";
    const bool lives = bar.death > bar.birth && !is_same(bar.birth, bar.death);
    if (lives && is_boundary(column, bar.death * (1 - slack_), false)) return "has a cycle that dies before it";
    if (dies && !is_boundary(column, bar.death * (1 + slack_), true)) return "has a cycle that does not die with it";
    return "";
}

std::string FilteredComplex::chain_complaint(const std::vector<Vertices>& chain, const ChainClaim& claim) const {
    Column column;
    double latest;
    const std::string complaint = read_cycle(chain, claim.degree, &column, &latest);
    if (!complaint.empty()) return complaint;
    if (!column.empty() && latest > claim.born_by * (1 + slack_)) return "has a cycle that is born too late";
    const bool lives = claim.alive_until > claim.born_by * (1 + 2 * slack_);
    if (lives && is_boundary(column, claim.alive_until * (1 - slack_), false)) return "has a cycle that dies too early";
    if (!is_boundary(column, claim.dead_from * (1 + slack_), true) && std::isfinite(claim.dead_from))
        return "has a cycle that dies too late";
    return "";
}

}  // namespace netmesh::tool
