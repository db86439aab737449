// The referee of diagrams: compares every number that a diagram's files promise with truths of its own, and plants
// violations that `check` must refuse. Shares no code with what it judges.
//
//   referee_diagrams NETMESH [--seed S] [--minutes M] [--sets N] [--keep FOLDER]   a slice; or new seeds for M minutes,
//                                                                                  and for N sets at least
//   referee_diagrams NETMESH --trial D:FAMILY:SEED | --plants D:SEED               one trial that failed
#include <cstdio>

#include "../command.hpp"
#include "diagram_trials.hpp"

using namespace referee;

namespace {

void run_slice(const Tool& tool, DiagramSettings settings, std::uint64_t seed, DiagramAccount* account) {
    Random seeds(seed);
    settings.ways = 0.2;
    settings.seconds = 4;
    settings.named_with_all_k = false;
    settings.over_refined = 2;
    settings.simplices = 6000;
    const std::vector<int> dims = dimensions_of(tool);
    try_named_diagrams(tool, settings, account);
    settings.most[3] = 6;
    settings.most[4] = 5;
    for (const int dim : dims)
        for (std::size_t family = 0; family < families().size(); family++) {
            const std::uint64_t own = seeds.next() >> 16;
            if (dim < 4 || own % 4 == 0) try_diagram_family(tool, settings, dim, family, own, account);
        }
    try_diagram_plants(tool, settings, 2 + seeds.below(2), seeds.next() >> 16, account);
}

void run_long(const Tool& tool, DiagramSettings settings, const Command& arguments, DiagramAccount* account) {
    Random seeds(arguments.seed);
    const double end = now() + 60 * arguments.minutes;
    const std::vector<int> dims = dimensions_of(tool);
    settings.memory = "256M";
    settings.seconds = 30;
    settings.sets_max = 8000;
    settings.simplices = 60000;
    settings.most[2] = 18;
    settings.most[3] = 11;
    settings.most[4] = 8;
    try_named_diagrams(tool, settings, account);
    for (std::size_t round = 0; now() < end || account->sets < arguments.sets; round++) {
        const int dim = dims[seeds.below(dims.size())];
        if (round % 40 == 0) {
            try_diagram_plants(tool, settings, dims[round / 40 % dims.size()], seeds.next() >> 16, account);
        } else {
            try_diagram_family(tool, settings, dim, seeds.below(families().size()), seeds.next() >> 16, account);
        }
    }
}

int report(const DiagramAccount& account, bool all_plants) {
    int kinds = 0, planted = 0, seen = 0, never = 0;
    for (const auto& [name, count] : account.planted) {
        kinds += count > 0;
        planted += count;
        if (count > 0 || !all_plants) continue;
        never++;
        std::printf("never planted: %s\n", name.c_str());
    }
    for (const auto& entry : account.seen) seen += entry.second;
    std::printf(
        "%d sets, %d runs: %d diagrams judged, %d with a ratio by scale, %d cycles; %d refused as documented or "
        "failed, %d too large\n",
        account.sets, account.runs, account.judged, account.by_scale, account.cycles, account.refused,
        account.too_large);
    std::printf("%d diagrams reproduced by `check`; %d fits, %d vineyards, %d distances\n", account.checked,
                account.fits, account.vineyards, account.distances);
    for (const auto& [name, count] : account.ways) std::printf("  %s: %d\n", name.c_str(), count);
    std::printf("the true ratio came to %.3f of the certified one, as logarithms: %s\n", account.tightest,
                account.tightest_title.c_str());
    std::printf("%d kinds of violations planted %d times, %d refused by `check`\n", kinds, planted, seen);
    std::printf("%d failures\n", account.failures + never);
    return account.failures + never == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
    Command arguments;
    if (!parse(count, words, {"--seed", "--minutes", "--sets", "--keep", "--trial", "--plants"}, &arguments)) {
        std::fprintf(stderr, "referee_diagrams NETMESH [--seed S] [--minutes M] [--sets N] [--keep FOLDER] "
                             "[--trial D:FAMILY:SEED] [--plants D:SEED]\n");
        return 2;
    }
    const Tool tool(arguments.tool);
    DiagramSettings settings;
    settings.keep = arguments.keep;
    DiagramAccount account;
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    if (!arguments.trial.empty()) {
        const std::vector<std::uint64_t> n = numbers_of(arguments.trial);
        if (n.size() != 3) return 2;
        try_diagram_family(tool, settings, static_cast<int>(n[0]), n[1], n[2], &account);
        return report(account, false);
    }
    if (!arguments.plants.empty()) {
        const std::vector<std::uint64_t> n = numbers_of(arguments.plants);
        if (n.size() != 2) return 2;
        try_diagram_plants(tool, settings, static_cast<int>(n[0]), n[1], &account);
        return report(account, true);
    }
    if (arguments.minutes > 0 || arguments.sets > 0) {
        run_long(tool, settings, arguments, &account);
    } else {
        run_slice(tool, settings, arguments.seed, &account);
    }
    return report(account, arguments.minutes == 0 && arguments.sets == 0);
}
