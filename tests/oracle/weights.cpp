// Alpha diagrams of points with weights against the exact ones of GUDHI, which are powers. NETMESH_WEIGHT_CLOUDS=200:
// 200 clouds of up to 5,000 points; without it a few of up to 600.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "common/inputs.hpp"
#include "netmesh.hpp"
#include "oracle/bars.hpp"
#include "oracle/peers/gudhi_tree.hpp"

namespace {

using oracle::Bars;

Bars bars_of_peer(int dim, const inputs::Points& points, const inputs::Points& weights) {
    Gudhi::Simplex_tree<> tree;
    make_gudhi_tree(dim, points, weights, &tree);
    return oracle::bars_of_tree(tree, false);
}

Bars bars_of_engine(int dim, const inputs::Points& points, const inputs::Points& weights, std::uint64_t* hidden) {
    netmesh::Request request(&netmesh_filter_alpha);
    request.set_points(static_cast<std::uint32_t>(dim), points).set_weights(&netmesh_weights, weights);
    request.squares = 1;
    std::vector<long double> memory((netmesh::plan(request) + (std::size_t(1) << 22)) / sizeof(long double));
    netmesh::Engine engine(memory.data(), memory.size() * sizeof(long double));
    REQUIRE(engine.persist(request) == NETMESH_OK);
    auto report = netmesh::sized<netmesh_report>();
    netmesh_get_report(engine.context(), &report);
    *hidden += report.input.hidden;
    Bars bars;
    for (const netmesh_pair& pair : engine.pairs())
        bars.push_back({static_cast<int>(pair.degree), pair.birth, pair.death});
    return bars;
}

}  // namespace

TEST_CASE("diagrams of weighted points are GUDHI's") {
    const char* const asked = std::getenv("NETMESH_WEIGHT_CLOUDS");
    const int clouds = asked != nullptr ? std::atoi(asked) : 14;
    const std::size_t most = asked != nullptr ? 5000 : 600;
    std::uint64_t hidden = 0;
    std::size_t compared = 0;
    for (int i = 0; i < clouds; ++i) {
        inputs::Random random(static_cast<std::uint64_t>(i) + 1);
        const int dim = 2 + static_cast<int>(random.below(i % 10 == 9 ? 3 : 2));
        std::size_t n = 20 + random.below(most - 20);
        if (dim == 4) n = n / 10 + 10;
        const int kind = static_cast<int>(random.below(3));
        const inputs::Points points = kind == 0   ? inputs::uniform(dim, n, random.bits())
                                      : kind == 1 ? inputs::gaussian(dim, n, random.bits())
                                                  : inputs::clusters(dim, n, random.bits());
        n = points.size() / static_cast<std::size_t>(dim);
        // From a hundredth to ten times the square of the spacing.
        const double spacing2 = std::pow(static_cast<double>(n), -2.0 / dim);
        const double size = spacing2 * std::pow(10.0, 3 * random.uniform() - 2), low = random.below(2) == 0 ? 0 : -1;
        inputs::Points weights(n);
        for (double& w : weights) w = size * (low + (1 - low) * random.uniform());
        INFO("cloud " << i << ", " << dim << "D, " << n << " points, weights of " << size);
        const double slack = 1e-12 * (kind == 1 ? 100 : 1);
        const Bars ours = oracle::long_ones(bars_of_engine(dim, points, weights, &hidden), slack);
        const Bars theirs = oracle::long_ones(bars_of_peer(dim, points, weights), slack);
        REQUIRE(ours.size() == theirs.size());
        CHECK(oracle::count_unlike(ours, theirs, slack) == 0);
        compared += ours.size();
    }
    CHECK(hidden > 0);
    MESSAGE(clouds << " clouds, " << compared << " bars, " << hidden << " hidden points");
}
