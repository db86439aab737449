#include "periods/final_stars.hpp"

#include "periods/ball_reach.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> class StarsAtPoints {
public:
    StarsAtPoints(Store<D>& store, const PeriodicPoints& points, const double* margin, const Weights* weights,
                  const std::uint32_t* copy_of)
        : store_(store), points_(points), reach_(points, margin, weights, store.arena), copy_of_(copy_of) {}

    StarReach run(std::uint8_t* at_points) {
        store_.arena.each(store_.state.cell_slots, 30 * D, [this, at_points](std::uint64_t c) {
            Cell<D>& cell = store_.cell(static_cast<std::uint32_t>(c));
            const bool is_at_point = has_point(cell, -1);
            at_points[c] = is_at_point;
            if (is_at_point) look_at(cell);
        });
        return {!(wanted_ > 0) && !is_open_, is_open_ ? infinity : wanted_};
    }

private:
    bool is_point(VertexId v) const { return copy_of_[v] < points_.count; }
    bool has_point(const Cell<D>& cell, int without) const {
        for (int i = 0; i <= D; ++i)
            if (i != without && is_point(cell.vertex[i])) return true;
        return false;
    }
    void look_at(Cell<D>& cell) {
        if (D == 2) reach_.sharpen(store_, cell);
        double more = reach_.missing_of(cell);
        if (more > 0 && D > 2) {
            reach_.sharpen(store_, cell);
            more = reach_.missing_of(cell);
        }
        wanted_ = more > wanted_ ? more : wanted_;
        for (int i = 0; i <= D && !is_open_; ++i)
            if (cell.neighbour[i] == none && has_point(cell, i) && !is_parallel(cell, i)) is_open_ = true;
    }
    bool is_parallel(const Cell<D>& cell, int without) {
        double moved[D];
        const double* p[D + 1];
        for (int i = 0; i <= D; ++i) p[i] = i == without ? moved : store_.point(cell.vertex[i]);
        const double* const from = store_.point(cell.vertex[without == 0 ? 1 : 0]);
        for (int j = 0; j < points_.lattice.count; ++j) {
            for (int k = 0; k < D; ++k) moved[k] = from[k] + points_.lattice.b[j][k];
            if (orient<D>(p, store_.state.orient_counts) != Sign::zero) return false;
        }
        return true;
    }

    Store<D>& store_;
    const PeriodicPoints& points_;
    const BallReach<D> reach_;
    const std::uint32_t* const copy_of_;
    double wanted_ = 0;
    bool is_open_ = false;
};

}  // namespace

template <int D>
StarReach reach_of_stars(Store<D>& store, const PeriodicPoints& points, const double* margin, const Weights* weights,
                         const std::uint32_t* copy_of, std::uint8_t* at_points) {
    return StarsAtPoints<D>(store, points, margin, weights, copy_of).run(at_points);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template StarReach reach_of_stars<D>(Store<D>&, const PeriodicPoints&, const double*, const Weights*,              \
                                         const std::uint32_t*, std::uint8_t*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
