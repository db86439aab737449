// Minors modulo a prime.
#pragma once
#include "numerics/minors.hpp"
#include "numerics/residues.hpp"

namespace netmesh {

// A matrix modulo a prime by columns, [1] with its signs changed.
struct ResidueMatrix {
    std::uint64_t entry[minor_rows_max][2][minor_rows_max];

    // r in [0, prime).
    void put(int column, int row, std::uint64_t r, const ResiduePrime& prime) {
        entry[column][0][row] = r;
        entry[column][1][row] = prime.value - r;
    }
};

// The minors of order `order` of the first columns of n rows, in [0, prime), numbered as in minors.hpp, in one of two
// levels or, of order 1, the first column; 1 <= order <= n.
using ResidueLevels = std::uint64_t[2][widest_level(minor_rows_max)];
const std::uint64_t* residue_minors(int n, int order, const ResidueMatrix& a, ResidueLevels& level,
                                    const ResiduePrime& prime);

}  // namespace netmesh
