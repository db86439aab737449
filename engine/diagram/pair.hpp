// Points of a persistence diagram, lists of them and their canonical order.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct Pair {
    double birth, death;  // radii; death is +infinity for an essential class
    std::uint32_t degree;
    std::uint32_t cycle;  // where a representative is kept (homology/cycles/cycles.hpp), 0 without one
};

// By degree, birth, death; no NaN.
struct CanonicalOrder {
    bool operator()(const Pair& a, const Pair& b) const {
        if (a.degree != b.degree) return a.degree < b.degree;
        if (a.birth != b.birth) return a.birth < b.birth;
        return a.death < b.death;
    }
};

// Pairs in the block, in the canonical order unless something else is said.
struct PairList {
    Pair* pairs;  // [count]; not null, also when count is 0
    std::uint64_t count;
};

// Moves pairs to the arena's low mark `low`, when nothing below them is needed any more. They must not stand below it.
// out_of_memory: hardly ever, when alignment alone takes the last bytes.
Status move_pairs_down(std::size_t low, Arena& arena, PairList* list);

}  // namespace netmesh
