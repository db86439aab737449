// Circumcentres of cells so flat that the digits of a double do not tell them, for any dimension: one piece of code for
// all, as it is seldom run.
#pragma once

namespace netmesh {

// The centre is p0 + x, see solve_sphere. error2: bound on (|error of x| / |x|)^2. False: not to be told.
//
// In about 100 bits, for edges of lengths within 2^+-1000. shape_factor: of the dimension, see sphere.hpp.
bool centre_in_long_digits(int dim, const double* const* p, double shape_factor, double* x, double* error2);
// In integers, for cells that only their last bits keep from being flat. They have a corner to be measured as long as
// coordinates and edges are of comparable size.
bool centre_in_integers(int dim, const double* const* p, double* x, double* error2);

}  // namespace netmesh
