// Lattices as options and files of atoms say them, and which points are outside of a period.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "tools/io/lattice.hpp"
#include "tools/io/points.hpp"

using namespace netmesh::tool;

namespace {

using Numbers = std::vector<double>;

void good_box(const std::string& text, const Numbers& vectors, const std::string& said) {
    CAPTURE(text);
    Lattice lattice;
    CHECK(parse_box(text, &lattice) == "");
    CHECK(lattice.kind == Lattice::box);
    CHECK(lattice.vectors == vectors);
    CHECK(lattice.text == said);
    Lattice again;
    CHECK(parse_box(said, &again) == "");
    CHECK(again.vectors == vectors);
    CHECK(again.low == lattice.low);
}

void good_cell(const std::string& text, const Numbers& vectors, const std::string& said) {
    CAPTURE(text);
    Lattice lattice;
    CHECK(parse_cell(text, &lattice) == "");
    CHECK(lattice.kind == Lattice::cell);
    CHECK(lattice.vectors == vectors);
    CHECK(lattice.text == said);
    Lattice again;
    CHECK(parse_cell(said, &again) == "");
    CHECK(again.vectors == vectors);
}

bool says(const std::string& complaint, const std::string& words) { return complaint.find(words) != std::string::npos; }

std::string of_box(const std::string& text) {
    Lattice lattice;
    return parse_box(text, &lattice);
}
std::string of_cell(const std::string& text) {
    Lattice lattice;
    return parse_cell(text, &lattice);
}
std::string of_file(const std::string& text) {
    Lattice lattice;
    return parse_file_cell(text, &lattice);
}

Numbers vectors_of_file(const std::string& text) {
    Lattice lattice;
    CHECK(parse_file_cell(text, &lattice) == "");
    return lattice.vectors;
}

}  // namespace

TEST_CASE("lattice: boxes") {
    good_box("0:10,5", {10, 0, 0, 5}, "0:10,0:5");
    good_box("-1.5:1.5,-,1e1", {3, 0, 0, 0, 0, 10}, "-1.5:1.5,-,0:10");
    good_box("-,-3:-1", {0, 2}, "-,-3:-1");
    CHECK(says(of_box("10"), "must have an entry for each axis"));
    CHECK(says(of_box("1,1,1,1,1,1,1"), "must have an entry for each axis"));
    CHECK(says(of_box("-,-"), "has no period"));
    CHECK(says(of_box("1,0"), "entry 2, \"0\", has to be a length above 0"));
    CHECK(says(of_box("1,-2"), "entry 2, \"-2\", has to be a length above 0"));
    CHECK(says(of_box("3:3,1"), "entry 1, \"3:3\", has to end above where it begins"));
    for (const char* const entry : {"nan", "inf", "", "a", "1:", ":1", "1:2:3", "0:nan", "1 2"})
        CHECK(says(of_box(std::string("1,") + entry), "no LO:HI of two finite numbers"));
    CHECK(says(of_box("-1e308:1e308,1"), "longer than the largest double"));
}

TEST_CASE("lattice: cells") {
    good_cell("4,0,0/1,4,0/0,0,5", {4, 0, 0, 1, 4, 0, 0, 0, 5}, "4,0,0/1,4,0/0,0,5");
    good_cell("1,4/4,0", {1, 4, 4, 0}, "1,4/4,0");
    good_cell("4,0,0/-/0,0,5.50", {4, 0, 0, 0, 0, 5.5}, "4,0,0/-/0,0,5.5");
    Lattice file;
    CHECK(parse_cell("file", &file) == "");
    CHECK(file.kind == Lattice::file);
    CHECK(says(of_cell("4,0,0"), "must be as many vectors"));
    CHECK(says(of_cell("filed"), "must be as many vectors"));
    CHECK(says(of_cell("-/-"), "has no period"));
    CHECK(says(of_cell("4,0/1,4/0,0"), "vector 1, \"4,0\", has to be 3 finite numbers"));
    CHECK(says(of_cell("4,0/1,nan"), "vector 2"));
    CHECK(says(of_cell("4,0/"), "vector 2"));
}

TEST_CASE("lattice: sides and angles") {
    good_cell("4,5,6,90,90,90", {4, 0, 0, 0, 5, 0, 0, 0, 6}, "4,0,0/0,5,0/0,0,6");
    good_cell("4,4,5,90,90,120", {4, 0, 0, -2, 4 * std::sin(120 * (3.14159265358979323846 / 180)), 0, 0, 0, 5},
              "4,0,0/-2,3.464101615137755,0/0,0,5");
    Lattice lattice;
    CHECK(parse_cell("3,4,5,70,80,65", &lattice) == "");
    const double sides[] = {3, 4, 5}, angles[] = {70, 80, 65};
    const auto dot = [&](std::size_t i, std::size_t j) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; k++) sum += lattice.vectors[3 * i + k] * lattice.vectors[3 * j + k];
        return sum;
    };
    for (std::size_t i = 0; i < 3; i++) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        CHECK(std::sqrt(dot(i, i)) == doctest::Approx(sides[i]).epsilon(1e-14));
        const double due = std::cos(angles[i] * (3.14159265358979323846 / 180));
        CHECK(dot(j, k) / std::sqrt(dot(j, j) * dot(k, k)) == doctest::Approx(due).epsilon(1e-14));
    }
    CHECK(says(of_cell("4,4,0,90,90,90"), "side 0 has to be above 0"));
    CHECK(says(of_cell("4,4,4,90,180,90"), "angle 180 has to be above 0 and below 180"));
    CHECK(says(of_cell("4,4,4,30,30,90"), "no cell has these angles"));
    CHECK(says(of_cell("4,4,4,120,120,120"), "no cell has these angles"));
    CHECK(says(of_cell("4,4,4,90,90"), "must be as many vectors"));
}

TEST_CASE("lattice: what files of atoms say") {
    const Numbers all = {4, 0, 0, 1, 4, 0, 0, 0, 5};
    const std::string lattice = "Lattice=\"4 0 0  1 4.0 0 0 0 5\"";
    CHECK(vectors_of_file(lattice) == all);
    CHECK(vectors_of_file("pbc=\"T T T\" " + lattice + " energy=-1") == all);
    CHECK(vectors_of_file("Virtual_Lattice=\"1\" " + lattice + " pbc=T") == all);
    CHECK(vectors_of_file(lattice + " pbc='T F 1'") == Numbers{4, 0, 0, 0, 0, 5});
    CHECK(vectors_of_file(lattice + " pbc=\"False True False\"") == Numbers{1, 4, 0});
    CHECK(says(of_file(lattice + " pbc=\"F F F\""), "pbc= says that no vector is a period"));
    CHECK(says(of_file(lattice + " pbc=\"T T\""), "pbc= has to be T or F"));
    CHECK(says(of_file(lattice + " pbc=\"T T x\""), "pbc= has to be T or F"));
    CHECK(says(of_file("Lattice=\"4 0 0 1 4 0\""), "nine finite numbers"));
    CHECK(says(of_file("Lattice=4"), "nine finite numbers"));
    CHECK(says(of_file("Lattice="), "nine finite numbers"));
    CHECK(vectors_of_file("CRYST1   52.000   58.600   61.900  90.00  90.00  90.00 P 21 21 21    8") ==
          Numbers{52, 0, 0, 0, 58.6, 0, 0, 0, 61.9});
    CHECK(vectors_of_file("CRYST1 1052.00011058.60011061.900  90.00  90.00  90.00") ==
          Numbers{1052, 0, 0, 0, 11058.6, 0, 0, 0, 11061.9});
    CHECK(says(of_file("CRYST1   52.000   58.600   61.900"), "columns 7 to 54"));
}

TEST_CASE("lattice: points outside of a period") {
    const auto outside = [](std::string (*parse)(const std::string&, Lattice*), const char* text, const Numbers& at) {
        Lattice lattice;
        CHECK(parse(text, &lattice) == "");
        return points_outside(lattice, at);
    };
    CHECK(outside(parse_box, "1:2,-", {1, 9, 1.5, -9, 2, 0, 0.5, 0}) == 2);
    CHECK(outside(parse_box, "1,1", {0, 0, 0, 1, 1, 0, -1e-300, 0, 0.5, 0.5}) == 3);
    CHECK(outside(parse_cell, "4,0/1,4", {0, 0, 4.5, 2, 0.4, 2, 5, 4, 2, 2}) == 3);
    CHECK(outside(parse_cell, "1,4/4,0", {0, 0, 4.5, 2, 0.4, 2, 5, 4, 2, 2}) == 3);
    CHECK(outside(parse_cell, "3,3,0/-/0,0,1", {100, -100, 0.5, 3.5, 3, 0.5, 1, 1, 1}) == 2);
}

TEST_CASE("lattice: with points from a file") {
    char name[] = "/tmp/netmesh-lattice-XXXXXX";
    const std::string folder = std::string(mkdtemp(name)) + "/";
    const auto read = [&](const std::string& file, const std::string& content, const char* cell, PointCloud* cloud) {
        std::ofstream(folder + file) << content;
        TableOptions options;
        if (*cell != 0) REQUIRE(parse_cell(cell, &options.lattice) == "");
        return read_points(folder + file, options, cloud);
    };
    const std::string head = "2\nLattice=\"4 0 0 1 4 0 0 0 5\" pbc=\"T T F\"\n", atoms = "C 0 0 0\nO 5 6 9\n";
    PointCloud cloud;
    CHECK(read("a.xyz", head + atoms, "file", &cloud).message == "");
    CHECK(cloud.lattice.text == "4,0,0/1,4,0/-");
    CHECK(cloud.note == "read as atoms of .xyz; 1 point stands for its copy inside the cell");
    CHECK(read("a.xyz", head + atoms, "", &cloud).message == "");
    CHECK(cloud.lattice.kind == Lattice::none);
    CHECK(says(cloud.note, "without its periodic cell: atoms near opposite sides are far apart; persist --cell file"));
    CHECK(read("a.xyz", head + atoms, "9,0,0/0,9,0/0,0,9.5", &cloud).message == "");
    CHECK(cloud.lattice.text == "9,0,0/0,9,0/0,0,9.5");
    CHECK(cloud.note == "read as atoms of .xyz");
    CHECK(read("b.xyz", "2\nLattice=\"4 0 0\"\n" + atoms, "file", &cloud).message ==
          folder + "b.xyz:2: --cell file: Lattice= has to be nine finite numbers in quotes, three for each vector");
    CHECK(read("b.xyz", "2\nno cell\n" + atoms, "file", &cloud).exit == Exit::usage);
    CHECK(says(read("c.csv", "1,2\n3,4\n", "file", &cloud).message, "c.csv has no periodic cell"));
    CHECK(says(read("c.csv", "1,2\n3,4\n", "9,0,0/0,9,0/0,0,9", &cloud).message, "is in 3 dimensions"));
    std::filesystem::remove_all(folder);
}
