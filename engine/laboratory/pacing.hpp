// Orderings of the inputs and how well paced they are (thesis 1.1, 3.8).
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"
#include "memory/work.hpp"
#include "mesh/input_tree.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// theta[i] = distance from input order[i] to the nearest of order[0..i-1] over that to the second nearest, in (0, 1]; 1
// for i < 2. order[0..count) is a permutation of the tree's inputs 0..count-1. The ordering is theta-well-paced for its
// least theta_i. Expected O(n log n). Scratch: 8 bytes a point. out_of_memory, cancelled.
Status pace(const AnyStore& store, const AnyInputTree& tree, const std::uint32_t* order, std::uint32_t count,
            const Work& work, double* theta);

// The farthest-first ordering: an input far from input 0, then always one of those farthest from all before.
//
// It is a theta-well-paced ordering, for theta its least theta_i, and up to a constant there is no better one that
// begins with a diameter, as 3.8 asks for. For let theta_i be the least, r the distance of p_i to its nearest
// predecessor p: everything is within r of P_{i-1}, and P_{i-1} has no point but p within r / theta_i - r of p. So the
// inputs nearest to p form a cluster of diameter at most 2r, two of them at least, that is r / theta_i - 3r away from
// all others; whatever ordering has points outside a cluster before its second point has a theta of at most 2 theta_i /
// (1 - 3 theta_i) there.
//
// Cost O(n log n) for each factor of two in the spread at most, O(n log n) on inputs of moderate spread. Scratch: 20
// bytes a point. out_of_memory, cancelled.
Status farthest_first_order(const AnyStore& store, const AnyInputTree& tree, std::uint32_t count, const Work& work,
                            std::uint32_t* order);

}  // namespace netmesh
