// Points of a persistence diagram, lists of them and their canonical order.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"
#include "vocabulary/dimension.hpp"
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

// Pairs in the canonical order that are only read, in one of two forms: records as they are, or births and deaths alone
// of pairs in degrees 0..D-1 that have no cycles, two thirds of the memory.
struct BarList {
    static constexpr std::size_t counts = (dimension_most() + 1) / 2 * 2;  // a multiple of Arena::alignment

    const void* first;  // [count] Pair; short: [count][2] double, behind how many there are of each degree, [counts]
    std::uint64_t count;
    bool is_short = false;

    Pair operator[](std::uint64_t i) const {
        if (!is_short) return static_cast<const Pair*>(first)[i];
        const double* const bar = static_cast<const double*>(first) + 2 * i;
        Pair pair = {bar[0], bar[1], 0, 0};
        for (const auto* of = static_cast<const std::uint64_t*>(first) - counts; i >= *of; ++pair.degree) i -= *of++;
        return pair;
    }
};

// Makes pairs short where they stand, which is the arena's low end, and gives back what that leaves. Right below them
// stands room for the counts. O(pairs).
void shorten_pairs(const PairList& list, Arena& arena);

// Moves pairs to the arena's low mark `low`, when nothing below them is needed any more. They must not stand below it.
// out_of_memory: hardly ever, when alignment alone takes the last bytes.
Status move_pairs_down(std::size_t low, Arena& arena, PairList* list);

}  // namespace netmesh
