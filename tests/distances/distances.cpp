// Distances of diagrams against exact answers in whole numbers without bound.
//
//   distances                   a slice of all that follows
//   distances small [COUNT]     pairs of up to nine bars, each in orders 1, 2 and 3 and in both scales: 20,000
//   distances large [COUNT [BARS]]
//                               pairs of a thousand bars, each in one order: 500. The matching and the potentials that
//                               come with a distance are its proof, which is looked at without rounding.
//   distances planted           answers that are wrong, each of which must be refused
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "common/exact_distance.hpp"
#include "common/wasserstein.hpp"

namespace {

using exact::Bars;
using exact::Ratio;
using Random = std::mt19937_64;

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double least_double = std::numeric_limits<double>::denorm_min();
long failures = 0;

void fail(const std::string& where, const char* what) {
    if (++failures <= 20) std::printf("%s: %s\n", where.c_str(), what);
}
void print(const Bars& bars) {
    for (const netmesh_pair& p : bars) std::printf("    {%u, %a, %a},\n", p.degree, p.birth, p.death);
    std::printf("    --\n");
}

// ---- pairs of diagrams

double unit(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }
std::size_t below(Random& random, std::size_t n) { return static_cast<std::size_t>(random() % n); }

constexpr const char* families[] = {"shifted chain", "equal bars",   "ties with the diagonal", "lengths of 12 orders",
                                    "last place",    "random",       "ends of the doubles",    "many kinds",
                                    "nearly equal",  "line of steps"};
constexpr std::size_t family_count = sizeof families / sizeof *families;

netmesh_pair made(double birth, double death, std::uint32_t degree = 0) {
    return bar(degree, std::min(birth, death), std::max(birth, death));
}

void make_pair(Random& random, std::size_t family, std::size_t most, bool full, Bars* a, Bars* b) {
    a->clear();
    b->clear();
    const std::size_t n = full ? most : below(random, most + 1), m = full ? most : below(random, most + 1);
    switch (family) {
    case 0: {  // all born together; the second lacks a bar, or is moved a little: shifting all by one may be cheapest
        const double birth = static_cast<double>(below(random, 3)),
                     spread = std::ldexp(1, -static_cast<int>(below(random, 8)));
        for (std::size_t i = 0; i < std::max<std::size_t>(n, 1); ++i)
            a->push_back(made(birth, birth + 0.05 + spread * unit(random)));
        *b = *a;
        const std::size_t gone =
            below(random, 2) == 0
                ? static_cast<std::size_t>(
                      std::max_element(b->begin(), b->end(), [](auto& x, auto& y) { return x.death < y.death; }) -
                      b->begin())
                : below(random, b->size());
        b->erase(b->begin() + static_cast<std::ptrdiff_t>(gone));
        if (below(random, 3) == 0)
            for (netmesh_pair& p : *b) p.death += 1e-6 * unit(random);
        break;
    }
    case 1: {  // few different bars
        const netmesh_pair kinds[] = {made(1, 3), made(1, 2 + unit(random)), made(unit(random), 4)};
        for (std::size_t i = 0; i < n; ++i) a->push_back(kinds[below(random, 3)]);
        for (std::size_t j = 0; j < m; ++j) b->push_back(kinds[below(random, 3)]);
        break;
    }
    case 2:  // on a small grid: ways to the diagonal are as far as ways to other bars
        for (std::size_t i = 0; i < n; ++i) {
            const double birth = static_cast<double>(below(random, 4));
            a->push_back(made(birth, birth + static_cast<double>(below(random, 4))));
        }
        for (std::size_t j = 0; j < m; ++j) {
            const double birth = static_cast<double>(below(random, 4));
            b->push_back(made(birth, birth + static_cast<double>(below(random, 4))));
        }
        break;
    case 3:  // lengths over twelve orders of size, many moved by a little
        for (std::size_t i = 0; i < n; ++i) {
            const double birth = unit(random), length = std::pow(10, -12 * unit(random));
            a->push_back(made(birth, birth + length));
            if (b->size() < m && below(random, 2) == 0)
                b->push_back(made(birth, birth + length * (1 + 1e-3 * unit(random))));
        }
        while (b->size() < m) {
            const double birth = unit(random);
            b->push_back(made(birth, birth + std::pow(10, -12 * unit(random))));
        }
        break;
    case 4: {  // some units in the last place apart
        const double base = 1 + unit(random);
        const auto near = [&] { return base + std::ldexp(static_cast<double>(below(random, 8)), -52); };
        for (std::size_t i = 0; i < n; ++i)
            a->push_back(below(random, 3) == 0 ? made(near(), 1.5 * near()) : made(near(), near()));
        for (std::size_t j = 0; j < m; ++j)
            b->push_back(below(random, 3) == 0 ? made(near(), 1.5 * near()) : made(near(), near()));
        break;
    }
    case 5:
        for (std::size_t i = 0; i < n; ++i) a->push_back(made(unit(random), unit(random)));
        for (std::size_t j = 0; j < m; ++j) b->push_back(made(unit(random), unit(random)));
        break;
    case 6: {  // any exponents; differences that overflow; multiples of the least double
        const auto any = [&]() -> double {
            const double most_double = std::numeric_limits<double>::max();
            switch (below(random, 5)) {
            case 0: return std::ldexp(unit(random), static_cast<int>(below(random, 2098)) - 1074);
            case 1: return static_cast<double>(below(random, 6)) * least_double;
            case 2: return most_double * (below(random, 2) == 0 ? 1 : unit(random));
            default: return std::ldexp(unit(random), static_cast<int>(below(random, 40)) - 20);
            }
        };
        const bool signs = below(random, 2) == 0, tiny = below(random, 3) == 0;
        const auto put = [&](Bars* bars, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) {
                double x = any(), y = any();
                if (tiny)
                    x = static_cast<double>(below(random, 9)) * least_double,
                    y = static_cast<double>(below(random, 9)) * least_double;
                bars->push_back(made(signs && below(random, 2) == 0 ? -x : x, signs && below(random, 2) == 0 ? -y : y));
            }
        };
        put(a, n);
        put(b, m);
        break;
    }
    case 7: {  // degrees, bars without an end, of length 0, born at 0
        const auto put = [&](Bars* bars, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) {
                const double birth = below(random, 4) == 0 ? 0 : std::floor(8 * unit(random)) / 4;
                const std::size_t kind = below(random, 4);
                const auto degree = static_cast<std::uint32_t>(below(random, 2));
                bars->push_back(made(birth, kind == 0 ? birth : birth + unit(random), degree));
            }
            for (std::uint32_t k = 0; k < 2; ++k)
                for (std::size_t i = 0; i < 2 + (below(random, 40) == 0 ? 1u : 0u); ++i)
                    bars->push_back(bar(k, unit(random) + (below(random, 30) == 0 ? -1 : 0.01), forever));
        };
        put(a, n);
        put(b, m);
        break;
    }
    case 8:  // the same but for the last digits, in another order
        for (std::size_t i = 0; i < n; ++i) {
            const double birth = unit(random), length = unit(random);
            a->push_back(made(birth, birth + length));
            b->push_back(made(birth, birth + length * (1 + 1e-12 * static_cast<double>(below(random, 3)))));
        }
        std::shuffle(b->begin(), b->end(), random);
        break;
    default: {  // one step apart from one another, and the second diagram half a step on, or a third
        const double step = 1 + unit(random), on = step / static_cast<double>(2 + below(random, 2));
        for (std::size_t i = 0; i < n; ++i) a->push_back(made(0, 3 + step * static_cast<double>(i)));
        for (std::size_t j = 0; j < m; ++j) b->push_back(made(0, 3 + on + step * static_cast<double>(j)));
        break;
    }
    }
}

// ---- small diagrams

void compare_small(long count) {
    Random random(1);
    long sizes[2] = {0, 0};
    for (long trial = 0; trial < count; ++trial) {
        const std::size_t family = static_cast<std::size_t>(trial) % family_count;
        Bars a, b;
        make_pair(random, family, family == 7 ? 5 : 9, false, &a, &b);
        const double errors[] = {0.5, 0.1, 0.001, 1e-6, 0x1p-30};
        const std::size_t which = below(random, 4);
        const auto degree = which < 2 ? static_cast<std::uint32_t>(which) : NETMESH_ALL_DEGREES;
        const long before = failures;
        const std::string where = std::string(families[family]) + ", pair " + std::to_string(trial);
        for (std::uint32_t order = 1; order <= 3; ++order) {
            const double error = errors[below(random, 5)];
            const exact::TransportSum truth = exact::least_transport(a, b, order, degree);
            const Transport found = wasserstein(wasserstein_request(a, b, order, error, degree));
            const char* fault = found.status != NETMESH_OK
                                    ? netmesh_status_text(found.status)
                                    : exact::fault_of_bounds(truth, order, found.lower, found.value, error);
            if (fault != nullptr) {
                fail(where + ", order " + std::to_string(order) + ", error " + std::to_string(error), fault);
                std::printf("    from %a to %a, is %.17g\n", found.lower, found.value,
                            std::pow(truth.sum.get_d(), 1.0 / order));
            }
            ++sizes[0];
        }
        for (const bool log : {false, true}) {
            bool has_logarithms = true;
            for (const Bars* bars : {&a, &b})
                for (const netmesh_pair& p : *bars) has_logarithms = has_logarithms && p.birth >= 0;
            if (log && !has_logarithms) continue;
            const Distance found = bottleneck(a, b, log ? NETMESH_SCALE_LOG : NETMESH_SCALE_PLAIN, degree);
            if (found.status != NETMESH_OK ||
                !exact::is_bottleneck(exact::least_bottleneck(a, b, log, degree), log, found.value, found.exponent)) {
                fail(where + (log ? ", log" : ", plain"), "not the exact bottleneck distance, rounded once");
            }
            ++sizes[1];
        }
        if (failures > before && failures < 6) print(a), print(b);
    }
    std::printf("%ld pairs of small diagrams: %ld Wasserstein and %ld bottleneck distances\n", count, sizes[0],
                sizes[1]);
}

// ---- large diagrams

using exact::Proof;

Transport with_proof(const Bars& a, const Bars& b, std::uint32_t order, double error, Proof* proof) {
    proof->mates.resize(a.size());
    proof->f.resize(a.size());
    proof->g.resize(b.size());
    netmesh_wasserstein_request request = wasserstein_request(a, b, order, error, 0);
    request.mates_a = proof->mates.data();
    request.potentials_a = proof->f.data();
    request.potentials_b = proof->g.data();
    return wasserstein(request);
}

void compare_large(long count, std::size_t bars) {
    Random random(2);
    double slowest = 0;
    std::string slowest_name;
    for (long trial = 0; trial < count; ++trial) {
        std::size_t family = static_cast<std::size_t>(trial) % 8;
        if (family >= 6) family += 2;  // neither ends of the doubles nor many kinds
        Bars a, b;
        make_pair(random, family, bars, true, &a, &b);
        const double errors[] = {0.1, 0.001, 1e-6, 0x1p-30};
        const double error = errors[below(random, 4)];
        const auto order = static_cast<std::uint32_t>(1 + below(random, 3));
        Proof proof;
        const auto start = std::chrono::steady_clock::now();
        const Transport found = with_proof(a, b, order, error, &proof);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        if (seconds.count() > slowest) {
            slowest = seconds.count();
            slowest_name = std::string(families[family]) + ", pair " + std::to_string(trial) + ", order " +
                           std::to_string(order) + ", error " + std::to_string(error);
        }
        const char* fault = found.status != NETMESH_OK ? netmesh_status_text(found.status) : nullptr;
        if (fault == nullptr) fault = exact::fault_of_width(found.lower, found.value, error);
        if (fault == nullptr)
            fault = exact::fault_of_proof(a, b, order, 0, {found.lower, found.value, found.exponent}, proof);
        if (fault != nullptr)
            fail(std::string(families[family]) + ", large pair " + std::to_string(trial) + ", order " +
                     std::to_string(order) + ", error " + std::to_string(error),
                 fault);
    }
    std::printf("%ld pairs of %zu bars, the slowest in %.2f s: %s\n", count, bars, slowest, slowest_name.c_str());
}

// ---- wrong answers

long accepted = 0;
void refused(const char* fault, const char* what) {
    if (fault == nullptr) ++accepted, std::printf("accepted: %s\n", what);
}
void refused(bool is_right, const char* what) { refused(is_right ? nullptr : "wrong", what); }

void plant() {
    const Bars a = {bar(0, 0, 4), bar(0, 0, 2), bar(1, 0, 1)}, b = {bar(0, 0, 3)};
    const exact::TransportSum truth = exact::least_transport(a, b, 2, 0);  // 1 + 1
    if (truth.sum != 2) ++accepted, std::printf("the exact sum is wrong\n");
    const double root = std::sqrt(2.0), up = std::nextafter(root, 2), down = std::nextafter(root, 1);
    const double below_root = root * root < 2 ? root : down, above_root = root * root < 2 ? up : root;
    if (exact::fault_of_bounds(truth, 2, down, up, 0x1p-30) != nullptr)
        ++accepted, std::printf("the truth is refused\n");
    refused(exact::fault_of_bounds(truth, 2, 1, below_root, 1), "an upper bound a unit in the last place too low");
    refused(exact::fault_of_bounds(truth, 2, above_root, 2, 1), "a lower bound a unit in the last place too high");
    refused(exact::fault_of_bounds(truth, 2, 1, root + 0.1, 0.5), "bounds farther apart than the error");
    refused(exact::fault_of_bounds(truth, 2, 0, up, 1e300), "no lower bound");
    refused(exact::fault_of_bounds(truth, 2, forever, forever, 1), "infinity");
    refused(exact::fault_of_bounds(truth, 2, std::nan(""), up, 1), "no number");
    refused(exact::fault_of_bounds(exact::least_transport({}, {bar(0, 1, forever)}, 1, 0), 1, 0, forever, 1),
            "half infinite");

    Proof good;
    const Bars one = {bar(0, 0, 4), bar(0, 0, 2)};
    const Transport found = with_proof(one, b, 2, 0.001, &good);
    if (exact::fault_of_proof(one, b, 2, 0, {found.lower, found.value, found.exponent}, good) != nullptr)
        ++accepted, std::printf("the proof is refused\n");
    for (int k = 0; k < 5; ++k) {
        Proof bad = good;
        Transport said = found;
        const char* what = "";
        switch (k) {
        case 0: bad.mates[1] = 0, what = "two bars with one mate"; break;
        case 1: bad.mates[0] = NETMESH_NONE, what = "another matching"; break;
        case 2:
            bad.f[0] = std::nextafter(bad.f[0] + std::fabs(bad.f[0]) * 0.01, forever), what = "a potential raised";
            break;
        case 3: bad.g[0] -= 0.1, what = "a potential that proves less"; break;
        default: said.value = std::nextafter(1.4, 0), what = "less than the matching costs"; break;
        }
        refused(exact::fault_of_proof(one, b, 2, 0, {said.lower, said.value, said.exponent}, bad), what);
    }

    const auto third = exact::least_bottleneck({bar(0, 3, 7)}, {}, true, 0);  // the root of 7 / 3
    const double ratio = std::sqrt(7.0 / 3);
    int right = 0;
    for (int k = -2; k <= 2; ++k) {
        double x = ratio;
        for (int i = 0; i < std::abs(k); ++i) x = std::nextafter(x, k < 0 ? 0 : 9);
        right += exact::is_bottleneck(third, true, x, 0) ? 1 : 0;
    }
    refused(right != 1, "two neighbours as the nearest of a root");
    const auto half = exact::least_bottleneck({bar(0, 0, 3 * least_double)}, {}, false, 0);  // 3 / 2: the even one is 2
    refused(exact::is_bottleneck(half, false, least_double, 0), "the odd one of two");
    if (!exact::is_bottleneck(half, false, 2 * least_double, 0)) ++accepted, std::printf("the even one is refused\n");
    refused(exact::is_bottleneck(half, false, 3 * least_double, 0), "one more");
    refused(exact::is_bottleneck(half, false, forever, 0), "infinity");
}

}  // namespace

int main(int argc, char** argv) {
    const char* const what = argc > 1 ? argv[1] : "";
    const long count = argc > 2 ? std::atol(argv[2]) : 0;
    if (std::strcmp(what, "planted") == 0) {
        plant();
        std::printf("%ld wrong answers were accepted\n", accepted);
        return accepted == 0 ? 0 : 1;
    }
    const bool slice = *what == 0;
    if (slice || std::strcmp(what, "small") == 0) compare_small(count > 0 ? count : slice ? 600 : 20000);
    if (slice) compare_large(24, 150);
    if (std::strcmp(what, "large") == 0)
        compare_large(count > 0 ? count : 500, argc > 3 ? static_cast<std::size_t>(std::atol(argv[3])) : 1000);
    std::printf("%ld faults\n", failures);
    return failures == 0 ? 0 : 1;
}
