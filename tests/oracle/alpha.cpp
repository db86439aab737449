// The alpha filter against GUDHI, whose values are exact squares of ours rounded to double.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/session.hpp"
#include "complex/triangulations.hpp"
#include "filtration/alpha.hpp"
#include "oracle/peers/gudhi.hpp"

namespace {

using Simplex = std::vector<std::uint32_t>;

struct Bar {
    double birth, death;
};
using Diagram = std::vector<std::vector<Bar>>;  // by degree

struct Peer {
    std::map<Simplex, double> value;  // radii
    Diagram bars;
};

Peer peer_of(int dim, const inputs::Points& points) {
    GudhiAlpha alpha(dim, points);
    Peer peer;
    for (GudhiAlpha::Simplex& simplex : alpha.simplices) {
        std::sort(simplex.vertices.begin(), simplex.vertices.end());
        peer.value[simplex.vertices] = simplex.radius;
    }
    peer.bars.resize(static_cast<std::size_t>(dim));
    for (const GudhiAlpha::Bar& bar : alpha.bars) {
        REQUIRE(bar.degree < dim);
        peer.bars[static_cast<std::size_t>(bar.degree)].push_back({bar.birth, bar.death});
    }
    return peer;
}

bool near(double a, double b, double slack) { return a == b || std::fabs(a - b) <= slack; }

// How many bars of `from` that are longer than the tolerance have no partner of their own in `to`.
std::size_t unmatched(const std::vector<Bar>& from, const std::vector<Bar>& to, double tolerance) {
    std::vector<Bar> sorted = to;
    std::sort(sorted.begin(), sorted.end(), [](const Bar& a, const Bar& b) { return a.birth < b.birth; });
    std::vector<bool> taken(sorted.size(), false);
    std::size_t count = 0;
    for (const Bar& bar : from) {
        const double slack = tolerance * (bar.death < HUGE_VAL ? bar.death : bar.birth);
        if (bar.death - bar.birth <= 4 * slack) continue;
        auto it = std::lower_bound(sorted.begin(), sorted.end(), bar.birth - slack,
                                   [](const Bar& a, double b) { return a.birth < b; });
        // The nearest one that is free: bars of a jittered grid lie closer together than the tolerance.
        std::size_t best = sorted.size();
        double best_distance = HUGE_VAL;
        for (; it != sorted.end() && it->birth <= bar.birth + slack; ++it) {
            const auto i = static_cast<std::size_t>(it - sorted.begin());
            if (taken[i] || !near(it->death, bar.death, slack)) continue;
            const double distance =
                std::fabs(it->birth - bar.birth) + (it->death == bar.death ? 0 : std::fabs(it->death - bar.death));
            if (distance < best_distance) {
                best_distance = distance;
                best = i;
            }
        }
        if (best < sorted.size()) {
            taken[best] = true;
        } else {
            ++count;
        }
    }
    return count;
}

constexpr double tolerance = 1e-9;

void compare_diagrams(const Diagram& ours, const Diagram& theirs) {
    for (std::size_t k = 0; k < theirs.size(); ++k) {
        CAPTURE(k);
        const std::vector<Bar> mine = k < ours.size() ? ours[k] : std::vector<Bar>();
        CHECK(unmatched(mine, theirs[k], tolerance) == 0);
        CHECK(unmatched(theirs[k], mine, tolerance) == 0);
    }
}

// Values on GUDHI's own triangulation, simplex by simplex. Radii of slivers on the hull that are 10^12 times as large
// as the point set are only known to be large: there 106 bits run out.
template <int D> void compare_values(const inputs::Points& points, const Peer& peer) {
    using namespace netmesh;
    netmesh_test::Cells<D> cells;
    cells.vertex_count = static_cast<std::uint32_t>(points.size() / D);
    for (const auto& entry : peer.value) {
        if (entry.first.size() != D + 1) continue;
        std::array<std::uint32_t, D + 1> cell;
        std::copy(entry.first.begin(), entry.first.end(), cell.begin());
        cells.list.push_back(cell);
    }
    Block block(std::size_t(1) << 25);
    Monitor monitor;
    Faces<D> faces;
    REQUIRE(enumerate_faces<D>(cells.view(), D, {block.arena, monitor}, &faces) == Status::ok);
    double* value[D + 1];
    for (int k = 0; k <= D; ++k) value[k] = block.arena.template take_low<double>(faces.count[k]);
    REQUIRE(alpha_values<D>(faces, points.data(), sizeof(double) * D, {block.arena, monitor}, value) == Status::ok);
    std::size_t compared = 0, differ = 0;
    for (int k = 0; k <= D; ++k)
        for (std::uint32_t i = 0; i < faces.count[k]; ++i) {
            Simplex simplex(static_cast<std::size_t>(k) + 1);
            faces.vertices(k, i, simplex.data());
            const double theirs = peer.value.at(simplex);
            ++compared;
            differ += theirs < 1e12 ? !near(value[k][i], theirs, tolerance * theirs) : !(value[k][i] > 1e11);
        }
    CHECK(differ == 0);
    CHECK(compared == peer.value.size());
}

template <int D> void compare(const std::string& name, const inputs::Points& points) {
    CAPTURE(D);
    CAPTURE(name);
    const Peer peer = peer_of(D, points);
    compare_values<D>(points, peer);
    Session session(D);
    REQUIRE(session.alpha(points) == NETMESH_OK);
    Diagram ours(D);
    std::size_t zero_length = 0, essential = 0;
    for (const netmesh_pair& pair : session.pairs()) {
        ours[pair.degree].push_back({pair.birth, pair.death});
        zero_length += !(pair.birth < pair.death);
        essential += pair.death == HUGE_VAL;
    }
    CHECK(zero_length == 0);
    CHECK(essential == 1);
    compare_diagrams(ours, peer.bars);
}

}  // namespace

TEST_CASE("plane") {
    compare<2>("uniform", inputs::uniform(2, 600));
    compare<2>("noisy circle", inputs::shell(2, 300, 1, 1.05, 11));
    compare<2>("circle", inputs::circle(101));
    compare<2>("clusters", inputs::clusters(2, 400));
    compare<2>("grid", inputs::grid(2, 16));
    compare<2>("grid, jitter 0.1", inputs::jittered(2, 16, 0.1, 12));
    compare<2>("grid, jitter 1e-9", inputs::jittered(2, 16, 1e-9, 13));
    compare<2>("grid, jitter 1e-15", inputs::jittered(2, 16, 1e-15, 14));
    compare<2>("annulus", inputs::shell(2, 400, 0.6, 1, 15));
    compare<2>("figure eight", inputs::eight(200, 0.05, 16));
    compare<2>("on one circle", inputs::cospherical(2, 5 * 5 * 13 * 17));
    compare<2>("zoom", inputs::zoom(2, 60, 1));
}

TEST_CASE("space") {
    compare<3>("uniform", inputs::uniform(3, 300));
    compare<3>("noisy sphere", inputs::shell(3, 200, 1, 1.02, 21));
    compare<3>("sphere", inputs::shell(3, 150, 1, 1, 22));
    compare<3>("clusters", inputs::clusters(3, 200));
    compare<3>("grid", inputs::grid(3, 5));
    compare<3>("grid, jitter 0.1", inputs::jittered(3, 6, 0.1, 23));
    compare<3>("grid, jitter 1e-9", inputs::jittered(3, 5, 1e-9, 24));
    compare<3>("grid, jitter 1e-15", inputs::jittered(3, 5, 1e-15, 25));
    compare<3>("shell", inputs::shell(3, 250, 0.6, 1, 26));
    compare<3>("torus", inputs::torus(300, 27));
    compare<3>("on one sphere", inputs::cospherical(3, 14));
    compare<3>("zoom", inputs::zoom(3, 60, 1));
}

TEST_CASE("higher dimensions") {
    for_each_dimension<4, 4>([&](auto dim) { compare<dim>("uniform", inputs::uniform(4, 60)); });
    for_each_dimension<4, 4>([&](auto dim) { compare<dim>("grid", inputs::grid(4, 3)); });
    for_each_dimension<4, 4>([&](auto dim) { compare<dim>("Clifford helix", inputs::clifford(80)); });
    for_each_dimension<5, 5>([&](auto dim) { compare<dim>("uniform", inputs::uniform(5, 30)); });
    for_each_dimension<6, 6>([&](auto dim) { compare<dim>("uniform", inputs::uniform(6, 18)); });
}
