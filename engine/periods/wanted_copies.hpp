// The triangulation of points and of those copies alone that the stars of points want.
#pragma once
#include "delaunay/store.hpp"
#include "periods/periodic_points.hpp"
#include "predicates/weights.hpp"

namespace netmesh {

// Opens the store and triangulates the points and the copies within `near` of their box. Then cells at points are asked
// for other copies in conflict with them, as far as balls are known: of these the nearest to the point is inserted, and
// the cells that it makes are asked in turn. In the end no copy is in conflict with a cell at a point whose ball is
// known; the balls of cells at points may reach beyond all copies.
//
// The store is compact. origin of a vertex: a point or copy, the points first. Vertices in no cell are hidden. D > 2,
// and as many vectors as dimensions. weights.index: as of the copies. spacing: how far points are apart, about.
// flat, out_of_memory, cancelled; the store and what it stands on are left.
template <int D>
Status triangulate_wanted(Store<D>& store, const PeriodicPoints& points, const Copies& copies, double near,
                          double spacing, const Weights& weights, bool has_weights, std::uint64_t seed,
                          const Work& work);

}  // namespace netmesh
