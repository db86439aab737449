#include "analysis/in_ball.hpp"

#include <cstddef>

#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// The active set of the search for an in-ball: normals (u, 1) of at most D+1 constraints, and the projection on them.
template <int D> struct ActiveSet {
    double row[D + 1][D + 1];
    std::uint32_t index[D + 1];
    int size = 0;

    // Splits (0, .., 0, 1) into multipliers of the rows and a rest orthogonal to them: the direction of steepest
    // growth.
    void project(double* multiplier, double* rest) const {
        double g[D + 1][D + 2];
        for (int i = 0; i < size; ++i) {
            for (int j = 0; j < size; ++j) {
                g[i][j] = 0;
                for (int k = 0; k <= D; ++k) g[i][j] += row[i][k] * row[j][k];
            }
            g[i][size] = row[i][D];
        }
        for (int k = 0; k < size; ++k) {
            int pivot = k;
            for (int i = k + 1; i < size; ++i)
                if (absolute(g[i][k]) > absolute(g[pivot][k])) pivot = i;
            for (int j = 0; j <= size; ++j) {
                const double t = g[k][j];
                g[k][j] = g[pivot][j];
                g[pivot][j] = t;
            }
            for (int i = 0; i < size; ++i) {
                if (i == k) continue;
                const double factor = g[i][k] / g[k][k];
                for (int j = k; j <= size; ++j) g[i][j] -= factor * g[k][j];
            }
        }
        for (int k = 0; k <= D; ++k) rest[k] = k == D ? 1 : 0;
        for (int i = 0; i < size; ++i) {
            multiplier[i] = g[i][size] / g[i][i];
            for (int k = 0; k <= D; ++k) rest[k] -= multiplier[i] * row[i][k];
        }
    }
    void remove(int i) {
        --size;
        for (int k = 0; k <= D; ++k) row[i][k] = row[size][k];
        index[i] = index[size];
    }
};

// u . x and half the distance |w| of a neighbour w.
template <int D> double along(const double* w, const double* x, double* half) {
    double length2 = 0, dot = 0;
    for (int k = 0; k < D; ++k) {
        length2 += w[k] * w[k];
        dot += w[k] * x[k];
    }
    const double length = square_root(length2);
    *half = 0.5 * length;
    return dot / length;
}

}  // namespace

template <int D> double largest_inscribed_ball(const double* w, std::uint32_t count, double scale, double* centre) {
    constexpr double flat = 0x1p-30;  // relative: of a direction, a multiplier, a slope
    double y[D + 1] = {};
    const auto slack = [&](std::uint32_t i) {
        double half;
        const double dot = along<D>(w + std::size_t{i} * D, y, &half);
        return half - dot - y[D];
    };
    ActiveSet<D> active;
    const auto add = [&](std::uint32_t i) {
        double half;
        const double* const p = w + std::size_t{i} * D;
        along<D>(p, y, &half);
        for (int k = 0; k < D; ++k) active.row[active.size][k] = p[k] / (2 * half);
        active.row[active.size][D] = 1;
        active.index[active.size++] = i;
    };
    std::uint32_t first = 0;
    double start = infinity;
    for (std::uint32_t i = 0; i < count; ++i) {
        double half;
        along<D>(w + std::size_t{i} * D, y, &half);
        if (!(half < start)) continue;
        start = half;
        first = i;
    }
    y[D] = start;
    add(first);
    for (int step = 0; step < 60 * (D + 1); ++step) {
        double multiplier[D + 1], rest[D + 1];
        active.project(multiplier, rest);
        if (!(rest[D] > flat) || active.size == D + 1) {  // rest[D] is the square of its length
            int worst = -1;
            for (int i = 0; i < active.size; ++i)
                if (multiplier[i] < -flat && (worst < 0 || active.index[i] < active.index[worst])) worst = i;
            if (worst < 0) break;
            active.remove(worst);
            continue;
        }
        double reach = infinity;
        std::uint32_t blocking = count;
        for (std::uint32_t i = 0; i < count; ++i) {
            double half;
            const double slope = along<D>(w + std::size_t{i} * D, rest, &half) + rest[D];
            if (!(slope > flat)) continue;
            const double room = slack(i), length = room > 0 ? room / slope : 0;
            if (!(length < reach)) continue;
            reach = length;
            blocking = i;
        }
        if (blocking == count || !(reach < 0x1p40 * scale)) break;
        for (int k = 0; k <= D; ++k) y[k] += reach * rest[k];
        add(blocking);
    }
    // Whatever the search did, this ball is inside.
    double radius = infinity;
    y[D] = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double room = slack(i);
        if (room < radius) radius = room;
    }
    for (int k = 0; k < D; ++k) centre[k] = y[k];
    return radius;
}

#define NETMESH_INSTANTIATE(D) template double largest_inscribed_ball<D>(const double*, std::uint32_t, double, double*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
