#include "diagram/sort.hpp"

#include "numerics/sort.hpp"

namespace netmesh {

void sort_pairs(Pair* pairs, std::uint64_t count) {
    sort(pairs, count, [](const Pair& a, const Pair& b) { return before(a, b); });
}

}  // namespace netmesh
