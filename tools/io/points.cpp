#include "tools/io/points.hpp"

#include "platform/files.hpp"
#include "platform/interrupt.hpp"
#include "tools/io/lines.hpp"

namespace netmesh::tool {

std::string PointCloud::place(std::uint64_t row) const {
    if (row < lines.size()) return "line " + std::to_string(lines[row]);
    return "row " + std::to_string(row + 1);
}

std::string PointCloud::where(std::uint64_t row) const {
    if (row < lines.size()) return name + ":" + std::to_string(lines[row]);
    return name + ": row " + std::to_string(row + 1);
}

std::string ending_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return {};
    std::string ending = path.substr(dot);
    for (char& c : ending) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return ending;
}

std::string shown_name(const std::string& path) { return path == "-" ? "<stdin>" : path; }

Outcome read_content(const std::string& path, std::string* content) {
    std::string why;
    const bool good = path == "-" ? platform::read_stdin(content, &why) : platform::read_file(path, content, &why);
    if (good) return {};
    if (platform::interrupted()) return {Exit::cancelled, "netmesh: cancelled while reading " + shown_name(path)};
    return data_error(shown_name(path) + ": " + why);
}

Outcome read_points(const std::string& path, PointCloud* cloud) {
    *cloud = {};
    cloud->name = shown_name(path);
    std::string content;
    const Outcome read = read_content(path, &content);
    if (!read.good()) return read;
    const std::string ending = path == "-" ? std::string() : ending_of(path);
    if (ending == ".npy") return parse_npy_points(content, cloud);
    if (ending == ".off") return parse_off_points(content, cloud);
    if (ending == ".ply") return parse_ply_points(content, cloud);
    if (ending == ".node") return parse_node_points(content, cloud);
    return parse_text_points(content, cloud);
}

namespace {

std::string columns_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " column" : " columns"); }

}  // namespace

Outcome parse_text_points(std::string_view content, PointCloud* cloud) {
    LineReader reader(content);
    std::string_view line;
    std::vector<double> row;
    bool first_content = true;
    while (reader.next_content(&line)) {
        const bool may_be_header = first_content;
        first_content = false;
        const Complaint complaint = parse_numbers(line, &row);
        if (!complaint.empty()) {
            if (may_be_header && is_header(line)) continue;
            return line_error(cloud->name, reader.number(), complaint);
        }
        if (cloud->dim == 0) {
            if (row.size() < dim_min || row.size() > dim_max) {
                return line_error(cloud->name, reader.number(),
                                  columns_text(row.size()) + "; points have 2 to 6 coordinates");
            }
            cloud->dim = static_cast<std::uint32_t>(row.size());
        } else if (row.size() != cloud->dim) {
            return line_error(cloud->name, reader.number(),
                              columns_text(row.size()) + " where line " + std::to_string(cloud->lines[0]) + " has " +
                                  std::to_string(cloud->dim));
        }
        cloud->coordinates.insert(cloud->coordinates.end(), row.begin(), row.end());
        cloud->lines.push_back(reader.number());
    }
    if (cloud->dim == 0) {
        return line_error(cloud->name, reader.number() == 0 ? 1 : reader.number(), "the input ends without a point");
    }
    return {};
}

}  // namespace netmesh::tool
