// What plans are fitted to, measured on uniform points.
#pragma once
#include "numerics/elementary.hpp"
#include "numerics/square_root.hpp"

namespace netmesh {

// x^p, x > 0, |p| < 64.
inline double to_power(double x, double p) {
    const double all = p < 0 ? -p : p;
    const int whole = static_cast<int>(all);
    double result = power(x, whole), root = x, rest = all - whole;
    for (int bit = 0; bit < 30; ++bit) {
        root = square_root(root);
        rest *= 2;
        if (rest < 1) continue;
        result *= root;
        rest -= 1;
    }
    return p < 0 ? 1 / result : result;
}

// Peaks of triangulations and alpha complexes of n uniform points: fixed + n (each - hull n^(-1/D)), as points near the
// hull have fewer cells. In the plane 1.5% above the largest of up to 60 sets; from space on the mean of sets and 4
// standard deviations or more, which one set in some ten thousands exceeds. Those of 100 points are 1.6%, 2%, 2.3% to
// 2.8%, 2.1% to 3% of the mean (D = 3 to 6), and less as the root of n. Fitted to n = 100 to 100,000 (D = 2, 3), 3,000
// (4), 1,000 (5; with diagrams 300) and 300 (6; with diagrams 200), beyond which nothing is known.
struct PeakFigures {
    double fixed, each, hull;
    template <int D> double at(double points) const {
        const double n = points > 100 ? points : 100;
        return fixed + points * (each - hull * to_power(n, -1.0 / D));
    }
};
// Made by netmesh_delaunay; with the diagram of netmesh_persist; by netmesh_persist_alpha.
struct DelaunayFigures {
    PeakFigures triangulated, filtered, diagram;
};
template <int D> struct DelaunayFiguresOf;
template <> struct DelaunayFiguresOf<2> {
    static constexpr DelaunayFigures value = {{2200, 158, 0}, {2400, 334, 0}, {2400, 196.5, 0}};
};
template <> struct DelaunayFiguresOf<3> {
    static constexpr DelaunayFigures value = {{2800, 554, 201}, {6000, 1333.5, 1200}, {4000, 762.5, 558}};
};
template <> struct DelaunayFiguresOf<4> {
    static constexpr DelaunayFigures value = {{4100, 3209, 3885}, {2100, 9471, 14659}, {2100, 6092, 9257}};
};
template <> struct DelaunayFiguresOf<5> {
    static constexpr DelaunayFigures value = {{14000, 24150, 40287}, {3000, 90250, 165768}, {2100, 65330, 119761}};
};
template <> struct DelaunayFiguresOf<6> {
    static constexpr DelaunayFigures value = {{2100, 172700, 300000}, {2100, 802200, 1450000}, {2100, 635700, 1150000}};
};

// Vertices of meshes of uniform points in R^2, R^3, R^4: 1 + growth spread a point. The spread from set to set
// is large where points are few: the largest of 60 sets of 100 points has 2.5 (D = 2) and 3 (3) times as many as the
// least one. Each at some places, between them as powers: of tau - 2 at `tau` - 2 and of ratio - sqrt 2 at `ratios`.
// Below 2 cells at the boundary of the points are a large part of a mesh of few: growth is then what 100 to 10,000
// points in the plane and 300 to 3,000 in space lead to for more; in R^4 it is that of 100 and 200 points and whole
// cells, below 1.8 a guess.
constexpr int ratio_places = 8;
constexpr double ratios[ratio_places] = {1.5, 1.6, 1.7, 1.8, 1.9, 2, 2.25, 3};
struct MeshFigures {
    double tau[3];
    double by_tau[3], by_ratio[ratio_places];
    double cages_growth;                      // with compact cages, times that without
    double spread_root, spread, spread_from;  // 1 + spread_root / sqrt n + spread / n, n at least spread_from
    double shell_power, shell;                // refined around the domain for persistence: shell sqrt(growth) n^power
    double net_fixed, net_power, net,
        net_each;              // VoronoiRefine, at the default tau: net_fixed + net n^power + net_each n
    double sizes_each, sizes;  // over-refined: sizes_each + sizes / eps^D a point
    // Bytes a vertex: while a mesh is made; made with cages; filtered whole, clipped, over-refined.
    double made, with_cages, whole, clipped, fine;
    double pairs;  // of a diagram, a point
};
template <int D> struct MeshFiguresOf;
// clang-format off
template <> struct MeshFiguresOf<2> {
    static constexpr MeshFigures value = {
        {2.5, 3.5, 6}, {3.08, 1.23, 0.44}, {54.5, 25.3, 13.5, 6.1, 3.15, 2, 0.985, 0.302}, 0.91, 7.5, 40, 100,
        0, 62, 700, 0.5, 12, 1, 10, 2.47,
        161, 190, 163.5, 162, 179, 22};
};
template <> struct MeshFiguresOf<3> {
    static constexpr MeshFigures value = {
        {2.5, 3.5, 6}, {6.6, 1.72, 0.46}, {345, 167, 71, 21, 6.9, 3.45, 1.39, 0.31}, 1, 14.3, 75, 100,
        0.3334, 17, 0, 0.25, 2450, 0.6, 48, 4.9,
        516, 574, 498, 505, 512, 77};
};
// Not of nets and sizes.
template <> struct MeshFiguresOf<4> {
    static constexpr MeshFigures value = {
        {3.08, 3.5, 6}, {5.05, 3.05, 0.63}, {950, 430, 165, 55, 17.4, 6.1, 2.1, 0.385}, 1, 5.5, 36, 250,
        0.5, 16, 0, 0, 0, 0, 0, 0,
        2490, 2500, 2490, 2490, 0, 180};
};
// clang-format on

// Takes powers for granted between the places, which ascend, and beyond them as next to the ends.
template <int n> double interpolated(double x, const double (&place)[n], const double (&value)[n]) {
    int i = 0;
    while (i + 2 < n && x >= place[i + 1]) ++i;
    const double far = place[i + 1] / place[i], low = value[i] / value[i + 1];
    return value[i] * to_power(x / place[i], -logarithm(low) / logarithm(far));
}

}  // namespace netmesh
