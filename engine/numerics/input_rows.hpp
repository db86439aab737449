// The caller's points where they lie: rows of doubles or of floats, packed or apart. Read once, when they are copied.
#pragma once
#include <cstddef>

#include "numerics/real.hpp"

namespace netmesh {

struct InputRows {
    const unsigned char* first = nullptr;
    std::size_t stride_bytes = 0;  // from one row to the next; 0: packed
    bool are_floats = false;

    InputRows() = default;
    InputRows(const void* points, std::size_t stride_bytes, bool are_floats)
        : first(static_cast<const unsigned char*>(points)), stride_bytes(stride_bytes), are_floats(are_floats) {}
    InputRows(const double* packed) : InputRows(packed, 0, false) {}  // NOLINT: as good as rows

    // Reads row i of points in `dim` dimensions, exactly the numbers that stand there; -0 becomes 0. False: one of them
    // is not finite.
    bool read(std::size_t i, int dim, double* x) const {
        const std::size_t bytes = are_floats ? sizeof(float) : sizeof(double);
        const unsigned char* at =
            first + i * (stride_bytes != 0 ? stride_bytes : static_cast<std::size_t>(dim) * bytes);
        bool finite = true;
        for (int k = 0; k < dim; ++k, at += bytes) {
            if (are_floats) {
                float single;
                __builtin_memcpy(&single, __builtin_assume_aligned(at, 4), sizeof single);
                x[k] = static_cast<double>(single);
            } else {
                __builtin_memcpy(&x[k], __builtin_assume_aligned(at, 4), sizeof x[k]);
            }
            x[k] += 0.0;
            finite &= is_finite(x[k]);
        }
        return finite;
    }
};

}  // namespace netmesh
