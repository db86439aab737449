// The commands, each from parsed options to an exit code.
#pragma once
#include "tools/options.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

// The job that plans a persistence diagram of this filter.
netmesh_job job_of(netmesh_filter filter);

Outcome run_engine_command(const Options& options);  // mesh, delaunay, persist
Outcome run_vineyard(const Options& options);
Outcome run_size(const Options& options);
Outcome run_check(const Options& options);
Outcome run_sample(const Options& options);

}  // namespace netmesh::tool
