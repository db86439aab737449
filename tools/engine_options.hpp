// Members of the engine's request by their names, after the engine's own table of options.
#pragma once
#include <string>
#include <vector>

#include "netmesh.hpp"

namespace netmesh::tool {

// The row of that name, "focus_ratio", which there is.
const netmesh_option& engine_option(const std::string& name);
// The words that it takes; none where it takes no words.
std::vector<std::string> engine_words(const std::string& name);

// Sets the member; of a flag the text is not read. A complaint, or empty. 0 is refused where it says that nothing is
// asked for.
std::string set_option(netmesh_request* request, const std::string& name, const std::string& text);
// Its value as set_option reads it; of a flag empty.
std::string option_text(const netmesh_request& request, const std::string& name);
// Is it anything but what a request has by default?
bool is_given(const netmesh_request& request, const std::string& name);

}  // namespace netmesh::tool
