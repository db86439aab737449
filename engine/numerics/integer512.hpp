// Integers modulo 2^512 in two's complement: exact as long as a result is below 2^511 in magnitude. For rare questions;
// a product takes 136 multiplications.
#pragma once
#include <cstdint>

namespace netmesh {

class Integer512 {
public:
    static constexpr int bits = 512;

    static Integer512 zero() {
        Integer512 a;
        for (std::uint32_t& d : a.digit_) d = 0;
        return a;
    }
    // magnitude * 2^shift, negated if so wished; 0 <= shift < 448.
    static Integer512 of(std::uint64_t magnitude, int shift, bool negative) {
        Integer512 a = zero();
        const int first = shift / 32, rest = shift % 32;
        const std::uint64_t low = magnitude << rest;
        a.digit_[first] = static_cast<std::uint32_t>(low);
        a.digit_[first + 1] = static_cast<std::uint32_t>(low >> 32);
        a.digit_[first + 2] = rest == 0 ? 0 : static_cast<std::uint32_t>(magnitude >> (64 - rest));
        return negative ? zero() - a : a;
    }

    friend Integer512 operator+(const Integer512& a, const Integer512& b) { return sum(a, b, 0, 0); }
    friend Integer512 operator-(const Integer512& a, const Integer512& b) { return sum(a, b, ~std::uint32_t{0}, 1); }
    [[gnu::noinline]] friend Integer512 operator*(const Integer512& a, const Integer512& b) {
        Integer512 c = zero();
        for (int i = 0; i < digits; ++i) {
            std::uint64_t carry = 0;
            for (int j = 0; i + j < digits; ++j) {
                carry += c.digit_[i + j] + std::uint64_t{a.digit_[i]} * b.digit_[j];
                c.digit_[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
        }
        return c;
    }

    // The number over 2^*exponent, to 2^-52 relative; below 2^97 in magnitude, and 2^32 or above when *exponent is not
    // 0.
    double leading(int* exponent) const {
        const bool negative = digit_[digits - 1] >> 31 != 0;
        const Integer512 size = negative ? zero() - *this : *this;
        int top = digits - 1;
        while (top > 2 && size.digit_[top] == 0) --top;
        const double value = (size.digit_[top] * 0x1p32 + size.digit_[top - 1]) * 0x1p32 + size.digit_[top - 2];
        *exponent = 32 * (top - 2);
        return negative ? -value : value;
    }

private:
    static constexpr int digits = bits / 32;

    [[gnu::noinline]] static Integer512 sum(const Integer512& a, const Integer512& b, std::uint32_t flip,
                                            std::uint64_t carry) {
        Integer512 c;
        for (int i = 0; i < digits; ++i) {
            carry += std::uint64_t{a.digit_[i]} + (b.digit_[i] ^ flip);
            c.digit_[i] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        return c;
    }

    std::uint32_t digit_[digits];
};

}  // namespace netmesh
