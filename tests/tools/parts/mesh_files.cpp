// Writers of meshes and diagrams, and the readers of `check`.
#include <doctest/doctest.h>

#include <cmath>

#include "tools/io/diagram_file.hpp"
#include "tools/io/mesh_files.hpp"

using namespace netmesh::tool;

namespace {

// Two triangles over the unit square, one Steiner vertex in a corner.
class Square : public MeshSource {
public:
    Square() {
        dim = 2;
        vertex_count = 4;
        cell_count = 2;
    }
    netmesh_vertex vertex(std::uint64_t index) const override {
        static constexpr double xy[4][2] = {{0, 0}, {1, -0.0}, {1, 0.1}, {0, 1e-17}};
        netmesh_vertex vertex = {};
        vertex.coordinates[0] = xy[index][0];
        vertex.coordinates[1] = xy[index][1];
        vertex.marker = index == 3 ? 1 : 0;
        vertex.value = 0.25 * static_cast<double>(index);
        return vertex;
    }
    netmesh_cell cell(std::uint64_t index) const override {
        static constexpr std::uint32_t corners[2][3] = {{0, 1, 2}, {0, 2, 3}};
        netmesh_cell cell = {};
        for (int k = 0; k < 3; k++) {
            cell.vertices[k] = corners[index][k];
            cell.neighbours[k] = NETMESH_NONE;
        }
        cell.neighbours[index == 0 ? 1 : 2] = index == 0 ? 1 : 0;
        return cell;
    }
};

std::string text_of(void (*write)(const MeshSource&, TextWriter&), const MeshSource& mesh) {
    TextWriter out;
    write(mesh, out);
    return out.text();
}

}  // namespace

TEST_CASE("node, ele and neigh of a triangulation") {
    const Square square;
    CHECK(text_of(write_node, square) == "4 2 0 1\n0 0 0 0\n1 1 0 0\n2 1 0.1 0\n3 0 1e-17 1\n");
    CHECK(text_of(write_ele, square) == "2 3 0\n0 0 1 2\n1 0 2 3\n");
    CHECK(text_of(write_neigh, square) == "2 3\n0 -1 1 -1\n1 -1 -1 0\n");
}

TEST_CASE("node of a mesh: domain, tau and filter values") {
    Square square;
    square.tau = 2.5;
    square.eps = 0.25;
    square.size_at_inputs = 0.5;
    square.net_spacing = 2;
    square.domain[0] = .5;
    square.domain[2] = 1;
    square.has_values = true;
    CHECK(text_of(write_node, square) == "# domain 0.5 0 1\n# tau 2.5\n# eps 0.25\n# cell-size 0.5 0\n"
                                         "# boundary-net 2\n"
                                         "4 2 1 1\n0 0 0 0 0\n1 1 0 0.25 0\n2 1 0.1 0.5 0\n3 0 1e-17 0.75 1\n");
    NodeFile node;
    REQUIRE(parse_node(text_of(write_node, square), &node).good());
    CHECK(node.tau == 2.5);
    CHECK(node.eps == 0.25);
    CHECK(node.size_at_inputs == 0.5);
    CHECK(node.size_growth == 0);
    CHECK(node.net_spacing == 2);
    CHECK(node.domain == std::vector<double>{.5, 0, 1});
    CHECK(node.attributes == std::vector<double>{0, .25, .5, .75});
    CHECK(node.markers == std::vector<std::uint8_t>{0, 0, 0, 1});
    CHECK(node.first_id == 0);
}

TEST_CASE("node of a mesh of clipped cells") {
    Square square;
    square.ratio = 2.25;
    square.clipped = true;
    CHECK(text_of(write_node, square).rfind("4 2 0 1\n", 0) == 0);  // without a domain there is no mesh
    square.domain[2] = 1;
    const std::string text = text_of(write_node, square);
    CHECK(text.rfind("# domain 0 0 1\n# ratio 2.25\n# clipped\n4 2 0 1\n", 0) == 0);
    NodeFile node;
    REQUIRE(parse_node(text, &node).good());
    CHECK(node.clipped);
    square.clipped = false;
    NodeFile whole;
    REQUIRE(parse_node(text_of(write_node, square), &whole).good());
    CHECK(!whole.clipped);
    square.clipped = true;
    square.ratio = 0;
    square.tau = 2.5;
    CHECK(text_of(write_node, square).find("clipped") == std::string::npos);
}

TEST_CASE("clipped stands alone, once, behind a domain and a ratio") {
    const struct {
        const char* head;
        const char* where;
    } faults[] = {{"# domain 0 0 1\n# ratio 2.25\n# clipped 1\n", "m.node:3: clipped is a word alone"},
                  {"# domain 0 0 1\n# ratio 2.25\n# clipped\n# clipped\n", "m.node:4: clipped is said twice"},
                  {"# domain 0 0 1\n# clipped\n# ratio 2.25\n", "m.node:2: clipped stands behind"},
                  {"# domain 0 0 1\n# tau 2.5\n# clipped\n", "m.node:3: clipped stands behind"},
                  {"# ratio 2.25\n# clipped\n# domain 0 0 1\n", "m.node:2: clipped stands behind"},
                  {"# clipped\n", "m.node:1: clipped stands behind"}};
    for (const auto& fault : faults) {
        NodeFile node;
        node.cloud.name = "m.node";
        const Outcome outcome = parse_node(std::string(fault.head) + "1 2 0 1\n0 0 0 0\n", &node);
        CAPTURE(outcome.message);
        CHECK(outcome.exit == Exit::data);
        CHECK(outcome.message.find(fault.where) == 0);
    }
}

TEST_CASE("cages in a node file and in fields of a vtu") {
    Square square;
    square.domain[2] = 1;
    square.tau = 3;
    constexpr std::uint32_t bytes = sizeof(netmesh_cage);
    square.cages = {{bytes, 2, NETMESH_NONE, 0.125}, {bytes, 1, 0, 1e-3}};
    const std::string text = text_of(write_node, square);
    CHECK(text.find("# tau 3\n# cage 2 0.125\n# cage 1 0.001\n4 2 0 1\n") != std::string::npos);
    NodeFile node;
    REQUIRE(parse_node(text, &node).good());
    REQUIRE(node.cages.size() == 2);
    CHECK(node.cages[0].centre == 2);
    CHECK(node.cages[1].radius == 1e-3);
    for (const char* remark : {"# cage 1", "# cage 9 1", "# cage 1 0", "# cage -1 1", "# cage 0.5 1", "# cage x 1"}) {
        NodeFile other;
        const Outcome outcome = parse_node("# domain 0 0 1\n" + std::string(remark) + "\n1 2 0 1\n0 0 0 0\n", &other);
        CHECK(outcome.exit == Exit::data);
    }
    CHECK(!node.has_thesis_cages);
    square.has_thesis_cages = true;
    const std::string thesis = text_of(write_node, square);
    CHECK(thesis.find("# tau 3\n# cages thesis\n# cage 2 0.125\n") != std::string::npos);
    REQUIRE(parse_node(thesis, &node).good());
    CHECK(node.has_thesis_cages);
    for (const char* remark : {"# cages", "# cages large", "# cages thesis 2"}) {
        NodeFile other;
        CHECK(parse_node("# domain 0 0 1\n" + std::string(remark) + "\n1 2 0 1\n0 0 0 0\n", &other).exit == Exit::data);
    }
    square.ratios = {2.5, 1.5, 0, 2};
    square.domains = {NETMESH_NONE, 1, 0, 1};
    const std::string vtu = text_of(write_vtu, square);
    CHECK(vtu.find("\n2.5\n1.5\n0\n2\n") != std::string::npos);
    CHECK(vtu.find("\n-1\n1\n0\n1\n") != std::string::npos);
}

TEST_CASE("off and vtu") {
    const Square square;
    CHECK(text_of(write_off, square) == "nOFF\n2\n4 2 0\n0 0\n1 0\n1 0.1\n0 1e-17\n3 0 1 2\n3 0 2 3\n");
    const std::string vtu = text_of(write_vtu, square);
    CHECK(vtu.find("NumberOfPoints=\"4\" NumberOfCells=\"2\"") != std::string::npos);
    CHECK(vtu.find("1 0.1 0\n") != std::string::npos);
    CHECK(vtu.find("\n0 1 2\n0 2 3\n") != std::string::npos);
    CHECK(vtu.find("\n3\n6\n") != std::string::npos);
    CHECK(vtu.find("\n5\n5\n") != std::string::npos);
    CHECK(vtu.find("Name=\"marker\"") != std::string::npos);
    CHECK(vtu.find("Name=\"value\"") == std::string::npos);
    PointCloud cloud;
    REQUIRE(parse_off_points(text_of(write_off, square), &cloud).good());
    CHECK(cloud.coordinates == std::vector<double>{0, 0, 1, 0, 1, .1, 0, 1e-17});
}

TEST_CASE("remarks that cannot be are faults with a line") {
    for (const char* remark : {"# domain 1 2", "# domain 1 2 0", "# domain 1 2 x", "# domain 1 2 3 4", "# tau 2",
                               "# eps 0", "# eps 1 2", "# cell-size 1", "# cell-size 0 1", "# cell-size 1 -1",
                               "# cell-size 1 2 3", "# boundary-net 0", "# boundary-net 9", "# boundary-net 1 1"}) {
        NodeFile node;
        node.cloud.name = "m.node";
        CAPTURE(remark);
        const Outcome outcome = parse_node(std::string("1 2\n") + remark + "\n0 1 1\n", &node);
        CHECK(outcome.exit == Exit::data);
        CHECK(outcome.message.find(std::string("# domain 1 2 3 4") == remark ? "m.node:3: " : "m.node:2: ") == 0);
    }
}

TEST_CASE("ele and neigh are read back") {
    const Square square;
    CellTable cells, neighbours;
    cells.columns = neighbours.columns = 3;
    REQUIRE(parse_cell_table(text_of(write_ele, square), {0, 4, false}, &cells).good());
    CHECK(cells.entries == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
    REQUIRE(parse_cell_table(text_of(write_neigh, square), {0, 2, true}, &neighbours).good());
    CHECK(neighbours.entries ==
          std::vector<std::uint32_t>{NETMESH_NONE, 1, NETMESH_NONE, NETMESH_NONE, NETMESH_NONE, 0});
    CellTable from_one;
    from_one.columns = 3;
    REQUIRE(parse_cell_table("1 3 1\n1 1 2 3 7\n", {1, 3, false}, &from_one).good());
    CHECK(from_one.entries == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("ele and neigh: faults and their lines") {
    const auto fault = [](const std::string& content, bool outside) {
        CellTable table;
        table.name = "m.ele";
        table.columns = 3;
        const Outcome outcome = parse_cell_table(content, {0, outside ? 1u : 4u, outside}, &table);
        CHECK(outcome.exit == Exit::data);
        return outcome.message;
    };
    CHECK(fault("", false) == "m.ele:1: the file ends after 0 of 0 rows");
    CHECK(fault("1 4 0\n0 0 1 2 3\n", false) == "m.ele:1: the header is: count 3");
    CHECK(fault("1 3 0\n0 0 1 4\n", false) == "m.ele:2: index 4 does not exist");
    CHECK(fault("1 3 0\n0 0 1 -1\n", false) == "m.ele:2: index -1 does not exist");
    CHECK(fault("1 3 0\n0 0 1 1.5\n", false) == "m.ele:2: index 1.5 does not exist");
    CHECK(fault("1 3 0\n1 0 1 2\n", false) == "m.ele:2: id 1 where 0 is due");
    CHECK(fault("1 3 0\n0 0 1\n", false) == "m.ele:2: 3 numbers where 4 are due");
    CHECK(fault("1 3 0\n0 0 1 2\n1 0 1 2\n", false) == "m.ele:3: more than the 1 row of the header");
    CHECK(fault("2 3 0\n0 0 1 2\n", false) == "m.ele:2: the file ends after 1 of 2 rows");
    CHECK(fault("2 3\n0 -1 -1 -1\n", true) == "m.ele:1: not as many rows as there are cells");
}

TEST_CASE("diagrams: shortest digits, and back") {
    const std::vector<Bar> bars = {{0, 0, HUGE_VAL}, {0, 0, 0.1}, {1, 1.0 / 3, 1e22}, {2, 5e-324, 0.5}};
    TextWriter out;
    write_diagram(bars, {}, out);
    CHECK(out.text() == "0 0 inf\n0 0 0.1\n1 0.3333333333333333 1e+22\n2 5e-324 0.5\n");
    std::vector<Bar> read;
    std::vector<std::uint64_t> lines;
    REQUIRE(parse_diagram("# bars\n\n" + out.text(), "d.pers", &read, &lines).good());
    CHECK(read == bars);
    CHECK(lines == std::vector<std::uint64_t>{3, 4, 5, 6});
}

TEST_CASE("diagrams: faults and their lines") {
    const auto fault = [](const std::string& content) {
        std::vector<Bar> bars;
        const Outcome outcome = parse_diagram(content, "d.pers", &bars);
        CHECK(outcome.exit == Exit::data);
        return outcome.message.substr(0, outcome.message.find(": "));
    };
    CHECK(fault("0 0 inf\n0 1\n") == "d.pers:2");
    CHECK(fault("0 0 inf 3\n") == "d.pers:1");
    CHECK(fault("# a\n-1 0 1\n") == "d.pers:2");
    CHECK(fault("x 0 1\n") == "d.pers:1");
    CHECK(fault("0 -1 -2\n") == "d.pers:1");
    CHECK(fault("0 inf inf\n") == "d.pers:1");
    CHECK(fault("0 nan 1\n") == "d.pers:1");
    CHECK(fault("0 2 1\n") == "d.pers:1");
    CHECK(fault("0 0 1e999\n") == "d.pers:1");
}
