// How a step of the tool ends: an exit code and what to tell the user.
#pragma once
#include <cstdint>
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

// done has no message; every other outcome has one complete sentence, with file and line where there are any. Without
// it all has been said already.
struct Outcome {
    Exit exit = Exit::done;
    std::string message = {};
    // The place that the message is about, for programs; empty and 0: none. Lines and their fields count from 1.
    std::string file = {};
    std::uint64_t line = 0, field = 0;

    bool good() const { return exit == Exit::done; }
};

inline Outcome usage_error(std::string message) { return {Exit::usage, "netmesh: " + std::move(message)}; }
inline Outcome data_error(std::string message) { return {Exit::data, std::move(message)}; }
// FILE: complaint
inline Outcome file_error(const std::string& file, const std::string& complaint, Exit exit = Exit::data) {
    return {exit, file + ": " + complaint, file};
}
// FILE:LINE: complaint
inline Outcome line_error(const std::string& file, std::uint64_t line, const std::string& complaint,
                          std::uint64_t field = 0, Exit exit = Exit::data) {
    return {exit, file + ":" + std::to_string(line) + ": " + complaint, file, line, field};
}

}  // namespace netmesh::tool
