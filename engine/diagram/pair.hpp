// Points of a persistence diagram.
#pragma once
#include <cstdint>

namespace netmesh {

struct Pair {
    double birth, death;  // radii; death is +infinity for an essential class
    std::uint32_t degree;
    std::uint32_t cycle;  // where a representative is kept (homology/cycles.hpp), 0 without one
};

// The canonical order: degree, birth, death.
inline bool before(const Pair& a, const Pair& b) {
    if (a.degree != b.degree) return a.degree < b.degree;
    if (a.birth != b.birth) return a.birth < b.birth;
    return a.death < b.death;
}

}  // namespace netmesh
