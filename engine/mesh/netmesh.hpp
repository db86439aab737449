// NetMesh (thesis 4.5, 4.7): a hierarchical mesh, whose size is linear in the number of inputs whatever their spread.
#pragma once
#include <cstdint>

#include "mesh/cage.hpp"
#include "mesh/refine.hpp"

namespace netmesh {

struct HierarchyOptions {
    double tau;            // > 2
    double domain_factor;  // as RefineOptions
    bool finish;           // FinishMesh (4.7.6): release all cages and refine what they kept apart
    std::uint64_t seed;
};

struct HierarchyReport {
    std::uint32_t cages;  // left in the mesh
    std::uint32_t cages_made, cages_released;
    std::uint64_t touches;  // of inputs by point location and searches: inputs looked at, cells and domains passed
};

// Meshes points[n][D]. Afterwards as after refine(), but that quality is hierarchical (definition 4.5, clipped, see cage.hpp):
// tau bounds the aspect ratio of the cell of each vertex that is not exempt, clipped to the ball of its domain, and of
// the cell of each cage, clipped to the ball of the domain around it. Shell vertices are exempt. The cages stand at *cages at
// the low end of the arena before the cells, parents before or behind their children.
//
// Statuses as refine(). Memory above that of refine(): 44 bytes an input.
template <int D>
Status netmesh(Store<D>& store, const double* points, std::size_t n, const HierarchyOptions& options, Monitor& monitor,
               InputReport* input, Domain<D>* domain, Cage** cages, HierarchyReport* report);

}  // namespace netmesh
