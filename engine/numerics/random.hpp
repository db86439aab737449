// Deterministic mixing: the same numbers on every platform.
#pragma once
#include <cstdint>

namespace netmesh {

// A bijection of 64-bit words whose output bits all depend on all input bits (splitmix64's finaliser).
constexpr std::uint64_t mix64(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

}  // namespace netmesh
