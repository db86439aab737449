// What plans are fitted to, measured on uniform points.
#pragma once
#include "numerics/elementary.hpp"
#include "numerics/residues.hpp"
#include "numerics/square_root.hpp"
#include "vocabulary/dimension.hpp"

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
    double at(double points, int D) const {
        const double n = points > 100 ? points : 100;
        return fixed + points * (each - hull * to_power(n, -1.0 / D));
    }
};
// Made by netmesh_delaunay; with the diagram of netmesh_persist; by netmesh_persist_alpha.
struct DelaunayFigures {
    PeakFigures triangulated, filtered, diagram;
};
// In the plane without weights, where words have 16 or 32 bits (alpha_of_plane.hpp).
constexpr PeakFigures plane_figures_few = {2700, 82, 0}, plane_figures = {2700, 106.1, 0},
                      few_cells_figures = {2600, 64, 0};
// With weights scratch for exact powers is taken ahead, so much times D + 3 (ExactSphere::room).
constexpr std::size_t exact_power_bytes = residue_prime_count * sizeof(std::uint64_t);
constexpr DelaunayFigures delaunay_figures_in(int dim) {
    using Peak = ByDimension<PeakFigures>;
    DelaunayFigures f = {};
    f.triangulated =
        Peak{{{2200, 158, 0}, {2800, 554, 201}, {4100, 3209, 3885}, {14000, 24150, 40287}, {2100, 172700, 300000}}}.at(
            dim);
    f.filtered = Peak{
        {{2800, 330, 0},
         {-2300, 1333.5, 1200},
         {2100, 9471, 14659},
         {3000, 90250, 165768},
         {2100, 802200,
          1450000}}}.at(dim);
    f.diagram =
        Peak{
            {{2400, 196.5, 0}, {-1400, 762.5, 558}, {2100, 6092, 9257}, {2100, 65330, 119761}, {2100, 635700, 1150000}}}
            .at(dim);
    return f;
}
template <int D> struct DelaunayFiguresOf { static constexpr DelaunayFigures value = delaunay_figures_in(D); };
// Of a dimension that is served.
inline const DelaunayFigures& delaunay_figures_of(std::uint32_t dim) {
    return *with_dimension(dim, [](auto of) { return &DelaunayFiguresOf<decltype(of)::value>::value; });
}

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
// In D = 2, 3, 4; of nets and sizes in 2 and 3 alone.
constexpr MeshFigures mesh_figures_in(int dim) {
    constexpr double tau[3][3] = {{2.5, 3.5, 6}, {2.5, 3.5, 6}, {3.08, 3.5, 6}};
    constexpr double by_tau[3][3] = {{3.08, 1.23, 0.44}, {6.6, 1.72, 0.46}, {5.05, 3.05, 0.63}};
    constexpr double by_ratio[3][ratio_places] = {{54.5, 25.3, 13.5, 6.1, 3.15, 2, 0.985, 0.302},
                                                  {345, 167, 71, 21, 6.9, 3.45, 1.39, 0.31},
                                                  {950, 430, 165, 55, 17.4, 6.1, 2.1, 0.385}};
    const int at = dim - 2;
    MeshFigures f = {};
    for (int i = 0; i < 3; ++i) {
        f.tau[i] = tau[at][i];
        f.by_tau[i] = by_tau[at][i];
    }
    for (int i = 0; i < ratio_places; ++i) f.by_ratio[i] = by_ratio[at][i];
    using Real = ByDimension<double>;
    f.cages_growth = Real{{0.91, 1, 1}}.at(dim);
    f.spread_root = Real{{7.5, 14.3, 5.5}}.at(dim);
    f.spread = Real{{40, 75, 36}}.at(dim);
    f.spread_from = Real{{100, 100, 250}}.at(dim);
    f.shell_power = Real{{0, 0.3334, 0.5}}.at(dim);
    f.shell = Real{{62, 17, 16}}.at(dim);
    f.net_fixed = Real{{700, 0, 0}}.at(dim);
    f.net_power = Real{{0.5, 0.25, 0}}.at(dim);
    f.net = Real{{12, 2450, 0}}.at(dim);
    f.net_each = Real{{1, 0.6, 0}}.at(dim);
    f.sizes_each = Real{{10, 48, 0}}.at(dim);
    f.sizes = Real{{2.47, 4.9, 0}}.at(dim);
    f.made = Real{{161, 516, 2490}}.at(dim);
    f.with_cages = Real{{190, 574, 2500}}.at(dim);
    f.whole = Real{{163.5, 498, 2490}}.at(dim);
    f.clipped = Real{{162, 505, 2490}}.at(dim);
    f.fine = Real{{179, 512, 0}}.at(dim);
    f.pairs = Real{{22, 77, 180}}.at(dim);
    return f;
}
template <int D> struct MeshFiguresOf { static constexpr MeshFigures value = mesh_figures_in(D); };

// Takes powers for granted between the places, which ascend, and beyond them as next to the ends.
template <int n> double interpolated(double x, const double (&place)[n], const double (&value)[n]) {
    int i = 0;
    while (i + 2 < n && x >= place[i + 1]) ++i;
    const double far = place[i + 1] / place[i], low = value[i] / value[i + 1];
    return value[i] * to_power(x / place[i], -logarithm(low) / logarithm(far));
}

}  // namespace netmesh
