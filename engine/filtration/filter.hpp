// What a filter is: a row of the table in filters.cpp; and what evaluating one on a mesh takes and gives.
#pragma once
#include <cstdint>

#include "certificate/certificate.hpp"
#include "complex/subcomplex.hpp"
#include "delaunay/store.hpp"
#include "include/netmesh.h"
#include "memory/work.hpp"
#include "mesh/domain.hpp"

namespace netmesh {

// What a filter filters.
enum class FilterSource : std::uint32_t { mesh, delaunay, scales, points };
// What holds of a filter; a row has a union of these.
namespace filter_trait {
enum : std::uint32_t {
    needs_k = 1 << 0,         // reads a number of neighbours
    needs_function = 1 << 1,  // reads a function of the caller's
    has_eps = 1 << 2,         // promises an accuracy that the caller chooses
    has_theta = 1 << 3,       // reads a mediality
    has_values = 1 << 4,      // its own values and the certified ones differ
    has_vineyard = 1 << 5,    // k_vineyard takes it
    has_goal = 1 << 6,        // the mesh may be refined by its certificate
    has_cycles = 1 << 7,      // a cycle can be given for each bar
    // Its function is the distance to the inputs, 0 there: covers begin with balls about the inputs (mesh_filter.hpp).
    zero_at_inputs = 1 << 8,
    // Inputs enter alone at 0 and their stars later. Inputs of the basic filter have the value 0 as their stars do.
    inputs_enter_first = 1 << 9,
    bounds_by_scale = 1 << 10,    // bars are bounded by the intervals of all cells, not by the ratio alone
    has_tighter_cells = 1 << 11,  // its intervals are those of single cells, which tighten_cell_bounds.hpp narrows
    made_of_edges = 1 << 12,      // on points: a simplex enters with its last edge (Rips), not with its ball (Cech)
    clips_cells = 1 << 13,        // its intervals can be those of cells clipped to a ball (clipped_nerve.hpp)
};
}  // namespace filter_trait

struct Filter {
    netmesh_filter_id id;
    FilterSource source;
    std::uint32_t traits;

    bool has(std::uint32_t trait) const { return (traits & trait) != 0; }
};

// The words of a row, apart from it: jobs read no words, so a program without what tells them has none.
struct FilterText {
    const char* name;
    const char* reference;  // the function whose diagram is certified; {k} and {D} stand for the numbers
};

struct MeshFilter;  // filters.hpp

struct FilterRequest {
    netmesh_filter_id filter;   // of source mesh
    const MeshFilter* on_mesh;  // that filter's
    FilterValues values;
    std::uint32_t k = 0;                         // of filters that need it, at most the number of inputs; 0 counts as 1
    const netmesh_function* function = nullptr;  // of the filter FUNCTION
};

struct Evaluation {
    double* value;                 // [vertices], given by the caller: t(v)
    Interval* interval = nullptr;  // [vertices], given by the caller; null: not asked for
    Certificate certificate = {};
    std::uint32_t zero_born = 0;  // vertices 0..zero_born-1 enter at 0, before their stars
    std::uint32_t culprit = 0;    // after not_finite: the vertex at which the function is not finite
};

}  // namespace netmesh
