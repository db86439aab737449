#include "delaunay/flat_centre.hpp"

#include "numerics/bits.hpp"
#include "numerics/double_double.hpp"
#include "numerics/integer512.hpp"
#include "numerics/minors.hpp"

namespace netmesh {

bool centre_in_long_digits(int dim, const double* const* p, double shape_factor, double* x, double* error2) {
    // Column i: edge i, scaled, and half of its square.
    DoubleDouble edge[dimension_most()][minor_rows_max], level[2][widest_level(minor_rows_max)];
    double lengths2 = 1;
    for (int i = 0; i < dim; ++i) {
        double largest = 0;
        for (int j = 0; j < dim; ++j) {
            edge[i][j] = exact_difference(p[i + 1][j], p[0][j]);
            const double size = __builtin_fabs(edge[i][j].high);
            if (size > largest) largest = size;
        }
        if (!(largest > 0x1p-1000 && largest < 0x1p1000)) return false;
        const int exponent = exponent_of(largest);
        DoubleDouble square = {0, 0};
        for (int j = 0; j < dim; ++j) {
            edge[i][j] = scaled(edge[i][j], power_of_two(-exponent));
            square = square + edge[i][j] * edge[i][j];
        }
        edge[i][dim] = scaled(square, power_of_two(exponent - 1));
        lengths2 *= square.high;
    }
    const DoubleDouble* const minors =
        minors_of_columns<2, dimension_most()>(dim + 1, dim, edge, edge[0], level);  // [dim - j]: without row j
    for (int j = 0; j < dim; ++j) {
        const DoubleDouble quotient = minors[dim - j] / minors[0];
        x[j] = (dim - 1 - j) % 2 == 0 ? quotient.high : -quotient.high;
    }
    const double shape = shape_factor * 0x1p-45;  // an operation errs by less than 2^-98
    const double inverse = 1 / minors[0].high;
    *error2 = shape * shape * lengths2 * (inverse * inverse);
    return true;
}

bool centre_in_integers(int dim, const double* const* p, double* x, double* error2) {
    const int edge_bits = (Integer512::bits - 16) / (dim + 1);  // D! D 2^(edge_bits (D + 1)) < 2^511
    int quantum = 1024, highest = -1074;
    for (int i = 0; i <= dim; ++i)
        for (int j = 0; j < dim; ++j) {
            const int k = quantum_of(p[i][j]), e = exponent_of(__builtin_fabs(p[i][j]));
            if (k < quantum) quantum = k;
            if (e > highest) highest = e;
        }
    if (highest - quantum > 440 || quantum > 400) return false;
    const auto integer = [&](double value) {
        const Decoded d = decode(value);
        if (d.mantissa == 0) return Integer512::zero();
        const int shift = d.exponent - quantum;  // negative when the mantissa ends in zeros
        return shift < 0 ? Integer512::of(d.mantissa >> -shift, 0, d.negative)
                         : Integer512::of(d.mantissa, shift, d.negative);
    };
    Integer512 edge[dimension_most()][minor_rows_max], level[2][widest_level(minor_rows_max)];
    for (int i = 0; i < dim; ++i) {
        Integer512 square = Integer512::zero();
        for (int j = 0; j < dim; ++j) {
            if (exponent_of(__builtin_fabs(p[i + 1][j] - p[0][j])) - quantum >= edge_bits) return false;
            edge[i][j] = integer(p[i + 1][j]) - integer(p[0][j]);
            square = square + edge[i][j] * edge[i][j];
        }
        edge[i][dim] = square;
    }
    const Integer512* const minors = minors_of_columns<2, dimension_most()>(dim + 1, dim, edge, edge[0], level);
    int below;
    const double determinant = minors[0].leading(&below);
    for (int j = 0; j < dim; ++j) {
        int above;
        const double numerator = minors[dim - j].leading(&above);
        const double quotient = numerator / determinant * power_of_two(above - below) * power_of_two(quantum - 1);
        x[j] = (dim - 1 - j) % 2 == 0 ? quotient : -quotient;
    }
    *error2 = dim * 0x1p-98;
    return true;
}

}  // namespace netmesh
