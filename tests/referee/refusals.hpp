// What the tool may refuse, as documented.
#pragma once
#include "exact.hpp"

#include <vector>

namespace referee {

// Are there no D + 1 affinely independent points?
bool is_flat(const std::vector<Point>& points, int dim);

// Two points nearer than so many units in the last place of their coordinates: 64, which meshing may refuse, or more
// where cells have to be small.
bool has_close_points(const std::vector<Point>& points, int dim, double units = 64);

// How many units in the last place points must be apart, as documented, for a mesh of this tau (0: the default).
double least_units(double tau, int dim);

// Magnitudes above 2^500 or distances below 2^-500, likewise.
bool is_out_of_range(const std::vector<Point>& points, int dim);

}  // namespace referee
