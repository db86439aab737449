#include "cycles.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "../nerve.hpp"
#include "truth.hpp"

namespace referee {
namespace {

void rank_by(const std::map<Simplex, double>& entries, double slack, ValuedComplex* out) {
    for (const auto& entry : entries) out->radii.push_back(entry.second);
    std::sort(out->radii.begin(), out->radii.end());
    const auto same = [&](double a, double b) { return b <= a * (1 + slack); };
    out->radii.erase(std::unique(out->radii.begin(), out->radii.end(), same), out->radii.end());
    for (const auto& entry : entries) {
        const auto above = std::upper_bound(out->radii.begin(), out->radii.end(), entry.second);
        out->complex.add(entry.first, static_cast<std::uint32_t>(above - out->radii.begin() - 1));
    }
    out->complex.reduce();
}

std::string title(const Cycle& cycle) {
    return "the cycle of bar " + count_text(cycle.degree) + " " + exact_text(cycle.birth) + " " +
           exact_text(cycle.death);
}

bool near(double a, double b, double slack) {
    return a == b || std::fabs(a - b) <= slack * std::max(std::fabs(a), std::fabs(b));
}

}  // namespace

bool lower_star(const Mesh& mesh, bool inputs_first, int top, std::size_t most, ValuedComplex* out) {
    if (mesh.cells.size() > most) return false;
    std::map<Simplex, double> entries;
    const std::size_t size = static_cast<std::size_t>(top) + 2;
    std::optional<Nerve> nerve;
    if (mesh.clipped) nerve.emplace(mesh);
    for (const Entries& cell : mesh.cells) {
        std::vector<std::uint32_t> vertices(cell.begin(), cell.begin() + mesh.dim + 1);
        std::sort(vertices.begin(), vertices.end());
        for_each_set(static_cast<std::uint32_t>(vertices.size()), size, [&](const Simplex& places) {
            Simplex simplex;
            double value = 0;
            for (const std::uint32_t i : places) {
                simplex.push_back(vertices[i]);
                value = std::max(value, mesh.values[vertices[i]]);
            }
            if (inputs_first && simplex.size() == 1 && mesh.markers[simplex[0]] == input_marker) value = 0;
            if (!nerve || nerve->has(simplex)) entries[simplex] = value;
        });
        if (entries.size() > most) return false;
    }
    out->top = top;
    rank_by(entries, 0, out);
    return true;
}

ValuedComplex rips_complex(const std::vector<Point>& points, int dim, int top) {
    std::map<Simplex, double> entries;
    for_each_set(static_cast<std::uint32_t>(points.size()), static_cast<std::size_t>(top) + 2,
                 [&](const Simplex& simplex) {
                     double longest = 0;
                     for (const std::uint32_t i : simplex)
                         for (const std::uint32_t j : simplex)
                             longest = std::max(longest, distance(points[i], points[j], dim) / 2);
                     entries[simplex] = longest;
                 });
    ValuedComplex out;
    out.top = top;
    rank_by(entries, 0x1p-40, &out);
    return out;
}

ValuedComplex cech_complex(const std::vector<Point>& points, int dim, int top) {
    ValuedComplex out;
    out.top = top;
    rank_by(enclosing_radii(points, dim, static_cast<std::size_t>(top) + 2), 0x1p-40, &out);
    return out;
}

void judge_pairs(const DiagramFile& diagram, const ValuedComplex& due, Verdict* verdict) {
    struct Entry {
        int degree;
        double birth, death;
        bool operator<(const Entry& b) const {
            return degree != b.degree ? degree < b.degree : birth != b.birth ? birth < b.birth : death < b.death;
        }
        bool operator!=(const Entry& b) const { return *this < b || b < *this; }
    };
    std::vector<Entry> found, wanted;
    for (const Bar& bar : diagram.bars)
        if (bar.birth < bar.death) found.push_back({bar.degree, bar.birth, bar.death});
    for (const PositionPair& pair : due.complex.pairs()) {
        const int degree = static_cast<int>(due.complex.simplex(pair.birth).size()) - 1;
        const double birth = due.radii[due.complex.rank(pair.birth)];
        const double death = pair.death == never ? INFINITY : due.radii[due.complex.rank(pair.death)];
        if (degree <= due.top && birth < death) wanted.push_back({degree, birth, death});
    }
    std::sort(found.begin(), found.end());
    std::sort(wanted.begin(), wanted.end());
    if (found.size() != wanted.size())
        return verdict->add("pairs", count_text(found.size()) + " bars, the mesh has " + count_text(wanted.size()));
    for (std::size_t i = 0; i < found.size(); i++)
        if (found[i] != wanted[i])
            return verdict->add("pairs", "bar " + count_text(found[i].degree) + " " + exact_text(found[i].birth) + " " +
                                             exact_text(found[i].death) + " is no pair of the mesh's");
}

void judge_cycles(const DiagramFile& diagram, const std::vector<Cycle>& cycles, const ValuedComplex& within,
                  double slack, Verdict* verdict) {
    if (cycles.size() != diagram.bars.size())
        return verdict->add("cycles",
                            count_text(cycles.size()) + " cycles, " + count_text(diagram.bars.size()) + " are due");
    for (std::size_t i = 0; i < cycles.size(); i++) {
        const Cycle& cycle = cycles[i];
        const Bar& bar = diagram.bars[i];
        const auto wrong = [&](const std::string& text) { verdict->add("cycles", title(cycle) + " " + text); };
        if (cycle.degree != bar.degree || cycle.birth != bar.birth || cycle.death != bar.death) {
            wrong("is not that of its bar");
            continue;
        }
        Complex::Chain chain, boundary;
        bool is_there = true;
        for (Simplex simplex : cycle.simplices) {
            std::sort(simplex.begin(), simplex.end());
            const std::uint32_t position = within.complex.position(simplex);
            is_there = is_there && position != never && static_cast<int>(simplex.size()) == bar.degree + 1;
            if (!is_there) break;
            add_chain(&chain, {position});
            add_chain(&boundary, within.complex.boundary(position));
        }
        if (!is_there || chain.size() != cycle.simplices.size() || chain.empty()) {
            wrong("has a simplex that is none, or one twice");
            continue;
        }
        if (bar.degree == 0 && chain.size() != (std::isinf(bar.death) ? 1u : 2u)) wrong("is not one vertex or two");
        if (!boundary.empty()) wrong("has a boundary");
        if (!near(within.radii[within.complex.rank(chain.back())], bar.birth, slack))
            wrong("is born at another radius");
        const std::uint32_t death = within.complex.death_of(chain);
        const double radius = death == never ? INFINITY : within.radii[within.complex.rank(death)];
        if (!near(radius, bar.death, slack)) wrong("dies at " + exact_text(radius));
    }
}

void judge_point_cycles(const DiagramFile& diagram, const std::vector<Cycle>& cycles, const ValuedComplex& within,
                        Verdict* verdict) {
    constexpr double room = 1 + 0x1p-36;
    const double ratio = diagram.ratio();
    if (cycles.size() != diagram.bars.size())
        return verdict->add("cycles",
                            count_text(cycles.size()) + " cycles, " + count_text(diagram.bars.size()) + " are due");
    for (std::size_t i = 0; i < cycles.size(); i++) {
        const Cycle& cycle = cycles[i];
        const Bar& bar = diagram.bars[i];
        const auto wrong = [&](const std::string& text) { verdict->add("cycles", title(cycle) + " " + text); };
        if (cycle.degree != bar.degree || cycle.birth != bar.birth || cycle.death != bar.death) {
            wrong("is not that of its bar");
            continue;
        }
        const bool dies = std::isfinite(bar.death);
        if (cycle.simplices.empty()) {
            if (!dies || bar.death > ratio * ratio * bar.birth * room) wrong("is empty");
            continue;
        }
        if (bar.birth == bar.death) wrong("is there");
        Complex::Chain chain, boundary;
        bool is_there = true;
        for (Simplex simplex : cycle.simplices) {
            std::sort(simplex.begin(), simplex.end());
            const std::uint32_t position = within.complex.position(simplex);
            is_there = is_there && position != never && static_cast<int>(simplex.size()) == bar.degree + 1;
            if (!is_there) break;
            add_chain(&chain, {position});
            add_chain(&boundary, within.complex.boundary(position));
        }
        if (!is_there || chain.size() != cycle.simplices.size()) {
            wrong("has a simplex that is none, or one twice");
            continue;
        }
        if (bar.degree == 0 && chain.size() != (dies ? 2u : 1u)) wrong("is not one point or two");
        if (!boundary.empty()) wrong("has a boundary");
        const double born = within.radii[within.complex.rank(chain.back())];
        if (born > bar.birth * ratio * room) wrong("is born at " + exact_text(born));
        const std::uint32_t death = within.complex.death_of(chain);
        const double radius = death == never ? INFINITY : within.radii[within.complex.rank(death)];
        const bool lives = bar.death > ratio * ratio * bar.birth * room;
        if (radius > bar.death * ratio * room || (lives && radius * room < bar.death / ratio))
            wrong("dies at " + exact_text(radius));
    }
}

}  // namespace referee
