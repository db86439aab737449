// The second opinion on exact diagrams: right by hand and by two ways, and not to be talked into anything.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/opinion/complexes.hpp"
#include "tools/opinion/delaunay_check.hpp"
#include "tools/opinion/spanning_tree.hpp"

using namespace netmesh::tool;
using netmesh::Engine;

namespace {

using Random = std::mt19937_64;

PointCloud cloud_of(std::uint32_t dim, const std::vector<double>& coordinates) {
    PointCloud cloud;
    cloud.name = "p.txt";
    cloud.dim = dim;
    cloud.coordinates = coordinates;
    return cloud;
}

PointCloud uniform(std::uint32_t dim, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    PointCloud cloud = cloud_of(dim, {});
    for (std::size_t i = 0; i < count * dim; i++)
        cloud.coordinates.push_back(std::ldexp(static_cast<double>(random() >> 11), -53));
    return cloud;
}

// Up to three units in the last place, so that what is cospherical is so nearly.
void shake(PointCloud* cloud, std::uint64_t seed) {
    Random random(seed);
    for (double& x : cloud->coordinates)
        for (std::uint64_t i = random() % 4; i > 0; i--)
            x = std::nextafter(x, random() % 2 == 0 ? HUGE_VAL : -HUGE_VAL);
}

PointCloud grid(std::uint32_t dim, int side, double step) {
    PointCloud cloud = cloud_of(dim, {});
    int count = 1;
    for (std::uint32_t k = 0; k < dim; k++) count *= side;
    for (int i = 0; i < count; i++)
        for (int rest = i, k = 0; k < static_cast<int>(dim); k++, rest /= side)
            cloud.coordinates.push_back(step * (rest % side));
    return cloud;
}

CellTable table_of(std::uint32_t columns, const std::vector<std::uint32_t>& entries) {
    CellTable table;
    table.columns = columns;
    table.entries = entries;
    table.lines.assign(entries.size() / columns, 1);
    return table;
}

// Squares of a grid of side^2 points, each cut along either diagonal.
CellTable cut_squares(std::uint32_t side, Random& random) {
    std::vector<std::uint32_t> entries;
    for (std::uint32_t y = 0; y + 1 < side; y++)
        for (std::uint32_t x = 0; x + 1 < side; x++) {
            const std::uint32_t a = y * side + x, b = a + 1, c = a + side, d = c + 1;
            if (random() % 2 == 0) {
                entries.insert(entries.end(), {a, b, c, b, c, d});
            } else {
                entries.insert(entries.end(), {a, b, d, a, c, d});
            }
        }
    return table_of(3, entries);
}

// Cubes of a grid of side^3 points: six cells each around a diagonal, or five around a tetrahedron, in turns.
CellTable cut_cubes(std::uint32_t side, bool by_five) {
    std::vector<std::uint32_t> entries;
    for (std::uint32_t z = 0; z + 1 < side; z++)
        for (std::uint32_t y = 0; y + 1 < side; y++)
            for (std::uint32_t x = 0; x + 1 < side; x++) {
                std::uint32_t c[8];
                for (std::uint32_t i = 0; i < 8; i++)
                    c[i] = ((z + (i >> 2)) * side + y + (i >> 1 & 1)) * side + x + (i & 1);
                const std::uint32_t even[] = {0, 1, 2, 4, 3, 1, 2, 7, 5, 1, 4, 7, 6, 2, 4, 7, 1, 2, 4, 7};
                const std::uint32_t around[] = {1, 3, 3, 2, 2, 6, 6, 4, 4, 5, 5, 1};
                const std::uint32_t mirror = (x + y + z) % 2;
                for (int i = 0; i < 20 && by_five; i++) entries.push_back(c[even[i] ^ mirror]);
                for (int i = 0; i < 6 && !by_five; i++)
                    entries.insert(entries.end(), {c[0], c[around[2 * i]], c[around[2 * i + 1]], c[7]});
            }
    return table_of(4, entries);
}

MeshFiles files_of(const PointCloud& cloud, const CellTable& cells) {
    MeshFiles files;
    files.node.cloud = cloud;
    files.cells = cells;
    return files;
}

std::vector<Bar> bars_by(const SimplexList& list, std::uint32_t max_degree) {
    REQUIRE(list);
    return FilteredComplex(*list).bars(max_degree, false);
}

// A diagram that the engine makes, as a file would have it.
struct Made {
    Options options;
    PointCloud points;
    DiagramFile file;
    RunReport run;
    std::string no_cycles;

    Made(std::vector<std::string> making, const PointCloud& cloud) : points(cloud) {
        making.insert(making.begin(), {"persist", "p.txt", "--quiet", "--filter"});
        CHECK(parse_options(making, &options).good());
        Session session(options, points.dim);
        REQUIRE(session.run(0, points, [&](Session& s) { return persist_as_asked(s, points); }).good());
        run.engine = session.engine().report();
        run.checked.emplace();
        file.name = "d.pers";
        file.bars = bars_of(session.engine());
        file.lines.assign(file.bars.size(), 1);
        options = settled(options, points.dim);
    }
    Outcome judge() {
        run.checked->clear();
        return second_opinion_on_points({file, options, no_cycles}, points, &run);
    }
    bool is_refused(std::vector<Bar> bars) {
        std::sort(bars.begin(), bars.end(), comes_before);
        bars.swap(file.bars);
        const Outcome outcome = judge();
        bars.swap(file.bars);
        CAPTURE(outcome.message);
        CHECK(outcome.message.find("exact arithmetic") != std::string::npos);
        return outcome.exit == Exit::check;
    }
    std::string said() {
        const Outcome outcome = judge();
        CHECK(outcome.message == "");
        return run.checked->empty() ? "" : run.checked->front();
    }
};

double moved(double x, bool up) { return std::nextafter(x, up ? HUGE_VAL : 0); }

// Every bar, or every n-th, in every way; without looking above degree `top`.
void plant(Made& made, std::size_t step, std::uint32_t top = 9) {
    const std::vector<Bar> right = made.file.bars;
    std::size_t planted = 0;
    for (std::size_t i = 0; i < right.size(); i += step) {
        const Bar bar = right[i];
        if (bar.degree > top) continue;
        std::vector<Bar> wrong = right;
        const auto refused = [&](double birth, double death, std::uint32_t degree) {
            if (death <= birth) return true;
            wrong[i] = {degree, birth, death};
            planted++;
            return made.is_refused(wrong);
        };
        for (const bool up : {false, true}) {
            if (std::isfinite(bar.death)) CHECK(refused(bar.birth, moved(bar.death, up), bar.degree));
            if (bar.birth > 0) CHECK(refused(moved(bar.birth, up), bar.death, bar.degree));
        }
        CHECK(refused(bar.birth, bar.death, bar.degree + 1));
        wrong = right;
        wrong.push_back({bar.degree, bar.birth, bar.birth});
        CHECK(made.is_refused(wrong));
        wrong = right;
        wrong.push_back(bar);
        CHECK(made.is_refused(wrong));
        wrong = right;
        wrong.erase(wrong.begin() + static_cast<std::ptrdiff_t>(i));
        CHECK(made.is_refused(wrong));
    }
    CHECK(planted > 3);
    // Rounded down, or up, in place of to nearest: neighbours of half of the numbers.
    for (const bool up : {false, true}) {
        std::vector<Bar> wrong = right;
        for (std::size_t i = 0; i < wrong.size(); i += 2)
            if (std::isfinite(wrong[i].death) && wrong[i].degree <= top) wrong[i].death = moved(wrong[i].death, up);
        CHECK(made.is_refused(wrong));
    }
    CHECK(made.judge().good());
}

}  // namespace

TEST_CASE("exact opinion: triangulations of grids are Delaunay whichever way squares and cubes are cut") {
    Random random(1);
    for (int turn = 0; turn < 20; turn++) {
        PointCloud square = grid(2, 5, turn % 2 == 0 ? 1 : 0.1);
        const CellTable cells = cut_squares(5, random);
        CHECK(delaunay_complaint(exact_places(square), cells) == "");
        shake(&square, static_cast<std::uint64_t>(turn));
        CHECK(delaunay_complaint(exact_places(square), cells) != "");  // of 65,536 ways few are left
    }
    for (const bool by_five : {false, true})
        CHECK(delaunay_complaint(exact_places(grid(3, 3, 1)), cut_cubes(3, by_five)) == "");
}

TEST_CASE("exact opinion: what is no Delaunay triangulation") {
    const std::vector<ExactPlace> kite = exact_places(cloud_of(2, {0, 0, 4, 0, 2, 1, 2, -1}));
    const auto judged = [](const std::vector<ExactPlace>& places, const std::vector<std::uint32_t>& entries) {
        return delaunay_complaint(places, table_of(3, entries));
    };
    const auto has = [](const std::string& text, const char* part) {
        CAPTURE(text);
        return text.find(part) != std::string::npos;
    };
    CHECK(judged(kite, {0, 2, 3, 1, 2, 3}) == "");
    CHECK(has(judged(kite, {0, 1, 2, 0, 1, 3}), "is inside the sphere"));
    CHECK(has(judged(kite, {0, 2, 3}), "no cell has the vertex 1"));
    CHECK(has(judged(kite, {0, 2, 3, 1, 2, 3, 0, 2, 3}), "overlapping"));
    CHECK(has(judged(kite, {0, 2, 3, 0, 2, 1}), "overlapping"));
    CHECK(has(judged(kite, {0, 0, 3, 1, 2, 3}), "flat"));
    CHECK(judged(kite, {}) == "there are no cells");
    // Not convex, seen from inside and at a vertex.
    const std::vector<ExactPlace> dart = exact_places(cloud_of(2, {0, 0, 4, 1, 1, 0, 4, -1}));
    CHECK(has(judged(dart, {0, 1, 2, 0, 2, 3}), "not convex"));
    CHECK(judged(dart, {0, 1, 2, 0, 2, 3, 1, 2, 3}) == "");
    const std::vector<ExactPlace> notch = exact_places(cloud_of(2, {0, 0, 8, 0, 8, 4, 4, 3, 0, 4}));
    CHECK(has(judged(notch, {0, 3, 4, 0, 1, 3, 1, 2, 3}), "not convex"));
    CHECK(judged(notch, {0, 3, 4, 0, 1, 3, 1, 2, 3, 2, 3, 4}) == "");
    // Two pieces that do not touch, and a star that goes around twice.
    const std::vector<ExactPlace> pieces = exact_places(cloud_of(2, {0, 0, 1, 0, 0, 1, 5, 5, 6, 5, 5, 6}));
    CHECK(judged(pieces, {0, 1, 2, 3, 4, 5}) != "");
    const std::vector<ExactPlace> star = exact_places(cloud_of(2, {0, 0, 5, 0, 1, 4, -4, 3, -4, -3, 1, -4}));
    CHECK(judged(star, {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1}) == "");
    CHECK(judged(star, {0, 1, 3, 0, 3, 5, 0, 5, 2, 0, 2, 4, 0, 4, 1}) != "");
    // The same in space: an octahedron whose middle is a vertex, and a cell of it less.
    const std::vector<ExactPlace> eight =
        exact_places(cloud_of(3, {0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1}));
    std::vector<std::uint32_t> cells;
    for (const std::uint32_t x : {1u, 2u})
        for (const std::uint32_t y : {3u, 4u})
            for (const std::uint32_t z : {5u, 6u}) cells.insert(cells.end(), {0u, x, y, z});
    CHECK(delaunay_complaint(eight, table_of(4, cells)) == "");
    cells.resize(cells.size() - 4);
    CHECK(has(delaunay_complaint(eight, table_of(4, cells)), "not convex"));
}

TEST_CASE("exact opinion: the triangulation and the nerve of balls have the same bars, on grids cut in any way") {
    Random random(2);
    for (const double step : {1.0, 0.375}) {
        const PointCloud square = grid(2, 5, step), cube = grid(3, 3, step);
        const std::vector<Bar> flat = bars_by(complex_of_points(square, false, 2), 1),
                               solid = bars_by(complex_of_points(cube, false, 3), 2);
        CHECK(solid.size() > 30);
        for (int turn = 0; turn < 10; turn++)
            CHECK(bars_by(alpha_complex(files_of(square, cut_squares(5, random)), 2), 1) == flat);
        for (const bool by_five : {false, true})
            CHECK(bars_by(alpha_complex(files_of(cube, cut_cubes(3, by_five)), 3), 2) == solid);
    }
}

TEST_CASE("exact opinion: the engine's triangulation and the nerve of balls have the same bars") {
    const auto compare = [](const PointCloud& cloud) {
        Made made({"alpha"}, cloud);
        bool is_too_large = true;
        Session session(made.options, cloud.dim);
        REQUIRE(session.run(0, cloud, [&](Session& s) { return make_mesh(s, cloud); }).good());
        const MeshFiles files = files_of(EngineMesh(session.engine()));
        const std::uint32_t top = made.options.request.max_degree;
        const SimplexList sets = complex_of_points(cloud, false, top + 1);
        made.file.bars = bars_by(sets, top);
        const Outcome outcome =
            judge_alpha({made.file, made.options, made.no_cycles}, files, "of it", &is_too_large, &*made.run.checked);
        CHECK(outcome.message == "");
        CHECK(!is_too_large);
    };
    for (std::uint64_t seed = 1; seed <= 5; seed++) {
        compare(uniform(2, 25, seed));
        compare(uniform(3, 16, seed));
        PointCloud square = grid(2, 5, 0.1), cube = grid(3, 2, 0.7);
        shake(&square, seed);
        shake(&cube, seed);
        compare(square);
        compare(cube);
        // Points of a circle and of a sphere, which rounding moves off it.
        PointCloud round = cloud_of(2, {}), ball = cloud_of(3, {});
        Random random(seed);
        for (int i = 0; i < 9; i++) {
            const double a = 1e-3 * static_cast<double>(random() % 6283),
                         z = 1e-3 * static_cast<double>(random() % 2000);
            const double r = std::sqrt(1 - (z - 1) * (z - 1));
            for (const double x : {std::cos(a), std::sin(a)}) round.coordinates.push_back(x);
            for (const double x : {r * std::cos(a), r * std::sin(a), z - 1}) ball.coordinates.push_back(x);
        }
        compare(round);
        compare(ball);
    }
}

TEST_CASE("exact opinion: planted errors are refused, by brute force") {
    PointCloud round = cloud_of(2, {0.25, 0.125}), few = round;
    for (int i = 0; i < 9; i++)
        for (const double x : {std::cos(0.7 * i), std::sin(0.7 * i)}) round.coordinates.push_back(x);
    for (int i = 0; i < 6; i++)
        for (const double x : {std::cos(1.1 * i), std::sin(1.1 * i)}) few.coordinates.push_back(x);
    for (const std::vector<std::string>& making :
         std::vector<std::vector<std::string>>{{"alpha"},
                                               {"cech"},
                                               {"rips"},
                                               {"cech", "--max-degree", "0"},
                                               {"barycentric-cech", "--k", "1"},
                                               {"barycentric-cech", "--k", "2"},
                                               {"barycentric-rips", "--k", "2"},
                                               {"barycentric-rips", "--k", "2", "--values", "thesis"},
                                               {"barycentric-cech", "--k", "3", "--max-degree", "0"}}) {
        CAPTURE(making[0]);
        Made made(making, making[0][0] == 'b' ? few : round);
        CHECK(made.said().find("in exact arithmetic: the same bars, to the last bit") != std::string::npos);
        CHECK(made.run.checked->front().find("triangulation") == std::string::npos);
        plant(made, 2);
    }
    Made space({"alpha"}, uniform(3, 13, 5));
    CHECK(space.said().find("of the nerve of all balls") != std::string::npos);
    plant(space, 3);
    // Bars of length zero are not looked at.
    Made all({"rips", "--all"}, round);
    CHECK(all.said().find("bars of length zero were not looked at") != std::string::npos);
}

TEST_CASE("exact opinion: planted errors are refused, by the triangulation") {
    for (std::uint32_t dim = 2; dim <= 3; dim++) {
        PointCloud cloud = uniform(dim, dim == 2 ? 150 : 90, dim);
        cloud.coordinates.insert(cloud.coordinates.end(), cloud.coordinates.begin(),
                                 cloud.coordinates.begin() + 2 * dim);  // two duplicates
        Made made({"alpha"}, cloud);
        CHECK(made.said().find("of the triangulation that the engine makes of p.txt, which is Delaunay") !=
              std::string::npos);
        plant(made, 70);
    }
    Made flat({"alpha"}, grid(2, 9, 0.1));
    CHECK(flat.said().find("which is Delaunay") != std::string::npos);
    plant(flat, 70);
}

TEST_CASE("exact opinion: of more points degree 0 alone") {
    const PointCloud cloud = grid(2, 4, 1);
    const std::vector<double> halves = spanning_tree_halves(cloud);
    CHECK(halves == std::vector<double>(15, 0.5));
    CHECK(nearest_half(cloud, 5) == 0.5);
    for (std::uint64_t seed = 1; seed < 6; seed++) {
        PointCloud some = seed % 2 == 0 ? uniform(3, 60, seed) : grid(2, 8, 0.3);
        if (seed == 3) shake(&some, seed);
        std::vector<double> deaths;
        for (const Bar& bar : bars_by(complex_of_points(some, true, 1), 0))
            if (std::isfinite(bar.death)) deaths.push_back(bar.death);
        CHECK(spanning_tree_halves(some) == deaths);
        for (std::size_t row = 0; row < some.rows(); row += 7)
            CHECK(std::binary_search(deaths.begin(), deaths.end(), nearest_half(some, row)));
    }
    // Of coordinates whose squares are out of range.
    for (const double scale : {0x1p-600, 0x1p600})
        CHECK(spanning_tree_halves(grid(2, 3, scale)) == std::vector<double>(8, scale / 2));
    // Rips of 200 points: 1,333,500 simplices.
    Made made({"rips"}, uniform(2, 200, 3));
    CHECK(made.said() == "second opinion on degree 0 alone, a minimum spanning tree of 200 points in exact arithmetic: "
                         "the same bars, to the last bit; degrees above were not looked at, as there are more than "
                         "1,000,000 simplices");
    plant(made, 25, 0);
    // A sample tells that all deaths are off.
    Made large({"alpha", "--max-degree", "0"}, uniform(2, 90000, 4));
    CHECK(large.said().find("and of it a sample: 1,000 of 90,000 points have bars") != std::string::npos);
    std::vector<Bar> wrong = large.file.bars;
    for (Bar& bar : wrong) bar.death = std::isfinite(bar.death) ? moved(bar.death, true) : bar.death;
    wrong.swap(large.file.bars);
    CHECK(large.judge().exit == Exit::check);
}
