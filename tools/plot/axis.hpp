// The scale that barcode and diagram share: logarithms of radii, or values of any sign as they are.
#pragma once
#include <string>
#include <vector>

#include "tools/io/diagram_file.hpp"

namespace netmesh::tool {

enum class Axis { natural, log, linear };  // natural: logarithms of radii, other values as they are

// Radii r with low <= ln r <= high, or values from low to high.
struct ValueScale {
    double low = -1, high = 1;
    bool has_zero = false;   // some bar is born at 0, which logarithms cannot show
    bool is_linear = false;  // values as they are

    // Where a value is between low and high, not below low; and the value that is there. Values as they are stand at
    // 8e307 at most, on either side of 0.
    double of(double value) const;
    double value_at(double coordinate) const;
    // Share of the way from low to high, 0 for r = 0.
    double share(double value) const { return (of(value) - low) / (high - low); }
    // Round values from low to high, in their order.
    std::vector<double> ticks() const;
    // Of a tick: with as many digits as tell it from the next.
    std::string label(double tick) const;
};

// The scale that shows `bars` with a little room at both ends.
ValueScale scale_for(const std::vector<Bar>& bars, bool is_linear = false);

// Is a linear scale right: it was asked for, or is natural for values that are not radii; or some value is negative?
bool is_linear_axis(Axis axis, bool are_radii, const std::vector<Bar>& bars);

}  // namespace netmesh::tool
