// The command lines of both referees.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tool.hpp"

namespace referee {

struct Command {
    std::string tool, trial, plants, keep, stem;
    std::uint64_t seed = 1;
    double minutes = 0;
    int sets = 0;
};

// words[1] is the tool, then come pairs of a name, which must be one of `names`, and a value. False: they do not.
bool parse(int count, char** words, const std::vector<std::string>& names, Command* command);

// The parts of A:B:C.
std::vector<std::uint64_t> numbers_of(const std::string& text);

double now();  // seconds

// Of 2, 3 and 4 those that the tool was built with; 2 and 3 must be.
std::vector<int> dimensions_of(const Tool& tool);

}  // namespace referee
