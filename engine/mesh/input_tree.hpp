// Nearest input point, exactly: a k-d tree over the inputs, 5 bytes a point; 13 where rings are searched too.
#pragma once
#include <cstdint>

#include "delaunay/store.hpp"

namespace netmesh {

template <int D> class InputTree {
public:
    // Over vertices 0..count-1, at the arena's low end; `rings`: to be asked for in_ring too. O(n log n). out_of_memory.
    Status build(const Store<D>& store, Arena& arena, std::uint32_t count, bool rings = false);

    // The input nearest to x that is not `except`, smallest index among equals, in terms of the squared distance as
    // computed. `start` is any input other than `except`, best one near x. Expected O(log n).
    std::uint32_t nearest(const double* x, std::uint32_t start, std::uint32_t except, double* distance2) const;

    // The input farthest from x among those whose distance is above `inner` and at most `outer`, with its squared distance;
    // `none` when there is none. Parts of the tree that cannot hold it are passed over at once.
    std::uint32_t farthest_in_ring(const double* x, double inner, double outer, double* distance2) const;

    // How often an input has been looked at by searches so far.
    std::uint64_t touches() const { return touches_; }

private:
    static constexpr std::uint32_t leaf = 8;
    void split(std::uint32_t begin, std::uint32_t end);

    const Store<D>* store_;
    std::uint32_t* items_;
    std::uint8_t* axis_;   // of the split at the middle item of a range
    double* reach_;        // of a range about its middle item; null without rings
    std::uint32_t count_;
    mutable std::uint64_t touches_;
};

}  // namespace netmesh
