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
    // A range of the tree and a box that holds it.
    struct Part {
        TreeRange range;
        double low[dimension_max], high[dimension_max];
    };
    bool gather(VertexId v, bool* known);
    double input_distance_low(VertexId v, double least);
    double input_distance_high(VertexId v);
    void from_vertex(std::uint32_t input, double* q) const {
        for (int k = 0; k < dim; ++k) q[k] = store_.point(input)[k] - at_[k];
    }
    void bound_input(std::uint32_t input);
    double box_distance(const Part& part) const;
    double farthest_corner(const double* mean, double square, std::uint32_t* corner) const;

    const int dim;
    const AnyStore& store_;
    const AnyInputTree& tree_;
    double cut_;
    Arena& arena_;

    const double* at_ = nullptr;  // the vertex; lengths and points are relative to it
    double* corner_ = nullptr;    // [corners_][dim]
    std::uint32_t corners_ = 0;
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
    std::uint32_t most = 0;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = arena_.piece(v, count, 5); v < piece; ++v) {
            if (store_.vertex(v).marker == Marker::steiner && degree_[v] > most) most = degree_[v];
        }
    corner_ = arena_.take_low<double>(most * static_cast<std::size_t>(dim));
    return corner_ == nullptr ? Status::out_of_memory : Status::ok;
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
            corner_[corners_ * static_cast<std::size_t>(dim) + static_cast<std::size_t>(k)] = cell.centre[k] - at_[k];
        ++corners_;
    });
    out_radius_ = (out_radius_ + doubt_) * up;
    *known = corners_ > 0 && is_finite(out_radius_);
    return room;
}

// Lowers least_ to what is known of this input, where that is less.
void CellTightener::bound_input(std::uint32_t input) {
    double q[dimension_max];
    from_vertex(input, q);
    const double d = square_root(dot(dim, q, q));
    double bound = least_distance(d, out_radius_, 1);
    const double slack = sum_slack * (d + out_radius_);
    for (std::uint32_t i = 0; i < half_spaces_ && bound < least_; ++i) {
        const double b = half_space_[i].distance(q) - slack;
        if (b > bound) bound = b;
    }
    if (!(bound < least_)) return;
    arena_.pass(60 + 4 * corners_);
    HalfSpace best;
    NearestInHull(dim).run(corner_, corners_, q, &best);
    const double b = best.distance(q) - slack;
    if (b > bound) bound = b;
    if (bound < least_) least_ = bound;
    // The first ones are about the nearest inputs; the last place is for what comes.
    if (b > 0) half_space_[half_spaces_ < kept ? half_spaces_++ : kept - 1] = best;
}

// No input in the box is nearer to the cell than this.
double CellTightener::box_distance(const Part& part) const {
    double away2 = 0, size = out_radius_;
    for (int k = 0; k < dim; ++k) {
        const double outside = part.low[k] > 0 ? part.low[k] : part.high[k] < 0 ? -part.high[k] : 0;
        away2 += outside * outside;
        const double far = -part.low[k] > part.high[k] ? -part.low[k] : part.high[k];
        if (is_finite(far)) size += far;
    }
    double best = square_root(away2) - out_radius_;
    for (std::uint32_t i = 0; i < half_spaces_; ++i) {
        double reach = -half_space_[i].height;
        for (int k = 0; k < dim; ++k) {
            const double w = half_space_[i].w[k];
            if (w != 0) reach += w * (w > 0 ? part.low[k] : part.high[k]);
        }
        if (reach > best) best = reach;
    }
    return best - sum_slack * size;
}

// At most the least distance of an input from v's cell; `least` is known already.
double CellTightener::input_distance_low(VertexId v, double least) {
    half_spaces_ = 0;
    least_ = 2 * cut_;
    bound_input(nearest_input(store_, v));
    Part stack[40];
    int depth = 0;
    stack[depth].range = tree_.root();
    for (int k = 0; k < dim; ++k) {
        stack[depth].low[k] = -infinity;
        stack[depth].high[k] = infinity;
    }
    ++depth;
    while (depth > 0 && least_ > least) {
        const Part part = stack[--depth];
        arena_.pass(1);
        if (!(box_distance(part) < least_)) continue;
        if (part.range.is_leaf()) {
            arena_.pass(part.range.end - part.range.begin);
            for (std::uint32_t i = part.range.begin; i < part.range.end; ++i) bound_input(tree_.item(i));
            continue;
        }
        const std::uint32_t middle = part.range.middle();
        const int axis = tree_.axis(middle);
        const double split = store_.point(tree_.item(middle))[axis] - at_[axis];
        bound_input(tree_.item(middle));
        // The side of v last: it is searched first.
        const bool side = split > 0;
        for (int turn = 0; turn < 2; ++turn) {
            const bool below = side == (turn == 1);
            Part& half = stack[depth++];
            half = part;
            half.range = below ? part.range.below() : part.range.above();
            (below ? half.high : half.low)[axis] = split;
        }
    }
    return (least_ - doubt_) * down;
}

// The largest |y|^2 - 2 y.mean + square over the corners.
double CellTightener::farthest_corner(const double* mean, double square, std::uint32_t* corner) const {
    arena_.pass(corners_ / 8);
    double worst = -infinity;
    for (std::uint32_t i = 0; i < corners_; ++i) {
        const double* const y = corner_ + i * static_cast<std::size_t>(dim);
        const double d2 = dot(dim, y, y) - 2 * dot(dim, y, mean) + square;
        if (!(d2 > worst)) continue;
        worst = d2;
        *corner = i;
    }
    return worst;
}

// At least the largest distance of a point of v's cell to its nearest input. A mixture of inputs is known by the mean
// of its points and of their squares.
double CellTightener::input_distance_high(VertexId v) {
    constexpr int rounds = 8;
    static constexpr double steps[] = {1, 0.7, 0.5, 0.35, 0.25, 0.15, 0.08};
    std::uint32_t near = nearest_input(store_, v);
    double mean[dimension_max];
    from_vertex(near, mean);
    double square = dot(dim, mean, mean), largest = square, reached2 = 0;
    std::uint32_t corner = 0;
    double worst = farthest_corner(mean, square, &corner);
    for (int round = 0; round < rounds; ++round) {
        double x[dimension_max], q[dimension_max], d2;
        for (int k = 0; k < dim; ++k)
            x[k] = corner_[corner * static_cast<std::size_t>(dim) + static_cast<std::size_t>(k)] + at_[k];
        near = tree_.nearest(x, near, none, &d2);
        if (d2 > reached2) reached2 = d2;
        if (worst <= reached2 * (1 + 0x1p-6)) break;
        from_vertex(near, q);
        const double q2 = dot(dim, q, q);
        if (q2 > largest) largest = q2;
        double best = worst, best_step = 0;
        for (const double step : steps) {
            double trial[dimension_max];
            for (int k = 0; k < dim; ++k) trial[k] = mean[k] + step * (q[k] - mean[k]);
            std::uint32_t at = 0;
            const double d = farthest_corner(trial, square + step * (q2 - square), &at);
            if (!(d < best)) continue;
            best = d;
            best_step = step;
            corner = at;
        }
        if (best_step == 0) break;
        for (int k = 0; k < dim; ++k) mean[k] += best_step * (q[k] - mean[k]);
        square += best_step * (q2 - square);
        worst = best;
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
    if (tree.build(mesh.store, work.arena, mesh.inputs) != Status::ok) return Status::out_of_memory;
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
