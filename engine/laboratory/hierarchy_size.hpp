// Bounds on the size of a mesh with cages: sums over its domains (thesis 4.9.4).
#pragma once
#include <cstdint>

#include "laboratory/feature_integral.hpp"
#include "memory/work.hpp"
#include "mesh/any_domain.hpp"
#include "mesh/cages/cage.hpp"

namespace netmesh {

// M_W: the vertices that are not exempt and in domain W (their innermost cage bounds it). |M| is the sum of |M_W| and 2
// D vertices of a shell for each cage: those are there by definition and count in both bounds as they are. B: the ball
// that cells of W are clipped to. Q: the inputs in W and the centres of the cages directly inside of it; where that is
// a single point, the nearest exempt vertex of W as well. So Q is a part of the mesh, and f_Q is 1-Lipschitz. V: the
// volume of the unit ball. r_v: half of the way from v to the nearest vertex.
//
// Upper bound. The balls about v of radius r_v are disjoint, and f_Q <= f_Q(v) + r_v <= (2 c + 1) r_v in each, with
// c the largest f_Q(v) / 2 r_v in M_W. Over a ball that contains all of them, f_Q^-D has an integral of V / (2 c + 1)^D
// for each v at least:
//
//     |M_W| <= (2 c + 1)^D / V * integral.
//
// c is measured in the mesh at hand, so this holds of any vertices whatever; what it says is how many there can be for
// this c. That c does not depend on the inputs is 4.9.2, and not proven for compact cages.
//
// Lower bound. Within s of B's centre any point has its nearest vertex in M_W or inside a cage directly inside of W,
// if s <= (F - a) / 2: other vertices, which are exempt or outside of the cage around W, are at F or more from the
// centre, some q in Q is at a, and |x - q| <= s + a <= F - s. With s at most B's radius, what v in M_W has of this ball
// is within tau r_v of v, and there f_Q >= f_M >= r_v: it has V tau^D of the integral of f_Q^-D at most. What is left
// is in cells of cages. That of a cage with centre u, radius r and in-radius R is within tau R of u; each x in it is
// nearest to some w with |w - u| < r; and all other points of Q being q or more away from u, f_Q(x) >= (q - r) / 2, as
// x is half as far from each of them as w is at least, and f_Q(x) no less than the least of these distances. So
//
//     |M_W| >= integral / (V tau^D) - sum over these cages of (2 R / (q - r))^D,
//
// or 0, of any mesh of hierarchical quality tau with these cages.
//
// Rounding: distances are known within 2^-48, balls are larger and smaller by 2^-40, and results give way by 2^-15.
struct DomainSum {
    std::uint64_t size;    // |M|, shells included
    double feature_ratio;  // the largest c, of all domains
    double lower, upper;
    std::uint64_t boxes;  // of all integrals
};

struct DomainSumRequest {
    AnyDomain outermost;
    Cage* cages;
    std::uint32_t cage_count;
    std::uint32_t inputs;  // vertices 0..inputs-1
    double tau;
    double tolerance;  // of the integrals, for all domains together
    std::uint64_t boxes_max;
};

// Of a compact mesh. Balls that are not nested or disjoint are no hierarchy: then the bounds say nothing (0, infinity).
// Cost: measure_hierarchy and two integrals a domain. Scratch: that of measure_hierarchy, 16 bytes a vertex, 17 an
// input, 8 a cage. out_of_memory, cancelled.
Status sum_over_domains(const AnyStore& store, const DomainSumRequest& request, const Work& work, DomainSum* sum);

}  // namespace netmesh
