// Diagrams of 1 to 9 points that are promised to be exact, bit for bit against brute force in integers
// (tests/exact/jobs.hpp). Bytes become coordinates that differ in the last digits, points on a sphere as doubles
// compute them, or any doubles; whole sets also at both ends of the range.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <vector>

#include "fuzz/decoder.hpp"
#include "tests/exact/jobs.hpp"

namespace {

double finite(double x) {
    return std::isfinite(x)  ? x
           : std::signbit(x) ? std::numeric_limits<double>::lowest()
                             : std::numeric_limits<double>::max();
}

// Eight bytes, the lowest first.
double any_double(fuzz::Tape& tape) {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= static_cast<std::uint64_t>(tape.byte()) << 8 * i;
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return finite(x);
}

// A number with all of its digits.
double base_value(std::uint8_t byte) {
    static const double sizes[] = {1, 0.1, 13.41, 100.105, 1.0 / 3, 0x1.6a09e667f3bcdp-1, 1e8, 2};
    return sizes[byte & 7] * (1 + (byte >> 3 & 3)) / (byte >> 5 != 0 ? byte >> 5 : 1);
}

std::vector<double> decode_points(fuzz::Tape& tape, int dim, std::size_t n, std::uint8_t style) {
    std::vector<double> x;
    double base[4];
    if (style % 3 != 0)
        for (double& b : base) b = base_value(tape.byte());
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> row(static_cast<std::size_t>(dim));
        if (style % 3 == 0) {
            for (double& c : row) c = any_double(tape);
        } else if (style % 3 == 1) {  // one of the base values and 0 to 7 units, or its negative
            for (double& c : row) {
                const std::uint8_t byte = tape.byte();
                c = base[byte >> 3 & 3];
                for (int units = byte & 7; units > 0; --units) c = std::nextafter(c, HUGE_VAL);
                if ((byte & 0x20) != 0) c = -c;
                if ((byte & 0xC0) == 0xC0) c = 0;
            }
        } else {
            double square = 0;
            for (double& c : row) {
                c = static_cast<double>(tape.byte()) - 128;
                square += c * c;
            }
            for (double& c : row) c = base[1] + base[0] * (square > 0 ? c / std::sqrt(square) : 0);
        }
        x.insert(x.end(), row.begin(), row.end());
    }
    if (style >= 192) {
        const int power = 8 * (static_cast<int>(tape.byte()) - 128);
        for (double& c : x) c = finite(std::ldexp(c, power));
    }
    return x;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const exact::Block block;
    fuzz::Tape tape(data, size);
    const int dim = 2 + static_cast<int>(tape.below(4));
    const std::size_t n = 1 + tape.below(9);
    const std::uint8_t how = tape.byte(), style = tape.byte();
    if (!exact::is_served(dim)) return 0;
    exact::Plan plan;
    plan.rips_degree = 1 + how % 3;
    plan.k = 1 + how / 3 % 3;
    plan.permutation = how;
    exact::set_nested_degree(dim, n, 1, &plan);
    const std::vector<double> x = decode_points(tape, dim, n, style);
    exact::Count counts[exact::jobs];
    const std::vector<exact::Finding> found = exact::judge(block, dim, x, plan, counts);
    for (const exact::Finding& finding : found)
        std::printf("%s: %s\n", exact::name_of(finding.job), finding.what.c_str());
    if (!found.empty()) {
        exact::print_cloud(dim, x);
        std::fflush(stdout);
    }
    fuzz::require(found.empty());
    return 0;
}
