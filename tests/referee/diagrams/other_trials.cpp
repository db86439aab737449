#include <algorithm>
#include <cmath>

#include "bottleneck.hpp"
#include "diagram_trials.hpp"

namespace referee {
namespace {

Way mesh_way(const std::string& filter, std::size_t k, int top) {
    Way way;
    way.name = filter;
    way.reference = filter == "knn"         ? Reference::kth
                    : filter == "kdistance" ? Reference::k_distance
                                            : Reference::offsets;
    way.k = k;
    way.top = top;
    return way;
}

// ln x of a ratio between 1 and the largest double was rounded twice: the ratio to a double, its logarithm within 4
// units in the last place.
bool is_logarithm(double x, const Rational& ratio2) {
    const long double due = std::log(static_cast<long double>(ratio2.get_d())) / 2;
    return std::fabs(static_cast<double>(x - due)) <= 0x1p-51 + 0x1p-49 * x;
}

}  // namespace

void try_fits(const Tool& tool, const DiagramSettings& settings, const PointSet& set, const std::string& title,
              Random& random, DiagramAccount* account) {
    const bool has_scales = random.below(2) == 0;
    const char* const filters[] = {"complete", "basic", "knn", "kdistance"};
    const std::string filter = filters[random.below(4)];
    const Way way = mesh_way(filter, filter == "knn" || filter == "kdistance" ? set.k() : 1, set.dim() - 1);
    std::vector<std::string> words = {"persist", tool.path("trial.txt"),  "--quiet",  "--json", "--bounds", "--fit",
                                      "-o",      tool.path("trial.pers"), "--filter", filter};
    if (filter == "knn" || filter == "kdistance") words.insert(words.end(), {"--k", count_text(way.k)});
    if (random.below(3) == 0) words.insert(words.end(), {"--values", "thesis"});
    if (has_scales)
        words.insert(words.end(), {"--from", exact_text(0.1 * set.width()), "--to", exact_text(0.5 * set.width())});
    double best = INFINITY, bytes = 6000;
    for (int trial = 0; trial < 8; trial++, bytes *= random.between(1.05, 1.9)) {
        const std::string memory = count_text(static_cast<std::uint64_t>(bytes));
        std::vector<std::string> all = words;
        all.insert(all.end(), {"--memory", memory});
        const Outcome outcome = tool.run(all, settings.seconds);
        if (outcome.exit == memory_exit && std::isinf(best)) continue;
        std::string whole = title + ", fit of " + filter;
        for (std::size_t i = 10; i < all.size(); i++) whole += " " + all[i];
        // With less memory it came to an end.
        if (outcome.exit == memory_exit)
            return fail(tool, settings, whole, "a larger block is too small: " + outcome.message, account);
        if (outcome.exit != done) return;
        DiagramFile diagram;
        const std::string unreadable = read_diagram(tool.path("trial.pers"), &diagram);
        if (!unreadable.empty()) return fail(tool, settings, whole, unreadable, account);
        Verdict verdict;
        const Truth& truth = set.truth(way);
        judge_form(diagram, outcome.message, way.top, &verdict);
        judge_ratio(diagram, truth, way.top, &verdict);
        judge_scales(diagram, truth, way.top, &verdict);
        judge_bounds(diagram, truth, way.top, &verdict);
        const std::vector<double> focus = json_numbers(json_text(outcome.message, "diagram", "certified_focus"));
        if (has_scales && focus.size() != 1)
            return fail(tool, settings, whole, "the report has no certified_focus", account);
        const double ratio = has_scales ? focus[0] : diagram.ratio();
        if (ratio > best)
            verdict.add("fit", "a larger block certifies " + exact_text(ratio) + ", a smaller one " + exact_text(best));
        best = ratio;
        account->fits++;
        if (!verdict.good()) return fail(tool, settings, whole, faults_text(verdict), account);
        const Outcome checked =
            tool.run({"check", tool.path("trial.pers"), "--points", tool.path("trial.txt"), "--quiet"}, 60);
        if (trial % 4 == 0 && checked.exit != done && checked.exit != out_of_time)
            return fail(tool, settings, whole,
                        "`check` exits with " + count_text(checked.exit) + ": " + checked.message, account);
    }
}

void try_vineyard(const Tool& tool, const DiagramSettings& settings, const PointSet& set, const std::string& title,
                  Random& random, DiagramAccount* account) {
    // Of nested sets each diagram is compared with that of persist, which is judged by itself.
    const char* const filters[] = {"knn", "kdistance", "barycentric-cech", "barycentric-rips"};
    const bool is_small = set.all().size() <= 9;
    const std::string filter = filters[random.below(is_small ? 4 : 2)], range = "1.." + count_text(set.k());
    const bool is_nested = filter.rfind("barycentric", 0) == 0;
    const std::string whole = title + ", vineyard of " + filter + ", k = " + range;
    const Outcome outcome = tool.run({"vineyard", tool.path("trial.txt"), "--quiet", "--filter", filter, "--k", range,
                                      "-o", tool.path("trial.vines"), "--memory", settings.memory},
                                     settings.seconds);
    if (outcome.exit != done) return;
    VineFile vines;
    const std::string unreadable = read_vines(tool.path("trial.vines"), &vines);
    if (!unreadable.empty()) return fail(tool, settings, whole, unreadable, account);
    account->vineyards++;
    Verdict verdict;
    if (vines.ratios.size() != set.k()) verdict.add("vines", "a ratio for each k is due");
    for (const auto& [k, ratio] : vines.ratios) {
        DiagramFile diagram, alone;
        diagram.head.emplace_back("certified-ratio", exact_text(ratio));
        for (const VinePoint& point : vines.points)
            if (point.k == k) diagram.bars.push_back(point.bar);
        const Way way = mesh_way(filter, k, set.dim() - 1);
        if (!is_nested && (k == 1 || k == set.k())) judge_ratio(diagram, set.truth(way), way.top, &verdict);
        if (tool.run({"persist", tool.path("trial.txt"), "--quiet", "--filter", filter, "--k", count_text(k), "-o",
                      tool.path("trial.pers"), "--memory", settings.memory},
                     settings.seconds)
                    .exit != done ||
            !read_diagram(tool.path("trial.pers"), &alone).empty())
            continue;
        const auto bars_of = [](const DiagramFile& file) {
            std::vector<std::array<double, 3>> bars;
            for (const Bar& bar : file.bars) bars.push_back({static_cast<double>(bar.degree), bar.birth, bar.death});
            std::sort(bars.begin(), bars.end());
            return bars;
        };
        if (bars_of(diagram) != bars_of(alone) || alone.ratio() != ratio)
            verdict.add("vines", "the diagram at k = " + count_text(k) + " is not that of persist");
    }
    const Outcome checked =
        tool.run({"check", tool.path("trial.vines"), "--points", tool.path("trial.txt"), "--quiet"}, 60);
    if (checked.exit != done && checked.exit != out_of_time)
        verdict.add("check", "exits with " + count_text(checked.exit) + ": " + checked.message);
    if (!verdict.good()) fail(tool, settings, whole, faults_text(verdict), account);
}

void try_distance(const Tool& tool, const DiagramSettings& settings, const DiagramFile& a, const DiagramFile& b,
                  const std::string& title, DiagramAccount* account) {
    if (a.bars.size() > 60 || b.bars.size() > 60) return;
    write_diagram(tool.path("a.pers"), a);
    write_diagram(tool.path("b.pers"), b);
    for (const bool log : {false, true}) {
        std::vector<std::string> words = {"distance", tool.path("a.pers"), tool.path("b.pers")};
        if (log) words.push_back("--log");
        const Outcome outcome = tool.run(words, settings.seconds);
        if (outcome.exit != done) {
            fail(tool, settings, title + ", distance", "exit " + count_text(outcome.exit) + ": " + outcome.message,
                 account);
            continue;
        }
        account->distances++;
        const std::vector<double> said = json_numbers(outcome.message);
        for (std::size_t i = 0; i + 1 < said.size(); i += 2) {
            const int degree = static_cast<int>(said[i]);
            const double value = said[i + 1];
            const ExactDistance due = bottleneck(a.bars, b.bars, degree, log);
            const bool right = due.infinite || std::isinf(value) ? due.infinite == std::isinf(value)
                               : log                             ? is_logarithm(value, due.value)
                                                                 : is_nearest(value, due.value);
            if (!right)
                fail(tool, settings, title + ", distance" + (log ? " --log" : ""),
                     "degree " + count_text(degree) + ": " + exact_text(value) + ", due is " +
                         (due.infinite ? std::string("inf") : exact_text(due.value.get_d())),
                     account);
        }
    }
}

}  // namespace referee
