// Quality of the mesh that a context holds.
#pragma once
#include "api/call.hpp"
#include "filtration/filter.hpp"
#include "mesh/hierarchy_quality.hpp"
#include "mesh/quality.hpp"
#include "mesh/sizing.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

// The cages of the mesh; none of a mesh without.
inline Cage* cages_of(Context& context) { return context.mesh.cages.in(&context); }
inline std::uint32_t cage_count_of(const Context& context) {
    return static_cast<std::uint32_t>(context.mesh.cages.count);
}

// The cages, for measure_hierarchy.
template <int D> HierarchyRequest hierarchy_of(Context& context) {
    HierarchyRequest request = {cages_of(context), cage_count_of(context), domain_of<D>(context.mesh)};
    request.kind = context.mesh.cage_kind;
    return request;
}

// Aspect ratio, and what is wrong with the cages where there are any. out_of_memory.
template <int D> Status measure_quality(Context& context, Store<D>& store, HierarchyQuality* quality) {
    const Domain<D> domain = domain_of<D>(context.mesh);
    *quality = HierarchyQuality{};
    return !built::cages || cage_count_of(context) == 0
               ? worst_aspect_ratio<D>(store, domain, context.arena, &quality->worst, &quality->vertex)
               : measure_hierarchy(store, hierarchy_of<D>(context), context.arena, quality);
}

// The largest size of a cell over the one asked for. out_of_memory.
template <int D> Status measure_sizes(Context* context, Store<D>& store, const SizeRule& sizes) {
    if (!built::sizes) return Status::ok;
    KeptMesh& mesh = context->mesh;
    SizeRatio ratio;
    const Status status =
        worst_size_ratio<D>(store, {domain_of<D>(mesh), context->input.distinct, sizes}, context->arena, &ratio);
    mesh.size_ratio_max = ratio.worst;
    return status;
}

// The mesh as jobs on filters take it.
template <int D> FilteredMesh<D> filtered_mesh_of(const Context& context, Store<D>& store) {
    return {store, domain_of<D>(context.mesh), context.input.distinct, context.mesh.goal.clipped};
}

}  // namespace netmesh
