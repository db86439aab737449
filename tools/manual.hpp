// Manual pages out of the tables of commands and options.
#pragma once
#include <string>

#include "tools/options.hpp"

namespace netmesh::tool {

// The page of a command, or of the program, in the language of man. CMake installs what `netmesh --manual` prints.
std::string manual_text(Command command);

// What `netmesh help` and the page of the program say of points and of exit codes.
extern const char* const points_paragraph;
extern const char* const exit_paragraph;
extern const char* const program_examples;

}  // namespace netmesh::tool
