// What a Rips complex with a threshold, or of distances, is made of.
#pragma once
#include <cmath>
#include <cstdint>
#include <string>

#include "tools/io/distance_file.hpp"
#include "tools/opinion/complexes.hpp"
#include "tools/options.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

struct RipsInput {
    DistanceFile file;  // of --distances
    PointCloud cloud;   // without: the different points, in their order
    std::uint64_t rows = 0;
    std::string path;        // of the file
    bool read_once = false;  // the distances are for one diagram without cycles, and memory for them is scarce

    bool of_points() const { return cloud.dim > 0; }
    std::uint64_t count() const { return of_points() ? cloud.rows() : file.points; }
    const std::string& name() const { return of_points() ? cloud.name : file.place.name; }
};

// Whether the diagram is made of such an input.
inline bool goes_by_distances(const Options& options) {
    return options.distances || std::isfinite(options.request.threshold);
}

// Points of any number of columns, or distances; their notes go to stderr unless --quiet was given.
Outcome read_rips_input(const Options& options, const std::string& path, RipsInput* input);
// The diagram of the session's request in its engine; what there is to report, of points with their
// dimension, number and duplicates. Of an input that is read once the distances may be gone afterwards.
Outcome persist_rips(RipsInput& input, Session& session, netmesh_report* report);

// All sets of up to top + 1 points within the threshold; nothing where there are too many.
SimplexList complex_of(const RipsInput& input, const Options& options, std::uint32_t top);

}  // namespace netmesh::tool
