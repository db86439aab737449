#pragma once

namespace netmesh {

// Squared distance, summed in the order of the coordinates.
template <int D> inline double distance2(const double* a, const double* b) {
    double d2 = 0;
    for (int k = 0; k < D; ++k) {
        const double d = a[k] - b[k];
        d2 += d * d;
    }
    return d2;
}

}  // namespace netmesh
