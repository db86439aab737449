#include "cages.hpp"

#include "templates.hpp"

namespace referee {
namespace {

const CageLine& line_of(const Mesh& mesh, int cage) { return mesh.cages[static_cast<std::size_t>(cage)]; }

// Sign of |x - centre of the cage| - factor r.
int compare(const Mesh& mesh, int cage, const Point& x, double factor) {
    const CageLine& line = line_of(mesh, cage);
    return compare_distance(mesh.vertices[line.centre], x, mesh.dim, factor * line.radius);
}

bool judge_lines(const Mesh& mesh, Verdict* verdict) {
    for (const CageLine& line : mesh.cages)
        if (line.centre >= mesh.count() || mesh.markers[line.centre] != input_marker || !(line.radius > 0)) {
            verdict->add("cages", "a cage is not a ball about an input");
            return false;
        }
    const int count = static_cast<int>(mesh.cages.size());
    for (int a = 0; a < count; a++)
        for (int b = 0; b < a; b++) {
            const CageLine &p = line_of(mesh, a), &q = line_of(mesh, b);
            const double apart = distance(mesh.vertices[p.centre], mesh.vertices[q.centre], mesh.dim);
            const double room = 0x1p-40 * (p.radius + q.radius), across = std::fabs(p.radius - q.radius);
            if (p.radius == q.radius && p.centre == q.centre) {
                verdict->add("cages", "a cage stands there twice");
                return false;
            }
            if (apart < p.radius + q.radius - room && apart > across + room) {
                verdict->add("cages",
                             "the balls about " + count_text(p.centre) + " and " + count_text(q.centre) + " cross");
                return false;
            }
        }
    return true;
}

// Sees that each point of the template has one vertex of the shell.
void judge_shell(const Mesh& mesh, int cage, bool is_outermost, const std::vector<std::uint32_t>& shell,
                 const std::string& name, Verdict* verdict) {
    const CageLine& line = line_of(mesh, cage);
    const Point& centre = mesh.vertices[line.centre];
    const double radius = thesis_sphere * line.radius;
    double room = thesis_off * radius;
    for (int k = 0; k < mesh.dim; k++) room += 0x1p-50 * (std::fabs(centre[k]) + radius);
    std::vector<int> used(shell.size(), 0);
    for (const Point& unit : is_outermost ? outer_template(mesh.dim) : cage_template(mesh.dim)) {
        Point place = centre;
        for (int k = 0; k < mesh.dim; k++) place[k] += radius * unit[k];
        int there = 0;
        for (std::size_t s = 0; s < shell.size(); s++)
            if (distance(mesh.vertices[shell[s]], place, mesh.dim) <= room) {
                there++;
                used[s]++;
            }
        if (there != 1) return verdict->add("cages", name + " has a place with " + count_text(there) + " vertices");
    }
    for (std::size_t s = 0; s < shell.size(); s++)
        if (used[s] != 1) verdict->add("cages", "vertex " + count_text(shell[s]) + " has no place in " + name);
}

void judge_thesis_cage(const Mesh& mesh, const Hierarchy& hierarchy, int cage, Verdict* verdict) {
    const CageLine& line = line_of(mesh, cage);
    const std::string name = "the cage about " + count_text(line.centre);
    const int parent = hierarchy.parent[static_cast<std::size_t>(cage)];
    std::vector<std::uint32_t> shell;
    for (std::uint32_t v = 0; v < mesh.count(); v++) {
        const Point& x = mesh.vertices[v];
        if (!is_in_cage(mesh, cage, v)) {
            if (compare(mesh, cage, x, thesis_outer) < 0)
                verdict->add("cages", "vertex " + count_text(v) + " is in the gap around " + name);
            continue;
        }
        const bool own = hierarchy.domain[v] == cage, is_input = mesh.markers[v] == input_marker;
        const bool gap = is_input && compare(mesh, cage, x, thesis_inner) > 0;
        if (own && (gap || mesh.markers[v] == exempt_marker))
            shell.push_back(v);
        else if (gap)
            verdict->add("cages", "input " + count_text(v) + " is in the gap inside " + name);
    }
    judge_shell(mesh, cage, parent == no_cage, shell, name, verdict);
    if (parent == no_cage) return;
    const CageLine& around = line_of(mesh, parent);
    if (distance(mesh.vertices[around.centre], mesh.vertices[line.centre], mesh.dim) + line.radius > around.radius)
        verdict->add("cages", name + " sticks out of the one around it");
}

void judge_cage(const Mesh& mesh, const Hierarchy& hierarchy, int cage, Verdict* verdict) {
    if (mesh.thesis_cages) return judge_thesis_cage(mesh, hierarchy, cage, verdict);
    const CageLine& line = line_of(mesh, cage);
    const std::string name = "the cage about " + count_text(line.centre);
    int shell = 0;
    for (std::uint32_t v = 0; v < mesh.count(); v++) {
        const Point& x = mesh.vertices[v];
        if (is_in_cage(mesh, cage, v)) {
            const bool inner = compare(mesh, cage, x, cage_inner) <= 0;
            if (!inner && mesh.markers[v] == input_marker)
                verdict->add("cages", "input " + count_text(v) + " is in the gap inside " + name);
            shell += !inner && mesh.markers[v] == exempt_marker && hierarchy.domain[v] == cage;
        } else if (compare(mesh, cage, x, cage_outer) < 0 && mesh.markers[v] != exempt_marker) {
            const int other = hierarchy.domain[v];
            const bool beside = other != no_cage && !is_in_cage(mesh, other, line.centre);
            if (mesh.markers[v] == input_marker || !beside)
                verdict->add("cages", "vertex " + count_text(v) + " is in the gap around " + name);
        }
    }
    if (shell != 2 * mesh.dim) verdict->add("cages", name + " has a shell of " + count_text(shell) + " vertices");
    const int parent = hierarchy.parent[static_cast<std::size_t>(cage)];
    if (parent == no_cage) return;
    // Balls are nested: that of the cage around is meant, not the half of it that its inputs lie in.
    const double reach = distance(clip_centre(mesh, parent), mesh.vertices[line.centre], mesh.dim) + line.radius;
    if (reach > line_of(mesh, parent).radius * (1 + 0x1p-40))
        verdict->add("cages", name + " sticks out of the domain around it");
}

}  // namespace

bool is_in_cage(const Mesh& mesh, int cage, std::uint32_t v) { return compare(mesh, cage, mesh.vertices[v], 1) < 0; }

bool is_shell(const Mesh& mesh, const Hierarchy& hierarchy, std::uint32_t v) {
    const int cage = hierarchy.domain[v];
    const double inner = mesh.thesis_cages ? thesis_inner : cage_inner;
    return mesh.markers[v] == exempt_marker && cage != no_cage && compare(mesh, cage, mesh.vertices[v], inner) > 0;
}

bool stands_in_shell(const Mesh& mesh, const Hierarchy& hierarchy, std::uint32_t v) {
    const int cage = hierarchy.domain[v];
    return mesh.thesis_cages && mesh.markers[v] == input_marker && cage != no_cage &&
           compare(mesh, cage, mesh.vertices[v], thesis_inner) > 0;
}

Hierarchy judge_cages(const Mesh& mesh, Verdict* verdict) {
    Hierarchy hierarchy;
    const int count = static_cast<int>(mesh.cages.size());
    hierarchy.domain.assign(mesh.count(), no_cage);
    hierarchy.parent.assign(mesh.cages.size(), no_cage);
    if (!judge_lines(mesh, verdict)) return hierarchy;
    const auto innermost = [&](std::uint32_t v, double above) {
        int found = no_cage;
        for (int c = 0; c < count; c++) {
            const double radius = line_of(mesh, c).radius;
            if (radius <= above || !is_in_cage(mesh, c, v)) continue;
            if (found == no_cage || radius < line_of(mesh, found).radius) found = c;
        }
        return found;
    };
    for (std::uint32_t v = 0; v < mesh.count() && count > 0; v++) hierarchy.domain[v] = innermost(v, 0);
    for (int c = 0; c < count; c++)
        hierarchy.parent[static_cast<std::size_t>(c)] = innermost(line_of(mesh, c).centre, line_of(mesh, c).radius);
    for (int c = 0; c < count; c++) judge_cage(mesh, hierarchy, c, verdict);
    if (!mesh.thesis_cages) return hierarchy;
    int outermost = 0;
    for (const int parent : hierarchy.parent) outermost += parent == no_cage;
    if (outermost != 1) verdict->add("cages", "there are " + count_text(outermost) + " outermost cages");
    for (std::uint32_t v = 0; v < mesh.count(); v++)
        if (hierarchy.domain[v] == no_cage && mesh.markers[v] != exempt_marker)
            verdict->add("cages", "vertex " + count_text(v) + " is outside of the outermost cage");
    return hierarchy;
}

}  // namespace referee
