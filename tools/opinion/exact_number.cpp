#include "tools/opinion/exact_number.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

namespace netmesh::tool {

Exact::Exact(double x) : negative_(x < 0) {
    if (x == 0) return;
    int exponent;
    // 53 bits, from 2^exponent on
    std::uint64_t bits = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
    exponent -= 53;
    const int shift = ((exponent % 32) + 32) % 32;
    low_ = (exponent - shift) / 32;
    const std::uint64_t low = bits << shift, high = shift == 0 ? 0 : bits >> (64 - shift);
    words_ = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32), static_cast<std::uint32_t>(high)};
    trim();
}

Exact Exact::power(int e) {
    Exact p;
    const int shift = ((e % 32) + 32) % 32;
    p.low_ = (e - shift) / 32;
    p.words_ = {std::uint32_t{1} << shift};
    return p;
}

void Exact::trim() {
    while (!words_.empty() && words_.back() == 0) words_.pop_back();
    std::size_t zeros = 0;
    while (zeros < words_.size() && words_[zeros] == 0) zeros++;
    words_.erase(words_.begin(), words_.begin() + static_cast<std::ptrdiff_t>(zeros));
    low_ = words_.empty() ? 0 : low_ + static_cast<int>(zeros);
    negative_ = negative_ && !words_.empty();
}

double Exact::leading(int* exponent) const {
    *exponent = 32 * (top() - 3);
    double x = 0;
    for (int i = 1; i <= 3; i++) x = x * 0x1p32 + word(top() - i);
    if (words_.empty()) *exponent = 0;
    return negative_ ? -x : x;
}

int Exact::compare_magnitudes(const Exact& a, const Exact& b) {
    if (a.words_.empty() || b.words_.empty()) return static_cast<int>(!a.words_.empty()) - !b.words_.empty();
    if (a.top() != b.top()) return a.top() < b.top() ? -1 : 1;
    for (int place = a.top(); place-- > std::min(a.low_, b.low_);) {
        const std::uint32_t x = a.word(place), y = b.word(place);
        if (x != y) return x < y ? -1 : 1;
    }
    return 0;
}

int compare(const Exact& a, const Exact& b) {
    if (a.sign() != b.sign()) return a.sign() < b.sign() ? -1 : 1;
    return a.sign() * Exact::compare_magnitudes(a, b);
}

Exact Exact::operator-() const {
    Exact other = *this;
    other.negative_ = !negative_ && !words_.empty();
    return other;
}

Exact Exact::sum(const Exact& a, const Exact& b, bool minus_b) {
    if (b.words_.empty()) return a;
    if (a.words_.empty()) return minus_b ? -b : b;
    Exact out;
    out.low_ = std::min(a.low_, b.low_);
    const int top = std::max(a.top(), b.top());
    out.words_.reserve(static_cast<std::size_t>(top - out.low_ + 1));
    if (a.negative_ == (b.negative_ != minus_b)) {
        out.negative_ = a.negative_;
        std::uint64_t carry = 0;
        for (int place = out.low_; place <= top; place++) {
            carry += std::uint64_t{a.word(place)} + b.word(place);
            out.words_.push_back(static_cast<std::uint32_t>(carry));
            carry >>= 32;
        }
    } else {
        const bool a_is_larger = compare_magnitudes(a, b) >= 0;
        const Exact &more = a_is_larger ? a : b, &less = a_is_larger ? b : a;
        out.negative_ = a.negative_ == a_is_larger;
        std::uint64_t borrow = 0;
        for (int place = out.low_; place < top; place++) {
            const std::uint64_t difference = std::uint64_t{more.word(place)} - less.word(place) - borrow;
            out.words_.push_back(static_cast<std::uint32_t>(difference));
            borrow = difference >> 63;
        }
    }
    out.trim();
    return out;
}

Exact operator*(const Exact& a, const Exact& b) {
    Exact out;
    if (a.words_.empty() || b.words_.empty()) return out;
    out.negative_ = a.negative_ != b.negative_;
    out.low_ = a.low_ + b.low_;
    out.words_.assign(a.words_.size() + b.words_.size(), 0);
    for (std::size_t i = 0; i < a.words_.size(); i++) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.words_.size(); j++) {
            carry += std::uint64_t{a.words_[i]} * b.words_[j] + out.words_[i + j];
            out.words_[i + j] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        out.words_[i + b.words_.size()] = static_cast<std::uint32_t>(carry);
    }
    out.trim();
    return out;
}

namespace {

// Infinity stands for 2^1024, which would be the next double.
Exact of_double(double x) { return std::isinf(x) ? Exact::power(1024) : Exact(x); }

bool is_odd(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits % 2 != 0;
}

// From r >= 0 near it to the number itself. side(a, b): the sign of it minus the middle of a and b.
template <class Side> double nearest_from(double r, const Side& side) {
    while (r > 0) {
        const double below = std::nextafter(r, 0);
        const int s = side(below, r);
        if (s > 0 || (s == 0 && !is_odd(r))) break;
        r = below;
    }
    while (!std::isinf(r)) {
        const double above = std::nextafter(r, HUGE_VAL);
        const int s = side(r, above);
        if (s < 0 || (s == 0 && !is_odd(r))) break;
        r = above;
    }
    return r;
}

}  // namespace

double nearest_root(const Exact& over, const Exact& under) {
    if (over.sign() == 0) return 0;
    int of_over, of_under;
    double square = over.leading(&of_over) / under.leading(&of_under);
    int exponent = of_over - of_under;
    if (exponent % 2 != 0) square *= 2, exponent--;
    const Exact four = over * Exact(4);
    // Of squares: over / under against ((a + b) / 2)^2.
    return nearest_from(std::min(std::ldexp(std::sqrt(square), exponent / 2), DBL_MAX), [&](double a, double b) {
        const Exact twice = of_double(a) + of_double(b);
        return compare(four, twice * twice * under);
    });
}

double nearest_quotient(const Exact& over, const Exact& under) {
    if (over.sign() == 0) return 0;
    if (over.sign() < 0) return -nearest_quotient(-over, under);
    int of_over, of_under;
    const double quotient = over.leading(&of_over) / under.leading(&of_under);
    const Exact two = over + over;
    return nearest_from(std::min(std::ldexp(quotient, of_over - of_under), DBL_MAX),
                        [&](double a, double b) { return compare(two, (of_double(a) + of_double(b)) * under); });
}

double nearest_signed_root(const Exact& over, const Exact& under) {
    return over.sign() < 0 ? -nearest_root(-over, under) : nearest_root(over, under);
}

}  // namespace netmesh::tool
