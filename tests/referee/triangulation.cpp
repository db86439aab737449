#include "triangulation.hpp"

#include <algorithm>
#include <numeric>

namespace referee {
namespace {

constexpr double all_of_them = 1e300;

template <class T> int orientation_in(const Mesh& mesh, const Entries& cell, int replaced, const Point& other) {
    const auto at = [&](int i) -> const Point& { return i == replaced ? other : mesh.vertices[cell[i]]; };
    Matrix<T> rows;
    for (int i = 0; i < mesh.dim; i++) rows[i] = difference<T>(at(0), at(i + 1), mesh.dim);
    return determinant_sign<T>(rows, mesh.dim);
}

// The centre of a cell's sphere from its first vertex on.
template <class T> bool sphere_centre(const Mesh& mesh, const Entries& cell, Vector<T>* y) {
    Matrix<T> rows;
    Vector<T> heights;
    for (int i = 0; i < mesh.dim; i++) {
        rows[i] = difference<T>(mesh.vertices[cell[0]], mesh.vertices[cell[i + 1]], mesh.dim);
        heights[i] = norm2<T>(rows[i], mesh.dim) * T(0.5);
    }
    return solve<T>(rows, heights, mesh.dim, y);
}

// x is strictly inside the sphere about y through `from`: |x - from|^2 < 2 (x - from).y
template <class T> int inside(const Point& from, const Vector<T>& y, const Point& x, int dim) {
    const Vector<T> a = difference<T>(from, x, dim);
    return sign_of(T(dot<T>(a, y, dim) - norm2<T>(a, dim) * T(0.5)));
}

class Sphere {
public:
    Sphere(const Mesh& mesh, const Entries& cell) : mesh_(mesh), cell_(cell) {
        known_ = sphere_centre<Interval>(mesh, cell, &about_);
    }
    bool contains(const Point& x) {
        const Point& from = mesh_.vertices[cell_[0]];
        const int guess = known_ ? inside<Interval>(from, about_, x, mesh_.dim) : 2;
        if (guess != 2) return guess == 1;
        if (!solved_) solved_ = sphere_centre<Rational>(mesh_, cell_, &centre_);
        return inside<Rational>(from, centre_, x, mesh_.dim) == 1;
    }

private:
    const Mesh& mesh_;
    const Entries& cell_;
    bool known_ = false, solved_ = false;
    Vector<Interval> about_;
    Vector<Rational> centre_;
};

struct Facet {
    Entries vertices;  // sorted, the last one unused
    std::uint32_t cell;
    int opposite;
};

bool judge_cells(const Mesh& mesh, Verdict* verdict) {
    std::vector<bool> used(mesh.count(), false);
    for (std::size_t c = 0; c < mesh.cells.size(); c++)
        for (int i = 0; i <= mesh.dim; i++) {
            used[mesh.cells[c][i]] = true;
            for (int j = 0; j < i; j++)
                if (mesh.cells[c][i] == mesh.cells[c][j]) {
                    verdict->add("cells", "cell " + count_text(c) + " has a vertex twice");
                    return false;
                }
        }
    for (std::size_t v = 0; v < mesh.count(); v++)
        if (!used[v]) verdict->add("cells", "vertex " + count_text(v) + " has no cell");
    return !mesh.cells.empty();
}

bool judge_neighbours(const Mesh& mesh, Hull* hull, Verdict* verdict) {
    std::vector<Facet> facets;
    for (std::uint32_t c = 0; c < mesh.cells.size(); c++)
        for (int i = 0; i <= mesh.dim; i++) {
            Facet facet = {{}, c, i};
            for (int j = 0, n = 0; j <= mesh.dim; j++)
                if (j != i) facet.vertices[n++] = mesh.cells[c][j];
            std::sort(facet.vertices.begin(), facet.vertices.begin() + mesh.dim);
            facets.push_back(facet);
        }
    std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) { return a.vertices < b.vertices; });
    bool good = true;
    const auto expect = [&](const Facet& facet, std::uint32_t due) {
        if (mesh.neighbours[facet.cell][facet.opposite] == due) return;
        verdict->add("neighbours", "neighbour " + count_text(facet.opposite) + " of cell " + count_text(facet.cell));
    };
    for (std::size_t k = 0; k < facets.size();) {
        std::size_t end = k;
        while (end < facets.size() && facets[end].vertices == facets[k].vertices) end++;
        if (end - k > 2) {
            verdict->add("cells", "a facet of three cells, " + count_text(facets[k].cell) + " among them");
            good = false;
        } else if (end - k == 2) {
            const Facet &a = facets[k], &b = facets[k + 1];
            expect(a, b.cell);
            expect(b, a.cell);
            const Point& beyond = mesh.vertices[mesh.cells[b.cell][b.opposite]];
            if (orientation(mesh, mesh.cells[a.cell], a.opposite, beyond) != -1) {
                verdict->add("cells", "cells " + count_text(a.cell) + " and " + count_text(b.cell) +
                                          " are on one side of their facet");
                good = false;
            }
        } else {
            expect(facets[k], outside);
            hull->facets.push_back({facets[k].cell, facets[k].opposite});
            for (int j = 0; j < mesh.dim; j++) hull->has[facets[k].vertices[j]] = true;
        }
        k = end;
    }
    return good;
}

// A facet's flat as {x : normal.(x - from) = 0}, with 1 at the cell's own apex; false when it is not known.
bool inner_normal(const Mesh& mesh, const Entries& cell, int opposite, const Point& from, Vector<Interval>* normal) {
    Matrix<Interval> rows;
    Vector<Interval> heights;
    int n = 0;
    for (int j = 0; j <= mesh.dim; j++) {
        const Point& x = mesh.vertices[cell[j]];
        if (&x == &from) continue;
        rows[n] = difference<Interval>(from, x, mesh.dim);
        heights[n++] = j == opposite ? 1.0 : 0.0;
    }
    return solve<Interval>(rows, heights, mesh.dim, normal);
}

void judge_hull(const Mesh& mesh, const Hull& hull, Verdict* verdict) {
    for (const auto& [c, i] : hull.facets) {
        const Entries& cell = mesh.cells[c];
        const Point& from = mesh.vertices[cell[i == 0 ? 1 : 0]];
        Vector<Interval> normal;
        const bool known = inner_normal(mesh, cell, i, from, &normal);
        for (std::size_t v = 0; v < mesh.count(); v++) {
            const Point& x = mesh.vertices[v];
            int side = known ? sign_of(dot<Interval>(normal, difference<Interval>(from, x, mesh.dim), mesh.dim)) : 2;
            if (side == 2) side = orientation(mesh, cell, i, x);
            if (side >= 0) continue;
            verdict->add("hull", "vertex " + count_text(v) + " lies outside of a facet of cell " + count_text(c));
            return;
        }
    }
}

// Is x, inside cell `home`, in another cell as well? False also when it is on a facet of one.
bool covered_once(const Mesh& mesh, std::size_t home, const Point& x, bool* on_facet) {
    for (std::size_t c = 0; c < mesh.cells.size(); c++) {
        int least = 1;
        for (int i = 0; i <= mesh.dim && least >= 0; i++)
            least = std::min(least, orientation(mesh, mesh.cells[c], i, x));
        if (least == 0) *on_facet = true;
        if (least == 0 || (least == 1) != (c == home)) return false;
    }
    return true;
}

void judge_cover(const Mesh& mesh, Random& random, Verdict* verdict) {
    for (int trial = 0; trial < 20; trial++) {
        const std::uint32_t home = random.below(mesh.cells.size());
        double weights[dim_max + 1], sum = 0;
        for (int i = 0; i <= mesh.dim; i++) sum += weights[i] = random.between(1, 2);
        Point x = {};
        for (int i = 0; i <= mesh.dim; i++)
            for (int k = 0; k < mesh.dim; k++) x[k] += weights[i] / sum * mesh.vertices[mesh.cells[home][i]][k];
        bool within = true;  // a thin cell may lose its point to rounding
        for (int i = 0; i <= mesh.dim && within; i++) within = orientation(mesh, mesh.cells[home], i, x) == 1;
        if (!within) continue;
        bool on_facet = false;
        if (covered_once(mesh, home, x, &on_facet)) return;
        if (!on_facet) return verdict->add("cells", "cell " + count_text(home) + " overlaps another one");
    }
}

void judge_spheres(const Mesh& mesh, double tests, Random& random, Verdict* verdict) {
    const auto blame = [&](std::size_t c, std::size_t v) {
        verdict->add("delaunay", "vertex " + count_text(v) + " is inside the sphere of cell " + count_text(c));
    };
    for (std::size_t c = 0; c < mesh.cells.size(); c++) {
        Sphere sphere(mesh, mesh.cells[c]);
        for (int i = 0; i <= mesh.dim; i++) {
            const std::uint32_t n = mesh.neighbours[c][i];
            if (n == outside) continue;
            for (int j = 0; j <= mesh.dim; j++) {
                const std::uint32_t v = mesh.cells[n][j];
                const auto end = mesh.cells[c].begin() + mesh.dim + 1;
                if (std::find(mesh.cells[c].begin(), end, v) == end && sphere.contains(mesh.vertices[v]))
                    return blame(c, v);
            }
        }
    }
    const double cells = static_cast<double>(mesh.cells.size()), vertices = static_cast<double>(mesh.count());
    const double share = cells * vertices <= tests ? all_of_them : tests / (cells * vertices);
    for (std::size_t c = 0; c < mesh.cells.size(); c++) {
        if (random.unit() >= share) continue;
        Sphere sphere(mesh, mesh.cells[c]);
        const auto end = mesh.cells[c].begin() + mesh.dim + 1;
        for (std::uint32_t v = 0; v < mesh.count(); v++)
            if (std::find(mesh.cells[c].begin(), end, v) == end && sphere.contains(mesh.vertices[v]))
                return blame(c, v);
    }
}

}  // namespace

int orientation(const Mesh& mesh, const Entries& cell, int i, const Point& other) {
    const int guess = orientation_in<Interval>(mesh, cell, i, other);
    return guess != 2 ? guess : orientation_in<Rational>(mesh, cell, i, other);
}

Hull judge_triangulation(const Mesh& mesh, double sphere_tests, Random& random, Verdict* verdict) {
    Hull hull;
    hull.has.assign(mesh.count(), false);
    if (mesh.cells.empty()) verdict->add("cells", "there are none");
    if (!judge_cells(mesh, verdict)) return hull;
    for (std::size_t c = 0; c < mesh.cells.size(); c++)
        if (orientation(mesh, mesh.cells[c], -1, {}) != 1) {
            verdict->add("orientation", "cell " + count_text(c) + " is not positively oriented");
            return hull;
        }
    if (!judge_neighbours(mesh, &hull, verdict)) return hull;
    judge_hull(mesh, hull, verdict);
    if (!verdict->good()) return hull;
    judge_cover(mesh, random, verdict);
    judge_spheres(mesh, sphere_tests, random, verdict);
    return hull;
}

}  // namespace referee
