// What the jobs on explicit complexes share: from a linked complex to a diagram in the context.
#pragma once
#include <cstdint>

#include "api/dispatch.hpp"
#include "complex/listed_complex.hpp"
#include "jobs/persist_complex.hpp"

namespace netmesh {

// Room for the rows and values of a complex with the given counts, at the arena's low end. False: out of memory.
bool take_complex(Arena& arena, ListedComplex& complex);

// Notes where an ordered complex lies, for netmesh_get_cycle. False: out of memory.
bool keep_complex(netmesh_context* context, const ListedComplex& complex);

// How many inputs, the first vertices of the mesh, netmesh_persist let enter at 0 before their stars.
std::uint32_t born_at_zero(const netmesh_context* context);

// Keeps the diagram of an explicit complex in an otherwise empty context; without representatives it is moved to where
// the complex was.
Status keep_pairs(netmesh_context* context, PairList pairs, const ComplexRequest& request);

// Orders a linked complex that lies at the low end of an otherwise empty context, computes its diagram and keeps that,
// with representatives the complex as well. The caller has set point_dim, points, inputs and the input's fingerprint.
// out_of_memory, cancelled, internal: the context is to be cleared.
Status keep_diagram_of(netmesh_context* context, ListedComplex& complex, const ComplexRequest& request,
                       Monitor& monitor);

}  // namespace netmesh
