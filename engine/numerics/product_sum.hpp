// Sums of products of two finite doubles, exact whatever their magnitudes are.
#pragma once
#include <cstdint>

#include "numerics/bits.hpp"

namespace netmesh {

// A number in units of 2^-2148, the least product that is not 0: up to 2^20 products below 2^2048 in magnitude. Digits
// keep their signs and carries; sign() adds them up.
class ProductSum {
public:
    // sum += x y, or -= x y.
    void add(double x, double y) { add(decode(x), decode(y), false); }
    void subtract(double x, double y) { add(decode(x), decode(y), true); }

    // -1, 0 or 1.
    int sign() const {
        std::int64_t carry = 0;
        bool any = false;
        for (const std::int64_t digit : digit_) {
            carry += digit;
            any = any || (carry & 0xFFFFFFFF) != 0;
            carry >>= 32;  // rounds down: what is left above the last digit is -1 or 0
        }
        return carry < 0 ? -1 : any ? 1 : 0;
    }

private:
    static constexpr int least = -2148, digits = 134;  // 2 * 1024 + 2148 + 20 bits, and more

    void add(const Decoded& x, const Decoded& y, bool negate) {
        const bool negative = (x.negative != y.negative) != negate;
        const int shift = x.exponent + y.exponent - least, first = shift / 32, rest = shift % 32;
        // The mantissas in halves of 27 bits at most: four products below 2^54, each moved by less than 59 bits.
        const std::uint64_t a[] = {x.mantissa & 0x3FFFFFF, x.mantissa >> 26};
        const std::uint64_t b[] = {y.mantissa & 0x3FFFFFF, y.mantissa >> 26};
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j) {
                const int moved = rest + 26 * (i + j), at = first + moved / 32;
                const std::uint64_t product = a[i] * b[j];
                const std::uint64_t low = (product & 0xFFFFFFFF) << moved % 32, high = (product >> 32) << moved % 32;
                const std::int64_t parts[] = {static_cast<std::int64_t>(low & 0xFFFFFFFF),
                                              static_cast<std::int64_t>((low >> 32) + (high & 0xFFFFFFFF)),
                                              static_cast<std::int64_t>(high >> 32)};
                for (int part = 0; part < 3; ++part) digit_[at + part] += negative ? -parts[part] : parts[part];
            }
    }

    std::int64_t digit_[digits] = {};
};

}  // namespace netmesh
