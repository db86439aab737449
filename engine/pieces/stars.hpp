// The Delaunay triangulation about some of the points: every cell at one of them is a cell of the triangulation of all.
#pragma once
#include <cstdint>

#include "delaunay/store.hpp"
#include "memory/work.hpp"
#include "pieces/source.hpp"

namespace netmesh {

struct StarsReport {
    std::uint32_t own, halo;        // points of the node, and others that were inserted
    std::uint64_t queries, visits;  // cells that others were asked for a conflict with; boxes that were looked at
};

// Triangulates the points of `node` and as many others as it takes. The first `report->own` vertices are those of the
// node, in the order of the tree; Vertex::origin is a row, Vertex::next a position in the order of the tree. Vertices
// are at the arena's high end, compact cells at its low end; without ok both are the caller's to give back.
//
// Why it is right: a cell at a vertex is one of the triangulation of all points exactly if no point is in conflict with
// it, ties broken by rows, since that triangulation is the only one without conflicts. Every cell at the points of the
// node is asked for, those at infinity too: for each of these the triangulation ends there for all points.
//
// ok, flat (all points are), out_of_memory, cancelled, not_finite, and what the source's functions say.
template <int D>
Status certified_stars(Store<D>& store, const PointSource& source, PieceNode node, const Work& work,
                       StarsReport* report);

}  // namespace netmesh
