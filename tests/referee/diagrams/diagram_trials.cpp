#include "diagram_trials.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "../refusals.hpp"

namespace referee {
namespace {

bool may_refuse(const Outcome& outcome, const PointSet& set, const Way& way) {
    const Points& points = set.different();
    const double units = way.over_refines ? 0x1p24 : 1024;
    if (outcome.exit == 2)
        return outcome.message.find("focus_from is below what coordinates resolve") != std::string::npos;
    if (outcome.exit == degenerate_exit)
        return way.promise == Promise::exact ? is_flat(points, set.dim()) : has_close_points(points, set.dim(), units);
    if (outcome.exit == data_exit)
        return is_out_of_range(points, set.dim()) || (way.over_refines && has_close_points(points, set.dim(), units));
    return false;
}

// The line `# input` of a run of another filter on the same points.
std::string fingerprint_of(const Tool& tool) {
    DiagramFile diagram;
    if (tool.run({"persist", tool.path("trial.txt"), "--filter", "rips", "--max-degree", "0", "--quiet", "-o",
                  tool.path("input.pers")},
                 60)
                .exit != done ||
        !read_diagram(tool.path("input.pers"), &diagram).empty())
        return {};
    return diagram.text("input");
}

// `check` alone, and with the mesh and the cycles.
std::string check_files(const Tool& tool, const Way& way, const Made& made, unsigned seconds) {
    const std::string points = tool.path("trial.txt");
    Outcome outcome = tool.run({"check", tool.path("trial.pers"), "--points", points, "--quiet"}, seconds);
    if (outcome.exit != done && outcome.exit != out_of_time)
        return "`check --points` exits with " + count_text(outcome.exit) + ": " + outcome.message;
    std::vector<std::string> words = {"check", tool.path("trial.pers"), "--quiet"};
    if (way.has_mesh) words.insert(words.end(), {"--mesh", tool.path("trial.node")});
    if (!way.has_mesh) words.insert(words.end(), {"--points", points});
    if (made.has_cycles) words.insert(words.end(), {"--representatives", tool.path("trial.cycles")});
    outcome = tool.run(words, seconds);
    const bool declined = outcome.message.find("simplices, which are too many") != std::string::npos ||
                          outcome.message.find("flat to the precision") != std::string::npos ||
                          outcome.message.find("faces of Voronoi cells meet the domain") != std::string::npos;
    if (outcome.exit == done || outcome.exit == out_of_time || outcome.exit == memory_exit || declined) return {};
    return "the second opinion of `check` exits with " + count_text(outcome.exit) + ": " + outcome.message;
}

void try_way(const Tool& tool, const DiagramSettings& settings, const PointSet& set, const Way& way,
             const std::string& title, const std::string& fingerprint, DiagramFile* left, DiagramAccount* account) {
    account->runs++;
    const bool small = set.dim() < 4 || set.different().size() < 6;
    std::vector<std::string> words = words_of(way, tool, tool.path("trial.txt"), small);
    if (std::find(words.begin(), words.end(), "--memory") == words.end())
        words.insert(words.end(), {"--memory", settings.memory});
    const std::string whole = title + ", " + way.name;
    const Outcome outcome = tool.run(words, settings.seconds);
    if (outcome.exit == out_of_time || outcome.exit == memory_exit) {
        account->too_large++;
        return;
    }
    if (outcome.exit != done) {
        account->refused++;
        if (!may_refuse(outcome, set, way))
            fail(tool, settings, whole, "exit " + count_text(outcome.exit) + ": " + outcome.message, account);
        return;
    }
    Made made;
    const std::string unreadable = read_made(way, tool, outcome.message, small, &made);
    if (!unreadable.empty()) return fail(tool, settings, whole, unreadable, account);
    // Without a file the report has all.
    if (account->runs % 4 == 0) {
        words.erase(std::find(words.begin(), words.end(), "-o"), std::find(words.begin(), words.end(), "-o") + 2);
        const Outcome again = tool.run(words, settings.seconds);
        if (again.exit == done) made.json = again.message;
        if (again.exit == done && json_text(again.message, "diagram", "bars").empty())
            return fail(tool, settings, whole, "the report has no bars", account);
    }
    const Verdict verdict = judge_made(set, way, made, fingerprint, settings.simplices);
    account->judged++;
    account->by_scale += made.diagram.steps.empty() ? 0 : 1;
    account->cycles += static_cast<int>(made.cycles.size());
    std::string what = faults_text(verdict);
    const std::string refusal = check_files(tool, way, made, 60);
    if (!refusal.empty()) what += refusal;
    if (!what.empty()) fail(tool, settings, whole, what, account);
    if (refusal.empty()) account->checked++;
    if (what.empty()) account->ways[way.arguments[1]]++;
    const double ratio = made.diagram.ratio();
    if (way.promise == Promise::by_ratio && std::isfinite(ratio) && ratio > 1 + 1e-6 && verdict.good()) {
        const double share = std::log(true_ratio(made.diagram, set.truth(way), way.top, ratio)) / std::log(ratio);
        if (share > account->tightest) {
            account->tightest = share;
            account->tightest_title = whole;
        }
    }
    *left = made.diagram;
}

}  // namespace

void fail(const Tool& tool, const DiagramSettings& settings, const std::string& title, const std::string& what,
          DiagramAccount* account) {
    account->failures++;
    std::printf("FAILED %s\n       %s\n", title.c_str(), what.c_str());
    std::fflush(stdout);
    if (settings.keep.empty()) return;
    std::filesystem::create_directories(settings.keep);
    const std::string number = settings.keep + "/" + count_text(account->failures);
    for (const char* const ending : {".txt", ".pers", ".node", ".ele", ".neigh", ".cycles", ".vines"}) {
        std::error_code ignored;
        std::filesystem::copy(tool.path(std::string("trial") + ending), number + ending,
                              std::filesystem::copy_options::overwrite_existing, ignored);
    }
}

void try_set(const Tool& tool, const DiagramSettings& settings, const PointSet& set, const std::string& title,
             std::uint64_t seed, DiagramAccount* account) {
    account->sets++;
    Random random(seed);
    write_points(tool.path("trial.txt"), set.all(), set.dim());
    const std::string fingerprint = fingerprint_of(tool);
    DiagramFile last, before;
    for (const Way& way : ways_to_persist(set.dim(), set.k(), std::max(set.width(), 0x1p-400), random)) {
        if (random.unit() > settings.ways) continue;
        const std::size_t most = set.dim() == 2 ? SIZE_MAX : set.dim() == 3 ? settings.over_refined : 2;
        if (way.over_refines && set.different().size() > most) continue;
        DiagramFile made;
        try_way(tool, settings, set, way, title, fingerprint, &made, account);
        if (made.bars.empty()) continue;
        before = last;
        last = made;
    }
    if (!before.bars.empty()) try_distance(tool, settings, before, last, title, account);
    if (random.unit() < 0.3) try_fits(tool, settings, set, title, random, account);
    if (random.unit() < 0.3) try_vineyard(tool, settings, set, title, random, account);
}

void try_diagram_family(const Tool& tool, const DiagramSettings& settings, int dim, std::size_t family,
                        std::uint64_t seed, DiagramAccount* account) {
    Random random(seed);
    const Family& made = families()[family];
    const std::size_t most = settings.most[dim];
    Points points = made.make(dim, most / 2 + random.below(most - most / 2) + 1, random);
    if (points.size() > most) points.resize(most);
    const std::size_t k = 1 + random.below(4);
    const bool neighbours = random.below(2) == 0;  // else as few of them as so many points allow
    while (neighbours && points.size() > k && !is_feasible(points.size(), k, dim, settings.sets_max)) points.pop_back();
    const PointSet set(points, dim, k, settings.sets_max);
    const std::string title = "D = " + count_text(dim) + ", " + made.name + ", " + count_text(points.size()) +
                              " points  (--trial " + count_text(dim) + ":" + count_text(family) + ":" +
                              count_text(seed) + ")";
    try_set(tool, settings, set, title, random.next(), account);
}

void try_named_diagrams(const Tool& tool, const DiagramSettings& settings, DiagramAccount* account) {
    Points gon;
    for (int i = 0; i < 9; i++) gon.push_back({std::cos(i * 0.6981317007977318), std::sin(i * 0.6981317007977318)});
    const std::vector<std::pair<const char*, Points>> all = {
        {"the unit square", {{0, 0}, {1, 0}, {0, 1}, {1, 1}}},
        {"the regular 9-gon", gon},
        {"a triangle that is nearly right", {{0, 0}, {1, 0}, {0.5, 0.500001}}},
    };
    DiagramSettings every = settings;
    every.ways = 1;
    for (const auto& [name, points] : all)
        for (const std::size_t k : {2, 1, 3}) {
            if (k != 2 && !settings.named_with_all_k) continue;
            try_set(tool, every, PointSet(points, 2, k, settings.sets_max), name, k, account);
        }
}

}  // namespace referee
