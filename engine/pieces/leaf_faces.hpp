// What a leaf is made of: faces of the cells at its points, with values and with where their vertices are from.
#pragma once
#include "complex/faces.hpp"
#include "memory/work.hpp"
#include "pieces/residual.hpp"
#include "pieces/source.hpp"
#include "pieces/stars.hpp"

namespace netmesh {

struct LeafFaces {
    AnyFaces faces;               // of the triangulation about the node's points
    double* value[simplex_most];  // of k-faces; right where a vertex is the node's own
    std::uint32_t* row;           // of vertices: rows of the input
    PieceNode* leaf;              // of vertices: their lowest nodes
};

// They are left in the arena. What certified_stars and alpha_values say.
Status list_leaf_faces(const PointSource& source, PieceNode node, const Work& work, LeafFaces* out,
                       StarsReport* report);
template <int D>
Status list_leaf_faces(const PointSource& source, PieceNode node, const Work& work, LeafFaces* out,
                       StarsReport* report);

}  // namespace netmesh
