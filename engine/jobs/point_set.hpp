// What jobs on points themselves share: the points without their copies, and the sets of them that a filter begins
// with.
#pragma once
#include <cstdint>

#include "certificate/certificate.hpp"
#include "complex/listed_complex.hpp"
#include "diagram/pair.hpp"
#include "include/netmesh.h"
#include "memory/work.hpp"
#include "numerics/input_rows.hpp"

namespace netmesh {

// Degrees up to this one, and k + max_degree of barycentric filters.
constexpr std::uint32_t points_degree_max = ListedComplex::dimension_max - 1;

struct PointsFilter {
    netmesh_filter_id filter;  // of source points
    FilterValues values;
    std::uint32_t k;           // of filters that need it, >= 1
    std::uint32_t max_degree;  // with k, where it is needed, at most points_degree_max
};

struct GivenPoints {
    InputRows points;
    std::uint32_t count, dim;
};

struct PointSet {
    double* coordinates;  // [count][dim]
    std::uint32_t count, dim;
    std::uint64_t fingerprint;
};

// Copies the points to the arena's low end, -0.0 as 0, and leaves out what equals an earlier one. not_finite (*culprit:
// the row), out_of_memory.
Status take_points(const GivenPoints& given, Arena& arena, PointSet* out, std::uint64_t* culprit);

// Of the k-nearest-neighbour kind: chains of sets of k points and more (8.5).
bool is_barycentric(netmesh_filter_id filter);
bool has_edges(netmesh_filter_id filter);  // a set enters with its longest edge, not with its ball

// The factor on the filter's own values, and the ratio that the diagram then has. Balls of sets are told by edges alone
// up to a factor between 1 and the root of 2.
double factor_of(const PointsFilter& filter);
double ratio_of(const PointsFilter& filter);

// All sets of up to `dimension` + 1 points, with the filter's own values.
Status list_sets(const PointSet& set, netmesh_filter_id filter, std::uint32_t dimension, const Work& work,
                 ListedComplex* out);

}  // namespace netmesh
