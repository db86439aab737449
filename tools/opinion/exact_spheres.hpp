// Spheres through points, without rounding.
#pragma once
#include <cstdint>
#include <vector>

#include "tools/io/points.hpp"
#include "tools/opinion/exact_number.hpp"

namespace netmesh::tool {

using ExactPlace = std::vector<Exact>;  // coordinates

std::vector<ExactPlace> exact_places(const PointCloud& cloud);  // of all rows

// Half of the distance of two points, coordinates [dim] each, rounded to the nearest double.
double half_distance(const double* a, const double* b, std::size_t dim);

// The sign of the determinant of p[1] - p[0], .., p[D] - p[0].
int orientation(const std::vector<const ExactPlace*>& points);

// The smallest sphere through points: the one with its centre in their affine hull. With weights, one for each, the
// smallest one that is orthogonal to their balls: the power of its centre x, |x - p|^2 less the weight, is the same to
// all points, and its square is that power.
class ExactSphere {
public:
    explicit ExactSphere(const std::vector<const ExactPlace*>& points, const std::vector<Exact>& weights = {});

    bool is_independent() const { return volume_.sign() > 0; }  // affinely; nothing else holds where they are not
    bool is_centred() const;                                    // the centre is strictly inside the simplex
    int side(const ExactPlace& place) const;                    // -1 strictly inside, 0 on, 1 outside; no weights
    double radius() const;  // rounded to the nearest double; of a power below 0 that of its opposite, below 0
    double square() const;  // the power

private:
    const ExactPlace& origin_;        // the first point, p
    std::vector<ExactPlace> edges_;   // from it to the others, v_i
    std::vector<Exact> squares_;      // v_i v_i, less the weight there, and that of p
    Exact volume_;                    // the determinant of 2 v_i v_j
    std::vector<Exact> coordinates_;  // volume_ times x_i, where the centre is p + sum x_i v_i
    Exact power_;                     // 2 volume_ times the power
};

}  // namespace netmesh::tool
