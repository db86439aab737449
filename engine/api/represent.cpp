// Representatives of the diagram of the triangulation or mesh that the context holds.
#include "jobs/represent.hpp"
#include "api/keep_complex.hpp"
#include "api/measure.hpp"
#include "api/requests.hpp"

namespace netmesh {
namespace {

Status find_cycles(netmesh_context* context, Monitor& monitor, Representation* made) {
    const KeptDiagram& diagram = context->diagram;
    const RepresentRequest request = {{diagram.filter, values_of(diagram.values), diagram.k},
                                      diagram.vertex_values.in(context),
                                      {diagram.max_degree, diagram.keeps_zero},
                                      diagram.bars(context)};
    return represent(filtered_mesh_of(*context), request, {context->arena, monitor}, made);
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_represent(netmesh_context* context, const netmesh_represent_request* from) {
    netmesh_represent_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    if (!context->mesh.present || !context->diagram.present)
        return finish(context, Status::no_result, "there is no diagram of a triangulation or mesh");
    if (context->cycles.present) return finish(context, Status::ok);
    const std::size_t high = context->arena.high_mark();
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    Representation made = {};
    const Status status = watch.heed(find_cycles(context, monitor, &made));
    if (status != Status::ok) return finish(context, status);
    context->diagram.pairs = Slice<Pair>::of(context->arena, made.pairs.pairs, made.pairs.count);
    context->diagram.is_short = false;
    keep_cycles(context, made.cycles, high);
    if (made.is_listed) keep_complex(context, made.complex);
    return finish(context, status);
}
