// Floating point with 1,024 bits and exponents that do not end, for the rare question that 106 bits leave open. A
// product takes 1,024 multiplications, a quotient eleven products.
#pragma once
#include <cstdint>

#include "numerics/bits.hpp"

namespace netmesh {

// +, -, * and / multiply their exact results by 1 + e, |e| <= unit. Results below are in units of 2^-1023 relative:
// cutting off what does not fit is 1 at most, and so is what a sum loses of the smaller number, as that is cut only
// where it is below 2^-32 of the larger one, and then no more than one leading bit cancels. Divided must not be 0.
class WideFloat {
public:
    static constexpr double unit = 0x1p-1015;

    WideFloat() = default;
    explicit WideFloat(double x) {
        const Decoded d = decode(x);
        for (std::uint32_t& digit : digit_) digit = 0;
        negative_ = d.negative;
        exponent_ = d.exponent + 64;
        digit_[digits - 1] = static_cast<std::uint32_t>(d.mantissa >> 32);
        digit_[digits - 2] = static_cast<std::uint32_t>(d.mantissa);
        normalise(0);
    }

    // Times 2^exponent.
    WideFloat scaled(int exponent) const {
        WideFloat b = *this;
        b.exponent_ += exponent;
        return b;
    }
    friend WideFloat operator-(const WideFloat& a) {
        WideFloat b = a;
        b.negative_ = !a.negative_;
        return b;
    }
    friend WideFloat operator-(const WideFloat& a, const WideFloat& b) { return a + -b; }
    [[gnu::noinline]] friend WideFloat operator+(const WideFloat& x, const WideFloat& y) {
        if (x.is_zero() || y.is_zero()) return x.is_zero() ? y : x;
        const bool swap = x.is_below(y);
        const WideFloat &a = swap ? y : x, &b = swap ? x : y;
        // b as far below a as it is, with one digit more than they have.
        const std::int64_t below = std::int64_t{a.exponent_} - b.exponent_;
        if (below >= 32 * digits) return a;
        const int skip = static_cast<int>(below) / 32, shift = static_cast<int>(below) % 32;
        const auto digit_of_b = [&](int i) {  // digit -1 is the one more
            const int from = i + skip;
            const std::uint64_t low = from >= 0 && from < digits ? b.digit_[from] : 0;
            const std::uint64_t high = from + 1 >= 0 && from + 1 < digits ? b.digit_[from + 1] : 0;
            return static_cast<std::uint32_t>((high << 32 | low) >> shift);
        };
        const bool subtract = a.negative_ != b.negative_;
        const std::uint32_t flip = subtract ? ~std::uint32_t{0} : 0;
        WideFloat c;
        std::uint64_t carry = subtract ? 1 : 0;
        carry += digit_of_b(-1) ^ flip;
        std::uint32_t lowest = static_cast<std::uint32_t>(carry);
        for (int i = 0; i < digits; ++i) {
            carry = (carry >> 32) + a.digit_[i] + (digit_of_b(i) ^ flip);
            c.digit_[i] = static_cast<std::uint32_t>(carry);
        }
        c.exponent_ = a.exponent_;
        c.negative_ = a.negative_;
        if (!subtract && carry >> 32 != 0) {
            for (int i = 0; i + 1 < digits; ++i) c.digit_[i] = c.digit_[i] >> 1 | c.digit_[i + 1] << 31;
            c.digit_[digits - 1] = c.digit_[digits - 1] >> 1 | 0x80000000u;
            ++c.exponent_;
            return c;
        }
        c.normalise(lowest);
        return c;
    }
    [[gnu::noinline]] friend WideFloat operator*(const WideFloat& a, const WideFloat& b) {
        if (a.is_zero() || b.is_zero()) return WideFloat(0);
        std::uint32_t product[2 * digits] = {};
        for (int i = 0; i < digits; ++i) {
            std::uint64_t carry = 0;
            for (int j = 0; j < digits; ++j) {
                carry += product[i + j] + std::uint64_t{a.digit_[i]} * b.digit_[j];
                product[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
            product[i + digits] = static_cast<std::uint32_t>(carry);
        }
        WideFloat c;
        for (int i = 0; i < digits; ++i) c.digit_[i] = product[digits + i];
        c.exponent_ = a.exponent_ + b.exponent_;
        c.negative_ = a.negative_ != b.negative_;
        c.normalise(product[digits - 1]);
        return c;
    }
    // By Newton's iteration for 1 / b, which squares the relative error, 2^-50 at first, five times; each time four
    // roundings come to it, of which the last are what remains.
    [[gnu::noinline]] friend WideFloat operator/(const WideFloat& a, const WideFloat& b) {
        WideFloat fraction = b;
        fraction.exponent_ = 0;
        const WideFloat one(1);
        WideFloat inverse(1 / fraction.rounded());
        for (int k = 0; k < 5; ++k) inverse = inverse + inverse * (one - fraction * inverse);
        WideFloat quotient = a * inverse;
        quotient.exponent_ -= b.exponent_;
        return quotient;
    }

    // As a double, to 2^-50 relative; infinite from 2^1023 on, and 0 below 2^-1000.
    double rounded() const {
        if (is_zero() || exponent_ < -1000) return 0;
        const double size =
            exponent_ > 1023 ? __builtin_huge_val()
                             : (digit_[digits - 1] * 0x1p32 + digit_[digits - 2]) * 0x1p-64 * power_of_two(exponent_);
        return negative_ ? -size : size;
    }

private:
    static constexpr int digits = 32;

    bool is_zero() const { return digit_[digits - 1] == 0; }
    // In magnitude.
    bool is_below(const WideFloat& b) const {
        if (exponent_ != b.exponent_) return exponent_ < b.exponent_;
        int i = digits - 1;
        while (i > 0 && digit_[i] == b.digit_[i]) --i;
        return digit_[i] < b.digit_[i];
    }
    // Moves the highest bit to the top; `lowest` is one digit more.
    void normalise(std::uint32_t lowest) {
        int top = digits - 1;
        while (top >= 0 && digit_[top] == 0) --top;
        if (top < 0 && lowest == 0) return;
        const std::uint32_t highest = top < 0 ? lowest : digit_[top];
        int shift = 0;
        while ((highest << shift & 0x80000000u) == 0) ++shift;
        const int skip = digits - 1 - top;
        for (int i = digits - 1; i >= 0; --i) {
            const auto digit_at = [&](int k) -> std::uint64_t { return k >= 0 ? digit_[k] : k == -1 ? lowest : 0; };
            const std::uint64_t both = digit_at(i - skip) << 32 | digit_at(i - skip - 1);
            digit_[i] = static_cast<std::uint32_t>(both << shift >> 32);
        }
        exponent_ -= 32 * skip + shift;
    }

    std::uint32_t digit_[digits];  // of a fraction, the last one first; its highest bit is set, or all are 0
    std::int32_t exponent_;        // fraction * 2^exponent
    bool negative_;
};

}  // namespace netmesh
