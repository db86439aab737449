#include "laboratory/weighted_cells.hpp"

namespace netmesh {
namespace {

// Lets another point of the domain at this distance count.
void meet(WeightedCell* cell, double length, double weight) {
    if (length < cell->feature_size) cell->feature_size = length;
    if (length - weight + cell->weight < 2 * cell->in_radius) cell->in_radius = 0.5 * (length - weight + cell->weight);
    const double own = cell->weight / (length - weight), other = weight / (length - cell->weight);
    if (!(own <= cell->epsilon && own >= 0)) cell->epsilon = own >= 0 ? own : infinity;
    if (!(other <= cell->epsilon && other >= 0)) cell->epsilon = other >= 0 ? other : infinity;
}

}  // namespace

[[gnu::cold]] void measure_weighted_cells(const HierarchyView& mesh, WeightedCell* cells) {
    for (std::uint32_t d = 0; d < mesh.cage_count; ++d) cells[d] = {0, infinity, infinity, 0};
    for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
        const std::uint32_t d = mesh.domains[v];
        if (d == none || !mesh.is_exempt(v)) continue;
        const double length = mesh.distance(mesh.point(v), mesh.point(mesh.cages[d].centre));
        if (length > cells[d].weight) cells[d].weight = length;
    }
    for (std::uint32_t d = 0; d < mesh.cage_count; ++d) {
        const double* const centre = mesh.point(mesh.cages[d].centre);
        const std::uint32_t around = mesh.cages[d].parent;
        for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
            if (mesh.domains[v] == around && !(around == none && mesh.is_exempt(v)))
                meet(&cells[d], mesh.distance(centre, mesh.point(v)), 0);
        for (std::uint32_t e = 0; e < mesh.cage_count; ++e)
            if (e != d && mesh.cages[e].parent == around)
                meet(&cells[d], mesh.distance(centre, mesh.point(mesh.cages[e].centre)), cells[e].weight);
    }
}

}  // namespace netmesh
