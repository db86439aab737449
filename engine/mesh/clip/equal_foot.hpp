// The point nearest to o of those equidistant from the vertices of a simplex, with a bound on its error.
//
// The bisectors of the edges (u, w) of a spanning tree meet in the flat that is meant. Gram and Schmidt's method makes
// normals n orthogonal to each other of the edges d = w - u, and y, at first o, goes to one bisector after the other:
//
//   y := y - (R / (2 |n|^2)) n,   R = |y - u|^2 - |y - w|^2 = d.(2 (y - u) - d);
//
// y - p, p any point of the new flat, is orthogonal to all earlier normals, so R may be taken with d in place of n. The
// tree is a shortest one: edges that lead out of a cluster are not used to tell its points apart.
//
// Roundings. Let e be the unit: an operation multiplies its exact result by 1 + x, |x| <= e. All is relative to one
// vertex, the base. Lengths are Euclidean; a hat marks what is computed; bounds are of first order, and 1.01 covers the
// rest and the roundings of the bounds themselves.
//   - A normal: |n^ - n| <= tilt |n^|. So the unit vectors of both differ by an angle whose sine is at most tilt, and
//     the projections on their lines by as much of what is projected. To take d's projection away costs D e |d| in
//     the product with n^, D + 1 in |n^|^2 and the quotient, 1 in the multiple of n^ and 1 in the difference: (2 D + 3)
//     e |d|. d itself has e |d|. Altogether |n^ - n| <= |d| (e + sum over earlier normals of (tilt + (2 D + 3) e)).
//   - R: a = u - base has the error e |a|, z = y - a that of y, `doubt`, and e |a| + e |z|; 2 z - d three roundings
//     more, of 2 |z|, of d and of the difference; the sum of D products D + 1 of |d| (2 |z| + |d|) with that of d. So R
//     is off by at most |d| (2 doubt + (2 D + 8) e S), S >= |a| + |z| + |d|.
//   - y: an error x of y becomes x - (d.x / |n|^2) n, an oblique projection, whose norm is |d| / |n|. The rest of the
//     error of R moves y by half of it over |n|; the tilt of n by tilt times the step's length, because a / |a|^2 and
//     b / |b|^2 are |a - b| / (|a| |b|) apart; the quotient and the product D + 3 roundings of the step, the difference
//     one of y.
// Underflow: lengths are multiplied by the power of two that brings the ball's radius between 1 and 2, so answers do
// not depend on the unit. Nothing is said of simplices with |n|^2 below normal2_min then; from there on 2^-1074, which
// a product may lose, is less than e times any of the terms above. What bounds lose by it is nothing beside 2^-1000,
// where `doubt` begins; questions about squares of lengths allow 2^-1060.
#pragma once
#include "mesh/domain.hpp"
#include "numerics/bits.hpp"
#include "numerics/wide_float.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

template <class Number> struct Arithmetic;
template <> struct Arithmetic<double> {
    static constexpr double unit = unit_roundoff, normal2_min = 0x1p-940;
    static double zero() { return 0; }
    static double difference(double a, double b, int scale) { return (a - b) * power_of_two(scale); }
    static double square(double a) { return a * a; }
    static double high(double a) { return a; }
};
template <> struct Arithmetic<WideFloat> {
    static constexpr double unit = 0x1p-900, normal2_min = 0x1p-940;  // more than its own: bounds are doubles
    static WideFloat zero() { return WideFloat(0); }
    static WideFloat difference(double a, double b, int scale) { return (WideFloat(a) - WideFloat(b)).scaled(scale); }
    static WideFloat square(double a) { return WideFloat(a) * WideFloat(a); }
    static double high(const WideFloat& a) { return a.rounded(); }
};

// Answers: 1 and -1 are certain, 0 is not.
template <class Number> class EqualFoot {
public:
    // Of the simplex of vertices point[0..n), 1 <= n <= D + 1.
    template <int D>
    EqualFoot(const Domain<D>& ball, const double* const* point, int n)
        : EqualFoot(D, ball.centre, ball.radius, point, n) {}
    EqualFoot(int dim, const double* centre, double radius, const double* const* point, int n)
        : dim_(dim), point_(point), n_(n), scale_(-exponent_of(radius)), radius_(radius * power_of_two(scale_)) {
        double size = 0;
        for (int k = 0; k < dim_; ++k) {
            y_[k] = centre_[k] = A::difference(centre[k], point[0][k], scale_);
            size += size_of(y_[k]);
        }
        doubt_ = unit * size + 0x1p-1000;
        double near2[dim_max + 1];
        int from[dim_max + 1];
        for (int i = 1; i < n; ++i) {
            near2[i] = netmesh::distance2(dim_, point[0], point[i]);
            from[i] = 0;
        }
        for (int step = 1; step < n && doubt_ < infinity; ++step) {
            int next = 0;
            for (int i = 1; i < n; ++i)
                if (near2[i] >= 0 && (next == 0 || near2[i] < near2[next])) next = i;
            meet_bisector(point[from[next]], point[next]);
            near2[next] = -1;
            for (int i = 1; i < n; ++i) {
                if (!(near2[i] >= 0)) continue;
                const double d2 = netmesh::distance2(dim_, point[next], point[i]);
                if (d2 >= near2[i]) continue;
                near2[i] = d2;
                from[i] = next;
            }
        }
    }

    // 1: the foot is outside of the ball, -1: inside.
    int beyond() const {
        Number away2 = A::zero();
        for (int k = 0; k < dim_; ++k) {
            const Number x = y_[k] - centre_[k];
            away2 = away2 + x * x;
        }
        double size = 0;
        for (int k = 0; k < dim_; ++k) size += size_of(centre_[k]);
        const double q = A::high(away2), r2 = radius_ * radius_, away = square_root(q);
        const double moved = doubt_ + unit * (size + away);
        const double slack = 1.01 * (moved * (2 * away + moved) + unit * ((dim_ + 1) * q + 2 * r2)) + underflow;
        return sign(A::high(away2 - A::square(radius_)), slack);
    }

    // 1: the foot is nearer to w than to the vertices, -1: farther.
    int nearer(const double* w) const {
        const double* u = point_[0];
        double best2 = netmesh::distance2(dim_, u, w);
        for (int i = 1; i < n_; ++i) {
            const double d2 = netmesh::distance2(dim_, point_[i], w);
            if (!(d2 < best2)) continue;
            best2 = d2;
            u = point_[i];
        }
        Number d[dim_max];
        const Side side = side_of(u, w, d);
        return sign(A::high(side.gain),
                    1.01 * side.length * (2 * doubt_ + (2 * dim_ + 8) * unit * side.size) + underflow);
    }

private:
    using A = Arithmetic<Number>;
    static constexpr int dim_max = dimension_most();
    static constexpr double unit = A::unit, underflow = 0x1p-1060;

    // R of the head for d = w - u, |d| and S.
    struct Side {
        Number gain;
        double length, size;
    };
    static double size_of(const Number& x) { return absolute(A::high(x)); }
    static int sign(double value, double slack) { return value > slack ? 1 : value < -slack ? -1 : 0; }

    Side side_of(const double* u, const double* w, Number (&d)[dim_max]) const {
        Side side = {A::zero(), 0, 0};
        double length2 = 0;
        for (int k = 0; k < dim_; ++k) {
            const Number a = A::difference(u[k], point_[0][k], scale_), z = y_[k] - a;
            d[k] = A::difference(w[k], u[k], scale_);
            side.gain = side.gain + d[k] * (z + z - d[k]);
            side.size += size_of(a) + size_of(z) + size_of(d[k]);
            length2 += A::high(d[k]) * A::high(d[k]);
        }
        side.length = square_root(length2);
        return side;
    }

    void meet_bisector(const double* u, const double* w) {
        Number(&n)[dim_max] = normal_[count_];
        const Side side = side_of(u, w, n);
        double off = unit;
        for (int i = 0; i < count_; ++i) {
            Number along = A::zero();
            for (int k = 0; k < dim_; ++k) along = along + n[k] * normal_[i][k];
            along = along / length2_[i];
            for (int k = 0; k < dim_; ++k) n[k] = n[k] - along * normal_[i][k];
            off += tilt_[i] + (2 * dim_ + 3) * unit;
        }
        Number length2 = A::zero();
        for (int k = 0; k < dim_; ++k) length2 = length2 + n[k] * n[k];
        const double height2 = A::high(length2), height = square_root(height2), stretch = side.length / height;
        const double tilt = 1.01 * off * stretch;
        if (!(height2 > A::normal2_min && height2 < infinity && tilt < 0x1p-10)) {
            doubt_ = infinity;  // flat
            return;
        }
        const Number step = side.gain / (length2 + length2);
        double size = 0;
        for (int k = 0; k < dim_; ++k) {
            y_[k] = y_[k] - step * n[k];
            size += size_of(y_[k]);
        }
        doubt_ = 1.01 * (stretch * (doubt_ + (dim_ + 4) * unit * side.size) +
                         size_of(step) * height * (tilt + (dim_ + 3) * unit) + unit * size);
        length2_[count_] = length2;
        tilt_[count_++] = tilt;
    }

    const int dim_;
    const double* const* const point_;
    const int n_;
    const int scale_;                      // lengths are multiplied by 2^scale_, so that the radius is between 1 and 2
    const double radius_;                  // of the ball
    int count_ = 0;                        // normals
    Number y_[dim_max], centre_[dim_max];  // the foot and o, relative to point[0]
    double doubt_;  // the foot is within this of the true one; infinite for simplices that may be flat
    Number normal_[dim_max][dim_max];  // orthogonal
    Number length2_[dim_max];          // of the normals
    double tilt_[dim_max];
};

}  // namespace netmesh
