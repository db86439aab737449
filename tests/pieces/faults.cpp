// What is refused, what is damaged, what runs out of memory or is stopped.
#include <doctest/doctest.h>

#include "pieces/in_memory.hpp"

namespace {

// A job of four pieces, all of them made.
struct Made {
    pieces::Options options;
    inputs::Points points;
    pieces::Split split;
    std::map<std::uint32_t, pieces::Bytes> all;

    explicit Made(std::uint64_t seed = 3, std::uint32_t count = 4, std::size_t n = 300)
        : points(inputs::uniform(3, n, seed)), split(3, points, count) {
        options.pieces = count;
        Session session(3);
        REQUIRE(pieces::run(session, split.source, options, &all) == NETMESH_OK);
    }
};

netmesh_detail detail_of(Session& session) {
    netmesh_detail detail = {};
    detail.struct_bytes = sizeof detail;
    netmesh_get_detail(session.context, &detail);
    return detail;
}

}  // namespace

TEST_CASE("any order of tasks, and tasks run twice, give the same bytes") {
    const Made made;
    std::map<std::uint32_t, pieces::Bytes> again;
    Session session(3);
    pieces::Options options = made.options;
    options.order = 5;
    REQUIRE(pieces::run(session, made.split.source, options, &again) == NETMESH_OK);
    for (const auto& [node, bytes] : made.all) CHECK(bytes == again[node]);
}

TEST_CASE("a piece that is cut off or has a bit flipped is refused by name, never read") {
    const Made made;
    Session session(3);
    inputs::Random random(9);
    pieces::Bytes out;
    int flipped = 0;
    for (int trial = 0; trial < 10000; ++trial) {
        const std::uint32_t node = trial % 2 == 0 ? 4 : 5;
        pieces::Bytes bad = made.all.at(node);
        const std::size_t changed = random.below(bad.count());
        if (trial % 10 == 0) {
            bad = pieces::Bytes(bad.data(), changed);
        } else {
            bad.data()[changed] ^= static_cast<unsigned char>(1u << random.below(8));
        }
        const netmesh_status status =
            make_join(session, node == 4 ? bad : made.all.at(4), node == 5 ? bad : made.all.at(5), &out);
        const netmesh_detail said = detail_of(session);
        flipped += status == NETMESH_INVALID_ARGUMENT &&
                   said.field == (node == 4 ? NETMESH_FIELD_ONE : NETMESH_FIELD_OTHER) && said.message[0] != '\0';
        netmesh_piece_info info = {};
        info.struct_bytes = sizeof info;
        const netmesh_piece piece = bad.piece();
        if (netmesh_read_piece(&piece, &info) == NETMESH_OK && changed < info.head_bytes)
            FAIL("a damaged head is read");
        info.look_at_all = 1;
        if (netmesh_read_piece(&piece, &info) == NETMESH_OK) FAIL("a damaged piece is read");
    }
    CHECK(flipped == 10000);
}

TEST_CASE("heads are enough to collect, and are refused where anything in them has changed") {
    const Made made;
    Session session(3);
    REQUIRE(pieces::collect(session, made.all) == NETMESH_OK);
    const std::uint64_t fingerprint = session.report().fingerprint;
    std::map<std::uint32_t, pieces::Bytes> heads;
    for (auto& [node, bytes] : made.all) {
        netmesh_piece_info info = {};
        info.struct_bytes = sizeof info;
        netmesh_piece piece = bytes.piece();
        REQUIRE(netmesh_read_piece(&piece, &info) == NETMESH_OK);
        REQUIRE(info.head_bytes <= piece.count);
        piece.count = static_cast<std::size_t>(info.head_bytes);
        heads[node] = pieces::Bytes(piece.bytes, piece.count);
        CHECK(netmesh_read_piece(&piece, &info) == NETMESH_OK);
    }
    CHECK(pieces::collect(session, heads) == NETMESH_OK);
    CHECK(session.report().fingerprint == fingerprint);
    pieces::Bytes out;
    CHECK(make_join(session, heads.at(4), made.all.at(5), &out) == NETMESH_INVALID_ARGUMENT);
    CHECK(std::string(detail_of(session).message) == "the piece is cut off: its head is there alone");
    inputs::Random random(10);
    for (int trial = 0; trial < 1000; ++trial) {
        std::map<std::uint32_t, pieces::Bytes> all = heads;
        pieces::Bytes& bad = all[6];
        if (trial % 10 == 0)
            bad = pieces::Bytes(bad.data(), 1 + random.below(bad.count() - 1));
        else
            bad.data()[random.below(bad.count())] ^= static_cast<unsigned char>(1u << random.below(8));
        if (pieces::collect(session, all) != NETMESH_INVALID_ARGUMENT || detail_of(session).index_a != 5 ||
            detail_of(session).field != NETMESH_FIELD_PIECES)
            FAIL("a damaged head is collected");
    }
}

TEST_CASE("pieces are collected one after the other where they are opened") {
    const Made made;
    Session session(3);
    REQUIRE(pieces::collect(session, made.all) == NETMESH_OK);
    const std::uint64_t fingerprint = session.report().fingerprint;
    struct Opened {
        const Made& made;
        std::size_t next = 0, fails_at = SIZE_MAX;
        pieces::Bytes one;  // what was there before is gone
        static netmesh_status open(void* self, std::size_t i, netmesh_piece* piece) {
            Opened& o = *static_cast<Opened*>(self);
            if (i != o.next++ % o.made.all.size()) return NETMESH_INTERNAL;
            if (o.next > 2 * o.made.all.size()) return NETMESH_INTERNAL;
            if (i == o.fails_at) return NETMESH_CHECK_FAILED;
            o.one = o.made.all.at(static_cast<std::uint32_t>(i + 1));
            *piece = o.one.piece();
            return NETMESH_OK;
        }
    };
    for (const std::size_t fails_at : {SIZE_MAX, std::size_t{0}, std::size_t{4}}) {
        Opened opened{made, 0, fails_at, {}};
        netmesh_collect_request r = {};
        r.struct_bytes = sizeof r;
        r.open = Opened::open;
        r.user = &opened;
        r.count = made.all.size();
        CHECK(netmesh_collect(session.context, &r) == (fails_at == SIZE_MAX ? NETMESH_OK : NETMESH_CHECK_FAILED));
        if (fails_at == SIZE_MAX) CHECK(session.report().fingerprint == fingerprint);
    }
}

TEST_CASE("pieces that do not go together are refused") {
    const Made made, other(4), more(3, 8);
    Session session(3);
    pieces::Bytes out;
    const auto refused = [&](const pieces::Bytes& a, const pieces::Bytes& b) {
        const netmesh_status status = make_join(session, a, b, &out);
        return status == NETMESH_INVALID_ARGUMENT ? std::string(detail_of(session).message) : "accepted";
    };
    CHECK(refused(made.all.at(4), other.all.at(5)) == "the pieces are of different jobs");
    CHECK(refused(made.all.at(4), more.all.at(9)) == "the pieces are of different jobs");
    CHECK(refused(made.all.at(4), made.all.at(4)) == "the pieces are not those of neighbours: nodes 2 n and 2 n + 1");
    CHECK(refused(made.all.at(5), made.all.at(6)) == "the pieces are not those of neighbours: nodes 2 n and 2 n + 1");
    CHECK(refused(made.all.at(1), made.all.at(1)) == "the pieces are not those of neighbours: nodes 2 n and 2 n + 1");
    std::map<std::uint32_t, pieces::Bytes> all = made.all;
    all.erase(5);
    CHECK(pieces::collect(session, all) == NETMESH_INVALID_ARGUMENT);
    CHECK(std::string(detail_of(session).message) == "pieces of some nodes are missing");
    all[5] = made.all.at(4);
    CHECK(pieces::collect(session, all) == NETMESH_INVALID_ARGUMENT);
    all[5] = other.all.at(5);
    CHECK(pieces::collect(session, all) == NETMESH_INVALID_ARGUMENT);
}

TEST_CASE("requests are refused by their field") {
    const Made made;
    Session session(3);
    netmesh_leaf_request r = {};
    r.struct_bytes = sizeof r;
    const auto field = [&] {
        CHECK(netmesh_leaf(session.context, &r) == NETMESH_INVALID_ARGUMENT);
        return detail_of(session).field;
    };
    CHECK(field() == NETMESH_FIELD_SOURCE);
    netmesh_source source = made.split.source;
    r.source = &source;
    CHECK(field() == NETMESH_FIELD_PIECES);
    r.pieces = 3;
    CHECK(field() == NETMESH_FIELD_PIECES);
    r.pieces = 1u << 20;
    CHECK(field() == NETMESH_FIELD_PIECES);
    r.pieces = 4;
    CHECK(field() == NETMESH_FIELD_NODE);
    r.node = 8;
    CHECK(field() == NETMESH_FIELD_NODE);
    r.node = 4;
    r.keep_zero_pairs = 2;
    CHECK(field() == NETMESH_FIELD_KEEP_ZERO_PAIRS);
    r.keep_zero_pairs = 0;
    r.reserved = 1;
    CHECK(field() == NETMESH_FIELD_STRUCT_BYTES);
    r.reserved = 0;
    source.levels = 2;
    CHECK(field() == NETMESH_FIELD_SOURCE);
    source.levels = made.split.source.levels;
    source.box = nullptr;
    CHECK(field() == NETMESH_FIELD_SOURCE);
    source.box = made.split.source.box;
    source.dim = 7;
    CHECK(field() == NETMESH_FIELD_DIM);
    netmesh_piece piece = {};
    CHECK(netmesh_get_piece(session.context, &piece) == NETMESH_NO_RESULT);
}

TEST_CASE("what a function of the source returns ends the call") {
    const Made made;
    Session session(3);
    netmesh_source source = made.split.source;
    pieces::Bytes out;
    source.read = [](void*, std::uint64_t, std::uint32_t, double*, std::uint32_t*) { return NETMESH_CHECK_FAILED; };
    CHECK(make_leaf(session, source, made.options, 4, &out) == NETMESH_CHECK_FAILED);
    source = made.split.source;
    source.box = [](void*, std::uint32_t, double*) { return NETMESH_OUT_OF_RANGE; };
    CHECK(make_leaf(session, source, made.options, 4, &out) == NETMESH_OUT_OF_RANGE);
    source.box = [](void*, std::uint32_t, double* box) {
        for (int i = 0; i < 6; ++i) box[i] = NAN;
        return NETMESH_OK;
    };
    CHECK(make_leaf(session, source, made.options, 4, &out) == NETMESH_NOT_FINITE);
}

TEST_CASE("in each smaller block a task runs out of memory, says how much it wants and leaves nothing") {
    const Made made(3, 4, 120);
    for (const std::uint32_t node : {4u, 2u}) {
        std::size_t fits = 0;
        for (std::size_t bytes = 8192; fits == 0; bytes += 4096) {
            REQUIRE(bytes < std::size_t(1) << 24);
            Session session(3);
            session.reserve(bytes);
            netmesh_leaf_request leaf = {};
            leaf.struct_bytes = sizeof leaf;
            leaf.source = &made.split.source;
            leaf.pieces = 4;
            leaf.node = node;
            leaf.max_degree = 255;
            netmesh_join_request join = {};
            join.struct_bytes = sizeof join;
            join.one = made.all.at(4).piece();
            join.other = made.all.at(5).piece();
            const netmesh_status status =
                node == 4 ? netmesh_leaf(session.context, &leaf) : netmesh_join(session.context, &join);
            netmesh_piece piece = {};
            const netmesh_status got = netmesh_get_piece(session.context, &piece);
            if (status == NETMESH_OK) {
                fits = bytes;
                CHECK(pieces::Bytes(piece.bytes, piece.count) == made.all.at(node));
            } else {
                REQUIRE(status == NETMESH_OUT_OF_MEMORY);
                CHECK(detail_of(session).bytes_wanted > bytes);
                CHECK(got == NETMESH_NO_RESULT);
            }
        }
    }
}

TEST_CASE("a task can be stopped at each poll") {
    const Made made(3, 4, 120);
    struct Counter {
        int left;
        static int poll(void* self, const netmesh_progress*) { return static_cast<Counter*>(self)->left-- <= 0; }
    };
    for (int polls = 0;; ++polls) {
        REQUIRE(polls < 100000);
        Counter counter = {polls};
        Session session(3);
        session.reserve(std::size_t(1) << 24);
        netmesh_leaf_request leaf = {};
        leaf.struct_bytes = sizeof leaf;
        leaf.source = &made.split.source;
        leaf.pieces = 4;
        leaf.node = 6;
        leaf.max_degree = 255;
        leaf.monitor = {Counter::poll, &counter};
        const netmesh_status status = netmesh_leaf(session.context, &leaf);
        if (status == NETMESH_OK) {
            CHECK(polls > 0);
            break;
        }
        REQUIRE(status == NETMESH_CANCELLED);
    }
}
