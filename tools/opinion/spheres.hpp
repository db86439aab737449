// Circumscribed spheres and smallest enclosing balls of a few points, in long doubles.
#pragma once
#include <cstdint>
#include <vector>

namespace netmesh::tool {

using Real = long double;
using Place = std::vector<Real>;  // a point of R^D

Real distance2(const Place& a, const Place& b);

// The centre is kept from one of the points on: as a place it would be rounded to the points' magnitude, which can be
// far above the radius.
struct Sphere {
    Place point, offset;
    Real radius = 0;

    Place centre() const;
    Real distance_to_centre(const Place& place) const;
};

// The smallest sphere through 1 to D+1 affinely independent points; false when they are not, to working precision.
bool smallest_circumsphere(const std::vector<Place>& points, Sphere* sphere);

// The radius of the smallest ball that contains the points: the least sphere through some of them that contains all.
Real enclosing_radius(const std::vector<Place>& points);

}  // namespace netmesh::tool
