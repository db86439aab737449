#include "api/simplices.hpp"

namespace netmesh {
namespace {

const char* text_of_fault(const SimplexFault& fault) {
    switch (fault.kind) {
    case NETMESH_FAULT_NONE: return "the value of a simplex is not a finite number";
    case NETMESH_FAULT_SIZE: return "a simplex has no vertices or more than 32";
    case NETMESH_FAULT_TOO_MANY: return "more than 2^31 - 1 simplices of one dimension";
    case NETMESH_FAULT_VERTEX_TWICE: return "a simplex has a vertex twice";
    case NETMESH_FAULT_LISTED_TWICE: return "a simplex is listed twice";
    case NETMESH_FAULT_FACE_MISSING: return "a face of a simplex is missing";
    case NETMESH_FAULT_FACE_LATER: return "a face enters later than its simplex";
    }
    return nullptr;
}

}  // namespace

netmesh_status fail_at_simplex(netmesh_context* context, Status status, const SimplexFault& fault, std::uint32_t step) {
    if (status != Status::not_a_complex && status != Status::not_finite) return fail_and_clear(context, status);
    fail_and_clear(context, status, text_of_fault(fault), fault.simplex, fault.other);
    context->detail.said.fault = fault.kind;
    context->detail.said.step = step;
    return static_cast<netmesh_status>(status);
}

}  // namespace netmesh
