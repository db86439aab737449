// Pictures: what they show, that no two of their texts touch, and that their colours are told apart.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "netmesh.hpp"
#include "tests/common/inputs.hpp"
#include "tools/commands/output.hpp"
#include "tools/plot/barcode.hpp"
#include "tools/plot/plots.hpp"
#include "tools/plot/text_width.hpp"

using namespace netmesh::tool;
using inputs::Random;

namespace {

// The room that a text takes.
struct TextBox {
    std::string words;
    double low_x, high_x, low_y, high_y;
};

double attribute(const std::string& element, const char* name) {
    const std::size_t at = element.find(std::string(" ") + name + "=\"");
    return at == std::string::npos ? 0 : std::strtod(element.c_str() + at + std::string(name).size() + 3, nullptr);
}

std::string unescaped(std::string text) {
    for (const auto& [code, letter] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
        for (std::size_t at; (at = text.find(code)) != std::string::npos;)
            text.replace(at, std::string(code).size(), letter);
    }
    return text;
}

std::vector<TextBox> boxes_of(const std::string& picture) {
    std::vector<TextBox> boxes;
    for (std::size_t at = 0; (at = picture.find("<text", at)) != std::string::npos; at++) {
        const std::size_t end = picture.find('>', at);
        const std::string element = picture.substr(at, end - at);
        const double size = attribute(element, "font-size");
        const std::string words = unescaped(picture.substr(end + 1, picture.find("</text>", end) - end - 1));
        const double width = text_width(words, size, element.find("bold") != std::string::npos);
        const double before = element.find("middle") != std::string::npos    ? 0.5
                              : element.find("\"end\"") != std::string::npos ? 1
                                                                             : 0;
        const double above = 0.78 * size, below = 0.23 * size;
        const std::size_t turned = element.find("translate(");
        if (turned == std::string::npos) {
            const double x = attribute(element, "x"), y = attribute(element, "y");
            boxes.push_back({words, x - before * width, x + (1 - before) * width, y - above, y + below});
        } else {
            char* rest = nullptr;
            const double x = std::strtod(element.c_str() + turned + 10, &rest), y = std::strtod(rest, nullptr);
            boxes.push_back({words, x - above, x + below, y - (1 - before) * width, y + before * width});
        }
    }
    return boxes;
}

// What is wrong with the texts of a picture: two that touch, or one that leaves the page.
std::string text_fault(const std::string& picture) {
    const std::vector<TextBox> boxes = boxes_of(picture);
    const std::string head = picture.substr(0, picture.find('>'));
    const double width = attribute(head, "width"), height = attribute(head, "height");
    for (std::size_t i = 0; i < boxes.size(); i++) {
        const TextBox& a = boxes[i];
        if (a.low_x < 0 || a.low_y < 0 || a.high_x > width || a.high_y > height) return "outside: " + a.words;
        for (std::size_t j = 0; j < i; j++) {
            const TextBox& b = boxes[j];
            if (a.low_x < b.high_x && b.low_x < a.high_x && a.low_y < b.high_y && b.low_y < a.high_y)
                return a.words + " | " + b.words;
        }
    }
    return "";
}

// A document with title and description and with numbers that are some.
void check_whole(const std::string& picture) {
    CHECK(picture.rfind("<svg ", 0) == 0);
    CHECK(picture.substr(picture.size() - 7) == "</svg>\n");
    CHECK(picture.find("<title id=\"title\">") != std::string::npos);
    CHECK(picture.find("<desc id=\"description\">") != std::string::npos);
    CHECK_MESSAGE(picture.find("nan") == std::string::npos, picture.substr(picture.find("nan") - 60, 100));
    CHECK(picture.find("\"inf") == std::string::npos);
    CHECK(picture.find("\"-inf") == std::string::npos);
    CHECK(text_fault(picture) == "");
}

netmesh_report report_of(std::uint32_t dim, std::uint64_t points) {
    netmesh_report report = netmesh::sized<netmesh_report>();
    report.input.dim = dim;
    report.input.points = points;
    report.mesh.present = report.mesh.is_mesh = 1;
    report.mesh.vertices = 12;
    report.mesh.tau = 2.5;
    report.diagram.filter = NETMESH_FILTER_COMPLETE;
    report.diagram.max_degree = dim - 1;
    report.diagram.certified_ratio = 2;
    return report;
}

// A value of the magnitude that `kind` says: ordinary, wide, narrow, huge, tiny.
double some_value(Random& random, int kind) {
    switch (kind) {
    case 1: return std::exp(60 * random.uniform() - 30);
    case 2: return 1e9 + 3 * random.uniform();
    case 3: return std::exp(1000 * random.uniform() - 500);
    case 4: return 1e-300 * random.uniform();
    default: return random.uniform();
    }
}

std::string some_diagram(std::uint64_t seed) {
    Random random(seed);
    const std::uint32_t degrees = 1 + static_cast<std::uint32_t>(seed % 6);
    netmesh_report report =
        report_of(2 + static_cast<std::uint32_t>(seed % 5), seed % 7 == 0 ? 1 : 1234567890123456789u);
    report.diagram.max_degree = degrees - 1;
    report.diagram.simplices = 98765432109876543u;
    report.mesh.vertices = report.mesh.cells = 18446744073709551615u;
    report.mesh.aspect_ratio_max = 1.2345678e-9;
    report.diagram.certified_ratio = seed % 4 == 0 ? 1 : 1 + 3 * random.uniform();
    report.diagram.certified_from = seed % 3 == 0 ? 1.234e-7 : 0;
    report.diagram.filter = static_cast<netmesh_filter_id>(seed / 3 % NETMESH_FILTER_FUNCTION + 1);
    const bool is_complex = seed % 11 == 3, is_function = seed % 5 == 2 && !is_complex;
    if (is_complex) {
        report.input.dim = 0;
        report.diagram.filter = NETMESH_FILTER_NONE;
        report.diagram.certified_ratio = 1;
        report.simplicial_complex.vertices = 123456789012345u;
        for (std::uint64_t& betti : report.diagram.essential) betti = 1234567890123456789u;
    }
    if (is_function) {
        report.diagram.filter = NETMESH_FILTER_FUNCTION;
        report.diagram.certified_error = 0.1;
    }
    const int kind = static_cast<int>(seed / 2 % 5);
    const bool negative = is_complex || is_function;
    std::vector<Bar> bars;
    const std::size_t count = seed % 13 == 0 ? 0 : seed % 3 == 0 ? 3 : 300;
    for (std::size_t i = 0; i < count; i++) {
        double birth = some_value(random, kind), death = some_value(random, kind);
        if (negative && i % 2 == 0) birth = -birth;
        if (!negative && i % 5 == 0) birth = 0;
        if (death < birth) std::swap(birth, death);
        bars.push_back({static_cast<std::uint32_t>(i) % degrees, birth, i % 17 == 0 ? HUGE_VAL : death});
    }
    std::sort(bars.begin(), bars.end(), comes_before);
    Bounds bounds;
    if (seed % 4 == 1) {
        bounds.bars.resize(bars.size());
        for (std::size_t i = 0; i < bars.size(); i++) bounds.bars[i].certain = i % 2;
        bounds.steps = {{0, 0, 0, 1, 1, HUGE_VAL, 0.1}, {0, .6, .5, 1, 1, 1.8, 0.1}, {0, 1.1, .5, 3, 1.1, 1, 0.1}};
    }
    return diagram_picture(bars, report, bounds, static_cast<Axis>(seed / 5 % 3));
}

std::string some_vineyard(std::uint64_t seed) {
    Random random(seed);
    Vines vines;
    vines.k_first = seed % 2 == 0 ? 1 : 4294960000u;
    vines.ratios.assign(1 + seed % 50 * 20, 2.0);
    netmesh_report report = report_of(3, 1);
    report.vineyard.filter = seed % 3 == 0 ? NETMESH_FILTER_NONE : NETMESH_FILTER_KNN;
    report.vineyard.simplices = seed % 6 == 0 ? 1 : 12345678901234567u;
    report.vineyard.max_degree = static_cast<std::uint32_t>(seed % 3);
    report.vineyard.k_first = vines.k_first;
    report.vineyard.k_last = vines.k_first + static_cast<std::uint32_t>(vines.ratios.size()) - 1;
    for (std::uint32_t i = 0; i < 80; i++) {
        const double birth = some_value(random, static_cast<int>(seed % 5)) - (seed % 4 == 0 ? 1 : 0);
        const double death = i == 0 ? HUGE_VAL : std::max(birth, some_value(random, static_cast<int>(seed % 5)));
        vines.points.push_back({0, i, i % (report.vineyard.max_degree + 1), vines.k_first, birth, death});
    }
    return vineyard_picture(vines, report, static_cast<Axis>(seed % 3));
}

std::string some_mesh(std::uint64_t seed) {
    Random random(seed);
    const std::uint32_t dim = 2 + static_cast<std::uint32_t>(seed % 2);
    std::vector<double> points;
    for (std::size_t i = 0; i < dim * (3 + seed % 20); i++) points.push_back(random.uniform());
    std::vector<double> block((16u << 20) / sizeof(double));
    netmesh::Engine engine(block.data(), block.size() * sizeof(double));
    netmesh::Request request;
    request.set_points(dim, points);
    request.mesh.method = seed % 4 == 0 ? &netmesh_method_netmesh : &netmesh_method_svr;
    REQUIRE(engine.mesh(request) == NETMESH_OK);
    TextWriter out;
    write_mesh_picture(EngineMesh(engine), dim == 2 && seed % 3 == 0, out);
    return out.text();
}

std::string some_cycles(std::uint64_t seed) {
    Random random(seed);
    CyclePlaces places;
    places.dim = 2 + static_cast<std::uint32_t>(seed % 2);
    for (std::size_t i = 0; i < 40 * places.dim; i++)
        places.coordinates.push_back(some_value(random, static_cast<int>(seed % 5)));
    places.inputs = 30;
    std::vector<CycleEntry> cycles;
    for (std::uint32_t i = 0; i + 3 < 40; i++) {
        const double birth = some_value(random, 3);
        cycles.push_back({{i % 4, birth, i % 7 == 0 ? HUGE_VAL : 2 * birth}, {{i, i + 1, i + 2, i + 3}}, 0});
        cycles.back().simplices[0].resize(i % 4 + 1);
    }
    TextWriter out;
    write_cycle_picture(cycles, places, out);
    return out.text();
}

using Colour = std::vector<double>;  // red, green, blue in proportion to light

Colour light_of(const std::string& colour) {
    Colour light;
    for (std::size_t i = 1; i < 7; i += 2) {
        const double value = static_cast<double>(std::stoul(colour.substr(i, 2), nullptr, 16)) / 255;
        light.push_back(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
    }
    return light;
}

// As somebody sees it who lacks one kind of cone: Machado, Oliveira, Fernandes 2009, severity 1.
using Sight = double[3][3];
constexpr Sight sights[] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}},
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}},
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

// CIE L*a*b*, in which distances are differences as seen.
std::vector<double> lab_of(const Colour& light, const Sight& sight) {
    double c[3];
    for (int i = 0; i < 3; i++)
        c[i] = std::clamp(sight[i][0] * light[0] + sight[i][1] * light[1] + sight[i][2] * light[2], 0.0, 1.0);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f((.4124 * c[0] + .3576 * c[1] + .1805 * c[2]) / .95047);
    const double y = f(.2126 * c[0] + .7152 * c[1] + .0722 * c[2]);
    const double z = f((.0193 * c[0] + .1192 * c[1] + .9505 * c[2]) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(const std::string& a, const std::string& b, const Sight& sight) {
    const std::vector<double> p = lab_of(light_of(a), sight), q = lab_of(light_of(b), sight);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double contrast_to_white(const std::string& colour) {
    const Colour light = light_of(colour);
    return 1.05 / (.2126 * light[0] + .7152 * light[1] + .0722 * light[2] + .05);
}

double least_distance(const std::vector<std::string>& colours) {
    double least = HUGE_VAL;
    for (const Sight& sight : sights)
        for (std::size_t i = 0; i < colours.size(); i++)
            for (std::size_t j = 0; j < i; j++) least = std::min(least, distance(colours[i], colours[j], sight));
    return least;
}

}  // namespace

TEST_CASE("no two texts touch and none leaves the page in 200 pictures of all kinds") {
    for (std::uint64_t seed = 0; seed < 110; seed++) {
        CAPTURE(seed);
        check_whole(some_diagram(seed));
    }
    for (std::uint64_t seed = 0; seed < 40; seed++) {
        CAPTURE(seed);
        check_whole(some_vineyard(seed));
    }
    for (std::uint64_t seed = 0; seed < 30; seed++) {
        CAPTURE(seed);
        check_whole(some_mesh(seed));
    }
    for (std::uint64_t seed = 0; seed < 20; seed++) {
        CAPTURE(seed);
        check_whole(some_cycles(seed));
    }
}

TEST_CASE("texts that touch or leave the page are seen") {
    const auto page = [](const std::string& texts) { return "<svg width=\"100\" height=\"50\">" + texts + "</svg>\n"; };
    const std::string first = "<text x=\"10\" y=\"20\" font-size=\"10\">abcdef</text>";
    CHECK(text_fault(page(first + "<text x=\"60\" y=\"20\" font-size=\"10\">abc</text>")) == "");
    CHECK(text_fault(page(first + "<text x=\"60\" y=\"20\" font-size=\"10\" text-anchor=\"middle\">abcdef</text>")) !=
          "");
    CHECK(text_fault(page(first + "<text x=\"10\" y=\"28\" font-size=\"10\">a</text>")) != "");
    CHECK(text_fault(page("<text x=\"90\" y=\"20\" font-size=\"10\">abc</text>")) != "");
    CHECK(text_fault(page(first + "<text transform=\"translate(20 25) rotate(-90)\" font-size=\"10\">a</text>")) != "");
}

TEST_CASE("texts are broken at blanks and cut short where they are too long") {
    CHECK(text_width("", 10) == 0);
    CHECK(text_width("iiii", 10) < text_width("MMMM", 10));
    CHECK(text_width("H", 10) < text_width("H", 10, true));
    CHECK(text_width("\xE2\x82\x81", 10) < text_width("1", 10));
    const std::string words = "certified ratio c = 2, within ln c of the exact diagram";
    const std::vector<std::string> lines = wrapped_text(words, 13, false, 120);
    REQUIRE(lines.size() > 2);
    std::string joined;
    for (const std::string& line : lines) {
        CHECK(text_width(line, 13) <= 120);
        joined += (joined.empty() ? "" : " ") + line;
    }
    CHECK(joined == words);
    const std::string cut = fitted_text("H\xE2\x82\x81\xE2\x82\x81\xE2\x82\x81 many bars", 12, false, 40);
    CHECK(text_width(cut, 12) <= 40);
    CHECK(cut.substr(cut.size() - 3) == "\xE2\x80\xA6");
}

TEST_CASE("colours are told apart with each kind of colour blindness, and seen on white") {
    // Red and green are not, for one.
    CHECK(least_distance({"#c00000", "#707000"}) < 15);
    std::vector<std::string> degrees;
    for (std::uint32_t degree = 0; degree < 6; degree++) {
        degrees.emplace_back(degree_colour(degree));
        CHECK(contrast_to_white(degrees.back()) >= 3);
        for (std::uint32_t other = 0; other < degree; other++) CHECK(degree_mark(degree) != degree_mark(other));
    }
    MESSAGE("least distance of six degrees: ", least_distance(degrees));
    CHECK(least_distance(degrees) >= 35);
    degrees.resize(3);
    MESSAGE("of the first three: ", least_distance(degrees));
    CHECK(least_distance(degrees) >= 38);
    CHECK(least_distance({input_colour, steiner_colour, boundary_colour}) >= 38);
    for (const char* text : {ink, faint_ink}) CHECK(contrast_to_white(text) >= 4.5);
    CHECK(contrast_to_white(doubt_line) >= 3);
}

TEST_CASE("the diagram is a square with equal axes; bars that are certified to exist come first, the longest first") {
    netmesh_report report = report_of(2, 4);
    const std::vector<Bar> bars = {{0, 0, HUGE_VAL}, {1, .5, .6}, {1, .5, 2.5}, {1, .1, .3}, {1, .1, 1.5}};
    for (const Axis axis : {Axis::log, Axis::linear}) {
        const std::string picture = diagram_picture(bars, report, {}, axis);
        std::size_t at = picture.rfind("fill=\"none\" stroke=\"" + std::string(ink));
        at = picture.rfind("<rect", at);
        const std::string frame = picture.substr(at, picture.find('>', at) - at);
        const double zero = axis == Axis::log ? zero_column : 0;
        CHECK(attribute(frame, "width") - zero == attribute(frame, "height") - infinity_row);
        CHECK(attribute(frame, "width") - zero > 400);
    }
    const ValueScale scale = scale_for(bars, false);
    const BarStyle style = style_of(bars, report, {});
    const std::vector<BarGroup> groups = group_bars(bars, 1, 24, scale, style);
    REQUIRE(groups[1].shown.size() == 4);
    CHECK(groups[1].labelled == 2);
    CHECK(groups[1].certified == 2);
    CHECK(groups[1].shown[0] == Bar{1, .1, 1.5});  // 15 times; certified from 4 times on
    CHECK(groups[1].shown[1] == Bar{1, .5, 2.5});
    CHECK(groups[1].shown[2] == Bar{1, .1, .3});
    CHECK(groups[1].shown[3] == Bar{1, .5, .6});
    const std::string picture = diagram_picture(bars, report);
    CHECK(picture.find(">0.1 to 1.5<") < picture.find(">0.5 to 2.5<"));
    CHECK(picture.find(">0.5 to 2.5<") != std::string::npos);
    CHECK(picture.find(">0.1 to 0.3<") == std::string::npos);
}

TEST_CASE("degree 0 shows the components that stand apart, the others as a curve") {
    std::vector<Bar> bars = {{0, 0, HUGE_VAL}, {0, 0, 3}, {0, 0, 2.9}};
    for (int i = 0; i < 1000; i++) bars.push_back({0, 0, 0.5 + 0.0001 * i});
    const netmesh_report report = report_of(2, 1003);
    const BarStyle style = style_of(bars, report, {});
    for (const bool linear : {false, true}) {
        const std::vector<BarGroup> groups = group_bars(bars, 0, 24, scale_for(bars, linear), style);
        CHECK(groups[0].shown.size() == 3);
        CHECK(groups[0].rest.size() == 1000);
        CHECK(groups[0].total == 1003);
    }
    CHECK(diagram_picture(bars, report).find("up to 1,000 at once") != std::string::npos);
    CHECK(diagram_picture(bars, report).find("1,000 as a curve") != std::string::npos);
}

TEST_CASE("values near the largest double of either sign are drawn in the picture") {
    constexpr double inf = std::numeric_limits<double>::infinity();
    netmesh_report report = {};
    report.diagram.max_degree = 0;
    const std::vector<Bar> bars = {{0, -1.7e308, inf}, {0, -1e308, 1.7e308}, {0, 1, 1.2e308}};
    const ValueScale scale = scale_for(bars, true);
    for (const double value : {-1.7e308, -1e308, 1.0, 1.2e308, 1.7e308}) {
        CHECK(scale.share(value) >= 0);
        CHECK(scale.share(value) <= 1);
    }
    const std::string picture = diagram_picture(bars, report);
    CHECK(picture.find("inf") == std::string::npos);
    CHECK(picture.find("nan") == std::string::npos);
}

TEST_CASE("ticks are round, and labels tell them apart") {
    const auto labels = [](const std::vector<Bar>& bars, bool linear) {
        const ValueScale scale = scale_for(bars, linear);
        std::string text;
        for (const double tick : scale.ticks()) text += scale.label(tick) + " ";
        return text;
    };
    CHECK(labels({{0, 1, 100}}, false) == "1 2 5 10 20 50 100 ");
    CHECK(labels({{0, 1e-8, 1e8}}, false) == "1e-08 1e-06 0.0001 0.01 1 100 10000 1e+06 1e+08 ");
    CHECK(labels({{0, -2, 2}}, true) == "\xE2\x88\x92"
                                        "2 \xE2\x88\x92"
                                        "1 0 1 2 ");
    CHECK(labels({{0, 1e9, 1e9 + 3}}, true).find("1000000001.5 ") != std::string::npos);
}

TEST_CASE("pictures are whole documents that show what they should") {
    netmesh_report report = report_of(2, 3);
    std::vector<Bar> bars = {{0, 0, HUGE_VAL}, {1, .5, .6}, {1, .5, 2.5}};
    for (int i = 0; i < 1000; i++) bars.push_back({0, 0, 0.001 * (i + 1)});
    const std::string picture = diagram_picture(bars, report);
    check_whole(picture);
    for (const char* words : {"1,001 bars", "certified ratio c = 2", "filter complete", "3 points in R", "radius r",
                              "never dies", "column of bars that are born at 0"})
        CHECK_MESSAGE(picture.find(words) != std::string::npos, words);
    CHECK(picture.find("c(r)") == std::string::npos);
    // The ratio by scale as a curve, cut at the diagram's where it is larger; not of a single ratio.
    Bounds bounds;
    bounds.bars.resize(bars.size());
    bounds.steps = {{0, 0, HUGE_VAL, HUGE_VAL, HUGE_VAL, 2, 0}};
    CHECK(diagram_picture(bars, report, bounds).find("c(r)") == std::string::npos);
    bounds.steps = {{0, 0, 0, 1, 1, HUGE_VAL, 0}, {0, .6, .5, 1, 1, 1.8, 0}, {0, 1.1, HUGE_VAL, 1, 1.1, 1, 0}};
    const std::string curve = diagram_picture(bars, report, bounds);
    CHECK(curve.find("c(r)") != std::string::npos);
    check_whole(curve);
    const std::string lonely = diagram_picture({{0, 0, HUGE_VAL}}, report_of(2, 1));
    check_whole(lonely);
    CHECK(lonely.find("1 bar<") != std::string::npos);
    CHECK(lonely.find("1 point in") != std::string::npos);
    // Values below 0 are drawn as they are.
    report.input.dim = 0;
    report.diagram.certified_ratio = 1;
    const std::string negative = diagram_picture({{0, -2, 0}, {0, -2, 1}, {0, -3, HUGE_VAL}}, report);
    check_whole(negative);
    CHECK(negative.find(">\xE2\x88\x92"
                        "2 to 1<") != std::string::npos);
    CHECK(negative.find("certified to exist") == std::string::npos);  // all bars of an exact diagram do
    CHECK(negative.find("value v") != std::string::npos);
}

TEST_CASE("pictures of meshes: each edge once, each Voronoi edge once, a legend of all there is") {
    // Six points around a seventh, and three far away: the cell of the seventh is closed.
    const std::vector<double> points = {0, 0, 1, 0, .5, .8, -.5, .8, -1, 0, -.5, -.8, .5, -.8};
    std::vector<double> block((8u << 20) / sizeof(double));
    netmesh::Engine engine(block.data(), block.size() * sizeof(double));
    netmesh::Request request;
    request.set_points(2, points);
    request.mesh.method = &netmesh_method_delaunay;
    REQUIRE(engine.mesh(request) == NETMESH_OK);
    const auto picture_of = [&](bool voronoi) {
        TextWriter out;
        write_mesh_picture(EngineMesh(engine), voronoi, out);
        check_whole(out.text());
        return out.text();
    };
    const auto strokes = [](const std::string& picture) {
        const std::size_t from = picture.find("<g clip-path"), to = picture.find("</g>", from);
        std::size_t count = 0;
        for (std::size_t at = from; (at = picture.find('M', at)) < to; at++) count++;
        return count;
    };
    const std::string triangles = picture_of(false), cells = picture_of(true);
    CHECK(strokes(triangles) == 12);
    CHECK(triangles.find("6 triangles") != std::string::npos);
    CHECK(triangles.find("7 inputs") != std::string::npos);
    CHECK(triangles.find(">domain<") == std::string::npos);
    CHECK(strokes(cells) == 6);
    CHECK(cells.find("Voronoi cells of 6 corners") != std::string::npos);
    // The one closed cell: out-radius over distance to the second nearest input is between 1/2 and 1.
    CHECK(cells.find("fill=\"#d6e4f0\"/>\n<path") != std::string::npos);

    request.mesh.method = &netmesh_method_netmesh;
    REQUIRE(engine.mesh(request) == NETMESH_OK);
    const std::string whole = picture_of(false);
    for (const char* words : {"7 inputs", ">domain<", "edges that end at the boundary"})
        CHECK_MESSAGE(whole.find(words) != std::string::npos, words);
}

TEST_CASE("a picture of cycles shows the longest, nearer parts after farther ones") {
    CyclePlaces places;
    places.dim = 3;
    places.coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    places.inputs = 4;
    const std::vector<CycleEntry> cycles = {{{1, .5, 2}, {{0, 1}, {0, 2}, {1, 2}}, 0},
                                            {{1, .5, .6}, {{0, 1}, {0, 3}, {1, 3}}, 0},
                                            {{2, 1, HUGE_VAL}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}, 0}};
    TextWriter out;
    write_cycle_picture(cycles, places, out);
    const std::string picture = out.text();
    check_whole(picture);
    CHECK(picture.find("4 points") != std::string::npos);
    CHECK(picture.find("from 0.5 to 2<") != std::string::npos);
    CHECK(picture.find("from 0.5 to 0.6<") == std::string::npos);
    std::size_t edges = 0, triangles = 0;
    for (std::size_t at = 0; (at = picture.find("<path", at)) != std::string::npos; at++) edges++;
    for (std::size_t at = 0; (at = picture.find("fill-opacity=\"0.22\"", at)) != std::string::npos; at++) triangles++;
    CHECK(edges == 3);
    CHECK(triangles == 4);
}
