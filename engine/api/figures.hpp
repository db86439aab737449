// The one list of the figures of a report and of an analysis: where they stand, what they are called, when they apply.
// Whoever writes them (the tool's JSON) and the fingerprints go by it.
#pragma once
#include <cstdint>

#include "include/netmesh/laboratory.h"
#include "numerics/fingerprint.hpp"

namespace netmesh {

// Of all figures that are marked as part of it.
std::uint64_t fingerprint_of(const netmesh_analysis& analysis);

// Adds the figures of a report that enter its fingerprint before the diagram's pairs, or before the vineyard's points.
enum class FingerprintPart : std::uint8_t { diagram = 1, vineyard = 2 };
void add_figures(Fingerprint* f, const netmesh_report& report, FingerprintPart part);

}  // namespace netmesh
