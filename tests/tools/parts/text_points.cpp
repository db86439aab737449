#include <doctest/doctest.h>

#include <cmath>

#include "tools/io/points.hpp"

using namespace netmesh::tool;

namespace {

PointCloud good(const std::string& text) {
    PointCloud cloud;
    cloud.name = "p.txt";
    const Outcome outcome = parse_text_points(text, &cloud);
    CAPTURE(text);
    CHECK(outcome.message == "");
    CHECK(outcome.good());
    return cloud;
}

std::string fault(const std::string& text) {
    PointCloud cloud;
    cloud.name = "p.txt";
    const Outcome outcome = parse_text_points(text, &cloud);
    CAPTURE(text);
    CHECK(outcome.exit == Exit::data);
    return outcome.message;
}

using Numbers = std::vector<double>;
using Lines = std::vector<std::uint64_t>;

}  // namespace

TEST_CASE("every separator, mixed and surrounded by blanks") {
    for (const char* text : {"1 2 3\n4 5 6\n", "1\t2\t3\n4\t5\t6", "1,2,3\n4,5,6\n", "1;2;3\n4;5;6\n",
                             "  1 ,2\t; 3  \n4 5,6\n", "1,2 3\r\n4 ;5, 6\r\n"}) {
        const PointCloud cloud = good(text);
        CHECK(cloud.dim == 3);
        CHECK(cloud.coordinates == Numbers{1, 2, 3, 4, 5, 6});
        CHECK(cloud.lines == Lines{1, 2});
    }
}

TEST_CASE("byte-order mark, comments, blank lines and one header line") {
    const PointCloud cloud = good("\xEF\xBB\xBF# made by hand\n\n x, \"y (mm)\"\n# a\n1,2 # first\n\n3,4\n");
    CHECK(cloud.dim == 2);
    CHECK(cloud.coordinates == Numbers{1, 2, 3, 4});
    CHECK(cloud.lines == Lines{5, 7});
    CHECK(cloud.where(1) == "p.txt:7");
    CHECK(cloud.place(0) == "line 5");
}

TEST_CASE("numbers of every shape") {
    CHECK(good("+1 -2e3 .5 5. 1E-2 0").coordinates == Numbers{1, -2000, .5, 5, .01, 0});
    CHECK(good("0.1 1e-400").coordinates == Numbers{0.1, 0});
    CHECK(good("4.9e-324 1.7976931348623157e308").coordinates == Numbers{4.9e-324, 1.7976931348623157e308});
    const PointCloud zero = good("-0.0 -0");
    CHECK(!std::signbit(zero.coordinates[0]));
    CHECK(!std::signbit(zero.coordinates[1]));
}

TEST_CASE("two to six columns") {
    CHECK(good("1 2").dim == 2);
    CHECK(good("1 2 3 4 5 6").dim == 6);
    CHECK(fault("1\n2\n") ==
          "p.txt:1: 1 column; points have 2 to 6 coordinates; --delimiter says what stands between them; of a "
          "series delays make points, as the guide says");
    CHECK(fault("\n\n1 2 3 4 5 6 7\n") == "p.txt:3: 7 columns; points have 2 to 6 coordinates; --columns chooses some");
}

TEST_CASE("ragged rows") {
    CHECK(fault("1 2\n3 4\n5\n") == "p.txt:3: 1 column where line 1 has 2");
    CHECK(fault("# a\n1 2\n\n3 4 5\n") == "p.txt:4: 3 columns where line 2 has 2");
}

TEST_CASE("nothing between two commas, before the first or behind the last") {
    CHECK(fault("1 2\n1,,2\n") == "p.txt:2: nothing before a ','");
    CHECK(fault("1,2\n1; ;2\n") == "p.txt:2: nothing before a ';'");
    CHECK(fault(",1,2\n") == "p.txt:1: nothing before a ','");
    CHECK(fault("1,2,\n") == "p.txt:1: nothing after the last ','");
}

TEST_CASE("what is not a number, with its physical line") {
    CHECK(fault("1 2\r\n\r\n# c\r\n3 x\r\n") == "p.txt:4: \"x\" is not a number");
    CHECK(fault("1 2\n0x10 3\n") == "p.txt:2: \"0x10\" is not a number");
    CHECK(fault("1 2\n1d5 3\n") == "p.txt:2: \"1d5\" is not a number; write e in place of Fortran's d");
    CHECK(fault("1 2\n1e 3\n") == "p.txt:2: \"1e\" is not a number");
    CHECK(fault("1 2\n+-1 3\n") == "p.txt:2: \"+-1\" is not a number");
    CHECK(fault("1 2\n3 1.2.3\n") == "p.txt:2: \"1.2.3\" is not a number");
    CHECK(fault(std::string("1 2\n3 \0x\n", 9)) == "p.txt:2: \"?x\" is not a number");
}

TEST_CASE("NaN and infinities, spelled or by overflow, are data even where a header could stand") {
    CHECK(fault("nan 1\n2 3\n") ==
          "p.txt:1: \"nan\" is not a finite double; a row with a missing value has to be left out or filled in: "
          "--drop-missing leaves such rows out, 1 of 2");
    const std::string remedy = "; such a row has to be taken out of the file: no option leaves it out";
    CHECK(fault("1 2\n3 -INF\n") == "p.txt:2: \"-INF\" is not a finite double" + remedy);
    CHECK(fault("inf inf\n1 2\n") == "p.txt:1: \"inf\" is not a finite double" + remedy);
    CHECK(fault("Infinity x\n1 2\n") == "p.txt:1: \"Infinity\" is not a finite double" + remedy);
    CHECK(fault("1 1e400\n") == "p.txt:1: \"1e400\" is not a finite double" + remedy);
    CHECK(fault("1 2\n-1e999 2\n") == "p.txt:2: \"-1e999\" is not a finite double" + remedy);
}

TEST_CASE("a header is words only, and only the first content line can be one") {
    CHECK(good("x y\n1 2\n").lines == Lines{2});
    CHECK(good("info,nanosecond\n1,2\n").lines == Lines{2});
    CHECK(fault("x y\nu v\n1 2\n") == "p.txt:2: \"u\" is not a number; --skip 2 leaves the lines down to this one out");
    CHECK(fault("1 2\nx y\n") == "p.txt:2: \"x\" is not a number");
    CHECK(fault("x 1\n1 2\n") == "p.txt:1: \"x\" is not a number; --skip 1 leaves the lines down to this one out");
    CHECK(fault("1.2.3 4.5.6\n1 2\n") ==
          "p.txt:1: \"1.2.3\" is not a number; --skip 1 leaves the lines down to this one out");
}

TEST_CASE("input without a point") {
    CHECK(fault("") == "p.txt:1: the input ends without a point");
    CHECK(fault("\n\n# nothing\n") == "p.txt:3: the input ends without a point");
    CHECK(fault("x,y\n") == "p.txt:1: the input ends without a point");
}

TEST_CASE("files that are not there or not files") {
    PointCloud cloud;
    Outcome outcome = read_points("/nowhere/at/all.txt", &cloud);
    CHECK(outcome.exit == Exit::data);
    CHECK(outcome.message == "/nowhere/at/all.txt: no such file or folder");
    outcome = read_points("/", &cloud);
    CHECK(outcome.exit == Exit::data);
    CHECK(outcome.message == "/: is a directory");
}

TEST_CASE("endings") {
    CHECK(ending_of("a/b.c/d.NPY") == ".npy");
    CHECK(ending_of("a.b/c") == "");
    CHECK(ending_of("x") == "");
}

TEST_CASE("rows that lack a value are counted, and left out where that is asked for") {
    const std::string text = "name,x,y\na,1,2\nb,NA,3\nc,4,\n,5,6\nd,nan,-\ne,7,8\n";
    TableOptions options;
    options.columns = {"x", "y"};
    PointCloud cloud;
    cloud.name = "p.txt";
    CHECK(parse_text_points(text, options, &cloud).message ==
          "p.txt:3: \"NA\" is not a number; a row with a missing value has to be left out or filled in: --drop-missing "
          "leaves such rows out, 3 of 6");
    options.drop_missing = true;
    REQUIRE(parse_text_points(text, options, &cloud).message == "");
    CHECK(cloud.coordinates == Numbers{1, 2, 5, 6, 7, 8});
    CHECK(cloud.lines == Lines{2, 5, 7});
    CHECK(cloud.note == "skipped header \"name,x,y\"; left out 3 of 6 rows, which lack a value: lines 3, 4, 6");
    CHECK(parse_text_points("1,2\n3,\n4,x\n", options, &cloud).exit == Exit::data);  // a word is none
    options.columns.clear();
    CHECK(parse_text_points("1,2\n3\n4,5\n", options, &cloud).exit == Exit::data);  // nor is half a row
    CHECK(parse_text_points("1,NA\n3,?\n", options, &cloud).message == "p.txt:1: every row lacks a value");
    CHECK(fault("1,2\n3,\n4,5\n") ==
          "p.txt:2: nothing after the last ','; a row with a missing value has to be left out or filled in: "
          "--drop-missing leaves such rows out, 1 of 3");
    CHECK(good("1 2\n3 4\n").note == "");
    REQUIRE(parse_text_points("1 2\n3 4\n", options, &cloud).good());
    CHECK(cloud.note == "no row lacks a value");
}

TEST_CASE("a matrix of distances in place of points is named") {
    std::string square, named = "name", triangle;
    for (int i = 0; i < 8; i++) {
        named += ",p" + std::to_string(i);
        for (int j = 0; j < 8; j++) square += (j > 0 ? "," : "") + std::to_string(i < j ? j - i : i - j);
        square += "\n";
        for (int j = 0; j <= i; j++) triangle += (j > 0 ? " " : "") + std::to_string(1 + j);
        triangle += "\n";
    }
    CHECK(fault(square).find("8 columns; points have 2 to 6 coordinates; a matrix of distances") != std::string::npos);
    std::string rows;
    for (std::size_t i = 0, at = 0; i < 8; i++) {
        const std::size_t end = square.find('\n', at) + 1;
        rows += "p" + std::to_string(i) + "," + square.substr(at, end - at);
        at = end;
    }
    CHECK(fault(named + "\n" + rows).find("persist --distances") != std::string::npos);
    CHECK(fault(triangle).find("a triangle of distances is read by persist --distances") != std::string::npos);
    CHECK(good("0 1 2\n1 0 3\n2 3 0\n").note.find("persist --distances takes it for distances") != std::string::npos);
    CHECK(fault("a,1,b,2,3,4,c,5\nd,1,e,2,3,4,f,5\n").find("--columns 2,4-6,8 leaves") != std::string::npos);
}
