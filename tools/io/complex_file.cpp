#include "tools/io/complex_file.hpp"

#include <algorithm>

#include "netmesh.h"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

Complaint add_simplex(const std::vector<double>& numbers, SimplexFile* file) {
    if (numbers.size() < 2) return "a line is: a simplex's vertices, then its value";
    if (numbers.size() > NETMESH_DEGREE_MAX + 2) {
        return counted(numbers.size() - 1, "vertex", "vertices") + "; a simplex has at most 32";
    }
    for (std::size_t i = 0; i + 1 < numbers.size(); i++) {
        if (!is_count(numbers[i]) || numbers[i] >= 4294967296.0) {
            return number_text(numbers[i]) + " is not a vertex: a whole number from 0 to 2^32 - 1";
        }
        file->vertices.push_back(static_cast<std::uint32_t>(numbers[i]));
    }
    file->starts.push_back(file->vertices.size());
    file->values.push_back(numbers.back());
    return {};
}

}  // namespace

Outcome parse_simplices(std::string_view content, SimplexFile* file) {
    LineReader reader(content);
    std::string_view line;
    std::vector<double> numbers;
    while (reader.next_content(&line)) {
        Complaint complaint = parse_numbers(line, &numbers);
        if (complaint.empty()) complaint = add_simplex(numbers, file);
        if (!complaint.empty()) return line_error(file->lines.name, reader.number(), complaint);
        file->lines.lines.push_back(reader.number());
    }
    if (file->count() > 0) return {};
    return line_error(file->lines.name, std::max<std::uint64_t>(reader.number(), 1),
                      "the input ends without a simplex");
}

Outcome parse_values(std::string_view content, const SimplexFile& complex, ValueFile* file) {
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < complex.count(); i++)
        vertices += complex.starts[i + 1] - complex.starts[i] == 1 ? 1 : 0;
    LineReader reader(content);
    std::string_view line;
    std::vector<double> numbers;
    while (reader.next_content(&line)) {
        Complaint complaint = parse_numbers(line, &numbers);
        const bool first = file->count() == 0;
        const bool fits =
            first ? numbers.size() == complex.count() || numbers.size() == vertices : numbers.size() == file->width;
        if (complaint.empty() && !fits) {
            complaint = counted(numbers.size(), "value", "values") + "; ";
            complaint += first ? complex.lines.name + " has " + counted(complex.count(), "simplex", "simplices") +
                                     ", " + grouped_text(vertices) + " of them vertices"
                               : "line " + std::to_string(file->lines.lines[0]) + " has " + grouped_text(file->width);
        }
        if (!complaint.empty()) return line_error(file->lines.name, reader.number(), complaint);
        file->width = numbers.size();
        file->values.insert(file->values.end(), numbers.begin(), numbers.end());
        file->lines.lines.push_back(reader.number());
    }
    file->by_vertex = file->width != complex.count();
    if (file->count() > 0) return {};
    return line_error(file->lines.name, std::max<std::uint64_t>(reader.number(), 1),
                      "the input ends without a vector of values");
}

std::string simplex_text(const SimplexFile& file, std::uint64_t i, std::uint64_t skip) {
    std::vector<std::uint32_t> sorted(file.vertices.begin() + static_cast<std::ptrdiff_t>(file.starts[i]),
                                      file.vertices.begin() + static_cast<std::ptrdiff_t>(file.starts[i + 1]));
    std::sort(sorted.begin(), sorted.end());
    std::string text;
    for (std::size_t n = 0; n < sorted.size(); n++) {
        if (n != skip) text += (text.empty() ? "" : " ") + std::to_string(sorted[n]);
    }
    return text;
}

}  // namespace netmesh::tool
