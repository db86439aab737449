// Filtrations on the points themselves: from points to a complex (filtration/point_complexes.hpp), from the complex to
// a diagram.
#pragma once
#include <cstdint>

#include "jobs/diagram_of_complex.hpp"
#include "jobs/point_set.hpp"

namespace netmesh {

struct PointsRequest {
    PointsFilter filter;
    InputRows points;
    std::uint32_t count, dim;
    double threshold;                 // of Rips filters: larger values are left out
    bool keep_zero, representatives;  // representatives: of filters that have cycles
};

struct PointsDiagram {
    ComplexDiagram diagram;
    double ratio;  // of the diagram, and the best
    std::uint32_t distinct;
    std::uint64_t input_fingerprint;
    std::uint64_t culprit;  // after not_finite: the row
    bool is_listed;         // representatives are asked for: the complex stays for cycle_of
    ListedComplex complex;
};

// Exact duplicates are merged into the first occurrence. The pairs are put at the arena's low end, with representatives
// behind the points and the complex, whose cycles stay at the high end; without ok nothing stays. Memory: points_bytes.
// invalid_argument (k above the number of distinct points), not_finite, out_of_range (CECH), out_of_memory, cancelled,
// internal.
Status diagram_of_points(const PointsRequest& request, const Work& work, PointsDiagram* out);

// The same, of Rips complexes in degrees 0 and 1 of points in the plane and in space with no more edges than are needed
// (rips_bound.hpp): of what is known to have no more of degree 1. Links the triangulation.
Status bounded_diagram_of_points(const PointsRequest& request, const Work& work, PointsDiagram* out);

// Bytes that n points in any position take at most, but for the fill of the reduction. Of a bounded diagram those that
// uniform points take.
double bounded_points_bytes(const PointsFilter& filter, std::uint64_t n, std::uint32_t dim);
double points_bytes(const PointsFilter& filter, std::uint64_t n, std::uint32_t dim);

}  // namespace netmesh
