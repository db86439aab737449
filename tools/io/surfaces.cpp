// Vertices of surfaces: .obj and .stl.
#include <array>
#include <cmath>
#include <cstring>
#include <set>

#include "tools/io/characters.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/points.hpp"

namespace netmesh::tool {

namespace {

// A vertex for each corner of a triangle: the same one in many of them.
class Corners {
public:
    explicit Corners(PointCloud* cloud) : cloud_(cloud) { cloud_->dim = 3; }
    // Whether it is new.
    bool add(const std::array<double, 3>& corner) {
        if (!seen_.insert(corner).second) return false;
        cloud_->coordinates.insert(cloud_->coordinates.end(), corner.begin(), corner.end());
        return true;
    }
    void note(std::uint64_t triangles) {
        cloud_->note = "read as the " + std::to_string(cloud_->rows()) + " different corners of " +
                       std::to_string(triangles) + (triangles == 1 ? " triangle" : " triangles");
    }

private:
    PointCloud* cloud_;
    std::set<std::array<double, 3>> seen_;
};

constexpr std::size_t stl_head = 84, stl_triangle = 50;

std::uint64_t binary_stl_count(std::string_view content) {
    std::uint64_t count = 0;
    for (unsigned i = 4; i-- > 0;) count = count << 8 | static_cast<unsigned char>(content[80 + i]);
    return count;
}

Outcome parse_binary_stl(std::string_view content, PointCloud* cloud) {
    Corners corners(cloud);
    const std::uint64_t count = binary_stl_count(content);
    if (count == 0) return file_error(cloud->name, "no triangle: no point");
    for (std::uint64_t i = 0; i < count; i++) {
        for (unsigned k = 0; k < 3; k++) {
            std::array<double, 3> corner;
            for (unsigned c = 0; c < 3; c++) {
                const std::size_t at = stl_head + i * stl_triangle + 12 + 12 * k + 4 * c;
                std::uint32_t bits = 0;
                for (unsigned b = 4; b-- > 0;) bits = bits << 8 | static_cast<unsigned char>(content[at + b]);
                float value;
                std::memcpy(&value, &bits, sizeof value);
                if (!std::isfinite(value))
                    return file_error(cloud->name, "triangle " + std::to_string(i + 1) + " (byte " +
                                                       std::to_string(at) +
                                                       "): " + not_finite(std::isnan(value) ? "nan" : "inf"));
                corner[c] = static_cast<double>(value) + 0.0;
            }
            corners.add(corner);
        }
    }
    corners.note(count);
    return {};
}

}  // namespace

bool is_binary_stl(std::string_view content) {
    return content.size() >= stl_head && binary_stl_count(content) == (content.size() - stl_head) / stl_triangle &&
           (content.size() - stl_head) % stl_triangle == 0;
}

Outcome parse_stl_points(std::string_view content, PointCloud* cloud) {
    if (is_binary_stl(content)) return parse_binary_stl(content, cloud);
    if (!starts(content, "solid") || content.find('\0') != std::string_view::npos)
        return file_error(cloud->name,
                          "neither a binary STL, whose size its number of triangles tells (bytes 80 to 83), nor one "
                          "in text, which starts with solid; was it cut off?");
    Corners corners(cloud);
    LineReader reader(content, false);
    std::string_view line;
    std::uint64_t count = 0;
    bool ended = false;
    while (reader.next_content(&line)) {
        ended = ended || starts(line, "endsolid");
        if (!starts(line, "vertex")) continue;
        const std::vector<std::string_view> words = split_blanks(line);
        if (words.size() != 4)
            return line_error(cloud->name, reader.number(), "not `vertex X Y Z`; was the file cut off?");
        std::array<double, 3> corner;
        for (unsigned c = 0; c < 3; c++)
            if (!parse_finite(std::string(words[c + 1]), &corner[c]))
                return line_error(cloud->name, reader.number(), not_a_number(words[c + 1]));
        count++;
        if (corners.add(corner)) cloud->lines.push_back(reader.number());
    }
    if (cloud->rows() == 0) return line_error(cloud->name, reader.number(), "no line vertex: no point");
    if (!ended || count % 3 != 0)
        return line_error(cloud->name, reader.number(), "the file ends before endsolid; it is cut off: copy it again");
    corners.note(count / 3);
    return {};
}

Outcome parse_obj_points(std::string_view content, PointCloud* cloud) {
    LineReader reader(content);
    std::string_view line;
    cloud->dim = 3;
    std::vector<double> numbers;
    while (reader.next_content(&line)) {
        if (!starts(line, "v ") && !starts(line, "v\t")) continue;
        if (line.find_first_of(",;") != std::string_view::npos)
            return line_error(cloud->name, reader.number(), "numbers are parted by blanks and written with a point");
        const Complaint complaint = parse_numbers(line.substr(2), &numbers);
        if (!complaint.empty()) return line_error(cloud->name, reader.number(), complaint);
        // x y z, then a weight, or a colour of three, or both
        const std::size_t count = numbers.size();
        if (count != 3 && count != 4 && count != 6 && count != 7)
            return line_error(cloud->name, reader.number(),
                              "a vertex of " + counted(count, "number", "numbers") + " where 3 are due");
        if ((count == 4 || count == 7) && numbers[3] != 1)
            return line_error(cloud->name, reader.number(), "a vertex with a weight other than 1; write x y z alone");
        cloud->coordinates.insert(cloud->coordinates.end(), numbers.begin(), numbers.begin() + 3);
        cloud->lines.push_back(reader.number());
    }
    if (cloud->rows() == 0)
        return line_error(cloud->name, reader.number() == 0 ? 1 : reader.number(),
                          "no line `v X Y Z`: no point; a table is named .txt or .csv");
    cloud->note = "read as the vertices of .obj";
    return {};
}

}  // namespace netmesh::tool
