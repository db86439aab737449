// Cage templates of thesis 4.5: points on the unit sphere that cover it.
#pragma once
#include <cstdint>

#include "mesh/cages/cage.hpp"

namespace netmesh {

constexpr int thesis_dim_max = 4;
// Below this the invariants of 4.9 have no constants, see engine/decisions/cages-of-the-thesis.md.
constexpr double thesis_tau_min = 3.4;

// Of a cage of radius r as the thesis has it; what the constants must satisfy stands in the same place.
struct ThesisCage {
    // No input between epsilon r and r, no vertex between r and 2 r / epsilon.
    static constexpr double epsilon = 0.3;
    static constexpr double clearance = 2 / epsilon;
    // The sphere of the shell has this radius times r.
    static constexpr double shell_factor = 0.64;
    // A shell vertex is within this times the radius of that sphere of a point of the template: it is moved by at most
    // jitter in each coordinate, or it is an input that it has yielded to.
    static constexpr double gamma = 0x1p-4;
    static constexpr double jitter = 0x1p-10;
    // How far from its place, moved as it is, a shell vertex yields: jitter^2 D is at most (2 jitter)^2.
    static constexpr double yields = gamma - 2 * jitter;
    // A new cage is larger by this than what the thesis asks for, so that inputs about as far away as the one that it
    // is made for do not make it grow at once.
    static constexpr double slack = 1.125;
};

// Is v, at this squared distance from the cage's centre, about as far from it as its shell?
inline bool is_by_shell(const Cage& cage, double distance2) {
    constexpr double off = ThesisCage::shell_factor * 2 * ThesisCage::gamma;
    const double d2 = distance2 / (cage.radius * cage.radius);
    constexpr double least = ThesisCage::shell_factor - off, most = ThesisCage::shell_factor + off;
    return d2 >= least * least && d2 <= most * most;
}

// A template that is the set of corners of a polytope around the origin covers worst where the normal of a facet meets
// the sphere.
//
//   D   points                                                    covering angle   packing
//   2   16, a regular polygon                                     11.25 degrees    .3902
//   3   42, the corners of an icosahedron and of its edges' middles    20.91 degrees    .5465
//   4   120, the corners of the 600-cell                          22.24 degrees    .6180
template <int D> struct CageTemplate;

template <> struct CageTemplate<2> {
    static constexpr std::uint32_t size = 16;
    static constexpr double packing = 0.3901;
    static void point(std::uint32_t k, double* x) {
        static constexpr double cosine[] = {1, 0.92387953251128675613, 0.70710678118654752440, 0.38268343236508977173,
                                            0};
        const std::uint32_t quarter = k / 4, step = k % 4;
        const double a = cosine[step], b = cosine[4 - step];
        x[0] = quarter == 0 ? a : quarter == 1 ? -b : quarter == 2 ? -a : b;
        x[1] = quarter == 0 ? b : quarter == 1 ? a : quarter == 2 ? -b : -a;
    }
};

constexpr double golden = 1.6180339887498948482;

template <> struct CageTemplate<3> {
    static constexpr std::uint32_t size = 42;
    static constexpr double packing = 0.5465;
    static void point(std::uint32_t k, double* x) {
        // (0, +-1, +-golden) / |.|, +-1 on an axis, (+-golden, +-1, +-1 / golden) / 2, and their cyclic permutations.
        constexpr double icosahedron = 0.52573111211913360603;  // 1 / sqrt(1 + golden^2)
        const std::uint32_t turn = k % 3, signs = k < 12 ? k / 3 : k < 18 ? (k - 12) / 3 : (k - 18) / 3;
        const double part[] = {k < 12   ? 0
                               : k < 18 ? 1
                                        : 0.5 * golden,
                               k < 12   ? icosahedron
                               : k < 18 ? 0
                                        : 0.5,
                               k < 12   ? icosahedron * golden
                               : k < 18 ? 0
                                        : 0.5 * (golden - 1)};
        const std::uint32_t flips = k < 12 ? signs << 1 : signs;
        for (std::uint32_t i = 0; i < 3; ++i) x[(i + turn) % 3] = (flips >> i & 1u) != 0 ? -part[i] : part[i];
    }
};

template <> struct CageTemplate<4> {
    static constexpr std::uint32_t size = 120;
    static constexpr double packing = 0.618;
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
        static constexpr std::uint8_t places[12][4] = {// where golden, 1, 1 / golden and 0 go
                                                       {0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {1, 0, 3, 2},
                                                       {0, 3, 1, 2}, {3, 1, 0, 2}, {0, 2, 3, 1}, {2, 3, 0, 1},
                                                       {3, 0, 2, 1}, {2, 1, 3, 0}, {1, 3, 2, 0}, {3, 2, 1, 0}};
        for (int i = 0; i < 3; ++i) x[places[even][i]] = (k >> i & 1u) != 0 ? values[i] : -values[i];
        x[places[even][3]] = 0;
    }
};

// The outermost cage has a denser shell, as nothing can be done about a corner that lies beyond it: the centres of
// grid^(D - 1) squares on each facet of a cube, seen from its centre. Along a facet no point is farther than
// sqrt(D - 1) / grid from one of them, and the way to the sphere makes distances no larger.
template <int D> struct RootTemplate {
    static constexpr std::uint32_t grid = D == 4 ? 5 : 6;
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
