// How far a diagram that is joined of scales is from that of all points, by scale (filtration/scale_partition.hpp).
//
// Let F be the distance to all points and G(x) that to the points P_i of the smallest ball B_i around x. That partition
// has shown G <= F + r_j, where a cluster C_j, j > 1, holds the point nearest to x, x not within B_j, so that
// F >= |x - p_j| - r_j >= s_j = (E_j - 1) r_j. Hence with R(a) = max(0, r_j : s_j <= a)
//
//     F <= G <= F + R(F):    {G <= a} c {F <= a} c {G <= a + R(a)}.
//
// A cluster matters where distances are like its gap; at a times its radius it moves by the factor 1 + 1 / a alone,
// and below s_j not at all. E / (E - 1) is the largest of these factors.
//
// The module of {G <= a} is the direct sum of those of the P_i's offsets, of the first one whole, of the others
// without their essential class; on it the maps of inclusion are diagonal. So a diagram within (phi_i, psi_i) of the
// offsets of P_i (jobs/bar_bounds.hpp) is joined bar by bar. A bar (b, d) of scale i has
//
//     its true birth in [before(psi_i^-(b)), phi_i(b)],    its true death in [before(psi_i^-(d)), phi_i(d)],
//
// before(y) = inf {a : a + R(a) >= y}, and is certified to exist when d > psi_i(after(phi_i(b))), after(a) = a + R(a):
// then psi_i^-(d) > after(phi_i(b)), and the bar of P_i's offsets that it is matched to is too long to be left over by
// the matching with F's. Two matchings one after the other are one: bars that are certain belong to different true
// bars. The same for whatever else says that a bar of P_i's offsets is alive from x to y: the true one is if y >=
// after(x). Values that are higher than true ones come from the join alone, so nothing is added to phi_i.
#pragma once
#include <cstdint>

#include "memory/arena.hpp"
#include "numerics/real.hpp"

namespace netmesh {

class JoinShift {
public:
    // Adds a cluster, of which radius and gap are within 2^-41 of themselves: 16 bytes at the arena's high end, where
    // all clusters stand together. False: out of memory.
    bool add(double radius, double gap, Arena& arena);
    // Once there are all.
    void close();

    // The least s_j; infinity for no cluster.
    double first_scale() const { return count_ == 0 ? infinity : clusters_[0].from; }
    // Is R(x) = 0?
    bool is_exact_until(double x) const { return count_ == 0 || x < clusters_[0].from; }
    // At least a + R(a), a where that is exact. Infinity stays.
    double after(double a) const;
    // At most the least a with a + R(a) >= y.
    double before(double y) const;
    // The largest y / before(y) for y in [from, to], from > 0. `to` may be infinite.
    double factor(double from, double to) const;

private:
    struct Cluster {
        double from, radius;  // s_j, r_j
    };
    // How many begin at x or before.
    std::uint32_t until(double x) const;

    Cluster* clusters_ = nullptr;  // after close() ascending in both
    std::uint32_t count_ = 0;
};

}  // namespace netmesh
