// What a misspelt word was meant to be.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace netmesh::tool {

// Letters that are put in, left out, changed, or swapped with their neighbour, to make one word of the other.
std::size_t edits_between(const std::string& a, const std::string& b);

// "; did you mean NAME?", the one name that `given` is closest to: a third of its letters may be wrong, or it is the
// beginning of no other name. Empty where no name is close.
std::string did_you_mean(const std::string& given, const std::vector<std::string>& names);

}  // namespace netmesh::tool
