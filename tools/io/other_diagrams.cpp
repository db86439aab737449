#include "tools/io/other_diagrams.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "tools/io/characters.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/points.hpp"

namespace netmesh::tool {

namespace {

using Words = std::vector<std::string_view>;

// A complaint, or empty.
std::string make_bar(double degree, double birth, double death, Bar* bar) {
    if (!is_count(degree) || degree > 1000) return number_text(degree) + " is not a degree";
    if (!std::isfinite(birth)) return number_text(birth) + " is not a birth: finite";
    if (!(death >= birth)) return number_text(death) + " is not a death: inf, or finite and not before the birth";
    *bar = {static_cast<std::uint32_t>(degree), birth, death};
    return {};
}

// Of text: words become the numbers of a bar.
std::string make_bar(const Words& words, Bar* bar) {
    double value[3] = {};
    for (std::size_t i = 0; i < 3; i++) {
        const std::string word = lower_case(words[i]);
        const bool never =
            i == 2 && (word == "inf" || word == "+inf" || word == "infinity" || word == "null" || word.empty());
        if (never) value[i] = HUGE_VAL;
        if (!never && !parse_finite(word, &value[i])) return not_a_number(words[i]);
    }
    return make_bar(value[0], value[1], value[2], bar);
}

// The words between any of `marks`, empty ones too.
Words split_by(std::string_view text, const char* marks) {
    Words words;
    for (;;) {
        const std::size_t end = text.find_first_of(marks);
        std::string_view word = text.substr(0, end);
        while (!word.empty() && (word.back() == ' ' || word.back() == '\t')) word.remove_suffix(1);
        while (!word.empty() && (word.front() == ' ' || word.front() == '\t')) word.remove_prefix(1);
        words.push_back(word);
        if (end == std::string_view::npos) return words;
        text.remove_prefix(end + 1);
    }
}

// ` [0,0.5)` of a degree said above, `[0, )` where it never dies; of a cycle's line what stands before the colon.
std::string take_interval(std::string_view line, std::uint64_t degree, Bar* bar) {
    const std::size_t end = line.find_first_of(")]");
    const Words words = split_by(line.substr(1, end == std::string_view::npos ? end : end - 1), ",");
    if (end == std::string_view::npos || words.size() != 2) return quoted(line) + " is not [birth,death)";
    const std::string text = std::to_string(degree);
    return make_bar({text, words[0], words[1]}, bar);
}

Outcome parse_ripser(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    constexpr std::string_view title = "persistence intervals in dim ";
    LineReader reader(content, false);
    std::string_view line;
    std::uint64_t degree = 0;
    bool is_below = false;
    while (reader.next(&line)) {
        Bar bar;
        std::string complaint;
        if (starts(line, title)) {
            is_below = true;
            const std::size_t end = line.find_first_not_of("0123456789", title.size());
            if (parse_unsigned(std::string(line.substr(title.size(), end - title.size())), &degree)) continue;
            complaint = quoted(line) + " says no degree";
        } else if (!is_below || line.empty() || line[0] != '[') {
            continue;
        } else {
            complaint = take_interval(line, degree, &bar);
        }
        if (!complaint.empty()) return line_error(name, reader.number(), complaint);
        bars->push_back(bar);
    }
    return {};
}

Outcome parse_text(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    LineReader reader(content);
    std::string_view line;
    std::size_t columns = 0;  // that a header names
    bool is_first = true;
    while (reader.next_content(&line)) {
        const bool by_commas = line.find(',') != std::string_view::npos;
        const Words words = by_commas ? split_by(line, ",") : split_blanks(line);
        const bool names = is_first && words.size() > 2 && is_header(line);
        is_first = false;
        if (names) {
            if (lower_case(words[1]) != "birth" || lower_case(words[2]) != "death")
                return line_error(name, reader.number(), "the first three columns have to be degree, birth, death");
            columns = words.size();
            continue;
        }
        Bar bar;
        std::string complaint;
        if (words.size() == 2)
            complaint = "2 fields, which say no degree; a line is: degree birth death";
        else if (words.size() != (columns > 0 ? columns : 3))
            complaint = counted(words.size(), "field", "fields") + "; a line is: degree birth death";
        else
            complaint = make_bar({words[0], words[1], words[2]}, &bar);
        if (!complaint.empty()) return line_error(name, reader.number(), complaint);
        bars->push_back(bar);
    }
    return {};
}

// {"bars": [[0, 0, 1.5], [0, 0, null]], ...}, anywhere in an object.
Outcome parse_json(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    std::size_t at = content.find("\"bars\"");
    at = at == std::string_view::npos ? at : content.find('[', at);
    if (at == std::string_view::npos)
        return file_error(name, "JSON without an entry \"bars\", [[degree, birth, death], ..]");
    for (at++;;) {
        at = content.find_first_of("[]", at);
        if (at != std::string_view::npos && content[at] == ']') return {};
        const std::size_t end = at == std::string_view::npos ? at : content.find(']', at);
        if (end == std::string_view::npos) return file_error(name, "the list \"bars\" does not end");
        const Words words = split_by(content.substr(at + 1, end - at - 1), ",");
        Bar bar;
        std::string complaint = "is not [degree, birth, death]";
        if (words.size() == 3) complaint = make_bar(words, &bar);
        if (!complaint.empty()) return file_error(name, "bar " + std::to_string(bars->size() + 1) + ": " + complaint);
        bars->push_back(bar);
        at = end + 1;
    }
}

Outcome parse_array(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    Table table;
    table.name = name;
    TableOptions options;
    options.distances = true;  // which may be infinite
    const Outcome outcome = parse_npy_table(content, options, &table);
    if (!outcome.good()) return outcome;
    if (table.width != 3)
        return file_error(name, "an array of " + counted(table.width, "column", "columns") +
                                    "; a diagram's have degree, birth, death");
    for (std::size_t i = 0; i < table.rows(); i++) {
        const double* const row = &table.values[3 * i];
        Bar bar;
        const std::string complaint = make_bar(row[0], row[1], row[2], &bar);
        if (!complaint.empty()) return file_error(name, "row " + std::to_string(i + 1) + ": " + complaint);
        bars->push_back(bar);
    }
    return {};
}

// Numbers of 8 bytes, the least significant one first.
std::uint64_t word_at(std::string_view content, std::size_t at) {
    std::uint64_t word = 0;
    for (std::size_t i = 8; i-- > 0;) word = word << 8 | static_cast<unsigned char>(content[at + i]);
    return word;
}
double double_at(std::string_view content, std::size_t at) {
    const std::uint64_t word = word_at(content, at);
    double value;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

constexpr std::uint64_t dipha_mark = 8067171840, dipha_diagram = 2;

// Behind mark, kind and count degree, birth and death each; -1 - degree where it never dies.
Outcome parse_dipha(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    if (content.size() < 24 || word_at(content, 8) != dipha_diagram)
        return file_error(name, "a file of DIPHA, but no diagram (bytes 8 to 15)");
    const std::uint64_t count = word_at(content, 16);
    if (content.size() % 24 != 0 || content.size() / 24 - 1 != count)
        return file_error(name, "says that it has " + grouped_text(count) + " bars, its " +
                                    grouped_text(content.size()) + " bytes are not 24 and 24 for each");
    for (std::uint64_t i = 0; i < count; i++) {
        const std::size_t at = 24 + 24 * static_cast<std::size_t>(i);
        const std::uint64_t degree = word_at(content, at);
        const bool never = degree >> 63 != 0;
        Bar bar;
        const std::string complaint =
            make_bar(static_cast<double>(never ? ~degree : degree), double_at(content, at + 8),
                     never ? HUGE_VAL : double_at(content, at + 16), &bar);
        if (!complaint.empty()) return file_error(name, "bar " + std::to_string(i + 1) + ": " + complaint);
        bars->push_back(bar);
    }
    return {};
}

}  // namespace

Outcome parse_any_diagram(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    if (starts(content, "\x93NUMPY")) return parse_array(content, name, bars);
    if (content.size() >= 8 && word_at(content, 0) == dipha_mark) return parse_dipha(content, name, bars);
    if (starts(content, "{")) return parse_json(content, name, bars);
    if (content.find("persistence intervals in dim ") != std::string_view::npos)
        return parse_ripser(content, name, bars);
    return parse_text(content, name, bars);
}

}  // namespace netmesh::tool
