#include <algorithm>
#include <cmath>

#include "tools/io/numbers.hpp"
#include "tools/plot/barcode.hpp"
#include "tools/plot/mesh_legend.hpp"
#include "tools/plot/plots.hpp"
#include "tools/plot/solid.hpp"
#include "tools/plot/svg.hpp"

namespace netmesh::tool {

namespace {

struct View {
    double x_min, y_min, scale;
    double x(const netmesh_vertex& vertex) const { return page_margin + (vertex.coordinates[0] - x_min) * scale; }
    double y(const netmesh_vertex& vertex) const {
        return page_size - page_margin - (vertex.coordinates[1] - y_min) * scale;
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
    return {(low[0] + high[0] - side) / 2, (low[1] + high[1] - side) / 2, (page_size - 2 * page_margin) / side};
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

void draw_vertices(const MeshSource& mesh, const View& view, std::uint32_t marker, double radius, Svg& svg) {
    const bool ringed = marker == 0 && radius > 1.5;
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        if (vertex.marker != marker) continue;
        if (ringed) svg.circle(view.x(vertex), view.y(vertex), radius + 1, "#ffffff");
        svg.mark(vertex_mark(marker), view.x(vertex), view.y(vertex), radius, vertex_colour(marker));
    }
}

// A cell's circumcentre, the corner of three Voronoi cells.
struct Corner {
    double x, y;
};

std::vector<Corner> corners_of(const MeshSource& mesh) {
    std::vector<Corner> corners(mesh.cell_count);
    for (std::uint64_t c = 0; c < mesh.cell_count; c++) {
        const netmesh_cell cell = mesh.cell(c);
        const netmesh_vertex o = mesh.vertex(cell.vertices[0]);
        double a[2], b[2];
        for (int k = 0; k < 2; k++) {
            a[k] = mesh.vertex(cell.vertices[1]).coordinates[k] - o.coordinates[k];
            b[k] = mesh.vertex(cell.vertices[2]).coordinates[k] - o.coordinates[k];
        }
        const double aa = a[0] * a[0] + a[1] * a[1], bb = b[0] * b[0] + b[1] * b[1];
        const double twice = 2 * (a[0] * b[1] - a[1] * b[0]);
        corners[c] = {o.coordinates[0] + (b[1] * aa - a[1] * bb) / twice,
                      o.coordinates[1] + (a[0] * bb - b[0] * aa) / twice};
    }
    return corners;
}

// The cells around a vertex in their order, beginning with one of them; empty where they do not close.
std::vector<std::uint32_t> cells_around(const MeshSource& mesh, std::uint32_t vertex, std::uint32_t first) {
    std::vector<std::uint32_t> around;
    std::uint32_t at = first;
    do {
        around.push_back(at);
        const netmesh_cell cell = mesh.cell(at);
        int i = 0;
        while (i < 2 && cell.vertices[i] != vertex) i++;
        at = cell.neighbours[(i + 1) % 3];
        if (at == NETMESH_NONE || around.size() > mesh.cell_count) return {};
    } while (at != first);
    return around;
}

// Distance to the second nearest input, the feature size that over-refinement goes by.
double feature_size(const std::vector<netmesh_vertex>& inputs, const netmesh_vertex& vertex) {
    double nearest = HUGE_VAL, second = HUGE_VAL;
    for (const netmesh_vertex& input : inputs) {
        const double x = input.coordinates[0] - vertex.coordinates[0], y = input.coordinates[1] - vertex.coordinates[1];
        const double square = x * x + y * y;
        second = std::min(second, std::max(square, nearest));
        nearest = std::min(nearest, square);
    }
    return std::sqrt(second);
}

constexpr double coloured_pairs_max = 4e8;  // of vertices and inputs: a second's work

// True when the cells could be coloured.
bool draw_voronoi(const MeshSource& mesh, const View& view, double stroke, Svg& svg) {
    const std::vector<Corner> corners = corners_of(mesh);
    const auto x = [&](const Corner& c) { return page_margin + (c.x - view.x_min) * view.scale; };
    const auto y = [&](const Corner& c) { return page_size - page_margin - (c.y - view.y_min) * view.scale; };
    std::vector<std::uint32_t> cell_of(mesh.vertex_count, NETMESH_NONE);
    for (std::uint64_t c = 0; c < mesh.cell_count; c++)
        for (int i = 0; i < 3; i++) cell_of[mesh.cell(c).vertices[i]] = static_cast<std::uint32_t>(c);
    std::vector<netmesh_vertex> inputs;
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++)
        if (mesh.vertex(i).marker == 0) inputs.push_back(mesh.vertex(i));
    const bool coloured =
        static_cast<double>(mesh.vertex_count) * static_cast<double>(inputs.size()) <= coloured_pairs_max;
    for (std::uint64_t v = 0; v < mesh.vertex_count && coloured && inputs.size() > 1; v++) {
        const netmesh_vertex vertex = mesh.vertex(v);
        if (vertex.marker == 2 || cell_of[v] == NETMESH_NONE) continue;
        std::vector<double> outline;
        double out_radius = 0;
        for (const std::uint32_t c : cells_around(mesh, static_cast<std::uint32_t>(v), cell_of[v])) {
            outline.insert(outline.end(), {x(corners[c]), y(corners[c])});
            out_radius = std::max(
                out_radius, std::hypot(corners[c].x - vertex.coordinates[0], corners[c].y - vertex.coordinates[1]));
        }
        if (!outline.empty()) svg.polygon(outline, fineness_colour(out_radius / feature_size(inputs, vertex)));
    }
    std::uint64_t strokes = 0;
    for (std::uint64_t c = 0; c < mesh.cell_count; c++) {
        const netmesh_cell cell = mesh.cell(c);
        for (int i = 0; i < 3; i++) {
            const std::uint32_t other = cell.neighbours[i];
            if (other == NETMESH_NONE || other < c) continue;
            if (strokes > 0 && strokes % 500 == 0) svg.end_path("#4d6076", stroke);
            if (strokes++ % 500 == 0) svg.begin_path();
            svg.move_to(x(corners[c]), y(corners[c]));
            svg.draw_to(x(corners[other]), y(corners[other]));
        }
    }
    if (strokes > 0) svg.end_path("#4d6076", stroke);
    return coloured;
}

void draw_circles(const MeshSource& mesh, const View& view, Svg& svg) {
    if (mesh.domain[2] > 0) {
        netmesh_vertex centre = {};
        centre.coordinates[0] = mesh.domain[0];
        centre.coordinates[1] = mesh.domain[1];
        svg.ring(view.x(centre), view.y(centre), mesh.domain[2] * view.scale, domain_colour, 1.5, "7 5");
    }
    for (const netmesh_cage& cage : mesh.cages) {
        const netmesh_vertex centre = mesh.vertex(cage.centre);
        if (cage.radius * view.scale < 0.5) continue;
        svg.ring(view.x(centre), view.y(centre), cage.radius * view.scale, cage_colour, 1.2);
        svg.ring(view.x(centre), view.y(centre), cage.radius / 2 * view.scale, cage_colour, 1, "3 4");
    }
}

}  // namespace

void write_mesh_picture(const MeshSource& mesh, bool voronoi, TextWriter& out) {
    if (mesh.dim == 3) {
        write_cut_picture(mesh, out);
        return;
    }
    const MeshCounts counts = counts_of(mesh);
    Legend legend(page_size - 2 * page_margin, 14);
    add_vertices(counts, &legend);
    add_cells(mesh, counts, voronoi, &legend);
    const std::string title = mesh_title(mesh, counts);
    Svg svg(out, page_size, page_size + legend.height() + page_margin / 2, title, mesh_description(mesh, counts));
    const View view = view_of(mesh);
    // Strokes and dots shrink as cells do, as far as they are seen.
    const double cell_size = (page_size - 2 * page_margin) / std::sqrt(static_cast<double>(mesh.vertex_count) + 1);
    const double dot = std::clamp(0.11 * cell_size, 0.5, 4.5);
    svg.begin_clip(page_margin / 2, page_margin / 2, page_size - page_margin, page_size - page_margin);
    const double stroke = std::clamp(0.035 * cell_size, 0.3, 1.1);
    if (voronoi) {
        draw_voronoi(mesh, view, stroke, svg);
    } else {
        draw_edges(mesh, view, true, "#b4bcc4", stroke, svg);
        draw_edges(mesh, view, false, "#76828e", stroke, svg);
    }
    draw_circles(mesh, view, svg);
    draw_vertices(mesh, view, 2, 0.6 * dot, svg);
    draw_vertices(mesh, view, 1, 0.6 * dot, svg);
    draw_vertices(mesh, view, 0, std::max(dot, 1.4), svg);
    svg.end_group();
    legend.draw(svg, page_margin, page_size - 4);
    svg.finish();
}

}  // namespace netmesh::tool
