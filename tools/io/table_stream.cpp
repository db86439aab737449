// Tables of plain numbers some rows at a time: the beginning says how rows are cut, and every line has to be like it.
#include <algorithm>
#include <cstring>

#include "platform/interrupt.hpp"
#include "tools/io/characters.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/point_stream.hpp"
#include "tools/io/table_lines.hpp"

namespace netmesh::tool {

namespace {

// The finite number at *at, which is stepped over: digits with a sign, a point and an exponent or without. False for
// everything of which readers of tables make more than a number: zeros in front, and what is too small for a double.
bool take_number(const char** at, const char* end, double* value) {
    const char* const begin = *at;
    const char* const digits = begin + (begin != end && (*begin == '-' || *begin == '+') ? 1 : 0);
    if (digits == end || (!is_digit(*digits) && *digits != '.')) return false;
    if (*digits == '0' && digits + 1 != end && is_digit(digits[1])) return false;
    if (parse_double(*at, end, value) != NumberKind::finite) return false;
    return *value != 0 || !is_below_doubles(std::string_view(begin, static_cast<std::size_t>(*at - begin)));
}

// Why any table of such lines is read as this one is: its lines have one delimiter, none has another, no number has a
// comma, and blanks behind commas stand behind all of them or behind none. That settles the dialect, whatever the
// numbers are; with a zero in front of none they are no halves of decimals either.
class TableStream : public PointStream {
public:
    TableStream(const TableShape& shape, const Table& table, std::unique_ptr<platform::InputFile> file)
        : shape_(shape), name_(table.name), file_(std::move(file)), values_(shape.fields) {
        note_ = table.note;
    }
    Outcome open(const Table& table) { return begin(table); }

    Outcome read(std::vector<double>* rows) override {
        const std::size_t before = rows->size();
        while (rows->size() == before && (offset_ < file_->bytes() || !text_.empty())) {
            const Outcome outcome = read_on();
            if (!outcome.good()) return outcome;
            std::string_view left = text_;
            const bool is_all = offset_ == file_->bytes();
            while (!left.empty()) {
                const void* const found = std::memchr(left.data(), '\n', left.size());
                if (found == nullptr && !is_all) break;
                const std::size_t length =
                    found == nullptr ? left.size()
                                     : static_cast<std::size_t>(static_cast<const char*>(found) - left.data());
                gave_up_ = !take_line(left.substr(0, length), rows);
                if (gave_up_) return {};
                left.remove_prefix(std::min(length + 1, left.size()));
            }
            gave_up_ = left.size() == text_.size() && !left.empty();  // a line without end
            if (gave_up_) return {};
            text_.erase(0, text_.size() - left.size());
        }
        return {};
    }

private:
    Outcome read_on() {
        const auto more =
            static_cast<std::size_t>(std::min<std::uint64_t>(file_->bytes() - offset_, std::uint64_t{1} << 20));
        const std::size_t left = text_.size();
        text_.resize(left + more);
        std::string why;
        if (!file_->read(offset_, &text_[left], more, &why)) {
            if (platform::interrupted()) return {Exit::cancelled, "netmesh: cancelled while reading " + name_};
            return file_error(name_, why);
        }
        offset_ += more;
        return {};
    }

    // False for a line that is more than a row, a comment or nothing.
    bool take_line(std::string_view line, std::vector<double>* rows) {
        if (++number_ < shape_.first_line) return true;  // of the beginning, which has been understood
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        const char* at = line.data();
        const char* const end = at + line.size();
        const auto skip_blanks = [&] {
            const char* const from = at;
            while (at != end && *at == ' ') at++;
            return at != from;
        };
        if (skip_blanks() && shape_.delimiter == '\t') return false;
        if (at == end || *at == '#' || *at == '%' || (*at == '/' && end - at > 1 && at[1] == '/')) return true;
        for (std::size_t k = 0; k < shape_.fields; k++) {
            if (k > 0 && !take_delimiter(&at, end, skip_blanks)) return false;
            if (!take_number(&at, end, &values_[k])) return false;
        }
        if (at != end || !is_index(values_[0])) return false;
        for (const std::size_t column : shape_.columns) rows->push_back(values_[column]);
        return true;
    }

    template <class Skip> bool take_delimiter(const char** at, const char* end, Skip skip_blanks) {
        if (shape_.delimiter == ' ') return skip_blanks() && *at != end;
        if (*at == end || **at != shape_.delimiter) return false;
        ++*at;
        if (shape_.delimiter == '\t') return true;
        const Spaced spaced = skip_blanks() ? Spaced::yes : Spaced::no;
        if (spaced_ == Spaced::unknown) spaced_ = spaced;
        return spaced == spaced_;
    }

    bool is_index(double value) {
        if (shape_.index == TableShape::none) return true;
        const bool good =
            is_count(value) && (!has_row_ || (shape_.index == TableShape::counts ? value == last_ + 1 : value > last_));
        has_row_ = true;
        last_ = value;
        return good;
    }

    enum class Spaced { unknown, yes, no };
    const TableShape shape_;
    const std::string name_;
    std::unique_ptr<platform::InputFile> file_;
    std::string text_;  // from the first line that is not done
    std::uint64_t offset_ = 0, number_ = 0;
    std::vector<double> values_;
    Spaced spaced_ = Spaced::unknown;  // are there blanks behind commas?
    bool has_row_ = false;
    double last_ = 0;
};

}  // namespace

Outcome open_table_stream(std::string_view head, const std::string& name, const TableOptions& options,
                          std::unique_ptr<platform::InputFile> file, std::unique_ptr<PointStream>* stream) {
    const std::size_t end = head.rfind('\n');
    if (head.size() < file->bytes() && end == std::string_view::npos) return {};
    Table table;
    TableShape shape;
    table.name = name;
    const std::string_view lines = head.size() < file->bytes() ? head.substr(0, end + 1) : head;
    // What is wrong with it is said by the reader of the whole file, who knows more about it.
    if (!parse_table(lines, options, &table, &shape).good() || !shape.is_plain || shape.delimiter == 0) return {};
    auto made = std::make_unique<TableStream>(shape, table, std::move(file));
    const Outcome outcome = made->open(table);
    if (outcome.good()) *stream = std::move(made);
    return outcome;
}

}  // namespace netmesh::tool
