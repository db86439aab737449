// Diagrams to their bottleneck distance, in both scales, and to their Wasserstein distance with its matching and its
// potentials, against exact ones. The scratch memory is allocated at the size that was asked for.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/exact_distance.hpp"
#include "common/wasserstein.hpp"
#include "fuzz/decoder.hpp"

namespace {

using exact::Bars;
using fuzz::require;

// Differences of them overflow, or are a few of the least double.
double extreme(std::uint8_t byte) {
    const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
    switch (byte >> 6) {
    case 0: return least * (byte & 63);
    case 1: return -least * (byte & 63);
    case 2: return most / (1 + (byte & 63));
    default: return -most / (1 + (byte & 63));
    }
}

Bars decode_diagram(fuzz::Tape& tape, bool log, const Bars& other) {
    Bars result;
    const std::uint32_t how_many = tape.byte(), count = how_many % 8;
    if ((how_many & 64) != 0) result = other;  // and what follows
    if ((how_many & 128) != 0 && !result.empty()) result.erase(result.begin() + (how_many >> 3) % 8 % result.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint8_t how = tape.byte();
        netmesh_pair p = bar(how & 1u, 0, 0);
        switch (how % 8) {
        case 7:  // neighbours in the last place, of few values
            p.birth = 1 + std::ldexp(how >> 4, -52);
            p.death = p.birth * (1 + (how & 16));
            break;
        case 6:  // born together
            p.birth = 1;
            p.death = 1 + (1 + tape.byte()) * 0.01;
            break;
        case 5:
            p.birth = extreme(tape.byte());
            p.death = extreme(tape.byte());
            break;
        case 4:  // a bar once more, a little longer or not
            if (!other.empty() && tape.left() > 0) p = other[tape.byte() % other.size()];
            if (!std::isinf(p.death)) p.death += std::fabs(p.death) * std::ldexp(how >> 4, -20);
            if (std::isinf(p.death)) p.death = p.birth;
            break;
        default:
            p.birth = fuzz::coordinate(tape.byte());
            p.death = fuzz::coordinate(tape.byte());
            break;
        }
        if (log) p.birth = std::fabs(p.birth), p.death = std::fabs(p.death);
        if (p.death < p.birth) std::swap(p.birth, p.death);
        if (how >> 5 == 7) p.death = std::numeric_limits<double>::infinity();
        result.push_back(p);
    }
    return Bars(result);
}

void check_bottleneck(const Bars& a, const Bars& b, bool log, std::uint32_t degree) {
    const netmesh_scale scale = log ? NETMESH_SCALE_LOG : NETMESH_SCALE_PLAIN;
    const Distance found = bottleneck(a, b, scale, degree), turned = bottleneck(b, a, scale, degree);
    require(found.status == NETMESH_OK && turned.status == NETMESH_OK);
    require(found.value == turned.value && found.exponent == turned.exponent);
    require(exact::is_bottleneck(exact::least_bottleneck(a, b, log, degree), log, found.value, found.exponent));
}

void check_wasserstein(const Bars& a, const Bars& b, std::uint32_t degree, std::uint32_t order, double error) {
    const exact::TransportSum truth = exact::least_transport(a, b, order, degree);
    netmesh_wasserstein_request request = wasserstein_request(a, b, order, error, degree);
    exact::Proof proof = {std::vector<std::uint32_t>(a.size()), std::vector<double>(a.size()),
                          std::vector<double>(b.size())};
    if (degree != NETMESH_ALL_DEGREES) {
        request.mates_a = proof.mates.data();
        request.potentials_a = proof.f.data();
        request.potentials_b = proof.g.data();
    }
    const Transport found = wasserstein(request);
    require(found.status == NETMESH_OK);
    require(exact::fault_of_bounds(truth, order, found.lower, found.value, error) == nullptr);
    if (degree == NETMESH_ALL_DEGREES || std::isinf(found.lower)) return;
    require(exact::fault_of_proof(a, b, order, degree, {found.lower, found.value, found.exponent}, proof) == nullptr);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Tape tape(data, size);
    const bool log = (tape.byte() & 1) != 0;
    const std::uint32_t choice = tape.below(4), degree = choice < 2 ? choice : NETMESH_ALL_DEGREES;
    Bars a = decode_diagram(tape, log, {});
    const Bars b = decode_diagram(tape, log, a);
    const std::uint32_t which = tape.byte(), order = 1 + (which < 224 ? which % 3 : which % NETMESH_ORDER_MAX);
    const double errors[] = {0.01, 0.5, 1e-6, 0x1p-30, 100};
    check_bottleneck(a, b, log, degree);
    check_wasserstein(a, b, degree, order, errors[tape.below(5)]);

    // What is no diagram is refused.
    if (!a.empty()) {
        netmesh_pair& p = a[tape.below(static_cast<std::uint32_t>(a.size()))];
        switch (tape.below(4)) {
        case 0: p.birth = std::numeric_limits<double>::quiet_NaN(); break;
        case 1: p.death = std::numeric_limits<double>::quiet_NaN(); break;
        case 2: p.birth = std::numeric_limits<double>::infinity(); break;
        default: p.death = std::nextafter(p.birth, -std::numeric_limits<double>::infinity()); break;
        }
        require(bottleneck(a, b, log ? NETMESH_SCALE_LOG : NETMESH_SCALE_PLAIN).status == NETMESH_INVALID_ARGUMENT);
        require(wasserstein(wasserstein_request(a, b, order, 0.5)).status == NETMESH_INVALID_ARGUMENT);
    }
    return 0;
}
