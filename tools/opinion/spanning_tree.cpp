#include "tools/opinion/spanning_tree.hpp"

#include <algorithm>
#include <cmath>

#include "tools/opinion/exact_spheres.hpp"

namespace netmesh::tool {

namespace {

// Is half of the distance surely more than `half`? Squares are off by less than (D + 2) 2^-53 of themselves, where none
// is lost to underflow.
bool is_surely_more(const double* a, const double* b, std::size_t dim, double half) {
    double sum = 0;
    for (std::size_t k = 0; k < dim; k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
    const double square = 4 * half * half;
    return std::isinf(half) ? false : square > 0x1p-900 && sum > square * (1 + 0x1p-40) && dim < 1000;
}

// *half becomes half of the distance if that is less.
void lower(double* half, const double* a, const double* b, std::size_t dim) {
    if (!is_surely_more(a, b, dim, *half)) *half = std::min(*half, half_distance(a, b, dim));
}

}  // namespace

std::vector<double> spanning_tree_halves(const PointCloud& different) {
    const std::size_t n = different.rows(), dim = different.dim;
    const double* const x = different.coordinates.data();
    std::vector<double> halves;
    // Rows that are not in the tree, and from each half of the way to it.
    std::vector<std::size_t> rest;
    std::vector<double> way(n, HUGE_VAL);
    for (std::size_t i = 1; i < n; i++) rest.push_back(i);
    std::size_t last = 0;
    while (!rest.empty()) {
        std::size_t next = 0;
        for (std::size_t i = 0; i < rest.size(); i++) {
            lower(&way[rest[i]], x + last * dim, x + rest[i] * dim, dim);
            if (way[rest[i]] < way[rest[next]]) next = i;
        }
        last = rest[next];
        halves.push_back(way[last]);
        rest[next] = rest.back();
        rest.pop_back();
    }
    std::sort(halves.begin(), halves.end());
    return halves;
}

double nearest_half(const PointCloud& different, std::size_t row) {
    const double* const x = different.coordinates.data();
    double half = HUGE_VAL;
    for (std::size_t i = 0; i < different.rows(); i++)
        if (i != row) lower(&half, x + row * different.dim, x + i * different.dim, different.dim);
    return half;
}

}  // namespace netmesh::tool
