#include "tools/io/table_lines.hpp"

#include <algorithm>
#include <cstring>

#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

bool is_delimiter(char c) { return c == ',' || c == ';' || c == '|' || c == '\t'; }

// Whether a # at `at` begins a comment, not a field: it is the first, or a blank stands between it and a field. Between
// tabs it is a field, and behind a word of a cell (Site #3) where a delimiter follows.
bool begins_comment(std::string_view line, std::size_t at) {
    if (without_blanks(line.substr(0, at)).empty()) return true;
    if (!is_blank(line[at - 1])) return false;
    if (line[at - 1] == '\t' && line.find('\t', at) != std::string_view::npos) return false;
    std::size_t before = at;
    while (is_blank(line[before - 1])) before--;
    if (line[before - 1] == ',' || line[before - 1] == ';' || line[before - 1] == '|') return false;
    std::size_t word = before;
    while (word > 0 && !is_blank(line[word - 1]) && !is_delimiter(line[word - 1])) word--;
    const bool is_glued = at + 1 < line.size() && !is_blank(line[at + 1]) && is_letter(line[word]);
    return !is_glued || line.find_first_of(",;|\t", at) == std::string_view::npos;
}

}  // namespace

std::string_view without_comment(std::string_view line) {
    const std::string_view content = without_blanks(line);
    if (content.substr(0, 1) == "%" || content.substr(0, 2) == "//") return {};
    if (std::memchr(line.data(), '#', line.size()) == nullptr) return line;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); i++) {
        if (line[i] == '"') quoted = !quoted;
        if (line[i] == '#' && !quoted && begins_comment(line, i)) return line.substr(0, i);
    }
    return quoted ? line.substr(0, line.find('#')) : line;
}

namespace {

// UTF-16 as spreadsheets save it, to UTF-8.
std::string from_utf16(std::string_view content, bool big) {
    std::string text;
    const auto unit = [&](std::size_t at) {
        const auto low = static_cast<unsigned char>(content[at + (big ? 1 : 0)]);
        const auto high = static_cast<unsigned char>(content[at + (big ? 0 : 1)]);
        return static_cast<unsigned>(low | (high << 8));
    };
    for (std::size_t at = 2; at + 1 < content.size(); at += 2) {
        const unsigned code = unit(at);
        if (code < 0x80) {
            text += static_cast<char>(code);
        } else if (code < 0x800) {
            text += static_cast<char>(0xC0 | (code >> 6));
            text += static_cast<char>(0x80 | (code & 63));
        } else {  // halves of pairs only ever stand in words
            text += static_cast<char>(0xE0 | (code >> 12));
            text += static_cast<char>(0x80 | ((code >> 6) & 63));
            text += static_cast<char>(0x80 | (code & 63));
        }
    }
    return text;
}

// One field at *at, up to a delimiter or blank that `ends` tells. False where a quotation does not end.
template <class Ends> bool take_field(std::string_view line, std::size_t* at, Ends ends, Field* field) {
    if (line[*at] == '"') {
        std::size_t stop = *at + 1;
        while (stop < line.size() && (line[stop] != '"' || (stop + 1 < line.size() && line[stop + 1] == '"')))
            stop += line[stop] == '"' ? 2 : 1;
        if (stop >= line.size()) return false;
        std::size_t behind = stop + 1;
        while (behind < line.size() && !ends(line[behind])) behind++;
        const bool nothing_else = without_blanks(line.substr(stop + 1, behind - stop - 1)).empty();
        field->quoted = nothing_else;
        field->text = nothing_else ? without_blanks(line.substr(*at + 1, stop - *at - 1))
                                   : without_blanks(line.substr(*at, behind - *at));
        *at = behind;
        return true;
    }
    std::size_t stop = *at;
    while (stop < line.size() && !ends(line[stop])) stop++;
    field->quoted = false;
    field->text = without_blanks(line.substr(*at, stop - *at));
    *at = stop;
    return true;
}

}  // namespace

namespace {

// The length of the line at the start of `content`, whose first end is at `length`, with the ends of lines that stand
// in its fields in quotes (RFC 4180). Where a quotation does not end as those of fields do, it holds none.
std::size_t with_breaks(std::string_view content, std::size_t length) {
    const auto parts = [&](std::size_t at) { return std::strchr(",;|\t", content[at]) != nullptr; };
    bool begins = true;  // a field
    for (std::size_t at = 0; at < length; at++) {
        if (content[at] != '"' || !begins) {
            begins = parts(at) || (begins && is_blank(content[at]));
            continue;
        }
        begins = false;
        for (at = content.find('"', at + 1); at != std::string_view::npos; at = content.find('"', at + 2))
            if (at + 1 == content.size() || content[at + 1] != '"') break;
        if (at < length) continue;
        const std::size_t next = at < content.size() ? content.find_first_not_of(" \r", at + 1) : at;
        const bool ends = next == std::string_view::npos ? at < content.size() : content[next] == '\n' || parts(next);
        if (!ends) return length;
        length = std::min(content.find('\n', at), content.size());
    }
    return length;
}

}  // namespace

std::string_view with_plain_ends(std::string_view content, std::string* remade) {
    const std::string_view mark = content.substr(0, 2);
    if (mark == "\xFF\xFE" || mark == "\xFE\xFF") {
        *remade = from_utf16(content, mark[0] == '\xFE');
        content = *remade;
    }
    if (content.substr(0, 3) == "\xEF\xBB\xBF") content.remove_prefix(3);
    if (content.find('\n') == std::string_view::npos && content.find('\r') != std::string_view::npos) {
        std::string text(content);  // of a Macintosh of old
        for (char& c : text) c = c == '\r' ? '\n' : c;
        *remade = std::move(text);
        content = *remade;
    }
    return content;
}

std::string collect_lines(std::string_view content, std::uint64_t skip, std::string* remade,
                          std::vector<TableLine>* lines, std::string_view* above, std::uint64_t* line) {
    content = with_plain_ends(content, remade);
    if (!content.empty() && content.back() == '\x1A') content.remove_suffix(1);  // DOS's end of file
    for (std::uint64_t number = 1; !content.empty(); number++) {
        const std::size_t first = std::min(content.find('\n'), content.size());
        const bool has_quotes = std::memchr(content.data(), '"', first) != nullptr && number > skip;
        const std::size_t end = has_quotes ? with_breaks(content, first) : first;
        std::string_view text = content.substr(0, end);
        content.remove_prefix(std::min(end + 1, content.size()));
        *line = number;
        if (end > first) number += static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
        if (*line <= skip) continue;
        while (!text.empty() && text.back() == '\r') text.remove_suffix(1);
        if (end == first && text.find('\r') != std::string_view::npos)
            return "a carriage return within the line; save the file with one kind of line ends";
        const std::string_view kept = without_comment(text);
        const std::string_view whole = text;
        const bool commented = kept.size() != text.size();  // tabs in front of a comment are no columns
        const std::string_view comment = commented ? text.substr(kept.size()) : std::string_view();
        text = kept;
        while (!text.empty() && (text.back() == ' ' || (commented && is_blank(text.back())))) text.remove_suffix(1);
        if (without_blanks(text).empty()) {
            const std::size_t words = whole.find_first_not_of("#%/ \t\r");
            if (lines->empty() && words != std::string_view::npos) *above = whole.substr(words);
            continue;
        }
        lines->push_back({text, *line, comment});
    }
    return {};
}

bool cut_line(std::string_view line, char delimiter, std::vector<Field>* fields) {
    fields->clear();
    std::size_t at = 0;
    Field field{};
    if (delimiter == ' ') {
        for (;;) {
            while (at < line.size() && is_blank(line[at])) at++;
            if (at == line.size()) return true;
            if (!take_field(line, &at, is_blank, &field)) return false;
            fields->push_back(field);
        }
    }
    if (delimiter == 0) {
        const auto ends = [](char c) { return is_blank(c) || c == ',' || c == ';'; };
        line = without_blanks(line);
        bool due = false;  // a field, behind a comma
        for (;;) {
            while (at < line.size() && is_blank(line[at])) at++;
            if (at == line.size()) break;
            if (line[at] == ',' || line[at] == ';') {
                fields->push_back({line.substr(at, 0), false});
            } else {
                if (!take_field(line, &at, ends, &field)) return false;
                fields->push_back(field);
                while (at < line.size() && is_blank(line[at])) at++;
            }
            due = at < line.size() && (line[at] == ',' || line[at] == ';');
            if (due) at++;
        }
        if (due) fields->push_back({line.substr(at, 0), false});
        return true;
    }
    for (;;) {
        while (at < line.size() && is_blank(line[at]) && line[at] != delimiter) at++;
        if (at == line.size()) {
            fields->push_back({line.substr(at, 0), false});
            return true;
        }
        if (!take_field(
                line, &at, [&](char c) { return c == delimiter; }, &field))
            return false;
        if (field.text.empty() && !field.quoted) field.text = line.substr(at, 0);
        fields->push_back(field);
        if (at == line.size()) return true;
        at++;
    }
}

std::string name_in(const Field& field) {
    std::string name(field.text);
    for (std::size_t at = 0; field.quoted && (at = name.find("\"\"", at)) != std::string::npos; at++) name.erase(at, 1);
    return name;
}

FieldKind read_field(const Field& field, bool decimal_comma, double* value) {
    if (field.text.empty()) return FieldKind::empty;
    char replaced[64];
    std::string_view text = field.text;
    const std::size_t comma = decimal_comma ? text.find(',') : std::string_view::npos;
    if (comma != std::string_view::npos) {
        const bool between =
            comma > 0 && comma + 1 < text.size() && is_digit(text[comma - 1]) && is_digit(text[comma + 1]);
        if (!between || text.size() > sizeof replaced || text.find('.') != std::string_view::npos)
            return FieldKind::word;
        std::memcpy(replaced, text.data(), text.size());
        replaced[comma] = '.';
        text = std::string_view(replaced, text.size());
    }
    const char* at = text.data();
    const char* const end = at + text.size();
    const NumberKind kind = parse_double(at, end, value);
    if (kind == NumberKind::not_a_number || at != end) return FieldKind::word;
    return kind == NumberKind::finite ? FieldKind::number : FieldKind::not_finite;
}

bool is_header_line(const std::vector<Field>& fields) {
    bool word = false;
    double ignored;
    bool of_pandas = fields.size() > 2 && fields[0].text.empty();  // ,0,1,2
    for (std::size_t i = 1; i < fields.size() && of_pandas; i++) of_pandas = fields[i].text == std::to_string(i - 1);
    if (of_pandas) return true;
    for (const Field& field : fields) {
        if (field.text.empty()) continue;
        const FieldKind kind = read_field(field, true, &ignored);
        if (kind == FieldKind::number || kind == FieldKind::not_finite) return false;
        const char first = field.text.front();
        if (first == '"') return false;  // fields in quotes that another delimiter parts
        if (is_digit(first) || first == '.' || first == '+' || first == '-') return false;
        bool letter = false;
        for (const char c : field.text) letter = letter || is_letter(c);
        if (!letter) return false;
        word = true;
    }
    return word;
}

}  // namespace netmesh::tool
