// Alpha diagrams of points that repeat against rationals (truth.hpp), births and deaths bit for bit: 1 to 8 points in
// the plane and 1 to 4 in space, 1 to D periods, with weights and without, in special position and in general; lattices
// with diagrams by hand; flat copies, duplicates; what has to leave a diagram as it is: another basis of the lattice,
// translation, another order of rows, other copies, weights 0, another unit; twice the cell; numbers whose copies are
// no doubles. Of more points, whose copies are inserted as they are asked for, the same changes, without rationals.
//
//   periods [--clouds N] [--seed S] [--in-space POINTS]    N clouds, or a slice; in space with up to so many points, 4
//   periods --plant                                        errors planted in what came, which have to be seen
//
// Ends with 1 on a difference, after the cloud.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "judge.hpp"

namespace {

using namespace periods;

bool is_near(double a, double b, double by) { return a == b || std::fabs(a - b) <= by; }

// Each bar of one that is longer than four times `by` is in the other, its ends moved by no more than `by`.
bool holds(const Bars& one, Bars other, double by) {
    for (const Bar& bar : one) {
        if (bar.death - bar.birth <= 4 * by) continue;
        std::size_t i = 0;
        while (i < other.size() && !(other[i].degree == bar.degree && is_near(other[i].birth, bar.birth, by) &&
                                     is_near(other[i].death, bar.death, by)))
            ++i;
        if (i == other.size()) return false;
        other.erase(other.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return true;
}

struct Seen {
    std::size_t clouds = 0, flat = 0, bars = 0, cycles = 0, weighted = 0, open = 0, duplicates = 0, hidden = 0,
                moved = 0, more = 0, faults = 0;
    double farthest = 0;
};

void print_exactly(const Cloud& cloud) {
    std::printf("  lattice");
    for (const double c : cloud.lattice) std::printf(" %a", c);
    std::printf("\n  points ");
    for (const double c : cloud.x) std::printf(" %a", c);
    std::printf("\n");
}

// Numbers whose copies are no doubles. The engine may move them, which moves bars by about as much.
std::string judge_exact_or_moved(const Block& block, const std::string& what, const Cloud& cloud, Seen* seen) {
    const Answer answer = ask(block, cloud);
    if (answer.status != NETMESH_OK) return what + ": " + netmesh_status_text(answer.status);
    const Bars bars = rounded(bars_of_cells(cloud), false);
    double reach = 0;
    for (const double c : cloud.x) reach = std::max(reach, std::fabs(c));
    for (const double c : cloud.lattice) reach = std::max(reach, std::fabs(c));
    ++seen->moved;
    seen->farthest = std::max(seen->farthest, answer.moved / reach);
    if (answer.moved > 0x1p-36 * reach) return what + ": numbers were moved far";
    if (answer.moved == 0 && !(answer.bars == bars)) {
        print_exactly(cloud);
        return what + ": nothing was moved, but other bars\n  came\n" + text_of(answer.bars) + "  truth\n" +
               text_of(bars);
    }
    // A short vector is a sum of at most some hundreds of those of a skewed basis.
    const double by = 1000 * answer.moved;
    if (holds(bars, answer.bars, by) && holds(answer.bars, bars, by)) return "";
    print_exactly(cloud);
    return what + ": bars are too far away\n  came\n" + text_of(answer.bars) + "  truth\n" + text_of(bars);
}

constexpr const char* digit_kinds[] = {"tenths", "moved by units", "on a fine grid"};

void lengthen(Random& random, int kind, Cloud* cloud) {
    double reach = 0;
    for (Numbers* const x : {&cloud->x, &cloud->lattice}) {
        if (kind == 0) multiply(x, 0.1);
        if (kind == 1) families::move_units(random, 2, x);
        for (const double c : *x) reach = std::max(reach, std::fabs(c));
    }
    if (kind != 2) return;
    // Multiples of the last digit of the largest: sums are doubles where they are as small, multiples are often none.
    int exponent;
    std::frexp(reach, &exponent);
    for (Numbers* const x : {&cloud->x, &cloud->lattice})
        for (double& c : *x) c += random.whole(-3, 3) * std::ldexp(1, exponent - 53);
}

std::string judge_digits(const Block& block, Random& random, int kind, Cloud cloud, Seen* seen) {
    lengthen(random, kind, &cloud);
    cloud.numbers.clear();
    cloud.are_radii = false;
    return is_flat(cloud) ? "" : judge_exact_or_moved(block, digit_kinds[kind], cloud, seen);
}

// In another unit, a power of 2.
std::string judge_unit(const Block& block, Random& random, Cloud cloud, Truth truth) {
    const double by = std::ldexp(1, random.whole(-40, 40));
    multiply(&cloud.x, by);
    multiply(&cloud.lattice, by);
    multiply(&cloud.numbers, cloud.are_radii ? by : by * by);
    for (Bar& bar : truth.bars) {
        bar.birth *= by;
        bar.death *= by;
    }
    return compare("another unit", ask(block, cloud), truth);
}

std::string judge_degree(const Block& block, Random& random, const Cloud& cloud, const Truth& truth) {
    Truth less = truth;
    Wish wish;
    wish.degree = static_cast<std::uint32_t>(random.whole(0, cloud.dim - 1));
    less.bars.clear();
    for (const Bar& bar : truth.bars)
        if (bar.degree <= wish.degree) less.bars.push_back(bar);
    return compare("degrees to " + std::to_string(wish.degree), ask(block, cloud, wish), less);
}

std::string judge_supercell(const Block& block, Random& random, const Cloud& cloud) {
    const Cloud twice = supercell(cloud, random.bits() % cloud.periods());
    const Bars bars = rounded(bars_of_cells(twice), false);
    return compare("twice the cell", ask(block, twice), truth_of(twice, bars));
}

std::string cycles_complaint(const std::vector<CycleOfBar>& cycles, const CycleJudge& judge) {
    for (const CycleOfBar& cycle : cycles) {
        const std::string complaint = judge.judge(cycle);
        if (!complaint.empty()) return "the cycle of" + text_of({cycle.bar}) + "    has " + complaint;
    }
    return "";
}

// By another basis and other copies, which cycles say translations of.
std::string judge_cycles(const Block& block, Random& random, Cloud cloud, const Truth& truth, Seen* seen) {
    skew(random, 2, &cloud);
    move_by_lattice(random, 3, &cloud);
    Wish wish;
    wish.cycles = true;
    wish.degree = static_cast<std::uint32_t>(random.whole(0, cloud.dim));
    Truth less = truth;
    less.bars.clear();
    for (const Bar& bar : truth.bars)
        if (bar.degree <= wish.degree) less.bars.push_back(bar);
    const Answer answer = ask(block, cloud, wish);
    const std::string fault = compare("with cycles", answer, less);
    if (!fault.empty()) return fault;
    seen->cycles += answer.cycles.size();
    return cycles_complaint(answer.cycles, CycleJudge(cloud));
}

constexpr int changes = 11;

std::string judge_change(const Block& block, Random& random, int change, const Cloud& cloud, const Truth& truth,
                         Seen* seen) {
    Cloud other = cloud;
    switch (change) {
    case 0: skew(random, 3, &other); return compare("another basis", ask(block, other), truth);
    case 1: translate(random, &other); return compare("translated", ask(block, other), truth);
    case 2: permute(random, &other); return compare("rows in another order", ask(block, other), truth);
    case 3: move_by_lattice(random, 3, &other); return compare("other copies", ask(block, other), truth);
    case 4:
        if (!cloud.numbers.empty()) return "";
        other.numbers.assign(cloud.count(), 0.0);
        other.are_radii = random.one_in(2);
        return compare("weights 0", ask(block, other), truth);
    case 5: return judge_unit(block, random, cloud, truth);
    case 6: return judge_degree(block, random, cloud, truth);
    case 7: return cloud.count() <= (cloud.dim == 2 ? 5u : 2u) ? judge_supercell(block, random, cloud) : "";
    case 8: return judge_digits(block, random, random.whole(0, 2), cloud, seen);
    case 9: return judge_digits(block, random, 2, cloud, seen);
    default:  // all at once
        skew(random, 2, &other);
        move_by_lattice(random, 1, &other);
        translate(random, &other);
        permute(random, &other);
        return compare("another basis, other copies, translated, another order", ask(block, other), truth);
    }
}

std::string judge(const Block& block, Random& random, std::size_t number, const Cloud& cloud, Seen* seen) {
    const Answer roots = ask(block, cloud);
    if (roots.status == NETMESH_NOT_BUILT) return "";  // a build of other dimensions
    ++seen->clouds;
    if (is_flat(cloud)) {
        ++seen->flat;
        return roots.status == NETMESH_FLAT ? "" : std::string("flat: ") + netmesh_status_text(roots.status);
    }
    const bool has_all_periods = cloud.periods() == cloud.width();
    std::vector<Extent> extents;
    const ExactBars exact = bars_of_cells(cloud, has_all_periods ? &extents : nullptr);
    const Truth truth = truth_of(cloud, rounded(exact, false));
    seen->bars += truth.bars.size();
    seen->weighted += !cloud.numbers.empty();
    seen->open += cloud.periods() < cloud.width();
    seen->duplicates += truth.duplicates;
    std::string fault = compare(cloud.numbers.empty() ? "radii" : "signed roots", roots, truth);
    if (fault.empty() && !cloud.numbers.empty()) {
        Wish wish;
        wish.squares = true;
        fault = compare("powers", ask(block, cloud, wish), truth_of(cloud, rounded(exact, true)));
    }
    if (fault.empty() && has_all_periods) {
        fault = compare_hidden(roots, cloud, extents);
        for (std::size_t i = 0; i < extents.size(); ++i) seen->hidden += extents[i] == Extent::nothing;
    }
    if (fault.empty()) fault = judge_cycles(block, random, cloud, truth, seen);
    for (std::size_t i = 0; i < 3 && fault.empty(); ++i) {
        ++seen->more;
        fault = judge_change(block, random, static_cast<int>((number * 3 + i) % changes), cloud, truth, seen);
    }
    return fault;
}

Cloud make_cloud_of(Random& random, std::size_t number, std::size_t most_in_space = 4) {
    const int dim = number % 3 == 2 ? 3 : 2;
    return make_cloud(random, dim, dim == 2 ? 8 : most_in_space);
}

// Points, most of whose copies nobody asks for: which these are another basis, place or order must not tell.
std::size_t judge_many(const Block& block, std::uint64_t seed, std::size_t clouds) {
    std::size_t faults = 0, judged = 0, points = 0, copies = 0;
    for (std::size_t i = 0; i < clouds && faults < 5; ++i) {
        Random random(seed * 0x9E3779B97F4A7C15u + i);
        const Cloud cloud = i % 4 == 3 ? make_cloud(random, 4, 12) : make_cloud(random, 3, i % 8 == 0 ? 400 : 60);
        const Answer answer = ask(block, cloud);
        if (answer.status != NETMESH_OK || answer.moved != 0) continue;
        ++judged;
        if (cloud.periods() == cloud.width()) {
            points += cloud.count();
            copies += answer.copies;
        }
        Truth truth;
        truth.bars = answer.bars;
        truth.duplicates = answer.duplicates;
        truth.periods = answer.periods;
        std::string fault = is_torus(cloud, answer.bars) ? "" : "not the classes of a torus";
        Seen seen;
        for (const int change : {0, 1, 2, 3, 4, changes - 1})
            if (fault.empty()) fault = judge_change(block, random, change, cloud, truth, &seen);
        if (fault.empty()) continue;
        ++faults;
        std::printf("cloud %zu of many points: %s\n", i, fault.c_str());
        print_cloud(cloud);
    }
    std::printf("%zu clouds of many points, %.1f copies a point, %zu faults\n", judged,
                static_cast<double>(copies) / static_cast<double>(points + (points == 0)), faults);
    // All that matter would be 26 in space, and 80 beyond.
    const bool are_too_many = points > 500 && copies > 16 * points;
    if (are_too_many) std::printf("too many copies\n");
    return faults + are_too_many;
}

// Diagrams by hand, from the engine and from the truth.
std::size_t judge_named(const Block& block) {
    std::size_t faults = 0, judged = 0;
    for (const Named& named : periods::named()) {
        const Answer answer = ask(block, named.cloud);
        if (answer.status == NETMESH_NOT_BUILT) continue;
        ++judged;
        std::string fault = is_flat(named.cloud) && answer.status == NETMESH_FLAT
                                ? ""
                                : compare("by hand", answer, truth_of(named.cloud, rounded(named.bars, false)));
        if (fault.empty() && !is_torus(named.cloud, answer.bars) && answer.status == NETMESH_OK)
            fault = "not the classes of a torus";
        // In four dimensions it takes seconds.
        if (named.cloud.dim <= 3 && !(bars_of_cells(named.cloud) == named.bars)) fault = "the truth is another";
        if (fault.empty()) continue;
        ++faults;
        std::printf("%s: %s\n", named.name.c_str(), fault.c_str());
    }
    std::printf("%zu diagrams by hand, %zu faults\n", judged, faults);
    return faults;
}

// Found once. A short vector is 3 b2 - b1 = (-30, 0), where 3 b2 is no double.
std::size_t judge_found(const Block& block, Seen* seen) {
    const Cloud cloud = cloud_of(2, {161, 150}, {-0x1.8e66666666667p+6, -0x1.68p+6, -0x1.599999999999ap+5, -0x1.ep+4});
    const std::string fault = judge_exact_or_moved(block, "multiples that are no doubles", cloud, seen);
    if (!fault.empty()) std::printf("%s\n", fault.c_str());
    return !fault.empty();
}

// A basis of long vectors, of which short ones are differences that no double has, and points 2^30 periods away.
// Against the truth of the short basis and of points nearby, both found in rationals and rounded.
std::size_t judge_long(const Block& block, std::uint64_t seed, std::size_t clouds) {
    std::size_t faults = 0;
    for (std::size_t i = 0; i < clouds; ++i) {
        Random random(seed * 0x9E3779B97F4A7C15u + i);
        // The second short vector is shorter than the first, so that they change places.
        const double first[] = {random.uniform(1, 2), random.uniform(0, 0.1)};
        const mpq_class times(std::ldexp(1, 21) + 2 * random.whole(0, 1000000) + 1);
        Cloud given, near;
        given.lattice = {first[0], first[1]};
        near.lattice = given.lattice;
        Row second;
        for (std::size_t k = 0; k < 2; ++k) {
            const double wanted = k == 0 ? random.uniform(-0.3, 0.3) : random.uniform(0.4, 0.7);
            const mpq_class sum = times * mpq_class(first[k]) + mpq_class(wanted);
            given.lattice.push_back(sum.get_d());
            second.push_back(mpq_class(given.lattice.back()) - times * mpq_class(first[k]));
            near.lattice.push_back(second.back().get_d());
        }
        for (int point = 0; point < 3; ++point) {
            const mpq_class a(std::ldexp(random.whole(-1000, 1000), 20)), b(std::ldexp(random.whole(-1000, 1000), 20));
            for (std::size_t k = 0; k < 2; ++k) {
                const mpq_class by = a * mpq_class(first[k]) + b * second[k];
                const mpq_class far = by + mpq_class(random.uniform());
                given.x.push_back(far.get_d());
                const mpq_class left = mpq_class(given.x.back()) - by;
                near.x.push_back(left.get_d());
            }
        }
        const Answer answer = ask(block, given);
        std::string fault = answer.status != NETMESH_OK ? netmesh_status_text(answer.status) : "";
        if (fault.empty()) {
            const Bars bars = rounded(bars_of_cells(near), false);
            const double by = 1e-12;
            if (!holds(bars, answer.bars, by) || !holds(answer.bars, bars, by))
                fault = "other bars\n  came\n" + text_of(answer.bars) + "  truth\n" + text_of(bars);
        }
        if (fault.empty()) continue;
        ++faults;
        std::printf("long vectors, cloud %zu: %s\n", i, fault.c_str());
        print_exactly(given);
    }
    std::printf("%zu clouds of long vectors and far points, %zu faults\n", clouds, faults);
    return faults;
}

// What is wrong with an answer now; false: there is nothing to make wrong.
bool spoil(Random& random, int kind, Answer* wrong) {
    const std::size_t at = random.bits() % wrong->bars.size();
    Bar& bar = wrong->bars[at];
    std::vector<std::size_t> essential;
    for (std::size_t i = 0; i < wrong->bars.size(); ++i)
        if (std::isinf(wrong->bars[i].death)) essential.push_back(i);
    const std::size_t lasting = essential[random.bits() % essential.size()];
    switch (kind) {
    case 0: bar.birth = families::moved(bar.birth, random.one_in(2) ? 1 : -1); break;
    case 1:
        if (std::isinf(bar.death)) return false;
        bar.death = families::moved(bar.death, random.one_in(2) ? 1 : -1);
        break;
    case 2: wrong->bars.erase(wrong->bars.begin() + static_cast<std::ptrdiff_t>(at)); break;
    case 3: wrong->bars.insert(wrong->bars.begin() + static_cast<std::ptrdiff_t>(at), Bar(bar)); break;
    case 4: wrong->bars.erase(wrong->bars.begin() + static_cast<std::ptrdiff_t>(lasting)); break;
    case 5: bar.degree += bar.degree == 0 || random.one_in(2) ? 1u : static_cast<std::uint32_t>(-1); break;
    case 6: wrong->bars[lasting].death = wrong->bars[lasting].birth + 1; break;
    case 7:  // two bars exchange their degrees
        if (wrong->bars.front().degree == wrong->bars.back().degree) return false;
        std::swap(wrong->bars.front().degree, wrong->bars.back().degree);
        break;
    case 8: ++wrong->duplicates; break;
    case 9: --wrong->periods; break;
    case 10: wrong->moved = 0x1p-50; break;
    default: wrong->status = NETMESH_FLAT; break;
    }
    return true;
}

// Lists of hidden points that lack one, have one too many, or are in another order, and a count that is off.
int plant_hidden(const Block& block, int* missed) {
    Random random(6);
    int planted = 0;
    for (std::size_t i = 0; planted < 60 && i < 2000; ++i) {
        const Cloud cloud = make_cloud(random, 2, 8);
        const Answer answer = ask(block, cloud);
        if (answer.status != NETMESH_OK || answer.hidden.empty() || cloud.periods() < cloud.width()) continue;
        std::vector<Extent> extents;
        bars_of_cells(cloud, &extents);
        for (int kind = 0; kind < 4; ++kind) {
            Answer wrong = answer;
            std::size_t other = 0;
            while (other < cloud.count() && extents[other] != Extent::inside) ++other;
            const std::size_t first = wrong.hidden.front();
            if (kind == 0 && extents[first] != Extent::nothing) continue;
            if (kind == 0) wrong.hidden.erase(wrong.hidden.begin());
            if (kind == 1) wrong.hidden.front() = other;
            if (kind == 2 && wrong.hidden.size() < 2) continue;
            if (kind == 2) std::swap(wrong.hidden.front(), wrong.hidden.back());
            if (kind == 3) ++wrong.distinct;
            ++planted;
            *missed += compare_hidden(wrong, cloud, extents).empty();
        }
    }
    return planted;
}

// What is wrong with a cycle now; false: there is nothing to make wrong.
bool spoil_cycle(Random& random, int kind, std::vector<CycleOfBar>* cycles) {
    CycleOfBar& cycle = (*cycles)[random.bits() % cycles->size()];
    const std::size_t at = random.bits() % cycle.simplices.size();
    CycleSimplex& simplex = cycle.simplices[at];
    switch (kind) {
    case 0:
        if (simplex.corners.size() < 2) return false;
        simplex.corners.back().times[random.bits() % simplex.corners.back().times.size()] += 9;
        break;
    case 1: cycle.simplices.erase(cycle.simplices.begin() + static_cast<std::ptrdiff_t>(at)); break;
    case 2: cycle.simplices.push_back(CycleSimplex(simplex)); break;
    case 3: simplex.value = families::moved(simplex.value, 1); break;
    case 4:  // a cycle of another bar, born and dying otherwise
        for (const CycleOfBar& other : *cycles) {
            if (other.bar.degree != cycle.bar.degree || other.bar.birth == cycle.bar.birth) continue;
            cycle.simplices = std::vector<CycleSimplex>(other.simplices);
            return true;
        }
        return false;
    default:  // longer by what has no boundary but does not die by then
        for (const CycleOfBar& other : *cycles) {
            if (other.bar.degree != cycle.bar.degree || other.bar.degree == 0 || &other == &cycle) continue;
            if (other.bar.birth > cycle.bar.birth || !(other.bar.death > cycle.bar.death)) continue;
            for (const CycleSimplex& more : other.simplices) {
                for (const CycleSimplex& own : cycle.simplices)
                    if (own.value == more.value) return false;  // it may be the same
            }
            cycle.simplices.insert(cycle.simplices.end(), other.simplices.begin(), other.simplices.end());
            return true;
        }
        return false;
    }
    return true;
}

int plant_in_cycles(const Block& block) {
    constexpr int kinds = 6;
    Random random(6);
    Wish wish;
    wish.cycles = true;
    int planted[kinds] = {}, missed = 0, sound = 0;
    for (std::size_t i = 0; sound < 60 && i < 600; ++i) {
        const Cloud cloud = make_cloud_of(random, i);
        const Answer answer = ask(block, cloud, wish);
        if (answer.status != NETMESH_OK || answer.cycles.empty()) continue;
        const CycleJudge judge(cloud);
        if (!cycles_complaint(answer.cycles, judge).empty()) continue;
        ++sound;
        for (int kind = 0; kind < kinds; ++kind) {
            std::vector<CycleOfBar> wrong = answer.cycles;
            if (!spoil_cycle(random, kind, &wrong)) continue;
            ++planted[kind];
            if (!cycles_complaint(wrong, judge).empty()) continue;
            ++missed;
            std::printf("missed: an error of kind %d in a cycle\n", kind);
        }
    }
    int kinds_seen = 0;
    for (const int count : planted) kinds_seen += count > 0;
    std::printf("%d kinds of errors planted in cycles of %d answers, %d missed\n", kinds_seen, sound, missed);
    return sound < 60 || kinds_seen < kinds || missed > 0 ? 1 : 0;
}

int plant(const Block& block) {
    constexpr int kinds = 12;
    Random random(5);
    int planted[kinds] = {}, missed = 0, sound = 0;
    for (std::size_t i = 0; sound < 60 && i < 600; ++i) {
        const Cloud cloud = make_cloud_of(random, i);
        const Answer answer = ask(block, cloud);
        if (answer.status != NETMESH_OK) continue;
        const Truth truth = truth_of(cloud, rounded(bars_of_cells(cloud), false));
        if (!compare("as it came", answer, truth).empty()) continue;
        ++sound;
        for (int kind = 0; kind < kinds; ++kind) {
            Answer wrong = answer;
            if (!spoil(random, kind, &wrong)) continue;
            ++planted[kind];
            if (!compare("planted", wrong, truth).empty()) continue;
            ++missed;
            std::printf("missed: an error of kind %d\n", kind);
        }
    }
    const int hidden = plant_hidden(block, &missed);
    int all = 0, kinds_seen = 0;
    for (const int count : planted) {
        all += count;
        kinds_seen += count > 0;
    }
    std::printf("%d errors of %d kinds planted in %d answers, and %d in lists of hidden points, %d missed\n", all,
                kinds_seen, sound, hidden, missed);
    return sound < 60 || hidden < 60 || kinds_seen < kinds || missed > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t clouds = 400, in_space = 4;
    std::uint64_t seed = 1;
    const Block block;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--plant") return plant(block) + plant_in_cycles(block);
        if (word == "--clouds" && i + 1 < argc) {
            clouds = std::strtoull(argv[++i], nullptr, 10);
        } else if (word == "--seed" && i + 1 < argc) {
            seed = std::strtoull(argv[++i], nullptr, 10);
        } else if (word == "--in-space" && i + 1 < argc) {
            in_space = std::strtoull(argv[++i], nullptr, 10);
        } else {
            std::fprintf(stderr, "periods [--clouds N] [--seed S] [--in-space POINTS] | --plant\n");
            return 2;
        }
    }
    Seen seen;
    seen.faults = judge_named(block) + judge_found(block, &seen) + judge_many(block, seed, clouds / 4) +
                  judge_long(block, seed, clouds / 10);
    for (std::size_t i = 0; i < clouds && seen.faults < 5; ++i) {
        Random random(seed * 0x9E3779B97F4A7C15u + i);
        const Cloud cloud = make_cloud_of(random, i, in_space);
        const std::string fault = judge(block, random, i, cloud, &seen);
        if (fault.empty()) continue;
        ++seen.faults;
        std::printf("cloud %zu: %s\n", i, fault.c_str());
        print_cloud(cloud);
    }
    std::printf(
        "%zu clouds: %zu bars equal to the last bit, %zu cycles, %zu changes; %zu clouds with weights, %zu with fewer "
        "periods, %zu duplicates, %zu without a cell, %zu flat; %zu with long digits, moved by %g of their reach; "
        "%zu faults\n",
        seen.clouds, seen.bars, seen.cycles, seen.more, seen.weighted, seen.open, seen.duplicates, seen.hidden,
        seen.flat, seen.moved, seen.farthest, seen.faults);
    return seen.faults > 0 || seen.clouds == 0 ? 1 : 0;
}
