// Stanford PLY, ASCII and binary of both byte orders: properties x, y and z of element vertex.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "platform/interrupt.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/point_stream.hpp"
#include "tools/io/points.hpp"

namespace netmesh::tool {

namespace {

enum class Scalar { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
    std::string name;
    Scalar type = Scalar::f32;
    bool is_list = false;
    Scalar count_type = Scalar::u8;
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

struct PlyHeader {
    bool binary = false, big_endian = false;
    std::vector<Element> elements;
    std::size_t vertex_element = SIZE_MAX;
    int columns[3] = {-1, -1, -1};  // positions of x, y, z among the properties
    std::uint32_t dim = 0;
};

bool scalar_of(std::string_view name, Scalar* type) {
    static constexpr struct {
        const char* name;
        Scalar type;
    } names[] = {{"char", Scalar::i8},   {"int8", Scalar::i8},     {"uchar", Scalar::u8},   {"uint8", Scalar::u8},
                 {"short", Scalar::i16}, {"int16", Scalar::i16},   {"ushort", Scalar::u16}, {"uint16", Scalar::u16},
                 {"int", Scalar::i32},   {"int32", Scalar::i32},   {"uint", Scalar::u32},   {"uint32", Scalar::u32},
                 {"float", Scalar::f32}, {"float32", Scalar::f32}, {"double", Scalar::f64}, {"float64", Scalar::f64}};
    for (const auto& entry : names) {
        if (name != entry.name) continue;
        *type = entry.type;
        return true;
    }
    return false;
}

unsigned bytes_of(Scalar type) {
    switch (type) {
    case Scalar::i8:
    case Scalar::u8: return 1;
    case Scalar::i16:
    case Scalar::u16: return 2;
    case Scalar::f64: return 8;
    default: return 4;
    }
}

double read_scalar(Scalar type, const char* source, bool big_endian) {
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < bytes_of(type); i++) {
        const char byte = source[big_endian ? bytes_of(type) - 1 - i : i];
        bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(byte)) << (8 * i);
    }
    float narrow;
    double wide;
    const std::uint32_t low = static_cast<std::uint32_t>(bits);
    switch (type) {
    case Scalar::i8: return static_cast<std::int8_t>(bits);
    case Scalar::i16: return static_cast<std::int16_t>(bits);
    case Scalar::i32: return static_cast<std::int32_t>(bits);
    case Scalar::f32: std::memcpy(&narrow, &low, sizeof narrow); return narrow;
    case Scalar::f64: std::memcpy(&wide, &bits, sizeof wide); return wide;
    default: return static_cast<double>(bits);
    }
}

Complaint parse_property(const std::vector<std::string_view>& words, PlyHeader* header) {
    if (header->elements.empty()) return "a property before the first element";
    Property property;
    property.is_list = words.size() > 1 && words[1] == "list";
    if (words.size() != (property.is_list ? 5u : 3u)) return "a property line that is not understood";
    const std::string_view type = words[property.is_list ? 3 : 1];
    if (property.is_list && !scalar_of(words[2], &property.count_type)) return "no such type: " + quoted(words[2]);
    if (property.count_type == Scalar::f32 || property.count_type == Scalar::f64)
        return "a list whose length is of type " + quoted(words[2]) + "; lengths are whole numbers, such as uchar";
    if (!scalar_of(type, &property.type)) return "no such type: " + quoted(type);
    property.name = std::string(words.back());
    for (const Property& other : header->elements.back().properties)
        if (other.name == property.name) return "a second property " + quoted(property.name) + " of one element";
    header->elements.back().properties.push_back(property);
    return {};
}

Complaint parse_header_line(std::string_view line, bool* format_seen, PlyHeader* header) {
    const std::vector<std::string_view> words = split_blanks(line);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return {};
    if (words[0] == "format" && words.size() == 3) {
        if (*format_seen) return "a second format line";
        header->big_endian = words[1] == "binary_big_endian";
        if (words[1] != "ascii" && words[1] != "binary_little_endian" && !header->big_endian)
            return "format " + quoted(words[1]) + "; ascii, binary_little_endian and binary_big_endian are read";
        header->binary = words[1] != "ascii";
        *format_seen = true;
        return {};
    }
    if (words[0] == "element" && words.size() == 3) {
        Element element;
        element.name = std::string(words[1]);
        if (!parse_unsigned(std::string(words[2]), &element.count)) return quoted(words[2]) + " is not a count";
        for (const Element& other : header->elements)
            if (element.name == "vertex" && other.name == "vertex") return "a second element vertex";
        header->elements.push_back(element);
        return {};
    }
    if (words[0] == "property") return parse_property(words, header);
    return "a header line that is not understood: " + quoted(line);
}

Complaint find_columns(PlyHeader* header) {
    for (std::size_t e = 0; e < header->elements.size(); e++) {
        if (header->elements[e].name != "vertex") continue;
        header->vertex_element = e;
        const std::vector<Property>& properties = header->elements[e].properties;
        for (std::size_t i = 0; i < properties.size(); i++) {
            const std::string& name = properties[i].name;
            if (name.size() != 1 || name[0] < 'x' || name[0] > 'z') continue;
            if (properties[i].is_list) return "property " + name + " is a list";
            header->columns[name[0] - 'x'] = static_cast<int>(i);
        }
    }
    if (header->vertex_element == SIZE_MAX) return "no element vertex";
    if (header->columns[0] < 0 || header->columns[1] < 0) return "element vertex has no property x or y";
    header->dim = header->columns[2] < 0 ? 2 : 3;
    if (header->elements[header->vertex_element].count == 0) return "no vertices: no point";
    return {};
}

Outcome parse_ply_header(LineReader& reader, const PointCloud& cloud, PlyHeader* header) {
    std::string_view line;
    if (!reader.next(&line) || line != "ply") {
        return line_error(cloud.name, 1, "a PLY file starts with a line that says ply");
    }
    bool format_seen = false;
    for (;;) {
        if (!reader.next(&line)) return line_error(cloud.name, reader.number(), "the file ends inside its header");
        if (line == "end_header") break;
        const Complaint complaint = parse_header_line(line, &format_seen, header);
        if (!complaint.empty()) return line_error(cloud.name, reader.number(), complaint);
    }
    if (!format_seen) return line_error(cloud.name, reader.number(), "no format line in the header");
    const Complaint complaint = find_columns(header);
    if (!complaint.empty()) return line_error(cloud.name, reader.number(), complaint);
    return {};
}

// The bytes of one element at content[*offset], stepped over; starts[i] is the offset of property i.
bool walk_element(const Element& element, std::string_view content, bool big_endian, std::size_t* offset,
                  std::vector<std::size_t>* starts) {
    starts->clear();
    for (const Property& property : element.properties) {
        starts->push_back(*offset);
        std::uint64_t bytes = bytes_of(property.type);
        if (property.is_list) {
            const unsigned count_bytes = bytes_of(property.count_type);
            if (content.size() - *offset < count_bytes) return false;
            const double count = read_scalar(property.count_type, content.data() + *offset, big_endian);
            if (!(count >= 0 && count <= 4294967295.0)) return false;
            *offset += count_bytes;
            bytes *= static_cast<std::uint64_t>(count);
        }
        if (content.size() - *offset < bytes) return false;
        *offset += bytes;
    }
    return true;
}

bool is_face_list(const Element& element, const Property& property) {
    return element.name == "face" && property.is_list &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
}

std::string no_such_vertex(double vertex, std::uint64_t count) {
    return "a face with vertex " + number_text(vertex) + "; vertices are numbered from 0 to " +
           std::to_string(count - 1);
}

// A vertex of the face in a row of bytes that does not exist, -1 for all below 0; 0 where all exist.
double foreign_vertex(const Element& element, std::string_view content, bool big_endian,
                      const std::vector<std::size_t>& starts, std::uint64_t count) {
    for (std::size_t p = 0; p < element.properties.size(); p++) {
        const Property& property = element.properties[p];
        if (!is_face_list(element, property)) continue;
        const char* const at = content.data() + starts[p];
        const auto length = static_cast<std::uint64_t>(read_scalar(property.count_type, at, big_endian));
        for (std::uint64_t i = 0; i < length; i++) {
            const double vertex = read_scalar(
                property.type, at + bytes_of(property.count_type) + i * bytes_of(property.type), big_endian);
            if (!(vertex >= 0 && vertex < static_cast<double>(count))) return vertex < 0 ? -1 : vertex;
        }
    }
    return 0;
}

// The elements of a binary file one after the other. Of a file that is not in memory as a whole the reader holds a
// part.
class BinaryElements {
public:
    BinaryElements(PlyHeader header, std::string name, std::string_view content, std::uint64_t offset)
        : header_(std::move(header)), name_(std::move(name)), content_(content), end_(content.size()), offset_(offset) {
    }
    BinaryElements(PlyHeader header, std::string name, std::unique_ptr<platform::InputFile> file, std::uint64_t offset)
        : header_(std::move(header)), name_(std::move(name)), file_(std::move(file)), end_(file_->bytes()),
          base_(offset), offset_(offset) {}

    // Coordinates of so many vertices at most, appended; fewer only where all elements have been looked at.
    Outcome read(std::uint64_t most, std::vector<double>* coordinates) {
        const std::uint64_t vertices = header_.elements[header_.vertex_element].count;
        std::uint64_t taken = 0;
        for (; element_ < header_.elements.size(); element_++, row_ = 0) {
            const Element& element = header_.elements[element_];
            if (element.properties.empty()) continue;
            for (; row_ < element.count; row_++) {
                if (taken == most) return {};
                const Outcome found = find_row(element);
                if (!found.good()) return found;
                const double vertex = foreign_vertex(element, content_, header_.big_endian, starts_, vertices);
                if (vertex < 0 || vertex >= static_cast<double>(vertices))
                    return file_error(name_, "face " + std::to_string(row_ + 1) + " (byte " +
                                                 std::to_string(base_ + starts_[0]) +
                                                 "): " + no_such_vertex(vertex, vertices));
                if (element_ != header_.vertex_element) continue;
                const Outcome outcome = take_vertex(element, coordinates);
                if (!outcome.good()) return outcome;
                taken++;
            }
        }
        return rest();
    }

private:
    Outcome take_vertex(const Element& element, std::vector<double>* coordinates) const {
        for (std::uint32_t k = 0; k < header_.dim; k++) {
            const std::size_t column = static_cast<std::size_t>(header_.columns[k]);
            const double value =
                read_scalar(element.properties[column].type, content_.data() + starts_[column], header_.big_endian);
            if (!std::isfinite(value)) {
                return {Exit::data,
                        name_ + ": row " + std::to_string(row_ + 1) + " (byte " +
                            std::to_string(base_ + starts_[column]) +
                            "): " + not_finite(std::isnan(value) ? "nan" : "inf"),
                        name_};
            }
            coordinates->push_back(value + 0.0);  // -0.0 becomes 0.0
        }
        return {};
    }
    // The bytes of the next row in content_, its properties at starts_; stepped over.
    Outcome find_row(const Element& element) {
        for (;;) {
            std::size_t at = static_cast<std::size_t>(offset_ - base_);
            if (walk_element(element, content_, header_.big_endian, &at, &starts_)) {
                offset_ = base_ + at;
                return {};
            }
            if (base_ + content_.size() == end_)
                return file_error(name_, "ends at byte " + std::to_string(end_) + ", inside " + element.name + " " +
                                             std::to_string(row_ + 1) + " of " + std::to_string(element.count));
            const Outcome outcome = read_on();
            if (!outcome.good()) return outcome;
        }
    }
    // Drops what has been looked at, and reads a mebibyte or as much again as is left.
    Outcome read_on() {
        const std::size_t left = content_.size() - static_cast<std::size_t>(offset_ - base_);
        buffer_.erase(0, buffer_.size() - left);
        base_ = offset_;
        const std::uint64_t more = std::min<std::uint64_t>(end_ - base_ - left, std::max(left, std::size_t{1} << 20));
        buffer_.resize(left + static_cast<std::size_t>(more));
        std::string why;
        if (!file_->read(base_ + left, &buffer_[left], static_cast<std::size_t>(more), &why)) {
            if (platform::interrupted()) return {Exit::cancelled, "netmesh: cancelled while reading " + name_};
            return file_error(name_, why);
        }
        content_ = buffer_;
        return {};
    }
    // Nothing but line ends may stand behind the elements.
    Outcome rest() {
        const std::uint64_t from = offset_;
        for (;;) {
            const std::string_view some = content_.substr(static_cast<std::size_t>(offset_ - base_));
            if (some.find_first_not_of("\r\n") != std::string_view::npos) break;
            offset_ = base_ + content_.size();
            if (offset_ == end_) return {};
            const Outcome outcome = read_on();
            if (!outcome.good()) return outcome;
        }
        return file_error(name_, counted(end_ - from, "byte", "bytes") +
                                     " behind all elements that its header counts (byte " + std::to_string(from) + ")");
    }

    const PlyHeader header_;
    const std::string name_;
    std::unique_ptr<platform::InputFile> file_;
    std::string buffer_;
    std::string_view content_;  // bytes base_, base_ + 1, .. of the file
    std::uint64_t end_, base_ = 0, offset_;
    std::size_t element_ = 0;
    std::uint64_t row_ = 0;
    std::vector<std::size_t> starts_;
};

class PlyStream : public PointStream {
public:
    PlyStream(const PlyHeader& header, const std::string& name, std::unique_ptr<platform::InputFile> file,
              std::uint64_t offset)
        : elements_(header, name, std::move(file), offset) {
        dim_ = header.dim;
    }
    Outcome read(std::vector<double>* rows) override { return elements_.read(std::uint64_t{1} << 15, rows); }

private:
    BinaryElements elements_;
};

// What is wrong with a row of an element in text; empty when nothing is.
std::string row_complaint(const Element& element, const std::vector<double>& row, std::uint64_t vertices) {
    std::size_t at = 0;
    for (const Property& property : element.properties) {
        std::size_t length = 1;
        if (property.is_list) {
            if (at >= row.size() || !is_count(row[at]) || row[at] > static_cast<double>(row.size()))
                return "a list that does not begin with its length";
            length = static_cast<std::size_t>(row[at++]);
        }
        for (std::size_t i = 0; i < length && at + i < row.size() && is_face_list(element, property); i++) {
            const double vertex = row[at + i];
            if (!is_count(vertex) || vertex >= static_cast<double>(vertices)) return no_such_vertex(vertex, vertices);
        }
        at += length;
    }
    if (at == row.size()) return {};
    return (element.name == "vertex" ? "a vertex of " : "a line of element " + element.name + " with ") +
           counted(row.size(), "number", "numbers") + " where " + std::to_string(at) + " are due";
}

Outcome parse_ply_ascii(LineReader& reader, const PlyHeader& header, PointCloud* cloud) {
    std::string_view line;
    std::vector<double> row;
    const std::uint64_t vertices = header.elements[header.vertex_element].count;
    for (std::size_t e = 0; e < header.elements.size(); e++) {
        const Element& element = header.elements[e];
        bool lists = false;
        for (const Property& property : element.properties) lists = lists || property.is_list;
        for (std::uint64_t i = 0; i < element.count; i++) {
            if (!reader.next_content(&line)) {
                return line_error(cloud->name, reader.number(),
                                  "the file ends after " + std::to_string(i) + " of " + std::to_string(element.count) +
                                      " lines of element " + element.name);
            }
            Complaint complaint = parse_numbers(line, &row);
            if (complaint.empty() && e == header.vertex_element && lists)
                complaint = "vertices with lists are read from binary files only";
            if (complaint.empty()) complaint = row_complaint(element, row, vertices);
            if (!complaint.empty()) return line_error(cloud->name, reader.number(), complaint);
            if (e != header.vertex_element) continue;
            for (std::uint32_t k = 0; k < header.dim; k++) {
                cloud->coordinates.push_back(row[static_cast<std::size_t>(header.columns[k])]);
            }
            cloud->lines.push_back(reader.number());
        }
    }
    if (!reader.next_content(&line)) return {};
    return line_error(cloud->name, reader.number(), "a line behind all elements that the header counts");
}

}  // namespace

Outcome parse_ply_points(std::string_view content, PointCloud* cloud) {
    LineReader reader(content, false);
    PlyHeader header;
    const Outcome outcome = parse_ply_header(reader, *cloud, &header);
    if (!outcome.good()) return outcome;
    cloud->dim = header.dim;
    if (!header.binary) return parse_ply_ascii(reader, header, cloud);
    return BinaryElements(header, cloud->name, content, reader.offset()).read(UINT64_MAX, &cloud->coordinates);
}

Outcome open_ply_stream(std::string_view head, const std::string& name, std::unique_ptr<platform::InputFile> file,
                        std::unique_ptr<PointStream>* stream) {
    LineReader reader(head, false);
    PlyHeader header;
    PointCloud cloud;
    cloud.name = name;
    const Outcome outcome = parse_ply_header(reader, cloud, &header);
    if (outcome.good() && header.binary)
        *stream = std::make_unique<PlyStream>(header, name, std::move(file), reader.offset());
    return outcome;
}

}  // namespace netmesh::tool
