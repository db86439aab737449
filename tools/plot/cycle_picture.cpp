#include <algorithm>
#include <cmath>
#include <map>

#include "tools/io/numbers.hpp"
#include "tools/plot/apart.hpp"
#include "tools/plot/barcode.hpp"
#include "tools/plot/plots.hpp"
#include "tools/plot/solid.hpp"
#include "tools/plot/tight_cycle.hpp"

namespace netmesh::tool {

namespace {

// A colour for each cycle, those of degrees, which are told apart with colour blindness, too; the longest bar's first.
// What has no colour is not drawn.
constexpr std::size_t cycles_most = 6;
const char* cycle_colour(std::size_t i) { return degree_colour(static_cast<std::uint32_t>((i + 1) % cycles_most)); }

// Cycles are pulled tight among edges of balls that meet at this multiple of the birth: holes that are noise are filled
// by then, and edges still short beside the hole.
constexpr double pull_ratio = 1.6;

struct Choice {
    std::vector<const CycleEntry*> cycles;               // by degree, the longest first
    std::map<std::uint32_t, std::size_t> left_out = {};  // bars of a degree that have a cycle, too
};

// From degree 1 on all that the user has chosen, else those that stand apart by their length, at least one of a
// degree; of degree 0 a cycle is but a point or two.
Choice choose_cycles(const std::vector<CycleEntry>& cycles, bool are_chosen) {
    std::vector<const CycleEntry*> order;
    for (const CycleEntry& cycle : cycles)
        if (cycle.bar.degree > 0 && !cycle.simplices.empty()) order.push_back(&cycle);
    std::stable_sort(order.begin(), order.end(), [](const CycleEntry* a, const CycleEntry* b) {
        return a->bar.degree != b->bar.degree ? a->bar.degree < b->bar.degree : length_of(a->bar) > length_of(b->bar);
    });
    Choice choice;
    for (std::size_t first = 0, last; first < order.size(); first = last) {
        const std::uint32_t degree = order[first]->bar.degree;
        std::vector<double> lengths;
        for (last = first; last < order.size() && order[last]->bar.degree == degree; last++)
            lengths.push_back(length_of(order[last]->bar));
        const std::size_t wanted = are_chosen ? lengths.size() : std::max<std::size_t>(count_apart(lengths), 1);
        const std::size_t taken = std::min(wanted, cycles_most - choice.cycles.size());
        choice.cycles.insert(choice.cycles.end(), order.begin() + static_cast<std::ptrdiff_t>(first),
                             order.begin() + static_cast<std::ptrdiff_t>(first + taken));
        if (taken < lengths.size()) choice.left_out[degree] = lengths.size() - taken;
    }
    return choice;
}

std::string left_out_text(const Choice& choice) {
    std::string text;
    for (const auto& [degree, count] : choice.left_out)
        text += (text.empty() ? "not drawn: " : ", ") + counted_text(count, "shorter bar") + " of " +
                homology_label(degree);
    return text;
}

// A point, an edge or a triangle of a cycle.
struct Piece {
    std::vector<Vec3> corners;
    double depth;
    const char* colour;
};

void draw_piece(const Piece& piece, const Projection& projection, double middle, Svg& svg) {
    std::vector<double> points;
    for (const Vec3& corner : piece.corners) points.insert(points.end(), {projection.x(corner), projection.y(corner)});
    if (piece.corners.size() == 1) {
        const double size = piece.depth >= middle ? 3 : 2.2;
        svg.circle(points[0], points[1], size, input_colour, piece.depth >= middle ? 0.8 : 0.35);
    } else if (piece.corners.size() == 2) {
        svg.begin_path();
        svg.move_to(points[0], points[1]);
        svg.draw_to(points[2], points[3]);
        svg.end_path(piece.colour, piece.depth >= middle ? 3.5 : 2.5);
    } else {
        for (std::size_t b = 1; b + 1 < piece.corners.size(); b++)
            svg.polygon({points[0], points[1], points[2 * b], points[2 * b + 1], points[2 * b + 2], points[2 * b + 3]},
                        piece.colour, 0.22);
    }
}

std::vector<Vec3> all_places(const CyclePlaces& places) {
    std::vector<Vec3> all;
    for (std::size_t i = 0; i < places.coordinates.size(); i += places.dim)
        all.push_back(
            {places.coordinates[i], places.coordinates[i + 1], places.dim > 2 ? places.coordinates[i + 2] : 0.0});
    return all;
}

}  // namespace

void write_cycle_picture(const std::vector<CycleEntry>& cycles, const CyclePlaces& places, TextWriter& out) {
    const std::vector<Vec3> all = all_places(places);
    const std::size_t inputs = places.inputs;
    const Choice choice = choose_cycles(cycles, places.all_chosen);
    const std::vector<const CycleEntry*>& chosen = choice.cycles;
    std::vector<Piece> pieces;
    Projection projection;
    std::vector<Vec3> seen(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(inputs));
    for (std::size_t i = chosen.size(); i-- > 0;) {  // the longest on top
        const Bar& bar = chosen[i]->bar;
        const double radius = std::min(pull_ratio * bar.birth, bar.death);
        for (const std::vector<std::uint32_t>& simplex : tightened(chosen[i]->simplices, radius, places)) {
            Piece piece{{}, 0, cycle_colour(i)};
            for (const std::uint32_t v : simplex) piece.corners.push_back(all[v]);
            seen.insert(seen.end(), piece.corners.begin(), piece.corners.end());
            pieces.push_back(piece);
        }
    }
    projection.fit(seen, page_margin, page_margin, page_size - 2 * page_margin, places.dim == 2);
    for (std::size_t i = 0; i < inputs; i++) pieces.push_back({{all[i]}, 0, input_colour});
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (Piece& piece : pieces) {
        for (const Vec3& corner : piece.corners)
            piece.depth += projection.depth(corner) / static_cast<double>(piece.corners.size());
        low = std::min(low, piece.depth);
        high = std::max(high, piece.depth);
    }
    if (places.dim > 2)
        std::stable_sort(pieces.begin(), pieces.end(),
                         [](const Piece& a, const Piece& b) { return a.depth < b.depth; });

    Legend legend(page_size - 2 * page_margin, 14);
    legend.add(
        12, [](Svg& svg, double x, double y) { svg.circle(x + 6, y, 4, input_colour, 0.8); },
        counted_text(inputs, "point"));
    for (std::size_t i = 0; i < chosen.size(); i++) {
        const Bar& bar = chosen[i]->bar;
        const std::uint32_t degree = bar.degree;
        const char* const colour = cycle_colour(i);
        legend.add(
            20,
            [degree, colour](Svg& svg, double x, double y) {
                if (degree == 1) svg.line(x, y, x + 20, y, colour, 3.5);
                if (degree > 1) svg.polygon({x, y - 6, x + 20, y - 6, x + 20, y + 6, x, y + 6}, colour, 0.4);
            },
            homology_label(degree) + ", from " + rounded_text(bar.birth, 4) + " to " +
                (std::isfinite(bar.death) ? rounded_text(bar.death, 4) : "\xE2\x88\x9E"));
    }
    const std::string left_out = left_out_text(choice);
    if (!left_out.empty())
        legend.add(
            0, [](Svg&, double, double) {}, left_out + "; --top N draws more");
    const std::string title = "Cycles of the longest bars of " + counted_text(inputs, "point");
    // The places are in the middle of a square, of which wide ones leave much.
    double top = page_size, bottom = 0;
    for (const Vec3& place : seen) {
        top = std::min(top, projection.y(place));
        bottom = std::max(bottom, projection.y(place));
    }
    if (seen.empty()) top = bottom = page_size / 2;
    const double shift = top - page_margin, height = bottom - top + 2 * page_margin;
    projection.bottom -= shift;
    Svg svg(out, page_size, height + legend.height() + page_margin / 2, title,
            counted_text(chosen.size(), "cycle") + " among the points" +
                (places.dim > 2 ? ", in parallel projection; what is nearer is darker." : ".") +
                (left_out.empty() ? "" : " " + left_out + "."));
    const double middle = places.dim > 2 ? 0.5 * low + 0.5 * high : -HUGE_VAL;
    for (const Piece& piece : pieces) draw_piece(piece, projection, middle, svg);
    legend.draw(svg, page_margin, height - 4);
    svg.finish();
}

}  // namespace netmesh::tool
