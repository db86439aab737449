// Alpha diagrams of points with weights against rationals (truth.hpp), births and deaths bit for bit, on clouds of 1 to
// 9 points of all families of tests/exact/families.hpp, D = 2 to 5, as radii and as weights: values as signed roots and
// as powers; which points are hidden, and which are merged; the triangulation, cell by cell; rows in another order.
//
//   weights [--clouds N] [--seed S]    N clouds, or a slice
//   weights --plant                    errors planted in what came, which have to be seen
//
// Ends with 1 on a difference, after the cloud in hexadecimal.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "judge.hpp"

namespace {

using namespace weights;

// Largest difference of coordinates.
double extent_of(const Cloud& cloud) {
    double extent = 0;
    const std::size_t d = static_cast<std::size_t>(cloud.dim);
    for (std::size_t i = d; i < cloud.x.size(); ++i) extent = std::max(extent, std::fabs(cloud.x[i] - cloud.x[i % d]));
    return extent > 0 && extent < 1e150 ? extent : 1;
}

constexpr int kinds = 11;

// A weight for each point. All operations are those of doubles alone, so a seed gives the same everywhere.
void weigh(families::Random& random, int kind, Cloud* cloud) {
    const std::size_t d = static_cast<std::size_t>(cloud->dim);
    const double extent = extent_of(*cloud), equal = random.uniform(0, 2);
    cloud->numbers.clear();
    for (std::size_t i = 0; i < cloud->x.size() / d; ++i) {
        double square = 0;
        for (std::size_t c = 0; c < d; ++c) square += cloud->x[i * d + c] * cloud->x[i * d + c];
        double w = 0;
        const double area = extent * extent;
        switch (kind) {
        case 0: break;                                     // none
        case 1: w = equal * area; break;                   // all equal
        case 2: w = 0.1 * area * random.uniform(); break;  // a few hidden
        case 3: w = area * random.uniform(); break;        // many hidden
        case 4: w = area * random.uniform(-1, 1); break;   // of both signs
        case 5: w = random.one_in(5) ? 1e6 * area : area * random.uniform(); break;
        case 6: w = square; break;  // all lifts are near 0
        case 7: w = square + random.whole(-1, 1); break;
        case 8: w = families::moved(area, random.whole(-3, 3)); break;  // nearly equal
        case 9: w = area * random.whole(0, 3); break;                   // ties
        default: w = 1e-20 * area * random.uniform(); break;
        }
        if (!(std::fabs(w) < 1e300)) w = 1;
        if (kind != 4 && kind != 7) w = std::fabs(w);
        cloud->numbers.push_back(cloud->are_radii ? std::sqrt(std::fabs(w)) : w);
    }
    if (kind == 6 && random.one_in(2))
        for (double& number : cloud->numbers) number = number != 0 ? families::moved(number, random.whole(-2, 2)) : 0;
}

Cloud make_cloud(families::Random& random, std::size_t number) {
    const std::vector<families::Family>& all = families::all();
    Cloud cloud;
    cloud.dim = 2 + static_cast<int>(number % 4);
    const std::size_t n = static_cast<std::size_t>(random.whole(random.one_in(10) ? 1 : cloud.dim + 1, 9));
    cloud.x = all[number / 4 % all.size()].make(random, cloud.dim, n);
    const std::size_t d = static_cast<std::size_t>(cloud.dim);
    if (cloud.x.size() > 9 * d) cloud.x.resize(9 * d);
    if (random.one_in(6) && cloud.x.size() > d)  // a point twice
        for (std::size_t c = 0; c < d; ++c) cloud.x[c] = cloud.x[cloud.x.size() - d + c];
    // Points between others, which these can hide.
    const std::size_t rows = cloud.x.size() / d, between = random.one_in(2) && rows > d + 1 ? rows - d - 1 : 0;
    for (std::size_t i = rows - between; i < rows; ++i) {
        const std::size_t one = random.bits() % (d + 1), two = random.bits() % (d + 1), three = random.bits() % (d + 1);
        for (std::size_t c = 0; c < d; ++c)
            cloud.x[i * d + c] = cloud.x[one * d + c] / 4 + cloud.x[two * d + c] / 4 + cloud.x[three * d + c] / 2;
    }
    cloud.are_radii = random.one_in(2);
    weigh(random, static_cast<int>(random.bits() % kinds), &cloud);
    return cloud;
}

// What came is changed in one place each time; compare has to say so.
int plant(const Block& block) {
    families::Random random(5);
    int planted = 0, missed = 0;
    for (std::size_t i = 0; planted < 300 && i < 3000; ++i) {
        const Cloud cloud = make_cloud(random, i);
        const Truth truth(cloud.dim, cloud.x, cloud.numbers, cloud.are_radii);
        const Answer answer = ask(block, cloud, false);
        if (answer.status != NETMESH_OK) continue;
        const Bars bars = truth.bars(false);
        for (int kind = 0; kind < 6; ++kind) {
            Answer wrong = answer;
            const std::size_t at = random.bits() % wrong.bars.size();
            if (kind == 0) wrong.bars[at].birth = families::moved(wrong.bars[at].birth, 1);
            if (kind == 1) wrong.bars.erase(wrong.bars.begin() + static_cast<std::ptrdiff_t>(at));
            if (kind == 2) wrong.bars.push_back(wrong.bars[at]);
            if (kind == 3) wrong.hidden.push_back(0);
            if (kind == 4) ++wrong.duplicates;
            if (kind == 5) --wrong.distinct;
            ++planted;
            missed += compare("planted", wrong, truth, bars).empty();
        }
    }
    std::printf("%d errors planted, %d missed\n", planted, missed);
    return planted < 300 || missed > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t clouds = 440;
    std::uint64_t seed = 1;
    const Block block;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--plant") return plant(block);
        if (word == "--clouds" && i + 1 < argc) {
            clouds = std::strtoull(argv[++i], nullptr, 10);
        } else if (word == "--seed" && i + 1 < argc) {
            seed = std::strtoull(argv[++i], nullptr, 10);
        } else {
            std::fprintf(stderr, "weights [--clouds N] [--seed S] | --plant\n");
            return 2;
        }
    }
    Seen seen;
    for (std::size_t i = 0; i < clouds && seen.faults < 5; ++i) {
        families::Random random(seed * 0x9E3779B97F4A7C15u + i);
        const Cloud cloud = make_cloud(random, i);
        const std::string fault = judge(block, random, cloud, &seen);
        if (fault.empty()) continue;
        ++seen.faults;
        std::printf("cloud %zu, family %s: %s\n", i, families::all()[i / 4 % families::all().size()].name,
                    fault.c_str());
        print_cloud(cloud);
    }
    std::printf(
        "%zu clouds: %zu bars equal to the last bit; %zu hidden points in %zu clouds, %zu merged; %zu flat, %zu out "
        "of range; %zu faults\n",
        seen.clouds, seen.bars, seen.hidden, seen.with_hidden, seen.duplicates, seen.flat, seen.range, seen.faults);
    return seen.faults > 0 || seen.clouds == 0 ? 1 : 0;
}
