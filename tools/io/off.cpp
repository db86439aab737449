// Geomview's OFF: the vertices only. OFF holds 3D points, nOFF says its dimension.
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/points.hpp"

namespace netmesh::tool {

namespace {

struct OffHeader {
    std::uint32_t dim = 3;
    std::uint64_t vertex_count = 0, face_count = 0;
    // Numbers behind the point: normals, colours of three or four, texture coordinates.
    bool normals = false, colours = false, textures = false;

    bool may_have(std::size_t numbers) const {
        const std::size_t least = dim + (normals ? dim : 0) + (colours ? 3 : 0) + (textures ? 2 : 0);
        return numbers == least || (colours && numbers == least + 1);
    }
};

// The keyword at the start of *line, cut off there; false when it is none.
bool take_keyword(std::string_view* line, bool* wide, OffHeader* header) {
    const std::size_t at = line->find("OFF");
    if (at == std::string_view::npos) return false;
    std::string_view prefix = line->substr(0, at);
    *wide = !prefix.empty() && prefix.back() == 'n';
    if (*wide) prefix.remove_suffix(1);
    const auto take = [&](std::string_view piece) {
        const bool there = prefix.substr(0, piece.size()) == piece;
        if (there) prefix.remove_prefix(piece.size());
        return there;
    };
    header->textures = take("ST");
    header->colours = take("C");
    header->normals = take("N");
    line->remove_prefix(at + 3);
    return prefix.empty();
}

// [Ndim] NVertices NFaces [NEdges], on one line or several.
Outcome parse_off_header(LineReader& reader, const PointCloud& cloud, OffHeader* header) {
    std::string_view line;
    if (!reader.next_content(&line)) return line_error(cloud.name, 1, "the input ends without a point");
    const std::string_view first = line;
    bool wide = false;
    if (!take_keyword(&line, &wide, header)) {
        return line_error(
            cloud.name, reader.number(),
            "an OFF file starts with OFF, COFF, NOFF, STOFF or nOFF (4OFF, of homogeneous coordinates, is not read), "
            "not " +
                quoted(first));
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
    header->face_count = static_cast<std::uint64_t>(numbers[wide ? 2 : 1]);
    if (header->vertex_count == 0) return line_error(cloud.name, reader.number(), "no vertices: no point");
    return {};
}

// The faces that the header counts, `N i1 .. iN` and colours, and nothing behind them: else the header's number of
// vertices cannot be trusted.
Outcome check_faces(LineReader& reader, const OffHeader& header, const PointCloud& cloud) {
    std::string_view line;
    std::vector<double> row;
    const std::string counts = "the header speaks of " + counted(header.vertex_count, "vertex", "vertices") + " and " +
                               counted(header.face_count, "face", "faces");
    for (std::uint64_t i = 0; i < header.face_count; i++) {
        if (!reader.next_content(&line))
            return line_error(cloud.name, reader.number(),
                              "the file ends after " + counted(i, "face", "faces") + "; " + counts);
        const Complaint complaint = parse_numbers(line, &row);
        if (!complaint.empty()) return line_error(cloud.name, reader.number(), complaint);
        const bool has_count = is_count(row[0]) && row[0] >= 1 && row[0] < static_cast<double>(row.size());
        if (!has_count)
            return line_error(cloud.name, reader.number(),
                              "not a face, a number of vertices and these; a vertex too many? " + counts);
        for (std::size_t k = 1; k <= static_cast<std::size_t>(row[0]); k++)
            if (!is_count(row[k]) || row[k] >= static_cast<double>(header.vertex_count))
                return line_error(cloud.name, reader.number(),
                                  "a face with vertex " + number_text(row[k]) + "; vertices are numbered from 0 to " +
                                      std::to_string(header.vertex_count - 1),
                                  k + 1);
    }
    if (reader.next_content(&line))
        return line_error(cloud.name, reader.number(), "a line more than the header says: " + counts);
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
        if (!header.may_have(row.size())) {
            return line_error(cloud->name, reader.number(),
                              "a vertex of " + counted(row.size(), "number", "numbers") + " where " +
                                  std::to_string(header.dim) + " are due");
        }
        cloud->coordinates.insert(cloud->coordinates.end(), row.begin(), row.begin() + header.dim);
        cloud->lines.push_back(reader.number());
    }
    return check_faces(reader, header, *cloud);
}

}  // namespace netmesh::tool
