// Ours against CGAL's. On points in general position the Delaunay triangulation is unique and must be the same cell by
// cell. Where points are cospherical it is not, but the subdivision is into the polytopes whose vertices are on one
// empty sphere: cells that share a facet and a sphere, taken together, must be the same sets of vertices and have the
// same volume, which they have not where cells overlap or are missing.
#pragma once
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "common/session.hpp"

template <int D> using Cells = std::vector<std::array<std::uint32_t, D + 1>>;

// `cgal` makes the list of cells that Session::cells makes, out of CGAL.
template <int D, class Cgal> void compare_with_cgal(std::size_t n, Cgal cgal) {
    const std::pair<const char*, inputs::Points> cases[] = {{"uniform", inputs::uniform(D, n, 11)},
                                                            {"gaussian", inputs::gaussian(D, n, 12)},
                                                            {"clusters", inputs::clusters(D, n, 13)}};
    for (const auto& [name, points] : cases) {
        INFO("D = " << D << ", " << name << ", " << n << " points");
        Session session(D);
        session.reserve(std::size_t{64} << 20);  // with room for the checks
        REQUIRE(session.delaunay(points) == NETMESH_OK);
        const Cells<D> ours = session.cells<D + 1>(), theirs = cgal(points);
        REQUIRE(theirs.size() > n);
        CHECK(ours.size() == theirs.size());
        CHECK((ours == theirs));
        CHECK(session.check() == NETMESH_OK);
    }
}

// A part of the subdivision: its vertices, ascending, and D! times its volume.
struct Polytope {
    std::vector<std::uint32_t> vertices;
    __int128 volume;

    bool operator<(const Polytope& o) const {
        return vertices != o.vertices ? vertices < o.vertices : volume < o.volume;
    }
    bool operator==(const Polytope& o) const { return vertices == o.vertices && volume == o.volume; }
};

// |det| of the edges of a cell whose coordinates are integers; fraction-free elimination.
template <int D> __int128 volume_of(const inputs::Points& points, const std::array<std::uint32_t, D + 1>& cell) {
    __int128 a[D][D], divisor = 1;
    for (int i = 0; i < D; ++i)
        for (int k = 0; k < D; ++k)
            a[i][k] = static_cast<__int128>(points[cell[static_cast<std::size_t>(i + 1)] * D + k]) -
                      static_cast<__int128>(points[cell[0] * D + k]);
    for (int c = 0; c + 1 < D; ++c) {
        int pivot = c;
        while (pivot < D && a[pivot][c] == 0) ++pivot;
        if (pivot == D) return 0;
        for (int k = 0; k < D; ++k) std::swap(a[c][k], a[pivot][k]);
        for (int i = c + 1; i < D; ++i)
            for (int k = c + 1; k < D; ++k) a[i][k] = (a[i][k] * a[c][c] - a[i][c] * a[c][k]) / divisor;
        divisor = a[c][c];
    }
    return a[D - 1][D - 1] < 0 ? -a[D - 1][D - 1] : a[D - 1][D - 1];
}

// on_sphere(cell, q): is point q on the sphere of the cell, decided exactly?
template <int D, class OnSphere>
std::vector<Polytope> subdivision(const inputs::Points& points, const Cells<D>& cells, OnSphere on_sphere) {
    std::vector<std::size_t> group(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) group[c] = c;
    const auto root = [&](std::size_t c) {
        while (group[c] != c) c = group[c] = group[group[c]];
        return c;
    };
    std::map<std::array<std::uint32_t, D>, std::size_t> facets;
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (std::size_t i = 0; i <= D; ++i) {
            std::array<std::uint32_t, D> facet;
            for (std::size_t j = 0, n = 0; j <= D; ++j)
                if (j != i) facet[n++] = cells[c][j];
            const auto [at, is_new] = facets.emplace(facet, c);
            if (!is_new && on_sphere(cells[at->second], cells[c][i])) group[root(c)] = root(at->second);
        }
    std::map<std::size_t, std::pair<std::set<std::uint32_t>, __int128>> parts;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        auto& [vertices, volume] = parts[root(c)];
        vertices.insert(cells[c].begin(), cells[c].end());
        volume += volume_of<D>(points, cells[c]);
    }
    std::vector<Polytope> all;
    for (const auto& [c, part] : parts) all.push_back({{part.first.begin(), part.first.end()}, part.second});
    std::sort(all.begin(), all.end());
    return all;
}

// Every point of a set, a fourth of its coordinates moved by one: nearly cospherical where the set is.
inline inputs::Points nudged(inputs::Points points, double scale, std::uint64_t seed) {
    inputs::Random random(seed);
    for (double& x : points) x = x * scale + (random.below(4) == 0 ? static_cast<double>(random.below(3)) - 1 : 0);
    return points;
}

// Integer points. `side`: of grids; norm: the squared radius of spheres.
template <int D> std::vector<std::pair<const char*, inputs::Points>> degenerate_sets(int side, int norm, double scale) {
    const inputs::Points grid = inputs::grid(D, side), sphere = inputs::cospherical(D, norm);
    inputs::Points faces, plane, two_spheres = sphere, some;
    inputs::Random random(7);
    for (std::size_t i = 0; i < grid.size(); i += D) {
        bool outside = false;
        for (int k = 0; k < D; ++k)
            outside |= grid[i + static_cast<std::size_t>(k)] == 0 || grid[i + static_cast<std::size_t>(k)] == side - 1;
        if (outside) faces.insert(faces.end(), &grid[i], &grid[i] + D);
        if (random.below(3) == 0) some.insert(some.end(), &grid[i], &grid[i] + D);
        if (grid[i] == 0) plane.insert(plane.end(), &grid[i], &grid[i] + D);
    }
    for (const double height : {3.0, -2.0, 11.0}) {
        plane.push_back(height);
        for (int k = 1; k < D; ++k) plane.push_back(k);
    }
    for (const double x : sphere) two_spheres.push_back(2 * x);
    return {{"grid", grid},
            {"some of a grid", some},
            {"faces of a cube", faces},
            {"a plane and three points", plane},
            {"a sphere", sphere},
            {"two spheres", two_spheres},
            {"nearly a grid", nudged(some, scale, 5)},
            {"nearly a sphere", nudged(sphere, scale, 6)}};
}

template <int D, class Cgal, class OnSphere>
void compare_degenerate_with_cgal(int side, int norm, double scale, Cgal cgal, OnSphere on_sphere) {
    for (const auto& [name, points] : degenerate_sets<D>(side, norm, scale)) {
        INFO("D = " << D << ", " << name << ", " << points.size() / D << " points");
        Session session(D);
        REQUIRE(session.delaunay(points) == NETMESH_OK);
        const auto on = [&, &all = points](const std::array<std::uint32_t, D + 1>& cell, std::uint32_t q) {
            return on_sphere(all, cell, q);
        };
        const std::vector<Polytope> ours = subdivision<D>(points, session.cells<D + 1>(), on);
        const std::vector<Polytope> theirs = subdivision<D>(points, cgal(points), on);
        CHECK(ours.size() == theirs.size());
        CHECK((ours == theirs));
    }
}
