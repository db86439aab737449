// What a mesh with a domain promises beyond its triangulation, by definition.
//
//   domain     contains every input. It lies inside the hull; or all of the hull is the boundary net of 3.5 on the
//              domain's sphere, and every point of that is within delta of it
//   markers    inputs come first. Vertices of the hull are exempt. An exempt vertex is on the hull and outside of the
//              domain, or in a cage's shell, or in the boundary net, at least delta from the others
//   quality    for each v that is not exempt: max |x - v| over x in Vor(v) and its domain's ball is at most tau r_v,
//              r_v half the distance to the nearest other vertex. For each cage, with u its centre, w the distance to
//              the nearest vertex of its shell and z the nearest vertex outside: max |x - u| over the cells of the
//              cage's vertices, in the ball of the domain around it, is at most tau (|z - u| + w) / 2 (4.6)
//   size       for each v that is not exempt: the same maximum is at most eps times the distance from v to the second
//              nearest input, v counted
//   certificate  `# ratio C`: the bounds of the distance to the inputs on every cell, certificate.hpp
#pragma once
#include "cages.hpp"
#include "random.hpp"
#include "triangulation.hpp"
#include "voronoi.hpp"

namespace referee {

// Room for the rounding of points that were computed: netmesh.h admits as much of meshes made elsewhere.
constexpr double room = 1 + 0x1p-40;

double promised_tau(const Mesh& mesh);

// Distance from x to the second nearest input, those at x counted; infinite for a single input.
double feature_size(const Mesh& mesh, const Point& x);

void judge_domain(const Mesh& mesh, const Hull& hull, Verdict* verdict);
void judge_markers(const Mesh& mesh, const Hull& hull, const Hierarchy& hierarchy, Verdict* verdict);

// How many cells are measured.
struct Effort {
    double cells_max;
    bool first_fault;
    Random& random;
};
void judge_quality(const Mesh& mesh, const Diagram& diagram, const Hierarchy& hierarchy, const Effort& effort,
                   Verdict* verdict);

// Without corners or poles: points of each domain, and where rays from vertices leave their cells; nearest vertices
// over all vertices.
void sample_quality(const Mesh& mesh, const Hierarchy& hierarchy, std::size_t samples, Random& random,
                    Verdict* verdict);

}  // namespace referee
