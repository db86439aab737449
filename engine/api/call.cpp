#include "api/call.hpp"

namespace netmesh {
namespace {

// Messages are static texts of this library, and so is this one: their distances do not depend on where it is loaded.
// A distance of 0 stands for the status's own text, which is not linked before someone asks for it.
constexpr char text_origin[] = "texts";

// A detail without its message.
netmesh_detail facts_of(Status status, std::uint64_t a, std::uint64_t b) {
    netmesh_detail detail = {};
    detail.struct_bytes = sizeof detail;
    detail.status = static_cast<netmesh_status>(status);
    detail.index_a = a;
    detail.index_b = b;
    return detail;
}

// text null: the status's own.
const char* message_of(netmesh_status status, const char* text) {
    return status == NETMESH_OK ? "" : text != nullptr ? text : netmesh_status_text(status);
}

void keep_said(netmesh_context* context, const netmesh_detail& detail, const char* text) {
    context->detail.said = detail;
    context->detail.message_from = kept_text(text);
}

}  // namespace

std::int64_t kept_text(const char* text) {
    if (text == nullptr) return 0;
    return static_cast<std::intptr_t>(reinterpret_cast<std::uintptr_t>(text) -
                                      reinterpret_cast<std::uintptr_t>(text_origin));
}

const char* text_kept(std::int64_t from) {
    if (from == 0) return nullptr;
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(text_origin) + static_cast<std::uintptr_t>(from);
    return reinterpret_cast<const char*>(address);  // NOLINT(performance-no-int-to-ptr)
}

bool usable(netmesh_context* context) {
    if (context == nullptr || context->magic != context_magic) return false;
    context->arena.rebase(context);
    return true;
}

bool usable(const netmesh_context* context) { return context != nullptr && context->magic == context_magic; }

netmesh_detail detail_of(Status status, const char* text, std::uint64_t a, std::uint64_t b) {
    netmesh_detail detail = facts_of(status, a, b);
    detail.message = message_of(detail.status, text);
    return detail;
}

netmesh_detail kept_detail(const netmesh_context* context) {
    netmesh_detail detail = context->detail.said;
    detail.message = message_of(detail.status, text_kept(context->detail.message_from));
    return detail;
}

netmesh_status finish(netmesh_context* context, Status status, const char* text, std::uint64_t a, std::uint64_t b) {
    if (status == Status::internal && context->mesh.is_loaded) {
        // What was loaded passed as a ball by its facets and its hull alone.
        status = Status::check_failed;
        text = "the cells that were loaded are not a triangulated ball";
    }
    netmesh_detail detail = facts_of(status, a, b);
    if (status == Status::out_of_memory) {
        // Lists that fill their share of the block ask for nothing: more than the block it is all the same.
        const std::uint64_t wanted = context->arena.bytes_wanted() + (context->block_bytes - context->arena.bytes());
        const std::uint64_t least = context->block_bytes + Arena::alignment;
        // What a block has beyond a multiple of the alignment is not used.
        detail.bytes_wanted = (wanted > least ? wanted : least) & ~std::uint64_t{Arena::alignment - 1};
    }
    keep_said(context, detail, text);
    return detail.status;
}

netmesh_status fail_and_clear(netmesh_context* context, Status status, const char* text, std::uint64_t a,
                              std::uint64_t b) {
    const netmesh_status result = finish(context, status, text, a, b);
    clear(context);
    return result;
}

netmesh_status refuse(netmesh_context* context, const Complaint& complaint, std::uint64_t row) {
    const Status status = complaint.not_built ? Status::not_built : Status::invalid_argument;
    netmesh_detail detail = facts_of(status, row, 0);
    detail.field = complaint.field;
    keep_said(context, detail, complaint.text);
    return detail.status;
}

Complaint complaint_about_struct(netmesh_field fault) {
    if (fault == NETMESH_FIELD_REQUEST) return {fault, "the request is null"};
    return {fault, "struct_bytes is not set, or a field is set that this version does not know"};
}

void clear_diagram(netmesh_context* context) {
    if (context->mesh.present) context->arena.release_low(context->mesh.low_end);
    if (context->mesh.present && context->cycles.present) context->arena.release_high(context->cycles.high_end);
    context->diagram = {};
    context->bounds = {};
    context->vineyard = {};
    context->cycles = {};
}

void clear(netmesh_context* context) {
    clear_diagram(context);
    context->complete = false;
    context->input = {};
    context->mesh = {};
    context->plane = {};
    context->scales = {};
    context->split = {};
    context->piece = {};
    context->arena.adopt(context, context->arena.bytes());
    context->arena.release_low(context->start);
}

}  // namespace netmesh
