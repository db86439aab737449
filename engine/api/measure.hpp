// Quality of the mesh that a context holds.
#pragma once
#include "api/call.hpp"
#include "filtration/any_mesh.hpp"
#include "mesh/check/hierarchy_quality.hpp"
#include "mesh/check/quality.hpp"
#include "mesh/sizing.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

// The cages of the mesh; none of a mesh without.
inline Cage* cages_of(Context& context) { return context.mesh.cages.in(&context); }
inline std::uint32_t cage_count_of(const Context& context) {
    return static_cast<std::uint32_t>(context.mesh.cages.count);
}

// The triangulation or mesh and its domain, with the dimension as a number.
inline AnyStore store_of(Context& context) {
    return AnyStore(static_cast<int>(context.input.dim), context.arena, context.mesh.store);
}
inline AnyDomain domain_of(const Context& context) {
    AnyDomain domain;
    domain.dim = static_cast<int>(context.input.dim);
    copy(domain.dim, context.mesh.centre, domain.centre);
    domain.radius = context.mesh.radius;
    domain.enclosing_radius = context.mesh.enclosing_radius;
    return domain;
}

// The cages, for measure_hierarchy.
inline HierarchyRequest hierarchy_of(Context& context, const AnyDomain& outermost) {
    HierarchyRequest request = {cages_of(context), cage_count_of(context), outermost};
    request.kind = context.mesh.cage_kind;
    return request;
}

// Aspect ratio, and what is wrong with the cages where there are any. out_of_memory.
inline Status measure_quality(Context& context, const AnyStore& store, HierarchyQuality* quality) {
    const AnyDomain domain = domain_of(context);
    *quality = HierarchyQuality{};
    return cage_count_of(context) == 0
               ? worst_aspect_ratio(store, domain, context.arena, &quality->worst, &quality->vertex)
               : measure_hierarchy(store, hierarchy_of(context, domain), context.arena, quality);
}

// The largest size of a cell over the one asked for. out_of_memory.
inline Status measure_sizes(Context* context, const AnyStore& store, const SizeRule& sizes) {
    if (!built::sizes) return Status::ok;
    KeptMesh& mesh = context->mesh;
    SizeRatio ratio;
    const Status status =
        worst_size_ratio(store, {domain_of(*context), context->input.distinct, sizes}, context->arena, &ratio);
    mesh.size_ratio_max = ratio.worst;
    return status;
}

// The mesh as jobs on filters take it.
inline AnyMesh filtered_mesh_of(Context& context) {
    return AnyMesh(store_of(context), domain_of(context), context.input.distinct, context.mesh.goal.clipped);
}

}  // namespace netmesh
