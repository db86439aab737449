// Structs larger than the library's, as of a later version, and the sizes of structs in general. Smaller ones: see
// tests/embedding/versions.c.
#include <doctest/doctest.h>

#include <cstring>

#include "common/session.hpp"

namespace {

template <class Struct> struct Later {
    Struct known;
    unsigned char unknown[48];
};

// A later version's struct, its unknown members set to `fill`.
template <class Struct> Later<Struct> later(const Struct& known, unsigned char fill) {
    Later<Struct> made;
    std::memset(&made, 0, sizeof made);
    made.known = known;
    std::memset(made.unknown, fill, sizeof made.unknown);
    made.known.struct_bytes = sizeof made;
    return made;
}

template <class Struct> bool is_zero_beyond(const Later<Struct>& filled) {
    for (const unsigned char byte : filled.unknown)
        if (byte != 0) return false;
    return true;
}

}  // namespace

TEST_CASE("requests of a later version are taken when they ask for nothing new") {
    Session s(2);
    const inputs::Points points = inputs::uniform(2, 20);
    REQUIRE(s.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
    const std::uint64_t print = s.report().fingerprint;
    const netmesh_request known = s.mesh_request(points, &netmesh_filter_complete);
    Later<netmesh_request> same = later(known, 0), more = later(known, 0);
    more.unknown[47] = 1;
    CHECK(netmesh_mesh(s.context, &more.known) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_STRUCT_BYTES);
    CHECK(netmesh_persist(s.context, &more.known) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_STRUCT_BYTES);
    auto detail = netmesh::sized<netmesh_detail>();
    netmesh::Request settled;
    CHECK(netmesh_settle(&more.known, &settled, &detail) == NETMESH_INVALID_ARGUMENT);
    CHECK(detail.field == NETMESH_FIELD_STRUCT_BYTES);
    CHECK(netmesh_plan_mesh(&more.known) == 0);
    CHECK(netmesh_plan(&more.known) == 0);
    CHECK(s.report().fingerprint == print);
    CHECK(netmesh_mesh(s.context, &same.known) == NETMESH_OK);
    CHECK(netmesh_plan_mesh(&same.known) == netmesh_plan_mesh(&known));
    CHECK(netmesh_plan(&same.known) == netmesh_plan(&known));
    CHECK(s.report().fingerprint == print);
}

TEST_CASE("results in structs of a later version are 0 where nothing is known") {
    Session s(2);
    REQUIRE(s.mesh_and_persist(inputs::uniform(2, 20)) == NETMESH_OK);
    Later<netmesh_report> report = later(netmesh_report{}, 0xAA);
    REQUIRE(netmesh_get_report(s.context, &report.known) == NETMESH_OK);
    CHECK(report.known.struct_bytes == sizeof report);
    CHECK(report.known.fingerprint == s.report().fingerprint);
    CHECK(is_zero_beyond(report));
    Later<netmesh_pair> pair = later(netmesh_pair{}, 0xAA);
    REQUIRE(netmesh_get_pair(s.context, 0, &pair.known) == NETMESH_OK);
    CHECK(pair.known.death == s.pairs()[0].death);
    CHECK(is_zero_beyond(pair));
}

TEST_CASE("a request is settled in as many bytes as are told and no more") {
    const inputs::Points points = inputs::uniform(2, 20);
    const netmesh_request open = on(points, Calls(2).plain(&netmesh_filter_complete));
    CHECK(open.struct_bytes == sizeof open);
    Later<netmesh_request> made = later(netmesh_request{}, 0xAA);
    REQUIRE(netmesh_settle(&open, &made.known, nullptr) == NETMESH_OK);
    CHECK(made.known.struct_bytes == sizeof made);
    CHECK(made.known.seed == 1);
    CHECK(made.known.max_degree == 1);
    CHECK(is_zero_beyond(made));
    unsigned char bytes[16];
    std::memset(bytes, 0xAA, sizeof bytes);
    const std::uint32_t room = 8;
    std::memcpy(bytes, &room, sizeof room);
    REQUIRE(netmesh_settle(&open, reinterpret_cast<netmesh_request*>(bytes), nullptr) == NETMESH_OK);
    std::uint32_t head[2];
    std::memcpy(head, bytes, sizeof head);
    CHECK(head[0] == 8);
    CHECK(head[1] == 1);
    for (int i = 8; i < 16; ++i) CHECK(bytes[i] == 0xAA);
}
