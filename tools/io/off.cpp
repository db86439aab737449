// Geomview's OFF: the vertices only. OFF holds 3D points, nOFF says its dimension.
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/points.hpp"

namespace netmesh::tool {

namespace {

struct OffHeader {
    std::uint32_t dim = 3;
    std::uint64_t vertex_count = 0;
    bool more_columns = false;  // colours, normals or texture coordinates follow the point
};

// The keyword at the start of *line, cut off there; false when it is none.
bool take_keyword(std::string_view* line, bool* wide, OffHeader* header) {
    const std::size_t at = line->find("OFF");
    if (at == std::string_view::npos) return false;
    std::string_view prefix = line->substr(0, at);
    *wide = !prefix.empty() && prefix.back() == 'n';
    if (*wide) prefix.remove_suffix(1);
    for (const std::string_view piece : {std::string_view("ST"), std::string_view("C"), std::string_view("N")}) {
        if (prefix.substr(0, piece.size()) != piece) continue;
        prefix.remove_prefix(piece.size());
        header->more_columns = true;
    }
    line->remove_prefix(at + 3);
    return prefix.empty();
}

// [Ndim] NVertices NFaces [NEdges], on one line or several.
Outcome parse_off_header(LineReader& reader, const PointCloud& cloud, OffHeader* header) {
    std::string_view line;
    if (!reader.next_content(&line)) return line_error(cloud.name, 1, "the input ends without a point");
    bool wide = false;
    if (!take_keyword(&line, &wide, header)) {
        return line_error(cloud.name, reader.number(), "an OFF file starts with OFF or nOFF, not " + quoted(line));
    }
    const std::size_t needed = wide ? 3 : 2;
    std::vector<double> numbers, more;
    for (;;) {
        const Complaint complaint = parse_numbers(line, &more);
        if (!complaint.empty()) return line_error(cloud.name, reader.number(), complaint);
        numbers.insert(numbers.end(), more.begin(), more.end());
        if (numbers.size() >= needed) break;
        if (!reader.next_content(&line)) {
            return line_error(cloud.name, reader.number(), "the file ends before its number of vertices");
        }
    }
    if (numbers.size() > needed + 1) return line_error(cloud.name, reader.number(), "too many numbers in the header");
    for (const double number : numbers) {
        if (!is_count(number)) {
            return line_error(cloud.name, reader.number(), "the header holds a number that is not a count");
        }
    }
    if (wide) {
        if (numbers[0] < dim_min || numbers[0] > dim_max) {
            return line_error(cloud.name, reader.number(),
                              "dimension " + std::to_string(static_cast<std::uint64_t>(numbers[0])) +
                                  "; points have 2 to 6 coordinates");
        }
        header->dim = static_cast<std::uint32_t>(numbers[0]);
    }
    header->vertex_count = static_cast<std::uint64_t>(numbers[wide ? 1 : 0]);
    if (header->vertex_count == 0) return line_error(cloud.name, reader.number(), "no vertices: no point");
    return {};
}

}  // namespace

Outcome parse_off_points(std::string_view content, PointCloud* cloud) {
    if (content.substr(0, 64).find("BINARY") != std::string_view::npos) {
        return line_error(cloud->name, 1, "binary OFF is not read");
    }
    LineReader reader(content);
    OffHeader header;
    const Outcome outcome = parse_off_header(reader, *cloud, &header);
    if (!outcome.good()) return outcome;
    cloud->dim = header.dim;
    std::string_view line;
    std::vector<double> row;
    for (std::uint64_t i = 0; i < header.vertex_count; i++) {
        if (!reader.next_content(&line)) {
            return line_error(cloud->name, reader.number(),
                              "the file ends after " + std::to_string(i) + " of " +
                                  counted(header.vertex_count, "vertex", "vertices"));
        }
        const Complaint complaint = parse_numbers(line, &row);
        if (!complaint.empty()) return line_error(cloud->name, reader.number(), complaint);
        if (row.size() < header.dim || (row.size() > header.dim && !header.more_columns)) {
            return line_error(cloud->name, reader.number(),
                              "a vertex of " + counted(row.size(), "number", "numbers") + " where " +
                                  std::to_string(header.dim) + " are due");
        }
        cloud->coordinates.insert(cloud->coordinates.end(), row.begin(), row.begin() + header.dim);
        cloud->lines.push_back(reader.number());
    }
    return {};
}

}  // namespace netmesh::tool
