#include "geometry/power_sphere_exact.hpp"

#include "geometry/circumsphere_fast.hpp"
#include "geometry/residue_steps.hpp"
#include "numerics/nearest_double.hpp"
#include "numerics/residue_minors.hpp"

namespace netmesh {

ExactPowerSphere::ExactPowerSphere(const double* const* point, int k, int dim, bool are_radii)
    : k_(k), dim_(dim), quantum_(1024), power_max_(0), are_radii_(are_radii) {
    int widest = exponent_of_zero, of_weights = 1024, heaviest = exponent_of_zero;
    for (int i = 0; i <= k; ++i) {
        for (int c = 0; c < dim; ++c) {
            const int q = quantum_of(point[i][c]), e = exponent_of(__builtin_fabs(point[i][c] - point[0][c]));
            quantum_ = q < quantum_ ? q : quantum_;
            widest = e > widest ? e : widest;
        }
        const int q = quantum_of(point[i][dim]), e = exponent_of(__builtin_fabs(point[i][dim]));
        of_weights = q < of_weights ? q : of_weights;
        heaviest = e > heaviest ? e : heaviest;
    }
    if (!are_radii) of_weights = of_weights >= 0 ? of_weights / 2 : -((1 - of_weights) / 2);  // rounded down
    quantum_ = of_weights < quantum_ ? of_weights : quantum_;
    for (int i = 0; i <= k; ++i)
        for (int c = 0; c <= dim; ++c) {
            x_[i][c] = scaled_integer(point[i][c], c < dim || are_radii ? quantum_ : 2 * quantum_);
            power_max_ = x_[i][c].power > power_max_ ? x_[i][c].power : power_max_;
        }
    if (widest < quantum_) widest = quantum_;
    length_bits_ = 2 * (widest + 1 - quantum_) + (dim > 4 ? 3 : dim > 2 ? 2 : 1);
    const int weight_bits = heaviest == exponent_of_zero ? 0
                            : are_radii                  ? 2 * (heaviest + 1 - quantum_) + 1
                                                         : heaviest + 2 - 2 * quantum_;
    right_bits_ = (weight_bits > length_bits_ ? weight_bits : length_bits_) + 1;
}

ExactPowerSphere::Residues ExactPowerSphere::modulo(const ResiduePrime& prime) const {
    const PowersByBits power(power_max_, prime);
    std::uint64_t edge[dim_max][dim_max], right[dim_max], weight[dim_max + 1];
    for (int c = 0; c < dim_; ++c) {
        const std::uint64_t base = residue_of(x_[0][c], power, prime);
        for (int i = 0; i < k_; ++i)
            edge[i][c] = residue_sum(residue_of(x_[i + 1][c], power, prime), negative_of(base, prime), prime);
    }
    for (int i = 0; i <= k_; ++i) {
        weight[i] = residue_of(x_[i][dim_], power, prime);
        if (are_radii_) weight[i] = multiply(weight[i], weight[i], prime);
    }
    // The k+1 rows "columns of G, b", as in circumsphere_exact.cpp.
    ResidueMatrix a;
    ResidueLevels level;
    for (int i = 0; i < k_; ++i)
        for (int j = 0; j <= i; ++j) {
            UnsignedSum sum;
            for (int c = 0; c < dim_; ++c) sum.add_product(edge[i][c], edge[j][c]);
            const std::uint64_t gram = reduce(sum, prime);
            a.put(i, j, gram, prime);
            a.put(j, i, gram, prime);
            if (i == j) {
                const std::uint64_t less = residue_sum(weight[0], negative_of(weight[i + 1], prime), prime);
                right[i] = residue_sum(gram, less, prime);
                a.put(i, k_, right[i], prime);
            }
        }
    const std::uint64_t* const minors = residue_minors(k_ + 1, k_, a, level, prime);
    Residues r;
    r.det[0] = minors[0];
    UnsignedSum sum;
    for (int i = 0; i < k_; ++i) {
        const std::uint64_t minor = minors[k_ - i];
        r.det[i + 1] = ((k_ - 1 - i) & 1) != 0 ? negative_of(minor, prime) : minor;
        sum.add_product(right[i], r.det[i + 1]);
    }
    const std::uint64_t own = multiply(multiply(weight[0], 4, prime), r.det[0], prime);
    r.power = residue_sum(reduce(sum, prime), negative_of(own, prime), prime);
    return r;
}

bool ExactPowerSphere::find_within(std::uint64_t* scratch, std::uint32_t* within) const {
    const int n = primes_for_bits(power_bits());
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

// The sign of |a|, or of its root, less the midpoint between x and the next double above; -2: out of range. With
// x = m 2^e the midpoint is (2 m + 1) 2^(e-1), so with p for |a| 4 det G it is the sign of 4^quantum p less 4 det G
// times the midpoint, or its square: of 2^shift p - (2 m + 1)^(1 or 2) det G.
int ExactPowerSphere::compare_midpoint(double x, bool squares, bool negative, std::uint64_t* scratch) const {
    const Decoded at = decode(x);
    const std::uint64_t odd = 2 * at.mantissa + 1;
    const int shift = squares ? 2 * quantum_ - at.exponent - 1 : 2 * (quantum_ - at.exponent);
    const int of_power = power_bits() + (shift > 0 ? shift : 0);
    const int of_midpoint = det_bits() + (squares ? 54 : 108) + (shift < 0 ? -shift : 0);
    const int n = primes_for_bits((of_power > of_midpoint ? of_power : of_midpoint) + 2);
    if (n > residue_prime_count) return -2;
    for (int j = 0; j < n; ++j) {
        const ResiduePrime prime = residue_prime(j);
        const Residues r = modulo(prime);
        std::uint64_t power = negative ? negative_of(r.power, prime) : r.power;
        std::uint64_t midpoint = multiply(r.det[0], odd, prime);
        if (!squares) midpoint = multiply(midpoint, odd, prime);
        std::uint64_t& finer = shift > 0 ? power : midpoint;
        finer = multiply(finer, power_of_two_modulo(shift > 0 ? shift : -shift, prime), prime);
        scratch[j] = residue_sum(power, negative_of(midpoint, prime), prime);
    }
    return sign_of_residues(scratch, n);
}

bool ExactPowerSphere::find_power(std::uint64_t* scratch, bool squares, double* value) const {
    const int n = primes_for_bits(power_bits());
    std::uint64_t *const det = scratch, *const power = scratch + n, *const opposite = scratch + 2 * n;
    for (int j = 0; j < n; ++j) {
        const ResiduePrime prime = residue_prime(j);
        const Residues r = modulo(prime);
        det[j] = r.det[0];
        power[j] = r.power;
        opposite[j] = negative_of(r.power, prime);
    }
    const int sign = sign_of_residues(power, n);
    *value = 0;
    if (sign == 0) return true;
    if (sign < 0) sign_of_residues(opposite, n);
    const Floating square = quotient(floating_of_digits(sign < 0 ? opposite : power, n), floating_of(det, n));
    // |a| is a mantissa between 1 and 4, to 2^-87 relative, times 4^e; or one between 1 and 2 times 2^e.
    const int own = exponent_of(square.mantissa.high);
    int e = square.exponent + own + 2 * quantum_ - 2;
    DoubleDouble mantissa = scaled(square.mantissa, power_of_two(-own));
    if (!squares) {
        const int odd = e & 1;
        mantissa = scaled(mantissa, odd != 0 ? 2 : 1);
        e = (e - odd) / 2;
    }
    const NearestRoot<double> nearest =
        nearest_power<double>(mantissa.high, mantissa.low, mantissa.high * 0x1p-86, squares);
    bool in_range = true;
    if (nearest.known != 0 && e > -1022 && e < 1022)
        *value = nearest.root * power_of_two(e);
    else
        *value = nearest_double(scaled_by(nearest.root, e), [&](double x) {
            const int over = compare_midpoint(x, squares, sign < 0, scratch);
            in_range = in_range && over != -2;
            return over;
        });
    if (sign < 0) *value = 0.0 - *value;
    return in_range;
}

}  // namespace netmesh
