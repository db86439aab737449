#include "tools/opinion/clipped_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace netmesh::tool {

namespace {

// A place is in a cell that it leaves by less than this part of lengths there.
constexpr Real inside = 1e-13L;
// Of an edge and what of it is orthogonal to others: edges that keep less are dependent but for their last digits.
constexpr Real dependent = 1e-10L;
// What is left of a vector in a flat's directions is rounding when it is less than this part of it.
constexpr Real lost = 1e-15L;

Place difference(const Place& a, const Place& b) {
    Place d = a;
    add(&d, -1, b);
    return d;
}

}  // namespace

using Set = std::vector<std::uint16_t>;  // positions in a list of neighbours, ascending

// The cell of a vertex, which is the origin: a . y <= |a|^2 / 2 for all neighbours a.
struct Star {
    std::vector<Place> a;
    Place centre;
    Real power;  // |centre|^2 - radius^2

    bool holds(const Place& y, const Set& face) const {
        const Real size = std::sqrt(dot(y, y));
        for (std::size_t u = 0; u < a.size(); u++) {
            if (std::binary_search(face.begin(), face.end(), static_cast<std::uint16_t>(u))) continue;
            const Real length = std::sqrt(dot(a[u], a[u]));
            if (dot(a[u], y) / length > length / 2 + inside * (length + size)) return false;
        }
        return true;
    }
};

// The flat of a face: q . y = h for orthonormal q, and where it comes nearest to the ball's centre.
struct Flat {
    std::vector<Place> q;
    std::vector<Real> h;
    Place foot;
    Real chord2;  // of the sphere that the ball's has in the flat, the radius squared; negative: there is none

    bool find(const Star& star, const Set& face);
    bool is_edge() const { return q.size() + 1 == foot.size(); }
    // What of d is in the flat's directions.
    Place along(Place d) const {
        for (std::size_t j = 0; j < 2 * q.size(); j++) add(&d, -dot(d, q[j % q.size()]), q[j % q.size()]);
        return d;
    }
    Place foot_of(const Place& to) const {
        Place y = along(to);
        for (std::size_t i = 0; i < q.size(); i++) add(&y, h[i], q[i]);
        return y;
    }
    // Of its sphere, the first one the farthest from p, the second one the nearest. `centre`: of the ball.
    std::array<Place, 2> poles(const Place& p, const Place& centre) const {
        const Place away = difference(centre, p);
        Place direction = is_edge() ? some_direction() : along(away);
        if (!(dot(direction, direction) > lost * lost * dot(away, away))) direction = some_direction();
        const Real share = std::sqrt(chord2 / dot(direction, direction));
        std::array<Place, 2> pole = {foot, foot};
        add(&pole[0], share, direction);
        add(&pole[1], -share, direction);
        return pole;
    }
    Place some_direction() const {
        Place best;
        for (std::size_t axis = 0; axis < foot.size(); axis++) {
            Place d(foot.size());
            d[axis] = 1;
            d = along(d);
            if (best.empty() || dot(d, d) > dot(best, best)) best = d;
        }
        return best;
    }
};

bool Flat::find(const Star& star, const Set& face) {
    for (const std::uint16_t u : face) {
        Place e = star.a[u];
        const Real before = dot(e, e);
        Real height = before / 2;
        for (std::size_t j = 0; j < 2 * q.size(); j++) {
            const std::size_t i = j % q.size();
            const Real part = dot(e, q[i]);
            add(&e, -part, q[i]);
            height -= part * h[i];
        }
        const Real after = std::sqrt(dot(e, e));
        if (!(after > dependent * std::sqrt(before))) return false;
        for (Real& x : e) x /= after;
        q.push_back(e);
        h.push_back(height / after);
    }
    // From the flat's place `base` nearest to the vertex on, |base + x - centre|^2 = radius^2 with x in the flat's
    // directions: of a small cell by the sphere all terms are small.
    Place base(star.centre.size());
    for (std::size_t i = 0; i < q.size(); i++) add(&base, h[i], q[i]);
    const Place across = along(star.centre);
    foot = base;
    add(&foot, 1, across);
    chord2 = dot(across, across) - (dot(base, base) - 2 * dot(base, star.centre) + star.power);
    return true;
}

namespace {

Real power_of(const Place& x, const Place& centre, Real radius) {
    Wide sum = -(Wide{static_cast<Half>(radius), 0} * Wide{static_cast<Half>(radius), 0});
    for (std::size_t k = 0; k < x.size(); k++) {
        const Wide d = exact_sum(static_cast<Half>(centre[k]), -static_cast<Half>(x[k]));
        sum = sum + d * d;
    }
    return static_cast<Real>(sum.high);
}

}  // namespace

struct CellShape {
    std::size_t vertex;
    Star star;
    std::vector<std::pair<Set, Flat>> faces;
};

std::vector<HullFacet> hull_facets(const CellTable& cells) {
    std::map<std::vector<std::uint32_t>, HullFacet> alone;
    for (std::size_t c = 0; c < cells.lines.size(); c++) {
        for (std::uint32_t i = 0; i < cells.columns; i++) {
            std::vector<std::uint32_t> facet;
            for (std::uint32_t j = 0; j < cells.columns; j++)
                if (j != i) facet.push_back(cells.entries[c * cells.columns + j]);
            std::sort(facet.begin(), facet.end());
            const auto [at, added] = alone.emplace(std::move(facet), HullFacet{c, i});
            if (!added) alone.erase(at);
        }
    }
    std::vector<HullFacet> found;
    for (const auto& entry : alone) found.push_back(entry.second);
    return found;
}

ClippedCells::ClippedCells(const MeshFiles& files, const std::vector<Place>& places, const std::vector<Place>& corners,
                           const std::vector<std::vector<std::uint32_t>>& star)
    : files_(files), places_(places), corners_(corners), star_(star) {
    const NodeFile& node = files.node;
    const std::uint32_t dim = node.cloud.dim, columns = files.cells.columns;
    centre_.assign(node.domain.begin(), node.domain.begin() + dim);
    radius_ = node.domain[dim];
    cut_.assign(places.size(), false);
    for (std::size_t c = 0; c < corners.size(); c++) {
        const std::uint32_t* const vertex = files.cells.entries.data() + c * columns;
        const bool deep = !corners[c].empty() && std::sqrt(distance2(corners[c], centre_)) < radius_ * (1 - inside);
        for (std::uint32_t i = 0; i < columns && !deep; i++) cut_[vertex[i]] = true;
    }
    for (const HullFacet& facet : hull_facets(files.cells)) {
        for (std::uint32_t i = 0; i < columns; i++)
            if (i != facet.opposite) cut_[files.cells.entries[facet.cell * columns + i]] = true;
    }
}

std::shared_ptr<const CellShape> ClippedCells::shape(std::size_t v) const {
    const std::uint32_t columns = files_.cells.columns;
    const std::size_t dim = columns - 1;
    std::map<std::uint32_t, std::uint16_t> position;
    std::set<Set> faces;
    Star star = {{}, difference(centre_, places_[v]), power_of(places_[v], centre_, radius_)};
    for (const std::uint32_t c : star_[v]) {
        Set others;
        for (std::uint32_t i = 0; i < columns; i++) {
            const std::uint32_t u = files_.cells.entries[c * columns + i];
            if (u == v) continue;
            const auto [at, added] = position.emplace(u, static_cast<std::uint16_t>(star.a.size()));
            if (added) star.a.push_back(difference(places_[u], places_[v]));
            others.push_back(at->second);
        }
        std::sort(others.begin(), others.end());
        for (std::uint32_t subset = 0; subset + 1 < (1u << dim); subset++) {
            Set face;
            for (std::size_t i = 0; i < dim; i++)
                if ((subset >> i & 1) != 0) face.push_back(others[i]);
            faces.insert(std::move(face));
        }
    }
    const auto shape = std::make_shared<CellShape>();
    for (const Set& face : faces) {
        Flat flat;
        if (flat.find(star, face) && flat.chord2 >= 0) shape->faces.emplace_back(face, std::move(flat));
    }
    shape->vertex = v;
    shape->star = std::move(star);
    return shape;
}

std::vector<Place> ClippedCells::places(const CellShape& shape, const std::vector<Place>& from) const {
    const Place& origin = places_[shape.vertex];
    std::vector<Place> found;
    for (const std::uint32_t c : star_[shape.vertex])
        if (!corners_[c].empty() && holds(corners_[c])) found.push_back(corners_[c]);
    const auto offer = [&](const Set& face, Place y) {
        if (!shape.star.holds(y, face)) return;
        add(&y, 1, origin);
        found.push_back(std::move(y));
    };
    for (const auto& [face, flat] : shape.faces) {
        for (const Place& q : from) {
            const std::array<Place, 2> pole = flat.poles(difference(q, origin), shape.star.centre);
            offer(face, pole[0]);
            if (!flat.is_edge()) continue;
            offer(face, pole[1]);
            break;
        }
    }
    return found;
}

Place ClippedCells::nearest(const CellShape& shape, const Place& q) const {
    const Place& origin = places_[shape.vertex];
    const Place goal = difference(q, origin);
    Place best;
    Real least2 = HUGE_VALL;
    for (const std::uint32_t c : star_[shape.vertex]) {
        if (corners_[c].empty() || !holds(corners_[c]) || !(distance2(corners_[c], q) < least2)) continue;
        least2 = distance2(corners_[c], q);
        best = difference(corners_[c], origin);
    }
    for (const auto& [face, flat] : shape.faces) {
        const Place foot = flat.foot_of(goal);
        const bool is_foot = distance2(foot, shape.star.centre) <= radius_ * radius_;
        const std::array<Place, 2> pole = flat.poles(goal, shape.star.centre);
        for (const int side : {1, 0}) {
            const Place& y = is_foot ? foot : pole[side];
            const Real far2 = distance2(y, goal);
            if (far2 < least2 && shape.star.holds(y, face)) {
                least2 = far2;
                best = y;
            }
            if (is_foot || !flat.is_edge()) break;
        }
    }
    if (!best.empty()) add(&best, 1, origin);
    return best;
}

}  // namespace netmesh::tool
