// Recursively well-paced subsets: a partition of the points, parents first, each scale as far from the next as theta
// says.
#include "filtration/scale_partition.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"

using namespace netmesh;

namespace {

template <int D> struct Held {
    explicit Held(const inputs::Points& points) : count(static_cast<std::uint32_t>(points.size() / D)) {
        REQUIRE(store.open_vertices(count) == Status::ok);
        for (std::uint32_t v = 0; v < count; ++v) std::copy_n(&points[std::size_t{v} * D], D, store.vertex(v).x);
    }
    Block block{std::size_t{1} << 22};
    StoreState state = {};
    Store<D> store{block.arena, state};
    std::uint32_t count;
};

// Copies of a grid's corners and its middle, each `ratio` times as large, about two of its own points.
template <int D> inputs::Points clumps(double ratio) {
    inputs::Points base = inputs::grid(D, 2);
    base.insert(base.end(), D, 0.5);
    inputs::Points all = base;
    for (const std::size_t about : {std::size_t{0}, std::size_t{D}})
        for (std::size_t i = 0; i < base.size(); ++i) all.push_back(base[about + i % D] + ratio * (base[i] + 0.125));
    return all;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("points of three scales", T, three) {
    constexpr int D = T::value;
    for (const double theta : {1.0 / 9, 0.02}) {
        const inputs::Points points = clumps<D>(0x1p-20);
        Held<D> held(points);
        Monitor monitor;
        ScalePartition<D> partition;
        REQUIRE(partition.open(held.store, held.count, theta, held.block.arena) == Status::ok);
        std::vector<int> chosen(held.count, 0);
        bool stopped = true;
        std::uint32_t clusters = 0;
        for (; partition.next(monitor, &stopped); ++clusters) {
            CHECK(!stopped);
            const std::uint32_t* const p = partition.chosen();
            CHECK(chosen[p[0]] == (clusters == 0 ? 0 : 1));  // the representative is its parent's
            for (std::uint32_t i = clusters == 0 ? 0 : 1; i < partition.chosen_count(); ++i) CHECK(chosen[p[i]]++ == 0);
            CHECK(partition.chosen_count() > 1);
        }
        CHECK(!stopped);
        CHECK(clusters == 3);
        CHECK(partition.clusters() == 3);
        CHECK(std::count(chosen.begin(), chosen.end(), 1) == static_cast<std::ptrdiff_t>(held.count));
        CHECK(partition.separation() >= (1 - theta) / (2 * theta) * (1 - 1e-9));
        CHECK(partition.separation() < 0x1p20);
    }
}
TEST_CASE_TEMPLATE_APPLY(three, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("one scale, what does not fit, and what is stopped", T, refused) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 1800);
    Held<D> held(points);
    Monitor monitor;
    ScalePartition<D> partition;
    REQUIRE(partition.open(held.store, 10, 1.0 / 9, held.block.arena) == Status::ok);
    bool stopped;
    REQUIRE(partition.next(monitor, &stopped));
    CHECK(partition.chosen_count() == 10);
    CHECK(!partition.next(monitor, &stopped));
    CHECK(partition.separation() == infinity);

    const std::size_t low = held.block.arena.low_mark();
    REQUIRE(held.block.arena.template take_low<unsigned char>(held.block.arena.bytes_free() - 64) != nullptr);
    CHECK(partition.open(held.store, held.count, 1.0 / 9, held.block.arena) == Status::out_of_memory);
    held.block.arena.release_low(low);

    Monitor stopping([](void*, const netmesh_progress*) { return 1; }, nullptr);
    REQUIRE(partition.open(held.store, held.count, 1.0 / 9, held.block.arena) == Status::ok);
    CHECK(!partition.next(stopping, &stopped));
    CHECK(stopped);
}
TEST_CASE_TEMPLATE_APPLY(refused, Dimensions<>);
