// How far the Voronoi cell of a vertex v, clipped to a ball, reaches from a point q.
//
// The clipped cell is convex, so the farthest point x lies on a face F of the cell, in its relative interior, and
// either is a corner of the cell or lies on the sphere. Of points y on the sphere, centre c,
//     |y - q|^2 = |y - c|^2 + |c - q|^2 + 2 (y - c).(c - q)
// is linear in y, and the flat of F meets the sphere in a sphere of its own. If F has dimension 2 or more, a farthest
// point on F in its relative interior is the pole of that sphere in the direction of c - q; if F is an edge, one of
// two points. (If the flat is orthogonal to c - q all its points are equally far; if one that is chosen is not in F,
// neither are all, so the sphere leaves F through a face of lower dimension, at a point as far.)
//
// So the candidates are: the corners of the cell in the ball, both points of each edge, and one pole of each face of
// dimension 2 to D, the cell itself among them. Faces are dual to the simplices at v of any Delaunay triangulation: a
// face of the Delaunay subdivision with the corner v is triangulated by simplices, one of full dimension at v.
// A candidate counts when it is in the cell, that is, no nearer to any neighbour of v than to v.
//
// Decided with intervals; with rationals and one square root where they overlap.
#pragma once
#include "mesh_file.hpp"

namespace referee {

struct Clip {
    Point centre;
    double radius;
    Point reference;  // q
    Rational limit2;  // the square of the largest distance from q that is promised
};

struct Reach {
    double farthest = 0;  // about
    bool beyond = false;  // surely farther than the limit
};

// Of vertices of a mesh that is a Delaunay triangulation.
class Diagram {
public:
    explicit Diagram(const Mesh& mesh);
    const std::vector<std::uint32_t>& neighbours(std::uint32_t v) const { return neighbours_[v]; }
    double nearest(std::uint32_t v) const { return nearest_[v]; }
    Rational nearest2(std::uint32_t v) const;  // squared distance to the nearest other vertex
    Reach reach(std::uint32_t v, const Clip& clip) const;

private:
    const Mesh& mesh_;
    std::vector<std::vector<std::uint32_t>> cells_, neighbours_;
    std::vector<double> nearest_;
};

}  // namespace referee
