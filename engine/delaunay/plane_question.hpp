// Vertices in the plane as seen from the point in question, and what in-circle determinants of them err by. A part of
// plane.hpp.
#pragma once
#include <cstddef>

#include "numerics/real.hpp"
#include "predicates/weighted.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {

// A vertex as seen from the point in question q. Infinity is (0, 0, the square of the points' extent): with it the
// in-circle determinant of a ghost is a positive multiple of the orientation of its edge and q.
struct PlaneArm {
    double x, y, lift;
    double square() const { return lift; }  // of its length
    double size() const { return lift; }    // what errors of the lift are relative to
};
// With weights the lift is the square less the difference of the weights.
struct WeightedArm {
    double x, y, lift, length2, sum;
    double square() const { return length2; }
    double size() const { return sum; }
};
template <class Arm> inline double cross(const Arm& a, const Arm& b) { return a.x * b.y - a.y * b.x; }

// What is asked about a point, by value, so that loops have it in registers.
template <class W> struct PlaneQuestion;
template <> struct PlaneQuestion<NoWeights> {
    using Arm = PlaneArm;
    static constexpr std::size_t numbers = 2;
    const double* points;  // [vertex][numbers]
    double x, y;           // q
    double extent2;        // square of the points' extent, or more
    double underflow;      // what in-circle determinants lose to it; +infinity: anything

    PlaneArm arm_to(VertexId v) const {
        if (v == none) return {0, 0, extent2};
        const double dx = points[2 * std::size_t{v}] - x, dy = points[2 * std::size_t{v} + 1] - y;
        return {dx, dy, dx * dx + dy * dy};
    }
    // What the in-circle determinant of arms with these lifts errs by at most: the bound of planar_stage.hpp, where
    // |x y'| + |y x'| <= (lift + lift') / 2 takes the place of the terms of a cross product.
    double error_of(double a, double b, double c) const {
        return 11 * unit_roundoff * (a * b + b * c + c * a) + underflow;
    }
    void ask(const double* q) {
        x = q[0];
        y = q[1];
    }
};
// A lift carries two roundings more than without weights, at most, relative to square + |difference of weights|, which
// takes the place of the lift in the bound; 13 covers that and the bound's own.
template <> struct PlaneQuestion<Weights> {
    using Arm = WeightedArm;
    static constexpr std::size_t numbers = 3;
    const double* points;
    double x, y, number;
    double extent2;  // and more than any difference of weights
    double underflow;
    Weights weights;

    WeightedArm arm_to(VertexId v) const {
        if (v == none) return {0, 0, extent2, 0, extent2};
        const double* const p = points + 3 * std::size_t{v};
        const double dx = p[0] - x, dy = p[1] - y, less = weights.difference(number, p[2]), square = dx * dx + dy * dy;
        return {dx, dy, square + less, square, square + __builtin_fabs(less)};
    }
    double error_of(double a, double b, double c) const {
        return 13 * unit_roundoff * (a * b + b * c + c * a) + underflow;
    }
    void ask(const double* q) {
        x = q[0];
        y = q[1];
        number = q[2];
    }
};

}  // namespace netmesh
