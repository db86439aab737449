// GUDHI's alpha complexes and bottleneck distances, compiled once: their headers take a minute each.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "common/inputs.hpp"

// The alpha complex in exact arithmetic. Its values are exact squares of radii, rounded to double; roots of these.
struct GudhiAlpha {
    struct Simplex {
        std::vector<std::uint32_t> vertices;
        double radius;
    };
    struct Bar {
        int degree;
        double birth, death;
    };
    GudhiAlpha(int dim, const inputs::Points& points);

    std::vector<Simplex> simplices;
    std::vector<Bar> bars;  // those of no length as well
};

// The exact distance.
double gudhi_bottleneck(const std::vector<std::pair<double, double>>& a,
                        const std::vector<std::pair<double, double>>& b);
