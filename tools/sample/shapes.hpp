// Point sets by formula.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tools/outcome.hpp"

namespace netmesh::tool {

struct SampleRequest {
    std::string shape;
    std::uint64_t count = 0;
    std::uint32_t dim = 0;  // 0: the shape's own
    std::uint64_t seed = 1;
    double noise = 0;                  // standard deviation of a normal offset added to every coordinate
    std::uint64_t turns[2] = {1, 10};  // of the Clifford winding: around the first and the second circle
};

// coordinates[count][*dim]. Exit::usage for a shape that does not exist or that does not fit the dimension or count.
Outcome sample_points(const SampleRequest& request, std::vector<double>* coordinates, std::uint32_t* dim);

// Whether the points depend on the seed, noise apart; true of names that are no shape.
bool is_random_shape(const std::string& name);

// "  name   what it is" for each shape, for the help text.
std::string shapes_help();

}  // namespace netmesh::tool
