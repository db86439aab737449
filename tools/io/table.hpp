// Tables of numbers in text, as spreadsheets, pandas, R, MATLAB and hand-made programs write them.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/io/lattice.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

// How a table is read where the file does not say it or says it wrongly.
struct TableOptions {
    char delimiter = 0;                // 0: told by the file; ' ': blanks; with one given, commas in fields are decimal
    std::uint64_t skip = 0;            // physical lines left out at the top
    std::vector<std::string> columns;  // numbers from 1, ranges 2-4, names of the header; none: all
    std::string weights;               // a column of radii or weights, by number or name; of atoms vdw; empty: none
    bool are_radii = false;            // these numbers
    Lattice lattice;                   // by which points repeat
    bool drop_missing = false;         // rows in which a value is missing are left out
    bool distances = false;            // of arrays: one axis is taken as one column, and infinity is a number
};

struct Table {
    std::string name;  // for messages
    std::size_t width = 0;
    std::size_t columns = 0;           // that rows of a text have, taken or not
    std::vector<double> values;        // [rows][width], finite, no -0.0
    bool has_weights = false;          // the last column is of radii or weights
    std::vector<std::uint64_t> lines;  // physical line of each row; empty for binary formats
    FileCell cell;                     // of atoms
    std::string note;                  // what was left out or understood: `skipped header "x,y"`; empty when nothing
    bool has_slip = false;             // the note says what may be a slip (slips.hpp)

    std::size_t rows() const { return width == 0 ? 0 : values.size() / width; }
};

// One row a line, fields as RFC 4180 has them: in quotes they may hold delimiters and ends of lines. # outside of
// quotes starts a comment, as % and // do at the start of a line. The delimiter is the one that fits all lines:
// semicolons, tabs, bars, commas or blanks; blanks in cells between commas part nothing. Only numbers that no single
// one parts are parted by commas, semicolons and blanks together, which the note says of commas. Numbers with decimal
// commas are read where nothing else can be meant. A header of words, an index column that the header tells of, an
// empty last column and empty rows at the end are left out, and table->note says so, as of numbers so small that they
// are 0 as doubles. What can be read in two ways is an error that names the option which decides. Every fault is
// Exit::data with file, line and remedy.
Outcome parse_table(std::string_view content, const TableOptions& options, Table* table);

// How the rows of a table are cut, for whoever reads on where its text ended.
struct TableShape {
    bool is_plain = false;             // numbers, maybe a header and an index: nothing that hangs on all of the lines
    char delimiter = 0;                // 0: several together
    std::size_t fields = 0;            // of a row
    std::vector<std::size_t> columns;  // those that are taken, from 0
    std::uint64_t first_line = 0;      // of the first row
    enum { none, ascends, counts } index = none;  // what the first column does that was left out
};
Outcome parse_table(std::string_view content, const TableOptions& options, Table* table, TableShape* shape);

// Whether digits that are not all 0 stand for a number that is 0 as a double: 1e-400.
bool is_below_doubles(std::string_view number);

// What --columns holds, cut at commas outside of quotes: a complaint, or empty.
std::string parse_columns(const std::string& text, std::vector<std::string>* columns);
// The columns that are taken, counted from 0: those of --columns, or those that *columns has, and behind them that of
// weights. A complaint, or empty.
std::string choose_columns(const TableOptions& options, std::size_t width, const std::vector<std::string>& names,
                           std::vector<std::size_t>* columns);
// "--radii 4"
std::string weights_option(const TableOptions& options);

}  // namespace netmesh::tool
