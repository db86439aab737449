#include "tools/opinion/corner_error.hpp"

#include <algorithm>
#include <cmath>

namespace netmesh::tool {

namespace {

constexpr Real ulp = 0x1p-53L;
constexpr Real digits_change = 0x1p-22L;
constexpr Real squares = 1.47L;

// k! / k^(k/2)
Real permanent_bound(std::size_t k) {
    Real bound = 1;
    for (std::size_t i = 1; i <= k; i++) bound *= static_cast<Real>(i) / std::sqrt(static_cast<Real>(k));
    return bound;
}

}  // namespace

CornerError corner_error(const std::vector<Place>& points, const Sphere& sphere) {
    const std::size_t dim = points[0].size();
    const Real d = static_cast<Real>(dim), roundings = (d + 1) * (d + 2) / 2 + d + 8;
    const Real factor =
        3 * std::sqrt(d) * roundings * ulp * (d * permanent_bound(dim - 1) + permanent_bound(dim)) / sphere.volume;
    const Place zero(dim);
    CornerError found;
    found.coordinates = squares * std::sqrt(8.0L) * ulp * std::sqrt(distance2(sphere.centre(), zero)) / sphere.radius;
    for (const Place& first : points) {
        Real lengths = 1;
        for (const Place& other : points)
            if (&other != &first) lengths *= std::sqrt(distance2(first, other));
        const Real shape = squares * factor * lengths;
        if (shape < digits_change) found.shape = std::max(found.shape, shape);
    }
    return found;
}

}  // namespace netmesh::tool
