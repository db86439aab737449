// Bounds on the size of a mesh, from the input and from the mesh (thesis 3.4, 3.6, 3.8).
#pragma once
#include <cstdint>

#include "laboratory/feature_integral.hpp"
#include "memory/work.hpp"
#include "mesh/any_domain.hpp"
#include "mesh/cages/cage.hpp"
#include "mesh/sizing.hpp"

namespace netmesh {

struct SizeOptions {
    double tau;
    SizeRule rule;     // that the mesh was refined to as well
    double tolerance;  // of the integrals, see feature_integral.hpp
    std::uint64_t boxes_max;
    Cage* cages = nullptr;  // of a mesh with cages; parents and nearest distances are found anew
    std::uint32_t cage_count = 0;
    CageKind kind = CageKind::compact;  // no bounds are proven of cages of the thesis, whose shells are of many sizes
};

// Balls about the domain's centre that integrals are taken over.
enum SizeBall { ball_domain = 0, ball_vertices = 1, ball_wide = 2 };

struct SizeAnalysis {
    std::uint64_t size;         // inserted vertices that are not exempt: |M|; with cages also their shells
    double theta, theta_limit;  // least theta_i of the farthest-first ordering, and what no ordering that begins with a
                                // diameter exceeds (pacing.hpp); 1 below three inputs
    double theta_log_sum;       // sum over i >= 3 of ln(1 / theta_i)
    double radius[FeatureIntegral::balls_max];  // the domain; all vertices' in-balls as well; 7 enclosing radii or more
    FeatureIntegral integral;
    double pace_lower, pace_upper;  // of the wide integral by the theta_i: 3.8.7 and 3.8.5
    double feature_ratio;        // largest f_P(v) / f_M(v) over vertices that are not exempt; with cages P is that of
                                 // v's domain, see hierarchy_size.hpp
    double feature_ratio_bound;  // what 3.3.2 with yielding and 3.7.1 allow; +infinity where they say nothing
    double size_lower;           // of every mesh of aspect ratio tau on this domain: 3.4.2; with cages by domains
    double size_upper;           // of every mesh of this feature_ratio: 3.4.1; with cages by domains
};

// 3.3.2 for refinement that yields: if inputs are inserted first when nearer than gamma times the empty radius,
// Lemma 3.3.1 holds with K - 1 = (K_S - 1) / gamma + 1 at inputs, K_S - 1 = 2 K / tau + 1 at Steiner points (an input
// that comes behind a Steiner point u is at least gamma lambda_u away), so K = (2 + 1/gamma) / (1 - 2 / (gamma tau)).
// +infinity unless gamma tau > 2.
double feature_ratio_bound(double tau, const SizeRule& rule);

// On a compact mesh whose vertices 0..inputs-1 are the inputs. What the vertices' distances to each other are is
// recomputed. Below two inputs f_P is infinite, integrals are 0 and bounds say nothing: lower 0, upper infinite. Cost:
// that of pacing.hpp and feature_integral.hpp, and O(cells). Scratch: 8 bytes a vertex, 33 an input. out_of_memory,
// cancelled.
Status analyse_size(const AnyStore& store, const AnyDomain& domain, std::uint32_t inputs, const SizeOptions& options,
                    const Work& work, SizeAnalysis* analysis);

// The bound that does not hold, null when all do. Room for the rounding of the analysis itself.
const char* violated_size_bound(const SizeAnalysis& analysis);

}  // namespace netmesh
