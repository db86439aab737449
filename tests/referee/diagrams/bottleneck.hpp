// Bottleneck distances between diagrams, exactly.
#pragma once
#include "../exact.hpp"
#include "diagram_file.hpp"

namespace referee {

struct ExactDistance {
    bool infinite = false;
    Rational value;  // the distance; with `log` the square of the ratio e^distance
};

// With `log` the distance of logarithms, births at 0 matched to births at 0 alone.
ExactDistance bottleneck(const std::vector<Bar>& a, const std::vector<Bar>& b, int degree, bool log);

// Is x the double nearest to q, or one of two?
bool is_nearest(double x, const Rational& q);

}  // namespace referee
