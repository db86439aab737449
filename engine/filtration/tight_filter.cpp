#include "filtration/tight_filter.hpp"

#include "certificate/cells.hpp"

namespace netmesh {
namespace {

class Clumps {
public:
    explicit Clumps(const AnyMesh& mesh) : store_(mesh.store), rho_(mesh.cut), inputs_(mesh.inputs) {}

    Status open(const AnyInputTree& tree, Arena& arena);
    // What the mesh says about v: F on its cell, or on its clump's, is at most hi; lo stands for r_p there.
    Interval interval(VertexId v) const {
        const VertexId p = clump_[v];
        if (p != none) return cut_at(rho_, {inner_[p], outer_[p]});
        const double d = distance_to_inputs(store_, v);
        return cut_at(rho_, {cell_distance(d, v), store_.vertex(v).marker == Marker::exempt ? infinity : reach_[v]});
    }
    // s'(v), cut.
    double own_value(VertexId v) const {
        const VertexId n = nearest_input(store_, v);
        const double d = distance(store_.dim, store_.point(v), store_.point(n));
        const double s = d > half_[n] ? d : half_[n];
        return s < rho_ ? s : rho_;
    }

private:
    // Lower bound of the distance to v's cell from an input at distance d of v, not v itself.
    double cell_distance(double d, VertexId v) const {
        return store_.vertex(v).marker == Marker::exempt ? least_distance_unbounded(d)
                                                         : least_distance(d, out_radius_[v]);
    }
    void gather_clumps(const AnyInputTree& tree);
    void bound_by_outside();

    const AnyStore& store_;
    double rho_;
    std::uint32_t inputs_;
    double *out_radius_ = nullptr, *reach_ = nullptr;               // [vertex]
    VertexId* clump_ = nullptr;                                     // [vertex] its input, `none`: in no clump
    double *half_ = nullptr, *inner_ = nullptr, *outer_ = nullptr;  // [input] f_P / 2, r_p, hi(W)
};

Status Clumps::open(const AnyInputTree& tree, Arena& arena) {
    const std::uint32_t count = store_.state.vertex_count;
    out_radius_ = arena.take_high<double>(count);
    reach_ = arena.take_high<double>(count);
    clump_ = arena.take_high<VertexId>(count);
    half_ = arena.take_high<double>(inputs_);
    inner_ = arena.take_high<double>(inputs_);
    outer_ = arena.take_high<double>(inputs_);
    if (out_radius_ == nullptr || reach_ == nullptr || clump_ == nullptr || half_ == nullptr || inner_ == nullptr ||
        outer_ == nullptr)
        return Status::out_of_memory;
    measure_cells(store_, out_radius_, reach_);
    gather_clumps(tree);
    bound_by_outside();
    return Status::ok;
}

// The clumps, hi(W), and what r_p has from the other inputs' distances to W.
void Clumps::gather_clumps(const AnyInputTree& tree) {
    for (VertexId p(0); p < inputs_;)
        for (const std::uint64_t piece = store_.arena.piece(p, inputs_, 500 * store_.dim); p < piece; ++p) {
            double d2;
            tree.nearest(store_.point(p), none, p, &d2);
            half_[p] = 0.5 * square_root(d2);
            inner_[p] = infinity;
            outer_[p] = 0;
        }
    for (VertexId v(0); v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 500 * store_.dim); v < piece;
             ++v) {
            const VertexId n = nearest_input(store_, v);
            const bool joins = store_.vertex(v).marker != Marker::exempt &&
                               distance(store_.dim, store_.point(v), store_.point(n)) <= half_[n];
            clump_[v] = none;
            if (!joins) continue;
            clump_[v] = n;
            double d2;
            tree.nearest(store_.point(v), none, n, &d2);
            const double others = cell_distance(square_root(d2), v);
            if (others < inner_[n]) inner_[n] = others;
            if (!(reach_[v] <= outer_[n])) outer_[n] = reach_[v];
        }
}

// What r_p has from the cells outside W: the way from p to the nearest of them leaves W into a cell that is adjacent to
// W.
void Clumps::bound_by_outside() {
    for (CellId c(0); c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 60 * store_.dim); c < piece;
             ++c) {
            const AnyCell cell = store_.cell(c);
            for (const VertexId w : cell.vertex) {
                const VertexId p = clump_[w];
                if (p == none) continue;
                for (const VertexId u : cell.vertex) {
                    if (clump_[u] == p) continue;
                    const double away = cell_distance(distance(store_.dim, store_.point(p), store_.point(u)), u);
                    if (away < inner_[p]) inner_[p] = away;
                }
            }
        }
}

}  // namespace

Status tight_filter(const AnyMesh& mesh, FilterValues values, const Work& work, Evaluation* out) {
    const ArenaScope scope(work.arena);
    AnyInputTree tree;
    if (tree.build(mesh.store, work.arena, mesh.inputs) != Status::ok) return Status::out_of_memory;
    work.monitor.begin(NETMESH_STAGE_CERTIFY, mesh.store.state.cell_slots);
    Clumps clumps(mesh);
    const Status status = clumps.open(tree, work.arena);
    if (status != Status::ok) return status;
    for (VertexId v(0); v < mesh.vertices();)
        for (const std::uint64_t piece = mesh.store.arena.piece(v, mesh.vertices(), 40); v < piece; ++v) {
            out->value[v] = clumps.own_value(v);
        }
    out->certificate = clamp_values(
        mesh.vertices(), mesh.cut, values,
        [&](VertexId v) {
            work.arena.step(v, 60);
            return clumps.interval(v);
        },
        out->value, out->interval);
    return Status::ok;
}

}  // namespace netmesh
