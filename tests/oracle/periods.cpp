// Alpha diagrams of points in a cube with periods against the exact ones of GUDHI, which are powers.
// NETMESH_PERIODIC_CLOUDS=60: 60 clouds of up to 20,000 points; without it a few of up to 1,500.
#include <gudhi/Alpha_complex_3d.h>

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "common/inputs.hpp"
#include "netmesh.hpp"
#include "oracle/bars.hpp"

namespace {

using oracle::Bars;

template <class Complex> Bars bars_of_complex(Complex& complex) {
    Gudhi::Simplex_tree<> tree;
    REQUIRE(complex.create_complex(tree));
    return oracle::bars_of_tree(tree, true);
}

Bars bars_of_peer(const inputs::Points& points, const inputs::Points& weights) {
    constexpr auto exact = Gudhi::alpha_complex::complexity::EXACT;
    if (weights.empty()) {
        using Complex = Gudhi::alpha_complex::Alpha_complex_3d<exact, false, true>;
        std::vector<typename Complex::Bare_point_3> rows;
        for (std::size_t i = 0; i < points.size(); i += 3) rows.emplace_back(points[i], points[i + 1], points[i + 2]);
        Complex complex(rows, 0, 0, 0, 1, 1, 1);
        return bars_of_complex(complex);
    }
    using Complex = Gudhi::alpha_complex::Alpha_complex_3d<exact, true, true>;
    std::vector<typename Complex::Bare_point_3> rows;
    for (std::size_t i = 0; i < points.size(); i += 3) rows.emplace_back(points[i], points[i + 1], points[i + 2]);
    Complex complex(rows, weights, 0, 0, 0, 1, 1, 1);
    return bars_of_complex(complex);
}

Bars bars_of_engine(const inputs::Points& points, const inputs::Points& weights, std::uint64_t* copies) {
    const std::vector<double> cube = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    netmesh::Request request(&netmesh_filter_alpha);
    request.set_points(3, points).set_lattice(cube);
    if (!weights.empty()) {
        request.set_weights(&netmesh_weights, weights);
        request.squares = 1;
    }
    std::vector<long double> memory((netmesh::plan(request) + (std::size_t(1) << 23)) / sizeof(long double));
    netmesh::Engine engine(memory.data(), memory.size() * sizeof(long double));
    REQUIRE(engine.persist(request) == NETMESH_OK);
    auto report = netmesh::sized<netmesh_report>();
    netmesh_get_report(engine.context(), &report);
    *copies += report.input.copies;
    CHECK(report.input.moved == 0);
    Bars bars;
    const auto power = [&](double r) { return weights.empty() ? r * r : r; };
    for (const netmesh_pair& pair : engine.pairs())
        bars.push_back({static_cast<int>(pair.degree), power(pair.birth), power(pair.death)});
    return bars;
}

}  // namespace

TEST_CASE("diagrams of points in a cube with periods are GUDHI's") {
    const char* const asked = std::getenv("NETMESH_PERIODIC_CLOUDS");
    const int clouds = asked != nullptr ? std::atoi(asked) : 6;
    const std::size_t most = asked != nullptr ? 20000 : 1500;
    std::uint64_t copies = 0;
    std::size_t compared = 0;
    for (int i = 0; i < clouds; ++i) {
        inputs::Random random(static_cast<std::uint64_t>(i) + 1);
        // Copies are doubles: coordinates have 40 places.
        const std::size_t side = 7 + random.below(5);
        const bool is_grid = i % 3 == 2;
        const std::size_t n = is_grid ? side * side * side : 400 + random.below(most - 400);
        inputs::Points points(3 * n), weights;
        const auto place = [&random] { return std::floor(random.uniform() * 0x1p40) * 0x1p-40; };
        for (double& x : points) x = place();
        if (is_grid)  // each point moved by up to half of its spacing
            for (std::size_t k = 0; k < points.size(); ++k) {
                std::size_t at = k / 3;
                for (std::size_t c = k % 3; c > 0; --c) at /= side;
                const double x = (static_cast<double>(at % side) + 0.5 * points[k]) / static_cast<double>(side);
                points[k] = std::floor(x * 0x1p40) * 0x1p-40;
            }
        // The peer takes weights from 0 to 1/64 of the square of the side, and lets a point enter at less than its
        // weight where another ball covers it by then; on grids with such weights none does.
        if (i % 6 == 5)
            for (std::size_t k = 0; k < n; ++k)
                weights.push_back(0.06 * random.uniform() / static_cast<double>(side * side));
        INFO("cloud " << i << ", " << n << " points, weights: " << weights.size());
        const double slack = 1e-13;
        const Bars ours = oracle::long_ones(bars_of_engine(points, weights, &copies), slack);
        const Bars theirs = oracle::long_ones(bars_of_peer(points, weights), slack);
        REQUIRE(ours.size() == theirs.size());
        CHECK(oracle::count_unlike(ours, theirs, slack) == 0);
        compared += ours.size();
    }
    CHECK(copies > 0);
    MESSAGE(clouds << " clouds, " << compared << " bars, " << copies << " copies");
}
