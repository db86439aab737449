// How entangled a triangulation is: degrees, ply, intersections of D-balls (thesis 4.8.1, 4.11).
#pragma once
#include <cstdint>

#include "delaunay/store.hpp"
#include "memory/work.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

struct StructureAnalysis {
    std::uint64_t vertices;              // with closed stars: not on the hull
    std::uint64_t degree_max, star_max;  // neighbours, cells of such a vertex
    double degree_mean, star_mean;
    std::uint64_t ply_points, ply_max;  // open D-balls that contain a point
    double ply_mean;
    std::uint64_t balls, intersections_max;  // other open D-balls that meet one
    double intersections_mean;
};

// On a compact store, a triangulation or a mesh. Ply is taken at barycentres of cells and at centres of D-balls that
// are within `reach` of `centre` (pass 0 for none), intersections at D-balls whose vertices are not exempt. Of both
// every k-th cell is looked at, k the least for which the work is bounded by about 2^24 looks at a cell. Balls are
// solved for anew, in doubles, so what touches within rounding may count either way. The cells whose balls contain a
// point of the hull, or meet a ball, hang together through facets, so a flood from one of them finds them all. Uses
// vertex.next and cell.mark. Scratch: 1 byte a vertex, 4 bytes a cell of the largest flood. out_of_memory, cancelled.
template <int D>
Status analyse_structure(Store<D>& store, const double* centre, double reach, const Work& work,
                         StructureAnalysis* analysis);

}  // namespace netmesh
