// Cycles of lower-star filtrations against the textbook reduction: each is one, is born and dies with its pair, and no
// cycle is a sum of others up to what has died before.
#include <doctest/doctest.h>

#include "common/dimensions.hpp"
#include "grid.hpp"
#include "textbook.hpp"

using namespace netmesh;

namespace {

template <int D>
Status run(const grid::Ball<D>& ball, const std::vector<double>& value, std::uint32_t zero_born, std::uint32_t degree,
           std::uint64_t pairs, Block& block, Representatives* out) {
    Monitor monitor;
    return lower_star_cycles<D>({ball.view(), value.data(), zero_born}, degree, pairs, {block.arena, monitor}, out);
}

template <int D>
void check(const grid::Ball<D>& ball, const std::vector<double>& value, std::uint32_t zero_born, Block& block) {
    const auto f = oracle::lower_star(oracle::all_faces(ball.cells()), value, zero_born);
    textbook::check_cycles<D>({ball.view(), value.data(), zero_born}, f, block);
}

template <int D> void check_values(const grid::Ball<D>& ball, std::mt19937& random) {
    Block block(std::size_t{16} << 20);
    std::vector<double> value(ball.vertex_count);
    for (const std::uint32_t levels : {0u, 3u, 20u}) {
        for (double& t : value) t = levels == 0 ? double(random()) / 4294967296.0 : double(random() % levels);
        check<D>(ball, value, 0, block);
        check<D>(ball, value, ball.vertex_count / 2, block);
    }
}

}  // namespace

TEST_CASE("cycles on grids") {
    std::mt19937 random(31);
    check_values<2>(grid::link<2>({{0, 1, 2}}, 3), random);
    for_each_dimension<6, 6>([&](auto dim) { check_values<dim>(grid::link<6>({{0, 1, 2, 3, 4, 5, 6}}, 7), random); });
    check_values<2>(grid::freudenthal<2>({12, 9}, random), random);
    check_values<3>(grid::freudenthal<3>({5, 4, 4}, random), random);
    for_each_dimension<4, 4>([&](auto dim) { check_values<dim>(grid::freudenthal<4>({2, 2, 3, 2}, random), random); });
    for_each_dimension<5, 5>([&](auto dim) {
        check_values<dim>(grid::freudenthal<5>({2, 1, 1, 1, 1}, random), random);
    });
}
TEST_CASE("cycles on balls with vertices of very different degrees") {
    std::mt19937 random(32);
    for (int round = 0; round < 4; ++round) {
        check_values<2>(grid::irregular<2>(80, random), random);
        check_values<3>(grid::irregular<3>(60, random), random);
        for_each_dimension<4, 4>([&](auto dim) { check_values<dim>(grid::irregular<4>(25, random), random); });
        for_each_dimension<5, 5>([&](auto dim) { check_values<dim>(grid::irregular<5>(12, random), random); });
        for_each_dimension<6, 6>([&](auto dim) { check_values<dim>(grid::irregular<6>(5, random), random); });
    }
}
TEST_CASE_TEMPLATE_DEFINE("every arena size gives the cycles or out_of_memory", T, any_arena) {
    constexpr int D = T::value;
    std::mt19937 random(33);
    const auto ball = grid::freudenthal<D>({2, 2, 2, 2}, random);
    std::vector<double> value(ball.vertex_count);
    for (double& t : value) t = double(random() % 1000);
    const auto f = oracle::lower_star(oracle::all_faces(ball.cells()), value, 0);
    const auto expected = oracle::diagram(f, 3, false);
    bool enough = false;
    std::size_t bytes = 0;
    for (; !enough; bytes += 1 << 12) {
        Block block(bytes);
        Representatives found;
        const Status status = run(ball, value, 0, 3, expected.size(), block, &found);
        enough = status == Status::ok;
        if (enough) {
            CHECK(oracle::same(expected, found.pairs));
        } else {
            REQUIRE(status == Status::out_of_memory);
            CHECK(block.arena.bytes_used() == 0);
        }
    }
    CHECK(bytes > std::size_t{1} << 14);
}
TEST_CASE_TEMPLATE_APPLY(any_arena, Dimensions<4, 4>);
