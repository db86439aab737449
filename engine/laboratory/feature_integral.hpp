// The feature size integral (thesis 3.4, 3.8): how many vertices a mesh needs, up to a constant.
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"
#include "memory/work.hpp"
#include "mesh/input_tree.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// Bounds on the integral of dx / f_P(x)^D over balls about one centre.
struct FeatureIntegral {
    static constexpr int balls_max = 3;
    double lower[balls_max], upper[balls_max];
    std::uint64_t boxes;  // that f_P was evaluated in
};

// What is asked: the balls, and how narrow the bounds are to be for how many boxes.
struct IntegralRequest {
    const double* centre;
    const double* radius;  // [balls], increasing
    int balls;
    double tolerance;
    std::uint64_t boxes_max;
};

// A tree of boxes is refined where half their diagonal h exceeds eta f_P(centre): as f_P
// is 1-Lipschitz, the value in a box is then known within a factor, which eta is chosen for; what a box that crosses a
// sphere has inside counts as one half or less, or more, as its centre says. The bounds are certain, with room for
// rounding; upper / lower - 1 is at most about `tolerance` (boundary aside) if boxes_max boxes do; with less it is what
// they allow, eta being 0.7 at most. The tree's points, two at least, are P. Deterministic. Cost: about
// (D^1.5 / (2 eta))^D times the integral, in nearest-neighbour searches. Scratch: 8 D + 1 bytes for each level of
// boxes, some 2,200 levels. out_of_memory, cancelled.
Status feature_integral(const AnyStore& store, const AnyInputTree& tree, const IntegralRequest& request,
                        const Work& work, FeatureIntegral* integral);

}  // namespace netmesh
