// The first points that span space.
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"

namespace netmesh {

// The first dim+1 affinely independent points along order[0..count), exactly. False when there are none.
bool independent_points(const AnyStore& store, const std::uint32_t* order, std::uint32_t count, VertexId* ids);

}  // namespace netmesh
