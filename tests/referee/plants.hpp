// Violations, planted one at a time in the files of good meshes.
#pragma once
#include <string>
#include <vector>

#include "judge.hpp"
#include "tool.hpp"

namespace referee {

enum Ground : unsigned {
    triangulation = 1,  // of points, by `delaunay`
    plain = 2,          // --method svr
    caged = 4,          // --method netmesh, with cages
    netted = 8,         // --method refine, with a boundary net
    sized = 16,         // with --eps
    certified = 32,     // the mesh of `persist --whole-cells`, with a ratio and values
    thesis = 64,        // --method netmesh --cages thesis
    clipped = 128,      // the mesh of `persist`: its cells are clipped to the domain
    meshes = plain | caged | netted | sized | certified | thesis | clipped,
    all_grounds = triangulation | meshes
};

struct Planter {
    const Tool& tool;
    const Mesh& good;
    Random& random;
    double worst;  // ratio of the good mesh, as the referee measured it

    std::uint32_t any(const Mesh& mesh, int marker) const;  // a vertex of that marker; `outside` when there is none
    double nearest(const Mesh& mesh, std::uint32_t v) const;
    Point beside(const Mesh& mesh, std::uint32_t v, double length) const;
};

void add_vertex(Mesh* mesh, const Point& x, int marker);
void remove_vertex(Mesh* mesh, std::uint32_t v);
void exchange_vertices(Mesh* mesh, std::uint32_t u, std::uint32_t v);  // with their ids, the cells stay where they are

struct Plant {
    const char* name;
    unsigned grounds;
    bool certain;    // a violation wherever it can be planted; else it is tried until the referee sees one
    bool malformed;  // `check` may call the file bad data instead
    bool (*plant)(Mesh* mesh, const Planter& planter);  // false: nothing to plant it in
};

const std::vector<Plant>& cell_plants();
const std::vector<Plant>& vertex_plants();
const std::vector<Plant>& remark_plants();
const std::vector<Plant>& cage_plants();

}  // namespace referee
