// The two panels of a diagram's picture.
#pragma once
#include <cmath>
#include <vector>

#include "netmesh.h"
#include "tools/plot/axis.hpp"
#include "tools/plot/svg.hpp"

namespace netmesh::tool {

struct Panel {
    double x, y, width, height;  // of the plotting area, labels outside
};

struct BarStyle {
    double ratio;                                // certified ratio c
    double from;                                 // radius from which it holds
    std::vector<netmesh_scale_step> steps = {};  // the certificate by scale, when it is known
    bool has_flags = false;                      // then `real` tells which bars are
    std::vector<Bar> real = {};                  // sorted
    double error = -1;                           // of values as they are, in place of a ratio: the additive bound
    bool is_additive() const { return error >= 0; }
    // True when the exact diagram surely has a class for this bar.
    bool certain(const Bar& bar) const;
    // Death up to which a bar with this birth may be an artefact.
    double doubtful(double birth) const;
    // Do the steps come from the bounds of cells, not from one ratio?
    bool has_curve() const { return !steps.empty() && std::isfinite(steps.back().high); }
};

// The style that certified ratio and bounds, if there are any, give.
BarStyle style_of(const std::vector<Bar>& bars, const netmesh_report& report, const Bounds& bounds);

// Bars of one degree as the barcode shows them.
struct BarGroup {
    std::uint32_t degree;
    std::uint64_t total;
    std::vector<Bar> shown;  // sorted by birth, then death
};

// The groups for degrees 0..max_degree. Of more than `rows_max` bars the longest by the scale are taken, by death /
// birth or by their difference, and of these only the ones that would be seen.
std::vector<BarGroup> group_bars(const std::vector<Bar>& bars, std::uint32_t max_degree, std::size_t rows_max,
                                 const ValueScale& scale);

void draw_barcode(Svg& svg, const Panel& panel, const std::vector<BarGroup>& groups, const ValueScale& scale,
                  const BarStyle& style);
// The certified ratio by scale, c(r) upwards on a log scale from 1, or the additive bound e(v) from 0, above the
// barcode's axis.
void draw_ratio(Svg& svg, const Panel& panel, const ValueScale& scale, const BarStyle& style);
void draw_scatter(Svg& svg, const Panel& panel, const std::vector<Bar>& bars, const ValueScale& scale,
                  const BarStyle& style);

// "H" and the degree as a subscript.
std::string homology_label(std::uint32_t degree);

}  // namespace netmesh::tool
