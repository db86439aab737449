// Numbers without rounding.
#pragma once
#include <cstdint>
#include <vector>

namespace netmesh::tool {

// m 2^(32 e) with whole m of any length and any e: every finite double, and all sums, differences and products of such.
class Exact {
public:
    Exact() = default;          // 0
    explicit Exact(double x);   // x is finite
    static Exact power(int e);  // 2^e

    int sign() const { return words_.empty() ? 0 : negative_ ? -1 : 1; }
    // Near the number over 2^*exponent: off by a share of 2^-50 at most, of magnitude 1 to 2^96, or 0.
    double leading(int* exponent) const;

    Exact operator-() const;
    friend Exact operator+(const Exact& a, const Exact& b) { return sum(a, b, false); }
    friend Exact operator-(const Exact& a, const Exact& b) { return sum(a, b, true); }
    friend Exact operator*(const Exact& a, const Exact& b);
    friend int compare(const Exact& a, const Exact& b);  // the sign of a - b

private:
    using Words = std::vector<std::uint32_t>;

    static Exact sum(const Exact& a, const Exact& b, bool minus_b);
    int top() const { return low_ + static_cast<int>(words_.size()); }
    // The word that counts 2^(32 place).
    std::uint32_t word(int place) const {
        return place < low_ || place >= top() ? 0 : words_[static_cast<std::size_t>(place - low_)];
    }
    static int compare_magnitudes(const Exact& a, const Exact& b);
    void trim();

    bool negative_ = false;
    int low_ = 0;  // words_[i] counts 2^(32 (low_ + i))
    Words words_;  // the first and the last are not 0; none of 0
};

Exact operator*(const Exact& a, const Exact& b);
int compare(const Exact& a, const Exact& b);

// The double nearest to sqrt(over / under), over >= 0, under > 0; of two that are as near the even one, beyond half a
// unit above the largest one infinity.
double nearest_root(const Exact& over, const Exact& under);
// The same of over / under, and of its root with its sign, for over of any sign.
double nearest_quotient(const Exact& over, const Exact& under);
double nearest_signed_root(const Exact& over, const Exact& under);

}  // namespace netmesh::tool
