// Parts of a ball with the homology of a point: what random elementary collapses leave of it.
#pragma once
#include "common/block.hpp"
#include "complex/subcomplex.hpp"
#include "grid.hpp"

namespace parts {

// Takes `pairs` free simplices with their only cofaces out of a complex, closed under faces, or as many as there are.
// `digging`: next to where the last ones were, so that tunnels arise.
inline std::vector<oracle::Simplex> collapse(const std::vector<oracle::Simplex>& simplices, std::size_t pairs,
                                             bool digging, std::mt19937& random) {
    std::map<oracle::Simplex, std::size_t> index;
    for (std::size_t i = 0; i < simplices.size(); ++i) index[simplices[i]] = i;
    std::vector<std::vector<std::size_t>> facets(simplices.size()), cofaces(simplices.size());
    for (std::size_t i = 0; i < simplices.size(); ++i) {
        for (std::size_t j = 0; simplices[i].size() > 1 && j < simplices[i].size(); ++j) {
            oracle::Simplex facet = simplices[i];
            facet.erase(facet.begin() + std::ptrdiff_t(j));
            facets[i].push_back(index.at(facet));
            cofaces[index.at(facet)].push_back(i);
        }
    }
    std::vector<bool> gone(simplices.size());
    std::vector<std::size_t> left(simplices.size()), free;  // cofaces that are not gone; candidates, stale ones too
    for (std::size_t i = 0; i < simplices.size(); ++i) {
        left[i] = cofaces[i].size();
        if (left[i] == 1) free.push_back(i);
    }
    std::shuffle(free.begin(), free.end(), random);
    while (pairs > 0 && !free.empty()) {
        const std::size_t near = digging ? std::min<std::size_t>(free.size(), 3) : free.size();
        std::swap(free[free.size() - 1 - random() % near], free.back());
        const std::size_t i = free.back();
        free.pop_back();
        if (gone[i] || left[i] != 1) continue;
        const std::size_t coface =
            *std::find_if(cofaces[i].begin(), cofaces[i].end(), [&](auto c) { return !gone[c]; });
        for (const std::size_t out : {coface, i}) {
            gone[out] = true;
            for (const std::size_t facet : facets[out]) {
                if (--left[facet] == 1) free.push_back(facet);
            }
        }
        --pairs;
    }
    std::vector<oracle::Simplex> rest;
    for (std::size_t i = 0; i < simplices.size(); ++i) {
        if (!gone[i]) rest.push_back(simplices[i]);
    }
    return rest;
}

// These simplices of a ball as the engine takes them. A face of a cell that is in is listed too, or not, by chance.
template <int D> struct Part {
    std::vector<oracle::Simplex> simplices;
    std::vector<std::uint8_t> cell, vertex;
    std::size_t cut = 0, absent = 0, bare = 0;  // vertices that are; faces that are in no cell of the part

    Part(const grid::Ball<D>& ball, const std::vector<oracle::Simplex>& in, std::mt19937& random)
        : simplices(in), block_(in.size() * 16 * D + 4096) {
        const std::set<oracle::Simplex> set(in.begin(), in.end());
        std::set<oracle::Simplex> covered;
        vertex.assign(ball.vertex_count, netmesh::VertexPart::whole);
        for (oracle::Simplex c : ball.cells()) {
            std::sort(c.begin(), c.end());
            cell.push_back(set.count(c) != 0 ? 1 : 0);
            for (const auto& face : oracle::all_faces({c})) {
                if (cell.back() != 0) covered.insert(face);
                for (const std::uint32_t v : face) {
                    if (set.count(face) == 0) vertex[v] = netmesh::VertexPart::cut;
                }
            }
        }
        for (std::uint32_t v = 0; v < ball.vertex_count; ++v) {
            if (set.count({v}) == 0) vertex[v] = netmesh::VertexPart::absent;
            cut += vertex[v] == netmesh::VertexPart::cut;
            absent += vertex[v] == netmesh::VertexPart::absent;
        }
        std::vector<oracle::Simplex> shuffled = in;
        std::shuffle(shuffled.begin(), shuffled.end(), random);
        for (const auto& s : shuffled) {
            if (s.size() == D + 1 || (covered.count(s) != 0 && random() % 4 != 0)) continue;
            bare += covered.count(s) == 0;
            if (!faces_.insert(s.data(), std::uint32_t(s.size()), block_.arena)) std::abort();
        }
        view = {cell.data(), faces_, vertex.data()};
    }
    netmesh::Subcomplex<D> view;

private:
    Block block_;
    netmesh::FaceSet<D> faces_;
};

}  // namespace parts
