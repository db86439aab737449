#include "tools/io/other_diagrams.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "tools/io/characters.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/plain_rows.hpp"
#include "tools/io/points.hpp"
#include "tools/io/unpack.hpp"

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

constexpr std::string_view title = "persistence intervals in dim ";  // of ripser's

Outcome parse_ripser(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
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

// Which words of a row are degree, birth and death.
struct Places {
    std::size_t words = 3;  // of a row
    std::size_t at[3] = {0, 1, 2};
};

// What others call the three.
std::string place_by_name(const Words& names, Places* places) {
    const std::vector<std::vector<const char*>> known = {
        {"degree", "dimension", "dim", "dims", "homology_dimension", "homology dimension", "hom_dim", "h_dim", "q"},
        {"birth", "births", "b"},
        {"death", "deaths", "d"}};
    places->words = names.size();
    for (std::size_t k = 0; k < 3; k++) {
        places->at[k] = names.size();
        for (std::size_t i = 0; i < names.size(); i++)
            for (const char* const name : known[k])
                if (lower_case(names[i]) == name) places->at[k] = std::min(places->at[k], i);
        if (places->at[k] == names.size())
            return std::string("the header names no column ") + known[k][0] +
                   "; it has to name degree, birth and death";
    }
    return {};
}

std::string_view without_quotes(std::string_view word) {
    const bool has_both = word.size() > 1 && word.front() == '"' && word.back() == '"';
    return has_both ? word.substr(1, word.size() - 2) : word;
}

// Rows of four that all begin with the same prime, the field that GUDHI's programs compute with.
bool begins_with_field(const std::vector<Words>& rows) {
    for (const Words& row : rows)
        if (row.size() != 4 || row[0] != rows[0][0]) return false;
    for (const char* const prime : {"2", "3", "5", "7", "11", "13"})
        if (!rows.empty() && rows[0][0] == prime) return true;
    return false;
}

// Whether comments say that this is a diagram, which may have no bar that was chosen.
bool is_said_empty(std::string_view content) {
    return content.find("# netmesh diagram ") != std::string_view::npos ||
           content.find("# a choice of ") != std::string_view::npos;
}

Outcome parse_text(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    std::string plain, ignored_note;
    std::uint64_t fault_line = 1;
    const std::string unclear = make_plain(content, &plain, &ignored_note, &fault_line);
    if (!unclear.empty()) return line_error(name, fault_line, unclear);
    if (!plain.empty()) content = plain;
    LineReader reader(content, plain.empty());
    std::string_view line;
    std::vector<Words> rows;
    std::vector<std::uint64_t> lines;
    Places places;
    bool has_header = false;
    while (reader.next_content(&line)) {
        const char* const marks = line.find(';') != std::string_view::npos    ? ";"
                                  : line.find(',') != std::string_view::npos  ? ","
                                  : line.find('\t') != std::string_view::npos ? "\t"
                                                                              : nullptr;
        Words words = marks != nullptr ? split_by(line, marks) : split_blanks(line);
        for (std::string_view& word : words) word = without_quotes(word);
        std::string text(line);  // words alone, the first of which may be empty
        text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
        if (rows.empty() && !has_header && words.size() > 1 && is_header(text)) {
            has_header = true;
            const std::string complaint = place_by_name(words, &places);
            if (!complaint.empty()) return line_error(name, reader.number(), complaint);
            continue;
        }
        rows.push_back(std::move(words));
        lines.push_back(reader.number());
    }
    if (rows.empty() && !has_header && !is_said_empty(content))
        return file_error(name, "no diagram: it has no line `degree birth death`, no head and no header");
    if (!has_header && begins_with_field(rows)) places = {4, {1, 2, 3}};
    for (std::size_t i = 0; i < rows.size(); i++) {
        const std::size_t more = has_header && rows[i].size() == places.words + 1;  // names of rows, as R writes them
        Bar bar;
        std::string complaint;
        if (rows[i].size() == 2)
            complaint = "2 fields, which say no degree; a line is: degree birth death";
        else if (rows[i].size() != places.words + more)
            complaint = counted(rows[i].size(), "field", "fields") + "; a line is: degree birth death";
        else
            complaint = make_bar(
                {rows[i][places.at[0] + more], rows[i][places.at[1] + more], rows[i][places.at[2] + more]}, &bar);
        if (!complaint.empty()) return line_error(name, lines[i], complaint);
        bars->push_back(bar);
    }
    return {};
}

// Lists in lists, as Python prints and JSON holds them: [degree, birth, death], GUDHI's (degree, (birth, death)), or a
// list of [birth, death] for each degree, as ripser.py and persim have them.
Outcome parse_lists(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    struct Level {
        std::size_t lists = 0;  // in it so far
        Words words;
    };
    std::vector<Level> levels(1);
    const auto fault = [&](const std::string& complaint) {
        return file_error(name, "bar " + std::to_string(bars->size() + 1) + ": " + complaint);
    };
    for (std::size_t at = 0; at < content.size();) {
        const char c = content[at];
        if (c == '[' || c == '(') {
            levels.emplace_back();
            at++;
        } else if (c == ']' || c == ')') {
            if (levels.size() < 2) return fault("a bracket that nothing opens");
            const Level level = std::move(levels.back());
            levels.pop_back();
            Level& outer = levels.back();
            at++;
            outer.lists++;
            if (level.words.empty() || level.lists > 0) continue;
            Bar bar;
            std::string complaint =
                "is not [degree, birth, death], (degree, (birth, death)) or, in the list of a degree, "
                "[birth, death]";
            const std::string degree = std::to_string(levels[levels.size() > 2 ? levels.size() - 2 : 0].lists);
            if (level.words.size() == 3)
                complaint = make_bar(level.words, &bar);
            else if (level.words.size() == 2 && outer.words.size() == 1)
                complaint = make_bar({outer.words[0], level.words[0], level.words[1]}, &bar);
            else if (level.words.size() == 2 && outer.words.empty() && levels.size() == 3)
                complaint = make_bar({degree, level.words[0], level.words[1]}, &bar);
            if (!complaint.empty()) return fault(complaint);
            bars->push_back(bar);
        } else if (c == ',' || is_blank(c) || c == '\n') {
            at++;
        } else {
            const std::size_t end = std::min(content.find_first_of("[](), \t\r\n", at), content.size());
            levels.back().words.push_back(content.substr(at, end - at));
            at = end;
        }
    }
    return levels.size() == 1 ? Outcome{} : fault("a bracket that does not end");
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

// numpy.empty((0, 2)) of a degree without a bar.
bool has_no_rows(std::string_view content) {
    const std::string_view head = content.substr(0, 256);
    const std::size_t shape = head.find("'shape': (");
    return shape != std::string_view::npos && starts(head.substr(shape + 10), "0,");
}

// Rows of degree, birth and death; of birth and death where the degree is known.
Outcome parse_array(std::string_view content, const std::string& name, const std::string& degree,
                    std::vector<Bar>* bars) {
    Table table;
    table.name = name;
    TableOptions options;
    options.distances = true;  // which may be infinite
    if (has_no_rows(content)) return {};
    const Outcome outcome = parse_npy_table(content, options, &table);
    if (!outcome.good()) return outcome;
    const std::size_t due = degree.empty() ? 3 : 2;
    if (table.width != due && table.width == 2)
        return file_error(name, "an array of 2 columns, which says no degree; all degrees in one file are "
                                "numpy.savez(FILE, *diagrams)");
    if (table.width != due)
        return file_error(name, "an array of " + counted(table.width, "column", "columns") +
                                    "; a diagram's have degree, birth, death");
    for (std::size_t i = 0; i < table.rows(); i++) {
        const double* const row = &table.values[due * i];
        Bar bar;
        const std::string complaint =
            degree.empty() ? make_bar(row[0], row[1], row[2], &bar) : make_bar(std::stod(degree), row[0], row[1], &bar);
        if (!complaint.empty()) return file_error(name, "row " + std::to_string(i + 1) + ": " + complaint);
        bars->push_back(bar);
    }
    return {};
}

// One array as in .npy, or one of [birth, death] for each degree, which its name ends in: arr_0, dgm1.
Outcome parse_archive(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    std::vector<ZipEntry> entries;
    std::string complaint = list_zip(content, &entries);
    for (std::size_t i = 0; i < entries.size() && complaint.empty(); i++) {
        std::string array = entries[i].name.substr(0, entries[i].name.rfind(".npy")), unpacked;
        const std::string degree = entries.size() == 1 ? "" : array.substr(array.find_last_not_of("0123456789") + 1);
        if (entries.size() > 1 && (degree.empty() || degree.size() > 4))
            return file_error(name, "array " + quoted(array) + ": its name does not end in its degree, as arr_0 does");
        complaint = unzip(entries[i], &unpacked);
        const Outcome outcome =
            complaint.empty() ? parse_array(unpacked, name + ":" + array, degree, bars) : file_error(name, complaint);
        if (!outcome.good()) return outcome;
    }
    return complaint.empty() ? Outcome{} : file_error(name, complaint);
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

bool is_of_ripser(std::string_view content) { return content.find(title) != std::string_view::npos; }

Outcome parse_any_diagram(std::string_view content, const std::string& name, std::vector<Bar>* bars) {
    if (starts(content, "\x93NUMPY")) return parse_array(content, name, "", bars);
    if (starts(content, "PK\x03\x04")) return parse_archive(content, name, bars);
    if (starts(content, "[") || starts(content, "(")) return parse_lists(content, name, bars);
    if (content.size() >= 8 && word_at(content, 0) == dipha_mark) return parse_dipha(content, name, bars);
    if (starts(content, "{")) return parse_json(content, name, bars);
    if (is_of_ripser(content)) return parse_ripser(content, name, bars);
    return parse_text(content, name, bars);
}

}  // namespace netmesh::tool
