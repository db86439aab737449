// The one list of the figures of a report and of an analysis: where they stand, what they are called, when they apply.
// Whoever writes them (the tool's JSON) and the fingerprint of an analysis go by it.
#pragma once
#include <cstdint>

#include "include/netmesh.h"

namespace netmesh {

// Of all figures that are marked as part of it.
std::uint64_t fingerprint_of(const netmesh_analysis& analysis);

}  // namespace netmesh
