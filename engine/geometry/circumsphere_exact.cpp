#include "geometry/circumsphere_exact.hpp"

#include "geometry/residue_steps.hpp"
#include "numerics/lanes.hpp"
#include "numerics/nearest_double.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// det[0] = det G, det[i] = det G_i from the k x k Gram matrix.
void solve_residues(int k, const std::uint64_t (&gram)[ExactSphere::dim_max][ExactSphere::dim_max],
                    const ResiduePrime& prime, std::uint64_t* det) {
    // The k+1 rows "columns of G, b"; minor k - i is the one without row i.
    ResidueMatrix a;
    ResidueLevels level;
    for (int c = 0; c < k; ++c)
        for (int r = 0; r <= k; ++r) a.put(c, r, gram[c][r < k ? r : c], prime);
    const std::uint64_t* const minors = residue_minors(k + 1, k, a, level, prime);
    det[0] = minors[0];
    // b is the last row; k-1-i transpositions bring it to the place of row i.
    for (int i = 0; i < k; ++i) det[i + 1] = ((k - 1 - i) & 1) != 0 ? negative_of(minors[k - i], prime) : minors[k - i];
}

}  // namespace

ExactSphere::ExactSphere(const double* const* point, int k, int dim) : k_(k), dim_(dim), quantum_(1024), power_max_(0) {
    int widest = exponent_of_zero;
    for (int c = 0; c < dim; ++c)
        for (int i = 0; i <= k; ++i) {
            const int q = quantum_of(point[i][c]), e = exponent_of(__builtin_fabs(point[i][c] - point[0][c]));
            quantum_ = q < quantum_ ? q : quantum_;
            widest = e > widest ? e : widest;
        }
    for (int c = 0; c < dim; ++c)
        for (int i = 0; i <= k; ++i) {
            x_[i][c] = scaled_integer(point[i][c], quantum_);
            power_max_ = x_[i][c].power > power_max_ ? x_[i][c].power : power_max_;
        }
    if (widest < quantum_) widest = quantum_;  // all points are one
    length_bits_ = 2 * (widest + 1 - quantum_) + (dim > 4 ? 3 : dim > 2 ? 2 : 1);
}

// find_within has k + 2 rows. compare_midpoint has one, of up to two primes more: the radius is half a quantum at
// least, so 53 bits of it end at 2^(quantum - 54) at the lowest, and it wants 2 * 54 + 8 bits more than the sphere.
std::size_t ExactSphere::words() const {
    return static_cast<std::size_t>(k_ + 2) * static_cast<std::size_t>(primes_for_bits(square_bits()));
}

ExactSphere::Residues ExactSphere::modulo(const ResiduePrime& prime) const {
    const PowersByBits power(power_max_, prime);
    std::uint64_t edge[dim_max][dim_max], gram[dim_max][dim_max] = {};
    for (int c = 0; c < dim_; ++c) {
        const std::uint64_t base = residue_of(x_[0][c], power, prime);
        for (int i = 0; i < k_; ++i)
            edge[i][c] = residue_sum(residue_of(x_[i + 1][c], power, prime), negative_of(base, prime), prime);
    }
    for (int i = 0; i < k_; ++i)
        for (int j = 0; j <= i; ++j) {
            UnsignedSum sum;
            for (int c = 0; c < dim_; ++c) sum.add_product(edge[i][c], edge[j][c]);
            gram[i][j] = gram[j][i] = reduce(sum, prime);
        }
    Residues r;
    solve_residues(k_, gram, prime, r.det);
    UnsignedSum sum;
    for (int i = 0; i < k_; ++i) sum.add_product(gram[i][i], r.det[i + 1]);
    r.sum = reduce(sum, prime);
    return r;
}

// This and find_radius stand apart, or a caller of both holds the stack of both.
[[gnu::noinline]] bool ExactSphere::find_within(std::uint64_t* scratch, std::uint32_t* within) const {
    const int n = primes_for_bits(square_bits());
    std::uint64_t* const det = scratch;  // rows: 2 det G beta_0, then det G_i, then det G
    for (int j = 0; j < n; ++j) {
        const ResiduePrime prime = residue_prime(j);
        const Residues r = modulo(prime);
        std::uint64_t first = residue_sum(r.det[0], r.det[0], prime);
        for (int i = 1; i <= k_; ++i) {
            det[i * n + j] = r.det[i];
            first = residue_sum(first, negative_of(r.det[i], prime), prime);
        }
        det[j] = first;
        det[(k_ + 1) * n + j] = r.det[0];
    }
    *within = 0;
    for (int i = 0; i <= k_; ++i)
        if (sign_of_residues(det + i * n, n) <= 0) *within |= 1u << i;
    return sign_of_residues(det + (k_ + 1) * n, n) > 0;
}

// The sign of the squared radius less that of the midpoint between x and the next double above; -2: out of range. With
// x = m 2^e the midpoint is (2 m + 1) 2^(e-1), so it is the sign of 4^(quantum - e) sum - (2 m + 1)^2 det G. x is near
// the radius: neither term has more than 8 bits more than the first.
int ExactSphere::compare_midpoint(double x, std::uint64_t* scratch) const {
    const Decoded at = decode(x);
    const std::uint64_t odd = 2 * at.mantissa + 1;
    const int shift = 2 * (quantum_ - at.exponent);
    const int n = primes_for_bits(square_bits() + (shift > 0 ? shift : 0) + 8);
    if (n > residue_prime_count) return -2;
    for (int j = 0; j < n; ++j) {
        const ResiduePrime prime = residue_prime(j);
        const Residues r = modulo(prime);
        std::uint64_t sphere = r.sum, midpoint = multiply(multiply(r.det[0], odd, prime), odd, prime);
        std::uint64_t& finer = shift > 0 ? sphere : midpoint;
        finer = multiply(finer, power_of_two_modulo(shift > 0 ? shift : -shift, prime), prime);
        scratch[j] = residue_sum(sphere, negative_of(midpoint, prime), prime);
    }
    return sign_of_residues(scratch, n);
}

[[gnu::noinline]] bool ExactSphere::find_radius(std::uint64_t* scratch, double* radius) const {
    const int n = primes_for_bits(square_bits());
    for (int j = 0; j < n; ++j) {
        const Residues r = modulo(residue_prime(j));
        scratch[j] = r.det[0];
        scratch[n + j] = r.sum;
    }
    const Floating square = quotient(floating_of(scratch + n, n), floating_of(scratch, n));
    // The root of a mantissa between 1 and 4, to 2^-87 relative, times 2^e.
    const int own = exponent_of(square.mantissa.high) & ~1;
    const DoubleDouble mantissa = scaled(square.mantissa, power_of_two(-own));
    const int twice = square.exponent + own + 2 * quantum_ - 2, odd = twice & 1, e = (twice - odd) / 2;
    const DoubleDouble even = scaled(mantissa, odd != 0 ? 2 : 1);
    const NearestRoot<double> nearest = nearest_root(even.high, even.low, even.high * 0x1p-86);
    if (nearest.known != 0 && e > -1022 && e < 1022) {
        *radius = nearest.root * power_of_two(e);
        return true;
    }
    bool in_range = true;
    *radius = nearest_double(scaled_by(nearest.root, e), [&](double x) {
        const int sign = compare_midpoint(x, scratch);
        in_range = in_range && sign != -2;
        return sign;
    });
    return in_range;
}

}  // namespace netmesh
