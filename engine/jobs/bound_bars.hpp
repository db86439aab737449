// For each bar of a diagram where the true one surely is, and which bars are certified to exist.
#pragma once
#include "filtration/filters.hpp"
#include "jobs/bar_bounds.hpp"

namespace netmesh {

struct BoundBarsRequest {
    FilterRequest filter;  // as the diagram was made
    BarList bars;
    // Of a function of the caller's, which is asked anew: the filter's values and their additive bound.
    const double* value = nullptr;  // [vertices]
    double error = 0;
};

struct BoundedBars {
    BarBounds* bounds;  // [bars]
    ScaleCurve curve;
};

// Of a diagram on a mesh whose filter bounds_by_scale: from the bounds of every cell, with certified bars. The result
// is put at the arena's low end, bounds before the curve; without ok nothing stays. Scratch: about 110 bytes a vertex,
// 120 a bar, and what a diagram takes. out_of_memory, cancelled; where the function is not the one of the values,
// not_finite or invalid_argument.
Status bound_bars(const AnyMesh& mesh, const BoundBarsRequest& request, const Work& work, BoundedBars* out);

// Of any other diagram: from its certified ratio and error. out_of_memory.
Status bound_bars_by_ratio(const UniformBound& bound, const BarList& bars, const Work& work, BoundedBars* out);

}  // namespace netmesh
