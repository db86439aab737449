// Vertices per input of quality meshes by plain refinement, over several seeds of the points and of the order of their
// insertion, and processor time per vertex. The counts are what meshing is tuned by: they do not depend on the machine.
//
//   sizes [seeds of a row, 5] [rows whose name begins with.., all] [tau, all]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>

#include "common/inputs.hpp"
#include "common/mesh_points.hpp"
#include "common/mesh_requests.hpp"
#include "mesh/check/quality.hpp"
#include "vocabulary/dimension.hpp"

using namespace netmesh;

namespace {

// The closed curve (cos t, sin t, cos 2t, ..), n points evenly.
inputs::Points curve(int dim, std::size_t n) {
    inputs::Points p;
    for (std::size_t i = 0; i < n; ++i)
        for (int k = 0; k < dim; ++k) {
            const auto [c, s] = inputs::turn(i * static_cast<std::size_t>(k / 2 + 1), n);
            p.push_back(k % 2 == 0 ? c : s);
        }
    return p;
}

// Uniform in the unit ball.
inputs::Points ball(int dim, std::size_t n, std::uint64_t seed) {
    inputs::Random random(seed);
    inputs::Points p, x(static_cast<std::size_t>(dim));
    while (p.size() < n * static_cast<std::size_t>(dim)) {
        double squared = 0;
        for (double& c : x) {
            c = 2 * random.uniform() - 1;
            squared += c * c;
        }
        if (squared <= 1) p.insert(p.end(), x.begin(), x.end());
    }
    return p;
}

struct Row {
    const char* name;
    int dim;
    char shape;
    std::size_t n;
    double taus[4];
};

constexpr Row rows[] = {
    {"2D ball 2000", 2, 'b', 2000, {3.08, 2.5, 2.2, 2.05}},
    {"2D clusters 2000", 2, 'k', 2000, {3.08, 2.5, 2.2, 2.05}},
    {"3D ball 1000", 3, 'b', 1000, {3.08, 2.5, 2.2}},
    {"3D clusters 1000", 3, 'k', 1000, {3.08, 2.5}},
    {"3D sphere 1000", 3, 's', 1000, {3.08, 2.5, 2.2}},
    {"3D curve 1000", 3, 'c', 1000, {3.08, 2.5, 2.2}},
    {"4D ball 200", 4, 'b', 200, {4, 3.08, 2.5, 2.2}},
    {"4D curve 300", 4, 'c', 300, {4, 3.08, 2.5}},
    {"4D Clifford 2000", 4, 't', 2000, {3.08}},
    {"5D ball 50", 5, 'b', 50, {4, 3.08}},
    {"5D curve 100", 5, 'c', 100, {4}},
    {"6D ball 20", 6, 'b', 20, {4}},
};

inputs::Points points_of(const Row& row, std::uint64_t seed) {
    switch (row.shape) {
    case 'b': return ball(row.dim, row.n, seed);
    case 'k': return inputs::clusters(row.dim, row.n, seed);
    case 's': return inputs::shell(row.dim, row.n, 1, 1, seed);
    case 'c': return curve(row.dim, row.n);
    default: return inputs::clifford(row.n);
    }
}

struct Trial {
    Status status;
    double vertices, cells, seconds, worst;
};

template <int D> Trial mesh(const inputs::Points& points, double tau, std::uint64_t seed) {
    constexpr std::size_t bytes = std::size_t{1} << 32;  // what is not touched costs nothing
    const std::unique_ptr<void, decltype(&std::free)> block(std::aligned_alloc(16, bytes), &std::free);
    Arena arena;
    arena.adopt(static_cast<unsigned char*>(block.get()), bytes);
    StoreState state = {};
    Store<D> store(arena, state);
    Monitor monitor;
    MeshResult<D> result;
    const std::clock_t start = std::clock();
    Trial trial = {};
    trial.status = mesh_points<D>(store, points.data(), points.size() / D, by_quality(tau, 1, false, seed),
                                  {arena, monitor}, &result);
    trial.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    trial.vertices = state.vertex_count;
    trial.cells = state.cell_slots;
    std::uint32_t vertex;
    if (trial.status == Status::ok)
        trial.status = worst_aspect_ratio(store, result.domain, arena, &trial.worst, &vertex);
    return trial;
}

Trial mesh(int dim, const inputs::Points& points, double tau, std::uint64_t seed) {
    return with_dimension(static_cast<std::uint32_t>(dim),
                          [&](auto dimension) { return mesh<decltype(dimension)::value>(points, tau, seed); });
}

void measure(const Row& row, double tau, std::uint64_t seeds) {
    const double n = static_cast<double>(row.n);
    double sum = 0, least = 1e300, most = 0, vertices = 0, cells = 0, seconds = 0, worst = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Trial trial = mesh(row.dim, points_of(row, seed), tau, seed);
        if (trial.status != Status::ok) {
            std::printf("%-17s %5.2f  no mesh after %.0f vertices\n", row.name, tau, trial.vertices);
            return;
        }
        const double share = trial.vertices / n;
        sum += share;
        least = std::min(least, share);
        most = std::max(most, share);
        vertices += trial.vertices;
        cells += trial.cells;
        seconds += trial.seconds;
        worst = std::max(worst, trial.worst);
    }
    std::printf("%-17s %5.2f %8.3f %8.3f %8.3f %8.2f %8.2f %8.3f %8.4f\n", row.name, tau,
                sum / static_cast<double>(seeds), least, most, cells / vertices, 1e6 * seconds / vertices,
                seconds / static_cast<double>(seeds), worst);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const std::uint64_t seeds = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 5;
    const char* const name = argc > 2 ? argv[2] : "";
    const double only = argc > 3 ? std::atof(argv[3]) : 0;
    std::printf("%-17s %5s %8s %8s %8s %8s %8s %8s %8s\n", "vertices / input", "tau", "mean", "least", "most",
                "cells/v", "us/v", "s", "worst");
    for (const Row& row : rows) {
        if (std::strncmp(row.name, name, std::strlen(name)) != 0) continue;
        if (!serves_dimension(static_cast<std::uint32_t>(row.dim))) continue;
        for (const double tau : row.taus)
            if (tau > 0 && (!(only > 0) || tau == only)) measure(row, tau, seeds);
    }
    return 0;
}
