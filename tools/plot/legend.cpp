#include "tools/plot/legend.hpp"

#include <algorithm>

#include "tools/plot/text_width.hpp"

namespace netmesh::tool {

namespace {

constexpr double symbol_gap = 8, item_gap = 26, line_factor = 1.5;

}  // namespace

void Legend::add(double symbol_width, Symbol symbol, const std::string& text) {
    const double line = line_factor * size_;
    Item item{symbol_width, std::move(symbol), {}, 0, 0, 0};
    item.lines = wrapped_text(text, size_, false, width_ - symbol_width - symbol_gap);
    item.height = line * static_cast<double>(item.lines.size());
    if (!items_.empty()) {
        const Item& last = items_.back();
        const bool one_line = last.lines.size() == 1 && item.lines.size() == 1;
        const double x = last.x + last.symbol_width + symbol_gap + text_width(last.lines[0], size_) + item_gap;
        const double needs = symbol_width + symbol_gap + text_width(item.lines[0], size_);
        const bool beside = one_line && x + needs <= width_;
        item.x = beside ? x : 0;
        item.y = beside ? last.y : last.y + last.height;
    }
    items_.push_back(std::move(item));
}

double Legend::height() const { return items_.empty() ? 0 : items_.back().y + items_.back().height; }

void Legend::draw(Svg& svg, double x, double y) const {
    const double line = line_factor * size_;
    for (const Item& item : items_) {
        const double middle = y + item.y + line / 2;
        item.symbol(svg, x + item.x, middle);
        for (std::size_t i = 0; i < item.lines.size(); i++) {
            const double base = middle + 0.36 * size_ + line * static_cast<double>(i);
            svg.text(x + item.x + item.symbol_width + symbol_gap, base, item.lines[i], size_, ink, Anchor::start);
        }
    }
}

void Heading::add(const std::string& text, double size, const char* colour, bool bold) {
    for (const std::string& line : wrapped_text(text, size, bold, width_)) {
        height_ += 1.5 * size;
        lines_.push_back({line, size, height_ - 0.4 * size, colour, bold});
    }
}

void Heading::draw(Svg& svg, double x, double y) const {
    for (const Line& line : lines_)
        svg.text(x, y + line.base, line.text, line.size, line.colour, Anchor::start, line.bold);
}

bool LabelRow::take(double low, double high) {
    constexpr double air = 6;
    for (const auto& [from, to] : taken_)
        if (low < to + air && high > from - air) return false;
    taken_.emplace_back(low, high);
    return true;
}

}  // namespace netmesh::tool
