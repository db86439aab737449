#include "quality.hpp"

#include <algorithm>

namespace referee {
namespace {

// (factor / 2)^2 d2 with room: the square of factor times half a distance.
Rational limit2(double factor, const Rational& d2) {
    const Rational f = exact(factor) * exact(room) / 2;
    return f * f * d2;
}

std::size_t input_count(const Mesh& mesh) {
    std::size_t n = 0;
    while (n < mesh.count() && mesh.markers[n] == input_marker) n++;
    return n;
}

// The distance from x to the flat through a hull facet, on a cell's own side; 0 where it is not known.
double height(const Mesh& mesh, const Entries& cell, int opposite, const Point& x) {
    Point corner[dim_max];
    int n = 0;
    for (int j = 0; j <= mesh.dim; j++)
        if (j != opposite) corner[n++] = mesh.vertices[cell[j]];
    const Vector<Rational> d = difference<Rational>(corner[0], x, mesh.dim);
    Matrix<Rational> gram;
    Vector<Rational> right, weights;
    Vector<Rational> edges[dim_max];
    for (int i = 0; i + 1 < n; i++) edges[i] = difference<Rational>(corner[0], corner[i + 1], mesh.dim);
    for (int i = 0; i + 1 < n; i++) {
        for (int j = 0; j + 1 < n; j++) gram[i][j] = dot<Rational>(edges[i], edges[j], mesh.dim);
        right[i] = dot<Rational>(edges[i], d, mesh.dim);
    }
    if (!solve<Rational>(gram, right, n - 1, &weights)) return 0;
    Vector<Rational> rest = d;
    for (int i = 0; i + 1 < n; i++)
        for (int k = 0; k < mesh.dim; k++) rest[k] = rest[k] - weights[i] * edges[i][k];
    return std::sqrt(norm2<Rational>(rest, mesh.dim).get_d());
}

// The inputs are in a ball of this diameter, as the domain's radius is the larger of 3/2 of it and ((K sqrt 2 + 1) S +
// 1) times it, S the spacing of the net (3.5) and K = 2 tau / (tau - 2).
double net_width(const Mesh& mesh) {
    const double tau = promised_tau(mesh), k = 2 * tau / (tau - 2), spacing = mesh.net > 0 ? mesh.net : 1;
    return mesh.radius / std::max(1.5, (k * std::sqrt(2) + 1) * spacing + 1);
}

double net_spacing(const Mesh& mesh) { return (mesh.net > 0 ? mesh.net : 1) * net_width(mesh); }

bool is_on_sphere(const Mesh& mesh, std::uint32_t v) {
    return std::fabs(distance(mesh.vertices[v], mesh.centre, mesh.dim) - mesh.radius) <= 0x1p-15 * mesh.radius;
}

// Does the hull end in a boundary net? Then all of its vertices are on the sphere.
bool has_net(const Mesh& mesh, const Hull& hull) {
    for (std::uint32_t v = 0; v < mesh.count(); v++)
        if (hull.has[v] && !is_on_sphere(mesh, v)) return false;
    return true;
}

void judge_spacing(const Mesh& mesh, const std::vector<std::uint32_t>& net, Verdict* verdict) {
    // Coordinates of both are rounded, each by half of a unit in its last place at most.
    double magnitude = 0;
    for (const std::uint32_t v : net)
        for (int k = 0; k < mesh.dim; k++) magnitude = std::max(magnitude, std::fabs(mesh.vertices[v][k]));
    const double rounding = 0x1p-52 * std::sqrt(static_cast<double>(mesh.dim)) * magnitude;
    const double least = net_spacing(mesh) * (1 - 0x1p-30) - rounding;
    for (const std::uint32_t v : net)
        for (const std::uint32_t u : net)
            if (u != v && distance(mesh.vertices[u], mesh.vertices[v], mesh.dim) < least)
                return verdict->add("markers", "exempt vertices " + count_text(u) + " and " + count_text(v) +
                                                   " are too near for a boundary net");
}

// The facet's vertices are on the domain's sphere: is every point of the sphere beyond it within delta of them? The
// farthest one is above the middle of the facet: with h the height of the centre it is at sqrt(2 R (R - h)).
bool is_covered(const Mesh& mesh, double height) {
    return 2 * mesh.radius * (mesh.radius - height) <= square(Interval(net_spacing(mesh) * (1 + 0x1p-10))).hi;
}

class CageCell {
public:
    CageCell(const Mesh& mesh, int cage) : mesh_(mesh), cage_(cage) {
        const Point& u = mesh.vertices[mesh.cages[static_cast<std::size_t>(cage)].centre];
        for (std::uint32_t v = 0; v < mesh.count(); v++) {
            const double d = distance(mesh.vertices[v], u, mesh.dim);
            if (is_in_cage(mesh, cage, v)) {
                members_.push_back(v);
            } else {
                outside_ = std::min(outside_, d);
            }
        }
    }
    const std::vector<std::uint32_t>& members() const { return members_; }
    double in_radius(const Hierarchy& hierarchy) const {
        if (mesh_.thesis_cages) return outside_ / 2;
        const Point& u = mesh_.vertices[mesh_.cages[static_cast<std::size_t>(cage_)].centre];
        double shell = INFINITY;
        for (const std::uint32_t v : members_)
            if (hierarchy.domain[v] == cage_ && is_shell(mesh_, hierarchy, v))
                shell = std::min(shell, distance(mesh_.vertices[v], u, mesh_.dim));
        return (outside_ + shell) / 2;
    }

    // Of 4.6: the distance from the centre to the farthest of the shell.
    double weight(const Hierarchy& hierarchy) const {
        double shell = 0;
        for (const std::uint32_t v : members_)
            if (hierarchy.domain[v] == cage_ && is_shell(mesh_, hierarchy, v))
                shell = std::max(shell, distance(mesh_.vertices[v], centre(), mesh_.dim));
        return shell;
    }
    const Point& centre() const { return mesh_.vertices[mesh_.cages[static_cast<std::size_t>(cage_)].centre]; }

private:
    const Mesh& mesh_;
    int cage_;
    std::vector<std::uint32_t> members_;
    double outside_ = INFINITY;
};

void judge_cage_cells(const Mesh& mesh, const Diagram& diagram, const Hierarchy& hierarchy, Verdict* verdict) {
    for (int cage = 0; cage < static_cast<int>(mesh.cages.size()); cage++) {
        const CageCell cell(mesh, cage);
        const double inner = cell.in_radius(hierarchy);
        if (!std::isfinite(inner)) continue;  // without a shell, which is another fault
        const int parent = hierarchy.parent[static_cast<std::size_t>(cage)];
        if (mesh.thesis_cages && parent == no_cage) continue;  // the outermost has no cell
        const std::uint32_t centre = mesh.cages[static_cast<std::size_t>(cage)].centre;
        const Clip clip = {clip_centre(mesh, parent), clip_radius(mesh, parent), mesh.vertices[centre],
                           limit2(2 * promised_tau(mesh), square(exact(inner)))};
        for (const std::uint32_t v : cell.members()) {
            const Reach reach = diagram.reach(v, clip);
            verdict->worst_ratio = std::max(verdict->worst_ratio, reach.farthest / inner);
            if (reach.beyond)
                verdict->add("quality", "the cell of the cage about " + count_text(centre) + " has the ratio " +
                                            number_text(reach.farthest / inner));
        }
    }
}

// 4.6.1, its premise with epsilon 1/3, and 4.6.2: a cage among the vertices and cages of the domain around it, all of
// them.
void judge_weights(const Mesh& mesh, const Hierarchy& hierarchy, Verdict* verdict) {
    std::vector<double> weights;
    for (int cage = 0; cage < static_cast<int>(mesh.cages.size()); cage++)
        weights.push_back(CageCell(mesh, cage).weight(hierarchy));
    for (std::size_t a = 0; a < mesh.cages.size(); a++) {
        const CageCell cell(mesh, static_cast<int>(a));
        double nearest = INFINITY, additive = INFINITY;
        bool apart = true;
        const auto meet = [&](const Point& x, double weight) {
            const double d = distance(x, cell.centre(), mesh.dim);
            nearest = std::min(nearest, d);
            additive = std::min(additive, d - weight - weights[a]);
            apart = apart && 3 * weights[a] <= (d - weight) * (1 + 0x1p-20) &&
                    3 * weight <= (d - weights[a]) * (1 + 0x1p-20);
        };
        for (std::uint32_t v = 0; v < mesh.count(); v++)
            if (hierarchy.domain[v] == hierarchy.parent[a]) meet(mesh.vertices[v], 0);
        for (std::size_t b = 0; b < mesh.cages.size(); b++)
            if (b != a && hierarchy.parent[b] == hierarchy.parent[a])
                meet(mesh.vertices[mesh.cages[b].centre], weights[b]);
        const std::string name = "the cage about " + count_text(mesh.cages[a].centre);
        if (!apart) verdict->add("weights", name + " is too near to another point of its domain for 4.6.1");
        for (const double r : {additive / 2 + weights[a], cell.in_radius(hierarchy)})
            if (std::isfinite(r) && !(r <= nearest * (1 + 0x1p-20) && nearest <= 3 * r * (1 + 0x1p-20)))
                verdict->add("weights", name + " has another feature size than 4.6.2 admits");
    }
}

double input_distance(const Mesh& mesh, const Point& x) {
    double least = INFINITY;
    for (std::size_t v = 0; v < mesh.count(); v++)
        if (mesh.markers[v] == input_marker) least = std::min(least, distance(mesh.vertices[v], x, mesh.dim));
    return least;
}

}  // namespace

double promised_tau(const Mesh& mesh) {
    if (mesh.tau > 0) return mesh.tau;
    return mesh.dim <= 3 ? 2.5 : mesh.dim == 4 ? 3.08 : 4;
}

double feature_size(const Mesh& mesh, const Point& x) {
    double first = INFINITY, second = INFINITY;
    const std::size_t inputs = input_count(mesh);
    for (std::size_t p = 0; p < inputs; p++) {
        const double d = distance(mesh.vertices[p], x, mesh.dim);
        if (d < first) {
            second = first;
            first = d;
        } else {
            second = std::min(second, d);
        }
    }
    return second;
}

void judge_domain(const Mesh& mesh, const Hull& hull, Verdict* verdict) {
    if (!(mesh.radius > 0)) verdict->add("domain", "it has no radius");
    for (std::size_t v = 0; v < mesh.count(); v++)
        if (mesh.markers[v] == input_marker &&
            compare_distance(mesh.vertices[v], mesh.centre, mesh.dim, mesh.radius * room) > 0)
            verdict->add("domain", "input " + count_text(v) + " is outside");
    const bool netted = has_net(mesh, hull);
    if (mesh.net > 0 && !netted) verdict->add("domain", "it has no boundary net");
    for (std::size_t v = 0; v < mesh.count() && netted; v++)
        if (mesh.markers[v] == input_marker &&
            compare_distance(mesh.vertices[v], mesh.centre, mesh.dim, net_width(mesh) / 2 * (1 + 0x1p-15)) > 0)
            return verdict->add("domain", "it is too small for its boundary net about input " + count_text(v));
    for (const auto& [c, i] : hull.facets) {
        if (orientation(mesh, mesh.cells[c], i, mesh.centre) <= 0) return verdict->add("domain", "it is outside");
        const double above = height(mesh, mesh.cells[c], i, mesh.centre);
        if (netted && !is_covered(mesh, above)) return verdict->add("domain", "the boundary net has a hole");
        if (!netted && above < mesh.radius * (1 - 0x1p-30)) return verdict->add("domain", "it reaches beyond the hull");
    }
}

void judge_markers(const Mesh& mesh, const Hull& hull, const Hierarchy& hierarchy, Verdict* verdict) {
    const bool netted = has_net(mesh, hull);
    std::vector<std::uint32_t> net;
    for (std::uint32_t v = 0; v < mesh.count(); v++) {
        const std::string name = "vertex " + count_text(v);
        if (v > 0 && mesh.markers[v] == input_marker && mesh.markers[v - 1] != input_marker)
            verdict->add("markers", name + " is an input behind others");
        if (hull.has[v] && mesh.markers[v] != exempt_marker)
            verdict->add("markers", name + " is on the hull and not exempt");
        if (mesh.markers[v] != exempt_marker || is_shell(mesh, hierarchy, v)) continue;
        const bool beyond = hull.has[v] && compare_distance(mesh.vertices[v], mesh.centre, mesh.dim, mesh.radius) > 0;
        if (netted && is_on_sphere(mesh, v)) {
            net.push_back(v);
        } else if (netted || !beyond) {
            verdict->add("markers", name + " is exempt without a reason");
        }
    }
    judge_spacing(mesh, net, verdict);
}

void judge_quality(const Mesh& mesh, const Diagram& diagram, const Hierarchy& hierarchy, const Effort& effort,
                   Verdict* verdict) {
    const double tau = promised_tau(mesh);
    const double share = effort.cells_max / static_cast<double>(mesh.count());
    for (std::uint32_t v = 0; v < mesh.count(); v++) {
        if (effort.first_fault && !verdict->good()) return;
        if (mesh.markers[v] == exempt_marker || (share < 1 && effort.random.unit() >= share)) continue;
        if (stands_in_shell(mesh, hierarchy, v)) continue;
        const int domain = hierarchy.domain[v];
        Clip clip = {clip_centre(mesh, domain), clip_radius(mesh, domain), mesh.vertices[v],
                     limit2(tau, diagram.nearest2(v))};
        const Reach reach = diagram.reach(v, clip);
        const double ratio = reach.farthest / (0.5 * diagram.nearest(v));
        verdict->worst_ratio = std::max(verdict->worst_ratio, ratio);
        if (reach.beyond)
            verdict->add("quality", "the cell of vertex " + count_text(v) + " has the ratio " + number_text(ratio));
        double size = mesh.eps > 0 ? mesh.eps * feature_size(mesh, mesh.vertices[v]) : INFINITY;
        if (mesh.least_size > 0)
            size = std::min(size, mesh.least_size + mesh.growth * input_distance(mesh, mesh.vertices[v]));
        if (!std::isfinite(size) || reach.farthest < size * (1 - 0x1p-30)) continue;
        clip.limit2 = limit2(2 * room, square(exact(size)));
        if (diagram.reach(v, clip).beyond)
            verdict->add("size", "the cell of vertex " + count_text(v) + " reaches " +
                                     number_text(reach.farthest / size) + " times as far as its size admits");
    }
    judge_cage_cells(mesh, diagram, hierarchy, verdict);
    judge_weights(mesh, hierarchy, verdict);
}

}  // namespace referee
