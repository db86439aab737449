// Structs of the interface, whose sizes the caller's compiler and this library may see differently: struct_bytes, the
// first of their members, says what the caller's is. This is the one place where they are copied in and out.
#pragma once
#include <cstddef>
#include <cstdint>

#include "include/netmesh.h"

namespace netmesh {

// Copies the caller's struct to `to`, which has the size that this library knows; what the caller's does not have is 0.
// NETMESH_FIELD_NONE, or what is at fault: REQUEST (null) or STRUCT_BYTES (not set, or a member that this library does
// not know is not 0).
netmesh_field read_struct(const void* from, void* to, std::size_t to_bytes);

// Can results be written to the caller's struct: not null, its size set?
bool has_room(const void* to);
// Writes a result of this library's to the caller's struct, as far as that goes. What the caller's has beyond it
// becomes 0, struct_bytes stays. Requires has_room(to).
void write_struct(const void* from, std::size_t from_bytes, void* to);
// The same for a struct of to_bytes whose struct_bytes are not set yet.
void start_struct(const void* from, std::size_t from_bytes, void* to, std::size_t to_bytes);

template <class Struct> bool give_result(const Struct& from, Struct* to) {
    if (!has_room(to)) return false;
    write_struct(&from, sizeof from, to);
    return true;
}

}  // namespace netmesh
