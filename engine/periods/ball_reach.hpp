// How far balls of cells reach beyond the points, by direction of the lattice.
#pragma once
#include "delaunay/sphere.hpp"
#include "numerics/vector.hpp"
#include "periods/periodic_points.hpp"

namespace netmesh {

template <int D> class BallReach {
public:
    // weights: null where points have none.
    BallReach(const PeriodicPoints& points, const Weights* weights, const Arena& arena)
        : points_(points), weights_(weights) {
        if (points_.lattice.count < D) measure_sides(arena);
    }

    // The ball of a cell anew, with an error that is as small as doubles allow.
    void sharpen(const Store<D>& store, Cell<D>& cell) const {
        constexpr double sharp_error = 0x1p-42;
        weights_ != nullptr ? solve_cell<D>(store, *weights_, sharp_error, cell)
                            : solve_cell<D>(store, sharp_error, cell);
    }
    // What a point in conflict with a ball, its error E counted, is away from its centre at most, squared: r^2 (1 + 4
    // E) (1 + 4 E) (pieces/others.hpp). Infinity where the ball is not known.
    static double reach2_of(const Cell<D>& cell) {
        const double error = static_cast<double>(cell.error) + 0x1p-40;
        return error < 0.125 ? cell.radius2 * (1 + 4 * error) * (1 + 4 * error) : infinity;
    }
    // The margin that the cell wants where `margin` is not enough, or 0. Of a ball that goes beyond the points on a
    // side its part within them counts: a cap or a slice, at a distance d, of half the width sqrt(r^2 - d^2).
    double missing_of(const Cell<D>& cell, const double* margin) const {
        const double radius2 = reach2_of(cell);
        if (!(radius2 < infinity)) return infinity;
        double apart2 = 0;
        for (int s = 0; s < sides_; ++s) {
            const double y = dot<D>(side_[s], cell.centre), slack = 0x1p-40 * absolute(y);
            const double d = y > high_[s] ? y - high_[s] - slack : y < low_[s] ? low_[s] - y - slack : 0;
            const double less = d - square_root(cell.radius2) * (static_cast<double>(cell.error) + 0x1p-40);
            if (less > 0 && less * less > apart2) apart2 = less * less;
        }
        const double width2 = radius2 - apart2, width = width2 > 0 ? square_root(width2) : 0;
        double most = 0;
        for (int j = 0; j < points_.lattice.count; ++j) {
            const double y = dot<D>(points_.lattice.e[j], cell.centre);
            const double below = points_.low[j] - (y - width), above = y + width - points_.high[j];
            const double wanted = (below > above ? below : above) + 0x1p-30 * (width + absolute(y));
            if (wanted > margin[j] && wanted > most) most = wanted;
        }
        return most;
    }

private:
    // The box of all points in the directions of the axes that are left when those of the lattice are taken out of
    // them: more than D - count directions, which are not orthogonal, but a distance in one of them is no more than
    // that in space.
    void measure_sides(const Arena& arena) {
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
            arena.each(points_.count, 4 * D, [&](std::uint64_t v) {
                const double y = dot<D>(kept, points_.x + v * (D + 1));
                low = y < low ? y : low;
                high = y > high ? y : high;
            });
            low_[sides_] = low;
            high_[sides_++] = high;
        }
    }

    const PeriodicPoints& points_;
    const Weights* const weights_;
    double side_[D][D], low_[D], high_[D];
    int sides_ = 0;
};

}  // namespace netmesh
