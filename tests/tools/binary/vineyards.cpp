// Vineyards: in k over a mesh, and of a complex with values of the user's.
#include <doctest/doctest.h>

#include <algorithm>

#include "run.hpp"

TEST_CASE("check: vineyards") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 40 -o p.csv").exit == 0);
    CHECK(folder.run("mesh p.csv -o m.node --quiet").exit == 0);
    CHECK(folder.run("vineyard p.csv --k 2..4 --filter kdistance -o v.vines --quiet").exit == 0);
    const std::string vines = folder.read("v.vines");
    CHECK(folder.run("check v.vines").exit == 0);
    const Result good = folder.run("check v.vines --points p.csv");
    CHECK(good.exit == 0);
    CHECK(good.out.find("is the vineyard of p.csv for filter kdistance, certified values") != std::string::npos);
    CHECK(folder.run("check v.vines --points p.csv --max-degree 0").exit == 7);
    // Another mesh has another vineyard; points that persistence meshes less far out too.
    CHECK(folder.run("check v.vines --points p.csv --tau 3").exit == 7);
    folder.write("v.vines", vines.substr(0, vines.rfind('\n', vines.size() - 2) + 1));  // the last point is gone
    CHECK(folder.run("check v.vines --points p.csv").exit == 7);
    std::string forged = vines;
    forged.replace(forged.find("certified ratio ") + 16, 1, "9");
    folder.write("v.vines", forged);
    CHECK(folder.run("check v.vines --points p.csv").says("the certified ratio at k = 2 is"));
    folder.write("v.vines", vines + "x");
    CHECK(folder.run("check v.vines").exit == 3);
    folder.write("v.vines", vines.substr(vines.find("# k ")));
    CHECK(folder.run("check v.vines").exit == 3);
    folder.write("v.vines", vines + "0 0 2 0 1\n");
    CHECK(folder.run("check v.vines").says("vines are not numbered one after the other"));
}

TEST_CASE("vineyard: diagrams of all k, each equal to its own run") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 30 -o p.csv").exit == 0);
    const Result result = folder.run("vineyard p.csv --k 1..4 -o v.vines --svg v.svg --check --json");
    CHECK(result.err == "");
    CHECK(result.exit == 0);
    CHECK(number_in(result.out, "k_last") == 4);
    CHECK(number_in(result.out, "transpositions") > 0);
    CHECK(folder.read("v.svg").rfind("<svg ", 0) == 0);
    const std::string vines = folder.read("v.vines");
    CHECK(
        vines.rfind("# netmesh vineyard 1: vine degree k birth death\n# filter knn, certified values\n# k 1 certified",
                    0) == 0);
    CHECK(folder.run("vineyard p.csv --k 1..4 --quiet").out == vines);
    // The lines of k = 3, without vine and k, are the diagram.
    std::istringstream lines(vines);
    std::vector<std::string> bars, due;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string vine, degree, k, birth, death;
        if (line[0] != '#' && words >> vine >> degree >> k >> birth >> death && k == "3") {
            bars.push_back(degree + " " + birth + " " + death);
        }
    }
    std::istringstream diagram(bars_of(folder.run("persist p.csv --filter knn --k 3 --quiet").out));
    for (std::string line; std::getline(diagram, line);) due.push_back(line);
    std::sort(bars.begin(), bars.end());
    std::sort(due.begin(), due.end());
    CHECK(!due.empty());
    CHECK(bars == due);
    CHECK(folder.run("vineyard p.csv").says("--k FIRST..LAST"));
    for (const char* line : {"--k 0..3", "--k 3..1", "--k 1..x", "--k 1..3 --filter alpha", "--k 1..3 -o v.pers"}) {
        CAPTURE(line);
        CHECK(folder.run(std::string("vineyard p.csv ") + line).exit == 2);
    }
    CHECK(folder.run("vineyard p.csv --k 1..31").exit == 3);
}

TEST_CASE("vineyard: a complex and values of the user's") {
    const Folder folder;
    folder.write("c.txt", "# a triangle with a tail\n0 0\n1 0\n2 0\n3 0\n0 1 1\n0 2 1\n1 2 1\n2 1 0 2\n2 3 5\n");
    folder.write("v.txt", "0,0,0,0,1,1,1,2,5\n# the cycle is filled at once\n0 0 0 0 1 1 1 1 5\n0 0 0 -1 1 1 1 4 0\n");
    const Result result = folder.run("vineyard c.txt --values v.txt -o v.vines --check --json");
    CHECK(result.err == "");
    CHECK(result.exit == 0);
    CHECK(number_in(result.out, "k_last") == 3);
    CHECK(number_in(result.out, "vines") == 5);
    CHECK(text_in(result.out, "units") == "value");
    const std::string vines = folder.read("v.vines");
    CHECK(vines.rfind("# netmesh vineyard 1: vine degree k birth death\n# filter none, given values\n# k 1 certified",
                      0) == 0);
    CHECK(vines.find("\n4 1 1 1 2\n4 1 3 1 4\n") != std::string::npos);
    CHECK(folder.run("vineyard c.txt --values v.txt --quiet").out == vines);
    // Values of the vertices alone say the same as those of all simplices with the last of their vertices.
    folder.write("lower.txt", "0 1 2 3\n3 -2 1 0\n");
    folder.write("spelt.txt", "0 1 2 3 1 2 2 2 3\n3 -2 1 0 3 3 1 3 1\n");
    const std::string lower = folder.run("vineyard c.txt --values lower.txt --check --quiet").out;
    CHECK(lower == folder.run("vineyard c.txt --values spelt.txt --quiet").out);
    CHECK(folder.run("vineyard c.txt --values lower.txt --quiet --svg v.svg -o v2.vines").exit == 0);
    CHECK(folder.read("v.svg").find(">\xE2\x88\x92"
                                    "2<") != std::string::npos);
    CHECK(folder.run("vineyard c.txt --values spelt.txt --max-degree 0 --quiet").out.find(" 1 ") != std::string::npos);

    CHECK(folder.run("check v.vines").exit == 0);
    CHECK(folder.run("check v.vines --complex c.txt --values v.txt")
              .out.find("is the vineyard of c.txt with the values of v.txt") != std::string::npos);
    CHECK(folder.run("check v.vines --complex c.txt --values spelt.txt").exit == 7);
    for (const auto& [have, forged] :
         {std::pair("4 1 3 1 4", "4 1 3 1 4.04"), std::pair("4 1 3 1 4\n", ""),
          std::pair("# k 3 certified ratio 1\n", "# k 3 certified ratio 1\n# k 4 certified ratio 1\n"),
          std::pair("certified ratio 1\n", "certified ratio 2\n")}) {
        CAPTURE(have);
        std::string text = vines;
        text.replace(text.find(have), std::string(have).size(), forged);
        folder.write("forged.vines", text);
        CHECK(folder.run("check forged.vines --complex c.txt --values v.txt").exit == 7);
    }
    CHECK(folder.run("check v.vines --complex c.txt").exit == 2);
    CHECK(folder.run("check v.vines --points c.txt").says("v.vines is of a complex"));

    const auto refused = [&](const std::string& values, const char* why) {
        folder.write("bad.txt", values);
        const Result bad = folder.run("vineyard c.txt --values bad.txt");
        CAPTURE(bad.err);
        CHECK(bad.exit == 3);
        CHECK(bad.says(why));
    };
    refused("0 0 0 0 1 1 1 2 5\n\n0 0 0 0 1 1 1 .5 5\n",
            "bad.txt:3: c.txt:9: simplex 0 1 2: enters at 0.5, before its face");
    refused("1 2 3\n", "bad.txt:1: 3 values; c.txt has 9 simplices, 4 of them vertices");
    refused("1 2 3 4\n1 2 3\n", "bad.txt:2: 3 values; line 1 has 4");
    refused("1 2 3 x\n", "bad.txt:1: ");
    refused("1 2 3 1e999\n", "bad.txt:1: ");
    refused("# none\n", "bad.txt:1: the input ends without a vector of values");
    folder.write("open.txt", "0 0\n0 1 1\n");
    CHECK(folder.run("vineyard open.txt --values lower.txt").exit == 3);
    folder.write("two.txt", "1 2\n");
    CHECK(folder.run("vineyard open.txt --values two.txt").says("open.txt:2: simplex 0 1: its face 1 is missing"));
    for (const char* line : {"--k 3", "--filter knn", "--tau 3", "-o v.pers"}) {
        CAPTURE(line);
        CHECK(folder.run(std::string("vineyard c.txt --values v.txt ") + line).exit == 2);
    }
    CHECK(folder.run("vineyard c.txt --values missing.txt").exit == 3);
}

TEST_CASE("vineyard: nested sets for a range of k") {
    const Folder folder;
    folder.write("square.txt", "0 0\n1 0\n1 1\n0 1\n");
    const Result result =
        folder.run("vineyard square.txt --filter barycentric-cech --k 1..4 -o s.vines --check --json");
    CHECK(result.err == "");
    CHECK(result.exit == 0);
    CHECK(number_in(result.out, "k_last") == 4);
    CHECK(number_in(result.out, "vines") == 8);
    const std::string vines = folder.read("s.vines");
    CHECK(vines.rfind("# netmesh vineyard 1: vine degree k birth death\n# filter barycentric-cech, certified values\n"
                      "# k 1 certified ratio 1\n",
                      0) == 0);
    CHECK(vines.find("\n3 0 1 0 inf\n3 0 2 0.5 inf\n3 0 3 0.707") != std::string::npos);
    CHECK(folder.run("check s.vines").exit == 0);
    CHECK(folder.run("check s.vines --points square.txt")
              .out.find("s.vines is the vineyard of square.txt for filter "
                        "barycentric-cech") != std::string::npos);
    CHECK(folder.run("check s.vines --points square.txt --max-degree 0").exit == 7);
    CHECK(folder.run("check s.vines --points square.txt --max-degree 2").exit == 0);
    CHECK(folder.run("check s.vines --mesh m.node").says("s.vines is of points: --points FILE says which"));
    CHECK(folder.run("vineyard square.txt --filter barycentric-cech --k 1..4").says("8 vines of 97 simplices"));
    // A lens is said to go on as another component, and to have been there before.
    for (const auto& [have, forged] :
         {std::pair("3 0 2 0.5 inf", "3 0 2 0.5 0.7071067811865476"),
          std::pair("4 0 2 0.5 0.7071067811865476", "4 0 2 0.5 0.71"), std::pair("7 1 1 0.5 0.7071067811865476\n", ""),
          std::pair("# k 4 certified ratio 1", "# k 4 certified ratio 2")}) {
        CAPTURE(have);
        std::string text = vines;
        text.replace(text.find(have), std::string(have).size(), forged);
        folder.write("forged.vines", text);
        CHECK(folder.run("check forged.vines --points square.txt").exit == 7);
    }
    for (const auto& [have, forged, why] :
         {std::tuple("vineyard 1:", "vineyard 2:", "is of another version of the format"),
          std::tuple("\n3 0 1", "\n# netmesh vineyard 1: vine degree k birth death\n3 0 1", "a second head"),
          std::tuple("\n3 0 1", "\n# filter barycentric-rips, certified values\n3 0 1", "a second line of the filter"),
          std::tuple("certified values", "other values", "s.vines:2: \"other\" are not values")}) {
        CAPTURE(forged);
        std::string text = vines;
        text.replace(text.find(have), std::string(have).size(), forged);
        folder.write("s.vines", text);
        CHECK(folder.run("check s.vines --points square.txt").exit == 3);
        CHECK(folder.run("check s.vines").says(why));
    }
    // Maps match no bars like these, whatever the points.
    folder.write("form.vines", "# filter barycentric-rips, thesis values\n# k 1 certified ratio 1.5\n"
                               "# k 2 certified ratio 1.5\n0 0 1 0 inf\n0 0 2 1 inf\n1 0 1 0 2\n1 0 2 2 3\n");
    CHECK(folder.run("check form.vines").says("form.vines: line 7: no map from k = 2"));
    CHECK(folder.run("check form.vines").exit == 7);

    CHECK(folder.run("sample sphere -n 8 -o p.csv").exit == 0);
    CHECK(folder.run("vineyard p.csv --filter barycentric-rips --values thesis --k 2..3 -o p.vines --quiet").exit == 0);
    CHECK(folder.run("check p.vines --points p.csv").exit == 0);
    for (const char* line :
         {"--k 1..30", "--k 1..4 --max-degree 27", "--filter rips --k 1..2", "--filter cech --k 1..2"}) {
        CAPTURE(line);
        CHECK(folder.run(std::string("vineyard p.csv --filter barycentric-cech ") + line).exit == 2);
    }
    CHECK(folder.run("vineyard p.csv --filter barycentric-cech --k 1..9").exit == 3);
    CHECK(folder.run("vineyard p.csv --filter barycentric-cech --k 1..4 --memory 64K").exit == 4);
}
