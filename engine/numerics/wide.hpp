// Sums of 64 x 64 bit products in 128 bits, signed and unsigned, equal on every target. The portable pair is always
// there to be tested; SignedSum and UnsignedSum name the pair that the engine uses.
#pragma once
#include <cstdint>

namespace netmesh {

// Two's complement number of 128 bits. Whoever adds sees to it that the sum stays below 2^127 in magnitude.
class PortableSignedSum {
public:
    explicit PortableSignedSum(std::int64_t a = 0)
        : low_(static_cast<std::uint64_t>(a)), high_(a < 0 ? ~std::uint64_t{0} : 0) {}
    void add_product(std::int64_t a, std::int64_t b);
    // Takes the lowest digit of the balanced expansion in base 2^64 off: value = digit + 2^64 * (value afterwards),
    // digit in [-2^63, 2^63).
    std::int64_t take_digit() {
        const std::int64_t digit = static_cast<std::int64_t>(low_);
        const std::uint64_t rest = high_ + (low_ >> 63);
        high_ = (rest >> 63) != 0 ? ~std::uint64_t{0} : 0;
        low_ = rest;
        return digit;
    }

private:
    std::uint64_t low_, high_;
};

// Number of 128 bits, not negative.
class PortableUnsignedSum {
public:
    explicit PortableUnsignedSum(std::uint64_t a = 0) : low_(a), high_(0) {}
    void add_product(std::uint64_t a, std::uint64_t b);
    // Quotient (below 2^64 by the caller's bounds) and remainder modulo 2^61.
    std::uint64_t quotient61() const { return (high_ << 3) | (low_ >> 61); }
    std::uint64_t remainder61() const { return low_ & ((std::uint64_t{1} << 61) - 1); }

private:
    std::uint64_t low_, high_;
};

// high:low += a * b modulo 2^128, from 32-bit halves.
inline void add_product_portable(std::uint64_t& high, std::uint64_t& low, std::uint64_t a, std::uint64_t b) {
    const std::uint64_t a0 = a & 0xFFFFFFFFu, a1 = a >> 32, b0 = b & 0xFFFFFFFFu, b1 = b >> 32;
    const std::uint64_t p00 = a0 * b0, p01 = a0 * b1, p10 = a1 * b0;
    const std::uint64_t middle = (p00 >> 32) + (p01 & 0xFFFFFFFFu) + (p10 & 0xFFFFFFFFu);
    const std::uint64_t product_low = (middle << 32) | (p00 & 0xFFFFFFFFu);
    high += a1 * b1 + (p01 >> 32) + (p10 >> 32) + (middle >> 32);
    low += product_low;
    high += low < product_low;
}

inline void PortableSignedSum::add_product(std::int64_t a, std::int64_t b) {
    const std::uint64_t ua = static_cast<std::uint64_t>(a), ub = static_cast<std::uint64_t>(b);
    // As numbers below 2^64 the factors are a + 2^64 [a < 0] and b + 2^64 [b < 0].
    high_ -= (a < 0 ? ub : 0) + (b < 0 ? ua : 0);
    add_product_portable(high_, low_, ua, ub);
}

inline void PortableUnsignedSum::add_product(std::uint64_t a, std::uint64_t b) {
    add_product_portable(high_, low_, a, b);
}

// WebAssembly has no instruction for it, only calls of a library.
#if defined(__SIZEOF_INT128__) && !defined(__wasm__) && !defined(NETMESH_PORTABLE_WIDE)

__extension__ typedef __int128 NativeInt128;
__extension__ typedef unsigned __int128 NativeUint128;

class NativeSignedSum {
public:
    explicit NativeSignedSum(std::int64_t a = 0) : value_(a) {}
    void add_product(std::int64_t a, std::int64_t b) { value_ += static_cast<NativeInt128>(a) * b; }
    std::int64_t take_digit() {
        const std::int64_t digit = static_cast<std::int64_t>(value_);
        value_ = (value_ >> 64) + (digit < 0);
        return digit;
    }

private:
    NativeInt128 value_;
};

class NativeUnsignedSum {
public:
    explicit NativeUnsignedSum(std::uint64_t a = 0) : value_(a) {}
    void add_product(std::uint64_t a, std::uint64_t b) { value_ += static_cast<NativeUint128>(a) * b; }
    std::uint64_t quotient61() const { return static_cast<std::uint64_t>(value_ >> 61); }
    std::uint64_t remainder61() const { return static_cast<std::uint64_t>(value_) & ((std::uint64_t{1} << 61) - 1); }

private:
    NativeUint128 value_;
};

using SignedSum = NativeSignedSum;
using UnsignedSum = NativeUnsignedSum;
#else
using SignedSum = PortableSignedSum;
using UnsignedSum = PortableUnsignedSum;
#endif

}  // namespace netmesh
