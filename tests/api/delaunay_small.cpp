// Few points in the plane, kept in short words: cells, vertices and report of netmesh_method_delaunay, and nothing
// else.
#include <doctest/doctest.h>

#include <cstring>

#include "common/dimensions.hpp"
#include "common/session.hpp"
#include "exact/families.hpp"

namespace {

netmesh::Request small_request(const Session& s, const inputs::Points& points) {
    netmesh::Request r = s.delaunay_request(points);
    r.mesh.method = &netmesh_method_delaunay_small;
    return r;
}

template <class Item, class Get> void expect_same_items(const Session& a, const Session& b, Get get) {
    for (std::uint64_t i = 0;; ++i) {
        Item of_a = {}, of_b = {};
        of_a.struct_bytes = of_b.struct_bytes = sizeof(Item);
        const netmesh_status status = get(a.context, i, &of_a);
        REQUIRE(status == get(b.context, i, &of_b));
        if (status != NETMESH_OK) return;
        CHECK(std::memcmp(&of_a, &of_b, sizeof(Item)) == 0);
    }
}

// False: flat, which both say.
bool expect_same(const inputs::Points& points) {
    INFO("points: " << points.size() / 2);
    Session few(2), any(2);
    few.reserve(std::size_t{1} << 24);
    any.reserve(std::size_t{1} << 24);
    const netmesh::Request of_few = small_request(few, points), of_any = any.delaunay_request(points);
    const netmesh_status status = netmesh_mesh(few.context, &of_few);
    REQUIRE(status == netmesh_mesh(any.context, &of_any));
    if (status != NETMESH_OK) return false;
    netmesh_report a = few.report(), b = any.report();
    const std::size_t peak = a.memory.peak_bytes;
    CHECK(peak <= b.memory.peak_bytes);
    a.memory = b.memory;
    CHECK(std::memcmp(&a, &b, sizeof a) == 0);
    expect_same_items<netmesh_cell>(few, any, netmesh_get_cell);
    expect_same_items<netmesh_vertex>(few, any, netmesh_get_vertex);
    few.reserve(peak);
    CHECK(netmesh_mesh(few.context, &of_few) == NETMESH_OK);
    few.reserve(peak - 16);
    CHECK(netmesh_mesh(few.context, &of_few) == NETMESH_OUT_OF_MEMORY);
    CHECK(few.report().input.present == 0);
    return true;
}

}  // namespace

TEST_CASE("few points in the plane: the same cells, vertices and report") {
    families::Random random(5);
    int made = 0;
    for (const families::Family& family : families::all())
        for (const std::size_t n : {3, 4, 7, 20, 60}) {
            INFO(family.name);
            made += expect_same(family.make(random, 2, n));
        }
    CHECK(made > 100);
    CHECK(expect_same(inputs::uniform(2, 8192)));
    CHECK(expect_same(inputs::grid(2, 30)));
    CHECK(expect_same(inputs::repeated(2, inputs::uniform(2, 100), 3)));
    CHECK_FALSE(expect_same({0, 0, 1, 1, 2, 2}));
}

TEST_CASE("few points in the plane: no other call reads them") {
    Session s(2);
    s.reserve(std::size_t{1} << 22);
    const inputs::Points points = inputs::uniform(2, 30);
    netmesh::Request r = small_request(s, points);
    REQUIRE(netmesh_mesh(s.context, &r) == NETMESH_OK);
    CHECK(s.persist(&netmesh_filter_alpha) == NETMESH_NO_RESULT);
    CHECK(s.persist(&netmesh_filter_complete) == NETMESH_NO_RESULT);
    CHECK(s.check() == NETMESH_NO_RESULT);
    REQUIRE(netmesh_mesh(s.context, &r) == NETMESH_OK);
    r.filter = &netmesh_filter_alpha;
    CHECK(netmesh_persist(s.context, &r) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_METHOD);
    r = small_request(s, inputs::uniform(2, 8193));
    const inputs::Points many = inputs::uniform(2, 8193);
    r.points.coordinates = many.data();
    CHECK(netmesh_mesh(s.context, &r) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_POINTS);
    // Another triangulation takes its place.
    REQUIRE(s.delaunay(points) == NETMESH_OK);
    CHECK(s.persist(&netmesh_filter_alpha) == NETMESH_OK);
    for (const int dim : dimensions()) {
        if (dim == 2) continue;
        Session other(dim);
        const inputs::Points there = inputs::uniform(dim, 10);
        const netmesh::Request of_other = small_request(other, there);
        CHECK(netmesh_mesh(other.context, &of_other) == NETMESH_INVALID_ARGUMENT);
        CHECK(other.detail().field == NETMESH_FIELD_DIM);
    }
}

TEST_CASE("few points in the plane: stopping leaves nothing") {
    Session s(2);
    s.reserve(std::size_t{1} << 22);
    const inputs::Points points = inputs::uniform(2, 400);
    struct Count {
        int left;
        static int poll(void* user, const netmesh_progress*) { return --static_cast<Count*>(user)->left < 0; }
    };
    int stopped = 0;
    for (int polls = 0; polls < 50; ++polls) {
        Count count = {polls};
        netmesh::Request r = small_request(s, points);
        r.monitor = {&Count::poll, &count};
        const netmesh_status status = netmesh_mesh(s.context, &r);
        if (status == NETMESH_OK) break;
        CHECK(status == NETMESH_CANCELLED);
        CHECK(s.report().input.present == 0);
        ++stopped;
    }
    CHECK(stopped > 0);
}
