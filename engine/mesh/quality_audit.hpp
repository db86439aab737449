// The invariants of 4.8 and 4.9 on an intermediate mesh, recomputed by looking at everything.
#pragma once
#include <cstdint>

#include "mesh/cage.hpp"

namespace netmesh {

// Worst of all intermediate meshes, one for each vertex inserted (with the cage that is made for it, if one is).
struct QualityAudit {
    std::uint32_t meshes;
    std::uint32_t
        encroached;  // meshes with an encroached cage (condition 3 of definition 4.5); the engine stops at one
    double worst;    // aspect ratio of a vertex's or a cage's cell (conditions 1 and 2): the quality invariant's tau'
    double feature;  // K of the feature size invariant: f_P(v) / f_M(v) over all v in M_Omega and all Omega
    double cage, steiner,
        input;  // K' of the insertion radius invariant: f_P(v) / lambda_v of shell vertices, of what cleaning
                // inserts (inputs that it yields to included), of inputs whose turn it is
};

// What `cage` cannot exceed: in radii, a shell vertex is at most shell_factor (1 + jitter) + e from the second input
// of its domain, and an input (within e of the centre) or another shell vertex is the nearest neighbour that it is
// given.
template <int D> double cage_insertion_bound();

// What the last step has inserted: `vertex`, an input or not, and before it, of the vertices from first_made on, the
// shell of a cage if one was made.
struct AuditStep {
    std::uint32_t first_made, vertex;
    bool cleaning;
};

// What audit_quality places besides HierarchyScratch: ratios and domains, and the lists of each domain's vertices.
struct AuditScratch {
    static constexpr std::size_t vertex_bytes = sizeof(double) + 2 * sizeof(std::uint32_t);
    static constexpr std::size_t cage_bytes = sizeof(Cage) + 2 * sizeof(std::uint32_t);
};

// Adds one mesh to *audit. cages[0..made): those released have no shell. P is what of the inputs is inserted; f_P says
// nothing in a domain of fewer than two, and is left out there. Works on a store in use as on a compact one. Cost:
// that of measure_hierarchy, and the square of the largest domain's vertices. Scratch: that and
// AuditScratch. out_of_memory.
template <int D>
Status audit_quality(Store<D>& store, const Cage* cages, std::uint32_t made, const Domain<D>& outermost, Arena& arena,
                     const AuditStep& step, QualityAudit* audit);

}  // namespace netmesh
