// How fine a mesh has to be beyond its quality (thesis 3.7): the out-radius R_v that each clipped cell may have.
#pragma once
#include <cstdint>

#include "certificate/cells.hpp"
#include "mesh/any_domain.hpp"
#include "mesh/input_tree.hpp"
#include "vocabulary/callback.hpp"

namespace netmesh {

// f(v) = min(eps * f_P(v), function(user, x), at_inputs + growth * d_P(v)), d_P the distance to the nearest input; a
// rule that is 0 or null asks for nothing.
struct SizeRule {
    double eps = 0;
    double (*function)(void* user, const double* x) = nullptr;
    void* user = nullptr;
    double at_inputs = 0, growth = 0;

    // What the caller's function says, +infinity without one.
    double by_caller(const double* x) const {
        return function != nullptr ? never_throwing(function)(user, x) : infinity;
    }
    bool asks() const { return eps > 0 || function != nullptr || at_inputs > 0; }
};

// Distance from vertex v to its second nearest input, v itself counted when it is one (3.3): +infinity when there is
// only one input. Inputs have the smallest indices, origin is final. Expected O(log n).
template <class StoreType, class Tree> double feature_size(const StoreType& store, const Tree& tree, std::uint32_t v) {
    const auto& vertex = store.vertex(v);
    double d2;
    tree.nearest(vertex.x, none, vertex.marker == Marker::input ? v : vertex.origin, &d2);
    return square_root(d2);
}

// f(v), +infinity when nothing is asked. What the caller's function says is passed on as it is.
template <class StoreType, class Tree>
double wanted_size(const StoreType& store, const Tree& tree, const SizeRule& rule, std::uint32_t v) {
    double size = rule.eps > 0 ? rule.eps * feature_size(store, tree, v) : infinity;
    const double asked_by_caller = rule.by_caller(store.point(v));
    if (!(asked_by_caller >= size)) size = asked_by_caller;
    if (rule.at_inputs > 0) {
        const double asked = rule.at_inputs + rule.growth * distance_to_inputs(store, VertexId(v));
        if (asked < size) size = asked;
    }
    return size;
}

// A positive double in 16 bits, rounded down (5 bits of fraction), so that it fits a vertex.
inline std::uint16_t size_hint_of(double x) { return static_cast<std::uint16_t>(bits_of(x) >> 47); }
inline double value_of_size_hint(std::uint16_t hint) { return double_of_bits(static_cast<std::uint64_t>(hint) << 47); }

struct SizeRatioRequest {
    AnyDomain domain;
    std::uint32_t inputs;  // vertices 0..inputs-1
    SizeRule rule;
};
struct SizeRatio {
    double worst;
    std::uint32_t vertex;  // whose; none when there is none
};

// Largest R_v / f(v) over inserted vertices that are not exempt. 0 when the rule asks for nothing; +infinity when f is
// not positive. O(cells + v log n); scratch: 8 bytes a vertex, 5 an input. out_of_memory.
Status worst_size_ratio(const AnyStore& store, const SizeRatioRequest& request, Arena& arena, SizeRatio* ratio);

}  // namespace netmesh
