// The scale that barcode and diagram share: natural logarithms of radii, or values of any sign as they are.
#pragma once
#include <string>
#include <vector>

#include "tools/io/diagram_file.hpp"

namespace netmesh::tool {

// Radii r with low <= ln r <= high, or values from low to high; ticks at multiples of `step`.
struct ValueScale {
    double low = -1, high = 1, step = 1;
    bool has_zero = false;   // some bar is born at 0, which logarithms cannot show
    bool is_linear = false;  // of values as they are

    // Where a value is between low and high, not below low; and the value that is there.
    double of(double value) const;
    double value_at(double coordinate) const;
    // Share of the way from low to high, 0 for r = 0.
    double share(double value) const { return (of(value) - low) / (high - low); }
    std::vector<double> ticks() const;
    // Of a tick: two lines, the second empty for values as they are.
    std::string label(double tick) const;
    std::string second_label(double tick) const;
};

// The scale that shows `bars` with a little room at both ends.
ValueScale scale_for(const std::vector<Bar>& bars, bool is_linear = false);

// The radius e^logarithm with as many digits as a label bears: 0.135, 2.72, 54.6, 1.1e-5.
std::string radius_label(double logarithm);
// The logarithm itself, with a real minus sign.
std::string logarithm_label(double logarithm);

}  // namespace netmesh::tool
