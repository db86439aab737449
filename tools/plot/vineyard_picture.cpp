#include <algorithm>
#include <cmath>

#include "tools/filters.hpp"
#include "tools/io/numbers.hpp"
#include "tools/plot/barcode.hpp"
#include "tools/plot/plots.hpp"

namespace netmesh::tool {

namespace {

constexpr double page_height = 730, panel_width = 460, gap = 90;
constexpr std::size_t vines_max = 60;  // shown of one degree

// The points of one vine, and how long it is where it is longest.
struct Strip {
    const netmesh_vine_point* first;
    std::size_t count;
    double length;  // ln(death / birth), births at 0 as if at the least positive double
};

// The vines of a degree, the longest first.
std::vector<Strip> strips_of(const Vines& vines, std::uint32_t degree) {
    std::vector<Strip> strips;
    for (std::size_t i = 0; i < vines.points.size();) {
        Strip strip{&vines.points[i], 0, 0};
        for (; i < vines.points.size() && vines.points[i].vine == strip.first->vine; i++, strip.count++) {
            const netmesh_vine_point& p = vines.points[i];
            strip.length = std::max(strip.length, std::log(p.death) - std::log(std::max(p.birth, 4.9e-324)));
        }
        if (strip.first->degree == degree) strips.push_back(strip);
    }
    std::stable_sort(strips.begin(), strips.end(), [](const Strip& a, const Strip& b) { return a.length > b.length; });
    return strips;
}

class Plot {
public:
    Plot(Svg& svg, const Panel& panel, const ValueScale& scale, const Vines& vines)
        : svg_(svg), panel_(panel), scale_(scale), first_(vines.k_first), count_(vines.ratios.size()) {}

    void axes(std::uint32_t degree, std::size_t total, std::size_t shown) const {
        std::string title = homology_label(degree) + ": " + grouped_text(total) + (total == 1 ? " vine" : " vines");
        if (shown < total) title += ", the " + std::to_string(shown) + " longest shown";
        svg_.text(panel_.x, panel_.y - 12, title, 14, ink, Anchor::start, true);
        for (const double tick : scale_.ticks()) {
            const double x = panel_.x + (tick - scale_.low) / (scale_.high - scale_.low) * panel_.width;
            const double bottom = panel_.y + panel_.height;
            svg_.line(x, panel_.y, x, bottom, rule, 1);
            svg_.text(x, bottom + 19, logarithm_label(tick), 12, ink, Anchor::middle);
            svg_.text(x, bottom + 34, radius_label(tick), 11, faint_ink, Anchor::middle);
        }
        const std::size_t step = count_ / 20 + 1;
        for (std::size_t i = 0; i < count_; i += step) {
            const double at = y(first_ + static_cast<std::uint32_t>(i));
            svg_.line(panel_.x, at, panel_.x + panel_.width, at, rule, 1);
            svg_.text(panel_.x - 9, at + 4, std::to_string(first_ + i), 12, ink, Anchor::end);
        }
        svg_.text(panel_.x + panel_.width / 2, panel_.y + panel_.height + 53, "ln radius, radius", 12, ink,
                  Anchor::middle);
        svg_.upright_text(panel_.x - 38, panel_.y + panel_.height / 2, "k", 12, ink);
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
    std::uint32_t first_;
    std::size_t count_;
};

}  // namespace

std::string vineyard_picture(const Vines& vines, const netmesh_report& report) {
    std::vector<Bar> bars;
    for (const netmesh_vine_point& p : vines.points) bars.push_back({p.degree, p.birth, p.death});
    const ValueScale scale = scale_for(bars);
    TextWriter out;
    const netmesh_vineyard_report& vineyard = report.vineyard;
    const std::uint32_t panels = vineyard.max_degree + 1;
    Svg svg(out, gap + panels * (panel_width + gap), page_height);
    const bool given = vineyard.filter == NETMESH_FILTER_NONE;
    const std::string of =
        given ? grouped_text(vineyard.simplices) + " simplices, " : grouped_text(report.input.points) + " points, k = ";
    svg.text(48, 40,
             "Vineyard of " + of + std::to_string(vineyard.k_first) + " to " + std::to_string(vineyard.k_last) +
                 (given ? " of its steps" : ""),
             20, ink, Anchor::start, true);
    const std::string what = "a bar from birth to death at every ";
    svg.text(48, 62,
             given ? what + "step, bands join the bars of one vine"
                   : choice_text({vineyard.filter, vineyard.values}) + "; " + what +
                         "k, bands join the bars of one vine; certified ratio at most " +
                         rounded_text(vineyard.certified_ratio, 4),
             13, faint_ink, Anchor::start);
    for (std::uint32_t degree = 0; degree < panels; degree++) {
        const Panel panel{gap + degree * (panel_width + gap), 110, panel_width, 520};
        const Plot plot(svg, panel, scale, vines);
        std::vector<Strip> strips = strips_of(vines, degree);
        const std::size_t shown = std::min(strips.size(), vines_max);
        plot.axes(degree, strips.size(), shown);
        for (std::size_t i = shown; i-- > 0;) plot.draw(strips[i], degree_colour(degree));
        svg.frame(panel.x, panel.y, panel.width, panel.height, ink);
    }
    svg.finish();
    return out.text();
}

}  // namespace netmesh::tool
