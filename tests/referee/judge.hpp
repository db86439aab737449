// Every promise of a mesh, judged from its files.
#pragma once
#include "certificate.hpp"

namespace referee {

// What was asked for, and how closely to look.
struct Case {
    std::vector<Point> points;  // as they were handed to the tool
    int dim = 0;
    double tau = 0, eps = 0;            // 0: not asked for
    double least_size = 0, growth = 0;  // of --cell-size
    double net = 0;                     // of --net
    bool is_mesh = true;                // else a Delaunay triangulation of the points
    bool has_cages = false;             // there may be some
    std::size_t samples = 20000;
    double sphere_tests = 2e6;
    double cells_max = 1e300;  // Voronoi cells that are measured; of larger meshes about as many by chance
    bool first_fault = false;  // one fault is enough
};

// The points without repetitions, each where it is first seen; -0 is 0.
std::vector<Point> distinct(const std::vector<Point>& points, int dim);

Verdict judge(const Mesh& mesh, const Case& wanted, Random& random);

}  // namespace referee
