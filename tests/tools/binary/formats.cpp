// What goes in and out of the binary by its options: notes, columns, endings, choices of bars, several inputs.
#include "run.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <sstream>

using Names = std::vector<std::string>;

namespace {

const std::string pandas = ",x,y,label\n0,0,0,a\n1,1,0,b\n2,0,1.5,c\n";

std::size_t lines_in(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("what is left out is said once, and not with --quiet") {
    const Folder folder;
    folder.write("p.csv", "x,y\n0,0\n1,0\n0,1.5\n");
    Result result = folder.run("delaunay p.csv -o m.node");
    CHECK(result.exit == 0);
    CHECK(result.says("p.csv: skipped header \"x,y\"\n"));
    CHECK(folder.run("delaunay p.csv -o m.node --quiet").err == "");
    result = folder.run("delaunay - -o m.node", "x;y\n0,5;0\n1;0\n0;1,5\n");
    CHECK(result.says("<stdin>: commas read as decimal; skipped header \"x;y\"\n"));
}

TEST_CASE("a degree above those of the points is said to be taken as the highest") {
    const Folder folder;
    folder.write("p.csv", "0,0\n1,0\n0,1.5\n2,2\n");
    const std::string note = "p.csv: --max-degree 5 is taken as 1: there is nothing of higher degree\n";
    for (const char* const filter : {"alpha", "complete"}) {
        const std::string command = std::string("persist p.csv -o p.pers --filter ") + filter;
        CHECK(folder.run(command + " --max-degree 5").says(note));
        CHECK(!folder.run(command + " --max-degree 1").says("--max-degree"));
        CHECK(folder.run(command + " --max-degree 5 -q").err == "");
    }
    CHECK(!folder.run("persist p.csv -o p.pers --filter rips --max-degree 5").says("--max-degree"));
}

TEST_CASE("a first column that counts rows is a coordinate, and that is said") {
    const Folder folder;
    std::string from_0, from_1;
    for (int i = 0; i < 6; i++) {
        const std::string rest = "," + std::to_string(i * i % 5) + "," + std::to_string(i % 2) + "\n";
        from_0 += std::to_string(i) + rest;
        from_1 += std::to_string(i + 1) + rest;
    }
    for (const std::string& table : {from_0, from_1}) {
        folder.write("p.csv", table);
        CHECK(folder.run("delaunay p.csv -o p.node")
                  .says("p.csv: took column 1, which counts rows, for a coordinate; "
                        "--columns 2,3 leaves it out\n"));
        CHECK(!folder.run("delaunay p.csv -o p.node --columns 1-3").says("counts rows"));
    }
    folder.write("p.csv", "1990,1,2\n1991,2,2\n1992,2,5\n1993,1,4\n1994,7,7\n");
    CHECK(folder.run("delaunay p.csv -o p.node").says("counts rows"));
    folder.write("p.csv", from_0 + "9,1,1\n");
    CHECK(!folder.run("delaunay p.csv -o p.node").says("counts rows"));
}

TEST_CASE("extended .xyz is read, and where its columns stand otherwise it says so") {
    const Folder folder;
    const std::string atoms = "O 0 0 0 1\nH 0 0 1 1\nH 0 1 0.2 1\nC 1 0 0 1\n";
    folder.write("a.xyz", "4\nLattice=\"5 0 0 0 5 0 0 0 5\" Properties=species:S:1:pos:R:3:charge:R:1\n" + atoms);
    CHECK(folder.run("delaunay a.xyz -o a.node").exit == 0);
    folder.write("b.xyz", "2\nProperties=id:I:1:species:S:1:pos:R:3\n1 O 0 0 0\n2 H 0 0 1\n");
    const Result result = folder.run("delaunay b.xyz -o b.node");
    CHECK(result.exit == 3);
    CHECK(result.says("b.xyz:2: Properties do not begin with species:S:1:pos:R:3"));
}

TEST_CASE("distances that are forgotten while they are read have the diagram of those that are kept") {
    const Folder folder;
    std::string triangle;
    unsigned state = 1;
    for (int i = 1; i < 700; i++) {
        for (int j = 0; j < i; j++)
            triangle += std::to_string(1000 + (state = state * 1103515245u + 12345u) / 65536 % 90) + " ";
        triangle += "\n";
    }
    folder.write("d.txt", triangle);
    const std::string options = " --distances --threshold 506 -q";
    const Result once = folder.run("persist d.txt" + options), kept = folder.run("persist -" + options, triangle);
    REQUIRE(once.exit == 0);
    CHECK(once.out.substr(once.out.find("\n0 ")) == kept.out.substr(kept.out.find("\n0 ")));
}

TEST_CASE("--columns, --delimiter and --skip, and what they do not go with") {
    const Folder folder;
    folder.write("p.csv", pandas);
    Result result = folder.run("delaunay p.csv -o m.node");
    CHECK(result.exit == 3);
    CHECK(result.says("p.csv:2: \"a\" is not a number; --columns 2,3 leaves such columns out"));
    REQUIRE(folder.run("delaunay p.csv -o m.node --columns x,y").exit == 0);
    CHECK(folder.read("m.node") == "3 2 0 1\n0 0 0 0\n1 1 0 0\n2 0 1.5 0\n");
    REQUIRE(folder.run("delaunay p.csv -o n.node --columns 2-3").exit == 0);
    CHECK(folder.read("n.node") == folder.read("m.node"));
    folder.write("colon.txt", "a title, of 2024\n0:0\n1:0\n0:1,5\n");
    REQUIRE(folder.run("delaunay colon.txt -o n.node --delimiter : --skip 1").exit == 0);
    CHECK(folder.read("n.node") == folder.read("m.node"));
    CHECK(folder.run("delaunay p.csv --columns x,q").exit == 3);
    CHECK(folder.run("delaunay p.csv --columns ,").exit == 2);
    CHECK(folder.run("delaunay p.csv --delimiter 5").exit == 2);
    CHECK(folder.run("delaunay p.csv --skip x").exit == 2);
    folder.write("s.off", "OFF\n1 0 0\n1 2 3\n");
    CHECK(folder.run("mesh s.off --columns 1,2").exit == 2);
    CHECK(folder.run("mesh s.off --skip 1").exit == 2);
    REQUIRE(folder.run("persist p.csv --columns x,y -o d.pers").exit == 0);
    CHECK(folder.run("check d.pers --points p.csv --columns x,y").exit == 0);
    CHECK(folder.run("check d.pers --points p.csv --columns 1,2").exit == 7);
}

TEST_CASE("endings that are not written are refused before any work, of the input too") {
    const Folder folder;
    for (const char* arguments :
         {"persist none.txt -o d.txt", "persist none.txt --svg d.png", "persist none.txt --mesh m.stl",
          "persist none.txt --representatives c.vtp", "mesh none.txt -o m.stl", "delaunay none.txt -o m",
          "delaunay none.txt --svg m.pdf", "homology none.txt -o d.dat", "homology none.txt --representatives c.vtu",
          "vineyard none.txt --k 1..2 --svg v.jpg", "persist none.txt --svg - --json"}) {
        CAPTURE(arguments);
        CHECK(folder.run(arguments).exit == 2);
    }
    folder.write("p.txt", "0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
    for (const char* ending : {"vtu", "ply", "obj", "msh", "mesh"}) {
        const Result result = folder.run(std::string("delaunay p.txt -o m.") + ending);
        CHECK(result.exit == 2);
        CHECK(result.says("holds 2 or 3 dimensions"));
    }
    CHECK(folder.names() == Names{"p.txt"});
}

TEST_CASE("--svg - is the picture alone on stdout") {
    const Folder folder;
    REQUIRE(folder.run("sample circle -n 20 -o p.txt").exit == 0);
    Result result = folder.run("persist p.txt --svg - --quiet");
    CHECK(result.exit == 0);
    CHECK(result.out.rfind("<svg ", 0) == 0);
    CHECK(result.out.find("inf\n") == std::string::npos);
    result = folder.run("mesh p.txt --svg - -o m.node --quiet");
    CHECK(result.out.rfind("<svg ", 0) == 0);
    CHECK(folder.has("m.ele"));
    CHECK(!folder.has("-"));
}

TEST_CASE("--check of a triangulation speaks of no quality, and what auto takes is not advised against memory") {
    const Folder folder;
    REQUIRE(folder.run("sample cube --dim 2 -n 400 -o p.csv").exit == 0);
    const Result checked = folder.run("delaunay p.csv --check -o p.node --json");
    CHECK(checked.out.find("Delaunay property") != std::string::npos);
    CHECK(checked.out.find("quality") == std::string::npos);
    CHECK(folder.run("mesh p.csv --check -o m.node --json").out.find("quality") != std::string::npos);
    for (const std::string memory : {"10K", "150K"}) {
        const Result small = folder.run("persist p.csv --representatives c.txt -o d.pers --memory " + memory);
        CHECK(small.exit == 4);
        CHECK(!small.says("--filter alpha is exact"));
    }
}

TEST_CASE("a diagram given as points is recognised") {
    const Folder folder;
    folder.write("p.csv", "0,0\n1,0\n0,1.5\n2,2\n");
    for (const std::string file : {"d.pers", "d.csv", "d.npy"}) {
        REQUIRE(folder.run("persist p.csv -q -o " + file).exit == 0);
        const Result result = folder.run("persist " + file);
        CHECK(result.exit == 3);
        CHECK(result.says("`netmesh distance`"));
    }
    const Result misread = folder.run("check d.pers --points d.csv");
    CHECK(misread.exit == 3);
}

TEST_CASE("two outputs to stdout are refused") {
    const Folder folder;
    folder.write("p.csv", "0,0\n1,0\n0,1.5\n2,2\n");
    for (const std::string command : {"persist p.csv", "mesh p.csv", "persist p.csv --filter rips --threshold 2"}) {
        const Result result = folder.run(command + " --svg - -o - -q");
        CHECK(result.exit == 2);
        CHECK(result.says("--svg - and -o -: only one of the two can go to stdout"));
        CHECK(result.out == "");
    }
}

TEST_CASE("a diagram that is not exact is said to be so, by its head or, whatever --quiet says, on stderr") {
    const Folder folder;
    std::string points;
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++)
            points += std::to_string(i) + "," + std::to_string(j) + "," + std::to_string(i + j) + "\n";
    folder.write("p.csv", points);
    for (const std::string output :
         {"-o d.npy", "-o d.csv", "-o d.json", "-o d.pers --top 2", "--least 0.1", "--svg -"}) {
        CAPTURE(output);
        const Result result = folder.run("persist p.csv -q " + output);
        CHECK(result.says("in a hyperplane"));
        CHECK(result.says("certified ratio "));
        CHECK(folder.run("persist p.csv -q --filter cech " + output).err == "");
    }
    for (const std::string output : {"-o d.pers", "", "-o d.npy --json"}) {
        CAPTURE(output);
        CHECK(folder.run("persist p.csv -q " + output).err == "");
    }
}

TEST_CASE("--top and --min-persistence choose bars, cycles with them, and leave no certificate") {
    const Folder folder;
    REQUIRE(folder.run("sample circle -n 20 -o p.txt").exit == 0);
    REQUIRE(folder.run("persist p.txt --filter alpha -o all.pers").exit == 0);
    REQUIRE(folder.run("persist p.txt --filter alpha --top 2 -o d.pers --representatives c.txt").exit == 0);
    const std::string two = folder.read("d.pers");
    CHECK(two.rfind("# a choice of 3 of 21 bars, --top 2\n", 0) == 0);
    CHECK(lines_in(bars_of(two)) == 3);
    CHECK(two.find("0 0 inf\n") != std::string::npos);
    const std::string cycles = folder.read("c.txt");
    std::size_t count = 0;
    for (std::size_t at = cycles.find("bar"); at != std::string::npos; at = cycles.find("bar", at + 1)) count++;
    CHECK(count == 3);
    Result result = folder.run("persist p.txt --filter alpha --min-persistence 0.5 --quiet");
    CHECK(lines_in(bars_of(result.out)) == 2);
    result = folder.run("check d.pers --points p.txt");
    CHECK(result.exit == 7);
    CHECK(result.says("carries no certificate"));
    CHECK(folder.run("persist p.txt --top 0").exit == 2);
    CHECK(folder.run("persist p.txt --min-persistence -1").exit == 2);
    result = folder.run("persist p.txt --bounds --top 1 -o b.csv");
    CHECK(result.exit == 0);
    CHECK(folder.read("b.csv").rfind("degree,birth,death,birth_low,birth_high,death_low,death_high,exists\n", 0) == 0);
    CHECK(lines_in(folder.read("b.csv")) == 3);
    folder.write("k.txt", "0 0\n1 0\n2 0\n0 1 1\n1 2 3\n");
    CHECK(bars_of(folder.run("homology k.txt --top 2 --quiet").out) == "0 0 3\n0 0 inf\n");
}

TEST_CASE("--least: bars at least so long, and how many there were") {
    const Folder folder;
    REQUIRE(folder.run("sample torus -n 400 --noise .1 -o p.csv").exit == 0);
    const std::string all = bars_of(folder.run("persist p.csv --filter alpha -q").out);
    std::istringstream lines(all);
    std::string due;
    std::size_t kept = 0;
    for (std::string line; std::getline(lines, line);) {
        double degree, birth;
        std::string death;
        std::istringstream(line) >> degree >> birth >> death;
        if (std::strtod(death.c_str(), nullptr) - birth < 0.125) continue;
        due += line + "\n";
        kept++;
    }
    REQUIRE(kept > 5);
    REQUIRE(kept + 5 < lines_in(all));
    const std::string head =
        "# a choice of " + std::to_string(kept) + " of " + std::to_string(lines_in(all)) + " bars, --least 0.125\n";
    CHECK(folder.run("persist p.csv --filter alpha -q --least 0.125").out == head + due);
    CHECK(folder.run("persist p.csv --pieces 4 -q --least 0.125").out == head + due);
    CHECK(bars_of(folder.run("persist p.csv --filter alpha -q --min-persistence 0.125").out) == due);
    REQUIRE(folder.run("persist p.csv --filter alpha -q --least 0.125 -o d.npy").exit == 0);
    const std::string array = folder.read("d.npy");
    CHECK(array.find("'shape': (" + std::to_string(kept) + ", 3)") != std::string::npos);
    CHECK(array.size() == 128 + kept * 24);
    for (const char* const wrong : {"-1", "-0.5", "nan", "inf", "x", "''"}) {
        const Result result = folder.run(std::string("persist p.csv --least ") + wrong);
        CHECK(result.exit == 2);
        CHECK(result.says("must be a finite number, 0 or more"));
    }
}

TEST_CASE("the longest bars of each degree are the first of those that are as long") {
    const Folder folder;
    folder.write("k.txt", "0 0\n1 0\n2 0\n3 0\n4 1\n0 1 2\n1 2 2\n2 3 5\n3 4 3\n");
    const std::string all = bars_of(folder.run("homology k.txt -q").out);
    CHECK(all == "0 0 2\n0 0 2\n0 0 5\n0 0 inf\n0 1 3\n");
    CHECK(bars_of(folder.run("homology k.txt -q --top 3").out) == "0 0 2\n0 0 5\n0 0 inf\n");
    CHECK(bars_of(folder.run("homology k.txt -q --top 4").out) == "0 0 2\n0 0 2\n0 0 5\n0 0 inf\n");
    CHECK(bars_of(folder.run("homology k.txt -q --top 4 --least 2.5").out) == "0 0 5\n0 0 inf\n");
    CHECK(bars_of(folder.run("homology k.txt -q --top 9").out) == all);
}

TEST_CASE("several inputs write several outputs") {
    const Folder folder;
    for (const char* name : {"a", "b"})
        REQUIRE(folder
                    .run(std::string("sample circle -n 12 --noise .1 --seed ") + (*name == 'a' ? "1" : "2") + " -o " +
                         name + ".csv")
                    .exit == 0);
    Result result = folder.run("persist a.csv b.csv -o '{}.pers' --svg '{}.svg' --quiet");
    CHECK(result.exit == 0);
    CHECK(folder.names() == Names{"a.csv", "a.pers", "a.svg", "b.csv", "b.pers", "b.svg"});
    CHECK(folder.run("check b.pers --points b.csv").exit == 0);
    CHECK(folder.run("check b.pers --points a.csv").exit == 7);
    for (const char* wrong : {"persist a.csv b.csv", "persist a.csv b.csv -o d.pers",
                              "persist a.csv a.csv -o '{}.pers'", "mesh a.csv b.csv -o '{}.node' --svg m.svg",
                              "persist a.csv b.csv -o '{}.pers' --svg -", "homology a.csv b.csv"}) {
        CAPTURE(wrong);
        CHECK(folder.run(wrong).exit == 2);
    }
    result = folder.run("mesh a.csv none.csv b.csv -o '{}.off' --quiet");
    CHECK(result.exit == 3);
    CHECK(result.err == "none.csv: no such file or folder\n");
    CHECK(folder.has("a.off"));
    CHECK(folder.has("b.off"));
}

TEST_CASE("tables with words in their cells, missing values, and distances where points are due") {
    const Folder folder;
    folder.write("lab.csv", "time,site,x [mm],y [mm]\n2024-03-01 10:00:00,\"Lab A, bench\",0,0\n"
                            "2024-03-01 10:01:00,\"Lab A, bench\",1,\n2024-03-01 10:02:00,\"Lab\nB\",2,0\n"
                            "2024-03-01 10:03:00,\"Lab B\",0,2\n");
    Result result = folder.run("delaunay lab.csv -o m.node --columns 'x [mm],y [mm]'");
    CHECK(result.exit == 3);
    CHECK(result.says("--drop-missing leaves such rows out, 1 of 4"));
    result = folder.run("delaunay lab.csv -o m.node --columns 'x [mm],y [mm]' --drop-missing");
    CHECK(result.exit == 0);
    CHECK(result.says("left out 1 of 4 rows, which lack a value: line 3"));
    CHECK(folder.read("m.node") == "3 2 0 1\n0 0 0 0\n1 2 0 0\n2 0 2 0\n");
    std::string square;
    for (int i = 0; i < 9; i++)
        for (int j = 0; j < 9; j++) square += std::to_string(i < j ? j - i : i - j) + (j < 8 ? "," : "\n");
    folder.write("d.csv", square);
    CHECK(folder.run("persist d.csv").says("is read by persist --distances"));
    CHECK(folder.run("persist d.csv --filter rips -q -o d.pers").exit == 0);  // points in nine dimensions, and said
    CHECK(folder.run("persist d.csv --filter rips -o d.pers").says("persist --distances takes it for distances"));
    CHECK(folder.run("persist d.csv --distances -o d.pers").exit == 0);
}

TEST_CASE("what may be a slip is said with --quiet, too; balls have neither bounds nor cycles") {
    const Folder folder;
    folder.write("places.csv", "lat,lon\n52.1,13.2\n51.9,13.9\n52.4,13.1\n-999,-999\n");
    CHECK(folder.run("persist places.csv -q -o p.pers").says("-999"));
    CHECK(folder.run("persist places.csv -q -o p.pers").exit == 0);
    folder.write("plain.csv", "a,b\n0,0\n1,0\n0,1\n");
    CHECK(folder.run("persist plain.csv -q -o p.pers").err.empty());
    CHECK(folder.run("persist plain.csv -o p.pers").says("skipped header"));
    folder.write("balls.txt", "0 0 1\n3 0 1\n1 2 1\n");
    CHECK(folder.run("persist balls.txt --radii 3 --bounds").says("--bounds: with weights each bar is the exact one"));
    CHECK(
        folder.run("persist balls.txt --radii 3 --representatives c.txt").says("with weights there are cycles where"));
    folder.write("line.txt", "0 0 1\n3 0 1\n");
    CHECK(folder.run("persist line.txt --radii 3").says("there is no other filter of balls"));
    CHECK(folder.run("persist balls.txt --columns 1 2").says("2: no such file or folder; names of columns are"));
}

TEST_CASE("what is said of k, of points on a line, and of the whole process") {
    const Folder folder;
    folder.write("line.csv", "0,0\n1,1\n3,3\n");
    CHECK(folder.run("persist line.csv").says("on a line --filter rips is exact"));
    folder.write("flat.csv", "0,0,5\n1,0,5\n1,1,5\n0,1,5\n");
    for (const char* const given : {"", " --filter alpha", " --columns 1,2 -q"})
        CHECK(folder.run("persist flat.csv" + std::string(given)).out.find("1 0.5 0.7071067811865476") !=
              std::string::npos);
    CHECK(
        folder.run("persist flat.csv -o flat.pers").says("left out what is the same in all points: coordinate 3 is 5"));
    CHECK(folder.run("check flat.pers --points flat.csv").exit == 0);
    CHECK(folder.run("check flat.pers --points flat.csv")
              .says("left out what is the same in all points: coordinate 3 is 5"));
    folder.write("other.csv", "0,0,5\n1,0,5\n1,1,5\n0,1,6\n");
    CHECK(folder.run("check flat.pers --points other.csv").exit == 7);
    folder.write("thin.csv", "7,0,5,0,3\n7,1,5,0,3\n7,1,5,1,3\n7,0,5,1,3\n");
    CHECK(folder.run("persist thin.csv -o thin.pers")
              .says("points: coordinate 1 is 7, coordinate 3 is 5, coordinate 5 is 3"));
    CHECK(folder.run("check thin.pers --points thin.csv").exit == 0);
    CHECK(folder.run("persist flat.csv --filter complete").says("coordinate 3 is 5 in all points; without it, by"));
    CHECK(folder.run("persist flat.csv --proof p.proof -o p.pers").exit != 0);
    CHECK(folder.run("persist flat.csv --pieces 2 -o p.pers").exit == 5);
    CHECK(folder.run("persist flat.csv --mesh m.ply -o m.pers").says("by --columns, the same"));
    folder.write("axis.csv", "0,5,5\n1,5,5\n2,5,5\n");  // one coordinate would be left: a mesh
    CHECK(folder.run("persist axis.csv").says("in a hyperplane"));
    folder.write("slope.csv", "0,0,0\n1,0,1\n1,1,2\n0,1,1\n");
    CHECK(folder.run("persist slope.csv").says("in a hyperplane and have no Delaunay triangulation; --filter cech is"));
    CHECK(folder.run("persist slope.csv --filter cech").exit == 0);
    REQUIRE(folder.run("sample circle -n 30 -o p.csv").exit == 0);
    const Result result = folder.run("persist p.csv --k 3");
    CHECK(result.exit == 2);
    CHECK(result.says("--filter knn or kdistance"));
    CHECK(folder.run("persist p.csv --filter knn").says("--k 4 does not see single ones"));
    CHECK_FALSE(folder.run("persist p.csv --filter knn --k 4").says("outliers"));
    CHECK(folder.run("persist p.csv --memory 1M").says("; the whole process took "));
}

TEST_CASE("pictures of cycles show the bars that stand apart, or those that are chosen, and say what is left out") {
    const Folder folder;
    REQUIRE(folder.run("sample circle -n 40 -o a.csv").exit == 0);
    std::string two = folder.read("a.csv");
    std::istringstream rows(two);
    for (std::string row; std::getline(rows, row);) {  // the same, half as large, beside it
        const std::size_t comma = row.find_first_of(", \t");
        const double x = std::strtod(row.c_str(), nullptr), y = std::strtod(row.c_str() + comma + 1, nullptr);
        if (comma == std::string::npos || row[0] == 'x') continue;
        two += std::to_string(3 + x / 2) + row[comma] + std::to_string(y / 2) + "\n";
    }
    folder.write("two.csv", two);
    const auto count = [&](const std::string& word) {
        const std::string picture = folder.read("c.svg");
        std::size_t found = 0;
        for (std::size_t at = 0; (at = picture.find(word, at)) != std::string::npos; at++) found++;
        return found;
    };
    const std::string legend = "\xE2\x82\x81, from ";
    REQUIRE(folder.run("persist two.csv -q -o d.pers --representatives c.svg").exit == 0);
    CHECK(count(legend) == 2);
    REQUIRE(folder.run("persist two.csv -q -o d.pers --representatives c.svg --top 1").exit == 0);
    CHECK(count(legend) == 1);
    CHECK(count("not drawn") == 0);  // nothing that was chosen
    REQUIRE(folder.run("sample ball --dim 2 -n 200 -o ball.csv").exit == 0);
    REQUIRE(folder.run("persist ball.csv -q -o d.pers --representatives c.svg").exit == 0);
    CHECK(count("not drawn: ") == 2);  // in the legend, and for who cannot see it
    REQUIRE(folder.run("persist ball.csv -q -o d.pers --representatives c.svg --top 9").exit == 0);
    CHECK(count(legend) == 6);
    CHECK(count("not drawn: 3 shorter bars") == 2);
}
