#include <algorithm>
#include <cmath>

#include "tools/filters.hpp"
#include "tools/io/numbers.hpp"
#include "tools/plot/barcode.hpp"
#include "tools/plot/plots.hpp"

namespace netmesh::tool {

namespace {

constexpr double page_width = 1280, page_height = 750;
constexpr std::size_t rows_max = 40;  // bars shown of one degree
constexpr double ratio_height = 60;

std::string superscript(std::uint32_t dim) {
    static constexpr const char* digits[] = {
        "", "", "\xC2\xB2", "\xC2\xB3", "\xE2\x81\xB4", "\xE2\x81\xB5", "\xE2\x81\xB6"};
    return digits[dim <= 6 ? dim : 0];
}

constexpr const char* separator = "  \xC2\xB7  ";

std::string subtitle(const netmesh_report& report) {
    const netmesh_diagram_report& diagram = report.diagram;
    const netmesh_mesh_report& mesh = report.mesh;
    if (report.input.dim == 0) {
        std::string text = grouped_text(report.simplicial_complex.vertices) + " vertices";
        for (std::uint32_t degree = 0; degree <= diagram.max_degree; degree++) {
            text += std::string(degree == 0 ? separator : ", ") + (degree == 0 ? "Betti numbers " : "") +
                    grouped_text(diagram.essential[degree]);
        }
        return text;
    }
    std::string text = reported_choice_text({diagram.filter, diagram.values});
    if (mesh.present == 0) return text + separator + grouped_text(diagram.simplices) + " simplices";
    text += separator + grouped_text(mesh.vertices) + " vertices, " + grouped_text(mesh.cells) + " cells";
    if (mesh.is_mesh == 0) return text;
    text += std::string(separator) + "aspect ratio \xE2\x89\xA4 " + rounded_text(mesh.aspect_ratio_max, 4);
    const double ratio = mesh.certificate.ratio;
    return text + (ratio > 0 ? std::string(separator) + "refined to ratio " + rounded_text(ratio, 4)
                             : " (\xCF\x84 = " + rounded_text(mesh.tau, 4) + ")");
}

std::string certificate(const netmesh_report& report) {
    const double c = report.diagram.certified_ratio, from = report.diagram.certified_from;
    if (report.input.dim == 0) return "exact";
    const std::string reference = reference_name(report);
    const std::string of = reference.rfind("closed offsets", 0) == 0 ? "offsets" : reference;
    if (c == 1 && from == 0) return "certified ratio c = 1: the exact diagram of the " + of;
    if (report.diagram.filter == NETMESH_FILTER_FUNCTION)
        return "certified error e = " + rounded_text(report.diagram.certified_error, 4) +
               ": births and deaths are within e of those of the " + reference;
    std::string text = "certified ratio c = " + rounded_text(c, 4);
    if (from > 0) text += " from radius " + rounded_text(from, 4);
    return text + ": within ln c = " + rounded_text(std::log(c), 3) + " of the exact diagram of the " + of;
}

void draw_key(Svg& svg, double x, double y, const netmesh_report& report, const BarStyle& style) {
    for (std::uint32_t degree = 0; degree <= report.diagram.max_degree; degree++) {
        svg.circle(x, y - 4, 4, degree_colour(degree));
        svg.text(x + 9, y, homology_label(degree), 13, ink, Anchor::start);
        x += 44;
    }
    if (style.is_additive() ? style.error <= 0 : report.diagram.certified_ratio <= 1) return;
    const double square = report.diagram.certified_ratio * report.diagram.certified_ratio;
    svg.rect(x + 8, y - 11, 22, 13, "#fbf3dc");
    if (style.has_flags) {
        const std::string curve =
            style.is_additive() ? "; e(v): certified error at value v" : "; c(r): certified ratio at radius r";
        const std::string shown = style.has_curve() ? curve : "";
        svg.text(x + 38, y,
                 "too short to be surely real by scale; faint bars may be artefacts, every solid class is real" + shown,
                 12, faint_ink, Anchor::start);
        return;
    }
    if (style.is_additive()) {
        svg.text(x + 38, y,
                 "death \xE2\x88\x92 birth \xE2\x89\xA4 2 e = " + rounded_text(2 * style.error, 3) +
                     ": drawn faint, may be an artefact; every solid class is real",
                 12, faint_ink, Anchor::start);
        return;
    }
    svg.text(x + 38, y,
             "death / birth \xE2\x89\xA4 c\xC2\xB2 = " + rounded_text(square, 3) +
                 ": drawn faint, may be an artefact; every solid class is real",
             12, faint_ink, Anchor::start);
}

}  // namespace

std::string diagram_picture(const std::vector<Bar>& bars, const netmesh_report& report, const Bounds& bounds) {
    TextWriter out;
    Svg svg(out, page_width, page_height);
    const BarStyle style = style_of(bars, report, bounds);
    const ValueScale scale = scale_for(bars, style.is_additive());
    const std::string subject =
        report.input.dim == 0 ? "a complex of " + grouped_text(report.diagram.simplices) + " simplices"
                              : grouped_text(report.input.points) + " points in R" + superscript(report.input.dim);
    svg.text(48, 40, "Persistent homology of " + subject, 20, ink, Anchor::start, true);
    svg.text(48, 62, subtitle(report), 13, faint_ink, Anchor::start);
    svg.text(48, 82, certificate(report), 13, ink, Anchor::start);
    Panel barcode{152, 112, 572, 520};
    if (style.has_curve()) {
        draw_ratio(svg, {barcode.x, barcode.y, barcode.width, ratio_height}, scale, style);
        barcode.y += ratio_height + 20;
        barcode.height -= ratio_height + 20;
    }
    draw_barcode(svg, barcode, group_bars(bars, report.diagram.max_degree, rows_max, scale), scale, style);
    const Panel scatter{800, 112, 440, 520};
    draw_scatter(svg, scatter, bars, scale, style);
    draw_key(svg, 52, page_height - 26, report, style);
    svg.finish();
    return out.text();
}

}  // namespace netmesh::tool
