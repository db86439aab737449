// Filter values between what a mesh lets them be.
#pragma once
#include "filtration/cell_bounds.hpp"
#include "filtration/mesh_filter.hpp"

namespace netmesh {

// The clamp that makes the certificate best, for intervals cut at `cut`, as own values are here. interval(v) is called twice;
// intervals[v], when asked for.
template <class IntervalOf>
void clamp_values(std::uint32_t count, double cut, FilterValues values, IntervalOf&& interval, double* value,
                  MeshCertificate* certificate, Interval* intervals) {
    double best2 = 1;
    for (std::uint32_t v = 0; v < count; ++v) {
        const Interval i = interval(v);
        if (i.hi > i.lo * best2) best2 = i.hi / i.lo;
    }
    const double best = best2 > 1 ? square_root(best2) * up : 1;
    double ratio = 1;
    for (std::uint32_t v = 0; v < count; ++v) {
        const Interval i = interval(v);
        if (intervals != nullptr) intervals[v] = i;
        double t = value[v] < cut ? value[v] : cut;
        if (values == FilterValues::certified && is_finite(best)) {
            const double least = i.hi / best, most = i.lo * best;
            if (t < least) t = least;
            if (t > most) t = most;
        }
        if (i.hi > t && !(i.hi / t * up <= ratio)) ratio = i.hi / t * up;
        if (t > i.lo && !(t / i.lo * up <= ratio)) ratio = t / i.lo * up;
        value[v] = t;
    }
    *certificate = {ratio, best, 0};
}

}  // namespace netmesh
