// Rows of numbers that need not be of one length (a triangle of distances, bars) in the dialects of tables.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace netmesh::tool {

// What spreadsheets and others write, as plain text with the same lines: UTF-16 becomes UTF-8, ends of lines of old
// become new ones, comments go, numbers lose their quotes, bars between them become semicolons. Commas between digits
// are decimal where something else parts fields in their line, and become points. *plain stays empty where there is
// nothing to do, and holds no comments else; `note` says what was understood. A complaint about line *line, or empty.
std::string make_plain(std::string_view content, std::string* plain, std::string* note, std::uint64_t* line);

}  // namespace netmesh::tool
