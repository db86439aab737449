// Nanoseconds of one predicate call by dimension and by the stage that ends it. Each figure is the least of several
// rounds over a batch of inputs; the last columns are the shares of the batch that ended in the float, integer and
// exact stage.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include "predicates/predicates.hpp"

namespace {

using netmesh::PredicateCounts;

enum class Kind { uniform, grid, flips, wide_flips, full_range_flips };

std::mt19937_64 engine(20240229);

double unit() { return static_cast<double>(engine() >> 11) * 0x1p-53; }

// One coordinate vector whose sign changes and permutations are cospherical points.
void fill_radius_vector(Kind kind, double* v, int dim) {
    for (int c = 0; c < dim; ++c) {
        const int spread = kind == Kind::wide_flips ? 64 : kind == Kind::full_range_flips ? 1000 : 0;
        const int exponent = spread == 0 ? 0 : static_cast<int>(engine() % (2 * spread + 1)) - spread;
        v[c] = std::ldexp(1 + unit(), exponent);
    }
}

template <int D> void fill_point(Kind kind, double* v, double* x) {
    if (kind != Kind::uniform && kind != Kind::grid)
        for (int c = D - 1; c > 0; --c) std::swap(v[c], v[engine() % static_cast<unsigned>(c + 1)]);
    for (int c = 0; c < D; ++c) {
        if (kind == Kind::uniform)
            x[c] = unit();
        else if (kind == Kind::grid)
            x[c] = static_cast<double>(engine() % 2 + 16);
        else
            x[c] = (engine() & 1) != 0 ? v[c] : -v[c];
    }
}

// batch times D+2 distinct points.
template <int D> std::vector<double> make_points(Kind kind, int batch) {
    std::vector<double> x(static_cast<std::size_t>(batch) * (D + 2) * D);
    for (int b = 0; b < batch; ++b) {
        double v[D];
        fill_radius_vector(kind, v, D);
        double* const first = x.data() + b * (D + 2) * D;
        for (int i = 0; i < D + 2; ++i) {
            bool again = true;
            while (again) {
                fill_point<D>(kind, v, first + i * D);
                again = false;
                for (int j = 0; j < i; ++j) again |= std::equal(first + i * D, first + (i + 1) * D, first + j * D);
            }
        }
    }
    return x;
}

template <int D> void measure(const char* name, Kind kind, bool ball, int batch, int rounds) {
    const std::vector<double> x = make_points<D>(kind, batch);
    std::vector<const double*> pointers;
    for (int i = 0; i < batch * (D + 2); ++i) pointers.push_back(x.data() + i * D);
    PredicateCounts counts{};
    long signs = 0;
    double best = INFINITY;
    for (int r = 0; r < rounds; ++r) {
        const auto start = std::chrono::steady_clock::now();
        for (int b = 0; b < batch; ++b) {
            const double* const* p = pointers.data() + b * (D + 2);
            signs += static_cast<long>(ball ? netmesh::in_ball<D>(p, p[D + 1], counts) : netmesh::orient<D>(p, counts));
        }
        const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
        best = std::min(best, took.count() / batch);
    }
    const double total = static_cast<double>(batch) * rounds;
    std::printf("%d  %-8s %-12s %12.1f   %5.2f %5.2f %5.2f   (%ld)\n", D, ball ? "in_ball" : "orient", name, best,
                static_cast<double>(counts.calls[1]) / total, static_cast<double>(counts.calls[2]) / total,
                static_cast<double>(counts.calls[3]) / total, signs / rounds);
}

template <int D> void measure_all() {
    for (const bool ball : {false, true}) {
        measure<D>("uniform", Kind::uniform, ball, 1000, 200);
        measure<D>("grid", Kind::grid, ball, 1000, 200);
        measure<D>("53 bits", Kind::flips, ball, 1000, 50);
        measure<D>("2^+-64", Kind::wide_flips, ball, 200, 10);
        measure<D>("full range", Kind::full_range_flips, ball, 50, 4);
    }
}

}  // namespace

int main() {
    std::printf("D  predicate points       ns a call    float  int.  exact\n");
    measure_all<2>();
    measure_all<3>();
    measure_all<4>();
    measure_all<5>();
    measure_all<6>();
}
