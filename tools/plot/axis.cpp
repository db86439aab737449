#include "tools/plot/axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace netmesh::tool {

double LogScale::share(double radius) const {
    if (!(radius > 0)) return 0;
    return (std::log(radius) - low) / (high - low);
}

std::vector<double> LogScale::ticks() const {
    std::vector<double> ticks;
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) ticks.push_back(k * step);
    return ticks;
}

namespace {

// 1, 2 or 5 times a power of ten, so that about eight steps make up `length`.
double step_for(double length) {
    const double wanted = length / 8;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= wanted) return factor * power;
    }
    return 10 * power;
}

}  // namespace

LogScale scale_for(const std::vector<Bar>& bars) {
    LogScale scale;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Bar& bar : bars) {
        scale.has_zero = scale.has_zero || bar.birth == 0;
        for (const double radius : {bar.birth, bar.death}) {
            if (!(radius > 0) || !std::isfinite(radius)) continue;
            low = std::min(low, std::log(radius));
            high = std::max(high, std::log(radius));
        }
    }
    if (low > high) low = high = 0;
    const double room = std::max(0.04 * (high - low), 0.15);
    scale.low = low - room;
    scale.high = high + room;
    scale.step = step_for(scale.high - scale.low);
    return scale;
}

std::string radius_label(double logarithm) {
    const double radius = std::exp(logarithm);
    char text[40];
    if (radius >= 1e-3 && radius < 1e5) {
        const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(radius) + 1e-9)));
        std::snprintf(text, sizeof text, "%.*f", decimals, radius);
        std::string label = text;
        if (label.find('.') != std::string::npos) {
            while (label.back() == '0') label.pop_back();
            if (label.back() == '.') label.pop_back();
        }
        return label;
    }
    const int exponent = static_cast<int>(std::floor(logarithm / std::log(10.0)));
    std::snprintf(text, sizeof text, "%.1fe%d", std::exp(logarithm - exponent * std::log(10.0)), exponent);
    return text;
}

std::string logarithm_label(double logarithm) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", std::fabs(logarithm) < 1e-9 ? 0.0 : std::fabs(logarithm));
    return (logarithm < -1e-9 ? "\xE2\x88\x92" : "") + std::string(text);
}

}  // namespace netmesh::tool
