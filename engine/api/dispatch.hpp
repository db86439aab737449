// From a dimension known at run time to one known at compile time.
#pragma once
#include <cstdint>
#include <type_traits>

#include "vocabulary/dimension.hpp"
#include "api/context.hpp"
#include "mesh/hierarchy_quality.hpp"
#include "mesh/quality.hpp"
#include "mesh/sizing.hpp"

namespace netmesh {

inline Monitor monitor_of(const netmesh_options& options) { return Monitor(options.poll, options.user); }

// Whether an enumeration that came from outside has a value in [least, most]. Callers in C may pass any int, which C++
// must not even read as an enumeration.
template <class E> bool in_range(const E& e, E least, E most) {
    using Value = std::underlying_type_t<E>;
    Value value;
    __builtin_memcpy(&value, &e, sizeof value);
    return value >= static_cast<Value>(least) && value <= static_cast<Value>(most);
}

inline SizeRule size_rule_of(const netmesh_options& options) {
    return {options.over_refine_eps, options.size, options.size_user};
}

// Records a failure (or success) for netmesh_get_detail and translates it.
inline netmesh_status finish(netmesh_context* context, Status status, const char* message, std::uint64_t a = 0,
                             std::uint64_t b = 0) {
    if (status == Status::internal && context->is_loaded) {
        // What was loaded passed as a ball by its facets and its hull alone.
        status = Status::check_failed;
        message = "the cells that were loaded are not a triangulated ball";
    }
    context->detail = netmesh_detail{};
    context->detail.status = static_cast<netmesh_status>(status);
    context->detail.index_a = a;
    context->detail.index_b = b;
    context->detail.message = status == Status::ok ? "" : message;
    if (status == Status::out_of_memory) {
        const std::uint64_t wanted = context->arena.bytes_wanted();
        context->detail.bytes_wanted = wanted + (context->block_bytes - context->arena.bytes());
    }
    return context->detail.status;
}

template <int D> Domain<D> domain_of(const Context& context) {
    Domain<D> domain;
    for (int k = 0; k < D; ++k) domain.centre[k] = context.domain_centre[k];
    domain.radius = context.domain_radius;
    domain.enclosing_radius = context.enclosing_radius;
    return domain;
}

inline Cage* cages_of(const Context& context) {
    // The context stands at the start of the block, wherever that is now.
    const auto* const base = reinterpret_cast<const unsigned char*>(&context);
    return reinterpret_cast<Cage*>(const_cast<unsigned char*>(base) + context.cages_offset);
}

// Aspect ratio and cages of the mesh that the context holds. out_of_memory.
template <int D> Status measure_mesh(Context& context, Store<D>& store, HierarchyQuality* quality) {
    const Domain<D> domain = domain_of<D>(context);
    *quality = HierarchyQuality{};
    return context.hierarchy.cages == 0
               ? worst_aspect_ratio<D>(store, domain, context.arena, &quality->worst, &quality->vertex)
               : measure_hierarchy<D>(store, cages_of(context), context.hierarchy.cages, domain, context.arena,
                                      quality);
}

// Checks what every job checks: the context and its block, the options' size, the dimension.
bool usable(netmesh_context* context);
bool usable(const netmesh_options* options);
double tau_of(const netmesh_options& options);
double eps_of(const netmesh_options& options);  // of the tight filter and of scales
double theta_of(const netmesh_options& options);
inline bool is_valid_ratio(double ratio) { return ratio > 1 && ratio * ratio > 2 && ratio < 0x1p100; }
inline RatioGoal goal_of(const netmesh_options& options) {
    return {options.ratio, options.focus_ratio, options.focus_from, options.focus_to};
}
inline bool is_valid_theta(double theta) { return theta > 0 && theta <= 1.0 / 9; }
inline bool is_valid_eps(double eps) { return eps > 0 && eps <= 0.5; }

// Forgets the result held.
void clear(netmesh_context* context);
// Forgets the diagram and the filter values.
void clear_diagram(netmesh_context* context);

}  // namespace netmesh
