// Circumscribed spheres and smallest enclosing balls of a few points.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tools/opinion/wide.hpp"

namespace netmesh::tool {

using Real = long double;
using Place = std::vector<Real>;  // a point of R^D
using WidePlace = std::vector<Wide>;

Real distance2(const Place& a, const Place& b);
inline Real dot(const Place& a, const Place& b) {
    Real sum = 0;
    for (std::size_t k = 0; k < a.size(); k++) sum += a[k] * b[k];
    return sum;
}
inline void add(Place* a, Real factor, const Place& b) {
    for (std::size_t k = 0; k < a->size(); k++) (*a)[k] += factor * b[k];
}

// The centre is kept from one of the points on: as a place it would be rounded to the points' magnitude, which can be
// far above the radius.
struct Sphere {
    Place point;
    WidePlace offset;
    Real radius = 0;
    Real error = 0;   // the true centre is no farther away; at most 2^-45 times the radius
    Real volume = 1;  // of the parallelepiped that the points span

    Place centre() const;
    Real distance_to_centre(const Place& place) const;
    // 1: the place, of doubles, lies inside; -1: outside; 0: not known, or on the sphere.
    int holds(const Place& place) const;
};

// The smallest sphere through 1 to D+1 affinely independent points whose coordinates are doubles; false when its error
// would be larger than 2^-45 times its radius: then they are dependent but for their last digits. With an error of at
// most `enough` times the radius long doubles do, which is much faster than twice their digits.
bool smallest_circumsphere(const std::vector<Place>& points, Sphere* sphere, Real enough = 0);

// The radius of the smallest ball that contains the points: the least sphere through some of them that contains all.
Real enclosing_radius(const std::vector<Place>& points);

}  // namespace netmesh::tool
