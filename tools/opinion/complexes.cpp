#include "tools/opinion/complexes.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "tools/opinion/clipped_nerve.hpp"
#include "tools/opinion/exact_spheres.hpp"

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

namespace {

// A face of a simplex that has its value, and the vertex that the simplex has besides.
struct FaceOf {
    Vertices vertices;
    std::uint32_t other;
    double value;
};

// One entry for each face, with the value at which it enters, of faces sorted by vertices. False where a face is flat.
bool add_alpha_values(const std::vector<FaceOf>& faces, const std::vector<ExactPlace>& places,
                      std::vector<FilteredSimplex>* level) {
    for (std::size_t first = 0, last; first < faces.size(); first = last) {
        const Vertices& vertices = faces[first].vertices;
        std::vector<const ExactPlace*> corners;
        for (const std::uint32_t v : vertices) corners.push_back(&places[v]);
        const ExactSphere sphere(corners);
        if (!sphere.is_independent()) return false;
        double least = faces[first].value;
        bool is_attached = false;
        for (last = first; last < faces.size() && faces[last].vertices == vertices; last++) {
            least = std::min(least, faces[last].value);
            // No other point is inside the sphere of radius 0.
            is_attached = is_attached || (vertices.size() > 1 && sphere.side(places[faces[last].other]) < 0);
        }
        level->push_back({vertices, is_attached ? least : sphere.radius()});
    }
    return true;
}

}  // namespace

SimplexList alpha_complex(const MeshFiles& files, std::uint32_t top, std::size_t most) {
    const std::vector<ExactPlace> places = exact_places(files.node.cloud);
    const std::size_t columns = files.cells.columns;
    // A facet is of at most two cells.
    if (files.cells.lines.size() > 2 * most / (columns + 2)) return {};
    std::vector<FilteredSimplex> list, level;
    for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
        Vertices cell;
        std::vector<const ExactPlace*> corners;
        for (std::size_t i = 0; i < columns; i++) cell.push_back(files.cells.entries[c * columns + i]);
        std::sort(cell.begin(), cell.end());
        for (const std::uint32_t v : cell) corners.push_back(&places[v]);
        const ExactSphere sphere(corners);
        if (!sphere.is_independent()) return {};
        level.push_back({cell, sphere.radius()});
    }
    std::size_t seen = level.size();
    for (std::size_t size = columns; size > 0; size--) {
        std::vector<FaceOf> faces;
        for (const FilteredSimplex& s : level) {
            if (size <= top + 1) list.push_back(s);
            for (std::size_t i = 0; i < size && size > 1; i++) {
                Vertices rest = s.vertices;
                rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
                faces.push_back({std::move(rest), s.vertices[i], s.value});
            }
        }
        std::sort(faces.begin(), faces.end(), [](const FaceOf& a, const FaceOf& b) { return a.vertices < b.vertices; });
        level.clear();
        if (!add_alpha_values(faces, places, &level)) return {};
        seen += level.size();
        if (seen > most) return {};
    }
    return list;
}

std::vector<Place> different_places(const PointCloud& cloud) {
    const PointCloud different = different_points(cloud);
    std::vector<Place> places;
    for (std::size_t row = 0; row < different.rows(); row++) {
        const auto first = different.coordinates.begin() + static_cast<std::ptrdiff_t>(row * cloud.dim);
        places.emplace_back(first, first + cloud.dim);
    }
    return places;
}

namespace {

// The largest of the facets' values, where these are in the order of their vertices.
double largest_of_facets(const Vertices& set, const std::vector<FilteredSimplex>& facets) {
    double most = -HUGE_VAL;
    for (std::size_t i = 0; i < set.size(); i++) {
        Vertices facet = set;
        facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
        const auto before = [](const FilteredSimplex& a, const Vertices& b) { return a.vertices < b; };
        most = std::max(most, std::lower_bound(facets.begin(), facets.end(), facet, before)->value);
    }
    return most;
}

// Radii of sets of points from those of their facets.
class SetRadii {
public:
    SetRadii(const PointCloud& cloud, bool rips) : cloud_(cloud), rips_(rips) {
        if (!rips) places_ = exact_places(cloud);
    }
    // Half of the longest edge, or the radius of the smallest enclosing ball: that of the set's own sphere if its
    // centre is strictly inside, or else the largest of the facets'. A largest one of rounded values is the rounded
    // largest one.
    double operator()(const Vertices& set, const std::vector<FilteredSimplex>& facets) const {
        if (set.size() == 1) return 0;
        if (set.size() == 2) return half_distance(row(set[0]), row(set[1]), cloud_.dim);
        if (!rips_ && set.size() <= cloud_.dim + 1) {
            std::vector<const ExactPlace*> corners;
            for (const std::uint32_t v : set) corners.push_back(&places_[v]);
            const ExactSphere sphere(corners);
            if (sphere.is_independent() && sphere.is_centred()) return sphere.radius();
        }
        return largest_of_facets(set, facets);
    }

private:
    const double* row(std::uint32_t v) const { return cloud_.coordinates.data() + std::size_t{v} * cloud_.dim; }

    const PointCloud& cloud_;
    bool rips_;
    std::vector<ExactPlace> places_;
};

// The same of balls. The largest power to the points of a set is convex, and least at a place inside the simplex of
// those that have it: where that is the set's own orthogonal centre, its value is its own.
class SetPowers {
public:
    SetPowers(const PointCloud& cloud, bool are_radii, bool squares)
        : dim_(cloud.dim), squares_(squares), places_(exact_places(cloud)) {
        for (const double w : cloud.weights) weights_.push_back(are_radii ? Exact(w) * Exact(w) : Exact(w));
    }
    double operator()(const Vertices& set, const std::vector<FilteredSimplex>& facets) const {
        if (set.size() <= dim_ + 1) {
            std::vector<const ExactPlace*> corners;
            std::vector<Exact> weights;
            for (const std::uint32_t v : set) corners.push_back(&places_[v]), weights.push_back(weights_[v]);
            const ExactSphere sphere(corners, weights);
            if (sphere.is_independent() && sphere.is_centred()) return squares_ ? sphere.square() : sphere.radius();
        }
        return largest_of_facets(set, facets);
    }

private:
    std::size_t dim_;
    bool squares_;
    std::vector<ExactPlace> places_;
    std::vector<Exact> weights_;
};

// All sets of up to top + 1 of so many, each at value(set, those of one less).
template <class Value>
SimplexList all_sets(std::size_t count, std::uint32_t top, std::size_t most, const Value& value) {
    if (count_of_sets(count, top + 1) > static_cast<double>(most)) return {};
    std::vector<FilteredSimplex> list, facets, level;
    for (std::uint32_t v = 0; v < count; v++) level.push_back({{v}, value({v}, {})});
    while (!level.empty()) {
        list.insert(list.end(), level.begin(), level.end());
        facets.swap(level);
        level.clear();
        if (facets[0].vertices.size() > top) break;
        for (const FilteredSimplex& s : facets) {
            Vertices set = s.vertices;
            set.push_back(0);
            for (std::uint32_t v = s.vertices.back() + 1; v < count; v++) {
                set.back() = v;
                level.push_back({set, value(set, facets)});
            }
        }
    }
    return list;
}

}  // namespace

PointCloud different_points(const PointCloud& cloud) {
    PointCloud different;
    different.name = cloud.name;
    different.dim = cloud.dim;
    std::set<std::vector<double>> seen;
    for (std::size_t row = 0; row < cloud.rows(); row++) {
        std::vector<double> x;
        for (std::size_t k = 0; k < cloud.dim; k++) x.push_back(cloud.coordinates[row * cloud.dim + k] + 0.0);
        if (seen.insert(x).second) different.coordinates.insert(different.coordinates.end(), x.begin(), x.end());
    }
    return different;
}

double count_of_sets(std::size_t members, std::uint32_t size) {
    double sum = 0, choose = 1;
    for (std::size_t s = 1; s <= size && s <= members; s++) {
        choose = choose * static_cast<double>(members - s + 1) / static_cast<double>(s);
        sum += choose;
    }
    return sum;
}

SimplexList complex_of_points(const PointCloud& given, bool rips, std::uint32_t top, std::size_t most) {
    const PointCloud cloud = different_points(given);
    return all_sets(cloud.rows(), top, most, SetRadii(cloud, rips));
}

SimplexList nerve_of_balls(const PointCloud& cloud, bool are_radii, bool squares, std::uint32_t top, std::size_t most) {
    return all_sets(cloud.rows(), top, most, SetPowers(cloud, are_radii, squares));
}

SimplexList nerve_of_sets(const PointCloud& given, std::uint32_t k, bool rips, double factor, std::uint32_t top,
                          std::size_t most) {
    const PointCloud cloud = different_points(given);
    const std::uint32_t n = static_cast<std::uint32_t>(cloud.rows());
    if (n < k || n > 16) return {};  // 2^n sets have radii
    const SimplexList sets = complex_of_points(given, rips, n - 1, std::size_t{1} << n);
    std::vector<double> radius(std::size_t{1} << n);
    std::vector<std::uint32_t> members;
    for (const FilteredSimplex& s : *sets) {
        std::uint32_t mask = 0;
        for (const std::uint32_t v : s.vertices) mask |= 1u << v;
        radius[mask] = s.value;
        if (s.vertices.size() == k) members.push_back(mask);
    }
    if (count_of_sets(members.size(), top + 1) > static_cast<double>(most)) return {};
    std::vector<FilteredSimplex> list;
    std::vector<std::uint32_t> unions;  // of the members of each
    for (std::uint32_t m = 0; m < members.size(); m++) {
        list.push_back({{m}, radius[members[m]] * factor});
        unions.push_back(members[m]);
    }
    for (std::size_t at = 0; at < list.size(); at++) {
        if (list[at].vertices.size() > top) break;
        for (std::uint32_t m = list[at].vertices.back() + 1; m < members.size(); m++) {
            Vertices more = list[at].vertices;
            more.push_back(m);
            unions.push_back(unions[at] | members[m]);
            list.push_back({std::move(more), radius[unions.back()] * factor});
        }
    }
    return list;
}

}  // namespace netmesh::tool
