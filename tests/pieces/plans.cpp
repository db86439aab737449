// What is planned for leaves and joins: enough, and not much more than enough.
#include <doctest/doctest.h>

#include "pieces/in_memory.hpp"

namespace {

std::size_t join_bytes(const pieces::Bytes& bytes) {
    netmesh_piece_info info = {};
    info.struct_bytes = sizeof info;
    const netmesh_piece piece = bytes.piece();
    REQUIRE(netmesh_read_piece(&piece, &info) == NETMESH_OK);
    return static_cast<std::size_t>(info.join_bytes);
}

}  // namespace

TEST_CASE("leaves and joins of uniform points fit blocks as planned, which are at most 2.2 times what they take") {
    struct Case {
        int dim;
        std::size_t n;
        std::uint32_t pieces;
    };
    for (const Case& c : {Case{2, 40000, 8}, Case{2, 4000, 4}, Case{3, 20000, 4}, Case{3, 8000, 8}, Case{4, 1000, 2},
                          Case{4, 3000, 8}, Case{5, 300, 2}}) {
        CAPTURE(c.dim);
        CAPTURE(c.n);
        const inputs::Points points = inputs::uniform(c.dim, c.n, 21);
        const pieces::Split split(c.dim, points, c.pieces);
        pieces::Options options;
        options.pieces = c.pieces;
        std::map<std::uint32_t, pieces::Bytes> all;
        const std::size_t plan = netmesh_plan_leaf(static_cast<std::uint32_t>(c.dim), c.n, c.pieces);
        double most = 0, most_of_joins = 0;
        for (std::uint32_t node = 2 * c.pieces - 1; node > 0; --node) {
            const bool is_leaf = node >= c.pieces;
            const std::size_t block = is_leaf ? plan : join_bytes(all[2 * node]) + join_bytes(all[2 * node + 1]);
            Session session(c.dim);
            session.reserve(block);
            REQUIRE((is_leaf ? make_leaf(session, split.source, options, node, &all[node])
                             : make_join(session, all[2 * node], all[2 * node + 1], &all[node])) == NETMESH_OK);
            const netmesh_memory_report memory = session.report().memory;
            CHECK(memory.block_bytes < block + 16);  // it did not have to grow
            double& share = is_leaf ? most : most_of_joins;
            share = std::max(share, static_cast<double>(memory.peak_bytes) / static_cast<double>(block));
        }
        MESSAGE("D = " << c.dim << ": leaves " << most << ", joins " << most_of_joins);
        CHECK(most > 1 / 2.2);
        CHECK(most_of_joins > 1 / 2.2);
    }
    CHECK(netmesh_plan_leaf(7, 100, 4) == 0);
    CHECK(netmesh_plan_leaf(3, 100, 3) == 0);
    CHECK(netmesh_plan_leaf(3, 3, 4) == 0);
    CHECK(netmesh_plan_leaf(3, UINT64_MAX, 1) == SIZE_MAX);
}
