// NetMesh (thesis 4.5, 4.7): a hierarchical mesh, whose size is linear in the number of inputs whatever their spread.
#pragma once
#include <cstdint>

#include "mesh/ball_lists.hpp"
#include "mesh/cage.hpp"
#include "mesh/quality_audit.hpp"
#include "mesh/refine.hpp"

namespace netmesh {

struct HierarchyOptions {
    double tau;            // > 2
    double domain_factor;  // as RefineOptions
    bool finish;           // FinishMesh (4.7.6): release all cages and refine what they kept apart
    std::uint64_t seed;
    bool cages = true;  // false: Sparse Voronoi Refinement (4.4), in the same order of events
    // Audits, see the two headers. Location: inputs are stored in all D-balls that contain them and inserted in rounds of
    // range nets (4.7.5), each of which is drawn from again until the largest load has halved. Quality: everything is
    // measured after each insertion until the last input is in and clean, for small runs. The meshes are as good without.
    bool audit_location = false, audit_quality = false;
};

struct HierarchyReport {
    std::uint32_t cages;  // left in the mesh
    std::uint32_t cages_made, cages_released;
    // Of inputs by point location: how often a search has looked at one (inserted or not), and cells and domains passed on the
    // way to where one belongs. Nearly all of it is spent on looking for an input to yield to around each Steiner point: some 30 /
    // 40 / 60 looks (D = 2 / 3 / 4) a vertex. So it depends on the spread as far as the size of the mesh does, and gaps of a
    // few times the clusters, too narrow for cages, have the largest meshes.
    std::uint64_t touches;
    LocationAudit location;  // 0 where not asked for
    QualityAudit quality;
};

// Meshes points[n][D]. Afterwards as after refine(), but that quality is hierarchical (definition 4.5, clipped, see cage.hpp):
// tau bounds the aspect ratio of the cell of each vertex that is not exempt, clipped to the ball of its domain, and of
// the cell of each cage, clipped to the ball of the domain around it. Shell vertices are exempt. The cages stand at *cages at
// the low end of the arena before the cells, parents before or behind their children. Where cages are left, vertex.origin is some
// input near by and not always the nearest.
//
// Statuses as refine(); `internal` when an audit finds an input in other D-balls than it is stored in, or an encroached cage.
// Memory above that of refine(): 44 bytes an input; with audits what they say.
template <int D>
Status netmesh(Store<D>& store, const double* points, std::size_t n, const HierarchyOptions& options, Monitor& monitor,
               InputReport* input, Domain<D>* domain, Cage** cages, HierarchyReport* report);

}  // namespace netmesh
