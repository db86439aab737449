// Options that would change nothing are refused, so that nobody believes in their effect.
#pragma once
#include <initializer_list>
#include <string>

#include "tools/options.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

// Exit::usage for the first option given that can change nothing for this command, filter and kind of file: "--tau:
// filter alpha has no cells that it bounds". What the input alone tells is for the command to say. --quiet never is
// one of them.
Outcome check_use(const Options& options);

// The same of `check` for a diagram whose file says nothing of how it was made: by the options with which persist would
// make it.
Outcome check_use_in_diagram(const Options& made);

// Exit::usage for the first of these options that was given.
Outcome refuse_options(const Options& options, std::initializer_list<const char*> names, const std::string& why);

}  // namespace netmesh::tool
