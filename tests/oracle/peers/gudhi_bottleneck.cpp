#include <gudhi/Bottleneck.h>

#include "oracle/peers/gudhi.hpp"

double gudhi_bottleneck(const std::vector<std::pair<double, double>>& a,
                        const std::vector<std::pair<double, double>>& b) {
    return Gudhi::persistence_diagram::bottleneck_distance(a, b, 0.);
}
