// From points to the diagram of their alpha complex, without keeping a triangulation.
#pragma once
#include <cstddef>
#include <cstdint>

#include "delaunay/plane_cells.hpp"
#include "delaunay/triangulate.hpp"
#include "homology/persistence.hpp"
#include "memory/work.hpp"

namespace netmesh {

struct AlphaOfPoints {
    InputRows points;
    std::size_t count;
    std::uint64_t seed;
    DiagramRequest diagram;
};

struct AlphaDiagram {
    CountedPairs found;
    std::uint32_t distinct;  // points, after merging
    InputReport input;
};

// The diagram that triangulate and alpha_of_triangulation make. Once the points are triangulated nothing stays of a
// cell but its vertices and nothing of a point but its coordinates; in the plane see alpha_of_plane.
//
// The pairs are put at the arena's low end, everything else is given back; without ok nothing stays. Memory from
// space on: the larger of what triangulate takes and of what alpha_of_triangulation takes above 8 D bytes a point.
// ok, not_finite, flat, out_of_memory, out_of_range, cancelled.
template <int D> Status alpha_of_points(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out);

// The same, but in the plane of no more than few_points_max points, and in less code.
constexpr std::size_t few_points_max = NarrowWords::points_max;
template <int D> Status alpha_of_few_points(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out);

// The same with weights. `distinct` are those that are not hidden; the list of hidden ones stays at the arena's high
// end. Memory: 8 bytes a point more.
struct WeightedAlphaOfPoints : AlphaOfPoints {
    WeightRows weights;
    bool squares;  // values are powers, not their signed roots
};
struct WeightedAlphaDiagram : AlphaDiagram {
    HiddenPoints hidden;
};
template <int D>
Status alpha_of_weighted_points(const WeightedAlphaOfPoints& request, const Work& work, WeightedAlphaDiagram* out);

}  // namespace netmesh
