// Filters on meshes: of points by way of a mesh, of the mesh that the context holds.
#include "api/measure.hpp"
#include "api/plan.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "jobs/diagram_of_mesh.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

void keep_mesh_diagram(netmesh_context* context, const PersistRequest& request, netmesh_values values,
                       const FilterDiagram& diagram) {
    const Arena& arena = context->arena;
    KeptDiagram& kept = context->diagram;
    kept.present = true;
    kept.keeps_zero = request.diagram.keep_zero;
    kept.filter = request.filter.filter;
    kept.values = values;
    kept.max_degree = request.diagram.max_degree;
    kept.k = request.filter.k;
    kept.pairs = Slice<Pair>::of(arena, diagram.pairs.pairs, diagram.pairs.count);
    kept.is_short = true;
    kept.vertex_values = Slice<double>::of(arena, diagram.value, context->mesh.store.vertex_count);
    kept.simplices = diagram.simplices;
    kept.certified_ratio = diagram.certificate.ratio;
    kept.certified_ratio_best = diagram.certificate.ratio_best;
    kept.certified_from = diagram.certificate.from;
    kept.certified_error = diagram.certificate.error;
    if (diagram.clip_radius > 0) context->mesh.radius = diagram.clip_radius;
}

netmesh_status run_on_mesh(netmesh_context* context) {
    const netmesh_request& r = context->request;
    if (source_of(r) != Source::points) return filter_mesh(context);
    const netmesh_status status = dispatch(*r.mesh.method, context);
    return status == NETMESH_OK ? filter_mesh(context) : status;
}

}  // namespace

netmesh_status filter_mesh(netmesh_context* context) {
    const netmesh_request& r = context->request;
    const char* const missing = missing_mesh(context);
    if (missing != nullptr) return finish(context, Status::no_result, missing);
    netmesh_function function = {};
    if (r.filter->id == NETMESH_FILTER_FUNCTION) {
        const Complaint complaint = read_function(r.function, &function);
        if (complaint.text != nullptr) return refuse(context, complaint);
    }
    if (r.k > context->input.distinct)
        return refuse(context, NETMESH_FIELD_K, "k is more than the number of different points");
    const PersistRequest wanted = {{r.filter->id, r.filter->on_mesh, values_of(r.values), r.k, &function},
                                   {degree_of(r.max_degree, context->input.dim), r.keep_zero_pairs != 0}};
    clear_diagram(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    FilterDiagram diagram;
    const Status found = diagram_of_mesh(filtered_mesh_of(*context), wanted, {context->arena, monitor}, &diagram);
    const Status status = watch.heed(found);
    if (status == Status::ok) {
        keep_mesh_diagram(context, wanted, r.values, diagram);
        return finish(context, status);
    }
    clear_diagram(context);
    if (status == Status::not_finite)
        return finish(context, status, "the function is not finite at a vertex", diagram.culprit);
    return finish(context, status);
}

}  // namespace netmesh

using namespace netmesh;

// Each with its number, what it reads, and what its meshes are made by for a ratio; null: not for one.
#define NETMESH_EACH_ON_MESH(FILTER)                                                                                   \
    FILTER(complete, COMPLETE, of_any | given::fit, by_certificate)                                                    \
    FILTER(basic, BASIC, of_any | given::fit, nullptr)                                                                 \
    FILTER(knn, KNN, of_any | of_neighbours | given::fit, nullptr)                                                     \
    FILTER(kdistance, KDISTANCE, of_any | of_neighbours | given::fit, nullptr)                                         \
    FILTER(function, FUNCTION, of_any | given::function | given::error | given::fit, nullptr)                          \
    FILTER(tight, TIGHT, of_any | given::eps | given::fit, by_certificate)

namespace netmesh {

// How each is evaluated: filtration/filters.cpp.
#define NETMESH_EVALUATED(name, id, reads, by_ratio) extern const MeshFilter name##_on_mesh;
NETMESH_EACH_ON_MESH(NETMESH_EVALUATED)
#undef NETMESH_EVALUATED

namespace {

constexpr std::uint32_t of_any = (given::of_mesh & ~(given::eps | given::theta | given::error)) | given::cycles |
                                 given::keep_mesh | given::seed,
                        of_neighbours = given::k | given::k_last | given::vines;
// Without the certificate a filter has the meshes that its tau makes.
#if NETMESH_WITH_CERTIFICATE
constexpr const netmesh_method* by_certificate = &netmesh_method_certificate;
#else
constexpr const netmesh_method* by_certificate = nullptr;
#endif

}  // namespace
}  // namespace netmesh

#define NETMESH_ON_MESH(name, id, reads, by_ratio)                                                                     \
    extern const netmesh_filter netmesh_filter_##name;                                                                 \
    const netmesh_filter netmesh_filter_##name = {                                                                     \
        NETMESH_FILTER_##id, reads, run_on_mesh, settle_on_mesh, &name##_on_mesh, &netmesh_method_svr, by_ratio};
extern "C" {
NETMESH_EACH_ON_MESH(NETMESH_ON_MESH)
}
#undef NETMESH_ON_MESH
#undef NETMESH_EACH_ON_MESH
