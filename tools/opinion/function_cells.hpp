// What the additive error of a function's diagram has to be at least, from the Voronoi cells of a mesh.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/io/mesh_files.hpp"
#include "tools/opinion/spheres.hpp"

namespace netmesh::tool {

struct FunctionClaim {
    std::function<double(const double* x)> function;  // no number where it is not known
    double lipschitz, cut, error;
};

struct FunctionOpinion {
    std::vector<Real> values;       // the function at each vertex, cut
    std::vector<Real> least, most;  // what it takes at the vertex and, where known, the corners of its cell
    std::vector<Real> low, high;    // how far down and up it may go at those corners that are in the domain
    std::uint64_t places = 0;
};

// Outside of the domain the function is the cut.
FunctionOpinion function_opinion(const MeshFiles& files, const FunctionClaim& claim);

// Empty, or why the error claimed is too small for vertex *at with that filter value.
std::string error_complaint(const FunctionOpinion& opinion, const FunctionClaim& claim,
                            const std::vector<double>& filter_values, std::size_t* at);

}  // namespace netmesh::tool
