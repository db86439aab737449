// How a step of the tool ends: an exit code and what to tell the user.
#pragma once
#include <string>
#include <utility>

namespace netmesh::tool {

enum class Exit : int {
    done = 0,
    internal = 1,
    usage = 2,
    data = 3,        // bad data, or a file that cannot be read or written
    memory = 4,      // arena too small
    degenerate = 5,  // input that the command refuses
    cancelled = 6,
    check = 7,
};

// done has no message; every other outcome has one complete sentence, with file and line where there are any.
struct Outcome {
    Exit exit = Exit::done;
    std::string message;

    bool good() const { return exit == Exit::done; }
};

inline Outcome usage_error(std::string message) { return {Exit::usage, "netmesh: " + std::move(message)}; }
inline Outcome data_error(std::string message) { return {Exit::data, std::move(message)}; }

}  // namespace netmesh::tool
