// Lower-star filtrations of parts of balls, cut at random in every way that leaves the homology of a point, against the
// textbook reduction of the simplices that are in.
#include "complex/subcomplex.hpp"

#include <doctest/doctest.h>

#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "delaunay/triangulate.hpp"
#include "disturbed.hpp"
#include "parts.hpp"
#include "textbook.hpp"

using namespace netmesh;
using parts::Part;

namespace {

struct Seen {
    std::size_t cut = 0, absent = 0, bare = 0, whole_and_cut = 0, top_pairs = 0;
};

template <int D> void check_part(const grid::Ball<D>& ball, const Part<D>& part, std::mt19937& random, Seen* seen) {
    Block block(std::size_t{16} << 20);
    std::vector<double> value(ball.vertex_count);
    for (const std::uint32_t levels : {0u, 4u, 1u}) {
        CAPTURE(levels);
        for (double& t : value)
            t = levels == 0 ? double(random()) / 4294967296.0 : levels == 1 ? 2 : double(random() % levels);
        const std::uint32_t zero_born = levels == 0 || random() % 2 == 0 ? 0 : random() % (ball.vertex_count + 1);
        const auto f = oracle::lower_star(part.simplices, value, zero_born);
        const LowerStarFiltration<D> filtration = {ball.view(), value.data(), zero_born, &part.view};
        textbook::check_diagrams<D>(filtration, f, block);
        textbook::check_cycles<D>(filtration, f, block);
        for (const Pair& p : oracle::diagram(f, D - 1, false)) seen->top_pairs += p.degree == D - 1;
    }
    seen->cut += part.cut;
    seen->absent += part.absent;
    seen->bare += part.bare;
    seen->whole_and_cut += part.cut > 0 && part.cut + part.absent < ball.vertex_count;
}

// Everything; almost everything; half of it; next to nothing; and what lies around tunnels.
template <int D> void check_parts(const grid::Ball<D>& ball, std::mt19937& random, Seen* seen) {
    const auto all = oracle::all_faces(ball.cells());
    const std::size_t depths[] = {0, 1 + random() % 4, all.size() / 16, all.size() / 4, all.size()};
    for (const std::size_t pairs : depths) {
        for (const bool digging : {false, true}) {
            CAPTURE(pairs);
            CAPTURE(digging);
            check_part<D>(ball, Part<D>(ball, parts::collapse(all, pairs, digging, random), random), random, seen);
        }
    }
}

void check_seen(const Seen& seen) {
    CHECK(seen.cut > 100);
    CHECK(seen.absent > 20);
    CHECK(seen.bare > 100);
    CHECK(seen.whole_and_cut > 5);
    CHECK(seen.top_pairs > 10);
}

template <int D> grid::Ball<D> delaunay(std::size_t points, std::uint64_t seed) {
    Block block(std::size_t{4} << 20);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    const auto p = inputs::uniform(D, points, seed);
    REQUIRE(triangulate<D>(store, p.data(), points, 1, monitor, &input) == Status::ok);
    std::vector<std::array<std::uint32_t, D + 1>> cells;
    const TriangulationView<D> view = store.view();
    for (CellId c(0); c < view.cell_count; ++c) {
        cells.emplace_back();
        for (std::size_t i = 0; i <= D; ++i) cells.back()[i] = view.vertices(c)[i];
    }
    return grid::link<D>(cells, view.vertex_count);
}

}  // namespace

TEST_CASE("parts of the plane") {
    std::mt19937 random(71);
    Seen seen;
    for (std::uint64_t round = 0; round < 6; ++round) {
        check_parts<2>(grid::freudenthal<2>({7, 6}, random), random, &seen);
        check_parts<2>(grid::irregular<2>(50, random), random, &seen);
        check_parts<2>(delaunay<2>(50, round), random, &seen);
    }
    check_seen(seen);
}
TEST_CASE("parts of space") {
    std::mt19937 random(72);
    Seen seen;
    for (std::uint64_t round = 0; round < 4; ++round) {
        check_parts<3>(grid::freudenthal<3>({3, 3, 2}, random), random, &seen);
        check_parts<3>(grid::irregular<3>(30, random), random, &seen);
        check_parts<3>(delaunay<3>(30, round), random, &seen);
    }
    check_seen(seen);
}
TEST_CASE_TEMPLATE_DEFINE("parts of four dimensions", T, parts_4) {
    constexpr int D = T::value;
    std::mt19937 random(73);
    Seen seen;
    for (std::uint64_t round = 0; round < 3; ++round) {
        check_parts<D>(grid::freudenthal<D>({2, 1, 1, 1}, random), random, &seen);
        check_parts<D>(grid::irregular<D>(22, random), random, &seen);
        check_parts<D>(delaunay<D>(18, round), random, &seen);
    }
    check_seen(seen);
}
TEST_CASE_TEMPLATE_APPLY(parts_4, Dimensions<4, 4>);

namespace {

// Cells around one vertex with a large link, and another cell on each facet of their hull.
template <int D> grid::Ball<D> covered_cone(std::uint32_t length) {
    const auto cone = grid::cone_over_stack<D>(length);
    std::vector<std::array<std::uint32_t, D + 1>> cells;
    std::uint32_t next = cone.vertex_count;
    for (CellId c(0); c < cone.view().cell_count; ++c) {
        cells.emplace_back();
        std::copy(cone.view().vertices(c), cone.view().vertices(c) + D + 1, cells.back().begin());
        const auto inner = cells.back();
        for (std::uint32_t i = 0; i <= D; ++i) {
            if (cone.view().neighbour(c, i) != none) continue;
            cells.push_back(inner);
            cells.back()[i] = next++;
        }
    }
    return grid::link<D>(cells, next);
}

// Its vertex with the large link is still whole when some of the outer cells are gone.
template <int D> void check_large(std::uint32_t length, std::mt19937& random, Seen* seen) {
    const auto ball = covered_cone<D>(length);
    const auto all = oracle::all_faces(ball.cells());
    for (const std::size_t pairs : {std::size_t{5}, std::size_t{60}, all.size() / 4}) {
        const Part<D> part(ball, parts::collapse(all, pairs, false, random), random);
        if (pairs < 10) CHECK(part.vertex[length + D] == VertexPart::whole);
        check_part<D>(ball, part, random, seen);
    }
}

}  // namespace

TEST_CASE("parts with large links") {
    std::mt19937 random(74);
    Seen seen;
    check_large<3>(64, random, &seen);
    for_each_dimension<4, 4>([&](auto dim) { check_large<dim>(60, random, &seen); });
    for (int round = 0; round < 3; ++round) {
        check_parts<3>(grid::cone_over_stack<3>(66), random, &seen);
        for_each_dimension<4, 4>([&](auto dim) { check_parts<dim>(grid::cone_over_stack<4>(24), random, &seen); });
    }
    CHECK(seen.cut > 100);
}
TEST_CASE("parts of five and six dimensions") {
    std::mt19937 random(75);
    Seen seen;
    for_each_dimension<5, 5>([&](auto dim) {
        for (int round = 0; round < 3; ++round) check_parts<dim>(grid::irregular<5>(8, random), random, &seen);
    });
    for_each_dimension<6, 6>([&](auto dim) {
        for (int round = 0; round < 3; ++round) check_parts<dim>(grid::irregular<6>(4, random), random, &seen);
    });
}
// The tetrahedron of one cell, in no cell of the part, without one of its triangles: the star of their last vertex has
// no place for it, or goes without it.
TEST_CASE_TEMPLATE_DEFINE("a part that is not closed does no harm", T, not_closed) {
    constexpr int D = T::value;
    std::array<std::uint32_t, D + 1> all;
    std::iota(all.begin(), all.end(), 0u);
    const auto cell = grid::link<D>({all}, D + 1);
    const std::uint8_t out[1] = {0};
    std::vector<std::uint8_t> vertex(D + 1, VertexPart::absent);
    for (std::size_t v = 0; v < 4; ++v) vertex[v] = VertexPart::cut;
    int refused = 0;
    for (const oracle::Simplex& missing : {oracle::Simplex{}, {0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
        Block block(std::size_t{1} << 16), faces(std::size_t{1} << 14);
        Subcomplex<D> part = {out, {}, vertex.data()};
        for (const auto& s : oracle::all_faces({{0, 1, 2, 3}}))
            if (s != missing) REQUIRE(part.faces.insert(s.data(), std::uint32_t(s.size()), faces.arena));
        const std::vector<double> value(all.begin(), all.end());
        Monitor monitor;
        CountedPairs found;
        const Status status =
            persist_lower_star<D>({cell.view(), value.data(), 0, &part}, {D, false}, {block.arena, monitor}, &found);
        if (missing.empty()) {
            REQUIRE(status == Status::ok);
            CHECK(found.simplices == 15);
        }
        if (status == Status::ok) continue;
        CHECK(status == Status::internal);
        CHECK(block.arena.bytes_used() == 0);
        ++refused;
    }
    CHECK(refused > 0);
}
TEST_CASE_TEMPLATE_APPLY(not_closed, Dimensions<4>);

namespace {

template <int D> oracle::Simplex random_simplex(std::mt19937& random, std::uint32_t range) {
    std::set<std::uint32_t> s;
    for (const std::size_t n = 1 + random() % D; s.size() < n;) s.insert(random() % range);
    return {s.begin(), s.end()};
}
template <int D> bool has(const FaceSet<D>& faces, const oracle::Simplex& s) {
    return faces.contains(s.data(), std::uint32_t(s.size()));
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("a set of faces knows them by all of their vertices", T, face_set) {
    constexpr int D = T::value;
    std::mt19937 random(76);
    Block block(std::size_t{4} << 20), other_block(std::size_t{4} << 20);
    FaceSet<D> faces, other;
    std::set<oracle::Simplex> expected;
    std::vector<oracle::Simplex> order;
    CHECK(!has(faces, {0}));
    CHECK(block.arena.bytes_used() == 0);
    for (int i = 0; i < 3000; ++i) {
        const auto s = random_simplex<D>(random, 60);
        CHECK(has(faces, s) == (expected.count(s) != 0));
        REQUIRE(faces.insert(s.data(), std::uint32_t(s.size()), block.arena));
        expected.insert(s);
        order.push_back(s);
        CHECK(faces.count() == expected.size());
        CHECK(block.arena.high_mark() == block.arena.bytes());
        const std::size_t bytes = faces.count() * 4 * D;
        CHECK(block.arena.low_mark() <= std::max<std::size_t>(64 * 4 * D, bytes * 8 / 3));
    }
    std::shuffle(order.begin(), order.end(), random);
    for (const auto& s : order) REQUIRE(other.insert(s.data(), std::uint32_t(s.size()), other_block.arena));
    CHECK(other.count() == faces.count());
    for (int i = 0; i < 5000; ++i) {
        const auto s = random_simplex<D>(random, 62);
        CHECK(has(faces, s) == (expected.count(s) != 0));
        CHECK(has(other, s) == (expected.count(s) != 0));
    }
}
TEST_CASE_TEMPLATE_APPLY(face_set, Dimensions<>);
TEST_CASE("a set of faces that cannot grow keeps what it has") {
    std::mt19937 random(77);
    for (const std::size_t bytes : {0, 100, 1600, 2400, 5000, 10000, 24000}) {
        CAPTURE(bytes);
        Block block(bytes);
        FaceSet<3> faces;
        std::set<oracle::Simplex> expected;
        oracle::Simplex s;
        for (;;) {
            s = random_simplex<3>(random, 100);
            const std::size_t used = block.arena.bytes_used();
            if (!faces.insert(s.data(), std::uint32_t(s.size()), block.arena)) {
                CHECK(block.arena.bytes_used() == used);
                break;
            }
            expected.insert(s);
        }
        CHECK(faces.count() == expected.size());
        CHECK(!has(faces, s));
        for (const auto& in : expected) CHECK(has(faces, in));
        if (bytes >= 1600) CHECK(expected.size() * 100 > bytes);
    }
}
