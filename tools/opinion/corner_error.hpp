// How far off a corner of a Voronoi cell may be where it was found in doubles, as proven from its Delaunay cell alone.
//
// Edges e_i from a vertex p_0 of the cell, R the radius of the ball around it, u = 2^-53. The corner is p_0 + x with
// e_i . x = |e_i|^2 / 2, by Cramer's rule. The products of a minor of k rows have absolute values that add up to at
// most k! / k^(k/2) times the product of the edges' lengths, the permanent's largest value on unit vectors. |e_i|^2 / 2
// <= R |e_i| stands in one row for a numerator, so the products of one add up to at most D c_(D-1) R times the product
// of all lengths. At most m = (D+1)(D+2)/2 + D + 8 roundings take part in each of them: two for an entry, D + 6 for
// |e_i|^2 / 2, those of sums and products of minors, the quotient. So with V = |det E| each coordinate of x is off by
// at most
//
//   m u R (D c_(D-1) + c_D) product of |e_i| / V   to first order;
//
// times sqrt(D) as a vector, times 3 for a determinant that may be half of what it should be and a radius that is off
// by as much, and 1.47 for adding the rounding of coordinates in squares. A proof that is no worse than 2^-22 is taken
// as it is; else the corner is found with more digits, and only the rounding of its coordinates is left. Any vertex may
// have been the first.
#pragma once
#include <vector>

#include "tools/opinion/spheres.hpp"

namespace netmesh::tool {

struct CornerError {
    Real shape = 0;        // over R, from the cell's shape
    Real coordinates = 0;  // over R, from the corner's coordinates
};
// Of D+1 points with a circumscribed sphere.
CornerError corner_error(const std::vector<Place>& points, const Sphere& sphere);

}  // namespace netmesh::tool
