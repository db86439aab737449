#include "tools/plot/axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace netmesh::tool {

double ValueScale::of(double value) const { return is_linear ? value : value > 0 ? std::log(value) : low; }

double ValueScale::value_at(double coordinate) const { return is_linear ? coordinate : std::exp(coordinate); }

std::string ValueScale::label(double tick) const { return logarithm_label(tick); }

std::string ValueScale::second_label(double tick) const { return is_linear ? "" : radius_label(tick); }

std::vector<double> ValueScale::ticks() const {
    std::vector<double> ticks;
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++)
        ticks.push_back(std::fabs(k) < 0.5 ? 0 : k * step);
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

ValueScale scale_for(const std::vector<Bar>& bars, bool is_linear) {
    ValueScale scale;
    scale.is_linear = is_linear;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Bar& bar : bars) {
        scale.has_zero = scale.has_zero || (bar.birth == 0 && !is_linear);
        for (const double value : {bar.birth, bar.death}) {
            if ((!(value > 0) && !is_linear) || !std::isfinite(value)) continue;
            low = std::min(low, scale.of(value));
            high = std::max(high, scale.of(value));
        }
    }
    if (low > high) low = high = 0;
    // One value alone: as much about it as it is large.
    const double least = !is_linear ? 0.15 : high > low ? 0 : std::max(std::fabs(low), 1e-300) * 0.5;
    const double room = std::max(0.04 * (high - low), least);
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
    std::snprintf(text, sizeof text, "%.6g", std::fabs(logarithm));
    return (logarithm < 0 ? "\xE2\x88\x92" : "") + std::string(text);
}

}  // namespace netmesh::tool
