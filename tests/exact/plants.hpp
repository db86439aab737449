// Errors planted in diagrams of random clouds, one at a time: the judge has to refuse each of them and nothing else.
// And rounding by itself, on roots whose doubles are known.
#pragma once
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "families.hpp"
#include "jobs.hpp"

namespace exact {

struct Plant {
    const char* name;
    std::function<bool(Bars* bars, std::size_t at)> spoil;  // false: not on this bar
};

inline const std::vector<Plant>& plants() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    static const std::vector<Plant> list = {
        {"a death one unit later",
         [](Bars* bars, std::size_t at) {
             double& death = (*bars)[at].death;
             if (death == infinity) return false;
             death = std::nextafter(death, infinity);
             return true;
         }},
        {"a death one unit earlier",
         [](Bars* bars, std::size_t at) {
             double& death = (*bars)[at].death;
             if (death == infinity) return false;
             death = std::nextafter(death, 0);
             return true;
         }},
        {"a birth one unit later",
         [](Bars* bars, std::size_t at) {
             (*bars)[at].birth = std::nextafter((*bars)[at].birth, infinity);
             return true;
         }},
        {"a birth of -0",
         [](Bars* bars, std::size_t at) {
             if ((*bars)[at].birth != 0) return false;
             (*bars)[at].birth = -0.0;
             return true;
         }},
        {"a bar missing",
         [](Bars* bars, std::size_t at) {
             bars->erase(bars->begin() + static_cast<std::ptrdiff_t>(at));
             return true;
         }},
        {"a bar twice",
         [](Bars* bars, std::size_t at) {
             const Bar bar = (*bars)[at];
             bars->push_back(bar);
             return true;
         }},
        {"a bar of no length more",
         [](Bars* bars, std::size_t at) {
             Bar bar = (*bars)[at];
             bar.death = bar.birth;
             bars->push_back(bar);
             return true;
         }},
        {"another degree",
         [](Bars* bars, std::size_t at) {
             ++(*bars)[at].degree;
             return true;
         }},
        {"degrees of two bars exchanged",
         [](Bars* bars, std::size_t at) {
             Bar &a = (*bars)[at], &b = bars->back();
             if (a.degree == b.degree || (bits_of(a.birth) == bits_of(b.birth) && bits_of(a.death) == bits_of(b.death)))
                 return false;
             std::swap(a.degree, b.degree);
             return true;
         }},
        {"deaths of two bars exchanged",
         [](Bars* bars, std::size_t at) {
             Bar &a = (*bars)[at], &b = bars->back();
             if (a.death == b.death || (a.birth == b.birth && a.degree == b.degree)) return false;
             std::swap(a.death, b.death);
             return true;
         }},
        {"a bar that never ends",
         [](Bars* bars, std::size_t at) {
             if ((*bars)[at].death == infinity) return false;
             (*bars)[at].death = infinity;
             return true;
         }},
        {"death before birth",
         [](Bars* bars, std::size_t at) {
             std::swap((*bars)[at].birth, (*bars)[at].death);
             return true;
         }},
    };
    return list;
}

// Squares of roots with known doubles, among them ties, subnormals and what is beyond the largest double.
inline bool rounding_is_right() {
    const auto power = [](unsigned long e) { return mpz_class(mpz_class(1) << e); };
    struct Root {
        const char* name;
        Square square;
        long unit;
        double root;
    };
    const mpz_class odd = power(53) + 1, next = power(53) + 3;  // in the middle between doubles
    const double top = std::numeric_limits<double>::max();
    const Root roots[] = {
        {"0", {0, 1}, 0, 0},
        {"1", {1, 1}, 0, 1},
        {"root of 2", {2, 1}, 0, 0x1.6a09e667f3bcdp+0},
        {"root of 3, scaled", {3, 1}, -900, 0x1.bb67ae8584caap-900},
        {"1/3", {1, 9}, 0, 0x1.5555555555555p-2},
        {"a tie down to even", {odd * odd, 1}, 0, 0x1p53},
        {"a tie up to even", {next * next, 1}, 0, 0x1p53 + 4},
        {"just above a tie", {odd * odd + 1, 1}, 0, 0x1p53 + 2},
        {"just below a tie", {next * next - 1, 1}, 0, 0x1p53 + 2},
        {"up to a power of two", {power(108) - 1, 1}, 0, 0x1p54},
        {"half of the least subnormal", {1, 4}, -1074, 0},
        {"above half of the least subnormal", {power(200) + 1, power(202)}, -1074, 0x1p-1074},
        {"one and a half of the least subnormal", {9, 4}, -1074, 0x1p-1073},
        {"two and a half of the least subnormal", {25, 4}, -1074, 0x1p-1073},
        {"far below", {1, 1}, -5000, 0},
        {"subnormal up to normal", {power(106) - power(54) + 1, 1}, -1075, 0x1p-1022},
        {"the largest double", {(power(53) - 1) * (power(53) - 1), 1}, 971, top},
        {"half a unit above the largest", {(power(54) - 1) * (power(54) - 1), 1}, 970, HUGE_VAL},
        {"just below half a unit above the largest", {(power(54) - 1) * (power(54) - 1) - 1, 1}, 970, top},
        {"far above", {1, 1}, 3000, HUGE_VAL},
    };
    bool good = true;
    for (const Root& r : roots) {
        const double got = nearest_root(r.square, r.unit);
        if (bits_of(got) == bits_of(r.root)) continue;
        good = false;
        std::printf("rounding of %s: %a for %a\n", r.name, got, r.root);
    }
    return good;
}

// Diagrams that can be told by hand: the corners of a square and of a cube, one point, two points.
inline bool known_diagrams_are_right() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto compare = [](const char* name, const Truth& truth, const Bars& expected) {
        const std::string found = difference(expected, truth.bars);
        if (!found.empty()) std::printf("%s: %s\n", name, found.c_str());
        return found.empty();
    };
    bool good = true;
    const double root2 = 0x1.6a09e667f3bcdp+0, root3 = 0x1.bb67ae8584caap+0;
    {
        const Cloud cloud(2, {0, 0, 2, 0, 0, 2, 2, 2});
        const Balls balls(cloud);
        const Bars points = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, infinity}};
        Bars ring = points;
        ring.push_back({1, 1, root2});
        good &= compare("Cech of a square", nerve_diagram(members(4, 1), balls.cech, 1), ring);
        good &= compare("Rips of a square", nerve_diagram(members(4, 1), balls.rips, 1), ring);
        // places within r of two of the points: four of them at 1, joined at the centre at root2
        good &= compare("second nearest of a square", nerve_diagram(members(4, 2), balls.cech, 1),
                        {{0, 1, root2}, {0, 1, root2}, {0, 1, root2}, {0, 1, infinity}});
        good &=
            compare("fourth nearest of a square", nerve_diagram(members(4, 4), balls.cech, 1), {{0, root2, infinity}});
    }
    {
        const Cloud cloud(3, {0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0, 0, 0, 2, 2, 0, 2, 0, 2, 2, 2, 2, 2});
        const Balls balls(cloud);
        Bars cube = {{0, 0, infinity}, {2, root2, root3}};
        for (int i = 0; i < 7; ++i) cube.push_back({0, 0, 1});
        for (int i = 0; i < 5; ++i) cube.push_back({1, 1, root2});
        good &= compare("Cech of a cube", nerve_diagram(members(8, 1), balls.cech, 2), cube);
    }
    {
        const Cloud cloud(2, {3, 3, 3, 3});
        const Balls balls(cloud);
        good &= compare("one point twice", nerve_diagram(members(1, 1), balls.cech, 1), {{0, 0, infinity}});
    }
    {
        const Cloud cloud(2, {0, 0, 0x1p-1074, 0});
        const Balls balls(cloud);
        good &= compare("a distance that rounds to nothing", nerve_diagram(members(2, 1), balls.cech, 1),
                        {{0, 0, infinity}});
    }
    return good;
}

// Whether all is as it should be; prints a table.
inline bool try_plants() {
    bool good = rounding_is_right();
    good &= known_diagrams_are_right();
    struct Tally {
        std::size_t planted = 0, refused = 0;
    };
    std::vector<Tally> tallies(plants().size());
    std::size_t accepted = 0, clouds = 0;
    families::Random random(11);
    for (const families::Family& family : families::all())
        for (int round = 0; round < 12; ++round) {
            const int dim = random.whole(2, 4);
            const Cloud cloud(dim, family.make(random, dim, static_cast<std::size_t>(random.whole(4, 7))));
            const Balls balls(cloud);
            const Truth truth =
                nerve_diagram(members(cloud.count(), 1), balls.cech, static_cast<std::uint32_t>(dim) - 1);
            ++clouds;
            Answer answer;
            answer.bars = truth.bars;
            for (std::size_t i = answer.bars.size(); i > 1; --i)
                std::swap(answer.bars[i - 1],
                          answer.bars[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
            accepted += fault_of(answer, truth.bars).empty();
            for (std::size_t p = 0; p < plants().size(); ++p) {
                for (std::size_t at = 0; at < truth.bars.size(); ++at) {
                    answer.bars = truth.bars;
                    if (!plants()[p].spoil(&answer.bars, at)) continue;
                    ++tallies[p].planted;
                    tallies[p].refused += !fault_of(answer, truth.bars).empty();
                }
            }
        }
    std::printf("%zu of %zu right diagrams accepted\n", accepted, clouds);
    good &= accepted == clouds;
    for (std::size_t p = 0; p < plants().size(); ++p) {
        std::printf("%-32s planted %6zu, refused %6zu\n", plants()[p].name, tallies[p].planted, tallies[p].refused);
        good &= tallies[p].planted > 0 && tallies[p].refused == tallies[p].planted;
    }
    return good;
}

}  // namespace exact
