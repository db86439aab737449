#include "delaunay/sphere.hpp"

#include "delaunay/flat_centre.hpp"
#include "memory/prefetch.hpp"
#include "numerics/minors.hpp"
#include "numerics/real.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

constexpr double u = unit_roundoff;

// Divides each edge, and with it its equation, by a power of two of its own, so that lengths of any ratio do not meet
// in one product. False when an edge vanishes or all are too short for their squares.
template <int D> [[gnu::cold]] bool rescale(double (&a)[D + 1][D + 1], double* lengths2) {
    double longest = 0;
    *lengths2 = 1;
    for (int i = 0; i < D; ++i) {
        double largest = 0;
        for (int j = 0; j < D; ++j)
            if (absolute(a[j][i]) > largest) largest = absolute(a[j][i]);
        if (!(largest > 0x1p-1000 && largest < 0x1p1000)) return false;
        const int exponent = exponent_of(largest);
        const double inverse = power_of_two(-exponent);
        double square = 0;
        for (int j = 0; j < D; ++j) {
            a[j][i] *= inverse;
            square += a[j][i] * a[j][i];
        }
        a[D][i] = 0.5 * square * power_of_two(exponent);
        *lengths2 *= square;
        if (largest > longest) longest = largest;
    }
    return longest > 0x1p-900;
}

struct Ball {
    double* centre;
    double* radius2;
    float* error;
};

// Says that nothing is known: every question about this ball goes to the exact predicates.
void forget_sphere(int dim, const double* const* p, const Ball& ball) {
    copy(dim, p[0], ball.centre);
    *ball.radius2 = infinity;
    *ball.error = static_cast<float>(infinity);
}

// A squared radius above this loses no more than 2^-60 of itself to underflow: the inputs of a mesh are 2^-500 apart.
constexpr double shortest2 = 0x1p-1010;

// Makes the ball of p0 + x. The two terms of the error are the shape's, shape2 its square, and the rounding of the
// centre's coordinates. False when it is above error_max.
template <int D>
bool keep_sphere(int dim, const double* p0, const double* x, double shape2, double error_max, const Ball& ball) {
    if (D != any_dimension) dim = D;
    double radius2 = 0, size2 = 0;
    for (int j = 0; j < dim; ++j) {
        ball.centre[j] = p0[j] + x[j];
        const double d = p0[j] - ball.centre[j];
        radius2 += d * d;
        size2 += ball.centre[j] * ball.centre[j];
    }
    const double error2 = 2.1 * (shape2 + 8 * u * u * (size2 / radius2));
    if (!(error2 < error_max * error_max) || !(radius2 > shortest2)) return false;
    *ball.radius2 = radius2;
    *ball.error = static_cast<float>(1.01 * square_root(error2));
    return true;
}

constexpr double error_limit = 0.25;  // beyond it the bounds' own assumptions fail

// For cells so flat that the digits of a double do not tell their centre, or so small that they do not place it. Where
// the rounding of coordinates makes its error more than blurred_error, the radius r is that of the centre as it was
// before, |x|, which is known within 2^-27 of r. Rounding moves the centre by at most u |centre|, less than error r / 3
// by keep_sphere. So the f of sphere.hpp is less than error r^2 at p0, and its gradient less than error r; together
// less than error (|q-c|^2 + 3 r^2), as power() wants it.
[[gnu::cold, gnu::noinline]] void solve_flat_sphere(AnyDimension dim, const double* const* p, double shape_factor,
                                                    const Ball& ball) {
    constexpr int D = serves_one_dimension ? dimension_most() : any_dimension;
    for (int in_integers = 0; in_integers < 2; ++in_integers) {
        double x[dimension_max], shape2;
        const bool solved = in_integers != 0 ? centre_in_integers(dim, p, x, &shape2)
                                             : centre_in_long_digits(dim, p, shape_factor, x, &shape2);
        if (!solved || !keep_sphere<D>(dim, p[0], x, shape2, error_limit, ball)) continue;
        if (*ball.error <= blurred_error) return;
        if (!(shape2 < 0x1p-56)) continue;
        *ball.radius2 = dot(dim, x, x);
        return;
    }
    forget_sphere(dim, p, ball);
}

}  // namespace

// The centre is p0 + x, where the edges e_i from p0 satisfy e_i . x = |e_i|^2 / 2: Cramer's rule on the matrix with the
// edges in its columns and their half squares b in its last row. Without a branch, so that it costs little more than
// its products.
template <int D> void solve_sphere(const double* const* p, double error_max, Cell<D>& cell) {
    double a[D + 1][D + 1], minors[D + 1];
    bool plain = true;
    double lengths2 = 1;
    for (int i = 0; i < D; ++i) {
        double square = 0;
        for (int j = 0; j < D; ++j) {
            a[j][i] = p[i + 1][j] - p[0][j];
            square += a[j][i] * a[j][i];
        }
        a[D][i] = 0.5 * square;
        plain = plain && a[D][i] > edge_square_min && a[D][i] < edge_square_max;
        lengths2 *= 2 * a[D][i];
    }
    const Ball ball = {cell.centre, &cell.radius2, &cell.error};
    if (!plain && !rescale<D>(a, &lengths2)) return forget_sphere(D, p, ball);
    minors_of_order<D>(a, minors);  // minors[D - j] is the one without row j
    const double inverse = 1 / minors[0];
    double x[D];
    for (int j = 0; j < D; ++j) x[j] = minors[D - j] * ((D - 1 - j) % 2 == 0 ? inverse : -inverse);
    constexpr double shape = shape_factor<D>();
    if (!keep_sphere<shared_dimension<D>>(D, p[0], x, shape * shape * lengths2 * (inverse * inverse), error_max, ball))
        solve_flat_sphere(D, p, shape, ball);
}

// e_i . x = (|e_i|^2 + w_0 - w_i) / 2. As |c - v|^2 - w is the same of all vertices v, |w_0 - w_i| is at most
// |e_i| (|c - v_0| + |c - v_i|), so right-hand sides are below 2 R |e_i| in absolute values, R^2 being radius2, where
// without weights they are below R |e_i|; and four roundings more: the bound of shape_factor with twice its first term.
template <int D>
void solve_power_sphere(const double* const* p, const Weights& weights, double error_max, Cell<D>& cell) {
    constexpr double c[7] = {1, 1, 1, 1.15471, 1.5, 2.14664, 3.33334}, root[7] = {0, 1, 1.42, 1.74, 2, 2.24, 2.45};
    constexpr int roundings = (D + 1) * (D + 2) / 2 + D + 12;
    constexpr double shape = 3 * root[D] * roundings * u * (2 * D * c[D - 1] + c[D]);
    double a[D + 1][D + 1], minors[D + 1];
    bool plain = true;
    double lengths2 = 1;
    for (int i = 0; i < D; ++i) {
        double square = 0;
        for (int j = 0; j < D; ++j) {
            a[j][i] = p[i + 1][j] - p[0][j];
            square += a[j][i] * a[j][i];
        }
        const double twice = square + weights.difference(p[0][D], p[i + 1][D]);
        a[D][i] = 0.5 * twice;
        plain = plain && square > edge_square_min && square < edge_square_max && absolute(twice) < edge_square_max;
        lengths2 *= square;
    }
    const Ball ball = {cell.centre, &cell.radius2, &cell.error};
    if (!plain) return forget_sphere(D, p, ball);
    minors_of_order<D>(a, minors);
    const double inverse = 1 / minors[0];
    double radius2 = weights.height(p[0][D]), size2 = 0;
    for (int j = 0; j < D; ++j) {
        cell.centre[j] = p[0][j] + minors[D - j] * ((D - 1 - j) % 2 == 0 ? inverse : -inverse);
        const double d = p[0][j] - cell.centre[j];
        radius2 += d * d;
        size2 += cell.centre[j] * cell.centre[j];
    }
    const double error2 = 2.1 * (shape * shape * lengths2 * (inverse * inverse) + 8 * u * u * (size2 / radius2));
    if (!(error2 < error_max * error_max) || !(radius2 > shortest2) || !(radius2 < infinity))
        return forget_sphere(D, p, ball);
    cell.radius2 = radius2;
    cell.error = static_cast<float>(1.01 * square_root(error2));
}

template <int D> void recompute_balls(Store<D>& store) {
    for (std::uint32_t c = 0; c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 70 * D * D); c < piece; ++c) {
            if constexpr (D > 4) {  // a call is little beside the rest
                solve_cell<D>(store, corner_error_max, store.cell(c));
            } else {
                const std::uint32_t later = c + 8 < store.state.cell_slots ? c + 8 : c;
                for (const VertexId v : store.cell(later).vertex) prefetch(store.point(v));
                const double* p[D + 1];
                for (int i = 0; i <= D; ++i) p[i] = store.point(store.cell(c).vertex[i]);
                solve_sphere<D>(p, corner_error_max, store.cell(c));
            }
        }
}

namespace {

template <int D> void measure_edges_of(const Store<D>& store) {
    for (std::uint32_t v = 0; v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 6); v < piece; ++v) {
            store.vertex(v).nearest2 = infinity;
        }
    const int squares = store.dim * store.dim;
    for (std::uint32_t c = 0; c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 30 * squares); c < piece; ++c) {
            const double* x[DimensionOf<D>::most + 1];
            double least2[DimensionOf<D>::most + 1];
            const Cell<D>& cell = store.cell(c);
            for (int i = 0; i <= store.dim; ++i) {
                x[i] = store.point(cell.vertex[i]);
                least2[i] = infinity;
                for (int j = 0; j < i; ++j) {
                    const double d2 = distance2<D>(store.dim, x[i], x[j]);
                    if (d2 < least2[i]) least2[i] = d2;
                    if (d2 < least2[j]) least2[j] = d2;
                }
            }
            for (int i = 0; i <= store.dim; ++i) {
                auto&& vertex = store.vertex(cell.vertex[i]);
                if (least2[i] < vertex.nearest2) vertex.nearest2 = least2[i];
            }
        }
}

}  // namespace

void measure_edges(const AnyStore& store) {
    with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = shared_dimension<decltype(dimension)::value>;
        measure_edges_of<D>(store.of_dimension<D>());
    });
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template void solve_sphere<D>(const double* const*, double, Cell<D>&);                                             \
    template void solve_power_sphere<D>(const double* const*, const Weights&, double, Cell<D>&);                       \
    template void recompute_balls<D>(Store<D>&);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
