// Freudenthal triangulations of grids as balls for tests: each cube is cut into D! simplices, one for each order in
// which a path from its lowest to its highest corner can take the axes.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include "complex/triangulation.hpp"
#include "oracle.hpp"

namespace grid {

template <int D> struct Ball {
    static constexpr std::size_t words = 2 * (D + 1) + 2;  // a record has room behind, as in a mesh
    std::vector<std::uint32_t> records;
    std::uint32_t vertex_count = 0;

    netmesh::TriangulationView<D> view() const {
        return {reinterpret_cast<const unsigned char*>(records.data()), words * 4,
                static_cast<std::uint32_t>(records.size() / words), vertex_count};
    }
    std::vector<oracle::Simplex> cells() const {
        std::vector<oracle::Simplex> all;
        for (std::size_t c = 0; c < records.size(); c += words) {
            all.push_back({records.begin() + std::ptrdiff_t(c), records.begin() + std::ptrdiff_t(c) + D + 1});
        }
        return all;
    }
};

// Links cells[c] = D+1 vertices by their common facets.
template <int D> Ball<D> link(const std::vector<std::array<std::uint32_t, D + 1>>& cells, std::uint32_t vertex_count) {
    Ball<D> ball;
    ball.vertex_count = vertex_count;
    ball.records.assign(cells.size() * Ball<D>::words, 0xABABABABu);
    std::map<oracle::Simplex, std::size_t> open;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (std::size_t i = 0; i <= D; ++i) {
            ball.records[c * Ball<D>::words + i] = cells[c][i];
            std::uint32_t& word = ball.records[c * Ball<D>::words + D + 1 + i];
            word = netmesh::none;
            oracle::Simplex facet(cells[c].begin(), cells[c].end());
            facet.erase(facet.begin() + std::ptrdiff_t(i));
            std::sort(facet.begin(), facet.end());
            const auto [at, fresh] = open.insert({facet, 8 * c + i});
            if (fresh) continue;
            word = static_cast<std::uint32_t>(at->second);
            ball.records[(at->second >> 3) * Ball<D>::words + D + 1 + (at->second & 7)] =
                static_cast<std::uint32_t>(8 * c + i);
            open.erase(at);
        }
    }
    return ball;
}

// cubes[d] cubes along axis d; vertices, cells and the vertices of each cell in random order.
template <int D> Ball<D> freudenthal(const std::array<std::uint32_t, D>& cubes, std::mt19937& random) {
    std::uint32_t vertex_count = 1, cube_count = 1;
    for (const std::uint32_t n : cubes) {
        vertex_count *= n + 1;
        cube_count *= n;
    }
    std::vector<std::uint32_t> name(vertex_count);
    std::iota(name.begin(), name.end(), 0u);
    std::shuffle(name.begin(), name.end(), random);
    std::vector<std::array<std::uint32_t, D + 1>> cells;
    for (std::uint32_t cube = 0; cube < cube_count; ++cube) {
        std::array<std::uint32_t, D> axes, corner;
        for (std::uint32_t d = 0, rest = cube; d < D; ++d) {
            corner[d] = rest % cubes[d];
            rest /= cubes[d];
            axes[d] = d;
        }
        do {
            std::array<std::uint32_t, D + 1> cell;
            auto at = corner;
            for (std::size_t i = 0; i <= D; ++i) {
                std::uint32_t index = 0;
                for (std::size_t d = D; d-- > 0;) index = index * (cubes[d] + 1) + at[d];
                cell[i] = name[index];
                if (i < D) ++at[axes[i]];
            }
            std::shuffle(cell.begin(), cell.end(), random);
            cells.push_back(cell);
        } while (std::next_permutation(axes.begin(), axes.end()));
    }
    std::shuffle(cells.begin(), cells.end(), random);
    return link<D>(cells, vertex_count);
}

// A ball with vertices of very different degrees: cells are glued to the hull, and random faces are starred from a new
// vertex, `steps` times.
template <int D> Ball<D> irregular(std::uint32_t steps, std::mt19937& random) {
    using Cell = std::array<std::uint32_t, D + 1>;
    std::vector<Cell> cells(1);
    std::iota(cells[0].begin(), cells[0].end(), 0u);
    std::uint32_t next = D + 1;
    for (std::uint32_t step = 0; step < steps; ++step, ++next) {
        const std::uint32_t c = std::uint32_t(random() % cells.size());
        if (random() % 4 == 0) {
            const auto view = link<D>(cells, next);
            const std::uint32_t i = std::uint32_t(random() % (D + 1));
            if (view.view().neighbour(netmesh::CellId(c), i) == netmesh::none) {
                cells.push_back(cells[c]);
                cells.back()[std::size_t(i)] = next;
                continue;
            }
        }
        Cell shuffled = cells[c];
        std::shuffle(shuffled.begin(), shuffled.end(), random);
        const std::vector<std::uint32_t> face(shuffled.begin(), shuffled.begin() + 2 + std::ptrdiff_t(random() % D));
        std::vector<Cell> starred;
        for (const Cell& cell : cells) {
            std::vector<std::size_t> at;
            for (const std::uint32_t v : face) {
                const auto found = std::find(cell.begin(), cell.end(), v);
                if (found != cell.end()) at.push_back(std::size_t(found - cell.begin()));
            }
            if (at.size() < face.size()) {
                starred.push_back(cell);
                continue;
            }
            for (const std::size_t i : at) {
                starred.push_back(cell);
                starred.back()[i] = next;
            }
        }
        cells.swap(starred);
    }
    std::vector<std::uint32_t> name(next);
    std::iota(name.begin(), name.end(), 0u);
    std::shuffle(name.begin(), name.end(), random);
    for (Cell& cell : cells) {
        for (std::uint32_t& v : cell) v = name[v];
        std::shuffle(cell.begin(), cell.end(), random);
    }
    return link<D>(cells, next);
}

// Cells around one vertex whose link is large: a cone over the boundary of a long stack of cells.
template <int D> Ball<D> cone_over_stack(std::uint32_t length) {
    std::vector<std::array<std::uint32_t, D + 1>> stack;
    for (std::uint32_t c = 0; c < length; ++c) {
        std::array<std::uint32_t, D + 1> cell;
        for (std::uint32_t i = 0; i <= D; ++i) cell[i] = c + i;
        stack.push_back(cell);
    }
    const std::uint32_t apex = length + D;
    const auto inner = link<D>(stack, apex);
    std::vector<std::array<std::uint32_t, D + 1>> cells;
    for (std::uint32_t c = 0; c < length; ++c) {
        for (int i = 0; i <= D; ++i) {
            if (inner.view().neighbour(netmesh::CellId(c), i) != netmesh::none) continue;
            cells.push_back(stack[c]);
            cells.back()[std::size_t(i)] = apex;
        }
    }
    return link<D>(cells, apex + 1);
}

}  // namespace grid
