// A mesh as its files say it: TetGen's .node, .ele and .neigh with the remarks of `netmesh`.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "exact.hpp"

namespace referee {

enum Marker : int { input_marker = 0, steiner_marker = 1, exempt_marker = 2 };
constexpr std::uint32_t outside = UINT32_MAX;

using Entries = std::array<std::uint32_t, dim_max + 1>;

struct CageLine {
    std::uint32_t centre;
    double radius;
};

struct Mesh {
    int dim = 0;
    std::vector<Point> vertices;
    std::vector<int> markers;
    std::vector<double> values;  // the attribute, where there is one
    std::vector<Entries> cells, neighbours;
    bool has_domain = false;
    Point centre = {};
    double radius = 0;
    double tau = 0, ratio = 0, eps = 0;  // 0: the file does not say
    bool clipped = false;                // the ratio is that of cells clipped to the domain
    double least_size = 0, growth = 0;   // of `# cell-size`
    double net = 0;                      // of `# boundary-net`
    std::vector<CageLine> cages;
    bool thesis_cages = false;  // of which kind they are

    std::size_t count() const { return vertices.size(); }
};

// Reads stem.node, stem.ele, stem.neigh. An empty text, or what is wrong with them.
std::string read_mesh(const std::string& stem, Mesh* mesh);
void write_mesh(const std::string& stem, const Mesh& mesh);
void write_points(const std::string& path, const std::vector<Point>& points, int dim);

}  // namespace referee
