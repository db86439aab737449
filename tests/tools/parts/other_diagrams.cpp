// Diagrams in the forms of other programs.
#include "tools/io/other_diagrams.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

using namespace netmesh::tool;

namespace {

const std::vector<Bar> three = {{0, 0, 0.5}, {0, 0, HUGE_VAL}, {1, 0.75, 1.5}};

std::vector<Bar> good(const std::string& content) {
    std::vector<Bar> bars;
    CAPTURE(content);
    CHECK(parse_any_diagram(content, "d", &bars).message == "");
    return bars;
}

std::string fault(const std::string& content) {
    std::vector<Bar> bars;
    const Outcome outcome = parse_any_diagram(content, "d", &bars);
    CAPTURE(content);
    CHECK(outcome.exit == Exit::data);
    return outcome.message;
}

template <class Number> std::string bytes(Number number) {
    std::string text(sizeof number, 0);
    std::memcpy(&text[0], &number, sizeof number);
    return text;
}

}  // namespace

TEST_CASE("diagrams as text, as anybody writes them") {
    CHECK(good("0 0 0.5\n0 0 inf\n1 0.75 1.5\n") == three);
    CHECK(good("# of GUDHI\n0 0 0.5\n0 0 Inf\n1 .75 1.5\n") == three);
    CHECK(good("degree,birth,death\n0,0,0.5\n0,0,\n1,0.75,1.5\n") == three);
    CHECK(good("dimension,Birth,Death\n0, 0, .5\n0, 0, Infinity\n1, .75, 1.5\n") == three);
    CHECK(good("degree,birth,death,birth_low,birth_high,death_low,death_high,real\n0,0,0.5,0,0,.4,.6,1\n"
               "0,0,inf,0,0,inf,inf,1\n1,0.75,1.5,.7,.8,1.4,1.6,0\n") == three);
    for (const char* const nothing : {"", "\n\n", "# bars of a run\n"})
        CHECK(fault(nothing) == "d: no diagram: it has no line `degree birth death`, no head and no header");
    CHECK(good("degree,birth,death\n").empty());
    CHECK(good("# a choice of 0 of 4 bars, --least 9\n").empty());
    CHECK(fault("0 1\n") == "d:1: 2 fields, which say no degree; a line is: degree birth death");
    CHECK(fault("0 0 1 2\n") == "d:1: 4 fields; a line is: degree birth death");
    CHECK(fault("birth,death\n0,1\n") ==
          "d:1: the header names no column degree; it has to name degree, birth and death");
    CHECK(fault("dimension,birth,persistence\n0,1,0\n").find("no column death") != std::string::npos);
    CHECK(fault("0 0 1\n0.5 0 1\n") == "d:2: 0.5 is not a degree");
    CHECK(fault("0 1 0.5\n") == "d:1: 0.5 is not a death: inf, or finite and not before the birth");
    CHECK(fault("0 inf inf\n") == "d:1: \"inf\" is not a number");
    CHECK(fault("0 x 1\n") == "d:1: \"x\" is not a number");
}

TEST_CASE("diagrams as tables, in their dialects and in the order that a header names") {
    for (const char* const text :
         {"degree;birth;death\n0;0;0,5\n0;0;inf\n1;0,75;1,5\n", "0;0;0.5\n0;0;\n1;0.75;1.5\n",
          "0|0|0.5\n0|0|inf\n1|0.75|1.5\n",
          "\xEF\xBB\xBF"
          "dim,birth,death\r\n0,0,0.5\r\n0,0,inf\r\n1,.75,1.5\r\n",
          ",dim,birth,death\n0,0,0,0.5\n1,0,0,inf\n2,1,.75,1.5\n", "birth,death,dim\n0,0.5,0\n0,inf,0\n.75,1.5,1\n",
          "death\tbirth\tq\n0.5\t0\t0\ninf\t0\t0\n1.5\t.75\t1\n", "degree,death,birth\n0,.5,0\n0,,0\n1,1.5,.75\n",
          "\"dimension\",\"Birth\",\"Death\"\n\"0\",0,0.5\n\"0\",0,Inf\n\"1\",.75,1.5\n",
          "\"\",\"dimension\",\"Birth\",\"Death\"\n\"1\",0,0,0.5\n\"2\",0,0,Inf\n\"3\",1,.75,1.5\n",
          "\"dimension\" \"Birth\" \"Death\"\n\"1\" 0 0 0.5\n\"2\" 0 0 Inf\n\"3\" 1 .75 1.5\n",
          "dimension birth death\n0 0 0.5\n0 0 inf\n1 .75 1.5\n",
          "2  0 0 0.5\n2 0 0 inf\n2 1 .75 1.5\n",  // the field in front, as GUDHI's programs write it
          "11 0 0 0.5\n11 0 0 inf\n11 1 .75 1.5\n", "degree,birth,death,note\n0,0,0.5,a\n0,0,inf,b\n1,.75,1.5,c\n"}) {
        CHECK(good(text) == three);
    }
    CHECK(fault("2 0 0 1\n3 0 0 1\n").find("4 fields") != std::string::npos);
    CHECK(fault("4 0 0 1\n4 0 0 1\n").find("4 fields") != std::string::npos);
    CHECK(fault("degree;birth;death\n0;0;0,5\n1;0.5;2\n").find("d:2: points and commas are both decimal") == 0);
}

TEST_CASE("diagrams as lists in lists, as Python prints and JSON holds them") {
    for (const char* const text :
         {"[[0, 0, 0.5], [0, 0, Infinity], [1, 0.75, 1.5]]", "[(0, (0.0, 0.5)), (0, (0.0, inf)), (1, (0.75, 1.5))]",
          "(0, (0.0, 0.5))\n(0, (0.0, inf))\n(1, (0.75, 1.5))\n", "[[0,[0,0.5]],[0,[0,null]],[1,[0.75,1.5]]]",
          "[[[0, 0.5], [0, Infinity]], [[0.75, 1.5]]]", "[[[0,0.5],\n [0,null]],\n [[0.75,1.5]]]\n"})
        CHECK(good(text) == three);
    CHECK(good("[[], [[0.75, 1.5]]]") == std::vector<Bar>{{1, 0.75, 1.5}});
    CHECK(good("[]").empty());
    CHECK(fault("[[0, 1], [1, 2]]").find("d: bar 1: is not [degree, birth, death]") == 0);
    CHECK(fault("[[0, 0, 1], [0, 0").find("does not end") != std::string::npos);
    CHECK(fault("[[0, 0, 1]]]").find("nothing opens") != std::string::npos);
    CHECK(fault("[[0, 2, 1]]").find("1 is not a death") != std::string::npos);
    CHECK(fault("[{\"birth\": 0}]").find("d: bar 1") == 0);
}

TEST_CASE("diagrams as ripser prints them") {
    const std::string head =
        "value range: [1,3]\ndistance matrix with 4 points, using threshold at enclosing radius 3\n";
    CHECK(good(head + "persistence intervals in dim 0:\n [0,0.5)\n [0, )\npersistence intervals in dim 1:\n"
                      " [0.75,1.5)\n") == three);
    CHECK(good(head + "persistence intervals in dim 0:\n [0,0.5):  {[0] (0), [1] (0)}\n [0, ):  {[0] (0)}\n"
                      "persistence intervals in dim 1:\n [0.75,1.5):  {[0,1] (1)}\n") == three);
    CHECK(fault("persistence intervals in dim 0:\n [0,1\n") == "d:2: \"[0,1\" is not [birth,death)");
    CHECK(fault("persistence intervals in dim x:\n [0,1)\n").find("says no degree") != std::string::npos);
}

TEST_CASE("diagrams as JSON") {
    CHECK(good("{\"schema\": 1, \"bars\": [[0, 0, 0.5], [0, 0, null], [1, 0.75, 1.5]], \"more\": [1]}") == three);
    CHECK(good("{\"bars\":[]}").empty());
    CHECK(fault("{\"pairs\": []}").find("without an entry \"bars\"") != std::string::npos);
    CHECK(fault("{\"bars\": [[0, 1]]}") == "d: bar 1: is not [degree, birth, death]");
    CHECK(fault("{\"bars\": [[0, 0, 1], [0, 0") == "d: the list \"bars\" does not end");
    CHECK(fault("{\"bars\": [[0, 0, 1]") == "d: the list \"bars\" does not end");
}

TEST_CASE("diagrams of DIPHA") {
    const std::string mark = bytes(std::int64_t{8067171840});
    const std::string bars = bytes(std::int64_t{0}) + bytes(0.0) + bytes(0.5) + bytes(std::int64_t{-1}) + bytes(0.0) +
                             bytes(9.0) + bytes(std::int64_t{1}) + bytes(0.75) + bytes(1.5);
    CHECK(good(mark + bytes(std::int64_t{2}) + bytes(std::int64_t{3}) + bars) == three);
    CHECK(fault(mark + bytes(std::int64_t{1}) + bytes(std::int64_t{3}) + bars).find("no diagram") != std::string::npos);
    CHECK(fault(mark + bytes(std::int64_t{2}) + bytes(std::int64_t{4}) + bars).find("says that it has 4 bars") !=
          std::string::npos);
    CHECK(fault(mark).find("no diagram") != std::string::npos);
}
