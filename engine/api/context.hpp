// What a context remembers between calls, at the start of the caller's block. Counts, offsets and values only.
#pragma once
#include <cstdint>

#include "delaunay/store.hpp"
#include "homology/cycles/cycles.hpp"
#include "homology/persistence.hpp"
#include "include/netmesh.h"
#include "memory/arena.hpp"
#include "mesh/domain.hpp"
#include "mesh/mesh_request.hpp"

namespace netmesh {

constexpr std::uint64_t context_magic = 0x6E65746D65736801u;

// The block while a result is held:
//
//   | Context | cages | cells | filter values | pairs |        gap        | vertices |
//             ^ start         ^ mesh_mark
//
// (cages that were loaded stand behind the cells), with representatives, where pairs are listed once more,
//
//   | Context | cages | cells | filter values | pairs | pairs | cycles |                 gap                    | vertices |
//
// of an alpha complex or with pairs of zero length
//
//   | Context | cages | cells | filter values | pairs | facets, values | KeptComplex | pairs |   gap   | cycles | vertices |
//
// or, after homology of a complex, the parts in brackets when representatives are kept:
//
//   | Context | [ facets, values | KeptComplex ] | pairs |        gap        | [ cycles ] |
struct KeptComplex {
    std::uint32_t dimension;
    std::uint32_t count[FilteredComplex::dimension_max + 1];
    std::uint64_t rows[FilteredComplex::dimension_max + 1], values[FilteredComplex::dimension_max + 1];  // offsets
};

struct Context {
    std::uint64_t magic;
    std::uint64_t block_bytes;
    Arena arena;
    std::uint64_t start;  // low end of an empty context
    netmesh_detail detail;

    std::uint32_t dim;  // 0: holds no triangulation
    bool is_mesh, complete, has_values, has_diagram;
    StoreState store;
    std::uint64_t points, duplicates, input_fingerprint;
    std::uint32_t inputs;
    RatioGoal goal;  // ratio 0: the mesh is not refined by the certificate
    double tau, aspect_ratio_max, size_ratio_max, over_refine_eps;
    double domain_centre[NETMESH_DIM_MAX], domain_radius, enclosing_radius;

    netmesh_method method;
    std::uint32_t audit;  // what was audited
    std::uint64_t cages_offset;
    HierarchyCounts hierarchy;
    MeshAudit mesh_audit;

    std::uint64_t mesh_mark;  // low end of the mesh alone
    std::uint64_t values_offset, pairs_offset, pair_count, simplices;
    netmesh_filter filter;
    netmesh_values values;
    std::uint32_t max_degree, k;
    double certified_ratio, certified_ratio_best, certified_from;

    bool is_complex, has_cycles;  // then dim is 0
    std::uint32_t point_dim;      // of the points the complex is made of, 0 for one given by its simplices
    bool keeps_zero;
    std::uint64_t kept_offset, result_fingerprint, cycles_high;  // kept_offset: 0 when no complex is kept
                                                                 // cycles_high: the high end below which cycles lie
    CycleStore cycles;
    std::uint32_t scales, scale_points_max, scale_vertices_max;  // scales 0: another filter
    std::uint64_t scale_vertices;
    double separation;

    bool is_loaded;  // the mesh came through netmesh_load

    bool has_bounds;
    std::uint64_t bounds_offset, curve_offset, curve_steps;

    bool has_vineyard;
    std::uint32_t k_first, k_last, vines;
    std::uint64_t vine_ratios_offset, vine_points_offset, vine_points, transpositions;
};

}  // namespace netmesh

struct netmesh_context : netmesh::Context {};
