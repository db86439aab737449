// Nearest input points, exactly: a k-d tree over the inputs, 5 bytes a point; 13 where rings are searched too.
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"
#include "numerics/vector.hpp"

namespace netmesh {

// A part of the tree: items begin..end-1. A longer one than a leaf is split by its middle item.
struct TreeRange {
    static constexpr std::uint32_t leaf = 8;
    std::uint32_t begin, end;

    bool is_leaf() const { return end - begin <= leaf; }
    std::uint32_t middle() const { return begin + (end - begin) / 2; }  // no two ranges have the same
    TreeRange below() const { return {begin, middle()}; }
    TreeRange above() const { return {middle() + 1, end}; }
};

// A part to be looked at, beyond planes across each axis at these distances from the point that is searched about.
// Squares are summed as those of distances are, so that no distance to a point of the part is computed to be less than
// least2.
template <int D> struct TreePart {
    TreeRange range;
    double least2, offset[D];

    TreePart beyond(int axis, double distance, TreeRange other) const {
        TreePart part = {other, 0, {}};
        for (int k = 0; k < D; ++k) {
            part.offset[k] = k == axis ? distance : offset[k];
            part.least2 += part.offset[k] * part.offset[k];
        }
        return part;
    }
};

// One of several nearest inputs.
struct Neighbour {
    double distance2;  // as computed
    std::uint32_t input;
    std::uint32_t unused;
};

// A tree, where the dimension is a number at run time. Items of a range below the middle have an axis(middle)
// coordinate at most that of the middle item, those above at least.
class AnyInputTree {
public:
    // What build places for each input, and with rings besides.
    static constexpr std::size_t input_bytes = sizeof(std::uint32_t) + sizeof(std::uint8_t);
    static constexpr std::size_t ring_bytes = sizeof(double);

    // Over vertices 0..count-1, or those listed in chosen[count], at the arena's low end; `rings`: to be asked for
    // farthest_in_ring too. O(n log n). out_of_memory.
    Status build(const AnyStore& store, Arena& arena, std::uint32_t count, bool rings = false,
                 const std::uint32_t* chosen = nullptr);

    // The input nearest to x that is not `except`, smallest index among equals, in terms of the squared distance as
    // computed. `start` is any input other than `except`, best one near x, or none. Expected O(log n).
    std::uint32_t nearest(const double* x, std::uint32_t start, std::uint32_t except, double* distance2) const;

    // The k inputs nearest to x, 1 <= k <= count, into neighbours[k] in ascending order of distance, then index:
    // unique, whatever the tree. Expected O(k log k + log n).
    void nearest_k(const double* x, std::uint32_t k, Neighbour* neighbours) const;

    // The input farthest from x among those whose distance is above `inner` and at most `outer`, with its squared
    // distance; `none` when there is none. Parts of the tree that cannot hold it are passed over at once.
    std::uint32_t farthest_in_ring(const double* x, double inner, double outer, double* distance2) const;

    // How often an input has been looked at by searches so far.
    std::uint64_t touches() const { return touches_; }

    TreeRange root() const { return {0, count_}; }
    std::uint32_t item(std::uint32_t i) const { return items_[i]; }
    int axis(std::uint32_t middle) const { return axis_[middle]; }
    // No item of a range is farther from its middle one; says something where rings are searched.
    double reach(std::uint32_t middle) const { return reach_ == nullptr ? infinity : reach_[middle]; }

protected:
    const double* point(std::uint32_t v) const {
        return reinterpret_cast<const double*>(first_point_ + static_cast<std::ptrdiff_t>(v) * stride_);
    }
    template <int D> double squared_distance(const double* x, std::uint32_t v) const {
        ++touches_;
        if constexpr (D == any_dimension)
            return netmesh::distance2(dim_, x, point(v));
        else
            return netmesh::distance2<D>(x, point(v));
    }
    // nearest and nearest_within, in dimension D or any_dimension.
    template <int D>
    std::uint32_t nearest_of(const double* x, std::uint32_t start, std::uint32_t except, double* distance2) const;
    template <int D> std::uint32_t within_of(const double* x, double bound2, double* distance2) const;
    // Calls consider(input), which returns the squared distance or 0, for every input that can be nearer than bound2()
    // or as near, near parts first. W: the dimension or more.
    template <int W, class Consider, class Bound>
    void visit(const double* x, Consider&& consider, Bound&& bound2) const;

    // Reports what a search has looked at since touches were *reported, where that is much, as it is where inputs are
    // crowded; less is its callers' to report.
    void report(std::uint64_t* reported) const {
        constexpr std::uint64_t many = 64;
        const std::uint64_t looked = touches_ - *reported;
        if (looked <= many) return;
        arena_->pass(static_cast<std::uint32_t>(looked / 8));
        *reported = touches_;
    }

    std::uint32_t* items_;
    std::uint8_t* axis_;  // of the split at the middle item of a range
    double* reach_;       // of a range about its middle item; null without rings
    std::uint32_t count_;
    int dim_;
    mutable std::uint64_t touches_;

private:
    void split(std::uint32_t begin, std::uint32_t end);
    double squared_distance(const double* x, std::uint32_t v) const {
        ++touches_;
        return netmesh::distance2(dim_, x, point(v));
    }

    const unsigned char* first_point_;
    std::ptrdiff_t stride_;
    const Arena* arena_;
};

// With the searches that refinement spends its time in.
template <int D> class InputTree : public AnyInputTree {
public:
    std::uint32_t nearest(const double* x, std::uint32_t start, std::uint32_t except, double* distance2) const;

    // The same among the inputs nearer to x than bound, of which there may be `none`. Where there is none, parts of
    // the tree that are farther away are passed over at once.
    std::uint32_t nearest_within(const double* x, double bound2, double* distance2) const;
};

}  // namespace netmesh
