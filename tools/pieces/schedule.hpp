// All tasks of a job in pieces, in processes of this program.
#pragma once
#include <string_view>

#include "tools/options.hpp"
#include "tools/outcome.hpp"
#include "tools/pieces/tasks.hpp"

namespace netmesh::tool {

// Leaves and joins that are not there yet, `jobs` at a time. The first task that fails ends all; what is done stays.
Outcome run_tasks(const Options& options, const PiecesFolder& folder, const PiecesJob& job, unsigned jobs);

// What a Makefile begins with that is written here.
constexpr std::string_view makefile_mark = "# Written by `netmesh pieces split`.";
// A Makefile that does the same, and the names that other schedulers need; for `netmesh pieces split`.
std::string makefile_of(const PiecesJob& job);

}  // namespace netmesh::tool
