// persist of distances and of points with a threshold: every input, every output, and a file that check makes again.
#include "run.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

std::string npy(const std::string& shape, const std::vector<double>& numbers) {
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }";
    header.resize(117, ' ');
    header += '\n';
    std::string content("\x93NUMPY\x01\0", 8);
    content += static_cast<char>(header.size());
    content += '\0';
    content += header;
    content.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
    return content;
}

// Of a square with sides 3 and 4.
const std::string bars = "0 0 1.5\n0 0 1.5\n0 0 2\n0 0 inf\n1 2 2.5\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("distances of every kind of file give one diagram, which check makes again") {
    const Folder folder;
    folder.write("full.txt", "a b c d\n0 3 5 4\n3 0 4 5\n5 4 0 3\n4 5 3 0\n");
    folder.write("lower.txt", "3\n5 4\n4 5 3\n");
    folder.write("tril.csv", "0,0,0,0\n3,0,0,0\n5,4,0,0\n4,5,3,0\n");
    folder.write("full.npy", npy("(4, 4)", {0, 3, 5, 4, 3, 0, 4, 5, 5, 4, 0, 3, 4, 5, 3, 0}));
    folder.write("condensed.npy", npy("(6,)", {3, 5, 4, 4, 5, 3}));
    folder.write("entries.txt", "0 1 3\n0 2 5\n0 3 4\n1 2 4\n1 3 5\n2 3 3\n");
    for (const std::string file : {"full.txt", "lower.txt", "tril.csv", "full.npy", "condensed.npy", "entries.txt"}) {
        CAPTURE(file);
        const std::string sparse = file == "entries.txt" ? " --sparse" : "";
        REQUIRE(
            folder.run("persist " + file + " --distances -o d.pers --representatives c.txt -q --check" + sparse).exit ==
            0);
        const std::string diagram = folder.read("d.pers");
        CHECK(bars_of(diagram) == bars);
        CHECK(diagram.find("# filter rips\n# distances\n") != std::string::npos);
        CHECK((diagram.find("# sparse\n") != std::string::npos) == !sparse.empty());
        const Result check = folder.run("check d.pers -q --json --representatives c.txt --points " + file);
        CHECK(check.err == "");
        CHECK(check.exit == 0);
        CHECK(check.out.find("reproduced: the engine makes the same bars of " + file) != std::string::npos);
        CHECK(check.out.find("second opinion: 5 bars are the pairs") != std::string::npos);
        CHECK(check.out.find("second opinion: 5 cycles are closed") != std::string::npos);
        // Tampered with, or of another file.
        folder.write("e.pers", replaced(diagram, "1 2 2.5\n", "1 2 2.25\n"));
        CHECK(folder.run("check e.pers --points " + file).exit == 7);
        folder.write("e.pers", replaced(diagram, "# points 4\n", "# points 5\n"));
        CHECK(folder.run("check e.pers --points " + file).says("has 4 points"));
    }
    CHECK(folder.run("persist full.txt --distances").says("full.txt: skipped header \"a b c d\"\n"));
    REQUIRE(folder.run("persist full.txt --distances -o d.pers -q").exit == 0);
    folder.write("other.txt", "0 3 5 4\n3 0 4 5\n5 4 0 2\n4 5 2 0\n");
    const Result other = folder.run("check d.pers --points other.txt");
    CHECK(other.exit == 7);
    CHECK(other.says("\"# input "));
    folder.write("e.pers", replaced(folder.read("d.pers"), "# max-degree 1\n", "# max-degree 1\n# dim 2\n"));
    CHECK(folder.run("check e.pers --points full.txt").exit == 3);
    folder.write("e.pers", replaced(folder.read("d.pers"), "# distances\n", ""));
    CHECK(folder.run("check e.pers --points full.txt").exit == 3);
}

TEST_CASE("inf joins no points, and a threshold none beyond") {
    const Folder folder;
    folder.write("inf.txt", "0 3 inf 4\n3 0 4 inf\ninf 4 0 3\n4 inf 3 0\n");
    CHECK(bars_of(folder.run("persist inf.txt --distances -q").out) == "0 0 1.5\n0 0 1.5\n0 0 2\n0 0 inf\n1 2 inf\n");
    REQUIRE(folder.run("persist inf.txt --distances -q --threshold 1.75 -o d.pers").exit == 0);
    CHECK(bars_of(folder.read("d.pers")) == "0 0 1.5\n0 0 1.5\n0 0 inf\n0 0 inf\n");
    CHECK(folder.run("check d.pers --points inf.txt").exit == 0);
    CHECK(folder.run("persist inf.txt --distances --filter cech").exit == 2);
}

TEST_CASE("distances go to every output of diagrams") {
    const Folder folder;
    folder.write("d.txt", "3\n5 4\n4 5 3\n");
    REQUIRE(folder.run("persist d.txt --distances -q -o d.csv --svg d.svg").exit == 0);
    CHECK(folder.read("d.csv") == "degree,birth,death\n0,0,1.5\n0,0,1.5\n0,0,2\n0,0,inf\n1,2,2.5\n");
    CHECK(folder.read("d.svg").rfind("<svg ", 0) == 0);
    REQUIRE(folder.run("persist d.txt --distances -q -o d.json").exit == 0);
    CHECK(folder.read("d.json").find("[0, 0, null], [1, 2, 2.5]") != std::string::npos);
    REQUIRE(folder.run("persist d.txt --distances -q -o d.npy").exit == 0);
    CHECK(folder.read("d.npy").find("'shape': (5, 3)") != std::string::npos);
    CHECK(folder.run("persist d.txt --distances -q --svg -").out.rfind("<svg ", 0) == 0);
    CHECK(bars_of(folder.run("persist d.txt --distances -q --top 1").out) == "0 0 inf\n1 2 2.5\n");
    CHECK(folder.run("persist d.txt --distances -o d.txt").exit == 2);
    CHECK(folder.run("persist d.txt --distances --representatives c.vtu").says("have no places"));
}

TEST_CASE("a threshold for points cuts their diagram, and leaves distances of any magnitude exact") {
    const Folder folder;
    REQUIRE(folder.run("sample circle -n 30 --noise .1 -o p.csv").exit == 0);
    folder.write("p.csv", folder.read("p.csv") + folder.read("p.csv").substr(0, folder.read("p.csv").find('\n') + 1));
    std::istringstream whole(bars_of(folder.run("persist p.csv --filter rips -q").out));
    std::vector<std::string> due;
    for (std::string degree, birth, death; whole >> degree >> birth >> death;)
        if (std::stod(birth) <= .3)
            due.push_back(degree + (death != "inf" && std::stod(death) > .3 ? " inf" : " " + death.substr(0, 12)));
    REQUIRE(folder.run("persist p.csv --filter rips --threshold .3 -q -o d.pers --representatives c.vtu").exit == 0);
    CHECK(folder.read("d.pers").find("# points 31\n# duplicates 1\n") != std::string::npos);
    std::istringstream cut(bars_of(folder.read("d.pers")));
    std::vector<std::string> have;
    for (std::string degree, birth, death; cut >> degree >> birth >> death;)
        have.push_back(degree + " " + death.substr(0, 12));
    std::sort(due.begin(), due.end());
    std::sort(have.begin(), have.end());
    CHECK(have == due);
    CHECK(folder.run("check d.pers --points p.csv").exit == 0);
    CHECK(folder.read("c.vtu").find("<VTKFile") != std::string::npos);
    for (const std::string scale : {"e-200", "e-320", "e200"}) {
        const Result result =
            folder.run("persist - --filter rips --threshold 1e300 -q", "0 0\n3" + scale + " 4" + scale + "\n");
        const double death = std::strtod(bars_of(result.out).substr(4).c_str(), nullptr);
        const double due_death = std::strtod(("2.5" + scale).c_str(), nullptr);
        CHECK(std::fabs(death - due_death) <= 1e-3 * due_death);
    }
    CHECK(bars_of(folder.run("persist - --filter rips --threshold 1 -q", "0 0\n1e305 0\n").out) ==
          "0 0 inf\n0 0 inf\n");
    CHECK(bars_of(folder.run("persist - --filter rips --threshold 1e305 -q", "0 0\n1e305 0\n").out) ==
          "0 0 5e+304\n0 0 inf\n");
    CHECK(folder.run("persist p.csv --threshold 1").says("--threshold 1: of the filter rips alone"));
}

TEST_CASE("points of any number of columns, for rips alone") {
    const Folder folder;
    std::string points;
    for (int i = 0; i < 12; i++) {
        for (int k = 0; k < 12; k++) points += (k > 0 ? "," : "") + std::string(i == k ? "1" : "0");
        points += "\n";
    }
    folder.write("p.csv", points);
    for (const std::string threshold : {"", " --threshold 1"}) {
        REQUIRE(folder.run("persist p.csv --filter rips -q -o d.pers" + threshold).exit == 0);
        CHECK(folder.read("d.pers").find("# dim 12\n") != std::string::npos);
        CHECK(bars_of(folder.read("d.pers")).rfind("0 0 0.707106781186547", 0) == 0);
        const Result check = folder.run("check d.pers --points p.csv");
        CHECK(check.err == "");
        CHECK(check.exit == 0);
    }
    for (const char* const other : {"complete", "alpha", "cech"})
        CHECK(folder.run(std::string("persist p.csv --filter ") + other).says("12 columns; points have 2 to 6"));
}

TEST_CASE("distance: births and deaths are compared on one scale") {
    const Folder folder;
    folder.write("d.txt", "3\n5 4\n4 5 3\n");
    REQUIRE(folder.run("persist d.txt --distances -q -o d.pers").exit == 0);
    folder.write("ripser.txt", "persistence intervals in dim 0:\n [0,3)\n [0,3)\n [0,4)\n [0, )\n"
                               "persistence intervals in dim 1:\n [4,5)\n");
    for (const std::string files : {"d.pers ripser.txt", "ripser.txt d.pers"}) {
        const Result result = folder.run("distance " + files);
        CHECK(result.out == "0 0\n1 0\n");
        CHECK(result.says("ripser.txt: ripser's births and deaths are diameters; they are halved"));
        CHECK(folder.run("distance -q " + files).err == "");
    }
    CHECK(folder.run("distance ripser.txt ripser.txt").out == "0 0\n1 0\n");
    CHECK(folder.run("distance ripser.txt ripser.txt").err == "");
    REQUIRE(folder.run("persist d.txt --distances -q -o d.csv").exit == 0);
    const Result unknown = folder.run("distance -q d.csv ripser.txt");
    CHECK(unknown.out == "0 2\n1 0.5\n");
    CHECK(unknown.says("d.csv does not say whether its own are radii"));

    folder.write("w.csv", "0,0,.1\n1,0,.2\n0,1.5,.1\n2,2,.3\n");
    REQUIRE(folder.run("persist w.csv --radii 3 -q -o plain.pers").exit == 0);
    REQUIRE(folder.run("persist w.csv --radii 3 -q --squares -o squares.pers").exit == 0);
    CHECK(folder.run("distance squares.pers squares.pers").exit == 0);
    for (const std::string files : {"plain.pers squares.pers", "squares.pers plain.pers", "ripser.txt squares.pers"}) {
        const Result refused = folder.run("distance " + files);
        CHECK(refused.exit == 3);
        CHECK(refused.says(": \"# squares\": births and deaths are squares, those of "));
    }
}
