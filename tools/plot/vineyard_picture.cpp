#include <algorithm>
#include <cmath>

#include "tools/filters.hpp"
#include "tools/io/numbers.hpp"
#include "tools/plot/barcode.hpp"
#include "tools/plot/plots.hpp"

namespace netmesh::tool {

namespace {

constexpr double vines_width = 460, vines_height = 520, gap = 90, text_margin = 48;
constexpr std::size_t vines_max = 60;  // shown of one degree

// The points of one vine, and how long it is where it is longest.
struct Strip {
    const netmesh_vine_point* first;
    std::size_t count;
    double length;  // death - birth, or ln(death / birth), births at 0 as if at the least positive double
};

// The vines of a degree, the longest first.
std::vector<Strip> strips_of(const Vines& vines, std::uint32_t degree, bool is_linear) {
    std::vector<Strip> strips;
    for (std::size_t i = 0; i < vines.points.size();) {
        Strip strip{&vines.points[i], 0, 0};
        for (; i < vines.points.size() && vines.points[i].vine == strip.first->vine; i++, strip.count++) {
            const netmesh_vine_point& p = vines.points[i];
            const double length =
                is_linear ? p.death - p.birth : std::log(p.death) - std::log(std::max(p.birth, 4.9e-324));
            strip.length = std::max(strip.length, length);
        }
        if (strip.first->degree == degree) strips.push_back(strip);
    }
    std::stable_sort(strips.begin(), strips.end(), [](const Strip& a, const Strip& b) { return a.length > b.length; });
    return strips;
}

class Plot {
public:
    Plot(Svg& svg, const Panel& panel, const ValueScale& scale, const Vines& vines, const char* what)
        : svg_(svg), panel_(panel), scale_(scale), what_(what), first_(vines.k_first), count_(vines.ratios.size()) {}

    void axes(std::uint32_t degree, std::size_t total, std::size_t shown) const {
        std::string title = homology_label(degree) + ": " + counted_text(total, "vine");
        if (shown < total) title += ", the " + std::to_string(shown) + " longest shown";
        svg_.text(panel_.x, panel_.y - 12, fitted_text(title, 14, true, panel_.width), 14, ink, Anchor::start, true);
        const double bottom = panel_.y + panel_.height;
        draw_value_axis(svg_, panel_.y, bottom, panel_.x - 40, panel_.x + panel_.width + 40, scale_,
                        [&](double tick) { return x(tick); });
        LabelRow labels;
        const std::size_t step = count_ / 20 + 1;
        for (std::size_t i = 0; i < count_; i += step) {
            const double at = y(first_ + static_cast<std::uint32_t>(i));
            svg_.line(panel_.x, at, panel_.x + panel_.width, at, rule, 1);
            if (!labels.take(at - 8, at + 4)) continue;
            const std::string label = fitted_text(std::to_string(first_ + i), 12, false, 44);
            svg_.text(panel_.x - 9, at + 4, label, 12, ink, Anchor::end);
        }
        svg_.text(panel_.x + panel_.width / 2, bottom + 40, scale_.is_linear ? "value" : "radius", 12, ink,
                  Anchor::middle);
        svg_.upright_text(panel_.x - 62, panel_.y + panel_.height / 2, what_, 12, ink);
    }
    // From birth to death at every k, joined to the next where the vine goes on.
    void draw(const Strip& strip, const char* colour) const {
        for (std::size_t i = 0; i < strip.count; i++) {
            const netmesh_vine_point& p = strip.first[i];
            svg_.line(x(p.birth), y(p.k), x(p.death), y(p.k), colour, 1.6);
            if (i + 1 == strip.count || strip.first[i + 1].k != p.k + 1) continue;
            const netmesh_vine_point& q = strip.first[i + 1];
            const double band[] = {x(p.birth), y(p.k), x(p.death), y(p.k), x(q.death), y(q.k), x(q.birth), y(q.k)};
            svg_.polygon(band, 4, colour, 0.18);
        }
    }

private:
    double x(double radius) const {
        const double share = std::isfinite(radius) ? scale_.share(radius) : 1;
        return panel_.x + std::clamp(share, 0.0, 1.0) * panel_.width;
    }
    double y(std::uint32_t k) const {
        return panel_.y + panel_.height * (1 - (k - first_ + 0.5) / static_cast<double>(count_));
    }
    Svg& svg_;
    const Panel& panel_;
    const ValueScale& scale_;
    const char* what_;  // that grows upwards
    std::uint32_t first_;
    std::size_t count_;
};

}  // namespace

std::string vineyard_picture(const Vines& vines, const netmesh_report& report, Axis axis) {
    std::vector<Bar> bars;
    for (const netmesh_vine_point& p : vines.points) bars.push_back({p.degree, p.birth, p.death});
    const netmesh_vineyard_report& vineyard = report.vineyard;
    const bool given = vineyard.filter == NETMESH_FILTER_NONE;
    // Values that are given have always been drawn as radii, unless some are negative.
    const ValueScale scale = scale_for(bars, is_linear_axis(axis, true, bars));
    TextWriter out;
    const std::uint32_t panels = vineyard.max_degree + 1;
    const double width = std::max(gap + panels * (vines_width + gap), 760.0);
    const std::string of =
        given ? simplices_text(vineyard.simplices) + ", " : counted_text(report.input.points, "point") + ", k = ";
    const std::string title = "Vineyard of " + of + std::to_string(vineyard.k_first) + " to " +
                              std::to_string(vineyard.k_last) + (given ? " of its steps" : "");
    const std::string what = std::string("a bar from birth to death at every ") + (given ? "step" : "k") +
                             ", bands join the bars of one vine";
    const std::string about = given ? what
                                    : choice_text({vineyard.filter, vineyard.values}) + "; " + what +
                                          "; certified ratio at most " + rounded_text(vineyard.certified_ratio, 4);
    Heading heading(width - 2 * text_margin);
    heading.add(title, 20, ink, true);
    heading.add(about, 13, faint_ink);
    const double top = 18 + heading.height() + 40;
    std::string description = "For each degree bars of a diagram, one row for each step. " + about + ".";
    for (std::uint32_t degree = 0; degree < panels; degree++)
        description += " Degree " + std::to_string(degree) + ": " +
                       counted_text(strips_of(vines, degree, scale.is_linear).size(), "vine") + ".";
    Svg svg(out, width, top + vines_height + 64, title, description);
    heading.draw(svg, text_margin, 18);
    for (std::uint32_t degree = 0; degree < panels; degree++) {
        const Panel panel{gap + degree * (vines_width + gap), top, vines_width, vines_height};
        const Plot plot(svg, panel, scale, vines, given ? "step" : "k");
        std::vector<Strip> strips = strips_of(vines, degree, scale.is_linear);
        const std::size_t shown = std::min(strips.size(), vines_max);
        plot.axes(degree, strips.size(), shown);
        for (std::size_t i = shown; i-- > 0;) plot.draw(strips[i], degree_colour(degree));
        svg.frame(panel.x, panel.y, panel.width, panel.height, ink);
    }
    svg.finish();
    return out.text();
}

}  // namespace netmesh::tool
