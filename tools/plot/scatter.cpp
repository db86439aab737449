#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "tools/plot/barcode.hpp"

namespace netmesh::tool {

namespace {

struct Square {
    double panel_x, panel_y, side;
    const ValueScale& scale;
    double left() const { return panel_x + (scale.has_zero ? zero_column : 0); }
    double right() const { return left() + side; }
    double top() const { return panel_y + infinity_row; }
    double bottom() const { return top() + side; }
    double zero() const { return panel_x + zero_column / 2; }
    double x(double radius) const {
        if (radius == 0 && !scale.is_linear) return zero();
        return left() + scale.share(radius) * side;
    }
    double y(double radius) const {
        if (!std::isfinite(radius)) return panel_y + infinity_row / 2;
        return bottom() - scale.share(radius) * side;
    }
    // By the scale's own numbers, for lines.
    double x_of(double coordinate) const { return left() + (coordinate - scale.low) / (scale.high - scale.low) * side; }
    double y_of(double coordinate) const {
        return bottom() - (coordinate - scale.low) / (scale.high - scale.low) * side;
    }
};

void draw_axes(Svg& svg, const Square& square, const ValueScale& scale) {
    LabelRow labels;
    labels.take(square.y(HUGE_VAL) - 8, square.y(HUGE_VAL) + 4);
    for (const double tick : scale.ticks()) {
        const double y = square.y(tick);
        svg.line(square.panel_x, y, square.right(), y, rule, 1);
        svg.line(square.panel_x - 5, y, square.panel_x, y, ink, 1);
        if (labels.take(y - 8, y + 4)) svg.text(square.panel_x - 9, y + 4, scale.label(tick), 12, ink, Anchor::end);
    }
    const double least = scale.has_zero ? square.zero() + 10 : square.panel_x - 40;
    draw_value_axis(svg, square.panel_y, square.bottom(), least, square.right() + 36, scale,
                    [&](double tick) { return square.x(tick); });
    svg.line(square.panel_x, square.top(), square.right(), square.top(), "#b9bec4", 1);
    svg.text(square.panel_x - 9, square.y(HUGE_VAL) + 4, "\xE2\x88\x9E", 14, ink, Anchor::end);
    if (scale.has_zero) {
        svg.line(square.left(), square.panel_y, square.left(), square.bottom(), "#b9bec4", 1);
        svg.text(square.zero(), square.bottom() + 19, "0", 12, ink, Anchor::middle);
    }
    svg.text((square.left() + square.right()) / 2, square.bottom() + 40, "birth", 12, ink, Anchor::middle);
    svg.upright_text(square.panel_x - 9 - death_label_width(scale) - 12, (square.top() + square.bottom()) / 2, "death",
                     12, ink);
}

// Up to the death that is doubtful for each birth, where that is known by scale.
void draw_doubt(Svg& svg, const Square& square, const ValueScale& scale, const BarStyle& style) {
    std::vector<double> area = {square.x_of(scale.high), square.y_of(scale.high), square.x_of(scale.low),
                                square.y_of(scale.low)};
    std::vector<double> edges = {scale.low};
    for (const netmesh_scale_step& step : style.steps) {
        for (const double radius : {step.from, step.reach}) {
            const double at = scale.of(radius);
            if (at > scale.low && at < scale.high) edges.push_back(at);
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.push_back(scale.high);
    for (std::size_t i = 0; i + 1 < edges.size(); i++) {
        // Between two edges the doubtful death is one value or, where nothing is doubtful, the birth itself.
        // Where one ratio or error is all that is known it grows with the birth.
        const double middle = (edges[i] + edges[i + 1]) / 2;
        for (const double at : {edges[i], edges[i + 1]}) {
            const double near_end = at + 1e-6 * (middle - at), birth = scale.value_at(near_end);
            const double doubtful = style.doubtful(birth);
            const double top = doubtful > birth ? std::max(scale.of(doubtful), at) : at;
            area.insert(area.end(), {square.x_of(at), square.y_of(std::min(top, scale.high))});
        }
    }
    svg.polygon(area, doubt_fill);
    svg.begin_path();
    for (std::size_t i = 4; i < area.size(); i += 2) {
        i == 4 ? svg.move_to(area[i], area[i + 1]) : svg.draw_to(area[i], area[i + 1]);
    }
    svg.end_path(doubt_line, 1);
}

// Below the diagonal nothing can be; between it and death = c^2 birth, or birth + 2 e, nothing is certain.
void draw_regions(Svg& svg, const Square& square, const ValueScale& scale, const BarStyle& style) {
    const double below[] = {square.x_of(scale.low),  square.y_of(scale.low), square.x_of(scale.high),
                            square.y_of(scale.high), square.right(),         square.bottom()};
    svg.polygon(below, 3, "#eff1f3");
    if (style.has_curve()) {
        draw_doubt(svg, square, scale, style);
        return;
    }
    const double span = scale.high - scale.low;
    if (scale.is_linear && !style.is_additive()) {
        // death = c^2 birth, a line through 0.
        const double square_of_ratio = style.ratio * style.ratio, low = std::max(scale.low, 0.0);
        if (!(square_of_ratio > 1) || !std::isfinite(square_of_ratio) || scale.high <= 0) return;
        const double birth = scale.high / square_of_ratio;
        if (birth <= low) {
            svg.polygon({square.x_of(low), square.y_of(low), square.x_of(low), square.y_of(scale.high),
                         square.x_of(scale.high), square.y_of(scale.high)},
                        doubt_fill);
            return;
        }
        svg.polygon({square.x_of(low), square.y_of(low), square.x_of(low), square.y_of(low * square_of_ratio),
                     square.x_of(birth), square.y_of(scale.high), square.x_of(scale.high), square.y_of(scale.high)},
                    doubt_fill);
        svg.line(square.x_of(low), square.y_of(low * square_of_ratio), square.x_of(birth), square.y_of(scale.high),
                 doubt_line, 1, "4 3");
        return;
    }
    const double width = 2 * (style.is_additive() ? style.error : std::log(style.ratio));
    if (!(width > 0) || !std::isfinite(width)) return;
    const double reach = std::min(width, span);
    svg.polygon({square.x_of(scale.low), square.y_of(scale.low), square.x_of(scale.low), square.y_of(scale.low + reach),
                 square.x_of(scale.high - reach), square.y_of(scale.high), square.x_of(scale.high),
                 square.y_of(scale.high)},
                doubt_fill);
    if (width < span) {
        svg.line(square.x_of(scale.low), square.y_of(scale.low + width), square.x_of(scale.high - width),
                 square.y_of(scale.high), doubt_line, 1, "4 3");
    }
}

}  // namespace

double death_label_width(const ValueScale& scale) {
    double width = 14;
    for (const double tick : scale.ticks()) width = std::max(width, text_width(scale.label(tick), 12));
    return width;
}

void draw_scatter(Svg& svg, double x, double y, double side, const std::vector<Bar>& bars, const ValueScale& scale,
                  const BarStyle& style) {
    const Square square{x, y, side, scale};
    draw_regions(svg, square, scale, style);
    draw_axes(svg, square, scale);
    svg.line(square.x_of(scale.low), square.y_of(scale.low), square.x_of(scale.high), square.y_of(scale.high), ink, 1);
    svg.frame(x, y, square.right() - x, square.bottom() - y, ink);
    // Points that fall on one another within half a pixel are drawn once, which bounds the size of the picture.
    std::set<std::tuple<std::uint32_t, int, int>> drawn;
    for (const bool certain : {false, true}) {
        for (const Bar& bar : bars) {
            if (style.certain(bar) != certain) continue;
            const double at_x = square.x(bar.birth), at_y = square.y(bar.death);
            if (!drawn.emplace(bar.degree, static_cast<int>(2 * at_x), static_cast<int>(2 * at_y)).second) continue;
            // Long bars are larger dots, so that they are seen next to clouds of short ones.
            const double share = 10 * (bar.death - bar.birth) / (scale.high - scale.low);  // of a tenth of the width
            const double length = scale.is_linear ? std::min(share, 1.0)
                                  : bar.birth > 0 ? std::min(std::log(bar.death / bar.birth), 1.0)
                                                  : 1.0;
            svg.mark(degree_mark(bar.degree), at_x, at_y, 2 + 1.8 * length, degree_colour(bar.degree),
                     certain ? 0.9 : 0.4 + 0.3 * length);
        }
    }
}

}  // namespace netmesh::tool
