// Cost of lower-star persistence in processor time per simplex, on a Freudenthal grid of R^D with the distance to a
// sample of a Clifford torus (projected to R^D) at jittered grid points as values.
//
//   homology [cubes per axis, 17] [sample, 2000] [jitter in grid steps, 0.3] [shuffle, 0] [D, 4]
//
// A large jitter makes the values noise.
// shuffle 1 puts the cells into random order, 2 the vertices too: what a mesh without locality costs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <numeric>
#include <random>
#include <vector>

#include "homology/lower_star/lower_star.hpp"

namespace {

template <int D> constexpr std::size_t stride = 8 * (D + 1) + 8 * (D + 2);  // as in a mesh: with a centre and a radius
constexpr std::uint32_t factorial(int n) { return n == 0 ? 1 : std::uint32_t(n) * factorial(n - 1); }
template <int D> constexpr std::uint32_t orders = factorial(D);

template <int D> struct Grid {
    std::uint32_t cubes, vertex_count, cell_count;
    std::vector<unsigned char> records;
    std::vector<double> value;
    int axes[orders<D>][D];

    std::uint32_t order_index(const int* a) const {
        for (std::uint32_t o = 0; o < orders<D>; ++o) {
            if (std::equal(a, a + D, axes[o])) return o;
        }
        std::abort();
    }
};

template <int D> Grid<D> make_grid(std::uint32_t cubes, int shuffle) {
    Grid<D> g;
    g.cubes = cubes;
    std::uint32_t cube_count = 1, side = cubes + 1;
    g.vertex_count = 1;
    for (int d = 0; d < D; ++d) {
        cube_count *= cubes;
        g.vertex_count *= side;
    }
    g.cell_count = cube_count * orders<D>;
    int a[D];
    std::iota(a, a + D, 0);
    for (std::uint32_t o = 0; o < orders<D>; ++o, std::next_permutation(a, a + D)) std::copy(a, a + D, g.axes[o]);
    std::mt19937 random(5);
    std::vector<std::uint32_t> cell_name(g.cell_count), vertex_name(g.vertex_count);
    std::iota(cell_name.begin(), cell_name.end(), 0u);
    std::iota(vertex_name.begin(), vertex_name.end(), 0u);
    if (shuffle >= 1) std::shuffle(cell_name.begin(), cell_name.end(), random);
    if (shuffle >= 2) std::shuffle(vertex_name.begin(), vertex_name.end(), random);
    std::uint32_t step[D], cube_step[D];
    for (int d = 0; d < D; ++d) {
        step[d] = d == 0 ? 1 : step[d - 1] * side;
        cube_step[d] = d == 0 ? 1 : cube_step[d - 1] * cubes;
    }
    std::uint32_t next_order[orders<D>][D + 1];
    for (std::uint32_t o = 0; o < orders<D>; ++o) {
        const int* x = g.axes[o];
        for (int i = 1; i < D; ++i) {
            int y[D];
            std::copy(x, x + D, y);
            std::swap(y[i - 1], y[i]);
            next_order[o][i] = g.order_index(y);
        }
        int up[D], down[D];
        std::rotate_copy(x, x + 1, x + D, up);
        std::rotate_copy(x, x + D - 1, x + D, down);
        next_order[o][0] = g.order_index(up);
        next_order[o][D] = g.order_index(down);
    }
    g.records.assign(g.cell_count * stride<D>, 0);
    for (std::uint32_t cube = 0; cube < cube_count; ++cube) {
        std::uint32_t at[D], corner = 0;
        for (int d = 0; d < D; ++d) {
            at[d] = cube / cube_step[d] % cubes;
            corner += at[d] * step[d];
        }
        for (std::uint32_t o = 0; o < orders<D>; ++o) {
            std::uint32_t record[2 * (D + 1)];
            std::uint32_t v = corner;
            for (int i = 0; i <= D; ++i) {
                record[i] = vertex_name[v];
                if (i < D) v += step[g.axes[o][i]];
                std::uint32_t& word = record[D + 1 + i];
                if (i > 0 && i < D) {
                    word = 8 * cell_name[cube * orders<D> + next_order[o][i]] + std::uint32_t(i);
                } else if (i == 0) {
                    const int d = g.axes[o][0];
                    word = at[d] + 1 == cubes ? netmesh::none
                                              : 8 * cell_name[(cube + cube_step[d]) * orders<D> + next_order[o][0]] + D;
                } else {
                    const int d = g.axes[o][D - 1];
                    word = at[d] == 0 ? netmesh::none
                                      : 8 * cell_name[(cube - cube_step[d]) * orders<D> + next_order[o][D]];
                }
            }
            std::memcpy(&g.records[cell_name[cube * orders<D> + o] * stride<D>], record, sizeof record);
        }
    }
    g.value.resize(g.vertex_count);
    return g;
}

template <int D> void fill_values(Grid<D>& g, std::uint32_t sample, double jitter, int shuffle) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<std::array<double, 6>> points(sample);
    for (auto& p : points) {
        const double turn = 6.283185307179586;
        const double a = turn * unit(random), b = turn * unit(random), c = turn * unit(random);
        p = {std::cos(a), std::sin(a), std::cos(b), std::sin(b), std::cos(c), std::sin(c)};
    }
    std::vector<std::uint32_t> name(g.vertex_count);
    std::iota(name.begin(), name.end(), 0u);
    if (shuffle >= 2) {
        std::mt19937 same(5);
        std::vector<std::uint32_t> cells(g.cell_count);
        std::iota(cells.begin(), cells.end(), 0u);
        std::shuffle(cells.begin(), cells.end(), same);
        std::shuffle(name.begin(), name.end(), same);
    }
    for (std::uint32_t v = 0; v < g.vertex_count; ++v) {
        double x[D];
        for (std::uint32_t d = 0, rest = v; d < D; ++d, rest /= g.cubes + 1) {
            x[d] = -1.5 + 3 * (rest % (g.cubes + 1) + jitter * (unit(random) - 0.5)) / g.cubes;
        }
        double best = 1e300;
        for (const auto& p : points) {
            double s = 0;
            for (int d = 0; d < D; ++d) s += (x[d] - p[d]) * (x[d] - p[d]);
            best = std::min(best, s);
        }
        g.value[name[v]] = std::sqrt(best);
    }
}

template <int D> int measure(std::uint32_t cubes, std::uint32_t sample, double jitter, int shuffle) {
    Grid<D> g = make_grid<D>(cubes, shuffle);
    fill_values<D>(g, sample, jitter, shuffle);
    const netmesh::TriangulationView<D> view = {g.records.data(), stride<D>, g.cell_count, g.vertex_count};
    std::vector<unsigned char> block(std::size_t{24} * 8 * g.cell_count + (1 << 20));
    const std::size_t skip = (16 - reinterpret_cast<std::uintptr_t>(block.data()) % 16) % 16;
    std::memset(block.data(), 1, block.size());  // the pages are there before the clock runs
    double best[2] = {1e300, 1e300};
    std::size_t peak[2] = {0, 0};
    netmesh::CountedPairs out = {};
    std::uint64_t pairs[D] = {};
    for (int round = 0; round < 6; ++round) {
        netmesh::Arena arena;
        arena.adopt(block.data() + skip, block.size() - 16);
        netmesh::Monitor monitor;
        const std::clock_t begin = std::clock();
        const std::uint32_t max_degree = round % 2 == 0 ? D - 1 : 0;
        const auto status =
            netmesh::persist_lower_star<D>({view, g.value.data(), 0}, {max_degree}, {arena, monitor}, &out);
        const double took = double(std::clock() - begin) / CLOCKS_PER_SEC;
        if (status != netmesh::Status::ok) {
            std::printf("status %d\n", int(status));
            return 1;
        }
        best[round % 2] = std::min(best[round % 2], took);
        peak[round % 2] = arena.bytes_peak();
        if (round > 0) continue;
        for (std::uint64_t i = 0; i < out.pairs.count; ++i) ++pairs[out.pairs.pairs[i].degree];
    }
    const std::uint64_t simplices = out.simplices;
    std::printf("%u vertices, %u cells, %llu simplices; pairs by degree", g.vertex_count, g.cell_count,
                static_cast<unsigned long long>(simplices));
    for (const std::uint64_t n : pairs) std::printf(" %llu", static_cast<unsigned long long>(n));
    std::printf("\nall degrees: %.3f s, %.1f ns and %.2f bytes a simplex\n", best[0], best[0] / double(simplices) * 1e9,
                double(peak[0]) / double(simplices));
    std::printf("degree 0:    %.3f s, %.1f ns and %.2f bytes a simplex\n", best[1], best[1] / double(simplices) * 1e9,
                double(peak[1]) / double(simplices));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::uint32_t cubes = argc > 1 ? std::uint32_t(std::atoi(argv[1])) : 17;
    const std::uint32_t sample = argc > 2 ? std::uint32_t(std::atoi(argv[2])) : 2000;
    const double jitter = argc > 3 ? std::atof(argv[3]) : 0.3;
    const int shuffle = argc > 4 ? std::atoi(argv[4]) : 0;
    switch (argc > 5 ? std::atoi(argv[5]) : 4) {
    case 2: return measure<2>(cubes, sample, jitter, shuffle);
    case 3: return measure<3>(cubes, sample, jitter, shuffle);
    case 4: return measure<4>(cubes, sample, jitter, shuffle);
    case 5: return measure<5>(cubes, sample, jitter, shuffle);
    case 6: return measure<6>(cubes, sample, jitter, shuffle);
    }
    return 2;
}
