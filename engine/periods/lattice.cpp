#include "periods/lattice.hpp"

#include "numerics/double_double.hpp"
#include "numerics/real.hpp"
#include "numerics/vector.hpp"

namespace netmesh {
namespace {

constexpr double shortest_part = 0x1p-45;

void exchange(double* a, double* b, int count) {
    for (int k = 0; k < count; ++k) {
        const double x = a[k];
        a[k] = b[k];
        b[k] = x;
    }
}

}  // namespace

bool Lattice::orthogonalise() {
    for (int j = 0; j < count; ++j) {
        double* const v = e[j];
        copy(dim, b[j], v);
        // Twice, so that what is left is orthogonal although little is left.
        for (int pass = 0; pass < 2; ++pass)
            for (int i = 0; i < j; ++i) {
                const double along = dot(dim, e[i], v);
                for (int k = 0; k < dim; ++k) v[k] -= along * e[i][k];
            }
        const double left2 = dot(dim, v, v);
        if (!(left2 > 0)) return false;
        h[j] = square_root(left2);
        for (int k = 0; k < dim; ++k) v[k] /= h[j];
    }
    return true;
}

bool Lattice::reduce(double (*of_given)[most]) {
    if (!orthogonalise()) return false;
    // Each exchange makes a product of lengths shorter by a factor; the bound is never met.
    int j = 1;
    for (int turn = 0; turn < 20000 && j < count; ++turn) {
        // More than once where vectors are long.
        for (int pass = 0; pass < 3; ++pass)
            for (int i = j - 1; i >= 0; --i) {
                const double times = nearest_integer(dot(dim, e[i], b[j]) / h[i]);
                if (times == 0) continue;
                subtract(times, i, b[j], rest[j]);
                for (int k = 0; of_given != nullptr && k < count; ++k) of_given[j][k] -= times * of_given[i][k];
            }
        if (!orthogonalise()) return false;
        const double along = dot(dim, e[j - 1], b[j]);
        if (h[j] * h[j] + along * along >= 0.75 * h[j - 1] * h[j - 1]) {
            ++j;
            continue;
        }
        exchange(b[j], b[j - 1], dim);
        exchange(rest[j], rest[j - 1], dim);
        if (of_given != nullptr) exchange(of_given[j], of_given[j - 1], count);
        if (!orthogonalise()) return false;
        j = j > 1 ? j - 1 : 1;
    }
    double longest = 0, shortest = infinity;
    for (j = 0; j < count; ++j) {
        longest = h[j] > longest ? h[j] : longest;
        shortest = h[j] < shortest ? h[j] : shortest;
    }
    return shortest > shortest_part * longest;
}

bool Lattice::open(const double* vectors, int given, int dimension, int* culprit, double (*of_given)[most]) {
    dim = dimension;
    // One vector more at a time, to tell which one is at fault.
    for (count = 1; count <= given; ++count) {
        *culprit = count - 1;
        for (int j = 0; j < count; ++j)
            for (int k = 0; k < dim; ++k) {
                b[j][k] = vectors[j * dim + k] + 0.0;
                rest[j][k] = 0;
            }
        for (int j = 0; of_given != nullptr && j < count; ++j)
            for (int k = 0; k < count; ++k) of_given[j][k] = j == k ? 1 : 0;
        if (!reduce(of_given)) return false;
    }
    count = given;
    return true;
}

void Lattice::find_far(double* far) const {
    for (int j = 0; j < count; ++j) {
        // |e[j] . u| h[j] <= |b[j]|^2 / 2 + sum over i < j of |e[i] . b[j]| |e[i] . u|.
        double sum = 0.5 * dot(dim, b[j], b[j]);
        for (int i = 0; i < j; ++i) sum += absolute(dot(dim, e[i], b[j])) * 0.5 * far[i];
        far[j] = 2 * sum / h[j];
    }
    for (int j = 0; j < count; ++j) far[j] *= 1 + 0x1p-10;
}

double Lattice::place(int j, const double* x) const { return dot(dim, e[j], x) / h[j]; }

void Lattice::split(const double* x, double* part) const {
    double left[most];
    copy(dim, x, left);
    for (int j = count - 1; j >= 0; --j) {
        part[j] = place(j, left);
        for (int k = 0; k < dim; ++k) left[k] -= part[j] * b[j][k];
    }
}

void Lattice::subtract(double times, int j, double* high, double* low) const {
    for (int k = 0; k < dim; ++k) {
        const DoubleDouble left =
            DoubleDouble{high[k], low[k]} - DoubleDouble{times, 0} * DoubleDouble{b[j][k], rest[j][k]};
        high[k] = left.high;
        low[k] = left.low;
    }
}

}  // namespace netmesh
