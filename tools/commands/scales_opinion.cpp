// check: a diagram that is joined of scales, against the true one by the Cech complex of the points, which shares
// nothing with it: no partition, no mesh, no filter.
#include <cmath>
#include <map>
#include <set>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/cycles.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/io/cycle_file.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/opinion/bar_matching.hpp"
#include "tools/opinion/filtered_complex.hpp"

namespace netmesh::tool {

namespace {

constexpr double more = 1 + radius_tolerance;

bool parse_radius(std::string_view word, double* value) {
    if (word != "inf") return parse_finite(std::string(word), value);
    *value = HUGE_VAL;
    return true;
}

// Who is certified to exist: `DEGREE BIRTH DEATH # birth A B death C D real`.
Outcome read_real(const DiagramFile& file, std::vector<BarBox>* boxes, std::vector<std::size_t>* bars) {
    std::size_t bar = 0;
    for (const BoundLine& line : file.bounds) {
        if (line.text[0] == '#') continue;
        const std::vector<std::string_view> words = split_blanks(line.text);
        BarBox box = {file.bars[bar].degree, 0, 0, 0, 0};
        if (words.size() < 10 || !parse_radius(words[5], &box.birth_low) || !parse_radius(words[6], &box.birth_high) ||
            !parse_radius(words[8], &box.death_low) || !parse_radius(words[9], &box.death_high))
            return file.wrong(line.number, "not `# birth LOW HIGH death LOW HIGH`");
        box.birth_low /= more;
        box.birth_high *= more;
        box.death_low /= more;
        box.death_high *= more;
        if (words.size() > 10) {
            boxes->push_back(box);
            bars->push_back(bar);
        }
        bar++;
    }
    return {};
}

// Bars and true bars of more than ratio^2 have each other within the ratio.
Outcome judge_ratio(const DiagramFile& file, const std::vector<Bar>& truth, double ratio) {
    const auto boxes_of = [&](const std::vector<Bar>& list, std::vector<std::size_t>* places) {
        std::vector<BarBox> boxes;
        for (std::size_t i = 0; i < list.size(); i++) {
            if (!(list[i].death > ratio * ratio * list[i].birth * more)) continue;
            boxes.push_back(box_of(list[i], ratio * more));
            places->push_back(i);
        }
        return boxes;
    };
    std::vector<std::size_t> bars, true_bars;
    std::size_t at = 0;
    if (!can_place(boxes_of(file.bars, &bars), truth, &at))
        return file.wrong(file.line_of(bars[at]), bar_text(file.bars, bars[at]) + ": no true bar is within the ratio " +
                                                      number_text(ratio) + " of it that is not another's");
    if (!can_place(boxes_of(truth, &true_bars), file.bars, &at))
        return file.wrong(1, "the true bar " + bar_text(truth, true_bars[at]) +
                                 " has no bar of its own within the ratio " + number_text(ratio));
    return {};
}

Outcome judge_real(const DiagramFile& file, const std::vector<Bar>& truth, std::string* text) {
    std::vector<BarBox> boxes;
    std::vector<std::size_t> bars;
    const Outcome read = read_real(file, &boxes, &bars);
    if (!read.good()) return read;
    std::size_t at = 0;
    if (!can_place(boxes, truth, &at))
        return file.wrong(file.line_of(bars[at]), bar_text(file.bars, bars[at]) +
                                                      ": said to exist, but no true bar is within its bounds that is "
                                                      "not another's");
    if (!boxes.empty())
        *text += ", and the " + grouped_text(boxes.size()) + " that are real different ones within their bounds";
    return {};
}

ChainClaim claim_of(const Bar& bar, double ratio) {
    return {bar.degree, bar.birth * ratio * more, bar.death / ratio, bar.death * ratio};
}

// Without the complex: closed, and each simplex in a ball of what the ratio allows.
std::string closed_complaint(const std::vector<Vertices>& chain, const Bar& bar, double ratio,
                             const std::vector<Place>& places) {
    std::map<Vertices, int> faces;
    std::set<Vertices> seen;
    for (const Vertices& simplex : chain) {
        std::vector<Place> corners;
        for (const std::uint32_t v : simplex) {
            if (v >= places.size()) return "has a vertex that is no point";
            corners.push_back(places[v]);
        }
        if (!seen.insert(simplex).second) return "has a simplex twice in its cycle";
        if (enclosing_radius(corners) > bar.birth * ratio * more) return "has a cycle that is born too late";
        for (std::size_t v = 0; v < simplex.size() && simplex.size() > 1; v++) {
            Vertices face = simplex;
            face.erase(face.begin() + static_cast<std::ptrdiff_t>(v));
            faces[face] ^= 1;
        }
    }
    for (const auto& [face, odd] : faces)
        if (odd != 0) return "has a chain with a boundary";
    return "";
}

std::string bar_complaint(const std::vector<Vertices>& chain, const Bar& bar, double ratio,
                          const FilteredComplex* complex, const std::vector<Place>& places) {
    const bool dies = std::isfinite(bar.death);
    if (bar.death == bar.birth) return chain.empty() ? "" : "has a cycle and no length";
    if (chain.empty() && !(dies && bar.death <= ratio * ratio * bar.birth * more)) return "has no cycle";
    if (bar.degree == 0 && !chain.empty() && chain.size() != (dies ? 2 : 1))
        return "has a chain of too many or too few vertices";
    return complex != nullptr ? complex->chain_complaint(chain, claim_of(bar, ratio))
                              : closed_complaint(chain, bar, ratio, places);
}

}  // namespace

std::string point_cycles_complaint(const std::vector<CycleEntry>& cycles, double ratio, const PointCloud& points,
                                   const FilteredComplex* complex, std::size_t* at) {
    const std::vector<Place> places = different_places(points);
    for (std::size_t i = 0; i < cycles.size(); i++) {
        *at = i;
        const std::string complaint = bar_complaint(cycles[i].simplices, cycles[i].bar, ratio, complex, places);
        if (!complaint.empty()) return complaint;
    }
    return "";
}

Outcome second_opinion_on_scales(const DiagramClaim& claim, const PointCloud& points, RunReport* run) {
    const DiagramFile& file = claim.file;
    const double ratio = run->engine->diagram.certified_ratio;
    const SimplexList simplices =
        complex_of_points(points, false, claim.made.request.max_degree + 1, joined_simplices_max);
    std::optional<FilteredComplex> complex;
    if (simplices) complex.emplace(*simplices, radius_tolerance);
    std::string text;
    if (complex) {
        const std::vector<Bar> truth = complex->bars(claim.made.request.max_degree, false);
        Outcome outcome = judge_ratio(file, truth, ratio);
        text = "second opinion: by the Cech complex of the points, of " +
               counted(complex->count(), "simplex", "simplices") + ", all bars are within the ratio of true ones";
        if (outcome.good()) outcome = judge_real(file, truth, &text);
        if (!outcome.good()) return outcome;
    } else {
        text = "no second opinion on the bars: the Cech complex of the points has more than " +
               counted(joined_simplices_max, "simplex", "simplices");
    }
    run->checked->push_back(text);
    if (claim.cycles_path.empty()) return {};
    std::vector<CycleEntry> cycles;
    const Outcome outcome = read_cycles(claim, &cycles);
    if (!outcome.good()) return outcome;
    std::size_t at = 0;
    const std::string complaint = point_cycles_complaint(cycles, ratio, points, complex ? &*complex : nullptr, &at);
    if (!complaint.empty()) return cycle_refused(claim, cycles, at, complaint);
    run->checked->push_back("second opinion: " + grouped_text(cycles.size()) + " cycles of points are closed, are " +
                            (complex ? "born with their bars and die with them, within the ratio"
                                     : "born with their bars within the ratio; nobody looked when they die"));
    return {};
}

}  // namespace netmesh::tool
