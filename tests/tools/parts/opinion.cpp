// The second opinion: right on what can be worked out by hand, and not to be talked into anything.
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/cycles.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/io/cycle_file.hpp"
#include "tools/opinion/cell_values.hpp"
#include "tools/opinion/complexes.hpp"
#include "tools/opinion/corner_error.hpp"
#include "tools/opinion/spheres.hpp"

using namespace netmesh::tool;
using netmesh::Engine;

namespace {

bool near(double a, double b) { return std::fabs(a - b) <= 1e-12 * std::fmax(1, std::fabs(b)); }

double value_of(const SimplexList& list, const Vertices& vertices) {
    for (const FilteredSimplex& s : *list) {
        if (s.vertices == vertices) return s.value;
    }
    return -1;
}

PointCloud cloud_of(std::uint32_t dim, const std::vector<double>& coordinates) {
    PointCloud cloud;
    cloud.name = "points";
    cloud.dim = dim;
    cloud.coordinates = coordinates;
    return cloud;
}

// Two triangles that share an edge: one is filled at 4, the other at 6.
FilteredComplex two_triangles() {
    return FilteredComplex({{{0}, 0},
                            {{1}, 0},
                            {{2}, 0},
                            {{3}, 0.5},
                            {{0, 1}, 1},
                            {{1, 2}, 2},
                            {{0, 2}, 3},
                            {{1, 3}, 1},
                            {{2, 3}, 3.5},
                            {{0, 1, 2}, 4},
                            {{1, 2, 3}, 6}});
}

}  // namespace

TEST_CASE("opinion: a plain reduction, and bars that are not its pairs") {
    const FilteredComplex complex = two_triangles();
    const std::vector<Bar> due = {{0, 0, 1}, {0, 0, 2}, {0, 0, HUGE_VAL}, {0, 0.5, 1}, {1, 3, 4}, {1, 3.5, 6}};
    CHECK(complex.bars(1, false) == due);
    std::size_t at = 0;
    CHECK(complex.bars_complaint(due, 1, false, &at) == "");
    for (std::size_t i = 0; i < due.size(); i++) {
        std::vector<Bar> forged = due;
        forged.erase(forged.begin() + static_cast<std::ptrdiff_t>(i));
        CHECK(complex.bars_complaint(forged, 1, false, &at) != "");
        forged = due;
        forged.insert(forged.begin() + static_cast<std::ptrdiff_t>(i), due[i]);
        CHECK(complex.bars_complaint(forged, 1, false, &at) != "");
        CHECK(at == i + 1);
        forged = due;
        forged[i].birth += 0.01;
        CHECK(complex.bars_complaint(forged, 1, false, &at) != "");
        CHECK(at == i);
    }
    CHECK(complex.bars_complaint({}, 1, false, &at) != "");
    CHECK(FilteredComplex({{{0}, 0}, {{1}, 1}, {{0, 1}, 1}}).bars(0, true).size() == 2);
    CHECK(FilteredComplex({{{0}, 0}, {{1}, 1}, {{0, 1}, 1}}).bars(0, false).size() == 1);
}

TEST_CASE("opinion: with values of its own, bars within rounding are the pairs, no others") {
    const FilteredComplex complex(
        {{{0}, 0}, {{1}, 0}, {{2}, 0}, {{0, 1}, 1}, {{1, 2}, 1}, {{0, 2}, 2}, {{0, 1, 2}, 2 * (1 + 1e-12)}}, 1e-9);
    std::size_t at = 0;
    CHECK(complex.bars_complaint({{0, 0, 1 + 1e-13}, {0, 0, 1}, {0, 0, HUGE_VAL}}, 1, false, &at) == "");
    CHECK(complex.bars_complaint({{0, 0, 1}, {0, 0, 1}, {0, 0, HUGE_VAL}, {1, 2, 2 * (1 + 1e-13)}}, 1, false, &at) ==
          "");
    CHECK(complex.bars_complaint({{0, 0, 1 + 1e-8}, {0, 0, 1}, {0, 0, HUGE_VAL}}, 1, false, &at) != "");
    CHECK(complex.bars_complaint({{0, 0, 1}, {0, 0, HUGE_VAL}}, 1, false, &at) != "");
    CHECK(complex.bars_complaint({{0, 0, 1}, {0, 0, 1}, {0, 0, HUGE_VAL}, {1, 2, 2.1}}, 1, false, &at) != "");
}

TEST_CASE("opinion: cycles are born with their bars and die with them") {
    const FilteredComplex complex = two_triangles();
    const std::vector<Vertices> first = {{0, 1}, {0, 2}, {1, 2}}, second = {{1, 2}, {1, 3}, {2, 3}};
    const std::vector<Vertices> both = {{0, 1}, {0, 2}, {1, 3}, {2, 3}};
    CHECK(complex.cycle_complaint(first, {1, 3, 4}) == "");
    CHECK(complex.cycle_complaint(second, {1, 3.5, 6}) == "");
    CHECK(complex.cycle_complaint(both, {1, 3.5, 6}) == "");  // homologous from 4 on
    CHECK(complex.cycle_complaint({{0}, {1}}, {0, 0, 1}) == "");
    CHECK(complex.cycle_complaint({{0}}, {0, 0, HUGE_VAL}) == "");
    const struct {
        std::vector<Vertices> chain;
        Bar bar;
        const char* complaint;
    } faults[] = {{first, {1, 3, 6}, "has a cycle that dies before it"},
                  {first, {1, 3, HUGE_VAL}, "has a cycle that dies before it"},
                  {second, {1, 3.5, 4}, "has a cycle that does not die with it"},
                  {second, {1, 3, 6}, "has a cycle that is not born with it"},
                  {{{0, 1}, {0, 2}}, {1, 3, 4}, "has a chain with a boundary"},
                  {{{0, 1}, {0, 3}, {1, 3}}, {1, 3, 4}, "has a simplex in its cycle that the complex lacks"},
                  {{{0, 1}, {0, 1}}, {1, 1, 4}, "has a simplex twice in its cycle"},
                  {{{0}, {1}}, {1, 0, 1}, "has a cycle of another degree"},
                  {{{0}, {1}}, {0, 0, HUGE_VAL}, "has a chain of too many or too few vertices"},
                  {{{0}, {3}}, {0, 0.5, 0.75}, "has a cycle that does not die with it"},
                  {{}, {1, 3, 4}, "has no cycle"}};
    for (const auto& fault : faults) CHECK(complex.cycle_complaint(fault.chain, fault.bar) == fault.complaint);
}

// The Gram matrix of the first has the determinant 2^-80, that of the second 2^-100 and less.
TEST_CASE("opinion: spheres through clusters and nearly flat simplices") {
    const Real small = 0x1p-40L, tiny = 0x1p-50L;
    Sphere sphere;
    REQUIRE(smallest_circumsphere({{0, 0, 0}, {1, 0, 0}, {1, small, 0}}, &sphere));
    CHECK(std::fabs(sphere.radius - std::sqrt(1 + small * small) / 2) < 1e-18L);
    CHECK(std::fabs(sphere.distance_to_centre({0, small, 0}) - sphere.radius) < 1e-18L);
    CHECK(sphere.holds({0.5, 0, 0x1.fffffffffp-2}) == 1);
    CHECK(sphere.holds({0.5, 0, 0.5 + 0x1p-30}) == -1);
    // A cluster of three or four, far from the first point, bent by its last bits.
    for (const Real far : {1.0L, 1e4L}) {
        const std::vector<Place> bent = {
            {0, 0, 0, 0}, {far, small, 0, 0}, {far, 0, small, 0}, {far, small / 2, small / 2 + tiny, 0}};
        REQUIRE(smallest_circumsphere(bent, &sphere));
        CHECK(sphere.error <= 0x1p-45L * sphere.radius);
        for (const Place& p : bent)
            CHECK(std::fabs(sphere.distance_to_centre(p) - sphere.radius) <= 1e-17L * sphere.radius);
        CHECK(sphere.centre()[3] == 0);
    }
    CHECK(!smallest_circumsphere({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, &sphere));
    CHECK(!smallest_circumsphere({{0, 0}, {0, 0}}, &sphere));
}

TEST_CASE("opinion: radii of alpha, Rips and Cech complexes") {
    // An obtuse triangle: the long edge has the third point in its circle and enters with the triangle.
    MeshFiles files;
    files.node.cloud = cloud_of(2, {0, 0, 1, 0, 0.5, 0.1});
    files.cells.columns = 3;
    files.cells.entries = {0, 1, 2};
    files.cells.lines = {2};
    const double side = std::sqrt(0.26), radius = 0.26 / 0.2;
    const SimplexList alpha = alpha_complex(files, 2);
    CHECK(alpha->size() == 7);
    CHECK(near(value_of(alpha, {0, 2}), side / 2));
    CHECK(near(value_of(alpha, {0, 1}), radius));
    CHECK(near(value_of(alpha, {0, 1, 2}), radius));
    CHECK(alpha_complex(files, 0)->size() == 3);
    // The same points with one of them twice; Rips and Cech differ from it, and from each other in an acute triangle.
    const PointCloud obtuse = cloud_of(2, {0, 0, 1, 0, 0, 0, 0.5, 0.1});
    CHECK(near(value_of(complex_of_points(obtuse, true, 2), {0, 1, 2}), 0.5));
    CHECK(near(value_of(complex_of_points(obtuse, false, 2), {0, 1, 2}), 0.5));
    const PointCloud even = cloud_of(2, {0, 0, 1, 0, 0.5, std::sqrt(0.75)});
    CHECK(near(value_of(complex_of_points(even, true, 2), {0, 1, 2}), 0.5));
    CHECK(near(value_of(complex_of_points(even, false, 2), {0, 1, 2}), 1 / std::sqrt(3)));
    // Near one another and far from the origin: distances of 1e-13, an acute triangle.
    const std::vector<double> small = {
        0.3, 0.2000000000007, 0.30000000000009996, 0.1999999999999, 0.2999999999996, 0.20000000000010001};
    std::vector<double> moved;
    for (std::size_t i = 0; i < small.size(); i++) moved.push_back(0x1p40 * (small[i] - small[i % 2]));
    const SimplexList near_by = complex_of_points(cloud_of(2, small), false, 2);
    const SimplexList at_origin = complex_of_points(cloud_of(2, moved), false, 2);
    for (const FilteredSimplex& s : *at_origin) CHECK(near(0x1p40 * value_of(near_by, s.vertices), s.value));
    const SimplexList stars = lower_stars(files.cells, {1, 2, 3}, 2, 1);
    CHECK(stars->size() == 6);
    CHECK(value_of(stars, {0}) == 0);
    CHECK(value_of(stars, {2}) == 3);
    CHECK(value_of(stars, {0, 1}) == 2);
}

namespace {

PointCloud two_rings() {
    PointCloud points = cloud_of(2, {});
    for (int i = 0; i < 24; i++) {
        points.coordinates.push_back(std::cos(0.2618 * i) * (1 + 0.1 * (i % 3)));
        points.coordinates.push_back(std::sin(0.2618 * i) * (1 + 0.07 * (i % 4)));
    }
    return points;
}

// A diagram with the mesh that it was made on, as files would have them.
struct Made {
    Options options;
    MeshFiles files;
    DiagramFile file;
    std::string cycles_path;
    RunReport run;

    explicit Made(const std::vector<std::string>& arguments, const PointCloud& points = two_rings()) {
        CHECK(parse_options(arguments, &options).good());
        Session session(options, points.dim);
        CHECK(session.run(0, points, [&](Session& s) { return persist_as_asked(s, points); }).good());
        const Engine& engine = session.engine();
        run.engine = engine.report();
        run.checked.emplace();
        file.name = "d.pers";
        file.bars = bars_of(engine);
        TextWriter text;
        write_head(head_of(options, *run.engine), text);
        write_diagram(file.bars, bounds_of(engine), text);
        CHECK(parse_head(text.text(), file.name, &file.head).good());
        file.bounds = bound_lines(text.text());
        file.lines.assign(file.bars.size(), 1);
        options = settled(options, points.dim);
        take_mesh(EngineMesh(engine));
        cycles_path = "/tmp/netmesh-cycles-" + std::to_string(getpid());
        TextWriter cycles;
        write_cycles(engine, cycles);
        write(cycles.text());
    }
    ~Made() { std::remove(cycles_path.c_str()); }
    Made(const Made&) = delete;
    Made& operator=(const Made&) = delete;

    void take_mesh(const EngineMesh& mesh) {
        TextWriter node, ele;
        write_node(mesh, node);
        write_ele(mesh, ele);
        files.node.cloud.name = "m.node";
        CHECK(parse_node(node.text(), &files.node).good());
        files.cells.name = "m.ele";
        files.cells.columns = files.node.cloud.dim + 1;
        CHECK(parse_cell_table(ele.text(), {0, mesh.vertex_count, false}, &files.cells).good());
    }
    void write(const std::string& cycles) const { std::ofstream(cycles_path) << cycles; }
    std::string cycles() const {
        std::string text;
        CHECK(read_content(cycles_path, &text).good());
        return text;
    }
    Outcome judge() {
        run.checked->clear();
        return second_opinion_on_mesh({file, options, cycles_path}, files, &run);
    }
    // One of whose value nothing is open: its cell lies in the ball, where cells are clipped.
    std::size_t some_vertex() const {
        const CellOpinion opinion = cell_opinion(files, choice_of(options), std::max(options.request.k, 1u),
                                                 run.engine->diagram.certified_ratio);
        std::size_t v = opinion.values.size() / 2;
        while (v > 0 && opinion.values[v].most > opinion.values[v].least * (1 + 1e-12L)) v--;
        CHECK(v > 0);
        return v;
    }
    bool refuses(const std::string& why) {
        const Outcome outcome = judge();
        CAPTURE(outcome.message);
        CHECK(outcome.message.find(why) != std::string::npos);
        return outcome.exit == Exit::check;
    }
};

const std::vector<std::vector<std::string>> makings = {{"--bounds"},
                                                       {"--ratio", "2.2", "--bounds"},
                                                       {"--whole-cells", "--bounds"},
                                                       {"--method", "svr"},
                                                       {"--values", "thesis"},
                                                       {"--filter", "basic", "--bounds"},
                                                       {"--filter", "knn", "--k", "3", "--bounds"},
                                                       {"--filter", "kdistance", "--k", "4"}};

std::vector<std::string> command(const std::vector<std::string>& making) {
    std::vector<std::string> line = {"persist", "p.txt",    "--quiet", "--representatives",
                                     "c.txt",   "--filter", "complete"};
    line.insert(line.end(), making.begin(), making.end());
    return line;
}

}  // namespace

TEST_CASE("opinion: what the engine made is confirmed; forged values, ratios and bars are not") {
    for (const std::vector<std::string>& making : makings) {
        CAPTURE(making[1 % making.size()]);
        Made made(command(making));
        const Outcome good = made.judge();
        CHECK(good.message == "");
        CHECK(good.exit == Exit::done);
        CHECK(made.run.checked->size() == 3);
        const bool whole = std::find(making.begin(), making.end(), "--whole-cells") != making.end();
        if (filter_of(made.options) == NETMESH_FILTER_COMPLETE &&
            made.options.request.mesh.method == &netmesh_method_certificate)
            CHECK(made.files.node.clipped == !whole);

        double& value = made.files.node.attributes[made.some_vertex()];
        const double right = value;
        for (const double wrong : {right * 1.01, right * 0.99, right * (1 + 1e-7)}) {
            value = wrong;
            CHECK(made.refuses("follows from the vertex's cell"));
        }
        value = right;
        double& ratio = made.run.engine->diagram.certified_ratio;
        const double certified = ratio;
        for (const double wrong : {certified * 1.01, certified * 0.99}) {
            ratio = wrong;
            CHECK(made.refuses("follows from"));  // the cells of the mesh, or one of them, whose value the ratio tells
        }
        ratio = certified;
        for (Bar& bar : made.file.bars) {
            const Bar was = bar;
            bar.birth = bar.birth * 1.01 + 1e-3;
            CHECK(made.refuses("pair"));
            bar = was;
        }
        made.file.bars.push_back({1, 0.5, 0.6});
        CHECK(made.refuses("pair"));
        made.file.bars.resize(made.file.bars.size() - 2);
        CHECK(made.refuses("is missing"));
    }
}

TEST_CASE("opinion: reaches of clipped cells may be a hair too large, and no more") {
    Made made(command({"--bounds"}));
    CHECK(made.judge().good());
    const CellOpinion opinion =
        cell_opinion(made.files, choice_of(made.options), 1, made.run.engine->diagram.certified_ratio);
    std::size_t planted = 0, tight = 0;
    for (std::size_t v = 0; v < opinion.values.size(); v++) {
        const Span due = opinion.values[v];
        if (!(due.most > due.least) || !(due.most < 1e300L)) continue;
        CHECK(due.most <= due.least * (1 + 0x1p-19L));
        tight += due.most <= due.least * (1 + 0x1p-28L);
        double& value = made.files.node.attributes[v];
        const double right = value;
        for (const Real wrong : {due.most * (1 + 1.1e-9L), due.least * (1 - 1.1e-9L)}) {
            value = static_cast<double>(wrong);
            CHECK(made.refuses("follows from the vertex's cell"));
            planted++;
        }
        value = right;
    }
    CHECK(planted > 10);
    CHECK(3 * tight > planted);  // two thirds of the cells, planted twice each
}

namespace {

// By Cramer's rule in doubles, from one of three vertices: how far from the true corner, over the radius.
Real corner_in_doubles(const std::vector<Place>& points, std::size_t first, const Sphere& sphere) {
    double e[2][2], half[2];
    for (std::size_t i = 0; i < 2; i++) {
        const Place& to = points[(first + i + 1) % 3];
        for (std::size_t k = 0; k < 2; k++)
            e[i][k] = static_cast<double>(to[k]) - static_cast<double>(points[first][k]);
        half[i] = (e[i][0] * e[i][0] + e[i][1] * e[i][1]) / 2;
    }
    const double determinant = e[0][0] * e[1][1] - e[0][1] * e[1][0];
    const double x[2] = {(half[0] * e[1][1] - e[0][1] * half[1]) / determinant,
                         (e[0][0] * half[1] - half[0] * e[1][0]) / determinant};
    Real off2 = 0;
    for (std::size_t k = 0; k < 2; k++) {
        const Real off = points[first][k] - sphere.point[k] + x[k] - static_cast<Real>(sphere.offset[k].high);
        off2 += off * off;
    }
    return std::sqrt(off2) / sphere.radius;
}

}  // namespace

TEST_CASE("opinion: errors of corners in doubles, by the shapes of their cells") {
    Real worst = 0;
    std::size_t judged = 0, flat = 0;
    for (int turn = 0; turn < 4000; turn++) {
        std::vector<Place> points(3, Place(2));
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 2; k++) {
                const double x = std::sin(12.9898 * (turn + 1) + 78.233 * (2 * i + k));
                points[i][k] = k == 0 ? std::ldexp(x, -(turn % 32)) : x;
            }
        Sphere sphere;
        REQUIRE(smallest_circumsphere(points, &sphere));
        const Real shape = corner_error(points, sphere).shape;
        Real most = 0;
        for (std::size_t first = 0; first < 3; first++) most = std::max(most, corner_in_doubles(points, first, sphere));
        CHECK(shape < 0x1p-22L);
        flat += shape == 0;  // too flat from each vertex: the corner is found with more digits
        if (turn % 32 >= 12) continue;
        judged++;
        CHECK(most <= shape);
        worst = std::max(worst, most / shape);
    }
    CHECK(judged > 1000);
    CHECK(flat > 100);
    CHECK(worst > 1e-3L);
}

// Pairs beside which nothing is refined further: some cells are so flat that a proof adds more than the tolerance.
TEST_CASE("opinion: nearly flat cells are allowed their own corners' errors, others nothing") {
    PointCloud points = cloud_of(2, {});
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++)
            points.coordinates.push_back(std::sin(1.7 * (i / 2) + 2.3 * k + 1) + (i % 2) * 1e-8 * std::cos(k + i));
    Made made(command({"--method", "netmesh", "--finish"}), points);
    CHECK(made.judge().message == "");
    const CellOpinion opinion =
        cell_opinion(made.files, choice_of(made.options), 1, made.run.engine->diagram.certified_ratio);
    const Real tolerance = opinion.tolerance;
    std::size_t planted = 0, plain = 0;
    for (std::size_t v = 0; v < opinion.values.size(); v++) {
        const Span due = opinion.values[v];
        CHECK(due.most <= due.least * (1 + 0x1p-20L));
        plain += due.most == due.least;
        if (!(due.most > due.least * (1 + 1e-9L)) || planted == 10) continue;
        double& value = made.files.node.attributes[v];
        const double right = value;
        for (const Real wrong : {due.most * (1 + 1.1L * tolerance), due.least * (1 - 1.1L * tolerance)}) {
            value = static_cast<double>(wrong);
            CHECK(made.refuses("follows from the vertex's cell"));
        }
        value = right;
        planted++;
    }
    CHECK(planted > 0);
    CHECK(2 * plain > opinion.values.size());
}

TEST_CASE("opinion: of a function, an error that is too small and forged values are not confirmed") {
    Made made(command({"--filter", "function", "--function", "max(sqrt(x*x + y*y) - 1.2, .2 - abs(x))", "--lipschitz",
                       "1.5", "--cut", "-.3"}));
    const Outcome good = made.judge();
    CHECK(good.message == "");
    double& error = made.run.engine->diagram.certified_error;
    const double certified = error;
    for (const double wrong : {certified * 0.9, certified * 0.5, 0.0}) {
        error = wrong;
        CHECK(made.refuses("more than the error"));
    }
    error = certified;
    // Steps of the error by value.
    double low = HUGE_VAL;
    for (const double t : made.files.node.attributes) low = std::min(low, t);
    const std::string step =
        "# scale " + std::to_string(low) + " low " + std::to_string(low - 9) + " high 9 reach 9 error ";
    made.file.bounds = {{1, step + std::to_string(certified + 1e-5)}};
    CHECK(made.judge().message == "");
    for (const std::string& wrong :
         {step + "0.01", std::string("# scale -9 low -9 high -0.4 reach 9 error 9"), step + "x"}) {
        CAPTURE(wrong);
        made.file.bounds = {{1, wrong}};
        CHECK(made.judge().exit == Exit::check);
    }
    made.file.bounds.clear();
    double& value = made.files.node.attributes[made.files.node.attributes.size() / 2];
    value += 1e-6;
    CHECK(made.refuses("where the function is"));
}

namespace {

// What the function takes at sampled places of each vertex's cell, in the ball where cells are clipped to it.
std::vector<CellRange> sampled_cells(const MeshFiles& files, netmesh_filter_id filter, std::uint32_t k) {
    const NodeFile& node = files.node;
    const FilteredFunction function(node, filter, k);
    const std::vector<double>& x = node.cloud.coordinates;
    std::vector<CellRange> seen(node.cloud.rows(), {HUGE_VALL, 0});
    const auto look = [&](double across, double along) {
        std::size_t best = 0;
        const auto apart2 = [&](std::size_t v) {
            return (x[2 * v] - across) * (x[2 * v] - across) + (x[2 * v + 1] - along) * (x[2 * v + 1] - along);
        };
        for (std::size_t v = 1; v < seen.size(); v++)
            if (apart2(v) < apart2(best)) best = v;
        const Real f = function({across, along});
        seen[best] = {std::min(seen[best].lo, f), std::max(seen[best].hi, f)};
    };
    const double cx = node.domain[0], cy = node.domain[1], radius = node.domain[2];
    for (int turn = 0; turn < 2000; turn++)
        look(cx + radius * (1 - 1e-12) * std::cos(turn * 0.00314159), cy + radius * std::sin(turn * 0.00314159));
    for (int i = -200; i <= 200; i++)
        for (int j = -200; j <= 200; j++)
            if (!node.clipped || i * i + j * j <= 200 * 200) look(cx + radius * i / 200, cy + radius * j / 200);
    return seen;
}

struct ScaleStep {
    Real from, next, low, high, ratio;
};
// Does what was sampled break this claim by shares? `balls`: cells of inputs are there as balls before their values,
// which are as large as the scale.
bool is_broken(const ScaleStep& step, const MeshFiles& files, const std::vector<CellRange>& sampled, bool balls,
               Real below, Real above) {
    for (std::size_t v = 0; v < sampled.size(); v++) {
        const Real t = files.node.attributes[v], enters = std::max(step.from, t), absent = std::min(step.next, t);
        if (t < step.next && sampled[v].hi * (1 - above) > std::min(std::max(step.high, enters), step.ratio * enters))
            return true;
        if (balls && files.node.markers[v] == 0) continue;
        if (t >= step.from && sampled[v].lo < (1 - below) * std::max(std::min(step.low, absent), absent / step.ratio))
            return true;
    }
    return false;
}

}  // namespace

// Sampling tells which forgeries are false: all of those have to be refused that the least value on a cell shows, as it
// is found exactly, and all that the largest one does, which is found nearly.
TEST_CASE("opinion: forged ratios by scale") {
    for (const std::vector<std::string>& making : makings) {
        if (making.back() != "--bounds") continue;
        CAPTURE(making[0]);
        Made made(command(making));
        const netmesh_filter_id filter = filter_of(made.options);
        const std::uint32_t k = std::max(made.options.request.k, 1u);
        const std::vector<CellRange> sampled = sampled_cells(made.files, filter, k);
        const auto number = [](const std::string& text, const std::string& name) {
            return std::strtod(text.c_str() + text.find(" " + name + " ") + name.size() + 2, nullptr);
        };
        std::size_t due = 0, missed = 0, steps = 0, low = 0, high = 0, ratio = 0;
        for (std::size_t i = 0; i < made.file.bounds.size(); i++) {
            BoundLine& line = made.file.bounds[i];
            if (line.text.find("# scale ") != 0) continue;
            steps++;
            const std::string right = line.text;
            const bool last = i + 1 == made.file.bounds.size() || made.file.bounds[i + 1].text.find("# scale ") != 0;
            const ScaleStep said = {number(right, "scale"),
                                    last ? HUGE_VALL : number(made.file.bounds[i + 1].text, "scale"),
                                    number(right, "low"), number(right, "high"), number(right, "ratio")};
            CHECK(!is_broken(said, made.files, sampled, k == 1, 1e-9L, 1e-9L));
            const auto forge = [&](const std::string& name, Real ScaleStep::*claimed, double value) {
                ScaleStep forged = said;
                forged.*claimed = value;
                const std::size_t at = right.find(" " + name + " ") + name.size() + 2;
                line.text = right.substr(0, at) + number_text(value) +
                            right.substr(std::min(right.find(' ', at), right.size()));
                const bool is_refused = made.judge().exit == Exit::check;
                line.text = right;
                const bool is_due = is_broken(forged, made.files, sampled, k == 1, 1e-9L, 0.04L);
                due += is_due;
                missed += is_due && !is_refused;
                return is_refused;
            };
            low += forge("low", &ScaleStep::low, 1e9);
            high += forge("high", &ScaleStep::high, 0);
            ratio += forge("ratio", &ScaleStep::ratio, 1);
            for (const double more : {1.02, 1.1, 1.3, 1.6}) {
                forge("low", &ScaleStep::low, static_cast<double>(said.low * more));
                forge("high", &ScaleStep::high, static_cast<double>(said.high / more));
                forge("ratio", &ScaleStep::ratio, std::max(1.0, static_cast<double>(said.ratio / more)));
            }
        }
        CHECK(steps > 10);
        CHECK(missed == 0);
        // Scales at which no cell is to be judged, as the first and the last, may claim anything.
        CHECK(3 * high >= 2 * steps);
        CHECK(3 * ratio >= 2 * steps);
        CHECK(due > 4 * steps);
        if (!made.files.node.clipped) CHECK(3 * low >= 2 * steps);
        CHECK(made.judge().good());
    }
}

TEST_CASE("opinion: forged cycles") {
    Made made(command({"--method", "svr"}));
    const std::string right = made.cycles();
    std::vector<CycleEntry> cycles;
    CHECK(parse_cycles(right, "c.txt", &cycles).good());
    CHECK(cycles.size() == made.file.bars.size());
    const std::size_t last = right.rfind("bar ");
    made.write(right.substr(0, last));
    CHECK(made.refuses("has no cycle"));
    // Chains of the right form, but of another bar, and one that lacks a simplex.
    const auto forge = [&](std::size_t bar, const std::vector<Vertices>& chain) {
        TextWriter text;
        for (std::size_t i = 0; i < cycles.size(); i++) {
            const std::vector<Vertices>& simplices = i == bar ? chain : cycles[i].simplices;
            text << "bar " << cycles[i].bar.degree << ' ' << cycles[i].bar.birth << ' ' << cycles[i].bar.death << ' '
                 << static_cast<std::uint64_t>(simplices.size()) << '\n';
            for (const Vertices& vertices : simplices) {
                for (std::size_t v = 0; v < vertices.size(); v++)
                    text << vertices[v] << (v + 1 < vertices.size() ? ' ' : '\n');
            }
        }
        made.write(text.text());
    };
    std::size_t forged = 0;
    for (std::size_t i = 0; i + 1 < cycles.size(); i++) {
        const Bar &a = cycles[i].bar, &b = cycles[i + 1].bar;
        if (b.degree != 0 || !std::isfinite(b.death) || a.death == b.death) continue;
        forge(i, cycles[i + 1].simplices);
        CHECK(made.refuses("does not die with it"));
        forge(i + 1, cycles[i].simplices);
        CHECK(made.refuses("dies before it"));
        forged++;
    }
    CHECK(forged > 5);
    std::vector<Vertices> open = cycles.back().simplices;
    CHECK(cycles.back().bar.degree == 1);
    open.pop_back();
    forge(cycles.size() - 1, open);
    CHECK(made.refuses("has a chain with a boundary"));
    made.write(right + "bar 1 1 2 0\n");
    CHECK(made.refuses("its bar is not bar"));
    made.write(right.substr(0, right.size() - 5));
    CHECK(made.judge().exit == Exit::data);
    for (const char* text : {"bar 1 1 2\n", "bar 1 1 2 x\n", "bar 1 2 1 0\n", "1 2\n", "bar 1 1 2 1\n1\n",
                             "bar 1 1 2 1\n2 1\n", "bar 1 1 2 1\nx 1\n", "bar 1 1 2 2\n1 2\n"}) {
        std::vector<CycleEntry> none;
        CHECK(parse_cycles(text, "c.txt", &none).exit == Exit::data);
    }
}

// The places that are looked at must come near to what the certificate allows, or looking would be no test of it.
TEST_CASE("opinion: places of cells nearly use the certified ratio up") {
    for (const std::vector<std::string>& making : makings) {
        CAPTURE(making[1 % making.size()]);
        const Made made(command(making));
        const double c = made.run.engine->diagram.certified_ratio;
        const CellOpinion opinion =
            cell_opinion(made.files, choice_of(made.options), std::max(made.options.request.k, 1u), c);
        double used = 1;
        for (std::size_t v = 0; v < opinion.values.size(); v++) {
            const double t = static_cast<double>(opinion.values[v].least);
            if (t > 0) used = std::fmax(used, static_cast<double>(opinion.seen[v].hi) / t);
            if (t > 0) used = std::fmax(used, t / static_cast<double>(opinion.seen[v].lo));
        }
        CHECK(used <= c * (1 + 1e-9));
        CHECK(used >= 0.75 * c);
    }
}
