#include <algorithm>

#include "tools/manual.hpp"
#include "tools/option_table.hpp"
#include "tools/sample/shapes.hpp"

namespace netmesh::tool {

const char* const points_paragraph =
    "POINTS is a table in text, one point a line (blanks, tabs, commas, semicolons or bars between coordinates, # for "
    "comments, - for stdin), or .npy .npz .off .ply .obj .stl .node, or atoms in .xyz .pdb .pqr; .gz around any of "
    "them. Data goes to stdout or to the file of -o, messages to stderr. Files appear whole or not at all. With --json "
    "stdout holds an object also where a run fails, with `error`; of several POINTS one for each.";
const char* const exit_paragraph =
    "Exit: 0 done, 1 internal error, 2 usage, 3 bad data or file, 4 memory too small, 5 degenerate input refused, "
    "6 cancelled, 7 check failed.";
const char* const program_examples = "sample circle -n 60 --noise .05 -o points.csv\n"
                                     "persist points.csv -o diagram.pers --svg diagram.svg\n"
                                     "check diagram.pers --points points.csv\n";

std::string version_text() { return std::string("netmesh ") + netmesh_version_text() + "\n"; }

namespace {

constexpr std::size_t columns = 100, option_indent = 20, command_indent = 43;

// Text behind what stands in the line already, `indent` wide, in lines of at most `columns`; blanks and line ends part
// words.
std::string wrapped(const std::string& text, std::size_t indent) {
    std::string out;
    std::size_t width = indent, at = 0;
    for (;;) {
        at = text.find_first_not_of(" \n", at);
        if (at == std::string::npos) return out + "\n";
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        if (width > indent && width + 1 + end - at > columns) {
            out += "\n" + std::string(indent, ' ');
            width = indent;
        } else if (width > indent) {
            out += ' ';
            width++;
        }
        out += text.substr(at, end - at);
        width += end - at;
        at = end;
    }
}

// `name`, and behind it from column `indent` on what it is.
std::string row(std::string name, std::size_t indent, const std::string& text) {
    if (name.size() + 2 > indent)
        name += "\n" + std::string(indent, ' ');
    else
        name.resize(indent, ' ');
    return name + wrapped(text, indent);
}

std::string examples(const char* lines) {
    std::string text;
    for (std::string rest = lines; !rest.empty(); rest.erase(0, rest.find('\n') + 1))
        text += "  netmesh " + rest.substr(0, rest.find('\n') + 1);
    return text;
}

std::string program_help() {
    std::string text = "netmesh: quality meshes and certified persistent homology of point clouds in R^2 .. R^6\n\n";
    for (const CommandEntry& entry : command_entries()) {
        std::string usage = std::string("  netmesh ") + entry.name + " ";
        usage += entry.positional == nullptr ? "--dim D --points N" : entry.positional;
        if (entry.command == Command::sample) usage += " -n N";
        text += row(usage, command_indent, entry.summary);
    }
    text += row("  netmesh help COMMAND", command_indent, "all options of a command; also netmesh COMMAND --help, -h");
    text += row("  netmesh --version", command_indent, "also -V");
    text += row("  netmesh --completion bash|zsh", command_indent, "what completes command lines in that shell");
    text += row("  netmesh --manual [COMMAND]", command_indent, "the manual page, for man");
    text += "\n" + wrapped(points_paragraph, 0);
    text += "\nexamples:\n" + examples(program_examples);
    return text + "\n" + wrapped(exit_paragraph, 0);
}

}  // namespace

std::string help_text(Command command) {
    if (command == Command::none) return program_help();
    const CommandEntry& entry = entry_of(command);
    std::string text = std::string("netmesh ") + entry.name;
    if (entry.positional != nullptr) text += std::string(" ") + entry.positional;
    text += std::string(" [OPTION]...\n\n") + wrapped(entry.summary, 0);
    if (command == Command::sample)
        text += "\nshapes:\n" + shapes_help();
    else if (*entry.details != 0)
        text += wrapped(entry.details, 0);
    text += "\nexamples:\n" + examples(entry.examples);
    text += "\noptions:\n";
    for (const OptionEntry& option : option_entries()) {
        if ((option.commands & bit(command)) == 0) continue;
        std::string usage = std::string("  ") + option.name;
        if (std::string(option.name) == "--quiet") usage = "  -q, --quiet";
        if (option.value != nullptr) usage += std::string(" ") + option.value;
        text += row(usage, option_indent, option.help);
    }
    return text + row("  -h, --help", option_indent, "this text");
}

}  // namespace netmesh::tool
