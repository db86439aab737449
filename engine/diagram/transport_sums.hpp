// Sums of costs, and what they prove of a distance.
#pragma once
#include <cstdint>

#include "diagram/transport_cost.hpp"
#include "include/netmesh.h"
#include "numerics/double_double.hpp"

namespace netmesh {

// A sum of up to 2^26 terms >= 0 within 2^-51 of itself.
class PositiveSum {
public:
    void add(double x) {
        const DoubleDouble sum = exact_sum(high_, x);
        high_ = sum.high;
        low_ += sum.low;
    }
    double value() const { return high_ == infinity ? infinity : high_ + low_; }

private:
    double high_ = 0, low_ = 0;
};

// A sum of up to 2^26 whole numbers of size up to 2^62, exactly.
class WholeSum {
public:
    void add(std::int64_t x) {
        const std::uint64_t lifted = static_cast<std::uint64_t>(x) + lift;
        high_ += lifted >> 32;
        low_ += lifted & 0xFFFFFFFFu;
        ++count_;
    }
    // The sum, where it is from 0 to 2^62; 0 where it is less.
    std::int64_t value() const {
        const std::uint64_t high = high_ + (low_ >> 32), base = count_ * (lift >> 32);
        if (high < base) return 0;
        return static_cast<std::int64_t>((high - base) << 32 | (low_ & 0xFFFFFFFFu));
    }

private:
    static constexpr std::uint64_t lift = std::uint64_t{1} << 62;
    std::uint64_t high_ = 0, low_ = 0, count_ = 0;
};

// Bounds of a sum of p-th powers, of lengths in units of 2^-exponent.
struct Bounds {
    int exponent;
    double lower, upper;
};

// The bounds of several parts together.
class Total {
public:
    explicit Total(Power power) : power_(power) {}

    // What is added is 0 or at least 2^-60. What gets lost below the doubles when units are changed is less than its
    // rounding, then.
    void add(const Bounds& part) {
        if (part.upper == 0) return;
        if (is_zero_ || part.exponent < exponent_) {
            rescale(is_zero_ ? 0 : part.exponent - exponent_);
            exponent_ = part.exponent;
            is_zero_ = false;
        }
        const int shift = static_cast<int>(power_.order()) * (exponent_ - part.exponent);
        lower_ = lower_ + DoubleDouble{scaled(part.lower, shift), 0};
        upper_ = upper_ + DoubleDouble{scaled(part.upper, shift), 0};
    }
    // Are the roots within the error of one another? Where all parts are, by Transport::are_near, that is so: the sums
    // and roots here add less than 2^-47. It is asked all the same, as it is what is promised.
    bool is_within(double relative_error) const {
        return is_zero_ || upper() <= lower() * (1 + relative_error * (1 - 0x1p-14));
    }
    netmesh_wasserstein_distance distance(int exponent) const {
        constexpr std::uint32_t bytes = sizeof(netmesh_wasserstein_distance);
        if (is_zero_) return {bytes, exponent, 0, 0};
        TransportCost cost(power_);
        cost.set_unit(exponent_);
        return {bytes, exponent, cost.raised_from_unit(upper()), cost.lowered_from_unit(lower())};
    }

private:
    double upper() const { return power_.root_above(upper_.high * (1 + 4 * unit_roundoff)); }
    double lower() const { return power_.root_below(lower_.high * (1 - 4 * unit_roundoff)); }
    void rescale(int steps) {
        const int shift = static_cast<int>(power_.order()) * steps;
        lower_ = {scaled(lower_.high, shift), scaled(lower_.low, shift)};
        upper_ = {scaled(upper_.high, shift), scaled(upper_.low, shift)};
    }
    // x 2^k, k <= 0.
    static double scaled(double x, int k) {
        return k < -1000 ? 0 : k < -500 ? x * 0x1p-500 * power_of_two(k + 500) : x * power_of_two(k);
    }

    Power power_;
    bool is_zero_ = true;
    int exponent_ = 0;
    DoubleDouble lower_ = {0, 0}, upper_ = {0, 0};
};

}  // namespace netmesh
