// Alpha complexes of GUDHI as it keeps them, compiled once with those of gudhi.hpp.
#pragma once
#include <gudhi/Simplex_tree.h>

#include "common/inputs.hpp"

// The alpha complex in exact arithmetic, with the squares of radii, rounded to double; with weights their powers.
void make_gudhi_tree(int dim, const inputs::Points& points, const inputs::Points& weights, Gudhi::Simplex_tree<>* tree);
