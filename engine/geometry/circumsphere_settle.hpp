// The stages of circumsphere.hpp that come behind the float stage, one after the other.
#pragma once
#include <cstdint>

#include "geometry/circumsphere.hpp"
#include "memory/arena.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Of one simplex of k+1 points in R^dim, 1 <= k <= dim: sets out->within, out->radius, each where it is asked for.
// Scratch, given back: what ExactSphere takes of these points, a few hundred bytes unless their sizes are far apart.
// ok, out_of_memory; out_of_range: coordinates, see ExactSphere; check_failed: the simplex is flat.
Status settle_circumsphere(const double* const* point, std::uint32_t k, int dim, bool within, bool radius, Arena& arena,
                           Circumsphere* out);

}  // namespace netmesh
