// Which simplices of a Delaunay triangulation have dual Voronoi faces that meet the domain's ball, exactly.
//
// The dual face of a simplex s with the vertex v lies in the flat of points as far from v as from the others of s. Let
// x be the point of the flat nearest to the ball's centre. If x is outside of the ball, so is the face. If x is in the
// face, that is, no nearer to the further vertex w of any cofacet s + w than to v, the face meets the ball. Otherwise
// its point nearest to the centre lies in the dual face of a cofacet.
#pragma once
#include <map>

#include "mesh_file.hpp"

namespace referee {

class Nerve {
public:
    explicit Nerve(const Mesh& mesh);
    bool has(const std::vector<std::uint32_t>& simplex) const {  // vertices ascending
        const auto found = meets_.find(simplex);
        return found != meets_.end() && found->second;
    }

private:
    std::map<std::vector<std::uint32_t>, bool> meets_;
};

}  // namespace referee
