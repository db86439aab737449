// A command of several inputs.
#pragma once
#include <functional>
#include <string>

#include "tools/options.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

using RunInput = std::function<Outcome(const std::string& path)>;

// Of several inputs each is tried; the first that fails says how it ends. Bad usage and a signal end it at once.
Outcome run_one_by_one(const Options& options, const RunInput& run);
// The same, options.jobs of them at a time, each in a process: files and what is said are the same, in the order of the
// inputs. Where bad usage or a signal ends it, files of inputs behind may be there already.
Outcome run_side_by_side(const Options& options, const RunInput& run);

}  // namespace netmesh::tool
