// The edges of a Vietoris-Rips complex of data that is known by its distances.
#pragma once
#include <cstdint>

#include "filtration/distance_source.hpp"
#include "homology/rips/rips.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct DistanceLimits {
    double limit;  // edges up to this one are wanted: where the complex is a cone, or the threshold; finite
    std::uint64_t fingerprint;  // of all distances
};

// Looks at every distance; of points, whose fingerprint is 0 here, as far as the limit asks for. invalid_argument
// (*fault), out_of_memory, cancelled.
Status measure_distances(const DistanceSource& source, double threshold, const Work& work, DistanceLimits* out,
                         DistanceFault* fault);

// As measure_distances, with the edges at the arena's low end. source.count <= RipsGraph::table_max.
Status distance_graph(const DistanceSource& source, double threshold, const Work& work, RipsGraph* out,
                      DistanceLimits* limits, DistanceFault* fault);

struct DistanceEntries {
    const netmesh_distance_entry* entries;
    std::uint32_t entry_count, count;  // count: of points, <= RipsGraph::vertices_max
};
// The same of entries.
Status sparse_graph(const DistanceEntries& entries, double threshold, const Work& work, RipsGraph* out,
                    DistanceLimits* limits, DistanceFault* fault);

}  // namespace netmesh
