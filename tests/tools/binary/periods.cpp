// Points that repeat by the binary: what is written, read again, noted and refused.
#include "run.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace {

const std::string points = "0,0\n1,0.5\n0.25,2\n2.75,1\n4,4\n";
const std::string atoms = "Na 0 0 0\nCl 2.5 0 0\n";

std::string xyz(const std::string& comment) { return "2\n" + comment + "\n" + atoms; }

std::string bars(const std::string& text) { return text.substr(text.find("\n0 0") + 1); }

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("periods: a square and a cubic lattice") {
    const Folder folder;
    folder.write("two.csv", "0.25,0.75\n");
    CHECK(bars(folder.run("persist two.csv --box 1,1 -q").out) ==
          "0 0 inf\n1 0.5 inf\n1 0.5 inf\n2 0.7071067811865476 inf\n");
    folder.write("three.csv", "0,0,0\n");
    const std::string cubic = "0 0 inf\n1 0.5 inf\n1 0.5 inf\n1 0.5 inf\n2 0.7071067811865476 inf\n"
                              "2 0.7071067811865476 inf\n2 0.7071067811865476 inf\n3 0.8660254037844386 inf\n";
    for (const char* const lattice : {"--box 1,1,1", "--box -1:0,0:1,5:6", "--cell 1,0,0/0,1,0/0,0,1",
                                      "--cell 0,1,0/1,0,0/1,0,-1", "--cell 1,1,1,90,90,90"}) {
        CAPTURE(lattice);
        CHECK(bars(folder.run(std::string("persist three.csv -q ") + lattice).out) == cubic);
    }
    CHECK(bars(folder.run("persist three.csv --box 1,1,1 --max-degree 1 -q").out) ==
          "0 0 inf\n1 0.5 inf\n1 0.5 inf\n1 0.5 inf\n");
}

TEST_CASE("periods: cycles say which copies, and are laid out one simplex beside the other") {
    const Folder folder;
    folder.write("one.csv", "0.25,0.75\n");
    CHECK(folder.run("persist one.csv --box 1,1 -q -o one.pers --representatives c.txt").exit == 0);
    const std::string cycles = folder.read("c.txt");
    CHECK(has(cycles, "bar 0 0 inf 1\n0\nbar 1 0.5 inf 1\n0 0:"));
    CHECK(has(cycles, "\n0 0:1,0\n"));
    CHECK(has(cycles, "\n0 0:0,1\n"));
    CHECK(has(cycles, "bar 2 0.7071067811865476 inf 2\n0 0:"));
    // A ring of eight across the corner of the box, closed where it is drawn.
    folder.write("ring.csv", "0.3,0\n0.2,0.2\n0,0.3\n1.8,0.2\n1.7,0\n1.8,1.8\n0,1.7\n0.2,1.8\n");
    CHECK(folder.run("persist ring.csv --box 2,2 -q -o ring.pers --max-degree 1 --representatives ring.obj").exit == 0);
    CHECK(folder.run("persist ring.csv --box 2,2 -q -o ring.pers --max-degree 1 --representatives ring.txt").exit == 0);
    CHECK(folder.run("persist ring.csv --box 2,2 -q -o ring.pers --representatives ring.svg").exit == 0);
    CHECK(folder.run("persist ring.csv --box 2,2 -q -o ring.pers --representatives ring.vtu").exit == 0);
    const std::string text = folder.read("ring.txt"), drawn = folder.read("ring.obj");
    std::size_t edges = 0;
    for (std::size_t at = text.find("bar 1 "); at < text.size(); at = text.find('\n', at + 1)) edges += 1;
    CHECK(edges > 8);
    CHECK(has(text, ":"));
    // Places of the obj of the only ring that dies: all edges as long as edges of the ring are.
    std::vector<std::array<double, 2>> places;
    std::istringstream lines(drawn);
    double longest = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            places.emplace_back();
            words >> places.back()[0] >> places.back()[1];
        }
        std::size_t a = 0, b = 0;
        if (kind == "l" && words >> a >> b)
            longest = std::max(longest, std::hypot(places.at(a - 1)[0] - places.at(b - 1)[0],
                                                   places.at(a - 1)[1] - places.at(b - 1)[1]));
    }
    CHECK(places.size() > 8);
    CHECK(longest > 0.2);
    CHECK(longest < 1.5);
}

TEST_CASE("periods: heads, reports and JSON say the lattice") {
    const Folder folder;
    folder.write("p.csv", points);
    Result result = folder.run("persist p.csv --box 0:4,4.50 -o p.pers");
    CHECK(result.exit == 0);
    CHECK(result.says("p.csv: 1 point stands for its copy inside the box\n"));
    CHECK(result.says("periods  2 vectors, --box 0:4,0:4.5; with "));
    CHECK(!result.says("moved"));
    CHECK(result.says("rounded to the nearest double"));
    const std::string head = folder.read("p.pers");
    CHECK(has(head, "# filter alpha\n# box 0:4,0:4.5\n# max-degree 2\n"));
    CHECK(has(head, "\n# copies "));
    CHECK(!has(head, "\n# moved "));
    CHECK(has(head, "# reference closed offsets of the points in R^2 modulo the lattice\n"));
    result = folder.run("persist p.csv --cell 4,0/0.1,4.5 --json -q -o p.json");
    CHECK(has(result.out, "\"lattice\": [[4, 0], [0.1, 4.5]]"));
    CHECK(has(result.out, "\"periods\": 2"));
    CHECK(has(result.out, "\"copies\": "));
    CHECK(has(result.out, "\"moved\": "));
    CHECK(!has(folder.run("persist p.csv --json -q -o p.json").out, "lattice"));
    result = folder.run("persist p.csv --cell 4,0/0.1,4.5 -o moved.pers");
    CHECK(result.says("moved    by "));
    CHECK(result.says("the exact one of the moved numbers"));
    CHECK(has(folder.read("moved.pers"), "\n# moved "));
    CHECK(has(folder.run("persist p.csv --cell 4,0/- -q").out, "# cell 4,0/-\n"));
}

TEST_CASE("periods: what a head says makes the same diagram, and every line of it is looked at") {
    const Folder folder;
    folder.write("p.csv", "0,0,0\n1,0.5,2\n0.3,2,1\n2.7,1.1,0.5\n");
    REQUIRE(folder.run("persist p.csv --cell 3,4,5,80,95,110 -q -o a.pers").exit == 0);
    const std::string head = folder.read("a.pers");
    const std::size_t at = head.find("# cell ") + 7;
    const std::string cell = head.substr(at, head.find('\n', at) - at);
    CHECK(std::count(cell.begin(), cell.end(), '/') == 2);
    REQUIRE(folder.run("persist p.csv --cell " + cell + " -q -o b.pers").exit == 0);
    CHECK(folder.read("b.pers") == head);
    // `check` does not make it again, but reads it whole.
    Result result = folder.run("check a.pers --points p.csv");
    CHECK(result.exit == 2);
    CHECK(result.says("a.pers: is of points that repeat, of which there is no second opinion yet"));
    CHECK(folder.run("check a.pers").exit == 2);
    const auto forged = [&](const std::string& from, const std::string& to, const std::string& words) {
        std::string text = head;
        REQUIRE(has(text, from));
        text.replace(text.find(from), from.size(), to);
        folder.write("forged.pers", text);
        result = folder.run("check forged.pers");
        CAPTURE(from);
        CHECK(result.exit == 3);
        CHECK(result.says(words));
    };
    forged("# cell " + cell, "# cell file", "contradicts the other lines");
    forged("# cell " + cell, "# cell 4,0/1,4", "contradicts # dim");
    forged("# cell " + cell, "# cell 4", "must be as many vectors");
    forged("# cell " + cell + "\n", "", "contradicts the other lines");
    forged("# copies ", "# copy ", "not a line of a head");
    forged("# copies ", "# copies x", "must be a whole number");
    forged("# max-degree 3", "# max-degree 4", "contradicts # dim: at most 3");
}

TEST_CASE("periods: cells of files") {
    const Folder folder;
    folder.write("a.xyz", xyz("Lattice=\"0 2.5 2.5 2.5 0 2.5 2.5 2.5 0\" energy=1"));
    Result result = folder.run("persist a.xyz --cell file");
    CHECK(result.exit == 0);
    CHECK(result.says("a.xyz: read as atoms of .xyz; 1 point stands for its copy inside the cell\n"));
    CHECK(has(result.out, "# cell 0,2.5,2.5/2.5,0,2.5/2.5,2.5,0\n"));
    result = folder.run("persist a.xyz --cell file --radii vdw -q");
    CHECK(result.exit == 0);
    CHECK(has(result.out, "# radii vdw\n# cell "));
    folder.write("slab.xyz", xyz("Lattice=\"5 0 0 0 5 0 0 0 5\" pbc=\"F T T\""));
    CHECK(has(folder.run("persist slab.xyz --cell file -q").out, "# cell -/0,5,0/0,0,5\n"));
    result = folder.run("persist slab.xyz");
    CHECK(result.says("without its periodic cell: atoms near opposite sides are far apart; persist --cell file takes"));
    CHECK(!folder.run("persist slab.xyz --box 9,9,9").says("without its periodic cell"));
    folder.write("c.pdb", "CRYST1    9.000    9.000    9.000  90.00  90.00  90.00 P 1           1\n"
                          "ATOM      1  N   ALA A   1       1.000   6.000   6.500  1.00  0.00           N\n");
    CHECK(has(folder.run("persist c.pdb --cell file -q").out, "# cell 9,0,0/0,9,0/0,0,9\n"));
    // Of several files each has its own.
    CHECK(folder.run("persist a.xyz slab.xyz --cell file -q -o '{}.pers'").exit == 0);
    CHECK(has(folder.read("a.pers"), "# cell 0,2.5"));
    CHECK(has(folder.read("slab.pers"), "# cell -/0,5,0"));
    folder.write("none.xyz", xyz("no cell"));
    result = folder.run("persist none.xyz --cell file");
    CHECK(result.exit == 2);
    CHECK(result.says("--cell file: none.xyz has no periodic cell"));
    folder.write("free.xyz", xyz("Lattice=\"5 0 0 0 5 0 0 0 5\" pbc=\"F F F\""));
    result = folder.run("persist free.xyz --cell file");
    CHECK(result.exit == 3);
    CHECK(result.says("free.xyz:2: --cell file: pbc= says that no vector is a period"));
}

TEST_CASE("periods: what does not go with them is refused by its option") {
    const Folder folder;
    folder.write("p.csv", points);
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        const Result result = folder.run(arguments + " -q");
        CAPTURE(arguments);
        CHECK(result.exit == 2);
        CHECK(result.says(words));
    };
    refused("persist p.csv --box 4,0", "--box 4,0: entry 2, \"0\", has to be a length above 0");
    refused("persist p.csv --box 4,4,4", "is in 3 dimensions, p.csv in 2");
    refused("persist p.csv --box -,-", "has no period");
    refused("persist p.csv --cell 4,0/8,0", "--cell 4,0/8,0: vector 2: ");
    refused("persist p.csv --cell 4,0/nan,0", "vector 2");
    refused("persist p.csv --box 4,4 --cell 4,0/0,4", "--cell 4,0/0,4: goes without --box");
    refused("persist p.csv --cell 4,0/0,4 --box 4,4", "--box 4,4: goes without --cell");
    refused("persist p.csv --box 4,4 --filter rips", "--box 4,4: of the filter alpha alone");
    refused("persist p.csv --box 4,4 --tau 3", "--box 4,4: of the filter alpha alone");
    refused("persist p.csv --box 4,4 --filter alpha --bounds", "leave out bounds");
    refused("persist p.csv --box 4,4 --filter alpha --mesh m.node", "no triangulation is kept");
    refused("persist p.csv --box 4,4 --check", "--check does not go with --box");
    refused("persist p.csv --box 4,4 --pieces 2", "--box does not go with --pieces");
    refused("persist p.csv --box 4,4 --distances", "--box 4,4");
    for (const char* const command :
         {"delaunay p.csv", "mesh p.csv", "check p.pers", "pieces split p.csv d", "vineyard p.csv"})
        refused(std::string(command) + " --cell 4,0/0,4", "points repeat for persist alone");
}

TEST_CASE("periods: points that are far away, and a block that is too small") {
    const Folder folder;
    folder.write("far.csv", "0,0\n1e16,0.5\n");
    Result result = folder.run("persist far.csv --box 1,1 -q");
    CHECK(result.exit == 3);
    CHECK(result.says("far.csv:2: this point is 2^50 periods away"));
    folder.write("p.csv", points);
    result = folder.run("persist p.csv --box 4,4 --memory 1K -q");
    CHECK(result.exit == 4);
    CHECK(result.says("1.0 KiB of memory are too few"));
    CHECK(!result.says("--fit"));
    CHECK(!result.says("--tau"));
}

TEST_CASE("periods: points that are flat, and pictures to degree D") {
    const Folder folder;
    folder.write("line.csv", "0,1\n1,1\n2.5,1\n");
    const Result flat = folder.run("persist line.csv --box 4,- -q");
    CHECK(flat.exit == 5);
    CHECK(flat.says("line.csv: flat with all copies"));
    const Result result = folder.run("persist line.csv --box 4,2 -q --svg line.svg");
    CHECK(result.exit == 0);
    const std::string picture = folder.read("line.svg");
    CHECK(has(picture, "3 points in R\xC2\xB2, which repeat"));
    CHECK(has(picture, "H\xE2\x82\x82"));
    CHECK(has(picture, "Degree 1: "));
}

TEST_CASE("periods: that most points are outside of the box is said with --quiet, too") {
    const Folder folder;
    folder.write("p.csv", "0.1,0.2\n5,6\n7.5,6.5\n");
    CHECK(folder.run("persist p.csv --box 1,1 -q -o d.pers").says("2 points stand for their copies inside the box"));
    CHECK(folder.run("persist p.csv --box 8,8 -q -o d.pers").err == "");
    CHECK(folder.run("persist p.csv --box 7,7 -q -o d.pers").err == "");
}
