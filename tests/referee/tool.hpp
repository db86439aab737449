// The program `netmesh` from outside, in a folder that goes away afterwards.
#pragma once
#include <string>
#include <vector>

#include "mesh_file.hpp"

namespace referee {

// Exit codes of the tool's contract.
enum Exit : int { done = 0, data_exit = 3, memory_exit = 4, degenerate_exit = 5, check_exit = 7, out_of_time = 256 };

struct Outcome {
    int exit = -1;  // 128 and more: a signal, 256: out of time
    std::string message;
};

class Tool {
public:
    explicit Tool(const std::string& binary);
    ~Tool();
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    Outcome run(const std::vector<std::string>& arguments, unsigned seconds) const;

    // `check` on the mesh, with the points where they are not null.
    Outcome check(const Mesh& mesh, const std::vector<Point>* points) const;
    // New cells for the vertices as they are, from `delaunay`; false when it refuses.
    bool triangulate(Mesh* mesh) const;

private:
    std::string binary_, folder_;
};

}  // namespace referee
