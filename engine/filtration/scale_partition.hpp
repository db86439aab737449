// Recursively well-paced subsets (thesis 7.6.1, reconstructed): the input partitioned by scale, and the join of the
// diagrams.
//
// A cluster C_i with representative p_i and radius r_i = max over q in C_i of |p_i - q| (C_1 = P) chooses P_i: p_i, the
// point farthest from it, and then, as long as there is one, the point farthest from P_i among those that are
// theta-medial (distance to the nearest of P_i at least theta times that to the second nearest). What is left goes to
// its nearest point of P_i, and p_j with what it got is a cluster C_j of a smaller scale.
//
// For a cluster C_j within C_i let gap_j be the distance from p_j to the nearest other point of P_i and
// E_j = gap_j / (2 r_j); by the choice of P_i, E_j > (1 - theta) / (2 theta). Let all E_j >= 2, E the least of them.
//
// The balls B_j = ball(p_j, E_j r_j) are nested or disjoint. For x let B_i be the smallest that contains it (all of
// space for C_1) and n its nearest input. If n is not in P_i, then some p in P_i has |x - p| <= E / (E - 1) |x - n|: n
// lies in a cluster C_j whose ball does not contain x, so |n - p_j| <= r_j <= |x - p_j| / E; either p_j is in P_i, or n
// is not in C_i, and then p_i is as near to x as p_j, or nearer than n. So d_P and the distance to the P_i of the ball
// that x is in differ by that factor at most (7.6.1).
//
// At alpha < E_j r_j the offset of P_i meets B_j in ball(p_j, alpha) alone, one component, in whose place the offset of
// P_j is put; from r_j on that is star-shaped about p_j. Pieces that share one point which is there from alpha = 0 on:
// the diagram of the union is one essential class and the diagrams of the P_i's offsets without theirs.
//
// Hence the joined diagrams of the P_i, each within ln c_i of its offsets' diagram, are within ln(E / (E - 1)) + max ln
// c_i of that of P's offsets: at most ln(1 + 3 theta) + ln(1 + eps) <= 3 theta + eps for theta <= 1/9 with tight
// filters. No ball around the meshes enters: the certificates c_i are about offsets in all of space. What the thesis
// asks of its boundary balls of 2 r_i, E > 2 (1 + eps) and (1 - 2 theta) / theta > 2 (2 + eps), holds for theta <= 1/9,
// eps <= 1/2.
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// A point that is not chosen yet.
struct PointLeft {
    double near, second;         // distances to the two nearest chosen points
    std::uint32_t point, owner;  // owner: the nearest, as a position in chosen_; between calls the representative
};

// One cluster after the other, parents before children.
class ScalePartition {
public:
    static constexpr std::size_t point_bytes = sizeof(PointLeft) + sizeof(std::uint32_t);  // what open places for each

    // Of the store's vertices 0..count-1, distinct points that stay where they are; at the arena's low end.
    // 0 < theta <= 1/9. out_of_memory.
    Status open(const AnyStore& store, std::uint32_t count, double theta, Arena& arena);
    // The next cluster's P_i, representative first, in the order of choice. False: there is none. The clusters cost
    // O(sum |C_i| |P_i|). *stopped: the monitor wants to stop.
    bool next(Monitor& monitor, bool* stopped);
    const std::uint32_t* chosen() const { return chosen_; }
    std::uint32_t chosen_count() const { return chosen_count_; }

    std::uint32_t clusters() const { return clusters_; }
    // The least E_j of the clusters found so far; infinity for one.
    double separation() const { return separation_; }
    // r_j and gap_j of the cluster that `next` went through; 0 for the first one, which has neither.
    double radius() const { return radius_; }
    double gap() const { return gap_; }
    // Between two points of one P_i that are chosen: the least distance, infinity for none, and the largest of one to
    // those that were chosen before it.
    double closest() const { return closest_; }
    double widest() const { return widest_; }

private:
    double distance(std::uint32_t a, std::uint32_t b) const;
    std::uint32_t farthest(std::uint32_t begin, std::uint32_t end) const;
    void choose(std::uint32_t point, std::uint32_t begin, std::uint32_t end);
    void group(std::uint32_t begin, std::uint32_t end);

    const AnyStore* store_ = nullptr;
    std::uint32_t total_ = 0, done_ = 0;
    double theta_ = 0;
    PointLeft* left_ =
        nullptr;  // [total_] those before done_ have been chosen; then the clusters to come, one after the other
    std::uint32_t* chosen_ = nullptr;  // [total_ + 1]
    std::uint32_t chosen_count_ = 0, clusters_ = 0;
    double separation_ = 0, radius_ = 0, gap_ = 0, closest_ = 0, widest_ = 0;
};

}  // namespace netmesh
