#include "periods/lattice.hpp"

#include "numerics/real.hpp"
#include "numerics/vector.hpp"

namespace netmesh {
namespace {

constexpr double independent = 0x1p-45;

// a - times * b. It is a double although the product may be none: of whole numbers the last 64 bits are enough.
double difference(double a, double times, double b, double quantum) {
    const auto whole = [](double x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)); };
    const std::uint64_t n = whole(a / quantum) - whole(times) * whole(b / quantum);
    return static_cast<double>(static_cast<std::int64_t>(n)) * quantum;
}

}  // namespace

bool Lattice::orthogonalise(int* culprit) {
    for (int j = 0; j < count; ++j) {
        double* const v = e[j];
        copy(dim, b[j], v);
        const double length2 = dot(dim, v, v);
        // Twice, so that what is left is orthogonal although little is left.
        for (int pass = 0; pass < 2; ++pass)
            for (int i = 0; i < j; ++i) {
                const double along = dot(dim, e[i], v);
                for (int k = 0; k < dim; ++k) v[k] -= along * e[i][k];
            }
        const double left2 = dot(dim, v, v);
        *culprit = j;
        if (!(left2 > independent * independent * length2)) return false;
        h[j] = square_root(left2);
        for (int k = 0; k < dim; ++k) v[k] /= h[j];
    }
    return true;
}

bool Lattice::reduce(const double* quantum) {
    int culprit;
    if (!orthogonalise(&culprit)) return false;
    // Each exchange makes a product of lengths shorter by a factor; the bound is never met.
    int j = 1;
    for (int turn = 0; turn < 4000 && j < count; ++turn) {
        for (int i = j - 1; i >= 0; --i) {
            const double times = nearest_integer(dot(dim, e[i], b[j]) / h[i]);
            if (!(absolute(times) < 0x1p62)) return false;
            for (int k = 0; k < dim; ++k)
                b[j][k] = quantum == nullptr ? b[j][k] - times * b[i][k]
                          : quantum[k] == 0  ? 0
                                             : difference(b[j][k], times, b[i][k], quantum[k]);
        }
        const double along = dot(dim, e[j - 1], b[j]);
        if (h[j] * h[j] + along * along >= 0.75 * h[j - 1] * h[j - 1]) {
            ++j;
            continue;
        }
        for (int k = 0; k < dim; ++k) {
            const double x = b[j][k];
            b[j][k] = b[j - 1][k];
            b[j - 1][k] = x;
        }
        if (!orthogonalise(&culprit)) return false;
        j = j > 1 ? j - 1 : 1;
    }
    return orthogonalise(&culprit);
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

}  // namespace netmesh
