// The two definitions of truth.hpp against one another, against diagrams by hand and what has to stay: no engine.
//
//   periods_self [--clouds N] [--seed S] [--sets N]    N clouds, or a slice; balls where there are at most so many sets
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "balls.hpp"
#include "lattices.hpp"

namespace {

using namespace periods;

std::string text_of(const ExactBars& bars) {
    std::string text;
    for (const ExactBar& bar : bars)
        text += "    " + std::to_string(bar.degree) + " " + bar.birth.get_str() + " " +
                (bar.is_essential ? "inf" : bar.death.get_str()) + "\n";
    return text;
}
struct Seen {
    std::size_t clouds = 0, compared = 0, bars = 0, sets = 0, ball_sets = 0, faults = 0;
    double slowest = 0;
};

bool differ(const char* what, const ExactBars& came, const ExactBars& other) {
    if (came == other) return false;
    std::printf("%s\n  cells\n%s  other\n%s", what, text_of(came).c_str(), text_of(other).c_str());
    return true;
}

// 1: a difference; 0: none; -1: too many sets.
int judge_balls(const Cloud& cloud, const Values& values, const ExactBars& bars, std::size_t sets, Seen* seen) {
    mpq_class most = values.begin()->second;
    for (const auto& entry : values) most = std::max(most, entry.second);
    Balls balls(cloud, most, sets);
    if (!balls.find()) return -1;
    seen->ball_sets += balls.values().size();
    return differ("balls", bars, reduce(balls.values(), cloud.width()));
}

bool is_wrong(Random& random, const Cloud& cloud, std::size_t sets, Seen* seen) {
    const auto begin = std::chrono::steady_clock::now();
    const Values values = values_of_cells(cloud);
    const ExactBars bars = reduce(values, cloud.width());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    if (took.count() > seen->slowest) seen->slowest = took.count();
    if (took.count() > 2) {
        std::printf("%.1f s, %zu sets\n", took.count(), values.size());
        print_cloud(cloud);
    }
    ++seen->clouds;
    seen->sets += values.size();
    seen->bars += bars.size();
    if (!is_torus(cloud, bars)) return differ("not the classes of a torus", bars, {});
    const int by_balls = judge_balls(cloud, values, bars, sets, seen);
    seen->compared += by_balls == 0;
    if (by_balls == 1) return true;
    Cloud moved = cloud;
    skew(random, 4, &moved);
    move_by_lattice(random, 3, &moved);
    translate(random, &moved);
    permute(random, &moved);
    return differ("moved", bars, bars_of_cells(moved));
}

bool judge_named() {
    bool is_bad = false;
    for (const Named& named : periods::named()) {
        Seen seen;
        const Values values = values_of_cells(named.cloud);
        const ExactBars bars = reduce(values, named.cloud.width());
        const bool differs = differ(named.name.c_str(), bars, named.bars);
        const int by_balls = judge_balls(named.cloud, values, bars, 100000, &seen);
        std::printf("%-24s %s, %zu sets of cells, %zu of balls%s\n", named.name.c_str(),
                    differs ? "WRONG" : "as by hand", values.size(), seen.ball_sets,
                    by_balls < 0   ? " (too many)"
                    : by_balls > 0 ? " WRONG"
                                   : "");
        is_bad = is_bad || differs || by_balls == 1;
    }
    return is_bad;
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t clouds = 150, sets = 5000;
    std::uint64_t seed = 1;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string word = argv[i];
        const std::uint64_t number = std::strtoull(argv[i + 1], nullptr, 10);
        if (word == "--clouds") clouds = number;
        if (word == "--seed") seed = number;
        if (word == "--sets") sets = number;
    }
    Seen seen;
    if (judge_named()) ++seen.faults;
    for (std::size_t i = 0; i < clouds && seen.faults < 5; ++i) {
        Random random(seed * 0x9E3779B97F4A7C15u + i);
        const int dim = i % 3 == 2 ? 3 : 2;
        const Cloud cloud = make_cloud(random, dim, dim == 2 ? 8 : 4);
        if (!is_wrong(random, cloud, sets, &seen)) continue;
        ++seen.faults;
        std::printf("cloud %zu\n", i);
        print_cloud(cloud);
    }
    std::printf(
        "%zu clouds, %zu sets of cells, %zu bars; %zu compared with %zu sets of balls; slowest %.2f s; %zu faults\n",
        seen.clouds, seen.sets, seen.bars, seen.compared, seen.ball_sets, seen.slowest, seen.faults);
    return seen.faults > 0 ? 1 : 0;
}
