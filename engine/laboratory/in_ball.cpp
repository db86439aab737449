#include "laboratory/in_ball.hpp"

#include <cstddef>

#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// The active set of the search for an in-ball: normals (u, 1) of at most dim+1 constraints, and the projection on them.
struct ActiveSet {
    explicit ActiveSet(int d) : dim(d) {}

    const int dim;
    double row[dimension_most() + 1][dimension_most() + 1];
    std::uint32_t index[dimension_most() + 1];
    int size = 0;

    // Splits (0, .., 0, 1) into multipliers of the rows and a rest orthogonal to them: the direction of steepest
    // growth.
    [[gnu::cold]] void project(double* multiplier, double* rest) const {
        double g[dimension_most() + 1][dimension_most() + 2];
        for (int i = 0; i < size; ++i) {
            for (int j = 0; j < size; ++j) {
                g[i][j] = 0;
                for (int k = 0; k <= dim; ++k) g[i][j] += row[i][k] * row[j][k];
            }
            g[i][size] = row[i][dim];
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
        for (int k = 0; k <= dim; ++k) rest[k] = k == dim ? 1 : 0;
        for (int i = 0; i < size; ++i) {
            multiplier[i] = g[i][size] / g[i][i];
            for (int k = 0; k <= dim; ++k) rest[k] -= multiplier[i] * row[i][k];
        }
    }
    void remove(int i) {
        --size;
        for (int k = 0; k <= dim; ++k) row[i][k] = row[size][k];
        index[i] = index[size];
    }
};

// u . x and half the distance |w| of a neighbour w.
[[gnu::cold]] double along(int dim, const double* w, const double* x, double* half) {
    double length2 = 0, dot = 0;
    for (int k = 0; k < dim; ++k) {
        length2 += w[k] * w[k];
        dot += w[k] * x[k];
    }
    const double length = square_root(length2);
    *half = 0.5 * length;
    return dot / length;
}

constexpr double flat = 0x1p-30;  // relative: of a direction, a multiplier, a slope

// The active-set search: a ball inside the cell that grows while its centre moves, touching more and more planes.
class BallSearch {
public:
    BallSearch(int d, const double* w, std::uint32_t count) : dim(d), w_(w), count_(count), active_(d) {}

    void start();
    void grow(double scale);
    // The largest ball about the present centre that is inside. Whatever the search did, this one is.
    double settle(double* centre);

private:
    const double* neighbour(std::uint32_t i) const { return w_ + std::size_t{i} * dim; }
    double slack(std::uint32_t i) const {
        double half;
        const double dot = along(dim, neighbour(i), y_, &half);
        return half - dot - y_[dim];
    }
    void touch(std::uint32_t i);
    int plane_to_leave(const double* multiplier) const;
    std::uint32_t first_plane_on_the_way(const double* direction, double* reach) const;

    const int dim;
    const double* const w_;
    const std::uint32_t count_;
    double y_[dimension_most() + 1] = {};  // centre and radius
    ActiveSet active_;
};

// The ball about the origin up to the nearest plane.
[[gnu::cold]] void BallSearch::start() {
    std::uint32_t first = 0;
    double radius = infinity;
    for (std::uint32_t i = 0; i < count_; ++i) {
        double half;
        along(dim, neighbour(i), y_, &half);
        if (!(half < radius)) continue;
        radius = half;
        first = i;
    }
    y_[dim] = radius;
    touch(first);
}

[[gnu::cold]] void BallSearch::touch(std::uint32_t i) {
    double half;
    const double* const p = neighbour(i);
    along(dim, p, y_, &half);
    for (int k = 0; k < dim; ++k) active_.row[active_.size][k] = p[k] / (2 * half);
    active_.row[active_.size][dim] = 1;
    active_.index[active_.size++] = i;
}

// A plane that keeps the ball from growing although it need not be touched, the first one by number; -1 when there is
// none: then the ball is the largest.
[[gnu::cold]] int BallSearch::plane_to_leave(const double* multiplier) const {
    int worst = -1;
    for (int i = 0; i < active_.size; ++i)
        if (multiplier[i] < -flat && (worst < 0 || active_.index[i] < active_.index[worst])) worst = i;
    return worst;
}

// The plane that the ball meets first when it changes in this direction, and how far that is; `count` if none.
[[gnu::cold]] std::uint32_t BallSearch::first_plane_on_the_way(const double* direction, double* reach) const {
    std::uint32_t blocking = count_;
    *reach = infinity;
    for (std::uint32_t i = 0; i < count_; ++i) {
        double half;
        const double slope = along(dim, neighbour(i), direction, &half) + direction[dim];
        if (!(slope > flat)) continue;
        const double room = slack(i), length = room > 0 ? room / slope : 0;
        if (!(length < *reach)) continue;
        *reach = length;
        blocking = i;
    }
    return blocking;
}

[[gnu::cold]] void BallSearch::grow(double scale) {
    for (int step = 0; step < 60 * (dim + 1); ++step) {
        double multiplier[dimension_most() + 1], rest[dimension_most() + 1];
        active_.project(multiplier, rest);
        if (!(rest[dim] > flat) || active_.size == dim + 1) {  // rest[dim] is the square of its length
            const int left = plane_to_leave(multiplier);
            if (left < 0) return;
            active_.remove(left);
            continue;
        }
        double reach;
        const std::uint32_t blocking = first_plane_on_the_way(rest, &reach);
        if (blocking == count_ || !(reach < 0x1p40 * scale)) return;
        for (int k = 0; k <= dim; ++k) y_[k] += reach * rest[k];
        touch(blocking);
    }
}

[[gnu::cold]] double BallSearch::settle(double* centre) {
    double radius = infinity;
    y_[dim] = 0;
    for (std::uint32_t i = 0; i < count_; ++i) {
        const double room = slack(i);
        if (room < radius) radius = room;
    }
    for (int k = 0; k < dim; ++k) centre[k] = y_[k];
    return radius;
}

}  // namespace

[[gnu::cold]] double largest_inscribed_ball(int dim, const double* w, std::uint32_t count, double scale,
                                            double* centre) {
    BallSearch search(dim, w, count);
    search.start();
    search.grow(scale);
    return search.settle(centre);
}

}  // namespace netmesh
