#include "filtration/circumsphere_exact.hpp"

#include "numerics/bits.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

#ifdef __OPTIMIZE_SIZE__
[[gnu::noinline]]
#endif
std::uint64_t
negative(std::uint64_t a, const ResiduePrime& prime) {
    return a == 0 ? 0 : prime.value - a;
}
#ifdef __OPTIMIZE_SIZE__
[[gnu::noinline]]
#endif
std::uint64_t
sum_of(std::uint64_t a, std::uint64_t b, const ResiduePrime& prime) {
    return a + b >= prime.value ? a + b - prime.value : a + b;
}

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
    for (int i = 0; i < k; ++i) det[i + 1] = ((k - 1 - i) & 1) != 0 ? negative(minors[k - i], prime) : minors[k - i];
}

// 2^e modulo the prime.
std::uint64_t power_of_two_modulo(int e, const ResiduePrime& prime) {
    std::uint64_t r = std::uint64_t{1} << (e % 61);
    for (int i = 0; i < e / 61; ++i) r = multiply(r, prime.excess, prime);
    return r;
}

// sqrt, in the range of doubles; infinite if that is.
double root_of(const Floating& square) {
    if (!(square.mantissa.high < infinity)) return infinity;
    const bool odd = (square.exponent & 1) != 0;
    double root = square_root(scaled(square.mantissa, odd ? 2 : 1));
    int e = (square.exponent - odd) / 2;
    if (e > 1100) return radius_max;
    for (; e > 500; e -= 500) root *= 0x1p500;
    for (; e < -500 && root > 0; e += 500) root *= 0x1p-500;
    if (root > 0) root *= power_of_two(e < -500 ? 0 : e);
    return kept_radius(root);
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
            if (i > 0) edge_[c][i - 1] = two_difference(point[i][c], point[0][c]);
        }
    if (widest < quantum_) widest = quantum_;  // all points are one
    length_bits_ = 2 * (widest + 1 - quantum_) + (dim > 4 ? 3 : dim > 2 ? 2 : 1);
}

ExactSphere::Residues ExactSphere::modulo(const ResiduePrime& prime) const {
    std::uint64_t power[scaled_power_max + 1], edge[dim_max][dim_max], gram[dim_max][dim_max] = {};
    power[0] = 1;
    for (int i = 1; i <= power_max_; ++i) power[i] = multiply(power[i - 1], prime.excess, prime);
    for (int c = 0; c < dim_; ++c) {
        const std::uint64_t base = residue_of(x_[0][c], power, prime);
        for (int i = 0; i < k_; ++i)
            edge[i][c] = sum_of(residue_of(x_[i + 1][c], power, prime), negative(base, prime), prime);
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

namespace {

// a / b for b >= 0; infinite where b is 0.
Floating quotient(const Floating& a, const Floating& b) {
    if (!(b.mantissa.high > 0)) return {{infinity, 0}, 0};
    return {a.mantissa / b.mantissa, a.exponent - b.exponent};
}

Floating floating_of(std::uint64_t* residues, int n) {
    sign_of_residues(residues, n);
    return floating_of_digits(residues, n);
}

}  // namespace

#ifdef __OPTIMIZE_SIZE__
Circumsphere ExactSphere::evaluate(std::uint64_t* scratch) const {
    const int n = primes_for_bits(square_bits());
    std::uint32_t within = 0;
    for (int i = 0; i <= k_; ++i) {
        for (int j = 0; j < n; ++j) {
            const ResiduePrime prime = residue_prime(j);
            const Residues r = modulo(prime);
            scratch[j] = i > 0 ? r.det[i] : sum_of(r.det[0], r.det[0], prime);  // 2 det G beta_i
            for (int m = 1; i == 0 && m <= k_; ++m) scratch[j] = sum_of(scratch[j], negative(r.det[m], prime), prime);
        }
        if (sign_of_residues(scratch, n) <= 0) within |= 1u << i;
    }
    return {root_of(radius_squared(scratch)), within, 0};
}
#else
Circumsphere ExactSphere::evaluate(std::uint64_t* scratch) const {
    const int n = primes_for_bits(square_bits());
    std::uint64_t* const first = scratch;  // 2 det G beta_0
    std::uint64_t* const sum = scratch + n;
    std::uint64_t* const det = scratch + 2 * n;  // k+1 rows
    for (int j = 0; j < n; ++j) {
        const ResiduePrime prime = residue_prime(j);
        const Residues r = modulo(prime);
        first[j] = sum_of(r.det[0], r.det[0], prime);
        for (int i = 0; i <= k_; ++i) det[i * n + j] = r.det[i];
        for (int i = 1; i <= k_; ++i) first[j] = sum_of(first[j], negative(r.det[i], prime), prime);
        sum[j] = r.sum;
    }
    std::uint32_t within = sign_of_residues(first, n) <= 0;
    for (int i = 1; i <= k_; ++i)
        if (sign_of_residues(det + i * n, n) <= 0) within |= 1u << i;
    Floating square = quotient(floating_of(sum, n), floating_of(det, n));
    square.exponent += 2 * quantum_ - 2;
    return {root_of(square), within, 0};
}
#endif

Floating ExactSphere::radius_squared(std::uint64_t* scratch) const {
    const int n = primes_for_bits(square_bits());
    for (int j = 0; j < n; ++j) {
        const Residues r = modulo(residue_prime(j));
        scratch[j] = r.det[0];
        scratch[n + j] = r.sum;
    }
    Floating square = quotient(floating_of(scratch + n, n), floating_of(scratch, n));
    square.exponent += 2 * quantum_ - 2;
    return square;
}

int ExactSphere::product_bits(const ExactSphere& a, const ExactSphere& b) {
    const int shift = 2 * (a.quantum_ - b.quantum_);
    const int bits_a = a.square_bits() + b.det_bits() + (shift > 0 ? shift : 0);
    const int bits_b = b.square_bits() + a.det_bits() + (shift < 0 ? -shift : 0);
    return bits_a > bits_b ? bits_a : bits_b;
}

// A difference that overflows is no number, and equal to none.
bool ExactSphere::congruent(const ExactSphere& a, const ExactSphere& b) {
    if (a.k_ != b.k_) return false;
    std::uint32_t used = 0;
    for (int c = 0; c < a.dim_; ++c) {
        bool found = false;
        for (int d = 0; d < a.dim_ && !found; ++d) {
            if ((used >> d & 1u) != 0) continue;
            bool same = true, reversed = true;
            for (int i = 0; i < a.k_; ++i) {
                const DoubleDouble x = a.edge_[c][i], y = b.edge_[d][i];
                same = same && x.high == y.high && x.low == y.low;
                reversed = reversed && x.high == -y.high && x.low == -y.low;
            }
            found = same || reversed;
            if (found) used |= 1u << d;
        }
        if (!found) return false;
    }
    return true;
}

std::uint32_t ExactSphere::hash() const {
    std::uint64_t sum = 0;
    for (int c = 0; c < dim_; ++c) {
        std::uint64_t axis = 0;
        for (int i = 0; i < k_; ++i) {
            const std::uint64_t size = bits_of(__builtin_fabs(edge_[c][i].high));
            axis = (axis ^ size) * 0x9E3779B97F4A7C15u;
            axis ^= axis >> 29;
        }
        sum += axis * axis;
    }
    return static_cast<std::uint32_t>(sum >> 32 ^ sum >> 7);
}

bool ExactSphere::excess(const ExactSphere& a, const ExactSphere& b, std::uint64_t* scratch, double* out) {
    const int shift = 2 * (a.quantum_ - b.quantum_);
    const int n = primes_for_bits(product_bits(a, b) + 1);
    if (n > residue_prime_count) return false;
    std::uint64_t *const difference = scratch, *const opposite = scratch + n, *const product = scratch + 2 * n;
    for (int j = 0; j < n; ++j) {
        const ResiduePrime prime = residue_prime(j);
        const Residues ra = a.modulo(prime), rb = b.modulo(prime);
        std::uint64_t left = multiply(ra.sum, rb.det[0], prime), right = multiply(rb.sum, ra.det[0], prime);
        std::uint64_t& coarser = shift > 0 ? left : right;
        coarser = multiply(coarser, power_of_two_modulo(shift > 0 ? shift : -shift, prime), prime);
        difference[j] = sum_of(left, negative(right, prime), prime);
        opposite[j] = negative(difference[j], prime);
        product[j] = right;
    }
    const int sign = sign_of_residues(difference, n);
    *out = 0;
    if (sign == 0) return true;
    const Floating size = sign > 0 ? floating_of_digits(difference, n) : floating_of(opposite, n);
    const Floating ratio = quotient(size, floating_of(product, n));
    // By the size itself: mantissas have exponents of their own.
    const int own = exponent_of(ratio.mantissa.high), sum = ratio.exponent + own, e = sum > 900 ? 900 : sum;
    *out = sign * (e < -900 ? 0x1p-1000 : ratio.mantissa.high / power_of_two(own) * power_of_two(e));
    return true;
}

}  // namespace netmesh
