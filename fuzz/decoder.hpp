// Bytes of a fuzzer as choices and numbers that are mostly near-degenerate.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace fuzz {

inline void require(bool good) {
    if (!good) std::abort();
}

// Few values, their neighbours in the last place, tiny powers of two and huge numbers.
inline double coordinate(std::uint8_t byte) {
    const double grid = static_cast<double>(byte & 7) - 3;
    switch (byte >> 5) {
    case 0:
    case 1:
    case 2: return grid;
    case 3: return grid * 0.1;
    case 4: return std::nextafter(grid, 10);
    case 5: return std::ldexp(1.0, -8 * (byte & 31));
    case 6: return std::ldexp(grid, byte & 24);
    default: return std::ldexp(1.0 + (byte & 31), 900 * (byte & 1) - 450);
    }
}

// What is left of an input; zeros when it is used up.
class Tape {
public:
    Tape(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

    bool empty() const { return at_ == end_; }
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
    std::uint8_t byte() { return at_ == end_ ? std::uint8_t{0} : *at_++; }
    std::uint32_t below(std::uint32_t n) { return byte() % n; }
    bool rarely() { return byte() % 16 == 15; }
    // An argument that is nearly always finite.
    double number() {
        const std::uint8_t b = byte();
        if (b == 253) return std::numeric_limits<double>::quiet_NaN();
        if (b == 254) return std::numeric_limits<double>::infinity();
        if (b == 255) return -std::numeric_limits<double>::max();
        return coordinate(b);
    }

private:
    const std::uint8_t* at_;
    const std::uint8_t* end_;
};

}  // namespace fuzz
