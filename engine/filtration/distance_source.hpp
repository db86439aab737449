// Distances of points, wherever they come from.
#pragma once
#include <cstddef>
#include <cstdint>

#include "geometry/half_distance.hpp"
#include "include/netmesh.h"
#include "vocabulary/callback.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// Half a distance, to nearest, which rounds below the normal range alone.
struct HalfDistance {
    double half;
    bool is_less;  // than half the distance
};

// Of a negative number itself: the half of the least one rounds to zero, and has to be refused.
inline HalfDistance halved(double distance) {
    if (distance < 0) return {distance, false};
    const double half = distance / 2 + 0.0;
    return {half, half + half < distance};
}

// When points join that are joined within twice the threshold: infinity, never, where rounding alone took them there.
inline double joins_at(HalfDistance d, double threshold) {
    return d.is_less && d.half == threshold ? infinity : d.half;
}

// Half the distance of points i and j < i.
struct DistanceSource {
    enum class Kind { full, lower, halves, function, points };
    Kind kind;
    std::uint32_t count;    // of points, >= 1
    const double* numbers;  // full: [count][count]; lower, halves: [count (count - 1) / 2]; points: [count][dim]
    std::uint32_t dim;      // of points
    netmesh_distance_function evaluate;
    void* user;

    double half(std::uint32_t i, std::uint32_t j) const { return rounded_half(i, j).half; }
    HalfDistance rounded_half(std::uint32_t i, std::uint32_t j) const {
        const std::size_t n = count;
        switch (kind) {
        case Kind::full: return halved(numbers[i * n + j]);
        case Kind::lower: return halved(numbers[triangle(i) + j]);
        case Kind::halves: return {numbers[triangle(i) + j], false};
        case Kind::function: return halved(distance_at(evaluate, user, i, j));
        case Kind::points: break;
        }
        const double *const a = numbers + i * std::size_t{dim}, *const b = numbers + j * std::size_t{dim};
        return {half_distance(static_cast<int>(dim), a, b), false};
    }
    // half(i, j) where it is below `near`; else a number that is not, and within `limit` where half(i, j) is.
    double half_if_below(std::uint32_t i, std::uint32_t j, double near, double limit) const {
        if (kind == Kind::points) {
            const std::size_t row = dim;
            const double squared = distance2(static_cast<int>(dim), numbers + i * row, numbers + j * row);
            if (surely_above(static_cast<int>(dim), squared, near)) {
                if (surely_below(static_cast<int>(dim), squared, limit)) return near;
                if (surely_above(static_cast<int>(dim), squared, limit)) return __builtin_inf();
            }
        }
        return half(i, j);
    }
    static std::size_t triangle(std::uint32_t i) {
        return i % 2 == 0 ? i / 2 * (i - std::size_t{1}) : (i - 1) / 2 * std::size_t{i};
    }
    // What half() costs, in nanoseconds or so.
    std::uint32_t cost() const { return kind == Kind::points ? 5 + dim : kind == Kind::function ? 50 : 5; }
};

enum class DistanceFlaw { none, negative, not_a_number, asymmetric, own, no_point };

// Where distances are at fault: a row and a column, or the number of an entry.
struct DistanceFault {
    DistanceFlaw flaw = DistanceFlaw::none;
    std::uint64_t a = 0, b = 0;
};

inline DistanceFlaw flaw_of(double distance) {
    if (distance >= 0) return DistanceFlaw::none;
    return distance < 0 ? DistanceFlaw::negative : DistanceFlaw::not_a_number;
}

// Polls while pairs are met.
class PairPolls {
public:
    PairPolls(Monitor& monitor, std::uint32_t cost) : monitor_(monitor), cost_(cost) {}
    // True when the caller wants to stop.
    bool stop(std::uint32_t row) {
        spent_ += cost_;
        if (spent_ < 3000) return false;
        const std::uint32_t work = spent_ / 100;
        spent_ = 0;
        return monitor_.advance(row, work);
    }

private:
    Monitor& monitor_;
    std::uint32_t cost_, spent_ = 0;
};

}  // namespace netmesh
