#include "tools/plot/barcode.hpp"

#include <algorithm>
#include <cmath>

#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

constexpr double zero_width = 44;    // of the column for births at 0, left of the scale
constexpr double arrow_width = 22;   // for heads of essential bars, right of the scale
constexpr double label_width = 104;  // of degree and count, left of the panel
constexpr double group_gap = 12;
constexpr double gap_stretch = 48;
constexpr double group_least = 32;   // so that the labels of a degree fit
constexpr double group_share = 1.4;  // at most this many times an equal share of the panel goes to one degree
constexpr double row_most = 9;
constexpr double ratio_most = 10;      // of c(r), where the diagram has no ratio
constexpr double least_ratio = 1.002;  // death / birth of a bar that is worth a row when there are too many
constexpr double least_share = 0.001;  // of the picture's width, where the scale is linear

struct Horizontal {
    const Panel& panel;
    const ValueScale& scale;
    double left() const { return panel.x + (scale.has_zero ? zero_width : 0); }
    double right() const { return panel.x + panel.width - arrow_width; }
    double zero() const { return panel.x + 10; }
    double at(double radius) const {
        if (radius == 0 && !scale.is_linear) return zero();
        return left() + scale.share(radius) * (right() - left());
    }
};

double persistence(const Bar& bar, const ValueScale& scale) {
    if (!std::isfinite(bar.death)) return HUGE_VAL;
    if (scale.is_linear) return bar.death - bar.birth;
    return bar.birth == 0 ? 1e300 * (bar.death > 0) : bar.death / bar.birth;
}

void draw_axis(Svg& svg, const Panel& panel, const Horizontal& x, const ValueScale& scale) {
    const double bottom = panel.y + panel.height;
    for (const double tick : scale.ticks()) {
        const double at = x.at(scale.value_at(tick));
        svg.line(at, panel.y, at, bottom, rule, 1);
        if (scale.has_zero && at < x.left() + 6) continue;  // its label would touch that of 0
        svg.line(at, bottom, at, bottom + 5, ink, 1);
        svg.text(at, bottom + 19, scale.label(tick), 12, ink, Anchor::middle);
        if (!scale.is_linear) svg.text(at, bottom + 34, scale.second_label(tick), 11, faint_ink, Anchor::middle);
    }
    svg.line(x.left(), bottom, panel.x + panel.width, bottom, ink, 1);
    if (scale.has_zero) {
        svg.line(x.zero(), panel.y, x.zero(), bottom, rule, 1);
        svg.line(panel.x, bottom, x.left() - 9, bottom, ink, 1);
        for (const double shift : {-9.0, -4.0}) {  // the axis is broken here
            svg.line(x.left() + shift - 2, bottom + 4, x.left() + shift + 2, bottom - 4, ink, 1);
        }
        svg.line(x.zero(), bottom, x.zero(), bottom + 5, ink, 1);
        svg.text(x.zero(), bottom + 19, "\xE2\x88\x92\xE2\x88\x9E", 12, ink, Anchor::middle);
        svg.text(x.zero(), bottom + 34, "0", 11, faint_ink, Anchor::middle);
    }
    const double label = panel.x - 12;
    svg.text(label, bottom + 19, scale.is_linear ? "value v" : "ln r", 12, ink, Anchor::end);
    if (!scale.is_linear) svg.text(label, bottom + 34, "radius r", 11, faint_ink, Anchor::end);
}

void draw_bar(Svg& svg, const Horizontal& x, const Bar& bar, double y, double thickness, bool certain) {
    const char* const colour = degree_colour(bar.degree);
    const double opacity = certain ? 1 : 0.5;
    const bool essential = !std::isfinite(bar.death);
    const double start = x.at(bar.birth);
    const double end = essential ? x.right() + arrow_width - 8 : std::max(x.at(bar.death), start + 0.75);
    const double half = thickness / 2;
    const double box[] = {start, y - half, end, y - half, end, y + half, start, y + half};
    svg.polygon(box, 4, colour, opacity);
    if (!essential) return;
    const double wing = std::max(4.0, thickness);
    const double head[] = {end, y - wing, end + 9, y, end, y + wing};
    svg.polygon(head, 3, colour, opacity);
}

double group_height(const BarGroup& group, double row, double most) {
    return std::clamp(row * static_cast<double>(group.shown.size()), group_least, most);
}

// Rows as high as the panel bears; groups are never lower than their labels.
double row_height(const std::vector<BarGroup>& groups, double height, double most) {
    double row = row_most;
    for (; row > 0.5; row *= 0.98) {
        double total = -group_gap;
        for (const BarGroup& group : groups) {
            total += group_height(group, row, most) + group_gap;
        }
        if (total <= height - 6) break;
    }
    return row;
}

std::string count_label(const BarGroup& group) {
    if (group.total == 0) return "none";
    return grouped_text(group.total) + (group.total == 1 ? " bar" : " bars");
}

void draw_labels(Svg& svg, const Panel& panel, double y, const BarGroup& group) {
    svg.text(panel.x - label_width, y + 16, homology_label(group.degree), 18, degree_colour(group.degree),
             Anchor::start, true);
    svg.text(panel.x - 14, y + 13, count_label(group), 11, faint_ink, Anchor::end);
    if (group.shown.size() < group.total) {
        const std::string label = group.shown.empty() ? "all short" : "longest " + std::to_string(group.shown.size());
        svg.text(panel.x - 14, y + 27, label, 11, faint_ink, Anchor::end);
    }
}

}  // namespace

BarStyle style_of(const std::vector<Bar>& bars, const netmesh_report& report, const Bounds& bounds) {
    BarStyle style{report.diagram.certified_ratio, report.diagram.certified_from};
    style.has_flags = !bounds.bars.empty();
    style.steps = bounds.steps;
    if (report.diagram.filter == NETMESH_FILTER_FUNCTION) style.error = report.diagram.certified_error;
    // Of equal bars all have to be real, as they are drawn alike.
    for (std::size_t first = 0, last; first < bounds.bars.size(); first = last) {
        bool all = true;
        for (last = first; last < bounds.bars.size() && bars[last] == bars[first]; last++)
            all = all && bounds.bars[last].certain != 0;
        if (all) style.real.push_back(bars[first]);
    }
    return style;
}

double BarStyle::doubtful(double birth) const {
    const double by_one = is_additive() ? birth + 2 * error : ratio * ratio * birth;
    double reach = steps.empty() ? by_one : birth;
    for (const netmesh_scale_step& step : steps) {
        if (step.from <= birth) reach = std::isfinite(step.reach) ? step.reach : by_one;
    }
    return std::max(reach, birth);
}

bool BarStyle::certain(const Bar& bar) const {
    if (has_flags) return std::binary_search(real.begin(), real.end(), bar, comes_before);
    if (is_additive()) return bar.death > bar.birth + 2 * error;
    const double start = std::max(bar.birth, from);
    return bar.birth == 0 ? bar.death > from : bar.death > ratio * ratio * start;
}

std::string homology_label(std::uint32_t degree) {
    static constexpr const char* digits[] = {"\xE2\x82\x80", "\xE2\x82\x81", "\xE2\x82\x82", "\xE2\x82\x83",
                                             "\xE2\x82\x84", "\xE2\x82\x85", "\xE2\x82\x86", "\xE2\x82\x87",
                                             "\xE2\x82\x88", "\xE2\x82\x89"};
    std::string text = "H";
    for (const char digit : std::to_string(degree)) text += digits[digit - '0'];
    return text;
}

std::vector<BarGroup> group_bars(const std::vector<Bar>& bars, std::uint32_t max_degree, std::size_t rows_max,
                                 const ValueScale& scale) {
    const double least = scale.is_linear ? least_share * (scale.high - scale.low) : least_ratio;
    std::vector<BarGroup> groups(max_degree + 1);
    for (std::uint32_t degree = 0; degree <= max_degree; degree++) groups[degree].degree = degree;
    for (const Bar& bar : bars) {
        if (bar.degree <= max_degree) groups[bar.degree].shown.push_back(bar);
    }
    for (BarGroup& group : groups) {
        group.total = group.shown.size();
        if (group.total > rows_max) {
            std::stable_sort(group.shown.begin(), group.shown.end(), [&](const Bar& a, const Bar& b) {
                const double pa = persistence(a, scale), pb = persistence(b, scale);
                return pa != pb ? pa > pb : a.death > b.death;
            });
            group.shown.resize(rows_max);
            while (!group.shown.empty() && persistence(group.shown.back(), scale) < least) group.shown.pop_back();
        }
        std::stable_sort(group.shown.begin(), group.shown.end(), comes_before);
    }
    return groups;
}

void draw_barcode(Svg& svg, const Panel& panel, const std::vector<BarGroup>& groups, const ValueScale& scale,
                  const BarStyle& style) {
    const Horizontal x{panel, scale};
    draw_axis(svg, panel, x, scale);
    const double most = group_share * panel.height / static_cast<double>(groups.size());
    const double row = row_height(groups, panel.height, most);
    double left = panel.height;  // what no group needs stretches the gaps
    for (const BarGroup& group : groups) left -= group_height(group, row, most) + group_gap;
    const double gap = group_gap + std::clamp(left / static_cast<double>(groups.size()), 0.0, gap_stretch);
    double y = panel.y;
    for (const BarGroup& group : groups) {
        const double count = static_cast<double>(std::max<std::size_t>(group.shown.size(), 1));
        const double height = group_height(group, row, most);
        if (group.degree > 0) {
            svg.line(panel.x - label_width, y - gap / 2, panel.x + panel.width, y - gap / 2, rule, 1);
        }
        draw_labels(svg, panel, y, group);
        const double own_row = std::min(height / count, row_most);
        double at = y + (height - own_row * count) / 2 + own_row / 2;
        for (const Bar& bar : group.shown) {
            draw_bar(svg, x, bar, at, std::min(own_row * 0.7, 4.5), style.certain(bar));
            at += own_row;
        }
        y += height + gap;
    }
}

namespace {

// c(r) or e(v) in a step: what the step's bounds say at x, and where, between its ends, that is no line by the scale.
double bound_at(const netmesh_scale_step& step, double x, bool is_additive) {
    if (is_additive) return std::min(step.error, std::max({step.high - x, x - step.low, 0.0}));
    return std::min(step.ratio, std::max({step.high / x, x / step.low, 1.0}));
}
std::vector<double> bends_of(const netmesh_scale_step& step, bool is_additive) {
    if (is_additive)
        return {0.5 * step.low + 0.5 * step.high, step.low, step.high, step.high - step.error, step.low + step.error};
    return {std::sqrt(step.low) * std::sqrt(step.high), step.low, step.high, step.high / step.ratio,
            step.low * step.ratio};
}

}  // namespace

void draw_ratio(Svg& svg, const Panel& panel, const ValueScale& scale, const BarStyle& style) {
    const Horizontal x{panel, scale};
    const double bottom = panel.y + panel.height;
    const bool additive = style.is_additive();
    const double least = additive ? 0 : 1, most = additive                                        ? style.error
                                                  : std::isfinite(style.ratio) && style.ratio > 1 ? style.ratio
                                                                                                  : ratio_most;
    const auto y = [&](double bound) {
        const double share = additive ? bound / most : std::log(bound) / std::log(most);
        return bottom - std::min(share, 1.0) * panel.height;
    };
    for (const double bound : {least, most}) {
        svg.line(x.left(), y(bound), x.right(), y(bound), rule, 1);
        svg.text(panel.x - 12, y(bound) + 4, rounded_text(bound, 3), 11, faint_ink, Anchor::end);
    }
    svg.text(panel.x - label_width, (panel.y + bottom) / 2 + 4, additive ? "e(v)" : "c(r)", 14, ink, Anchor::start);
    const double low = scale.value_at(scale.low), high = scale.value_at(scale.high);
    svg.begin_path();
    bool begun = false;
    const auto go = [&](double at, double bound) {
        begun ? svg.draw_to(x.at(at), y(bound)) : svg.move_to(x.at(at), y(bound));
        begun = true;
    };
    if (style.steps[0].from > low) {
        go(low, least);
        go(std::min(style.steps[0].from, high), least);
    }
    for (std::size_t i = 0; i < style.steps.size(); i++) {
        const netmesh_scale_step& step = style.steps[i];
        const double first = std::max(step.from, low);
        const double last = std::min(i + 1 < style.steps.size() ? style.steps[i + 1].from : high, high);
        if (!(first < last)) continue;
        // Between these ln c(r) is a line in ln r, and e(v) in v.
        std::vector<double> ends = {first, last};
        for (const double end : bends_of(step, additive)) {
            if (end > first && end < last) ends.push_back(end);
        }
        std::sort(ends.begin(), ends.end());
        for (const double end : ends) go(end, bound_at(step, end, additive));
    }
    svg.end_path("#d9b95c", 1.5);
}

}  // namespace netmesh::tool
