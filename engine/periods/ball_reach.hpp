// How far balls of cells reach beyond the points, by direction of the lattice.
#pragma once
#include "delaunay/sphere.hpp"
#include "numerics/vector.hpp"
#include "periods/periodic_points.hpp"

namespace netmesh {

template <int D> class BallReach {
public:
    // weights: null where points have none.
    BallReach(const PeriodicPoints& points, const double* margin, const Weights* weights, const Arena& arena)
        : points_(points), margin_(margin), weights_(weights) {
        if (points_.lattice.count < D)
            measure_sides(arena);
        else
            place_box();
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
    // The margin that the cell wants where there is not enough, or 0. Of a ball that goes beyond the points on a
    // side its part within them counts: a cap or a slice, at a distance d, of half the width sqrt(r^2 - d^2).
    double missing_of(const Cell<D>& cell) const {
        const double radius2 = reach2_of(cell);
        if (!(radius2 < infinity)) return infinity;
        if (is_in_box(cell, radius2)) return 0;
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
            if (wanted > margin_[j] && wanted > most) most = wanted;
        }
        return most;
    }

private:
    // Most balls are in a box along the axes that is within the margin, and the least of all is asked to see it.
    bool is_in_box(const Cell<D>& cell, double radius2) const {
        bool is_in = true;
        for (int k = 0; k < D; ++k) {
            const double above = cell.centre[k] - box_low_[k], below = box_high_[k] - cell.centre[k];
            const double least = above < below ? above : below;
            is_in &= least > 0 && least * least > radius2;
        }
        return is_in;
    }
    // Directions are orthonormal, as there are D. Around the middle of the points, with sides as long as they allow:
    // the whole box of points where they are along the axes.
    void place_box() {
        double half[D], size[D] = {}, middle[D] = {}, part = 1;
        for (int j = 0; j < D; ++j) {
            half[j] = 0.5 * (points_.high[j] - points_.low[j]) + margin_[j];
            for (int k = 0; k < D; ++k) {
                size[k] += absolute(points_.lattice.e[j][k]) * half[j];
                middle[k] += points_.lattice.e[j][k] * 0.5 * (points_.high[j] + points_.low[j]);
            }
        }
        for (int j = 0; j < D; ++j) {
            double along = 0;
            for (int k = 0; k < D; ++k) along += absolute(points_.lattice.e[j][k]) * size[k];
            if (half[j] < part * along) part = half[j] / along;
        }
        for (int k = 0; k < D; ++k) {
            const double less = part * size[k] - 0x1p-30 * (size[k] + absolute(middle[k]));
            box_low_[k] = middle[k] - less;
            box_high_[k] = middle[k] + less;
        }
    }
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
    const double* const margin_;
    const Weights* const weights_;
    double box_low_[D] = {}, box_high_[D] = {};  // empty where there is none
    double side_[D][D], low_[D], high_[D];
    int sides_ = 0;
};

}  // namespace netmesh
