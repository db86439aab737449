// Costs of transport between persistence diagrams: p-th powers of distances, in a unit of length that is a power of
// two.
#pragma once
#include <cstdint>

#include "numerics/bits.hpp"
#include "numerics/real.hpp"

namespace netmesh {

// x^p for x >= 0 by repeated products, p from 1 to order_max, and p-th roots that are surely above or below. A product
// of positive numbers is within 1 + 2^-53 of its own, so a power is within (1 + 2^-53)^(p - 1) unless it leaves the
// range.
class Power {
public:
    static constexpr std::uint32_t order_max = 16;

    explicit Power(std::uint32_t order) : order_(order) {}
    std::uint32_t order() const { return order_; }

    double of(double x) const {
        double power = x;
        for (std::uint32_t i = 1; i < order_; ++i) power *= x;
        return power;
    }
    // No less, no more than the p-th root of x >= 0, x^p in the range of doubles without loss.
    double root_above(double x) const {
        double root = near_root(x);
        while (of(root) * (1 - roundoff()) < x) root = next_up(root);
        return root;
    }
    double root_below(double x) const {
        double root = near_root(x);
        while (root > 0 && of(root) * (1 + roundoff()) > x) root = double_of_bits(bits_of(root) - 1);
        return root;
    }
    // Of a power and of the product that compares it.
    double roundoff() const { return (order_ + 2) * unit_roundoff; }

private:
    // Newton's steps from above; x^(1/p) <= max(1, x).
    double near_root(double x) const {
        if (order_ == 1 || x == 0) return x;
        double root = power_above(x);
        for (;;) {
            double rest = x;
            for (std::uint32_t i = 1; i < order_; ++i) rest /= root;
            const double next = root - (root - rest) / order_;
            if (!(next < root)) return root;
            root = next;
        }
    }
    // A power of two that is not below the root.
    double power_above(double x) const {
        double bound = 1;
        while (of(bound) < x) bound *= 2;
        while (bound > 0x1p-60 && of(bound / 2) >= x) bound /= 2;
        return bound;
    }

    std::uint32_t order_;
};

// (2^exponent |x - y|)^p for distances in the largest coordinate, as doubles and as whole numbers.
//
// `paid_*` are doubles. In the unit a distance is rounded once, so they are within (1 + 2^-53)^(2p) of the true cost,
// but for what lies below the doubles. The others are floor(2^grid paid), and `ceiling` where that would be more: what
// is paid may be rounded in the last bits of a double, what it is called in an auction is exact. Each is a monotone
// function of the distance, so the cost of a way to a box is never above that to a point in it.
class TransportCost {
public:
    explicit TransportCost(Power power) : power_(power) { set_unit(0); }

    // Unit 2^-exponent: that in which x > 0 is from 1 to 2, as far as exponents go; x may be infinite.
    static int unit_of(double x) {
        if (!is_finite(x)) return unit_min;
        const Decoded d = decode(x);
        const int unit = -(d.exponent + log2_floor(d.mantissa));
        return unit < unit_min ? unit_min : unit;
    }
    void set_unit(int exponent) {
        exponent_ = exponent;
        half_[0] = power_of_two(exponent / 2);
        half_[1] = power_of_two(exponent - exponent / 2);
    }
    // The grid in which `paid` > 0 is a whole number from 2^59 to 2^60; that becomes the ceiling.
    void set_grid(double paid) {
        grid_ = 59 + unit_of(paid);
        scale_ = power_of_two(grid_);
        top_ = paid * scale_;
        ceiling_ = static_cast<std::int64_t>(top_);
    }
    int exponent() const { return exponent_; }
    int grid() const { return grid_; }
    std::int64_t ceiling() const { return ceiling_; }
    const Power& power() const { return power_; }

    // Within 2^-53 of x 2^-grid.
    double off_grid(std::int64_t x) const { return static_cast<double>(x) * power_of_two(-grid_); }

    // x 2^-exponent; what was rounded goes down, or up. No more than the largest double; infinite above it.
    double lowered_from_unit(double x) const {
        const double y = from_unit(x);
        return in_unit(y) > x ? double_of_bits(bits_of(y) - 1) : y;
    }
    double raised_from_unit(double x) const {
        const double y = from_unit(x);
        return in_unit(y) < x ? next_up(y) : y;
    }

    double paid_between(const double* x, const double* y) const { return power_.of(distance(x, y)); }
    double paid_to_diagonal(const double* x) const { return power_.of(length(x) / 2); }
    double paid_on_line(double x, double y) const { return power_.of(difference(x, y)); }
    std::int64_t between(const double* x, const double* y) const { return whole(paid_between(x, y)); }
    std::int64_t to_diagonal(const double* x) const { return whole(paid_to_diagonal(x)); }
    // From x to the nearest point of a box.
    std::int64_t to_box(const double* x, const double* low, const double* high) const {
        double largest = 0;
        for (int k = 0; k < 2; ++k) {
            const double outside = x[k] < low[k]    ? difference(low[k], x[k])
                                   : x[k] > high[k] ? difference(x[k], high[k])
                                                    : 0;
            if (outside > largest) largest = outside;
        }
        return whole(power_.of(largest));
    }

    // In the unit: how far two points are apart, how long a bar is.
    double distance(const double* x, const double* y) const {
        const double births = difference(x[0], y[0]), deaths = difference(x[1], y[1]);
        return births > deaths ? births : deaths;
    }
    double length(const double* x) const { return difference(x[1], x[0]); }
    // 2^exponent |x - y|, also where x - y is beyond the doubles.
    double difference(double x, double y) const {
        const double plain = absolute(x - y);
        if (is_finite(plain)) return plain * half_[0] * half_[1];
        return absolute(x / 2 - y / 2) * half_[0] * half_[1] * 2;
    }

private:
    static constexpr int unit_min = -1022;
    double from_unit(double x) const {
        const int k = -exponent_;
        return x * power_of_two(k / 2) * power_of_two(k - k / 2);
    }
    // Exact for what came from the unit, infinity too.
    double in_unit(double y) const { return y * half_[0] * half_[1]; }
    std::int64_t whole(double paid) const {
        const double x = paid * scale_;
        return x < top_ ? static_cast<std::int64_t>(x) : ceiling_;
    }

    Power power_;
    int exponent_ = 0, grid_ = 0;
    double half_[2] = {1, 1};
    double scale_ = 1, top_ = 0;
    std::int64_t ceiling_ = 0;
};

}  // namespace netmesh
