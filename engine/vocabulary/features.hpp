// What this build of the engine holds: the switches of netmesh_config.h as constants. Code that is left out is not
// called, which drops it from the program; it is compiled all the same.
#pragma once
#include "vocabulary/netmesh_config.h"

namespace netmesh {
namespace built {  // not nested at once: tools/amalgamate reads the line before

constexpr bool certificate = NETMESH_WITH_CERTIFICATE, sizes = NETMESH_WITH_SIZES, audits = NETMESH_WITH_AUDITS;

}  // namespace built
}  // namespace netmesh
