// Drawing by SVG elements. Pixels, y downwards; numbers are written with two decimals.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "tools/io/text_writer.hpp"

namespace netmesh::tool {

// Colours of degrees 0, 1, 2, ..: told apart by most eyes, and in grey.
const char* degree_colour(std::uint32_t degree);
constexpr const char* ink = "#22262b";        // text and axes
constexpr const char* faint_ink = "#6b727a";  // lesser text
constexpr const char* rule = "#e3e6e9";       // grid

enum class Anchor { start, middle, end };

class Svg {
public:
    Svg(TextWriter& out, double width, double height);
    // Ends the document; nothing may be drawn afterwards.
    void finish();

    void line(double x0, double y0, double x1, double y1, const char* colour, double width, const char* dash = nullptr);
    void rect(double x, double y, double width, double height, const char* fill);
    void frame(double x, double y, double width, double height, const char* colour);
    void circle(double x, double y, double radius, const char* fill, double opacity = 1);
    void ring(double x, double y, double radius, const char* colour, double width, const char* dash = nullptr);
    // A closed polygon from points (x, y), (x, y), ..
    void polygon(const double* points, int count, const char* fill, double opacity = 1);
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
    void number(double value);
    void attribute(const char* name, double value);
    void escaped(std::string_view content);
    TextWriter& out_;
    int clips_ = 0;
};

}  // namespace netmesh::tool
