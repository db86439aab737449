#include <algorithm>
#include <cmath>

#include "tools/filters.hpp"
#include "tools/io/numbers.hpp"
#include "tools/plot/barcode.hpp"
#include "tools/plot/plots.hpp"

namespace netmesh::tool {

namespace {

constexpr double page_width = 1280;
constexpr double axis_height = 52;  // below a panel
constexpr double square_side = 440, panel_height = infinity_row + square_side;
constexpr std::size_t rows_max = 24;  // bars shown of one degree
constexpr double ratio_height = 60;

std::string superscript(std::uint32_t dim) {
    static constexpr const char* digits[] = {
        "", "", "\xC2\xB2", "\xC2\xB3", "\xE2\x81\xB4", "\xE2\x81\xB5", "\xE2\x81\xB6"};
    return digits[dim <= 6 ? dim : 0];
}

std::string counted_vertices(std::uint64_t count) {
    return count == 1 ? "1 vertex" : grouped_text(count) + " vertices";
}

constexpr const char* separator = "  \xC2\xB7  ";

std::string subtitle(const netmesh_report& report) {
    const netmesh_diagram_report& diagram = report.diagram;
    const netmesh_mesh_report& mesh = report.mesh;
    if (report.input.dim == 0) {
        std::string text = counted_vertices(report.simplicial_complex.vertices);
        for (std::uint32_t degree = 0; degree <= diagram.max_degree; degree++) {
            text += std::string(degree == 0 ? separator : ", ") + (degree == 0 ? "Betti numbers " : "") +
                    grouped_text(diagram.essential[degree]);
        }
        return text;
    }
    std::string text = reported_choice_text({diagram.filter, diagram.values});
    if (mesh.present == 0) return text + separator + simplices_text(diagram.simplices);
    text += separator + counted_vertices(mesh.vertices) + ", " + counted_text(mesh.cells, "cell");
    if (mesh.is_mesh == 0) return text;
    text += std::string(separator) + "aspect ratio \xE2\x89\xA4 " + rounded_text(mesh.aspect_ratio_max, 4);
    const double ratio = mesh.goal.ratio;
    return text + (ratio > 0 ? std::string(separator) + "refined to ratio " + rounded_text(ratio, 4)
                             : " (\xCF\x84 = " + rounded_text(mesh.tau, 4) + ")");
}

// R^2 of a text, as pictures write it.
std::string with_superscripts(std::string text) {
    for (std::uint32_t dim = 2; dim <= 6; dim++) {
        const std::string plain = "R^" + std::to_string(dim);
        const std::size_t at = text.find(plain);
        if (at != std::string::npos) text.replace(at, plain.size(), "R" + superscript(dim));
    }
    return text;
}

std::string certificate(const netmesh_report& report) {
    const double c = report.diagram.certified_ratio, from = report.diagram.certified_from;
    if (report.input.dim == 0) return "exact";
    const std::string reference = with_superscripts(reference_name(report));
    const std::string of = reference.rfind("closed offsets", 0) == 0 ? "offsets" : reference;
    if (c == 1 && from == 0) return "certified ratio c = 1: the exact diagram of the " + of;
    if (report.diagram.filter == NETMESH_FILTER_FUNCTION)
        return "certified error e = " + rounded_text(report.diagram.certified_error, 4) +
               ": births and deaths are within e of those of the " + reference;
    std::string text = "certified ratio c = " + rounded_text(c, 4);
    if (from > 0) text += " from radius " + rounded_text(from, 4);
    return text + ": within ln c = " + rounded_text(std::log(c), 3) + " of the exact diagram of the " + of;
}

Legend legend_of(const netmesh_report& report, const std::vector<BarGroup>& groups, const BarStyle& style,
                 const ValueScale& scale) {
    Legend legend(page_width - 2 * page_margin);
    bool folds = false, essential = false, labels = false, apart = false;
    for (const BarGroup& group : groups) {
        const std::uint32_t degree = group.degree;
        legend.add(
            9,
            [degree](Svg& svg, double x, double y) {
                svg.mark(degree_mark(degree), x + 4.5, y, 4.5, degree_colour(degree));
            },
            homology_label(degree));
        folds = folds || !group.rest.empty();
        labels = labels || group.labelled > 0;
        apart = apart || group.apart > 0;
        for (const Bar& bar : group.shown) essential = essential || !std::isfinite(bar.death);
    }
    const auto swatch = [](const char* fill, double opacity) {
        return [fill, opacity](Svg& svg, double x, double y) {
            svg.polygon({x, y - 6, x + 22, y - 6, x + 22, y + 6, x, y + 6}, fill, opacity);
        };
    };
    const bool doubts = style.is_additive() ? style.error > 0 : report.diagram.certified_ratio > 1;
    if (doubts) {
        const double c = report.diagram.certified_ratio;
        const std::string limit =
            style.has_flags       ? ""
            : style.is_additive() ? ": death \xE2\x88\x92 birth \xE2\x89\xA4 2 e = " + rounded_text(2 * style.error, 3)
                                  : ": death / birth \xE2\x89\xA4 c\xC2\xB2 = " + rounded_text(c * c, 3);
        legend.add(22, swatch(doubt_fill, 1), "too short to be certified" + limit);
        legend.add(22, swatch(degree_colour(0), 0.45), "faint: may be an artefact");
        legend.add(22, swatch(degree_colour(0), 1), "solid: certified to exist, however short");
    }
    if (style.has_curve()) {
        legend.add(
            22, [](Svg& svg, double x, double y) { svg.line(x, y, x + 22, y, doubt_line, 1.5); },
            style.is_additive() ? "e(v): certified error at value v" : "c(r): certified ratio at radius r");
    }
    if (essential)
        legend.add(
            22,
            [](Svg& svg, double x, double y) {
                svg.line(x, y, x + 14, y, ink, 4);
                svg.polygon({x + 13, y - 5, x + 22, y, x + 13, y + 5}, ink);
            },
            "never dies");
    if (folds)
        legend.add(22, swatch(degree_colour(0), 0.3), "curve: how many of the other, shorter bars there are at once");
    legend.add(22, swatch("#eff1f3", 1), "below the diagonal no bar can be");
    if (labels)
        legend.add(
            22, [](Svg& svg, double x, double y) { svg.text(x + 11, y + 4, "a to b", 9, ink, Anchor::middle); },
            apart ? "birth and death; bold: bars that stand apart by their length"
                  : "birth and death of the longest bars");
    if (scale.has_zero)
        legend.add(
            22, [](Svg& svg, double x, double y) { svg.text(x + 11, y + 4, "0", 12, ink, Anchor::middle); },
            "column of bars that are born at 0");
    return legend;
}

// For who cannot see it.
std::string description_of(const netmesh_report& report, const std::vector<BarGroup>& groups) {
    std::string text =
        "A barcode, and beside it the same bars as points, death against birth. " + certificate(report) + ".";
    for (const BarGroup& group : groups) {
        text +=
            " Degree " + std::to_string(group.degree) + ": " +
            (group.total == 0 ? "no bar" : counted_text(group.total, "bar")) +
            (group.total == 0 || group.is_exact ? "" : ", " + grouped_text(group.certified) + " certified to exist") +
            (group.apart == 0 ? "." : ", of which " + grouped_text(group.apart) + " by its length apart.");
        if (group.shown.empty()) continue;
        const Bar& first = group.shown[0];
        text += " First shown: from " + rounded_text(first.birth, 4) +
                (std::isfinite(first.death) ? " to " + rounded_text(first.death, 4) : " on for ever") + ".";
    }
    return text;
}

}  // namespace

std::string diagram_picture(const std::vector<Bar>& bars, const netmesh_report& report, const Bounds& bounds,
                            Axis axis) {
    TextWriter out;
    const BarStyle style = style_of(bars, report, bounds);
    const bool are_radii = !style.is_additive();
    const ValueScale scale = scale_for(bars, is_linear_axis(axis, are_radii, bars));
    const std::string subject = report.input.dim == 0 ? "a complex of " + simplices_text(report.diagram.simplices)
                                                      : counted_text(report.input.points, "point") + " in R" +
                                                            superscript(report.input.dim) +
                                                            (report.input.periods > 0 ? ", which repeat" : "");
    const std::string title = "Persistent homology of " + subject;
    Heading heading(page_width - 2 * page_margin);
    heading.add(title, 20, ink, true);
    heading.add(subtitle(report), 13, faint_ink);
    heading.add(certificate(report), 13, ink);
    const std::vector<BarGroup> groups = group_bars(bars, report.diagram.max_degree, rows_max, scale, style);
    const Legend legend = legend_of(report, groups, style, scale);

    // From the right: the square, labels of deaths, labels of bars; the barcode has the rest.
    const double top = 18 + heading.height() + 22;
    const double diagram_x = page_width - page_margin - square_side - (scale.has_zero ? zero_column : 0);
    const double barcode_x = page_margin + degree_width;
    const double width = diagram_x - death_label_width(scale) - 44 - label_width(groups) - barcode_x;
    const double curve = style.has_curve() ? ratio_height + 20 : 0;
    const double height = std::max(panel_height, curve + barcode_height(groups));
    const Panel barcode{barcode_x, top + curve, width, height - curve};
    const double legend_y = top + height + axis_height;
    Svg svg(out, page_width, legend_y + legend.height() + 20, title, description_of(report, groups));
    heading.draw(svg, page_margin, 18);
    if (style.has_curve()) draw_ratio(svg, {barcode_x, top, width, ratio_height}, scale, style);
    draw_barcode(svg, barcode, groups, scale, style);
    svg.text(barcode_x + width / 2, top + height + 40,
             report.input.squares != 0            ? "square of the radius"
             : are_radii && report.input.dim != 0 ? "radius r"
                                                  : "value v",
             12, ink, Anchor::middle);
    draw_scatter(svg, diagram_x, top, square_side, bars, scale, style);
    legend.draw(svg, page_margin, legend_y);
    svg.finish();
    return out.text();
}

}  // namespace netmesh::tool
