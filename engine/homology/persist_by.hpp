// The frame of every reduction of an explicit filtration.
#pragma once
#include "homology/persistence.hpp"
#include "memory/work.hpp"

namespace netmesh {

// Reduction: constructed from the arguments, run(), then finish() gives the pairs at the arena's low end. What the
// reduction took besides is given back.
template <class Reduction>
Status persist_by(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, const Work& work, PairList* out) {
    if (complex.dimension > FilteredComplex::dimension_max) return Status::invalid_argument;
    if (max_degree > complex.dimension) max_degree = complex.dimension;
    ArenaScope scope(work.arena);
    Reduction reduction(complex, max_degree, keep_zero, work);
    const Status status = reduction.run();
    if (status != Status::ok) return status;
    *out = reduction.finish();
    scope.keep_low_from_now();
    return Status::ok;
}

}  // namespace netmesh
