// Representatives on their way out, and the check on them.
#pragma once
#include <string>

#include "netmesh.hpp"
#include "tools/io/text_writer.hpp"

namespace netmesh::tool {

// `bar DEGREE BIRTH DEATH N` and N lines of vertices for each pair that the engine holds.
void write_cycles(const Engine& engine, TextWriter& out);

// Empty when every cycle has boundary zero (in degree 0: is one vertex, or two of a pair that dies) and enters with its
// pair; otherwise what is wrong.
std::string cycles_complaint(const Engine& engine);

}  // namespace netmesh::tool
