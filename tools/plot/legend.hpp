// What stands around a picture: lines of a heading, the legend, labels of axes.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tools/plot/svg.hpp"

namespace netmesh::tool {

// Entries one behind the other, in as many lines as they need.
class Legend {
public:
    // Draws a symbol whose left end is at x and whose middle is at y.
    using Symbol = std::function<void(Svg& svg, double x, double y)>;
    explicit Legend(double width, double size = 12) : width_(width), size_(size) {}
    void add(double symbol_width, Symbol symbol, const std::string& text);
    double height() const;
    // The first line's top is at y.
    void draw(Svg& svg, double x, double y) const;

private:
    struct Item {
        double symbol_width;
        Symbol symbol;
        std::vector<std::string> lines;
        double x, y, height;
    };
    double width_, size_;
    std::vector<Item> items_;
};

// Lines below one another, each text broken to fit: the heading of a picture.
class Heading {
public:
    explicit Heading(double width) : width_(width) {}
    void add(const std::string& text, double size, const char* colour, bool bold = false);
    double height() const { return height_; }
    void draw(Svg& svg, double x, double y) const;

private:
    struct Line {
        std::string text;
        double size, base;
        const char* colour;
        bool bold;
    };
    double width_, height_ = 0;
    std::vector<Line> lines_;
};

// Labels along a line that leave out what would touch the one before.
class LabelRow {
public:
    // Is there room between `low` and `high`, with a little air? Then it is taken.
    bool take(double low, double high);

private:
    std::vector<std::pair<double, double>> taken_;
};

}  // namespace netmesh::tool
