// Distances between points of persistence diagrams as 64-bit keys that compare like the exact distances, rounded once.
//
// Rounding is monotone, so the smallest largest key over all matchings is the key of the smallest largest exact
// distance: nothing is lost by comparing keys. Thesis 6.5.
#pragma once
#include <cstdint>

#include "numerics/bits.hpp"
#include "numerics/real.hpp"
#include "numerics/wide.hpp"

namespace netmesh {

constexpr std::uint64_t key_of_infinity = ~std::uint64_t{0};

// Differences of values; the key is the bit pattern of the distance.
struct PlainScale {
    static std::uint64_t between(double x, double y) { return bits_of(absolute(x - y) + 0.0); }
    // Half the length of the bar, what it costs to match it to the diagonal.
    static std::uint64_t to_diagonal(double birth, double death) {
        const double length = death - birth;
        return bits_of(is_finite(length) ? length / 2 : death / 2 - birth / 2);
    }
};

// Differences of logarithms by way of ratios: the key is that of the ratio e^distance >= 1, exponent << 52 | fraction
// as in a double, but with the exponent counted from 0 and as large as the ratio of any two doubles needs. Values > 0.
struct LogScale {
    static std::uint64_t between(double x, double y) {
        const double large = x > y ? x : y, small = x > y ? y : x;
        const double ratio = large / small;
        if (is_finite(ratio)) return bits_of(ratio) - bits_of(1.0);
        // Then large >= 2^-50 and small <= 1, and both products are exact.
        const double scaled = (large * 0x1p-600) / (small * 0x1p600);
        return bits_of(scaled) + (std::uint64_t{1200} << 52) - bits_of(1.0);
    }
    // The square root of death / birth.
    static std::uint64_t to_diagonal(double birth, double death) {
        const Normal b = normal_of(birth);
        Normal d = normal_of(death);
        int exponent = d.exponent - b.exponent;
        if ((exponent & 1) != 0) {
            d.mantissa *= 2;
            --exponent;
        }
        // root = sqrt(d.mantissa / b.mantissa) * 2^shift, between 2^52 and 2^53, is to be rounded. Half-way cases do
        // not occur: the square of an odd number of 54 bits has too many digits.
        const int shift = d.mantissa < b.mantissa ? 53 : 52;
        const double quotient = static_cast<double>(static_cast<std::int64_t>(d.mantissa)) /
                                static_cast<double>(static_cast<std::int64_t>(b.mantissa));
        std::uint64_t root =
            static_cast<std::uint64_t>(static_cast<std::int64_t>(square_root(quotient) * power_of_two(shift)));
        while (square_is_less(2 * root + 1, b.mantissa, d.mantissa, shift)) ++root;
        while (!square_is_less(2 * root - 1, b.mantissa, d.mantissa, shift)) --root;
        const std::uint64_t one = std::uint64_t{1} << 52;
        return static_cast<std::uint64_t>(52 - shift + exponent / 2) * one + (root - one);
    }

private:
    struct Normal {
        std::uint64_t mantissa;  // [2^52, 2^53)
        int exponent;
    };
    static Normal normal_of(double x) {
        const Decoded d = decode(x);
        const int up = 52 - log2_floor(d.mantissa);
        return {d.mantissa << up, d.exponent - up};
    }
    // Whether (twice / 2)^2 * b < d * 4^shift; twice and d have at most 54 bits, b 53.
    static bool square_is_less(std::uint64_t twice, std::uint64_t b, std::uint64_t d, int shift) {
        std::uint64_t square[2] = {0, 0}, left[3] = {0, 0, 0}, carry = 0;
        add_product_portable(square[1], square[0], twice, twice);
        add_product_portable(left[1], left[0], square[0], b);
        add_product_portable(carry, left[1], square[1], b);
        left[2] = carry;
        const int up = 2 * shift + 2 - 64;  // 42 or 44
        const std::uint64_t middle = d << up, top = d >> (64 - up);
        if (left[2] != top) return left[2] < top;
        return left[1] < middle;
    }
};

}  // namespace netmesh
