// Cages and the hierarchy of domains that they bound (thesis 4.5).
//
// A cage is a ball about an input, its centre, that has room on both sides. With e = cage_epsilon and r its radius:
//
//   distance from the centre   0 ......... e r ............ r ................... 2 r / e .....
//                              | the inputs | no input, shell | no vertex, no input | outside |
//
// (Other cages may reach in with their shells and Steiner points, not with their centres, and the shell of a cage that
// has been released stays where it is.)
//
// The shell is a net on the sphere of radius shell_factor * r: the 2 D corners of a cross-polytope, whose covering
// radius sqrt(2 - 2 / sqrt D) is the thesis's delta, moved by a little (gamma) so that it is not cospherical. One of
// them is in the direction of the farthest input, and all are about as far out as the cage reaches: whole cells leave
// the cage where inputs, or the shell of a cage about one, are near a facet of the shell's hull, which is only
// shell_factor / sqrt D radii away (engine/decisions/compact-cages.md has figures). A smaller e asks for wider gaps. A
// domain is a ball without the balls of the cages directly inside it; the outermost domain is the mesh's own ball,
// domain.hpp. The cells inside a cage keep their quality clipped to the ball of radius e r, as those of the outermost
// domain do clipped to its ball; the cells of a cage's vertices together make up one cell of the domain around it,
// which keeps its quality too.
#pragma once
#include <cstdint>

#include "delaunay/store.hpp"
#include "mesh/domain.hpp"
#include "numerics/vector.hpp"

namespace netmesh {

constexpr double cage_epsilon = 1.0 / 2;
// No vertex but the shell's lies between 1 and this many radii from the centre: 2 / e.
constexpr double cage_clearance = 2 / cage_epsilon;
constexpr double shell_factor = 0.985;
constexpr std::uint32_t shell_size_of(int dim) { return 2 * static_cast<std::uint32_t>(dim); }
// Shell vertices are moved by at most this times the radius of their sphere along each axis of the cross-polytope.
constexpr double shell_jitter = 0x1p-8;
// They are at least so many radii from the centre. Checks and bounds go by this, for files with shells at .9 radii.
constexpr double shell_least = 27.0 / 32;

enum class CageKind {
    compact,  // those of this file
    thesis,   // cage_template.hpp
};

// Domains are named by the index of their cage, the outermost one by `none`.
struct Cage {
    std::uint32_t centre;  // an input
    std::uint32_t parent;  // the domain around it
    std::uint32_t shell;   // first of its 2 D shell vertices; none when released
    std::uint32_t next;    // scratch of whoever walks over cages
    double radius;
    double nearest2;  // squared distance from the centre to the nearest vertex outside: f_M of the cage, squared
    double clip;      // compact cages: radius of the ball that the cells inside are clipped to, see is_growing
};

template <int D> inline bool is_inside(const Store<D>& store, const Cage& cage, const double* x) {
    return distance2<D>(store.dim, x, store.point(cage.centre)) < cage.radius * cage.radius;
}

// In-radius of the cell of a cage (thesis 4.6): half of the way to the nearest vertex outside, measured from the shell.
inline double in_radius(const Cage& cage) { return 0.5 * (square_root(cage.nearest2) + shell_least * cage.radius); }

// The ball that cells are clipped to is that of e r until the cage is to be released: then it grows first, so that
// cells beside it never reach much farther at once (hierarchy_rule.hpp).
inline bool is_growing(const Cage& cage) { return cage.clip > cage_epsilon * cage.radius; }

// The ball that the cells of a domain's vertices are clipped to.
template <int D>
inline Domain<D> domain_ball(const Store<D>& store, const Cage* cages, std::uint32_t domain,
                             const Domain<D>& outermost) {
    if (domain == none) return outermost;
    Domain<D> ball;
    copy<D>(store.dim, store.point(cages[domain].centre), ball.centre);
    ball.radius = ball.enclosing_radius = cages[domain].clip;
    return ball;
}

// Does cell c have vertices inside and outside of the cage? Infinity is outside.
template <int D> inline bool is_on_boundary(const Store<D>& store, const Cage& cage, std::uint32_t c) {
    bool inside = false, outside = false;
    for (const std::uint32_t v : store.cell(c).vertex)
        (v != none && is_inside<D>(store, cage, store.point(v)) ? inside : outside) = true;
    return inside && outside;
}

// Are there vertices inside and outside of the cage among those of facet i of cell c? Then the edge behind it is one
// of the cage's cell.
template <int D> inline bool is_mixed(const Store<D>& store, const Cage& cage, std::uint32_t c, int i) {
    bool inside = false, outside = false;
    for (int k = 0; k <= store.dim; ++k) {
        const VertexId v = store.cell(c).vertex[k];
        if (k != i) (v != none && is_inside<D>(store, cage, store.point(v)) ? inside : outside) = true;
    }
    return inside && outside;
}

}  // namespace netmesh
