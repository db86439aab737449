// The diagrams of the scales of a set of points (filtration/scale_partition.hpp), joined: the tight filter on meshes
// over-refined for eps, or the complete filter on meshes refined by the certificate. What the join needs of a scale is
// the certificate of its diagram, whose essential class is born at 0 as that of all filters with inputs at 0 is.
#pragma once
#include <cstdint>

#include "certificate/certificate.hpp"
#include "delaunay/any_store.hpp"
#include "homology/cycles/cycles.hpp"
#include "jobs/bar_bounds.hpp"
#include "memory/work.hpp"

namespace netmesh {

struct ScalesRequest {
    double theta;       // in (0, 1/9]
    double eps, ratio;  // eps in (0, 1/2] and ratio 0, or the ratio of the joined diagram, above 1.4143 (1 + 3 theta)
    double tau;         // with eps
    std::uint64_t seed;
    FilterValues values;
    std::uint32_t max_degree;  // 0..D-1
    bool keep_zero;
    bool bounds;           // of each bar, and by scale
    bool representatives;  // of each bar of some length, by the points (joined_bars.hpp)
};

struct ScalesResult {
    PairList pairs;  // at the arena's low end
    double ratio, ratio_best;
    double separation;
    std::uint64_t simplices, vertices;  // of all meshes
    std::uint32_t clusters, most_points, most_vertices;
    std::uint64_t row_a, row_b;  // culprits of out_of_range, too_close, invalid_argument
    BarBounds* bounds;           // [pairs.count] when they are asked for, behind the pairs
    ScaleCurve curve;            // likewise
    CycleStore cycles;           // of lower_star_cycle, before the pairs, when they are asked for
};

// The joined diagram of the distinct points that are the vertices 0..count-1 of `points`: one mesh after the other
// in the same memory, in coordinates from its representative where these are exact. With a ratio the partition is
// made twice, as the meshes' part of it depends on how far the scales are apart; so it is with bounds, which need to
// know all clusters (join_shift.hpp). Those take what bound_bars takes of each mesh, 80 bytes a bar and 48 KB;
// cycles what the diagram takes of each mesh, 80 bytes a bar and themselves. Vertices of cycles are those of
// `points`. Everything but the pairs and what is known of them is given back. out_of_memory, cancelled,
// out_of_range, too_close, invalid_argument (coordinates do not resolve the size asked for).
Status diagram_of_scales(const AnyStore& points, std::uint32_t count, const ScalesRequest& request, const Work& work,
                         ScalesResult* result);

}  // namespace netmesh
