// The request of a call, read and settled. It stands in the context while the call runs, so that no stack holds it.
#pragma once
#include "api/settle.hpp"
#include "delaunay/triangulate.hpp"
#include "homology/persistence.hpp"
#include "mesh/check/check_domain.hpp"

namespace netmesh {

class TakenRequest {
public:
    // Refused: what the context holds stays.
    TakenRequest(netmesh_context* context, const netmesh_request* from, Call call)
        : context_(context), status_(take(context, from, call)) {}
    ~TakenRequest() {
        if (status_ == NETMESH_OK) __builtin_memset(&context_->request, 0, sizeof context_->request);
    }
    TakenRequest(const TakenRequest&) = delete;
    TakenRequest& operator=(const TakenRequest&) = delete;

    netmesh_status status() const { return status_; }

private:
    [[gnu::noinline]] static netmesh_status take(netmesh_context* context, const netmesh_request* from, Call call);

    netmesh_context* const context_;
    const netmesh_status status_;
};

// What a mesh that is there has to keep: the goal and the rules of a request, or without one the dimension's tau.
struct Promises {
    double tau = 0;
    SizeRule sizes = {};
    RatioGoal goal = {};  // ratio 0: none
    NetPromise net = {};
    CageKind cages = CageKind::compact;
};
// `sizes` has to live as long as the promises.
[[gnu::noinline]] Complaint read_promises(netmesh_context* context, const netmesh_request* promised, std::uint32_t dim,
                                          Promises* promises, ErrorSizes* sizes);

// Is a diagram there that is the request's own?
bool has_diagram_of(const netmesh_context* context);

// Without a source: why the context holds no cells, or none that a filter on meshes is evaluated on; null when it does.
const char* missing_cells(const netmesh_context* context);
const char* missing_mesh(const netmesh_context* context);

// Of a request with weights.
WeightRows weights_of(const netmesh_request& request);
// Whether values are out of range because the context's request wants squares and that of a radius is beyond the
// largest double. The radius is named then, and the call refused; what the context holds stays. O(points).
bool refuses_square(netmesh_context* context, Status status);

// A triangulation of the request's points in place of what the context held. `allowance` may be null; when it is spent
// the status is NETMESH_CANCELLED, and what the context holds has to be cleared.
netmesh_status triangulate_points(netmesh_context* context, Allowance* allowance);

// Ends a call that has triangulated the request's points, or what of them the status says; with weights so many are
// hidden.
netmesh_status finish_triangulation(netmesh_context* context, const InputReport& input, std::uint32_t hidden,
                                    Status status);

// What is kept of a diagram by the filter alpha.
inline void keep_alpha(netmesh_context* context, const DiagramRequest& wanted, const CountedPairs& found) {
    KeptDiagram& diagram = context->diagram;
    diagram.present = true;
    diagram.filter = NETMESH_FILTER_ALPHA;
    diagram.keeps_zero = wanted.keep_zero;
    diagram.max_degree = wanted.max_degree;
    diagram.pairs = Slice<Pair>::of(context->arena, found.pairs.pairs, found.pairs.count);
    diagram.simplices = found.simplices;
    diagram.certified_ratio = diagram.certified_ratio_best = 1;
}

// The diagrams of the context's request on the triangulation or mesh that the context holds, in place of another one.
netmesh_status filter_triangulation(netmesh_context* context);
netmesh_status filter_mesh(netmesh_context* context);

// What is kept of a request's points; made: PointsDiagram or PointsVineyard.
template <class Made> KeptInput input_of(const netmesh_points& points, const Made& made) {
    const std::uint64_t duplicates = points.count - made.distinct;
    return {true, true, points.dim, points.count, duplicates, made.input_fingerprint, made.distinct};
}

// Ends a call without OK: the context is empty. The job has said invalid_argument where field k is too large.
template <class Made>
netmesh_status fail_at_points(netmesh_context* context, Status status, netmesh_field k, const Made& made) {
    if (status != Status::invalid_argument)
        return fail_and_clear(context, status, nullptr, status == Status::not_finite ? made.culprit : 0);
    clear(context);
    return refuse(context, k, "k is more than the number of different points");
}

}  // namespace netmesh
