// Where a filter's function is least and most on a convex cell, as far as a few places tell.
//
// Near a place its square is the squared distance to a source plus a constant. All in all it is |x|^2 plus the least of
// affine functions: least on a cell where the cell is nearest to a source, and most at a corner or between places with
// different sources, where both give the same value. The k-th nearest input's distance has its least there, too.
#pragma once
#include <functional>
#include <vector>

#include "tools/opinion/cell_values.hpp"

namespace netmesh::tool {

// What the function is at a place of a cell.
struct Known {
    Place x;
    Real f;
    Place source;
};
Known known_at(const FilteredFunction& function, Place x);

// Both add to the places that are known of a cell, few of them: each takes as long as a value of the function does.
// nearest_to: the place of the cell nearest to another, empty when there is none. The first to be tried is `first`.
void seek_least(const FilteredFunction& function, const Place& first,
                const std::function<Place(const Place&)>& nearest_to, std::vector<Known>* known);
void seek_most(const FilteredFunction& function, std::vector<Known>* known);

}  // namespace netmesh::tool
