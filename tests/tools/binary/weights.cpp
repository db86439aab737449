// Balls of different sizes by the binary: what is written, made again, and refused.
#include "run.hpp"

#include <doctest/doctest.h>

namespace {

// The fourth one is hidden.
const std::string balls = "x,y,r\n0,0,1\n4,0,2\n2,3,0.5\n3.5,0,0\n";

}  // namespace

TEST_CASE("diagrams of balls, and the second opinion of them") {
    const Folder folder;
    folder.write("b.csv", balls);
    Result result = folder.run("persist b.csv --radii r -o b.pers --check");
    CHECK(result.exit == 0);
    CHECK(result.says("1 ball hidden by others"));
    CHECK(!result.says("coordinates, too"));
    CHECK(result.says("combinatorics and orientation of the regular triangulation"));
    result = folder.run("persist b.csv --radii r -q");
    CHECK(result.out.find("# radii r\n") != std::string::npos);
    CHECK(result.out.find("0 -2 inf\n0 -1 1.2808688457449497\n0 -0.5 1.1812843401601887\n") != std::string::npos);
    for (const char* const squares : {"", " --squares"}) {
        CHECK(folder.run(std::string("persist b.csv --radii 3 -q -o b.pers") + squares).exit == 0);
        result = folder.run("check b.pers --points b.csv");
        CHECK(result.exit == 0);
        CHECK(result.out.find("of the nerve of all balls, by their powers, in exact arithmetic: the same bars") !=
              std::string::npos);
    }
    folder.write("c.csv", "x,y,r\n0,0,1\n4,0,2\n2,3,0.6\n3.5,0,0\n");
    result = folder.run("check b.pers --points c.csv");
    CHECK(result.exit == 7);
    CHECK(result.says("# input"));
    std::string forged = folder.run("persist b.csv --radii r -q").out;
    forged.replace(forged.find("1.1812843401601887"), 18, "1.1812843401601889");
    folder.write("b.pers", forged);
    CHECK(folder.run("check b.pers --points b.csv").exit == 7);
}

TEST_CASE("radii as weights, and regular triangulations") {
    const Folder folder;
    folder.write("b.csv", balls);
    folder.write("w.csv", "0,0,1\n4,0,4\n2,3,0.25\n3.5,0,0\n");
    const auto bars = [](const std::string& text) { return text.substr(text.find("\n0 -") + 1); };
    CHECK(bars(folder.run("persist b.csv --radii r -q").out) == bars(folder.run("persist w.csv --weights 3 -q").out));
    const Result result = folder.run("delaunay b.csv --radii r --check -o b.node");
    CHECK(result.exit == 0);
    CHECK(result.says("3 vertices, 1 cell"));
}

TEST_CASE("what does not go with balls is refused by its option") {
    const Folder folder;
    folder.write("b.csv", balls);
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        const Result result = folder.run("persist b.csv -q " + arguments);
        CAPTURE(arguments);
        CHECK(result.exit == 2);
        CHECK(result.says(words));
    };
    refused("--radii r --weights r", "--weights r: goes without --radii");
    refused("--radii r --filter rips", "--radii r: of the filter alpha alone");
    refused("--radii r --tau 3", "--radii r: of the filter alpha alone");
    refused("--radii r --filter alpha --bounds", "leave out bounds");
    refused("--radii r --pieces 2", "--radii r does not go with --pieces");
    refused("--radii r --filter alpha --representatives c.txt", "cycles where there are periods alone");
    refused("--squares", "--squares: of points with weights alone");
    Result result = folder.run("persist b.csv --radii q");
    CHECK(result.exit == 3);
    CHECK(result.says("b.csv:2: --radii: there is no column \"q\""));
    folder.write("n.csv", "x,y,r\n0,0,1\n4,0,-2\n");
    result = folder.run("persist n.csv --radii r");
    CHECK(result.exit == 3);
    CHECK(result.says("n.csv:3: radius -2; radii are 0 or more"));
}
