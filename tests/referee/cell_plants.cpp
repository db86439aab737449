// Violations of .ele and .neigh, and of coordinates under cells that stay as they were.
#include <algorithm>

#include "plants.hpp"

namespace referee {
namespace {

struct FacetAt {
    std::uint32_t cell = outside;
    int i = 0;
};

// A random facet, of the hull or between two cells.
FacetAt any_facet(const Mesh& mesh, Random& random, bool on_hull) {
    for (int trial = 0; trial < 100000; trial++) {
        const std::uint32_t c = random.below(mesh.cells.size());
        const int i = static_cast<int>(random.below(static_cast<std::size_t>(mesh.dim) + 1));
        if ((mesh.neighbours[c][i] == outside) == on_hull) return {c, i};
    }
    return {};
}

// Cell c goes; the last one takes its number.
void remove_cell(Mesh* mesh, std::uint32_t c) {
    const std::uint32_t last = static_cast<std::uint32_t>(mesh->cells.size()) - 1;
    mesh->cells[c] = mesh->cells[last];
    mesh->neighbours[c] = mesh->neighbours[last];
    mesh->cells.pop_back();
    mesh->neighbours.pop_back();
    for (Entries& row : mesh->neighbours)
        for (int i = 0; i <= mesh->dim; i++) row[i] = row[i] == c ? outside : row[i] == last ? c : row[i];
}

// .neigh anew from .ele.
void relink(Mesh* mesh) {
    for (std::uint32_t c = 0; c < mesh->cells.size(); c++) mesh->neighbours[c].fill(outside);
    const auto shared = [&](std::uint32_t a, std::uint32_t b, int* alone) {
        int count = 0;
        for (int i = 0; i <= mesh->dim; i++) {
            const auto end = mesh->cells[b].begin() + mesh->dim + 1;
            std::find(mesh->cells[b].begin(), end, mesh->cells[a][i]) != end ? count++ : * alone = i;
        }
        return count == mesh->dim;
    };
    for (std::uint32_t a = 0; a < mesh->cells.size(); a++)
        for (std::uint32_t b = 0; b < mesh->cells.size(); b++) {
            int alone = 0;
            if (a != b && shared(a, b, &alone)) mesh->neighbours[a][alone] = b;
        }
}

bool hull_cell_missing(Mesh* mesh, const Planter& p) {
    const FacetAt facet = any_facet(*mesh, p.random, true);
    if (facet.cell == outside || mesh->cells.size() < 2) return false;
    remove_cell(mesh, facet.cell);
    return true;
}

bool inner_cell_missing(Mesh* mesh, const Planter& p) {
    for (int trial = 0; trial < 1000; trial++) {
        const std::uint32_t c = p.random.below(mesh->cells.size());
        const auto begin = mesh->neighbours[c].begin(), end = begin + mesh->dim + 1;
        if (std::find(begin, end, outside) != end) continue;
        remove_cell(mesh, c);
        return true;
    }
    return false;
}

bool cell_twice(Mesh* mesh, const Planter& p) {
    const std::uint32_t c = p.random.below(mesh->cells.size());
    mesh->cells.push_back(mesh->cells[c]);
    mesh->neighbours.push_back(mesh->neighbours[c]);
    return true;
}

bool other_vertex(Mesh* mesh, const Planter& p) {
    Entries& cell = mesh->cells[p.random.below(mesh->cells.size())];
    const std::uint32_t v = p.random.below(mesh->count());
    if (std::find(cell.begin(), cell.begin() + mesh->dim + 1, v) != cell.begin() + mesh->dim + 1) return false;
    cell[p.random.below(static_cast<std::size_t>(mesh->dim) + 1)] = v;
    return true;
}

bool vertex_twice(Mesh* mesh, const Planter& p) {
    Entries& cell = mesh->cells[p.random.below(mesh->cells.size())];
    cell[0] = cell[1];
    return true;
}

bool cells_exchange_vertices(Mesh* mesh, const Planter& p) {
    const FacetAt facet = any_facet(*mesh, p.random, false);
    if (facet.cell == outside) return false;
    Entries& other = mesh->cells[mesh->neighbours[facet.cell][facet.i]];
    for (int j = 0; j <= mesh->dim; j++) {
        const auto end = mesh->cells[facet.cell].begin() + mesh->dim + 1;
        if (std::find(mesh->cells[facet.cell].begin(), end, other[j]) != end) continue;
        std::swap(mesh->cells[facet.cell][facet.i], other[j]);
        return true;
    }
    return false;
}

bool vertices_swapped(Mesh* mesh, const Planter& p) {
    const std::uint32_t c = p.random.below(mesh->cells.size());
    if (mesh->neighbours[c][0] == mesh->neighbours[c][1]) return false;
    std::swap(mesh->cells[c][0], mesh->cells[c][1]);
    return true;
}

// Two cells of a facet become D cells about the edge between their apexes, where these are positively oriented.
bool flip(Mesh* mesh, const Planter& p) {
    for (int trial = 0; trial < 200; trial++) {
        const FacetAt facet = any_facet(*mesh, p.random, false);
        if (facet.cell == outside) return false;
        const std::uint32_t n = mesh->neighbours[facet.cell][facet.i];
        const Entries cell = mesh->cells[facet.cell];
        const auto end = cell.begin() + mesh->dim + 1;
        std::uint32_t apex = 0;
        for (int j = 0; j <= mesh->dim; j++)
            if (std::find(cell.begin(), end, mesh->cells[n][j]) == end) apex = mesh->cells[n][j];
        std::vector<Entries> made;
        bool good = true;
        for (int j = 0; j <= mesh->dim && good; j++) {
            if (j == facet.i) continue;
            Entries fresh = cell;
            fresh[static_cast<std::size_t>(j)] = apex;
            good = orientation(*mesh, fresh, -1, {}) == 1;
            made.push_back(fresh);
        }
        if (!good) continue;
        remove_cell(mesh, std::max(facet.cell, n));
        remove_cell(mesh, std::min(facet.cell, n));
        for (const Entries& fresh : made) {
            mesh->cells.push_back(fresh);
            mesh->neighbours.push_back(fresh);
        }
        relink(mesh);
        return true;
    }
    return false;
}

bool other_neighbour(Mesh* mesh, const Planter& p) {
    const FacetAt facet = any_facet(*mesh, p.random, false);
    if (facet.cell == outside) return false;
    const std::uint32_t n = p.random.below(mesh->cells.size());
    if (n == mesh->neighbours[facet.cell][facet.i]) return false;
    mesh->neighbours[facet.cell][facet.i] = n;
    return true;
}

bool neighbours_swapped(Mesh* mesh, const Planter& p) {
    Entries& row = mesh->neighbours[p.random.below(mesh->cells.size())];
    if (row[0] == row[1]) return false;
    std::swap(row[0], row[1]);
    return true;
}

bool neighbour_outside(Mesh* mesh, const Planter& p) {
    const FacetAt facet = any_facet(*mesh, p.random, false);
    if (facet.cell == outside) return false;
    mesh->neighbours[facet.cell][facet.i] = outside;
    return true;
}

bool outside_is_a_cell(Mesh* mesh, const Planter& p) {
    const FacetAt facet = any_facet(*mesh, p.random, true);
    if (facet.cell == outside) return false;
    mesh->neighbours[facet.cell][facet.i] = p.random.below(mesh->cells.size());
    return true;
}

bool own_neighbour(Mesh* mesh, const Planter& p) {
    const FacetAt facet = any_facet(*mesh, p.random, false);
    if (facet.cell == outside) return false;
    mesh->neighbours[facet.cell][facet.i] = facet.cell;
    return true;
}

bool vertex_without_cell(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.random.below(mesh->count());
    const double length = 0.3 * p.nearest(*mesh, v);
    add_vertex(mesh, p.beside(*mesh, v, length), mesh->has_domain ? steiner_marker : input_marker);
    return true;
}

bool vertex_moved_far(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.random.below(mesh->count());
    mesh->vertices[v] = p.beside(*mesh, v, 3 * p.nearest(*mesh, v));
    return true;
}

bool vertex_moved_a_little(Mesh* mesh, const Planter& p) {
    const std::uint32_t v = p.random.below(mesh->count());
    mesh->vertices[v] = p.beside(*mesh, v, 0.1 * p.nearest(*mesh, v));
    return true;
}

bool hull_vertex_drawn_in(Mesh* mesh, const Planter& p) {
    const FacetAt facet = any_facet(*mesh, p.random, true);
    if (facet.cell == outside) return false;
    const Entries& cell = mesh->cells[facet.cell];
    const std::uint32_t v = cell[facet.i == 0 ? 1 : 0], apex = cell[facet.i];
    for (int k = 0; k < mesh->dim; k++) mesh->vertices[v][k] += 0.5 * (mesh->vertices[apex][k] - mesh->vertices[v][k]);
    return true;
}

}  // namespace

const std::vector<Plant>& cell_plants() {
    static const std::vector<Plant> all = {
        {"a cell at the hull is missing", all_grounds, true, false, hull_cell_missing},
        {"a cell inside is missing", all_grounds, true, false, inner_cell_missing},
        {"a cell stands there twice", all_grounds, true, false, cell_twice},
        {"a cell has another vertex", all_grounds, true, false, other_vertex},
        {"a cell has a vertex twice", all_grounds, true, false, vertex_twice},
        {"two cells exchange their apexes", all_grounds, true, false, cells_exchange_vertices},
        {"two vertices of a cell are swapped", all_grounds, true, false, vertices_swapped},
        {"a flip of two cells", all_grounds, false, false, flip},
        {"a neighbour is another cell", all_grounds, true, false, other_neighbour},
        {"two neighbours are swapped", all_grounds, true, false, neighbours_swapped},
        {"a neighbour inside is said to be outside", all_grounds, true, false, neighbour_outside},
        {"a neighbour outside is said to be a cell", all_grounds, true, false, outside_is_a_cell},
        {"a cell is its own neighbour", all_grounds, true, false, own_neighbour},
        {"a vertex without a cell", all_grounds, true, false, vertex_without_cell},
        {"a vertex is moved far", all_grounds, false, false, vertex_moved_far},
        {"a vertex is moved a little", all_grounds, false, false, vertex_moved_a_little},
        {"a vertex of the hull is drawn in", all_grounds, false, false, hull_vertex_drawn_in},
    };
    return all;
}

}  // namespace referee
