// The ball in which mesh quality is promised, and Voronoi edges clipped to it.
#pragma once
#include <cstdint>

#include "delaunay/store.hpp"
#include "numerics/vector.hpp"

namespace netmesh {

template <int D> struct Domain {
    static constexpr int dim = D;
    double centre[D];
    double radius;
    double enclosing_radius;  // of a ball about `centre` that contains all inputs: rho of the certificate, or more

    double distance2(const double* x) const { return netmesh::distance2<D>(x, centre); }
    bool contains(const double* x) const { return distance2(x) <= radius * radius; }
};

// Cells may be clipped to a ball of this many enclosing radii (RatioGoal::clipped): a hair more than 1, so that no
// input is near its sphere.
constexpr double clip_factor = 1 + 0x1p-9;

// Points of dim coordinates, the first at `first`, each stride_bytes behind the one before.
struct PointRows {
    int dim;
    const unsigned char* first;
    std::ptrdiff_t stride_bytes;
    std::uint32_t count;

    const double* operator[](std::uint32_t i) const {
        return reinterpret_cast<const double*>(first + static_cast<std::ptrdiff_t>(i) * stride_bytes);
    }
};
double enclosing_radius_of_inputs(const PointRows& points, const Arena& arena, double* centre);

// Smallest enclosing ball of vertices 0..count-1: exact up to rounding where the search converges, never too small by
// more than rounding, as the radius is the largest distance from the centre found, enlarged by 8 u. Fischer and
// Gaertner's bases by exhaustion over at most D+2 points; O(n) a step, few steps. A single point gets a radius of its
// own magnitude, at least 1. domain.radius is left 0.
template <int D> inline void smallest_enclosing_ball(const Store<D>& store, std::uint32_t count, Domain<D>& domain) {
    const PointRows points = {D, store.coordinate_base(), Store<D>::vertex_stride, count};
    domain.enclosing_radius = enclosing_radius_of_inputs(points, store.arena, domain.centre);
    domain.radius = 0;
}

// The same for points[count][dim], count >= 1: *radius is 0 for a single point.
void smallest_enclosing_ball(int dim, const double* points, std::uint32_t count, double* centre, double* radius);
template <int D>
inline void smallest_enclosing_ball(const double* points, std::uint32_t count, double* centre, double* radius) {
    smallest_enclosing_ball(D, points, count, centre, radius);
}

// The points (0, 1 or 2) in which the segment a-b crosses a sphere, written to z. Measured from the nearer
// end, as the other one may be farther away than its digits reach.
[[gnu::always_inline]] inline int sphere_crossings(int dim, const double* centre, double radius, const double* a,
                                                   const double* b, double* const (&z)[2]) {
    double a2 = 0, b2 = 0, between = 0;
    for (int k = 0; k < dim; ++k) {
        const double e = a[k] - centre[k], f = b[k] - centre[k];
        a2 += e * e;
        b2 += f * f;
        between += e * f;
    }
    const double least2 = b2 < a2 ? b2 : a2;
    // Both ends outside and leading away from the nearer one, as surely as digits tell: the usual case outside.
    if (least2 > radius * radius && between - least2 > 0x1p-30 * (a2 + b2)) return 0;
    if (b2 < a2) {
        const double* const nearer = b;
        b = a;
        a = nearer;
    }
    double along = 0, length2 = 0, from2 = 0;
    for (int k = 0; k < dim; ++k) {
        const double e = b[k] - a[k], f = a[k] - centre[k];
        along += e * f;
        length2 += e * e;
        from2 += f * f;
    }
    const double rest = from2 - radius * radius;
    if ((rest > 0 && !(along < 0)) || !(length2 > 0)) return 0;  // outside and leading away, or no segment
    // Passes by, well apart: told without a root.
    const double level = rest * length2;
    if (level > 0x1p-900 && along * along < level * (1 - 0x1p-30)) return 0;
    // Distances from a, with no more than squares of lengths on the way, so that any scale will do.
    const double length = square_root(length2), height = along / length;
    const double root2 = height * height - rest;
    if (!(root2 >= 0)) return 0;
    // One from the larger sum, the other from their product: no cancellation.
    const double root = square_root(root2), sum = height > 0 ? -height - root : root - height;
    const double distances[2] = {sum, sum != 0 ? rest / sum : 0};
    int found = 0;
    for (const double t : distances) {
        if (!(t > 0 && t < length)) continue;
        for (int k = 0; k < dim; ++k) z[found][k] = a[k] + t / length * (b[k] - a[k]);
        ++found;
    }
    return found;
}

// The same, once in the program.
int any_sphere_crossings(int dim, const double* centre, double radius, const double* a, const double* b,
                         double* const (&z)[2]);

template <int D>
inline int sphere_crossings(const Domain<D>& domain, const double* a, const double* b, double (&z)[2][D]) {
    if constexpr (shared_dimension<D> == D && fast_dimension_max > 0)
        return sphere_crossings(D, domain.centre, domain.radius, a, b, {z[0], z[1]});
    else
        return any_sphere_crossings(D, domain.centre, domain.radius, a, b, {z[0], z[1]});
}

}  // namespace netmesh
