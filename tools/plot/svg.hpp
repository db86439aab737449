// Drawing by SVG elements. Pixels, y downwards; numbers are written with two decimals.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/io/text_writer.hpp"

namespace netmesh::tool {

constexpr double page_size = 1000, page_margin = 40;  // of pictures of meshes and cycles

// Shapes of dots, the same share of a page each.
enum class Mark : std::uint8_t { disc, square, diamond, triangle, cross, star };

// Colours of degrees 0, 1, 2, .. on white, told apart in each kind of colour blindness too
// (tests/tools/parts/plot.cpp), and their dots.
const char* degree_colour(std::uint32_t degree);
Mark degree_mark(std::uint32_t degree);
constexpr const char* doubt_fill = "#fbf0d0";  // what may be an artefact
constexpr const char* doubt_line = "#a97c00";
constexpr const char* input_colour = "#1f2d4a";     // input points of a mesh, discs
constexpr const char* steiner_colour = "#d5590e";   // Steiner points, squares
constexpr const char* boundary_colour = "#9180be";  // vertices of the boundary net, triangles
constexpr const char* domain_colour = "#1aa77d";    // the domain's circle, and inner circles of cages
constexpr const char* cage_colour = "#c21dff";      // outer circles of cages
constexpr const char* ink = "#22262b";              // text and axes
constexpr const char* faint_ink = "#5b626a";        // lesser text
constexpr const char* rule = "#e3e6e9";             // grid

enum class Anchor { start, middle, end };

class Svg {
public:
    // Title and description are what a screen reader says.
    Svg(TextWriter& out, double width, double height, std::string_view title, std::string_view description);
    // Ends the document; nothing may be drawn afterwards.
    void finish();

    void line(double x0, double y0, double x1, double y1, const char* colour, double width, const char* dash = nullptr);
    void rect(double x, double y, double width, double height, const char* fill);
    void frame(double x, double y, double width, double height, const char* colour);
    void circle(double x, double y, double radius, const char* fill, double opacity = 1);
    // A dot of the size of a circle of that radius.
    void mark(Mark mark, double x, double y, double radius, const char* fill, double opacity = 1);
    void ring(double x, double y, double radius, const char* colour, double width, const char* dash = nullptr);
    // A closed polygon from points (x, y), (x, y), ..
    void polygon(const double* points, int count, const char* fill, double opacity = 1);
    void polygon(const std::vector<double>& points, const char* fill, double opacity = 1) {
        polygon(points.data(), static_cast<int>(points.size() / 2), fill, opacity);
    }
    void outlined_polygon(const double* points, int count, const char* fill, const char* colour, double width);
    void text(double x, double y, std::string_view content, double size, const char* colour, Anchor anchor,
              bool bold = false);
    // Text that runs upwards.
    void upright_text(double x, double y, std::string_view content, double size, const char* colour);

    // A path of many strokes: begin, move/draw .., end.
    void begin_path();
    void move_to(double x, double y);
    void draw_to(double x, double y);
    void end_path(const char* colour, double width, double opacity = 1);

    // What is drawn until end_group() is cut off outside the rectangle.
    void begin_clip(double x, double y, double width, double height);
    void end_group();

private:
    void corners(const double* points, int count);
    void number(double value);
    void attribute(const char* name, double value);
    void escaped(std::string_view content);
    TextWriter& out_;
    int clips_ = 0;
};

}  // namespace netmesh::tool
