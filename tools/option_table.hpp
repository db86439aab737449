// Every command and option of the program, with what the help text says. The parser and the help text are made of
// these.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "tools/options.hpp"

namespace netmesh::tool {

struct CommandEntry {
    Command command;
    const char* name;
    const char* positional;  // the names of all, null for none
    std::size_t positional_count;
    const char* summary;
    const char* details;
    const char* examples;  // lines behind `netmesh`; the files that they name are those of the test that runs them
};

// What an option does: sets a member of the request, by its name in the engine's table, or something of the tool's own.
struct Effect {
    using Apply = std::string (*)(Options&, const std::string& value);  // a complaint, or empty
    Effect(const char* name) : member(name) {}
    Effect(Apply what) : apply(what) {}

    const char* member = nullptr;
    Apply apply = nullptr;
};

struct OptionEntry {
    const char* name;
    unsigned commands;  // a union of bit(command)
    const char* value;  // how the help calls the value; null for a switch
    Effect effect;
    std::string help;
};

constexpr unsigned bit(Command command) { return 1u << static_cast<unsigned>(command); }

const std::vector<CommandEntry>& command_entries();
const std::vector<OptionEntry>& option_entries();

// Not of Command::none.
const CommandEntry& entry_of(Command command);

// The words that an option of a command takes, where it takes words; of --values and --focus they are some of all.
std::vector<std::string> words_of(const OptionEntry& option, Command command);
// Whether its value is the name of a file.
bool names_file(const OptionEntry& option);

// The options that a field of the library's requests comes from, the likeliest first; none for those that come from
// none.
std::vector<std::string> option_names(netmesh_field field);

}  // namespace netmesh::tool
