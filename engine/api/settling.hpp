// How a request is settled, step by step: common steps in settle.cpp, those of a kind of filter where its settle names
// them, those of meshes in settle_mesh.cpp. A program holds the steps of the filters and methods that it names.
#pragma once
#include "api/settle.hpp"
#include "filtration/filters.hpp"
#include "numerics/square_root.hpp"

namespace netmesh {

inline Complaint fine() { return {}; }
// Of what a weighting reads when a job begins: a plan has no numbers.
inline Complaint missing_weights(const netmesh_request& r) {
    return r.weighting != nullptr && r.points.weights == nullptr
               ? Complaint{NETMESH_FIELD_WEIGHTS, "a weighting without weights; give points.weights"}
               : Complaint{};
}
inline bool is_length(double x) { return x >= 0 && is_finite(x); }
inline bool is_valid_ratio(double ratio) { return ratio >= ratio_least && ratio < 0x1p100; }
inline bool is_given(double x) { return x != 0; }
inline bool asks_sizes(const netmesh_sizes& sizes) {
    return sizes.eps != 0 || sizes.at_inputs != 0 || sizes.size != nullptr;
}

class Settling {
public:
    Settling(Call to, std::uint32_t held_dim, netmesh_request* request)
        : call(to), source(source_of(*request)), dim(source == Source::points ? request->points.dim : held_dim),
          row(request->filter != nullptr ? find_filter(request->filter->id) : nullptr), r(*request), goal(r.goal),
          rules(r.mesh) {}

    bool has(std::uint32_t trait) const { return row != nullptr && row->has(trait); }
    bool is_of(FilterSource kind) const { return row != nullptr && row->source == kind; }
    bool takes_alpha() const {
        return r.filter != nullptr && (r.filter->id == NETMESH_FILTER_ALPHA || r.filter->id == NETMESH_FILTER_AUTO);
    }
    bool is_promise() const { return call == Call::promise; }
    bool is_certified() const { return r.values == NETMESH_VALUES_CERTIFIED; }
    double ratio_of_tau() const { return square_root(2 + tau_of(dim, rules.tau)); }
    bool is_valid_tau() const {
        const double tau = tau_of(dim, rules.tau);
        return tau > 2 && is_finite(tau);
    }
    // Sizes of cells are asked for, whoever does.
    bool is_sized() const { return asks_sizes(rules.sizes) || is_given(goal.error) || is_given(goal.eps); }
    bool certifies() const {
        return rules.method != nullptr ? rules.method->certifies() : is_promise() && is_given(goal.ratio);
    }

    const Call call;
    const Source source;
    const std::uint32_t dim;
    const Filter* const row;  // of the request's filter; null: none
    netmesh_request& r;
    netmesh_goal& goal;
    netmesh_mesh_rules& rules;
};

[[gnu::always_inline]] inline Complaint dispatch_settle(const netmesh_filter& filter, const Settling& s) {
    return filter.settle(s);
}
[[gnu::always_inline]] inline Complaint dispatch_settle(const netmesh_method& method, const Settling& s) {
    return method.settle(s);
}
[[gnu::always_inline]] inline Complaint dispatch_settle(const netmesh_want& want, const Settling& s) {
    return want.settle(s);
}

[[gnu::always_inline]] inline Complaint dispatch_settle(const netmesh_weighting& weighting, const Settling& s) {
    return weighting.settle(s);
}
[[gnu::always_inline]] inline Complaint dispatch_settle(const netmesh_periods& periods, const Settling& s) {
    return periods.settle(s);
}

// The first of what is given that is not among those that are read, a union of given::*: a complaint with the text.
Complaint refuse_unread(const netmesh_request& request, std::uint32_t read, const char* text);

// Steps that several kinds of filters share.
Complaint settle_neighbours(const Settling& s);
Complaint settle_mesh_degree(const Settling& s);
Complaint settle_accuracy(const Settling& s);  // eps, theta and ratio of the filters tight and scales
Complaint settle_rules(const Settling& s);     // the mesh; of methods without a filter all there is
Complaint settle_on_mesh(const Settling& s);   // all of a filter on meshes

}  // namespace netmesh
