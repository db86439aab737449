// .npy, .off, .ply and .node as points.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "tools/io/points.hpp"

using namespace netmesh::tool;

namespace {

using Parser = Outcome (*)(std::string_view, PointCloud*);
using Numbers = std::vector<double>;
using Lines = std::vector<std::uint64_t>;

PointCloud good(Parser parser, const std::string& content) {
    PointCloud cloud;
    cloud.name = "p";
    const Outcome outcome = parser(content, &cloud);
    CAPTURE(content);
    CHECK(outcome.message == "");
    return cloud;
}

std::string fault(Parser parser, const std::string& content) {
    PointCloud cloud;
    cloud.name = "p";
    const Outcome outcome = parser(content, &cloud);
    CAPTURE(content);
    CHECK(outcome.exit == Exit::data);
    return outcome.message;
}

template <class T> std::string raw(std::initializer_list<T> values, bool big = false) {
    std::string bytes;
    for (const T value : values) {
        char item[sizeof(T)];
        std::memcpy(item, &value, sizeof(T));
        std::uint16_t probe = 1;
        char low;
        std::memcpy(&low, &probe, 1);
        if ((low == 1) == big) {
            for (std::size_t i = 0; i < sizeof(T) / 2; i++) std::swap(item[i], item[sizeof(T) - 1 - i]);
        }
        bytes.append(item, sizeof(T));
    }
    return bytes;
}

std::string npy(const std::string& descr, const std::string& shape, const std::string& data,
                const std::string& order = "False", char version = 1) {
    std::string header = "{'descr': '" + descr + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
    while ((10 + header.size() + 1) % 64 != 0) header += ' ';
    header += '\n';
    std::string content = "\x93NUMPY";
    content += version;
    content += '\0';
    content += static_cast<char>(header.size() & 255);
    content += static_cast<char>(header.size() >> 8);
    if (version > 1) content += std::string(2, '\0');
    return content + header + data;
}

}  // namespace

TEST_CASE("npy: every type and byte order gives the same points") {
    const Numbers points = {1, 2, 3, 4, 5, 100};
    CHECK(good(parse_npy_points, npy("<f8", "(3, 2)", raw<double>({1, 2, 3, 4, 5, 100}))).coordinates == points);
    CHECK(good(parse_npy_points, npy(">f8", "(3, 2)", raw<double>({1, 2, 3, 4, 5, 100}, true))).coordinates == points);
    CHECK(good(parse_npy_points, npy("<f4", "(3, 2)", raw<float>({1, 2, 3, 4, 5, 100}))).coordinates == points);
    CHECK(good(parse_npy_points, npy(">f4", "(3, 2)", raw<float>({1, 2, 3, 4, 5, 100}, true))).coordinates == points);
    CHECK(good(parse_npy_points, npy("|i1", "(3, 2)", raw<std::int8_t>({1, 2, 3, 4, 5, 100}))).coordinates == points);
    CHECK(good(parse_npy_points, npy("|u1", "(3, 2)", raw<std::uint8_t>({1, 2, 3, 4, 5, 100}))).coordinates == points);
    CHECK(good(parse_npy_points, npy("<u2", "(3, 2)", raw<std::uint16_t>({1, 2, 3, 4, 5, 100}))).coordinates == points);
    CHECK(good(parse_npy_points, npy(">i4", "(3, 2)", raw<std::int32_t>({1, 2, 3, 4, 5, 100}, true))).coordinates ==
          points);
    const PointCloud wide = good(parse_npy_points, npy("<i8", "(2, 3)", raw<std::int64_t>({1, 2, 3, 4, 5, 100})));
    CHECK(wide.dim == 3);
    CHECK(wide.coordinates == points);
    CHECK(good(parse_npy_points, npy("<i8", "(1, 2)", raw<std::int64_t>({-1, -2}))).coordinates == Numbers{-1, -2});
    CHECK(good(parse_npy_points, npy("<f8", "(1, 2)", raw<double>({7, 8}), "False", 2)).coordinates == Numbers{7, 8});
}

TEST_CASE("npy: Fortran order, half precision and integers up to 2^53") {
    const Numbers points = {1, 2, 3, 4, 5, 100};
    const std::string by_columns = raw<double>({1, 3, 5, 2, 4, 100});
    CHECK(good(parse_npy_points, npy("<f8", "(3, 2)", by_columns, "True")).coordinates == points);
    const std::string halves = raw<std::uint16_t>({0x3C00, 0xC000, 0x0001, 0x7BFF, 0x8000, 0x3555});
    const PointCloud half = good(parse_npy_points, npy("<f2", "(3, 2)", halves));
    CHECK(half.coordinates == Numbers{1, -2, 0x1p-24, 65504, 0, 0.333251953125});
    CHECK(!std::signbit(half.coordinates[4]));
    CHECK(fault(parse_npy_points, npy("<f2", "(1, 2)", raw<std::uint16_t>({0x3C00, 0x7C00}))) ==
          "p: row 1 (byte 130): \"inf\" is not a finite double");
    CHECK(fault(parse_npy_points, npy("<f2", "(1, 2)", raw<std::uint16_t>({0x7E00, 0x3C00}))) ==
          "p: row 1 (byte 128): \"nan\" is not a finite double");
    const std::int64_t most = std::int64_t{1} << 53;
    CHECK(good(parse_npy_points, npy("<i8", "(1, 2)", raw<std::int64_t>({most, -most}))).coordinates ==
          Numbers{0x1p53, -0x1p53});
    const std::string beyond = "an integer beyond 2^53, which a double need not hold; write floats, or subtract a "
                               "common offset";
    CHECK(fault(parse_npy_points, npy("<i8", "(1, 2)", raw<std::int64_t>({1, most + 1}))) ==
          "p: row 1 (byte 136): " + beyond);
    CHECK(fault(parse_npy_points, npy("<i8", "(2, 1)", raw<std::int64_t>({1, -most - 1}))) ==
          "p: row 2 (byte 136): " + beyond);
    CHECK(fault(parse_npy_points, npy(">u8", "(1, 2)", raw<std::uint64_t>({1, UINT64_MAX}, true))) ==
          "p: row 1 (byte 136): " + beyond);
}

TEST_CASE("npy: what is not two axes of real numbers is refused") {
    const std::string two = raw<double>({1, 2});
    CHECK(fault(parse_npy_points, npy("<f8", "(2,)", two)) ==
          "p: an array of 1 axis; points need two: a.reshape(-1, D)");
    CHECK(fault(parse_npy_points, npy("<f8", "(1, 1, 2)", two)) ==
          "p: an array of 3 axes; points need two: a.reshape(-1, D)");
    CHECK(fault(parse_npy_points, npy("<c16", "(1, 2)", two)).find("type") != std::string::npos);
    CHECK(fault(parse_npy_points, npy("|b1", "(1, 2)", "ab")).find("type") != std::string::npos);
    CHECK(fault(parse_npy_points, npy("<f16", "(1, 1)", two)).find("type") != std::string::npos);
    CHECK(fault(parse_npy_points, npy("<f8", "(2, 1)", two)) == "p: 1 column; points have 2 to 6 coordinates");
    CHECK(fault(parse_npy_points, npy("<f8", "(0, 2)", "")) == "p: the array has no rows: no point");
    CHECK(fault(parse_npy_points, npy("<f8", "(2, 2)", raw<double>({1, 2, 3}))) ==
          "p: ends at byte 152, inside row 2 of 2");
    CHECK(fault(parse_npy_points, npy("<f8", "(1, 2)", raw<double>({1, 2, 3}))) ==
          "p: 8 bytes behind the array (byte 144)");
    CHECK(fault(parse_npy_points, npy("<f8", "(99999999999999999, 2)", two)).find("inside row 2") != std::string::npos);
    CHECK(fault(parse_npy_points, "") == "p: not a NumPy array (bytes 0 to 5)");
    CHECK(fault(parse_npy_points, std::string("\x93NUMPY\x01\x00\xff\x00{'descr", 17)).find("ends inside") !=
          std::string::npos);
    CHECK(fault(parse_npy_points,
                npy("<f8", "(2, 2)", raw<double>({1, 2, 3, std::numeric_limits<double>::quiet_NaN()}))) ==
          "p: row 2 (byte 152): \"nan\" is not a finite double");
    CHECK(fault(parse_npy_points, npy("<f4", "(1, 2)", raw<float>({std::numeric_limits<float>::infinity(), 1}))) ==
          "p: row 1 (byte 128): \"inf\" is not a finite double");
}

TEST_CASE("off: three dimensions unless it says otherwise") {
    const PointCloud cloud = good(parse_off_points, "OFF\n# a triangle\n3 1 0\n0 0 0\n1 0 0\n\n0 1 .5\n3 0 1 2\n");
    CHECK(cloud.dim == 3);
    CHECK(cloud.coordinates == Numbers{0, 0, 0, 1, 0, 0, 0, 1, .5});
    CHECK(cloud.lines == Lines{4, 5, 7});
    CHECK(good(parse_off_points, "OFF 1 0 0\n1 2 3\n").coordinates == Numbers{1, 2, 3});
    CHECK(good(parse_off_points, "nOFF\n4\n1 0 0\n1 2 3 4\n").dim == 4);
    CHECK(good(parse_off_points, "nOFF 2 2 0 0\n1 2\n3 4\n").coordinates == Numbers{1, 2, 3, 4});
    CHECK(good(parse_off_points, "COFF\n1 0 0\n1 2 3 255 0 0 255\n").coordinates == Numbers{1, 2, 3});
}

TEST_CASE("off: faults and their lines") {
    CHECK(fault(parse_off_points, "") == "p:1: the input ends without a point");
    CHECK(fault(parse_off_points, "PLY\n").find("p:1: an OFF file starts with OFF, COFF") == 0);
    CHECK(fault(parse_off_points, "4OFF\n").find("is not read), not \"4OFF\"") != std::string::npos);
    CHECK(fault(parse_off_points, "OFF\n") == "p:1: the file ends before its number of vertices");
    CHECK(fault(parse_off_points, "OFF\n0 0 0\n") == "p:2: no vertices: no point");
    CHECK(fault(parse_off_points, "OFF\n-1 0 0\n") == "p:2: the header holds a number that is not a count");
    CHECK(fault(parse_off_points, "OFF\n2 0 0\n1 2 3\n") == "p:3: the file ends after 1 of 2 vertices");
    CHECK(fault(parse_off_points, "OFF\n2 0 0\n1 2 3\n1 2\n") == "p:4: a vertex of 2 numbers where 3 are due");
    CHECK(fault(parse_off_points, "OFF\n2 0 0\n1 2 3\n1 2 3 4\n") == "p:4: a vertex of 4 numbers where 3 are due");
    CHECK(fault(parse_off_points, "OFF\n2 0 0\n1 2 3\n1 2 z\n") == "p:4: \"z\" is not a number");
    CHECK(fault(parse_off_points, "OFF\n1 0 0\n1 2 inf\n") == "p:3: \"inf\" is not a finite double");
    CHECK(fault(parse_off_points, "nOFF 7 1 0 0\n") == "p:1: dimension 7; points have 2 to 6 coordinates");
    CHECK(fault(parse_off_points, "OFF BINARY\n").find("binary") != std::string::npos);
}

namespace {

const std::string ply_head = "ply\nformat ascii 1.0\ncomment hand made\nelement vertex 2\n";

}  // namespace

TEST_CASE("off: the header's counts are held against the file") {
    const std::string two = "0 0 0\n1 0 0\n";
    const std::string counts = "the header speaks of 2 vertices and 1 face";
    CHECK(good(parse_off_points, "OFF\n2 1 0\n" + two + "2 0 1 255 0 0\n# the end\n").rows() == 2);
    CHECK(fault(parse_off_points, "OFF\n2 1 0\n" + two) == "p:4: the file ends after 0 faces; " + counts);
    CHECK(fault(parse_off_points, "OFF\n2 1 0\n" + two + "0 1 0\n2 0 1\n") ==
          "p:5: not a face, a number of vertices and these; a vertex too many? " + counts);
    CHECK(fault(parse_off_points, "OFF\n2 1 0\n" + two + "2 0 1\n2 1 0\n") ==
          "p:6: a line more than the header says: " + counts);
    CHECK(fault(parse_off_points, "OFF\n2 1 0\n" + two + "2 0 2\n") ==
          "p:5: a face with vertex 2; vertices are numbered from 0 to 1");
    CHECK(fault(parse_off_points, "OFF\n2 1 0\n" + two + "2 -1 0\n") ==
          "p:5: a face with vertex -1; vertices are numbered from 0 to 1");
    CHECK(fault(parse_off_points, "OFF\n2 1 0\n" + two + "3 0 1\n").find("p:5: not a face") == 0);
    CHECK(fault(parse_off_points, "OFF\n2 1 0\n" + two + "2 0 x\n") == "p:5: \"x\" is not a number");
    CHECK(fault(parse_off_points, "OFF\n1 0 0\n" + two).find("p:4: a line more than the header says") == 0);
}

TEST_CASE("off: rows with colours, normals and texture coordinates have as many numbers as the keyword says") {
    for (const char* const file :
         {"COFF\n1 0 0\n1 2 3 255 0 0\n", "COFF\n1 0 0\n1 2 3 255 0 0 255\n", "NOFF\n1 0 0\n1 2 3 0 0 1\n",
          "STOFF\n1 0 0\n1 2 3 .5 .5\n", "STCNOFF\n1 0 0\n1 2 3 0 0 1 1 0 0 .5 .5\n"})
        CHECK(good(parse_off_points, file).coordinates == Numbers{1, 2, 3});
    for (const char* const file : {"COFF\n1 0 0\n1 2 3\n", "COFF\n1 0 0\n1 2 3 255 0\n", "STOFF\n1 0 0\n1 2 3 .5\n",
                                   "NOFF\n1 0 0\n1 2 3 0 0\n", "STOFF\n1 0 0\n1 2 3 .5 .5 .5\n"})
        CHECK(fault(parse_off_points, file).find("p:3: a vertex of ") == 0);
}

TEST_CASE("ply: the header's counts are held against the file") {
    const std::string head = ply_head + "property float x\nproperty float y\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string rows = "1 2\n3 4\n";
    CHECK(good(parse_ply_points, head + faces + rows + "2 0 1\n\n").rows() == 2);
    CHECK(fault(parse_ply_points, head + "end_header\n" + rows + "5 6\n") ==
          "p:10: a line behind all elements that the header counts");
    CHECK(fault(parse_ply_points, head + faces + rows + "5 6\n2 0 1\n").find("p:12: ") == 0);
    CHECK(fault(parse_ply_points, head + faces + rows) == "p:11: the file ends after 0 of 1 lines of element face");
    CHECK(fault(parse_ply_points, head + faces + rows + "2 0 2\n") ==
          "p:12: a face with vertex 2; vertices are numbered from 0 to 1");
    CHECK(fault(parse_ply_points, head + faces + rows + "3 0 1\n") ==
          "p:12: a line of element face with 3 numbers where 4 are due");
    CHECK(fault(parse_ply_points, head + faces + rows + "x 0 1\n") == "p:12: \"x\" is not a number");
    CHECK(fault(parse_ply_points, head + faces + rows + "-1 0 1\n") ==
          "p:12: a list that does not begin with its length");
    const std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
                               "property float y\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string point = raw<float>({1, 2}), face = raw<std::uint8_t>({1}) + raw<std::int32_t>({0});
    CHECK(good(parse_ply_points, binary + point + face).rows() == 1);
    CHECK(good(parse_ply_points, binary + point + face + "\n").rows() == 1);
    CHECK(fault(parse_ply_points, binary + point + face + face).find("p: 5 bytes behind all elements") == 0);
    CHECK(fault(parse_ply_points, binary + point).find("inside face 1 of 1") != std::string::npos);
    for (const std::int32_t vertex : {1, -1})
        CHECK(fault(parse_ply_points, binary + point + raw<std::uint8_t>({1}) + raw<std::int32_t>({vertex}))
                  .find("p: face 1 (byte ") == 0);
}

TEST_CASE("ply: ASCII, with and without z, other properties and elements around") {
    const PointCloud cloud =
        good(parse_ply_points, ply_head + "property float x\nproperty float y\nproperty double z\nproperty uchar red\n"
                                          "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                                          "1 2 3 255\n4 5 6 0\n3 0 1 0\n");
    CHECK(cloud.dim == 3);
    CHECK(cloud.coordinates == Numbers{1, 2, 3, 4, 5, 6});
    CHECK(cloud.lines == Lines{12, 13});
    const PointCloud flat =
        good(parse_ply_points, ply_head + "property float y\nproperty float x\nend_header\r\n1 2\n3 4\n");
    CHECK(flat.dim == 2);
    CHECK(flat.coordinates == Numbers{2, 1, 4, 3});
}

TEST_CASE("ply: binary little-endian, lists before the vertices stepped over") {
    const std::string header = "ply\nformat binary_little_endian 1.0\nelement face 2\n"
                               "property list uchar int vertex_indices\nelement vertex 2\nproperty short x\n"
                               "property double y\nproperty uchar flag\nproperty float z\nend_header\n";
    const std::string faces = raw<std::uint8_t>({3}) + raw<std::int32_t>({0, 1, 0}) + raw<std::uint8_t>({0});
    const std::string first = raw<std::int16_t>({-7}) + raw<double>({.5}) + "\x01" + raw<float>({2});
    const std::string second = raw<std::int16_t>({8}) + raw<double>({1e300}) + "\x01" + raw<float>({-3});
    const PointCloud cloud = good(parse_ply_points, header + faces + first + second);
    CHECK(cloud.coordinates == Numbers{-7, .5, 2, 8, 1e300, -3});
    CHECK(cloud.place(1) == "row 2");
    CHECK(fault(parse_ply_points, header + faces + first + second.substr(0, 5)).find("inside vertex 2 of 2") !=
          std::string::npos);
    const std::string nan = raw<std::int16_t>({8}) + raw<double>({NAN}) + "\x01" + raw<float>({-3});
    CHECK(fault(parse_ply_points, header + faces + first + nan).find("p: row 2 (byte ") == 0);
}

TEST_CASE("ply: binary big-endian") {
    const auto turned = [](std::string bytes) { return std::string(bytes.rbegin(), bytes.rend()); };
    const std::string header = "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty short x\n"
                               "property double y\nelement face 1\nproperty list ushort int vertex_indices\n"
                               "end_header\n";
    const std::string vertices = turned(raw<std::int16_t>({-7})) + turned(raw<double>({.5})) +
                                 turned(raw<std::int16_t>({8})) + turned(raw<double>({1e300}));
    const auto face = [&](std::int32_t v) {
        return turned(raw<std::uint16_t>({3})) + turned(raw<std::int32_t>({0, 1, v}));
    };
    CHECK(good(parse_ply_points, header + vertices + face(1)).coordinates == Numbers{-7, .5, 8, 1e300});
    CHECK(fault(parse_ply_points, header + vertices + face(258)).find("a face with vertex 258") != std::string::npos);
}

TEST_CASE("ply: faults and their lines") {
    const std::string xy = "property float x\nproperty float y\n";
    CHECK(fault(parse_ply_points, "") == "p:1: a PLY file starts with a line that says ply");
    CHECK(fault(parse_ply_points, "ply\nformat ascii 1.0\n") == "p:2: the file ends inside its header");
    CHECK(fault(parse_ply_points, "ply\nelement vertex 1\n" + xy + "end_header\n1 2\n") ==
          "p:5: no format line in the header");
    CHECK(fault(parse_ply_points, "ply\nformat binary_middle_endian 1.0\n").find("p:2: format") == 0);
    CHECK(fault(parse_ply_points, ply_head + "property float x\nend_header\n") ==
          "p:6: element vertex has no property x or y");
    CHECK(fault(parse_ply_points, ply_head + "property quad x\n") == "p:5: no such type: \"quad\"");
    CHECK(fault(parse_ply_points, ply_head + "property list uchar int x\nproperty float y\nend_header\n") ==
          "p:7: property x is a list");
    CHECK(fault(parse_ply_points, "ply\nformat ascii 1.0\nelement vertex -3\n") == "p:3: \"-3\" is not a count");
    CHECK(fault(parse_ply_points, "ply\nformat ascii 1.0\nelement vertex 0\n" + xy + "end_header\n") ==
          "p:6: no vertices: no point");
    CHECK(fault(parse_ply_points, ply_head + xy + "end_header\n1 2\n3\n") ==
          "p:9: a vertex of 1 number where 2 are due");
    CHECK(fault(parse_ply_points, ply_head + xy + "end_header\n1 2\n3 nan\n") == "p:9: \"nan\" is not a finite double");
    CHECK(fault(parse_ply_points, ply_head + xy + "end_header\n1 2\n") ==
          "p:8: the file ends after 1 of 2 lines of element vertex");
}

TEST_CASE("node: ids from 0 or 1, attributes and markers left aside") {
    CHECK(good(parse_node_points, "2 2 0 0\n0 1 2\n1 3 4\n").coordinates == Numbers{1, 2, 3, 4});
    const PointCloud cloud = good(parse_node_points, "# c\n2 3 1 1\n1 1 2 3 .5 0\n\n2 4 5 6 .25 1 # last\n");
    CHECK(cloud.dim == 3);
    CHECK(cloud.coordinates == Numbers{1, 2, 3, 4, 5, 6});
    CHECK(cloud.lines == Lines{3, 5});
}

TEST_CASE("node: faults and their lines") {
    CHECK(fault(parse_node_points, "") == "p:1: the input ends without a point");
    CHECK(fault(parse_node_points, "2\n") == "p:1: the header is: count D attributes marker");
    CHECK(fault(parse_node_points, "0 2\n") == "p:1: no vertices: no point");
    CHECK(fault(parse_node_points, "1 9\n") == "p:1: dimension 9; points have 2 to 6 coordinates");
    CHECK(fault(parse_node_points, "2 2\n0 1 2\n") == "p:2: the file ends after 1 of 2 vertices");
    CHECK(fault(parse_node_points, "1 2\n0 1 2\n1 3 4\n") == "p:3: more than the 1 vertex of the header");
    CHECK(fault(parse_node_points, "2 2\n0 1 2\n2 3 4\n") == "p:3: id 2 where 1 is due");
    CHECK(fault(parse_node_points, "2 2\n0 1 2\n1 3\n") == "p:3: 2 numbers where 3 are due");
    CHECK(fault(parse_node_points, "1 2\n0 1 1e999\n") == "p:2: \"1e999\" is not a finite double");
}
