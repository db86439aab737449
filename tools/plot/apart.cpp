#include "tools/plot/apart.hpp"

#include <algorithm>
#include <cmath>

namespace netmesh::tool {

double length_of(const Bar& bar) { return std::isfinite(bar.death) ? bar.death - bar.birth : HUGE_VAL; }

std::size_t count_apart(const std::vector<double>& lengths) {
    constexpr std::size_t most = 12, few = 8;
    constexpr double gap_least = 1.5, end_gap = 2.5;
    std::size_t count = 0, endless = 0;  // of those above 0
    while (count < lengths.size() && lengths[count] > 0) count++;
    while (endless < count && std::isinf(lengths[endless])) endless++;
    std::size_t apart = endless;
    double largest = gap_least;
    for (std::size_t i = endless; i + 1 < count && i < endless + most; i++) {
        if (!(lengths[i] >= largest * lengths[i + 1])) continue;
        largest = lengths[i] / lengths[i + 1];
        apart = i + 1;
    }
    return count <= few && largest < end_gap ? count : apart;
}

}  // namespace netmesh::tool
