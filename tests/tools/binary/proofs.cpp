// persist --proof and homology --proof: what it goes with, and what it writes. Whether proofs are verified is for
// tests/proofs.
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
    refused("--filter complete", "--proof is of filters alpha, rips and cech, not of complete");
    refused("--filter rips --threshold 1 --top 2", "--proof does not go with --top");
    refused("--filter rips -o d.csv", "a diagram with a proof is written to .pers");
    refused("--filter rips --threshold 1 -o d.csv", "a diagram with a proof is written to .pers");
    refused("--filter rips --threshold 1 -o p.csv", "p.csv: would be written over the input");
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

TEST_CASE(
    "a proof of a Rips diagram is the same bytes with any block and order of options; the diagram stays what it is") {
    const Folder folder;
    REQUIRE(folder.run("sample torus -n 250 --noise 0.02 -o p.csv").exit == 0);
    for (const std::string words : {"--filter rips", "--filter rips --threshold 0.9 --max-degree 2"}) {
        CAPTURE(words);
        REQUIRE(folder.run("persist p.csv -q -o without.pers " + words).exit == 0);
        REQUIRE(folder.run("persist p.csv -q -o a.pers --proof a.proof " + words).exit == 0);
        REQUIRE(folder.run("persist --proof b.proof p.csv -q --memory 64M -o b.pers " + words).exit == 0);
        CHECK(folder.read("a.pers") == folder.read("without.pers"));
        CHECK(folder.read("a.proof") == folder.read("b.proof"));
        CHECK(folder.read("a.proof").compare(0, 16, "netmesh proof 3\n") == 0);
    }
    folder.write("q.csv", folder.read("p.csv"));
    REQUIRE(folder.run("persist p.csv q.csv -q --filter rips --proof {}.proof -o {}.pers").exit == 0);
    CHECK(folder.read("q.proof") == folder.read("p.proof"));
    folder.write("d.txt", "1\n2 1.5\n");
    REQUIRE(folder.run("persist d.txt --distances -q -o d.pers --proof d.proof").exit == 0);
    folder.write("full.txt", "0 1 2\n1 0 1.5\n2 1.5 0\n");
    REQUIRE(folder.run("persist full.txt --distances -q -o full.pers --proof full.proof").exit == 0);
    CHECK(folder.read("full.proof") == folder.read("d.proof"));
    // Simplices that 64 bits do not number: 16 bits for an edge, 9 for each vertex besides.
    const Result result = folder.run("persist p.csv --filter rips --max-degree 6 --threshold 0.01 -q --proof c.proof");
    CHECK(result.exit == 0);
    CHECK(folder.run("sample ball -n 3000 -o many.csv").exit == 0);
    const Result many = folder.run("persist many.csv --filter rips --max-degree 6 --threshold 0.01 -q --proof m.proof");
    CHECK(many.exit == 2);
    CHECK(many.says("cannot be numbered in 64 bits"));
    CHECK(!folder.has("m.proof"));
}

TEST_CASE("a proof of a listed complex") {
    const Folder folder;
    folder.write("c.txt", "7 0\n8 0.5\n9 0\n7 8 1\n8 9 1\n7 9 2\n");
    REQUIRE(folder.run("homology c.txt -q -o without.pers").exit == 0);
    REQUIRE(folder.run("homology c.txt -q -o c.pers --proof c.proof").exit == 0);
    CHECK(folder.read("c.pers") == folder.read("without.pers"));
    CHECK(folder.read("c.proof").compare(0, 16, "netmesh proof 3\n") == 0);
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        const Result result = folder.run("homology c.txt -q --proof p.proof " + arguments);
        CAPTURE(arguments);
        CHECK(result.exit == 2);
        CHECK(result.says(words));
        CHECK(!folder.has("p.proof"));
    };
    refused("--all", "--proof does not go with --all");
    refused("--top 1", "--proof does not go with --top");
    refused("-o c.json", "a diagram with a proof is written to .pers");
    refused("-o c.txt", "c.txt: would be written over the input");
}
