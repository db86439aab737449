#include "refusals.hpp"

#include <algorithm>
#include <cmath>

namespace referee {

bool is_flat(const std::vector<Point>& points, int dim) {
    std::vector<Vector<Rational>> rows;
    for (std::size_t i = 1; i < points.size(); i++) {
        Vector<Rational> row = difference<Rational>(points[0], points[i], dim);
        for (const Vector<Rational>& other : rows) {
            int pivot = 0;
            while (sgn(other[pivot]) == 0) pivot++;
            const Rational factor = row[pivot] / other[pivot];
            for (int k = 0; k < dim; k++) row[k] = row[k] - factor * other[k];
        }
        bool zero = true;
        for (int k = 0; k < dim; k++) zero = zero && sgn(row[k]) == 0;
        if (!zero) rows.push_back(row);
        if (static_cast<int>(rows.size()) == dim) return false;
    }
    return true;
}

bool has_close_points(const std::vector<Point>& points, int dim, double units) {
    for (std::size_t i = 0; i < points.size(); i++)
        for (std::size_t j = 0; j < i; j++) {
            double magnitude = 0;
            for (int k = 0; k < dim; k++)
                magnitude = std::max({magnitude, std::fabs(points[i][k]), std::fabs(points[j][k])});
            if (distance(points[i], points[j], dim) <= units * 0x1p-52 * magnitude) return true;
        }
    return false;
}

double least_units(double tau, int dim) {
    return tau > 0 ? std::clamp(6.5 * std::sqrt(dim) * (2 / (tau - 2) + 1), 64.0, 0x1p26) : 64;
}

bool is_out_of_range(const std::vector<Point>& points, int dim) {
    for (std::size_t i = 0; i < points.size(); i++) {
        for (int k = 0; k < dim; k++)
            if (std::fabs(points[i][k]) > 0x1p500) return true;
        for (std::size_t j = 0; j < i; j++)
            if (distance(points[i], points[j], dim) < 0x1p-500) return true;
    }
    return false;
}

}  // namespace referee
