#include "tools/opinion/clipped_nerve.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "tools/opinion/clipped_cells.hpp"

namespace netmesh::tool {

namespace {

// Distances that differ from the radius by less than this part of it are not told from it. The arithmetic here is far
// more precise; what it leaves out, the errors of corners and rays, is added.
constexpr Real margin = 0x1p-40L;
constexpr Real precision = 0x1p-48L;  // of corners, over the radius; how far each is off is counted
constexpr Real unit = 0x1p-58L;       // of sums of a few products

Real length(const Place& a) { return std::sqrt(dot(a, a)); }

// The rows of `m` hold a square matrix and a right side. False when a pivot vanishes.
bool eliminate(std::vector<Place>* m, Place* x) {
    const std::size_t n = m->size();
    for (std::size_t k = 0; k < n; k++) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < n; i++)
            if (std::fabs((*m)[i][k]) > std::fabs((*m)[best][k])) best = i;
        std::swap((*m)[k], (*m)[best]);
        if (!(std::fabs((*m)[k][k]) > 0)) return false;
        for (std::size_t i = k + 1; i < n; i++) add(&(*m)[i], -(*m)[i][k] / (*m)[k][k], (*m)[k]);
    }
    x->assign(n, 0);
    for (std::size_t k = n; k-- > 0;) {
        Real sum = (*m)[k][n];
        for (std::size_t j = k + 1; j < n; j++) sum -= (*m)[k][j] * (*x)[j];
        (*x)[k] = sum / (*m)[k][k];
    }
    return true;
}

// The point of the set nearest to the origin, by Wolfe's algorithm (Finding the nearest point in a polytope, 1976), in
// which rays take part as points do, but their weights add up to nothing. What it finds is judged for itself at each
// step: a sum of points and rays with weights that may be is in the set, and a direction in which all lie far enough
// keeps the set apart. So a step that rounding has spoiled leads to `unknown`, never to a wrong answer.
class NearestPoint {
public:
    explicit NearestPoint(const HullAndCone& set) : set_(set) {
        for (const Place& p : set.points) farthest_ = std::max(farthest_, length(p));
    }
    Meeting decide();

private:
    struct Atom {
        std::size_t index;
        bool is_ray;
        Real weight;
        bool operator==(const Atom& other) const { return index == other.index && is_ray == other.is_ray; }
    };
    const Place& place(const Atom& a) const { return a.is_ray ? set_.rays[a.index] : set_.points[a.index]; }
    Meeting judge(const Place& x, Atom* next) const;
    Place sum() const {
        Place x(set_.points[0].size());
        for (const Atom& a : atoms_) add(&x, a.weight, place(a));
        return x;
    }
    bool affine_minimum(Place* weights) const;
    bool descend();

    const HullAndCone& set_;
    Real farthest_ = 0;
    std::vector<Atom> atoms_;
};

// x, a sum of atoms; *next is the atom that lies farthest on the origin's side of x.
Meeting NearestPoint::judge(const Place& x, Atom* next) const {
    const Real size = length(x);
    Real error = unit * (1 + farthest_), rays = 0;
    for (const Atom& a : atoms_) {
        error += a.weight * (a.is_ray ? set_.ray_error + unit : set_.point_errors[a.index]);
        if (a.is_ray) rays += a.weight;
    }
    if (size + error < 1 - margin) return Meeting::meets;
    Real least = HUGE_VALL, back = 0, gain = unit;
    *next = {0, false, -1};
    for (std::size_t i = 0; i < set_.points.size(); i++) {
        const Real along = dot(set_.points[i], x) / size;
        least = std::min(least, along - set_.point_errors[i] - unit * farthest_);
        if (size - along > gain) gain = size - along, *next = {i, false, 0};
    }
    for (std::size_t i = 0; i < set_.rays.size(); i++) {
        const Real along = dot(set_.rays[i], x) / size;
        back = std::max(back, set_.ray_error + unit - along);
        if (-along > gain) gain = -along, *next = {i, true, 0};
    }
    const bool apart = set_.complete && least - back * set_.ray_length > 1 + margin;
    return apart ? Meeting::apart : Meeting::unknown;
}

// Weights of the atoms whose sum is nearest to the origin, of any sign, those of points 1 in sum: with the multiplier l
// the sum x has x . p = l for points and x . r = 0 for rays. Far points count by their directions, so that the rows are
// of one size.
bool NearestPoint::affine_minimum(Place* weights) const {
    const std::size_t n = atoms_.size();
    std::vector<Place> rows(n + 1, Place(n + 2));
    std::vector<Real> size;
    for (const Atom& a : atoms_) size.push_back(std::max<Real>(1, length(place(a))));
    for (std::size_t i = 0; i < n; i++) {
        for (std::size_t j = 0; j < n; j++) rows[i][j] = dot(place(atoms_[i]), place(atoms_[j])) / (size[i] * size[j]);
        rows[i][n] = rows[n][i] = atoms_[i].is_ray ? 0 : 1 / size[i];
    }
    rows[n][n + 1] = 1;
    if (!eliminate(&rows, weights)) return false;
    weights->pop_back();
    for (std::size_t i = 0; i < n; i++) (*weights)[i] /= size[i];
    return std::all_of(weights->begin(), weights->end(), [](Real w) { return std::isfinite(w); });
}

// To the minimum over the atoms, leaving out those that it would take with negative weights.
bool NearestPoint::descend() {
    while (true) {
        Place goal;
        if (!affine_minimum(&goal)) return false;
        Real share = 1;
        std::size_t first = atoms_.size();
        for (std::size_t i = 0; i < atoms_.size(); i++) {
            if (goal[i] > 0) continue;
            const Real s = atoms_[i].weight / (atoms_[i].weight - goal[i]);
            if (first == atoms_.size() || s < share) share = s, first = i;
        }
        const bool leaves = first < atoms_.size();
        for (std::size_t i = 0; i < atoms_.size(); i++)
            atoms_[i].weight += (leaves ? share : 1) * (goal[i] - atoms_[i].weight);
        if (!leaves) return true;
        atoms_.erase(atoms_.begin() + static_cast<std::ptrdiff_t>(first));
        Real points = 0;
        for (Atom& a : atoms_) {
            a.weight = std::max<Real>(a.weight, 0);
            if (!a.is_ray) points += a.weight;
        }
        if (!(points > 0)) return false;
        for (Atom& a : atoms_)
            if (!a.is_ray) a.weight /= points;
    }
}

Meeting NearestPoint::decide() {
    if (set_.points.empty()) return Meeting::unknown;
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < set_.points.size(); i++)
        if (length(set_.points[i]) < length(set_.points[nearest])) nearest = i;
    atoms_ = {{nearest, false, 1}};
    for (int step = 0; step < 200; step++) {
        Atom next;
        const Meeting found = judge(sum(), &next);
        if (found != Meeting::unknown || next.weight < 0) return found;
        if (std::find(atoms_.begin(), atoms_.end(), next) != atoms_.end()) return Meeting::unknown;
        atoms_.push_back(next);
        if (!descend()) return Meeting::unknown;
    }
    return Meeting::unknown;
}

// The Voronoi diagram of a mesh, from the ball's centre on, over its radius.
class DualFaces {
public:
    explicit DualFaces(const MeshFiles& files);

    std::size_t cell_count() const { return corners_.size(); }
    std::uint32_t vertex(std::size_t cell, std::uint32_t i) const {
        return files_.cells.entries[cell * files_.cells.columns + i];
    }
    bool surely_holds(std::size_t cell) const {
        return !corners_[cell].empty() && length(corners_[cell]) + errors_[cell] < 1 - margin;
    }
    Meeting meeting(const Vertices& simplex, const std::vector<std::uint32_t>& cells) const;

private:
    // The unbounded edge of a cell at a facet of the hull.
    struct Ray {
        std::uint32_t opposite;  // the cell's vertex that the facet lacks
        Place direction;
        Real error, height;  // of the direction; of the facet over the centre
    };
    Place from_centre(const Place& x) const {
        Place y = x;
        for (std::size_t k = 0; k < y.size(); k++) y[k] = (y[k] - centre_[k]) / radius_;
        return y;
    }
    void find_rays();
    Ray ray_at(const Vertices& facet, std::uint32_t opposite) const;

    const MeshFiles& files_;
    Place centre_;
    Real radius_;
    std::vector<Place> places_;
    std::vector<Place> corners_;  // an empty place: not known
    std::vector<Real> errors_;
    std::map<std::size_t, std::vector<Ray>> rays_;
};

DualFaces::DualFaces(const MeshFiles& files) : files_(files) {
    const NodeFile& node = files.node;
    const std::uint32_t dim = node.cloud.dim;
    centre_.assign(node.domain.begin(), node.domain.begin() + dim);
    radius_ = node.domain[dim];
    for (std::size_t v = 0; v < node.cloud.rows(); v++) {
        const double* const x = node.cloud.coordinates.data() + v * dim;
        places_.emplace_back(x, x + dim);
    }
    for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
        std::vector<Place> points;
        for (std::uint32_t i = 0; i <= dim; i++) points.push_back(places_[vertex(c, i)]);
        Sphere ball;
        smallest_circumsphere(points, &ball, precision);
        // Of a cell that is nearly flat the centre is less well known; mostly that is enough.
        const bool known = !ball.point.empty() && ball.error < 0x1p-6L * radius_;
        corners_.push_back(known ? from_centre(ball.centre()) : Place());
        // Rounding of places, which are vertices and centres, to their own magnitudes.
        Real magnitude = 0;
        if (known) magnitude = length(ball.centre()) + length(points[0]) + length(centre_);
        errors_.push_back((ball.error + unit * magnitude) / radius_);
    }
    find_rays();
}

void DualFaces::find_rays() {
    for (const HullFacet& at : hull_facets(files_.cells)) {
        Vertices facet;
        for (std::uint32_t i = 0; i < files_.cells.columns; i++)
            if (i != at.opposite) facet.push_back(vertex(at.cell, i));
        rays_[at.cell].push_back(ray_at(facet, vertex(at.cell, at.opposite)));
    }
}

// The part of `opposite` to the facet that is orthogonal to its edges, taken out twice. What rounding leaves of it in
// the facet grows with the dependence of the edges: by the quotient of each and what it has outside of those before.
DualFaces::Ray DualFaces::ray_at(const Vertices& facet, std::uint32_t opposite) const {
    std::vector<Place> across;
    Real growth = 1;
    const auto remainder = [&](const Place& to) {
        Place e = to;
        add(&e, -1, places_[facet[0]]);
        const Real before = length(e);
        for (std::size_t j = 0; j < 2 * across.size(); j++) {
            const Place& q = across[j % across.size()];
            add(&e, -dot(e, q), q);
        }
        const Real after = length(e);
        growth *= before / after;
        for (Real& x : e) x /= after;
        return e;
    };
    for (std::size_t i = 1; i < facet.size(); i++) across.push_back(remainder(places_[facet[i]]));
    Ray ray = {opposite, remainder(places_[opposite]), 0, 0};
    for (Real& x : ray.direction) x = -x;
    ray.error = 64 * unit * growth;
    ray.height = dot(ray.direction, from_centre(places_[facet[0]]));
    if (!std::isfinite(ray.error)) ray.error = HUGE_VALL;
    return ray;
}

// The dual face of a simplex is the hull of the corners of the cells around it, plus the rays out of the hull's facets
// around it. A ray n_j has height h_j = n_j . v over the centre, v a vertex of the simplex; if the centre is inside the
// hull, all are positive, and for y = p + sum of b_j n_j within the ball, p a sum of corners,
//     sum of b_j <= (y - p) . v / min h <= (1 + max |p|) |v| / min h.
Meeting DualFaces::meeting(const Vertices& simplex, const std::vector<std::uint32_t>& cells) const {
    HullAndCone set;
    Real height = HUGE_VALL, farthest = 0;
    for (const std::uint32_t c : cells) {
        if (corners_[c].empty()) {
            set.complete = false;
        } else {
            set.points.push_back(corners_[c]);
            set.point_errors.push_back(errors_[c]);
            farthest = std::max(farthest, length(corners_[c]));
        }
        const auto found = rays_.find(c);
        if (found == rays_.end()) continue;
        for (const Ray& ray : found->second) {
            if (std::binary_search(simplex.begin(), simplex.end(), ray.opposite)) continue;
            set.rays.push_back(ray.direction);
            set.ray_error = std::max(set.ray_error, ray.error);
            height = std::min(height, ray.height);
        }
    }
    if (!set.rays.empty()) {
        set.ray_length = 1.01L * (1 + farthest) * length(from_centre(places_[simplex[0]])) / height;
        if (!(height > 0 && set.ray_error < 0x1p-20L)) set.complete = false;
    }
    return meeting_of(set);
}

template <class Visit>
void for_each_face(const DualFaces& faces, std::size_t c, std::uint32_t columns, std::uint32_t top, Visit&& visit) {
    for (std::uint32_t subset = 1; subset < (1u << columns); subset++) {
        Vertices face;
        for (std::uint32_t i = 0; i < columns; i++)
            if ((subset >> i & 1) != 0) face.push_back(faces.vertex(c, i));
        if (face.size() > top + 1) continue;
        std::sort(face.begin(), face.end());
        visit(std::move(face));
    }
}

}  // namespace

Meeting meeting_of(const HullAndCone& set) { return NearestPoint(set).decide(); }

ClippedNerve clipped_nerve(const MeshFiles& files, std::uint32_t top) {
    const DualFaces faces(files);
    const std::uint32_t columns = files.cells.columns;
    ClippedNerve nerve;
    nerve.vertices.assign(files.node.cloud.rows(), Meeting::apart);
    for (std::size_t c = 0; c < faces.cell_count(); c++) {
        if (!faces.surely_holds(c)) continue;
        for_each_face(faces, c, columns, top, [&](Vertices face) { nerve.simplices.insert(std::move(face)); });
    }
    // What is left has none of those cells around it.
    std::map<Vertices, std::vector<std::uint32_t>> around;
    for (std::size_t c = 0; c < faces.cell_count(); c++) {
        if (faces.surely_holds(c)) continue;
        for_each_face(faces, c, columns, top, [&](Vertices face) {
            if (nerve.simplices.count(face) == 0) around[std::move(face)].push_back(static_cast<std::uint32_t>(c));
        });
    }
    for (const auto& [simplex, cells] : around) {
        const Meeting found = faces.meeting(simplex, cells);
        if (found == Meeting::meets) nerve.simplices.insert(simplex);
        if (found == Meeting::unknown) nerve.unknown++;
        if (found == Meeting::unknown && simplex.size() == 1) nerve.vertices[simplex[0]] = found;
    }
    for (const Vertices& simplex : nerve.simplices)
        if (simplex.size() == 1) nerve.vertices[simplex[0]] = Meeting::meets;
    return nerve;
}

}  // namespace netmesh::tool
