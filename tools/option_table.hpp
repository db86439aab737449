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

struct OptionEntry {
    const char* name;
    unsigned commands;                                         // a union of bit(command)
    const char* value;                                         // how the help calls the value; null for a switch
    std::string (*apply)(Options&, const std::string& value);  // a complaint, or empty
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

// The option that a field of the library's requests comes from; null for those that come from none.
const char* option_name(netmesh_field field);

}  // namespace netmesh::tool
