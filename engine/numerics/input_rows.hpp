// The caller's points where they lie: rows of doubles or of floats, packed or apart. Read once, when they are copied.
#pragma once
#include <cstddef>

namespace netmesh {

struct InputRows {
    const unsigned char* first = nullptr;
    std::size_t stride_bytes = 0;  // from one row to the next; 0: packed
    bool are_floats = false;

    InputRows() = default;
    InputRows(const void* points, std::size_t stride_bytes, bool are_floats)
        : first(static_cast<const unsigned char*>(points)), stride_bytes(stride_bytes), are_floats(are_floats) {}
    InputRows(const double* packed) : InputRows(packed, 0, false) {}  // NOLINT: as good as rows

    std::size_t coordinate_bytes() const { return are_floats ? sizeof(float) : sizeof(double); }
    // Row i of points in `dim` dimensions; its coordinates are read by `coordinate`.
    const unsigned char* row(std::size_t i, int dim) const {
        return first + i * (stride_bytes != 0 ? stride_bytes : static_cast<std::size_t>(dim) * coordinate_bytes());
    }
    // Exactly the number that stands there.
    double coordinate(const unsigned char* row, int k) const {
        const unsigned char* const at = row + static_cast<std::size_t>(k) * coordinate_bytes();
        if (are_floats) {
            float x;
            __builtin_memcpy(&x, __builtin_assume_aligned(at, 4), sizeof x);
            return static_cast<double>(x);
        }
        double x;
        __builtin_memcpy(&x, __builtin_assume_aligned(at, 4), sizeof x);
        return x;
    }
};

}  // namespace netmesh
