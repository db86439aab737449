// The sampler's random numbers: the same from one seed everywhere.
#pragma once
#include <cstdint>

namespace netmesh::tool {

// xoshiro256++ (Blackman and Vigna), its state filled by splitmix64.
class Random {
public:
    explicit Random(std::uint64_t seed);
    std::uint64_t bits();
    // In [0, 1), a multiple of 2^-53.
    double uniform();
    // Mean 0, standard deviation 1.
    double normal();

private:
    std::uint64_t state_[4];
};

}  // namespace netmesh::tool
