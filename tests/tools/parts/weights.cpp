// Radii and weights of points, from every kind of file that has them.
#include <doctest/doctest.h>

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tools/io/npy_writer.hpp"
#include "tools/io/points.hpp"
#include "tools/io/vdw_radii.hpp"
#include "tools/opinion/complexes.hpp"
#include "tools/opinion/exact_number.hpp"

using namespace netmesh::tool;

namespace {

using Numbers = std::vector<double>;

class Folder {
public:
    Folder() {
        char name[] = "/tmp/netmesh-weights-XXXXXX";
        path_ = std::string(mkdtemp(name)) + "/";
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::string write(const std::string& name, const std::string& content) const {
        std::ofstream(path_ + name, std::ios::binary) << content;
        return path_ + name;
    }

private:
    std::string path_;
};

Outcome read(const std::string& path, const std::string& weights, bool are_radii, PointCloud* cloud,
             std::vector<std::string> columns = {}) {
    TableOptions options;
    options.weights = weights;
    options.are_radii = are_radii;
    options.columns = std::move(columns);
    return read_points(path, options, cloud);
}

void good(const std::string& path, const std::string& weights, bool are_radii, const Numbers& coordinates,
          const Numbers& due, std::vector<std::string> columns = {}) {
    CAPTURE(path);
    PointCloud cloud;
    CHECK(read(path, weights, are_radii, &cloud, std::move(columns)).message == "");
    CHECK(cloud.coordinates == coordinates);
    CHECK(cloud.weights == due);
    CHECK(cloud.dim == coordinates.size() / due.size());
}

std::string fault(const std::string& path, const std::string& weights, bool are_radii, Exit exit = Exit::data,
                  std::vector<std::string> columns = {}) {
    CAPTURE(path);
    PointCloud cloud;
    const Outcome outcome = read(path, weights, are_radii, &cloud, std::move(columns));
    CHECK(outcome.exit == exit);
    return outcome.message.substr(outcome.message.rfind('/') + 1);
}

std::string npy(const Numbers& numbers, std::uint64_t columns) {
    TextWriter out;
    write_npy_head(numbers.size() / columns, columns, out);
    for (const double x : numbers) write_npy_double(x, out);
    return std::string(out.text());
}

const char* const carbon = "ATOM      1  CA  ALA A   1       1.500  -2.250   7.000  1.00  0.00           C\n";
const char* const zinc = "HETATM    2 ZN    ZN A   2       1.500  -2.250   7.000  1.00  0.00          ZN\n";

}  // namespace

TEST_CASE("weights are a column of a table or an array, which is no coordinate") {
    const Folder folder;
    const Numbers places = {1, 2, 5, 6, 9, 1}, third = {3, 7, 2};
    const std::string table = folder.write("a.csv", "x,y,r\n1,2,3\n5,6,7\n9,1,2\n");
    for (const bool are_radii : {false, true}) {
        good(table, "r", are_radii, places, third);
        good(table, "3", are_radii, places, third);
        good(table, "3", are_radii, places, third, {"x", "y"});
        good(table, "x", are_radii, {2, 3, 6, 7, 1, 2}, {1, 5, 9});
        good(folder.write("a.npy", npy({1, 2, 3, 5, 6, 7, 9, 1, 2}, 3)), "3", are_radii, places, third);
    }
    good(folder.write("b.csv", ",x,y,r\n0,1,2,3\n1,5,6,7\n2,9,1,2\n"), "r", true, places, third);  // behind an index
    good(folder.write("c.csv", "1;2;-3,5\n5;6;7\n9;1;2\n"), "3", false, places, {-3.5, 7, 2});
    CHECK(fault(table, "4", true) == "a.csv:2: --radii 4: there are columns 1 to 3");
    CHECK(fault(table, "w", false) ==
          "a.csv:2: --weights: there is no column \"w\"; the header names \"x\", \"y\", \"r\"");
    CHECK(fault(table, "2-3", true) == "a.csv:2: --radii 2-3: is one column");
    CHECK(fault(table, "r", true, Exit::data, {"x", "r"}) ==
          "a.csv:2: --radii r: --columns takes the same column for a coordinate");
    CHECK(fault(folder.write("d.csv", "x,y,r\n1,2,3\n5,6,-7\n"), "r", true) ==
          "d.csv:3: radius -7; radii are 0 or more, --weights takes squares of any sign");
    CHECK(fault(folder.write("e.npy", npy({1, 2, 3, 5, 6, -7}, 3)), "3", true).find("e.npy: row 2: radius -7") == 0);
    CHECK(fault(folder.write("f.csv", "x,y,r\n1,2,3\n5,6,nan\n"), "r", true).find("f.csv:3: ") == 0);
    CHECK(fault(folder.write("g.csv", "1,2\n5,6\n"), "2", true).find("g.csv:1: 1 column besides that of weights") == 0);
    CHECK(
        fault(folder.write("h.off", "OFF\n1 0 0\n1 2 3\n"), "3", true, Exit::usage).find("h.off has no such column") !=
        std::string::npos);
}

TEST_CASE("radii of atoms") {
    const Folder folder;
    const std::string xyz = folder.write("a.xyz", "3\nby hand\nC 1 2 3\nh 4 5 6\n8 7 8 9\n");
    good(xyz, "vdw", true, {1, 2, 3, 4, 5, 6, 7, 8, 9}, {1.7, 1.1, 1.52});
    good(folder.write("a.pdb", carbon), "vdw", true, {1.5, -2.25, 7}, {1.7});
    // Without columns 77 and 78 by the name: CA in column 14 is carbon, in column 13 calcium; 1HB and HG11 are
    // hydrogen.
    const auto named = [](const char* name) {
        return "ATOM      1 " + std::string(name) + std::string(carbon + 16, 50) + "\n";
    };
    good(folder.write("b.pdb", named(" CA ") + named("CA  ") + named("1HB ") + named("HG11") + named("SE  ")), "vdw",
         true, {1.5, -2.25, 7, 1.5, -2.25, 7, 1.5, -2.25, 7, 1.5, -2.25, 7, 1.5, -2.25, 7}, {1.7, 2.31, 1.1, 1.1, 1.9});
    good(folder.write("a.pqr", "ATOM 1 N ALA 1 1.5 -2.25 7 -0.3 1.85\nATOM 2 C ALA A 1 3 4 8 0.2 2.0\n"), "radius",
         true, {1.5, -2.25, 7, 3, 4, 8}, {1.85, 2});
    CHECK(fault(folder.write("c.pdb", std::string(carbon) + zinc), "vdw", true)
              .find("c.pdb:2: no van der Waals radius of \"ZN\" is known") == 0);
    CHECK(fault(xyz, "2", true, Exit::usage).find("--radii vdw, or a table") != std::string::npos);
    CHECK(fault(xyz, "vdw", false, Exit::usage).find("--radii vdw, or a table") != std::string::npos);
    CHECK(fault(folder.write("b.pqr", "ATOM 1 N ALA 1 1.5 -2.25 7 -0.3 1.85\n"), "vdw", true, Exit::usage)
              .find("--radii radius") != std::string::npos);
    CHECK(van_der_waals_radius("Fe") == 0);
    CHECK(van_der_waals_radius("Cl12") == 1.75);
    CHECK(van_der_waals_radius("d") == 1.1);
    CHECK(van_der_waals_radius("") == 0);
    CHECK(van_der_waals_radius("CB") == 0);
}

TEST_CASE("quotients and roots with a sign, rounded to nearest") {
    CHECK(nearest_quotient(Exact(1), Exact(3)) == 1.0 / 3);
    CHECK(nearest_quotient(Exact(-7), Exact(5)) == -7.0 / 5);
    CHECK(nearest_quotient(Exact(), Exact(5)) == 0);
    CHECK(nearest_quotient(Exact(5e-324), Exact(2)) == 0);  // half of the least double, to even
    CHECK(nearest_quotient(Exact(0x1.8p-1073), Exact(2)) == 0x1p-1073);
    CHECK(nearest_quotient(Exact(0x1.fffffffffffffp1023), Exact(0.5)) == HUGE_VAL);
    CHECK(nearest_signed_root(Exact(-2), Exact(1)) == -std::sqrt(2.0));
    CHECK(nearest_signed_root(Exact(9), Exact(4)) == 1.5);
}

TEST_CASE("the nerve of balls by their powers") {
    // Two balls of radius 1 and 2 whose centres are 4 apart meet where both have grown to x^2 - 1 = (4 - x)^2 - 4.
    PointCloud cloud;
    cloud.dim = 2;
    cloud.coordinates = {0, 0, 4, 0};
    cloud.weights = {1, 2};
    const SimplexList powers = nerve_of_balls(cloud, true, true, 1), radii = nerve_of_balls(cloud, true, false, 1);
    REQUIRE((powers && powers->size() == 3));
    CHECK((*powers)[0].value == -1);
    CHECK((*powers)[1].value == -4);
    CHECK((*powers)[2].value == 1.625 * 1.625 - 1);
    CHECK((*radii)[1].value == -2);
    CHECK((*radii)[2].value == std::sqrt(1.625 * 1.625 - 1));
    // A ball inside of the other one has no time of its own.
    cloud.coordinates = {0, 0, 1, 0};
    cloud.weights = {1, 9};
    const SimplexList nested = nerve_of_balls(cloud, false, true, 1);
    CHECK((*nested)[2].value == -1);
}
