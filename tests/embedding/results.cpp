// Results in C++: an engine with its block, ranges of what it has made, spans of what these are made of. No exceptions,
// no memory but the block. The longest loop of eight points around a square, and how long it is.
#include <netmesh.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

netmesh::EngineIn<1 << 20> engine;  // in static memory; also in a scope, if its stack is large enough

double length_of(const netmesh_simplex& edge) {
    const auto ends = netmesh::vertices(edge);
    const netmesh_vertex from = engine.vertices()[ends[0]], to = engine.vertices()[ends[1]];
    const auto a = netmesh::coordinates(from, 2), b = netmesh::coordinates(to, 2);
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}

}  // namespace

int main() {
    constexpr std::array<float, 16> points = {0, 0, 2, 0, 2, 2, 0, 2, 1, -0.5F, 2.5F, 1, 1, 2.5F, -0.5F, 1};
    netmesh::Request alpha(&netmesh_filter_alpha);
    alpha.set_points(2, points);
    alpha.cycles = &netmesh_cycles;
    if (engine.persist(alpha) != NETMESH_OK) {
        std::puts(engine.detail().message);
        return 1;
    }
    const auto loops = engine.pairs(1);
    auto longest = loops.begin();
    for (auto bar = loops.begin(); bar != loops.end(); ++bar)
        if (bar->death - bar->birth > longest->death - longest->birth) longest = bar;
    double length = 0;
    for (const netmesh_simplex& edge : engine.cycle(longest.index())) length += length_of(edge);
    std::printf("%d vertices, %d cells, a loop from radius %.3f to %.3f of %d edges, length %.3f\n",
                static_cast<int>(engine.vertices().size()), static_cast<int>(engine.cells().size()), longest->birth,
                longest->death, static_cast<int>(engine.cycle(longest.index()).size()), length);

    // In memory from elsewhere, which goes with the engine.
    constexpr std::size_t bytes = std::size_t{1} << 20;
    netmesh::OwningEngine other(std::malloc(bytes), bytes, std::free);
    if (other.status() != NETMESH_OK) return 2;
    alpha.cycles = nullptr;
    if (other.persist(alpha) != NETMESH_OK) return 3;
    return other.pairs(1).size() == loops.size() ? 0 : 4;
}
