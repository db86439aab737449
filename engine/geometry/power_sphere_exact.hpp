// Smallest spheres that are orthogonal to weighted vertices (predicates/weights.hpp), in exact arithmetic: what the
// float stage of circumsphere_fast.hpp is not certain of.
//
// circumsphere_exact.hpp with b_i = |e_i|^2 + w_0 - w_i: G beta = b / 2, and the power at the centre c, which is the
// same for all vertices, |c - v_i|^2 - w_i, is
//     a = (sum of b_i det G_i - 4 w_0 det G) / (4 det G)   squared quanta.
#pragma once
#include "geometry/circumsphere_exact.hpp"

namespace netmesh {

class ExactPowerSphere {
public:
    static constexpr int dim_max = dimension_most();
    // point: k+1 addresses of dim+1 finite numbers; not read later. 1 <= k <= dim. Scratch: ExactSphere::room.
    ExactPowerSphere(const double* const* point, int k, int dim, bool are_radii);

    // As of ExactSphere.
    bool in_range() const { return primes_for_bits(power_bits()) <= residue_prime_count; }
    bool find_within(std::uint64_t* scratch, std::uint32_t* within) const;
    // a to the nearest double, ties to even, infinite beyond the largest; or sign(a) times the root of |a|.
    bool find_power(std::uint64_t* scratch, bool squares, double* value) const;

private:
    // What is known modulo one prime: det[0] = det G, det[i] = det G_i, power = a times 4 det G.
    struct Residues {
        std::uint64_t det[dim_max + 1], power;
    };
    Residues modulo(const ResiduePrime& prime) const;
    int compare_midpoint(double x, bool squares, bool negative, std::uint64_t* scratch) const;

    // Of the magnitudes: lengths^2 < 2^length_bits, b_i < 2^right_bits, 4 w_0 < 2^(right_bits + 1).
    int power_bits() const { return (k_ - 1) * length_bits_ + 2 * right_bits_ + 16; }
    int det_bits() const { return k_ * length_bits_; }

    ScaledInteger x_[dim_max + 1][dim_max + 1];
    int k_, dim_, quantum_, length_bits_, right_bits_, power_max_;
    bool are_radii_;
};

}  // namespace netmesh
