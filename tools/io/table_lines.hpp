// The lines of a table, cut into fields by one delimiter or another: what parse_table is made of.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/io/characters.hpp"
#include "tools/io/table.hpp"

namespace netmesh::tool {

struct TableLine {
    std::string_view text;     // without line end, comment and blanks behind; tabs in front are kept
    std::uint64_t number;      // physical, from 1, of its beginning
    std::string_view comment;  // behind it, from # on
};

// A field of a line, without quotes and blanks around. Of an empty one data() is where it would stand.
struct Field {
    std::string_view text;
    bool quoted;
};

// How fields are told apart, and what a comma in a number is.
struct Dialect {
    char delimiter = 0;          // 0: blanks, commas and semicolons together; ' ': runs of blanks
    bool decimal_comma = false;  // numbers may have a comma in place of the point
};

// All lines that hold something, behind `skip` physical ones; ends of lines in a field in quotes are part of it. A
// complaint about line *line, or empty. *remade holds the text where its line ends had to be replaced; `content` and
// *remade must outlive the lines. *above is what the last comment in front of them says.
std::string collect_lines(std::string_view content, std::uint64_t skip, std::string* remade,
                          std::vector<TableLine>* lines, std::string_view* above, std::uint64_t* line);

// The text from its byte-order mark on, in UTF-8, with \n at the ends of its lines; *remade holds it where it had to be
// written anew, and must outlive it.
std::string_view with_plain_ends(std::string_view content, std::string* remade);
// The line without a comment: # outside of quotes and of cells, % and // at its start.
std::string_view without_comment(std::string_view line);

// False where a quotation does not end.
bool cut_line(std::string_view line, char delimiter, std::vector<Field>* fields);

// A field as a name: of its doubled quotes one is left.
std::string name_in(const Field& field);

enum class FieldKind { number, not_finite, word, empty };
// What a whole field is; its value when it is a number. A decimal comma only where the dialect has it.
FieldKind read_field(const Field& field, bool decimal_comma, double* value);

// Whether a line can be a header: nothing in it is a number or begins like one, and something is a word. Of a line
// that begins with an empty field numbers are names too (pandas).
bool is_header_line(const std::vector<Field>& fields);

// The dialect that fits lines[first..]. A complaint with its remedy about line *line, or empty; `sentence` is added to
// the table's note where it is not empty.
std::string find_dialect(const std::vector<TableLine>& lines, std::size_t first, const TableOptions& options,
                         Dialect* dialect, std::string* sentence, std::uint64_t* line);

// The delimiter as an option: `--delimiter ';'`.
std::string delimiter_option(char delimiter);

}  // namespace netmesh::tool
