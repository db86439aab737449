#include "jobs/bar_bounds.hpp"

#include "jobs/value_table.hpp"

namespace netmesh {
namespace {

class Interleaving {
public:
    Status open(const FilterBounds& filter, Arena& arena) {
        const auto t = [&](std::uint32_t v) { return filter.value[v]; };
        const auto lo = [&](std::uint32_t v) { return filter.interval[v].lo; };
        const auto hi = [&](std::uint32_t v) { return filter.interval[v].hi; };
        const std::uint32_t count = filter.count;
        const bool room = by_value_.open_largest(count, t, hi, arena) && by_low_.open_largest(count, lo, t, arena) &&
                          lows_.open_least(count, t, lo, arena);
        return room ? Status::ok : Status::out_of_memory;
    }
    double phi(double b) const { return larger(by_value_.largest_up_to(b), b); }
    double psi(double a) const { return larger(by_low_.largest_up_to(a), a); }
    double psi_inverse(double b) const {
        const double least = lows_.least_from(b);
        return least < b ? least : b;
    }
    // The step that begins at scale `from`, where the next one begins; infinity for the last.
    ScaleStep step(double from, double* next) const {
        const double enough = psi(phi(from)) * (1 + 0x1p-4);
        const auto exceeds = [&](double a) { return a > from && psi(phi(a)) > enough; };
        const std::uint32_t i = by_value_.first_where(exceeds), j = by_low_.first_where(exceeds);
        const double a = i < by_value_.count() ? by_value_.key(i) : infinity;
        const double b = j < by_low_.count() ? by_low_.key(j) : infinity;
        *next = a < b ? a : b;
        // Between keys psi(phi(a)) is constant or a.
        double reach = psi(phi(from));
        if (i > 0) reach = larger(reach, psi(phi(by_value_.key(i - 1))));
        if (j > 0) reach = larger(reach, psi(phi(by_low_.key(j - 1))));
        return {from, reach};
    }
    double first_scale() const { return by_value_.first() < by_low_.first() ? by_value_.first() : by_low_.first(); }

private:
    static double larger(double a, double b) { return a > b ? a : b; }

    ValueTable by_value_, by_low_, lows_;  // hi by t, t by lo, lo by t
};

}  // namespace

Status bound_by_scale(const FilterBounds& filter, const BarList& bars, Arena& arena, BarBounds* bounds,
                      ScaleCurve* curve) {
    const HighScope scope(arena);
    Interleaving interleaving;
    Status status = interleaving.open(filter, arena);
    *curve = {arena.take_low<ScaleStep>(0), 0};
    if (curve->steps == nullptr) status = Status::out_of_memory;
    if (status != Status::ok) return status;
    for (double at = interleaving.first_scale(); at < infinity; ++curve->count) {
        if (!arena.extend_low(sizeof(ScaleStep))) return Status::out_of_memory;
        curve->steps[curve->count] = interleaving.step(at, &at);
    }
    for (std::uint64_t i = 0; i < bars.count; ++i) {
        const double birth = bars.pairs[i].birth, death = bars.pairs[i].death;
        const double latest = interleaving.phi(birth), after = interleaving.psi(latest);
        bounds[i] = {interleaving.psi_inverse(birth),
                     latest,
                     interleaving.psi_inverse(death),
                     death < infinity ? interleaving.phi(death) : infinity,
                     after,
                     death > after ? 1u : 0u,
                     0};
        if (birth == 0) bounds[i].birth_low = 0;
    }
    return Status::ok;
}

Status bound_by_ratio(double ratio, const BarList& bars, Arena& arena, BarBounds* bounds, ScaleCurve* curve) {
    for (std::uint64_t i = 0; i < bars.count; ++i) {
        const double birth = bars.pairs[i].birth, death = bars.pairs[i].death;
        const bool zero = birth == 0;  // whatever the ratio: 0 times infinity is no number
        const double after = zero ? 0 : birth * ratio * ratio;
        bounds[i] = {zero ? 0 : birth / ratio,
                     zero ? 0 : birth * ratio,
                     death < infinity ? death / ratio : infinity,
                     death > 0 ? death * ratio : 0,
                     after,
                     death > after ? 1u : 0u,
                     0};
    }
    *curve = {arena.take_low<ScaleStep>(ratio > 1 ? 1 : 0), ratio > 1 ? 1u : 0u};
    if (curve->steps == nullptr) return Status::out_of_memory;
    if (ratio > 1) curve->steps[0] = {0, infinity};
    return Status::ok;
}

double step_ratio(const ScaleStep& step, double certified_ratio) {
    const double ratio = step.reach > step.from ? square_root(step.reach / step.from) * up : 1;
    return ratio < certified_ratio ? ratio : certified_ratio;
}

}  // namespace netmesh
