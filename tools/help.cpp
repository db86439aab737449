#include "tools/option_table.hpp"
#include "tools/sample/shapes.hpp"

namespace netmesh::tool {

std::string version_text() { return std::string("netmesh ") + netmesh_version_text() + "\n"; }

namespace {

std::string padded(std::string text, std::size_t width) {
    text.resize(text.size() + 2 > width ? text.size() + 2 : width, ' ');
    return text;
}

std::string program_help() {
    std::string text = "netmesh: quality meshes and certified persistent homology of point clouds in R^2 .. R^6\n\n";
    for (const CommandEntry& entry : command_entries()) {
        std::string usage = std::string("  netmesh ") + entry.name + " ";
        usage += entry.positional == nullptr ? "--dim D --points N" : entry.positional;
        if (entry.command == Command::sample) usage += " -n N";
        text += padded(usage, 43) + entry.summary + "\n";
    }
    text +=
        "  netmesh COMMAND --help\n  netmesh --version\n\n"
        "POINTS is a table in text, one point a line (blanks, tabs, commas, semicolons or bars between coordinates,\n"
        "# for comments, - for stdin), or .npy .npz .off .ply .obj .stl .node, or atoms in .xyz .pdb .pqr; .gz around\n"
        "any of them. Data goes to stdout or to the file of -o, messages to stderr.\n"
        "Files appear whole or not at all.\n\n"
        "Exit: 0 done, 1 internal error, 2 usage, 3 bad data or file, 4 memory too small, 5 degenerate input refused,\n"
        "6 cancelled, 7 check failed.\n";
    return text;
}

}  // namespace

std::string help_text(Command command) {
    if (command == Command::none) return program_help();
    const CommandEntry& entry = entry_of(command);
    std::string text = std::string("netmesh ") + entry.name;
    if (entry.positional != nullptr) text += std::string(" ") + entry.positional;
    text += std::string(" [OPTION]...\n\n") + entry.summary + "\n";
    text += command == Command::sample ? "\nshapes:\n" + shapes_help() : std::string(entry.details);
    text += "\noptions:\n";
    for (const OptionEntry& option : option_entries()) {
        if ((option.commands & bit(command)) == 0) continue;
        std::string usage = std::string("  ") + option.name;
        if (option.value != nullptr) usage += std::string(" ") + option.value;
        text += padded(usage, 20) + option.help + "\n";
    }
    return text + padded("  --help", 20) + "this text\n";
}

}  // namespace netmesh::tool
