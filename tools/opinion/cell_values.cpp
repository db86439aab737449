#include "tools/opinion/cell_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "tools/opinion/cell_search.hpp"
#include "tools/opinion/clipped_cells.hpp"
#include "tools/opinion/clipped_nerve.hpp"
#include "tools/opinion/corner_error.hpp"

namespace netmesh::tool {

namespace {

constexpr Real unbounded = HUGE_VALL;

Place place_of(const PointCloud& cloud, std::size_t row) {
    const double* const x = cloud.coordinates.data() + row * cloud.dim;
    return Place(x, x + cloud.dim);
}

std::uint32_t input_count(const NodeFile& node) {
    std::uint32_t count = 0;
    while (count < node.markers.size() && node.markers[count] == 0) count++;
    return count;
}

Real distance(const Place& a, const Place& b) { return std::sqrt(distance2(a, b)); }

// Inputs whose distances from a vertex differ by less are equally near.
constexpr Real tie = 1e-12L;
// What a corner's shape may add to its distances, over its radius, is counted from here on: less is within the
// tolerance.
constexpr Real excess_min = 1e-9L;
// As well as that corners are known, over the radius; far better than the tolerance.
constexpr Real corner_precision = 0x1p-48L;

}  // namespace

FilteredFunction::FilteredFunction(const NodeFile& node, netmesh_filter_id filter, std::uint32_t k)
    : mean_(filter == NETMESH_FILTER_KDISTANCE), k_(about(filter).needs_k != 0 ? k : 1) {
    const std::uint32_t dim = node.cloud.dim;
    const Place centre(node.domain.begin(), node.domain.begin() + dim);
    Real magnitude = 1;  // of a single point, whose ball has no radius
    for (std::uint32_t i = 0; i < input_count(node); i++) {
        inputs_.push_back(place_of(node.cloud, i));
        cut_ = std::max(cut_, distance(inputs_.back(), centre));
        for (const Real x : inputs_.back()) magnitude = std::max(magnitude, std::fabs(x));
    }
    if (inputs_.size() == 1) cut_ = magnitude;
}

std::vector<std::pair<Real, std::uint32_t>> FilteredFunction::nearest(const Place& x) const {
    std::vector<std::pair<Real, std::uint32_t>> squares;
    if (k_ == 1) {
        squares.emplace_back(unbounded, 0);
        for (std::uint32_t i = 0; i < inputs_.size(); i++) {
            const Real square = distance2(inputs_[i], x);
            if (square < squares[0].first) squares[0] = {square, i};
        }
        return squares;
    }
    for (std::uint32_t i = 0; i < inputs_.size(); i++) squares.emplace_back(distance2(inputs_[i], x), i);
    std::partial_sort(squares.begin(), squares.begin() + k_, squares.end());
    squares.resize(k_);
    return squares;
}

Real FilteredFunction::value_of(const std::vector<std::pair<Real, std::uint32_t>>& nearest) const {
    Real sum = 0;
    for (const auto& input : nearest) sum += input.first;
    return std::sqrt(mean_ ? sum / k_ : nearest.back().first);
}

Real FilteredFunction::operator()(const Place& x, Place* source) const {
    const auto inputs = nearest(x);
    *source = inputs_[inputs.back().second];
    for (std::size_t k = 0; k < x.size() && mean_; k++) {
        (*source)[k] = 0;
        for (const auto& input : inputs) (*source)[k] += inputs_[input.second][k] / k_;
    }
    return std::min(cut_, value_of(inputs));
}

namespace {

// The mesh vertex by vertex.
class CellWalk {
public:
    CellWalk(const MeshFiles& files, const FilterChoice& choice, std::uint32_t k);
    CellOpinion take(Real claimed);

private:
    bool is_input(std::size_t v) const { return node_.markers[v] == 0; }
    bool is_exempt(std::size_t v) const { return node_.markers[v] == 2; }
    bool is_bounded(std::size_t v) const { return node_.clipped || !is_exempt(v); }
    // Not when its clipped cell is empty, or may be.
    bool is_cut(std::size_t v) const { return node_.clipped && clipped_->is_cut(v); }
    bool counts(std::size_t v) const { return !node_.clipped || meeting_[v] == Meeting::meets; }
    void find_nearest();
    void clip_cells();
    // Of a clipped cell the places that stand for corners: it reaches as far as they do from v and its nearest inputs.
    template <class Visit> void for_each_corner(std::size_t v, Visit&& visit) const {
        if (is_cut(v)) {
            for (const Known& end : ends_[v]) visit(end);
            return;
        }
        for (const std::uint32_t c : star_[v])
            if (!corners_[c].empty()) visit(known_[c]);
    }
    // What the cell reaches from a place, and that share of what a proof in doubles may say beyond it.
    Real farthest_corner(std::size_t v, const Place& from, Real share) const;
    Real function_radius(std::size_t v, Real share) const { return farthest_corner(v, places_[v], share); }
    Real cut_excess(std::size_t v, const Place& from, Real reach) const;
    bool has_excess(std::size_t v) const {
        return is_cut(v) || choice_.filter == NETMESH_FILTER_TIGHT ||
               std::any_of(star_[v].begin(), star_[v].end(), [&](auto c) { return excess_[c] > 0; });
    }
    Place towards(std::size_t v, const Place& goal) const;
    // Adds places of v's cell.
    template <class Nearest> void search(std::size_t v, Nearest&& nearest_to, std::vector<Known>* known) {
        const std::size_t before = known->size();
        seek_most(function_, known);
        seek_least(function_, places_[nearest_[v][0]], nearest_to, known);
        found_.places += known->size() - before;
    }
    void look(std::size_t v, CellRange* seen);

    Real own_value(std::size_t v, std::uint32_t nearest) const;
    // What a certificate may make of a cell: it takes an exempt vertex's for unbounded or not, and what a cell reaches
    // as it is or for as much as a proof may say.
    struct Reading {
        bool modest;
        Real own, far;  // shares of that excess, of the distances from the vertex and from the nearest input
    };
    CellRange range_of(std::size_t v, std::uint32_t nearest, const Reading& reading) const;
    // Both for each input that may count as v's nearest, by each reading.
    template <class Visit> void for_each_nearest(std::size_t v, Visit&& visit) const {
        for (const std::uint32_t p : nearest_[v]) {
            visit(range_of(v, p, plain), own_value(v, p));
            for (int shares = 0; shares < 4 && has_excess(v); shares++)
                visit(range_of(v, p, {!is_cut(v), shares % 2 * 1.0L, shares / 2 * 1.0L}), own_value(v, p));
        }
    }
    bool has_ratio(std::size_t v) const { return choice_.filter != NETMESH_FILTER_BASIC || !is_input(v); }
    Real certified(Real t, const CellRange& range, Real ratio) const;
    // Of the cells of clumps: the distance from an input at distance d to the cell of v.
    Real away(std::size_t v, Real d, const Reading& reading) const {
        return is_exempt(v) && reading.modest ? d / 2 : std::max(d / 2, d - function_radius(v, reading.own));
    }
    void gather_clumps();
    void find_ratio();
    void find_values(Real claimed);

    const MeshFiles& files_;
    const NodeFile& node_;
    FilterChoice choice_;
    bool by_neighbours_;  // d_k or the k-distance, k > 1
    FilteredFunction function_;
    // Of a cell that is flat to the digits of its vertices no corner is known, an empty place: the cells beside it have
    // the same corner, nearly.
    std::vector<Place> places_, corners_;
    std::vector<Known> known_;  // of the function at corners
    std::vector<Real> error_;   // of corners, over the radius
    std::vector<Real> excess_;  // what a proof may add to distances from corners; 0 when within the tolerance
    std::vector<std::vector<std::uint32_t>> star_;     // Delaunay cells around each vertex
    std::vector<std::vector<std::uint32_t>> nearest_;  // inputs of each vertex, ties in all
    std::vector<Real> neighbour_;                      // distance to the nearest other vertex
    std::optional<ClippedCells> clipped_;
    std::vector<Meeting> meeting_;                       // of each cell with the ball
    std::vector<std::vector<Known>> ends_;               // of cells that are cut
    std::vector<Real> half_;                             // tight: half of the distance from an input to the next
    std::vector<std::uint32_t> clump_;                   // the input whose clump a vertex is in
    std::array<std::vector<CellRange>, 2> clump_range_;  // of an input, without excess and with it
    CellOpinion found_;
    static constexpr Reading plain = {true, 0, 0};
    static constexpr std::uint32_t nobody = UINT32_MAX;
};

CellWalk::CellWalk(const MeshFiles& files, const FilterChoice& choice, std::uint32_t k)
    : files_(files), node_(files.node), choice_(choice), by_neighbours_(about(choice.filter).needs_k != 0 && k > 1),
      function_(files.node, choice.filter, k) {
    const std::size_t count = node_.cloud.rows();
    const std::uint32_t columns = files.cells.columns;
    for (std::size_t v = 0; v < count; v++) places_.push_back(place_of(node_.cloud, v));
    star_.resize(count);
    for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
        std::vector<Place> points;
        for (std::uint32_t i = 0; i < columns; i++) {
            const std::uint32_t v = files.cells.entries[c * columns + i];
            points.push_back(places_[v]);
            star_[v].push_back(static_cast<std::uint32_t>(c));
        }
        Sphere ball;
        const bool known = smallest_circumsphere(points, &ball, corner_precision);
        corners_.push_back(known ? ball.centre() : Place());
        const CornerError error = known ? corner_error(points, ball) : CornerError();
        error_.push_back(error.shape + error.coordinates);
        // Twice: the corner is off by that much, and a proof adds as much.
        excess_.push_back(2 * error.shape > excess_min ? 2 * error.shape * ball.radius : 0);
        known_.push_back(known ? known_at(function_, corners_.back()) : Known());
    }
    find_nearest();
    found_.places = corners_.size() + count;
    if (node_.clipped) clip_cells();
    if (choice.filter == NETMESH_FILTER_TIGHT) gather_clumps();
}

void CellWalk::clip_cells() {
    meeting_ = clipped_nerve(files_, 0).vertices;
    clipped_.emplace(files_, places_, corners_, star_);
    ends_.resize(places_.size());
    for (std::size_t v = 0; v < places_.size(); v++) {
        if (!clipped_->is_cut(v) || meeting_[v] == Meeting::apart) continue;
        std::vector<Place> from = {places_[v]};
        for (const std::uint32_t p : nearest_[v]) from.push_back(places_[p]);
        const auto shape = clipped_->shape(v);
        for (Place& x : clipped_->places(*shape, from)) ends_[v].push_back(known_at(function_, std::move(x)));
        if (ends_[v].empty()) {
            meeting_[v] = Meeting::unknown;
            continue;
        }
        search(
            v, [&](const Place& goal) { return clipped_->nearest(*shape, goal); }, &ends_[v]);
    }
}

void CellWalk::find_nearest() {
    const std::uint32_t inputs = input_count(node_), columns = files_.cells.columns;
    for (std::size_t v = 0; v < places_.size(); v++) {
        Real least2 = unbounded;
        for (std::uint32_t p = 0; p < inputs; p++) least2 = std::min(least2, distance2(places_[v], places_[p]));
        nearest_.emplace_back();
        for (std::uint32_t p = 0; p < inputs; p++) {
            if (distance2(places_[v], places_[p]) <= least2 * (1 + 2 * tie)) nearest_.back().push_back(p);
        }
        Real neighbour2 = unbounded;
        for (const std::uint32_t c : star_[v]) {
            for (std::uint32_t i = 0; i < columns; i++) {
                const std::uint32_t u = files_.cells.entries[c * columns + i];
                if (u != v) neighbour2 = std::min(neighbour2, distance2(places_[v], places_[u]));
            }
        }
        neighbour_.push_back(std::sqrt(neighbour2));
    }
}

Real CellWalk::farthest_corner(std::size_t v, const Place& from, Real share) const {
    if (is_cut(v)) {
        Real far2 = 0;
        for (const Known& end : ends_[v]) far2 = std::max(far2, distance2(end.x, from));
        return std::sqrt(far2) + (share > 0 ? share * cut_excess(v, from, std::sqrt(far2)) : 0);
    }
    Real far = 0;
    for (const std::uint32_t c : star_[v])
        if (!corners_[c].empty()) far = std::max(far, distance(corners_[c], from) + share * excess_[c]);
    return far;
}

// The engine proves what a clipped cell reaches from u: it cuts the cell by the half-space of the places in the ball
// that are at s or more from u, with s a little more than the reach it has measured, and shows that what is left does
// not go beyond s or has nothing of the ball. As corners are off by d it has to cut at a half-space for a smaller s,
// s^2 - S; when this is still more than the reach, what is left is as it should be. So s need not be more than the
// reach times 1 + S / (2 reach^2). It tries 2^-38 and then 2^6 times as much a step: at most 2^6 times what is needed,
// up to the 2^-20 that its own test asks for (S is far less for most cells than it can be). The reach it then states
// counts errors of corners twice, as they are and as they are allowed for, and roundings of places on edges.
//
// With c the ball's centre and r its radius, |x - c|^2 - r^2 - |x - u|^2 + s^2 changes by 2 |u - c| a unit of length.
// It is 2 (x - u) (u - c) and three squares, in doubles off by less than 2^-44 of all those terms; both may count
// twice.
Real CellWalk::cut_excess(std::size_t v, const Place& from, Real reach) const {
    const Real away = distance(from, clipped_->centre()), radius = clipped_->radius();
    Real wide = 0, most = 0, doubt = 0;
    bool is_known = true;
    for (const std::uint32_t c : star_[v]) {
        is_known = is_known && !corners_[c].empty();
        if (corners_[c].empty()) continue;
        const Real length = distance(corners_[c], places_[v]);
        wide = std::max(wide, length);
        most = std::max(most, error_[c]);
        doubt = std::max(doubt, error_[c] * length);
    }
    // In the ball an edge's place is in doubt by its share of the end beyond.
    doubt = std::min(doubt, 3 * most * reach);
    const Real both = 2 * (wide + distance(from, places_[v]));
    const Real rounding = 0x1p-44L * (2 * both * away + away * away + radius * radius + reach * reach);
    const Real slack = 4 * away * doubt + 8 * rounding;
    const Real needed = is_known ? std::max(0x1p-38L, slack / (2 * reach * reach)) : 1;
    return std::min(0x1p-20L, 0x1p6L * needed) * reach + 2 * doubt + 0x1p-43L * both;
}

// A place of v's cell, which lies in the ball or is bounded, near the one that is nearest to `goal`: a mean of corners
// whose weights go from the corner that leads there least to the one that leads there most.
Place CellWalk::towards(std::size_t v, const Place& goal) const {
    const std::size_t dim = goal.size();
    std::vector<Real> corners;  // from the goal on, one after the other
    for_each_corner(v, [&](const Known& corner) {
        for (std::size_t k = 0; k < dim; k++) corners.push_back(corner.x[k] - goal[k]);
    });
    const std::size_t count = corners.size() / dim;
    if (count == 0) return {};
    const auto dot = [dim](const Real* a, const Real* b) {
        Real sum = 0;
        for (std::size_t k = 0; k < dim; k++) sum += a[k] * b[k];
        return sum;
    };
    const auto corner = [&](std::size_t i) { return corners.data() + i * dim; };
    std::vector<Real> weight(count, 0);
    std::size_t start = 0;
    for (std::size_t i = 1; i < count; i++)
        if (dot(corner(i), corner(i)) < dot(corner(start), corner(start))) start = i;
    weight[start] = 1;
    Place x(corner(start), corner(start) + dim);
    for (int step = 0; step < 200; step++) {
        // The one that leads there most has the least product with x.
        std::size_t best = 0, worst = 0;
        Real least = unbounded, most = -unbounded;
        for (std::size_t i = 0; i < count; i++) {
            const Real along = dot(x.data(), corner(i));
            if (along < least) least = along, best = i;
            if (weight[i] > 0 && along > most) most = along, worst = i;
        }
        const Real x2 = dot(x.data(), x.data());
        if (!(x2 - least > 1e-9L * x2)) break;
        Place way(dim);
        for (std::size_t k = 0; k < dim; k++) way[k] = corner(best)[k] - corner(worst)[k];
        const Real share = std::min(weight[worst], (most - least) / dot(way.data(), way.data()));
        weight[best] += share;
        weight[worst] -= share;
        for (std::size_t k = 0; k < dim; k++) x[k] += share * way[k];
    }
    for (std::size_t k = 0; k < dim; k++) x[k] += goal[k];
    return x;
}

void CellWalk::look(std::size_t v, CellRange* seen) {
    *seen = {unbounded, 0};
    if (!counts(v)) return;
    std::vector<Known> known;
    for_each_corner(v, [&](const Known& corner) { known.push_back(corner); });
    if (!node_.clipped || clipped_->holds(places_[v])) known.push_back(known_at(function_, places_[v]));
    if (is_bounded(v) && !is_cut(v))
        search(
            v, [&](const Place& goal) { return towards(v, goal); }, &known);
    for (const Known& place : known) *seen = {std::min(seen->lo, place.f), std::max(seen->hi, place.f)};
    // Balls stand for the cells of inputs, and for those of clumps, where the distance to the points goes down to 0.
    const bool in_ball = !by_neighbours_ && (is_input(v) || (!clump_.empty() && clump_[v] != nobody));
    if (in_ball) seen->lo = unbounded;
}

Real CellWalk::own_value(std::size_t v, std::uint32_t nearest) const {
    if (by_neighbours_) return function_(places_[v]);
    const Real d = distance(places_[v], places_[nearest]);
    Real s = is_input(v) ? neighbour_[v] / 2 : d;
    if (choice_.filter == NETMESH_FILTER_TIGHT) s = std::max(d, half_[nearest]);
    return std::min(s, function_.cut());
}

CellRange CellWalk::range_of(std::size_t v, std::uint32_t nearest, const Reading& reading) const {
    const Real cut = function_.cut();
    const auto within = [&](Real lo, Real hi) { return CellRange{std::min(lo, cut), std::min(hi, cut)}; };
    if (!clump_.empty() && clump_[v] != nobody) {
        const CellRange& range = clump_range_[reading.far > 0][clump_[v]];
        return within(range.lo, range.hi);
    }
    const bool endless = is_exempt(v) && reading.modest;
    if (by_neighbours_) {
        const Real f = function_.uncut(places_[v]);
        return within(away(v, f, reading), endless ? unbounded : f + function_radius(v, reading.own));
    }
    if (is_input(v)) return within(neighbour_[v] / 2, function_radius(v, reading.own));
    const Real d = distance(places_[v], places_[nearest]);
    const Real far = endless ? unbounded : farthest_corner(v, places_[nearest], reading.far);
    return within(away(v, d, reading), far);
}

// An input p and the vertices nearest to it within half of its distance to the next input. F is at most hi on their
// cells; lo is how near another input comes to them, and how near p comes to the cells beside them.
void CellWalk::gather_clumps() {
    const std::uint32_t inputs = input_count(node_), columns = files_.cells.columns;
    half_.assign(inputs, unbounded);
    for (std::uint32_t p = 0; p < inputs; p++) {
        for (std::uint32_t q = 0; q < inputs; q++) {
            if (p != q) half_[p] = std::min(half_[p], distance(places_[p], places_[q]) / 2);
        }
    }
    for (std::size_t v = 0; v < places_.size(); v++) {
        const std::uint32_t p = nearest_[v][0];
        const bool joins = !is_exempt(v) && counts(v) && distance(places_[v], places_[p]) <= half_[p];
        clump_.push_back(joins ? p : nobody);
    }
    for (const int share : {0, 1}) {
        std::vector<CellRange>& ranges = clump_range_[share];
        const Reading reading = {true, static_cast<Real>(share), static_cast<Real>(share)};
        ranges.assign(inputs, {unbounded, 0});
        for (std::size_t v = 0; v < places_.size(); v++) {
            const std::uint32_t p = clump_[v];
            if (p == nobody) continue;
            Real other = unbounded;
            for (std::uint32_t q = 0; q < inputs; q++) {
                if (q != p) other = std::min(other, distance(places_[v], places_[q]));
            }
            ranges[p].lo = std::min(ranges[p].lo, away(v, other, reading));
            ranges[p].hi = std::max(ranges[p].hi, farthest_corner(v, places_[p], reading.far));
            for (const std::uint32_t c : star_[v]) {
                for (std::uint32_t i = 0; i < columns; i++) {
                    const std::uint32_t u = files_.cells.entries[c * columns + i];
                    if (clump_[u] == p || !counts(u)) continue;
                    ranges[p].lo = std::min(ranges[p].lo, away(u, distance(places_[p], places_[u]), reading));
                }
            }
        }
    }
}

// Certified values are the filter's own, moved as little as the best ratio allows, and that ratio is theirs.
Real CellWalk::certified(Real t, const CellRange& range, Real ratio) const {
    if (choice_.values == NETMESH_VALUES_THESIS) return t;
    return std::min(std::max(t, range.hi / ratio), range.lo * ratio);
}

void CellWalk::find_ratio() {
    for (std::size_t v = 0; v < places_.size(); v++) {
        if (!counts(v)) {
            if (meeting_[v] == Meeting::unknown) found_.ratio.most = unbounded;
            continue;
        }
        Span span = {unbounded, 1}, reach = {unbounded, 0};
        for_each_nearest(v, [&](const CellRange& range, Real t) {
            const Real ratio = choice_.values == NETMESH_VALUES_THESIS ? std::max(range.hi / t, t / range.lo)
                                                                       : std::sqrt(range.hi / range.lo);
            span = {std::min(span.least, ratio), std::max(span.most, ratio)};
            reach = {std::min(reach.least, range.hi), std::max(reach.most, range.hi)};
        });
        Span& all = has_ratio(v) ? found_.ratio : found_.from;
        const Span& own = has_ratio(v) ? span : reach;
        all = {std::max(all.least, own.least), std::max(all.most, own.most)};
    }
}

void CellWalk::find_values(Real claimed) {
    for (std::size_t v = 0; v < places_.size(); v++) {
        if (!counts(v)) {
            found_.values.push_back({0, unbounded});
            continue;
        }
        Span span = {unbounded, 0};
        for_each_nearest(v, [&](const CellRange& range, Real own) {
            const Real t = has_ratio(v) ? certified(own, range, claimed) : 0;
            span = {std::min(span.least, t), std::max(span.most, t)};
        });
        found_.values.push_back(span);
    }
}

CellOpinion CellWalk::take(Real claimed) {
    for (std::size_t v = 0; v < places_.size(); v++) {
        found_.seen.emplace_back();
        look(v, &found_.seen.back());
    }
    find_ratio();
    find_values(claimed);
    Real magnitude = 0, nearest = unbounded;
    for (std::size_t v = 0; v < places_.size(); v++) {
        nearest = std::min(nearest, neighbour_[v]);
        for (const Real x : places_[v]) magnitude = std::max(magnitude, std::fabs(x));
    }
    const Real unit = 0x1p-52L * std::sqrt(static_cast<Real>(node_.cloud.dim)) * magnitude;
    found_.tolerance += std::min<Real>((node_.clipped ? 64 : 5.2L) * unit / nearest, 5.2L / 24);
    return std::move(found_);
}

}  // namespace

std::uint32_t zero_born(const NodeFile& node, netmesh_filter_id filter, std::uint32_t k) {
    if (filter == NETMESH_FILTER_FUNCTION) return 0;
    const bool has_balls = filter != NETMESH_FILTER_BASIC && (about(filter).needs_k == 0 || k == 1);
    return has_balls ? input_count(node) : 0;
}

double opinion_cost(const MeshFiles& files) {
    const double vertices = static_cast<double>(files.node.cloud.rows()) + files.cells.lines.size();
    // Faces of cells that the ball cuts, with what each takes.
    const double columns = files.cells.columns, faces = files.cells.lines.size() * columns * std::exp2(columns - 1);
    return vertices * input_count(files.node) + (files.node.clipped ? 25 * faces : 0);
}

CellOpinion cell_opinion(const MeshFiles& files, const FilterChoice& choice, std::uint32_t k, double claimed) {
    return CellWalk(files, choice, k).take(claimed);
}

}  // namespace netmesh::tool
