// Numbers that look random and are the same everywhere (splitmix64).
#pragma once
#include <cmath>
#include <cstdint>

#include "exact.hpp"

namespace referee {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(next() % n); }
    // In [0, 1), with all bits of a double.
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    double normal() {
        double sum = -6;
        for (int i = 0; i < 12; i++) sum += unit();
        return sum;
    }
    Point direction(int dim) {
        while (true) {
            Point x = {};
            double length2 = 0;
            for (int k = 0; k < dim; k++) {
                x[k] = between(-1, 1);
                length2 += x[k] * x[k];
            }
            if (length2 > 1 || length2 < 1e-4) continue;
            for (int k = 0; k < dim; k++) x[k] /= std::sqrt(length2);
            return x;
        }
    }

private:
    std::uint64_t state_;
};

}  // namespace referee
