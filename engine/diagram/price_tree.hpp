// Points of a diagram with a potential each, as an implicit k-d tree: the root of a stretch is its middle. A stretch is
// split where it is wider, and every node has the box of its stretch and the largest potential in it, so that a search
// for the least cost minus potential leaves out what is too far or too dear. Costs and potentials are whole numbers of
// size up to 2^62 (TransportCost), so that nothing is rounded here.
#pragma once
#include <cstdint>

#include "diagram/transport_cost.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct TransportPoint {
    double at[2];         // birth, death: finite
    std::uint32_t index;  // of its pair
};

// The least of cost minus potential over all partners and the diagonal, and the second least.
struct Offer {
    std::int64_t first, second;
    std::uint32_t at;  // none: the diagonal
};

class PriceTree {
public:
    struct Node {
        double low[2], high[2];  // the box of the stretch
        std::int64_t largest;    // potential in it
        std::int64_t potential;  // of the point
    };

    // Puts points[count] into the order of the tree. O(count log count).
    void build(TransportPoint* points, Node* nodes, std::uint32_t count, Monitor& monitor) {
        points_ = points;
        nodes_ = nodes;
        count_ = count;
        monitor_ = &monitor;
        Range stack[levels_max];
        int height = 0;
        for (Range now = {0, count};;) {
            if (now.end - now.begin > 1) {
                const std::uint32_t middle = middle_of(now);
                const int axis = wider_axis(now);
                std::uint64_t compared = 0;
                select(points + now.begin, now.end - now.begin, middle - now.begin,
                       [this, axis, &compared](const TransportPoint& a, const TransportPoint& b) {
                           if (++compared % 256 == 0) monitor_->pass(15);
                           const double x = a.at[axis], y = b.at[axis];
                           return x < y || (!(y < x) && a.index < b.index);
                       });
                stack[height++] = {middle + 1, now.end};
                now = {now.begin, middle};
                continue;
            }
            if (height == 0) break;
            now = stack[--height];
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            const double* const x = points[i].at;
            nodes[i] = {{x[0], x[1]}, {x[0], x[1]}, 0, 0};
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            monitor.pass(1);
            const double* const x = points[i].at;
            descend(i, [x](Node& node) {
                for (int k = 0; k < 2; ++k) {
                    if (x[k] < node.low[k]) node.low[k] = x[k];
                    if (x[k] > node.high[k]) node.high[k] = x[k];
                }
            });
        }
    }

    std::uint32_t count() const { return count_; }
    const TransportPoint& operator[](std::uint32_t i) const { return points_[i]; }
    std::int64_t potential(std::uint32_t i) const { return nodes_[i].potential; }

    // Sets all potentials to potential_of(i). O(count log count).
    template <class PotentialOf> void price_all(PotentialOf potential_of) {
        for (std::uint32_t i = 0; i < count_; ++i) nodes_[i].potential = nodes_[i].largest = potential_of(i);
        for (std::uint32_t i = 0; i < count_; ++i) {
            monitor_->pass(1);
            const std::int64_t potential = nodes_[i].potential;
            descend(i, [potential](Node& node) {
                if (potential > node.largest) node.largest = potential;
            });
        }
    }
    // Sets the potential of a point, of which searches learn by price_again. O(1), and O(count log count).
    void keep(std::uint32_t i, std::int64_t potential) { nodes_[i].potential = potential; }
    void price_again() {
        price_all([this](std::uint32_t i) { return nodes_[i].potential; });
    }
    // O(log count).
    void price(std::uint32_t i, std::int64_t potential) {
        Range path[levels_max];
        int depth = 0;
        Range now = {0, count_};
        for (; middle_of(now) != i; now = part_of(now, i)) path[depth++] = now;
        path[depth++] = now;
        nodes_[i].potential = potential;
        while (depth > 0) {
            const Range r = path[--depth];
            const std::uint32_t middle = middle_of(r);
            std::int64_t largest = nodes_[middle].potential;
            if (middle > r.begin) largest = larger(largest, nodes_[middle_of({r.begin, middle})].largest);
            if (middle + 1 < r.end) largest = larger(largest, nodes_[middle_of({middle + 1, r.end})].largest);
            if (nodes_[middle].largest == largest) return;
            nodes_[middle].largest = largest;
        }
    }

    // What `from` is offered when the diagonal costs `diagonal`.
    Offer best(const TransportPoint& from, std::int64_t diagonal, const TransportCost& cost) const {
        Later stack[levels_max];
        int height = 0;
        Offer offer = {diagonal, most, none};
        std::uint32_t looks = 0;
        if (count_ == 0) return offer;
        for (Range now = {0, count_};;) {
            const std::uint32_t middle = middle_of(now);
            ++looks;
            const std::int64_t value = cost.between(from.at, points_[middle].at) - nodes_[middle].potential;
            if (value < offer.first) {
                offer = {value, offer.first, middle};
            } else if (offer.at != none && value < offer.second) {
                offer.second = value;
            }
            const Later left = bound(from, {now.begin, middle}, cost);
            const Later right = bound(from, {middle + 1, now.end}, cost);
            const bool left_first = left.least <= right.least;
            const Later &near = left_first ? left : right, &far = left_first ? right : left;
            const std::int64_t bar = bar_of(offer);
            if (far.least < bar) stack[height++] = far;
            if (near.least < bar) {
                now = near.range;
                continue;
            }
            do {
                if (height == 0) {
                    monitor_->pass(1 + looks / 4);
                    return offer;
                }
                --height;
            } while (!(stack[height].least < bar_of(offer)));
            now = stack[height].range;
        }
    }

private:
    static constexpr int levels_max = 34;
    static constexpr std::int64_t most = INT64_MAX;
    struct Range {
        std::uint32_t begin, end;
    };
    struct Later {
        Range range;
        std::int64_t least;
    };
    static std::uint32_t middle_of(const Range& r) { return r.begin + (r.end - r.begin) / 2; }
    static Range part_of(const Range& r, std::uint32_t i) {
        const std::uint32_t middle = middle_of(r);
        return i < middle ? Range{r.begin, middle} : Range{middle + 1, r.end};
    }
    // Bars of degree 0 all have one birth.
    int wider_axis(const Range& r) const {
        double low[2] = {infinity, infinity}, high[2] = {-infinity, -infinity};
        for (std::uint32_t i = r.begin; i < r.end; ++i) {
            if (i % 256 == 0) monitor_->pass(10);
            for (int k = 0; k < 2; ++k) {
                const double x = points_[i].at[k];
                if (x < low[k]) low[k] = x;
                if (x > high[k]) high[k] = x;
            }
        }
        return high[1] - low[1] > high[0] - low[0] ? 1 : 0;
    }
    static std::int64_t larger(std::int64_t a, std::int64_t b) { return a > b ? a : b; }
    // Only less than this changes an offer.
    static std::int64_t bar_of(const Offer& offer) { return offer.at == none ? offer.first : offer.second; }

    // Calls visit(node) for the nodes from the root to point i.
    template <class Visit> void descend(std::uint32_t i, Visit visit) {
        for (Range now = {0, count_};; now = part_of(now, i)) {
            visit(nodes_[middle_of(now)]);
            if (middle_of(now) == i) return;
        }
    }
    // No point of the stretch offers less.
    Later bound(const TransportPoint& from, const Range& range, const TransportCost& cost) const {
        if (range.begin == range.end) return {range, most};
        const Node& node = nodes_[middle_of(range)];
        return {range, cost.to_box(from.at, node.low, node.high) - node.largest};
    }

    TransportPoint* points_ = nullptr;
    Node* nodes_ = nullptr;
    std::uint32_t count_ = 0;
    Monitor* monitor_ = nullptr;
};

}  // namespace netmesh
