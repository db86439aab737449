// Diagrams of a few points with weights, with periods or with both, bit for bit against definitions in rationals
// (tests/weights/truth.hpp, tests/periods/truth.hpp). Bytes become coordinates and weights of few values, neighbours in
// the last place and, without periods, of many scales. With periods all copies are doubles.
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "fuzz/decoder.hpp"
#include "tests/periods/judge.hpp"
#include "vocabulary/dimension.hpp"

namespace {

double finite(double x) { return std::isfinite(x) ? x : std::numeric_limits<double>::max(); }

// One that makes lifts equal, or nearly, now and then.
double weight_of(fuzz::Tape& tape, const double* x, int dim, bool is_radius) {
    const std::uint8_t how = tape.byte();
    double w = fuzz::coordinate(tape.byte());
    if (how % 4 == 1) {
        w = how >> 4;
        for (int c = 0; c < dim; ++c) w += x[c] * x[c];
    }
    if (how % 4 == 2) w = how >> 4;
    if (how % 4 == 3) w = std::nextafter(how >> 4, 100);
    w = finite(w);
    return !is_radius ? w : how % 4 == 1 ? std::sqrt(w) : std::fabs(w);
}

void judge_weights(fuzz::Tape& tape) {
    static const weights::Block block;
    weights::Cloud cloud;
    cloud.dim = 2 + static_cast<int>(tape.below(3));
    if (!netmesh::serves_dimension(static_cast<std::uint32_t>(cloud.dim))) return;
    const std::size_t n = 1 + tape.below(8), d = static_cast<std::size_t>(cloud.dim);
    cloud.are_radii = tape.below(2) != 0;
    const bool is_near = tape.below(4) != 0;
    for (std::size_t i = 0; i < n * d; ++i) {
        const std::uint8_t byte = tape.byte();
        cloud.x.push_back(is_near ? fuzz::coordinate(byte % 160) : finite(fuzz::coordinate(byte)));
    }
    for (std::size_t i = 0; i < n; ++i)
        cloud.numbers.push_back(weight_of(tape, &cloud.x[i * d], cloud.dim, cloud.are_radii));
    families::Random random(tape.byte());
    weights::Seen seen;
    const std::string fault = weights::judge(block, random, cloud, &seen);
    if (!fault.empty()) {
        std::printf("%s\n", fault.c_str());
        weights::print_cloud(cloud);
        std::fflush(stdout);
    }
    fuzz::require(fault.empty());
}

double small_whole(fuzz::Tape& tape, int most) {
    return static_cast<int>(tape.below(static_cast<std::uint32_t>(2 * most + 1))) - most;
}

// Whether a vector of the lattice is a sum of others.
bool depend(const periods::Cloud& cloud) {
    const std::size_t d = cloud.width(), m = cloud.periods();
    std::vector<periods::Row> products(m, periods::Row(m));
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < m; ++j)
            for (std::size_t c = 0; c < d; ++c)
                products[i][j] += mpq_class(cloud.lattice[i * d + c]) * mpq_class(cloud.lattice[j * d + c]);
    return !periods::eliminate(&products);
}

void judge_periods(fuzz::Tape& tape) {
    static const weights::Block block;
    periods::Cloud cloud;
    cloud.dim = 2 + static_cast<int>(tape.below(2));
    const std::size_t d = cloud.width(), n = 1 + tape.below(d == 2 ? 6 : 3);
    const std::size_t count = tape.below(3) != 0 ? d : 1 + tape.below(static_cast<std::uint32_t>(d));
    const std::uint8_t how = tape.byte();
    for (std::size_t j = 0; j < count; ++j)
        for (std::size_t k = 0; k < d; ++k)
            cloud.lattice.push_back((j == k ? 1 + tape.below(6) : 0) +
                                    (how & 1 ? small_whole(tape, how & 2 ? 4 : 1) : 0));
    for (std::size_t i = 0; i < n * d; ++i) {
        const double x = small_whole(tape, 6);
        cloud.x.push_back(how & 4 ? x / 4 : how & 8 ? x + std::ldexp(small_whole(tape, 2), -20) : x);
    }
    cloud.are_radii = (how & 16) != 0;
    if (how & 32)
        for (std::size_t i = 0; i < n; ++i)
            cloud.numbers.push_back(cloud.are_radii ? tape.below(24) / 8.0 : small_whole(tape, how & 64 ? 2 : 20) / 2);
    const periods::Answer answer = ask(block, cloud);
    const bool is_flat = periods::is_flat(cloud), are_dependent = depend(cloud);
    if (answer.status == NETMESH_INVALID_ARGUMENT) fuzz::require(are_dependent);
    if (answer.status == NETMESH_FLAT) fuzz::require(is_flat);
    if (are_dependent || is_flat) {
        fuzz::require(answer.status != NETMESH_OK);
        return;
    }
    const periods::ExactBars exact = bars_of_cells(cloud);
    std::string fault = compare("radii", answer, truth_of(cloud, rounded(exact, false)));
    if (fault.empty() && !cloud.numbers.empty()) {
        periods::Wish wish;
        wish.squares = true;
        fault = compare("powers", ask(block, cloud, wish), truth_of(cloud, rounded(exact, true)));
    }
    if (!fault.empty()) {
        std::printf("%s\n", fault.c_str());
        print_cloud(cloud);
        std::fflush(stdout);
    }
    fuzz::require(fault.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Tape tape(data, size);
    tape.byte() % 2 == 0 ? judge_weights(tape) : judge_periods(tape);
    return 0;
}
