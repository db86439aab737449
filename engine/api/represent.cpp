// Representatives of the diagram of the triangulation or mesh that the context holds.
#include "jobs/represent.hpp"
#include "api/keep_complex.hpp"
#include "api/measure.hpp"
#include "api/request.hpp"

namespace netmesh {
namespace {

Status find_cycles(netmesh_context* context, Monitor& monitor, Representation* made) {
    const KeptDiagram& diagram = context->diagram;
    const RepresentRequest request = {
        {diagram.filter, context->request.filter->on_mesh, values_of(diagram.values), diagram.k},
        diagram.vertex_values.in(context),
        {diagram.max_degree, diagram.keeps_zero},
        diagram.bars(context)};
    return represent(filtered_mesh_of(*context), request, {context->arena, monitor}, made);
}

// Complexes on points, of distances and of simplices have had theirs when they were filtered.
netmesh_status run_cycles(netmesh_context* context) {
    if (context->cycles.present) return finish(context, Status::ok);
    if (!context->mesh.present)
        return finish(context, Status::no_result, "the diagram was made without its cycles; give its points once more");
    if (context->input.weighting != NETMESH_WEIGHTING_NONE) return finish(context, Status::no_result, weighted_cells);
    const std::size_t high = context->arena.high_mark();
    Monitor monitor = monitor_of(context->request.monitor);
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

}  // namespace
}  // namespace netmesh

extern "C" {
extern const netmesh_want netmesh_cycles;
const netmesh_want netmesh_cycles = {netmesh::Want::cycles, netmesh::run_cycles, nullptr, nullptr};
}
