// Fingerprints of results: a 64-bit hash of values, not of bytes in memory, so that it is the same on every platform.
#pragma once
#include <cstdint>

#include "numerics/bits.hpp"
#include "numerics/random.hpp"

namespace netmesh {

class Fingerprint {
public:
    void add(std::uint64_t word) { state_ = mix64(state_ ^ word) + 0x632BE59BD9B4E019u * word; }
    void add(double x) { add(bits_of(x == 0 ? 0.0 : x)); }
    std::uint64_t value() const { return mix64(state_); }

private:
    std::uint64_t state_ = 0x6E65746D65736800u;
};

}  // namespace netmesh
