// Other programs, each run to its end.
#pragma once
#include <string>
#include <vector>

namespace netmesh::platform {

// The path of the program `name`: in the folder of this one, else in the first folder of PATH that has it. Empty:
// nowhere.
std::string find_program(const std::string& name);

struct ProgramEnd {
    int code = -1;         // -1: a signal ended it
    std::string out, err;  // what it said on stdout and stderr
};

// Runs words[0], a path, with the other words as its arguments and nothing on stdin. False with a phrase in *why where
// it could not be begun, and at an interrupt, which ends it.
bool run_program(const std::vector<std::string>& words, ProgramEnd* end, std::string* why);

}  // namespace netmesh::platform
