#include "plants.hpp"

#include <algorithm>

namespace referee {

std::uint32_t Planter::any(const Mesh& mesh, int marker) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t v = 0; v < mesh.count(); v++)
        if (mesh.markers[v] == marker) found.push_back(v);
    return found.empty() ? outside : found[random.below(found.size())];
}

double Planter::nearest(const Mesh& mesh, std::uint32_t v) const {
    double least = INFINITY;
    for (std::uint32_t u = 0; u < mesh.count(); u++)
        if (u != v) least = std::min(least, distance(mesh.vertices[u], mesh.vertices[v], mesh.dim));
    return least;
}

Point Planter::beside(const Mesh& mesh, std::uint32_t v, double length) const {
    const Point direction = random.direction(mesh.dim);
    Point x = mesh.vertices[v];
    for (int k = 0; k < mesh.dim; k++) x[k] += length * direction[k];
    return x;
}

void add_vertex(Mesh* mesh, const Point& x, int marker) {
    mesh->vertices.push_back(x);
    mesh->markers.push_back(marker);
    if (!mesh->values.empty()) mesh->values.push_back(mesh->values.back());
}

void remove_vertex(Mesh* mesh, std::uint32_t v) {
    mesh->vertices.erase(mesh->vertices.begin() + v);
    mesh->markers.erase(mesh->markers.begin() + v);
    if (!mesh->values.empty()) mesh->values.erase(mesh->values.begin() + v);
    for (CageLine& cage : mesh->cages) cage.centre -= cage.centre > v;
}

void exchange_vertices(Mesh* mesh, std::uint32_t u, std::uint32_t v) {
    std::swap(mesh->vertices[u], mesh->vertices[v]);
    std::swap(mesh->markers[u], mesh->markers[v]);
    if (!mesh->values.empty()) std::swap(mesh->values[u], mesh->values[v]);
    const auto renamed = [&](std::uint32_t w) { return w == u ? v : w == v ? u : w; };
    for (Entries& cell : mesh->cells)
        for (int i = 0; i <= mesh->dim; i++) cell[i] = renamed(cell[i]);
    for (CageLine& cage : mesh->cages) cage.centre = renamed(cage.centre);
}

}  // namespace referee
