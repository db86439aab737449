#include "tools/plot/svg.hpp"

#include <cmath>
#include <cstdio>

namespace netmesh::tool {

const char* degree_colour(std::uint32_t degree) {
    static constexpr const char* colours[] = {"#1f2d4a", "#d5590e", "#1aa77d", "#c21dff", "#592710", "#9180be"};
    return colours[degree % 6];
}

Mark degree_mark(std::uint32_t degree) { return static_cast<Mark>(degree % 6); }

Svg::Svg(TextWriter& out, double width, double height, std::string_view title, std::string_view description)
    : out_(out) {
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"title description\"";
    attribute("width", width);
    attribute("height", height);
    out_ << " viewBox=\"0 0 ";
    number(width);
    out_ << ' ';
    number(height);
    out_ << "\" font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\">\n<title id=\"title\">";
    escaped(title);
    out_ << "</title>\n<desc id=\"description\">";
    escaped(description);
    out_ << "</desc>\n";
    rect(0, 0, width, height, "#ffffff");
}

void Svg::finish() { out_ << "</svg>\n"; }

void Svg::number(double value) {
    char text[40];
    int length = std::snprintf(text, sizeof text, "%.2f", value + 0.0);
    while (length > 1 && text[length - 1] == '0') length--;
    if (text[length - 1] == '.') length--;
    const std::string_view digits(text, static_cast<std::size_t>(length));
    out_ << (digits == "-0" ? std::string_view("0") : digits);
}

void Svg::attribute(const char* name, double value) {
    out_ << ' ' << std::string_view(name) << "=\"";
    number(value);
    out_ << '"';
}

void Svg::escaped(std::string_view content) {
    for (const char c : content) {
        if (c == '<') {
            out_ << "&lt;";
        } else if (c == '>') {
            out_ << "&gt;";
        } else if (c == '&') {
            out_ << "&amp;";
        } else {
            out_ << c;
        }
    }
}

void Svg::line(double x0, double y0, double x1, double y1, const char* colour, double width, const char* dash) {
    out_ << "<line";
    attribute("x1", x0);
    attribute("y1", y0);
    attribute("x2", x1);
    attribute("y2", y1);
    attribute("stroke-width", width);
    if (dash != nullptr) out_ << " stroke-dasharray=\"" << std::string_view(dash) << '"';
    out_ << " stroke=\"" << std::string_view(colour) << "\"/>\n";
}

void Svg::rect(double x, double y, double width, double height, const char* fill) {
    out_ << "<rect";
    attribute("x", x);
    attribute("y", y);
    attribute("width", width);
    attribute("height", height);
    out_ << " fill=\"" << std::string_view(fill) << "\"/>\n";
}

void Svg::frame(double x, double y, double width, double height, const char* colour) {
    out_ << "<rect";
    attribute("x", x);
    attribute("y", y);
    attribute("width", width);
    attribute("height", height);
    out_ << " fill=\"none\" stroke=\"" << std::string_view(colour) << "\"/>\n";
}

void Svg::circle(double x, double y, double radius, const char* fill, double opacity) {
    out_ << "<circle";
    attribute("cx", x);
    attribute("cy", y);
    attribute("r", radius);
    if (opacity < 1) attribute("fill-opacity", opacity);
    out_ << " fill=\"" << std::string_view(fill) << "\"/>\n";
}

void Svg::mark(Mark mark, double x, double y, double radius, const char* fill, double opacity) {
    // Corners about (0, 0) of a shape whose area is about that of the circle of radius 1.
    static constexpr double square[] = {-0.9, -0.9, 0.9, -0.9, 0.9, 0.9, -0.9, 0.9};
    static constexpr double diamond[] = {0, -1.3, 1.3, 0, 0, 1.3, -1.3, 0};
    static constexpr double triangle[] = {0, -1.5, 1.3, 0.8, -1.3, 0.8};
    static constexpr double cross[] = {-0.5, -1.4, 0.5,  -1.4, 0.5,  -0.5, 1.4,  -0.5, 1.4,  0.5,  0.5,  0.5,
                                       0.5,  1.4,  -0.5, 1.4,  -0.5, 0.5,  -1.4, 0.5,  -1.4, -0.5, -0.5, -0.5};
    static constexpr double star[] = {0, -1.6, 0.45, -0.5, 1.5,  -0.5, 0.7,  0.25, 1,     1.4,
                                      0, 0.7,  -1,   1.4,  -0.7, 0.25, -1.5, -0.5, -0.45, -0.5};
    static constexpr struct {
        const double* corners;
        int count;
    } shapes[] = {{nullptr, 0}, {square, 4}, {diamond, 4}, {triangle, 3}, {cross, 12}, {star, 10}};
    const auto& shape = shapes[static_cast<int>(mark)];
    if (shape.count == 0) {
        circle(x, y, radius, fill, opacity);
        return;
    }
    double points[24];
    for (int i = 0; i < shape.count; i++) {
        points[2 * i] = x + radius * shape.corners[2 * i];
        points[2 * i + 1] = y + radius * shape.corners[2 * i + 1];
    }
    polygon(points, shape.count, fill, opacity);
}

void Svg::ring(double x, double y, double radius, const char* colour, double width, const char* dash) {
    out_ << "<circle";
    attribute("cx", x);
    attribute("cy", y);
    attribute("r", radius);
    attribute("stroke-width", width);
    if (dash != nullptr) out_ << " stroke-dasharray=\"" << std::string_view(dash) << '"';
    out_ << " fill=\"none\" stroke=\"" << std::string_view(colour) << "\"/>\n";
}

void Svg::corners(const double* points, int count) {
    out_ << "<polygon points=\"";
    for (int i = 0; i < count; i++) {
        if (i > 0) out_ << ' ';
        number(points[2 * i]);
        out_ << ',';
        number(points[2 * i + 1]);
    }
    out_ << '"';
}

void Svg::polygon(const double* points, int count, const char* fill, double opacity) {
    corners(points, count);
    if (opacity < 1) attribute("fill-opacity", opacity);
    out_ << " fill=\"" << std::string_view(fill) << "\"/>\n";
}

void Svg::outlined_polygon(const double* points, int count, const char* fill, const char* colour, double width) {
    corners(points, count);
    attribute("stroke-width", width);
    out_ << " fill=\"" << std::string_view(fill) << "\" stroke-linejoin=\"round\" stroke=\"" << std::string_view(colour)
         << "\"/>\n";
}

void Svg::text(double x, double y, std::string_view content, double size, const char* colour, Anchor anchor,
               bool bold) {
    static constexpr const char* anchors[] = {"start", "middle", "end"};
    out_ << "<text";
    attribute("x", x);
    attribute("y", y);
    attribute("font-size", size);
    if (anchor != Anchor::start)
        out_ << " text-anchor=\"" << std::string_view(anchors[static_cast<int>(anchor)]) << '"';
    if (bold) out_ << " font-weight=\"bold\"";
    out_ << " fill=\"" << std::string_view(colour) << "\">";
    escaped(content);
    out_ << "</text>\n";
}

void Svg::upright_text(double x, double y, std::string_view content, double size, const char* colour) {
    out_ << "<text transform=\"translate(";
    number(x);
    out_ << ' ';
    number(y);
    out_ << ") rotate(-90)\" text-anchor=\"middle\"";
    attribute("font-size", size);
    out_ << " fill=\"" << std::string_view(colour) << "\">";
    escaped(content);
    out_ << "</text>\n";
}

void Svg::begin_path() { out_ << "<path d=\""; }

void Svg::move_to(double x, double y) {
    out_ << 'M';
    number(x);
    out_ << ' ';
    number(y);
}

void Svg::draw_to(double x, double y) {
    out_ << 'L';
    number(x);
    out_ << ' ';
    number(y);
}

void Svg::end_path(const char* colour, double width, double opacity) {
    out_ << "\" fill=\"none\" stroke-linejoin=\"round\"";
    attribute("stroke-width", width);
    if (opacity < 1) attribute("stroke-opacity", opacity);
    out_ << " stroke=\"" << std::string_view(colour) << "\"/>\n";
}

void Svg::begin_clip(double x, double y, double width, double height) {
    const std::uint64_t id = static_cast<std::uint64_t>(clips_++);
    out_ << "<clipPath id=\"clip" << id << "\">";
    rect(x, y, width, height, "#ffffff");
    out_ << "</clipPath>\n<g clip-path=\"url(#clip" << id << ")\">\n";
}

void Svg::end_group() { out_ << "</g>\n"; }

}  // namespace netmesh::tool
