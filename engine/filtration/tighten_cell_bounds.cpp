#include "filtration/tighten_cell_bounds.hpp"

#include "certificate/cells.hpp"
#include "delaunay/cell_list.hpp"
#include "filtration/nearest_in_hull.hpp"
#include "mesh/input_tree.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> class CellTightener {
public:
    CellTightener(Store<D>& store, std::uint32_t inputs, double cut, Arena& arena)
        : store_(store), inputs_(inputs), cut_(cut), arena_(arena) {}

    Status open();
    Status tighten(VertexId v, Interval* interval);

private:
    // A range of the tree and a box that holds it.
    struct Part {
        TreeRange range;
        double low[D], high[D];
    };
    bool gather(VertexId v, bool* known);
    double input_distance_low(VertexId v, double least);
    double input_distance_high(VertexId v);
    void from_vertex(std::uint32_t input, double* q) const {
        for (int k = 0; k < D; ++k) q[k] = store_.point(input)[k] - at_[k];
    }
    void bound_input(std::uint32_t input);
    double box_distance(const Part& part) const;
    double farthest_corner(const double* mean, double square, std::uint32_t* corner) const;

    Store<D>& store_;
    std::uint32_t inputs_;
    double cut_;
    Arena& arena_;
    InputTree<D> tree_;

    const double* at_ = nullptr;  // the vertex; lengths and points are relative to it
    double* corner_ = nullptr;    // [corners_][D]
    std::uint32_t corners_ = 0;
    std::uint32_t* degree_ = nullptr;    // [vertex] corners of its cell, 0 on the hull
    double out_radius_ = 0, doubt_ = 0;  // largest distance and error of a corner

    static constexpr std::uint32_t kept = 8;
    HalfSpace<D> half_space_[kept];
    std::uint32_t half_spaces_ = 0;
    double least_ = 0;  // least distance of an input from the cell so far
};

template <int D> Status CellTightener<D>::open() {
    const std::uint32_t count = store_.state.vertex_count;
    degree_ = arena_.take_low<std::uint32_t>(count);
    if (degree_ == nullptr || tree_.build(store_, arena_, inputs_) != Status::ok) return Status::out_of_memory;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = arena_.piece(v, count, 5); v < piece; ++v) {
            degree_[v] = 0;
        }
    for (CellId c(0); c < store_.state.cell_slots;)
        for (const std::uint64_t piece = arena_.piece(c, store_.state.cell_slots, 6 * D); c < piece; ++c) {
            for (const VertexId v : store_.cell(c).vertex) ++degree_[v];
        }
    for (CellId c(0); c < store_.state.cell_slots;)
        for (const std::uint64_t piece = arena_.piece(c, store_.state.cell_slots, 6 * D); c < piece; ++c) {
            for (int i = 0; i <= D; ++i)
                for (int j = 0; j <= D && store_.cell(c).neighbour[i] == none; ++j)
                    if (j != i) degree_[store_.cell(c).vertex[j]] = 0;
        }
    std::uint32_t most = 0;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = arena_.piece(v, count, 5); v < piece; ++v) {
            if (store_.vertex(v).marker == Marker::steiner && degree_[v] > most) most = degree_[v];
        }
    corner_ = arena_.take_low<double>(std::size_t{most} * D);
    return corner_ == nullptr ? Status::out_of_memory : Status::ok;
}

// The corners of v's cell. False: no room to visit the star.
template <int D> bool CellTightener<D>::gather(VertexId v, bool* known) {
    at_ = store_.point(v);
    corners_ = 0;
    out_radius_ = doubt_ = 0;
    const bool room = visit_star(store_, VertexId(v), [&](CellId c) {
        const Cell<D>& cell = store_.cell(c);
        const double radius = square_root(cell.radius2), error = static_cast<double>(cell.error) * radius;
        if (!(error <= doubt_)) doubt_ = error;
        if (!(radius <= out_radius_)) out_radius_ = radius;
        for (int k = 0; k < D; ++k)
            corner_[std::size_t{corners_} * D + static_cast<std::size_t>(k)] = cell.centre[k] - at_[k];
        ++corners_;
    });
    out_radius_ = (out_radius_ + doubt_) * up;
    *known = corners_ > 0 && is_finite(out_radius_);
    return room;
}

// Lowers least_ to what is known of this input, where that is less.
template <int D> void CellTightener<D>::bound_input(std::uint32_t input) {
    double q[D];
    from_vertex(input, q);
    const double d = square_root(dot<D>(q, q));
    double bound = least_distance(d, out_radius_, 1);
    const double slack = sum_slack * (d + out_radius_);
    for (std::uint32_t i = 0; i < half_spaces_ && bound < least_; ++i) {
        const double b = half_space_[i].distance(q) - slack;
        if (b > bound) bound = b;
    }
    if (!(bound < least_)) return;
    arena_.pass(60 + 4 * corners_);
    HalfSpace<D> best;
    NearestInHull<D>().run(corner_, corners_, q, &best);
    const double b = best.distance(q) - slack;
    if (b > bound) bound = b;
    if (bound < least_) least_ = bound;
    // The first ones are about the nearest inputs; the last place is for what comes.
    if (b > 0) half_space_[half_spaces_ < kept ? half_spaces_++ : kept - 1] = best;
}

// No input in the box is nearer to the cell than this.
template <int D> double CellTightener<D>::box_distance(const Part& part) const {
    double away2 = 0, size = out_radius_;
    for (int k = 0; k < D; ++k) {
        const double outside = part.low[k] > 0 ? part.low[k] : part.high[k] < 0 ? -part.high[k] : 0;
        away2 += outside * outside;
        const double far = -part.low[k] > part.high[k] ? -part.low[k] : part.high[k];
        if (is_finite(far)) size += far;
    }
    double best = square_root(away2) - out_radius_;
    for (std::uint32_t i = 0; i < half_spaces_; ++i) {
        double reach = -half_space_[i].height;
        for (int k = 0; k < D; ++k) {
            const double w = half_space_[i].w[k];
            if (w != 0) reach += w * (w > 0 ? part.low[k] : part.high[k]);
        }
        if (reach > best) best = reach;
    }
    return best - sum_slack * size;
}

// At most the least distance of an input from v's cell; `least` is known already.
template <int D> double CellTightener<D>::input_distance_low(VertexId v, double least) {
    half_spaces_ = 0;
    least_ = 2 * cut_;
    bound_input(nearest_input<D>(store_, v));
    Part stack[40];
    int depth = 0;
    stack[depth].range = tree_.root();
    for (int k = 0; k < D; ++k) {
        stack[depth].low[k] = -infinity;
        stack[depth].high[k] = infinity;
    }
    ++depth;
    while (depth > 0 && least_ > least) {
        const Part part = stack[--depth];
        if (!(box_distance(part) < least_)) continue;
        if (part.range.is_leaf()) {
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
template <int D>
double CellTightener<D>::farthest_corner(const double* mean, double square, std::uint32_t* corner) const {
    arena_.pass(corners_ / 8);
    double worst = -infinity;
    for (std::uint32_t i = 0; i < corners_; ++i) {
        const double* const y = corner_ + std::size_t{i} * D;
        const double d2 = dot<D>(y, y) - 2 * dot<D>(y, mean) + square;
        if (!(d2 > worst)) continue;
        worst = d2;
        *corner = i;
    }
    return worst;
}

// At least the largest distance of a point of v's cell to its nearest input. A mixture of inputs is known by the mean
// of its points and of their squares.
template <int D> double CellTightener<D>::input_distance_high(VertexId v) {
    constexpr int rounds = 8;
    constexpr double steps[] = {1, 0.7, 0.5, 0.35, 0.25, 0.15, 0.08};
    std::uint32_t near = nearest_input<D>(store_, v);
    double mean[D];
    from_vertex(near, mean);
    double square = dot<D>(mean, mean), largest = square, reached2 = 0;
    std::uint32_t corner = 0;
    double worst = farthest_corner(mean, square, &corner);
    for (int round = 0; round < rounds; ++round) {
        double x[D], q[D], d2;
        for (int k = 0; k < D; ++k) x[k] = corner_[std::size_t{corner} * D + static_cast<std::size_t>(k)] + at_[k];
        near = tree_.nearest(x, near, none, &d2);
        if (d2 > reached2) reached2 = d2;
        if (worst <= reached2 * (1 + 0x1p-6)) break;
        from_vertex(near, q);
        const double q2 = dot<D>(q, q);
        if (q2 > largest) largest = q2;
        double best = worst, best_step = 0;
        for (const double step : steps) {
            double trial[D];
            for (int k = 0; k < D; ++k) trial[k] = mean[k] + step * (q[k] - mean[k]);
            std::uint32_t at = 0;
            const double d = farthest_corner(trial, square + step * (q2 - square), &at);
            if (!(d < best)) continue;
            best = d;
            best_step = step;
            corner = at;
        }
        if (best_step == 0) break;
        for (int k = 0; k < D; ++k) mean[k] += best_step * (q[k] - mean[k]);
        square += best_step * (q2 - square);
        worst = best;
    }
    return (square_root(worst + sum_slack * (largest + out_radius_ * out_radius_)) + doubt_) * up;
}

template <int D> Status CellTightener<D>::tighten(VertexId v, Interval* interval) {
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

template <int D> Status tighten_cell_bounds(const FilteredMesh<D>& mesh, const Work& work, Interval* interval) {
    const ArenaScope scope(work.arena);
    const Store<D>& store = mesh.store;
    const double cut = mesh.cut();
    CellTightener<D> tightener(mesh.store, mesh.inputs, cut, work.arena);
    Status status = tightener.open();
    work.monitor.begin(NETMESH_STAGE_CERTIFY, mesh.vertices());
    for (VertexId v(mesh.inputs); v < mesh.vertices() && status == Status::ok; ++v) {
        if (store.vertex(v).marker != Marker::steiner || !(interval[v].lo < cut) || !mesh.has(v)) continue;
        status = tightener.tighten(v, &interval[v]);
        if (status == Status::ok && work.monitor.advance(v, 200)) status = Status::cancelled;
    }
    return status;
}

#define NETMESH_INSTANTIATE(D) template Status tighten_cell_bounds<D>(const FilteredMesh<D>&, const Work&, Interval*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
