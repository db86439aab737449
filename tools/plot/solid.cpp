#include "tools/plot/solid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "tools/plot/mesh_legend.hpp"

namespace netmesh::tool {

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

namespace {

Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

Projection::Projection() {
    constexpr double azimuth = -0.9, elevation = 0.5;
    towards = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
    right = {-std::sin(azimuth), std::cos(azimuth), 0};
    up = cross(towards, right);
}

void Projection::fit(const std::vector<Vec3>& places, double x, double y, double side, bool is_plane) {
    if (is_plane) {
        right = {1, 0, 0};
        up = {0, 1, 0};
        towards = {0, 0, 1};
    }
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (const Vec3& place : places) {
        const double at[2] = {dot(place, right), dot(place, up)};
        for (int k = 0; k < 2; k++) {
            low[k] = std::min(low[k], at[k]);
            high[k] = std::max(high[k], at[k]);
        }
    }
    if (places.empty()) low[0] = low[1] = high[0] = high[1] = 0;
    const double span = std::max(std::max(high[0] - low[0], high[1] - low[1]), 1e-300);
    low_x = 0.5 * low[0] + 0.5 * high[0] - span / 2;
    low_y = 0.5 * low[1] + 0.5 * high[1] - span / 2;
    scale = side / span;
    left = x;
    bottom = y + side;
}

double Projection::x(const Vec3& place) const { return left + (dot(place, right) - low_x) * scale; }
double Projection::y(const Vec3& place) const { return bottom - (dot(place, up) - low_y) * scale; }
double Projection::depth(const Vec3& place) const { return dot(place, towards); }

namespace {

Vec3 place_of(const netmesh_vertex& vertex) {
    return {vertex.coordinates[0], vertex.coordinates[1], vertex.coordinates[2]};
}

struct Face {
    Vec3 corners[3];
    std::uint32_t vertices[3];
    double depth, light;
    bool at_input;
};

// Cells that are drawn: inside of the domain, and behind the plane.
std::vector<char> kept_cells(const MeshSource& mesh, const Vec3& middle, const Vec3& normal) {
    std::vector<char> kept(mesh.cell_count);
    for (std::uint64_t c = 0; c < mesh.cell_count; c++) {
        const netmesh_cell cell = mesh.cell(c);
        Vec3 centre = {0, 0, 0};
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < 3; k++) centre[k] += mesh.vertex(cell.vertices[i]).coordinates[k] / 4;
        const Vec3 from_middle = minus(centre, middle);
        const double radius = mesh.domain[3];
        const bool inside = radius == 0 || dot(from_middle, from_middle) <= radius * radius;
        kept[c] = inside && dot(from_middle, normal) <= 0;
    }
    return kept;
}

// Faces of the drawn cells that nothing drawn covers, those that are turned to the viewer.
std::vector<Face> faces_of(const MeshSource& mesh, const std::vector<char>& kept, const Projection& projection) {
    static constexpr int corners[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
    std::vector<Face> faces;
    for (std::uint64_t c = 0; c < mesh.cell_count; c++) {
        if (!kept[c]) continue;
        const netmesh_cell cell = mesh.cell(c);
        for (int i = 0; i < 4; i++) {
            const std::uint32_t other = cell.neighbours[i];
            if (other != NETMESH_NONE && kept[other]) continue;
            Face face{{}, {}, 0, 0, false};
            for (int k = 0; k < 3; k++) {
                const netmesh_vertex vertex = mesh.vertex(cell.vertices[corners[i][k]]);
                face.vertices[k] = cell.vertices[corners[i][k]];
                face.corners[k] = place_of(vertex);
                face.at_input = face.at_input || vertex.marker == 0;
                face.depth += projection.depth(face.corners[k]) / 3;
            }
            Vec3 normal = cross(minus(face.corners[1], face.corners[0]), minus(face.corners[2], face.corners[0]));
            const Vec3 inwards = minus(place_of(mesh.vertex(cell.vertices[i])), face.corners[0]);
            if (dot(normal, inwards) > 0) normal = {-normal[0], -normal[1], -normal[2]};
            const double length = std::sqrt(dot(normal, normal));
            const double facing = dot(normal, projection.towards);
            if (!(facing > 0) || !(length > 0)) continue;
            face.light = std::clamp(0.55 + 0.45 * facing / length, 0.0, 1.0);
            faces.push_back(face);
        }
    }
    std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.depth < b.depth; });
    return faces;
}

std::string shade(const int colour[3], double light) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<int>(colour[0] * light),
                  static_cast<int>(colour[1] * light), static_cast<int>(colour[2] * light));
    return text;
}

constexpr int at_input_rgb[3] = {244, 176, 120}, others_rgb[3] = {205, 222, 238};

}  // namespace

void write_cut_picture(const MeshSource& mesh, TextWriter& out) {
    Projection projection;
    Vec3 middle = {mesh.domain[0], mesh.domain[1], mesh.domain[2]};
    std::vector<Vec3> places;
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) places.push_back(place_of(mesh.vertex(i)));
    if (mesh.domain[3] == 0) {
        for (int k = 0; k < 3; k++) {
            double low = HUGE_VAL, high = -HUGE_VAL;
            for (const Vec3& place : places) {
                low = std::min(low, place[k]);
                high = std::max(high, place[k]);
            }
            middle[k] = places.empty() ? 0 : 0.5 * low + 0.5 * high;
        }
    }
    // The plane is turned a little away from the viewer, so that the sides are seen as well.
    Vec3 normal = projection.towards;
    for (int k = 0; k < 3; k++) normal[k] = 0.87 * projection.towards[k] + 0.45 * projection.right[k];
    const std::vector<char> kept = kept_cells(mesh, middle, normal);
    const std::vector<Face> faces = faces_of(mesh, kept, projection);
    std::vector<Vec3> seen;
    for (const Face& face : faces) seen.insert(seen.end(), face.corners, face.corners + 3);
    projection.fit(seen, page_margin, page_margin, page_size - 2 * page_margin, false);

    const MeshCounts counts = counts_of(mesh);
    Legend legend(page_size - 2 * page_margin, 14);
    const auto swatch = [](const int* colour) {
        return [colour](Svg& svg, double x, double y) {
            svg.polygon({x, y - 7, x + 20, y - 7, x + 20, y + 7, x, y + 7}, shade(colour, 1).c_str());
        };
    };
    MeshCounts inputs;
    inputs.markers[0] = counts.markers[0];
    add_vertices(inputs, &legend);
    const bool others = std::any_of(faces.begin(), faces.end(), [](const Face& face) { return !face.at_input; });
    legend.add(20, swatch(at_input_rgb), "triangles at an input, of a cut through " + cells_text(mesh));
    if (others) legend.add(20, swatch(others_rgb), "other triangles");
    Svg svg(out, page_size, page_size + legend.height() + page_margin / 2, mesh_title(mesh, counts),
            "A cut through the middle, in parallel projection. " + mesh_description(mesh, counts));
    const double stroke = std::clamp(24 / std::sqrt(static_cast<double>(faces.size()) + 1), 0.25, 1.0);
    // An input's dot comes behind the last of its faces, so that what is nearer covers it.
    std::vector<std::size_t> last_face(mesh.vertex_count, faces.size());
    for (std::size_t f = 0; f < faces.size(); f++)
        for (const std::uint32_t v : faces[f].vertices) last_face[v] = f;
    for (std::size_t f = 0; f < faces.size(); f++) {
        const Face& face = faces[f];
        double points[6];
        for (int k = 0; k < 3; k++) {
            points[2 * k] = projection.x(face.corners[k]);
            points[2 * k + 1] = projection.y(face.corners[k]);
        }
        svg.outlined_polygon(points, 3, shade(face.at_input ? at_input_rgb : others_rgb, face.light).c_str(), "#4d6076",
                             stroke);
        for (int k = 0; k < 3; k++) {
            if (last_face[face.vertices[k]] != f || mesh.vertex(face.vertices[k]).marker != 0) continue;
            svg.circle(points[2 * k], points[2 * k + 1], std::clamp(6 * stroke, 1.2, 4.0), input_colour);
        }
    }
    legend.draw(svg, page_margin, page_size - 4);
    svg.finish();
}

}  // namespace netmesh::tool
