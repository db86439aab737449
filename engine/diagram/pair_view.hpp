// Diagrams as callers hand them over to be compared, and the scratch memory that comes with them.
#pragma once
#include <cstddef>
#include <cstdint>

#include "include/netmesh.h"
#include "numerics/real.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// Diagrams of more pairs are not compared.
constexpr std::uint64_t compared_pairs_max = std::uint64_t{1} << 25;

// Pairs as the caller has them: `stride` bytes from one to the next, as its netmesh_pair may be of a later version.
struct PairView {
    const void* first;
    std::size_t stride;  // >= sizeof(netmesh_pair)
    std::uint64_t count;
    Monitor* monitor = nullptr;  // is told of loops over the pairs; null: nobody is

    void report(std::uint64_t i) const {
        if (i % 256 == 0 && monitor != nullptr) monitor->pass(25);
    }
    netmesh_pair operator[](std::size_t i) const {
        report(i);
        netmesh_pair pair;
        __builtin_memcpy(&pair, static_cast<const unsigned char*>(first) + i * stride, sizeof pair);
        return pair;
    }
};

inline bool is_essential(const netmesh_pair& pair) { return pair.death == infinity; }

// Are births finite and deaths not before them; on the log scale, are births not negative?
inline bool are_diagram(const PairView& pairs, bool log_scale) {
    for (std::size_t i = 0; i < pairs.count; ++i) {
        const netmesh_pair pair = pairs[i];
        if (!is_finite(pair.birth) || !(pair.death >= pair.birth)) return false;
        if (log_scale && pair.birth < 0) return false;
    }
    return true;
}

// The least degree of either diagram that is at least `from`; false if there is none.
inline bool next_degree(const PairView& a, const PairView& b, std::uint64_t from, std::uint32_t* degree) {
    bool found = false;
    const PairView* const both[2] = {&a, &b};
    for (const PairView* const pairs : both) {
        for (std::size_t i = 0; i < pairs->count; ++i) {
            const std::uint32_t d = (*pairs)[i].degree;
            if (d < from || (found && d >= *degree)) continue;
            *degree = d;
            found = true;
        }
    }
    return found;
}

// Scratch in pieces. Without a base it only counts: the size asked for is the layout itself.
struct Scratch {
    static constexpr std::size_t alignment = 16;
    unsigned char* base;
    std::size_t used;

    template <class T> T* take(std::size_t count) {
        T* const piece = base == nullptr ? nullptr : reinterpret_cast<T*>(base + used);
        used += (count * sizeof(T) + alignment - 1) & ~(alignment - 1);
        return piece;
    }
};

}  // namespace netmesh
