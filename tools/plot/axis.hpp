// The natural-log scale of radii that barcode and diagram share.
#pragma once
#include <string>
#include <vector>

#include "tools/io/diagram_file.hpp"

namespace netmesh::tool {

// Radii r with low <= ln r <= high; ticks at multiples of `step`.
struct LogScale {
    double low = -1, high = 1, step = 1;
    bool has_zero = false;  // some bar is born at 0, which the scale cannot show

    // Share of the way from low to high, 0 for r = 0.
    double share(double radius) const;
    std::vector<double> ticks() const;
};

// The scale that shows `bars` with a little room at both ends.
LogScale scale_for(const std::vector<Bar>& bars);

// The radius e^logarithm with as many digits as a label bears: 0.135, 2.72, 54.6, 1.1e-5.
std::string radius_label(double logarithm);
// The logarithm itself, with a real minus sign.
std::string logarithm_label(double logarithm);

}  // namespace netmesh::tool
