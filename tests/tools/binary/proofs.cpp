// persist --proof: what it goes with, and what it writes. Whether proofs are verified is for tests/proofs.
#include "run.hpp"

#include <doctest/doctest.h>

TEST_CASE("a proof is the same bytes with any block, seed and order of options; the diagram stays what it is") {
    const Folder folder;
    REQUIRE(folder.run("sample torus -n 300 --noise 0.02 -o p.csv").exit == 0);
    REQUIRE(folder.run("persist p.csv -q --filter alpha -o without.pers").exit == 0);
    REQUIRE(folder.run("persist p.csv -q --filter alpha -o a.pers --proof a.proof").exit == 0);
    REQUIRE(folder.run("persist p.csv -q --proof b.proof --seed 7 --memory 64M -o b.pers").exit == 0);
    CHECK(folder.read("a.pers") == folder.read("without.pers"));
    CHECK(folder.read("a.proof") == folder.read("b.proof"));
    CHECK(folder.read("a.proof").compare(0, 16, "netmesh proof 1\n") == 0);
    REQUIRE(folder.run("persist p.csv p.csv -q --proof {}.proof -o {}.pers").exit == 2);  // one name for two
    folder.write("q.csv", folder.read("p.csv"));
    REQUIRE(folder.run("persist p.csv q.csv -q --proof {}.proof -o {}.pers").exit == 0);
    CHECK(folder.read("q.proof") == folder.read("a.proof"));
}

TEST_CASE("what a proof does not go with is refused by name, and leaves no file") {
    const Folder folder;
    folder.write("p.csv", "x,y,r\n0,0,1\n4,0,1\n0,3,1\n5,4,1\n");
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        const Result result = folder.run("persist p.csv --columns x,y -q --proof p.proof " + arguments);
        CAPTURE(arguments);
        CAPTURE(result.err);
        CHECK(result.exit == 2);
        CHECK(result.says(words));
        CHECK(!folder.has("p.proof"));
    };
    refused("--filter rips", "--proof is of filter alpha alone, not of rips");
    refused("--filter complete", "--proof is of filter alpha alone, not of complete");
    refused("--all", "--proof does not go with --all");
    refused("--least 1", "--proof does not go with --least");
    refused("--top 2", "--proof does not go with --top");
    refused("--box 9,9", "--proof does not go with --box: there are no such proofs yet");
    refused("--pieces 2", "--proof does not go with --pieces");
    refused("-o d.json", "a diagram with a proof is written to .pers");
    refused("-o p.csv", "p.csv: would be written over the input");
    refused("-o p.proof", "p.proof: two outputs would be written to this file");
    const Result flat = folder.run("persist p.csv --columns x,x -q --proof p.proof -o p.pers");
    CHECK(flat.exit != 0);
    CHECK(!folder.has("p.proof"));
}

TEST_CASE("a proof of balls is the same bytes with any block, seed and order of options") {
    const Folder folder;
    folder.write("p.csv", "x,y,r\n0,0,1\n4,0,1\n0,3,1\n5,4,1\n0.1,0,0.2\n4,0,2\n");
    REQUIRE(folder.run("persist p.csv -q --radii r -o without.pers").exit == 0);
    REQUIRE(folder.run("persist p.csv -q --radii r -o a.pers --proof a.proof").exit == 0);
    REQUIRE(folder.run("persist p.csv -q --proof b.proof --seed 7 --memory 64M --radii r -o b.pers").exit == 0);
    CHECK(folder.read("a.pers") == folder.read("without.pers"));
    CHECK(folder.read("a.proof") == folder.read("b.proof"));
    CHECK(folder.read("a.proof").compare(0, 16, "netmesh proof 2\n") == 0);
    REQUIRE(folder.run("persist p.csv -q --weights r --filter alpha -o c.pers --proof c.proof").exit == 0);
    CHECK(folder.read("c.proof") != folder.read("a.proof"));
}
