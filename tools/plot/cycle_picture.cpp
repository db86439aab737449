#include <algorithm>
#include <cmath>

#include "tools/io/numbers.hpp"
#include "tools/plot/barcode.hpp"
#include "tools/plot/plots.hpp"
#include "tools/plot/solid.hpp"

namespace netmesh::tool {

namespace {

constexpr double page_size = 1000, margin = 40;
constexpr std::size_t cycles_most = 3;  // shown of one degree, of those at least half as long as the longest

double length_of(const Bar& bar) { return std::isfinite(bar.death) ? bar.death - bar.birth : HUGE_VAL; }

// The longest of each degree from 1 on, the shorter first; of degree 0 a cycle is but a point or two.
std::vector<const CycleEntry*> chosen_cycles(const std::vector<CycleEntry>& cycles) {
    std::vector<const CycleEntry*> order, chosen;
    for (const CycleEntry& cycle : cycles)
        if (cycle.bar.degree > 0 && !cycle.simplices.empty()) order.push_back(&cycle);
    std::stable_sort(order.begin(), order.end(), [](const CycleEntry* a, const CycleEntry* b) {
        return a->bar.degree != b->bar.degree ? a->bar.degree < b->bar.degree : length_of(a->bar) > length_of(b->bar);
    });
    std::size_t of_degree = 0;
    double longest = 0;
    for (std::size_t i = 0; i < order.size(); i++) {
        const bool first = i == 0 || order[i - 1]->bar.degree != order[i]->bar.degree;
        if (first) of_degree = 0;
        if (first) longest = length_of(order[i]->bar);
        if (of_degree++ < cycles_most && length_of(order[i]->bar) >= longest / 2) chosen.push_back(order[i]);
    }
    std::reverse(chosen.begin(), chosen.end());
    return chosen;
}

// A point, an edge or a triangle of a cycle.
struct Piece {
    std::vector<Vec3> corners;
    double depth;
    std::uint32_t degree;
};

void draw_piece(const Piece& piece, const Projection& projection, double middle, Svg& svg) {
    std::vector<double> points;
    for (const Vec3& corner : piece.corners) points.insert(points.end(), {projection.x(corner), projection.y(corner)});
    const char* const colour = degree_colour(piece.degree);
    if (piece.corners.size() == 1) {
        const double size = piece.depth >= middle ? 3 : 2.2;
        svg.circle(points[0], points[1], size, input_colour, piece.depth >= middle ? 0.8 : 0.35);
    } else if (piece.corners.size() == 2) {
        svg.begin_path();
        svg.move_to(points[0], points[1]);
        svg.draw_to(points[2], points[3]);
        svg.end_path(colour, piece.depth >= middle ? 3.5 : 2.5);
    } else {
        for (std::size_t b = 1; b + 1 < piece.corners.size(); b++)
            svg.polygon({points[0], points[1], points[2 * b], points[2 * b + 1], points[2 * b + 2], points[2 * b + 3]},
                        colour, 0.22);
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
    const std::vector<const CycleEntry*> chosen = chosen_cycles(cycles);
    std::vector<Piece> pieces;
    Projection projection;
    std::vector<Vec3> seen(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(inputs));
    for (const CycleEntry* cycle : chosen) {
        for (const std::vector<std::uint32_t>& simplex : cycle->simplices) {
            Piece piece{{}, 0, cycle->bar.degree};
            for (const std::uint32_t v : simplex) piece.corners.push_back(all[v]);
            seen.insert(seen.end(), piece.corners.begin(), piece.corners.end());
            pieces.push_back(piece);
        }
    }
    projection.fit(seen, margin, margin, page_size - 2 * margin, places.dim == 2);
    for (std::size_t i = 0; i < inputs; i++) pieces.push_back({{all[i]}, 0, 0});
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

    Legend legend(page_size - 2 * margin, 14);
    legend.add(
        12, [](Svg& svg, double x, double y) { svg.circle(x + 6, y, 4, input_colour, 0.8); },
        counted_text(inputs, "point"));
    for (std::size_t i = chosen.size(); i-- > 0;) {
        const Bar& bar = chosen[i]->bar;
        const std::uint32_t degree = bar.degree;
        legend.add(
            20,
            [degree](Svg& svg, double x, double y) {
                if (degree == 1) svg.line(x, y, x + 20, y, degree_colour(degree), 3.5);
                if (degree > 1)
                    svg.polygon({x, y - 6, x + 20, y - 6, x + 20, y + 6, x, y + 6}, degree_colour(degree), 0.4);
            },
            homology_label(degree) + ", from " + rounded_text(bar.birth, 4) + " to " +
                (std::isfinite(bar.death) ? rounded_text(bar.death, 4) : "\xE2\x88\x9E"));
    }
    const std::string title = "Cycles of the longest bars of " + counted_text(inputs, "point");
    Svg svg(out, page_size, page_size + legend.height() + margin / 2, title,
            counted_text(chosen.size(), "cycle") + " among the points" +
                (places.dim > 2 ? ", in parallel projection; what is nearer is darker." : "."));
    const double middle = places.dim > 2 ? 0.5 * low + 0.5 * high : -HUGE_VAL;
    for (const Piece& piece : pieces) draw_piece(piece, projection, middle, svg);
    legend.draw(svg, margin, page_size - 4);
    svg.finish();
}

}  // namespace netmesh::tool
