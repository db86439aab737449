#include <algorithm>
#include <cmath>

#include "diagram_trials.hpp"

namespace referee {
namespace {

struct Ground {
    PointSet set;
    Way way;
    Made made;
    std::string fingerprint;
};

// The name begins with the filter whose diagram is changed. False: there is nothing to change.
struct DiagramPlant {
    const char* filter;
    const char* name;
    bool (*plant)(Made* made, const Ground& ground, Random& random);
    bool malformed;       // `check` may call the file bad data instead
    bool absent = false;  // of what is not there no line can be named
};

DiagramFile& file_of(Made* made) { return made->diagram; }

bool set_line(Made* made, const char* name, const std::string& value) {
    if (!made->diagram.has(name) || made->diagram.text(name) == value) return false;
    made->diagram.set(name, value);
    return true;
}

void sort_bars(DiagramFile* file) {
    std::stable_sort(file->bars.begin(), file->bars.end(), [](const Bar& a, const Bar& b) {
        return a.degree != b.degree ? a.degree < b.degree : a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
    });
}

// One of the bars that end, and of these the longest with `longest`.
Bar* finite_bar(Made* made, Random& random, bool longest) {
    std::vector<Bar*> bars;
    for (Bar& bar : made->diagram.bars)
        if (std::isfinite(bar.death)) bars.push_back(&bar);
    if (bars.empty()) return nullptr;
    if (!longest) return bars[random.below(bars.size())];
    return *std::max_element(bars.begin(), bars.end(),
                             [](const Bar* a, const Bar* b) { return a->death - a->birth < b->death - b->birth; });
}

bool move_death(Made* made, Random& random, double factor) {
    Bar* const bar = finite_bar(made, random, false);
    if (bar == nullptr) return false;
    bar->death *= factor;
    bar->death_low = std::min(bar->death_low, bar->death);
    bar->death_high = std::max(bar->death_high, bar->death);
    sort_bars(&made->diagram);
    return true;
}

bool remove_longest(Made* made, Random& random) {
    Bar* const bar = finite_bar(made, random, true);
    if (bar == nullptr) return false;
    file_of(made).bars.erase(file_of(made).bars.begin() + (bar - file_of(made).bars.data()));
    return true;
}

bool each_step(Made* made, void (*change)(Step*)) {
    for (Step& step : made->diagram.steps) change(&step);
    return !made->diagram.steps.empty();
}

bool each_bar(Made* made, void (*change)(Bar*)) {
    for (Bar& bar : made->diagram.bars)
        if (std::isfinite(bar.death)) change(&bar);
    return true;
}

const std::vector<DiagramPlant>& diagram_plants() {
    static const std::vector<DiagramPlant> all = {
        {"complete", "a certified ratio below the true one",
         [](Made* made, const Ground& ground, Random&) {
             const double ratio = true_ratio(made->diagram, ground.set.truth(ground.way), ground.way.top, 1e6);
             if (ratio < 1.001) return false;
             for (Step& step : made->diagram.steps) step.ratio = std::min(step.ratio, std::sqrt(ratio));
             return set_line(made, "certified-ratio", exact_text(std::sqrt(ratio)));
         },
         false},
        {"cech", "a death one unit in the last place off",
         [](Made* made, const Ground&, Random& random) {
             Bar* const bar = finite_bar(made, random, true);
             if (bar == nullptr) return false;
             bar->death = std::nextafter(bar->death, INFINITY);
             return true;
         },
         false},
        {"complete", "a bar is missing",
         [](Made* made, const Ground&, Random& random) { return remove_longest(made, random); }, false},
        {"complete", "a bar twice",
         [](Made* made, const Ground&, Random& random) {
             const Bar* const bar = finite_bar(made, random, true);
             if (bar == nullptr) return false;
             const Bar copy = *bar;
             made->diagram.bars.push_back(copy);
             sort_bars(&made->diagram);
             return true;
         },
         false},
        {"complete", "a death beyond the ratio",
         [](Made* made, const Ground&, Random& random) {
             return move_death(made, random, 1.1 * std::pow(made->diagram.ratio(), 2));
         },
         false},
        {"complete", "a death before the ratio",
         [](Made* made, const Ground&, Random& random) {
             return move_death(made, random, 0.9 / std::pow(made->diagram.ratio(), 2));
         },
         true},
        {"complete", "a birth after 0",
         [](Made* made, const Ground&, Random& random) {
             Bar* const bar = finite_bar(made, random, false);
             if (bar == nullptr || bar->birth > 0) return false;
             bar->birth = bar->birth_high = 0.5 * bar->death;
             sort_bars(&made->diagram);
             return true;
         },
         false},
        {"complete", "an essential class that dies",
         [](Made* made, const Ground& ground, Random&) {
             for (Bar& bar : made->diagram.bars)
                 if (std::isinf(bar.death)) bar.death = bar.death_low = bar.death_high = 2 * ground.set.width();
             sort_bars(&made->diagram);
             return true;
         },
         true},
        {"complete", "a bar of another degree",
         [](Made* made, const Ground&, Random& random) {
             Bar* const bar = finite_bar(made, random, true);
             if (bar == nullptr) return false;
             bar->degree = 1 - bar->degree;
             sort_bars(&made->diagram);
             return true;
         },
         true},
        {"complete", "bars out of order",
         [](Made* made, const Ground&, Random&) {
             auto& bars = made->diagram.bars;
             for (std::size_t i = 1; i < bars.size(); i++)
                 if (bars[i - 1].death != bars[i].death) {
                     std::swap(bars[i - 1], bars[i]);
                     return true;
                 }
             return false;
         },
         true},
        {"complete", "a bar of length zero",
         [](Made* made, const Ground&, Random& random) {
             Bar* const bar = finite_bar(made, random, false);
             if (bar == nullptr) return false;
             bar->death = bar->birth;
             bar->death_low = std::min(bar->death_low, bar->death);
             sort_bars(&made->diagram);
             return true;
         },
         true},
        {"complete", "scales that say too narrow bounds",
         [](Made* made, const Ground&, Random&) {
             return each_step(made, [](Step* step) { step->low = step->high = step->from; });
         },
         false},
        {"complete", "scales with too low ratios",
         [](Made* made, const Ground&, Random&) { return each_step(made, [](Step* step) { step->ratio = 1; }); },
         false},
        {"complete", "scales with bounds of 0.1.0",
         [](Made* made, const Ground&, Random&) {
             return each_step(made, [](Step* step) { step->ratio = std::sqrt(std::sqrt(step->ratio)); });
         },
         false},
        {"tight", "scales after which all is said to exist",
         [](Made* made, const Ground&, Random&) { return each_step(made, [](Step* step) { step->reach = 0; }); },
         false},
        {"complete", "bounds of deaths that end too early",
         [](Made* made, const Ground&, Random&) {
             return each_bar(made, [](Bar* bar) { bar->death_high = bar->death; });
         },
         false},
        {"complete", "bounds of deaths that begin too late",
         [](Made* made, const Ground&, Random&) {
             return each_bar(made, [](Bar* bar) { bar->death_low = bar->death; });
         },
         false},
        {"knn", "bounds of births that end too early",
         [](Made* made, const Ground&, Random&) {
             for (Bar& bar : made->diagram.bars) bar.birth_low = bar.birth_high = bar.birth;
             return true;
         },
         false},
        {"tight", "bars said to exist that are not",
         [](Made* made, const Ground&, Random&) {
             for (Bar& bar : made->diagram.bars) bar.real = true;
             return true;
         },
         false},
        {"basic", "a ratio that holds from 0",
         [](Made* made, const Ground&, Random&) { return set_line(made, "certified-from", "1e-300"); }, false},
        {"complete", "another number of points",
         [](Made* made, const Ground& g, Random&) {
             return set_line(made, "points", count_text(g.set.all().size() + 1));
         },
         false},
        {"complete", "another number of duplicates",
         [](Made* made, const Ground&, Random&) { return set_line(made, "duplicates", "1"); }, false},
        {"complete", "another dimension",
         [](Made* made, const Ground& g, Random&) { return set_line(made, "dim", count_text(g.set.dim() + 1)); }, true},
        {"complete", "another fingerprint",
         [](Made* made, const Ground&, Random&) { return set_line(made, "input", "0123456789abcdef"); }, false},
        {"complete", "another reference",
         [](Made* made, const Ground&, Random&) { return set_line(made, "reference", "open offsets of the points"); },
         false},
        {"complete", "a domain that leaves points out",
         [](Made* made, const Ground& g, Random&) {
             std::string ball;
             for (int k = 0; k < g.set.dim(); k++) ball += exact_text(made->mesh.centre[k]) + " ";
             return set_line(made, "domain", ball + exact_text(0.5 * made->mesh.radius));
         },
         false},
        {"complete", "another filter",
         [](Made* made, const Ground&, Random&) { return set_line(made, "filter", "basic"); }, true},
        {"knn", "another k", [](Made* made, const Ground&, Random&) { return set_line(made, "k", "1"); }, false},
        {"complete", "another highest degree",
         [](Made* made, const Ground&, Random&) {
             return made->diagram.bars.back().degree > 0 && set_line(made, "max-degree", "0");
         },
         true},
        {"alpha", "two different radii are one",
         [](Made* made, const Ground&, Random&) {
             auto& bars = made->diagram.bars;
             for (std::size_t i = 1; i < bars.size(); i++)
                 if (std::isfinite(bars[i].death) && bars[i].degree == 0 && bars[i].death != bars[i - 1].death) {
                     bars[i].death = bars[i - 1].death;
                     return true;
                 }
             return false;
         },
         false},
        {"alpha", "a radius off by 1e-13 of it",
         [](Made* made, const Ground&, Random& random) { return move_death(made, random, 1 + 1e-13); }, false},
        {"alpha", "a short bar is missing",
         [](Made* made, const Ground&, Random&) {
             auto& bars = made->diagram.bars;
             for (std::size_t i = 0; i < bars.size(); i++)
                 if (bars[i].degree > 0) {
                     bars.erase(bars.begin() + static_cast<std::ptrdiff_t>(i));
                     return true;
                 }
             return false;
         },
         false},
        {"cech", "a radius 1e-9 off",
         [](Made* made, const Ground&, Random& random) { return move_death(made, random, 1 + 1e-9); }, false},
        {"rips", "a radius that is a diameter",
         [](Made* made, const Ground&, Random& random) { return move_death(made, random, 2); }, false},
        {"kdistance", "a certified ratio below the true one, of the k-distance",
         [](Made* made, const Ground& ground, Random&) {
             const double ratio = true_ratio(made->diagram, ground.set.truth(ground.way), ground.way.top, 1e6);
             if (ratio < 1.001) return false;
             return set_line(made, "certified-ratio", exact_text(std::sqrt(ratio)));
         },
         false},
        {"scales", "a certified ratio of 1, of scales",
         [](Made* made, const Ground&, Random&) { return set_line(made, "certified-ratio", "1"); }, false},
        {"scales", "ratios by scale of 1, of scales",
         [](Made* made, const Ground&, Random&) { return each_step(made, [](Step* step) { step->ratio = 1; }); },
         false},
        {"scales", "bars of scales that are all said to exist",
         [](Made* made, const Ground&, Random&) {
             return each_bar(made, [](Bar* bar) {
                 bar->real = true;
                 bar->birth_low = bar->birth_high = bar->birth;
                 bar->death_low = bar->death_high = bar->death;
             });
         },
         false},
        {"scales cycles", "a cycle of points without one of its simplices",
         [](Made* made, const Ground&, Random&) {
             for (Cycle& cycle : made->cycles)
                 if (!cycle.simplices.empty()) {
                     cycle.simplices.pop_back();
                     return true;
                 }
             return false;
         },
         false},
        {"scales cycles", "a cycle of one point too far away",
         [](Made* made, const Ground& ground, Random& random) {
             const auto count = static_cast<std::uint32_t>(ground.set.different().size());
             for (Cycle& cycle : made->cycles)
                 if (cycle.degree == 0 && std::isfinite(cycle.death) && !cycle.simplices.empty()) {
                     cycle.simplices[0][0] = static_cast<std::uint32_t>(random.below(count));
                     return true;
                 }
             return false;
         },
         false},
        {"scales cycles", "a cycle of points is missing",
         [](Made* made, const Ground&, Random&) {
             made->cycles.pop_back();
             return true;
         },
         false, true},
        {"cycles", "a cycle without one of its simplices",
         [](Made* made, const Ground&, Random&) {
             for (Cycle& cycle : made->cycles)
                 if (cycle.degree > 0) {
                     cycle.simplices.pop_back();
                     return true;
                 }
             return false;
         },
         false},
        {"cycles", "the cycle of another bar",
         [](Made* made, const Ground&, Random&) {
             for (std::size_t i = 1; i < made->cycles.size(); i++)
                 if (made->cycles[i].degree == made->cycles[i - 1].degree &&
                     made->cycles[i].death != made->cycles[i - 1].death) {
                     std::swap(made->cycles[i].simplices, made->cycles[i - 1].simplices);
                     return true;
                 }
             return false;
         },
         false},
        {"cycles", "a cycle with another radius",
         [](Made* made, const Ground&, Random&) {
             for (Cycle& cycle : made->cycles)
                 if (std::isfinite(cycle.death)) {
                     cycle.death *= 2;
                     return true;
                 }
             return false;
         },
         false},
        {"cycles", "a cycle is missing",
         [](Made* made, const Ground&, Random&) {
             made->cycles.pop_back();
             return true;
         },
         false, true},
    };
    return all;
}

bool names_a_line(const std::string& message) {
    for (std::size_t i = message.find(':'); i != std::string::npos; i = message.find(':', i + 1)) {
        std::size_t end = i + 1;
        while (end < message.size() && std::isdigit(static_cast<unsigned char>(message[end])) != 0) end++;
        if (end > i + 1 && end < message.size() && message[end] == ':') return true;
    }
    return false;
}

// Few enough for truths of two neighbours.
Points ground_points(int dim, bool neighbours, Random& random) {
    Points points;
    const std::size_t count = neighbours ? 5 : dim == 2 ? 10 : dim == 3 ? 7 : 6;
    for (std::size_t i = 0; i < count; i++) {
        Point x = random.direction(dim);
        const double length = random.between(0.7, 1);
        for (int k = 0; k < dim; k++) x[k] *= length;
        points.push_back(x);
    }
    return points;
}

// The first way of that filter on those points, judged good.
bool make_ground(const Tool& tool, const DiagramSettings& settings, const std::string& filter, bool small,
                 Random& random, Ground* ground) {
    for (const Way& way : ways_to_persist(ground->set.dim(), ground->set.k(), ground->set.width(), random)) {
        if (way.arguments[1] != filter) continue;
        ground->way = way;
        const Outcome outcome = tool.run(words_of(way, tool, tool.path("trial.txt"), small), settings.seconds);
        return outcome.exit == done && read_made(way, tool, outcome.message, small, &ground->made).empty() &&
               judge_made(ground->set, way, ground->made, ground->fingerprint, settings.simplices).good();
    }
    return false;
}

void try_plant(const Tool& tool, const DiagramSettings& settings, const DiagramPlant& plant, int dim,
               std::uint64_t seed, const std::string& replay, DiagramAccount* account) {
    const bool by_scales = std::string(plant.filter) == "scales cycles";
    const bool of_cycles = by_scales || std::string(plant.filter) == "cycles";
    const std::string filter = by_scales ? "scales" : of_cycles ? "complete" : plant.filter;
    const bool neighbours = filter == "knn" || filter == "kdistance";
    Random random(seed);
    for (int trial = 0; trial < 60; trial++) {  // some points have no bar that will do
        Ground ground = {PointSet(ground_points(dim, neighbours, random), dim, 2, settings.sets_max), {}, {}, {}};
        write_points(tool.path("trial.txt"), ground.set.all(), dim);
        if (!make_ground(tool, settings, filter, of_cycles, random, &ground)) continue;
        ground.fingerprint = ground.made.diagram.text("input");
        Made made = ground.made;
        made.json.clear();
        if (!plant.plant(&made, ground, random)) continue;
        const Verdict verdict = judge_made(ground.set, ground.way, made, ground.fingerprint, settings.simplices);
        if (verdict.good()) continue;  // by chance it is still true
        account->planted[plant.name]++;
        write_diagram(tool.path("trial.pers"), made.diagram);
        write_cycles(tool.path("trial.cycles"), made.cycles);
        std::vector<std::string> words = {"check", tool.path("trial.pers"), "--quiet"};
        if (of_cycles) words.insert(words.end(), {"--representatives", tool.path("trial.cycles")});
        if (of_cycles && !by_scales) {
            words.insert(words.end(), {"--mesh", tool.path("trial.node")});
        } else {
            words.insert(words.end(), {"--points", tool.path("trial.txt")});
        }
        const Outcome outcome = tool.run(words, 120);
        const bool refused = outcome.exit == check_exit || (plant.malformed && outcome.exit == data_exit);
        if (refused && (plant.absent || names_a_line(outcome.message))) {
            account->seen[plant.name]++;
            return;
        }
        fail(tool, settings,
             "plant: " + std::string(plant.name) + "; in a diagram of " + ground.way.name + ", D = " + count_text(dim) +
                 "  (--plants " + replay + ")",
             "`check` exits with " + count_text(outcome.exit) + ": " + outcome.message +
                 "; the referee: " + faults_text(verdict),
             account);
        return;
    }
}

}  // namespace

void try_diagram_plants(const Tool& tool, const DiagramSettings& settings, int dim, std::uint64_t seed,
                        DiagramAccount* account) {
    std::uint64_t number = 0;
    for (const DiagramPlant& plant : diagram_plants()) {
        account->planted[plant.name] += 0;
        number++;
        if (dim > 3 && (std::string(plant.filter) == "tight" || std::string(plant.filter).find("scales") == 0))
            continue;
        try_plant(tool, settings, plant, dim, seed + 1000 * number, count_text(dim) + ":" + count_text(seed), account);
    }
}

}  // namespace referee
