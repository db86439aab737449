// NumPy arrays of two axes with real numbers in them, one by one (.npy) or in an archive (.npz).
#include <algorithm>
#include <cmath>
#include <cstring>

#include "platform/interrupt.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/point_stream.hpp"
#include "tools/io/points.hpp"
#include "tools/io/unpack.hpp"

namespace netmesh::tool {

namespace {

struct Array {
    char kind = 0;  // f, i or u
    unsigned item_bytes = 0;
    bool little = true, fortran = false;
    std::uint64_t rows = 0, columns = 0;
    std::size_t data_offset = 0;
};

Outcome wrong(const Table& table, const std::string& what) { return file_error(table.name, what); }

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

// How such elements become floats.
const char* remedy_for_type(std::string_view text) {
    if (text.front() == '[') return "numpy.lib.recfunctions.structured_to_unstructured(a)";
    const char kind = text.size() > 2 ? text[2] : ' ';
    if (kind == 'c') return "numpy.column_stack([a.real, a.imag])";
    if (kind == 'O') return "numpy.array(a.tolist(), dtype=float), where all rows have the same length";
    return "a.astype(float)";
}

std::string parse_descr(std::string_view text, Array* array) {
    if (text.empty()) return "elements of no type";
    const std::string no = "elements of type " + quoted(text) +
                           "; float16, float32, float64 and integers are read: numpy.save(FILE, ...) of " +
                           remedy_for_type(text);
    if (text.size() < 5 || (text.front() != '\'' && text.front() != '"') || text.back() != text.front()) return no;
    const std::string_view code = text.substr(1, text.size() - 2);
    const char order = code[0];
    array->kind = code[1];
    const std::string_view digits = code.substr(2);
    array->item_bytes = digits.size() == 1 ? static_cast<unsigned>(digits[0] - '0') : 0;
    array->little = order != '>';
    const unsigned n = array->item_bytes;
    const bool size_good = array->kind == 'f' ? (n == 2 || n == 4 || n == 8) : (n == 1 || n == 2 || n == 4 || n == 8);
    const bool kind_good = array->kind == 'f' || array->kind == 'i' || array->kind == 'u';
    const bool order_good = order == '<' || order == '>' || order == '|' || order == '=';
    return size_good && kind_good && order_good ? std::string() : no;
}

// Everything before the data. A complaint, or empty.
std::string parse_header(std::string_view content, bool distances, Array* array) {
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
    if (shape.size() == 1 && distances) shape.push_back(1);
    if (shape.size() != 2 && distances)
        return "an array of " + std::to_string(shape.size()) + " axes; one or two are read";
    if (shape.size() != 2)
        return "an array of " + std::to_string(shape.size()) + (shape.size() == 1 ? " axis" : " axes") +
               "; points need two: a.reshape(-1, D)" + (shape.size() == 1 ? remedy_for_condensed(shape[0]) : "");
    if (order != "False" && order != "True") return "fortran_order " + quoted(order) + " is not understood";
    array->fortran = order == "True";
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

double half(const unsigned char* bytes) {
    std::uint16_t bits;
    std::memcpy(&bits, bytes, sizeof bits);
    const int exponent = (bits >> 10) & 31;
    const double fraction = bits & 1023;
    double value = exponent == 0    ? std::ldexp(fraction, -24)
                   : exponent == 31 ? (fraction > 0 ? std::nan("") : HUGE_VAL)
                                    : std::ldexp(1024 + fraction, exponent - 25);
    return (bits & 0x8000) != 0 ? -value : value;
}

// Whether an integer of eight bytes is a double.
bool is_exact(const unsigned char* bytes, bool is_signed) {
    std::uint64_t size;
    std::memcpy(&size, bytes, sizeof size);
    if (is_signed && (size >> 63) != 0) size = 0 - size;
    constexpr std::uint64_t limit = std::uint64_t{1} << 53;
    return size <= limit;
}

// False for an integer that no double is sure to hold.
bool read_item(const Array& array, const unsigned char* source, double* value) {
    unsigned char bytes[8];
    constexpr std::uint16_t probe = 1;
    const bool host_little = *reinterpret_cast<const unsigned char*>(&probe) == 1;
    for (unsigned i = 0; i < array.item_bytes; i++) {
        bytes[i] = source[array.little == host_little ? i : array.item_bytes - 1 - i];
    }
    const bool is_signed = array.kind == 'i';
    if (array.kind == 'f') {
        *value = array.item_bytes == 2 ? half(bytes) : array.item_bytes == 4 ? item<float>(bytes) : item<double>(bytes);
        return true;
    }
    switch (array.item_bytes) {
    case 1: *value = is_signed ? item<std::int8_t>(bytes) : item<std::uint8_t>(bytes); break;
    case 2: *value = is_signed ? item<std::int16_t>(bytes) : item<std::uint16_t>(bytes); break;
    case 4: *value = is_signed ? item<std::int32_t>(bytes) : item<std::uint32_t>(bytes); break;
    default:
        *value = is_signed ? item<std::int64_t>(bytes) : item<std::uint64_t>(bytes);
        return is_exact(bytes, is_signed);
    }
    return true;
}

// Everything before the data, of a file of so many bytes, and the columns that are wanted.
Outcome open_array(std::string_view head, std::uint64_t bytes, const TableOptions& options, Array* array,
                   std::vector<std::size_t>* columns, Table* table) {
    const std::string complaint = parse_header(head, options.distances, array);
    if (!complaint.empty()) return wrong(*table, complaint);
    if (array->rows == 0) return wrong(*table, "the array has no rows: no point");
    if (array->columns == 0) return wrong(*table, "the array has no columns: no point");
    const std::uint64_t available = bytes - array->data_offset;
    if (array->columns > available / array->item_bytes ||
        array->rows > available / (array->columns * array->item_bytes)) {
        const std::uint64_t whole = array->columns > available ? 0 : available / (array->columns * array->item_bytes);
        return wrong(*table, "ends at byte " + std::to_string(bytes) + ", inside row " + std::to_string(whole + 1) +
                                 " of " + std::to_string(array->rows));
    }
    const std::uint64_t data_bytes = array->rows * array->columns * array->item_bytes;
    if (data_bytes != available) {
        return wrong(*table, std::to_string(available - data_bytes) + " bytes behind the array (byte " +
                                 std::to_string(array->data_offset + data_bytes) + ")");
    }
    columns->clear();
    for (std::size_t k = 0; k < array->columns && options.columns.empty(); k++) columns->push_back(k);
    const std::string wrong_columns = choose_columns(options, array->columns, {}, columns);
    if (!wrong_columns.empty()) return wrong(*table, wrong_columns);
    table->width = columns->size();
    table->has_weights = !options.weights.empty();
    return {};
}

// Where the numbers of some rows are: of each wanted column the first, and bytes from one to the next.
struct RowPlaces {
    std::vector<const unsigned char*> starts;
    std::size_t stride;
};

// Rows first, first + 1, .., behind those that are in the table.
Outcome take_rows(const Array& array, const std::vector<std::size_t>& columns, const RowPlaces& places,
                  std::uint64_t first, std::uint64_t count, bool distances, Table* table) {
    std::size_t i = table->values.size();
    table->values.resize(i + count * columns.size());
    for (std::uint64_t row = 0; row < count; row++) {
        for (std::size_t k = 0; k < columns.size(); k++) {
            double value;
            const bool exact = read_item(array, places.starts[k] + row * places.stride, &value);
            const char* const fault = !exact              ? "an integer beyond 2^53, which a double need not hold; "
                                                            "write floats, or subtract a common offset"
                                      : std::isnan(value) ? "\"nan\" is not a finite double"
                                      : !std::isfinite(value) && !(distances && value > 0)
                                          ? (array.columns == 3 && columns[k] == 2
                                                 ? "\"inf\" is not a finite double; a persistence diagram, degree, "
                                                   "birth, death, as this may be, is read by `netmesh distance`"
                                                 : "\"inf\" is not a finite double")
                                          : nullptr;
            if (fault != nullptr) {
                const std::uint64_t at =
                    array.fortran ? columns[k] * array.rows + first + row : (first + row) * array.columns + columns[k];
                return wrong(*table, "row " + std::to_string(first + row + 1) + " (byte " +
                                         std::to_string(array.data_offset + at * array.item_bytes) + "): " + fault);
            }
            table->values[i++] = value + 0.0;  // -0.0 becomes 0.0
        }
    }
    return {};
}

// An array that is read some rows at a time.
class NpyStream : public PointStream {
public:
    explicit NpyStream(std::unique_ptr<platform::InputFile> file) : file_(std::move(file)) {}

    Outcome open(std::string_view head, const std::string& name, const TableOptions& options) {
        table_.name = name;
        const Outcome outcome = open_array(head, file_->bytes(), options, &array_, &columns_, &table_);
        return outcome.good() ? begin(table_) : outcome;
    }

    Outcome read(std::vector<double>* rows) override {
        constexpr std::uint64_t most_bytes = std::uint64_t{1} << 20;
        const std::uint64_t row_bytes = array_.columns * array_.item_bytes;
        const std::uint64_t count = std::min(array_.rows - done_, 1 + most_bytes / row_bytes);
        if (count == 0) return {};
        RowPlaces places;
        if (array_.fortran) {
            const std::size_t column_bytes = count * array_.item_bytes;
            buffer_.resize(columns_.size() * column_bytes);
            for (std::size_t k = 0; k < columns_.size(); k++) {
                const std::uint64_t at = (columns_[k] * array_.rows + done_) * array_.item_bytes;
                const Outcome outcome = fetch(at, column_bytes, k * column_bytes);
                if (!outcome.good()) return outcome;
            }
            for (std::size_t k = 0; k < columns_.size(); k++) places.starts.push_back(bytes() + k * column_bytes);
            places.stride = array_.item_bytes;
        } else {
            buffer_.resize(count * row_bytes);
            const Outcome outcome = fetch(done_ * row_bytes, count * row_bytes, 0);
            if (!outcome.good()) return outcome;
            for (const std::size_t column : columns_) places.starts.push_back(bytes() + column * array_.item_bytes);
            places.stride = row_bytes;
        }
        table_.values.swap(*rows);
        const Outcome outcome = take_rows(array_, columns_, places, done_, count, false, &table_);
        table_.values.swap(*rows);
        done_ += count;
        return outcome;
    }

private:
    const unsigned char* bytes() const { return reinterpret_cast<const unsigned char*>(buffer_.data()); }
    Outcome fetch(std::uint64_t offset, std::size_t count, std::size_t to) {
        std::string why;
        if (file_->read(array_.data_offset + offset, buffer_.data() + to, count, &why)) return {};
        if (platform::interrupted()) return {Exit::cancelled, "netmesh: cancelled while reading " + table_.name};
        return wrong(table_, why);
    }

    std::unique_ptr<platform::InputFile> file_;
    Table table_;
    Array array_;
    std::vector<std::size_t> columns_;
    std::vector<char> buffer_;
    std::uint64_t done_ = 0;
};

}  // namespace

Outcome open_npy_stream(std::string_view head, const std::string& name, const TableOptions& options,
                        std::unique_ptr<platform::InputFile> file, std::unique_ptr<PointStream>* stream) {
    auto made = std::make_unique<NpyStream>(std::move(file));
    const Outcome outcome = made->open(head, name, options);
    if (outcome.good()) *stream = std::move(made);
    return outcome;
}

Outcome parse_npy_table(std::string_view content, const TableOptions& options, Table* table) {
    Array array;
    std::vector<std::size_t> columns;
    const Outcome outcome = open_array(content, content.size(), options, &array, &columns, table);
    if (!outcome.good()) return outcome;
    const unsigned char* const data = reinterpret_cast<const unsigned char*>(content.data()) + array.data_offset;
    RowPlaces places;
    for (const std::size_t column : columns)
        places.starts.push_back(data + column * (array.fortran ? array.rows : 1) * array.item_bytes);
    places.stride = (array.fortran ? 1 : array.columns) * array.item_bytes;
    return take_rows(array, columns, places, 0, array.rows, options.distances, table);
}

Outcome parse_npz_table(std::string_view content, const std::string& array, const TableOptions& options, Table* table) {
    std::vector<ZipEntry> entries;
    std::string complaint = list_zip(content, &entries);
    if (!complaint.empty()) return wrong(*table, complaint);
    std::string names;
    const ZipEntry* found = nullptr;
    for (const ZipEntry& entry : entries) {
        const bool is_array = ending_of(entry.name) == ".npy";
        const std::string name = is_array ? entry.name.substr(0, entry.name.size() - 4) : entry.name;
        names += (names.empty() ? "" : ", ") + quoted(name);
        if (is_array && (array.empty() ? entries.size() == 1 : name == array)) found = &entry;
    }
    if (found == nullptr) {
        const std::string has = entries.empty() ? "no array" : "arrays " + names;
        return wrong(*table, "an archive with " + has +
                                 (array.empty() ? "; name the one that is meant behind a colon: FILE.npz:NAME"
                                                : ", none of them called " + quoted(array)));
    }
    std::string unpacked;
    complaint = unzip(*found, &unpacked);
    if (!complaint.empty()) return wrong(*table, complaint);
    table->note = "read array " + quoted(std::string_view(found->name).substr(0, found->name.size() - 4));
    return parse_npy_table(unpacked, options, table);
}

Outcome parse_npy_points(std::string_view content, PointCloud* cloud) {
    Table table;
    table.name = cloud->name;
    const Outcome outcome = parse_npy_table(content, {}, &table);
    return outcome.good() ? take_table(std::move(table), cloud) : outcome;
}

}  // namespace netmesh::tool
