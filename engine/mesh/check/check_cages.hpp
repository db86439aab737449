// What is wrong with the cages of a mesh while it grows, found by plain loops. For builds with NETMESH_VALIDATE.
#pragma once
#ifdef NETMESH_VALIDATE
#include <cstdint>

#include "mesh/cages/hierarchy.hpp"
#include "mesh/check/check_growth.hpp"

namespace netmesh {

// The smallest cage around x whose radius is above `above`; none outside of all cages.
template <int D>
std::uint32_t innermost_cage(const Store<D>& store, const Hierarchy<D>& hierarchy, const double* x, double above) {
    std::uint32_t innermost = none;
    for (std::uint32_t d = 0; d < hierarchy.made(); ++d) {
        const Cage& cage = hierarchy.cages()[d];
        if (!hierarchy.is_live(d) || !(cage.radius > above) || !is_inside(store, cage, x)) continue;
        if (innermost == none || cage.radius < hierarchy.cages()[innermost].radius) innermost = d;
    }
    return innermost;
}

// The domain of a vertex as Hierarchy::of() finds it.
template <int D> std::uint32_t domain_found(const Store<D>& store, const Hierarchy<D>& hierarchy, std::uint32_t v) {
    const Vertex<D>& vertex = store.vertex(v);
    std::uint32_t d = hierarchy.of_input(vertex.marker == Marker::input ? v : vertex.origin);
    while (!hierarchy.contains(d, vertex.x)) d = hierarchy.present(hierarchy.cages()[d].parent);
    return d;
}

template <int D> const char* shell_violation(const Store<D>& store, const Cage& cage) {
    for (std::uint32_t v = cage.shell; v < cage.shell + shell_size_of(store.dim); ++v) {
        if (v >= store.state.vertex_count || !is_in_mesh(store, v)) return "a shell vertex is not in the mesh";
        if (store.vertex(v).marker != Marker::exempt) return "a shell vertex is not exempt";
        const double d2 = distance2<D>(store.dim, store.point(v), store.point(cage.centre));
        const double least = shell_least * cage.radius;
        if (d2 < least * least || !(d2 < cage.radius * cage.radius)) return "a shell vertex is out of its place";
    }
    return nullptr;
}

// Of a cage d alone: its centre, shell and gap, and the nearest vertex outside.
template <int D>
const char* cage_violation_at(const Store<D>& store, const Hierarchy<D>& hierarchy, std::uint32_t inputs,
                              std::uint32_t d) {
    const Cage& cage = hierarchy.cages()[d];
    if (cage.centre >= inputs || !is_in_mesh(store, cage.centre)) return "a cage's centre is not an input in the mesh";
    const char* const violation = shell_violation(store, cage);
    if (violation != nullptr) return violation;
    const double* const centre = store.point(cage.centre);
    const double inner = cage_epsilon * cage.radius, clear = cage_clearance * cage.radius;
    double nearest2 = infinity;
    for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) {
        const double d2 = distance2<D>(store.dim, store.point(v), centre);
        if (v < inputs && d2 > inner * inner * (1 + validated_slack) && d2 < clear * clear)
            return "an input is in the gap around a cage";
        if (!is_in_mesh(store, v) || d2 < cage.radius * cage.radius) continue;
        if (d2 < nearest2) nearest2 = d2;
        if (!(d2 < clear * clear) || store.vertex(v).marker == Marker::exempt || is_growing(cage)) continue;
        const std::uint32_t around = innermost_cage(store, hierarchy, store.point(v), 0);
        if (hierarchy.contains(around, centre)) return "a vertex encroaches on a cage";
    }
    return is_about(cage.nearest2, nearest2) ? nullptr : "a cage's nearest distance is wrong";
}

// Balls of cages are nested or disjoint, and a cage's parent is the next one around it.
template <int D> const char* nesting_violation(const Store<D>& store, const Hierarchy<D>& hierarchy, std::uint32_t d) {
    const Cage& cage = hierarchy.cages()[d];
    const double* const centre = store.point(cage.centre);
    for (std::uint32_t e = 0; e < d; ++e) {
        if (!hierarchy.is_live(e)) continue;
        const Cage& other = hierarchy.cages()[e];
        const double offset = distance<D>(store.dim, centre, store.point(other.centre));
        const double small = cage.radius < other.radius ? cage.radius : other.radius;
        const double large = cage.radius < other.radius ? other.radius : cage.radius;
        if (offset + small > large && offset < small + large) return "the balls of two cages cross";
    }
    return hierarchy.present(cage.parent) == innermost_cage(store, hierarchy, centre, cage.radius)
               ? nullptr
               : "a cage's parent is not the cage around it";
}

// After a step: all cages and the domains of all vertices. O(cages * (vertices + cages)).
template <int D>
const char* cages_violation(const Store<D>& store, const Hierarchy<D>& hierarchy, std::uint32_t inputs) {
    if (store.state.vertex_count > validated_vertices_max) return nullptr;
    std::uint32_t live = 0, exempt = 0;
    for (std::uint32_t d = 0; d < hierarchy.made(); ++d) {
        if (!hierarchy.is_live(d)) continue;
        ++live;
        const char* violation = cage_violation_at(store, hierarchy, inputs, d);
        if (violation == nullptr) violation = nesting_violation(store, hierarchy, d);
        if (violation != nullptr) return violation;
    }
    if (live != hierarchy.live()) return "the count of cages is wrong";
    for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) {
        if (!is_in_mesh(store, v)) continue;
        exempt += store.vertex(v).marker == Marker::exempt;
        // What comes into a growing cage from outside stays in the domain around.
        const std::uint32_t found = domain_found(store, hierarchy, v),
                            innermost = innermost_cage(store, hierarchy, store.point(v), 0);
        const Cage* const around = innermost == none ? nullptr : &hierarchy.cages()[innermost];
        if (found != innermost &&
            (around == nullptr || !is_growing(*around) || found != hierarchy.present(around->parent)))
            return "a vertex's domain is not the innermost cage around it";
    }
    return exempt == (live + 1) * shell_size_of(store.dim) ? nullptr : "an exempt vertex belongs to no shell";
}

}  // namespace netmesh
#endif
