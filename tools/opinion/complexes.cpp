#include "tools/opinion/complexes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "tools/opinion/clipped_nerve.hpp"
#include "tools/opinion/spheres.hpp"

namespace netmesh::tool {

namespace {

// All faces of up to top + 1 vertices; false when there are too many.
bool faces_of(const CellTable& cells, std::uint32_t top, std::set<Vertices>* faces) {
    // A facet is of at most two cells.
    const std::size_t count = cells.lines.size(), facets = cells.columns * count / 2;
    const std::size_t least = top + 1 >= cells.columns ? facets + count : top + 2 == cells.columns ? facets : 0;
    if (least > opinion_simplices_max) return false;
    for (std::size_t c = 0; c < cells.lines.size(); c++) {
        for (std::uint32_t subset = 1; subset < (1u << cells.columns); subset++) {
            Vertices face;
            for (std::uint32_t i = 0; i < cells.columns; i++) {
                if ((subset >> i & 1) != 0) face.push_back(cells.entries[c * cells.columns + i]);
            }
            if (face.size() > top + 1) continue;
            std::sort(face.begin(), face.end());
            faces->insert(std::move(face));
        }
        if (faces->size() > opinion_simplices_max) return false;
    }
    return true;
}

// As files have it: the largest double stands for radii above it.
double written(Real radius) { return static_cast<double>(std::min<Real>(radius, std::numeric_limits<double>::max())); }

std::vector<Place> places_of(const PointCloud& cloud, const Vertices& vertices) {
    std::vector<Place> places;
    for (const std::uint32_t v : vertices) {
        const double* const x = cloud.coordinates.data() + std::size_t{v} * cloud.dim;
        places.emplace_back(x, x + cloud.dim);
    }
    return places;
}

}  // namespace

SimplexList lower_stars(const CellTable& cells, const std::vector<double>& values, std::uint32_t zero_born,
                        std::uint32_t top) {
    std::set<Vertices> faces;
    if (!faces_of(cells, top, &faces)) return {};
    std::vector<FilteredSimplex> list;
    for (const Vertices& face : faces) {
        double value = values[face[0]];
        for (const std::uint32_t v : face) value = std::max(value, values[v]);
        if (face.size() == 1 && face[0] < zero_born) value = 0;
        list.push_back({face, value});
    }
    return list;
}

SimplexList mesh_complex(const MeshFiles& files, const std::vector<double>& values, std::uint32_t zero_born,
                         std::uint32_t top, std::uint64_t* unknown) {
    *unknown = 0;
    SimplexList list = lower_stars(files.cells, values, zero_born, top);
    if (!list || !files.node.clipped) return list;
    const ClippedNerve nerve = clipped_nerve(files, top);
    *unknown = nerve.unknown;
    if (nerve.unknown > 0) return {};
    const auto is_out = [&](const FilteredSimplex& s) { return nerve.simplices.count(s.vertices) == 0; };
    list->erase(std::remove_if(list->begin(), list->end(), is_out), list->end());
    return list;
}

SimplexList alpha_complex(const MeshFiles& files, std::uint32_t top, bool* is_flat) {
    const PointCloud& cloud = files.node.cloud;
    std::set<Vertices> faces;
    if (!faces_of(files.cells, cloud.dim, &faces)) return {};
    std::vector<FilteredSimplex> list;
    for (std::size_t size = cloud.dim + 1; size > 0; size--) {
        // Spheres of the faces of one dimension.
        std::map<Vertices, Sphere> spheres;
        for (const Vertices& face : faces) {
            if (face.size() != size || smallest_circumsphere(places_of(cloud, face), &spheres[face])) continue;
            if (is_flat != nullptr) *is_flat = true;
            return {};
        }
        // The remaining vertex of each cofacet, which has its value already, against them.
        std::map<Vertices, Real> first;
        std::set<Vertices> attached, doubtful;
        for (const FilteredSimplex& cofacet : list) {
            if (cofacet.vertices.size() != size + 1) continue;
            for (std::size_t i = 0; i <= size; i++) {
                Vertices face = cofacet.vertices;
                const std::uint32_t other = face[i];
                face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
                const Sphere& sphere = spheres[face];
                const auto [at, added] = first.emplace(face, cofacet.value);
                if (!added) at->second = std::min<Real>(at->second, cofacet.value);
                const int inside = sphere.holds(places_of(cloud, {other})[0]);
                if (inside > 0) attached.insert(face);
                if (inside == 0) doubtful.insert(face);
            }
        }
        for (const auto& [face, sphere] : spheres) {
            // Rounding must not let a face enter after its cofacet.
            Real value = sphere.radius;
            const auto cofacet = first.find(face);
            if (cofacet != first.end()) value = std::min(value, cofacet->second);
            if (attached.count(face) != 0) {
                value = cofacet->second;
            } else if (doubtful.count(face) != 0 && cofacet->second > value * (1 + radius_tolerance / 8)) {
                if (is_flat != nullptr) *is_flat = true;
                return {};
            }
            list.push_back({face, written(value)});
        }
    }
    list.erase(
        std::remove_if(list.begin(), list.end(), [&](const FilteredSimplex& s) { return s.vertices.size() > top + 1; }),
        list.end());
    return list;
}

std::vector<Place> different_places(const PointCloud& cloud) {
    std::vector<Place> places;
    std::set<Place> seen;
    for (std::size_t row = 0; row < cloud.rows(); row++) {
        const Place place = places_of(cloud, {static_cast<std::uint32_t>(row)})[0];
        if (seen.insert(place).second) places.push_back(place);
    }
    return places;
}

SimplexList complex_of_points(const PointCloud& cloud, bool rips, std::uint32_t top, std::size_t most) {
    const std::vector<Place> places = different_places(cloud);
    std::vector<Vertices> level;  // all sets of one size
    for (std::uint32_t v = 0; v < places.size(); v++) level.push_back({v});
    std::vector<FilteredSimplex> list;
    for (std::uint32_t d = 0; d <= top; d++) {
        std::vector<Vertices> next;
        for (const Vertices& set : level) {
            std::vector<Place> corners;
            for (const std::uint32_t v : set) corners.push_back(places[v]);
            Real value = 0;
            for (const Place& a : corners) {
                for (const Place& b : corners) value = std::max(value, std::sqrt(distance2(a, b)) / 2);
            }
            list.push_back({set, written(rips ? value : enclosing_radius(corners))});
            for (std::uint32_t v = set.back() + 1; v < places.size() && d < top; v++) {
                next.push_back(set);
                next.back().push_back(v);
            }
            if (list.size() + next.size() > most) return {};
        }
        level.swap(next);
    }
    return list;
}

}  // namespace netmesh::tool
