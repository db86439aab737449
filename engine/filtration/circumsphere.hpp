// Smallest circumspheres of simplices in R^D and the side on which each vertex lies of the others' sphere.
#pragma once
#include <cstdint>

namespace netmesh {

// Of a k-simplex with vertices 0..k:
//   radius   of its smallest circumsphere; at most the largest finite double
//   within   bit i set: vertex i lies inside or on the smallest circumsphere of the facet opposite it (then that
//   facet's
//            sphere is not empty, or it is the simplex's own sphere)
//   volume   of the float stage: squared volume of the edge vectors over their squared lengths, in (0, 1]: how good it
//   is
//
// The centre c is the point of the simplex's affine hull with barycentric coordinates beta, and vertex i lies outside
// the sphere of its facet exactly when beta_i > 0: c is then on i's side of the facet. One solve thus answers for the
// simplex and for all of its facets. The method is Gram-Schmidt with pivoting on the edge vectors from vertex 0, whose
// error grows with the condition of the edge vectors, not with its square as that of their Gram matrix does.
struct Circumsphere {
    double radius;
    std::uint32_t within;
    double volume;
};

// In doubles. False when the result is not certain: the simplex is flat for the precision, its size is far from 1, or
// some beta_i is too close to 0 to tell its sign. Otherwise `within` is exact, and the radius is off by at most
// radius_error of the true one. point: k+1 addresses of D coordinates. 2 <= k <= D. Body and proof:
// circumsphere_fast.hpp.
template <int K, int D> bool circumsphere_fast(const double* const* point, Circumsphere* out);
template <int K, int D> double radius_error(double volume);

// In about 106 bits, any finite coordinates. A centre that lies on a facet to within 2^-80 radii counts as on it: the
// two spheres are then the same in all bits that matter, and noise does not decide. The radius is nearly always
// correctly rounded; it loses digits in simplices flatter than 1 : 2^50, whose spheres are mostly as much larger than
// themselves. When the precision cannot tell the simplex from a flat one, the radius is very large and the signs are
// those of the limit. 1 <= k <= dim <= 6.
Circumsphere circumsphere_precise(const double* const* point, int k, int dim);

// A bound on how far `radius` is from that of the smallest ball that contains the simplex, relative to the latter,
// whatever the simplex and whoever computed the radius: about 2^-51 where that is nearly right. Infinite for
// sizes below 2^-900 and coordinates above 2^980. O(2^k) solves of circumsphere_precise; 1 <= k <= dim.
double enclosing_error(const double* const* point, int k, int dim, double radius);

}  // namespace netmesh
