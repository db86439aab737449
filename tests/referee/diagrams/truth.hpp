// True diagrams of few points, in rational arithmetic and from the definitions: nerves of convex covers.
//
//   offsets        balls about the points; a set of balls meets from the radius of its smallest enclosing ball on
//   d_k            places within r of k points: for each k points the places within r of all of them, convex, and a set
//                  of those meets when the balls about all points of all its members do
//   k-distance     its square at x is the least, over all sets K of k points, of |x - b|^2 + v, with b the mean of K
//   and
//                  v the mean square distance from b: balls again, about b, of square radius r^2 - v
//   Rips           sets of points enter with half of their longest distance
//
// Each is a complex whose simplices enter at an exact square of a radius.
#pragma once
#include "../exact.hpp"
#include "complex.hpp"

namespace referee {

struct TrueBar {
    int degree;
    std::uint32_t birth, death;  // ranks in `squares`; `never` for an essential class
};

struct Truth {
    std::vector<Rational> squares;  // of radii, ascending, all different
    std::vector<TrueBar> bars;      // of positive length
    int top = 0;                    // degrees 0 .. top are there
};

using ExactPoint = Vector<Rational>;

// Sets of points that a truth can be had of; k = 1 for offsets. False: too many for a nerve in that dimension.
bool is_feasible(std::size_t points, std::size_t k, int dim, std::size_t sets_max);

// Of each set of 1 .. size points the radius of its smallest enclosing ball, rounded once.
std::map<Simplex, double> enclosing_radii(const std::vector<Point>& points, int dim, std::size_t size);

Truth true_offsets(const std::vector<Point>& points, int dim);
Truth true_kth(const std::vector<Point>& points, int dim, std::size_t k);
Truth true_k_distance(const std::vector<Point>& points, int dim, std::size_t k);
Truth true_rips(const std::vector<Point>& points, int dim, int top);

}  // namespace referee
