// Hierarchical quality (definition 4.5) of a mesh with cages, from vertices, cells and cages as they are.
#pragma once
#include <cstdint>

#include "delaunay/check.hpp"
#include "mesh/any_domain.hpp"
#include "mesh/cages/cage.hpp"

namespace netmesh {

struct HierarchyQuality {
    double worst;            // largest aspect ratio of a clipped cell, of vertices that are not exempt and of cages
    std::uint32_t vertex;    // whose, or the centre of which cage; none when there is none
    bool is_hierarchy;       // nested balls about inputs; otherwise nothing was measured
    CheckResult encroached;  // why this is no hierarchical mesh: .cell is the centre of the cage at fault
};

// Scratch of measure_hierarchy.
struct HierarchyScratch {
    static constexpr std::size_t vertex_bytes = 2 * sizeof(double) + sizeof(std::uint32_t) + sizeof(bool);
    static constexpr std::size_t cell_bytes = 2 * sizeof(std::uint32_t);
    static constexpr std::size_t cage_bytes = sizeof(double) + sizeof(std::uint32_t) + sizeof(bool);
};

struct HierarchyRequest {
    Cage* cages;
    std::uint32_t count;
    AnyDomain outermost;
    double* ratios = nullptr;  // [vertex_count], with domains or neither
    std::uint32_t* domains = nullptr;
    double* cage_radii = nullptr;  // [2 * count], with ratios or not
    CageKind kind = CageKind::compact;
};

// Of cages of the thesis cells are not clipped and nobody is excused; inputs that a shell has yielded to are exempt
// too, and the outermost cage has no cell.
//
// Finds parent and nearest2 of each cage anew, from centres and radii: the balls of cages must be nested or disjoint.
// Encroached is a cage with an input between e r and r of its centre, with an input, or a vertex that is neither in
// nor of the shell of a cage beside it, between r and 2 r / e, without a shell, with a centre that is not an input, or
// with a sphere that sticks out of its parent. Ratios are as cage.hpp describes, corners solved for anew, nearest
// distances recomputed. Where ratios is not null: ratios[v] := that of v's clipped cell, 0 for exempt vertices;
// domains[v] := its innermost cage or none; cage_radii: in-radius and out-radius of each cage's cell. The store may be
// in use: ghosts and free slots are passed over. O(depth of the hierarchy * cells); scratch: HierarchyScratch.
// out_of_memory.
Status measure_hierarchy(const AnyStore& store, const HierarchyRequest& request, Arena& arena,
                         HierarchyQuality* quality);

}  // namespace netmesh
