// Points of a persistence diagram.
#pragma once
#include <cstdint>

namespace netmesh {

struct Pair {
    double birth, death;   // radii; death is +infinity for an essential class
    std::uint32_t degree;
    std::uint32_t unused;  // 0, so that a pair has no padding
};

// The canonical order: degree, birth, death.
inline bool before(const Pair& a, const Pair& b) {
    if (a.degree != b.degree) return a.degree < b.degree;
    if (a.birth != b.birth) return a.birth < b.birth;
    return a.death < b.death;
}

}  // namespace netmesh
