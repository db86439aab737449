#include "tools/io/table.hpp"

#include <algorithm>
#include <cstring>

#include "tools/io/characters.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/slips.hpp"
#include "tools/io/table_lines.hpp"

namespace netmesh::tool {

std::string parse_columns(const std::string& text, std::vector<std::string>* columns) {
    columns->clear();
    std::vector<Field> fields;
    const bool good = cut_line(text, ',', &fields) && !fields.empty() &&
                      std::none_of(fields.begin(), fields.end(), [](const Field& field) { return field.text.empty(); });
    if (!good) return "must be numbers from 1, ranges or names of the header: 1,3-4,z";
    for (const Field& field : fields) columns->push_back(name_in(field));
    return {};
}

namespace {

// "; the header names x [mm], y [mm]"
std::string names_text(const std::vector<std::string>& names) {
    constexpr std::size_t most = 8;
    if (names.empty()) return ", nor a header";
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most; i++)
        if (!names[i].empty()) text += (text.empty() ? "" : ", ") + quoted(names[i]);
    return "; the header names " + text + (names.size() > most ? ", ..." : "");
}

// Columns counted from 0 out of numbers from 1, ranges and names.
std::string resolve_columns(const std::string& option, const std::vector<std::string>& wanted, std::size_t width,
                            const std::vector<std::string>& names, std::vector<std::size_t>* columns) {
    columns->clear();
    for (const std::string& item : wanted) {
        const auto named = std::find(names.begin(), names.end(), item);
        if (named != names.end()) {
            if (std::find(named + 1, names.end(), item) != names.end())
                return option + " " + item + ": two columns are called so; numbers from 1 tell them apart";
            if (names.size() < width)
                return option + " " + item + ": the header names " + counted(names.size(), "column", "columns") +
                       ", the rows have " + std::to_string(width) + "; numbers from 1 say which are meant";
            columns->push_back(static_cast<std::size_t>(named - names.begin()));
            if (columns->back() >= width)
                return "--columns " + item + ": the header names " + counted(names.size(), "column", "columns") +
                       ", the rows have " + std::to_string(width);
            continue;
        }
        const std::size_t dash = item.find('-');
        std::uint64_t from = 0, to = 0;
        const bool good = parse_unsigned(item.substr(0, dash), &from) &&
                          (dash == std::string::npos ? (to = from, true) : parse_unsigned(item.substr(dash + 1), &to));
        if (!good) return option + ": there is no column " + quoted(item) + names_text(names);
        if (from == 0 || to < from || to > width)
            return option + " " + item + ": there are columns 1 to " + std::to_string(width);
        for (std::uint64_t k = from; k <= to; k++) columns->push_back(static_cast<std::size_t>(k - 1));
    }
    for (std::size_t i = 0; i < columns->size(); i++)
        for (std::size_t j = 0; j < i; j++)
            if ((*columns)[i] == (*columns)[j])
                return option + ": column " + std::to_string((*columns)[i] + 1) + " stands there twice";
    return {};
}

}  // namespace

std::string weights_option(const TableOptions& options) {
    return (options.are_radii ? "--radii " : "--weights ") + options.weights;
}

std::string choose_columns(const TableOptions& options, std::size_t width, const std::vector<std::string>& names,
                           std::vector<std::size_t>* columns) {
    const bool named = !options.columns.empty();
    std::string complaint;
    if (named) complaint = resolve_columns("--columns", options.columns, width, names, columns);
    if (!complaint.empty() || options.weights.empty()) return complaint;
    std::vector<std::size_t> weights;
    complaint = resolve_columns(options.are_radii ? "--radii" : "--weights", {options.weights}, width, names, &weights);
    if (!complaint.empty()) return complaint;
    if (weights.size() != 1) return weights_option(options) + ": is one column";
    const auto at = std::find(columns->begin(), columns->end(), weights[0]);
    if (at != columns->end() && named)
        return weights_option(options) + ": --columns takes the same column for a coordinate";
    if (at != columns->end()) columns->erase(at);
    columns->push_back(weights[0]);
    return {};
}

bool is_below_doubles(std::string_view number) {
    const std::string_view digits = number.substr(0, number.find_first_of("eE"));
    return digits.find_first_of("123456789") != std::string_view::npos;
}

namespace {

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> pieces) {
    return std::any_of(pieces.begin(), pieces.end(),
                       [&](std::string_view piece) { return text.substr(0, piece.size()) == piece; });
}

// What stands where there is no value.
bool is_missing(std::string_view text) {
    if (text.empty()) return true;
    if (text.size() > 7) return false;
    const std::string lower = lower_case(text);
    for (const char* missing : {"na", "n/a", "null", "none", "-", "--", ".", "?", "missing", "#n/a", "nan", "-nan"})
        if (lower == missing) return true;
    return false;
}

constexpr const char* numbers_alone = "; rows are of numbers alone, without units, signs of currency and quotes";

// What to do about a field that is no number, and no missing value.
std::string remedy_for(std::string_view text) {
    const std::string lower = lower_case(text);
    if (text.size() > 2 && text[0] == '#' && (text.back() == '!' || text.back() == '?'))
        return "; a spreadsheet says so of an error: mend it there, or take such a row out of the file";
    if (starts_with_any(lower, {"[", "(", "{", "array("}))
        return "; write plain rows of numbers, as numpy.savetxt does, without brackets";
    if (lower.find("\xE2\x88\x92") != std::string::npos || lower.find("\xE2\x80\x93") != std::string::npos)
        return "; its minus is not the sign - of numbers";
    if (lower.find("\xC2\xA0") != std::string::npos || lower.find("\xE2\x80\xAF") != std::string::npos)
        return "; it holds a blank that does not break: replace it";
    if (std::count(text.begin(), text.end(), ',') + std::count(text.begin(), text.end(), '\'') > 0)
        return "; write numbers with a point and without signs between thousands";
    const std::size_t other = lower.find_first_not_of("0123456789.+-e");
    if (other != std::string::npos && other > 0 &&
        (lower[other] == ':' || lower[other] == '/' || lower[other] == '&') &&
        lower.find_first_not_of("0123456789.+-e:/&") == std::string::npos)
        return "; " + delimiter_option(lower[other]) + " where that stands between columns";
    const std::size_t d = lower.find('d');
    if (d != std::string::npos && d > 0 && lower.find_first_not_of("0123456789.+-d") == std::string::npos)
        return "; write e in place of Fortran's d";
    return {};
}

// Of a text without a row: lines that are left out as comments, which may be meant as rows.
std::string remedy_for_comments(std::string_view content) {
    std::size_t count = 0;
    std::string_view line;
    for (LineReader reader(content, false); reader.next(&line);) count += starts(line, "#");
    if (count < 2) return {};
    return "; " + counted(count, "line", "lines") + " of it begin with #, as comments do: take that sign out";
}

// (mm), [m/s], % below names.
bool is_header_of_units(const std::vector<Field>& fields) {
    double ignored;
    return std::all_of(fields.begin(), fields.end(), [&](const Field& field) {
        return read_field(field, true, &ignored) == FieldKind::word || field.text.empty();
    });
}

// A table on its way from lines to numbers.
class TableParser {
public:
    TableParser(const TableOptions& options, Table* table) : options_(options), table_(table) {}
    Outcome parse(std::string_view content);
    // Behind parse().
    TableShape shape() const {
        TableShape found;
        found.is_plain = is_plain_ && remade_.empty() && lines_.size() > 8;
        found.delimiter = dialect_.delimiter;
        found.fields = width_;
        found.columns = columns_;
        found.first_line = lines_[0].number;
        found.index = index_;
        return found;
    }

private:
    // column: counted from 1; 0: no one
    Outcome fault(std::uint64_t line, const std::string& complaint, std::size_t column = 0) const {
        return line_error(table_->name, line, complaint, column);
    }
    void take_separator_line();
    Outcome find_header();
    Outcome drop_ends();
    Outcome find_columns();
    Outcome find_index();
    Outcome check_column_numbers() const;
    Outcome check_count_of_names() const;
    Outcome check_count_of_rows() const;
    void take_names_above();
    void note_slips();
    void note_comments();
    void note_whole_first_row();
    Outcome parse_rows();
    Outcome explain_field(const TableLine& line, std::size_t column) const;
    Outcome explain_width(const TableLine& line) const;
    bool is_word_column(std::size_t column) const;
    // Whether the row behind so many lines can be read.
    bool skipping_helps(std::uint64_t lines) const;
    // Where the delimiter that was given leaves another one in the field that stands in every line.
    std::string remedy_for_delimiter(std::string_view text) const;
    Outcome refuse_diagram(std::string_view content) const;
    // Whether the row has all its fields, and one that is taken has no value.
    bool lacks_value(const std::vector<Field>& fields) const;
    std::size_t count_lacking() const;
    std::string remedy_for_missing() const;
    void note_missing(const std::vector<std::uint64_t>& left_out);
    // Whether the first column counts from row `first` on: 0, 1, 2, ... or from another number on, or only ascends.
    bool counts(bool by_one, std::size_t first = 0) const;
    void add_plain_note(const std::string& sentence) { table_->note += (table_->note.empty() ? "" : "; ") + sentence; }
    // Of what hangs on more than the lines at the top.
    void add_note(const std::string& sentence) {
        add_plain_note(sentence);
        is_plain_ = false;
    }
    bool cut(const TableLine& line, std::vector<Field>* fields) const {
        return cut_line(line.text, dialect_.delimiter, fields);
    }

    TableOptions options_;
    Table* const table_;
    std::string_view content_;
    bool is_trial_ = false;  // of another parser, which asks whether this one can read the rest
    std::string remade_;
    std::vector<TableLine> lines_;  // of rows, once the header is out
    Dialect dialect_;
    TableLine header_ = {};
    std::string_view above_;          // what a comment in front of the rows says
    std::vector<std::string> names_;  // of the header
    std::size_t width_ = 0;           // fields of a row
    std::size_t dropped_ = 0;         // empty fields at the end of every row
    std::vector<std::size_t> columns_;
    std::uint64_t too_small_ = 0;  // numbers that are 0 as doubles alone
    bool is_plain_ = true;
    decltype(TableShape::index) index_ = TableShape::none;
};

// Excel's `sep=;`.
void TableParser::take_separator_line() {
    if (lines_.empty()) return;
    std::string_view text = without_blanks(lines_[0].text);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    if (text.size() != 5 || !starts_with_any(text, {"sep=", "SEP=", "Sep="})) return;
    if (options_.delimiter == 0) options_.delimiter = text[4];
    add_note("skipped line " + quoted(text));
    lines_.erase(lines_.begin());
}

Outcome TableParser::find_header() {
    std::vector<Field> fields;
    std::string sentence;
    std::uint64_t line = 0;
    const auto are_words = [&](char delimiter) {
        return !lines_.empty() && cut_line(lines_[0].text, delimiter, &fields) && is_header_line(fields);
    };
    const bool bars = !lines_.empty() && lines_[0].text.find('|') != std::string_view::npos;
    const bool first_is_words = are_words(0) || are_words(options_.delimiter) || (bars && are_words('|'));
    const bool quoted_alone = !lines_.empty() && lines_.size() > 1 && lines_[0].text.find('"') != std::string::npos &&
                              lines_[1].text.find('"') == std::string::npos;
    const bool apart = first_is_words || quoted_alone;
    std::string complaint = find_dialect(lines_, apart ? 1 : 0, options_, &dialect_, &sentence, &line);
    if (!complaint.empty()) return fault(line, complaint);
    if (!sentence.empty()) add_note(sentence);
    if (lines_.empty()) return {};
    // Names may hold blanks where these are no delimiters, and be numbers where only they are in quotes.
    if (!cut(lines_[0], &fields)) return fault(lines_[0].number, "a quotation that does not end");
    bool header = is_header_line(fields);
    for (std::size_t k = 0; k < fields.size() && !header && quoted_alone; k++) {
        const bool counts = fields[k].text == std::to_string(k) || fields[k].text == std::to_string(k + 1);
        if (!fields[k].quoted || !counts) break;
        header = k + 1 == fields.size();
    }
    if (!header && first_is_words) header = true;
    if (!header) return {};
    header_ = lines_[0];
    for (const Field& field : fields) names_.push_back(name_in(field));
    add_plain_note("skipped header " + quoted(without_blanks(lines_[0].text)));
    lines_.erase(lines_.begin());
    return {};
}

// Rows without a value at the end of the file, and a last column without one.
Outcome TableParser::drop_ends() {
    std::vector<Field> fields;
    const auto nothing = [](const Field& field) { return field.text.empty(); };
    std::size_t rows = 0;
    while (!lines_.empty()) {
        if (!cut(lines_.back(), &fields)) return fault(lines_.back().number, "a quotation that does not end");
        if (!std::all_of(fields.begin(), fields.end(), nothing)) break;
        if (lines_.size() == 1) break;
        lines_.pop_back();
        rows++;
    }
    if (rows > 0)
        add_note("skipped " + std::to_string(rows) + (rows == 1 ? " row" : " rows") + " of nothing at the end");
    bool trailing = lines_.size() > 1 && dialect_.delimiter != ' ';
    for (std::size_t i = 0; i < lines_.size() && trailing; i++)
        trailing = cut(lines_[i], &fields) && fields.size() > 1 && fields.back().text.empty();
    if (lines_.empty()) return {};
    if (!cut(lines_[0], &fields)) return fault(lines_[0].number, "a quotation that does not end");
    if (trailing) {
        dropped_ = 1;
        add_note("skipped an empty last column");
    }
    width_ = fields.size() - dropped_;
    if (trailing && names_.size() == width_ + 1 && names_.back().empty()) names_.pop_back();
    if (names_.empty() || names_.size() == width_) return {};
    // A header may have another delimiter than the rows.
    if (!cut_line(header_.text, 0, &fields) || fields.size() != width_ || !is_header_line(fields)) return {};
    names_.clear();
    for (const Field& field : fields) names_.emplace_back(field.text);
    return {};
}

bool TableParser::counts(bool by_one, std::size_t first) const {
    std::vector<Field> fields;
    double last = 0;
    for (std::size_t i = first; i < lines_.size(); i++) {
        double value;
        if (!cut(lines_[i], &fields) || fields.empty()) return false;
        if (read_field(fields[0], false, &value) != FieldKind::number || value < 0 || !is_count(value)) return false;
        if (i > first && (by_one ? value != last + 1 : value <= last)) return false;
        last = value;
    }
    return first < lines_.size();
}

// A first column that the header says is no coordinate.
Outcome TableParser::find_index() {
    if (names_.empty() || width_ < 2) return {};
    const std::string first = lower_case(names_[0]);
    const bool unnamed = names_.size() == width_ && (first.empty() || first == "unnamed: 0");
    const bool one_short = names_.size() + 1 == width_;
    bool called = false;
    for (const char* name : {"index", "id", "idx", "row", "rowid", "row_id", "no", "no.", "nr", "nr.", "rownames",
                             "row.names", "#", "point_id", "pointid", "fid", "objectid"})
        called = called || (first == name && names_.size() == width_);
    if (!unnamed && !one_short && !called) return {};
    const bool good = counts(true) || (!one_short && counts(false)) || is_word_column(0);
    if (!good) {
        const std::string rest = width_ == 2 ? "" : "--columns 2-" + std::to_string(width_) + " leaves it out, ";
        const std::string others = rest + "--columns 1-" + std::to_string(width_) +
                                   " takes it for coordinates; if this line is part of a title, --skip " +
                                   std::to_string(lines_[0].number) + " leaves it out";
        return fault(lines_[0].number, "the header gives the first column " +
                                           (first.empty() || one_short ? "no name" : "the name " + quoted(names_[0])) +
                                           ", but it does not count rows: " + others);
    }
    columns_.erase(columns_.begin());
    index_ = one_short ? TableShape::counts : TableShape::ascends;
    add_plain_note("skipped index column 1");
    return {};
}

// 0,1,2 above numbers that are all no whole ones: column numbers (pandas) or a point?
Outcome TableParser::check_column_numbers() const {
    if (!names_.empty() || lines_.size() < 3 || dialect_.delimiter == ' ' || dialect_.delimiter == 0 || width_ < 2 ||
        options_.delimiter != 0)
        return {};
    std::vector<Field> fields;
    for (std::size_t i = 0; i < lines_.size(); i++) {
        if (!cut(lines_[i], &fields) || fields.size() < width_) return {};
        for (std::size_t k = 0; k < width_; k++) {
            const bool whole = fields[k].text.find_first_of(".,eE") == std::string_view::npos;
            if (i == 0 ? fields[k].text != std::to_string(k) : whole) return {};
        }
    }
    return fault(lines_[0].number, quoted(lines_[0].text) +
                                       " may be column numbers, as pandas writes them, or a point: --skip " +
                                       std::to_string(lines_[0].number) + " leaves it out, " +
                                       delimiter_option(dialect_.delimiter) + " reads it as a point");
}

// More names than columns, where blanks within names cannot be the reason: rows lack something. Or fewer, and more than
// the one that rows have in front may lack.
Outcome TableParser::check_count_of_names() const {
    std::size_t named = 0;
    for (const std::string& name : names_) named += !name.empty();
    const bool by_blanks = dialect_.delimiter == ' ' || dialect_.delimiter == 0;
    const auto is_short = [](const std::string& name) { return name.size() < 3; };  // x, y, z
    if (by_blanks && !std::all_of(names_.begin(), names_.end(), is_short)) return {};
    if (names_.size() == width_ || named == width_ || named + 1 == width_ || named < 2) return {};
    std::vector<Field> fields;
    double ignored;
    cut(lines_[0], &fields);
    for (const Field& field : fields)
        if (read_field(field, dialect_.decimal_comma, &ignored) == FieldKind::word) return {};  // said of that field
    return fault(lines_[0].number, counted(width_, "column", "columns") + " where the header names " +
                                       std::to_string(named) +
                                       "; --columns with numbers takes the rows as they are, --skip " +
                                       std::to_string(lines_[0].number - 1) + " leaves the header out");
}

// 100 2 above 100 rows of the plane, or 2 100: how many there are of how many coordinates, or a point? And 100 3 0 0
// above rows that are counted is the head of a .node file.
Outcome TableParser::check_count_of_rows() const {
    std::vector<Field> fields;
    if (!names_.empty() || width_ < 2 || lines_.size() < 4) return {};
    if (!cut(lines_[0], &fields) || fields.size() != width_) return {};
    std::vector<std::uint64_t> head(width_);
    for (std::size_t k = 0; k < width_; k++)
        if (!parse_unsigned(std::string(fields[k].text), &head[k])) return {};
    const std::uint64_t rows = lines_.size() - 1;
    const bool is_node = width_ > 2 && head[0] == rows && head[1] > 1 && head[1] < width_ && counts(true, 1);
    const bool is_count = head[0] == rows && head[1] == width_;
    const bool is_turned = width_ == 2 && head[0] == 2 && head[1] == rows;
    if (!is_node && !is_count && !is_turned) return {};
    const std::string skip = "--skip " + std::to_string(lines_[0].number) + " leaves it out";
    const std::string text = quoted(without_blanks(lines_[0].text));
    if (is_node)
        return fault(lines_[0].number, text +
                                           " is the head of a .node file of Triangle or TetGen, it seems: name the "
                                           "file .node; " +
                                           skip + " and has the rows read as a table");
    return fault(lines_[0].number,
                 text + " may say how many points of how many coordinates there are, or be a point: " + skip +
                     ", --columns 1-" + std::to_string(width_) + " reads it as a point");
}

// 2019 2020 2021 above numbers that all have decimals: names, it may be, but read as a point.
void TableParser::note_whole_first_row() {
    if (!names_.empty() || lines_.size() < 3 || width_ < 2) return;
    std::vector<Field> fields;
    double last = 0;
    for (std::size_t i = 0; i < lines_.size(); i++) {
        if (!cut(lines_[i], &fields) || fields.size() < width_) return;
        for (std::size_t k = 0; k < width_; k++) {
            double value;
            if (read_field(fields[k], dialect_.decimal_comma, &value) != FieldKind::number) return;
            const bool whole = fields[k].text.find_first_of(".,eE") == std::string_view::npos;
            if (i > 0 ? whole : !whole || (k > 0 && value <= last)) return;
            last = value;
        }
    }
    add_note("read " + quoted(without_blanks(lines_[0].text)) + " of line " + std::to_string(lines_[0].number) +
             " as a point; if it names columns, --skip " + std::to_string(lines_[0].number) + " leaves it out");
}

// # x,y above the rows, as numpy.savetxt writes names.
void TableParser::take_names_above() {
    std::vector<Field> fields;
    for (const char delimiter : {dialect_.delimiter, char{0}})
        if (cut_line(above_, delimiter, &fields) && fields.size() == width_ && is_header_line(fields)) {
            for (const Field& field : fields) names_.push_back(name_in(field));
            return;
        }
}

Outcome TableParser::find_columns() {
    for (std::size_t k = 0; k < width_; k++) columns_.push_back(k);
    if (options_.columns.empty()) {
        Outcome outcome = check_column_numbers();
        if (outcome.good()) outcome = check_count_of_names();
        if (outcome.good()) outcome = check_count_of_rows();
        if (!outcome.good()) return outcome;
        note_whole_first_row();
        const Outcome found = find_index();
        if (!found.good()) return found;
    }
    if (names_.empty()) take_names_above();
    std::vector<std::string> names = names_;
    if (names.size() + 1 == width_) names.insert(names.begin(), "");
    const std::string complaint = choose_columns(options_, width_, names, &columns_);
    if (!complaint.empty()) return fault(lines_[0].number, complaint);
    return {};
}

bool TableParser::is_word_column(std::size_t column) const {
    std::vector<Field> fields;
    double ignored;
    bool words = false;
    for (const TableLine& line : lines_) {
        if (!cut(line, &fields) || fields.size() <= column) return false;
        const FieldKind kind = read_field(fields[column], dialect_.decimal_comma, &ignored);
        words = words || kind == FieldKind::word;
        const bool good =
            kind == FieldKind::word || kind == FieldKind::empty || (kind == FieldKind::number && fields[column].quoted);
        if (!good) return false;
    }
    return words;
}

bool TableParser::lacks_value(const std::vector<Field>& fields) const {
    return fields.size() == width_ + dropped_ &&
           std::any_of(columns_.begin(), columns_.end(), [&](std::size_t k) { return is_missing(fields[k].text); });
}

std::size_t TableParser::count_lacking() const {
    std::vector<Field> fields;
    return static_cast<std::size_t>(std::count_if(lines_.begin(), lines_.end(), [&](const TableLine& line) {
        return cut(line, &fields) && lacks_value(fields);
    }));
}

std::string TableParser::remedy_for_missing() const {
    const std::size_t count = count_lacking();
    return std::string("; a row with a missing value has to be left out or filled in") +
           (count == lines_.size() ? ""
                                   : ": --drop-missing leaves such rows out, " + grouped_text(count) + " of " +
                                         grouped_text(lines_.size()));
}

void TableParser::note_missing(const std::vector<std::uint64_t>& left_out) {
    constexpr std::size_t most = 5;
    if (!options_.drop_missing) return;
    if (left_out.empty()) return add_note("no row lacks a value");
    std::string places;
    for (std::size_t i = 0; i < left_out.size() && i < most; i++)
        places += (i > 0 ? ", " : "") + std::to_string(left_out[i]);
    add_note("left out " + grouped_text(left_out.size()) + " of " + counted(lines_.size(), "row", "rows") +
             ", which lack a value: line" + (left_out.size() > 1 ? "s " : " ") + places +
             (left_out.size() > most ? ", ..." : ""));
}

// #12 behind the numbers of every row: a column, it may be.
void TableParser::note_comments() {
    if (lines_.size() < 2) return;
    for (const TableLine& line : lines_)
        if (line.comment.size() < 2 || is_blank(line.comment[1])) return;
    add_note("left out what stands behind # in every row, " + quoted(lines_[0].comment) +
             " first; if it is a column, take that sign out");
}

// What is a coordinate by mistake, it may be. A row that counts hangs on all of them.
void TableParser::note_slips() {
    TakenColumns taken;
    taken.columns = columns_;
    if (!options_.weights.empty()) taken.columns.pop_back();
    taken.width = width_;
    taken.chosen = !options_.columns.empty();
    for (const std::size_t column : taken.columns)
        if (names_.size() == width_) taken.names.push_back(names_[column]);
    for (const std::string& sentence : slips_of(taken, table_->values, table_->width)) {
        add_note(sentence);
        table_->has_slip = true;
    }
}

Outcome TableParser::explain_width(const TableLine& line) const {
    std::vector<Field> fields;
    cut(line, &fields);
    const bool may_be_left_out = lacks_value(fields) && count_lacking() < lines_.size();
    const std::string missing = may_be_left_out ? remedy_for_missing() : "";
    for (std::size_t i = 0; i < fields.size(); i++) {
        if (!fields[i].text.empty() || dialect_.delimiter == ' ') continue;
        const std::string delimiter = dialect_.delimiter == '\t'
                                          ? "tab"
                                          : std::string("'") +
                                                (dialect_.delimiter != 0 ? dialect_.delimiter
                                                 : i + 1 < fields.size() ? *fields[i].text.data()
                                                                         : without_blanks(line.text).back()) +
                                                "'";
        return fault(line.number,
                     (i + 1 < fields.size() ? "nothing before a " + delimiter : "nothing after the last " + delimiter) +
                         missing,
                     i + 1);
    }
    const std::uint64_t first = lines_[0].number;
    std::string remedy;
    if (lines_.size() > 2) {  // a count or a title above the rows?
        const auto same = [&](std::size_t i) {
            std::vector<Field> of_line;
            return cut(lines_[i], &of_line) && of_line.size() == fields.size();
        };
        bool others = line.number == lines_[1].number;
        for (std::size_t i = 1; i < lines_.size() && others; i++) others = same(i);
        if (others) remedy = "; --skip " + std::to_string(first) + " leaves that line out";
        bool grows = true;  // by one field a row
        for (std::size_t i = 0; i < lines_.size() && grows; i++) {
            std::vector<Field> of_line;
            grows = cut(lines_[i], &of_line) && of_line.size() == i + 1;
        }
        if (grows) remedy = "; a triangle of distances is read by persist --distances";
    }
    return fault(line.number, counted(fields.size(), "column", "columns") + " where line " + std::to_string(first) +
                                  " has " + std::to_string(width_ + dropped_) + remedy);
}

bool TableParser::skipping_helps(std::uint64_t lines) const {
    if (is_trial_) return false;
    TableOptions options = options_;
    options.skip = lines;
    Table table;
    TableParser rest(options, &table);
    rest.is_trial_ = true;
    const Outcome outcome = rest.parse(content_);
    return outcome.good() || (!rest.lines_.empty() && outcome.line > rest.lines_[0].number);
}

std::string TableParser::remedy_for_delimiter(std::string_view text) const {
    if (options_.delimiter == 0) return {};
    for (const char mark : {';', '\t', '|', ','}) {
        if (mark == options_.delimiter || text.find(mark) == std::string_view::npos) continue;
        if (std::any_of(lines_.begin(), lines_.end(),
                        [&](const TableLine& line) { return line.text.find(mark) == std::string_view::npos; }))
            continue;
        return "; " + delimiter_option(options_.delimiter) + " does not fit: a " +
               (mark == '\t' ? std::string("tab") : std::string(1, mark)) +
               " stands in every line; without --delimiter the lines say what parts them";
    }
    return {};
}

// A diagram is read by `distance`, and its degree is no coordinate. Chosen columns are what somebody asked for.
Outcome TableParser::refuse_diagram(std::string_view content) const {
    if (!options_.columns.empty()) return {};
    const bool is_ours = starts(content, "# netmesh diagram ") || starts(content, "# a choice of ");
    std::vector<std::string> lower;
    for (std::size_t k = 0; k < names_.size() && k < 3; k++) lower.push_back(lower_case(names_[k]));
    if (!is_ours && lower != std::vector<std::string>{"degree", "birth", "death"}) return {};
    return fault(is_ours ? 1 : header_.number,
                 "this is a persistence diagram, not points; `netmesh distance` compares diagrams");
}

Outcome TableParser::explain_field(const TableLine& line, std::size_t column) const {
    std::vector<Field> fields;
    cut(line, &fields);
    double ignored;
    const Field& field = fields[column];
    const FieldKind kind = read_field(field, dialect_.decimal_comma, &ignored);
    if (kind == FieldKind::empty && !field.quoted && options_.columns.empty() && dialect_.delimiter != '\t')
        return explain_width(line);
    if (kind == FieldKind::empty)
        return fault(line.number, "nothing in column " + std::to_string(column + 1) + remedy_for_missing(), column + 1);
    std::string remedy = is_trial_ ? std::string() : remedy_for_delimiter(field.text);
    if (remedy.empty() && lines_.size() > 1 && kind == FieldKind::word && is_word_column(column)) {
        std::vector<std::size_t> others;
        for (const std::size_t k : columns_)
            if (!is_word_column(k)) others.push_back(k + 1);
        if (others.size() > 1) remedy = "; --columns " + ranges_text(others) + " leaves such columns out";
        if (others.size() < 2) remedy = remedy_for(field.text);
        if (others.size() < 2 && remedy.empty())
            remedy = !others.empty()
                         ? "; of the columns that are taken " + std::to_string(others[0]) + " alone holds numbers"
                     : std::any_of(field.text.begin(), field.text.end(), is_digit)
                         ? numbers_alone
                         : "; no column that is taken holds numbers";
        if (others.size() > 6 && others.size() == lines_.size())
            remedy = "; distances, with names or without, are read by persist --distances";
    }
    if (remedy.empty()) remedy = is_missing(field.text) ? remedy_for_missing() : remedy_for(field.text);
    const bool by_blanks = dialect_.delimiter == ' ' || dialect_.delimiter == 0;
    if (kind == FieldKind::word && options_.delimiter == 0 && by_blanks && remedy.find("--") == std::string::npos &&
        line.text.find_first_of(",;|\t") != std::string_view::npos)
        remedy += "; blanks part columns here: --delimiter says what does, as in --delimiter ','";
    const bool of_units = line.number == lines_[0].number && !names_.empty() && kind == FieldKind::word &&
                          lines_.size() > 1 && is_header_of_units(fields) && skipping_helps(line.number);
    if (of_units) remedy = "; --skip " + std::to_string(line.number) + " leaves the lines down to this one out";
    const bool above = &line == &lines_[0] || line.number == lines_[0].number;
    if (kind == FieldKind::not_finite && remedy.empty())
        remedy = "; such a row has to be taken out of the file: no option leaves it out";
    if (remedy.empty() && above && lines_.size() > 1 && skipping_helps(line.number))
        remedy = "; --skip " + std::to_string(line.number) + " leaves the lines down to this one out";
    if (remedy.empty() && above && lines_.size() > 1) remedy = numbers_alone;
    return fault(line.number,
                 (kind == FieldKind::not_finite ? not_finite(field.text) : not_a_number(field.text)) + remedy,
                 column + 1);
}

Outcome TableParser::parse_rows() {
    std::vector<Field> fields;
    table_->width = columns_.size();
    table_->columns = width_;
    table_->has_weights = !options_.weights.empty();
    table_->values.reserve(lines_.size() * columns_.size());
    table_->lines.reserve(lines_.size());
    std::vector<std::uint64_t> left_out;
    for (const TableLine& line : lines_) {
        if (!cut(line, &fields)) return fault(line.number, "a quotation that does not end");
        const bool ragged = fields.size() != width_ + dropped_;
        if (options_.drop_missing && lacks_value(fields)) {
            left_out.push_back(line.number);
            continue;
        }
        // What is no number explains more than a count of fields that it has changed.
        for (const std::size_t column : columns_) {
            if (column >= fields.size()) break;
            double value;
            const FieldKind kind = read_field(fields[column], dialect_.decimal_comma, &value);
            if (kind != FieldKind::number && !(ragged && kind == FieldKind::empty)) return explain_field(line, column);
            if (kind == FieldKind::number) table_->values.push_back(value);
            if (kind == FieldKind::number && value == 0 && is_below_doubles(fields[column].text)) too_small_++;
        }
        if (ragged) return explain_width(line);
        table_->lines.push_back(line.number);
    }
    if (table_->lines.empty()) return fault(lines_[0].number, "every row lacks a value");
    note_missing(left_out);
    note_comments();
    note_slips();
    if (too_small_ > 0) add_note("read " + counted(too_small_, "number", "numbers") + " below 4.9e-324 as 0");
    return {};
}

Outcome TableParser::parse(std::string_view content) {
    std::uint64_t line = 0;
    content_ = content;
    const std::string complaint = collect_lines(content, options_.skip, &remade_, &lines_, &above_, &line);
    if (!complaint.empty()) return fault(line, complaint);
    take_separator_line();
    const auto breaks = std::count_if(lines_.begin(), lines_.end(), [](const TableLine& row) {
        return std::memchr(row.text.data(), '\n', row.text.size()) != nullptr;
    });
    if (breaks > 0)
        add_note(counted(static_cast<std::size_t>(breaks), "row has", "rows have") + " ends of lines in quotes");
    Outcome outcome = find_header();
    if (outcome.good()) outcome = refuse_diagram(content);
    if (outcome.good()) outcome = drop_ends();
    if (!outcome.good()) return outcome;
    if (lines_.empty())
        return fault(line == 0 ? 1 : line, "the input ends without a point" + remedy_for_comments(content));
    outcome = find_columns();
    return outcome.good() ? parse_rows() : outcome;
}

}  // namespace

Outcome parse_table(std::string_view content, const TableOptions& options, Table* table) {
    return TableParser(options, table).parse(content);
}

Outcome parse_table(std::string_view content, const TableOptions& options, Table* table, TableShape* shape) {
    TableParser parser(options, table);
    const Outcome outcome = parser.parse(content);
    if (outcome.good()) *shape = parser.shape();
    return outcome;
}

}  // namespace netmesh::tool
