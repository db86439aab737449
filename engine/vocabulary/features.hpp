// What this build of the engine holds: the switches of netmesh_config.h as constants. Code that is left out is not
// called, which drops it from the program; it is compiled all the same.
#pragma once
#include "vocabulary/netmesh_config.h"

namespace netmesh {
namespace built {  // not nested at once: tools/amalgamate reads the line before

constexpr bool cages = NETMESH_WITH_CAGES, thesis_cages = NETMESH_WITH_THESIS_CAGES, refine = NETMESH_WITH_REFINE,
               certificate = NETMESH_WITH_CERTIFICATE, sizes = NETMESH_WITH_SIZES, audits = NETMESH_WITH_AUDITS;
constexpr bool alpha = NETMESH_WITH_ALPHA, basic = NETMESH_WITH_BASIC, nearest_k = NETMESH_WITH_NEAREST_K,
               function = NETMESH_WITH_FUNCTION, tight = NETMESH_WITH_TIGHT;

}  // namespace built
}  // namespace netmesh
