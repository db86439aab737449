// The sweep over lower stars where columns are many and long: random values, so that most stars are irregular.
// Undisturbed against the general reduction; then without memory, and stopped.
#include <doctest/doctest.h>

#include "common/dimensions.hpp"
#include "disturbed.hpp"
#include "grid.hpp"
#include "homology/cycles/cycles.hpp"
#include "parts.hpp"

using namespace netmesh;

namespace {

template <int D> struct Input {
    grid::Ball<D> ball;
    std::vector<double> value;
    std::uint32_t zero_born;
    const parts::Part<D>* part = nullptr;

    LowerStarFiltration<D> filtration() const {
        return {ball.view(), value.data(), zero_born, part == nullptr ? nullptr : &part->view};
    }
    std::vector<oracle::Simplex> simplices() const {
        return part == nullptr ? oracle::all_faces(ball.cells()) : part->simplices;
    }
};

template <int D>
Input<D> random_values(const grid::Ball<D>& ball, std::uint32_t levels, std::uint32_t zero_born, std::mt19937& random) {
    Input<D> input = {ball, {}, zero_born, nullptr};
    for (std::uint32_t v = 0; v < ball.vertex_count; ++v) input.value.push_back(double(random() % levels));
    return input;
}

// The diagram of the complex, listed and reduced as any.
std::vector<Pair> general(const oracle::Explicit& listed, std::uint32_t degree, bool keep_zero) {
    Block block(std::size_t{64} << 20);
    Monitor monitor;
    PairList out;
    REQUIRE(persist_homology(listed.complex, {degree, keep_zero}, {block.arena, monitor}, &out) == Status::ok);
    return {out.pairs, out.pairs + out.count};
}

template <int D>
Status pairs(const Input<D>& input, std::uint32_t degree, bool keep_zero, const std::vector<Pair>& expected,
             const Work& work) {
    CountedPairs out;
    const Status status = persist_lower_star<D>(input.filtration(), {degree, keep_zero}, work, &out);
    if (status == Status::ok) {
        REQUIRE(oracle::same(expected, out.pairs));
        work.arena.release_low(0);
    }
    return status;
}

// Each cycle against the first ones seen, which are the same in any block.
template <int D>
Status cycles(const Input<D>& input, const std::vector<Pair>& expected, std::vector<std::vector<std::uint32_t>>* seen,
              const Work& work) {
    Representatives found;
    const Status status = lower_star_cycles<D>(input.filtration(), D, expected.size(), work, &found);
    if (status != Status::ok) return status;
    const PairList& out = found.pairs;
    REQUIRE(oracle::same(expected, out));
    const bool first = seen->empty();
    for (std::uint64_t i = 0; i < out.count; ++i) {
        const Cycle cycle = lower_star_cycle(found.store, work.arena, out.pairs[i]);
        const std::vector<std::uint32_t> now(cycle.simplices,
                                             cycle.simplices + std::size_t{cycle.count} * (out.pairs[i].degree + 1));
        if (first) seen->push_back(now);
        REQUIRE((*seen)[i] == now);
    }
    work.arena.release_low(0);
    return status;
}

// Pairs with and without those of zero length, cycles, and components alone, for which stars are opened but not swept.
template <int D> void check_sizes(const Input<D>& input, std::size_t dense) {
    const std::size_t enough = std::size_t{8} << 20;
    const oracle::Explicit listed(oracle::lower_star(input.simplices(), input.value, input.zero_born));
    for (const bool keep_zero : {false, true}) {
        const auto expected = general(listed, D - 1, keep_zero);
        const auto outcome = disturbed::by_size(enough, keep_zero ? dense / 2 : dense, [&](const Work& work) {
            return pairs(input, D - 1, keep_zero, expected, work);
        });
        CHECK(outcome.refused > 50);
        if (keep_zero) continue;
        std::vector<std::vector<std::uint32_t>> seen;
        disturbed::by_size(enough, dense, [&](const Work& work) { return cycles(input, expected, &seen, work); });
    }
    const auto components = general(listed, 0, false);
    disturbed::by_size(enough, 500, [&](const Work& work) { return pairs(input, 0, false, components, work); });
}

}  // namespace

TEST_CASE("columns in blocks of all sizes, in the plane") {
    std::mt19937 random(60);
    check_sizes(random_values(grid::freudenthal<2>({9, 8}, random), 1000, 0, random), 8000);
}
TEST_CASE("columns in blocks of all sizes, in space") {
    std::mt19937 random(61);
    check_sizes(random_values(grid::freudenthal<3>({5, 5, 4}, random), 1000, 30, random), 16000);
}
TEST_CASE_TEMPLATE_DEFINE("columns in blocks of all sizes, in four dimensions", T, blocks_4) {
    constexpr int D = T::value;
    std::mt19937 random(62);
    check_sizes(random_values(grid::freudenthal<D>({3, 2, 2, 2}, random), 1000, 0, random), 16000);
}
TEST_CASE_TEMPLATE_APPLY(blocks_4, Dimensions<4, 4>);
TEST_CASE_TEMPLATE_DEFINE("columns in blocks of all sizes, in five dimensions", T, blocks_5) {
    constexpr int D = T::value;
    std::mt19937 random(63);
    check_sizes(random_values(grid::freudenthal<D>({2, 2, 1, 1, 1}, random), 1000, 0, random), 2500);
}
TEST_CASE_TEMPLATE_APPLY(blocks_5, Dimensions<5, 5>);
TEST_CASE_TEMPLATE_DEFINE("columns in blocks of all sizes, in six dimensions", T, blocks_6) {
    constexpr int D = T::value;
    std::mt19937 random(64);
    check_sizes(random_values(grid::freudenthal<D>({2, 1, 1, 1, 1, 1}, random), 1000, 0, random), 1200);
}
TEST_CASE_TEMPLATE_APPLY(blocks_6, Dimensions<6, 6>);

namespace {

template <int D> void check_part_sizes(const grid::Ball<D>& ball, std::mt19937& random) {
    const auto all = oracle::all_faces(ball.cells());
    const parts::Part<D> part(ball, parts::collapse(all, all.size() / 6, false, random), random);
    auto input = random_values(ball, 1000, 10, random);
    input.part = &part;
    check_sizes(input, 2000);
}

}  // namespace

TEST_CASE("parts in blocks of all sizes") {
    std::mt19937 random(65);
    check_part_sizes(grid::freudenthal<2>({9, 8}, random), random);
    check_part_sizes(grid::freudenthal<3>({4, 4, 4}, random), random);
    for_each_dimension<4, 4>([&](auto dim) { check_part_sizes(grid::freudenthal<dim>({2, 2, 2, 1}, random), random); });
}
TEST_CASE("large links in blocks of all sizes") {
    std::mt19937 random(62);
    for (const bool apex_first : {false, true}) {
        auto space = random_values(grid::cone_over_stack<3>(70), 1000, 0, random);
        auto four = random_values(grid::cone_over_stack<4>(66), 1000, 40, random);
        space.value.back() = four.value.back() = apex_first ? -1 : 500;
        check_sizes(space, 1000);
        for_each_dimension<4, 4>([&](auto dim) { check_sizes<dim>(four, 1000); });
    }
    // Along the stack, with the apex in between: its star is regular. Or in turns of six, and the lower link in pieces.
    for (const bool in_turns : {false, true}) {
        auto space = random_values(grid::cone_over_stack<3>(80), 1000, 0, random);
        auto four = random_values(grid::cone_over_stack<4>(80), 1000, 0, random);
        for (std::uint32_t v = 0; v < space.value.size(); ++v) space.value[v] = in_turns ? v / 6 % 2 * 100 + v % 6 : v;
        for (std::uint32_t v = 0; v < four.value.size(); ++v) four.value[v] = in_turns ? v / 6 % 2 * 100 + v % 6 : v;
        space.value.back() = four.value.back() = 40.5;
        check_sizes(space, 500);
        for_each_dimension<4, 4>([&](auto dim) { check_sizes<dim>(four, 500); });
    }
}

namespace {

template <int D>
void check_refused(const grid::Ball<D>& ball, const std::vector<double>& value, Status expected, bool surface = true) {
    const Input<D> input = {ball, value, 0, nullptr};
    Block block(std::size_t{1} << 20);
    Monitor monitor;
    std::vector<std::vector<std::uint32_t>> seen;
    CHECK(cycles(input, {{0, 1, 0, 0}}, &seen, {block.arena, monitor}) == expected);
    CHECK(block.arena.bytes_used() == 0);
    if (D == 2 && !surface) return;
    CHECK(pairs(input, D, false, {}, {block.arena, monitor}) == expected);
    CHECK(block.arena.bytes_used() == 0);
}

// Cells around vertex 0, each with `step` vertices more than the one before; each says that it is its own neighbour.
template <int D> grid::Ball<D> glued_to_themselves(std::uint32_t count, std::uint32_t step) {
    std::vector<std::array<std::uint32_t, D + 1>> cells(count);
    for (std::uint32_t c = 0; c < count; ++c) {
        cells[c][0] = 0;
        for (std::uint32_t i = 1; i <= D; ++i) cells[c][i] = c * step + i;
    }
    grid::Ball<D> ball = grid::link<D>(cells, (count - 1) * step + D + 1);
    for (std::uint32_t c = 0; c < count; ++c) {
        for (std::uint32_t i = 0; i <= D; ++i) ball.records[c * grid::Ball<D>::words + D + 1 + i] = 8 * c + i;
    }
    return ball;
}

template <int D> void check_no_balls() {
    CAPTURE(D);
    std::vector<double> value(200);
    value[0] = 1;  // everything is lower
    // The links of surfaces that are not asked for cycles are walked around and not listed.
    check_refused(glued_to_themselves<D>(12, D), value, Status::internal, false);  // 12 D vertices around 0
    for (std::uint32_t count = 7; D > 2 && count < 90; count += 1 + count / 8)
        check_refused(glued_to_themselves<D>(count, 1), value, Status::internal);  // too few cells for the faces
    std::mt19937 random(63);
    std::array<std::uint32_t, D> one;
    one.fill(1);
    grid::Ball<D> ball = grid::freudenthal<D>(one, random);
    ++ball.vertex_count;
    check_refused(ball, value, Status::invalid_argument);  // the last one is in no cell
    ball.vertex_count = 0;
    check_refused(ball, value, Status::invalid_argument);
    ball.vertex_count = 5;
    ball.records.clear();
    check_refused(ball, value, Status::invalid_argument);
}

}  // namespace

TEST_CASE("what is no ball is refused") {
    for_each_dimension([](auto dim) { check_no_balls<dim>(); });
}
