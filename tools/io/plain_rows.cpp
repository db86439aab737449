#include "tools/io/plain_rows.hpp"

#include <algorithm>
#include <cstring>

#include "tools/io/characters.hpp"
#include "tools/io/table_lines.hpp"

namespace netmesh::tool {

namespace {

bool holds(std::string_view text, char c) { return std::memchr(text.data(), c, text.size()) != nullptr; }

// Whether text[at] stands between two digits.
bool is_between_digits(std::string_view text, std::size_t at) {
    return at > 0 && at + 1 < text.size() && is_digit(text[at - 1]) && is_digit(text[at + 1]);
}

// What may stand in quotes around a number.
bool is_number_like(std::string_view text) {
    const std::string lower = lower_case(without_blanks(text));
    if (lower == "inf" || lower == "infinity") return true;
    return !lower.empty() && lower.find_first_not_of("0123456789+-.,e") == std::string::npos &&
           lower.find_first_of("0123456789") != std::string::npos;
}

// The end of a field in quotes at `at`, behind its last quote; npos where it does not end or is no number.
std::size_t end_of_quoted_number(std::string_view line, std::size_t at) {
    const std::size_t end = line.find('"', at + 1);
    if (end == std::string_view::npos || !is_number_like(line.substr(at + 1, end - at - 1)))
        return std::string_view::npos;
    return end + 1;
}

bool has_quoted_number(std::string_view line) {
    for (std::size_t at = line.find('"'); at != std::string_view::npos;) {
        if (end_of_quoted_number(line, at) != std::string_view::npos) return true;
        at = line.find('"', at + 1);
        at = at == std::string_view::npos ? at : line.find('"', at + 1);
    }
    return false;
}

// How the numbers of a text are written.
struct Habits {
    bool quotes = false;    // around the numbers of all lines but a first one
    bool decimal = false;   // commas
    bool points = false;    // decimal ones
    bool thousands = true;  // every comma may group them: 1,234
    std::uint64_t decimal_line = 0;
};

// 1,234 may be 1.234 or 1234; 0,234 and 1,5 are decimal.
bool may_group(std::string_view line, std::size_t comma) {
    std::size_t from = comma, to = comma + 1;
    while (from > 0 && is_digit(line[from - 1])) from--;
    while (to < line.size() && is_digit(line[to])) to++;
    return to - comma == 4 && comma - from < 4 && line[from] != '0' && (to == line.size() || line[to] != ',');
}

template <class Use> void each_line(std::string_view content, Use use) {
    for (std::uint64_t number = 1; !content.empty(); number++) {
        const std::size_t end = std::min(content.find('\n'), content.size());
        use(content.substr(0, end), number);
        content.remove_prefix(std::min(end + 1, content.size()));
    }
}

Habits habits_of(std::string_view content) {
    Habits habits;
    std::size_t rows = 0, quoted = 0;
    each_line(content, [&](std::string_view line, std::uint64_t number) {
        line = without_comment(line);
        if (without_blanks(line).empty()) return;
        rows++;
        const bool has_quotes = holds(line, '"') && has_quoted_number(line);
        quoted += has_quotes;
        habits.points = habits.points || holds(line, '.');
        const bool parts = line.find_first_of(";\t|") != std::string_view::npos;
        bool in_quotes = false;
        for (std::size_t at = 0; at < line.size() && (parts || has_quotes); at++) {
            if (line[at] == '"') in_quotes = !in_quotes;
            if (line[at] != ',' || !is_between_digits(line, at) || !(parts || in_quotes)) continue;
            if (!habits.decimal) habits.decimal_line = number;
            habits.decimal = true;
            habits.thousands = habits.thousands && may_group(line, at);
        }
    });
    habits.quotes = quoted > 0 && quoted + 1 >= rows && (rows < 2 || quoted > 1 || rows == 2);
    return habits;
}

void append_plain(std::string_view line, const Habits& habits, std::string* plain) {
    bool in_quotes = false;
    for (std::size_t at = 0; at < line.size(); at++) {
        if (line[at] == '"' && !in_quotes && habits.quotes) {
            const std::size_t end = end_of_quoted_number(line, at);
            if (end != std::string_view::npos) {
                for (std::size_t i = at + 1; i + 1 < end; i++)
                    plain->push_back(habits.decimal && line[i] == ',' ? '.' : line[i]);
                at = end - 1;
                continue;
            }
        }
        if (line[at] == '"') in_quotes = !in_quotes;
        const bool is_decimal =
            habits.decimal && line[at] == ',' && !in_quotes && is_between_digits(line, at) && !habits.quotes;
        plain->push_back(is_decimal ? '.' : line[at] == '|' && !in_quotes ? ';' : line[at]);
    }
}

// Whether anything of it is more than numbers and names between commas, semicolons and blanks.
bool is_plain(std::string_view content) {
    bool decimal = false, has_comment = false, has_sign = false;
    if (holds(content, '"') || holds(content, '|') || holds(content, '\x1A')) return false;
    if (holds(content, ',') && (holds(content, ';') || holds(content, '\t')))
        each_line(content, [&](std::string_view line, std::uint64_t) {
            for (std::size_t at = line.find(','); at != std::string_view::npos && !decimal; at = line.find(',', at + 1))
                decimal = is_between_digits(line, at) && line.find_first_of(";\t") != std::string_view::npos;
        });
    if (holds(content, '%') || holds(content, '/') || holds(content, '#'))
        each_line(content, [&](std::string_view line, std::uint64_t) {
            const std::string_view text = without_blanks(line);
            has_comment = has_comment || starts(text, "%") || starts(text, "//");
            const std::size_t sign = line.find('#');
            has_sign = has_sign || (sign != std::string_view::npos && without_comment(line).size() > sign);
        });
    return !decimal && !has_comment && !has_sign;
}

}  // namespace

std::string make_plain(std::string_view content, std::string* plain, std::string* note, std::uint64_t* line) {
    std::string remade;
    content = with_plain_ends(content, &remade);
    if (is_plain(content) && (remade.empty() || !holds(content, '#'))) {
        *plain = std::move(remade);
        return {};
    }
    const Habits habits = habits_of(content);
    *line = habits.decimal_line;
    if (habits.decimal && habits.points) return "points and commas are both decimal here; write numbers in one way";
    if (habits.decimal && habits.thousands)
        return "commas may be decimal or group thousands (1,234); write numbers with points";
    if (habits.decimal) *note = "commas read as decimal";
    if (!content.empty() && content.back() == '\x1A') content.remove_suffix(1);
    plain->reserve(content.size());
    each_line(content, [&](std::string_view row, std::uint64_t) {
        append_plain(without_comment(row), habits, plain);
        plain->push_back('\n');
    });
    return {};
}

}  // namespace netmesh::tool
