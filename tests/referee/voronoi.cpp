#include "voronoi.hpp"

#include <algorithm>
#include <memory>

namespace referee {
namespace {

// The cell {y : a.y <= h} in coordinates about its vertex, the ball and q likewise.
template <class T> struct Star {
    std::vector<Vector<T>> a;
    std::vector<T> h;
    Vector<T> centre, reference;
    T radius2, limit2;
};

// A point y = foot + side sqrt(root) direction, or foot alone; its squared distance from q is
// base + 2 side sqrt(root) along.
template <class T> struct Candidate {
    Vector<T> foot, direction;
    T root, base, along, term;  // term: sqrt(root) along, of intervals
    bool is_corner = false;
};

struct Face {
    std::array<std::uint16_t, dim_max> at = {};  // positions in the list of neighbours, ascending
    int size = 0;
    bool operator<(const Face& other) const { return size != other.size ? size < other.size : at < other.at; }
    bool operator==(const Face& other) const { return size == other.size && at == other.at; }
};

enum class Place { known, outside_ball, unknown };

int exponent_of(double x) {
    int e = 0;
    std::frexp(x, &e);
    return e;
}

Star<Rational> exact_star(const Mesh& mesh, std::uint32_t v, const std::vector<std::uint32_t>& neighbours,
                          const Clip& clip) {
    Star<Rational> star;
    const Point& x = mesh.vertices[v];
    for (const std::uint32_t u : neighbours) {
        star.a.push_back(difference<Rational>(x, mesh.vertices[u], mesh.dim));
        star.h.push_back(norm2<Rational>(star.a.back(), mesh.dim) / 2);
    }
    star.centre = difference<Rational>(x, clip.centre, mesh.dim);
    star.reference = difference<Rational>(x, clip.reference, mesh.dim);
    star.radius2 = square(exact(clip.radius));
    star.limit2 = clip.limit2;
    return star;
}

// Lengths are scaled by 2^-g, and rows by a power of two of their own.
Star<Interval> near_star(const Mesh& mesh, std::uint32_t v, const std::vector<std::uint32_t>& neighbours,
                         const Clip& clip, int g) {
    const auto shrunk = [&](Vector<Interval> d, int e) {
        for (int k = 0; k < mesh.dim; k++) d[k] = scaled(d[k], e);
        return d;
    };
    Star<Interval> star;
    const Point& x = mesh.vertices[v];
    for (const std::uint32_t u : neighbours) {
        const Vector<Interval> a = shrunk(difference<Interval>(x, mesh.vertices[u], mesh.dim), -g);
        double largest = 0;
        for (int k = 0; k < mesh.dim; k++) largest = std::max(largest, magnitude(a[k]));
        const int e = -exponent_of(largest);
        star.a.push_back(shrunk(a, e));
        star.h.push_back(scaled(norm2<Interval>(a, mesh.dim) * Interval(0.5), e));
    }
    star.centre = shrunk(difference<Interval>(x, clip.centre, mesh.dim), -g);
    star.reference = shrunk(difference<Interval>(x, clip.reference, mesh.dim), -g);
    star.radius2 = square(scaled(Interval(clip.radius), -g));
    // A double next to the exact square root; the room for its rounding is in the interval.
    Rational limit2 = clip.limit2;
    g >= 0 ? mpq_div_2exp(limit2.get_mpq_t(), limit2.get_mpq_t(), 2 * static_cast<unsigned long>(g))
           : mpq_mul_2exp(limit2.get_mpq_t(), limit2.get_mpq_t(), 2 * static_cast<unsigned long>(-g));
    const double limit = limit2.get_d();
    star.limit2 = std::isfinite(limit) ? widened(limit * (1 - 0x1p-50), limit * (1 + 0x1p-50)) : whole_line();
    return star;
}

// d without its part in the span of the face's rows.
template <class T> bool project(const Star<T>& star, const Face& face, const Matrix<T>& gram, int dim, Vector<T>* d) {
    if (face.size == 0) return true;
    Vector<T> right, weights;
    for (int i = 0; i < face.size; i++) right[i] = dot<T>(star.a[face.at[i]], *d, dim);
    if (!solve<T>(gram, right, face.size, &weights)) return false;
    for (int i = 0; i < face.size; i++)
        for (int k = 0; k < dim; k++) (*d)[k] = (*d)[k] - weights[i] * star.a[face.at[i]][k];
    return true;
}

// An axis without its part in the span: one keeps at least 1 / D of its square, as the squares add up to the dimension
// of what is orthogonal to the span, 1 or more.
template <class T>
bool project_an_axis(const Star<T>& star, const Face& face, const Matrix<T>& gram, int dim, Vector<T>* d) {
    for (int axis = 0; axis < dim; axis++) {
        for (int k = 0; k < dim; k++) (*d)[k] = T(k == axis ? 1.0 : 0.0);
        if (!project<T>(star, face, gram, dim, d)) return false;
        if (sign_of(T(norm2<T>(*d, dim) - T(0.5) / T(static_cast<double>(dim)))) == 1) return true;
    }
    return false;
}

void set_term(Candidate<Interval>* c, Interval s2, Interval length2, bool is_pole) {
    c->root = s2 / length2;
    if (c->root.lo < 0) c->root.lo = 0;
    c->term = is_pole ? root(s2 * length2) : root(c->root) * c->along;
}
void set_term(Candidate<Rational>* c, const Rational& s2, const Rational& length2, bool) { c->root = s2 / length2; }

template <class T> Place place(const Star<T>& star, const Face& face, int dim, Candidate<T>* c) {
    Matrix<T> rows;
    Vector<T> right;
    if (face.size == dim) {
        for (int i = 0; i < dim; i++) {
            rows[i] = star.a[face.at[i]];
            right[i] = star.h[face.at[i]];
        }
        c->is_corner = true;
        if (!solve<T>(rows, right, dim, &c->foot)) return Place::unknown;
        Vector<T> from_centre, from_reference;
        for (int k = 0; k < dim; k++) {
            from_centre[k] = c->foot[k] - star.centre[k];
            from_reference[k] = c->foot[k] - star.reference[k];
        }
        c->base = norm2<T>(from_reference, dim);
        return sign_of(T(norm2<T>(from_centre, dim) - star.radius2)) == 1 ? Place::outside_ball : Place::known;
    }
    for (int i = 0; i < face.size; i++) {
        for (int j = 0; j < face.size; j++) rows[i][j] = dot<T>(star.a[face.at[i]], star.a[face.at[j]], dim);
        right[i] = star.h[face.at[i]] - dot<T>(star.a[face.at[i]], star.centre, dim);
    }
    Vector<T> weights, off;
    for (int k = 0; k < dim; k++) off[k] = T(0.0);
    if (face.size > 0 && !solve<T>(rows, right, face.size, &weights)) return Place::unknown;
    for (int i = 0; i < face.size; i++)
        for (int k = 0; k < dim; k++) off[k] = off[k] + weights[i] * star.a[face.at[i]][k];
    Vector<T> w;
    for (int k = 0; k < dim; k++) {
        c->foot[k] = star.centre[k] + off[k];
        w[k] = star.centre[k] - star.reference[k];
    }
    const T s2 = star.radius2 - norm2<T>(off, dim);
    if (sign_of(s2) == -1) return Place::outside_ball;
    c->base = star.radius2 + norm2<T>(w, dim) + dot<T>(off, w, dim) * T(2.0);
    bool is_pole = face.size < dim - 1;
    if (is_pole) {
        c->direction = w;
        if (!project<T>(star, face, rows, dim, &c->direction)) return Place::unknown;
        is_pole = sign_of(norm2<T>(c->direction, dim)) != 0;
    }
    if (!is_pole && !project_an_axis<T>(star, face, rows, dim, &c->direction)) return Place::unknown;
    c->along = dot<T>(c->direction, w, dim);
    set_term(c, s2, norm2<T>(c->direction, dim), is_pole);
    return Place::known;
}

// Is the candidate nearer to some neighbour than to v? 1: surely; 0: surely not; 2: not known.
template <class T> int is_cut_off(const Star<T>& star, const Face& face, const Candidate<T>& c, int side, int dim) {
    int result = 0;
    for (std::size_t u = 0; u < star.a.size(); u++) {
        if (std::find(face.at.begin(), face.at.begin() + face.size, u) != face.at.begin() + face.size) continue;
        const T p = dot<T>(star.a[u], c.foot, dim) - star.h[u];
        int sign;
        if (c.is_corner) {
            sign = sign_of(p);
        } else {
            const T r = dot<T>(star.a[u], c.direction, dim) * T(static_cast<double>(side));
            sign = sign_with_root(p, r, c.root);
        }
        if (sign == 1) return 1;
        if (sign == 2) result = 2;
    }
    return result;
}

bool surely_beyond(const Star<Rational>& star, const Face& face, int side, int dim) {
    Candidate<Rational> c;
    if (place<Rational>(star, face, dim, &c) != Place::known) return false;
    const Rational above = c.base - star.limit2;
    const int sign = c.is_corner ? sgn(above) : sign_with_root(above, Rational(c.along * 2 * side), c.root);
    return sign == 1 && is_cut_off<Rational>(star, face, c, side, dim) == 0;
}

}  // namespace

Diagram::Diagram(const Mesh& mesh)
    : mesh_(mesh), cells_(mesh.count()), neighbours_(mesh.count()), nearest_(mesh.count()) {
    for (std::uint32_t c = 0; c < mesh.cells.size(); c++)
        for (int i = 0; i <= mesh.dim; i++) {
            const std::uint32_t v = mesh.cells[c][i];
            cells_[v].push_back(c);
            for (int j = 0; j <= mesh.dim; j++)
                if (j != i) neighbours_[v].push_back(mesh.cells[c][j]);
        }
    for (std::uint32_t v = 0; v < mesh.count(); v++) {
        std::vector<std::uint32_t>& list = neighbours_[v];
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        nearest_[v] = INFINITY;
        // The nearest vertex is a neighbour in every Delaunay triangulation.
        for (const std::uint32_t u : list)
            nearest_[v] = std::min(nearest_[v], distance(mesh.vertices[u], mesh.vertices[v], mesh.dim));
    }
}

Rational Diagram::nearest2(std::uint32_t v) const {
    Rational least = -1;
    for (const std::uint32_t u : neighbours_[v]) {
        if (distance(mesh_.vertices[u], mesh_.vertices[v], mesh_.dim) > nearest_[v] * (1 + 0x1p-40)) continue;
        const Rational d2 =
            norm2<Rational>(difference<Rational>(mesh_.vertices[u], mesh_.vertices[v], mesh_.dim), mesh_.dim);
        if (least < 0 || d2 < least) least = d2;
    }
    return least;
}

Reach Diagram::reach(std::uint32_t v, const Clip& clip) const {
    const std::vector<std::uint32_t>& list = neighbours_[v];
    const int dim = mesh_.dim;
    std::vector<Face> faces;
    for (const std::uint32_t c : cells_[v]) {
        std::vector<std::uint16_t> at;
        for (int i = 0; i <= dim; i++)
            if (mesh_.cells[c][i] != v)
                at.push_back(static_cast<std::uint16_t>(std::lower_bound(list.begin(), list.end(), mesh_.cells[c][i]) -
                                                        list.begin()));
        std::sort(at.begin(), at.end());
        for (unsigned subset = 0; subset < 1u << dim; subset++) {
            Face face;
            for (std::size_t i = 0; i < at.size(); i++)
                if (subset >> i & 1u) face.at[static_cast<std::size_t>(face.size++)] = at[i];
            faces.push_back(face);
        }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());

    const int g = exponent_of(nearest_[v]);
    const Star<Interval> star = near_star(mesh_, v, list, clip, g);
    std::unique_ptr<Star<Rational>> exactly;
    Reach reach;
    double farthest2 = 0;
    for (const Face& face : faces) {
        Candidate<Interval> c;
        const Place where = place<Interval>(star, face, dim, &c);
        if (where == Place::outside_ball) continue;
        for (int side = 1; side >= (face.size == dim - 1 ? -1 : 1); side -= 2) {
            Interval distance2 = where == Place::unknown ? whole_line() : c.base;
            if (where == Place::known && !c.is_corner) distance2 = distance2 + c.term * Interval(2.0 * side);
            const bool harmless = distance2.hi <= star.limit2.lo;
            if (harmless && distance2.middle() <= farthest2) continue;
            const int cut_off = where == Place::unknown ? 2 : is_cut_off<Interval>(star, face, c, side, dim);
            if (cut_off == 1) continue;
            if (!harmless) {
                if (!exactly) exactly = std::make_unique<Star<Rational>>(exact_star(mesh_, v, list, clip));
                if (!surely_beyond(*exactly, face, side, dim)) continue;
                reach.beyond = true;
            }
            farthest2 = std::max(farthest2, distance2.middle());
        }
    }
    reach.farthest = std::ldexp(std::sqrt(farthest2), g);
    return reach;
}

}  // namespace referee
