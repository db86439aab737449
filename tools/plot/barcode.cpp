#include "tools/plot/barcode.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

constexpr double zero_width = 44;   // of the column for births at 0, left of the scale
constexpr double arrow_width = 22;  // for heads of essential bars, right of the scale
constexpr double group_gap = 14;
constexpr double gap_stretch = 40;
constexpr double group_least = 76;  // so that the labels of a degree fit
constexpr double label_row = 14;    // of a bar with birth and death beside it
constexpr double row_most = 12, row_least = 3;
constexpr double curve_height = 34;
constexpr double ratio_most = 10;      // of c(r), where the diagram has no ratio
constexpr double least_ratio = 1.002;  // death / birth of a bar that is worth a row when there are too many
constexpr double least_share = 0.001;  // of the picture's width, where the scale is linear
constexpr std::size_t labels_most = 8;
constexpr std::size_t apart_most = 12;    // components that stand apart
constexpr double apart_least = 1.5;       // how large the gap is that they stand apart by, as a ratio
constexpr std::size_t rows_degree_0 = 8;  // so few bars need no choice

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
    const double least = scale.has_zero ? x.left() - 6 : panel.x - 60;
    draw_value_axis(svg, panel.y, bottom, least, panel.x + panel.width + 40, scale,
                    [&](double tick) { return x.at(tick); });
    svg.line(x.left(), bottom, panel.x + panel.width, bottom, ink, 1);
    if (scale.has_zero) {
        svg.line(x.zero(), panel.y, x.zero(), bottom, rule, 1);
        svg.line(panel.x, bottom, x.left() - 9, bottom, ink, 1);
        for (const double shift : {-9.0, -4.0}) {  // the axis is broken here
            svg.line(x.left() + shift - 2, bottom + 4, x.left() + shift + 2, bottom - 4, ink, 1);
        }
        svg.line(x.zero(), bottom, x.zero(), bottom + 5, ink, 1);
        svg.text(x.zero(), bottom + 19, "0", 12, ink, Anchor::middle);
    }
}

void draw_bar(Svg& svg, const Horizontal& x, const Bar& bar, double y, double thickness, bool certain) {
    const char* const colour = degree_colour(bar.degree);
    const double opacity = certain ? 1 : 0.45;
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

// What the rows of a group take, those without labels `row` high.
double rows_height(const BarGroup& group, double row) {
    const double labelled = static_cast<double>(group.labelled);
    return label_row * labelled + row * (static_cast<double>(group.shown.size()) - labelled);
}

double group_height(const BarGroup& group, double row) {
    return std::max(rows_height(group, row) + (group.rest.empty() ? 0 : curve_height + 4), group_least);
}

double all_groups_height(const std::vector<BarGroup>& groups, double row) {
    double total = -group_gap;
    for (const BarGroup& group : groups) total += group_height(group, row) + group_gap;
    return total;
}

// Rows as high as the panel bears.
double row_height(const std::vector<BarGroup>& groups, double height) {
    double row = row_most;
    while (row > row_least && all_groups_height(groups, row) > height - 6) row *= 0.98;
    return std::max(row, row_least);
}

void draw_labels(Svg& svg, const Panel& panel, double y, const BarGroup& group) {
    const double x = panel.x - degree_width;
    svg.text(x, y + 14, homology_label(group.degree), 18, degree_colour(group.degree), Anchor::start, true);
    const double symbol = x + text_width(homology_label(group.degree), 18, true) + 14;
    svg.mark(degree_mark(group.degree), symbol, y + 8, 4.5, degree_colour(group.degree));
    std::vector<std::string> lines = {group.total == 0 ? "no bar" : counted_text(group.total, "bar")};
    if (group.total > 0 && !group.is_exact) lines.push_back(grouped_text(group.certified) + " certified");
    if (group.apart > 0)
        lines.push_back(grouped_text(group.apart) + (group.apart == 1 ? " stands apart" : " stand apart"));
    if (!group.rest.empty()) lines.push_back(grouped_text(group.rest.size()) + " as a curve");
    for (std::size_t i = 0; i < lines.size(); i++) {
        const double base = y + 31 + 14 * static_cast<double>(i);
        svg.text(x, base, fitted_text(lines[i], 11, false, degree_width - 8), 11, faint_ink, Anchor::start);
    }
}

std::string ends_text(const Bar& bar) {
    const auto text = [](double value) {
        if (std::isinf(value)) return std::string("\xE2\x88\x9E");
        return value < 0 ? "\xE2\x88\x92" + rounded_text(-value, 4) : rounded_text(value, 4);
    };
    return text(bar.birth) + " to " + text(bar.death);
}

// How many of the bars there are at each value, as an area with steps.
void draw_curve(Svg& svg, const Horizontal& x, const BarGroup& group, double top) {
    std::vector<std::pair<double, int>> changes;  // where, and by how much
    for (const Bar& bar : group.rest) {
        changes.emplace_back(x.at(bar.birth), 1);
        changes.emplace_back(std::isfinite(bar.death) ? x.at(bar.death) : x.right(), -1);
    }
    std::sort(changes.begin(), changes.end());
    int count = 0, most = 1;
    for (std::size_t i = 0; i < changes.size(); i++) {
        count += changes[i].second;
        if (i + 1 == changes.size() || changes[i + 1].first > changes[i].first) most = std::max(most, count);
    }
    const std::string label = "up to " + grouped_text(static_cast<std::uint64_t>(most)) + " at once";
    const double bottom = top + curve_height, height = curve_height - 4;
    std::vector<double> area = {changes.front().first, bottom};
    count = 0;
    double drawn_at = -HUGE_VAL;
    for (std::size_t i = 0; i < changes.size(); i++) {
        const double before = bottom - height * count / most;
        count += changes[i].second;
        const bool ends = i + 1 == changes.size();
        // Steps closer than a third of a pixel are one.
        if (!ends && changes[i + 1].first - drawn_at < 0.35) continue;
        drawn_at = changes[i].first;
        area.insert(area.end(), {changes[i].first, area.size() == 2 ? bottom : before});
        area.insert(area.end(), {changes[i].first, bottom - height * count / most});
    }
    svg.polygon(area, degree_colour(group.degree), 0.3);
    svg.text(x.panel.x + x.panel.width + 8, bottom - curve_height / 2 + 4, label, 11, faint_ink, Anchor::start);
}

}  // namespace

BarStyle style_of(const std::vector<Bar>& bars, const netmesh_report& report, const Bounds& bounds) {
    BarStyle style{report.diagram.certified_ratio, report.diagram.certified_from};
    style.has_flags = !bounds.bars.empty();
    style.steps = bounds.steps;
    if (report.diagram.filter == NETMESH_FILTER_FUNCTION) style.error = report.diagram.certified_error;
    // Of equal bars all have to be certified, as they are drawn alike.
    for (std::size_t first = 0, last; first < bounds.bars.size(); first = last) {
        bool all = true;
        for (last = first; last < bounds.bars.size() && bars[last] == bars[first]; last++)
            all = all && bounds.bars[last].certain != 0;
        if (all) style.certified.push_back(bars[first]);
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
    if (has_flags) return std::binary_search(certified.begin(), certified.end(), bar, comes_before);
    if (is_additive()) return bar.death > bar.birth + 2 * error;
    if (ratio == 1 && from == 0) return true;
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

std::string counted_text(std::uint64_t count, const char* one) {
    return grouped_text(count) + " " + one + (count == 1 ? "" : "s");
}

std::string simplices_text(std::uint64_t count) {
    return count == 1 ? "1 simplex" : grouped_text(count) + " simplices";
}

namespace {

// How many of the longest components stand apart from the others: above the largest gap between deaths.
std::size_t components_apart(const std::vector<Bar>& longest_first, const ValueScale& scale) {
    if (longest_first.size() <= rows_degree_0) return longest_first.size();
    std::size_t essential = 0;
    while (essential < longest_first.size() && !std::isfinite(longest_first[essential].death)) essential++;
    std::size_t apart = essential;
    double largest = apart_least;
    for (std::size_t i = essential; i < std::min(apart_most, longest_first.size() - 1); i++) {
        const Bar &a = longest_first[i], &b = longest_first[i + 1];
        const double ratio = scale.is_linear ? persistence(a, scale) / persistence(b, scale) : a.death / b.death;
        if (!(ratio > largest)) continue;
        largest = ratio;
        apart = i + 1;
    }
    return apart;
}

// Of all bars of the group, which are in `shown` yet.
void find_apart(BarGroup* group) {
    std::vector<double> lengths;
    for (const Bar& bar : group->shown) lengths.push_back(length_of(bar));
    std::sort(lengths.begin(), lengths.end(), std::greater<double>());
    group->apart = count_apart(lengths);
    group->apart_length = group->apart > 0 ? lengths[group->apart - 1] : HUGE_VAL;
}

}  // namespace

std::vector<BarGroup> group_bars(const std::vector<Bar>& bars, std::uint32_t max_degree, std::size_t rows_max,
                                 const ValueScale& scale, const BarStyle& style) {
    const double least = scale.is_linear ? least_share * (scale.high - scale.low) : least_ratio;
    std::vector<BarGroup> groups(max_degree + 1);
    for (std::uint32_t degree = 0; degree <= max_degree; degree++) groups[degree].degree = degree;
    for (const Bar& bar : bars) {
        if (bar.degree <= max_degree) groups[bar.degree].shown.push_back(bar);
    }
    for (BarGroup& group : groups) {
        std::vector<Bar>& shown = group.shown;
        group.total = shown.size();
        group.is_exact = style.is_exact();
        find_apart(&group);
        std::stable_sort(shown.begin(), shown.end(), [&](const Bar& a, const Bar& b) {
            const double pa = persistence(a, scale), pb = persistence(b, scale);
            return pa != pb ? pa > pb : a.death > b.death;
        });
        std::size_t kept = group.degree == 0 ? components_apart(shown, scale) : std::min(shown.size(), rows_max);
        if (kept < shown.size()) {
            while (kept > 0 && persistence(shown[kept - 1], scale) < least) kept--;
        }
        group.rest.assign(shown.begin() + static_cast<std::ptrdiff_t>(kept), shown.end());
        shown.resize(kept);
        group.certified = static_cast<std::uint64_t>(
            std::count_if(group.rest.begin(), group.rest.end(), [&](const Bar& bar) { return style.certain(bar); }));
        const auto end_of_certified =
            std::stable_partition(shown.begin(), shown.end(), [&](const Bar& bar) { return style.certain(bar); });
        const std::size_t certified = static_cast<std::size_t>(end_of_certified - shown.begin());
        group.certified += certified;
        group.labelled = std::min(certified, groups.size() <= 4 ? labels_most : labels_most / 2);
    }
    return groups;
}

double label_width(const std::vector<BarGroup>& groups) {
    double width = 0;
    for (const BarGroup& group : groups) {
        for (std::size_t i = 0; i < group.labelled; i++)
            width = std::max(width, text_width(ends_text(group.shown[i]), 11, true));
        if (!group.rest.empty())
            width = std::max(width, text_width("up to " + grouped_text(group.rest.size()) + " at once", 11));
    }
    return width + 8;
}

double barcode_height(const std::vector<BarGroup>& groups) { return all_groups_height(groups, row_least) + 6; }

void draw_barcode(Svg& svg, const Panel& panel, const std::vector<BarGroup>& groups, const ValueScale& scale,
                  const BarStyle& style) {
    const Horizontal x{panel, scale};
    draw_axis(svg, panel, x, scale);
    const double row = row_height(groups, panel.height);
    // What no group needs stretches the gaps.
    const double left = panel.height - 6 - all_groups_height(groups, row);
    const double gap = group_gap + std::clamp(left / static_cast<double>(groups.size()), 0.0, gap_stretch);
    double y = panel.y;
    for (const BarGroup& group : groups) {
        const double height = group_height(group, row);
        if (group.degree > 0) {
            svg.line(panel.x - degree_width, y - gap / 2, panel.x + panel.width, y - gap / 2, rule, 1);
        }
        draw_labels(svg, panel, y, group);
        double at = y;
        for (std::size_t i = 0; i < group.shown.size(); i++) {
            const double own_row = i < group.labelled ? label_row : row;
            const Bar& bar = group.shown[i];
            draw_bar(svg, x, bar, at + own_row / 2, std::min(own_row * 0.65, 6.5), style.certain(bar));
            if (i < group.labelled) {
                const double right = panel.x + panel.width + 8;
                svg.text(right, at + own_row / 2 + 4, ends_text(bar), 11, ink, Anchor::start, group.is_apart(bar));
            }
            at += own_row;
        }
        if (!group.rest.empty()) draw_curve(svg, x, group, at + 2);
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
        const double share = !(most > least) ? 0 : additive ? bound / most : std::log(bound) / std::log(most);
        return bottom - std::min(share, 1.0) * panel.height;
    };
    std::vector<double> limits = {least};
    if (most > least) limits.push_back(most);
    for (const double bound : limits) {
        svg.line(x.left(), y(bound), x.right(), y(bound), rule, 1);
        svg.text(panel.x - 12, y(bound) + 4, rounded_text(bound, 3), 11, faint_ink, Anchor::end);
    }
    svg.text(panel.x - degree_width, (panel.y + bottom) / 2 + 4, additive ? "e(v)" : "c(r)", 14, ink, Anchor::start);
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
        // On the other scales c(r) is curved.
        for (int i = 1; i < 16 && !additive && scale.is_linear; i++) ends.push_back(first + (last - first) * i / 16);
        std::sort(ends.begin(), ends.end());
        for (const double end : ends) go(end, bound_at(step, end, additive));
    }
    svg.end_path(doubt_line, 1.5);
}

}  // namespace netmesh::tool
