#include "cases.hpp"

#include <algorithm>
#include <cmath>

#include "../judge.hpp"

namespace referee {
namespace {

std::string reference_of(const Way& way, int dim) {
    const std::string space = " in R^" + count_text(dim), k = count_text(way.k);
    if (way.reference == Reference::rips) return "Vietoris-Rips complex of the points, edges at half their length";
    // The distance to the nearest point has two names.
    if (way.reference == Reference::offsets) return "closed offsets of the points" + space;
    if (way.reference == Reference::kth) return "sublevel sets of d_" + k + space;
    return "sublevel sets of the k-distance, k = " + k + "," + space;
}

void judge_head(const PointSet& set, const Way& way, const DiagramFile& diagram, const std::string& fingerprint,
                Verdict* verdict) {
    auto due = way.says;
    const std::size_t count = set.all().size();
    due.emplace_back("dim", count_text(set.dim()));
    due.emplace_back("points", count_text(count));
    due.emplace_back("duplicates", count_text(count - set.different().size()));
    due.emplace_back("max-degree", count_text(way.top));
    if (!fingerprint.empty()) due.emplace_back("input", fingerprint);
    for (const auto& [name, value] : due)
        if (!diagram.has(name) || diagram.text(name) != value)
            verdict->add("head", "`" + name + " " + diagram.text(name) + "`, due is `" + value + "`");
    const std::string reference = diagram.text("reference");
    if (reference != reference_of(way, set.dim()) &&
        !(way.k == 1 && way.reference != Reference::rips &&
          reference == "closed offsets of the points in R^" + count_text(set.dim())))
        verdict->add("head", "the reference is " + reference);
    if (way.ratio_most > 0 && diagram.ratio() > way.ratio_most * (1 + 1e-11))
        verdict->add("bound", "the certified ratio is " + exact_text(diagram.ratio()) + ", documented as at most " +
                                  exact_text(way.ratio_most));
}

// The domain holds all points, and the mesh's file names the same one.
void judge_ball(const PointSet& set, const Made& made, Verdict* verdict) {
    std::string ball;
    for (int k = 0; k < set.dim(); k++) ball += exact_text(made.mesh.centre[k]) + " ";
    ball += exact_text(made.mesh.radius);
    if (made.diagram.text("domain") != ball) verdict->add("domain", "the mesh has another: " + ball);
    for (const Point& p : set.different())
        if (compare_distance(p, made.mesh.centre, set.dim(), made.mesh.radius) > 0)
            verdict->add("domain", "an input lies outside of the domain");
}

}  // namespace

PointSet::PointSet(const Points& points, int dim, std::size_t k, std::size_t sets_max)
    : dim_(dim), k_(k), all_(points), different_(distinct(points, dim)) {
    while (k_ > 1 && !is_feasible(different_.size(), k_, dim, sets_max)) k_--;
    for (const Point& p : points)
        for (const Point& q : points) width_ = std::max(width_, distance(p, q, dim));
}

const Truth& PointSet::truth(const Way& way) const {
    const bool is_offsets = way.k == 1 && way.reference != Reference::rips;
    const std::pair<Reference, int> key = {is_offsets ? Reference::offsets : way.reference,
                                           way.reference == Reference::rips ? way.top : 0};
    const auto found = truths_.find(key);
    if (found != truths_.end()) return found->second;
    Truth& truth = truths_[key];
    switch (key.first) {
    case Reference::offsets: truth = true_offsets(different_, dim_); break;
    case Reference::kth: truth = true_kth(different_, dim_, k_); break;
    case Reference::k_distance: truth = true_k_distance(different_, dim_, k_); break;
    case Reference::rips: truth = true_rips(different_, dim_, way.top); break;
    }
    return truth;
}

std::vector<std::string> words_of(const Way& way, const Tool& tool, const std::string& points, bool small) {
    std::vector<std::string> words = {"persist", points, "--quiet", "--json", "-o", tool.path("trial.pers")};
    words.insert(words.end(), way.arguments.begin(), way.arguments.end());
    if (way.has_mesh) words.insert(words.end(), {"--mesh", tool.path("trial.node")});
    if (way.has_cycles && small) words.insert(words.end(), {"--representatives", tool.path("trial.cycles")});
    return words;
}

std::string read_made(const Way& way, const Tool& tool, const std::string& json, bool small, Made* made) {
    made->json = json;
    std::string fault = read_diagram(tool.path("trial.pers"), &made->diagram);
    if (fault.empty() && way.has_mesh) fault = read_mesh(tool.path("trial"), &made->mesh);
    made->has_cycles = way.has_cycles && small;
    if (fault.empty() && made->has_cycles) fault = read_cycles(tool.path("trial.cycles"), &made->cycles);
    return fault;
}

Verdict judge_made(const PointSet& set, const Way& way, const Made& made, const std::string& fingerprint,
                   std::size_t simplices) {
    Verdict verdict;
    const DiagramFile& diagram = made.diagram;
    judge_head(set, way, diagram, fingerprint, &verdict);
    judge_form(diagram, made.json, way.top, &verdict);
    const Truth& truth = set.truth(way);
    if (way.promise == Promise::exact) {
        judge_exact(diagram, truth, way.top, &verdict);
    } else if (way.promise == Promise::near) {
        judge_near(diagram, truth, way.top, &verdict);
    } else {
        judge_ratio(diagram, truth, way.top, &verdict);
    }
    if (diagram.has("bounds")) {
        if (way.promise == Promise::by_ratio) judge_scales(diagram, truth, way.top, &verdict);
        judge_bounds(diagram, truth, way.top, &verdict);
    }
    ValuedComplex within;
    bool is_known = false;
    if (made.mesh.has_domain) {
        judge_ball(set, made, &verdict);
        is_known = !made.mesh.values.empty() && lower_star(made.mesh, way.inputs_first, way.top, simplices, &within);
        if (is_known) judge_pairs(diagram, within, &verdict);
    } else if (way.reference == Reference::rips) {
        within = rips_complex(set.different(), set.dim(), way.top);
        is_known = true;
    }
    if (made.has_cycles && !way.has_mesh && way.reference == Reference::offsets)
        judge_point_cycles(diagram, made.cycles, cech_complex(set.different(), set.dim(), way.top), &verdict);
    if (made.has_cycles && is_known) judge_cycles(diagram, made.cycles, within, way.has_mesh ? 0 : 0x1p-38, &verdict);
    return verdict;
}

}  // namespace referee
