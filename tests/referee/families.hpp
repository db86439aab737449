// Points that meshers get wrong.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "random.hpp"

namespace referee {

using Points = std::vector<Point>;

struct Family {
    const char* name;
    std::function<Points(int dim, std::size_t size, Random&)> make;  // about `size` points, or fewer
};

const std::vector<Family>& families();

// The inputs of which version 0.1.0 said "aspect ratio at most 0".
struct NamedInput {
    const char* name;
    int dim;
    double tau;
    Points points;
};
std::vector<NamedInput> named_inputs(std::size_t share);  // a share-th of the points

}  // namespace referee
