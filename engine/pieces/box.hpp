// Boxes with sides along the axes.
#pragma once

namespace netmesh {

template <int D> struct Box {
    double least[D], most[D];

    // Squared distance, rounded by less than (D + 3) 2^-53 of itself.
    double distance2(const double* x) const {
        double sum = 0;
        for (int k = 0; k < D; ++k) {
            const double d = outside(least[k] - x[k], x[k] - most[k]);
            sum += d * d;
        }
        return sum;
    }
    double distance2(const Box& other) const {
        double sum = 0;
        for (int k = 0; k < D; ++k) {
            const double d = outside(least[k] - other.most[k], other.least[k] - most[k]);
            sum += d * d;
        }
        return sum;
    }
    // The one that is positive, or 0; nobody could foresee which.
    static double outside(double below, double above) {
        const double more = below > above ? below : above;
        return more > 0 ? more : 0;
    }
    double diagonal2() const {
        double sum = 0;
        for (int k = 0; k < D; ++k) sum += (most[k] - least[k]) * (most[k] - least[k]);
        return sum;
    }
};

}  // namespace netmesh
