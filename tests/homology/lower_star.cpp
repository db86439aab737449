// Lower-star persistence against the textbook reduction on small balls with every kind of tie.
#include <doctest/doctest.h>

#include <cmath>

#include "common/dimensions.hpp"
#include "grid.hpp"
#include "textbook.hpp"

using namespace netmesh;

namespace {

template <int D>
void check(const grid::Ball<D>& ball, const std::vector<double>& value, std::uint32_t zero_born_count) {
    const auto f = oracle::lower_star(oracle::all_faces(ball.cells()), value, zero_born_count);
    Block block(std::size_t{16} << 20);
    textbook::check_diagrams<D>({ball.view(), value.data(), zero_born_count}, f, block);
}

template <int D> void check_values(const grid::Ball<D>& ball, std::mt19937& random) {
    const std::uint32_t n = ball.vertex_count;
    std::vector<double> value(n);
    const auto both = [&] {
        check<D>(ball, value, 0);
        check<D>(ball, value, 1 + random() % n);
        check<D>(ball, value, n);
    };
    for (double& t : value) t = double(random()) / 4294967296.0;
    both();
    for (double& t : value) t = double(random() % 3);
    both();
    for (double& t : value) t = 1.5;
    check<D>(ball, value, n / 2);
    for (double& t : value) t = (random() & 1) != 0 ? 0.0 : -0.0;
    check<D>(ball, value, n / 3);
    for (double& t : value) t = -double(random() % 1000);
    check<D>(ball, value, 0);
}

template <int D> std::array<std::uint32_t, D> cubes(std::uint32_t a, std::uint32_t b, std::uint32_t rest) {
    std::array<std::uint32_t, D> n;
    n.fill(rest);
    n[0] = a;
    n[1] = b;
    return n;
}

}  // namespace

TEST_CASE("a single cell") {
    std::mt19937 random(1);
    check_values<2>(grid::link<2>({{0, 1, 2}}, 3), random);
    check_values<3>(grid::link<3>({{0, 1, 2, 3}}, 4), random);
    for_each_dimension<4, 4>([&](auto dim) { check_values<dim>(grid::link<4>({{0, 1, 2, 3, 4}}, 5), random); });
    for_each_dimension<5, 5>([&](auto dim) { check_values<dim>(grid::link<5>({{0, 1, 2, 3, 4, 5}}, 6), random); });
    for_each_dimension<6, 6>([&](auto dim) { check_values<dim>(grid::link<6>({{0, 1, 2, 3, 4, 5, 6}}, 7), random); });
}

TEST_CASE("grids of the plane") {
    std::mt19937 random(2);
    check_values<2>(grid::freudenthal<2>({12, 9}, random), random);
    check_values<2>(grid::freudenthal<2>({1, 15}, random), random);
}
TEST_CASE("grids of space") {
    std::mt19937 random(3);
    check_values<3>(grid::freudenthal<3>({5, 4, 4}, random), random);
    check_values<3>(grid::freudenthal<3>({1, 1, 9}, random), random);
}
TEST_CASE("grids in four dimensions") {
    std::mt19937 random(4);
    for_each_dimension<4, 4>([&](auto dim) { check_values<dim>(grid::freudenthal<4>({2, 2, 3, 2}, random), random); });
}
TEST_CASE("grids in five and six dimensions") {
    std::mt19937 random(5);
    for_each_dimension<5, 5>([&](auto dim) {
        check_values<dim>(grid::freudenthal<5>({2, 1, 1, 1, 2}, random), random);
    });
    for_each_dimension<6, 6>([&](auto dim) {
        check_values<dim>(grid::freudenthal<6>({1, 1, 1, 1, 1, 1}, random), random);
    });
}
TEST_CASE("balls with vertices of very different degrees") {
    std::mt19937 random(9);
    for (int round = 0; round < 6; ++round) {
        check_values<2>(grid::irregular<2>(80, random), random);
        check_values<3>(grid::irregular<3>(60, random), random);
        for_each_dimension<4, 4>([&](auto dim) { check_values<dim>(grid::irregular<4>(25, random), random); });
        for_each_dimension<5, 5>([&](auto dim) { check_values<dim>(grid::irregular<5>(12, random), random); });
        for_each_dimension<6, 6>([&](auto dim) { check_values<dim>(grid::irregular<6>(6, random), random); });
    }
}
// Stars in which more is critical than homology asks for: it is paired within the star, at no length. With those pairs
// every simplex is in one, but for the one that is essential.
TEST_CASE_TEMPLATE_DEFINE("with pairs of zero length every simplex of a ball is in a pair", T, all_paired) {
    constexpr int D = T::value;
    std::mt19937 random(11);
    Block block(std::size_t{16} << 20);
    for (int round = 0; round < 12; ++round) {
        CAPTURE(round);
        const auto ball = grid::irregular<D>(D == 4 ? 60 + random() % 20 : D < 4 ? 50 : D == 5 ? 12 : 6, random);
        std::vector<double> value(ball.vertex_count);
        for (int turn = 0; turn < 6; ++turn) {
            for (double& t : value) t = double(random());
            const std::size_t low = block.arena.low_mark();
            Monitor monitor;
            CountedPairs out;
            REQUIRE(persist_lower_star<D>({ball.view(), value.data(), 0}, {D - 1, true}, {block.arena, monitor},
                                          &out) == Status::ok);
            CHECK(2 * out.pairs.count - 1 == out.simplices);
            block.arena.release_low(low);
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(all_paired, Dimensions<>);

TEST_CASE("links of more than 63 vertices") {
    std::mt19937 random(6);
    check_values<3>(grid::cone_over_stack<3>(90), random);
    for_each_dimension<4, 4>([&](auto dim) { check_values<dim>(grid::cone_over_stack<4>(80), random); });
}

TEST_CASE_TEMPLATE_DEFINE("every arena size gives the diagram or out_of_memory", T, any_arena) {
    constexpr int D = T::value;
    std::mt19937 random(8);
    const auto ball = grid::freudenthal<D>({2, 2, 2, 2}, random);
    std::vector<double> value(ball.vertex_count);
    for (double& t : value) t = double(random() % 1000);
    const auto records = ball.records;
    const auto expected = oracle::diagram(oracle::lower_star(oracle::all_faces(ball.cells()), value, 20), 3, false);
    bool fitted = false;
    for (std::size_t bytes = 0; bytes < 300000; bytes += fitted ? 1024 : 16) {
        Block block(bytes);
        Monitor monitor;
        CountedPairs out;
        const Status status = persist_lower_star<D>({ball.view(), value.data(), 20}, {3}, {block.arena, monitor}, &out);
        if (status == Status::ok) {
            fitted = true;
            REQUIRE(oracle::same(expected, out.pairs));
        } else {
            REQUIRE(status == Status::out_of_memory);
            REQUIRE(!fitted);
            REQUIRE(block.arena.bytes_used() == 0);
            REQUIRE(block.arena.bytes_wanted() > bytes);
        }
    }
    CHECK(fitted);
    CHECK(records == ball.records);
}
TEST_CASE_TEMPLATE_APPLY(any_arena, Dimensions<4, 4>);

TEST_CASE_TEMPLATE_DEFINE("stopping at any poll leaves the arena as it was", T, any_poll) {
    constexpr int D = T::value;
    std::mt19937 random(10);
    const auto ball = grid::freudenthal<D>({8, 7, 6, 6}, random);
    std::vector<double> value(ball.vertex_count);
    for (double& t : value) t = double(random());
    struct Countdown {
        int left;
    };
    const auto poll = [](void* user, const netmesh_progress* progress) {
        auto* countdown = static_cast<Countdown*>(user);
        CHECK(progress->done <= progress->total);
        return countdown->left-- == 0 ? 1 : 0;
    };
    Block block(std::size_t{32} << 20);
    int polls = 0;
    for (bool finished = false; !finished; ++polls) {
        Countdown countdown = {polls};
        Monitor monitor(poll, &countdown);
        CountedPairs out;
        const Status status = persist_lower_star<D>({ball.view(), value.data(), 0}, {3}, {block.arena, monitor}, &out);
        finished = status == Status::ok;
        if (finished) break;
        REQUIRE(status == Status::cancelled);
        REQUIRE(block.arena.bytes_used() == 0);
    }
    CHECK(polls > 1);
}
TEST_CASE_TEMPLATE_APPLY(any_poll, Dimensions<4, 4>);
