#include "command.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "mesh_file.hpp"

namespace referee {

bool parse(int count, char** words, const std::vector<std::string>& names, Command* command) {
    if (count < 2 || count % 2 != 0) return false;
    command->tool = words[1];
    for (int i = 2; i < count; i += 2) {
        const std::string name = words[i], value = words[i + 1];
        if (std::find(names.begin(), names.end(), name) == names.end()) return false;
        if (name == "--seed") command->seed = std::strtoull(value.c_str(), nullptr, 0);
        if (name == "--minutes") command->minutes = std::atof(value.c_str());
        if (name == "--sets") command->sets = std::atoi(value.c_str());
        if (name == "--trial") command->trial = value;
        if (name == "--plants") command->plants = value;
        if (name == "--keep") command->keep = value;
        if (name == "--judge") command->stem = value;
    }
    return true;
}

std::vector<std::uint64_t> numbers_of(const std::string& text) {
    std::vector<std::uint64_t> numbers;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ':');) numbers.push_back(std::strtoull(part.c_str(), nullptr, 0));
    return numbers;
}

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

std::vector<int> dimensions_of(const Tool& tool) {
    std::vector<int> dims = {2, 3};
    std::vector<Point> simplex(5);
    for (std::size_t i = 0; i < 4; i++) simplex[i][i] = 1;
    write_points(tool.path("simplex.txt"), simplex, 4);
    if (tool.run({"delaunay", tool.path("simplex.txt"), "-o", tool.path("simplex.node")}, 60).exit == done) {
        dims.push_back(4);
    } else {
        std::printf("D = 4 is left out: the tool was built without it\n");
    }
    return dims;
}

}  // namespace referee
