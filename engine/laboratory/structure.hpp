// How entangled a triangulation is: degrees, ply, intersections of D-balls (thesis 4.8.1, 4.11).
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"
#include "delaunay/load.hpp"
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
    std::uint32_t ply_stride, balls_stride;  // every k-th cell was looked at; 1: all
    // On the hull, where the boundary of a mesh is: balls whose cells have an exempt vertex there.
    std::uint64_t hull_vertices, hull_degree_max;
    std::uint64_t hull_balls, hull_intersections_max;
};

Status analyse_structure(const AnyStore& store, const Figures& figures, const double* centre, double reach,
                         const Work& work, StructureAnalysis* analysis);
// On a compact store, a triangulation or a mesh. Ply is taken at barycentres of cells and at centres of D-balls that
// are within `reach` of `centre` (pass 0 for none), intersections at all D-balls, those at the boundary of a mesh
// apart: they are as large as the mesh and meet a number of others that grows with it. Of both every k-th cell is
// looked at, k the least for which the work is bounded by about 2^24 looks at a cell. Balls are solved for anew, in
// doubles, so what touches within rounding may count either way. The cells whose balls contain a point within the hull
// hang together through facets, so a flood from one of them finds them all; so do those that meet a ball, but for what
// meets it beyond the hull: where a flood gets to the hull all cells are looked at. Uses vertex.next and cell.mark.
// Scratch: 1 byte a vertex, 4 bytes a cell of the largest flood. out_of_memory, cancelled.
template <int D>
Status analyse_structure(Store<D>& store, const double* centre, double reach, const Work& work,
                         StructureAnalysis* analysis) {
    recompute_balls<D>(store);
    return analyse_structure(store, figures<D>, centre, reach, work, analysis);
}

// One D-ball.
struct BallFigures {
    std::uint32_t ply;    // D-balls that contain the barycentre of its simplex
    std::uint32_t meets;  // other D-balls that meet it
};
// On a store with recomputed balls. Scratch: the largest flood. out_of_memory.
Status measure_ball(const AnyStore& store, CellId c, BallFigures* figures);

}  // namespace netmesh
