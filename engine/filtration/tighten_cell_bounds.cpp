#include "filtration/tighten_cell_bounds.hpp"

#include "certificate/cells.hpp"
#include "geometry/nearest_in_hull.hpp"

namespace netmesh {
namespace {

class CellTightener {
public:
    CellTightener(const AnyStore& store, const AnyInputTree& tree, double cut, Arena& arena)
        : dim(store.dim), store_(store), tree_(tree), cut_(cut), arena_(arena) {}

    Status open();
    Status tighten(VertexId v, Interval* interval);

private:
    bool gather(VertexId v, bool* known);
    double input_distance_low(VertexId v, double least);
    double input_distance_high(VertexId v);
    void from_vertex(std::uint32_t input, double* q) const {
        const double *const point = store_.point(input), *const at = at_;
        for (int k = 0; k < dim; ++k) q[k] = point[k] - at[k];
    }
    PointColumns corners() const { return {corner_, corners_most_, corners_, dim}; }
    bool is_beyond(const double* q, double reach) const;
    void bound_input(const double* q);
    double farthest_corner(const double* mean, double square, std::uint32_t* corner);

    const int dim;
    const AnyStore& store_;
    const AnyInputTree& tree_;
    double cut_;
    Arena& arena_;

    const double* at_ = nullptr;  // the vertex; lengths and points are relative to it
    double* corner_ = nullptr;    // coordinate k of corner i at [k * corners_most_ + i]
    double *square_ = nullptr, *excess_ = nullptr, *slope_ = nullptr;  // by corners: see input_distance_high
    std::uint32_t corners_ = 0, corners_most_ = 0;
    std::uint32_t* degree_ = nullptr;    // [vertex] corners of its cell, 0 on the hull
    double out_radius_ = 0, doubt_ = 0;  // largest distance and error of a corner

    static constexpr std::uint32_t kept = 8;
    HalfSpace half_space_[kept];
    std::uint32_t half_spaces_ = 0;
    double least_ = 0;  // least distance of an input from the cell so far
};

Status CellTightener::open() {
    const std::uint32_t count = store_.state.vertex_count;
    degree_ = arena_.take_low<std::uint32_t>(count);
    if (degree_ == nullptr) return Status::out_of_memory;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = arena_.piece(v, count, 5); v < piece; ++v) {
            degree_[v] = 0;
        }
    for (CellId c(0); c < store_.state.cell_slots;)
        for (const std::uint64_t piece = arena_.piece(c, store_.state.cell_slots, 6 * dim); c < piece; ++c) {
            for (const VertexId v : store_.cell(c).vertex) ++degree_[v];
        }
    for (CellId c(0); c < store_.state.cell_slots;)
        for (const std::uint64_t piece = arena_.piece(c, store_.state.cell_slots, 6 * dim); c < piece; ++c) {
            for (int i = 0; i <= dim; ++i)
                for (int j = 0; j <= dim && store_.cell(c).neighbour[i] == none; ++j)
                    if (j != i) degree_[store_.cell(c).vertex[j]] = 0;
        }
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = arena_.piece(v, count, 5); v < piece; ++v) {
            if (store_.vertex(v).marker == Marker::steiner && degree_[v] > corners_most_) corners_most_ = degree_[v];
        }
    const std::size_t most = corners_most_;
    corner_ = arena_.take_low<double>(most * static_cast<std::size_t>(dim + 3));
    if (corner_ == nullptr) return Status::out_of_memory;
    square_ = corner_ + most * static_cast<std::size_t>(dim);
    excess_ = square_ + most;
    slope_ = excess_ + most;
    return Status::ok;
}

// The corners of v's cell. False: no room to visit the star.
bool CellTightener::gather(VertexId v, bool* known) {
    at_ = store_.point(v);
    corners_ = 0;
    out_radius_ = doubt_ = 0;
    const bool room = visit_any_star(store_, v, [&](CellId c) {
        const AnyCell cell = store_.cell(c);
        const double radius = square_root(cell.radius2), error = static_cast<double>(cell.error) * radius;
        if (!(error <= doubt_)) doubt_ = error;
        if (!(radius <= out_radius_)) out_radius_ = radius;
        for (int k = 0; k < dim; ++k)
            corner_[static_cast<std::size_t>(k) * corners_most_ + corners_] = cell.centre[k] - at_[k];
        ++corners_;
    });
    constexpr double origin[dimension_max] = {};
    corners().distances2(origin, square_);
    out_radius_ = (out_radius_ + doubt_) * up;
    *known = corners_ > 0 && is_finite(out_radius_);
    return room;
}

// Is no input within `reach` of q nearer to the cell than what is known?
bool CellTightener::is_beyond(const double* q, double reach) const {
    const double d = square_root(dot(dim, q, q));
    const double far = least_ + reach + sum_slack * (d + out_radius_ + reach);
    // Without a reach half of the distance will do: the cell is nearer to its vertex than to any input.
    if (d - out_radius_ >= far || (reach == 0 && 0.5 * d >= far)) return true;
    for (std::uint32_t i = 0; i < half_spaces_; ++i)
        if (half_space_[i].distance(q) >= far) return true;
    return false;
}

// Lowers least_ to what is known of this input, q from the vertex, where that is less.
void CellTightener::bound_input(const double* q) {
    if (is_beyond(q, 0)) return;
    arena_.pass(60 + 4 * corners_);
    HalfSpace best;
    const double d = square_root(dot(dim, q, q)), slack = sum_slack * (d + out_radius_);
    NearestInHull(dim).run(corners(), q, excess_, &best);
    double bound = least_distance(d, out_radius_, 1);
    const double b = best.distance(q) - slack;
    if (b > bound) bound = b;
    if (bound < least_) least_ = bound;
    // The first ones are about the nearest inputs; the last place is for what comes.
    if (b > 0) half_space_[half_spaces_ < kept ? half_spaces_++ : kept - 1] = best;
}

// At most the least distance of an input from v's cell; `least` is known already.
double CellTightener::input_distance_low(VertexId v, double least) {
    half_spaces_ = 0;
    least_ = 2 * cut_;
    double q[dimension_max];
    from_vertex(nearest_input(store_, v), q);
    bound_input(q);
    TreeRange stack[40];
    int depth = 0;
    stack[depth++] = tree_.root();
    while (depth > 0 && least_ > least) {
        const TreeRange range = stack[--depth];
        if (range.is_leaf()) {
            arena_.pass(range.end - range.begin);
            for (std::uint32_t i = range.begin; i < range.end; ++i) {
                from_vertex(tree_.item(i), q);
                bound_input(q);
            }
            continue;
        }
        arena_.pass(1);
        const std::uint32_t middle = range.middle();
        from_vertex(tree_.item(middle), q);
        if (is_beyond(q, tree_.reach(middle))) continue;
        bound_input(q);
        // The side of v last: it is searched first.
        const bool is_above = q[tree_.axis(middle)] > 0;
        stack[depth++] = is_above ? range.above() : range.below();
        stack[depth++] = is_above ? range.below() : range.above();
    }
    return (least_ - doubt_) * down;
}

// The largest |y|^2 - 2 y.mean + square over the corners, and excess_ of each.
double CellTightener::farthest_corner(const double* mean, double square, std::uint32_t* corner) {
    arena_.pass(corners_ / 8);
    corners().dots(mean, excess_);
    double worst = -infinity;
    for (std::uint32_t i = 0; i < corners_; ++i) {
        const double d2 = excess_[i] = square_[i] - 2 * excess_[i] + square;
        if (!(d2 > worst)) continue;
        worst = d2;
        *corner = i;
    }
    return worst;
}

// At least the largest distance of a point of v's cell to its nearest input. A mixture of inputs is known by the mean
// of its points and of their squares. Mixed with a share t of another input, the excess of a corner is excess_ + t
// slope_.
double CellTightener::input_distance_high(VertexId v) {
    constexpr int rounds = 8, shares = 7;
    static constexpr double share[shares] = {1, 0.7, 0.5, 0.35, 0.25, 0.15, 0.08};
    std::uint32_t near = nearest_input(store_, v);
    double mean[dimension_max];
    from_vertex(near, mean);
    double square = dot(dim, mean, mean), largest = square, reached2 = 0;
    std::uint32_t corner = 0;
    double worst = farthest_corner(mean, square, &corner);
    for (int round = 0; round < rounds; ++round) {
        double x[dimension_max], q[dimension_max], d2;
        for (int k = 0; k < dim; ++k) x[k] = corners().coordinate(corner, k) + at_[k];
        near = tree_.nearest(x, near, none, &d2);
        if (d2 > reached2) reached2 = d2;
        if (worst <= reached2 * (1 + 0x1p-6)) break;
        from_vertex(near, q);
        const double q2 = dot(dim, q, q);
        if (q2 > largest) largest = q2;
        for (int k = 0; k < dim; ++k) q[k] -= mean[k];
        arena_.pass(corners_ / 8);
        corners().dots(q, slope_);
        double most[shares];
        for (double& m : most) m = -infinity;
        for (std::uint32_t i = 0; i < corners_; ++i) {
            const double slope = q2 - square - 2 * slope_[i];
            for (int k = 0; k < shares; ++k) {
                const double d = excess_[i] + share[k] * slope;
                most[k] = d > most[k] ? d : most[k];
            }
        }
        double best = worst, step = 0;
        for (int k = 0; k < shares; ++k) {
            if (!(most[k] < best)) continue;
            best = most[k];
            step = share[k];
        }
        if (step == 0) break;
        for (int k = 0; k < dim; ++k) mean[k] += step * q[k];
        square += step * (q2 - square);
        worst = farthest_corner(mean, square, &corner);
    }
    return (square_root(worst + sum_slack * (largest + out_radius_ * out_radius_)) + doubt_) * up;
}

Status CellTightener::tighten(VertexId v, Interval* interval) {
    if (degree_[v] == 0) return Status::ok;
    bool known;
    if (!gather(v, &known)) return Status::out_of_memory;
    if (!known) return Status::ok;
    const double lo = input_distance_low(v, interval->lo), hi = input_distance_high(v);
    if (lo > interval->lo) interval->lo = lo < cut_ ? lo : cut_;
    if (hi < interval->hi) interval->hi = hi;
    return Status::ok;
}

}  // namespace

Status tighten_cell_bounds(const AnyMesh& mesh, const Work& work, Interval* interval) {
    const ArenaScope scope(work.arena);
    AnyInputTree tree;
    if (tree.build(mesh.store, work.arena, mesh.inputs, true) != Status::ok) return Status::out_of_memory;
    CellTightener tightener(mesh.store, tree, mesh.cut, work.arena);
    Status status = tightener.open();
    const std::uint32_t vertices = mesh.vertices();
    work.monitor.begin(NETMESH_STAGE_CERTIFY, vertices);
    for (VertexId v(mesh.inputs); v < vertices && status == Status::ok; ++v) {
        if (mesh.store.vertex(v).marker != Marker::steiner || !(interval[v].lo < mesh.cut) || !mesh.has(v)) continue;
        status = tightener.tighten(v, &interval[v]);
        if (status == Status::ok && work.monitor.advance(v, 200)) status = Status::cancelled;
    }
    return status;
}

}  // namespace netmesh
