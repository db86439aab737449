#include "tools/report/report.hpp"

#include <doctest/doctest.h>

#include <unistd.h>

#include <cstdio>

#include <cmath>

#include "tools/commands/diagram_checks.hpp"
#include "tools/io/numbers.hpp"
#include "tools/report/json.hpp"
#include "tools/sample/shapes.hpp"

using namespace netmesh::tool;

TEST_CASE("JSON: nesting, escapes, numbers that JSON has not") {
    Json json;
    json.open('{');
    json.entry("text", "a\"b\\c\n");
    json.entry("half", 0.5);
    json.entry("infinite", HUGE_VAL);
    json.entry("count", std::uint64_t{18446744073709551615u});
    json.entry("yes", true);
    json.key("list");
    json.open('[');
    json.value(1.0);
    json.null();
    json.open('[');
    json.close(']');
    json.close(']');
    json.key("empty");
    json.open('{');
    json.close('}');
    json.key("print");
    json.fingerprint(0xABCu);
    json.close('}');
    CHECK(json.text() == "{\n  \"text\": \"a\\\"b\\\\c\\u000a\",\n  \"half\": 0.5,\n  \"infinite\": null,\n"
                         "  \"count\": 18446744073709551615,\n  \"yes\": true,\n  \"list\": [1, null, []],\n"
                         "  \"empty\": {},\n  \"print\": \"0000000000000abc\"\n}\n");
}

TEST_CASE("numbers for people") {
    CHECK(grouped_text(7) == "7");
    CHECK(grouped_text(1234567) == "1,234,567");
    CHECK(bytes_text(1023) == "1023 bytes");
    CHECK(bytes_text(1536) == "1.5 KiB");
    CHECK(number_text(-0.0) == "0");
    CHECK(number_text(0.1) == "0.1");
}

TEST_CASE("report of a run that has no engine result: nulls") {
    Options options;
    options.command = Command::size;
    RunReport run;
    run.options = &options;
    run.plan_bytes = 4096;
    const std::string json = json_report(run);
    for (const char* part :
         {"\"schema\": 1", "\"command\": \"size\"", "\"input\": null", "\"mesh\": null", "\"diagram\": null",
          "\"block_bytes\": null", "\"plan_bytes\": 4096", "\"predicates\": null", "\"fingerprint\": null"}) {
        CAPTURE(part);
        CHECK(json.find(part) != std::string::npos);
    }
}

TEST_CASE("report of a mesh and its diagram") {
    Options options;
    options.command = Command::persist;
    netmesh_report engine = netmesh::sized<netmesh_report>();
    engine.input.present = 1;
    engine.input.dim = 2;
    engine.input.points = 10;
    engine.input.duplicates = 1;
    engine.input.fingerprint = 0x1234;
    engine.mesh.present = engine.mesh.is_mesh = 1;
    engine.mesh.vertices = 100;
    engine.mesh.steiner = 80;
    engine.mesh.exempt = 11;
    engine.mesh.cells = 180;
    engine.mesh.tau = 2.5;
    engine.mesh.aspect_ratio_max = 2.25;
    engine.mesh.domain[0] = 1;
    engine.mesh.domain[2] = 3;
    engine.diagram.present = 1;
    engine.diagram.filter = NETMESH_FILTER_BASIC;
    engine.diagram.max_degree = 1;
    engine.diagram.pairs[0] = 9;
    engine.diagram.pairs[1] = 2;
    engine.diagram.certified_ratio = 2.125;
    engine.diagram.certified_from = 0.5;
    engine.predicates.in_ball[NETMESH_PREDICATE_TIE] = 77;
    engine.fingerprint = 0xFEDCBA9876543210u;
    RunReport run;
    run.options = &options;
    run.engine = engine;
    const std::vector<Bar> bars = {{0, 0, HUGE_VAL}, {1, .5, 1}};
    run.bars = &bars;
    const std::string json = json_report(run);
    for (const char* part :
         {"\"points\": 10", "\"duplicates\": 1", "\"steiner\": 80", "\"exempt\": 11", "\"domain\": [1, 0, 3]",
          "\"aspect_ratio_max\": 2.25", "\"pairs\": [9, 2]", "\"certified_ratio\": 2.125", "\"certified_from\": 0.5",
          "\"units\": \"radius\"", "\"field\": \"Z/2\"", "\"tie\": 77", "\"fingerprint\": \"fedcba9876543210\"",
          "\"bars\": [[0, 0, null], [1, 0.5, 1]]", "\"filter\": \"basic\"", "\"fingerprint\": \"0000000000001234\""}) {
        CAPTURE(part);
        CHECK(json.find(part) != std::string::npos);
    }
    const std::string text = text_report(run);
    CHECK(text.find("10 points in R^2, 1 duplicate merged") != std::string::npos);
    CHECK(text.find("certified ratio 2.125 from radius 0.5") != std::string::npos);
}

TEST_CASE("report: what has to be asked for is left out or there as a whole") {
    Options options;
    options.command = Command::mesh;
    netmesh_report engine = netmesh::sized<netmesh_report>();
    engine.input.present = engine.mesh.present = 1;
    engine.input.dim = 2;
    RunReport run;
    run.options = &options;
    run.engine = engine;
    const auto mesh_of = [](const std::string& json) {
        const std::size_t at = json.find("\"mesh\": ");
        return json.substr(at, json.find("\"diagram\"") - at);
    };
    CHECK(mesh_of(json_report(run)) ==
          "\"mesh\": {\n    \"vertices\": 0,\n    \"steiner\": 0,\n    \"exempt\": 0,\n    \"cells\": 0,\n"
          "    \"aspect_ratio_max\": null,\n    \"tau\": null,\n    \"domain\": null\n  },\n  ");
    run.engine->mesh.is_mesh = 1;
    run.engine->mesh.method = NETMESH_METHOD_NETMESH;
    run.engine->mesh.hierarchy.present = 1;
    run.engine->mesh.hierarchy.cages = 4;
    run.engine->mesh.touches = 9;
    run.engine->mesh.goal.ratio = 2;
    run.engine->mesh.audit.what = NETMESH_AUDIT_LOCATION;
    run.engine->mesh.audit.rounds = 2;
    run.engine->mesh.audit.load[0] = 7;
    CHECK(mesh_of(json_report(run)) ==
          "\"mesh\": {\n    \"vertices\": 0,\n    \"steiner\": 0,\n    \"exempt\": 0,\n    \"cells\": 0,\n"
          "    \"aspect_ratio_max\": 0,\n    \"tau\": null,\n    \"ratio\": 2,\n    \"domain\": [0, 0, 0],\n"
          "    \"cages\": 4,\n    \"cages_made\": 0,\n    \"touches\": 9,\n    \"audit\": {\n"
          "      \"location\": {\n        \"load\": [7, 0],\n        \"nets\": 0,\n        \"nets_max\": 0,\n"
          "        \"ply_max\": 0,\n        \"ply_mean\": 0,\n        \"touches_max\": 0,\n"
          "        \"touches_mean\": 0,\n        \"tests_mean\": 0\n      }\n    }\n  },\n  ");
    netmesh_analysis analysis = netmesh::sized<netmesh_analysis>();
    analysis.structure.present = 1;
    run.analysis = analysis;
    const std::string json = json_report(run);
    CHECK(json.find("\"analysis\": {\n    \"size\": null,\n    \"structure\": {\n      \"degree_max\": 0,") !=
          std::string::npos);
    CHECK(json.find("\"what\"") == std::string::npos);
}

TEST_CASE("without a terminal progress is a line of a log now and then, none where it is not wanted") {
    netmesh_progress progress = {};
    progress.stage = NETMESH_STAGE_REFINE;
    progress.done = 2500;
    progress.total = 10000;
    std::FILE* const log = std::tmpfile();
    const int kept = dup(2);
    REQUIRE((log != nullptr && kept >= 0));
    std::fflush(stderr);
    dup2(fileno(log), 2);
    ProgressBar now(true, 0), later(true), never(false, 0);
    for (ProgressBar* const bar : {&now, &later, &never}) {
        bar->show(progress);
        bar->clear();
    }
    now.show(progress);
    std::fflush(stderr);
    dup2(kept, 2);
    close(kept);
    std::rewind(log);
    char text[200] = {};
    const std::size_t bytes = std::fread(text, 1, sizeof text - 1, log);
    std::fclose(log);
    CHECK(std::string(text, bytes) == "refine   2,500 of 10,000   25%  0:00\nrefine   2,500 of 10,000   25%  0:00\n");
}

TEST_CASE("the progress line fits its terminal") {
    netmesh_progress progress = {};
    progress.stage = NETMESH_STAGE_REFINE;
    progress.done = 2500;
    progress.total = 10000;
    progress.vertices = 12345;
    const std::string wide = progress_line(progress, 10, 120);
    CHECK(wide.find("refine") == 0);
    CHECK(wide.find("[##########....") != std::string::npos);
    CHECK(wide.find("2,500 of 10,000   25%  12,345 vertices  0:30 left") != std::string::npos);
    for (int columns = 1; columns < 100; columns++) {
        CHECK(progress_line(progress, 10, columns).size() < static_cast<std::size_t>(columns < 2 ? 100 : columns));
    }
    progress.total = 0;
    CHECK(progress_line(progress, 61, 100).find("2,500  12,345 vertices  1:01") != std::string::npos);
}

TEST_CASE("what every diagram must satisfy") {
    const Bar essential = {0, 0, HUGE_VAL};
    CHECK(diagram_complaint({{0, 0, 1}, essential, {1, .5, 1}}) == "");
    CHECK(diagram_complaint({}) == "no essential class");
    CHECK(diagram_complaint({{0, 0, 1}}) == "no essential class");
    CHECK(diagram_complaint({essential, essential}) == "more than one essential class");
    CHECK(diagram_complaint({essential, {1, 0, HUGE_VAL}}) != "");
    CHECK(diagram_complaint({{0, .5, HUGE_VAL}}) == "");  // of a function that is not 0 anywhere
    CHECK(diagram_complaint({{0, .25, 1}, {0, .5, HUGE_VAL}}) != "");
    CHECK(diagram_complaint({essential, {1, 2, 1}}) != "");
    CHECK(diagram_complaint({essential, {0, 0, 1}}) != "");
    std::size_t at = 0;
    diagram_complaint({essential, {1, 1, 2}, {1, .5, 2}}, &at);
    CHECK(at == 2);
}

TEST_CASE("the first difference of two diagrams") {
    const std::vector<Bar> a = {{0, 0, 1}, {1, 1, 2}}, b = {{0, 0, 1}, {1, 1, 3}}, c = {{0, 0, 1}};
    CHECK(first_difference(a, a) == SIZE_MAX);
    CHECK(first_difference(a, b) == 1);
    CHECK(first_difference(a, c) == 1);
    CHECK(bar_text(a, 1) == "1 1 2");
    CHECK(bar_text(c, 1) == "nothing");
}

namespace {

std::vector<double> sample(const std::string& shape, std::uint64_t count, std::uint32_t dim, std::uint64_t seed = 1) {
    SampleRequest request;
    request.shape = shape;
    request.count = count;
    request.dim = dim;
    request.seed = seed;
    std::vector<double> points;
    std::uint32_t found = 0;
    const Outcome outcome = sample_points(request, &points, &found);
    CAPTURE(shape);
    CHECK(outcome.message == "");
    CHECK(points.size() == count * found);
    if (dim != 0) CHECK(found == dim);
    return points;
}

double norm(const double* x, std::uint32_t dim) {
    double sum = 0;
    for (std::uint32_t k = 0; k < dim; k++) sum += x[k] * x[k];
    return std::sqrt(sum);
}

}  // namespace

TEST_CASE("samples lie where their names say") {
    for (std::uint32_t dim = 2; dim <= 6; dim++) {
        const std::vector<double> ball = sample("ball", 200, dim), sphere = sample("sphere", 200, dim);
        const std::vector<double> annulus = sample("annulus", 200, dim), zoom = sample("zoom", 200, dim);
        for (std::uint32_t i = 0; i < 200; i++) {
            CHECK(norm(&ball[i * dim], dim) <= 1 + 1e-12);
            CHECK(norm(&sphere[i * dim], dim) == doctest::Approx(1));
            CHECK(norm(&annulus[i * dim], dim) > 0.6 - 1e-12);
            CHECK(norm(&zoom[i * dim], dim) == doctest::Approx(std::ldexp(1, -static_cast<int>(i))));
        }
    }
    CHECK(sample("grid", 5, 2) == std::vector<double>{0, 0, 0, 1, 0, 2, 1, 0, 1, 1});
    const std::vector<double> clifford = sample("clifford", 2000, 0);
    CHECK(norm(&clifford[0], 4) == doctest::Approx(std::sqrt(2)));
    const double step[] = {clifford[4] - clifford[0], clifford[5] - clifford[1], clifford[6] - clifford[2],
                           clifford[7] - clifford[3]};
    CHECK(std::log(norm(step, 4) / 2) == doctest::Approx(-4.15).epsilon(0.01));
    const std::vector<double> torus = sample("torus", 100, 0);
    for (int i = 0; i < 100; i++) {
        const double ring = std::hypot(torus[3 * i], torus[3 * i + 1]) - 1;
        CHECK(std::hypot(ring, torus[3 * i + 2]) == doctest::Approx(0.4));
    }
}

TEST_CASE("samples depend on shape, count and seed alone") {
    CHECK(sample("cube", 50, 3) == sample("cube", 50, 3));
    CHECK(sample("cube", 50, 3) != sample("cube", 50, 3, 2));
    CHECK(sample("clusters", 50, 2) == sample("clusters", 50, 2));
    for (const char* shape : {"circle", "curve", "figure-eight", "helix"}) CHECK(sample(shape, 30, 0).size() > 0);
    // xoshiro256++ from splitmix64(1), top 53 bits.
    CHECK(sample("cube", 1, 2)[0] == doctest::Approx(0.811612).epsilon(1e-6));
}

TEST_CASE("samples that cannot be") {
    SampleRequest request;
    std::vector<double> points;
    std::uint32_t dim;
    request.shape = "frob";
    request.count = 3;
    CHECK(sample_points(request, &points, &dim).exit == Exit::usage);
    request.shape = "torus";
    request.dim = 2;
    CHECK(sample_points(request, &points, &dim).exit == Exit::usage);
    request.shape = "zoom";
    request.count = 2000;
    CHECK(sample_points(request, &points, &dim).exit == Exit::usage);
}
