#include "vocabulary/dimension.hpp"
#include "api/context.hpp"

#include "api/dispatch.hpp"
#include "numerics/fingerprint.hpp"

namespace netmesh {
namespace {

// Is the floating-point mode the one that all bounds and fingerprints rest on? Catches at run time what the preprocessor
// cannot: flush-to-zero or another rounding mode set for the whole process, double rounding, contraction.
bool floating_point_as_expected() {
    volatile double one = 1, tiny = 0x1p-1060, half_ulp = 0x1p-53, third = 3, big = 0x1p27 + 1;
    if (tiny * 0.5 == 0 || tiny + tiny != 0x1p-1059) return false;
    if (one + half_ulp != 1 || (one + 0x1p-52) + half_ulp != 1 + 0x1p-51 || -one - half_ulp != -1) return false;
    if (one + (half_ulp + 0x1p-80) != 1 + 0x1p-52) return false;
    const double product = big * big;
    if (big * big - product != 0) return false;
    return square_root(one + one) == 0x1.6A09E667F3BCDp0 && one / third == 0x1.5555555555555p-2;
}

constexpr std::uint64_t block_minimum = sizeof(netmesh_context) + 4 * Arena::alignment;

}  // namespace

bool usable(netmesh_context* context) {
    if (context == nullptr || context->magic != context_magic) return false;
    context->arena.rebase(context);
    return true;
}

bool usable(const netmesh_options* options) {
    return options != nullptr && options->struct_bytes == sizeof(netmesh_options) && serves_dimension(options->dim);
}

double tau_of(const netmesh_options& options) {
    if (options.tau != 0) return options.tau;
    return with_dimension(options.dim, [](auto d) { return figures<decltype(d)::value>.tau_default; });
}

double theta_of(const netmesh_options& options) { return options.theta != 0 ? options.theta : 1.0 / 9; }

double eps_of(const netmesh_options& options) { return options.eps != 0 ? options.eps : 0.5; }

void clear_diagram(netmesh_context* context) {
    context->has_values = context->has_diagram = context->has_vineyard = context->has_bounds = false;
    context->pair_count = context->simplices = 0;
    context->certified_ratio = context->certified_ratio_best = context->certified_from = 0;
    context->filter = NETMESH_FILTER_NONE;
    context->scales = 0;
    if (context->dim != 0) context->arena.release_low(context->mesh_mark);
    if (context->dim != 0 && context->has_cycles) context->arena.release_high(context->cycles_high);
    context->has_cycles = false;
}

void clear(netmesh_context* context) {
    clear_diagram(context);
    context->dim = 0;
    context->is_mesh = context->complete = context->is_complex = context->has_cycles = context->is_loaded = false;
    context->method = NETMESH_METHOD_SVR;
    context->cages_offset = 0;
    context->hierarchy = HierarchyCounts{};
    context->mesh_audit = MeshAudit{};
    context->arena.adopt(context, context->arena.bytes());
    context->arena.release_low(context->start);
}

}  // namespace netmesh

using namespace netmesh;

extern "C" {

const char* netmesh_status_text(netmesh_status status) {
    switch (status) {
    case NETMESH_OK: return "done";
    case NETMESH_INVALID_ARGUMENT: return "invalid argument";
    case NETMESH_OUT_OF_MEMORY: return "the block of memory is too small";
    case NETMESH_CANCELLED: return "cancelled";
    case NETMESH_NOT_FINITE: return "a coordinate is not a finite number";
    case NETMESH_OUT_OF_RANGE: return "a coordinate or a distance is outside the range that meshing admits";
    case NETMESH_FLAT: return "the points lie in a hyperplane";
    case NETMESH_TOO_CLOSE: return "two points are closer than their coordinates resolve";
    case NETMESH_NO_RESULT: return "an earlier step is missing";
    case NETMESH_CHECK_FAILED: return "a check failed";
    case NETMESH_FLOATING_POINT: return "the floating-point mode is not IEEE double precision, rounding to nearest";
    case NETMESH_NOT_A_COMPLEX: return "the simplices are not a filtered complex";
    case NETMESH_INTERNAL: return "an invariant of the library does not hold";
    }
    return "unknown status";
}

void netmesh_options_init(netmesh_options* options, uint32_t dim) {
    *options = netmesh_options{};
    options->struct_bytes = sizeof(netmesh_options);
    options->dim = dim < NETMESH_DIM_MIN ? NETMESH_DIM_MIN : dim > NETMESH_DIM_MAX ? NETMESH_DIM_MAX : dim;
    options->seed = 1;
}

double netmesh_tau(const netmesh_options* options) { return usable(options) ? tau_of(*options) : 0; }

netmesh_status netmesh_init(void* block, size_t block_bytes, netmesh_context** context) {
    if (context == nullptr || block == nullptr || reinterpret_cast<std::uintptr_t>(block) % Arena::alignment != 0)
        return NETMESH_INVALID_ARGUMENT;
    *context = nullptr;
    if (block_bytes < block_minimum) return NETMESH_OUT_OF_MEMORY;
    if (!floating_point_as_expected()) return NETMESH_FLOATING_POINT;
    netmesh_context* const made = static_cast<netmesh_context*>(block);
    __builtin_memset(made, 0, sizeof *made);
    made->magic = context_magic;
    made->block_bytes = block_bytes;
    made->arena.adopt(block, block_bytes);
    made->start = (sizeof *made + Arena::alignment - 1) & ~(Arena::alignment - 1);
    made->arena.release_low(made->start);
    finish(made, Status::ok, "");
    *context = made;
    return NETMESH_OK;
}

netmesh_status netmesh_adopt(void* block, netmesh_context** context) {
    if (context == nullptr || block == nullptr || reinterpret_cast<std::uintptr_t>(block) % Arena::alignment != 0)
        return NETMESH_INVALID_ARGUMENT;
    *context = static_cast<netmesh_context*>(block);
    if (usable(*context)) return NETMESH_OK;
    *context = nullptr;
    return NETMESH_INVALID_ARGUMENT;
}

netmesh_detail netmesh_get_detail(const netmesh_context* context) {
    return context != nullptr && context->magic == context_magic ? context->detail : netmesh_detail{};
}

}  // extern "C"
