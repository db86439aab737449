// Files that teach shells the commands, options and words of the tables.
#pragma once
#include <string>

namespace netmesh::tool {

// `shell` is bash or zsh. CMake installs what `netmesh --completion SHELL` prints.
std::string completion_text(const std::string& shell);

}  // namespace netmesh::tool
