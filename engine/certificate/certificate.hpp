// The ratio that intervals prove for filter values, and the values that make it the best.
//
// Let lo <= F <= hi on the cell of each vertex and t its filter value. Where the cells (with what stands for them, see
// the filters) form a cover, the diagrams of the filter and of F are within ln c on the log scale, c = max over the
// vertices of max(hi / t, t / lo). The best values reach c* = max sqrt(hi / lo): any t between hi / c* and c* lo does.
// A filter's own value clamped to these limits stays closest to it.
#pragma once
#include <cstdint>

#include "certificate/interval.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {

enum class FilterValues { certified, thesis };  // clamped; a filter's own

struct Certificate {
    double ratio = 1;       // c of the values given
    double ratio_best = 1;  // c*
    double from = 0;        // scale from which the ratio holds: 0 but for the basic filter
    double error = 0;       // additive bound, of functions of the caller's alone (function_filter.hpp)
};

// First every interval is shown to it, then every value.
class Clamp {
public:
    explicit Clamp(FilterValues values) : values_(values) {}

    void show(Interval i) {
        const double square = i.hi / i.lo;
        if (square > widest_) widest_ = square;
    }
    double widest() const { return widest_; }  // the largest hi / lo shown, at least 1
    // A little less than the root of that. A vertex whose own value t has t <= c lo and hi <= c t, c this, keeps t for
    // its value and is not what decides the ratio, even if closer bounds take the place of lo and hi, nor does lo
    // change anything when t <= c lo and hi <= c^2 lo.
    double sure_ratio() const { return square_root(widest_) * down; }
    void fix_ratio() { certificate_.ratio_best = widest_ > 1 ? square_root(widest_) * up : 1; }

    // After fix_ratio: the value of a vertex whose own value is t.
    double value(double t, Interval i) {
        if (values_ == FilterValues::certified) {
            const double least = i.hi / certificate_.ratio_best, most = i.lo * certificate_.ratio_best;
            if (t < least) t = least;
            if (t > most) t = most;
        }
        if (i.hi > t && !(i.hi / t * up <= certificate_.ratio)) certificate_.ratio = i.hi / t * up;
        if (t > i.lo && !(t / i.lo * up <= certificate_.ratio)) certificate_.ratio = t / i.lo * up;
        return t;
    }
    const Certificate& certificate() const { return certificate_; }

private:
    FilterValues values_;
    double widest_ = 1;
    Certificate certificate_;
};

// Clamps value[count], the own values, which are cut at `cut` as the intervals are. interval(v) is called twice;
// intervals[v], when asked for.
template <class IntervalOf>
Certificate clamp_values(std::uint32_t count, double cut, FilterValues values, IntervalOf&& interval, double* value,
                         Interval* intervals) {
    Clamp clamp(values);
    for (VertexId v(0); v < count; ++v) {
        const Interval i = interval(v);
        if (i.hi > i.lo * clamp.widest()) clamp.show(i);  // products first: most intervals need no division
    }
    clamp.fix_ratio();
    for (VertexId v(0); v < count; ++v) {
        const Interval i = interval(v);
        if (intervals != nullptr) intervals[v] = i;
        value[v] = clamp.value(value[v] < cut ? value[v] : cut, i);
    }
    return clamp.certificate();
}

}  // namespace netmesh
