#include "tools/manual.hpp"

#include "tools/option_table.hpp"
#include "tools/sample/shapes.hpp"

namespace netmesh::tool {

namespace {

// Text whose lines the reader's program breaks: one blank between words.
std::string flowing(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\n';
        if (!blank || (!out.empty() && out.back() != ' ')) out += blank ? ' ' : c;
    }
    return out;
}

// Text as it is: no character of it is a command of roff's, and no hyphen becomes a longer dash.
std::string escaped(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); i++) {
        const bool begins = i == 0 || text[i - 1] == '\n';
        if (begins && (text[i] == '.' || text[i] == '\'')) out += "\\&";
        if (text[i] == '\\') {
            out += "\\e";
        } else if (text[i] == '-') {
            out += "\\-";
        } else {
            out += text[i];
        }
    }
    return out;
}

std::string section(const std::string& title) { return ".SH " + title + "\n"; }

std::string literal(const std::string& lines) { return ".nf\n" + escaped(lines) + ".fi\n"; }

std::string option(const std::string& name, const char* value, const std::string& help) {
    std::string text = ".TP\n\\fB" + escaped(name) + "\\fR";
    if (value != nullptr) text += " \\fI" + escaped(value) + "\\fR";
    return text + "\n" + escaped(flowing(help)) + "\n";
}

std::string examples_section(const std::string& lines) {
    std::string text;
    for (std::size_t at = 0; at < lines.size(); at = lines.find('\n', at) + 1)
        text += "netmesh " + lines.substr(at, lines.find('\n', at) + 1 - at);
    return section("EXAMPLES") + literal(text);
}

std::string head(const std::string& page, const std::string& summary) {
    std::string title;
    for (const char c : page) title += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    std::string version = version_text();
    version.pop_back();
    return ".TH " + escaped(title) + " 1 \"\" \"" + version + "\" \"netmesh\"\n" + section("NAME") + escaped(page) +
           " \\- " + escaped(summary) + "\n" + section("SYNOPSIS");
}

std::string see_also(Command command) {
    std::string text;
    if (command != Command::none) text = ".BR netmesh (1)";
    for (const CommandEntry& entry : command_entries()) {
        if (entry.command == command) continue;
        if (!text.empty()) text += ",\n";
        text += std::string(".BR netmesh\\-") + entry.name + " (1)";
    }
    return section("SEE ALSO") + text + "\n";
}

std::string program_manual() {
    std::string text = head("netmesh", "quality meshes and certified persistent homology of points") +
                       "\\fBnetmesh\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n" + section("DESCRIPTION") +
                       escaped(points_paragraph) + "\n" + section("COMMANDS");
    for (const CommandEntry& entry : command_entries()) text += option(entry.name, entry.positional, entry.summary);
    text += option("help", "COMMAND", "all options of a command; also netmesh COMMAND --help, -h");
    text += section("OPTIONS") + option("-V, --version", nullptr, "the version") +
            option("--completion", "bash|zsh", "what completes command lines in that shell") +
            option("--manual", "[COMMAND]", "this page, or that of a command");
    return text + examples_section(program_examples) + section("EXIT STATUS") + escaped(exit_paragraph) + "\n" +
           see_also(Command::none);
}

}  // namespace

std::string manual_text(Command command) {
    if (command == Command::none) return program_manual();
    const CommandEntry& entry = entry_of(command);
    std::string text = head(std::string("netmesh-") + entry.name, entry.summary);
    text += std::string("\\fBnetmesh ") + entry.name + "\\fR ";
    if (entry.positional != nullptr) text += "\\fI" + escaped(entry.positional) + "\\fR ";
    text += "[\\fIOPTION\\fR]...\n";
    if (command == Command::sample)
        text += section("SHAPES") + literal(shapes_help());
    else if (*entry.details != 0)
        text += section("DESCRIPTION") + escaped(flowing(entry.details)) + "\n";
    text += section("OPTIONS");
    for (const OptionEntry& each : option_entries()) {
        if ((each.commands & bit(command)) == 0) continue;
        const std::string name = each.name;
        text += option(name == "--quiet" ? "-q, --quiet" : name, each.value, each.help);
    }
    text += option("-h, --help", nullptr, "a shorter form of this text");
    return text + examples_section(entry.examples) + section("EXIT STATUS") + escaped(exit_paragraph) + "\n" +
           see_also(command);
}

}  // namespace netmesh::tool
