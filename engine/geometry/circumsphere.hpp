// Smallest circumspheres of simplices in R^D and the side on which each vertex lies of the others' sphere.
//
// The radius is the true one rounded to the nearest double, ties to even: a function of the vertices alone, whatever
// their order and whoever computes it. Beyond the largest double it is infinite, and below the least one it is 0.
#pragma once
#include <cstdint>

namespace netmesh {

// Of a k-simplex with vertices 0..k:
//   radius   of its smallest circumsphere
//   within   bit i set: vertex i lies inside or on the smallest circumsphere of the facet opposite it (then that
//            facet's sphere is not empty, or it is the simplex's own sphere)
//
// The centre c is the point of the simplex's affine hull with barycentric coordinates beta, and vertex i lies outside
// the sphere of its facet exactly when beta_i > 0: c is then on i's side of the facet. One solve thus answers for the
// simplex and for all of its facets. The method is Gram-Schmidt with pivoting on the edge vectors from vertex 0, whose
// error grows with the condition of the edge vectors, not with its square as that of their Gram matrix does.
struct Circumsphere {
    double radius;
    std::uint32_t within;
};

// What the float stage (circumsphere_fast.hpp) is certain of. What it is not is left to a closer look
// (circumsphere_close.hpp), and then to the exact stage (circumsphere_exact.hpp). Bit i is simplex i of those that were
// asked for at the same time.
struct Certainty {
    std::uint32_t within, radius;
};

}  // namespace netmesh
