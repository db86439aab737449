// Disjoint sets whose root is always the oldest member, as the elder rule wants it.
#pragma once
#include <cstdint>

namespace netmesh {

// Root of the set of i; parent[root] == root. Halves the path: O(log n) amortised.
inline std::uint32_t find_root(std::uint32_t* parent, std::uint32_t i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

}  // namespace netmesh
