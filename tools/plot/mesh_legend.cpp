#include "tools/plot/mesh_legend.hpp"

#include <algorithm>
#include <cmath>

#include "tools/io/numbers.hpp"
#include "tools/plot/barcode.hpp"

namespace netmesh::tool {

namespace {

constexpr struct {
    double limit;
    const char* colour;
    const char* label;
} finenesses[] = {{0.125, "#35608d", "\xE2\x89\xA4 1/8"},
                  {0.25, "#6b93bd", "\xE2\x89\xA4 1/4"},
                  {0.5, "#a5c1dc", "\xE2\x89\xA4 1/2"},
                  {1, "#d6e4f0", "\xE2\x89\xA4 1"},
                  {HUGE_VAL, "#f6f8fb", "> 1"}};

Legend::Symbol swatch(const char* colour) {
    return [colour](Svg& svg, double x, double y) {
        svg.polygon({x, y - 7, x + 20, y - 7, x + 20, y + 7, x, y + 7}, colour);
        svg.frame(x, y - 7, 20, 14, "#76828e");
    };
}

}  // namespace

std::string cells_text(const MeshSource& mesh) {
    if (mesh.dim == 2) return counted_text(mesh.cell_count, "triangle");
    return grouped_text(mesh.cell_count) + (mesh.cell_count == 1 ? " tetrahedron" : " tetrahedra");
}

MeshCounts counts_of(const MeshSource& mesh) {
    MeshCounts counts;
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) counts.markers[std::min(mesh.vertex(i).marker, 2u)]++;
    return counts;
}

const char* vertex_colour(std::uint32_t marker) {
    return marker == 0 ? input_colour : marker == 1 ? steiner_colour : boundary_colour;
}

Mark vertex_mark(std::uint32_t marker) {
    return marker == 0 ? Mark::disc : marker == 1 ? Mark::square : Mark::triangle;
}

const char* fineness_colour(double ratio) {
    for (const auto& step : finenesses)
        if (ratio <= step.limit) return step.colour;
    return finenesses[4].colour;
}

std::string mesh_title(const MeshSource& mesh, const MeshCounts& counts) {
    return (mesh.tau > 0 || mesh.ratio > 0 ? "Quality mesh of " : "Delaunay triangulation of ") +
           counted_text(counts.markers[0], "point");
}

std::string mesh_description(const MeshSource& mesh, const MeshCounts& counts) {
    return cells_text(mesh) + "; " + counted_text(counts.markers[0], "input") + ", " +
           counted_text(counts.markers[1], "Steiner point") + " and " + grouped_text(counts.markers[2]) +
           " vertices of the boundary, each with a shape and colour of its own.";
}

void add_vertices(const MeshCounts& counts, Legend* legend) {
    static constexpr const char* names[] = {"input", "Steiner point", ""};
    for (std::uint32_t marker = 0; marker < 3; marker++) {
        const std::uint64_t count = counts.markers[marker];
        if (count == 0) continue;
        const std::string text = marker < 2
                                     ? counted_text(count, names[marker])
                                     : grouped_text(count) + (count == 1 ? " boundary vertex" : " boundary vertices");
        legend->add(
            12,
            [marker](Svg& svg, double x, double y) {
                svg.mark(vertex_mark(marker), x + 6, y, 5, vertex_colour(marker));
            },
            text);
    }
}

void add_cells(const MeshSource& mesh, const MeshCounts& counts, bool voronoi, Legend* legend) {
    const auto lines = [](const char* colour) {
        return [colour](Svg& svg, double x, double y) {
            svg.begin_path();
            svg.move_to(x, y + 6);
            svg.draw_to(x + 10, y - 7);
            svg.draw_to(x + 20, y + 6);
            svg.draw_to(x, y + 6);
            svg.end_path(colour, 1.2);
        };
    };
    if (voronoi) {
        legend->add(20, lines("#4d6076"), "Voronoi cells of " + counted_text(mesh.cell_count, "corner"));
    } else {
        legend->add(20, lines("#76828e"), cells_text(mesh));
        if (counts.markers[2] > 0) legend->add(20, lines("#b4bcc4"), "edges that end at the boundary");
    }
    if (mesh.domain[2] > 0)
        legend->add(
            20, [](Svg& svg, double x, double y) { svg.ring(x + 10, y, 7, domain_colour, 1.5, "4 3"); }, "domain");
    if (!mesh.cages.empty()) {
        legend->add(
            20, [](Svg& svg, double x, double y) { svg.ring(x + 10, y, 7, cage_colour, 1.2); },
            counted_text(mesh.cages.size(), "cage"));
        legend->add(
            20, [](Svg& svg, double x, double y) { svg.ring(x + 10, y, 7, cage_colour, 1, "3 4"); },
            "half of a cage's radius");
    }
    if (!voronoi || counts.markers[0] < 2) return;
    for (const auto& step : finenesses) {
        const bool first = step.colour == finenesses[0].colour;
        legend->add(20, swatch(step.colour),
                    first ? std::string("out-radius / distance to the second nearest input ") + step.label
                          : step.label);
    }
}

}  // namespace netmesh::tool
