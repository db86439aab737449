// Every value that is promised to be exact against the truth: diagrams of alpha, Cech and Rips complexes and of nested
// sets, births and deaths bit for bit, on clouds of 1 to 9 points (families.hpp).
//
//   exact [--clouds N] [--seed S] [--family NAME]    N clouds in all, or a slice; a table by family and job
//   exact --file FILE                                the cloud of a file: a point a line, numbers as strtod reads them
//   exact --plant                                    errors planted in diagrams, which have to be seen
//
// Ends with 1 on a difference, after the cloud in hexadecimal, what was expected and what came. Clouds are judged by a
// process of their own: where a call crashes, or takes minutes, the next one goes on.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

#include "families.hpp"
#include "jobs.hpp"
#include "plants.hpp"

namespace {

using namespace exact;

constexpr std::size_t slice = 2600;

Plan make_plan(families::Random& random, int dim, std::size_t n) {
    Plan plan;
    plan.permutation = random.bits();
    plan.rips_degree = static_cast<std::uint32_t>(random.whole(1, 3));
    plan.k = random.whole(1, 3) + random.one_in(4);
    set_nested_degree(dim, n, random.one_in(25) ? 10 : 1, &plan);
    return plan;
}

struct Row {
    Count counts[jobs];
    std::size_t clouds = 0, faults[jobs] = {};
};

struct Trial {
    std::string title;
    std::size_t row;
    int dim;
    std::vector<double> points;
    Plan plan;
};

// Judges one cloud; prints what is wrong.
void judge_trial(const Block& block, const Trial& trial, Row* row, int* printed) {
    ++row->clouds;
    const std::vector<Finding> found = judge(block, trial.dim, trial.points, trial.plan, row->counts);
    for (const Finding& finding : found) ++row->faults[finding.job];
    if (found.empty() || ++*printed > 10) return;
    std::printf("%s, %dD:\n", trial.title.c_str(), trial.dim);
    for (const Finding& finding : found) std::printf("  %s: %s\n", name_of(finding.job), finding.what.c_str());
    print_cloud(trial.dim, trial.points);
}

constexpr std::size_t rows_max = 100;

// What the process that judges and the one that waits for it both see.
struct Shared {
    Row rows[rows_max];
    std::size_t next = 0;  // trial
    int printed = 0;
};

// All trials; the rows of the table.
const Row* judge_all(std::size_t count, const std::function<Trial(std::size_t)>& make) {
    void* const memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    Shared* const shared = new (memory) Shared;
    while (shared->next < count) {
        std::fflush(stdout);
        const pid_t child = fork();
        if (child < 0) throw std::bad_alloc();
        if (child == 0) {
            const Block block;
            while (shared->next < count) {
                const Trial trial = make(shared->next);
                alarm(300);
                judge_trial(block, trial, &shared->rows[trial.row], &shared->printed);
                ++shared->next;
            }
            std::fflush(stdout);
            _exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        if (shared->next >= count) break;
        const Trial trial = make(shared->next++);
        Row& row = shared->rows[trial.row];
        int at = 0;  // outside of any: a fault of this program
        while (at < jobs && row.counts[at].begun == row.counts[at].asked) ++at;
        const char* const where = at < jobs ? name_of(at) : "no call";
        if (at < jobs) row.counts[at].asked = row.counts[at].begun;
        ++row.faults[at < jobs ? at : 0];
        std::printf("%s, %dD:\n  %s: stopped with status %#x\n", trial.title.c_str(), trial.dim, where,
                    static_cast<unsigned>(status));
        print_cloud(trial.dim, trial.points);
    }
    return shared->rows;
}

// About D + 2 above all.
std::size_t count_for(families::Random& random, int dim) {
    if (random.one_in(3)) return static_cast<std::size_t>(random.whole(1, 9));
    return static_cast<std::size_t>(std::min(random.whole(dim + 1, dim + 4), 9));
}

std::size_t print_table(const std::vector<std::string>& names, const Row* rows) {
    std::printf("\nDifferences / diagrams\n%-24s %7s", "family", "clouds");
    for (int job = 0; job < jobs; ++job) std::printf(" %15s", name_of(job));
    std::printf("\n");
    Row sum;
    std::size_t differences = 0;
    const auto print = [&](const char* name, const Row& row) {
        std::printf("%-24s %7zu", name, row.clouds);
        for (int job = 0; job < jobs; ++job) {
            const std::string cell = std::to_string(row.faults[job]) + " / " + std::to_string(row.counts[job].asked);
            std::printf(" %15s", cell.c_str());
        }
        std::printf("\n");
    };
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Row& row = rows[i];
        if (row.clouds == 0) continue;
        print(names[i].c_str(), row);
        sum.clouds += row.clouds;
        for (int job = 0; job < jobs; ++job) {
            sum.faults[job] += row.faults[job];
            differences += row.faults[job];
            sum.counts[job].asked += row.counts[job].asked;
            sum.counts[job].bars += row.counts[job].bars;
            sum.counts[job].hidden += row.counts[job].hidden;
            sum.counts[job].close += row.counts[job].close;
            sum.counts[job].refused += row.counts[job].refused;
        }
    }
    print("all", sum);
    const auto print_counts = [&](const char* name, std::size_t Count::*what) {
        std::printf("%-32s", name);
        for (int job = 0; job < jobs; ++job) std::printf(" %15zu", sum.counts[job].*what);
        std::printf("\n");
    };
    print_counts("bars", &Count::bars);
    print_counts("from a double to the next one", &Count::close);
    print_counts("of no length once rounded", &Count::hidden);
    print_counts("flat, out of range", &Count::refused);
    std::printf("differences: %zu\n", differences);
    return differences;
}

int judge_file(const char* name) {
    std::ifstream file(name);
    std::vector<double> x;
    int dim = 0;
    for (std::string line; std::getline(file, line);) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        const std::vector<std::string> row{std::istream_iterator<std::string>(words), {}};
        if (row.empty()) continue;
        if (dim == 0) dim = static_cast<int>(row.size());
        if (row.size() != static_cast<std::size_t>(dim)) dim = -1;
        for (const std::string& word : row) x.push_back(std::strtod(word.c_str(), nullptr));
    }
    if (dim < 2 || dim > 6) {
        std::fprintf(stderr, "%s: no points of 2 to 6 coordinates each\n", name);
        return 2;
    }
    families::Random random(1);
    const Plan plan = make_plan(random, dim, Cloud(dim, x).count());
    return print_table({name}, judge_all(1, [&](std::size_t) { return Trial{name, 0, dim, x, plan}; })) == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t clouds = slice;
    std::uint64_t seed = 1;
    std::string only;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--plant") return exact::try_plants() ? 0 : 1;
        if (word == "--file" && i + 1 < argc) return judge_file(argv[i + 1]);
        if (i + 1 < argc && word == "--clouds") {
            clouds = std::strtoul(argv[++i], nullptr, 0);
        } else if (i + 1 < argc && word == "--seed") {
            seed = std::strtoull(argv[++i], nullptr, 0);
        } else if (i + 1 < argc && word == "--family") {
            only = argv[++i];
        } else {
            std::fprintf(stderr, "exact [--clouds N] [--seed S] [--family NAME] | --file FILE | --plant\n");
            return 2;
        }
    }
    const auto begin = std::chrono::steady_clock::now();
    std::vector<int> dims;
    for (int dim = NETMESH_DIM_MIN; dim <= NETMESH_DIM_MAX; ++dim)
        if (is_served(dim)) dims.push_back(dim);
    const std::vector<families::Family>& all = families::all();
    const std::vector<families::Named>& named = families::named();
    std::vector<std::string> names = {"named"};
    std::vector<std::size_t> chosen;  // families; after them one of many coordinates
    for (std::size_t i = 0; i < all.size(); ++i) {
        names.push_back(all[i].name);
        names.push_back(std::string(all[i].name) + ", moved");
        if (only.empty() || only == all[i].name) chosen.push_back(i);
    }
    names.push_back("many coordinates");
    if (only.empty() || only == names.back()) chosen.push_back(all.size());
    if (chosen.empty()) {
        std::fprintf(stderr, "no family '%s'\n", only.c_str());
        return 2;
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const std::size_t first = only.empty() ? named.size() : 0;
    const auto make = [&](std::size_t i) {
        families::Random seeds(seed + i), random(seeds.bits());
        if (i < first) {
            const std::size_t count = named[i].points.size() / static_cast<std::size_t>(named[i].dim);
            return Trial{named[i].name, 0, named[i].dim, named[i].points, make_plan(random, named[i].dim, count)};
        }
        const std::size_t family = chosen[(i - first) % chosen.size()];
        if (family == all.size()) {
            const int dim = random.whole(7, random.one_in(3) ? 300 : 20);
            const std::size_t n = static_cast<std::size_t>(random.whole(2, 8));
            Plan plan;
            plan.rips_degree = static_cast<std::uint32_t>(random.whole(1, 3));
            plan.permutation = random.bits();
            return Trial{names.back(), names.size() - 1, dim, families::many_coordinates(random, dim, n), plan};
        }
        const int dim = dims[static_cast<std::size_t>(random.whole(1, static_cast<int>(dims.size()))) - 1];
        families::Points x = all[family].make(random, dim, count_for(random, dim));
        const bool move = random.one_in(3);
        if (move) families::move_units(random, random.whole(1, 3), &x);
        const std::size_t row = 1 + 2 * family + move;
        return Trial{names[row], row, dim, x, make_plan(random, dim, x.size() / static_cast<std::size_t>(dim))};
    };
    const std::size_t differences = print_table(names, judge_all(first + clouds, make));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::printf("seed %#llx, %.1f s\n", static_cast<unsigned long long>(seed), seconds.count());
    return differences == 0 ? 0 : 1;
}
