// How much room texts take, from a table of the widths of characters.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace netmesh::tool {

// Pixels, not less than in Helvetica, Arial, Liberation Sans and DejaVu Sans, whichever the viewer has. UTF-8.
double text_width(std::string_view text, double size, bool bold = false);

// The same text in lines of at most `width` pixels, broken at blanks; a word that is longer is cut short by an
// ellipsis.
std::vector<std::string> wrapped_text(std::string_view text, double size, bool bold, double width);

// The text, cut short by an ellipsis where it takes more than `width` pixels.
std::string fitted_text(std::string_view text, double size, bool bold, double width);

}  // namespace netmesh::tool
