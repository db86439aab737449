// Heads of diagrams that this program does not read: of earlier and of later versions.
#include <doctest/doctest.h>

#include "tools/io/diagram_file.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/provenance.hpp"

using namespace netmesh::tool;

namespace {

std::string head_with(const std::string& version, const std::string& more = "") {
    return "# netmesh diagram 1: degree birth death\n# version " + version +
           "\n# filter alpha\n# max-degree 1\n# dim 2\n# points 3\n# duplicates 0\n# input 0123456789abcdef\n"
           "# certified-ratio 1\n" +
           more + "# reference closed offsets of the points in R^2\n0 0 inf\n";
}

Outcome read(const std::string& text) {
    std::optional<Provenance> head;
    return parse_head(text, "d.pers", &head);
}

}  // namespace

TEST_CASE("heads: files whose births and deaths were not rounded to nearest are told, with the remedy") {
    for (const std::string version : {"0.2.0", "0.1.0"}) {
        const Outcome outcome = read(head_with(version, "# value-error 8.6e-12\n"));
        CHECK(outcome.exit == Exit::data);
        CHECK(outcome.line == 10);
        CHECK(outcome.message.find("this file was made by netmesh 0.2.0 or before, whose births and deaths were not "
                                   "rounded to nearest; make the diagram again") != std::string::npos);
    }
    CHECK(read(head_with(netmesh_version_text())).message == "");
}

TEST_CASE("heads: a version is three numbers, and none that is still to come") {
    for (const char* version : {"0.1.0", "0.1.99", "0.0.0"}) CHECK(read(head_with(version)).message == "");
    for (const char* version : {"", "x", "1", "0.2", "0.2.", "0.2.0.", "0.2.0.1", "0.2.0 ", "0.2.-1", "0..0", ".2.0",
                                "0.2.0x", "00000.2.0", "0x0.2.0", "0,2,0", "the same as yours"}) {
        CAPTURE(version);
        const Outcome outcome = read(head_with(version));
        const bool is_cut = std::string(version) == "0.2.0 ";  // blanks at the end of a line say nothing
        CHECK((outcome.message.find("not a version") != std::string::npos) == !is_cut);
        CHECK(outcome.exit == (is_cut ? Exit::done : Exit::data));
    }
    for (const char* version : {"9999.0.0", "0.9999.0", "1000.2.0"}) {
        CAPTURE(version);
        const Outcome outcome = read(head_with(version));
        CHECK(outcome.exit == Exit::data);
        CHECK(outcome.line == 2);
        CHECK(outcome.message.find("made by a later version than this program") != std::string::npos);
    }
}

TEST_CASE("bounds of bars: the word of version 0.2.0 is read as that of now") {
    const std::string now =
        "# scale 0 low 0 high 1 reach 2 ratio 2\n1 0.5 2 # birth 0.4 0.6 death 1 3 exists\n1 0.5 0.6 # "
        "birth 0.4 0.6 death 0.5 0.7\n";
    std::string old = now;
    old.replace(old.find("exists"), 6, "real");
    const std::vector<BoundLine> first = bound_lines(now), second = bound_lines(old);
    REQUIRE(first.size() == 3);
    REQUIRE(second.size() == 3);
    for (std::size_t i = 0; i < 3; i++) CHECK(first[i].text == second[i].text);
    CHECK(first[1].text == "1 0.5 2 # birth 0.4 0.6 death 1 3 exists");
}
