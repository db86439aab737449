// A diagram says how it was made: check needs nothing but the file and the points, and finds what has been tampered
// with.
#include <doctest/doctest.h>

#include <functional>
#include <sstream>

#include "netmesh.h"
#include "run.hpp"

namespace {

// The physical line, from 1, at which a line of the text begins with `start`; 0: none does.
std::size_t line_with(const std::string& text, const std::string& start) {
    std::istringstream lines(text);
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        number++;
        if (line.rfind(start, 0) == 0) return number;
    }
    return 0;
}

// The text with `change` done to that line; an empty result takes it out.
std::string with_line(const std::string& text, std::size_t number,
                      const std::function<std::string(const std::string&)>& change) {
    std::istringstream lines(text);
    std::string result;
    std::size_t at = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::string now = ++at == number ? change(line) : line;
        if (!now.empty()) result += now + "\n";
    }
    return result;
}

std::string with_head(const std::string& text, const std::string& name, const std::string& line) {
    return with_line(text, line_with(text, "# " + name), [&](const std::string&) { return line; });
}

// "1 0.5 0.75" with its number of that index (from 0) times `factor`.
std::string scaled(const std::string& line, int index, double factor) {
    std::istringstream words(line);
    std::string result, word;
    for (int i = 0; words >> word; i++) {
        if (i == index) {
            std::ostringstream number;
            number.precision(17);
            number << std::strtod(word.c_str(), nullptr) * factor;
            word = number.str();
        }
        result += (i > 0 ? " " : "") + word;
    }
    return result;
}

}  // namespace

TEST_CASE("provenance: every way to call persist is checked from file and points alone") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 30 -o p.csv").exit == 0);
    folder.write("p.csv", folder.read("p.csv") + "0.25 0.5\n0.25 0.5\n");  // a duplicate
    for (const std::string ways :
         {"",
          "--filter basic",
          "--filter alpha",
          "--filter alpha --all",
          "--filter alpha --bounds",
          "--filter knn --k 4",
          "--filter knn",
          "--filter kdistance --k 3 --values thesis",
          "--filter tight",
          "--filter tight --eps .4 --bounds",
          "--filter tight --ratio 2",
          "--filter tight --ratio 2.5 --focus 1.6 --from .3 --to .9",
          "--filter scales",
          "--filter scales --theta .1 --eps .5 --bounds",
          "--filter scales --theta .1 --ratio 2 --bounds",
          "--filter rips",
          "--filter rips --threshold .3",
          "--filter rips --threshold .3 --max-degree 2 --all",
          "--filter cech --max-degree 0",
          "--filter barycentric-cech --k 2",
          "--filter barycentric-rips --k 2 --values thesis",
          "--seed 7",
          "--tau 3",
          "--ratio 1.9",
          "--ratio 2.5 --focus 1.6 --from .3 --to .9 --bounds",
          "--fit --memory 512K",
          "--focus auto --memory 512K",
          "--focus auto --memory 512K --ratio 3 --longer-than 1.3 --whole-cells",
          "--fit --memory 512K --from .3 --to .9 --ratio 3 --bounds",
          "--fit --memory 512K --filter knn --k 2 --bounds",
          "--fit --memory 512K --values thesis",
          "--method svr",
          "--method refine --tau 4",
          "--method netmesh --finish",
          "--values thesis --max-degree 0",
          "--max-degree 9",
          "--bounds --all",
          "--filter function --function 'x*x + y*y - 1' --lipschitz 4 --cut -2 --bounds",
          "--filter function --function 'max(x, -x, 2*y) + 3' --lipschitz 2 --cut 3 --all",
          "--filter function --function 'sqrt(x*x + y*y)' --lipschitz 1 --cut .7 --error .1"}) {
        CAPTURE(ways);
        const Result made = folder.run("persist p.csv --quiet -o d.pers " + ways);
        CHECK(made.err == "");
        CHECK(made.exit == 0);
        const Result check = folder.run("check d.pers --points p.csv");
        CHECK(check.err == "");
        CHECK(check.exit == 0);
        CHECK(check.out.find("reproduced: the engine makes the same bars") != std::string::npos);
        CHECK(folder.run("persist p.csv --quiet " + ways).out == folder.read("d.pers"));
        // What was said on the command line may be said again.
        if (ways.find("--fit") == std::string::npos)
            CHECK(folder.run("check d.pers --points p.csv --memory 1G").exit == 0);
        const Result alone = folder.run("check d.pers");
        CHECK(alone.exit == 7);
        CHECK(alone.says("nothing was checked: it says how it was made, and --points POINTS or --mesh"));
        CHECK(!alone.says("--proof"));
    }
}

TEST_CASE("provenance: a proof beside a diagram that nothing was checked of is named") {
    const Folder folder;
    folder.run("sample circle -n 20 -o p.csv");
    REQUIRE(folder.run("persist p.csv -q -o d.pers --proof d.proof").exit == 0);
    const Result alone = folder.run("check d.pers");
    CHECK(alone.exit == 7);
    CHECK(alone.says("; d.proof is checked by --points POINTS --proof d.proof\n"));
    CHECK(folder.run("check d.pers --points p.csv --proof d.proof").exit == 0);
}

// What the diagram was fitted in did not hold the check of its mesh too; where the basic filter's ratio begins was
// asked to be what the loosest bounds of clipped cells say.
TEST_CASE("provenance: fitted diagrams are checked with their meshes") {
    const Folder folder;
    folder.run("sample sphere -n 40 -o p.txt");
    for (const std::string ways :
         {"--focus auto --memory 1M", "--fit --memory 256K --bounds", "--fit --memory 1M --bounds",
          "--filter basic --fit --memory 512K", "--filter basic --fit --memory 1M --bounds"}) {
        CAPTURE(ways);
        CHECK(folder.run("persist p.txt --quiet -o d.pers --mesh m.node " + ways).exit == 0);
        const Result check = folder.run("check d.pers --mesh m.node");
        CHECK(check.err == "");
        CHECK(check.exit == 0);
    }
}

// Of a cell of collinear points the direction to the pole of its face is nothing but rounding.
TEST_CASE("provenance: clipped cells of collinear points have a second opinion") {
    const Folder folder;
    folder.write("p.txt", "0 0 0\n4 0 -1\n8 0 -2\n12 0 -3\n16 0 -4\n20 0 -5\n");
    for (const std::string ways : {"--ratio 2.8 --bounds", "--ratio 4 --focus 1.6 --from 2.2 --to 13 --bounds"}) {
        CAPTURE(ways);
        CHECK(folder.run("persist p.txt --quiet -o d.pers --mesh m.node " + ways).exit == 0);
        CHECK(folder.run("check d.pers --mesh m.node --quiet").err == "");
    }
}

TEST_CASE("provenance: radii above the largest double are infinite, and have a second opinion") {
    const Folder folder;
    folder.write("p.txt", "-1.79e308 -1.79e308\n1.79e308 -0.8307e308\n-0.8307e308 1.79e308\n");
    for (const std::string filter : {"rips", "cech", "alpha"}) {
        CAPTURE(filter);
        const Result made = folder.run("persist p.txt -o d.pers --filter " + filter);
        CHECK(made.exit == 0);
        CHECK(folder.read("d.pers").find("\n0 0 inf\n0 0 inf\n") != std::string::npos);
        CHECK(folder.run("check d.pers --points p.txt --quiet").err == "");
    }
}

// The second opinion knew centres of balls as places and cut what it allows for rounding at 1e-3.
TEST_CASE("provenance: points as near to one another as their coordinates resolve have a second opinion too") {
    const Folder folder;
    folder.write("p.txt",
                 "0.3 0.2000000000007\n0.30000000000009996 0.1999999999999\n0.2999999999996 0.2000000000001\n");
    CHECK(folder.run("persist p.txt --quiet --filter cech -o d.pers").exit == 0);
    CHECK(folder.run("check d.pers --points p.txt --quiet").err == "");
    folder.write("q.txt", "-0.33293458536583692 0.52024275900629458\n0.049431891246738406 0.18873740412812817\n"
                          "0.37906112344763071 -0.29650688655827018\n-0.33293458536520726 0.52024275900672812\n"
                          "0.049431891245927735 0.18873740412883819\n0.37906112344730891 -0.29650688655900853\n"
                          "-0.33293458536637527 0.52024275900754668\n0.049431891245959286 0.1887374041288386\n"
                          "0.37906112344797527 -0.29650688655878327\n-0.33293458536518961 0.5202427590071993\n"
                          "0.049431891245412314 0.18873740412802181\n");
    for (const std::string ways : {"--ratio 2.3 --bounds", "--method svr --values thesis --bounds"}) {
        CHECK(folder.run("persist q.txt --quiet -o d.pers --mesh m.node " + ways).exit == 0);
        CHECK(folder.run("check d.pers --mesh m.node --quiet").err == "");
    }
    // Cells that are flat to the precision of a long double; it crashed, then had no second opinion.
    folder.write("r.txt", "-0.99642013506483285 -0.083546956583924095 -0.012915900392312286\n"
                          "3.6924515889765467e-07 -1.316158564519345e-08 -9.2923882037609145e-07\n"
                          "5.2034231272496163e-13 -3.9407026843090292e-13 -7.5759652924682426e-13\n"
                          "1.3746487538391947e-19 -8.8547555443418933e-19 -4.4388788059052536e-19\n"
                          "3.4674304949528193e-26 -8.7901903704704462e-25 4.7552415825607997e-25\n");
    CHECK(folder.run("persist r.txt --quiet --filter alpha -o d.pers --mesh m.node").exit == 0);
    CHECK(folder.run("check d.pers --mesh m.node").out.find("the same bars, to the last bit") != std::string::npos);
    // A cube bent by its last bits has cells that are flat to twice that precision; it had no second opinion.
    folder.write("bent.txt", "0.2999999999999999 0.2999999999999999 0.2999999999999999\n"
                             "0.3 0.29999999999999993 0.6\n"
                             "0.3 0.6000000000000002 0.29999999999999993\n"
                             "0.3000000000000001 0.5999999999999998 0.6000000000000002\n"
                             "0.5999999999999999 0.30000000000000004 0.30000000000000004\n"
                             "0.6000000000000002 0.3 0.6000000000000002\n"
                             "0.6000000000000001 0.6000000000000002 0.3\n"
                             "0.5999999999999998 0.5999999999999998 0.6\n");
    CHECK(folder.run("persist bent.txt --quiet --filter alpha -o d.pers --mesh m.node").exit == 0);
    const Result flat = folder.run("check d.pers --mesh m.node");
    CHECK(flat.exit == 0);
    CHECK(flat.out.find("the same bars, to the last bit") != std::string::npos);
    CHECK(folder.run("persist bent.txt --quiet --filter alpha -o d.pers --mesh m.node --representatives c.txt").exit ==
          0);
    CHECK(folder.run("check d.pers --mesh m.node --quiet --representatives c.txt").exit == 0);
    CHECK(folder.run("check d.pers --points bent.txt --quiet --representatives c.txt").exit == 0);
}

TEST_CASE("provenance: the head, line by line") {
    const Folder folder;
    folder.write("p.txt", "0 0\n1 0\n0 0\n1 1\n0 1\n");
    CHECK(folder.run("persist p.txt --quiet --filter kdistance --k 2 --tau 3 --seed 5 -o d.pers").exit == 0);
    const std::string text = folder.read("d.pers");
    const std::string head = text.substr(0, text.find("# domain"));
    CHECK(head == "# netmesh diagram 1: degree birth death\n# version " + std::string(netmesh_version_text()) +
                      "\n# filter kdistance\n# k 2\n"
                      "# values certified\n# method svr\n# tau 3\n# max-degree 1\n# seed 5\n# dim 2\n# points 5\n"
                      "# duplicates 1\n" +
                      head.substr(head.find("# input ")));
    const std::size_t ratio = text.find("# certified-ratio ");
    CHECK(ratio != std::string::npos);
    CHECK(text.find("# reference sublevel sets of the k-distance, k = 2, in R^2\n") != std::string::npos);
    // Blank lines, comments before the head and behind the bars, CRLF: as in every file.
    std::string other = "# mine\n\n" + text + "# mine too\n";
    for (std::size_t at = 0; (at = other.find('\n', at)) != std::string::npos; at += 2) other.insert(at, "\r");
    folder.write("d.pers", other);
    CHECK(folder.run("check d.pers --points p.txt").exit == 0);
    CHECK(folder.run("distance d.pers d.pers").exit == 0);
}

TEST_CASE("provenance: tampering is found, with line and reason") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 40 --seed 5 -o p.csv").exit == 0);
    CHECK(folder.run("sample annulus -n 40 --seed 2 -o q.csv").exit == 0);
    CHECK(folder.run("sample annulus -n 41 -o r.csv").exit == 0);
    CHECK(folder.run("sample annulus -n 40 --dim 3 -o s.csv").exit == 0);
    const std::string make = "persist p.csv --quiet -o d.pers --mesh m.node --bounds --filter ";
    const auto tampered = [&](const std::string& name, const std::string& content, std::size_t line,
                              const std::string& reason, const std::string& source = "--points p.csv") {
        CAPTURE(name);
        CHECK(content != folder.read("d.pers"));
        folder.write("t.pers", content);
        const Result result = folder.run("check t.pers " + source);
        CHECK(result.exit == 7);
        CHECK(result.out == "");
        const std::string where = "t.pers:" + std::to_string(line) + ": check failed: ";
        CHECK_MESSAGE(result.says(where), result.err);
        CHECK_MESSAGE(result.says(reason), result.err);
    };

    CHECK(folder.run(make + "knn --k 3").exit == 0);
    const std::string text = folder.read("d.pers");
    const auto number = [&](const std::string& start) { return line_with(text, start); };
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    const std::size_t first = number("0 "), loop = lines;  // the last bar, of degree 1
    for (const std::string source : {"--points p.csv", "--mesh m.node"}) {
        CAPTURE(source);
        const auto bad = [&](const std::string& name, const std::string& content, std::size_t line,
                             const std::string& reason) { tampered(name, content, line, reason, source); };
        const auto bar = [&](std::size_t line, int index, double factor) {
            return with_line(text, line, [&](const std::string& old) {
                const std::size_t hash = old.find(" # ");
                return scaled(old.substr(0, hash), index, factor) + old.substr(hash);
            });
        };
        bad("birth 1% up", bar(loop, 1, 1.01), loop, " is due for filter knn");
        bad("death 1% down", bar(loop, 2, 0.99), loop, "this bar or one of those lines is wrong");
        bad("a bar taken out", with_line(text, loop - 1, [](const std::string&) { return ""; }), loop - 1,
            " is due for");
        bad("a bar twice", with_line(text, loop, [](const std::string& old) { return old + "\n" + old; }), loop + 1,
            " is due for");
        bad("another degree", with_line(text, loop, [](const std::string& old) { return "2" + old.substr(1); }), loop,
            "a bar of degree 2 where max-degree is 1");
        bad("not sorted", with_line(text, first, [](const std::string&) { return "0 7 8 # birth 7 7 death 8 8"; }),
            first + 1, "not sorted");
        const std::size_t forever = text.find(" inf # ");
        std::string mortal = text;
        mortal.replace(forever, 4, " 99");
        bad("no essential class", mortal, lines, "no essential class");
        bad("certified ratio 1% down",
            with_line(text, number("# certified-ratio"), [](const std::string& old) { return scaled(old, 2, 0.99); }),
            number("# certified-ratio"), " is due");
        bad("certified from somewhere",
            with_line(text, number("# certified-ratio"),
                      [](const std::string& old) { return old + "\n# certified-from 0.1"; }),
            number("# certified-ratio") + 1, "where no such line is due");
        bad("reference", with_head(text, "reference", "# reference closed offsets of the points in R^2"),
            number("# reference"), "sublevel sets of d_3");
        bad("domain", with_line(text, number("# domain"), [](const std::string& old) { return scaled(old, 4, 1.01); }),
            number("# domain"), " is due");
        bad("k", with_head(text, "k ", "# k 4"), first, "lines");
        bad("values", with_head(text, "values", "# values thesis"), number("# certified-ratio"), " is due");
        bad("max-degree", with_head(text, "max-degree", "# max-degree 0"), number("1 "), "max-degree is 0");
        bad("bound of a bar 1% up",
            with_line(text, loop,
                      [](const std::string& old) {
                          const std::size_t hash = old.find('#');
                          return old.substr(0, hash) + scaled(old.substr(hash), 3, 1.01);
                      }),
            loop, "bounds differ");
        bad("exists",
            with_line(text, first,
                      [](const std::string& old) {
                          return old.find(" exists") == std::string::npos ? old + " exists"
                                                                          : old.substr(0, old.find(" exists"));
                      }),
            first, "bounds differ");
        bad("ratio by scale",
            with_line(text, number("# scale"),
                      [](const std::string& old) { return old.substr(0, old.find(" ratio ")) + " ratio 1.01"; }),
            number("# scale"), "bounds differ");
        bad("no line `bounds`", with_line(text, number("# bounds"), [](const std::string&) { return ""; }),
            number("# scale") - 1, "no line `# bounds`");
    }
    // What the points tell.
    tampered("number of points", with_head(text, "points", "# points 41"), number("# points"), "has 40 points");
    tampered("number of points, from the mesh", with_head(text, "points", "# points 41"), number("# points"),
             "m.node has 40 inputs", "--mesh m.node");
    tampered("duplicates", with_head(text, "duplicates", "# duplicates 1"), number("# duplicates"), "is due");
    tampered("fingerprint", with_head(text, "input", "# input 0123456789abcdef"), number("# input"), "is due");
    tampered("tau", with_head(text, "tau", "# tau 3"), first, "lines");
    tampered("too large a k", with_head(text, "k ", "# k 41"), number("# version"), "cannot be made as the head says");
    folder.write("t.pers", text);
    CHECK(folder.run("check t.pers --points q.csv").says("# input "));
    CHECK(folder.run("check t.pers --points r.csv").says("r.csv has 41 points"));
    CHECK(folder.run("check t.pers --points s.csv").says("s.csv has 3 dimensions"));

    // The order of insertion is drawn for more than 64 points.
    CHECK(folder.run("sample annulus -n 80 -o p.csv").exit == 0);
    CHECK(folder.run("persist p.csv --quiet --filter complete -o d.pers").exit == 0);
    const std::string complete = folder.read("d.pers");
    tampered("seed", with_head(complete, "seed", "# seed 2"), line_with(complete, "0 "), "lines");
    tampered("ratio", with_head(complete, "ratio", "# ratio 2"), line_with(complete, "0 "), "lines");
    // No ratio of that mesh follows from it.
    tampered("tau beside a ratio", with_head(complete, "tau", "# tau 100"), line_with(complete, "# tau"),
             "as # ratio does not follow from it");
    CHECK(folder.run("persist p.csv --quiet --tau 4 -o d.pers --mesh m.node").exit == 0);
    CHECK(folder.run("check d.pers --points p.csv --quiet").err == "");
    CHECK(folder.run("check d.pers --mesh m.node --quiet").err == "");
    const std::string mesh = folder.read("m.node"), by_tau = folder.read("d.pers");
    folder.write("m.node", with_head(mesh, "ratio", "# ratio 2"));
    CHECK(folder.run("check d.pers --mesh m.node")
              .says("d.pers:" + std::to_string(line_with(by_tau, "# ratio")) +
                    ": check failed: m.node promises ratio 2"));
    CHECK(folder.run("persist p.csv --quiet -o d.pers --filter rips").exit == 0);
    const std::string rips = folder.read("d.pers");
    tampered("filter",
             with_head(with_head(rips, "filter", "# filter cech"), "reference",
                       "# reference closed offsets of the points in R^2"),
             line_with(rips, "1 "), "is due for filter cech");
}

TEST_CASE("provenance: the function and the error of a diagram are checked") {
    const Folder folder;
    CHECK(folder.run("sample circle -n 20 -o p.txt").exit == 0);
    const std::string made = "persist p.txt --quiet --filter function --lipschitz 3 -o d.pers --mesh m.node ";
    // Two pits with a wall between them, from -1 to 0 at the sphere.
    const std::string pits = "--function 'max(sqrt(x^2 + y^2) - 1, .3 - abs(x))' --cut 0 ";
    CHECK(folder.run(made + pits + "--error .1").exit == 0);
    const std::string text = folder.read("d.pers");
    CHECK(line_with(text, "# function max(sqrt(x^2 + y^2) - 1, .3 - abs(x))") > 0);
    double error = 0;
    std::istringstream(text.substr(text.find("# certified-error ") + 18)) >> error;
    CHECK(error > 0.05);
    CHECK(error <= 0.1);
    for (const std::string source : {" --points p.txt", " --mesh m.node"}) {
        CAPTURE(source);
        CHECK(folder.run("check d.pers" + source).err == "");
        const std::string forged[][2] = {{"certified-error", "# certified-error 0.0990"},
                                         {"certified-error", "# certified-error 0.05"},
                                         {"function", "# function max(sqrt(x^2 + y^2) - 1, .31 - abs(x))"},
                                         {"cut", "# cut -0.01"},
                                         {"lipschitz", "# lipschitz 2.9"}};
        for (const auto& [name, line] : forged) {
            CAPTURE(line);
            folder.write("t.pers", with_head(text, name, line));
            const Result result = folder.run("check t.pers" + source);
            CHECK(result.exit == 7);
            CHECK(result.says("t.pers:"));
        }
    }
    // Nothing is below the first scale of a function that is above the cut: `low -inf`.
    CHECK(folder
              .run("persist p.txt --quiet --filter function --function 'x + 9' --lipschitz 1 --cut 0 --bounds "
                   "-o b.pers --mesh b.node")
              .exit == 0);
    CHECK(line_with(folder.read("b.pers"), "# scale 0 low -inf ") > 0);
    CHECK(folder.run("check b.pers --mesh b.node --quiet").err == "");
    const Result opinion = folder.run("check d.pers --mesh m.node");
    CHECK(opinion.out.find("second opinion: the function keeps to the error") != std::string::npos);
    CHECK(opinion.out.find("are the pairs of a plain reduction") != std::string::npos);
    // What cannot be so.
    const auto refused = [&](const std::string& options, const std::string& why) {
        CAPTURE(options);
        const Result result = folder.run("persist p.txt --filter function " + options);
        CHECK(result.exit == 2);
        CHECK_MESSAGE(result.says(why), result.err);
        CHECK(result.out == "");
    };
    refused("--function 'x*x + y*y - 1' --lipschitz 3 --cut .5", "--cut 0.5");
    refused("--function 'x*x + y*y - 1' --lipschitz .5 --cut 0", "--lipschitz 0.5");
    refused("--function '5*x' --lipschitz 4 --cut -99", "--lipschitz 4: the function changes by");
    refused("--function 'z' --lipschitz 4 --cut -9", "column 1: coordinate 3 of points in 2 dimensions");
    refused("--function '1/(x-x)' --lipschitz 4 --cut -9", "not finite at a vertex");
    refused("--function 'x' --lipschitz 4", "needs --function or --values-at, --lipschitz and --cut");
    refused("--function 'x' --values-at p.txt --lipschitz 4 --cut 0", "--function and --values-at");
    refused("--function 'x' --lipschitz 4 --cut 0 --fit", "--fit needs --memory");
    refused("--function 'x' --lipschitz 4 --cut 0 --fit --memory 1M --error .1", "--error");
    refused("--function 'x' --lipschitz 4 --cut 0 --fit --memory 1M --ratio 3", "--ratio");
    refused("--function 'x' --lipschitz 4 --cut 0 --fit --memory 1M --from 1 --to 2", "--from");
    refused("--function 'x' --lipschitz 4 --cut 0 --fit --memory 1M --method svr", "--fit");
    refused("--function 'x' --lipschitz 4 --cut 0 --fit --memory 1M --values certified", "--values thesis");
    refused("--function 'x' --lipschitz 4 --cut -9 --error .1 --values certified", "--values certified: error is for");
    CHECK(folder.run("persist p.txt --cut 4").says("go with --filter function"));
    CHECK(folder.run("persist p.txt --filter function --function 'x*x + y*y - 1' --lipschitz 3 --cut 0 --error 1e-30")
              .exit == 3);
    // Births below 0 have a distance, and no logarithm.
    CHECK(folder.run("distance d.pers d.pers").out == "0 0\n");
    CHECK(folder.run("distance --log d.pers d.pers").exit == 3);
}

TEST_CASE("provenance: a file without is looked at for its form, or made as the options say") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 30 -o p.csv").exit == 0);
    CHECK(folder.run("persist p.csv --quiet -o d.pers --mesh m.node --filter knn --k 3").exit == 0);
    folder.write("d.pers", bars_of(folder.read("d.pers")));
    for (const std::string source : {"", " --points p.csv", " --mesh m.node"}) {
        CAPTURE(source);
        const Result check = folder.run("check d.pers" + source);
        CHECK(check.exit == 7);
        CHECK(check.says("carries no certificate"));
        if (source.empty()) continue;
        const Result told = folder.run("check d.pers --filter knn --k 3" + source);
        CHECK(told.exit == 0);
        CHECK(told.out.find("reproduced") != std::string::npos);
        CHECK(folder.run("check d.pers --filter knn --k 4" + source).exit == 7);
        CHECK(folder.run("check d.pers --filter basic" + source).exit == 7);
    }
    // Any bars at all pass for a diagram by their form, which is no check.
    folder.write("forged.pers", "0 0 inf\n0 0 0.25\n1 0.5 2\n");
    for (const std::string source : {"", " --points p.csv", " --mesh m.node"})
        CHECK(folder.run("check forged.pers" + source).exit == 7);
}

TEST_CASE("provenance: options that contradict the file, and heads that cannot be") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 30 -o p.csv").exit == 0);
    CHECK(folder.run("persist p.csv --quiet -o d.pers --tau 3").exit == 0);
    const std::string text = folder.read("d.pers");
    const auto number = [&](const std::string& name) { return std::to_string(line_with(text, "# " + name)); };
    for (const std::string option : {"--tau 3", "--tau 3.0", "--filter complete", "--values certified", "--seed 1",
                                     "--max-degree 1", "--memory 1G"}) {
        CAPTURE(option);
        CHECK(folder.run("check d.pers --points p.csv " + option).exit == 0);
    }
    for (const std::string option : {"--tau 2.5", "--filter basic", "--values thesis", "--seed 2", "--max-degree 0",
                                     "--ratio 2", "--k 2", "--all", "--eps .5", "--method svr"}) {
        CAPTURE(option);
        const Result result = folder.run("check d.pers --points p.csv " + option);
        CHECK(result.exit == 2);
        CHECK(result.says("netmesh: " + option + " contradicts d.pers"));
    }
    CHECK(folder.run("check d.pers --points p.csv --seed 2").says("d.pers:" + number("seed") + ": \"# seed 1\""));
    CHECK(folder.run("check d.pers --points p.csv --all").says("made without --all"));

    const auto refused = [&](const std::string& content, const std::string& line, const std::string& reason) {
        CAPTURE(reason);
        folder.write("t.pers", content);
        for (const std::string source : {"", " --points p.csv"}) {
            const Result result = folder.run("check t.pers" + source);
            CHECK(result.exit == 3);
            CHECK_MESSAGE(result.says("t.pers:" + line + ": "), result.err);
            CHECK_MESSAGE(result.says(reason), result.err);
        }
        CHECK(folder.run("distance t.pers t.pers").exit == 0);  // which needs no head
    };
    refused(with_head(text, "seed", "# seed 1\n# sed 2"), std::to_string(line_with(text, "# seed") + 1),
            "not a line of a head");
    refused(with_head(text, "seed", "# seed 1\n# seed 1"), std::to_string(line_with(text, "# seed") + 1), "twice");
    refused(with_head(text, "seed", ""), "1", "lacks the line \"# seed\"");
    refused(with_head(text, "ratio", ""), "1", "lacks the line \"# ratio\"");
    refused(with_head(text, "certified-ratio", ""), "1", "lacks the line \"# certified-ratio\"");
    refused(with_head(text, "version", "# k 2"), number("version"), "contradicts the other lines");
    refused(with_head(text, "filter", "# filter basic"), number("ratio"), "contradicts the other lines");
    refused(with_head(text, "filter", "# filter frob"), number("filter"), "there are auto, complete");
    refused(with_head(text, "tau", "# tau 2"), number("tau"), "above 2");
    refused(with_head(text, "ratio", "# ratio 2\n# focus 1.5\n# from 1\n# to .5"),
            std::to_string(line_with(text, "# ratio") + 3), "not 0 < focus_from < focus_to");
    refused(with_head(text, "ratio", "# ratio 2\n# from 1"), std::to_string(line_with(text, "# ratio") + 1),
            "focus_ratio is not between 1 and ratio");
    refused(with_head(text, "ratio", "# ratio 2\n# focus auto"), std::to_string(line_with(text, "# ratio") + 1),
            "contradicts the other lines");
    refused(with_head(text, "duplicates", "# duplicates 30"), number("duplicates"), "fewer of them are duplicates");
    refused(with_head(text, "dim", "# dim 7"), number("dim"), "from 2 to 6");
    refused(with_head(text, "points", "# points many"), number("points"), "whole number");
    refused(with_head(text, "domain", "# domain 0 1"), number("domain"), "radius above 0");
    refused(with_head(text, "max-degree", "# max-degree 2"), number("max-degree"), "at most 1");
    refused(with_head(text, "input", "# input 12"), number("input"), "16 hexadecimal digits");
    refused(with_head(text, "certified-ratio", "# certified-ratio .5"), number("certified-ratio"), "at least 1");
    refused(with_head(text, "netmesh diagram", "# netmesh diagram 2: more"), "1", "another version of the format");
}

TEST_CASE("provenance: with its mesh a diagram has a second opinion, its cycles too") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 40 -o p.csv").exit == 0);
    for (const std::string filter : {"complete --bounds", "complete --values thesis --all", "basic", "knn --k 3",
                                     "kdistance --k 3", "tight", "alpha", "complete --method netmesh --finish"}) {
        CAPTURE(filter);
        CHECK(folder.run("persist p.csv --quiet -o d.pers --mesh m.node --representatives c.txt --filter " + filter)
                  .exit == 0);
        const Result check = folder.run("check d.pers --mesh m.node --points p.csv --representatives c.txt");
        CHECK(check.err == "");
        CHECK(check.exit == 0);
        CHECK((filter == "alpha" || check.out.find("are the pairs of a plain reduction of") != std::string::npos));
        CHECK(check.out.find("are born with their bars and die with them") != std::string::npos);
        CHECK((check.out.find("follows from them") == std::string::npos) == (filter == "alpha"));
    }
    for (const std::string filter : {"rips", "cech"}) {
        CAPTURE(filter);
        CHECK(folder.run("persist p.csv --quiet -o d.pers --representatives c.txt --filter " + filter).exit == 0);
        const Result check = folder.run("check d.pers --points p.csv --representatives c.txt");
        CHECK(check.exit == 0);
        CHECK(check.out.find("die with them") != std::string::npos);
        // The cycle of another bar is born, or dies, at another time.
        std::string cycles = folder.read("c.txt");
        const std::size_t last = cycles.rfind("\nbar 0 ") + 1;
        folder.write("c.txt", cycles.substr(0, last) + cycles.substr(cycles.find("\nbar 1 ") + 1));
        CHECK(folder.run("check d.pers --points p.csv --representatives c.txt").exit == 7);
        folder.write("c.txt", "bar 0 0\n");
        CHECK(folder.run("check d.pers --points p.csv --representatives c.txt").exit == 3);
    }
    CHECK(folder.run("persist p.csv --quiet -o d.pers --filter scales").exit == 0);
    CHECK(folder.run("check d.pers --mesh m.node").exit == 2);
}

TEST_CASE("provenance: bounds and cycles of scales are judged by the exact diagram, and made again") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 30 -o a.csv").exit == 0);
    // Twice, the second time small and at the first of the points.
    std::string all = folder.read("a.csv");
    std::istringstream lines(all);
    double x, y, x0 = 0, y0 = 0;
    for (int i = 0; lines >> x; i++) {
        if (lines.peek() == ',') lines.get();
        lines >> y;
        if (i == 0) x0 = x, y0 = y;
        std::ostringstream small;
        small.precision(17);
        small << x0 + (x - x0) / 512 << ' ' << y0 + (y - y0) / 512 << '\n';
        if (i > 0) all += small.str();
    }
    for (char& c : all) c = c == ',' ? ' ' : c;
    folder.write("p.txt", all);
    for (const std::string how : {"--eps .5", "--ratio 2", "--ratio 3 --all", "--eps .4 --values thesis"}) {
        CAPTURE(how);
        const Result made =
            folder.run("persist p.txt -o d.pers --bounds --representatives c.txt --check --filter scales " + how);
        REQUIRE(made.exit == 0);
        CHECK(made.err.find("closed cycle of points that is born with it within the ratio and dies with it so") !=
              std::string::npos);
        Result check = folder.run("check d.pers --points p.txt --representatives c.txt");
        CHECK(check.err == "");
        CHECK(check.exit == 0);
        CHECK(check.out.find("reproduced: the engine makes the same bars, bounds and ratios by scale") !=
              std::string::npos);
        CHECK(check.out.find("all bars are within the ratio of true ones, and the") != std::string::npos);
        CHECK(check.out.find("are born with their bars and die with them, within the ratio") != std::string::npos);
        // A cycle that is cut, one of another bar, none.
        const std::string cycles = folder.read("c.txt"), text = folder.read("d.pers");
        const std::size_t ring = cycles.find("\nbar 1 ") + 1, first = cycles.find('\n', ring) + 1;
        const auto refused = [&](const std::string& changed) {
            folder.write("c.txt", changed);
            const Result result = folder.run("check d.pers --points p.txt --representatives c.txt");
            CHECK(result.exit == 7);
            CHECK(result.err.find("check failed") != std::string::npos);
        };
        refused(cycles.substr(0, cycles.rfind("\nbar ") + 1));
        const std::size_t edge = cycles.find('\n', first);
        if (cycles[first] != 'b') refused(cycles.substr(0, first) + "0 1" + cycles.substr(edge));
        folder.write("c.txt", cycles);
        // Bounds and what is certified.
        std::string forged = text;
        const std::size_t exists = forged.find(" exists\n");
        REQUIRE(exists != std::string::npos);
        forged.erase(exists, 7);
        folder.write("d.pers", forged);
        check = folder.run("check d.pers --points p.txt");
        CHECK(check.exit == 7);
        CHECK(check.err.find("bounds differ") != std::string::npos);
        folder.write("d.pers", text);
    }
    // JSON and picture have them too.
    const Result json = folder.run("persist p.txt --filter scales --ratio 2 --bounds --json --svg d.svg");
    CHECK(json.exit == 0);
    CHECK(json.out.find("\"bounds\"") != std::string::npos);
    CHECK(json.out.find("\"scale_steps\"") != std::string::npos);
    const Result plain = folder.run("persist p.txt --filter scales --ratio 2 --quiet --svg e.svg -o e.pers");
    CHECK(plain.exit == 0);
    CHECK(folder.read("d.svg") != folder.read("e.svg"));
}
