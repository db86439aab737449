// Complexes that are given by their simplices.
#include "api/simplices.hpp"

#include "api/keep_complex.hpp"
#include "api/plan.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "jobs/diagram_of_simplices.hpp"
#include "jobs/value_vineyard.hpp"

namespace netmesh {
namespace {

// By netmesh_fault. Rows, not a table of pointers: on Arm that would hold the texts of all other tables, too.
constexpr char fault_texts[][46] = {"the value of a simplex is not a finite number",
                                    "a simplex has no vertices or more than 32",
                                    "more than 2^31 - 1 simplices of one dimension",
                                    "a simplex has a vertex twice",
                                    "a simplex is listed twice",
                                    "a face of a simplex is missing",
                                    "a face enters later than its simplex"};
static_assert(sizeof fault_texts / sizeof fault_texts[0] == NETMESH_FAULT_FACE_LATER + 1);

Complaint settle_simplices(const Settling& s) {
    if (s.r.max_degree > NETMESH_DEGREE_MAX) s.r.max_degree = NETMESH_DEGREE_MAX;
    if (s.source == Source::context) return fine();  // more of the diagram that is there
    netmesh_simplices given;
    const bool is_read = read_struct(s.r.simplices, &given, sizeof given) == NETMESH_FIELD_NONE;
    if (is_read && given.step_count != 0 && s.r.vines == nullptr)
        return {NETMESH_FIELD_STEP_COUNT, "steps are for vines; set them"};
    if (is_read && given.by_vertex != 0 && given.step_count == 0)
        return {NETMESH_FIELD_STEP_COUNT, "by_vertex is of steps; there are none"};
    return is_read && given.step_count == 0 && s.r.vines != nullptr
               ? Complaint{NETMESH_FIELD_STEP_COUNT, "there are no steps"}
               : fine();
}

netmesh_status run_simplices(netmesh_context* context) {
    const netmesh_request& r = context->request;
    if (source_of(r) == Source::context)
        return finish(context, Status::no_result, "there is no such diagram of simplices; give them once more");
    netmesh_simplices given;
    const Complaint complaint = read_simplices(r, &given);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    const SimplexList list = {given.vertices, given.starts, given.entries, given.simplex_count};
    const ComplexRequest wanted = {{r.max_degree, r.keep_zero_pairs != 0}, r.cycles != nullptr};
    SimplicesDiagram made;
    const Status status = watch.heed(diagram_of_simplices(list, wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_at_simplex(context, status, made.listed.fault);
    KeptDiagram diagram;
    diagram.max_degree = made.max_degree;
    diagram.certified_ratio = diagram.certified_ratio_best = 1;
    const KeptInput input = {true, true, 0, 0, 0, made.listed.input_fingerprint, made.listed.complex.count[0]};
    keep_diagram(context, input, diagram, made.diagram, wanted.representatives ? &made.listed.complex : nullptr);
    return finish(context, status);
}

}  // namespace

double plan_of_simplices(const netmesh_request& r) {
    netmesh_simplices given;
    if (read_struct(r.simplices, &given, sizeof given) != NETMESH_FIELD_NONE) return 0;
    if (given.simplex_count == 0 || given.vertex_count < given.simplex_count) return 0;
    if (given.vertex_count > UINT64_MAX / 128 || given.step_count >= none) return 0;
    const double bytes = given.step_count > 0
                             ? value_vineyard_bytes(given.simplex_count, given.vertex_count, given.step_count)
                             : simplices_bytes(given.simplex_count, given.vertex_count);
    return bytes + complex_overhead;
}

Complaint read_simplices(const netmesh_request& request, netmesh_simplices* s) {
    const netmesh_field fault = read_struct(request.simplices, s, sizeof *s);
    if (fault != NETMESH_FIELD_NONE) return complaint_about_struct(fault);
    if (s->vertices == nullptr) return {NETMESH_FIELD_VERTICES, "vertices is null"};
    if (s->starts == nullptr) return {NETMESH_FIELD_STARTS, "starts is null"};
    if (s->entries == nullptr) return {NETMESH_FIELD_ENTRIES, "entries is null"};
    if (s->simplex_count == 0) return {NETMESH_FIELD_SIMPLEX_COUNT, "there are no simplices"};
    if (s->vertex_count != 0 && s->starts[s->simplex_count] > s->vertex_count)
        return {NETMESH_FIELD_VERTEX_COUNT, "starts leads beyond the last vertex"};
    if (s->step_count >= none) return {NETMESH_FIELD_STEP_COUNT, "more than 2^32 - 2 steps"};
    return {};
}

netmesh_status fail_at_simplex(netmesh_context* context, Status status, const SimplexFault& fault, std::uint32_t step) {
    if (status != Status::not_a_complex && status != Status::not_finite) return fail_and_clear(context, status);
    fail_and_clear(context, status, fault_texts[fault.kind], fault.simplex, fault.other);
    context->detail.said.fault = fault.kind;
    context->detail.said.step = step;
    return static_cast<netmesh_status>(status);
}

}  // namespace netmesh

using namespace netmesh;

extern "C" {
extern const netmesh_filter netmesh_filter_simplices;
const netmesh_filter netmesh_filter_simplices = {
    NETMESH_FILTER_NONE, given::cycles | given::vines, run_simplices, settle_simplices, nullptr, nullptr, nullptr};
}
