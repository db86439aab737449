// Smallest circumspheres in exact arithmetic: the signs of circumsphere.hpp, radii that can be compared.
//
// With e_i the edge vectors from vertex 0 in quanta, which are integers, G their Gram matrix and b its diagonal, the
// centre is vertex 0 + sum of beta_i e_i with G beta = b / 2. So by Cramer, with G_i for G with b as column i,
//     beta_i = det G_i / (2 det G),   beta_0 = (2 det G - sum of det G_i) / (2 det G),
//     squared radius = (b . G^-1 b) / 4 = (sum of b_i det G_i) / (4 det G)   squared quanta.
// All of these determinants are residues (residues.hpp). det G is positive, as no cell of a triangulation is flat; it
// is 0 for simplices that are, as those of a triangulation from elsewhere may be.
#pragma once
#include <cstddef>
#include <cstdint>

#include "filtration/circumsphere.hpp"
#include "numerics/real.hpp"
#include "numerics/residues.hpp"
#include "predicates/exact_stage.hpp"

namespace netmesh {

constexpr double radius_max = 0x1.fffffffffffffp1023;  // stands for all above
constexpr double radius_min = 0x1p-1021;               // smaller ones are off by half of the least double besides
// A radius as it is kept: the least double stands for all below it.
inline double kept_radius(double r) { return r >= radius_max ? radius_max : r > 0x1p-1074 ? r : 0x1p-1074; }

// Bound on the error of a radius that exact arithmetic gave, relative to the true one: a handful of roundings, one of
// them to a number that may be denormal, of n least doubles; then the true one is n - 1/2 of them or more. (That it may
// be half of one, of which the kept radius is the double, too: no radius is less than half of a distance.)
inline double exact_radius_error(double radius) {
    if (radius >= radius_max) return infinity;
    return radius >= radius_min ? 0x1p-51 : 0x1p-51 + 1.01 / (2 * (radius * 0x1p537 * 0x1p537) - 1);
}

class ExactSphere {
public:
    static constexpr int dim_max = 6;
    // Words of scratch that a question takes in dimension `dim`.
    static constexpr std::size_t room(int dim) { return std::size_t(dim + 3) * residue_prime_count; }

    // point: k+1 addresses of dim finite coordinates; not read later. 1 <= k <= dim <= 6. For all questions but
    // evaluate the points have to be affinely independent.
    ExactSphere(const double* const* point, int k, int dim);

    // Whether the table of primes is long enough: differences of coordinates below 2^(16,700 / (2k+2)) quanta. The
    // questions below ask for it.
    bool in_range() const { return primes_for_bits(square_bits()) <= residue_prime_count; }
    // `within` is exact; the radius is off by exact_radius_error at most. A flat simplex has an infinite radius.
    Circumsphere evaluate(std::uint64_t* scratch) const;
    // The squared radius to 2^-89 relative. 2^-62 < mantissa < 2^62.
    Floating radius_squared(std::uint64_t* scratch) const;
    // Whether squared radii less than `near` < 1/2 apart, relative, must be equal. They are quotients of integers, p /
    // q and r / s, which differ by 1 / (q r) of the second or not at all.
    static bool equal_if_within(const ExactSphere& a, const ExactSphere& b, double near) {
        const int bits = product_bits(a, b);
        return bits < 1000 && near < power_of_two(-bits - 1);
    }
    // Whether one is the other moved, with axes exchanged or reversed, vertex by vertex: a cheap way to see most of the
    // ties of grids.
    static bool congruent(const ExactSphere& a, const ExactSphere& b);
    // A hash that congruent simplices share.
    std::uint32_t hash() const;
    // How much a's squared radius exceeds b's, relative to b's: 0 if and only if they are equal, the right sign, 2^-50
    // relative; nothing nearer to 0 than 2^-1000. False: out of range, 2^(16,700 / (4k+2)) quanta are not.
    static bool excess(const ExactSphere& a, const ExactSphere& b, std::uint64_t* scratch, double* out);

private:
    // What is known modulo one prime: det[0] = det G, det[i] = det G_i, sum = sum of b_i det G_i.
    struct Residues {
        std::uint64_t det[dim_max + 1], sum;
    };
    Residues modulo(const ResiduePrime& prime) const;

    // Of the magnitudes, with lengths^2 < 2^length_bits: det G by Hadamard, each det G_i by its k! products.
    int det_bits() const { return k_ * length_bits_; }
    int square_bits() const { return (k_ + 1) * length_bits_ + 14; }
    // Of the two products that a comparison takes.
    static int product_bits(const ExactSphere& a, const ExactSphere& b);

    DoubleDouble edge_[dim_max][dim_max];  // [axis][edge], exact
    ScaledInteger x_[dim_max + 1][dim_max];
    int k_, dim_, quantum_, length_bits_, power_max_;
};

}  // namespace netmesh
