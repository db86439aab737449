// Functions from the command line: values at the vertices of a mesh, pictures, the least error that fits.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "run.hpp"

namespace {

// What a program of the user's would do: a value for each vertex of the mesh, on a line of its own.
std::string values_at_vertices(const std::string& node, const std::function<double(double, double)>& f) {
    std::istringstream lines(node);
    std::string line, text = "# of a program\n";
    bool header = true;
    while (std::getline(lines, line)) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        double id, x, y;
        if (words >> id >> x >> y && !header) {
            char value[40];
            std::snprintf(value, sizeof value, "%.17g\n", f(x, y));
            text += value;
        }
        header = false;
    }
    return text;
}

std::string with_line(const std::string& text, std::size_t number, const std::string& line) {
    std::istringstream lines(text);
    std::string out, each;
    for (std::size_t n = 1; std::getline(lines, each); n++) out += (n == number ? line : each) + "\n";
    return out;
}

// The first line that begins so has another one in its place.
std::string with_head(const std::string& text, const std::string& name, const std::string& line) {
    std::istringstream lines(text);
    std::string out;
    for (std::string each; std::getline(lines, each);) out += (each.rfind("# " + name, 0) == 0 ? line : each) + "\n";
    return out;
}

double number_after(const std::string& text, const std::string& name) {
    const std::size_t at = text.find(name);
    return at == std::string::npos ? HUGE_VAL : std::strtod(text.c_str() + at + name.size(), nullptr);
}

}  // namespace

TEST_CASE(
    "values at the vertices of a mesh: the diagram of the expression, checked, and refused with line and reason") {
    const Folder folder;
    REQUIRE(folder.run("sample circle -n 40 -o p.txt").exit == 0);
    REQUIRE(folder.run("mesh p.txt --cell-size .1 -o m.node --quiet").exit == 0);
    const std::string node = folder.read("m.node");
    const auto f = [](double x, double y) { return std::fabs(std::sqrt(x * x + y * y) - 0.6) - 0.1; };
    const std::string values = values_at_vertices(node, f);
    folder.write("v.txt", values);
    const std::string how = " --filter function --lipschitz 1 --cut .2 --values thesis";
    const Result made =
        folder.run("persist m.node --values-at v.txt --bounds --check --svg d.svg -o d.pers --mesh n.node "
                   "--representatives c.txt" +
                   how);
    CHECK(made.exit == 0);
    CHECK(made.says("certified error"));
    const std::string text = folder.read("d.pers");
    CHECK(text.find("# function") == std::string::npos);
    CHECK(text.find("# tau") == std::string::npos);
    CHECK(text.find("# values-at ") != std::string::npos);
    CHECK(text.find("# mesh ") != std::string::npos);
    CHECK(number_after(text, "# certified-error ") <= 0.1);
    CHECK(text.find(" error 0.") != std::string::npos);
    CHECK(folder.read("n.node").find("# cell-size 0.1") != std::string::npos);
    // The same values by the expression, on the mesh that its options make: a mesh of the same points and sizes.
    REQUIRE(folder.run("persist p.txt --function 'abs(sqrt(x*x + y*y) - .6) - .1' --quiet -o e.pers --error .1" + how)
                .exit == 0);
    CHECK(number_after(folder.read("e.pers"), "# certified-error ") <= 0.1);

    for (const std::string mesh : {"m.node", "n.node"}) {
        CAPTURE(mesh);
        const Result check = folder.run("check d.pers --values-at v.txt --representatives c.txt --mesh " + mesh);
        CHECK(check.exit == 0);
        CHECK(check.out.find("of the values in v.txt") != std::string::npos);
        CHECK(check.out.find("second opinion: the function keeps to the error") != std::string::npos);
        CHECK(check.out.find(" by value,") != std::string::npos);
        CHECK(check.out.find("are the pairs of a plain reduction") != std::string::npos);
        CHECK(check.out.find("cycles are closed") != std::string::npos);
    }
    CHECK(folder.run("check n.node --values-at v.txt" + how).out.find("values are those of filter function") !=
          std::string::npos);
    CHECK(folder.run("check d.pers").says("--mesh MESH.node and --values-at FILE are what to check that with"));
    CHECK(folder.run("check d.pers --mesh m.node").says("--values-at FILE says which"));
    CHECK(folder.run("check d.pers --points p.txt --values-at v.txt").says("--values-at goes with --mesh"));
    CHECK(folder.run("check e.pers --mesh m.node --values-at v.txt").says("was made without --values-at"));

    const auto wrong = [&](const std::string& file, const std::string& mesh, const std::string& why) {
        CAPTURE(why);
        const Result check = folder.run("check " + file + " --values-at v.txt --mesh " + mesh);
        CHECK(check.exit == 7);
        CHECK_MESSAGE(check.says(why), check.err);
    };
    folder.write("v.txt", with_line(values, 20, "0.05"));
    wrong("d.pers", "m.node", "the values of v.txt have the fingerprint");
    folder.write("v.txt", values);
    REQUIRE(folder.run("mesh p.txt --cell-size .1 --seed 5 -o o.node --quiet").exit == 0);
    if (folder.read("o.node") != node) {
        folder.write("w.txt", values_at_vertices(folder.read("o.node"), f));
        CHECK(folder.run("check d.pers --values-at w.txt --mesh o.node").says("of this mesh have the fingerprint"));
    }
    const std::string forged[][2] = {{"certified-error", "# certified-error 0.05"},
                                     {"lipschitz", "# lipschitz 0.9"},
                                     {"lipschitz", "# lipschitz 1.1"},
                                     {"cut", "# cut 0.3"},
                                     {"mesh", "# mesh 0123456789abcdef"},
                                     {"values-at", "# values-at 0123456789abcdef"}};
    for (const auto& [name, line] : forged) {
        folder.write("t.pers", with_head(text, name, line));
        wrong("t.pers", "m.node", "t.pers:");
    }

    // Files and options that cannot be; lines count from 1, the first is a comment.
    const auto refused = [&](const std::string& content, int exit, const std::string& why) {
        CAPTURE(why);
        folder.write("w.txt", content);
        const Result result = folder.run("persist m.node --values-at w.txt" + how);
        CHECK(result.exit == exit);
        CHECK_MESSAGE(result.says(why), result.err);
        CHECK(result.out == "");
    };
    const std::size_t count = static_cast<std::size_t>(std::count(values.begin(), values.end(), '\n')) - 1;
    refused(with_line(values, 7, "seven"), 3, "w.txt:7: \"seven\" is not a number");
    refused(with_line(values, 7, "nan"), 3, "w.txt:7: \"nan\" is not a finite double");
    refused(with_line(values, 7, "1 2"), 3, "w.txt:7: 2 values; a line is the value at one vertex");
    refused(values + "1\n", 3, "w.txt:" + std::to_string(count + 2) + ": a value too many; m.node has");
    refused(with_line(values, 7, "# lost"), 3, "the input ends after " + std::to_string(count - 1) + " values");
    refused("", 3, "w.txt:1: the input ends after 0 values");
    refused(with_line(values, 60, ".9"), 2, "(w.txt:60)");
    refused(with_line(values, 60, ".9"), 2, "--lipschitz 1: the function changes by");
    refused(with_line(values, 9, "-4"), 2, "(w.txt:9)");
    const auto bad = [&](const std::string& arguments, const std::string& why) {
        CAPTURE(arguments);
        const Result result = folder.run("persist " + arguments);
        CHECK(result.exit != 0);
        CHECK_MESSAGE(result.says(why), result.err);
    };
    bad("p.txt --values-at v.txt" + how, "goes with a mesh, MESH.node");
    bad("m.node --values-at v.txt --tau 3" + how, "--tau 3: the mesh is made already");
    bad("m.node --values-at v.txt --error .1" + how, "--error .1: the mesh is made already");
    bad("m.node --values-at v.txt --fit --memory 1M" + how, "--fit: fit is for points");
    bad("m.node --values-at v.txt --method svr" + how, "--method svr: the mesh is made already");
    bad("m.node --values-at v.txt", "go with --filter function");
    REQUIRE(folder.run("delaunay p.txt -o t.node --quiet").exit == 0);
    bad("t.node --values-at v.txt" + how, "t.node: no mesh with a domain");
    REQUIRE(folder.run("mesh - --method netmesh -o h.node --quiet", "0 0\n1e-4 0\n1 0\n0 1\n1 1\n").exit == 0);
    bad("h.node --values-at v.txt" + how, "a mesh with cages");
    // Vertices that are no Delaunay triangulation of themselves.
    const std::size_t at = node.rfind("\n", node.size() - 2) + 1;
    std::istringstream last(node.substr(at));
    std::string id, x, y, marker;
    last >> id >> x >> y >> marker;
    folder.write("b.node", node.substr(0, at) + id + " " + x + "1e-3 " + y + " " + marker + "\n");
    folder.write("b.ele", folder.read("m.ele"));
    folder.write("b.neigh", folder.read("m.neigh"));
    folder.write("v.txt", values);
    CHECK(folder.run("persist b.node --values-at v.txt" + how).exit != 0);
    const Result base = folder.run("persist m.node --values-at v.txt --quiet" + how);
    CHECK(base.exit == 0);
    // Values outside of the domain are not looked at: those of the frame, which come with marker 2.
    std::string other = values;
    std::istringstream lines(node);
    std::string line;
    std::size_t vertex = 0, changed = 0;
    while (std::getline(lines, line)) {
        if (line[0] == '#' || vertex++ == 0) continue;
        if (line.substr(line.size() - 2) == " 2") other = with_line(other, vertex, "-1e9"), changed++;
    }
    CHECK(changed == 4);
    folder.write("v.txt", other);
    const Result same = folder.run("persist m.node --values-at v.txt --quiet" + how);
    CHECK(same.exit == 0);
    CHECK(bars_of(same.out) == bars_of(base.out));
}

TEST_CASE("pictures of a function's diagram: a band, values as they are, e(v)") {
    const Folder folder;
    REQUIRE(folder.run("sample circle -n 40 -o p.txt").exit == 0);
    const std::string how = "persist p.txt --filter function --function 'abs(sqrt(x*x + y*y) - .6) - .5' --lipschitz 1 "
                            "--cut -.1 --error .05 --quiet -o d.pers --svg d.svg";
    REQUIRE(folder.run(how).exit == 0);
    std::string picture = folder.read("d.svg");
    CHECK(picture.find("certified error e = ") != std::string::npos);
    CHECK(picture.find("birth \xE2\x89\xA4 2 e = ") != std::string::npos);
    CHECK(picture.find("value v") != std::string::npos);
    CHECK(picture.find("radius r") == std::string::npos);
    CHECK(picture.find("\xE2\x88\x92"
                       "0.4") != std::string::npos);      // a tick below 0
    CHECK(picture.find("#fbf0d0") != std::string::npos);  // the band
    CHECK(picture.find("nan") == std::string::npos);
    CHECK(picture.find("inf") == std::string::npos);
    REQUIRE(folder.run(how + " --bounds").exit == 0);
    picture = folder.read("d.svg");
    CHECK(picture.find(">e(v)<") != std::string::npos);
    CHECK(picture.find("e(v): certified error at value v") != std::string::npos);
    CHECK(picture.find("nan") == std::string::npos);
    // One value alone, and a bar that is born at 0.
    for (const std::string function : {"'0'", "'7'", "'sqrt(x*x + y*y) - 1'"}) {
        CAPTURE(function);
        REQUIRE(folder
                    .run("persist p.txt --filter function --lipschitz 1 --cut 0 --quiet -o d.pers --svg d.svg "
                         "--function " +
                         function)
                    .exit == 0);
        picture = folder.read("d.svg");
        CHECK(picture.find("nan") == std::string::npos);
        CHECK(picture.find("inf") == std::string::npos);
    }
}

TEST_CASE("--fit of a function: the error never grows with memory, and the files tell what it was made for") {
    const Folder folder;
    REQUIRE(folder.run("sample circle -n 40 -o p.txt").exit == 0);
    const std::string how = "persist p.txt --filter function --function 'abs(sqrt(x*x + y*y) - .6) - .1' --lipschitz 1 "
                            "--cut .2 --quiet --fit -o d.pers --mesh m.node --memory ";
    double last = HUGE_VAL;
    int better = 0;
    for (const std::string memory : {"100K", "120K", "200K", "400K", "1M"}) {
        CAPTURE(memory);
        REQUIRE(folder.run(how + memory).exit == 0);
        const double error = number_after(folder.read("d.pers"), "# certified-error ");
        CHECK(error <= last);
        better += error < last;
        last = error;
        const double fitted = number_after(folder.read("d.pers"), "# fitted-error ");
        CHECK((fitted == 0 || error <= fitted));
    }
    CHECK(better > 2);
    for (const std::string source : {" --points p.txt", " --mesh m.node"}) {
        const Result check = folder.run("check d.pers" + source);
        CHECK_MESSAGE(check.exit == 0, check.err);
        folder.write("t.pers", with_head(folder.read("d.pers"), "certified-error", "# certified-error 0.001"));
        CHECK(folder.run("check t.pers" + source).exit == 7);
    }
    CHECK(folder.run(how + "20K").exit == 4);
}
