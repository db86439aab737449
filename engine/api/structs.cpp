#include "api/structs.hpp"

namespace netmesh {
namespace {

// More than any version's struct has: a size that was never set is told from one that was.
constexpr std::uint32_t bytes_max = 1u << 16;

std::uint32_t struct_bytes_of(const void* caller) {
    std::uint32_t bytes;
    __builtin_memcpy(&bytes, caller, sizeof bytes);
    return bytes < sizeof bytes || bytes > bytes_max ? 0 : bytes;
}

}  // namespace

netmesh_field read_struct(const void* from, void* to, std::size_t to_bytes) {
    if (from == nullptr) return NETMESH_FIELD_REQUEST;
    const std::size_t bytes = struct_bytes_of(from);
    if (bytes == 0) return NETMESH_FIELD_STRUCT_BYTES;
    const auto* const caller = static_cast<const unsigned char*>(from);
    for (std::size_t i = to_bytes; i < bytes; ++i)
        if (caller[i] != 0) return NETMESH_FIELD_STRUCT_BYTES;
    __builtin_memset(to, 0, to_bytes);
    __builtin_memcpy(to, from, bytes < to_bytes ? bytes : to_bytes);
    return NETMESH_FIELD_NONE;
}

bool has_room(const void* to) { return to != nullptr && struct_bytes_of(to) != 0; }

void write_struct(const void* from, std::size_t from_bytes, void* to) {
    start_struct(from, from_bytes, to, struct_bytes_of(to));
}

void start_struct(const void* from, std::size_t from_bytes, void* to, std::size_t to_bytes) {
    const std::uint32_t bytes = static_cast<std::uint32_t>(to_bytes);
    __builtin_memset(to, 0, to_bytes);
    __builtin_memcpy(to, from, from_bytes < to_bytes ? from_bytes : to_bytes);
    __builtin_memcpy(to, &bytes, sizeof bytes < to_bytes ? sizeof bytes : to_bytes);
}

}  // namespace netmesh
