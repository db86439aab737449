// Violations of inputs, markers and quality. The cells are always the Delaunay triangulation of the vertices.
#include <algorithm>

#include "plants.hpp"

namespace referee {
namespace {

bool input_moved_by_an_ulp(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, input_marker);
    double& x = mesh->vertices[v][p.random.below(static_cast<std::size_t>(mesh->dim))];
    x = std::nextafter(x, INFINITY);
    return p.tool.triangulate(mesh);
}

bool inputs_exchanged(Mesh* mesh, const Planter& p) {
    const std::uint32_t u = p.any(*mesh, input_marker), v = p.any(*mesh, input_marker);
    if (u == v) return false;
    exchange_vertices(mesh, u, v);
    return true;
}

bool input_missing(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, input_marker);
    for (const CageLine& cage : mesh->cages)
        if (cage.centre == v) return false;
    remove_vertex(mesh, v);
    return p.tool.triangulate(mesh);
}

bool input_too_many(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, input_marker);
    const Point x = p.beside(*mesh, v, 0.5 * p.nearest(*mesh, v));
    std::uint32_t inputs = 0;
    while (inputs < mesh->count() && mesh->markers[inputs] == input_marker) inputs++;
    mesh->vertices.insert(mesh->vertices.begin() + inputs, x);
    mesh->markers.insert(mesh->markers.begin() + inputs, input_marker);
    if (!mesh->values.empty()) mesh->values.insert(mesh->values.begin() + inputs, 0.0);
    return p.tool.triangulate(mesh);
}

// The vertex behind the last input, or the last input.
std::uint32_t first_behind_inputs(const Mesh& mesh) {
    std::uint32_t v = 0;
    while (v < mesh.count() && mesh.markers[v] == input_marker) v++;
    return v;
}

bool steiner_as_input(Mesh* mesh, const Planter&) {
    const std::uint32_t v = first_behind_inputs(*mesh);
    for (std::uint32_t u = v; u < mesh->count(); u++)
        if (mesh->markers[u] == steiner_marker) {
            exchange_vertices(mesh, u, v);
            mesh->markers[v] = input_marker;
            return true;
        }
    return false;
}

bool input_as_steiner(Mesh* mesh, const Planter&) {
    mesh->markers[first_behind_inputs(*mesh) - 1] = steiner_marker;
    return true;
}

bool input_as_exempt(Mesh* mesh, const Planter&) {
    mesh->markers[first_behind_inputs(*mesh) - 1] = exempt_marker;
    return true;
}

bool input_behind_others(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, steiner_marker);
    if (v == outside) return false;
    exchange_vertices(mesh, v, first_behind_inputs(*mesh) - 1);
    return true;
}

bool steiner_missing(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, steiner_marker);
    if (v == outside) return false;
    remove_vertex(mesh, v);
    return p.tool.triangulate(mesh);
}

bool all_steiner_missing(Mesh* mesh, const Planter& p) {
    bool any = false;
    for (std::uint32_t v = static_cast<std::uint32_t>(mesh->count()); v-- > 0;)
        if (mesh->markers[v] == steiner_marker) {
            remove_vertex(mesh, v);
            any = true;
        }
    return any && p.tool.triangulate(mesh);
}

bool steiner_beside_another(Mesh* mesh, const Planter& p) {
    const std::uint32_t u = p.any(*mesh, steiner_marker), v = p.any(*mesh, steiner_marker);
    if (u == outside || u == v) return false;
    mesh->vertices[u] = p.beside(*mesh, v, 1e-3 * p.nearest(*mesh, v));
    return p.tool.triangulate(mesh);
}

bool twin(Mesh* mesh, const Planter& p, int of, int marker) {
    const std::uint32_t v = p.any(*mesh, of);
    if (v == outside) return false;
    add_vertex(mesh, p.beside(*mesh, v, 1e-3 * p.nearest(*mesh, v)), marker);
    return p.tool.triangulate(mesh);
}
bool steiner_beside_input(Mesh* mesh, const Planter& p) { return twin(mesh, p, input_marker, steiner_marker); }
bool exempt_beside_input(Mesh* mesh, const Planter& p) { return twin(mesh, p, input_marker, exempt_marker); }
bool exempt_beside_steiner(Mesh* mesh, const Planter& p) { return twin(mesh, p, steiner_marker, exempt_marker); }

// The file of which version 0.1.0 said "aspect ratio at most 2.4991": twins 1e-7 from all Steiner points, all exempt.
bool exempt_twins(Mesh* mesh, const Planter& p) {
    const std::size_t count = mesh->count();
    bool any = false;
    for (std::uint32_t v = 0; v < count; v++) {
        if (mesh->markers[v] != steiner_marker) continue;
        any = true;
        mesh->markers[v] = exempt_marker;
        add_vertex(mesh, p.beside(*mesh, v, 1e-7 * p.nearest(*mesh, v)), exempt_marker);
    }
    return any && p.tool.triangulate(mesh);
}

bool steiner_as_exempt(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, steiner_marker);
    if (v == outside) return false;
    mesh->markers[v] = exempt_marker;
    return true;
}

bool all_steiner_as_exempt(Mesh* mesh, const Planter& p) {
    if (p.any(*mesh, steiner_marker) == outside) return false;
    std::replace(mesh->markers.begin(), mesh->markers.end(), static_cast<int>(steiner_marker),
                 static_cast<int>(exempt_marker));
    return true;
}

// A Steiner point goes, and its neighbours, whose cells it kept small, are marked exempt.
bool missing_and_exempt(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, steiner_marker);
    if (v == outside) return false;
    bool any = false;
    for (const Entries& cell : mesh->cells) {
        const auto end = cell.begin() + mesh->dim + 1;
        if (std::find(cell.begin(), end, v) == end) continue;
        for (int i = 0; i <= mesh->dim; i++)
            if (cell[i] != v && mesh->markers[cell[i]] == steiner_marker) {
                mesh->markers[cell[i]] = exempt_marker;
                any = true;
            }
    }
    remove_vertex(mesh, v);
    return any && p.tool.triangulate(mesh);
}

// A Steiner point of the inputs' neighbourhood: what is exempt now is what bounds an input's cell.
bool exempt_near_centre(Mesh* mesh, const Planter& p) {
    Point x = mesh->centre;
    const Point d = p.random.direction(mesh->dim);
    for (int k = 0; k < mesh->dim; k++) x[k] += 0.5 * mesh->radius * p.random.unit() * d[k];
    add_vertex(mesh, x, exempt_marker);
    return p.tool.triangulate(mesh);
}

bool exempt_between_domain_and_hull(Mesh* mesh, const Planter& p) {
    Point x = mesh->centre;
    const Point d = p.random.direction(mesh->dim);
    for (int k = 0; k < mesh->dim; k++) x[k] += 1.02 * mesh->radius * d[k];
    add_vertex(mesh, x, exempt_marker);
    return p.tool.triangulate(mesh);
}

bool exempt_on_the_sphere(Mesh* mesh, const Planter& p) {
    const double spacing = 1e-3 * mesh->radius;
    Point x = mesh->centre, y = mesh->centre;
    const Point d = p.random.direction(mesh->dim);
    for (int k = 0; k < mesh->dim; k++) {
        x[k] += mesh->radius * d[k];
        y[k] += mesh->radius * (d[k] + (k == 0 ? spacing / mesh->radius : 0));
    }
    const double length = distance(y, mesh->centre, mesh->dim);
    for (int k = 0; k < mesh->dim; k++) y[k] = mesh->centre[k] + mesh->radius / length * (y[k] - mesh->centre[k]);
    add_vertex(mesh, x, exempt_marker);
    add_vertex(mesh, y, exempt_marker);
    return p.tool.triangulate(mesh);
}

// A vertex on the hull: exempt, and farthest from the domain's centre.
std::uint32_t hull_vertex(const Mesh& mesh) {
    std::uint32_t found = outside;
    double most = 0;
    for (std::uint32_t v = 0; v < mesh.count(); v++) {
        const double d = distance(mesh.vertices[v], mesh.centre, mesh.dim);
        if (d > most) {
            most = d;
            found = v;
        }
    }
    return found;
}

bool hull_as_steiner(Mesh* mesh, const Planter&) {
    mesh->markers[hull_vertex(*mesh)] = steiner_marker;
    return true;
}

bool hull_vertex_missing(Mesh* mesh, const Planter& p) {
    remove_vertex(mesh, hull_vertex(*mesh));
    return p.tool.triangulate(mesh);
}

bool frame_drawn_in(Mesh* mesh, const Planter& p) {
    for (std::uint32_t v = 0; v < mesh->count(); v++) {
        const double d = distance(mesh->vertices[v], mesh->centre, mesh->dim);
        if (mesh->markers[v] != exempt_marker || d < 1.01 * mesh->radius) continue;
        for (int k = 0; k < mesh->dim; k++)
            mesh->vertices[v][k] = mesh->centre[k] + 1.01 * mesh->radius / d * (mesh->vertices[v][k] - mesh->centre[k]);
    }
    return p.tool.triangulate(mesh);
}

bool net_vertex_inside(Mesh* mesh, const Planter& p) {
    std::uint32_t v = outside;
    for (int trial = 0; trial < 100; trial++) {
        v = p.any(*mesh, exempt_marker);
        if (v != outside && distance(mesh->vertices[v], mesh->centre, mesh->dim) < 1.01 * mesh->radius) break;
        v = outside;
    }
    if (v == outside) return false;
    for (int k = 0; k < mesh->dim; k++) mesh->vertices[v][k] += 0.1 * (mesh->centre[k] - mesh->vertices[v][k]);
    return p.tool.triangulate(mesh);
}

bool net_twin(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, exempt_marker);
    if (v == outside || distance(mesh->vertices[v], mesh->centre, mesh->dim) > 1.01 * mesh->radius) return false;
    Point x = p.beside(*mesh, v, 1e-2 * p.nearest(*mesh, v));
    const double length = distance(x, mesh->centre, mesh->dim);
    for (int k = 0; k < mesh->dim; k++) x[k] = mesh->centre[k] + mesh->radius / length * (x[k] - mesh->centre[k]);
    add_vertex(mesh, x, exempt_marker);
    return p.tool.triangulate(mesh);
}

bool value_times_ten(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, steiner_marker);
    if (v == outside) return false;
    mesh->values[v] *= 10;
    return true;
}

bool value_a_tenth(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.any(*mesh, steiner_marker);
    if (v == outside) return false;
    mesh->values[v] /= 10;
    return true;
}

bool values_exchanged(Mesh* mesh, const Planter&) {
    std::uint32_t least = outside, most = outside;
    for (std::uint32_t v = 0; v < mesh->count(); v++) {
        if (mesh->markers[v] != steiner_marker) continue;
        if (least == outside || mesh->values[v] < mesh->values[least]) least = v;
        if (most == outside || mesh->values[v] > mesh->values[most]) most = v;
    }
    if (least == outside || least == most) return false;
    std::swap(mesh->values[least], mesh->values[most]);
    return true;
}

}  // namespace

const std::vector<Plant>& vertex_plants() {
    constexpr unsigned qualities = plain | caged | netted | sized | thesis;
    static const std::vector<Plant> all = {
        {"an input is moved by an ulp", all_grounds, true, false, input_moved_by_an_ulp},
        {"two inputs are exchanged", all_grounds, true, false, inputs_exchanged},
        {"an input is missing", all_grounds, true, false, input_missing},
        {"an input too many", all_grounds, true, false, input_too_many},
        {"a Steiner point passes as an input", meshes, true, false, steiner_as_input},
        {"an input passes as a Steiner point", meshes, true, false, input_as_steiner},
        {"an input passes as exempt", meshes, true, false, input_as_exempt},
        {"an input behind a Steiner point", meshes, true, true, input_behind_others},
        {"a Steiner point is missing", meshes, false, false, steiner_missing},
        {"all Steiner points are missing", meshes, false, false, all_steiner_missing},
        {"a Steiner point beside another", qualities, false, false, steiner_beside_another},
        {"a Steiner point beside an input", qualities, false, false, steiner_beside_input},
        {"an exempt vertex beside an input", meshes, true, false, exempt_beside_input},
        {"an exempt vertex beside a Steiner point", meshes, false, false, exempt_beside_steiner},
        {"exempt twins of all Steiner points", meshes, true, false, exempt_twins},
        {"a Steiner point passes as exempt", meshes, false, false, steiner_as_exempt},
        {"all Steiner points pass as exempt", meshes, true, false, all_steiner_as_exempt},
        {"a Steiner point is missing, those around it are exempt", meshes, false, false, missing_and_exempt},
        {"an exempt vertex within the domain", meshes, true, false, exempt_near_centre},
        {"an exempt vertex between domain and hull", meshes, false, false, exempt_between_domain_and_hull},
        {"two exempt vertices near each other on the domain's sphere", meshes, false, false, exempt_on_the_sphere},
        {"a vertex of the hull passes as a Steiner point", meshes, true, false, hull_as_steiner},
        {"a vertex of the hull is missing", meshes, false, false, hull_vertex_missing},
        {"the frame is drawn in to the domain", meshes, false, false, frame_drawn_in},
        {"a vertex of the boundary net inside the domain", netted, true, false, net_vertex_inside},
        {"a twin in the boundary net", netted, true, false, net_twin},
        {"a value is ten times as large", certified | clipped, false, false, value_times_ten},
        {"a value is a tenth", certified | clipped, false, false, value_a_tenth},
        {"two values are exchanged", certified | clipped, false, false, values_exchanged},
    };
    return all;
}

}  // namespace referee
