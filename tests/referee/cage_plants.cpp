// Violations of cages.
#include "plants.hpp"

namespace referee {
namespace {

CageLine& any_cage(Mesh* mesh, const Planter& p) { return mesh->cages[p.random.below(mesh->cages.size())]; }

// A vertex of some cage's shell, and the cage.
std::uint32_t any_shell(const Mesh& mesh, const Planter& p, CageLine* cage) {
    Verdict ignored;
    const Hierarchy hierarchy = judge_cages(mesh, &ignored);
    std::vector<std::uint32_t> found;
    for (std::uint32_t v = 0; v < mesh.count(); v++)
        if (is_shell(mesh, hierarchy, v)) found.push_back(v);
    if (found.empty()) return outside;
    const std::uint32_t v = found[p.random.below(found.size())];
    *cage = mesh.cages[static_cast<std::size_t>(hierarchy.domain[v])];
    return v;
}

bool cage_missing(Mesh* mesh, const Planter& p) {
    mesh->cages.erase(mesh->cages.begin() + p.random.below(mesh->cages.size()));
    return true;
}

bool all_cages_missing(Mesh* mesh, const Planter&) {
    mesh->cages.clear();
    return true;
}

bool cage_too_many(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, input_marker);
    mesh->cages.push_back({v, 0.4 * p.nearest(*mesh, v)});
    return true;
}

bool larger_cage(Mesh* mesh, const Planter& p) {
    any_cage(mesh, p).radius *= 1.9;
    return true;
}

bool smaller_cage(Mesh* mesh, const Planter& p) {
    any_cage(mesh, p).radius *= 0.6;
    return true;
}

bool cage_of_another_input(Mesh* mesh, const Planter& p) {
    CageLine& cage = any_cage(mesh, p);
    const std::uint32_t v = p.any(*mesh, input_marker);
    if (distance(mesh->vertices[v], mesh->vertices[cage.centre], mesh->dim) < cage.radius) return false;
    cage.centre = v;
    return true;
}

bool cage_of_steiner(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, steiner_marker);
    if (v == outside) return false;
    any_cage(mesh, p).centre = v;
    return true;
}

bool cage_twice(Mesh* mesh, const Planter& p) {
    const CageLine cage = any_cage(mesh, p);
    mesh->cages.push_back(cage);
    return true;
}

bool crossing_cage(Mesh* mesh, const Planter& p) {
    const CageLine cage = any_cage(mesh, p);
    const std::uint32_t v = p.any(*mesh, input_marker);
    const double d = distance(mesh->vertices[v], mesh->vertices[cage.centre], mesh->dim);
    if (d < cage.radius) return false;
    mesh->cages.push_back({v, d});
    return true;
}

bool shell_as_steiner(Mesh* mesh, const Planter& p) {
    CageLine cage;
    const std::uint32_t v = any_shell(*mesh, p, &cage);
    if (v == outside) return false;
    mesh->markers[v] = steiner_marker;
    return true;
}

bool shell_vertex_missing(Mesh* mesh, const Planter& p) {
    CageLine cage;
    const std::uint32_t v = any_shell(*mesh, p, &cage);
    if (v == outside) return false;
    remove_vertex(mesh, v);
    return p.tool.triangulate(mesh);
}

bool move_shell(Mesh* mesh, const Planter& p, double factor) {
    CageLine cage;
    const std::uint32_t v = any_shell(*mesh, p, &cage);
    if (v == outside) return false;
    for (int k = 0; k < mesh->dim; k++) {
        const double c = mesh->vertices[cage.centre][k];
        mesh->vertices[v][k] = c + factor * (mesh->vertices[v][k] - c);
    }
    return p.tool.triangulate(mesh);
}
bool shell_inwards(Mesh* mesh, const Planter& p) { return move_shell(mesh, p, 0.4); }
bool shell_outwards(Mesh* mesh, const Planter& p) { return move_shell(mesh, p, 1.5); }

bool add_at(Mesh* mesh, const Planter& p, double factor, int marker) {
    const CageLine cage = any_cage(mesh, p);
    add_vertex(mesh, p.beside(*mesh, cage.centre, factor * cage.radius), marker);
    return p.tool.triangulate(mesh);
}
bool steiner_around(Mesh* mesh, const Planter& p) { return add_at(mesh, p, 2, steiner_marker); }
bool shell_too_many(Mesh* mesh, const Planter& p) { return add_at(mesh, p, 0.8, exempt_marker); }
bool exempt_inside(Mesh* mesh, const Planter& p) { return add_at(mesh, p, 0.3, exempt_marker); }
bool exempt_around(Mesh* mesh, const Planter& p) { return add_at(mesh, p, 2, exempt_marker); }

// The shell is drawn together to a side: as many vertices, all in their place, and the cage's cell opens.
bool shell_to_a_side(Mesh* mesh, const Planter& p) {
    CageLine cage;
    const std::uint32_t one = any_shell(*mesh, p, &cage);
    if (one == outside) return false;
    Verdict ignored;
    const Hierarchy hierarchy = judge_cages(*mesh, &ignored);
    const Point centre = mesh->vertices[cage.centre], pole = mesh->vertices[one];
    const double length = distance(centre, pole, mesh->dim);
    for (std::uint32_t v = 0; v < mesh->count(); v++) {
        if (hierarchy.domain[v] != hierarchy.domain[one] || !is_shell(*mesh, hierarchy, v) || v == one) continue;
        Point x = pole;
        const Point d = p.random.direction(mesh->dim);
        for (int k = 0; k < mesh->dim; k++) x[k] += 0.05 * length * d[k];
        const double now = distance(centre, x, mesh->dim);
        for (int k = 0; k < mesh->dim; k++) x[k] = centre[k] + length / now * (x[k] - centre[k]);
        mesh->vertices[v] = x;
    }
    return p.tool.triangulate(mesh);
}

// As far from the centre as before, by a sixth of a radius.
bool shell_sideways(Mesh* mesh, const Planter& p) {
    CageLine cage;
    const std::uint32_t v = any_shell(*mesh, p, &cage);
    if (v == outside) return false;
    const Point centre = mesh->vertices[cage.centre], d = p.random.direction(mesh->dim);
    Point& x = mesh->vertices[v];
    const double length = distance(centre, x, mesh->dim);
    double along = 0, across = 0;
    for (int k = 0; k < mesh->dim; k++) along += d[k] * (x[k] - centre[k]) / length;
    Point side = {};
    for (int k = 0; k < mesh->dim; k++) {
        side[k] = d[k] - along * (x[k] - centre[k]) / length;
        across += side[k] * side[k];
    }
    if (across < 0.1) return false;
    for (int k = 0; k < mesh->dim; k++)
        x[k] = centre[k] + (x[k] - centre[k]) * std::cos(1.0 / 6) +
               side[k] / std::sqrt(across) * length * std::sin(1.0 / 6);
    return p.tool.triangulate(mesh);
}

bool other_kind(Mesh* mesh, const Planter&) {
    mesh->thesis_cages = !mesh->thesis_cages;
    return true;
}

}  // namespace

const std::vector<Plant>& cage_plants() {
    static const std::vector<Plant> all = {
        {"a cage is missing", caged | thesis, true, false, cage_missing},
        {"all cages are missing", caged | thesis, true, false, all_cages_missing},
        {"a cage too many", caged | thesis, true, false, cage_too_many},
        {"a cage is larger", caged | thesis, false, false, larger_cage},
        {"a cage is smaller", caged | thesis, false, false, smaller_cage},
        {"a cage has another input as centre", caged | thesis, true, false, cage_of_another_input},
        {"a cage has a Steiner point as centre", caged | thesis, true, false, cage_of_steiner},
        {"a cage stands there twice", caged | thesis, true, false, cage_twice},
        {"a cage crosses another", caged | thesis, false, false, crossing_cage},
        {"a shell vertex passes as a Steiner point", caged | thesis, true, false, shell_as_steiner},
        {"a shell vertex is missing", caged | thesis, true, false, shell_vertex_missing},
        {"a shell vertex is moved inwards", caged | thesis, true, false, shell_inwards},
        {"a shell vertex is moved outwards", caged | thesis, true, false, shell_outwards},
        {"a Steiner point around a cage", caged | thesis, false, false, steiner_around},
        {"a shell vertex too many", caged | thesis, true, false, shell_too_many},
        {"an exempt vertex inside a cage", caged | thesis, false, false, exempt_inside},
        {"an exempt vertex around a cage", caged | thesis, false, false, exempt_around},
        {"a shell on one side", caged | thesis, false, false, shell_to_a_side},
        {"a shell vertex is moved along its sphere", thesis, true, false, shell_sideways},
        {"cages of the thesis pass as compact ones", thesis, true, false, other_kind},
        {"compact cages pass as those of the thesis", caged, true, false, other_kind},
    };
    return all;
}

}  // namespace referee
