// What sequences of covers claim, without what interleaving tells: true bars that contain each claim, all different
// (alpha complex).
#include "jobs/certified_bars.hpp"

#include <doctest/doctest.h>

#include <string>

#include "common/dimensions.hpp"
#include "common/filtered_mesh.hpp"
#include "common/meshed.hpp"
#include "common/session.hpp"
#include "filtration/filters.hpp"
#include "filtration/tighten_cell_bounds.hpp"
#include "homology/lower_star/lower_star.hpp"
#include "oracle/log_distance.hpp"

using namespace netmesh;

namespace {

template <int D>
void claims_hold(const std::string& name, const inputs::Points& points, double tau, std::size_t least) {
    CAPTURE(name);
    Session exact(D);
    REQUIRE(exact.alpha(points) == NETMESH_OK);
    Block block(std::size_t{1} << 28);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    MeshResult<D> meshed;
    REQUIRE(mesh_points<D>(store, points.data(), points.size() / D, by_quality(tau, 1, true), {block.arena, monitor},
                           &meshed) == Status::ok);
    const Domain<D>& domain = meshed.domain;
    const std::uint32_t inputs = static_cast<std::uint32_t>(points.size() / D);
    std::vector<double> value(state.vertex_count);
    std::vector<Interval> interval(state.vertex_count);
    const FilteredMesh<D> mesh = {store, domain, inputs};
    Evaluation complete = {value.data(), interval.data()};
    REQUIRE(evaluate(mesh, {NETMESH_FILTER_COMPLETE, &complete_on_mesh, FilterValues::certified},
                     {block.arena, monitor}, &complete) == Status::ok);
    REQUIRE(tighten_cell_bounds(mesh, {block.arena, monitor}, interval.data()) == Status::ok);
    CountedPairs counted = {};
    REQUIRE(persist_lower_star<D>({store.view(), value.data(), inputs}, {D - 1}, {block.arena, monitor}, &counted) ==
            Status::ok);
    const PairList& list = counted.pairs;
    std::vector<BarBounds> bounds(list.count);
    const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
    const CertifiedBarsRequest request = {
        AnyStore(store).view(), {value.data(), interval.data(), state.vertex_count}, inputs, {list.pairs, list.count}};
    REQUIRE(find_certified_bars(request, {block.arena, monitor}, bounds.data()) == Status::ok);
    CHECK(block.arena.low_mark() == low);
    CHECK(block.arena.high_mark() == high);
    std::vector<Claim> claims;
    for (std::uint64_t i = 0; i < list.count; ++i) {
        const BarBounds& b = bounds[i];
        if (b.certain == 0) continue;
        CHECK(list.pairs[i].degree > 0);
        CHECK(b.birth_low <= list.pairs[i].birth);
        CHECK(list.pairs[i].birth <= b.birth_high);
        CHECK(b.death_low <= list.pairs[i].death);
        CHECK(list.pairs[i].death <= b.death_high);
        CHECK(b.birth_high <= b.death_low);
        claims.push_back({list.pairs[i].degree,
                          {sizeof(netmesh_bar_bounds), 1, b.birth_low, b.birth_high, b.death_low, b.death_high, 0}});
    }
    CHECK(claims.size() >= least);
    CHECK(all_real(claims, diagram(exact), 1 + 1e-9));
    MESSAGE(name << " D=" << D << ", tau " << tau << ": " << claims.size() << " claims");
}

// `count` circles of 20 points in a row.
inputs::Points circles(int count, double gap) {
    inputs::Points p;
    for (int i = 0; i < count; ++i)
        for (std::size_t j = 0; j < 20; ++j) {
            const auto [x, y] = inputs::turn(j, 20);
            p.insert(p.end(), {x + i * (2 + gap), y * (1 + 0.1 * i)});
        }
    return p;
}

}  // namespace

TEST_CASE("plane") {
    claims_hold<2>("circle", inputs::circle(60), 3.08, 1);
    claims_hold<2>("seven circles", circles(7, 0.5), 2.5, 2);
    claims_hold<2>("seven circles, close", circles(7, 0.1), 2.1, 4);
    claims_hold<2>("figure eight", inputs::eight(100, 0.05, 16), 3.08, 2);
    claims_hold<2>("annulus", inputs::shell(2, 150, 0.8, 1, 15), 2.5, 1);
    claims_hold<2>("uniform", inputs::uniform(2, 300), 2.2, 0);
    claims_hold<2>("uniform, coarse", inputs::uniform(2, 300), 4, 0);
    claims_hold<2>("grid", inputs::grid(2, 8), 2.2, 0);
    claims_hold<2>("clusters", inputs::clusters(2, 120), 2.2, 0);
}

TEST_CASE("space") {
    claims_hold<3>("sphere", inputs::shell(3, 300, 1, 1, 22), 3.08, 1);
    claims_hold<3>("torus", inputs::torus(400, 27), 2.5, 2);
    claims_hold<3>("uniform", inputs::uniform(3, 100), 2.2, 0);
}

TEST_CASE("four dimensions") {
    for_each_dimension<4, 4>([](auto dim) { claims_hold<dim>("Clifford", inputs::clifford(400), 3.5, 1); });
}
