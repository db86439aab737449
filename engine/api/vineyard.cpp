// Vineyards of the mesh that the context holds.
#include "api/measure.hpp"
#include "api/requests.hpp"
#include "jobs/k_vineyard.hpp"

namespace netmesh {
namespace {

Complaint complaint_about(const netmesh_vineyard_request& request) {
    const Filter* const filter = find_filter(request.filter);
    if (filter == nullptr || !filter->has(filter_trait::has_vineyard))
        return {NETMESH_FIELD_FILTER, "the filter has no k on a mesh"};
    if (request.k_first < 1) return {NETMESH_FIELD_K_FIRST, "k begins at 1"};
    if (request.k_last < request.k_first) return {NETMESH_FIELD_K_LAST, "the last k is below the first"};
    return complaint_about_values(request.values);
}

void keep_vineyard(netmesh_context* context, const netmesh_vineyard_request& request, const VineList& vines) {
    const Arena& arena = context->arena;
    KeptVineyard& kept = context->vineyard;
    const std::uint32_t count = request.k_last - request.k_first + 1;
    kept.present = true;
    kept.filter = request.filter;
    kept.values = request.values;
    kept.max_degree = degree_of(request.max_degree, context->input.dim);
    kept.k_first = request.k_first;
    kept.k_last = request.k_last;
    kept.vines = vines.vine_count;
    kept.ratios = Slice<double>::of(arena, vines.ratio, count);
    kept.points = Slice<VinePoint>::of(arena, vines.points, vines.count);
    kept.simplices = vines.simplices;
    kept.transpositions = vines.transpositions;
    kept.certified_ratio = 1;
    for (std::uint32_t i = 0; i < count; ++i)
        if (!(vines.ratio[i] <= kept.certified_ratio)) kept.certified_ratio = vines.ratio[i];
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_vineyard(netmesh_context* context, const netmesh_vineyard_request* from) {
    netmesh_vineyard_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    const char* const missing = missing_result(context, *find_filter(request.filter));
    if (missing != nullptr) return finish(context, Status::no_result, missing);
    if (request.k_last > context->input.distinct)
        return refuse(context, NETMESH_FIELD_K_LAST, "k is more than the number of different points");
    clear_diagram(context);
    Monitor monitor = monitor_of(request.monitor);
    VineList vines = {};
    const VineRequest wanted = {request.filter, request.k_first, request.k_last, values_of(request.values),
                                degree_of(request.max_degree, context->input.dim)};
    const Status status = with_dimension(context->input.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, context->mesh.store);
        return k_vineyard<D>(filtered_mesh_of<D>(*context, store), wanted, {context->arena, monitor}, &vines);
    });
    status == Status::ok ? keep_vineyard(context, request, vines) : clear_diagram(context);
    return finish(context, status);
}
