#include "tools/opinion/delaunay_check.hpp"

#include <algorithm>

#include "tools/opinion/filtered_complex.hpp"

namespace netmesh::tool {

namespace {

// A face of one dimension less, what it is of, and the vertex that is left out.
struct Side {
    Vertices vertices;
    std::uint32_t of, other;
};

void add_sides(const Vertices& simplex, std::uint32_t number, std::vector<Side>* sides) {
    for (std::size_t i = 0; i < simplex.size(); i++) {
        Vertices rest = simplex;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        sides->push_back({std::move(rest), number, simplex[i]});
    }
}

// Sorts the sides and calls f(first, last) for those of the same vertices; the first complaint of f ends it.
template <class F> std::string for_each_group(std::vector<Side>& sides, F f) {
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.vertices < b.vertices; });
    std::string complaint;
    for (std::size_t first = 0, last; first < sides.size() && complaint.empty(); first = last) {
        for (last = first + 1; last < sides.size() && sides[last].vertices == sides[first].vertices;) last++;
        complaint = f(first, last);
    }
    return complaint;
}

class DelaunayCheck {
public:
    DelaunayCheck(const std::vector<ExactPlace>& points, const CellTable& cells) : points_(points) {
        for (std::size_t c = 0; c < cells.lines.size(); c++) {
            const auto first = cells.entries.begin() + static_cast<std::ptrdiff_t>(c * cells.columns);
            cells_.emplace_back(first, first + cells.columns);
            std::sort(cells_.back().begin(), cells_.back().end());
        }
    }
    std::string complaint() {
        if (cells_.empty()) return "there are no cells";
        std::string what = look_at_cells();
        if (what.empty()) what = look_at_facets();
        if (what.empty()) what = look_from_inside();
        return what.empty() ? look_at_ridges() : what;
    }

private:
    std::vector<const ExactPlace*> places_of(const Vertices& vertices) const {
        std::vector<const ExactPlace*> places;
        for (const std::uint32_t v : vertices) places.push_back(&points_[v]);
        return places;
    }
    // Of a facet with one more point.
    int side(const Vertices& facet, const ExactPlace& place) const {
        std::vector<const ExactPlace*> places = places_of(facet);
        places.push_back(&place);
        return orientation(places);
    }
    static std::string text_of(const char* what, const Vertices& vertices) {
        std::string text = what;
        for (const std::uint32_t v : vertices) text += " " + std::to_string(v);
        return text;
    }

    std::string look_at_cells() const {
        std::vector<bool> used(points_.size());
        for (const Vertices& cell : cells_) {
            for (const std::uint32_t v : cell) used[v] = true;
            if (orientation(places_of(cell)) == 0) return text_of("flat is the cell", cell);
        }
        const auto unused = std::find(used.begin(), used.end(), false);
        return unused == used.end() ? "" : "no cell has the vertex " + std::to_string(unused - used.begin());
    }

    std::string look_at_facets() {
        std::vector<Side> sides;
        for (std::uint32_t c = 0; c < cells_.size(); c++) add_sides(cells_[c], c, &sides);
        return for_each_group(sides, [&](std::size_t first, std::size_t last) -> std::string {
            const Vertices& facet = sides[first].vertices;
            if (last == first + 1) hull_.push_back(sides[first]);
            if (last == first + 1) return "";
            const Side &a = sides[first], &b = sides[first + 1];
            if (last > first + 2 || side(facet, points_[a.other]) != -side(facet, points_[b.other]))
                return text_of("overlapping cells have the facet", facet);
            if (ExactSphere(places_of(cells_[a.of])).side(points_[b.other]) < 0)
                return "vertex " + std::to_string(b.other) + text_of(" is inside the sphere of the cell", cells_[a.of]);
            return "";
        });
    }

    std::string look_from_inside() const {
        // Half of the first vertex, a quarter of the next one, and so on, and of the last one what is missing to 1.
        const Vertices& home = cells_[0];
        ExactPlace inside(points_[0].size());
        for (std::size_t i = 0; i < home.size(); i++) {
            const Exact share = Exact::power(-static_cast<int>(std::min(i + 1, home.size() - 1)));
            for (std::size_t k = 0; k < inside.size(); k++) inside[k] = inside[k] + share * points_[home[i]][k];
        }
        for (const Side& facet : hull_)
            if (side(facet.vertices, inside) != side(facet.vertices, points_[facet.other]))
                return text_of("not convex at the facet", facet.vertices);
        for (std::size_t c = 1; c < cells_.size(); c++) {
            std::vector<const ExactPlace*> places = places_of(cells_[c]);
            const int own = orientation(places);
            bool is_out = false;
            for (const ExactPlace*& place : places) {
                const ExactPlace* const vertex = place;
                place = &inside;
                is_out = is_out || orientation(places) == -own;
                place = vertex;
                if (is_out) break;
            }
            if (!is_out) return text_of("another cell is overlapped by the cell", cells_[c]);
        }
        return "";
    }

    std::string look_at_ridges() const {
        std::vector<Side> ridges;
        for (std::uint32_t f = 0; f < hull_.size(); f++) add_sides(hull_[f].vertices, f, &ridges);
        return for_each_group(ridges, [&](std::size_t first, std::size_t last) -> std::string {
            const Side &a = ridges[first], &b = ridges[first == ridges.size() - 1 ? first : first + 1];
            if (last != first + 2) return text_of("an open or branching boundary at the ridge", a.vertices);
            const Side& facet = hull_[a.of];
            if (side(facet.vertices, points_[b.other]) == -side(facet.vertices, points_[facet.other]))
                return text_of("not convex at the ridge", a.vertices);
            return "";
        });
    }

    const std::vector<ExactPlace>& points_;
    std::vector<Vertices> cells_;
    std::vector<Side> hull_;  // facets of one cell
};

}  // namespace

std::string delaunay_complaint(const std::vector<ExactPlace>& points, const CellTable& cells) {
    return DelaunayCheck(points, cells).complaint();
}

}  // namespace netmesh::tool
