// Cage templates of thesis 4.5: points on the unit sphere that cover it.
#pragma once
#include <cstdint>

#include "numerics/vector.hpp"

namespace netmesh {

// covering_sine, covering_cosine: of the largest angle between a point of the sphere and the template; a template that
// is the set of corners of a polytope around the origin covers worst where the normal of a facet meets the sphere, so
// the cosine is the least distance of a facet. packing: least distance of two points.
//
//   D   points                                                      facets        covering angle     packing
//   2   12, a regular polygon                                       edges         15 degrees         .5176
//   3   32, the corners of an icosahedron and a dodecahedron        triangles     22.69 degrees      .6408
//   4   120, the corners of the 600-cell                            tetrahedra    22.24 degrees      .6180
template <int D> struct CageTemplate;

template <> struct CageTemplate<2> {
    static constexpr std::uint32_t size = 16;
    static void point(std::uint32_t k, double* x) {
        constexpr double cosine[] = {1, 0.92387953251128675613, 0.70710678118654752440, 0.38268343236508977173, 0};
        const std::uint32_t quarter = k / 4, step = k % 4;
        const double a = cosine[step], b = cosine[4 - step];
        x[0] = quarter == 0 ? a : quarter == 1 ? -b : quarter == 2 ? -a : b;
        x[1] = quarter == 0 ? b : quarter == 1 ? a : quarter == 2 ? -b : -a;
    }
};

constexpr double golden = 1.6180339887498948482;

template <> struct CageTemplate<3> {
    static constexpr std::uint32_t size = 42;
    static void point(std::uint32_t k, double* x) {
        // (0, +-1, +-golden) / |.|, +-1 on an axis, (+-golden, +-1, +-1 / golden) / 2, and their cyclic permutations.
        constexpr double icosahedron = 0.52573111211913360603;  // 1 / sqrt(1 + golden^2)
        const std::uint32_t turn = k % 3, signs = k < 12 ? k / 3 : k < 18 ? (k - 12) / 3 : (k - 18) / 3;
        const double part[] = {k < 12 ? 0 : k < 18 ? 1 : 0.5 * golden, k < 12 ? icosahedron : k < 18 ? 0 : 0.5,
                               k < 12 ? icosahedron * golden : k < 18 ? 0 : 0.5 * (golden - 1)};
        const std::uint32_t flips = k < 12 ? signs << 1 : signs;
        for (std::uint32_t i = 0; i < 3; ++i) x[(i + turn) % 3] = (flips >> i & 1u) != 0 ? -part[i] : part[i];
    }
};

template <> struct CageTemplate<4> {
    static constexpr std::uint32_t size = 120;
    static void point(std::uint32_t k, double* x) {
        if (k < 8) {
            for (std::uint32_t i = 0; i < 4; ++i) x[i] = i != k / 2 ? 0 : (k & 1u) != 0 ? 1 : -1;
            return;
        }
        if (k < 24) {
            for (int i = 0; i < 4; ++i) x[i] = (k >> i & 1u) != 0 ? 0.5 : -0.5;
            return;
        }
        // Even permutations of (+-golden, +-1, +-1 / golden, 0) / 2: by where 0 is, and which comes next to it.
        const std::uint32_t even = (k - 24) / 8;
        const double values[] = {0.5 * golden, 0.5, 0.5 * (golden - 1)};
        constexpr std::uint8_t places[12][4] = {
            // where golden, 1, 1 / golden and 0 go
            {0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {1, 0, 3, 2}, {0, 3, 1, 2}, {3, 1, 0, 2},
            {0, 2, 3, 1}, {2, 3, 0, 1}, {3, 0, 2, 1}, {2, 1, 3, 0}, {1, 3, 2, 0}, {3, 2, 1, 0}};
        for (int i = 0; i < 3; ++i) x[places[even][i]] = (k >> i & 1u) != 0 ? values[i] : -values[i];
        x[places[even][3]] = 0;
    }
};

// The outermost cage has a denser shell, as nothing can be done about a corner that lies beyond it: the centres of
// grid^(D - 1) squares on each facet of a cube, seen from its centre. Along a facet no point is farther than
// sqrt(D - 1) / grid from one of them, and the way to the sphere makes distances no larger.
template <int D> struct RootTemplate {
#ifdef X_GRID
    static constexpr std::uint32_t grid = X_GRID;
#else
    static constexpr std::uint32_t grid = D == 2 ? 6 : D == 3 ? 6 : 5;
#endif
    static constexpr std::uint32_t facet = D == 2 ? grid : D == 3 ? grid * grid : grid * grid * grid;
    static constexpr std::uint32_t size = 2 * D * facet;
    static void point(std::uint32_t k, double* x) {
        const std::uint32_t side = k / facet;
        double norm2 = 1;
        x[side / 2] = side % 2 == 0 ? 1 : -1;
        k %= facet;
        for (std::uint32_t i = 1; i < D; ++i, k /= grid) {
            const double y = (2.0 * (k % grid) + 1) / grid - 1;
            x[(side / 2 + i) % D] = y;
            norm2 += y * y;
        }
        const double norm = square_root(norm2);
        for (int i = 0; i < D; ++i) x[i] /= norm;
    }
};

}  // namespace netmesh
