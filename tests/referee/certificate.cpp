#include "certificate.hpp"

#include <algorithm>

#include "nerve.hpp"

namespace referee {
namespace {

// Corners are known to this part of their distances; so are the numbers made of them.
constexpr double corner_room = 1e-9;

// How far a cell nearest_to from one of the inputs that its vertex is nearest to. There can be several as far from it:
// any of them bounds the distance to the inputs on the cell.
struct NearestInput {
    std::uint32_t input;
    double far;
};

std::uint32_t nearest(const Mesh& mesh, const Point& x, bool inputs_only, double* least) {
    std::uint32_t found = 0;
    *least = INFINITY;
    for (std::uint32_t v = 0; v < mesh.count(); v++) {
        if (inputs_only && mesh.markers[v] != input_marker) continue;
        const double d = distance(mesh.vertices[v], x, mesh.dim);
        if (d < *least) {
            *least = d;
            found = v;
        }
    }
    return found;
}

// The corner of a cell from its first vertex on, with an error far below corner_room.
Vector<Rational> exact_corner(const Mesh& mesh, const Entries& cell) {
    Matrix<Rational> rows;
    Vector<Rational> heights, y;
    for (int i = 0; i < mesh.dim; i++) {
        rows[i] = difference<Rational>(mesh.vertices[cell[0]], mesh.vertices[cell[i + 1]], mesh.dim);
        heights[i] = norm2<Rational>(rows[i], mesh.dim) / 2;
    }
    solve<Rational>(rows, heights, mesh.dim, &y);
    return y;
}

double corner_distance(const Mesh& mesh, const Vector<Rational>& corner, const Point& from, const Point& to) {
    Vector<Rational> d = difference<Rational>(to, from, mesh.dim);
    for (int k = 0; k < mesh.dim; k++) d[k] = d[k] + corner[k];
    return std::sqrt(norm2<Rational>(d, mesh.dim).get_d());
}

std::vector<NearestInput> nearest_inputs(const Mesh& mesh, std::uint32_t v, double* least) {
    nearest(mesh, mesh.vertices[v], true, least);
    std::vector<NearestInput> found;
    for (std::uint32_t w = 0; w < mesh.count(); w++)
        if (mesh.markers[w] == input_marker &&
            distance(mesh.vertices[w], mesh.vertices[v], mesh.dim) <= *least * (1 + corner_room))
            found.push_back({w, 0});
    return found;
}

// The radius of a ball about the domain's centre that contains the inputs; of a single one the larger of 1 and its
// largest coordinate.
double enclosing_radius(const Mesh& mesh) {
    double most = 0, magnitude = 1;
    std::size_t inputs = 0;
    for (std::size_t v = 0; v < mesh.count(); v++) {
        if (mesh.markers[v] != input_marker) continue;
        inputs++;
        most = std::max(most, distance(mesh.vertices[v], mesh.centre, mesh.dim));
        for (int k = 0; k < mesh.dim; k++) magnitude = std::max(magnitude, std::fabs(mesh.vertices[v][k]));
    }
    return inputs == 1 ? magnitude : most;
}

// In doubles but for what is beyond the limit, which is decided exactly: half of d, or the promise.
void judge_clipped(const Mesh& mesh, const Diagram& diagram, const Hull& hull, Verdict* verdict) {
    const double rho = enclosing_radius(mesh);
    const Nerve nerve(mesh);
    for (std::uint32_t v = 0; v < mesh.count(); v++) {
        if (!nerve.has({v})) continue;
        double d;
        const std::vector<NearestInput> inputs = nearest_inputs(mesh, v, &d);
        const bool is_input = mesh.markers[v] == input_marker;
        double low = is_input ? diagram.nearest(v) / 2 : d / 2;
        if (!is_input && !hull.has[v]) {
            const Reach own = diagram.reach(v, {mesh.centre, mesh.radius, mesh.vertices[v], square(exact(d)) / 4});
            if (!own.beyond) low = std::max(low, d - own.farthest);
        }
        low = std::min(low, rho);
        const double most = low * mesh.ratio * mesh.ratio * (1 + 2 * corner_room);
        double high = rho;
        bool beyond = rho > most;
        for (const NearestInput& near : inputs) {
            const Reach reach =
                diagram.reach(v, {mesh.centre, mesh.radius, mesh.vertices[near.input], square(exact(most))});
            high = std::min(high, reach.farthest);
            beyond = beyond && reach.beyond;
        }
        const double ratio = std::sqrt(high / low);
        verdict->worst_ratio = std::max(verdict->worst_ratio, ratio);
        if (beyond)
            verdict->add("certificate",
                         "the clipped cell of vertex " + count_text(v) + " has the ratio " + number_text(ratio));
    }
}

}  // namespace

void judge_certificate(const Mesh& mesh, const Diagram& diagram, const Hull& hull, Verdict* verdict) {
    if (mesh.clipped) return judge_clipped(mesh, diagram, hull, verdict);
    const std::size_t count = mesh.count();
    const double rho = enclosing_radius(mesh);
    std::vector<double> out(count, 0), from_inputs(count);
    std::vector<std::vector<NearestInput>> nearest_to(count);
    for (std::uint32_t v = 0; v < count; v++) nearest_to[v] = nearest_inputs(mesh, v, &from_inputs[v]);
    for (const Entries& cell : mesh.cells) {
        const Vector<Rational> corner = exact_corner(mesh, cell);
        const Point& from = mesh.vertices[cell[0]];
        const double radius = corner_distance(mesh, corner, from, from);
        for (int i = 0; i <= mesh.dim; i++) {
            const std::uint32_t v = cell[i];
            out[v] = std::max(out[v], radius);
            for (NearestInput& near : nearest_to[v])
                near.far = std::max(near.far, corner_distance(mesh, corner, from, mesh.vertices[near.input]));
        }
    }
    for (std::uint32_t v = 0; v < count; v++) {
        const double d = from_inputs[v];
        double low = std::max(d / 2, d - out[v]), high = INFINITY;
        for (const NearestInput& near : nearest_to[v]) high = std::min(high, near.far);
        if (mesh.markers[v] == input_marker) low = diagram.nearest(v) / 2, high = out[v];
        if (hull.has[v]) low = d / 2, high = INFINITY;
        const double ratio = std::sqrt(std::min(high, rho) / std::min(low, rho));
        verdict->worst_ratio = std::max(verdict->worst_ratio, ratio);
        if (ratio > mesh.ratio * (1 + corner_room))
            verdict->add("certificate", "the cell of vertex " + count_text(v) + " has the ratio " + number_text(ratio));
    }
}

void sample_values(const Mesh& mesh, const Diagram& diagram, std::size_t samples, Random& random, Verdict* verdict) {
    const double c = mesh.ratio * (1 + corner_room), rho = enclosing_radius(mesh);
    for (std::size_t s = 0; s < samples; s++) {
        const Point direction = random.direction(mesh.dim);
        Point x = mesh.centre;
        double length = mesh.radius * std::pow(random.unit(), 1.0 / mesh.dim);
        if (s % 2 == 0) {  // near a vertex
            const std::uint32_t v = random.below(mesh.count());
            if (mesh.markers[v] == exempt_marker) continue;
            x = mesh.vertices[v];
            length = diagram.nearest(v) * random.between(0, 1.5);
        }
        for (int k = 0; k < mesh.dim; k++) x[k] += length * direction[k];
        if (distance(x, mesh.centre, mesh.dim) > mesh.radius) continue;
        double apart, d;
        const std::uint32_t v = nearest(mesh, x, false, &apart);
        nearest(mesh, x, true, &d);
        d = std::min(d, rho);
        const bool in_ball = mesh.markers[v] == input_marker && apart <= diagram.nearest(v) / 2;
        if (d > c * mesh.values[v] || (!in_ball && d < mesh.values[v] / c))
            verdict->add("certificate", "a point of the cell of vertex " + count_text(v) + " is at " + number_text(d) +
                                            ", the vertex has the value " + number_text(mesh.values[v]));
    }
}

}  // namespace referee
