// Filtrations on points: what becomes of equal points, and ratios that barycentric Rips complexes have.
#include "jobs/diagram_of_points.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/block.hpp"
#include "common/inputs.hpp"

using namespace netmesh;

namespace {

struct Listed {
    std::vector<Pair> pairs;
    std::vector<std::vector<std::uint32_t>> cycles;  // of each pair, the vertices of its simplices
    double ratio;
    std::uint32_t distinct;
};

Listed persist(std::uint32_t dim, const inputs::Points& points, const PointsFilter& filter, bool representatives) {
    Block block(std::size_t{1} << 22);
    Monitor monitor;
    PointsDiagram out;
    const PointsRequest request = {
        filter, points.data(), static_cast<std::uint32_t>(points.size() / dim), dim, HUGE_VAL, false, representatives};
    REQUIRE(diagram_of_points(request, {block.arena, monitor}, &out) == Status::ok);
    Listed listed = {{}, {}, out.ratio, out.distinct};
    const PairList& pairs = out.diagram.pairs;
    listed.pairs.assign(pairs.pairs, pairs.pairs + pairs.count);
    for (std::uint64_t i = 0; i < pairs.count && representatives; ++i) {
        const FilteredComplex complex = out.complex.filtered();
        const Cycle cycle = cycle_of(complex, out.diagram.cycles, block.arena, pairs.pairs[i]);
        std::vector<std::uint32_t> vertices;
        for (std::uint32_t n = 0; n < cycle.count; ++n) {
            std::vector<std::uint32_t> simplex(pairs.pairs[i].degree + 1);
            vertices_of(complex, out.complex.rows[0], pairs.pairs[i].degree, cycle.simplices[n], simplex.data());
            vertices.insert(vertices.end(), simplex.begin(), simplex.end());
        }
        listed.cycles.push_back(vertices);
    }
    return listed;
}

}  // namespace

TEST_CASE("equal points are merged into the first of them, which keeps its number among the distinct ones") {
    inputs::Random random(5);
    for (int round = 0; round < 20; ++round) {
        const inputs::Points distinct = inputs::uniform(2, 9, 50 + static_cast<std::uint64_t>(round));
        inputs::Points repeated;
        for (std::size_t next = 0; next < 9;) {
            // An old one again, or the next one for the first time.
            const std::size_t i = next > 0 && random.below(2) == 0 ? random.below(next) : next++;
            repeated.insert(repeated.end(), {distinct[2 * i], distinct[2 * i + 1]});
        }
        for (const netmesh_filter_id kind : {NETMESH_FILTER_RIPS, NETMESH_FILTER_CECH}) {
            const PointsFilter filter = {kind, FilterValues::certified, 0, 1};
            const Listed once = persist(2, distinct, filter, true), often = persist(2, repeated, filter, true);
            CHECK(often.distinct == 9);
            REQUIRE(often.pairs.size() == once.pairs.size());
            for (std::size_t i = 0; i < once.pairs.size(); ++i) {
                CHECK(often.pairs[i].birth == once.pairs[i].birth);
                CHECK(often.pairs[i].death == once.pairs[i].death);
            }
            CHECK(often.cycles == once.cycles);
        }
    }
}

// The corners of a regular simplex are D + 1 points whose balls meet at sqrt(D / (2 D + 2)) times an edge, their edges
// are there at half of it: the whole set, which is the only one of D + 1 points, enters at one or the other.
TEST_CASE("barycentric Rips complexes are within the ratio that is told, for both kinds of values") {
    for (const std::uint32_t dim : {2u, 3u}) {
        CAPTURE(dim);
        const inputs::Points corners =
            dim == 2 ? inputs::circle(3) : inputs::Points{1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
        const auto only = [&](netmesh_filter_id kind, FilterValues values) {
            const Listed found = persist(dim, corners, {kind, values, dim + 1, 0}, false);
            REQUIRE(found.pairs.size() == 1);
            return std::pair<double, double>(found.pairs[0].birth, found.ratio);
        };
        const auto cech = only(NETMESH_FILTER_BARYCENTRIC_CECH, FilterValues::certified);
        CHECK(cech.second == 1);
        CHECK(cech.first == doctest::Approx(dim == 2 ? 1 : std::sqrt(3.0)).epsilon(1e-12));
        for (const FilterValues values : {FilterValues::certified, FilterValues::thesis}) {
            const auto rips = only(NETMESH_FILTER_BARYCENTRIC_RIPS, values);
            CHECK(rips.first <= cech.first * rips.second);
            CHECK(cech.first <= rips.first * rips.second);
            if (values == FilterValues::thesis)
                CHECK(rips.first == doctest::Approx(dim == 2 ? std::sqrt(3.0) / 2 : std::sqrt(2.0)).epsilon(1e-12));
        }
    }
}
