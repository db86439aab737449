#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "tools/plot/barcode.hpp"

namespace netmesh::tool {

namespace {

constexpr double zero_width = 30;       // births at 0
constexpr double infinity_height = 30;  // deaths at infinity

struct Square {
    const Panel& panel;
    const ValueScale& scale;
    double left() const { return panel.x + (scale.has_zero ? zero_width : 0); }
    double right() const { return panel.x + panel.width; }
    double top() const { return panel.y + infinity_height; }
    double bottom() const { return panel.y + panel.height; }
    double zero() const { return panel.x + zero_width / 2; }
    double x(double radius) const {
        if (radius == 0 && !scale.is_linear) return zero();
        return left() + scale.share(radius) * (right() - left());
    }
    double y(double radius) const {
        if (!std::isfinite(radius)) return panel.y + infinity_height / 2;
        return bottom() - scale.share(radius) * (bottom() - top());
    }
    // By the scale's own numbers, for lines.
    double x_of(double logarithm) const {
        return left() + (logarithm - scale.low) / (scale.high - scale.low) * (right() - left());
    }
    double y_of(double logarithm) const {
        return bottom() - (logarithm - scale.low) / (scale.high - scale.low) * (bottom() - top());
    }
};

void draw_axes(Svg& svg, const Square& square, const ValueScale& scale) {
    for (const double tick : scale.ticks()) {
        const double x = square.x_of(tick), y = square.y_of(tick);
        svg.line(x, square.panel.y, x, square.bottom(), rule, 1);
        svg.line(square.panel.x, y, square.right(), y, rule, 1);
        svg.line(square.panel.x - 5, y, square.panel.x, y, ink, 1);
        svg.text(square.panel.x - 9, y + 4, scale.label(tick), 12, ink, Anchor::end);
        if (scale.has_zero && x < square.left() + 16) continue;  // its label would touch that of 0
        svg.line(x, square.bottom(), x, square.bottom() + 5, ink, 1);
        svg.text(x, square.bottom() + 19, scale.label(tick), 12, ink, Anchor::middle);
        if (!scale.is_linear)
            svg.text(x, square.bottom() + 34, scale.second_label(tick), 11, faint_ink, Anchor::middle);
    }
    svg.line(square.panel.x, square.top(), square.right(), square.top(), "#b9bec4", 1);
    svg.text(square.panel.x - 9, square.y(HUGE_VAL) + 4, "\xE2\x88\x9E", 14, ink, Anchor::end);
    if (scale.has_zero) {
        svg.line(square.left(), square.panel.y, square.left(), square.bottom(), "#b9bec4", 1);
        svg.text(square.zero(), square.bottom() + 19, "\xE2\x88\x92\xE2\x88\x9E", 12, ink, Anchor::middle);
        svg.text(square.zero(), square.bottom() + 34, "0", 11, faint_ink, Anchor::middle);
    }
    const double middle = (square.left() + square.right()) / 2;
    svg.text(middle, square.bottom() + 53, "birth", 12, ink, Anchor::middle);
    svg.upright_text(square.panel.x - 38, (square.top() + square.bottom()) / 2, "death", 12, ink);
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
        const double middle = scale.value_at((edges[i] + edges[i + 1]) / 2), doubtful = style.doubtful(middle);
        for (const double at : {edges[i], edges[i + 1]}) {
            const double x = square.x_of(at), top = doubtful > middle ? scale.of(doubtful) : at;
            area.insert(area.end(), {x, square.y_of(std::min(top, scale.high))});
        }
    }
    svg.polygon(area.data(), static_cast<int>(area.size() / 2), "#fbf3dc");
    svg.begin_path();
    for (std::size_t i = 4; i < area.size(); i += 2) {
        i == 4 ? svg.move_to(area[i], area[i + 1]) : svg.draw_to(area[i], area[i + 1]);
    }
    svg.end_path("#d9b95c", 1);
}

// Below the diagonal nothing can be; between it and death = c^2 birth, or birth + 2 e, nothing is certain.
void draw_regions(Svg& svg, const Square& square, const ValueScale& scale, const BarStyle& style) {
    const double below[] = {square.x_of(scale.low),  square.y_of(scale.low), square.x_of(scale.high),
                            square.y_of(scale.high), square.right(),         square.bottom()};
    svg.polygon(below, 3, "#f4f5f6");
    if (style.has_curve()) {
        draw_doubt(svg, square, scale, style);
        return;
    }
    const double width = 2 * (style.is_additive() ? style.error : std::log(style.ratio));
    if (width > 0 && std::isfinite(width)) {
        const double reach = std::min(width, scale.high - scale.low);
        const double band[] = {square.x_of(scale.low),         square.y_of(scale.low),          square.x_of(scale.low),
                               square.y_of(scale.low + reach), square.x_of(scale.high - reach), square.y_of(scale.high),
                               square.x_of(scale.high),        square.y_of(scale.high)};
        svg.polygon(band, 4, "#fbf3dc");
        if (width < scale.high - scale.low) {
            svg.line(square.x_of(scale.low), square.y_of(scale.low + width), square.x_of(scale.high - width),
                     square.y_of(scale.high), "#d9b95c", 1, "4 3");
        }
    }
}

}  // namespace

void draw_scatter(Svg& svg, const Panel& panel, const std::vector<Bar>& bars, const ValueScale& scale,
                  const BarStyle& style) {
    const Square square{panel, scale};
    draw_regions(svg, square, scale, style);
    draw_axes(svg, square, scale);
    svg.line(square.x_of(scale.low), square.y_of(scale.low), square.x_of(scale.high), square.y_of(scale.high), ink, 1);
    svg.frame(panel.x, panel.y, panel.width, panel.height, ink);
    // Points that fall on one another within half a pixel are drawn once, which bounds the size of the picture.
    std::set<std::tuple<std::uint32_t, int, int>> drawn;
    for (const bool certain : {false, true}) {
        for (const Bar& bar : bars) {
            if (style.certain(bar) != certain) continue;
            const double x = square.x(bar.birth), y = square.y(bar.death);
            if (!drawn.emplace(bar.degree, static_cast<int>(2 * x), static_cast<int>(2 * y)).second) continue;
            // Long bars are larger dots, so that they are seen next to clouds of short ones.
            const double share = 10 * (bar.death - bar.birth) / (scale.high - scale.low);  // of a tenth of the width
            const double length = scale.is_linear ? std::min(share, 1.0)
                                  : bar.birth > 0 ? std::min(std::log(bar.death / bar.birth), 1.0)
                                                  : 1.0;
            svg.circle(x, y, 2 + 1.6 * length, degree_colour(bar.degree), certain ? 0.9 : 0.4 + 0.3 * length);
        }
    }
}

}  // namespace netmesh::tool
