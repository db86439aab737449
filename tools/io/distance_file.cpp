#include "tools/io/distance_file.hpp"

#include <algorithm>
#include <optional>

#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

constexpr std::uint64_t points_max = 65536;

struct Row {
    std::uint64_t line;
    std::size_t first, count;  // in numbers
};

std::string count_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " number" : " numbers"); }

std::string flaw_of(double distance) { return distance < 0 ? "a distance is negative: " + number_text(distance) : ""; }

Outcome read_rows(std::string_view content, bool sparse, DistanceFile* file, std::vector<Row>* rows) {
    LineReader reader(content);
    std::string_view line;
    std::vector<double> row;
    bool may_be_header = true;
    std::optional<bool> parted_by_commas;  // or by blanks alone, in all rows of two numbers and more
    while (reader.next_content(&line)) {
        const Complaint complaint = parse_numbers(line, &row);
        if (!complaint.empty()) {
            if (may_be_header && is_header(line)) {
                may_be_header = false;
                continue;
            }
            return line_error(file->place.name, reader.number(), complaint);
        }
        may_be_header = false;
        const auto commas = static_cast<std::size_t>(
            std::count_if(line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }));
        const bool in_one_way = (commas == 0 || commas + 1 == row.size()) &&
                                (row.size() == 1 || parted_by_commas.value_or(commas > 0) == (commas > 0));
        if (!in_one_way)
            return line_error(file->place.name, reader.number(),
                              "commas part some numbers and blanks others; write decimals with a point");
        if (row.size() > 1) parted_by_commas = commas > 0;
        for (std::size_t f = sparse ? 2 : 0; f < row.size(); f++) {
            const std::string flaw = flaw_of(row[f]);
            if (!flaw.empty())
                return line_error(file->place.name, reader.number(), "field " + std::to_string(f + 1) + ": " + flaw);
        }
        rows->push_back({reader.number(), file->numbers.size(), row.size()});
        file->numbers.insert(file->numbers.end(), row.begin(), row.end());
    }
    if (rows->empty())
        return line_error(file->place.name, reader.number() == 0 ? 1 : reader.number(),
                          "the input ends without a distance");
    return {};
}

// Where row r must have `due` numbers.
Outcome wrong_count(const DistanceFile& file, const Row& row, std::size_t due, const char* what) {
    return line_error(file.place.name, row.line,
                      count_text(row.count) + " where " + what + " has " + std::to_string(due));
}

Outcome take_square(const std::vector<Row>& rows, DistanceFile* file) {
    for (const Row& row : rows) {
        if (row.count != rows[0].count) return wrong_count(*file, row, rows[0].count, "the first row of the matrix");
        file->place.lines.push_back(row.line);
    }
    if (rows.size() != rows[0].count)
        return line_error(file->place.name, rows.back().line,
                          "a matrix of " + counted(rows.size(), "row", "rows") + " and " + counted(rows[0].count, "column", "columns") + "; one of distances is square");
    file->layout = NETMESH_DISTANCES_FULL;
    file->points = rows.size();
    return {};
}

// The first row has one number: the distance of the second point to the first one, or of the first one to itself.
Outcome take_triangle(const std::vector<Row>& rows, DistanceFile* file) {
    const bool has_diagonal =
        rows.back().count == rows.size() && file->numbers[0] == 0 && (rows.size() == 1 || rows[1].count == 2);
    std::vector<double> lower;
    bool ends_in_zeros = has_diagonal;
    for (const Row& row : rows) ends_in_zeros = ends_in_zeros && file->numbers[row.first + row.count - 1] == 0;
    if (!ends_in_zeros) file->place.lines.push_back(rows[0].line);  // the first point has no row
    for (std::size_t r = 0; r < rows.size(); r++) {
        if (rows[r].count != r + 1) return wrong_count(*file, rows[r], r + 1, "a lower triangle");
        const std::size_t own = ends_in_zeros ? 1 : 0;
        const auto first = file->numbers.begin() + static_cast<std::ptrdiff_t>(rows[r].first);
        lower.insert(lower.end(), first, first + static_cast<std::ptrdiff_t>(rows[r].count - own));
        file->place.lines.push_back(rows[r].line);
    }
    file->numbers = std::move(lower);
    file->layout = NETMESH_DISTANCES_LOWER;
    file->points = file->place.lines.size();
    return {};
}

Outcome take_entries(const std::vector<Row>& rows, DistanceFile* file) {
    file->layout = NETMESH_DISTANCES_SPARSE;
    for (const Row& row : rows) {
        if (row.count != 3) return wrong_count(*file, row, 3, "an entry, `i j d`,");
        const double* const field = file->numbers.data() + row.first;
        for (int f = 0; f < 2; f++) {
            if (is_count(field[f]) && field[f] < static_cast<double>(points_max)) continue;
            return line_error(file->place.name, row.line,
                              "field " + std::to_string(f + 1) + ": " + number_text(field[f]) +
                                  "; points are numbered from 0, to 65535");
        }
        const netmesh_distance_entry entry = {static_cast<std::uint32_t>(field[0]),
                                              static_cast<std::uint32_t>(field[1]), field[2]};
        file->entries.push_back(entry);
        file->points = std::max<std::uint64_t>(file->points, std::max(entry.i, entry.j) + std::uint64_t{1});
        file->place.lines.push_back(row.line);
    }
    file->numbers.clear();
    return {};
}

Outcome take_rows(const std::vector<Row>& rows, bool sparse, DistanceFile* file) {
    if (sparse) return take_entries(rows, file);
    const bool is_triangle = rows[0].count == 1 && (rows.size() > 1 || file->numbers[0] != 0);
    return is_triangle ? take_triangle(rows, file) : take_square(rows, file);
}

}  // namespace

std::string DistanceFile::where(std::uint64_t a, std::uint64_t b) const {
    if (layout == NETMESH_DISTANCES_SPARSE) {
        const std::string at = place.where(a);
        return a == b ? at : at + " and " + place.place(b);
    }
    return place.where(a) + ", field " + std::to_string(b + 1);
}

Outcome parse_distances(std::string_view content, bool sparse, DistanceFile* file) {
    std::vector<Row> rows;
    const Outcome outcome = read_rows(content, sparse, file, &rows);
    return outcome.good() ? take_rows(rows, sparse, file) : outcome;
}

Outcome read_distances(const std::string& path, bool sparse, DistanceFile* file) {
    *file = {};
    file->place.name = shown_name(path);
    std::string content;
    const Outcome read = read_content(path, &content);
    if (!read.good()) return read;
    if (path != "-" && ending_of(path) == ".npy")
        return data_error(file->place.name + ": distances are read from text: numpy.savetxt writes it");
    return parse_distances(content, sparse, file);
}

}  // namespace netmesh::tool
