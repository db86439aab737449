// check: what other code than the engine's says of a diagram.
#include <algorithm>
#include <cmath>

#include "tools/asked_function.hpp"
#include "tools/commands/check_parts.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/io/cycle_file.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/opinion/cell_values.hpp"
#include "tools/opinion/complexes.hpp"
#include "tools/opinion/filtered_complex.hpp"
#include "tools/opinion/function_cells.hpp"

namespace netmesh::tool {

Outcome read_cycles(const DiagramClaim& claim, std::vector<CycleEntry>* cycles) {
    const std::string name = shown_name(claim.cycles_path);
    const std::vector<Bar>& bars = claim.file.bars;
    std::string content;
    Outcome outcome = read_content(claim.cycles_path, &content);
    if (outcome.good()) outcome = parse_cycles(content, name, cycles);
    if (!outcome.good()) return outcome;
    for (std::size_t i = 0; i < cycles->size(); i++)
        if (i >= bars.size() || !((*cycles)[i].bar == bars[i]))
            return line_error(name, (*cycles)[i].line,
                              "check failed: its bar is not bar " + std::to_string(i) + " of " + claim.file.name, 0,
                              Exit::check);
    if (cycles->size() < bars.size())
        return file_error(name, "check failed: bar " + bar_text(bars, cycles->size()) + " has no cycle", Exit::check);
    return {};
}

Outcome cycle_refused(const DiagramClaim& claim, const std::vector<CycleEntry>& cycles, std::size_t at,
                      const std::string& why) {
    return line_error(shown_name(claim.cycles_path), cycles[at].line,
                      "check failed: bar " + bar_text(claim.file.bars, at) + " " + why, 0, Exit::check);
}

Outcome judge_cycles(const DiagramClaim& claim, const FilteredComplex& complex, std::vector<std::string>* checked) {
    if (claim.cycles_path.empty()) return {};
    std::vector<CycleEntry> cycles;
    const Outcome outcome = read_cycles(claim, &cycles);
    if (!outcome.good()) return outcome;
    for (std::size_t i = 0; i < cycles.size(); i++) {
        const std::string complaint = complex.cycle_complaint(cycles[i].simplices, cycles[i].bar);
        if (!complaint.empty()) return cycle_refused(claim, cycles, i, complaint);
    }
    checked->push_back("second opinion: " + grouped_text(cycles.size()) +
                       " cycles are closed, are born with their bars and die with them");
    return {};
}

namespace {

constexpr double cost_max = 1e9;  // some ten seconds

std::string shown(Real value) { return rounded_text(static_cast<double>(value), 12); }

// The cells of a mesh against the values in its file and what the diagram's file certifies.
class CellJury {
public:
    CellJury(const DiagramClaim& claim, const MeshFiles& files, double ratio)
        : claim_(claim), files_(files), ratio_(ratio),
          opinion_(cell_opinion(files, choice_of(claim.made), std::max(claim.made.request.k, 1u), ratio)),
          has_values_(files.node.attribute_count == 1) {
        for (std::size_t v = 0; v < opinion_.values.size(); v++)
            values_.push_back(has_values_ ? files.node.attributes[v] : static_cast<double>(opinion_.values[v].least));
    }
    Outcome judge(std::vector<std::string>* checked);
    // Filter values: those of the mesh's file where it has some.
    const std::vector<double>& values() const { return values_; }
    double slack() const { return has_values_ ? 0 : static_cast<double>(opinion_.tolerance); }

private:
    bool agrees(Real a, Real b) const {
        return a == b || std::fabs(a - b) <= opinion_.tolerance * std::max(std::fabs(a), std::fabs(b));
    }
    Outcome judge_ratio();
    Outcome judge_values();
    Outcome judge_cells();
    Outcome judge_step(const std::vector<double>& step, const std::string& line, double next, std::uint64_t number);
    Outcome judge_steps(std::size_t* steps);
    Outcome bad_vertex(std::size_t v, const std::string& why) const {
        return files_.node.cloud.fault(v, "check failed: " + why, Exit::check);
    }

    const DiagramClaim& claim_;
    const MeshFiles& files_;
    double ratio_;  // certified, and by now reproduced
    CellOpinion opinion_;
    bool has_values_;
    std::vector<double> values_;
    Real worst_ = 0;  // relative difference of values
};

Outcome CellJury::judge_values() {
    for (std::size_t v = 0; v < values_.size(); v++) {
        const Span due = opinion_.values[v];
        const double have = values_[v];
        const Real nearest = std::min(std::max<Real>(have, due.least), due.most);
        if (!agrees(have, nearest))
            return bad_vertex(v, "filter value " + number_text(have) + " where " + shown(nearest) +
                                     " follows from the vertex's cell");
        if (nearest > 0) worst_ = std::max(worst_, std::fabs(have - nearest) / nearest);
    }
    return {};
}

Outcome CellJury::judge_ratio() {
    const HeadLine* const line = claim_.file.head ? claim_.file.head->find("certified-ratio") : nullptr;
    const std::uint64_t number = line == nullptr ? 1 : line->number;
    const Real nearest = std::min(std::max<Real>(ratio_, opinion_.ratio.least), opinion_.ratio.most);
    if (!agrees(ratio_, nearest))
        return claim_.file.wrong(number, "certified ratio " + number_text(ratio_) + " where " + shown(nearest) +
                                             " follows from the cells of the mesh");
    const HeadLine* const from = claim_.file.head ? claim_.file.head->find("certified-from") : nullptr;
    double have = 0;
    if (from == nullptr) return {};
    const bool is_number = parse_finite(from->value, &have);
    const Real due = std::min(std::max<Real>(have, opinion_.from.least), opinion_.from.most);
    if (is_number && agrees(have, due)) return {};
    return claim_.file.wrong(from->number, quoted("# " + head_text(*from)) + " where " + shown(due) +
                                               " follows from the cells of the mesh");
}

// Interleaving, by what the function takes at places of the cells: F <= c t and t <= c F on each of them.
Outcome CellJury::judge_cells() {
    const bool basic = choice_of(claim_.made).filter == NETMESH_FILTER_BASIC;
    const Real c = ratio_ * (1 + opinion_.tolerance), from = opinion_.from.most * (1 + opinion_.tolerance);
    for (std::size_t v = 0; v < values_.size(); v++) {
        const CellRange seen = opinion_.seen[v];
        const Real most = basic && values_[v] == 0 ? from : c * values_[v];
        if (seen.hi > most)
            return bad_vertex(v, "the function takes " + shown(seen.hi) +
                                     " on the vertex's cell, more than the ratio " + number_text(ratio_) +
                                     " allows for the filter value " + number_text(values_[v]));
        if (values_[v] > c * seen.lo)
            return bad_vertex(v, "the function takes " + shown(seen.lo) +
                                     " on the vertex's cell, less than the ratio " + number_text(ratio_) +
                                     " allows for the filter value " + number_text(values_[v]));
    }
    return {};
}

// A step {from, low, high, ratio} of the ratio by scale: where the filter is at a scale a of the step, or below, the
// function is at most max(high, a) and ratio a; where it is at a or above, at least min(low, a) and a / ratio.
Outcome CellJury::judge_step(const std::vector<double>& step, const std::string& line, double next,
                             std::uint64_t number) {
    const double from = step[0], low = step[1], high = step[2], ratio = step[3];
    const double more = 1 + static_cast<double>(opinion_.tolerance);
    for (std::size_t v = 0; v < values_.size(); v++) {
        const double t = values_[v], at_least = std::max(from, t), at_most = std::min(next, t);
        const CellRange seen = opinion_.seen[v];
        const Real most = std::min<Real>(std::max(high, at_least), at_least > 0 ? ratio * at_least : HUGE_VAL);
        const Real least = std::max<Real>(std::min(low, at_most), at_most / ratio);
        const bool above = t < next && seen.hi > most * more, below = t >= from && seen.lo * more < least;
        if (above || below)
            return claim_.file.wrong(number, quoted(line) + ": at vertex " + std::to_string(v) +
                                                 " of the mesh, of filter value " + number_text(t) +
                                                 ", the function takes " + shown(above ? seen.hi : seen.lo));
    }
    return {};
}

// {from, low, high, ratio or error} of a line of the certificate by scale.
struct Step {
    std::vector<double> numbers;
    const BoundLine* line;
};
// Infinity of either sign, too: a function has no lower bound below its first scale.
bool parse_number(const std::string& text, double* value) {
    if (text != "inf" && text != "-inf") return parse_finite(text, value);
    *value = text == "inf" ? HUGE_VAL : -HUGE_VAL;
    return true;
}
Outcome read_steps(const DiagramFile& file, const char* last, std::vector<Step>* list) {
    for (const BoundLine& line : file.bounds) {
        if (line.text.rfind("# scale ", 0) != 0) continue;
        const std::vector<std::string_view> words = split_blanks(line.text);
        Step step = {{}, &line};
        for (const char* name : {"scale", "low", "high", last}) {
            const auto at = std::find(words.begin(), words.end(), name);
            double value = 0;
            if (at == words.end() || at + 1 == words.end() || !parse_number(std::string(at[1]), &value))
                return file.wrong(line.number, quoted(line.text) + " has no number for " + name);
            step.numbers.push_back(value);
        }
        list->push_back(step);
    }
    return {};
}

Outcome CellJury::judge_steps(std::size_t* steps) {
    std::vector<Step> list;
    const Outcome read = read_steps(claim_.file, "ratio", &list);
    if (!read.good()) return read;
    *steps = list.size();
    for (std::size_t i = 0; i < list.size(); i++) {
        const double next = i + 1 < list.size() ? list[i + 1].numbers[0] : HUGE_VAL;
        const Outcome outcome = judge_step(list[i].numbers, list[i].line->text, next, list[i].line->number);
        if (!outcome.good()) return outcome;
    }
    return {};
}

Outcome CellJury::judge(std::vector<std::string>* checked) {
    std::size_t steps = 0;
    Outcome outcome = judge_ratio();
    if (outcome.good()) outcome = judge_values();
    if (outcome.good()) outcome = judge_cells();
    if (outcome.good()) outcome = judge_steps(&steps);
    if (!outcome.good()) return outcome;
    std::string text = "second opinion: ";
    if (has_values_)
        text += grouped_text(values_.size()) + " filter values are those of the vertices' cells (to " +
                rounded_text(static_cast<double>(worst_), 2) + ", " +
                rounded_text(static_cast<double>(opinion_.tolerance), 2) + " allowed), and ";
    text += "certified ratio " + bound_text(ratio_, 6) + " follows from them";
    text += "; the function keeps to it at " + grouped_text(opinion_.places) + " places of cells";
    if (steps > 0) text += " and to " + grouped_text(steps) + " ratios by scale";
    checked->push_back(text);
    return {};
}

Outcome judge_pairs(const DiagramClaim& claim, const SimplexList& simplices, double slack,
                    std::vector<std::string>* checked) {
    if (!simplices) {
        if (!claim.cycles_path.empty())
            return usage_error("--representatives: the complex has more than " +
                               counted(opinion_simplices_max, "simplex", "simplices") +
                               ", which are too many to check cycles");
        if (claim.is_proven) return {};
        checked->push_back("no second opinion on the pairs: more than " +
                           counted(opinion_simplices_max, "simplex", "simplices"));
        return {};
    }
    const FilteredComplex complex(*simplices, slack);
    std::size_t at = 0;
    const std::string complaint = complex.bars_complaint(claim.file.bars, claim.made.request.max_degree,
                                                         (claim.made.request.keep_zero_pairs != 0), &at);
    if (!complaint.empty())
        return claim.file.wrong(claim.file.line_of(at), bar_text(claim.file.bars, at) + ": " + complaint);
    checked->push_back("second opinion: " + counted(claim.file.bars.size(), "bar", "bars") +
                       " are the pairs of a plain reduction of " + counted(complex.count(), "simplex", "simplices"));
    return judge_cycles(claim, complex, checked);
}

// The pairs of a mesh's filter by these values.
Outcome judge_mesh_pairs(const DiagramClaim& claim, const MeshFiles& files, const std::vector<double>& values,
                         double slack, std::vector<std::string>* checked) {
    const std::uint32_t first = zero_born(files.node, filter_of(claim.made), std::max(claim.made.request.k, 1u));
    std::uint64_t unknown = 0;
    const SimplexList simplices = mesh_complex(files, values, first, claim.made.request.max_degree + 1, &unknown);
    if (unknown == 0) return judge_pairs(claim, simplices, slack, checked);
    const std::string why =
        "to working precision it is open whether " + grouped_text(unknown) + " faces of Voronoi cells meet the domain";
    if (!claim.cycles_path.empty()) return usage_error("--representatives: " + why + ", which leaves cycles open");
    checked->push_back("no second opinion on the pairs: " + why);
    return {};
}

// Of the filter by a function, what CellJury::judge_step says of ratios: where the filter is at a value a of the step,
// or below, the function is at most max(high, a) and a + error; where it is at a or above, at least min(low, a) and a -
// error.
Outcome judge_error_steps(const DiagramClaim& claim, const FunctionOpinion& opinion, const std::vector<double>& values,
                          std::size_t* steps) {
    std::vector<Step> list;
    const Outcome read = read_steps(claim.file, "error", &list);
    if (!read.good()) return read;
    *steps = list.size();
    for (std::size_t i = 0; i < list.size(); i++) {
        const double from = list[i].numbers[0], low = list[i].numbers[1], high = list[i].numbers[2],
                     error = list[i].numbers[3], next = i + 1 < list.size() ? list[i + 1].numbers[0] : HUGE_VAL;
        for (std::size_t v = 0; v < values.size(); v++) {
            const double t = values[v], at_least = std::max(from, t), at_most = std::min(next, t);
            const Real slack = 1e-9L * (std::fabs(t) + std::fabs(*claim.made.cut) + std::min(error, 1e300));
            const Real most = std::min(std::max(high, at_least), at_least + error) + slack;
            const Real least = std::max(std::min(low, at_most), at_most - error) - slack;
            const Real up = std::max(opinion.most[v], opinion.high[v]),
                       down = std::min(opinion.least[v], opinion.low[v]);
            const bool above = t < next && up > most, below = t >= from && down < least;
            if (above || below)
                return claim.file.wrong(list[i].line->number, quoted(list[i].line->text) + ": at vertex " +
                                                                  std::to_string(v) + " of the mesh, of filter value " +
                                                                  number_text(t) + ", the function is or may be " +
                                                                  shown(above ? up : down));
        }
    }
    return {};
}

// Of the filter by a function: its error is large enough, and the bars are those of its values.
Outcome judge_function(const DiagramClaim& claim, const MeshFiles& files, RunReport* run) {
    const Options& made = claim.made;
    if (files.node.clipped) {
        run->checked->push_back("no second opinion: functions are looked at on whole cells alone");
        return {};
    }
    const netmesh_diagram_report& diagram = run->engine->diagram;
    const FunctionClaim said = {[&](const double* x) { return function_at(made, x); }, *made.lipschitz, *made.cut,
                                diagram.certified_error};
    const FunctionOpinion opinion = function_opinion(files, said);
    const bool has_values = files.node.attribute_count == 1,
               are_own = std::isinf(diagram.certified_ratio) || choice_of(made).values == NETMESH_VALUES_THESIS;
    if (!has_values && !are_own) {
        run->checked->push_back("no second opinion: " + files.node.cloud.name + " has no filter values");
        return {};
    }
    std::vector<double> values = files.node.attributes;
    if (!has_values) values.assign(opinion.values.begin(), opinion.values.end());
    std::size_t at = 0;
    const std::string complaint = error_complaint(opinion, said, values, &at);
    if (!complaint.empty()) return files.node.cloud.fault(at, "check failed: " + complaint, Exit::check);
    for (at = 0; at < values.size() && are_own; at++)
        if (values[at] != static_cast<double>(opinion.values[at]))
            return files.node.cloud.fault(at,
                                          "check failed: filter value " + number_text(values[at]) +
                                              " where the function is " + shown(opinion.values[at]),
                                          Exit::check);
    std::size_t steps = 0;
    const Outcome outcome = judge_error_steps(claim, opinion, values, &steps);
    if (!outcome.good()) return outcome;
    run->checked->push_back("second opinion: the function keeps to the error " + bound_text(said.error, 6) +
                            (steps > 0 ? ", and to " + grouped_text(steps) + " by value," : "") + " at " +
                            grouped_text(opinion.places + values.size()) +
                            " places of cells, and as far as --lipschitz lets it");
    return judge_pairs(claim, lower_stars(files.cells, values, 0, made.request.max_degree + 1), 0, &*run->checked);
}

}  // namespace

Outcome second_opinion_on_mesh(const DiagramClaim& claim, const MeshFiles& files, RunReport* run) {
    if (files.node.domain.empty()) {
        bool is_too_large = false;
        const Outcome outcome = judge_alpha(claim, files, "of " + files.node.cloud.name, &is_too_large, &*run->checked);
        return is_too_large ? judge_pairs(claim, {}, 0, &*run->checked) : outcome;
    }
    if (filter_of(claim.made) == NETMESH_FILTER_FUNCTION) return judge_function(claim, files, run);
    const double cost = opinion_cost(files);
    if (cost > cost_max) {
        run->checked->push_back("no second opinion on the values: cells times inputs are " + rounded_text(cost, 3) +
                                ", more than " + rounded_text(cost_max, 3));
        if (files.node.attribute_count != 1) return {};
        // The pairs can still be looked at, with the values as the mesh has them.
        return judge_mesh_pairs(claim, files, files.node.attributes, 0, &*run->checked);
    }
    CellJury jury(claim, files, run->engine->diagram.certified_ratio);
    const Outcome outcome = jury.judge(&*run->checked);
    if (!outcome.good()) return outcome;
    return judge_mesh_pairs(claim, files, jury.values(), jury.slack(), &*run->checked);
}

Outcome second_opinion_on_complex(const DiagramClaim& claim, const SimplexList& simplices, RunReport* run) {
    return judge_pairs(claim, simplices, radius_tolerance, &*run->checked);
}

}  // namespace netmesh::tool
