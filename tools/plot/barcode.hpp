// The two panels of a diagram's picture.
#pragma once
#include <cmath>
#include <vector>

#include "netmesh.h"
#include "tools/plot/apart.hpp"
#include "tools/plot/axis.hpp"
#include "tools/plot/legend.hpp"
#include "tools/plot/svg.hpp"
#include "tools/plot/text_width.hpp"

namespace netmesh::tool {

struct Panel {
    double x, y, width, height;  // of the plotting area, labels outside
};

struct BarStyle {
    double ratio;                                // certified ratio c
    double from;                                 // radius from which it holds
    std::vector<netmesh_scale_step> steps = {};  // the certificate by scale, when it is known
    bool has_flags = false;                      // then `certified` tells which bars are
    std::vector<Bar> certified = {};             // sorted
    double error = -1;                           // of values as they are, in place of a ratio: the additive bound
    bool is_additive() const { return error >= 0; }
    bool is_exact() const { return ratio == 1 && from == 0 && !is_additive(); }
    // True when the exact diagram is certified to have a class for this bar, however short.
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
    std::uint64_t total, certified;  // all, and those that are certified to exist
    bool is_exact;                   // which all of an exact diagram do
    std::size_t apart;               // so many stand apart (apart.hpp): those at least
    double apart_length;             // so long
    std::vector<Bar> shown;          // certified ones first, the longest first
    std::size_t labelled = 0;        // this many of the first have birth and death beside them
    std::vector<Bar> rest = {};      // shown as a curve: how many there are at a radius

    bool is_apart(const Bar& bar) const { return apart > 0 && length_of(bar) >= apart_length; }
};

// The groups for degrees 0..max_degree. Of more than `rows_max` bars the longest by the scale are taken, by death /
// birth or by their difference, and of these only the ones that would be seen. Degree 0, where each point has a bar,
// shows components that stand apart: those above the largest gap between deaths, if it is large.
std::vector<BarGroup> group_bars(const std::vector<Bar>& bars, std::uint32_t max_degree, std::size_t rows_max,
                                 const ValueScale& scale, const BarStyle& style);

// Room that texts beside a barcode take, and its least height.
constexpr double degree_width = 116;  // left of it
double label_width(const std::vector<BarGroup>& groups);
double barcode_height(const std::vector<BarGroup>& groups);

void draw_barcode(Svg& svg, const Panel& panel, const std::vector<BarGroup>& groups, const ValueScale& scale,
                  const BarStyle& style);
// The certified ratio by scale, c(r) upwards on a log scale from 1, or the additive bound e(v) from 0, above the
// barcode's axis.
void draw_ratio(Svg& svg, const Panel& panel, const ValueScale& scale, const BarStyle& style);

// The diagram's square, and what lies around it: births at 0 in a column left of it, deaths at infinity in a row above.
constexpr double zero_column = 30, infinity_row = 30;
double death_label_width(const ValueScale& scale);
// Left and upper end of the panel; `side` is that of the square, a unit as long on both axes.
void draw_scatter(Svg& svg, double x, double y, double side, const std::vector<Bar>& bars, const ValueScale& scale,
                  const BarStyle& style);

// "H" and the degree as a subscript; "40 bars", "1 bar"; "40 simplices", "1 simplex".
std::string homology_label(std::uint32_t degree);
std::string counted_text(std::uint64_t count, const char* one);
std::string simplices_text(std::uint64_t count);

// Ticks with labels below a panel, as many as there is room for, between the ends `least` and `most`. `at` says where
// a value is.
template <class At>
void draw_value_axis(Svg& svg, double top, double bottom, double least, double most, const ValueScale& scale, At at) {
    LabelRow labels;
    for (const double tick : scale.ticks()) {
        const double x = at(tick), half = text_width(scale.label(tick), 12) / 2;
        svg.line(x, top, x, bottom, rule, 1);
        svg.line(x, bottom, x, bottom + 5, ink, 1);
        if (x - half < least || x + half > most || !labels.take(x - half, x + half)) continue;
        svg.text(x, bottom + 19, scale.label(tick), 12, ink, Anchor::middle);
    }
}

}  // namespace netmesh::tool
