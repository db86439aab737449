// Values at the vertices of a mesh: the file, and the function that it makes.
#include "tools/vertex_function.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

using namespace netmesh::tool;

namespace {

PointCloud three_points() {
    PointCloud cloud;
    cloud.name = "m.node";
    cloud.dim = 2;
    cloud.coordinates = {1, 0, 0, 1, 0, -1};
    return cloud;
}

}  // namespace

TEST_CASE("values at vertices: lines and reasons") {
    const PointCloud cloud = three_points();
    const auto message = [&](const std::string& text) {
        std::vector<double> values;
        std::vector<std::uint64_t> lines;
        const Outcome outcome = parse_vertex_values(text, "v.txt", cloud, &values, &lines);
        CHECK(outcome.good() == outcome.message.empty());
        CHECK((outcome.good() || outcome.exit == Exit::data));
        if (outcome.good()) {
            CHECK(values == std::vector<double>{1.5, -2, 0});
            CHECK(lines.size() == 3);
        }
        return outcome.message;
    };
    CHECK(message("1.5\n-2\n0\n") == "");
    CHECK(message("# head\n\n 1.5 # first\r\n-2\n\n-0") == "");
    CHECK(message("1.5\n-2\n") == "v.txt:2: the input ends after 2 values; m.node has 3 vertices");
    CHECK(message("") == "v.txt:1: the input ends after 0 values; m.node has 3 vertices");
    CHECK(message("1.5\n-2\n0\n# end\n4\n") == "v.txt:5: a value too many; m.node has 3 vertices");
    CHECK(message("1.5\n-2 0\n") == "v.txt:2: 2 values; a line is the value at one vertex");
    CHECK(message("1.5\ninf\n0\n") == "v.txt:2: \"inf\" is not a finite double");
    CHECK(message("1.5\nzero\n0\n") == "v.txt:2: \"zero\" is not a number");
}

TEST_CASE("values at vertices: found by coordinates, nothing elsewhere; fingerprints tell orders apart") {
    const PointCloud cloud = three_points();
    const std::string path = "vertex_function_test.txt";
    const auto read = [&](const std::string& text, const PointCloud& of) {
        std::ofstream(path) << text;
        VertexFunction function;
        CHECK(VertexFunction::read(path, of, &function).good());
        std::remove(path.c_str());
        return function;
    };
    const VertexFunction f = read("1\n# no value\n2\n3\n", cloud);
    for (std::size_t v = 0; v < 3; ++v) CHECK(f(&cloud.coordinates[2 * v]) == static_cast<double>(v + 1));
    const double beside[] = {1, 1e-300}, far[] = {9, 9};
    CHECK(std::isnan(f(beside)));
    CHECK(std::isnan(f(far)));
    CHECK(f.where(1) == path + ":3");
    CHECK(f.values_fingerprint().size() == 16);
    CHECK(f.values_fingerprint() == read("1\n2\n3\n", cloud).values_fingerprint());
    CHECK(f.values_fingerprint() != read("1\n3\n2\n", cloud).values_fingerprint());
    CHECK(f.values_fingerprint() != read("1\n2\n3.0000000000000004\n", cloud).values_fingerprint());
    PointCloud other = cloud;
    std::swap(other.coordinates[0], other.coordinates[1]);
    other.coordinates[2] = 7;
    CHECK(f.mesh_fingerprint() != read("1\n2\n3\n", other).mesh_fingerprint());
    VertexFunction none;
    CHECK(!VertexFunction::read("there/is/no/such/file", cloud, &none).good());
}
