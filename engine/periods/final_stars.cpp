#include "periods/final_stars.hpp"

#include "delaunay/sphere.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

constexpr double sharp_error = 0x1p-42;

template <int D> class StarsAtPoints {
public:
    StarsAtPoints(Store<D>& store, const PeriodicPoints& points, const double* margin, const Weights* weights)
        : store_(store), points_(points), margin_(margin), weights_(weights) {}

    StarReach run() {
        if (points_.lattice.count < D) measure_sides();
        store_.arena.each(store_.state.cell_slots, 30 * D, [this](std::uint64_t c) {
            Cell<D>& cell = store_.cell(static_cast<std::uint32_t>(c));
            if (has_point(cell, -1)) look_at(cell);
        });
        return {!(wanted_ > 0) && !is_open_, is_open_ ? infinity : wanted_};
    }

private:
    bool is_point(VertexId v) const { return store_.vertex(v).origin < points_.count; }
    bool has_point(const Cell<D>& cell, int without) const {
        for (int i = 0; i <= D; ++i)
            if (i != without && is_point(cell.vertex[i])) return true;
        return false;
    }
    // The box of all points in the directions of the axes that are left when those of the lattice are taken out of
    // them: more than D - count directions, which are not orthogonal, but a distance in one of them is no more than
    // that in space.
    void measure_sides() {
        for (int k = 0; k < D; ++k) {
            double* const side = side_[k];
            for (int i = 0; i < D; ++i) side[i] = i == k;
            for (int j = 0; j < points_.lattice.count; ++j) {
                const double along = points_.lattice.e[j][k];
                for (int i = 0; i < D; ++i) side[i] -= along * points_.lattice.e[j][i];
            }
            const double length = square_root(dot<D>(side, side));
            if (!(length > 0x1p-20)) continue;
            double* const kept = side_[sides_];
            for (int i = 0; i < D; ++i) kept[i] = side[i] / length;
            double low = infinity, high = -infinity;
            store_.arena.each(points_.count, 4 * D, [&](std::uint64_t v) {
                const double y = dot<D>(kept, points_.x + v * (D + 1));
                low = y < low ? y : low;
                high = y > high ? y : high;
            });
            low_[sides_] = low;
            high_[sides_++] = high;
        }
    }
    void look_at(Cell<D>& cell) {
        if (D == 2) sharpen(cell);
        double more = missing_of(cell);
        if (more > 0 && D > 2) {
            sharpen(cell);
            more = missing_of(cell);
        }
        wanted_ = more > wanted_ ? more : wanted_;
        for (int i = 0; i <= D && !is_open_; ++i)
            if (cell.neighbour[i] == none && has_point(cell, i) && !is_parallel(cell, i)) is_open_ = true;
    }
    void sharpen(Cell<D>& cell) {
        weights_ != nullptr ? solve_cell<D>(store_, *weights_, sharp_error, cell)
                            : solve_cell<D>(store_, sharp_error, cell);
    }
    // The margin that the cell wants where it has not enough, or 0. A point in conflict with a ball, its error E
    // counted, is within r sqrt((1 + 4 E) (1 + 4 E)) of its centre (pieces/others.hpp). Of a ball that goes beyond the
    // points on a side its part within them counts: a cap or a slice, at a distance d, of half the width sqrt(r^2 -
    // d^2).
    double missing_of(const Cell<D>& cell) const {
        const double error = static_cast<double>(cell.error) + 0x1p-40;
        if (!(error < 0.125)) return infinity;
        const double radius2 = cell.radius2 * (1 + 4 * error) * (1 + 4 * error);
        double apart2 = 0;
        for (int s = 0; s < sides_; ++s) {
            const double y = dot<D>(side_[s], cell.centre), slack = 0x1p-40 * absolute(y);
            const double d = y > high_[s] ? y - high_[s] - slack : y < low_[s] ? low_[s] - y - slack : 0;
            const double less = d - square_root(cell.radius2) * error;
            if (less > 0 && less * less > apart2) apart2 = less * less;
        }
        const double width2 = radius2 - apart2, width = width2 > 0 ? square_root(width2) : 0;
        double most = 0;
        for (int j = 0; j < points_.lattice.count; ++j) {
            const double y = dot<D>(points_.lattice.e[j], cell.centre);
            const double below = points_.low[j] - (y - width), above = y + width - points_.high[j];
            const double wanted = (below > above ? below : above) + 0x1p-30 * (width + absolute(y));
            if (wanted > margin_[j] && wanted > most) most = wanted;
        }
        return most;
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
    const double* const margin_;
    const Weights* const weights_;
    double side_[D][D], low_[D], high_[D];
    int sides_ = 0;
    double wanted_ = 0;
    bool is_open_ = false;
};

}  // namespace

template <int D>
StarReach reach_of_stars(Store<D>& store, const PeriodicPoints& points, const double* margin, const Weights* weights) {
    return StarsAtPoints<D>(store, points, margin, weights).run();
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template StarReach reach_of_stars<D>(Store<D>&, const PeriodicPoints&, const double*, const Weights*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
