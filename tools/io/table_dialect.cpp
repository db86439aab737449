// Which delimiter a table has, and whether its numbers have decimal commas.
#include <algorithm>

#include "tools/io/characters.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/table_lines.hpp"

namespace netmesh::tool {

namespace {

// How a file looks that is cut in one way.
struct Look {
    bool consistent = true;  // all lines have the same number of fields, and each is a number or a word
    bool is_even = true;     // all lines have the same number of fields
    std::size_t width = 0;
    bool decimal_commas = false;   // some number has a comma between or beside digits
    bool points = false;           // some number has a point
    bool may_be_thousands = true;  // all those commas stand where thousands have them: 1,234
    bool broken_digits = false;    // some field is digits with a blank and exactly three more behind: 1 234
    bool inner_blanks = false;     // some field is no word and has a blank between
    bool words = false;            // some field has a letter
    std::uint64_t broken_line = 0;
};

bool has_letter(std::string_view text) {
    for (const char c : text)
        if (is_letter(c)) return true;
    return false;
}

// 1,234 or -12,345: one to three digits, no leading zero, and exactly three behind the mark.
bool looks_like_thousands(std::string_view text, char mark) {
    const std::size_t at = text.find(mark);
    std::string_view whole = text.substr(0, at);
    const std::string_view rest = text.substr(at + 1);
    if (!whole.empty() && (whole[0] == '-' || whole[0] == '+')) whole.remove_prefix(1);
    return !whole.empty() && whole.size() <= 3 && whole[0] != '0' && rest.size() == 3 &&
           std::all_of(rest.begin(), rest.end(), is_digit) && std::all_of(whole.begin(), whole.end(), is_digit);
}

// Digits with a sign, a point and an exponent or without, as nearly all fields are: a number, however large. *point:
// whether it has one.
bool is_plain_number(std::string_view text, bool* point) {
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto skip_sign = [&] { at += at != end && (*at == '-' || *at == '+') ? 1 : 0; };
    const auto skip_digits = [&] {
        const char* const start = at;
        while (at != end && is_digit(*at)) at++;
        return at - start;
    };
    skip_sign();
    std::ptrdiff_t digits = skip_digits();
    *point = at != end && *at == '.';
    if (*point) at++, digits += skip_digits();
    if (digits == 0) return false;
    if (at != end && (*at == 'e' || *at == 'E')) {
        at++;
        skip_sign();
        if (skip_digits() == 0) return false;
    }
    return at == end;
}

void look_at_field(const Field& field, std::uint64_t line, bool decimal_comma, Look* look) {
    double ignored;
    bool point;
    if (is_plain_number(field.text, &point)) {
        look->points = look->points || point;
        return;
    }
    if (field.text.empty()) return;
    if (read_field(field, decimal_comma, &ignored) != FieldKind::word) {
        look->points = look->points || field.text.find('.') != std::string_view::npos;
        if (!decimal_comma || field.text.find(',') == std::string_view::npos) return;
        look->decimal_commas = true;
        look->may_be_thousands = look->may_be_thousands && looks_like_thousands(field.text, ',');
        return;
    }
    look->words = look->words || has_letter(field.text);
    if (has_letter(field.text)) return;
    const std::size_t blank = field.text.find_first_of(" \t");
    look->inner_blanks = look->inner_blanks || blank != std::string_view::npos;
    for (std::size_t at = blank; at != std::string_view::npos; at = field.text.find(' ', at + 1)) {
        std::size_t stop = at + 1;
        while (stop < field.text.size() && is_digit(field.text[stop])) stop++;
        if (stop != at + 4 || at == 0 || !is_digit(field.text[at - 1]) || look->broken_digits) continue;
        look->broken_digits = true;
        look->broken_line = line;
    }
    look->consistent = false;
}

Look look_at(const std::vector<TableLine>& lines, std::size_t first, char delimiter, bool decimal_comma) {
    Look look;
    std::vector<Field> fields;
    for (std::size_t i = first; i < lines.size(); i++) {
        if (!cut_line(lines[i].text, delimiter, &fields)) {
            look.consistent = look.is_even = false;
            continue;
        }
        if (look.width == 0) look.width = fields.size();
        look.is_even = look.is_even && fields.size() == look.width;
        for (const Field& field : fields) look_at_field(field, lines[i].number, decimal_comma, &look);
    }
    look.consistent = look.consistent && look.is_even;
    look.may_be_thousands = look.may_be_thousands && look.decimal_commas;
    return look;
}

// Where some lines are parted by blanks alone, the first one with a comma between digits: a decimal comma, it may be,
// of a line that lacks a field. SIZE_MAX for none.
std::size_t line_of_odd_comma(const std::vector<TableLine>& lines, std::size_t first) {
    bool blanks_alone = false;
    std::size_t odd = SIZE_MAX;
    for (std::size_t i = first; i < lines.size(); i++) {
        const std::string_view text = without_blanks(lines[i].text);
        if (text.find_first_of(",;") == std::string_view::npos) {
            blanks_alone = blanks_alone || (text.find_first_of(" \t") != std::string_view::npos &&
                                            text.find_first_not_of("0123456789.+-eE \t") == std::string_view::npos);
            continue;
        }
        for (std::size_t at = text.find(','); at != std::string_view::npos && odd == SIZE_MAX;
             at = text.find(',', at + 1))
            if (at > 0 && at + 1 < text.size() && is_digit(text[at - 1]) && is_digit(text[at + 1])) odd = i;
    }
    return blanks_alone ? odd : SIZE_MAX;
}

// In how many lines each separator stands, outside of quotes.
struct Marks {
    std::size_t semicolon = 0, tab = 0, bar = 0, comma = 0, blank = 0;
    std::size_t comma_and_blank = 0;  // lines with a comma that a blank follows
    std::size_t bare_comma = 0;       // and with one between digits
    bool leading_tab = true;          // every line begins with one: indentation
};

// What a byte is to count_marks, as bits.
struct MarkTable {
    static constexpr unsigned quote = 1, semicolon = 2, tab = 4, bar = 8, comma = 16, blank = 32;
    std::uint8_t of[256] = {};

    constexpr MarkTable() {
        of[static_cast<unsigned>('"')] = quote;
        of[static_cast<unsigned>(';')] = semicolon;
        of[static_cast<unsigned>('\t')] = tab;
        of[static_cast<unsigned>('|')] = bar;
        of[static_cast<unsigned>(',')] = comma;
        of[static_cast<unsigned>(' ')] = blank;
    }
};
constexpr MarkTable mark_table;

// A mark that separates two things, not one at an end of the line.
void count_marks(std::string_view line, Marks* marks) {
    unsigned seen = 0;
    bool quoted = false, spaced = false, bare = false;
    const std::string_view content = without_blanks(line);
    for (std::size_t i = 0; i < content.size(); i++) {
        const unsigned mark = mark_table.of[static_cast<unsigned char>(content[i])];
        if (mark == 0) continue;
        // One within a field, as of inches, begins nothing.
        const bool begins = i == 0 || mark_table.of[static_cast<unsigned char>(content[i - 1])] > MarkTable::quote;
        if (mark == MarkTable::quote) quoted = !quoted && begins;
        if (quoted) continue;
        seen |= mark;
        if (mark != MarkTable::comma || i + 1 >= content.size()) continue;
        spaced = spaced || is_blank(content[i + 1]);
        bare = bare || (i > 0 && is_digit(content[i - 1]) && is_digit(content[i + 1]));
    }
    marks->semicolon += (seen & MarkTable::semicolon) != 0;
    marks->tab += (seen & MarkTable::tab) != 0;
    marks->bar += (seen & MarkTable::bar) != 0;
    marks->comma += (seen & MarkTable::comma) != 0;
    marks->blank += (seen & MarkTable::blank) != 0;
    marks->comma_and_blank += spaced;
    marks->bare_comma += bare;
    marks->leading_tab = marks->leading_tab && !line.empty() && line[0] == '\t';
}

// Tabs that hold columns apart, empty ones too, and not only the blanks of a table that is aligned by hand.
bool is_tab_separated(const std::vector<TableLine>& lines, std::size_t first) {
    const auto tabs = [](std::string_view line) { return std::count(line.begin(), line.end(), '\t'); };
    std::vector<Field> fields;
    std::size_t blank_width = 0;
    bool same_tabs = true, same_fields = true;
    for (std::size_t i = first; i < lines.size(); i++) {
        if (!cut_line(lines[i].text, ' ', &fields)) return true;
        if (i == first) blank_width = fields.size();
        same_tabs = same_tabs && tabs(lines[i].text) == tabs(lines[first].text);
        same_fields = same_fields && fields.size() == blank_width;
    }
    return same_tabs || !same_fields;
}

// 1,002515,-0,002642: whole numbers in every field, and some behind a comma begin with a zero as decimals do.
std::size_t line_of_loose_decimals(const std::vector<TableLine>& lines, std::size_t first) {
    std::vector<Field> fields;
    std::size_t found = SIZE_MAX;
    for (std::size_t i = first; i < lines.size(); i++) {
        if (!cut_line(lines[i].text, ',', &fields) || fields.size() % 2 != 0) return SIZE_MAX;
        for (std::size_t k = 0; k < fields.size(); k++) {
            const std::string_view text = fields[k].text;
            const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
            if (text.size() == sign || fields[k].quoted) return SIZE_MAX;
            if (!std::all_of(text.begin() + static_cast<std::ptrdiff_t>(sign), text.end(), is_digit)) return SIZE_MAX;
            if (k % 2 == 1 && sign == 1) return SIZE_MAX;
            if (k % 2 == 1 && text.size() > 1 && text[0] == '0' && found == SIZE_MAX) found = i;
        }
    }
    return found;
}

// 1.500 beside 300 in a column: every point of the file may group thousands, as a German table has them. Columns of
// three decimals do not mix them with whole numbers, and 0, 0.500, 1.5 or 1500 speak against it.
bool points_may_group(const std::vector<TableLine>& lines, std::size_t first, char delimiter) {
    struct Column {
        bool points = false, short_numbers = false, long_numbers = false;
    };
    std::vector<Column> columns;
    std::vector<Field> fields;
    std::size_t points = 0;
    for (std::size_t i = first; i < lines.size(); i++) {
        if (!cut_line(lines[i].text, delimiter, &fields)) return false;
        if (columns.size() < fields.size()) columns.resize(fields.size());
        for (std::size_t k = 0; k < fields.size(); k++) {
            std::string_view text = fields[k].text;
            bool point;
            if (!is_plain_number(text, &point)) continue;
            if (point && !looks_like_thousands(text, '.')) return false;
            points += point;
            columns[k].points = columns[k].points || point;
            if (point) continue;
            if (text[0] == '-' || text[0] == '+') text.remove_prefix(1);
            if (!std::all_of(text.begin(), text.end(), is_digit)) return false;
            (text.size() > 3 ? columns[k].long_numbers : columns[k].short_numbers) |= text[0] != '0';
        }
    }
    return points > 1 && std::any_of(columns.begin(), columns.end(), [](const Column& column) {
               return column.points && column.short_numbers && !column.long_numbers;
           });
}

std::string two_ways(std::size_t columns, char delimiter, std::size_t others) {
    return "commas may be decimal (" + counted(columns, "column", "columns") + ", " + delimiter_option(delimiter) +
           ") or stand between columns (" + std::to_string(others) +
           "); one of them has to be chosen: write points in "
           "place of decimal commas, or one delimiter";
}

std::string thousands(char delimiter) {
    return "commas may be decimal or group thousands (1,234); " + delimiter_option(delimiter) +
           " reads them as decimal";
}

// The dialect of lines[first..], by what stands in them and what fits all of them.
class DialectFinder {
public:
    // names: fields of the header when commas part it, 0: no header
    DialectFinder(const std::vector<TableLine>& lines, std::size_t first, std::size_t names)
        : lines_(lines), first_(first), names_(names) {
        for (std::size_t i = first; i < lines.size(); i++) count_marks(lines[i].text, &marks_);
        line = lines[first].number;
    }
    // A complaint about `line`, or empty.
    std::string find() {
        const std::string complaint = find_delimiter();
        const bool has_points = std::any_of(lines_.begin() + static_cast<std::ptrdiff_t>(first_), lines_.end(),
                                            [](const TableLine& row) { return row.text.find('.') != row.text.npos; });
        if (!complaint.empty() || dialect.delimiter == ',' || dialect.decimal_comma || !has_points) return complaint;
        if (!points_may_group(lines_, first_, dialect.delimiter)) return {};
        return "points may be decimal or group thousands (1.234), as whole numbers below 1000 stand beside them: " +
               (dialect.delimiter == 0 ? std::string("--delimiter") : delimiter_option(dialect.delimiter)) +
               " reads them as decimal; numbers are written without signs between thousands";
    }

    Dialect dialect;
    std::string understood;
    std::uint64_t line;

private:
    std::string find_delimiter() {
        const std::size_t count = lines_.size() - first_;
        if (marks_.bar == count) return by('|');
        if (marks_.semicolon == count) return by(';');
        if (marks_.tab == count && !marks_.leading_tab && is_tab_separated(lines_, first_)) return by('\t');
        const bool parts = marks_.semicolon == 0 || (look(',', false).is_even && !look(0, false).consistent);
        if (marks_.comma == count && parts) return by_commas();
        return by_blanks();
    }
    Look look(char delimiter, bool decimal_comma) const { return look_at(lines_, first_, delimiter, decimal_comma); }
    std::string take_decimal(char delimiter) {
        dialect = {delimiter, true};
        understood = "commas read as decimal";
        return {};
    }
    std::string by(char delimiter);
    std::string by_commas();
    std::string by_blanks();

    const std::vector<TableLine>& lines_;
    const std::size_t first_, names_;
    Marks marks_;
};

constexpr const char* both = "points and commas are both decimal here; write numbers in one way";

// A delimiter that stands in every line and in no number.
std::string DialectFinder::by(char delimiter) {
    const Look strict = look(delimiter, true);
    if (strict.broken_digits) {
        line = strict.broken_line;
        return "blanks within numbers (1 234): write them without";
    }
    if (strict.may_be_thousands) return thousands(delimiter);
    if (strict.consistent || (!strict.inner_blanks && marks_.comma == 0)) {
        if (strict.decimal_commas && strict.points) return both;
        if (strict.decimal_commas) return take_decimal(delimiter);
        dialect = {delimiter, false};
        return {};
    }
    const bool mixes = delimiter != '|' && marks_.bare_comma == 0 && look(0, false).consistent;
    dialect = {mixes ? char{0} : delimiter, !mixes && marks_.comma > 0};
    return {};
}

// Commas in every line: between columns, unless numbers have them, too.
std::string DialectFinder::by_commas() {
    const Look strict = look(',', true);  // decimal ones are in quotes
    if (strict.may_be_thousands) return thousands(',');
    if (strict.decimal_commas) return strict.points ? both : take_decimal(',');
    const std::size_t loose = line_of_loose_decimals(lines_, first_);
    if (loose != SIZE_MAX) {
        line = lines_[loose].number;
        return "numbers behind commas begin with zeros, as decimals do: columns are to be held apart by something else "
               "than decimal commas; --delimiter , reads it as it stands";
    }
    if (marks_.blank + marks_.tab > 0) {
        const Look blanks = look(' ', true);
        if (blanks.consistent && blanks.decimal_commas && blanks.width > 1)
            return two_ways(blanks.width, ' ', look(0, false).width);
    }
    const std::size_t count = lines_.size() - first_;
    if (marks_.comma_and_blank == count && marks_.bare_comma == count)
        return "commas with blanks behind and commas without: write points in place of decimal commas; --delimiter , "
               "takes every comma for a delimiter";
    // A comma in every line, and the same number of them: cells may hold blanks (RFC 4180). Numbers alone between all
    // of these marks, in rows that no header counts, are what someone wrote by hand.
    const Look mixed = strict.inner_blanks && names_ != strict.width ? look(0, false) : Look{};
    const bool is_mixed = mixed.width > strict.width && mixed.consistent && !mixed.words;
    if (is_mixed)
        understood = "commas and blanks part columns, " + std::to_string(mixed.width) +
                     " of them; --delimiter ',' takes commas alone";
    dialect = {is_mixed ? char{0} : ',', false};
    return {};
}

// No delimiter but blanks in every line.
std::string DialectFinder::by_blanks() {
    const Look blanks = look(' ', true);
    if (marks_.comma == 0) {
        const bool bars = marks_.bar > 0 && !blanks.consistent;
        dialect = {bars ? '|' : marks_.semicolon > 0 ? char{0} : ' ', false};
        return {};
    }
    dialect = {};
    if (!blanks.consistent) {
        const std::size_t odd = line_of_odd_comma(lines_, first_);
        if (odd == SIZE_MAX || blanks.points) return {};  // numbers with a point have no decimal commas
        line = lines_[odd].number;
        return "a comma between digits where other lines are parted by blanks: a decimal one, or a delimiter? Write "
               "numbers with a point, or say what parts them: --delimiter";
    }
    if (!blanks.decimal_commas) return {};
    const Look mixed = look(0, false);
    if (mixed.consistent) return two_ways(blanks.width, ' ', mixed.width);
    if (blanks.points) return {};
    return blanks.may_be_thousands ? thousands(' ') : take_decimal(' ');
}

}  // namespace

std::string delimiter_option(char delimiter) {
    if (delimiter == '\t') return "--delimiter tab";
    if (delimiter == ' ') return "--delimiter blank";
    return std::string("--delimiter '") + delimiter + "'";
}

std::string find_dialect(const std::vector<TableLine>& lines, std::size_t first, const TableOptions& options,
                         Dialect* dialect, std::string* sentence, std::uint64_t* line) {
    *dialect = {options.delimiter, options.delimiter != 0};
    if (options.delimiter != 0 || first == lines.size()) return {};
    std::vector<Field> names;
    if (first > 0 && !cut_line(lines[first - 1].text, ',', &names)) names.clear();
    DialectFinder finder(lines, first, names.size());
    const std::string complaint = finder.find();
    *dialect = finder.dialect;
    *line = finder.line;
    *sentence = finder.understood;
    return complaint;
}

}  // namespace netmesh::tool
