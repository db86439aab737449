// Triangulated balls made by formula, and a block of memory to work in.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "common/block.hpp"
#include "complex/triangulation.hpp"

namespace netmesh_test {

// Cells alone: what is tested with them reads no neighbour words.
template <int D> struct Cells {
    std::uint32_t vertex_count = 0;
    std::vector<std::array<std::uint32_t, D + 1>> list;
    netmesh::TriangulationView<D> view() const {
        return {reinterpret_cast<const unsigned char*>(list.data()), sizeof(list[0]),
                static_cast<std::uint32_t>(list.size()), vertex_count};
    }
    // Facets that one cell has alone.
    std::uint64_t hull_facets() const {
        std::map<std::vector<std::uint32_t>, int> cells_at;
        for (const auto& cell : list)
            for (int i = 0; i <= D; ++i) {
                std::vector<std::uint32_t> facet(cell.begin(), cell.begin() + D + 1);
                facet.erase(facet.begin() + i);
                std::sort(facet.begin(), facet.end());
                ++cells_at[facet];
            }
        return static_cast<std::uint64_t>(
            std::count_if(cells_at.begin(), cells_at.end(), [](const auto& facet) { return facet.second == 1; }));
    }
};

// The grid of `side` cubes an axis, each cut into D! simplices along its monotone paths (Freudenthal).
template <int D> Cells<D> freudenthal(std::uint32_t side) {
    Cells<D> cells;
    std::array<std::uint32_t, D> stride, corner{};
    cells.vertex_count = 1;
    for (int d = 0; d < D; ++d) {
        stride[d] = cells.vertex_count;
        cells.vertex_count *= side + 1;
    }
    for (;;) {
        std::array<int, D> axis;
        std::iota(axis.begin(), axis.end(), 0);
        do {
            std::array<std::uint32_t, D + 1> cell;
            cell[0] = 0;
            for (int d = 0; d < D; ++d) cell[0] += corner[d] * stride[d];
            for (int d = 0; d < D; ++d) cell[d + 1] = cell[d] + stride[axis[d]];
            cells.list.push_back(cell);
        } while (std::next_permutation(axis.begin(), axis.end()));
        int d = 0;
        for (; d < D && ++corner[d] == side; ++d) corner[d] = 0;
        if (d == D) return cells;
    }
}

// Coordinates of its vertices, times `step`.
template <int D> std::vector<double> freudenthal_points(std::uint32_t side, double step = 1) {
    std::vector<double> x;
    std::array<std::uint32_t, D> at{};
    for (;;) {
        for (int d = 0; d < D; ++d) x.push_back(at[d] * step);
        int d = 0;
        for (; d < D && ++at[d] > side; ++d) at[d] = 0;
        if (d == D) return x;
    }
}

// Numbers that are the same everywhere.
struct Random {
    std::uint64_t state = 1;
    std::uint64_t bits() {
        std::uint64_t z = state += 0x9E3779B97F4A7C15u;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
        z = (z ^ z >> 27) * 0x94D049BB133111EBu;
        return z ^ z >> 31;
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(bits() % n); }
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
};

}  // namespace netmesh_test
