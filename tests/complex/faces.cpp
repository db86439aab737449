#include "complex/faces.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "common/dimensions.hpp"
#include "complex/triangulations.hpp"

using namespace netmesh;
using namespace netmesh_test;

namespace {

using Simplex = std::vector<std::uint32_t>;

template <int D> Simplex vertices_of(const Faces<D>& faces, int k, std::uint32_t i) {
    Simplex s(static_cast<std::size_t>(k + 1));
    faces.vertices(k, i, s.data());
    return s;
}

// Every face once, in lexicographic order, against a set; every facet where it says it is.
template <int D> void compare_with_sets(const Cells<D>& cells, int dimension_max) {
    std::vector<std::set<Simplex>> expected(D + 1);
    for (const auto& cell : cells.list) {
        Simplex sorted(cell.begin(), cell.end());
        std::sort(sorted.begin(), sorted.end());
        for (unsigned mask = 1; mask < 2u << D; ++mask) {
            Simplex face;
            for (int i = 0; i <= D; ++i)
                if ((mask >> i & 1u) != 0) face.push_back(sorted[static_cast<std::size_t>(i)]);
            expected[face.size() - 1].insert(face);
        }
    }
    Block block(std::size_t{1} << 26);
    Monitor monitor;
    Faces<D> faces;
    REQUIRE(enumerate_faces<D>(cells.view(), dimension_max, {block.arena, monitor}, &faces) == Status::ok);
    CHECK(faces.dimension_max == dimension_max);
    for (int k = 0; k <= D; ++k) {
        if (k > dimension_max) {
            CHECK(faces.count[k] == 0);
            continue;
        }
        REQUIRE(faces.count[k] == expected[static_cast<std::size_t>(k)].size());
        std::uint32_t i = 0;
        std::size_t differ = 0;
        for (const Simplex& face : expected[static_cast<std::size_t>(k)]) {
            if (vertices_of(faces, k, i) != face) ++differ;
            for (int j = 0; j <= k && k > 0; ++j) {
                Simplex facet = face;
                facet.erase(facet.begin() + j);
                if (vertices_of(faces, k - 1, faces.facets_of(k, i)[j]) != facet) ++differ;
            }
            ++i;
        }
        CHECK(differ == 0);
    }
}

// All of the boundaries, for comparisons.
template <int D> std::vector<std::uint32_t> contents(const Faces<D>& faces) {
    std::vector<std::uint32_t> all(faces.count, faces.count + D + 1);
    for (int k = 0; k <= faces.dimension_max; ++k) {
        all.insert(all.end(), faces.last_vertex[k], faces.last_vertex[k] + faces.count[k]);
        if (k > 0) all.insert(all.end(), faces.facets_of(k, 0), faces.facets_of(k, faces.count[k]));
    }
    return all;
}

// k-faces of a Freudenthal grid: an origin, and an ordered partition of s of the axes into k blocks.
std::uint64_t freudenthal_faces(int dim, std::uint64_t side, int k) {
    std::uint64_t onto[8][8] = {};  // ordered partitions of s things into b blocks
    onto[0][0] = 1;
    for (int s = 1; s <= dim; ++s)
        for (int b = 1; b <= s; ++b) onto[s][b] = static_cast<std::uint64_t>(b) * (onto[s - 1][b] + onto[s - 1][b - 1]);
    std::uint64_t total = 0, choose = 1;
    for (int s = 0; s <= dim; ++s) {
        std::uint64_t origins = 1;
        for (int d = 0; d < dim; ++d) origins *= d < s ? side : side + 1;
        total += choose * onto[s][k] * origins;
        choose = choose * static_cast<std::uint64_t>(dim - s) / static_cast<std::uint64_t>(s + 1);
    }
    return total;
}

template <int D> void check_grid(std::uint32_t side) {
    CAPTURE(D);
    Block block(std::size_t{1} << 27);
    Monitor monitor;
    Faces<D> faces;
    const Cells<D> cells = freudenthal<D>(side);
    REQUIRE(enumerate_faces<D>(cells.view(), D, {block.arena, monitor}, &faces) == Status::ok);
    std::int64_t euler = 0;
    for (int k = 0; k <= D; ++k) {
        CHECK(faces.count[k] == freudenthal_faces(D, side, k));
        euler += k % 2 == 0 ? faces.count[k] : -static_cast<std::int64_t>(faces.count[k]);
    }
    CHECK(euler == 1);
    std::size_t open = 0;
    for (int k = 2; k <= D; ++k)
        for (std::uint32_t i = 0; i < faces.count[k]; ++i) {
            std::map<std::uint32_t, int> times;
            for (int j = 0; j <= k; ++j)
                for (int l = 0; l < k; ++l) ++times[faces.facets_of(k - 1, faces.facets_of(k, i)[j])[l]];
            for (const auto& entry : times) open += entry.second % 2;
        }
    CHECK(open == 0);  // the boundary of a boundary
}

template <int D> void check_against_sets(std::uint32_t side) {
    CAPTURE(D);
    Cells<D> cells = freudenthal<D>(side);
    Random random;
    std::vector<std::uint32_t> name(cells.vertex_count);
    std::iota(name.begin(), name.end(), 0u);
    for (std::size_t i = name.size(); i > 1; --i)
        std::swap(name[i - 1], name[random.below(static_cast<std::uint32_t>(i))]);
    for (auto& cell : cells.list)
        for (auto& v : cell) v = name[v];
    for (int k = 0; k <= D; ++k) compare_with_sets(cells, k);
}

// Triangles around a vertex named `hub`.
Cells<2> fan(std::uint32_t petals, std::uint32_t hub) {
    Cells<2> cells;
    cells.vertex_count = petals + 2;
    const auto rim = [hub](std::uint32_t i) { return i < hub ? i : i + 1; };
    for (std::uint32_t i = 0; i < petals; ++i) cells.list.push_back({hub, rim(i), rim(i + 1)});
    return cells;
}

// Any amount of memory gives the faces or says that it is too little, and leaves the arena as it was.
template <int D> void enumerate_in_any_arena(const Cells<D>& cells, std::size_t step) {
    CAPTURE(D);
    Block whole(std::size_t{1} << 22);
    Monitor monitor;
    Faces<D> faces;
    REQUIRE(enumerate_faces<D>(cells.view(), D, {whole.arena, monitor}, &faces) == Status::ok);
    const std::vector<std::uint32_t> expected = contents(faces);
    bool succeeded = false;
    for (std::size_t bytes = 0; bytes <= whole.arena.bytes_peak() + 64 + step; bytes += step) {
        Block block(bytes);
        const Status status = enumerate_faces<D>(cells.view(), D, {block.arena, monitor}, &faces);
        if (status == Status::ok) {
            succeeded = true;
            CHECK(contents(faces) == expected);
        } else {
            CHECK(status == Status::out_of_memory);
            CHECK(!succeeded);
            CHECK(block.arena.bytes_used() == 0);
            CHECK(block.arena.bytes_wanted() > bytes - bytes % 16);
        }
    }
    CHECK(succeeded);
}

// Each cell has the vertices i .. i + D; two more vertices are in none.
template <int D> Cells<D> strip(std::uint32_t length) {
    Cells<D> cells;
    cells.vertex_count = length + D + 2;
    for (std::uint32_t i = 0; i < length; ++i) {
        std::array<std::uint32_t, D + 1> cell;
        std::iota(cell.begin(), cell.end(), i);
        cells.list.push_back(cell);
    }
    return cells;
}

template <int D> void strips() {
    compare_with_sets(strip<D>(20), D);
    for (std::uint32_t length : {1u, 2u, 7u}) enumerate_in_any_arena(strip<D>(length), 16);
    enumerate_in_any_arena(strip<D>(10000 >> D), 8192);  // more records than one block of the stream
}

template <int D> void refuse_dimensions() {
    const Cells<D> cells = strip<D>(3);
    Block block(1 << 16);
    Monitor monitor;
    Faces<D> faces;
    CHECK(enumerate_faces<D>(cells.view(), -1, {block.arena, monitor}, &faces) == Status::invalid_argument);
    CHECK(enumerate_faces<D>(cells.view(), D + 1, {block.arena, monitor}, &faces) == Status::invalid_argument);
}

}  // namespace

TEST_CASE("grids have the face counts of the formula, Euler characteristic 1, boundaries without boundary") {
    check_grid<2>(9);
    check_grid<3>(5);
    for_each_dimension<4, 4>([&](auto dim) { check_grid<dim>(3); });
    for_each_dimension<5, 5>([&](auto dim) { check_grid<dim>(2); });
    for_each_dimension<6, 6>([&](auto dim) { check_grid<dim>(1); });
}

TEST_CASE("each face is listed once, at its place, with its facets") {
    check_against_sets<2>(6);
    check_against_sets<3>(3);
    for_each_dimension<4, 4>([&](auto dim) { check_against_sets<dim>(2); });
    for_each_dimension<5, 5>([&](auto dim) { check_against_sets<dim>(1); });
    for_each_dimension<6, 6>([&](auto dim) { check_against_sets<dim>(1); });
}

TEST_CASE_TEMPLATE_DEFINE("one cell has all subsets of its vertices as faces", T, subsets) {
    constexpr int D = T::value;
    Cells<D> cells;
    cells.vertex_count = 7;
    cells.list.push_back({3, 1, 6, 0, 2, 5, 4});
    compare_with_sets(cells, 6);
}
TEST_CASE_TEMPLATE_APPLY(subsets, Dimensions<6, 6>);

// The same faces with their facets, whatever the order; vertices are numbered along it.
template <int D> void compare_along(Cells<D> cells, std::uint64_t seed) {
    CAPTURE(D);
    CAPTURE(seed);
    cells.vertex_count += 5;  // that are in none
    Random random;
    random.state = seed;
    for (std::size_t i = cells.list.size(); i-- > 1;)
        std::swap(cells.list[i], cells.list[random.below(static_cast<std::uint32_t>(i + 1))]);
    Block block(std::size_t{1} << 23);
    Monitor monitor;
    const Work work = {block.arena, monitor};
    Faces<D> plain, along;
    REQUIRE(enumerate_faces<D>(cells.view(), D, work, &plain) == Status::ok);
    const std::uint32_t n = cells.vertex_count;
    std::uint32_t* const order = block.arena.template take_high<std::uint32_t>(n);
    REQUIRE(order != nullptr);
    std::vector<std::uint32_t> place(n), used;
    for (std::uint32_t i = 0; i < n; ++i) order[i] = i;
    for (std::uint32_t i = n; i-- > 1;) std::swap(order[i], order[random.below(i + 1)]);
    for (std::uint32_t i = 0; i < n; ++i) {
        place[order[i]] = i;
        const bool is_used = std::any_of(cells.list.begin(), cells.list.end(), [&](const auto& cell) {
            return std::find(cell.begin(), cell.begin() + D + 1, order[i]) != cell.begin() + D + 1;
        });
        if (is_used) used.push_back(order[i]);
    }
    const std::size_t high = block.arena.high_mark();
    REQUIRE(enumerate_faces_along<D>(cells.view(), cells.hull_facets(), order, false, work, &along) == Status::ok);
    CHECK((block.arena.high_mark() == high) == lists_follow_order<D>);
    for (int k = 0; k <= D; ++k) {
        REQUIRE(along.count[k] == plain.count[k]);
        std::set<Simplex> expected, found;
        std::size_t differ = 0;
        for (std::uint32_t i = 0; i < along.count[k]; ++i) {
            expected.insert(vertices_of(plain, k, i));
            Simplex face = vertices_of(along, k, i);
            for (int j = 0; j <= k && k > 0; ++j) {
                Simplex facet = face;
                facet.erase(facet.begin() + j);
                if (vertices_of(along, k - 1, along.facets_of(k, i)[j]) != facet) ++differ;
                if (j > 0 && lists_follow_order<D> && place[face[j - 1]] >= place[face[j]]) ++differ;
                if (j > 0 && !lists_follow_order<D> && face[j - 1] >= face[j]) ++differ;
            }
            // Where jumps in memory do not matter (-Os) nothing follows the order.
            if (k == 0 && jumps_matter && face[0] != used[i]) ++differ;
            std::sort(face.begin(), face.end());
            found.insert(face);
        }
        CHECK(found == expected);
        CHECK(differ == 0);
    }
}

TEST_CASE_TEMPLATE_DEFINE("faces along an order", T, faces_along_an_order) {
    constexpr int D = T::value;
    for (std::uint64_t seed = 1; seed < 4; ++seed)
        compare_along<D>(freudenthal<D>(by_dimension<std::uint32_t>(D, {3, 3, 2, 1})), seed);
    Cells<D> one;
    one.vertex_count = D + 1;
    one.list.emplace_back();
    for (std::uint32_t i = 0; i <= D; ++i) one.list[0][i] = i;
    compare_along<D>(one, 4);
}
TEST_CASE_TEMPLATE_APPLY(faces_along_an_order, Dimensions<2, 5>);

// Two cells that are apart, one cell twice, wrong numbers of facets.
TEST_CASE_TEMPLATE_DEFINE("faces along an order: what is no ball is found out", T, no_ball) {
    constexpr int D = T::value;
    if (!lists_follow_order<D>) return;  // then vertices are not walked to from one another
    Cells<D> apart, ball = freudenthal<D>(1), twice = ball;
    apart.vertex_count = 2 * (D + 1);
    apart.list.resize(2);
    for (std::uint32_t i = 0; i <= D; ++i) {
        apart.list[0][i] = i;
        apart.list[1][i] = D + 1 + i;
    }
    twice.list.push_back(ball.list[0]);
    const auto refuses = [](const Cells<D>& cells, std::uint64_t hull_facets) {
        Block block(std::size_t{1} << 20);
        Monitor monitor;
        std::uint32_t* const order = block.arena.template take_high<std::uint32_t>(cells.vertex_count);
        for (std::uint32_t i = 0; i < cells.vertex_count; ++i) order[i] = i;
        const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
        Faces<D> faces;
        const Status status =
            enumerate_faces_along<D>(cells.view(), hull_facets, order, false, {block.arena, monitor}, &faces);
        return status == Status::internal && block.arena.low_mark() == low && block.arena.high_mark() == high;
    };
    CHECK(refuses(apart, apart.hull_facets()));
    CHECK(refuses(twice, twice.hull_facets()));
    for (const std::uint64_t wrong : {0u, 1u, 2u, 4u, 100u, 10000u})
        if (wrong / 2 != ball.hull_facets() / 2) CHECK(refuses(ball, wrong));
}
TEST_CASE_TEMPLATE_APPLY(no_ball, Dimensions<2, 4>);

TEST_CASE("vertices of very high degree") {
    for (std::uint32_t hub : {0u, 1500u, 3001u}) {
        compare_with_sets(fan(3000, hub), 2);
    }
}

TEST_CASE("a vertex in no cell is no face") {
    Cells<2> cells;
    cells.vertex_count = 9;
    cells.list = {{7, 2, 4}, {4, 2, 5}};
    compare_with_sets(cells, 2);
    Block block(1 << 20);
    Monitor monitor;
    Faces<2> faces;
    REQUIRE(enumerate_faces<2>(cells.view(), 2, {block.arena, monitor}, &faces) == Status::ok);
    CHECK(faces.count[0] == 4);
}

TEST_CASE_TEMPLATE_DEFINE("the order in which cells and their vertices are stored does not matter", T, any_order) {
    constexpr int D = T::value;
    Cells<D> cells = freudenthal<D>(2);
    Block block(std::size_t{1} << 24);
    Monitor monitor;
    Faces<D> faces;
    REQUIRE(enumerate_faces<D>(cells.view(), 4, {block.arena, monitor}, &faces) == Status::ok);
    const std::vector<std::uint32_t> expected = contents(faces);
    Random random;
    for (std::size_t i = cells.list.size(); i > 1; --i)
        std::swap(cells.list[i - 1], cells.list[random.below(static_cast<std::uint32_t>(i))]);
    for (auto& cell : cells.list) std::reverse(cell.begin(), cell.end());
    Block other(std::size_t{1} << 23);
    REQUIRE(enumerate_faces<D>(cells.view(), 4, {other.arena, monitor}, &faces) == Status::ok);
    CHECK(contents(faces) == expected);
}
TEST_CASE_TEMPLATE_APPLY(any_order, Dimensions<4, 4>);

TEST_CASE("any amount of memory gives the faces or says that it is too little, and leaves the arena as it was") {
    enumerate_in_any_arena(freudenthal<3>(2), 48);
}

TEST_CASE("strips of cells, with vertices that are in none, in any amount of memory") {
    for_each_dimension([](auto dim) { strips<dim>(); });
}

TEST_CASE("dimensions that do not exist are refused") {
    for_each_dimension([](auto dim) { refuse_dimensions<dim>(); });
}

TEST_CASE("the caller can stop the enumeration") {
    const Cells<3> cells = freudenthal<3>(24);
    Block block(std::size_t{1} << 26);
    int polls = 0;
    const auto stop = [](void* user, const netmesh_progress*) { return ++*static_cast<int*>(user) == 2 ? 1 : 0; };
    Monitor monitor(stop, &polls);
    Faces<3> faces;
    monitor.begin(NETMESH_STAGE_FILTER, 0);
    CHECK(enumerate_faces<3>(cells.view(), 3, {block.arena, monitor}, &faces) == Status::cancelled);
    CHECK(polls == 2);
    CHECK(block.arena.bytes_used() == 0);
}
