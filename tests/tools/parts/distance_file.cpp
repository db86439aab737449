#include "tools/io/distance_file.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace netmesh::tool;

namespace {

DistanceFile good(const std::string& text, bool sparse = false) {
    DistanceFile file;
    file.place.name = "d.csv";
    CAPTURE(text);
    CHECK(parse_distances(text, sparse, &file).message == "");
    return file;
}

std::string fault(const std::string& text, bool sparse = false) {
    DistanceFile file;
    file.place.name = "d.csv";
    const Outcome outcome = parse_distances(text, sparse, &file);
    CAPTURE(text);
    CHECK(outcome.exit == Exit::data);
    return outcome.message;
}

using Numbers = std::vector<double>;

}  // namespace

TEST_CASE("distances as a matrix") {
    const DistanceFile file = good("a,b,c\n0,3,5\n3,0,4\n# so far\n5,4,0\n");
    CHECK(file.layout == NETMESH_DISTANCES_FULL);
    CHECK(file.points == 3);
    CHECK(file.numbers == Numbers{0, 3, 5, 3, 0, 4, 5, 4, 0});
    CHECK(file.where(2, 1) == "d.csv:5, field 2");
    CHECK(good("0\n").points == 1);
}

TEST_CASE("distances as a lower triangle, with and without its diagonal") {
    for (const char* const text : {"3\n5 4\n", "\n3\n5,4\n", "0\n3,0\n5,4,0\n"}) {
        const DistanceFile file = good(text);
        CHECK(file.layout == NETMESH_DISTANCES_LOWER);
        CHECK(file.points == 3);
        CHECK(file.numbers == Numbers{3, 5, 4});
    }
    CHECK(good("3\n").points == 2);
    CHECK(good("3\n5 0\n").points == 3);  // two points in one place
    CHECK(good("3\n5 4\n").where(2, 1) == "d.csv:2, field 2");
    CHECK(good("0\n3 0\n5 4 0\n").where(2, 1) == "d.csv:3, field 2");
}

TEST_CASE("names in front of rows are left out behind a header of them") {
    for (const char* const text : {",a,b c,d\na,0,3,5\nb c,3,0,4\nd,5,4,0\n", "a b d\na 0 3 5\nb 3 0 4\nd 5 4 0\n"}) {
        const DistanceFile file = good(text);
        CHECK(file.numbers == Numbers{0, 3, 5, 3, 0, 4, 5, 4, 0});
        CHECK(file.note.find("; left out the names that rows begin with") != std::string::npos);
    }
    // Of pandas and of R.
    for (const char* const text :
         {",0,1,2\n0,0.0,3.0,5.0\n1,3.0,0.0,4.0\n2,5.0,4.0,0.0\n", "\ta\tb\tc\n7\t0\t3\t5\n8\t3\t0\t4\n9\t5\t4\t0\n",
          "\"\",\"a\",\"b, c\",\"1\"\n\"a\",0,3,5\n\"b, c\",3,0,4\n\"1\",5,4,0\n",
          "\"\" \"a\" \"b\" \"c\"\n\"a\" 0 3 5\n\"b\" 3 0 4\n\"c\" 5 4 0\n", ",a,1,2\na,0,3,5\n1,3,0,4\n2,5,4,0\n"}) {
        const DistanceFile file = good(text);
        CHECK(file.numbers == Numbers{0, 3, 5, 3, 0, 4, 5, 4, 0});
        CHECK(file.note.find("; left out the names that rows begin with") != std::string::npos);
    }
    CHECK(good(",i,j,d\n0,0,1,2.5\n1,1,2,1.5\n", true).entries.size() == 2);
    CHECK(fault(",0,1\n0,0,3\n1\n") == "d.csv:3: a row that has a name and no distance");
    CHECK(fault(",0,1\n0,0,3\n1 3,0\n").find("d.csv:3: commas part some") == 0);
    CHECK(fault("a,0,3\nb,3,0\n").find("d.csv:1: ") == 0);
    CHECK(fault(",a,b\na,0,x\nb,3,0\n").find("d.csv:2: ") == 0);
}

TEST_CASE("a header has as many names as there are points") {
    const std::string remedy =
        "; take out the header and the names that rows begin with, or put # in front of this line if it is no header";
    CHECK(fault(",a,b,c\n1\n2,5\n3,6,7\n") == "d.csv:1: the header names 3 points, the rows are of 4" + remedy);
    CHECK(fault("my distances\n0 1 2\n1 0 3\n2 3 0\n") ==
          "d.csv:1: the header names 2 points, the rows are of 3" + remedy);
    CHECK(fault("a b c\n0 1\n1 0\n") == "d.csv:1: the header names 3 points, the rows are of 2" + remedy);
    CHECK(good(",a,b,c,d\n1\n2,5\n3,6,7\n").points == 4);
    CHECK(good("a,b,c\n3\n5,4\n").numbers == Numbers{3, 5, 4});
    CHECK(good("name,a,b\na,0,1\nb,1,0\n").points == 2);             // the column of names has one, too
    CHECK(good("  a b\nb 3\nc 5 4\n").numbers == Numbers{3, 5, 4});  // R's print of a dist
    CHECK(fault(",a,b\na,1\nb,0.5,1\n").find("names 2 points, the rows are of 3") != std::string::npos);
    CHECK(good("i j d\n0 1 2\n1 2 3\n2 3 4\n3 4 5\n", true).points == 5);
}

TEST_CASE("what was understood of distances is said") {
    CHECK(good("a,b\n0,1\n1,0\n").note == "skipped header \"a,b\"");
    CHECK(good("0 1\n1 0\n").note == "");
    CHECK(good("3\n5 4\n").note == "");
    CHECK(good("0\n3 0\n5 4 0\n").note == "read as a lower triangle with its diagonal");
    // Zeros on one side: numpy's tril and triu.
    const DistanceFile lower = good("0 0 0\n3 0 0\n5 4 0\n"), upper = good("0 3 5\n0 0 4\n0 0 0\n");
    CHECK(lower.note == "read as a lower triangle: all above its diagonal is 0");
    CHECK(upper.note == "read as an upper triangle: all below its diagonal is 0");
    for (const DistanceFile* const file : {&lower, &upper}) {
        CHECK(file->layout == NETMESH_DISTANCES_LOWER);
        CHECK(file->points == 3);
        CHECK(file->numbers == Numbers{3, 5, 4});
    }
    CHECK(good("0 0\n0 0\n").layout == NETMESH_DISTANCES_FULL);
    CHECK(fault("0\n0 0\n0 0 0\n") ==
          "d.csv:1: a lower triangle of zeros may have its diagonal or not; write the whole matrix");
}

TEST_CASE("triangles the other way round, and what pdist gives, as text") {
    for (const char* const text : {"3 5\n4\n", "0 3 5\n0 4\n0\n", "3 5 4\n", "3\n5\n4\n"}) {
        const DistanceFile file = good(text);
        CHECK(file.layout == NETMESH_DISTANCES_LOWER);
        CHECK(file.points == 3);
        CHECK(file.numbers == Numbers{3, 5, 4});
        CHECK(file.note.find("upper triangle") != std::string::npos);
    }
    CHECK(good("1 2 3 12 13 23\n").numbers == Numbers{1, 2, 12, 3, 13, 23});
    CHECK(good("1 2 3\n12 13\n23\n").numbers == Numbers{1, 2, 12, 3, 13, 23});
    CHECK(good("0 1 2 3\n0 12 13\n0 23\n0\n").numbers == Numbers{1, 2, 12, 3, 13, 23});
    CHECK(fault("0 0\n0\n").find("an upper triangle of zeros") != std::string::npos);
    CHECK(fault("1 2 3 4\n").find("one axis of distances of n points has n (n - 1) / 2") != std::string::npos);
    CHECK(good("1 2 1.5\n2 3 1\n", true).note == "point 0 is in no entry, and stays alone; points are numbered from 0");
}

TEST_CASE("rounding noise of a matrix is taken off, and no more") {
    const DistanceFile file = good("0 1.5000000000000002 2\n1.5 2.2e-16 -1e-17\n2 0 0\n");
    CHECK(file.numbers == Numbers{0, 1.5, 2, 1.5, 0, 0, 2, 0, 0});
    CHECK(file.note == "took rounding noise off the matrix: distances moved by at most 2.2e-16");
    CHECK(good("0 1 2\n1 0 3\n2 3 0\n").note == "");
    // One part in 2^36 of the largest distance, which is 4, is 5.8e-11.
    CHECK(good("0 4\n4.00000000005 0\n").points == 2);
    CHECK(fault("0 4\n4.0000000001 0\n") == "d.csv:2: field 1: the distance is 4.0000000001, and 4 the other way "
                                            "round; (D + D.T) / 2 makes a matrix symmetric");
    CHECK(good("0 4\n4 5e-11\n").numbers == Numbers{0, 4, 4, 0});
    CHECK(fault("0 4\n4 1e-10\n") == "d.csv:2: field 2: the distance of a point to itself is 1e-10, not 0");
    CHECK(fault("0 4 1\n4 0 -1e-10\n1 0 0\n") == "d.csv:2: field 3: a distance is negative: -1e-10");
    CHECK(fault("0 inf\n1 0\n").find("the distance is 1, and inf the other way round") != std::string::npos);
    CHECK(good("0 inf 4\ninf 0 1\n4.00000000001 1 0\n").numbers[1] == HUGE_VAL);
}

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

std::string utf16(const std::string& text) {
    std::string wide = "\xFF\xFE";
    for (const char c : text) (wide += c) += '\0';
    return wide;
}

// The text as spreadsheets and others write it, a blank between its numbers.
std::vector<std::string> in_dialects(const std::string& text) {
    std::vector<std::string> all = {text};
    for (const char* const between : {",", ";", "\t", ", ", " ; ", "   ", "|", " | "})
        all.push_back(replaced(text, " ", between));
    const std::string semicolons = replaced(text, " ", ";");
    const bool has_semicolon = semicolons != text;
    const std::size_t plain = all.size();
    for (const char* const between : {";", "\t", "|", " ; "})  // decimal commas
        if (has_semicolon) all.push_back(replaced(replaced(text, ".", ","), " ", between));
    all.push_back("\"" + replaced(replaced(text, " ", "\",\""), "\n", "\"\n\""));
    all.back().pop_back();  // behind the last end of line nothing begins
    if (has_semicolon) all.push_back(replaced(all.back(), ".", ","));
    for (std::size_t i = 0, count = all.size(); i < count; i++) {
        if (i > 4 && i < plain) continue;
        all.push_back("\xEF\xBB\xBF" + replaced(all[i], "\n", "\r\n"));
        all.push_back(replaced(all[i], "\n", "\r"));
        all.push_back(utf16(all[i]));
        all.push_back("# made by hand, 2024\n" + replaced(all[i], "\n", " # so far\n"));
        all.push_back("% a\n// b\n" + all[i] + "\x1A");
    }
    return all;
}

}  // namespace

TEST_CASE("distances in every form are read in every dialect of tables") {
    const char* const forms[] = {"0 3.25 5.5 1.25\n3.25 0 4.5 2.75\n5.5 4.5 0 6.5\n1.25 2.75 6.5 0\n",
                                 "3.25\n5.5 4.5\n1.25 2.75 6.5\n",
                                 "0\n3.25 0\n5.5 4.5 0\n1.25 2.75 6.5 0\n",
                                 "3.25 5.5 1.25\n4.5 2.75\n6.5\n",
                                 "0 3.25 5.5 1.25\n0 4.5 2.75\n0 6.5\n0\n",
                                 "0 3.25 5.5 1.25\n0 0 4.5 2.75\n0 0 0 6.5\n0 0 0 0\n",
                                 "3.25 5.5 1.25 4.5 2.75 6.5\n",
                                 "3.25\n5.5\n1.25\n4.5\n2.75\n6.5\n"};
    const Numbers due = {3.25, 5.5, 4.5, 1.25, 2.75, 6.5};
    for (const char* const form : forms)
        for (const std::string& text : in_dialects(form)) {
            const DistanceFile file = good(text);
            CAPTURE(text);
            REQUIRE(file.points == 4);
            Numbers lower;
            for (std::size_t i = 0; i < 4; i++)
                for (std::size_t j = 0; j < i; j++)
                    lower.push_back(file.layout == NETMESH_DISTANCES_FULL ? file.numbers[4 * i + j]
                                                                          : file.numbers[i * (i - 1) / 2 + j]);
            CHECK(lower == due);
        }
    for (const std::string& text : in_dialects("0 1 3.25\n0 2 5.5\n1 2 4.5\n")) {
        CAPTURE(text);
        const DistanceFile file = good(text, true);
        REQUIRE(file.entries.size() == 3);
        CHECK((file.entries[2].i == 1 && file.entries[2].j == 2 && file.entries[2].distance == 4.5));
    }
}

TEST_CASE("decimal commas of distances are said, and refused where they may be something else") {
    CHECK(good("1,5;2,5;2,1\n").points == 3);  // three distances, not six
    CHECK(good("0;1,5\n1,5;0\n").note == "commas read as decimal");
    CHECK(good("\"0\",\"1,5\"\n\"1,5\",\"0\"\n").numbers == Numbers{0, 1.5, 1.5, 0});
    CHECK(good("sep=;\n0;1,5\n1,5;0\n").numbers == Numbers{0, 1.5, 1.5, 0});
    CHECK(good(";Site #1;Site #2\nSite #1;0;1,5\nSite #2;1,5;0\n").numbers == Numbers{0, 1.5, 1.5, 0});
    CHECK(fault("0;1,234\n1,234;0\n") ==
          "d.csv:1: commas may be decimal or group thousands (1,234); write numbers with points");
    CHECK(fault("0;1,5\n1.5;0\n").find("d.csv:1: points and commas are both decimal here") == 0);
    CHECK(fault("0 1,5\n1,5 0\n").find("write decimals with a point") != std::string::npos);
}

TEST_CASE("what stands in front of distances, and what is none, is named") {
    const std::string square = "0 3 5\n3 0 4\n5 4 0\n";
    CHECK(fault("3\n" + square).find("if line 1 says how many points there are, put # in front of it") !=
          std::string::npos);
    CHECK(fault("3 3\n" + square).find("says how many points there are") != std::string::npos);
    CHECK(fault("0,1,2\n0,3,5\n3,0,4\n5,4,0\n").find("if line 1 is the numbers of columns, put # in front of it") !=
          std::string::npos);
    CHECK(good("# 0,1,2\n0,3,5\n3,0,4\n5,4,0\n").points == 3);
    CHECK(fault("a 0 3\nb 3 0\n").find("names that rows begin with are read below a header") != std::string::npos);
    CHECK(fault("0,,\n3,0,\n5,4,0\n").find("cells that a triangle does not have are left out, or 0") !=
          std::string::npos);
    CHECK(fault("1 .5\n.5 1\n").find("; of similarities S write 1 - S") != std::string::npos);
    CHECK(fault("0 1 2\n0 2 3\n1 2 3\n").find("; lines i j distance are read with --sparse") != std::string::npos);
    CHECK(fault("0 1 2\n0 2 3\n1 2 3\n1 3 1\n").find("are read with --sparse") != std::string::npos);
}

TEST_CASE("inf is a distance") {
    CHECK(good("0 inf\nInfinity 0\n").numbers == Numbers{0, HUGE_VAL, HUGE_VAL, 0});
    CHECK(good("0 1 +INF\n", true).entries[0].distance == HUGE_VAL);
    CHECK(fault("0 nan\nnan 0\n") == "d.csv:1: \"nan\" is not a finite double");
    CHECK(fault("0 -inf\n-inf 0\n") == "d.csv:1: \"-inf\" is not a finite double");
    CHECK(fault("0 1e400\n1e400 0\n") == "d.csv:1: \"1e400\" is not a finite double");
    CHECK(good("0 -1e-400\n-1e-400 0\n").numbers == Numbers{0, 0, 0, 0});  // the nearest double
}

TEST_CASE("distances in arrays of NumPy") {
    const auto take = [](Numbers values, std::size_t width, bool sparse, std::string* message) {
        Table table;
        table.name = "d.npy";
        table.width = width;
        table.values = std::move(values);
        DistanceFile file;
        *message = take_distances(table, sparse, &file).message;
        return file;
    };
    std::string message;
    DistanceFile file = take({0, 3, 5, 3, 0, 4, 5, 4, 0}, 3, false, &message);
    CHECK(message == "");
    CHECK(file.layout == NETMESH_DISTANCES_FULL);
    CHECK(file.where(2, 1) == "d.npy: row 3, field 2");
    // pdist of four points: 01 02 03 12 13 23
    file = take({1, 2, 3, 12, 13, 23}, 1, false, &message);
    CHECK(message == "");
    CHECK(file.layout == NETMESH_DISTANCES_LOWER);
    CHECK(file.points == 4);
    CHECK(file.numbers == Numbers{1, 2, 12, 3, 13, 23});
    CHECK(file.note == "read as the upper triangle row by row, as scipy's pdist and R's dist have it");
    CHECK(take({7}, 1, false, &message).numbers == Numbers{7});
    CHECK(message == "");
    CHECK(take({0, 1, 2, 1, 2, 3}, 3, true, &message).entries.size() == 2);
    CHECK(message == "");
    take({1, 2, 3, 4}, 1, false, &message);
    CHECK(message == "d.npy: an array of 4 numbers; one axis of distances of n points has n (n - 1) / 2");
    take({0, 1, 1, 0, 2, 2}, 2, false, &message);
    CHECK(message ==
          "d.npy: row 3: a matrix of 3 rows and 2 columns; one of distances is square; points, as these may be, "
          "are read without --distances");
    take({0, 1, -1, 0}, 2, false, &message);
    CHECK(message == "d.npy: row 2: field 1: a distance is negative: -1");
    take({1, -2, 3}, 1, false, &message);
    CHECK(message == "d.npy: row 2: field 1: a distance is negative: -2");
}

TEST_CASE("distances as entries") {
    const DistanceFile file = good("0 2 1.5\n3 1 2\n", true);
    CHECK(file.layout == NETMESH_DISTANCES_SPARSE);
    CHECK(file.points == 4);
    REQUIRE(file.entries.size() == 2);
    CHECK(file.entries[1].i == 3);
    CHECK(file.entries[1].j == 1);
    CHECK(file.entries[1].distance == 2);
    CHECK(file.where(1, 1) == "d.csv:2");
}

TEST_CASE("faults in files of distances name line and field") {
    // A decimal comma in a row that lacks a field must not become a field of its own.
    const std::string mixed = "commas part some numbers and blanks others; write decimals with a point";
    CHECK(fault("0 2 1.5\n3,1,2\n", true) == "d.csv:2: " + mixed);
    CHECK(fault("0 1,5\n", true) == "d.csv:1: " + mixed);
    CHECK(fault("1\n2,5\n1 2 3\n") == "d.csv:3: " + mixed);
    CHECK(fault("0 1 0\n1 0,3\n0 3 0\n") == "d.csv:2: " + mixed);
    CHECK(fault("") == "d.csv:1: the input ends without a distance");
    for (const char* const points : {"0 1\n1 0\n2 2\n", "0 -1\n1 0\n2 2\n"})
        CHECK(fault(points) ==
              "d.csv:3: a matrix of 3 rows and 2 columns; one of distances is square; points, as these "
              "may be, are read without --distances");
    CHECK(fault("0.9999999999999998 0.5\n0.5 1\n").find("; of similarities S write 1 - S") != std::string::npos);
    CHECK(fault("0 1 2\n1 0\n") == "d.csv:2: 2 numbers where the first row of the matrix has 3");
    CHECK(fault("3\n5 4\n1 2\n") == "d.csv:3: 2 numbers where a lower triangle has 3");
    CHECK(fault("0 1\n-1 0\n") == "d.csv:2: field 1: a distance is negative: -1");
    CHECK(fault("0 1 2\n0 1\n", true) == "d.csv:2: 2 numbers where an entry, `i j d`, has 3");
    CHECK(fault("0 1.5 2\n", true) == "d.csv:1: field 2: 1.5; points are numbered from 0, to 67108863");
    CHECK(fault("0 67200001 2\n", true) == "d.csv:1: field 2: 67200001; points are numbered from 0, to 67108863");
    CHECK(fault("-1 0 2\n", true) == "d.csv:1: field 1: -1; points are numbered from 0, to 67108863");
    CHECK(fault("0 1 -2\n", true) == "d.csv:1: field 3: a distance is negative: -2");
}
