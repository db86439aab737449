// The commands, each from parsed options to an exit code.
#pragma once
#include "tools/options.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

Outcome run_engine_command(const Options& options);  // mesh, delaunay, persist
Outcome run_distances(const Options& options);       // persist --distances
Outcome run_pieces(const Options& options);
Outcome run_vineyard(const Options& options);
Outcome run_size(const Options& options);
Outcome run_homology(const Options& options);
Outcome run_distance(const Options& options);
Outcome run_check(const Options& options);
Outcome run_sample(const Options& options);

}  // namespace netmesh::tool
