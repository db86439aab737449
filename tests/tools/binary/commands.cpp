// What each command prints, writes and exits with.
#include "run.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "netmesh.h"

using Names = std::vector<std::string>;

TEST_CASE("version and help go to stdout") {
    const Folder folder;
    Result result = folder.run("--version");
    CHECK(result.exit == 0);
    CHECK(result.out == std::string("netmesh ") + netmesh_version_text() + "\n");
    CHECK(result.err == "");
    for (const char* command : {"", "mesh", "delaunay", "persist", "homology", "distance", "size", "check", "sample"}) {
        result = folder.run(std::string(command) + " --help");
        CHECK(result.exit == 0);
        CHECK(result.out.rfind("netmesh", 0) == 0);
        CHECK(result.err == "");
    }
}

TEST_CASE("usage errors: exit 2, the argument named, nothing on stdout, no file") {
    const Folder folder;
    folder.write("p.txt", "0 0\n1 0\n0 1\n");
    const char* const lines[][2] = {
        {"", "no command"},
        {"frob", "frob"},
        {"mesh", "POINTS"},
        {"mesh p.txt --frob", "--frob"},
        {"mesh p.txt --tau 2", "--tau 2"},
        {"mesh p.txt -o m.xyz", "m.xyz"},
        {"mesh p.txt -o m", "m: "},
        {"persist p.txt -o d.txt", "d.txt"},
        {"persist p.txt --filter frob", "barycentric-rips"},
        {"persist p.txt --filter barycentric-cech --k 0", "--k 0"},
        {"persist p.txt --filter rips --max-degree 31", "--max-degree"},
        {"persist p.txt --filter rips --mesh m.node", "--mesh"},
        {"persist p.txt --filter barycentric-cech --representatives c.txt", "--representatives"},
        {"persist p.txt --memory 0", "--memory 0"},
        {"size --dim 3", "--points"},
        {"size --points 3", "--dim"},
        {"check p.txt", "p.txt"},
        {"check m.node --mesh m.node", "--mesh"},
        {"sample ball", "-n"},
        {"sample frob -n 3", "frob"},
        {"sample ball -n 3 -o p.frob", "p.frob"}};
    for (const auto& line : lines) {
        const Result result = folder.run(line[0]);
        CAPTURE(line[0]);
        CHECK(result.exit == 2);
        CHECK(result.says(line[1]));
        CHECK(result.out == "");
    }
    folder.write("p4.txt", "0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
    CHECK(folder.run("mesh p4.txt -o m.vtu").says("m.vtu"));
    CHECK(folder.run("mesh p4.txt -o m.vtu").exit == 2);
    CHECK(folder.run("mesh p4.txt -o m.off --svg m.svg").exit == 2);
    CHECK(folder.names() == Names{"p.txt", "p4.txt"});
}

TEST_CASE("bad data: exit 3 with file and physical line, no file") {
    const Folder folder;
    folder.write("bad.txt", "x,y\r\n0,0\r\n\r\n1,nan\r\n");
    folder.write("empty.txt", "");
    folder.write("wide.csv", "1,2,3,4,5,6,7\n");
    folder.write("bad.npy", "nothing");
    const char* const lines[][2] = {{"bad.txt", "bad.txt:4: \"nan\""},
                                    {"empty.txt", "empty.txt:1: "},
                                    {"wide.csv", "wide.csv:1: 7 columns"},
                                    {"bad.npy", "bad.npy: not a NumPy array"},
                                    {"missing.txt", "missing.txt: no such file"},
                                    {".", ".: is a directory"}};
    for (const char* command : {"mesh", "delaunay", "persist"}) {
        for (const auto& line : lines) {
            const Result result = folder.run(std::string(command) + " " + line[0] + " --json");
            CAPTURE(line[0]);
            CHECK(result.exit == 3);
            CHECK(result.says(line[1]));
            CHECK(number_in(result.out, "code") == 3);
        }
    }
    const Result result = folder.run("mesh -", "1 2\n1 2 3\n");
    CHECK(result.exit == 3);
    CHECK(result.says("<stdin>:2: 3 columns where line 1 has 2"));
    CHECK(folder.names().size() == 4);
}

TEST_CASE("points that the engine refuses are named by their lines") {
    const Folder folder;
    Result result = folder.run("mesh -", "# two in one place, nearly\n0 0\n1 1\n\n1.0000000000000002 1\n");
    CHECK(result.exit == 5);
    CHECK(result.says("<stdin>:5: this point and the one of line 3"));
    result = folder.run("persist -", "0 0\n\n1e200 0\n");
    CHECK(result.exit == 3);
    CHECK(result.says("<stdin>:3: outside the range"));
    CHECK(result.says("2^500"));
    result = folder.run("delaunay -", "0 0\n1 1\n2 2\n3 3\n");
    CHECK(result.exit == 5);
    CHECK(result.says("flat"));
    CHECK(folder.run("delaunay - --quiet", "0 0\n1e300 0\n0 1e300\n").exit == 0);
    CHECK(folder.run("mesh - --quiet", "0 0\n1 1\n2 2\n3 3\n").exit == 0);
    CHECK(folder.run("mesh - --quiet", "5 5\n").exit == 0);
}

TEST_CASE("a triangulation of four points, as text") {
    const Folder folder;
    const Result result = folder.run("delaunay - -o t.node --json", "0 0\n4 0\n0 4\n1 1\n4 0\n-0.0 0\n");
    CHECK(result.exit == 0);
    CHECK(result.err == "");
    CHECK(number_in(result.out, "points") == 6);
    CHECK(number_in(result.out, "duplicates") == 2);
    CHECK(number_in(result.out, "cells") == 3);
    CHECK(folder.names() == Names{"t.ele", "t.neigh", "t.node"});
    CHECK(folder.read("t.node") == "4 2 0 1\n0 0 0 0\n1 4 0 0\n2 0 4 0\n3 1 1 0\n");
    CHECK(folder.read("t.ele").rfind("3 3 0\n", 0) == 0);
    CHECK(folder.read("t.neigh").rfind("3 3\n", 0) == 0);
    CHECK(folder.run("check t.node").exit == 0);
    CHECK(folder.run("delaunay t.node -o u.off").exit == 0);
    CHECK(folder.read("u.off").rfind("nOFF\n2\n4 3 0\n0 0\n", 0) == 0);
    CHECK(folder.run("delaunay t.node", "").out == folder.read("u.off"));
}

TEST_CASE("mesh: every format, checked from its files, tampering found") {
    const Folder folder;
    CHECK(folder.run("sample ball -n 60 --dim 3 -o p.txt").exit == 0);
    const Result result = folder.run("mesh p.txt -o m.node --tau 3 --check --json");
    CHECK(result.exit == 0);
    CHECK(number_in(result.out, "aspect_ratio_max") > 1);
    CHECK(number_in(result.out, "aspect_ratio_max") <= 3);
    CHECK(folder.run("mesh p.txt -o m.vtu --quiet").err == "");
    CHECK(folder.run("mesh p.txt -o m.off --quiet").exit == 0);
    CHECK(folder.read("m.off").rfind("OFF\n", 0) == 0);

    Result check = folder.run("check m.node --points p.txt");
    CHECK(check.exit == 0);
    CHECK(check.out.find("(tau 3)") != std::string::npos);
    CHECK(check.out.find("bit for bit") != std::string::npos);
    CHECK(folder.run("check m.node --tau 2.1").exit == 7);
    CHECK(folder.run("check m.node --eps 0.01").exit == 7);
    CHECK(folder.run("mesh p.txt -o fine.node --eps 0.4 --check").exit == 0);
    CHECK(folder.run("check fine.node").out.find("of the size asked for (eps 0.4)") != std::string::npos);
    CHECK(folder.run("mesh p.txt -o none.node --eps 1e-18").exit == 3);
    CHECK(folder.run("mesh p.txt -o sized.node --cell-size .05,.5 --domain 2 --check").exit == 0);
    CHECK(folder.run("check sized.node").out.find("(cell-size 0.05,0.5)") != std::string::npos);
    CHECK(folder.run("check sized.node --cell-size .05").exit == 7);
    CHECK(folder.run("mesh p.txt -o paced.node --pace order.txt").exit == 0);
    CHECK(folder.run("mesh p.txt -o paced.node --pace few.txt --theta .5").exit == 0);
    const std::string order = folder.read("order.txt"), few = folder.read("few.txt");
    CHECK(order.find("# input theta\n") == 0);
    CHECK(std::count(order.begin(), order.end(), '\n') == 1 + 60);
    CHECK(few.size() < order.size());
    CHECK(few.find(" 1\n") == std::string::npos);
    CHECK(folder.run("sample clusters -n 60 -o c.txt").exit == 0);
    CHECK(folder.run("mesh c.txt -o caged.node --method netmesh --weighted-cells cells.txt").exit == 0);
    const std::string weighted = folder.read("cells.txt"), caged = folder.read("caged.node");
    std::size_t remarks = 0;
    for (std::size_t at = 0; (at = caged.find("# cage ", at)) != std::string::npos; ++at) ++remarks;
    CHECK(remarks > 2);
    CHECK(std::count(weighted.begin(), weighted.end(), '\n') == 1 + static_cast<std::ptrdiff_t>(remarks));
    const std::string first = caged.substr(caged.find("# cage ") + 7);
    CHECK(weighted.find("\n" + first.substr(0, first.find(' ') + 1)) == weighted.find('\n'));
    CHECK(folder.run("check caged.node").out.find("in-radii and feature sizes as in 4.6") != std::string::npos);
    CHECK(folder.run("mesh p.txt -o netted.node --method refine --net .25 --check").exit == 0);
    CHECK(folder.run("check netted.node").out.find("a boundary net of spacing 0.25") != std::string::npos);
    CHECK(folder.run("check netted.node --net .5").exit == 7);
    const Result unending = folder.run("mesh p.txt -o none.node --method refine --tau 2.000000000000001");
    CHECK(unending.exit == 3);
    CHECK(unending.err.find("--tau 2.000000000000001: ") != std::string::npos);
    CHECK(folder.run("check sized.node --net 1").exit == 7);
    const Result unresolved = folder.run("mesh p.txt -o none.node --cell-size 1e-18");
    CHECK(unresolved.exit == 3);
    CHECK(unresolved.err.find("--cell-size 1e-18: ") != std::string::npos);
    CHECK(check.out.find("within the bounds of chapters 3 to 5") != std::string::npos);
    const Result analysed = folder.run("mesh p.txt -o m.node --analyse --json");
    CHECK(analysed.exit == 0);
    for (const char* key :
         {"\"analysis\"", "\"theta\"", "\"integral_lower\"", "\"ply_max\"", "\"beta_max\"", "\"feature_ratio\""})
        CHECK(analysed.out.find(key) != std::string::npos);
    const Result triangulated = folder.run("delaunay p.txt -o d.node --analyse");
    CHECK(triangulated.exit == 0);
    CHECK(triangulated.err.find("fatness") != std::string::npos);
    CHECK(triangulated.err.find("feature size") == std::string::npos);
    CHECK(folder.run("persist p.txt --analyse").exit == 2);
    CHECK(folder.run("sample ball -n 60 --dim 3 --seed 2 -o q.txt").exit == 0);
    check = folder.run("check m.node --points q.txt");
    CHECK(check.exit == 7);
    CHECK(check.says("q.txt:1"));

    const std::string cells = folder.read("m.ele"), neighbours = folder.read("m.neigh"), nodes = folder.read("m.node");
    folder.write("m.neigh", neighbours.substr(0, neighbours.find('\n')) + "\n0 -1 -1 -1 -1" +
                                neighbours.substr(neighbours.find('\n', neighbours.find('\n') + 1)));
    CHECK(folder.run("check m.node").exit == 7);
    folder.write("m.neigh", neighbours);
    folder.write("m.ele", "1 4 0\n0 0 1 2 99999\n");
    check = folder.run("check m.node");
    CHECK(check.exit == 3);
    CHECK(check.says("m.ele:2: index 99999"));
    folder.write("m.ele", cells);
    std::size_t line = nodes.find("\n0 ") + 1;
    folder.write("m.node", nodes.substr(0, line) + "0 0.9 0 0.9 0" + nodes.substr(nodes.find('\n', line)));
    CHECK(folder.run("check m.node").exit == 7);
    folder.write("m.node", nodes);
    CHECK(folder.run("check m.node --quiet").out == "");
    CHECK(folder.run("check m.node --quiet").exit == 0);
}

TEST_CASE("mesh --cages thesis: the kind written, checked from the files, tampering found") {
    const Folder folder;
    folder.write("p.txt", "0 0\n1 0\n1e-4 1e-4\n1 1e-4\n0.3 .8\n0.30002 .80003\n.2 .1\n.2003 .1001\n");
    const Result result = folder.run("mesh p.txt -o m.node --method netmesh --cages thesis --check --json");
    CHECK(result.exit == 0);
    CHECK(text_in(result.out, "cage_kind") == "thesis");
    CHECK(number_in(result.out, "cages") == 5);
    CHECK(number_in(result.out, "tau") == 7);
    const std::string nodes = folder.read("m.node");
    const std::size_t kind = nodes.find("# cages thesis\n"), line = nodes.find("# cage ", kind + 8);
    REQUIRE(kind != std::string::npos);
    REQUIRE(line != std::string::npos);
    const Result check = folder.run("check m.node --points p.txt");
    CHECK(check.exit == 0);
    CHECK(check.out.find("5 cages nested about inputs, none encroached; their cells and all others whole") !=
          std::string::npos);
    const auto is_refused = [&](const std::string& changed) {
        folder.write("m.node", changed);
        return folder.run("check m.node").exit == 7;
    };
    const std::size_t end = nodes.find('\n', line), radius = nodes.find(' ', line + 7);
    CHECK(is_refused(nodes.substr(0, kind) + nodes.substr(kind + 15)));  // of another kind
    CHECK(is_refused(nodes.substr(0, line) + nodes.substr(end + 1)));    // a cage is missing
    CHECK(is_refused(nodes.substr(0, radius) + " 0.3" + nodes.substr(end)));
    CHECK(is_refused(nodes.substr(0, nodes.find("# tau 7")) + "# tau 3.5" + nodes.substr(nodes.find("# tau 7") + 7)));
    const std::size_t last = nodes.rfind(" 1\n"), exempt = nodes.find(" 2\n");
    REQUIRE(last != std::string::npos);
    REQUIRE(exempt != std::string::npos);
    CHECK(is_refused(nodes.substr(0, last) + " 2" + nodes.substr(last + 2)));
    CHECK(is_refused(nodes.substr(0, exempt) + " 1" + nodes.substr(exempt + 2)));
    CHECK(folder.run("check m.node --tau 3.5").exit == 7);
    folder.write("m.node", nodes.substr(0, kind) + "# cages large" + nodes.substr(kind + 14));
    CHECK(folder.run("check m.node").exit == 3);
    CHECK(folder.run("mesh p.txt -o f.node --method netmesh --cages thesis --finish --quiet").exit == 0);
    CHECK(folder.run("check f.node --points p.txt").out.find("\n1 cage nested") != std::string::npos);
    CHECK(folder.run("mesh p.txt -o f.node --method netmesh --cages thesis --tau 3").exit == 2);
    folder.write("five.txt", "0 0 0 0 0\n1 0 0 0 0\n0 1 0 0 0\n");
    const Result five = folder.run("mesh five.txt -o f.node --method netmesh --cages thesis");
    const bool is_there = folder.run("mesh five.txt -o f.node").exit == 0;  // has the tool been built for D = 5?
    CHECK(five.exit == (is_there ? 2 : 3));
    if (is_there)
        CHECK(five.err.find("--cages thesis: there are cages of the thesis up to D = 4") != std::string::npos);
    folder.write("v.node", "# domain 0 0 0 0 0 1\n# cages thesis\n1 5 0 1\n0 0 0 0 0 0 0\n");
    folder.write("v.ele", "0 6 0\n");
    folder.write("v.neigh", "0 6\n");
    CHECK(folder.run("check v.node").exit == 3);
}

TEST_CASE("mesh --method netmesh: cages written, drawn and checked from the files, tampering found") {
    const Folder folder;
    folder.write("p.txt", "0 0\n1 0\n-1e-3 1e-3\n1e-6 1e-6\n0 -1e-9\n1e-12 0\n");
    const Result result = folder.run("mesh p.txt -o m.node --method netmesh --check --json --svg m.svg");
    CHECK(result.exit == 0);
    CHECK(text_in(result.out, "method") == "netmesh");
    CHECK(number_in(result.out, "cages") == 4);
    CHECK(number_in(result.out, "aspect_ratio_max") <= 2.5);
    Result check = folder.run("check m.node --points p.txt");
    CHECK(check.exit == 0);
    CHECK(check.out.find("4 cages") != std::string::npos);
    CHECK(folder.read("m.svg").find("4 cages") != std::string::npos);
    CHECK(folder.run("mesh p.txt -o m.vtu --method netmesh --quiet").exit == 0);
    CHECK(folder.read("m.vtu").find("Name=\"domain\"") != std::string::npos);
    CHECK(folder.read("m.vtu").find("Name=\"aspect_ratio\"") != std::string::npos);

    const std::string nodes = folder.read("m.node");
    const std::size_t line = nodes.find("# cage "), end = nodes.find('\n', line);
    folder.write("m.node", nodes.substr(0, line) + nodes.substr(end + 1));
    CHECK(folder.run("check m.node").exit == 7);
    const std::size_t radius = nodes.find(' ', line + 7);
    folder.write("m.node", nodes.substr(0, radius) + " 0.3" + nodes.substr(end));
    CHECK(folder.run("check m.node").exit == 7);
    folder.write("m.node", nodes.substr(0, line) + "# cage 99999 1" + nodes.substr(end));
    CHECK(folder.run("check m.node").exit == 3);
    CHECK(folder.run("mesh p.txt -o f.node --method netmesh --finish --quiet").exit == 0);
    CHECK(folder.read("f.node").find("# cage") == std::string::npos);
    CHECK(folder.run("check f.node --points p.txt").exit == 0);
    const Result audited = folder.run("mesh p.txt -o a.node --method netmesh --audit all --json");
    CHECK(audited.exit == 0);
    CHECK(number_in(audited.out, "nets") >= 1);
    CHECK(number_in(audited.out, "meshes") >= 6);
    const Result located = folder.run("mesh p.txt -o a.node --method netmesh --audit location");
    CHECK(located.err.find("located  in") != std::string::npos);
    CHECK(folder.run("check a.node --points p.txt").exit == 0);
    CHECK(folder.run("mesh p.txt -o a.node --audit some").exit == 2);
    for (const char* what : {"all --method refine", "quality --method refine", "location --eps 0.5"})
        CHECK(folder.run(std::string("mesh p.txt -o a.node --audit ") + what).exit == 2);
    const Result fine = folder.run("mesh p.txt -o a.node --audit quality --eps 0.5 --json");
    CHECK(fine.exit == 0);
    CHECK(number_in(fine.out, "degree_max") >= 3);
    const Result certified = folder.run("persist p.txt -o a.pers --audit quality");
    CHECK(certified.exit == 0);
    CHECK(certified.err.find("aspect ratio of points at most") != std::string::npos);
    CHECK(certified.err.find(", degree ") != std::string::npos);
    for (const char* what : {"location", "all", "quality --filter alpha", "quality --filter scales",
                             "quality --filter rips", "quality --fit --memory 1G"})
        CHECK(folder.run(std::string("persist p.txt -o a.pers --audit ") + what).exit == 2);
    CHECK(folder.run("mesh p.txt -o r.node --method refine --quiet").exit == 0);
    CHECK(folder.run("check r.node --points p.txt").exit == 0);
}

TEST_CASE("persist: diagrams that are checked, tampering found") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 80 -o p.csv").exit == 0);
    for (const std::string filter : {"complete", "basic", "alpha"}) {
        CAPTURE(filter);
        const Result result = folder.run("persist p.csv -o d.pers --json --check --svg d.svg --filter " + filter);
        CHECK(result.exit == 0);
        CHECK(result.err == "");
        CHECK(text_in(result.out, "units") == "radius");
        CHECK(number_in(result.out, "certified_ratio") >= 1);
        CHECK(number_in(result.out, "certified_ratio") < 2.6);
        CHECK(folder.read("d.svg").rfind("<svg ", 0) == 0);
        const std::string bars = folder.read("d.pers");
        CHECK(bars.rfind("# netmesh diagram 1: degree birth death\n", 0) == 0);
        CHECK(bars_of(bars).rfind("0 0 ", 0) == 0);
        CHECK(bars.find("0 0 inf\n") != std::string::npos);
        CHECK(folder.run("persist p.csv --quiet --filter " + filter).out == bars);
        const Result check = folder.run("check d.pers --points p.csv");
        CHECK(check.exit == 0);
        CHECK(check.out.find("filter " + filter) != std::string::npos);
        CHECK(folder.run("check d.pers").exit == 7);
        folder.write("d.pers", bars.substr(0, bars.rfind('\n', bars.size() - 2) + 1));  // the last bar is gone
        CHECK(folder.run("check d.pers --points p.csv").exit == 7);
        folder.write("d.pers", "1 0 1\n" + bars);
        CHECK(folder.run("check d.pers").exit == 7);
        folder.write("d.pers", bars + "1 2 x\n");
        CHECK(folder.run("check d.pers").exit == 3);
    }
}

TEST_CASE("persist: bounds of single bars") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 60 -o p.csv").exit == 0);
    for (const char* filter : {"complete", "basic", "alpha", "knn --k 3", "scales"}) {
        CAPTURE(filter);
        const std::string line = std::string("persist p.csv --bounds --filter ") + filter;
        CHECK(folder.run(line + " -o d.pers --quiet").exit == 0);
        const std::string bars = folder.read("d.pers");
        CHECK(bars.find(" # birth ") != std::string::npos);
        CHECK(bars.find(" inf # birth ") != std::string::npos);
        CHECK(bars.find(" exists\n") != std::string::npos);
        const std::string check = std::string("check d.pers --points p.csv --filter ") + filter;
        const Result good = folder.run(check);
        CHECK(good.exit == 0);
        CHECK(good.out.find("the same bars, bounds and ratios by scale") != std::string::npos);
        CHECK((bars.find("# scale ") != std::string::npos) == (std::string(filter) != "alpha"));
        // A digit of a bound, or of the ratio at a scale, is not what it was.
        std::string forged = bars;
        forged[forged.find_last_of("0123456789")] ^= 1;
        folder.write("d.pers", forged);
        const Result bad = folder.run(check);
        CHECK(bad.exit == 7);
        CHECK(bad.says("bounds differ"));
        const std::size_t scale = bars.find("\n# scale ");
        if (scale != std::string::npos) {
            forged = bars;
            forged.replace(forged.find(" ratio ", scale) + 7, 1, "9");
            folder.write("d.pers", forged);
            const auto line = std::count(bars.begin(), bars.begin() + static_cast<std::ptrdiff_t>(scale), '\n') + 2;
            CHECK(folder.run(check).says("d.pers:" + std::to_string(line) + ": check failed: bounds differ"));
        }
        const Result json = folder.run(line + " --json");
        CHECK(json.out.find("\"certain\": [") != std::string::npos);
        CHECK(json.out.find("\"bounds\": [[") != std::string::npos);
        CHECK(json.out.find("\"scale_steps\": [") != std::string::npos);
    }
    CHECK(folder.run("persist p.csv --filter complete --bounds --quiet -o d.pers --svg d.svg").exit == 0);
    CHECK(folder.read("d.svg").find("certified ratio at radius r") != std::string::npos);
}

TEST_CASE("persist: d_k and the k-distance") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 80 -o p.csv").exit == 0);
    for (const std::string filter : {"knn", "kdistance"}) {
        CAPTURE(filter);
        const std::string k = " --k 4 --filter " + filter;
        const Result result = folder.run("persist p.csv -o d.pers --json --check --svg d.svg --mesh m.node" + k);
        CHECK(result.exit == 0);
        CHECK(result.err == "");
        CHECK(number_in(result.out, "k") == 4);
        CHECK(text_in(result.out, "reference").find("sublevel sets of") == 0);
        CHECK(number_in(result.out, "certified_ratio") < 2.6);
        CHECK(bars_of(folder.read("d.pers")).rfind("0 0 ", 0) == std::string::npos);  // nothing is born at 0
        for (const std::string source : {"--points p.csv", "--mesh m.node"}) {
            const Result check = folder.run("check d.pers " + source + k);
            CHECK(check.err == "");
            CHECK(check.exit == 0);
            CHECK(check.out.find("filter " + filter + ", certified values") != std::string::npos);
            CHECK(folder.run("check d.pers " + source + " --k 4").exit == 0);
            CHECK(folder.run("check d.pers " + source + " --k 5").exit == 2);
        }
        CHECK(folder.run("persist p.csv --k 0 --filter " + filter).exit == 2);
        const Result many = folder.run("persist p.csv --k 81 --filter " + filter);
        CHECK(many.exit == 3);
        CHECK(many.says("p.csv: --k 81: "));
        CHECK(many.says("more than the number of different points"));
        CHECK(bars_of(folder.run("persist p.csv --quiet --filter " + filter).out) ==
              bars_of(folder.run("persist p.csv --quiet --method svr").out));
    }
}

TEST_CASE("persist: without --filter the engine chooses, and one line says so") {
    const Folder folder;
    CHECK(folder.run("sample torus -n 300 -o t.csv").exit == 0);
    CHECK(folder.run("sample helix -n 400 -o h.csv").exit == 0);
    const std::string small = "filter alpha: the exact alpha complex is affordable\n",
                      large = "filter complete: the exact alpha complex would take more work than a mesh\n",
                      of_a_mesh = "filter complete: --tau asks for a mesh\n";
    struct Call {
        std::string options, said, filter, why;
    };
    const Call calls[] = {{"t.csv", small, "alpha", "affordable"},
                          {"t.csv --filter auto", small, "alpha", "affordable"},
                          {"t.csv --filter complete --filter auto", small, "alpha", "affordable"},
                          {"h.csv", large, "complete", "cells"},
                          {"t.csv --tau 3", of_a_mesh, "complete", "asked"},
                          {"t.csv --tau 3 --filter auto", of_a_mesh, "complete", "asked"},
                          {"t.csv --filter complete", "", "complete", "asked"}};
    for (const Call& call : calls) {
        CAPTURE(call.options);
        const Result result = folder.run("persist " + call.options + " --json --check -o d.pers");
        CHECK(result.exit == 0);
        CHECK(result.err == call.said);
        const std::string diagram = result.out.substr(result.out.find("\"diagram\": {"));
        CHECK(text_in(diagram, "filter") == call.filter);
        CHECK(text_in(diagram, "why") == call.why);
        CHECK(folder.read("d.pers").find("\n# filter " + call.filter + "\n") != std::string::npos);
        const std::string points = call.options.substr(0, 5);
        CHECK(folder.run("check d.pers --points " + points).exit == 0);
        const std::string asked = call.options.find("--tau") == std::string::npos ? "" : " --tau 3";
        CHECK(folder.run("persist " + points + asked + " --quiet --filter " + call.filter).out ==
              folder.read("d.pers"));
        CHECK(folder.run("persist " + call.options + " --quiet").err == "");
    }
    CHECK(folder.run("check d.pers --points t.csv --filter auto").exit == 2);
    CHECK(folder.run("vineyard t.csv --k 1..2 --filter auto").exit == 2);
    CHECK(folder.run("size --dim 3 --points 300 --filter auto").out == folder.run("size --dim 3 --points 300").out);
}

TEST_CASE("persist: refinement by the certificate") {
    const Folder folder;
    CHECK(folder.run("sample sphere --dim 3 -n 150 -o p.csv").exit == 0);
    const Result plain = folder.run("persist p.csv --filter complete -o d.pers --json --check --mesh m.node --tau 3");
    CHECK(plain.err == "");
    CHECK(plain.exit == 0);
    CHECK(text_in(plain.out, "method") == "certificate");
    CHECK(number_in(plain.out, "certified_ratio") <= std::sqrt(5.0));
    CHECK(plain.out.find("\"tau\": null") != std::string::npos);
    const Result quality = folder.run("persist p.csv --json --quiet --method svr --tau 3 -o q.pers");
    CHECK(number_in(quality.out, "vertices") > number_in(plain.out, "vertices"));
    CHECK(folder.read("m.node").find("\n# ratio 2.2360679") != std::string::npos);
    for (const std::string source : {"--points p.csv --tau 3", "--mesh m.node"}) {
        const Result check = folder.run("check d.pers " + source);
        CHECK(check.err == "");
        CHECK(check.exit == 0);
    }
    CHECK(folder.run("check m.node --points p.csv").out.find("certified ratio at most 2.236") != std::string::npos);
    CHECK(folder.run("check m.node --ratio 2").exit == 7);
    CHECK(folder.run("check q.pers --points p.csv --tau 3").exit == 0);

    const Result focused =
        folder.run("persist p.csv --ratio 2.5 --focus 1.6 --from .5 --to .9 --json -o f.pers --bounds");
    CHECK(focused.exit == 0);
    CHECK(number_in(focused.out, "focus_ratio") == 1.6);
    CHECK(folder.run("check f.pers --points p.csv --ratio 2.5 --focus 1.6 --from .5 --to .9").exit == 0);
    CHECK(folder.run("check f.pers --points p.csv --ratio 2.5").exit == 0);
    CHECK(folder.run("check f.pers --points p.csv --ratio 2.4").exit == 2);

    double last = 10;
    for (const std::string memory : {"512K", "1M", "4M"}) {
        const Result fitted =
            folder.run("persist p.csv --fit --memory " + memory + " --json --quiet -o b.pers --check");
        CHECK(fitted.err == "");
        CHECK(fitted.exit == 0);
        CHECK(number_in(fitted.out, "certified_ratio") < last);
        last = number_in(fitted.out, "certified_ratio");
    }
    CHECK(folder.run("persist p.csv --fit --memory 20K").exit == 4);
    CHECK(folder.run("persist p.csv --focus auto --memory 20K").exit == 4);
    for (const std::string line : {"--fit",
                                   "--fit --memory 1M --focus 1.5",
                                   "--fit --memory 1M --from 1",
                                   "--ratio 1.4",
                                   "--ratio x",
                                   "--focus 1.5",
                                   "--focus 1.5 --from 2 --to 1",
                                   "--focus 1",
                                   "--ratio 2 --filter knn",
                                   "--ratio 2 --values thesis",
                                   "--ratio 2 --method svr",
                                   "--fit --memory 1M --filter alpha",
                                   "--fit --memory 1M --method svr",
                                   "--focus auto",
                                   "--focus auto --memory 1M --fit",
                                   "--focus auto --memory 1M --from 1 --to 2",
                                   "--focus auto --memory 1M --filter knn",
                                   "--focus auto --memory 1M --filter tight --ratio 2",
                                   "--focus auto --memory 1M --values thesis",
                                   "--focus auto --memory 1M --method svr",
                                   "--focus auto --memory 1M --audit quality",
                                   "--focus auto --memory 1M --longer-than 1",
                                   "--longer-than 2",
                                   "--focus 1.6 --ratio 2.5 --from .5 --to .9 --longer-than 2"}) {
        CAPTURE(line);
        CHECK(folder.run("persist p.csv " + line).exit == 2);
    }
    // What only the library finds wrong is said of the option that it comes from.
    for (const std::string line : {"--ratio 1e300", "--focus 2.6 --ratio 2.5 --from .1 --to .9",
                                   "--from 1e-18 --ratio 2.5 --focus 1.6 --to .9"}) {
        CAPTURE(line);
        const Result refused = folder.run("persist p.csv " + line);
        CHECK(refused.exit == 2);
        CHECK(refused.says("netmesh: " + line.substr(0, line.find(' ', line.find(' ') + 1)) + ": "));
    }
}

TEST_CASE("persist: --focus auto finds where bars are undecided, and the file says what it found") {
    const Folder folder;
    CHECK(folder.run("sample figure-eight -n 60 -o p.txt").exit == 0);
    const Result coarse = folder.run("persist p.txt --ratio 2 --bounds --json --quiet -o c.pers");
    const Result chosen =
        folder.run("persist p.txt --ratio 2 --focus auto --memory 1M --json --quiet -o d.pers --check");
    CHECK(chosen.err == "");
    CHECK(chosen.exit == 0);
    const auto real = [](const std::string& file) {
        std::size_t count = 0, at = 0;
        while ((at = file.find(" exists\n", at)) != std::string::npos) ++at, ++count;
        return count;
    };
    CHECK(real(folder.read("c.pers")) == 61);  // one loop of two, and the components
    CHECK(real(folder.read("d.pers")) == 62);
    CHECK(number_in(chosen.out, "longer_than") == 1.5);
    CHECK(number_in(chosen.out, "undecided_to") == 0);
    CHECK(number_in(chosen.out, "decided_from") < 0.4);  // both die at 0.41
    CHECK(number_in(chosen.out, "decided_from") > 0);
    const std::string file = folder.read("d.pers");
    for (const std::string line : {"\n# ratio 2\n", "\n# focus 1.2", "\n# from 0.3", "\n# to ", "\n# bounds\n"})
        CHECK(file.find(line) != std::string::npos);
    for (const std::string name : {"# fit", "# memory", "# longer-than", "auto"})
        CHECK(file.find(name) == std::string::npos);
    CHECK(folder.run("check d.pers --points p.txt").exit == 0);
    CHECK(folder.run("check d.pers --points p.txt --focus auto").exit == 2);
    const Result told = folder.run("persist p.txt --ratio 2 --focus auto --memory 1M -o e.pers");
    CHECK(folder.read("e.pers") == file);
    CHECK(told.err.find("undecided H0 0, H1 0 bars may live longer than 1.5 times their birth\n") != std::string::npos);
    CHECK(told.err.find("decided  all classes that live longer than 1.5 times") != std::string::npos);
    // What is asked of no bar is decided at once, and nothing is refined.
    const Result all =
        folder.run("persist p.txt --ratio 2 --focus auto --longer-than 20 --memory 1M --quiet -o f.pers");
    CHECK(all.exit == 0);
    CHECK(folder.read("f.pers") == folder.read("c.pers"));
}

TEST_CASE("persist: the mesh that was filtered vouches for the diagram") {
    const Folder folder;
    CHECK(folder.run("sample torus -n 60 -o p.txt").exit == 0);
    CHECK(folder.run("persist p.txt -o d.pers --mesh m.node --values thesis --tau 3").exit == 0);
    CHECK(folder.names() == Names{"d.pers", "m.ele", "m.neigh", "m.node", "p.txt"});
    const Result check = folder.run("check d.pers --mesh m.node");
    CHECK(check.err == "");
    CHECK(check.exit == 0);
    CHECK(check.out.find("vertex values are those of filter complete, thesis values") != std::string::npos);
    CHECK(check.out.find("the same bars of m.node for filter complete, thesis values") != std::string::npos);
    CHECK(folder.run("check d.pers --mesh m.node --filter basic").exit == 2);
}

TEST_CASE("JSON without -o carries the bars") {
    const Folder folder;
    const Result result = folder.run("persist - --filter alpha --json", "0 0\n1 0\n0 1\n1 1\n");
    CHECK(result.exit == 0);
    CHECK(result.err == "");
    CHECK(result.out.find("\"bars\": [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0.5], [0, 0, null], [1, 0.5, 0.7071067811865") !=
          std::string::npos);
}

TEST_CASE("fingerprints: the same for every format and every memory") {
    const Folder folder;
    CHECK(folder.run("sample sphere -n 100 -o p.txt").exit == 0);
    CHECK(folder.run("sample sphere -n 100 -o p.npy").exit == 0);
    CHECK(folder.run("sample sphere -n 100 -o p.csv").exit == 0);
    const std::string json = folder.run("persist p.txt --json -o d.pers").out;
    const std::string print = text_in(json, "fingerprint");
    CHECK(print.size() == 16);
    for (const char* line : {"p.npy", "p.csv", "p.txt --memory 64M", "p.txt --memory 100000000"}) {
        CAPTURE(line);
        CHECK(text_in(folder.run(std::string("persist --json -o d.pers ") + line).out, "fingerprint") == print);
    }
    CHECK(text_in(folder.run("persist p.txt --seed 2 --json -o d.pers").out, "fingerprint").size() == 16);
}

TEST_CASE("an alpha complex of coordinates too far apart in size is refused, and nothing is left") {
    const Folder folder;
    folder.write("far.txt", "0 0 0 0 0 3e-300\n1e300 0 0 0 0 0\n0 1e300 0 0 0 0\n0 0 1e300 0 0 0\n0 0 0 1e300 0 0\n"
                            "0 0 0 0 1e300 0\n1e300 0 0 0 0 1e300\n");
    const Result result = folder.run("persist far.txt --filter alpha -o far.pers");
    CHECK(result.exit == 3);
    CHECK(result.says("far.txt: coordinates too far apart in size"));
    CHECK(!folder.has("far.pers"));
}

TEST_CASE("size: one integer, enough for uniform points") {
    const Folder folder;
    for (const char* dim : {"2", "3", "4"}) {
        const Result size = folder.run(std::string("size --points 300 --dim ") + dim);
        CHECK(size.exit == 0);
        CHECK(size.err == "");
        const std::string bytes = size.out.substr(0, size.out.size() - 1);
        CHECK(std::to_string(std::strtoull(bytes.c_str(), nullptr, 10)) == bytes);
        CHECK(folder.run(std::string("sample ball -n 300 -o p.txt --dim ") + dim).exit == 0);
        for (const char* command : {"mesh", "delaunay", "persist"}) {
            const Result result = folder.run(std::string(command) + " p.txt --quiet --memory " + bytes);
            CHECK(result.err == "");
            CHECK(result.exit == 0);
        }
        const Result alpha = folder.run(std::string("size --points 300 --filter alpha --dim ") + dim);
        CHECK(folder.run("persist p.txt --quiet --filter alpha --memory " + alpha.out.substr(0, alpha.out.size() - 1))
                  .exit == 0);
    }
}

TEST_CASE("distance: a line per degree, plain and log, faults by file and line") {
    const Folder folder;
    folder.write("a.pers", "# a comment\n0 0 inf\n0 0 1\n1 1 3\n");
    folder.write("b.pers", "0 0 2\n1 1.5 3.5\n0 0 inf\n\n2 1 inf\n");
    folder.write("empty.pers", "");
    folder.write("none.csv", "degree,birth,death\n");
    Result result = folder.run("distance a.pers b.pers");
    CHECK(result.exit == 0);
    CHECK(result.err == "");
    CHECK(result.out == "0 1\n1 0.5\n2 inf\n");
    CHECK(folder.run("distance b.pers a.pers --log").out == "0 0.6931471805599453\n1 0.4054651081081644\n2 inf\n");
    CHECK(folder.run("distance a.pers a.pers").out == "0 0\n1 0\n");
    CHECK(folder.run("distance --log a.pers - ", "1 1 3\n0 0 inf\n0 1e-9 1\n").out == "0 inf\n1 0\n");
    CHECK(folder.run("distance none.csv none.csv").out == "");
    CHECK(folder.run("distance none.csv empty.pers").says("empty.pers: no diagram: "));
    CHECK(folder.run("distance a.pers empty.pers").exit == 3);
    const std::string c = "1 0 2\n1 10 14\n", d = "1 0 2.5\n1 10 13\n1 20 21\n";
    folder.write("c.pers", c);
    folder.write("d.pers", d);
    CHECK(folder.run("distance c.pers d.pers --wasserstein 1").out.rfind("1 2.0000000000", 0) == 0);
    result = folder.run("distance c.pers d.pers --wasserstein 1 --json");
    for (const char* part : {"\"order\": 1,", "\"distances\": [[1, 2.0000000000", "\"lower_bounds\": [[1, 1.9999"})
        CHECK(result.out.find(part) != std::string::npos);
    result = folder.run("distance a.pers b.pers");
    CHECK(folder.run("distance c.pers d.pers --wasserstein 2 --error 1e-6").out.rfind("1 1.2247448", 0) == 0);
    for (const char* wrong : {"--wasserstein 0", "--wasserstein 17", "--wasserstein x", "--wasserstein 1 --log",
                              "--error .1", "--wasserstein 1 --error 0"})
        CHECK(folder.run(std::string("distance c.pers d.pers ") + wrong).exit == 2);
    CHECK(folder.run("distance none.csv a.pers --quiet").out == "0 inf\n1 1\n");
    CHECK(folder.run("distance a.pers b.pers --json").out.find("\"distances\": [[0, 1], [1, 0.5], [2, null]]") !=
          std::string::npos);

    folder.write("bad.pers", "0 0 inf\n\n1 2\n");
    folder.write("late.pers", "0 0 inf\n1 3 2\n");
    folder.write("nan.pers", "0 0 nan\n");
    const char* const faults[][2] = {{"bad.pers", "bad.pers:3: "},
                                     {"late.pers", "late.pers:2: "},
                                     {"nan.pers", "nan.pers:1: "},
                                     {"missing.pers", "missing.pers: no such file"}};
    for (const auto& fault : faults) {
        CAPTURE(fault[0]);
        for (const std::string& line :
             {std::string("distance a.pers ") + fault[0], std::string("distance ") + fault[0] + " a.pers"}) {
            result = folder.run(line);
            CHECK(result.exit == 3);
            CHECK(result.says(fault[1]));
            CHECK(result.out == "");
        }
    }
    CHECK(folder.run("distance a.pers").exit == 2);
    CHECK(folder.run("distance a.pers b.pers a.pers").exit == 2);
    CHECK(folder.run("distance - -").exit == 2);
    CHECK(folder.run("distance a.pers b.pers --tau 3").exit == 2);
}

TEST_CASE("homology: a filtered complex from a file, its cycles, its faults by line") {
    const Folder folder;
    folder.write("t.txt", "# a triangle that is filled late\n5, 0\n9 0\n7 0\n\n5 7 1\n9;5;2\n7 9 3\n5 7 9 4.5\n");
    Result result = folder.run("homology t.txt --check --representatives c.txt --svg t.svg");
    CHECK(result.exit == 0);
    CHECK(result.out == "0 0 1\n0 0 2\n0 0 inf\n1 3 4.5\n");
    CHECK(result.says("Betti    1, 0, 0"));
    CHECK(folder.read("c.txt") ==
          "bar 0 0 1 2\n7\n5\nbar 0 0 2 2\n9\n5\nbar 0 0 inf 1\n5\nbar 1 3 4.5 3\n7 9\n5 9\n5 7\n");
    CHECK(folder.read("t.svg").rfind("<svg ", 0) == 0);
    result = folder.run("homology t.txt -o t.pers --json --max-degree 1");
    CHECK(result.exit == 0);
    CHECK(result.err == "");
    CHECK(result.out.find("\"essential\": [1, 0]") != std::string::npos);
    CHECK(result.out.find("\"mesh\": null") != std::string::npos);
    CHECK(folder.run("distance t.pers -", "1 3 4.5\n0 0 inf\n").out == "0 1\n1 0\n");
    CHECK(folder.run("homology t.txt --all --quiet --max-degree 0").out == "0 0 1\n0 0 2\n0 0 inf\n");
    CHECK(folder.run("homology - --quiet", "1 -2\n2 -1\n1 2 -0.5\n").out == "0 -2 inf\n0 -1 -0.5\n");
    CHECK(folder.run("homology - --quiet --svg n.svg", "1 -2\n2 -1\n").out == "0 -2 inf\n0 -1 inf\n");
    CHECK(folder.read("n.svg").find(">\xE2\x88\x92"
                                    "2 to ") != std::string::npos);
    // The real projective plane: over Z/2 it has a class in every degree.
    std::string plane;
    for (const char* s : {"0 1 2", "0 2 3", "0 3 4", "0 4 5", "0 1 5", "1 2 4", "2 3 5", "1 3 4", "2 4 5", "1 3 5"}) {
        plane += std::string(s) + " 2\n";
    }
    for (int a = 0; a < 6; a++) {
        plane += std::to_string(a) + " 0\n";
        for (int b = 0; b < a; b++) plane += std::to_string(a) + " " + std::to_string(b) + " 1\n";
    }
    result = folder.run("homology - --check", plane);
    CHECK(result.exit == 0);
    CHECK(result.says("Betti    1, 1, 1"));

    const char* const faults[][2] = {
        {"5 0\n7 0\n\n5 7 9 4\n", "<stdin>:4: simplex 5 7 9: its face 7 9 is missing"},
        {"5 0\n7 2\n7 5 1\n", "<stdin>:3: simplex 5 7: enters at 1, before its face 7 of line 2 at 2"},
        {"5 0\n7 0\n5 0\n", "<stdin>:3: simplex 5: is listed in line 1 already"},
        {"5 0\n5 5 0\n", "<stdin>:2: simplex 5 5: a simplex has a vertex twice"},
        {"5 0\n7 x\n", "<stdin>:2: \"x\" is not a number"},
        {"5 0\n7 nan\n", "<stdin>:2: "},
        {"5 0\n-7 1\n", "<stdin>:2: -7 is not a vertex"},
        {"5 0\n1.5 1\n", "<stdin>:2: 1.5 is not a vertex"},
        {"5\n", "<stdin>:1: "},
        {"", "<stdin>:1: "}};
    for (const auto& fault : faults) {
        CAPTURE(fault[1]);
        result = folder.run("homology -", fault[0]);
        CHECK(result.exit == 3);
        CHECK(result.says(fault[1]));
        CHECK(result.out == "");
    }
    CHECK(folder.run("homology t.txt --memory 2000").exit == 4);
    CHECK(folder.run("homology t.txt --memory 200K --quiet").exit == 0);
    CHECK(folder.run("homology t.txt -o t.txt").exit == 2);
    CHECK(folder.run("homology").exit == 2);
}

TEST_CASE("persist: filters on the points themselves") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 14 -o p.csv").exit == 0);
    CHECK(folder.run("persist p.csv --filter alpha --quiet -o alpha.pers").exit == 0);
    for (const std::string filter : {"rips", "cech", "barycentric-cech --k 2", "barycentric-rips --k 2"}) {
        CAPTURE(filter);
        const Result result = folder.run("persist p.csv -o d.pers --json --check --svg d.svg --filter " + filter);
        CHECK(result.exit == 0);
        CHECK(result.err == "");
        CHECK(result.out.find("\"mesh\": null") != std::string::npos);
        CHECK(number_in(result.out, "max_degree") == 1);
        const double ratio = number_in(result.out, "certified_ratio"), fourth_root_of_two = 1.189207115002721;
        if (filter.find("-rips") == std::string::npos)
            CHECK(ratio == 1);
        else
            CHECK((ratio > fourth_root_of_two && ratio < fourth_root_of_two * (1 + 1e-15)));
        const std::string bars = folder.read("d.pers");
        CHECK(folder.run("persist p.csv --quiet --filter " + filter).out == bars);
        CHECK(folder.run("check d.pers").exit == 7);
        const Result check = folder.run("check d.pers --points p.csv --filter " + filter);
        CHECK(check.err == "");
        CHECK(check.exit == 0);
        folder.write("d.pers", bars.substr(0, bars.rfind('\n', bars.size() - 2) + 1));
        CHECK(folder.run("check d.pers --points p.csv --filter " + filter).exit == 7);
        const std::string size = folder.run("size --dim 2 --points 14 --filter " + filter).out;
        CHECK(folder.run("persist p.csv --quiet --filter " + filter + " --memory " + size.substr(0, size.size() - 1))
                  .exit == 0);
        CHECK(folder.run("persist p.csv --quiet --filter " + filter + " --memory 3K").exit == 4);
    }
    CHECK(folder.run("persist p.csv --filter cech --quiet -o cech.pers --representatives c.txt").exit == 0);
    CHECK(folder.read("c.txt").rfind("bar 0 0 ", 0) == 0);
    CHECK(text_in(folder.run("persist p.csv --filter cech --json -o d.pers").out, "reference") ==
          "closed offsets of the points in R^2");
    CHECK(text_in(folder.run("persist p.csv --filter rips --json -o d.pers").out, "reference") ==
          "Vietoris-Rips complex of the points, edges at half their length");
    const Result distance = folder.run("distance alpha.pers cech.pers");
    CHECK(distance.out.rfind("0 ", 0) == 0);
    CHECK(std::strtod(distance.out.c_str() + 2, nullptr) < 1e-12);
    CHECK(std::strtod(distance.out.c_str() + distance.out.find("\n1 ") + 3, nullptr) < 1e-12);
    const Result many = folder.run("persist p.csv --filter barycentric-cech --k 15 --max-degree 0");
    CHECK(many.exit == 3);
    CHECK(many.says("--k 15"));
}
