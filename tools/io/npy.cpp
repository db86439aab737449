// NumPy arrays: the two-axis, C-order ones with real numbers in them.
#include <cmath>
#include <cstring>

#include "tools/io/lines.hpp"
#include "tools/io/points.hpp"

namespace netmesh::tool {

namespace {

struct Array {
    char kind = 0;  // f, i or u
    unsigned item_bytes = 0;
    bool little = true;
    std::uint64_t rows = 0, columns = 0;
    std::size_t data_offset = 0;
};

Outcome wrong(const PointCloud& cloud, const std::string& what) { return data_error(cloud.name + ": " + what); }

// The text of a value in the header's dictionary, from behind `'key':` up to the comma that ends it (brackets count).
bool find_value(std::string_view header, std::string_view key, std::string_view* value) {
    for (const char quote : {'\'', '"'}) {
        const std::string wanted = quote + std::string(key) + quote;
        std::size_t at = header.find(wanted);
        if (at == std::string_view::npos) continue;
        at = header.find(':', at + wanted.size());
        if (at == std::string_view::npos) return false;
        ++at;
        while (at < header.size() && header[at] == ' ') ++at;
        std::size_t stop = at;
        int depth = 0;
        while (stop < header.size()) {
            const char c = header[stop];
            if (c == '(' || c == '[') depth++;
            if (depth == 0 && (c == ',' || c == '}')) break;
            if (c == ')' || c == ']') depth--;
            stop++;
        }
        *value = header.substr(at, stop - at);
        while (!value->empty() && value->back() == ' ') value->remove_suffix(1);
        return true;
    }
    return false;
}

bool parse_shape(std::string_view text, std::vector<std::uint64_t>* shape) {
    if (text.size() < 2 || text.front() != '(' || text.back() != ')') return false;
    shape->clear();
    std::uint64_t number = 0;
    bool digits = false;
    for (const char c : text.substr(1)) {
        if (c >= '0' && c <= '9') {
            if (number > UINT64_MAX / 16) return false;
            number = 10 * number + static_cast<std::uint64_t>(c - '0');
            digits = true;
        } else if (c == ',' || c == ')') {
            if (digits) shape->push_back(number);
            number = 0;
            digits = false;
        } else if (c != ' ' && c != 'L') {
            return false;
        }
    }
    return true;
}

std::string parse_descr(std::string_view text, Array* array) {
    const std::string no = "elements of type " + quoted(text) + "; float32, float64 and integers are read";
    if (text.size() < 5 || (text.front() != '\'' && text.front() != '"') || text.back() != text.front()) return no;
    const std::string_view code = text.substr(1, text.size() - 2);
    const char order = code[0];
    array->kind = code[1];
    const std::string_view digits = code.substr(2);
    array->item_bytes = digits.size() == 1 ? static_cast<unsigned>(digits[0] - '0') : 0;
    array->little = order != '>';
    const unsigned n = array->item_bytes;
    const bool size_good = array->kind == 'f' ? (n == 4 || n == 8) : (n == 1 || n == 2 || n == 4 || n == 8);
    const bool kind_good = array->kind == 'f' || array->kind == 'i' || array->kind == 'u';
    const bool order_good = order == '<' || order == '>' || order == '|' || order == '=';
    return size_good && kind_good && order_good ? std::string() : no;
}

// Everything before the data. A complaint, or empty.
std::string parse_header(std::string_view content, Array* array) {
    if (content.size() < 10 || content.substr(0, 6) != "\x93NUMPY") return "not a NumPy array (bytes 0 to 5)";
    const unsigned char* const bytes = reinterpret_cast<const unsigned char*>(content.data());
    const unsigned version = bytes[6];
    if (version < 1 || version > 3) return "NumPy format version " + std::to_string(version) + " (byte 6)";
    std::size_t start = 10, length = bytes[8] | (bytes[9] << 8);
    if (version > 1) {
        if (content.size() < 12) return "ends inside its header (byte " + std::to_string(content.size()) + ")";
        start = 12;
        length |= (static_cast<std::size_t>(bytes[10]) << 16) | (static_cast<std::size_t>(bytes[11]) << 24);
    }
    if (length > content.size() - start) {
        return "ends inside its header (byte " + std::to_string(content.size()) + ")";
    }
    const std::string_view header = content.substr(start, length);
    std::string_view descr, order, shape_text;
    if (!find_value(header, "descr", &descr) || !find_value(header, "fortran_order", &order) ||
        !find_value(header, "shape", &shape_text)) {
        return "its header lacks descr, fortran_order or shape (byte " + std::to_string(start) + ")";
    }
    const std::string complaint = parse_descr(descr, array);
    if (!complaint.empty()) return complaint;
    std::vector<std::uint64_t> shape;
    if (!parse_shape(shape_text, &shape)) return "shape " + quoted(shape_text) + " is not understood";
    if (shape.size() != 2) return "an array of " + std::to_string(shape.size()) + " axes; points need two";
    if (order != "False") return "Fortran order; points are read in C order (one point a row)";
    array->rows = shape[0];
    array->columns = shape[1];
    array->data_offset = start + length;
    return {};
}

template <class T> double item(const unsigned char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

double read_item(const Array& array, const unsigned char* source) {
    unsigned char bytes[8];
    constexpr std::uint16_t probe = 1;
    const bool host_little = *reinterpret_cast<const unsigned char*>(&probe) == 1;
    for (unsigned i = 0; i < array.item_bytes; i++) {
        bytes[i] = source[array.little == host_little ? i : array.item_bytes - 1 - i];
    }
    const bool is_signed = array.kind == 'i';
    if (array.kind == 'f') return array.item_bytes == 4 ? item<float>(bytes) : item<double>(bytes);
    switch (array.item_bytes) {
    case 1: return is_signed ? item<std::int8_t>(bytes) : item<std::uint8_t>(bytes);
    case 2: return is_signed ? item<std::int16_t>(bytes) : item<std::uint16_t>(bytes);
    case 4: return is_signed ? item<std::int32_t>(bytes) : item<std::uint32_t>(bytes);
    default: return is_signed ? item<std::int64_t>(bytes) : item<std::uint64_t>(bytes);
    }
}

}  // namespace

Outcome parse_npy_points(std::string_view content, PointCloud* cloud) {
    Array array;
    const std::string complaint = parse_header(content, &array);
    if (!complaint.empty()) return wrong(*cloud, complaint);
    if (array.rows == 0) return wrong(*cloud, "the array has no rows: no point");
    if (array.columns < dim_min || array.columns > dim_max) {
        return wrong(*cloud, std::to_string(array.columns) + " columns; points have 2 to 6 coordinates");
    }
    const std::uint64_t row_bytes = array.columns * array.item_bytes;
    const std::uint64_t available = content.size() - array.data_offset;
    if (array.rows > available / row_bytes) {
        return wrong(*cloud, "ends at byte " + std::to_string(content.size()) + ", inside row " +
                                 std::to_string(available / row_bytes + 1) + " of " + std::to_string(array.rows));
    }
    if (array.rows * row_bytes != available) {
        return wrong(*cloud, std::to_string(available - array.rows * row_bytes) + " bytes behind the array (byte " +
                                 std::to_string(array.data_offset + array.rows * row_bytes) + ")");
    }
    cloud->dim = static_cast<std::uint32_t>(array.columns);
    cloud->coordinates.resize(array.rows * array.columns);
    const unsigned char* source = reinterpret_cast<const unsigned char*>(content.data()) + array.data_offset;
    for (std::size_t i = 0; i < cloud->coordinates.size(); i++, source += array.item_bytes) {
        const double value = read_item(array, source);
        if (!std::isfinite(value)) {
            return data_error(cloud->where(i / cloud->dim) + " (byte " +
                              std::to_string(array.data_offset + i * array.item_bytes) +
                              "): " + not_finite(std::isnan(value) ? "nan" : "inf"));
        }
        cloud->coordinates[i] = value + 0.0;  // -0.0 becomes 0.0
    }
    return {};
}

}  // namespace netmesh::tool
