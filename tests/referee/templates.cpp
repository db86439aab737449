#include "templates.hpp"

#include <algorithm>

namespace referee {
namespace {

const double golden_ratio = (1 + std::sqrt(5.0)) / 2;

Point unit(Point x) {
    double norm2 = 0;
    for (const double c : x) norm2 += c * c;
    for (double& c : x) c /= std::sqrt(norm2);
    return x;
}

// All arrangements of the numbers by permutations of `dim` places, even ones alone where asked for, with all signs.
Points arrangements(const std::vector<double>& numbers, bool even_only) {
    const int dim = static_cast<int>(numbers.size());
    std::vector<int> order(numbers.size());
    for (int i = 0; i < dim; i++) order[i] = i;
    Points found;
    do {
        int inversions = 0;
        for (int i = 0; i < dim; i++)
            for (int j = 0; j < i; j++) inversions += order[j] > order[i];
        if (even_only && inversions % 2 != 0) continue;
        for (int signs = 0; signs < 1 << dim; signs++) {
            Point x = {};
            for (int i = 0; i < dim; i++) x[i] = numbers[order[i]] * ((signs >> i & 1) != 0 ? -1 : 1);
            for (double& c : x) c += 0.0;
            if (std::find(found.begin(), found.end(), unit(x)) == found.end()) found.push_back(unit(x));
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return found;
}

Points icosahedron_with_middles() {
    Points points = arrangements({0, 1, golden_ratio}, true);
    const std::size_t corners = points.size();
    double least = INFINITY;
    for (std::size_t i = 0; i < corners; i++)
        for (std::size_t j = 0; j < i; j++) least = std::min(least, distance(points[i], points[j], 3));
    for (std::size_t i = 0; i < corners; i++)
        for (std::size_t j = 0; j < i; j++) {
            if (distance(points[i], points[j], 3) > 1.01 * least) continue;
            Point middle = {};
            for (int k = 0; k < 3; k++) middle[k] = points[i][k] + points[j][k];
            points.push_back(unit(middle));
        }
    return points;
}

Points corners_of_600_cell() {
    Points points = arrangements({1, 0, 0, 0}, false);
    for (const Point& x : arrangements({0.5, 0.5, 0.5, 0.5}, false)) points.push_back(x);
    for (const Point& x : arrangements({golden_ratio, 1, 1 / golden_ratio, 0}, true)) points.push_back(x);
    return points;
}

}  // namespace

Points cage_template(int dim) {
    if (dim == 3) return icosahedron_with_middles();
    if (dim == 4) return corners_of_600_cell();
    Points points(16);
    for (int i = 0; i < 16; i++) points[i] = {std::cos(i * std::acos(-1.0) / 8), std::sin(i * std::acos(-1.0) / 8)};
    return points;
}

Points outer_template(int dim) {
    const int grid = dim == 4 ? 5 : 6;
    Points points;
    for (int axis = 0; axis < dim; axis++)
        for (const double side : {-1.0, 1.0}) {
            int squares = 1;
            for (int k = 1; k < dim; k++) squares *= grid;
            for (int s = 0; s < squares; s++) {
                Point x = {};
                for (int k = 0, rest = s; k < dim; k++) {
                    x[k] = k == axis ? side : (2.0 * (rest % grid) + 1) / grid - 1;
                    if (k != axis) rest /= grid;
                }
                points.push_back(unit(x));
            }
        }
    return points;
}

}  // namespace referee
