// Places of atoms: chemical .xyz, .pdb and .pqr.
#include <array>

#include "tools/io/characters.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/points.hpp"
#include "tools/io/vdw_radii.hpp"

namespace netmesh::tool {

namespace {

bool is_number(std::string_view word) {
    double ignored;
    return parse_finite(std::string(word), &ignored);
}

// An element's symbol or name (C, Fe1), or its number.
bool is_element(std::string_view word) {
    std::uint64_t number;
    if (parse_unsigned(std::string(word), &number)) return number <= 118;
    return !word.empty() && word.size() <= 8 &&
           ((word[0] >= 'A' && word[0] <= 'Z') || (word[0] >= 'a' && word[0] <= 'z'));
}

std::string_view word_of(std::string_view text) {
    const std::vector<std::string_view> words = split_blanks(text);
    return words.empty() ? std::string_view() : words.size() == 1 ? words[0] : text;
}

// Behind the places may be a radius.
template <std::size_t count>
Outcome add_atom(const std::array<std::string_view, count>& words, std::uint64_t line, PointCloud* cloud) {
    for (const std::string_view word : words) {
        double value;
        if (word.empty()) return line_error(cloud->name, line, "an atom without three coordinates");
        if (!parse_finite(std::string(word), &value)) return line_error(cloud->name, line, not_a_number(word));
        cloud->coordinates.push_back(value);
    }
    cloud->lines.push_back(line);
    return {};
}

Outcome add_radius(std::string_view element, std::uint64_t line, PointCloud* cloud) {
    const double radius = van_der_waals_radius(element);
    if (radius == 0)
        return line_error(cloud->name, line,
                          "no van der Waals radius of " + quoted(element) +
                              " is known, but those of the main groups (Mantina et al. 2009); take that atom out, or "
                              "write a table with a column of radii");
    cloud->coordinates.push_back(radius);
    return {};
}

// The element of a line of .pdb: columns 77 and 78, or else the name's, which ends in column 14 and may go on.
std::string_view element_of_pdb(std::string_view line) {
    const std::string_view said = line.size() >= 78 ? word_of(line.substr(76, 2)) : std::string_view();
    if (!said.empty()) return said;
    const std::string_view name = line.substr(12, 4);
    const bool letter = (name[0] >= 'A' && name[0] <= 'Z') || (name[0] >= 'a' && name[0] <= 'z');
    if (!letter) return name.substr(1, 1);
    return name[0] == 'H' && name[3] != ' ' ? name.substr(0, 1) : word_of(name.substr(0, 2));
}

// Nothing is said of them; element and place are columns 1 to 4; anything else is said, or may be.
enum class Columns { plain, extended, other };

// What an extended XYZ file's comment line says of the columns: Properties=species:S:1:pos:R:3, and more columns
// behind. A line with the word alone is other: it may be meant to say it.
Columns columns_of(std::string_view comment) {
    constexpr std::string_view word = "properties", layout = "Properties=species:S:1:pos:R:3";
    const std::string lower = lower_case(comment);
    bool is_layout = false, is_mentioned = false;
    for (std::size_t at = lower.find(word); at != std::string::npos; at = lower.find(word, at + word.size())) {
        const std::string_view rest = comment.substr(at);
        const char behind = rest.size() > layout.size() ? rest[layout.size()] : ' ';
        if (starts(rest, layout) && (behind == ' ' || behind == '\t' || behind == ':')) {
            is_layout = true;
            continue;
        }
        const std::size_t next = rest.find_first_not_of(" \t\"'", word.size());
        if (next != std::string_view::npos && (rest[next] == '=' || rest[next] == ':')) return Columns::other;
        is_mentioned = true;
    }
    return is_layout ? Columns::extended : is_mentioned ? Columns::other : Columns::plain;
}

void note_atoms(const char* format, std::uint64_t left_out, std::uint64_t models, PointCloud* cloud) {
    cloud->note = std::string("read as atoms of ") + format;
    if (left_out > 0) cloud->note += ", without " + std::to_string(left_out) + " at alternate places";
    if (models > 1) cloud->note += ", those of the first of its " + std::to_string(models) + " models";
}

// A cell that is one: files of molecules that are no crystals have a cube of side 1, or zeros.
bool is_crystal(std::string_view line) {
    if (!starts(line, "CRYST1")) return false;
    const std::vector<std::string_view> words = split_blanks(line);
    double side = 0;
    return words.size() > 1 && parse_finite(std::string(words[1]), &side) && side > 1;
}

}  // namespace

bool is_chemical_xyz(std::string_view content) {
    LineReader reader(content, false);
    std::string_view line;
    std::uint64_t count = 0;
    if (!reader.next(&line) || !parse_unsigned(std::string(line), &count) || count == 0) return false;
    if (!reader.next(&line)) return false;
    if (columns_of(line) != Columns::plain) return true;
    bool named = false, numbered = true;
    for (std::uint64_t i = 0; i < count && i < 1000; i++) {
        if (!reader.next(&line)) return named;
        const std::vector<std::string_view> words = split_blanks(line);
        std::uint64_t ignored;
        if (words.size() < 4 || !is_element(words[0]) || !is_number(words[1])) return named;
        named = named || !is_number(words[0]);
        numbered = numbered && parse_unsigned(std::string(words[0]), &ignored);
    }
    return named || numbered;
}

Outcome parse_xyz_atoms(std::string_view content, bool with_radii, PointCloud* cloud) {
    LineReader reader(content, false);
    std::string_view line;
    std::uint64_t count = 0;
    reader.next(&line);
    if (!parse_unsigned(std::string(line), &count) || count == 0)
        return line_error(cloud->name, 1, quoted(line) + " is not a number of atoms");
    reader.next(&line);
    if (line.find("Lattice=") != std::string_view::npos) cloud->cell = {std::string(line), reader.number()};
    if (columns_of(line) == Columns::other)
        return line_error(
            cloud->name, reader.number(),
            "Properties do not begin with species:S:1:pos:R:3; places are read from columns 2 to 4; write these "
            "columns first, and Properties=species:S:1:pos:R:3 without blanks, or take the line's text out");
    cloud->dim = 3;
    for (std::uint64_t i = 0; i < count; i++) {
        if (!reader.next(&line))
            return line_error(cloud->name, reader.number(),
                              "the file ends after " + std::to_string(i) + " of " + counted(count, "atom", "atoms") +
                                  "; line 1 has to say how many there are");
        const std::vector<std::string_view> words = split_blanks(line);
        if (words.size() < 4 || !is_element(words[0]))
            return line_error(cloud->name, reader.number(),
                              "not an atom, `C 1.0 2.0 3.0`; line 1 says that there are " + std::to_string(count));
        Outcome outcome = add_atom<3>({words[1], words[2], words[3]}, reader.number(), cloud);
        if (outcome.good() && with_radii) outcome = add_radius(words[0], reader.number(), cloud);
        if (!outcome.good()) return outcome;
    }
    if (reader.next_content(&line))
        return line_error(cloud->name, reader.number(),
                          "more than the " + counted(count, "atom", "atoms") +
                              " that line 1 speaks of; of several frames cut one out: head -n " +
                              std::to_string(count + 2));
    note_atoms(".xyz", 0, 1, cloud);
    return {};
}

Outcome parse_pdb_atoms(std::string_view content, bool with_radii, PointCloud* cloud) {
    LineReader reader(content, false);
    std::string_view line;
    std::uint64_t models = 0, left_out = 0;
    char place = ' ';  // the alternate places that are taken: those of the first letter
    cloud->dim = 3;
    while (reader.next(&line)) {
        if (starts(line, "MODEL")) models++;
        if (cloud->cell.line == 0 && is_crystal(line)) cloud->cell = {std::string(line), reader.number()};
        if (models > 1 || (!starts(line, "ATOM") && !starts(line, "HETATM"))) continue;
        if (line.size() < 54)
            return line_error(cloud->name, reader.number(),
                              "an atom whose coordinates do not stand in columns 31 to 54; a file with blanks between "
                              "is named .pqr");
        const char here = line[16];
        if (here != ' ' && place == ' ') place = here;
        if (here != ' ' && here != place) {
            left_out++;
            continue;
        }
        Outcome outcome =
            add_atom<3>({word_of(line.substr(30, 8)), word_of(line.substr(38, 8)), word_of(line.substr(46, 8))},
                        reader.number(), cloud);
        if (outcome.good() && with_radii) outcome = add_radius(element_of_pdb(line), reader.number(), cloud);
        if (!outcome.good()) return outcome;
    }
    if (cloud->rows() == 0)
        return line_error(cloud->name, reader.number() == 0 ? 1 : reader.number(),
                          "no line ATOM or HETATM: no atom; a table is named .txt or .csv");
    note_atoms(".pdb", left_out, models, cloud);
    return {};
}

Outcome parse_pqr_atoms(std::string_view content, bool with_radii, PointCloud* cloud) {
    LineReader reader(content, false);
    std::string_view line;
    cloud->dim = 3;
    while (reader.next(&line)) {
        if (!starts(line, "ATOM") && !starts(line, "HETATM")) continue;
        const std::vector<std::string_view> words = split_blanks(line);
        // ATOM number name residue [chain] number x y z charge radius, and perhaps the element
        std::size_t end = words.size();
        if (end > 0 && !is_number(words[end - 1])) end--;
        const bool has_chain = end > 4 && words[4].find_first_of("0123456789") == std::string_view::npos;
        if (end < (has_chain ? 11 : 10) || !is_number(words[end - 1]) || !is_number(words[end - 2]))
            return line_error(cloud->name, reader.number(),
                              "an atom that does not end in x, y, z, charge and radius; with fixed columns it is .pdb");
        const std::string_view x = words[end - 5], y = words[end - 4], z = words[end - 3], radius = words[end - 1];
        const Outcome outcome = with_radii ? add_atom<4>({x, y, z, radius}, reader.number(), cloud)
                                           : add_atom<3>({x, y, z}, reader.number(), cloud);
        if (!outcome.good()) return outcome;
    }
    if (cloud->rows() == 0)
        return line_error(cloud->name, reader.number() == 0 ? 1 : reader.number(),
                          "no line ATOM or HETATM: no atom; a table is named .txt or .csv");
    note_atoms(".pqr", 0, 1, cloud);
    return {};
}

}  // namespace netmesh::tool
