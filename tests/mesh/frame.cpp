// The frame around everything, by looking at all of it.
#include "mesh/loop/frame.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "common/dimensions.hpp"
#include "common/meshed.hpp"
#include "delaunay/sphere.hpp"
#include "numerics/vector.hpp"

using namespace netmesh;

TEST_CASE_TEMPLATE_DEFINE("vertices of the frame know their nearest neighbour and input, and their hull is wide", T,
                          frames) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 15);
    Block block(std::size_t{1} << 22);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    std::uint32_t* order;
    REQUIRE(take_input<D>(store, points.data(), 15, 1, monitor, &input, &order) == Status::ok);
    InputTree<D> tree;
    REQUIRE(tree.build(store, block.arena, 15) == Status::ok);
    Domain<D> domain;
    smallest_enclosing_ball<D>(store, 15, domain);
    domain.radius = domain.enclosing_radius;
    REQUIRE(store.open_cells() == Status::ok);
    const double reach = figures<D>.frame_factor * domain.radius;
    std::uint64_t steps = 0;
    REQUIRE(open_frame(store, tree, domain, reach, &steps) == Status::ok);
    REQUIRE(state.vertex_count == 15 + 2 * D);
    for (std::uint32_t v = 15; v < state.vertex_count; ++v) {
        CAPTURE(v);
        double nearest2 = infinity, input2 = infinity;
        for (std::uint32_t w = 0; w < state.vertex_count; ++w) {
            const double d2 = distance2<D>(store.point(v), store.point(w));
            if (w != v && w >= 15) nearest2 = std::min(nearest2, d2);
            if (w < 15) input2 = std::min(input2, d2);
        }
        CHECK(store.vertex(v).nearest2 == nearest2);
        CHECK(distance2<D>(store.point(v), store.point(store.vertex(v).origin)) == input2);
        CHECK(store.vertex(v).marker == Marker::exempt);
        CHECK(store.vertex(v).cell != none);
        CHECK(distance<D>(store.point(v), domain.centre) == doctest::Approx(reach).epsilon(1e-12));
    }
    CHECK(reach / std::sqrt(double(D)) > 2.2 * domain.radius);
}
TEST_CASE_TEMPLATE_APPLY(frames, Dimensions<>);
