// Prints the operations of the floating-point stages as the engine's own headers make them: the headers of the stages
// are compiled with a number that records what is done to it in place of double. Lines, n being a number's line:
//
//     trace STAGE DIM LIFTED             input POINT COORDINATE
//     + - * / A B, sqrt neg abs A        operations; an operand is #N, the Nth of inputs and operations, or a constant
//     < <= > >= == A B OUTCOME           what a comparison said on the sample
//     out NAME A, sign S, exponent ROW E results, and the exponents of a frame
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include "numerics/bits.hpp"
#include "numerics/real.hpp"
#include "numerics/square_root.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {

// A number of the sample, and the line that made it: 0 for constants, which are computed as the compiler does.
struct Traced {
    double value = 0;
    int line = 0;
    static int lines;

    constexpr Traced() = default;
    constexpr Traced(double x) : value(x) {}
    constexpr Traced(double x, int made_by) : value(x), line(made_by) {}
};
int Traced::lines = 0;

void print_operand(Traced x) {
    if (x.line != 0)
        std::printf(" #%d", x.line);
    else
        std::printf(" %a", x.value);
}
Traced made(const char* operation, double value, std::initializer_list<Traced> operands) {
    std::printf("%s", operation);
    for (const Traced& x : operands) print_operand(x);
    std::printf("\n");
    return {value, ++Traced::lines};
}
bool compared(const char* operation, bool outcome, Traced a, Traced b) {
    std::printf("%s", operation);
    print_operand(a);
    print_operand(b);
    std::printf(" %d\n", outcome);
    return outcome;
}

#define TRACED_OPERATION(SIGN)                                                                                         \
    constexpr Traced operator SIGN(Traced a, Traced b) {                                                               \
        if (a.line == 0 && b.line == 0) return a.value SIGN b.value;                                                   \
        return made(#SIGN, a.value SIGN b.value, {a, b});                                                              \
    }                                                                                                                  \
    constexpr Traced& operator SIGN##=(Traced& a, Traced b) { return a = a SIGN b; }
TRACED_OPERATION(+)
TRACED_OPERATION(-)
TRACED_OPERATION(*)
TRACED_OPERATION(/)
#define TRACED_COMPARISON(SIGN)                                                                                        \
    constexpr bool operator SIGN(Traced a, Traced b) {                                                                 \
        if (a.line == 0 && b.line == 0) return a.value SIGN b.value;                                                   \
        return compared(#SIGN, a.value SIGN b.value, a, b);                                                            \
    }
TRACED_COMPARISON(<)
TRACED_COMPARISON(<=)
TRACED_COMPARISON(>)
TRACED_COMPARISON(>=)
TRACED_COMPARISON(==)
constexpr Traced operator-(Traced a) { return a.line == 0 ? Traced(-a.value) : made("neg", -a.value, {a}); }
Traced traced_absolute(Traced a) {
    return a.line == 0 ? Traced(std::fabs(a.value)) : made("abs", std::fabs(a.value), {a});
}
Traced square_root(Traced a) {
    return a.line == 0 ? Traced(std::sqrt(a.value)) : made("sqrt", std::sqrt(a.value), {a});
}
// An exponent is a number of the sample, nothing to be rounded.
int exponent_of(Traced a) { return exponent_of(a.value); }

}  // namespace netmesh

#define double Traced
#define __builtin_fabs traced_absolute
#include "predicates/cascade.hpp"
#include "predicates/power_stage.hpp"
namespace netmesh {
#include "arms.hpp"  // a part of delaunay/plane_question.hpp, written by check.py
}
#undef double
#undef __builtin_fabs

namespace netmesh {

Decision decide_undecided(int, bool, const Traced* const*, const FloatResult&) { return decide(0, false, stage_exact); }

// Points about the last one of which row `longest` is the longest, on one side or the other.
struct Sample {
    Traced coordinate[frame_rows_max + 1][dimension_most() + 1];
    const Traced* point[frame_rows_max + 1];

    Sample(const char* name, int dim, bool lifted, int longest, bool mirrored, double spread, double rest = 1) {
        std::printf("trace %s %d %d\n", name, dim, lifted);
        Traced::lines = 0;
        const int rows = frame_rows(dim, lifted);
        for (int i = 0; i <= rows; ++i) {
            for (int c = 0; c < dim; ++c) {
                const int k = mirrored && i < 2 ? 1 - i : i;
                double x = i == rows ? 0.0 : k == c ? 1.5 : 0.01 * ((7 * k + 3 * c) % 5);
                if (i == dim && i < rows) x = -0.5 - 0.01 * c;
                if (i != rows) x *= i == longest ? spread : rest;
                coordinate[i][c] = {x, ++Traced::lines};
                std::printf("input %d %d\n", i, c);
            }
            point[i] = coordinate[i];
        }
    }
    // Behind the coordinates a number, as weights have it; that of row `longest` is larger by `more`.
    void weigh(int dim, int longest, double more) {
        for (int i = 0; i <= dim + 1; ++i) {
            coordinate[i][dim] = {0.1 + 0.01 * i + (i == longest ? more : 0), ++Traced::lines};
            std::printf("input %d %d\n", i, dim);
        }
    }
};

void print_result(const char* name, Traced x) {
    std::printf("out %s", name);
    print_operand(x);
    std::printf("\n");
}
void print_bounds(FloatResult result) {
    print_result("determinant", result.determinant);
    print_result("magnitude", result.magnitude);
}

template <bool lifted> void trace_plane() {
    for (bool mirrored : {false, true}) {
        const Sample sample("plane", 2, lifted, -1, mirrored, 1);
        std::printf("sign %d\n", planar_stage<lifted>(sample.point));
    }
}

// The in-circle tests of delaunay/plane.hpp, whose two lines check.py compares. kind: 0 without weights, 1 weights, 2
// radii.
template <class W> void trace_arms(int kind) {
    for (bool walks : {false, true}) {
        std::printf("trace arms %d 1\n", 2 + kind);
        Traced::lines = 0;
        Traced number[4][PlaneQuestion<W>::numbers];
        for (int i = 0; i < 4; ++i)
            for (int c = 0; c < static_cast<int>(PlaneQuestion<W>::numbers); ++c) {
                number[i][c] = {0.3 * i + 0.1 * c * i * i + 0.5 * (c == 2), ++Traced::lines};
                std::printf("input %d %d\n", i, c);
            }
        PlaneQuestion<W> question = {};
        question.points = number[0];
        question.underflow = 0x1p-790;
        if constexpr (W::has) question.weights.are_radii = kind == 2;
        question.ask(number[3]);
        const auto a = question.arm_to(VertexId(0)), b = question.arm_to(VertexId(1)), c = question.arm_to(VertexId(2));
        if (walks) {
            const Traced side[3] = {cross(b, c), cross(c, a), cross(a, b)};
            print_result("value", a.lift * side[0] + b.lift * side[1] + c.lift * side[2]);
        } else {
            const Traced up = cross(b, c), down = cross(c, a), edge = cross(b, a);
            print_result("value", b.lift * down + a.lift * up - c.lift * edge);
        }
        print_result("error", question.error_of(a.size(), b.size(), c.size()));
        print_result("side", cross(a, b));
        print_result("side_error", 4 * unit_roundoff * (a.square() + b.square()) + 0x1p-960);
    }
}

template <int D, bool lifted> void trace_stages() {
    constexpr int rows = frame_rows(D, lifted);
    Traced minors[binomial(rows, D)];
    bool minors_exact;
    for (int longest = 0; longest < (lifted ? rows : 1); ++longest) {
        const Sample sample("stage", D, lifted, longest, false, 3);
        const FloatResult result = float_stage<D, lifted>(sample.point, lifted ? minors : nullptr);
        print_bounds(result);
        std::printf("sign %d\n", is_sure<D, lifted>(result));
    }
    for (double spread : {0x1p-500, 0x1p500})
        for (int row = 0; row < rows; ++row) {
            const Sample sample("refused", D, lifted, row, false, spread);
            print_bounds(float_stage<D, lifted>(sample.point, lifted ? minors : nullptr));
        }
    for (bool mirrored : {false, true}) {
        const Sample sample("decide", D, lifted, 0, mirrored, 3);
        Decision decision = {};
        if constexpr (lifted)
            decision = decide_in_ball<D>(sample.point, minors, &minors_exact);
        else
            decision = decide_orient<D>(sample.point);
        std::printf("sign %d\n", decision.stage == stage_float ? static_cast<int>(decision.sign) : 9);
    }
#ifndef __OPTIMIZE_SIZE__
    // One row shorter or longer than the others, by so much that its lift is the only one left.
    const double spreads[][2] = {{0x1p-900, 1}, {0x1p900, 1}, {0x1p1000, 0x1p-1010}};
    for (const auto& spread : spreads)
        for (int longest = 0; longest < rows; ++longest) {
            const Sample sample("scaled", D, lifted, longest, false, spread[0], spread[1]);
            Frame frame = {};
            frame.base = sample.point[rows];
            for (int i = 0; i < rows; ++i) {
                frame.row[i] = sample.point[i];
                frame.exponent[i] = difference_exponent(D, frame.row[i], frame.base);
                std::printf("exponent %d %d\n", i, frame.exponent[i]);
            }
            const FloatResult result = float_stage_scaled(frame, Dimension<D>{}, std::bool_constant<lifted>{});
            print_bounds(result);
            print_result("error", result.magnitude * error_factor(D, lifted));  // as undecided.cpp does
        }
#endif
}

template <int D> void trace_weights(bool are_radii) {
    Weights weights;
    weights.are_radii = are_radii;
    const char* const name = are_radii ? "radii" : "weights";
    const auto trace = [&](const char* stage, int longest, bool mirrored, double spread, double more) {
        Sample sample(stage, D, true, longest, mirrored, spread);
        sample.weigh(D, longest, more);
        std::printf("sign %d\n", power_stage<D>(sample.point, weights));
    };
    for (int longest = 0; longest <= D; ++longest)
        for (bool mirrored : {false, true})
            for (double more : {0.0, 4.0}) trace(name, longest, mirrored, 3, more);
    for (int row = 0; row <= D; ++row) {
        for (double spread : {0x1p-500, 0x1p500}) trace("refused", row, false, spread, 0);
        trace("refused", row, false, 3, 0x1p500);
    }
}

template <int D> void trace_dimension() {
    trace_stages<D, false>();
    trace_stages<D, true>();
    trace_weights<D>(false);
    trace_weights<D>(true);
}

}  // namespace netmesh

int main() {
    netmesh::trace_plane<false>();
    netmesh::trace_plane<true>();
    netmesh::trace_arms<netmesh::NoWeights>(0);
    netmesh::trace_arms<netmesh::Weights>(1);
    netmesh::trace_arms<netmesh::Weights>(2);
#define TRACE_DIMENSION(D) netmesh::trace_dimension<D>();
    NETMESH_EACH_DIMENSION(TRACE_DIMENSION)
    return 0;
}
