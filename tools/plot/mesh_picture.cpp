#include <algorithm>
#include <cmath>

#include "tools/io/numbers.hpp"
#include "tools/plot/plots.hpp"
#include "tools/plot/svg.hpp"

namespace netmesh::tool {

namespace {

constexpr double page_size = 1000, margin = 40, caption = 44;

struct View {
    double x_min, y_min, scale;
    double x(const netmesh_vertex& vertex) const { return margin + (vertex.coordinates[0] - x_min) * scale; }
    double y(const netmesh_vertex& vertex) const {
        return page_size - margin - (vertex.coordinates[1] - y_min) * scale;
    }
};

// The domain, or the box of all vertices where there is none, in the middle of a square.
View view_of(const MeshSource& mesh) {
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (std::uint64_t i = 0; i < mesh.vertex_count && mesh.domain[2] == 0; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        for (int k = 0; k < 2; k++) {
            low[k] = std::min(low[k], vertex.coordinates[k]);
            high[k] = std::max(high[k], vertex.coordinates[k]);
        }
    }
    for (int k = 0; k < 2 && mesh.domain[2] > 0; k++) {
        low[k] = mesh.domain[k] - 1.04 * mesh.domain[2];
        high[k] = mesh.domain[k] + 1.04 * mesh.domain[2];
    }
    const double side = std::max(std::max(high[0] - low[0], high[1] - low[1]), 1e-300);
    return {(low[0] + high[0] - side) / 2, (low[1] + high[1] - side) / 2, (page_size - 2 * margin) / side};
}

// Each edge once: from the side of the cell with the smaller index. `outer`: those that end at a boundary vertex, else
// the others.
void draw_edges(const MeshSource& mesh, const View& view, bool outer, const char* colour, double width, Svg& svg) {
    constexpr std::uint64_t strokes_a_path = 500;  // viewers choke on paths of millions of strokes
    std::uint64_t strokes = 0;
    for (std::uint64_t c = 0; c < mesh.cell_count; c++) {
        const netmesh_cell cell = mesh.cell(c);
        for (int i = 0; i < 3; i++) {
            if (cell.neighbours[i] != NETMESH_NONE && cell.neighbours[i] < c) continue;
            const netmesh_vertex a = mesh.vertex(cell.vertices[(i + 1) % 3]);
            const netmesh_vertex b = mesh.vertex(cell.vertices[(i + 2) % 3]);
            if ((a.marker == 2 || b.marker == 2) != outer) continue;
            if (strokes > 0 && strokes % strokes_a_path == 0) svg.end_path(colour, width);
            if (strokes++ % strokes_a_path == 0) svg.begin_path();
            svg.move_to(view.x(a), view.y(a));
            svg.draw_to(view.x(b), view.y(b));
        }
    }
    if (strokes > 0) svg.end_path(colour, width);
}

void draw_vertices(const MeshSource& mesh, const View& view, std::uint32_t marker, double radius, const char* colour,
                   Svg& svg) {
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        if (vertex.marker == marker) svg.circle(view.x(vertex), view.y(vertex), radius, colour);
    }
}

}  // namespace

void write_mesh_picture(const MeshSource& mesh, TextWriter& out) {
    Svg svg(out, page_size, page_size + caption);
    const View view = view_of(mesh);
    std::uint64_t counts[3] = {0, 0, 0};
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) counts[std::min(mesh.vertex(i).marker, 2u)]++;
    // Strokes and dots shrink as cells do.
    const double cell_size = (page_size - 2 * margin) / std::sqrt(static_cast<double>(mesh.vertex_count) + 1);
    const double dot = std::clamp(0.11 * cell_size, 0.5, 4.5);
    svg.begin_clip(margin / 2, margin / 2, page_size - margin, page_size - margin);
    const double stroke = std::clamp(0.035 * cell_size, 0.15, 1.1);
    draw_edges(mesh, view, true, "#dde2e6", stroke, svg);
    draw_edges(mesh, view, false, "#8c9aa8", stroke, svg);
    if (mesh.domain[2] > 0) {
        netmesh_vertex centre = {};
        centre.coordinates[0] = mesh.domain[0];
        centre.coordinates[1] = mesh.domain[1];
        svg.ring(view.x(centre), view.y(centre), mesh.domain[2] * view.scale, "#c98a1b", 1.5, "7 5");
    }
    for (const netmesh_cage& cage : mesh.cages) {
        const netmesh_vertex centre = mesh.vertex(cage.centre);
        if (cage.radius * view.scale < 0.5) continue;
        svg.ring(view.x(centre), view.y(centre), cage.radius * view.scale, "#6a4c93", 1.2);
        svg.ring(view.x(centre), view.y(centre), cage.radius / 2 * view.scale, "#c98a1b", 1, "7 5");
    }
    draw_vertices(mesh, view, 2, 0.6 * dot, "#c98a1b", svg);
    draw_vertices(mesh, view, 1, 0.6 * dot, "#1b7f79", svg);
    draw_vertices(mesh, view, 0, std::max(dot, 1.4), "#d1495b", svg);
    svg.end_group();
    double x = margin;
    const double y = page_size + caption / 2;
    const char* const colours[] = {"#d1495b", "#1b7f79", "#c98a1b"};
    const char* const names[] = {" inputs", " Steiner points", " boundary vertices"};
    for (int marker = 0; marker < 3; marker++) {
        if (counts[marker] == 0) continue;
        const std::string label = grouped_text(counts[marker]) + names[marker];
        svg.circle(x + 5, y - 5, 5, colours[marker]);
        svg.text(x + 17, y, label, 16, ink, Anchor::start);
        x += 48 + 8.6 * static_cast<double>(label.size());
    }
    svg.text(page_size - margin, y, grouped_text(mesh.cell_count) + " triangles", 16, faint_ink, Anchor::end);
    svg.finish();
}

}  // namespace netmesh::tool
