// The constant objects that requests name: filters, methods of meshing, wants. A program that does not name one does
// not link what it leads to. Calls through them are made here, nowhere else.
#pragma once
#include <cstddef>

#include "include/netmesh.h"
#include "mesh/mesh_request.hpp"

namespace netmesh {

struct MeshFilter;  // filtration/filters.hpp: how a filter on meshes is evaluated

enum class Want { bounds, cycles, vines, fit };

}  // namespace netmesh

// What a request can give, in the order in which it is refused: its bit, its member, its field, and the field's name.
// Goals and rules of meshes come first. Objects have a union of those that are read with them.
#define NETMESH_EACH_GIVEN(PART)                                                                                       \
    PART(ratio, goal.ratio, RATIO, "ratio")                                                                            \
    PART(eps, goal.eps, EPS, "eps")                                                                                    \
    PART(theta, goal.theta, THETA, "theta")                                                                            \
    PART(error, goal.error, ERROR, "error")                                                                            \
    PART(focus_ratio, goal.focus_ratio, FOCUS_RATIO, "focus_ratio")                                                    \
    PART(focus_from, goal.focus_from, FOCUS_FROM, "focus_from")                                                        \
    PART(focus_to, goal.focus_to, FOCUS_TO, "focus_to")                                                                \
    PART(longer_than, goal.longer_than, LONGER_THAN, "longer_than")                                                    \
    PART(tau, mesh.tau, TAU, "tau")                                                                                    \
    PART(method, mesh.method, METHOD, "method")                                                                        \
    PART(domain_factor, mesh.domain_factor, DOMAIN_FACTOR, "domain_factor")                                            \
    PART(net_spacing, mesh.net_spacing, NET_SPACING, "net_spacing")                                                    \
    PART(size_eps, mesh.sizes.eps, SIZE_EPS, "sizes.eps")                                                              \
    PART(size_at_inputs, mesh.sizes.at_inputs, SIZE_AT_INPUTS, "sizes.at_inputs")                                      \
    PART(size_growth, mesh.sizes.growth, SIZE_GROWTH, "sizes.growth")                                                  \
    PART(size, mesh.sizes.size, SIZES, "sizes")                                                                        \
    PART(finish, mesh.finish, FINISH, "finish")                                                                        \
    PART(whole_cells, mesh.whole_cells, WHOLE_CELLS, "whole_cells")                                                    \
    PART(audit, mesh.audit, AUDIT, "audit")                                                                            \
    PART(function, function, FUNCTION, "function")                                                                     \
    PART(k, k, K, "k")                                                                                                 \
    PART(k_last, k_last, K_LAST, "k_last")                                                                             \
    PART(threshold, threshold, THRESHOLD, "threshold")                                                                 \
    PART(cycles, cycles, CYCLES, "cycles")                                                                             \
    PART(vines, vines, VINES, "vines")                                                                                 \
    PART(fit, fit, FIT, "fit")                                                                                         \
    PART(keep_mesh, keep_mesh, KEEP_MESH, "keep_mesh")                                                                 \
    PART(weighting, weighting, WEIGHTING, "weighting")                                                                 \
    PART(squares, squares, SQUARES, "squares")                                                                         \
    PART(periods, periods, PERIODS, "periods")                                                                         \
    PART(seed, seed, SEED, "seed")

namespace netmesh {
namespace given {

#define NETMESH_PLACE(name, member, field, text) name##_place,
enum Place : unsigned { NETMESH_EACH_GIVEN(NETMESH_PLACE) };
#undef NETMESH_PLACE
#define NETMESH_BIT(name, member, field, text) constexpr std::uint32_t name = std::uint32_t{1} << name##_place;
NETMESH_EACH_GIVEN(NETMESH_BIT)
#undef NETMESH_BIT

constexpr std::uint32_t of_mesh = function - 1,  // goals and rules
    of_diagram = ~of_mesh,                       // all else
    focus = focus_ratio | focus_from | focus_to, sizes = size_eps | size_at_inputs | size_growth | size;

}  // namespace given

class Settling;  // api/settling.hpp
struct Complaint;

}  // namespace netmesh

// run: the diagram of the context's request, which is settled. settle: what the filter alone knows of a request. What
// it takes is in api/plan.cpp: a program that does not plan has none of it.
struct netmesh_filter {
    netmesh_filter_id id;
    std::uint32_t reads;  // a union of netmesh::given
    netmesh_status (*run)(netmesh_context* context);
    netmesh::Complaint (*settle)(const netmesh::Settling& settling);
    const netmesh::MeshFilter* on_mesh;       // null: not one on meshes
    const netmesh_method *by_tau, *by_ratio;  // what its meshes are made by; by_ratio null: not by a ratio
    bool is_small = false;                    // of the two filters with its id the one that links less
};

// mesh: that of the context's request, in place of what the context held; null: left out of this build.
struct netmesh_method {
    netmesh_method_id id;
    netmesh::MeshMethod method;
    netmesh::CageKind cages;
    std::uint32_t reads;
    netmesh_status (*mesh)(netmesh_context* context);
    netmesh::Complaint (*settle)(const netmesh::Settling& settling);  // without a filter
    bool keeps_few = false;                                           // in short words, see KeptPlane

    bool triangulates() const { return id == NETMESH_METHOD_DELAUNAY; }
    bool has_cages() const { return method == netmesh::MeshMethod::hierarchy; }
    bool certifies() const { return method == netmesh::MeshMethod::certificate; }
};

// run: what is wanted of the context's request; bounds and cycles of the diagram that is there. settle: null where
// nothing has to be known.
struct netmesh_want {
    netmesh::Want what;
    netmesh_status (*run)(netmesh_context* context);
    netmesh::Complaint (*settle)(const netmesh::Settling& settling);
    const netmesh_method* method;  // of fit
};

// What the numbers behind points.weights are. settle: what is said of weights and does not go together. run: the
// diagram of the context's request, which is settled but for where its numbers stand, by the filter alpha; mesh: the
// triangulation alone.
struct netmesh_weighting {
    bool are_radii;
    netmesh::Complaint (*settle)(const netmesh::Settling& settling);
    netmesh_status (*run)(netmesh_context* context);
    netmesh_status (*mesh)(netmesh_context* context);
};

// What points.lattice is. settle, run: the same.
struct netmesh_periods {
    netmesh::Complaint (*settle)(const netmesh::Settling& settling);
    netmesh_status (*run)(netmesh_context* context);
};

namespace netmesh {

// That of a row of the table of filters (filtration/filters.hpp).
const netmesh_filter* filter_object(std::uint32_t index);

// They stand where they are used: functions of equal code would be folded, and the call graph would take one for
// another.
[[gnu::always_inline]] inline netmesh_status dispatch(const netmesh_filter& filter, netmesh_context* context) {
    return filter.run(context);
}
[[gnu::always_inline]] inline netmesh_status dispatch(const netmesh_method& method, netmesh_context* context) {
    return method.mesh(context);
}
[[gnu::always_inline]] inline netmesh_status dispatch(const netmesh_want& want, netmesh_context* context) {
    return want.run(context);
}
[[gnu::always_inline]] inline netmesh_status dispatch(const netmesh_weighting& weighting, netmesh_context* context) {
    return weighting.run(context);
}
[[gnu::always_inline]] inline netmesh_status dispatch_mesh(const netmesh_weighting& weighting,
                                                           netmesh_context* context) {
    return weighting.mesh(context);
}
[[gnu::always_inline]] inline netmesh_status dispatch(const netmesh_periods& periods, netmesh_context* context) {
    return periods.run(context);
}
// Within another want.
[[gnu::always_inline]] inline netmesh_status dispatch_bounds(const netmesh_want& bounds, netmesh_context* context) {
    return bounds.run(context);
}

}  // namespace netmesh
