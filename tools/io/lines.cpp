#include "tools/io/lines.hpp"

#include <cmath>
#include <cstring>

#include "tools/io/characters.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

bool is_comma(char c) { return c == ',' || c == ';'; }

const char* field_end(const char* at, const char* end) {
    while (at != end && !is_blank(*at) && !is_comma(*at)) ++at;
    return at;
}

}  // namespace

LineReader::LineReader(std::string_view text, bool comments) : text_(text), comments_(comments) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") offset_ = 3;
}

bool LineReader::next(std::string_view* line) {
    if (offset_ >= text_.size()) return false;
    const char* const start = text_.data() + offset_;
    const std::size_t left = text_.size() - offset_;
    const char* const end = static_cast<const char*>(std::memchr(start, '\n', left));
    std::size_t bytes = left;
    if (end != nullptr) {
        bytes = static_cast<std::size_t>(end - start);
        offset_ += bytes + 1;
    } else {
        offset_ = text_.size();
    }
    ++number_;
    if (comments_) {
        const void* const hash = std::memchr(start, '#', bytes);
        if (hash != nullptr) bytes = static_cast<std::size_t>(static_cast<const char*>(hash) - start);
    }
    *line = without_blanks(std::string_view(start, bytes));
    return true;
}

bool LineReader::next_content(std::string_view* line) {
    while (next(line)) {
        if (!line->empty()) return true;
    }
    return false;
}

namespace {

bool is_infinity(std::string_view word) {
    const std::string lower = lower_case(word);
    return lower == "inf" || lower == "+inf" || lower == "infinity" || lower == "+infinity";
}

}  // namespace

Complaint parse_numbers(std::string_view line, std::vector<double>* values, bool infinities) {
    values->clear();
    const char* at = line.data();
    const char* const end = at + line.size();
    char comma = 0;  // behind the last number
    for (;;) {
        while (at != end && is_blank(*at)) ++at;
        if (at == end) break;
        if (is_comma(*at)) return std::string("nothing before a '") + *at + "'";
        const char* const field = at;
        double value;
        const NumberKind kind = parse_double(at, end, &value);
        const char* const stop = field_end(at, end);
        const std::string_view word(field, static_cast<std::size_t>(stop - field));
        if (kind == NumberKind::not_a_number || stop != at) return not_a_number(word);
        const bool infinite = kind == NumberKind::not_finite;
        if (infinite && !(infinities && is_infinity(word))) return not_finite(word);
        values->push_back(infinite ? HUGE_VAL : value);
        while (at != end && is_blank(*at)) ++at;
        comma = at != end && is_comma(*at) ? *at++ : char{0};
    }
    if (comma != 0) return std::string("nothing after the last '") + comma + "'";
    return {};
}

bool is_header(std::string_view line) {
    const char* at = line.data();
    const char* const end = at + line.size();
    while (at != end) {
        if (is_blank(*at) || is_comma(*at)) {
            ++at;
            continue;
        }
        const char* const stop = field_end(at, end);
        const char* number_end = at;
        double ignored;
        const bool number = parse_double(number_end, stop, &ignored) != NumberKind::not_a_number;
        const char first = *at;
        if (number && number_end == stop) return false;
        if ((first >= '0' && first <= '9') || first == '.' || first == '+' || first == '-') return false;
        bool letter = false;
        for (; at != stop; ++at) letter = letter || is_letter(*at);
        if (!letter) return false;
    }
    return !line.empty();
}

std::vector<std::string_view> split_blanks(std::string_view line) {
    std::vector<std::string_view> fields;
    std::size_t at = 0;
    while (at < line.size()) {
        std::size_t stop = at;
        while (stop < line.size() && !is_blank(line[stop])) ++stop;
        if (stop > at) fields.push_back(line.substr(at, stop - at));
        at = stop + 1;
    }
    return fields;
}

std::string quoted(std::string_view piece) {
    constexpr std::size_t longest = 40;
    std::string text = "\"";
    for (std::size_t i = 0; i < piece.size() && i < longest; i++) {
        const unsigned char c = static_cast<unsigned char>(piece[i]);
        text += (c < 0x20 || c == 0x7f) ? '?' : piece[i];
    }
    text += piece.size() > longest ? "...\"" : "\"";
    return text;
}

Complaint not_a_number(std::string_view field) { return quoted(field) + " is not a number"; }
Complaint not_finite(std::string_view field) { return quoted(field) + " is not a finite double"; }

}  // namespace netmesh::tool
