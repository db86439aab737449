// Smallest circumspheres in exact arithmetic: what the float stage of circumsphere.hpp is not certain of.
//
// With e_i the edge vectors from vertex 0 in quanta, which are integers, G their Gram matrix and b its diagonal, the
// centre is vertex 0 + sum of beta_i e_i with G beta = b / 2. So by Cramer, with G_i for G with b as column i,
//     beta_i = det G_i / (2 det G),   beta_0 = (2 det G - sum of det G_i) / (2 det G),
//     squared radius = (b . G^-1 b) / 4 = (sum of b_i det G_i) / (4 det G)   squared quanta.
// All of these determinants are residues (residues.hpp). det G is positive, but for flat simplices, of which it is 0.
#pragma once
#include <cstddef>
#include <cstdint>

#include "geometry/circumsphere.hpp"
#include "numerics/real.hpp"
#include "numerics/residues.hpp"
#include "predicates/exact_stage.hpp"

namespace netmesh {

class ExactSphere {
public:
    static constexpr int dim_max = dimension_most();
    // Words of scratch that any question takes in dimension `dim`; words(): those that this sphere's take.
    static constexpr std::size_t room(int dim) { return std::size_t(dim + 3) * residue_prime_count; }

    // point: k+1 addresses of dim finite coordinates; not read later. 1 <= k <= dim <= dimension_most().
    ExactSphere(const double* const* point, int k, int dim);

    // Whether the table of primes is long enough for signs: differences of coordinates below 2^(16,700 / (2k+2))
    // quanta. The questions below ask for it.
    bool in_range() const { return primes_for_bits(square_bits()) <= residue_prime_count; }
    std::size_t words() const;
    // The signs alone; false: the simplex is flat.
    bool find_within(std::uint64_t* scratch, std::uint32_t* within) const;
    // The radius alone, of a simplex that is not flat. Where 87 bits do not tell the nearest double, the squared radius
    // is compared with that of a midpoint between doubles. False: that is out of range, though signs may be in range.
    bool find_radius(std::uint64_t* scratch, double* radius) const;

private:
    // What is known modulo one prime: det[0] = det G, det[i] = det G_i, sum = sum of b_i det G_i.
    struct Residues {
        std::uint64_t det[dim_max + 1], sum;
    };
    Residues modulo(const ResiduePrime& prime) const;
    int compare_midpoint(double x, std::uint64_t* scratch) const;

    // Of the magnitudes, with lengths^2 < 2^length_bits: det G by Hadamard, each det G_i by its k! products.
    int det_bits() const { return k_ * length_bits_; }
    int square_bits() const { return (k_ + 1) * length_bits_ + 14; }

    ScaledInteger x_[dim_max + 1][dim_max];
    int k_, dim_, quantum_, length_bits_, power_max_;
};

}  // namespace netmesh
