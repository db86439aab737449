// The first points that span space.
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"

namespace netmesh {

// Affinely independent points, one after the other, exactly.
class IndependentPoints {
public:
    explicit IndependentPoints(const AnyStore& store) : store_(store) {}
    // Takes v if it is independent of those before it.
    void offer(VertexId v);
    bool are_enough() const { return count_ == store_.dim + 1; }
    const VertexId* ids() const { return ids_; }
    // The one taken last, of one at least.
    VertexId last() const { return ids_[count_ - 1]; }

private:
    const AnyStore& store_;
    int count_ = 0;
    VertexId ids_[dimension_max + 1];
    const double* p_[dimension_max + 1];
    int axes_[dimension_max] = {};
};

// The first dim+1 affinely independent points along order[0..count). False when there are none.
bool independent_points(const AnyStore& store, const std::uint32_t* order, std::uint32_t count, VertexId* ids);

}  // namespace netmesh
