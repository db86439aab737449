// What a context remembers between calls, at the start of the caller's block: a header, the arena, and a sum of
// results. Each result says itself whether it is there, holds counts, offsets and values only, and is forgotten by
// `= {}`.
#pragma once
#include <cstddef>
#include <cstdint>

#include "api/slice.hpp"
#include "delaunay/plane_cells.hpp"
#include "delaunay/store.hpp"
#include "diagram/pair.hpp"
#include "homology/cycles/cycles.hpp"
#include "include/netmesh.h"
#include "jobs/bar_bounds.hpp"
#include "jobs/k_vineyard.hpp"
#include "memory/arena.hpp"
#include "mesh/cages/cage.hpp"
#include "mesh/mesh_request.hpp"

namespace netmesh {

constexpr std::uint64_t context_magic = 0x6E65746D65736802u;

// The block while a result is held:
//
//   | Context | cages | cells | filter values | pairs |        gap        | vertices |
//             ^ start         ^ mesh.low_end
//
// (cages that were loaded stand behind the cells), with representatives, where pairs are listed once more,
//
//   | Context | cages | cells | filter values | pairs | pairs | cycles |            gap               | vertices |
//
// of an alpha complex or with pairs of zero length
//
//   | Context | cages | cells | filter values | pairs | facets, values | pairs |   gap   | cycles | vertices |
//
// or, after homology of a complex, the parts in brackets when representatives are kept:
//
//   | Context | [ facets, values ] | pairs |        gap        | [ cycles ] |
//
// of points with periods
//
//   | Context | pairs |        gap        | [ cycles | values, facets, vertices, copies ] | hidden |

// The points or simplices that the other results are made from.
struct KeptInput {
    bool present = false;
    bool is_complex = false;  // there is the diagram of a complex, on the points or of simplices, and no mesh
    std::uint32_t dim = 0;    // 0: a complex given by its simplices
    std::uint64_t points = 0, duplicates = 0, fingerprint = 0;
    std::uint32_t distinct = 0;  // inputs of a mesh, vertices of a complex
    netmesh_weighting_id weighting = NETMESH_WEIGHTING_NONE;
    bool squares = false;       // values of the diagram are powers
    std::uint32_t periods = 0;  // vectors of the lattice
    std::uint64_t copies = 0;
    double moved = 0;
    Slice<std::uint32_t> hidden = {};  // rows, ascending; at the high end, below the vertices
};

// What is wrong with cells that were loaded, so that whoever reads them needs no checker.
struct KeptFlaw {
    std::int64_t text_from = 0;  // as KeptDetail keeps a text; 0: nothing
    std::uint32_t cell = 0;
};

// A Delaunay triangulation or a mesh.
struct KeptMesh {
    bool present = false;
    bool is_mesh = false;       // has a domain, and what is said below `store`
    bool is_loaded = false;     // came through netmesh_load
    KeptFlaw flaw;              // of a triangulation that was loaded: none of the convex hull of its vertices
    std::uint64_t low_end = 0;  // of the arena, with the mesh alone
    StoreState store = {};
    double centre[NETMESH_DIM_MAX] = {}, radius = 0, enclosing_radius = 0;  // the domain
    netmesh_method_id method = NETMESH_METHOD_SVR;
    double tau = 0, aspect_ratio_max = 0;
    RatioGoal goal = {};  // ratio 0: the mesh is not refined by the certificate
    double size_eps = 0, size_ratio_max = 0;
    Slice<Cage> cages;
    CageKind cage_kind = CageKind::compact;
    HierarchyCounts hierarchy = {};
    std::uint64_t touches = 0;  // LocationCounts
    std::uint32_t audited = 0;  // a union of netmesh_audit_what
    MeshAudit audit = {};
};

// The triangulation of few points in the plane in short words (delaunay/plane_few.hpp). Then there is no mesh, but
// mesh.store has counts.
struct KeptPlane {
    bool present = false;
    Slice<PlaneCell<NarrowWords>> cells;
    Slice<double> points;
    Slice<std::uint16_t> place;
};

struct KeptDiagram {
    bool present = false;
    bool keeps_zero = false;
    netmesh_filter_id filter = NETMESH_FILTER_NONE;
    netmesh_values values = NETMESH_VALUES_CERTIFIED;
    std::uint32_t max_degree = 0, k = 0;
    Slice<Pair> pairs;
    bool is_short = false;        // pairs are of the short form (BarList)
    Slice<double> vertex_values;  // of a filter on meshes: one for each vertex
    std::uint64_t simplices = 0;
    double certified_ratio = 0, certified_ratio_best = 0, certified_from = 0, certified_focus = 0;
    double certified_error = 0, fitted_error = 0;
    netmesh_why why = NETMESH_WHY_ASKED;
    std::uint64_t tried_points = 0, tried_cells = 0;

    BarList bars(const void* block) const { return {pairs.in(block), pairs.count, is_short}; }
};

struct KeptBounds {
    bool present = false;
    Slice<BarBounds> bars;
    Slice<ScaleStep> steps;
    double longer_than = 0;  // of a fit that decides bars
};

struct KeptVineyard {
    bool present = false;
    netmesh_filter_id filter = NETMESH_FILTER_NONE;
    netmesh_values values = NETMESH_VALUES_CERTIFIED;
    std::uint32_t max_degree = 0, k_first = 0, k_last = 0, vines = 0;
    Slice<double> ratios;  // [k_last - k_first + 1]
    Slice<VinePoint> points;
    std::uint64_t simplices = 0, transpositions = 0;
    double certified_ratio = 0;
};

// What netmesh_split has made of points.
struct KeptSplit {
    bool present = false;
    std::uint32_t levels = 0;
    Slice<std::uint32_t> order;
    Slice<double> boxes;
};

struct KeptScales {
    bool present = false;
    std::uint32_t count = 0, points_max = 0, vertices_max = 0;
    std::uint64_t vertices = 0;
    double separation = 0;
};

// A complex that was listed simplex by simplex; of[k] in homology's FilteredComplex.
struct KeptComplex {
    // Simplices of one dimension: their facets and their values.
    struct Simplices {
        std::uint64_t rows = 0, values = 0;  // offsets
        std::uint64_t count = 0;
    };
    std::uint32_t dimension = 0;
    Simplices of[FilteredComplex::dimension_max + 1];
};

// Simplices of a complex modulo a lattice are sets of copies; of which points, and where (QuotientCycles).
struct KeptCopies {
    std::uint32_t axes = 0;                             // 0: there are none
    std::uint64_t vertices[dimension_most() + 1] = {};  // offsets, by dimension
    std::uint64_t labels = 0;                           // offset
};

// Representatives of the diagram's pairs.
struct KeptCycles {
    bool present = false;
    bool is_listed = false;      // cycles name simplices of `complex`; else they hold vertices of the mesh
    std::uint64_t high_end = 0;  // of the arena, above the cycles
    CycleStore store = {};
    KeptComplex complex;
    KeptCopies copies;
};

// What the last call said. Its text is kept as the distance from a text of this library's, which is the same wherever
// the program is loaded, so that a block read from a file can be used as well.
struct KeptDetail {
    netmesh_detail said = {};       // but for the message
    std::int64_t message_from = 0;  // see call.cpp
};

struct Context {
    std::uint64_t magic;
    std::uint64_t block_bytes;
    std::uint64_t start;  // low end of an empty context
    Arena arena;
    KeptDetail detail;
    bool complete;            // the job ran to its end
    netmesh_request request;  // of the call that runs, settled, where no stack has to hold it; else all 0

    KeptInput input;
    KeptMesh mesh;
    KeptPlane plane;
    KeptDiagram diagram;
    KeptBounds bounds;
    KeptVineyard vineyard;
    KeptScales scales;
    KeptCycles cycles;
    KeptSplit split;
    Slice<unsigned char> piece;  // of a leaf or a join; empty: none

    // In the caller's block; without the header <new>, which bare compilers may lack.
    static void* operator new(std::size_t, void* place) noexcept { return place; }
};

}  // namespace netmesh

struct netmesh_context : netmesh::Context {};
