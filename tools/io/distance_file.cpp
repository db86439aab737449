#include "tools/io/distance_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "platform/memory.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/plain_rows.hpp"
#include "tools/io/table_lines.hpp"

namespace netmesh::tool {

namespace {

constexpr std::uint64_t points_max = 65536, sparse_points_max = std::uint64_t{1} << 26;

struct DistanceRow {
    std::uint64_t line;        // 0: of an array, which has none
    std::size_t first, count;  // in numbers
};
using Rows = std::vector<DistanceRow>;

// The first line, where it holds names.
struct Header {
    std::uint64_t line = 0;          // 0: there is none
    std::vector<std::string> names;  // without an empty first field
    bool has_corner = false;         // its first field is empty: each row begins with a name, which may be a number
    bool has_row_names = false;
    std::string first_row;  // name of the first row
};

std::string count_text(std::size_t count) { return counted(count, "number", "numbers"); }

std::string flaw_of(double distance) { return distance < 0 ? "a distance is negative: " + number_text(distance) : ""; }

void add_note(const std::string& sentence, DistanceFile* file) {
    file->note += (file->note.empty() ? "" : "; ") + sentence;
}

Outcome wrong(const DistanceFile& file, const Rows& rows, std::size_t r, const std::string& complaint,
              std::size_t field = 0) {
    const std::string text = (field > 0 ? "field " + std::to_string(field) + ": " : "") + complaint;
    if (rows[r].line > 0) return line_error(file.place.name, rows[r].line, text, field);
    return file_error(file.place.name, "row " + std::to_string(r + 1) + ": " + text);
}

// What the rows hold is no distance. Of a square this is for even_out to say.
Outcome check_numbers(const DistanceFile& file, const Rows& rows, bool sparse) {
    for (std::size_t r = 0; r < rows.size(); r++)
        for (std::size_t f = sparse ? 2 : 0; f < rows[r].count; f++) {
            const std::string flaw = flaw_of(file.numbers[rows[r].first + f]);
            if (!flaw.empty()) return wrong(file, rows, r, flaw, f + 1);
        }
    return {};
}

// ripser's own files have one behind the last number of a row.
std::string_view without_last_comma(std::string_view line) {
    std::size_t end = line.size();
    while (end > 0 && (line[end - 1] == ' ' || line[end - 1] == '\t' || line[end - 1] == '\r')) --end;
    const bool is_behind = end > 1 && (line[end - 1] == ',' || line[end - 1] == ';');
    return is_behind ? line.substr(0, end - 1) : line;
}

// A row without its name, which may hold blanks where something else parts fields; empty where there is nothing else.
std::string_view behind_name(std::string_view line, std::string* name) {
    const std::size_t from = line[0] == '"' ? line.find('"', 1) : 0;
    std::size_t end = line.find_first_of(",;\t", from);
    if (end == std::string_view::npos) end = line.find(' ', from);
    if (end == std::string_view::npos) return {};
    std::string_view text = without_blanks(line.substr(0, end));
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    *name = std::string(text);
    return line.substr(end + 1);
}

// False where the line holds no names. A tab in front of it is an empty first field, too.
bool read_header(std::string_view line, bool has_tab, Header* header) {
    const auto parted_by = [&](char c) { return line.find(c) != std::string_view::npos; };
    const char delimiter = parted_by(',') ? ',' : parted_by(';') ? ';' : parted_by('\t') ? '\t' : ' ';
    std::vector<Field> fields;
    if (!cut_line(line, delimiter, &fields)) return false;
    const bool is_first_empty = fields.size() > 1 && fields[0].text.empty();
    if (!is_first_empty && !is_header(line)) return false;
    header->has_corner = is_first_empty || has_tab;
    for (std::size_t i = is_first_empty ? 1 : 0; i < fields.size(); i++) header->names.emplace_back(fields[i].text);
    return true;
}

// So many numbers at most, if one character parts them.
std::size_t count_fields(std::string_view content) {
    return 1 + static_cast<std::size_t>(std::count_if(content.begin(), content.end(), [](char c) {
               return (c >= 0 && c <= ' ') || c == ',' || c == ';';
           }));
}

// Gives the memory of a text back while it is read: the numbers are as large.
class TextReleaser {
public:
    explicit TextReleaser(std::string* text) : text_(text) {}
    void pass(std::size_t offset) {
        constexpr std::size_t piece = std::size_t{1} << 20;
        if (text_ == nullptr || offset - released_ < piece) return;
        platform::forget_pages(text_->data() + released_, offset - released_);
        released_ = offset;
    }

private:
    std::string* text_;
    std::size_t released_ = 0;
};

// What could make numbers of a line that has words or empty cells, too.
std::string remedy_for_line(const Header& header, const Rows& rows, std::string_view line) {
    if (line.find(",,") != std::string_view::npos || line.find(";;") != std::string_view::npos ||
        line.find_first_of(",;") == 0 || line.find_last_of(",;") + 1 == line.size())
        return "; cells that a triangle does not have are left out, or 0";
    std::string name;
    std::vector<double> row;
    const bool may_be_name = header.line == 0 && is_letter(line[0]) && !behind_name(line, &name).empty() &&
                             parse_numbers(behind_name(line, &name), &row, true).empty();
    if (may_be_name && rows.size() < 2)
        return "; names that rows begin with are read below a header of names, as in ,a,b,c";
    return {};
}

// *released: the content itself, where it is not needed afterwards, or null.
Outcome read_rows(std::string_view content, std::string* released, DistanceFile* file, Rows* rows, Header* header) {
    std::string plain, note;
    std::uint64_t fault_line = 1;
    const std::string unclear = make_plain(content, &plain, &note, &fault_line);
    if (!unclear.empty()) return line_error(file->place.name, fault_line, unclear);
    if (!note.empty()) add_note(note, file);
    if (!plain.empty()) content = plain;
    LineReader reader(content, plain.empty());
    TextReleaser releaser(plain.empty() ? released : &plain);
    file->numbers.reserve(count_fields(content));
    std::string_view line;
    std::vector<double> row;
    std::optional<bool> parted_by_commas;  // or by blanks alone, in all rows of two numbers and more
    while (reader.next_content(&line)) {
        const bool has_tab = line.data() != content.data() && line.data()[-1] == '\t';
        line = without_last_comma(line);
        if (rows->empty() && header->line == 0 && line.size() < 6 && starts(lower_case(line), "sep=")) continue;
        if (rows->empty() && header->line == 0 && read_header(line, has_tab, header)) {
            header->line = reader.number();
            add_note("skipped header " + quoted(line), file);
            continue;
        }
        Complaint complaint = parse_numbers(line, &row, true);
        const bool has_name_of_digits =
            complaint.empty() && header->has_corner &&
            (rows->empty() ? row.size() == header->names.size() + 1 : header->has_row_names);
        bool has_name = has_name_of_digits;
        std::string name;
        if (has_name_of_digits) {
            if (row.size() == 1)
                return line_error(file->place.name, reader.number(), "a row that has a name and no distance");
            behind_name(line, &name);
        } else if (!complaint.empty() && header->line > 0) {
            const std::string_view rest = behind_name(line, &name);
            if (!rest.empty() && parse_numbers(rest, &row, true).empty()) {
                complaint.clear();
                has_name = true;
                line = rest;
            }
        }
        if (!complaint.empty())
            return line_error(file->place.name, reader.number(), complaint + remedy_for_line(*header, *rows, line));
        if (has_name && !header->has_row_names) {
            add_note("left out the names that rows begin with", file);
            header->has_row_names = true;
            if (rows->empty()) header->first_row = name;
        }
        const auto commas = static_cast<std::size_t>(
            std::count_if(line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }));
        const bool in_one_way = (commas == 0 || commas + 1 == row.size()) &&
                                (row.size() == 1 || parted_by_commas.value_or(commas > 0) == (commas > 0));
        if (!in_one_way)
            return line_error(file->place.name, reader.number(),
                              "commas part some numbers and blanks others; write decimals with a point");
        if (row.size() > 1) parted_by_commas = commas > 0;
        if (has_name_of_digits) row.erase(row.begin());
        rows->push_back({reader.number(), file->numbers.size(), row.size()});
        file->numbers.insert(file->numbers.end(), row.begin(), row.end());
        releaser.pass(reader.offset());
    }
    if (rows->empty())
        return line_error(file->place.name, reader.number() == 0 ? 1 : reader.number(),
                          "the input ends without a distance");
    return {};
}

// A first row that may be something else: how many points there are, or the numbers of columns as pandas writes them.
std::string remedy_for_first_row(const DistanceFile& file, const Rows& rows) {
    if (rows.size() < 4 || rows[0].line == 0) return {};
    const std::size_t n = rows.size() - 1;
    bool are_numbers = rows[0].count == n, is_count = rows[0].count < 3;
    for (std::size_t k = 0; k < rows[0].count; k++) {
        are_numbers = are_numbers && file.numbers[rows[0].first + k] == static_cast<double>(k);
        is_count = is_count && file.numbers[rows[0].first + k] == static_cast<double>(n);
    }
    if (!are_numbers && !is_count) return {};
    return "; if line " + std::to_string(rows[0].line) +
           (are_numbers ? " is the numbers of columns" : " says how many points there are") + ", put # in front of it";
}

// Rows of three of which two are numbers of points.
std::string remedy_for_entries(const DistanceFile& file, const Rows& rows) {
    for (const DistanceRow& row : rows)
        if (row.count != 3 || !is_count(file.numbers[row.first]) || !is_count(file.numbers[row.first + 1])) return {};
    return "; lines i j distance are read with --sparse";
}

// Where row r must have `due` numbers.
Outcome wrong_count(const DistanceFile& file, const Rows& rows, std::size_t r, std::size_t due, const char* what) {
    return wrong(file, rows, r,
                 count_text(rows[r].count) + " where " + what + " has " + std::to_string(due) +
                     remedy_for_first_row(file, rows));
}

void add_line(const DistanceRow& row, DistanceFile* file) {
    if (row.line > 0) file->place.lines.push_back(row.line);
}

void set_lower(std::uint64_t points, DistanceFile* file) {
    file->layout = NETMESH_DISTANCES_LOWER;
    file->points = points;
}

// numpy's tril and triu: zeros on one side of the diagonal alone.
void take_half(DistanceFile* file) {
    const std::size_t n = file->points;
    bool upper = false, lower = false, diagonal = false;  // is something else than 0 there?
    for (std::size_t i = 0; i < n; i++)
        for (std::size_t j = 0; j < n; j++) (i < j ? upper : i > j ? lower : diagonal) |= file->numbers[i * n + j] != 0;
    if (diagonal || upper == lower) return;
    for (std::size_t i = 0; upper && i < n; i++)
        for (std::size_t j = 0; j < i; j++) file->numbers[i * n + j] = file->numbers[j * n + i];
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n; i++)
        for (std::size_t j = 0; j < i; j++) file->numbers[kept++] = file->numbers[i * n + j];
    file->numbers.resize(kept);
    add_note(lower ? "read as a lower triangle: all above its diagonal is 0"
                   : "read as an upper triangle: all below its diagonal is 0",
             file);
    set_lower(n, file);
}

// Products of matrices leave rounding noise: two sides that differ in the last digits, a diagonal that is not quite 0.
// Up to this share of the largest distance that is taken for 0, and said. What is beyond it is refused with both
// values.
constexpr double noise_share = 0x1p-36;

Outcome even_out(const Rows& rows, DistanceFile* file) {
    const std::size_t n = file->points;
    std::vector<double>& d = file->numbers;
    double largest = 0, moved = 0;
    for (const double x : d) largest = std::isfinite(x) ? std::max(largest, std::abs(x)) : largest;
    const double noise = largest * noise_share;
    bool are_ones = true;
    for (std::size_t i = 0; i < n; i++) are_ones = are_ones && std::abs(d[i * n + i] - 1) <= 1e-9;
    const std::string remedy = are_ones ? "; of similarities S write 1 - S" : remedy_for_entries(*file, rows);
    for (std::size_t i = 0; i < n; i++) {
        double& own = d[i * n + i];
        if (std::abs(own) > noise)
            return wrong(*file, rows, i,
                         "the distance of a point to itself is " + number_text(own) + ", not 0" + remedy, i + 1);
        moved = std::max(moved, std::abs(own));
        own = 0;
        for (std::size_t j = 0; j < i; j++) {
            double &low = d[i * n + j], &high = d[j * n + i];
            if (low < -noise) return wrong(*file, rows, i, flaw_of(low), j + 1);
            if (high < -noise) return wrong(*file, rows, j, flaw_of(high), i + 1);
            const double off = low == high ? 0 : std::abs(low - high);
            if (!(off <= noise))
                return wrong(*file, rows, i,
                             "the distance is " + number_text(low) + ", and " + number_text(high) +
                                 " the other way round; (D + D.T) / 2 makes a matrix symmetric",
                             j + 1);
            const double mean = off == 0 ? low : low / 2 + high / 2;
            moved = std::max({moved, off / 2, -mean});
            low = high = mean > 0 ? mean : 0;
        }
    }
    if (moved > 0)
        add_note("took rounding noise off the matrix: distances moved by at most " + number_text(moved), file);
    return {};
}

// More rows than columns, of which there are as many as points have coordinates.
std::string remedy_for_points(const DistanceFile& file, const Rows& rows) {
    const bool are_points = rows.size() > rows[0].count && rows[0].count <= NETMESH_DIM_MAX;
    if (!are_points || !remedy_for_entries(file, rows).empty() || !remedy_for_first_row(file, rows).empty()) return {};
    return "; points, as these may be, are read without --distances";
}

Outcome take_square(const Rows& rows, DistanceFile* file) {
    for (std::size_t r = 0; r < rows.size(); r++) {
        if (rows[r].count != rows[0].count)
            return wrong_count(*file, rows, r, rows[0].count, "the first row of the matrix");
        add_line(rows[r], file);
    }
    if (rows.size() != rows[0].count)
        return wrong(*file, rows, rows.size() - 1,
                     "a matrix of " + counted(rows.size(), "row", "rows") + " and " +
                         counted(rows[0].count, "column", "columns") + "; one of distances is square" +
                         remedy_for_first_row(*file, rows) + remedy_for_entries(*file, rows) +
                         remedy_for_points(*file, rows));
    file->layout = NETMESH_DISTANCES_FULL;
    file->points = rows.size();
    take_half(file);
    return file->layout == NETMESH_DISTANCES_FULL ? even_out(rows, file) : check_numbers(*file, rows, false);
}

// The first row has one number: the distance of the second point to the first one, or of the first one to itself. Rows
// that all end in 0 have their diagonal: without one each point would be at the place of the one before it.
Outcome take_triangle(const Rows& rows, DistanceFile* file) {
    bool has_diagonal = rows.size() > 1, all_zero = true;
    for (const DistanceRow& row : rows) has_diagonal = has_diagonal && file->numbers[row.first + row.count - 1] == 0;
    for (const double number : file->numbers) all_zero = all_zero && number == 0;
    for (std::size_t r = 0; r < rows.size(); r++)
        if (rows[r].count != r + 1) return wrong_count(*file, rows, r, r + 1, "a lower triangle");
    if (all_zero)
        return wrong(*file, rows, 0, "a lower triangle of zeros may have its diagonal or not; write the whole matrix");
    if (!has_diagonal) add_line(rows[0], file);  // the first point has no row
    std::size_t kept = 0;
    for (const DistanceRow& row : rows) {
        for (std::size_t j = 0; j < row.count - (has_diagonal ? 1 : 0); j++)
            file->numbers[kept++] = file->numbers[row.first + j];
        add_line(row, file);
    }
    file->numbers.resize(kept);
    if (has_diagonal) add_note("read as a lower triangle with its diagonal", file);
    set_lower(rows.size() + (has_diagonal ? 0 : 1), file);
    return {};
}

// Rows that get shorter by one, each of the distances to the points behind; with 0 in front of all of them or not.
bool is_upper_triangle(const Rows& rows) {
    for (std::size_t r = 0; r < rows.size(); r++)
        if (rows[r].count != rows.size() - r) return false;
    return rows.size() > 1;
}

Outcome take_upper(const Rows& rows, DistanceFile* file) {
    bool has_diagonal = true;
    for (const DistanceRow& row : rows) has_diagonal = has_diagonal && file->numbers[row.first] == 0;
    if (has_diagonal && std::all_of(file->numbers.begin(), file->numbers.end(), [](double d) { return d == 0; }))
        return wrong(*file, rows, 0, "an upper triangle of zeros may have its diagonal or not; write the whole matrix");
    const std::size_t n = rows.size() + (has_diagonal ? 0 : 1), skipped = has_diagonal ? 1 : 0;
    std::vector<double> lower;
    for (std::size_t i = 0; i < n; i++)
        for (std::size_t j = 0; j < i; j++) lower.push_back(file->numbers[rows[j].first + skipped + i - j - 1]);
    add_note(has_diagonal ? "read as an upper triangle with its diagonal" : "read as an upper triangle", file);
    file->numbers = std::move(lower);
    set_lower(n, file);
    return {};
}

// The upper triangle row by row.
Outcome take_condensed(DistanceFile* file) {
    const std::uint64_t count = file->numbers.size();
    std::uint64_t n = 1;
    while (n * (n - 1) / 2 < count && n <= 2 * points_max) n++;
    if (n * (n - 1) / 2 != count)
        return file_error(file->place.name, "an array of " + counted(count, "number", "numbers") +
                                                "; one axis of distances of n points has n (n - 1) / 2");
    std::vector<double> lower;
    lower.reserve(count);
    for (std::uint64_t i = 0; i < n; i++)
        for (std::uint64_t j = 0; j < i; j++) lower.push_back(file->numbers[n * j - j * (j + 1) / 2 + i - j - 1]);
    add_note("read as the upper triangle row by row, as scipy's pdist and R's dist have it", file);
    file->numbers = std::move(lower);
    set_lower(n, file);
    return {};
}

Outcome take_entries(const Rows& rows, DistanceFile* file) {
    file->layout = NETMESH_DISTANCES_SPARSE;
    for (std::size_t r = 0; r < rows.size(); r++) {
        if (rows[r].count != 3) return wrong_count(*file, rows, r, 3, "an entry, `i j d`,");
        const double* const field = file->numbers.data() + rows[r].first;
        for (std::size_t f = 0; f < 2; f++) {
            if (is_count(field[f]) && field[f] < static_cast<double>(sparse_points_max)) continue;
            return wrong(*file, rows, r, number_text(field[f]) + "; points are numbered from 0, to 67108863", f + 1);
        }
        const netmesh_distance_entry entry = {static_cast<std::uint32_t>(field[0]),
                                              static_cast<std::uint32_t>(field[1]), field[2]};
        file->entries.push_back(entry);
        file->points = std::max<std::uint64_t>(file->points, std::max(entry.i, entry.j) + std::uint64_t{1});
        add_line(rows[r], file);
    }
    file->numbers.clear();
    const auto is_at_0 = [](const netmesh_distance_entry& entry) { return entry.i == 0 || entry.j == 0; };
    if (std::none_of(file->entries.begin(), file->entries.end(), is_at_0))
        add_note("point 0 is in no entry, and stays alone; points are numbered from 0", file);
    return {};
}

// A header that names more or fewer points than there are: rows are missing, or they are not what they seem.
Outcome check_header(const Header& header, const Rows& rows, const DistanceFile& file) {
    const std::size_t count = header.names.size();
    if (header.line == 0 || count == file.points) return {};
    const bool names_their_column = header.has_row_names && !header.has_corner && count == file.points + 1;
    // R prints a `dist` so: columns a and b, rows b and c.
    const bool leaves_out_last =
        header.has_row_names && count == rows.size() && count + 1 == file.points && header.names[0] != header.first_row;
    if (names_their_column || leaves_out_last) return {};
    return line_error(file.place.name, header.line,
                      "the header names " + counted(count, "point", "points") + ", the rows are of " +
                          grouped_text(file.points) +
                          "; take out the header and the names that rows begin with, or put # in front of this line if "
                          "it is no header");
}

Outcome take_rows(const Rows& rows, const Header& header, bool sparse, DistanceFile* file) {
    const auto all_have = [&](std::size_t count) {
        return std::all_of(rows.begin(), rows.end(), [&](const DistanceRow& row) { return row.count == count; });
    };
    const bool is_square = !sparse && all_have(rows.size()) && (rows.size() > 1 || file->numbers[0] == 0);
    // Of numbers in rows of one length, but no square, that comes first: points may be negative.
    const bool is_oblong = !sparse && !is_square && rows.size() > 1 && rows[0].count > 1 && all_have(rows[0].count);
    Outcome outcome = is_square || is_oblong ? Outcome{} : check_numbers(*file, rows, sparse);
    if (!outcome.good()) return outcome;
    if (sparse) return take_entries(rows, file);
    if (header.line == 0 && !is_square && is_upper_triangle(rows)) return take_upper(rows, file);
    const bool is_line = rows.size() == 1 && rows[0].count > 2, is_column = rows.size() > 2 && all_have(1);
    if (header.line == 0 && (is_line || is_column)) return take_condensed(file);
    const bool is_triangle = rows[0].count == 1 && (rows.size() > 1 || file->numbers[0] != 0);
    outcome = is_triangle ? take_triangle(rows, file) : take_square(rows, file);
    return outcome.good() ? check_header(header, rows, *file) : outcome;
}

}  // namespace

std::string DistanceFile::where(std::uint64_t a, std::uint64_t b) const {
    if (layout == NETMESH_DISTANCES_SPARSE) {
        const std::string at = place.where(a);
        return a == b ? at : at + " and " + place.place(b);
    }
    return place.where(a) + ", field " + std::to_string(b + 1);
}

Outcome DistanceFile::fault(std::uint64_t a, std::uint64_t b, const std::string& complaint) const {
    const bool has_line = a < place.lines.size();
    const std::uint64_t field = layout == NETMESH_DISTANCES_SPARSE ? 0 : b + 1;
    return {Exit::data, where(a, b) + ": " + complaint, place.name, has_line ? place.lines[a] : 0,
            has_line ? field : 0};
}

Outcome parse_distances(std::string_view content, bool sparse, DistanceFile* file) {
    Rows rows;
    Header header;
    const Outcome outcome = read_rows(content, nullptr, file, &rows, &header);
    return outcome.good() ? take_rows(rows, header, sparse, file) : outcome;
}

Outcome take_distances(Table table, bool sparse, DistanceFile* file) {
    const std::size_t height = table.rows();
    file->place.name = table.name;
    file->note = table.note;
    file->numbers = std::move(table.values);
    Rows rows;
    for (std::size_t r = 0; r < height; r++) rows.push_back({0, r * table.width, table.width});
    if (table.width != 1 || height == 1 || sparse) return take_rows(rows, {}, sparse, file);
    const Outcome outcome = check_numbers(*file, rows, false);
    return outcome.good() ? take_condensed(file) : outcome;
}

Outcome read_distances(const std::string& path, bool sparse, DistanceFile* file) {
    *file = {};
    Table table;
    std::string text;
    Outcome outcome = read_numbers(path, &table, &text);
    if (!outcome.good()) return outcome;
    if (table.width > 0) return take_distances(std::move(table), sparse, file);
    file->place.name = table.name;
    Rows rows;
    Header header;
    outcome = read_rows(text, &text, file, &rows, &header);
    return outcome.good() ? take_rows(rows, header, sparse, file) : outcome;
}

}  // namespace netmesh::tool
