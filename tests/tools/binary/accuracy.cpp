// The filters that promise an accuracy, from the command line: tight and scales, by --eps and by --ratio.
#include "run.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

TEST_CASE("persist: tight, and scale by scale") {
    const Folder folder;
    CHECK(folder.run("sample annulus -n 25 -o p.csv").exit == 0);
    Result result =
        folder.run("persist p.csv --filter tight --eps .5 -o d.pers --json --check --svg d.svg --mesh m.node");
    CHECK(result.err == "");
    CHECK(result.exit == 0);
    CHECK(number_in(result.out, "certified_ratio") > 1);
    CHECK(number_in(result.out, "certified_ratio") <= 1.5);
    CHECK(folder.run("check d.pers --points p.csv --filter tight --eps .5").exit == 0);
    CHECK(folder.run("check d.pers --points p.csv --filter tight").exit == 0);  // 1/2 is the default
    CHECK(folder.run("check d.pers --points p.csv --filter tight --eps .4").exit == 2);
    result = folder.run("check d.pers --mesh m.node");
    CHECK(result.err == "");
    CHECK(result.exit == 0);
    CHECK(result.out.find("for filter tight, certified values") != std::string::npos);

    // --check knows what tight asks for; it held the mesh to the bounds of one that is not over-refined.
    folder.write("two.txt", "0 0\n1 0\n");
    CHECK(folder.run("persist two.txt --filter tight --eps .1 --check --quiet -o t.pers").err == "");

    CHECK(folder.run("sample zoom -n 30 --dim 2 -o q.csv").exit == 0);
    result = folder.run("persist q.csv --filter scales --theta .1 --eps .5 -o s.pers --json --check");
    CHECK(result.err == "");
    CHECK(result.exit == 0);
    CHECK(number_in(result.out, "certified_ratio") <= 1.3 * 1.5);
    CHECK(number_in(result.out, "separation_needed") == 2);
    CHECK(folder.run("check s.pers --points q.csv --filter scales --theta .1").exit == 0);
    CHECK(folder.run("check s.pers --points p.csv --filter scales --theta .1").exit == 7);
    for (const char* line :
         {"--filter tight --eps 0", "--filter tight --eps .6", "--eps .5", "--theta .1", "--filter scales --theta .2",
          "--filter scales --mesh m.node", "--filter tight --eps .5 --ratio 2", "--filter scales --eps .5 --ratio 2",
          "--filter scales --ratio 1.88", "--filter scales --ratio 3 --focus 2 --from .1 --to .2",
          "--filter tight --focus 2 --from .1 --to .2", "--filter tight --ratio 2 --values thesis",
          "--filter tight --ratio 2 --method svr"}) {
        CAPTURE(line);
        CHECK(folder.run(std::string("persist p.csv ") + line).exit == 2);
    }
}

TEST_CASE("persist: tight, and scale by scale, by a ratio from four dimensions on") {
    const Folder folder;
    for (const int dim : {4, 5}) {
        CAPTURE(dim);
        CHECK(folder.run("sample clusters -n 30 --dim " + std::to_string(dim) + " -o p.csv").exit == 0);
        if (folder.run("delaunay p.csv -o f.node").exit == 3) continue;  // the tool has been built without it
        for (const std::string filter : {"tight", "scales"}) {
            CAPTURE(filter);
            const Result result = folder.run("persist p.csv --filter " + filter + " -o d.pers --json --check");
            CHECK(result.err == "");
            CHECK(result.exit == 0);
            const double root = std::sqrt(2 + (dim == 4 ? 3.08 : 4)), join = filter == "scales" ? 4.0 / 3 : 1;
            CHECK(number_in(result.out, "certified_ratio") <= root * join * (filter == "tight" ? 1.1 : 1));
            CHECK(folder.read("d.pers").find("\n# ratio ") != std::string::npos);
            CHECK(folder.read("d.pers").find("\n# eps ") == std::string::npos);
            CHECK(folder.run("check d.pers --points p.csv").exit == 0);
        }
    }
    const Result sized = folder.run("size --dim 4 --points 200 --filter scales");
    CHECK(sized.exit == 0);
    CHECK(std::stod(sized.out) < 1e8);
}
