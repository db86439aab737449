// How far a point is from the convex hull of others, from below.
#pragma once
#include <cstdint>

#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

// All of conv Y lies on w.y <= height, |w| = 1 but for rounding: a point q is at least w.q - height away from it.
struct HalfSpace {
    int dim;
    double w[dimension_most()], height;
    double distance(const double* q) const { return dot(dim, w, q) - height; }
};

// Points by their coordinates: number k of point i is at[k * stride + i].
struct PointColumns {
    const double* at;
    std::size_t stride;
    std::uint32_t count;
    int dim;

    double coordinate(std::uint32_t i, int k) const { return at[static_cast<std::size_t>(k) * stride + i]; }
    // out[i]: point i times x, and the square of point i less x, as dot and distance2 have them.
    void dots(const double* x, double* __restrict out) const {
        each(x, out, [](double y, double c) { return y * c; });
    }
    void distances2(const double* x, double* __restrict out) const {
        each(x, out, [](double y, double c) { return (y - c) * (y - c); });
    }

private:
    template <class Term> void each(const double* x, double* __restrict out, Term&& term) const {
        for (std::uint32_t i = 0; i < count; ++i) out[i] = term(at[i], x[0]);
        for (int k = 1; k < dim; ++k) {
            const double* const column = at + static_cast<std::size_t>(k) * stride;
            const double c = x[k];
            for (std::uint32_t i = 0; i < count; ++i) out[i] += term(column[i], c);
        }
    }
};

// The point of conv Y nearest to q by Wolfe's algorithm: at most dim + 1 of the points, affinely independent, carry it.
class NearestInHull {
public:
    explicit NearestInHull(int d) : dim(d) {}

    // y.count >= 1, scratch[y.count]. *best: the half-space that bounds the distance of q best of all met on the way;
    // w = 0 where q seems to be inside. O(count dim) a step, a few steps.
    [[gnu::noinline]] void run(const PointColumns& y, const double* q, double* scratch, HalfSpace* best) {
        start(y, q, scratch);
        *best = HalfSpace{};
        best->dim = dim;
        double bound = 0;
        for (int step = 0; step < 4 * dim; ++step) {
            const double length = square_root(dot(dim, x_, x_));
            if (!(length > 0)) return;
            std::uint32_t at = 0;
            double least = infinity;
            y.dots(x_, scratch);
            for (std::uint32_t i = 0; i < y.count; ++i) {
                if (scratch[i] < least) {
                    least = scratch[i];
                    at = i;
                }
            }
            const double distance = (least - dot(dim, q, x_)) / length;
            if (distance > bound) {
                bound = distance;
                for (int k = 0; k < dim; ++k) best->w[k] = -x_[k] / length;
                best->height = -least / length;
            }
            if (bound >= length * (1 - 0x1p-10) || members_ > dim) return;
            for (int k = 0; k < dim; ++k) member_[members_][k] = y.coordinate(at, k) - q[k];
            weight_[members_++] = 0;
            if (!descend()) return;
        }
    }

private:
    static constexpr int most = dimension_most();
    void start(const PointColumns& y, const double* q, double* scratch) {
        y.distances2(q, scratch);
        std::uint32_t nearest = 0;
        for (std::uint32_t i = 1; i < y.count; ++i)
            if (scratch[i] < scratch[nearest]) nearest = i;
        members_ = 1;
        weight_[0] = 1;
        for (int k = 0; k < dim; ++k) member_[0][k] = x_[k] = y.coordinate(nearest, k) - q[k];
    }
    // To the nearest point of the members' affine hull, leaving behind those that the way there passes. False: they are
    // not affinely independent.
    bool descend() {
        for (int round = 0; round <= dim; ++round) {
            double mu[most + 1];
            if (!affine_weights(mu)) return false;
            int leaves = -1;
            double part = 1;
            for (int i = 0; i < members_; ++i) {
                if (mu[i] > 0x1p-40) continue;
                const double t = weight_[i] / (weight_[i] - mu[i]);
                if (leaves >= 0 && !(t < part)) continue;
                leaves = i;
                part = t;
            }
            if (leaves < 0) {
                for (int i = 0; i < members_; ++i) weight_[i] = mu[i];
                break;
            }
            for (int i = 0; i < members_; ++i) weight_[i] += part * (mu[i] - weight_[i]);
            --members_;
            weight_[leaves] = weight_[members_];
            for (int k = 0; k < dim; ++k) member_[leaves][k] = member_[members_][k];
        }
        for (int k = 0; k < dim; ++k) {
            x_[k] = 0;
            for (int i = 0; i < members_; ++i) x_[k] += weight_[i] * member_[i][k];
        }
        return true;
    }
    // Weights of sum 1 that minimise |sum mu_i member_i|, by Gauss and Jordan with row pivots.
    bool affine_weights(double* mu) const {
        const int n = members_ + 1;
        double a[most + 2][most + 3];
        for (int i = 0; i < n; ++i)
            for (int j = 0; j <= n; ++j)
                a[i][j] = i < members_ && j < members_                  ? dot(dim, member_[i], member_[j])
                          : (i == members_) != (j == members_) && j < n ? 1
                          : i == members_ && j == n                     ? 1
                                                                        : 0;
        for (int c = 0; c < n; ++c) {
            int pivot = c;
            for (int r = c + 1; r < n; ++r)
                if (absolute(a[r][c]) > absolute(a[pivot][c])) pivot = r;
            if (!(absolute(a[pivot][c]) > 0)) return false;
            for (int j = 0; j <= n; ++j) {
                const double t = a[pivot][j];
                a[pivot][j] = a[c][j];
                a[c][j] = t;
            }
            for (int r = 0; r < n; ++r) {
                if (r == c) continue;
                const double factor = a[r][c] / a[c][c];
                for (int j = c; j <= n; ++j) a[r][j] -= factor * a[c][j];
            }
        }
        for (int i = 0; i < members_; ++i) mu[i] = a[i][n] / a[i][i];
        return true;
    }

    const int dim;
    double member_[most + 1][most];  // from q
    double weight_[most + 1];
    double x_[most];
    int members_;
};

}  // namespace netmesh
