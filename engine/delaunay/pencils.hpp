// The balls of many new cells at a time, each from the two balls of its pencil, as pencil_sphere makes one. A part of
// kernel.cpp.
#pragma once
#include <utility>

#include "delaunay/sphere.hpp"

namespace netmesh {

#ifndef __OPTIMIZE_SIZE__

// Columns, so that several cells are computed at a time.
template <int D, std::uint32_t most> struct Pencils {
    struct Ball {
        double centre[D][most], radius2[most], error[most];
        double power[most], bound[most];  // what power() says of the new point

        void put(const Cell<D>& cell, std::uint32_t k) {
            for (int i = 0; i < D; ++i) centre[i][k] = cell.centre[i];
            radius2[k] = cell.radius2;
            error[k] = cell.error;
        }
    } in, out;  // in conflict with the new point, and not

    // Takes ball k from what mix() has left of it, if its error bound is below the one with the square error2_max.
    bool get(std::uint32_t k, double error2_max, Cell<D>& cell) const {
        for (int i = 0; i < D; ++i) cell.centre[i] = in.centre[i][k];
        cell.radius2 = in.radius2[k];
        cell.error = static_cast<float>(in.error[k]);
        return static_cast<std::uint32_t>(in.power[k] < error2_max) &
               static_cast<std::uint32_t>(in.radius2[k] > 0x1p-800);
    }
    // The powers of the first `count` pairs of balls, operation by operation as power() has them. height: with weights
    // that of q.
    template <bool weighted = false> void measure(const double* q, std::uint32_t count, double height = 0) {
        measure<weighted>(in, q, count, height, Axes{});
        measure<weighted>(out, q, count, height, Axes{});
    }
    // pencil_sphere of the first `count` pairs of balls, operation by operation, into `in`; the square of the error
    // bound, +infinity where the powers are too uncertain, into its powers. Written so that compilers make vectors of
    // it: no branch, no inner loop, no condition before a division.
    template <bool weighted = false>
    [[gnu::noinline]] void mix(const double* q, std::uint32_t count, double height = 0) {
        mix<weighted>(q, count, height, Axes{});
    }

private:
    using Axes = std::make_integer_sequence<int, D>;

    template <bool weighted, int... I>
    [[gnu::noinline]] static void measure(Ball& ball, const double* q, std::uint32_t count, double height,
                                          std::integer_sequence<int, I...>) {
        constexpr int roundings = weighted ? D + 12 : D + 8;
        const double at[D] = {q[I]...};
        for (std::uint32_t k = 0; k < count; ++k) {
            const double d[D] = {(at[I] - ball.centre[I][k])...};
            const double d2 = weighted ? height + sum_of_squares<I...>(d) : sum_of_squares<I...>(d);
            ball.bound[k] = (ball.error[k] + roundings * unit_roundoff) * (d2 + 3 * ball.radius2[k]) + 0x1p-960;
            ball.power[k] = d2 - ball.radius2[k];
        }
    }
    template <int... I> [[gnu::always_inline]] static double sum_of_squares(const double (&d)[D]) {
        return (... + (d[I] * d[I]));
    }
    template <bool weighted, int... I>
    [[gnu::always_inline]] void mix(const double* q, std::uint32_t count, double height,
                                    std::integer_sequence<int, I...>) {
        constexpr double u = unit_roundoff;
        const double at[D] = {q[I]...};
        for (std::uint32_t k = 0; k < count; ++k) {
            const double b = -in.power[k], a = out.power[k], bound_in = in.bound[k], bound_out = out.bound[k];
            const double sum = a + b, inverse = 1 / sum;
            const double w = a * inverse, v = b * inverse;
            const double d[D] = {(in.centre[I][k] - out.centre[I][k])...};
            const double x[D] = {(out.centre[I][k] + w * d[I])...};
            const double e[D] = {(at[I] - x[I])...};
            const double apart2 = sum_of_squares<I...>(d);
            const double size2 = sum_of_squares<I...>(x);
            const double radius2 = weighted ? height + sum_of_squares<I...>(e) : sum_of_squares<I...>(e);
            const double in2 = in.error[k] * in.error[k] * in.radius2[k];
            const double out2 = out.error[k] * out.error[k] * out.radius2[k];
            const double w_error = 1.02 * (w * bound_in + v * bound_out) * inverse + 8 * u;
            const double distance2 = 2.3 * (w * in2 + v * out2 + w_error * w_error * apart2) + (50 * u * u) * size2;
            const double error2 = distance2 / radius2;
            ((in.centre[I][k] = x[I]), ...);
            in.radius2[k] = radius2;
            in.error[k] = 1.01 * square_root(error2);
            in.power[k] = bound_in + bound_out < 0x1p-6 * sum ? error2 : infinity;
        }
    }
};

#endif

}  // namespace netmesh
