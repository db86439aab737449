// Whether bars can be those of a true diagram that is known.
#pragma once
#include <string>
#include <vector>

#include "tools/io/diagram_file.hpp"

namespace netmesh::tool {

// Where the true birth and death of a bar are said to be.
struct BarBox {
    std::uint32_t degree;
    double birth_low, birth_high, death_low, death_high;  // death_low infinite: it never dies

    bool holds(const Bar& bar) const;
};

// Can each box be given a true bar of its own within it? Otherwise *at is one that is left over. Augmenting paths.
bool can_place(const std::vector<BarBox>& boxes, const std::vector<Bar>& truth, std::size_t* at);

// Where a bar is within the factor `ratio` of what is said.
BarBox box_of(const Bar& bar, double ratio);

}  // namespace netmesh::tool
