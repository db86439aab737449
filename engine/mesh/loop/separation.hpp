// May the input be meshed?
#pragma once
#include <cstdint>

#include "delaunay/triangulate.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {

// What meshing admits: magnitudes of coordinates, distances, and distances over magnitudes.
constexpr double coordinate_max = 0x1p500;
constexpr double separation_min = 0x1p-500;
constexpr double resolution = 64 * 0x1p-52;

// The least distance over magnitude with which cells can be held to an aspect ratio of tau although coordinates are
// rounded (derived in aspect_rule.hpp).
inline double finest_distance(int dim, double tau) {
    const double units = 6.5 * square_root(dim) * (2 / (tau - 2) + 1);
    return units < 64 ? resolution : units < 0x1p26 ? units * 0x1p-52 : 0x1p-26;
}

// The store holds inputs alone, `tree` is over them. out_of_range: a coordinate above 2^500 or two inputs closer than
// 2^-500; too_close: two inputs closer than `finest` times the magnitude of their coordinates. Rows in *input. O(n log
// n).
Status check_separation(const AnyStore& store, const AnyInputTree& tree, double finest, InputReport* input);

}  // namespace netmesh
