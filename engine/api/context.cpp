#include "api/context.hpp"

#include "api/call.hpp"
#include "numerics/real.hpp"

namespace netmesh {
namespace {

// Is the floating-point mode the one that all bounds and fingerprints rest on? Catches at run time what the
// preprocessor cannot: flush-to-zero or another rounding mode set for the whole process, double rounding, contraction.
// A template, for options that a source sets itself may be lost in those.
template <class Real> bool floating_point_as_expected() {
    volatile Real one = 1, tiny = 0x1p-1060, half_ulp = 0x1p-53, third = 3, big = 0x1p27 + 1;
    if (tiny * 0.5 == 0 || tiny + tiny != 0x1p-1059) return false;
    if (one + half_ulp != 1 || (one + 0x1p-52) + half_ulp != 1 + 0x1p-51 || -one - half_ulp != -1) return false;
    if (one + (half_ulp + 0x1p-80) != 1 + 0x1p-52) return false;
    const Real product = big * big;
    if (big * big - product != 0) return false;
    return square_root(one + one) == 0x1.6A09E667F3BCDp0 && one / third == 0x1.5555555555555p-2;
}

constexpr std::uint64_t block_minimum = sizeof(netmesh_context) + 4 * Arena::alignment;

bool is_aligned(const void* block) { return reinterpret_cast<std::uintptr_t>(block) % Arena::alignment == 0; }

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_init(void* block, size_t block_bytes, netmesh_context** context) {
    if (context == nullptr || block == nullptr || !is_aligned(block)) return NETMESH_INVALID_ARGUMENT;
    *context = nullptr;
    if (block_bytes < block_minimum) return NETMESH_OUT_OF_MEMORY;
    if (!floating_point_as_expected<double>()) return NETMESH_FLOATING_POINT;
    __builtin_memset(block, 0, sizeof(netmesh_context));  // what all members of an empty context are
    netmesh_context* const made = static_cast<netmesh_context*>(block);
    made->magic = context_magic;
    made->block_bytes = block_bytes;
    made->arena.adopt(block, block_bytes);
    made->start = (sizeof *made + Arena::alignment - 1) & ~(Arena::alignment - 1);
    clear(made);
    finish(made, Status::ok);
    *context = made;
    return NETMESH_OK;
}

netmesh_status netmesh_adopt(void* block, netmesh_context** context) {
    if (context == nullptr || block == nullptr || !is_aligned(block)) return NETMESH_INVALID_ARGUMENT;
    *context = static_cast<netmesh_context*>(block);
    if (usable(*context)) return NETMESH_OK;
    *context = nullptr;
    return NETMESH_INVALID_ARGUMENT;
}

netmesh_status netmesh_get_detail(const netmesh_context* context, netmesh_detail* detail) {
    const bool known = usable(context);
    const bool given = give_result(known ? kept_detail(context) : detail_of(Status::ok, nullptr), detail);
    return known && given ? NETMESH_OK : NETMESH_INVALID_ARGUMENT;
}

}  // extern "C"
