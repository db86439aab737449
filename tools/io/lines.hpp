// Text cut into physical lines, lines into numbers.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/outcome.hpp"

namespace netmesh::tool {

// The lines of a text one after the other, without their ends (LF or CRLF), comment and surrounding blanks.
class LineReader {
public:
    // Skips a UTF-8 byte-order mark. `text` must outlive the reader.
    explicit LineReader(std::string_view text, bool comments = true);
    // The next line, also when it is empty. False at the end.
    bool next(std::string_view* line);
    // The next line that holds something.
    bool next_content(std::string_view* line);
    // Physical number, counted from 1, of the line that was handed out last; 0 before the first.
    std::uint64_t number() const { return number_; }
    // Offset in the text at which the next line starts.
    std::size_t offset() const { return offset_; }

private:
    std::string_view text_;
    std::size_t offset_ = 0;
    std::uint64_t number_ = 0;
    bool comments_;
};

// What is wrong with a line, if anything; an empty string when nothing is.
using Complaint = std::string;

// All numbers of a content line into *values (cleared first). Separators: blanks, and commas or semicolons with or
// without blanks around; nothing between two of them is an error, as is one at an end of the line. The words `inf` and
// `infinity` are numbers only where `infinities` are.
Complaint parse_numbers(std::string_view line, std::vector<double>* values, bool infinities = false);

// True when every field is a word and none is a number (nan and inf are numbers).
bool is_header(std::string_view line);

// The fields between blanks.
std::vector<std::string_view> split_blanks(std::string_view line);

// A piece of input fit for a message: quoted, shortened, control characters replaced.
std::string quoted(std::string_view piece);

// What a complaint about a number says, shared by all readers. `field` is the text at fault.
Complaint not_a_number(std::string_view field);
Complaint not_finite(std::string_view field);

}  // namespace netmesh::tool
