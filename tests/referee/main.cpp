// The referee: judges the files that `netmesh` writes, by its own definitions, and plants violations that `check` must
// refuse. Shares no code with what it judges.
//
//   referee NETMESH [--seed S] [--minutes M] [--keep FOLDER]      a slice, or new seeds for M minutes
//   referee NETMESH --trial D:FAMILY:SEED | --plants D:SEED       one trial that failed
//   referee NETMESH --judge STEM                                  files STEM.node, .ele, .neigh as they are
#include <cstdio>

#include "command.hpp"
#include "trials.hpp"

using namespace referee;

namespace {

void run_slice(const Tool& tool, const Settings& settings, std::uint64_t seed, Account* account) {
    Random seeds(seed);
    const std::vector<int> dims = dimensions_of(tool);
    try_named(tool, settings, 4, dims.back(), account);
    for (const int dim : dims)
        for (std::size_t family = 0; family < families().size(); family++)
            try_family(tool, settings, dim, family, seeds.next() >> 16, account);
    for (const int dim : dims) try_plants(tool, settings, dim, seeds.next() >> 16, account);
}

void run_long(const Tool& tool, Settings settings, const Command& arguments, Account* account) {
    Random seeds(arguments.seed);
    const double end = now() + 60 * arguments.minutes;
    const std::vector<int> dims = dimensions_of(tool);
    settings.every_ground = true;
    settings.seconds = 60;
    settings.refined = 60;
    for (std::size_t& size : settings.size) size *= 3;
    try_named(tool, settings, 1, dims.back(), account);
    for (std::size_t round = 0; now() < end; round++) {
        const int dim = dims[seeds.below(dims.size())];
        if (round % 25 == 0) {
            try_plants(tool, settings, dims[round / 25 % dims.size()], seeds.next() >> 16, account);
        } else {
            try_family(tool, settings, dim, seeds.below(families().size()), seeds.next() >> 16, account);
        }
    }
}

int judge_files(const std::string& stem, std::uint64_t seed) {
    Mesh mesh;
    const std::string unreadable = read_mesh(stem, &mesh);
    if (!unreadable.empty()) {
        std::printf("%s\n", unreadable.c_str());
        return 1;
    }
    Case wanted;
    wanted.dim = mesh.dim;
    wanted.is_mesh = mesh.has_domain;
    wanted.has_cages = true;
    for (std::size_t v = 0; v < mesh.count(); v++)
        if (mesh.markers[v] == input_marker) wanted.points.push_back(mesh.vertices[v]);
    Random random(seed);
    const Verdict verdict = judge(mesh, wanted, random);
    for (const Fault& fault : verdict.faults) std::printf("%s: %s\n", fault.promise.c_str(), fault.text.c_str());
    std::printf("largest ratio %.6f, sampled %.6f\n", verdict.worst_ratio, verdict.sampled_ratio);
    return verdict.good() ? 0 : 1;
}

// By chance a mesh has no place for a kind of violation; more kinds than this without one are a fault of the plants.
constexpr int never_planted_max = 3;

int report(const Account& account, bool all_plants) {
    int kinds = 0, never = 0;
    for (const auto& [name, count] : account.planted) {
        kinds += count > 0;
        if (count > 0 || !all_plants) continue;
        never++;
        std::printf("never planted: %s\n", name.c_str());
    }
    int planted = 0, seen = 0;
    for (const auto& entry : account.planted) planted += entry.second;
    for (const auto& entry : account.seen) seen += entry.second;
    std::printf("%d runs: %d meshes judged, %d refused as documented or failed, %d too large; "
                "largest sampled ratio %.6f of tau\n",
                account.trials, account.meshes, account.refused, account.too_large, account.worst_sampled);
    std::printf("%d kinds of violations planted %d times, %d refused by `check`\n", kinds, planted, seen);
    const int failures = account.failures + (never > never_planted_max ? never : 0);
    std::printf("%d failures\n", failures);
    return failures == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
    Command arguments;
    if (!parse(count, words, {"--seed", "--minutes", "--keep", "--trial", "--plants", "--judge"}, &arguments)) {
        std::fprintf(stderr, "referee NETMESH [--seed S] [--minutes M] [--keep FOLDER] [--trial D:FAMILY:SEED] "
                             "[--plants D:SEED] [--judge STEM]\n");
        return 2;
    }
    if (!arguments.stem.empty()) return judge_files(arguments.stem, arguments.seed);
    const Tool tool(arguments.tool);
    Settings settings;
    settings.keep = arguments.keep;
    Account account;
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    if (!arguments.trial.empty()) {
        const std::vector<std::uint64_t> n = numbers_of(arguments.trial);
        if (n.size() != 3) return 2;
        if (arguments.minutes > 0)  // as in a long run
            for (std::size_t& size : settings.size) size *= 3;
        try_family(tool, settings, static_cast<int>(n[0]), n[1], n[2], &account);
        return report(account, false);
    }
    if (!arguments.plants.empty()) {
        const std::vector<std::uint64_t> n = numbers_of(arguments.plants);
        if (n.size() != 2) return 2;
        settings.every_ground = true;
        try_plants(tool, settings, static_cast<int>(n[0]), n[1], &account);
        return report(account, false);
    }
    if (arguments.minutes > 0) {
        run_long(tool, settings, arguments, &account);
    } else {
        run_slice(tool, settings, arguments.seed, &account);
    }
    return report(account, arguments.minutes == 0);
}
