// A multifiltration of points by k and scale (thesis 8.5): the diagrams of a barycentric filtration for a range of k,
// and the maps between consecutive ones.
#pragma once
#include <cstdint>

#include "jobs/follow_vines.hpp"
#include "jobs/point_set.hpp"

namespace netmesh {

struct PointsVineyardRequest {
    GivenPoints given;
    PointsFilter filter;   // barycentric; its k is the first
    std::uint32_t k_last;  // >= k, with max_degree at most points_degree_max
};

struct PointsVineyard {
    VineList vines;
    std::uint32_t distinct;
    std::uint64_t input_fingerprint;
    std::uint64_t culprit;  // after not_finite: the row
};

// The diagram at each k is that of diagram_of_points without pairs of zero length. Sets of more points are fewer: at
// each scale the chains for k + 1 are among those for k, and inclusion maps the homology of the former to that of the
// latter. For Cech this is the map of the places themselves: let Z_k be the pairs of a place x and a point of the
// chains of sets u, of k points and more, whose balls all hold x. Over a place stand the subsets of a largest set,
// which are a cone, over a point of a chain the balls' intersection of its largest set, which is convex: both
// projections are homotopy equivalences, and Z_(k+1) is in Z_k at every scale, so they go with the maps.
// A vine goes through the bars that these maps match (diagram/induced_matching.hpp). Where it has points (b, d) at k
// and (b', d') at k + 1, the image of the map has the bar (b', d), and it has no others.
// One complex for all k, on nested sets that differ by at most max_degree + 1 points; put in order once. `out` is put
// at the arena's low end, everything else is given back; without ok nothing stays. Memory: points_vineyard_bytes.
// invalid_argument (k_last above the number of distinct points), not_finite, out_of_range (CECH), out_of_memory,
// cancelled, internal.
Status points_vineyard(const PointsVineyardRequest& request, const Work& work, PointsVineyard* out);

// Bytes that n points in any position take at most, but for the fill of the reduction.
double points_vineyard_bytes(const PointsFilter& filter, std::uint32_t k_last, std::uint64_t n, std::uint32_t dim);

}  // namespace netmesh
