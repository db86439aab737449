// Lattices: what points with periods repeat by.
#pragma once
#include <cstdint>

#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

// Ties to even.
inline double nearest_integer(double x) {
    constexpr double large = 0x1p52;
    if (!(absolute(x) < large)) return x;
    return x < 0 ? x - large + large : x + large - large;
}

// The vectors b[0..count) of R^dim, each with what it lacks to the vector that it stands for, and the directions in
// which they add one another something: unit vectors e, e[j] . b[j] = h[j] > 0, e[j] . b[i] = 0 for i < j. Directions
// are off by some 2^-50.
struct Lattice {
    static constexpr int most = dimension_most();
    int dim, count;
    double b[most][most], rest[most][most], e[most][most], h[most];

    // Finds e and h. False: a vector depends on those before it.
    bool orthogonalise();
    // Of `vectors` of [given][dim] doubles another basis, short and nearly orthogonal (Lenstra, Lenstra, Lovasz), in
    // about 106 bits. False: vector *culprit depends on those before it, or a sum of them is shorter than 2^-45 of
    // others. of_given, if any: b[j] is the sum of of_given[j][i] vectors i.
    bool open(const double* vectors, int given, int dimension, int* culprit, double (*of_given)[most] = nullptr);
    // How far copies of a point matter, by direction: the Delaunay star of p among all copies is that among those whose
    // e[j] . (q - p) is at most far[j] in size.
    //
    // Let x be nearest to p among all copies of all points, or as near as to any. Among the copies of p alone that
    // bounds u = x - p: u . b[j] <= |b[j]|^2 / 2, and the same of -b[j], so e[j] . u is at most w[j], found from one
    // direction to the next. The copies of q that are nearest to x lie as near in each direction, as what was said of
    // copies of p holds of them. So far = 2 w, with 2^-10 of it more for roundings and ties. With weights the same, as
    // copies have one weight; directions beside the lattice bound nothing and need no bound.
    void find_far(double* far) const;
    // e[j] . x / h[j].
    double place(int j, const double* x) const;
    // x as a sum of part[j] b[j], and of what lies beside the lattice.
    void split(const double* x, double* part) const;
    // x = high + low, less times b[j], in about 106 bits.
    void subtract(double times, int j, double* high, double* low) const;

private:
    bool reduce(double (*of_given)[most]);
};

}  // namespace netmesh
