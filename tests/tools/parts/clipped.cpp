// The second opinion on clipped cells, against brute force on meshes with balls of any size.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/opinion/cell_values.hpp"
#include "tools/opinion/clipped_cells.hpp"
#include "tools/opinion/clipped_nerve.hpp"
#include "tools/opinion/complexes.hpp"

using namespace netmesh::tool;

namespace {

class Chance {
public:
    explicit Chance(unsigned seed) : source_(seed) {}
    double unit() { return source_() * 0x1p-32; }
    Place direction(std::uint32_t dim) {
        while (true) {
            Place d(dim);
            Real square = 0;
            for (Real& x : d) x = 2 * unit() - 1;
            for (const Real x : d) square += x * x;
            if (square > 1 || square < 1e-4L) continue;
            for (Real& x : d) x /= std::sqrt(square);
            return d;
        }
    }

private:
    std::mt19937 source_;
};

Real dot(const Place& a, const Place& b) {
    Real sum = 0;
    for (std::size_t k = 0; k < a.size(); k++) sum += a[k] * b[k];
    return sum;
}
Place moved(Place a, Real factor, const Place& b) {
    for (std::size_t k = 0; k < a.size(); k++) a[k] += factor * b[k];
    return a;
}

PointCloud points_in(std::uint32_t dim, std::size_t count, Chance& chance) {
    PointCloud cloud;
    cloud.name = "points";
    cloud.dim = dim;
    for (std::size_t i = 0; i < count; i++) {
        const Real length = 0.5 + 0.5 * chance.unit();
        for (const Real x : chance.direction(dim)) cloud.coordinates.push_back(static_cast<double>(length * x));
    }
    return cloud;
}

// A mesh of whole cells, or the Delaunay triangulation of the points alone; in files, without a domain yet.
MeshFiles files_by(const std::vector<std::string>& words, const PointCloud& points) {
    Options options;
    REQUIRE(parse_options(words, &options).good());
    Session session(options, points.dim);
    const auto make = [&](Session& s) { return make_mesh(s, points); };
    REQUIRE(session.run(0, points, make).good());
    return files_of(EngineMesh(session.engine()));
}
MeshFiles whole_mesh(const PointCloud& points) {
    MeshFiles files = files_by({"mesh", "p.txt", "-o", "m.node", "--tau", points.dim < 4 ? "2.5" : "3.5"}, points);
    for (std::uint8_t& marker : files.node.markers)
        if (marker == 0 && &marker >= files.node.markers.data() + points.rows()) marker = 1;
    return files;
}

// 2 and 3, and 4 where the build serves it.
std::vector<int> dimensions(int most) {
    Options options;
    REQUIRE(parse_options({"delaunay", "p.txt", "-o", "m.node"}, &options).good());
    Chance chance(1);
    std::vector<int> served;
    for (int dim = 2; dim <= most; dim++) {
        const PointCloud points = points_in(static_cast<std::uint32_t>(dim), 8, chance);
        Session session(options, points.dim);
        const auto make = [&](Session& s) { return make_mesh(s, points); };
        if (dim < 4 || session.run(0, points, make).good()) served.push_back(dim);
    }
    return served;
}

void set_ball(MeshFiles* files, const Place& centre, double radius) {
    files->node.clipped = true;
    files->node.domain.clear();
    for (const Real x : centre) files->node.domain.push_back(static_cast<double>(x));
    files->node.domain.push_back(radius);
}

// About the origin, which is near the middle of the inputs.
double reach_of_inputs(const MeshFiles& files) {
    const std::uint32_t dim = files.node.cloud.dim;
    Real most = 0;
    for (std::size_t v = 0; v < files.node.cloud.rows(); v++) {
        if (files.node.markers[v] != 0) continue;
        Place x(files.node.cloud.coordinates.begin() + static_cast<std::ptrdiff_t>(v * dim),
                files.node.cloud.coordinates.begin() + static_cast<std::ptrdiff_t>((v + 1) * dim));
        most = std::max(most, std::sqrt(dot(x, x)));
    }
    return static_cast<double>(most);
}

std::vector<Place> places_of(const MeshFiles& files) {
    std::vector<Place> places;
    const std::uint32_t dim = files.node.cloud.dim;
    for (std::size_t v = 0; v < files.node.cloud.rows(); v++) {
        const double* const x = files.node.cloud.coordinates.data() + v * dim;
        places.emplace_back(x, x + dim);
    }
    return places;
}

// The least distances from the ball's centre to dual faces, from the cells down: of a face it is that of the point x
// nearest in its flat, when no cofacet's vertex is nearer to x than the simplex's, and otherwise the least of the
// cofacets'.
std::map<Vertices, Real> least_distances(const MeshFiles& files) {
    const std::uint32_t dim = files.node.cloud.dim;
    const Place centre(files.node.domain.begin(), files.node.domain.begin() + dim);
    const std::vector<Place> places = places_of(files);
    std::map<Vertices, std::vector<std::uint32_t>> others;  // vertices of cofacets
    for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
        for (std::uint32_t subset = 1; subset < (2u << dim); subset++) {
            Vertices face;
            for (std::uint32_t i = 0; i <= dim; i++)
                if ((subset >> i & 1) != 0) face.push_back(files.cells.entries[c * (dim + 1) + i]);
            std::sort(face.begin(), face.end());
            others[face];
            for (std::size_t i = 0; i < face.size() && face.size() > 1; i++) {
                Vertices facet = face;
                facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
                others[facet].push_back(face[i]);
            }
        }
    }
    std::map<Vertices, Real> least;
    for (std::size_t size = dim + 1; size > 0; size--) {
        for (const auto& [face, beside] : others) {
            if (face.size() != size) continue;
            const Place& v = places[face[0]];
            std::vector<Place> across;
            Place x = centre;
            for (std::size_t i = 1; i < size; i++) {
                Place e = moved(places[face[i]], -1, v);
                for (int turn = 0; turn < 2; turn++)
                    for (const Place& q : across) e = moved(e, -dot(e, q), q);
                const Place edge = moved(places[face[i]], -1, v);
                // x keeps what it is equally far from: e is orthogonal to the edges before.
                const Real gap = dot(edge, edge) / 2 - dot(edge, moved(x, -1, v));
                x = moved(x, gap / dot(edge, e), e);
                across.push_back(moved(Place(dim), 1 / std::sqrt(dot(e, e)), e));
            }
            bool inside = true;
            Real below = HUGE_VALL;
            for (const std::uint32_t u : beside) {
                inside = inside && distance2(x, places[u]) >= distance2(x, v);
                Vertices cofacet = face;
                cofacet.insert(std::upper_bound(cofacet.begin(), cofacet.end(), u), u);
                below = std::min(below, least.at(cofacet));
            }
            least[face] = inside ? std::sqrt(distance2(x, centre)) : below;
        }
    }
    return least;
}

struct Compared {
    std::size_t in = 0, out = 0, unknown = 0;
};

// K against least distances; it has the Euler characteristic of a point, as the ball is convex.
Compared compare_nerves(const MeshFiles& files) {
    const std::uint32_t dim = files.node.cloud.dim;
    const Real radius = files.node.domain[dim];
    const ClippedNerve nerve = clipped_nerve(files, dim);
    Compared seen;
    seen.unknown = static_cast<std::size_t>(nerve.unknown);
    int characteristic = 0, wrong = 0, open = 0;
    for (const auto& [face, least] : least_distances(files)) {
        const bool is_in = nerve.simplices.count(face) != 0;
        (is_in ? seen.in : seen.out)++;
        if (std::fabs(least / radius - 1) > 1e-10L && is_in != (least < radius)) wrong++;
        if (is_in) characteristic += face.size() % 2 == 1 ? 1 : -1;
        for (std::size_t i = 0; is_in && i < face.size() && face.size() > 1; i++) {
            Vertices facet = face;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            if (nerve.simplices.count(facet) == 0) open++;
        }
        if (face.size() == 1 && nerve.unknown == 0) CHECK((nerve.vertices[face[0]] == Meeting::meets) == is_in);
    }
    CHECK(wrong == (seen.unknown == 0 ? 0 : wrong));
    if (seen.unknown == 0) {
        CHECK(open == 0);
        CHECK(characteristic == 1);
    }
    return seen;
}

}  // namespace

TEST_CASE("clipped: points and rays near a ball") {
    const std::vector<Real> exact = {0, 0};
    const HullAndCone segment = {{{2, -1}, {2, 3}}, exact, {}, 0, 0, true};
    CHECK(meeting_of(segment) == Meeting::apart);
    CHECK(meeting_of({{{0.9L, -1}, {0.9L, 3}}, exact, {}, 0, 0, true}) == Meeting::meets);
    CHECK(meeting_of({{{1, -1}, {1, 3}}, exact, {}, 0, 0, true}) == Meeting::unknown);
    CHECK(meeting_of({{{1 + 0x1p-30L, -1}, {1 + 0x1p-30L, 3}}, exact, {}, 0, 0, true}) == Meeting::apart);
    CHECK(meeting_of({{{1 - 0x1p-30L, -1}, {1 - 0x1p-30L, 3}}, exact, {}, 0, 0, true}) == Meeting::meets);
    // What is not known of a corner is not known of the face.
    CHECK(meeting_of({{{1 + 0x1p-30L, -1}, {1 + 0x1p-30L, 3}}, {0x1p-20L, 0}, {}, 0, 0, true}) == Meeting::unknown);
    CHECK(meeting_of({{{2, -1}, {2, 3}}, exact, {}, 0, 0, false}) == Meeting::unknown);
    // A ray leads into the ball, or past it.
    CHECK(meeting_of({{{5, 0}}, {0}, {{-1, 0}}, 0, 100, true}) == Meeting::meets);
    CHECK(meeting_of({{{5, 2}}, {0}, {{-1, 0}}, 0, 100, true}) == Meeting::apart);
    CHECK(meeting_of({{{5, 2}}, {0}, {{-1, 0}}, 0x1p-5L, 100, true}) == Meeting::unknown);
    CHECK(meeting_of({{{5, 0}}, {0}, {{1, 0}}, 0, 100, true}) == Meeting::apart);
    CHECK(meeting_of({{{1e6L, 2e6L}, {1e6L, -1e6L}}, exact, {{-1, 0}}, 0, 1e7L, true}) == Meeting::meets);
    CHECK(meeting_of({{}, {}, {}, 0, 0, true}) == Meeting::unknown);
}

TEST_CASE("clipped: the nerve of a mesh's cells is that of least distances, for any ball inside the hull") {
    Chance chance(7);
    std::size_t unknown = 0, in = 0, out = 0;
    for (const int dim : dimensions(4)) {
        const std::uint32_t d = static_cast<std::uint32_t>(dim);
        for (int trial = 0; trial < (dim == 4 ? 1 : 3); trial++) {
            MeshFiles files = whole_mesh(points_in(d, dim == 2 ? 20 : dim == 3 ? 8 : 4, chance));
            for (const double radius : {0.2, 0.7, 1.001, 1.02, 1.3}) {
                const Real off = radius > 1 ? 0 : 0.4L * static_cast<Real>(chance.unit());
                set_ball(&files, moved(Place(d), off, chance.direction(d)), radius);
                CAPTURE(dim);
                CAPTURE(radius);
                const Compared seen = compare_nerves(files);
                unknown += seen.unknown;
                in += seen.in;
                out += seen.out;
            }
        }
    }
    CHECK(unknown == 0);
    CHECK(in > 10000);
    CHECK(out > 10000);
}

// The hull is near: faces are unbounded, corners far away.
TEST_CASE("clipped: the nerve of a triangulation without a frame") {
    Chance chance(3);
    std::size_t unknown = 0, meets = 0;
    for (const int dim : dimensions(4)) {
        const std::uint32_t d = static_cast<std::uint32_t>(dim);
        for (int trial = 0; trial < 40; trial++) {
            MeshFiles files = files_by({"delaunay", "p.txt", "-o", "m.node"}, points_in(d, 8 + 2 * d, chance));
            set_ball(&files, moved(Place(d), 0.1L, chance.direction(d)), 0.05 + 0.5 * chance.unit());
            const Compared seen = compare_nerves(files);
            unknown += seen.unknown > 0 ? 1 : 0;
            meets += seen.in;
        }
    }
    CHECK(unknown <= 3);
    CHECK(meets > 1000);
}

// The corners of a cube bent by their last bits: cells that are flat but for these, whose centres have few digits.
TEST_CASE("clipped: the nerve of nearly flat cells") {
    Chance chance(2);
    std::size_t flat = 0;
    for (const int dim : dimensions(4)) {
        if (dim == 2) continue;
        for (int trial = 0; trial < 10; trial++) {
            PointCloud cube;
            cube.name = "cube";
            cube.dim = static_cast<std::uint32_t>(dim);
            for (std::uint32_t i = 0; i < 1u << dim; i++) {
                for (int k = 0; k < dim; k++)
                    cube.coordinates.push_back((i >> k & 1u ? 1.0 : -1.0) *
                                               (1 + 0x1p-52 * std::floor(4 * chance.unit())));
            }
            for (int k = 0; k < 2 * dim; k++) {  // about it the frame's hull
                for (int j = 0; j < dim; j++) cube.coordinates.push_back(j != k / 2 ? 0 : k % 2 == 0 ? 9 : -8);
            }
            MeshFiles files = files_by({"delaunay", "p.txt", "-o", "m.node"}, cube);
            set_ball(&files, Place(cube.dim), 2.1);
            const std::vector<Place> places = places_of(files);
            for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
                std::vector<Place> points;
                for (std::uint32_t i = 0; i <= cube.dim; i++)
                    points.push_back(places[files.cells.entries[c * (cube.dim + 1) + i]]);
                Sphere ball;
                if (!smallest_circumsphere(points, &ball)) flat++;
            }
            const ClippedNerve nerve = clipped_nerve(files, cube.dim);
            int characteristic = 0;
            for (const Vertices& face : nerve.simplices) characteristic += face.size() % 2 == 1 ? 1 : -1;
            CHECK(nerve.unknown == 0);
            CHECK(characteristic == 1);
        }
    }
    CHECK(flat > 0);
}

namespace {

// Places of a ball, one in three on its sphere.
Place place_in(const Place& centre, Real radius, Chance& chance, int turn) {
    const std::uint32_t dim = static_cast<std::uint32_t>(centre.size());
    const Real share = turn % 3 == 0 ? 1 : std::pow(static_cast<Real>(chance.unit()), 1.0L / dim);
    return moved(centre, radius * share, chance.direction(dim));
}

std::size_t nearest_of(const std::vector<Place>& places, const Place& x, std::size_t count) {
    std::size_t best = 0;
    for (std::size_t v = 1; v < count; v++)
        if (distance2(places[v], x) < distance2(places[best], x)) best = v;
    return best;
}

}  // namespace

// Sampling bounds reaches from below, and places of the clipped cell from above.
TEST_CASE("clipped: cells reach as far as sampled places, and no farther than places of theirs") {
    Chance chance(11);
    for (const int dim : dimensions(4)) {
        CAPTURE(dim);
        const std::uint32_t d = static_cast<std::uint32_t>(dim);
        MeshFiles files = whole_mesh(points_in(d, dim == 2 ? 20 : 8, chance));
        const double radius = reach_of_inputs(files) * 1.002;
        const Place centre(d);
        set_ball(&files, centre, radius);
        const std::vector<Place> places = places_of(files);
        std::vector<Place> corners;
        std::vector<std::vector<std::uint32_t>> star(places.size());
        for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
            std::vector<Place> points;
            for (std::uint32_t i = 0; i <= d; i++) {
                const std::uint32_t v = files.cells.entries[c * (d + 1) + i];
                points.push_back(places[v]);
                star[v].push_back(static_cast<std::uint32_t>(c));
            }
            Sphere ball;
            REQUIRE(smallest_circumsphere(points, &ball));
            corners.push_back(ball.centre());
        }
        const ClippedCells cells(files, places, corners, star);
        const ClippedNerve nerve = clipped_nerve(files, 0);
        const Place goal = moved(centre, radius / 3, chance.direction(d));
        std::vector<Real> own(places.size()), far(places.size()), seen_own(places.size()), seen_far(places.size());
        std::vector<Real> seen_near(places.size(), HUGE_VALL);
        std::vector<Place> nearest(places.size());
        std::size_t cut = 0, foreign = 0, empty = 0;
        for (std::size_t v = 0; v < places.size(); v++) {
            if (!cells.is_cut(v)) continue;
            cut++;
            const auto shape = cells.shape(v);
            const std::vector<Place> ends = cells.places(*shape, {places[v], goal});
            std::vector<Place> all = ends;
            nearest[v] = cells.nearest(*shape, goal);
            if (nearest[v].empty() != ends.empty()) empty++;
            if (!nearest[v].empty()) all.push_back(nearest[v]);
            for (const Place& x : all) {
                const Real apart = std::sqrt(distance2(x, places[v]));
                own[v] = std::max(own[v], apart);
                far[v] = std::max(far[v], std::sqrt(distance2(x, goal)));
                const Real least = std::sqrt(distance2(x, places[nearest_of(places, x, places.size())]));
                if (least < apart * (1 - 1e-10L) || std::sqrt(distance2(x, centre)) > radius * (1 + 1e-10L)) foreign++;
            }
            if (ends.empty() != (nerve.vertices[v] == Meeting::apart)) empty++;
        }
        CHECK(cut > 10);
        CHECK(foreign == 0);
        CHECK(empty == 0);
        std::size_t beyond = 0, tight = 0, met = 0;
        for (int turn = 0; turn < (dim == 2 ? 30000 : 60000); turn++) {
            const Place x = place_in(centre, radius, chance, turn);
            const std::size_t v = nearest_of(places, x, places.size());
            if (nerve.vertices[v] != Meeting::meets) beyond++;
            if (!cells.is_cut(v)) continue;
            seen_own[v] = std::max(seen_own[v], std::sqrt(distance2(x, places[v])));
            seen_far[v] = std::max(seen_far[v], std::sqrt(distance2(x, goal)));
            seen_near[v] = std::min(seen_near[v], std::sqrt(distance2(x, goal)));
        }
        for (std::size_t v = 0; v < places.size(); v++) {
            if (!(seen_own[v] > 0)) continue;
            met++;
            if (seen_own[v] > own[v] * (1 + 1e-12L) || seen_far[v] > far[v] * (1 + 1e-12L)) beyond++;
            if (seen_own[v] > 0.7L * own[v]) tight++;
            const Real near = nearest[v].empty() ? HUGE_VALL : std::sqrt(distance2(nearest[v], goal));
            if (seen_near[v] < near * (1 - 1e-12L)) beyond++;
        }
        CHECK(beyond == 0);
        CHECK(met > 10);
        CHECK(3 * tight > 2 * met);
    }
}

TEST_CASE("clipped: what a filter is said to take on a cell, and its certificate, hold at sampled places") {
    Chance chance(5);
    for (const int dim : dimensions(3)) {
        const std::uint32_t d = static_cast<std::uint32_t>(dim);
        const PointCloud inputs = points_in(d, dim == 2 ? 20 : 8, chance);
        MeshFiles files = whole_mesh(inputs);
        const double radius = reach_of_inputs(files) * 1.002;
        const Place centre(d);
        const FilterChoice choice = {NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED};
        files.node.domain.assign(d, 0);
        files.node.domain.push_back(radius);
        const double whole = static_cast<double>(cell_opinion(files, choice, 1, 2.5).ratio.most);
        set_ball(&files, centre, radius);
        const double c = static_cast<double>(cell_opinion(files, choice, 1, 2.5).ratio.most) * (1 + 1e-15);
        CHECK(c <= whole);
        const CellOpinion opinion = cell_opinion(files, choice, 1, c);
        CHECK(opinion.ratio.least <= c);
        CHECK(opinion.ratio.most < 1.1L * opinion.ratio.least);
        const std::vector<Place> places = places_of(files);
        std::size_t wrong = 0, absent = 0, judged = 0, missed = 0;
        Real used = 1;
        std::vector<Real> least(places.size(), HUGE_VALL);
        for (std::size_t v = 0; v < places.size(); v++)
            if (opinion.values[v].most > 1e300L) absent++;
        CHECK(absent > 3);
        for (int turn = 0; turn < 20000; turn++) {
            const Place x = place_in(centre, radius, chance, turn);
            const std::size_t v = nearest_of(places, x, places.size());
            const Real f = std::sqrt(distance2(x, places[nearest_of(places, x, inputs.rows())]));
            const Real t = opinion.values[v].least, cut = static_cast<Real>(reach_of_inputs(files));
            if (v < inputs.rows() && f < opinion.values[v].least / c) continue;  // in its ball
            judged++;
            if (!(opinion.values[v].most < 1e300L)) wrong++;
            if (std::min(f, cut) > c * opinion.values[v].most * (1 + 1e-9L) || t > c * f * (1 + 1e-9L)) wrong++;
            used = std::max(used, std::max(std::min(f, cut) / t, t / f));
            least[v] = std::min(least[v], f);
        }
        CHECK(wrong == 0);
        CHECK(judged > 15000);
        CHECK(used > 1 + 0.6L * (c - 1));
        for (std::size_t v = 0; v < places.size(); v++) {
            const CellRange seen = opinion.seen[v];
            if (seen.hi > c * opinion.values[v].most * (1 + 1e-9L)) wrong++;
            if (opinion.values[v].least > c * seen.lo * (1 + 1e-9L)) wrong++;
            // What a Steiner vertex's cell holds of the function is looked for where it is least.
            if (v >= inputs.rows() && least[v] < seen.lo * (1 - 1e-12L)) missed++;
        }
        CHECK(missed == 0);
        CHECK(wrong == 0);
    }
}

TEST_CASE("clipped: the engine's bars are those of a plain reduction of the nerve") {
    Chance chance(9);
    for (const int dim : dimensions(4)) {
        for (int trial = 0; trial < (dim == 2 ? 20 : 6); trial++) {
            const std::uint32_t d = static_cast<std::uint32_t>(dim);
            const PointCloud points = points_in(d, dim == 2 ? 16 : 8, chance);
            Options options;
            REQUIRE(
                parse_options({"persist", "p.txt", "--quiet", "--ratio", dim < 4 ? "2.1" : "2.3"}, &options).good());
            Session session(options, d);
            const auto make = [&](Session& s) { return persist_as_asked(s, points); };
            REQUIRE(session.run(0, points, make).good());
            const MeshFiles files = files_of(EngineMesh(session.engine()));
            CHECK(files.node.clipped);
            std::uint64_t unknown = 0;
            const SimplexList complex =
                mesh_complex(files, files.node.attributes, static_cast<std::uint32_t>(points.rows()), d, &unknown);
            CHECK(unknown == 0);
            REQUIRE(complex.has_value());
            std::size_t at = 0;
            CHECK(FilteredComplex(*complex).bars_complaint(bars_of(session.engine()), d - 1, false, &at) == "");
        }
    }
}
