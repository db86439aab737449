// Cages as netmesh.h defines them, with e = 1/2 and r a cage's radius. Its centre is an input. The balls of cages are
// nested or disjoint. A vertex strictly inside the ball is in the cage; its domain is the innermost cage that it is in.
//   - Inputs in the cage are within e r of the centre.
//   - Its shell: 2 D exempt vertices of its domain, farther than e r from the centre.
//   - From r up to 2 r / e there are only exempt vertices, and Steiner points of cages that the centre is not in.
//   - The ball lies in the ball e r' that the domain around it is clipped to.
// Cages of the thesis have e = 0.3 and nobody is excused:
//   - Inputs in the cage, but for those of its shell, are within e r of the centre.
//   - Its shell: vertices of its domain, exempt ones or inputs, one within 1/16 of .64 r of each point of the template
//     (templates.hpp) on the sphere of radius .64 r, and no other exempt vertices.
//   - From r up to 2 r / e there is no vertex at all.
//   - There is one outermost cage, and nothing outside of it but exempt vertices of the hull.
// (Whether every exempt vertex inside the domain is of a shell is a question of markers, quality.hpp.)
#pragma once
#include "mesh_file.hpp"
#include "verdict.hpp"

namespace referee {

constexpr int no_cage = -1;
constexpr double cage_inner = 0.5, cage_outer = 4;
constexpr double thesis_inner = 0.3, thesis_outer = 2 / 0.3, thesis_sphere = 0.64, thesis_off = 0.0625;

struct Hierarchy {
    std::vector<int> domain;  // of each vertex: the innermost cage; no_cage for none
    std::vector<int> parent;  // of each cage
};

bool is_in_cage(const Mesh& mesh, int cage, std::uint32_t v);
bool is_shell(const Mesh& mesh, const Hierarchy& hierarchy, std::uint32_t v);
// With cages of the thesis: an input in the place of a shell vertex.
bool stands_in_shell(const Mesh& mesh, const Hierarchy& hierarchy, std::uint32_t v);
Hierarchy judge_cages(const Mesh& mesh, Verdict* verdict);

// The ball that cells of a domain are clipped to. With cages of the thesis they are not clipped: a ball so large that
// a cell that leaves it is larger than any tau admits.
inline double clip_radius(const Mesh& mesh, int cage) {
    if (mesh.thesis_cages) {
        double most = mesh.radius;
        for (const CageLine& line : mesh.cages) most = std::max(most, line.radius);
        return 64 * most * std::max(3.0, mesh.tau);
    }
    return cage == no_cage ? mesh.radius : cage_inner * mesh.cages[static_cast<std::size_t>(cage)].radius;
}
inline const Point& clip_centre(const Mesh& mesh, int cage) {
    return cage == no_cage ? mesh.centre : mesh.vertices[mesh.cages[static_cast<std::size_t>(cage)].centre];
}

}  // namespace referee
