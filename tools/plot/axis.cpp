#include "tools/plot/axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace netmesh::tool {

namespace {

constexpr double linear_most = 8e307;  // so that doubles hold both ends and the length between them

}  // namespace

double ValueScale::of(double value) const {
    if (is_linear) return std::isfinite(value) ? std::clamp(value, -linear_most, linear_most) : value;
    return value > 0 ? std::log(value) : low;
}

double ValueScale::value_at(double coordinate) const { return is_linear ? coordinate : std::exp(coordinate); }

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

std::vector<double> even_ticks(double low, double high) {
    if (!(high - low > 1e-300)) return {low};
    std::vector<double> ticks;
    const double step = step_for(high - low);
    const double first = std::ceil(low / step - 1e-9);
    for (int i = 0; i < 20 && (first + i) * step <= high + 1e-9 * step; i++) {
        const double k = first + i;
        ticks.push_back(std::fabs(k) < 0.5 ? 0 : k * step);
    }
    return ticks;
}

constexpr double ln_10 = 2.302585092994046;

}  // namespace

std::vector<double> ValueScale::ticks() const {
    if (is_linear) return even_ticks(low, high);
    const double decades = (high - low) / ln_10;
    if (decades < 0.9) return even_ticks(std::exp(low), std::exp(high));
    // Powers of ten, every so many; 1, 2 and 5 times them where there are few.
    std::vector<double> ticks;
    const double stride = std::ceil(decades / 10);
    const double first = std::floor(low / ln_10 / stride), last = std::floor(high / ln_10 / stride);
    for (double k = first; k <= last; k++) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor > 1 && decades > 4) continue;
            const double tick = factor * std::pow(10.0, k * stride);
            if (std::log(tick) >= low - 1e-9 && std::log(tick) <= high + 1e-9) ticks.push_back(tick);
        }
    }
    return ticks;
}

// Digits: those of the largest value by the distance of ticks.
std::string ValueScale::label(double tick) const {
    int digits = 6;
    if (is_linear || high - low < 0.9 * ln_10) {
        const double first = value_at(low), last = value_at(high);
        const double step = step_for(last - first), most = std::max(std::fabs(first), std::fabs(last));
        digits = std::clamp(static_cast<int>(std::ceil(std::log10(most / step) + 0.5)) + 1, 3, 17);
    }
    char text[48];
    std::snprintf(text, sizeof text, "%.*g", digits, std::fabs(tick));
    return (tick < 0 ? "\xE2\x88\x92" : "") + std::string(text);
}

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
    const double least = !is_linear ? 0.15 : high > low ? 1e-299 : std::max(std::fabs(low), 1e-298) * 0.5;
    // Half of the length first: between numbers of both signs it may be more than there are doubles for.
    const double room = std::max(0.08 * (0.5 * high - 0.5 * low), least);
    const double most = is_linear ? linear_most : 709.7;  // the logarithm of the largest double
    scale.low = std::max(low - room, is_linear ? -linear_most : -745.0);
    scale.high = std::min(high + room, most);
    return scale;
}

bool is_linear_axis(Axis axis, bool are_radii, const std::vector<Bar>& bars) {
    if (axis == Axis::linear || (axis == Axis::natural && !are_radii)) return true;
    return std::any_of(bars.begin(), bars.end(), [](const Bar& bar) { return bar.birth < 0; });
}

}  // namespace netmesh::tool
