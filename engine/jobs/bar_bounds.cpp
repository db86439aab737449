#include "jobs/bar_bounds.hpp"

#include "jobs/join_shift.hpp"
#include "jobs/scale_grid.hpp"
#include "jobs/value_table.hpp"
#include "numerics/bits.hpp"

namespace netmesh {
namespace {

class Interleaving {
public:
    explicit Interleaving(Spacing spacing) : spacing_(spacing) {}
    Status open(const FilterBounds& filter, Arena& arena) {
        arena_ = &arena;
        const auto t = [&](std::uint32_t v) { return filter.value[v]; };
        const auto lo = [&](std::uint32_t v) { return filter.interval[v].lo; };
        const auto hi = [&](std::uint32_t v) { return filter.interval[v].hi; };
        const std::uint32_t count = filter.count;
        const bool room = by_value_.open_largest(count, t, hi, arena) && by_low_.open_largest(count, lo, t, arena) &&
                          lows_.open_least(count, t, lo, arena);
        return room ? Status::ok : Status::out_of_memory;
    }
    double phi(double b) const { return larger(highest(b), b); }
    double psi(double a) const { return larger(by_low_.largest_up_to(a, spacing_.least()), a); }
    double psi_inverse(double b) const { return smaller(lowest(b), b); }
    // The step that begins at scale `from`, where the next one begins; infinity for the last.
    ScaleStep step(double from, double* next) const {
        constexpr double growth = 1 + 0x1p-4;
        const double high = spacing_.after(highest(from), growth), reach = spacing_.after(psi(phi(from)), growth);
        const auto grown = [&](double a) { return a > from && (highest(a) > high || psi(phi(a)) > reach); };
        *next = smaller(begin_of_lowest(from, growth), smaller(by_value_.key_or_infinity(by_value_.first_where(grown)),
                                                               by_low_.key_or_infinity(by_low_.first_where(grown))));
        // From the last key on `highest` is constant, and psi(phi(a)) is constant or a.
        const double last = larger(from, larger(last_key(by_value_, *next), last_key(by_low_, *next)));
        return {from,
                lowest(from),
                spacing_.is_difference() ? larger(highest(last), from) : highest(last),
                psi(phi(last)),
                from < 0 ? infinity : largest(from, *next, 1, [](double a, double b) { return quotient(a, b); }),
                largest(from, *next, 0, [](double a, double b) { return difference(a, b); })};
    }
    double first_scale() const { return smaller(by_value_.first(), by_low_.first()); }
    // From this scale on there is no bound but the identity.
    double end_scale() const { return larger(highest(by_value_.last()), larger(by_value_.last(), by_low_.last())); }
    // What holds from `from` to before `next`, where the diagram is joined with others. psi' = psi(after), psi'^- =
    // before(psi^-): a / psi'^-(a) is the product of two factors.
    ScaleStep step_in_join(double from, double next, const JoinShift& join) const {
        const double last = larger(from, larger(last_key(by_value_, next), last_key(by_low_, next)));
        const double low = lowest(from), high = highest(last);
        const double least = smaller(low, from), most = larger(high, next);
        const bool exact = join.is_exact_until(most);
        return {from,
                exact ? low : join.before(least),
                high,
                exact ? psi(phi(last)) : psi(join.after(most)),
                largest(from, next, 1, [](double a, double b) { return quotient(a, b); }) * join.factor(least, next),
                0};
    }

private:
    static double larger(double a, double b) { return a > b ? a : b; }
    static double smaller(double a, double b) { return a < b ? a : b; }
    // Before `next`, what is before all scales for none.
    double last_key(const ValueTable& table, double next) const {
        const std::uint32_t i = table.keys_until(next, true);
        return i > 0 ? table.key(i - 1) : spacing_.least();
    }
    // phi(a) = max(a, highest(a)), psi^-(a) = min(a, lowest(a)). At a distance of 0 any number does as lowest, so what
    // comes later.
    double highest(double a) const { return by_value_.largest_up_to(a, spacing_.least()); }
    double lowest(double a) const {
        return a > 0 || spacing_.is_difference() ? lows_.least_from(a) : lows_.least_after(0);
    }
    // Where `lowest` first has grown by so much: just after a key, as psi^- is continuous from the left. Infinity when
    // no key is left.
    double begin_of_lowest(double from, double growth) const {
        const double enough = spacing_.after(lowest(from), growth);
        if (!(enough < infinity)) return infinity;
        return next_up(lows_.key(lows_.first_where([&](double a) { return lowest(a) > enough; }) - 1));
    }
    // The largest c(a), or e(a), for a in [from, next): phi(a) is farthest above a at `from` or a key, psi^-(a) below
    // at a key or just before `next`. A step that ends at infinity has no lowest there, so what is below ends at a key.
    template <class Apart> double largest(double from, double next, double least, Apart&& apart) const {
        double most = larger(least, larger(apart(highest(from), from), apart(next, lowest(next))));
        for (std::uint32_t i = by_value_.keys_until(from, true); by_value_.key_or_infinity(i) < next; ++i) {
            arena_->step(i, 400);
            const double a = by_value_.key(i);
            most = larger(most, larger(apart(highest(a), a), apart(a, lowest(a))));
        }
        return most;
    }
    static double quotient(double a, double b) { return !(a > b) ? 1 : b > 0 ? a / b * up : infinity; }
    static double difference(double a, double b) { return a > b ? (a - b) * up : 0; }

    Spacing spacing_;
    const Arena* arena_ = nullptr;
    ValueTable by_value_, by_low_, lows_;  // hi by t, t by lo, lo by t
};

}  // namespace

namespace {

// A death at a or before belongs to no class that is certified to exist.
template <class After>
void bound_each(const Interleaving& interleaving, const BarList& bars, bool zero_is_exact, After&& certain_after,
                const Arena& arena, BarBounds* bounds) {
    for (std::uint64_t i = 0; i < bars.count;)
        for (const std::uint64_t piece = arena.piece(i, bars.count, 1200); i < piece; ++i) {
            const double birth = bars[i].birth, death = bars[i].death;
            const double latest = interleaving.phi(birth), after = certain_after(latest);
            bounds[i] = {interleaving.psi_inverse(birth),
                         latest,
                         interleaving.psi_inverse(death),
                         death < infinity ? interleaving.phi(death) : infinity,
                         after,
                         death > after ? 1u : 0u,
                         0};
            if (birth == 0 && zero_is_exact) bounds[i].birth_low = 0;
        }
}

}  // namespace

Status bound_by_scale(const FilterBounds& filter, const BarList& bars, Spacing spacing, Arena& arena, BarBounds* bounds,
                      ScaleCurve* curve) {
    const HighScope scope(arena);
    Interleaving interleaving(spacing);
    Status status = interleaving.open(filter, arena);
    *curve = {arena.take_low<ScaleStep>(0), 0};
    if (curve->steps == nullptr) status = Status::out_of_memory;
    if (status != Status::ok) return status;
    for (double at = interleaving.first_scale(); at < infinity; ++curve->count) {
        if (!arena.extend_low(sizeof(ScaleStep))) return Status::out_of_memory;
        arena.pass(10);
        curve->steps[curve->count] = interleaving.step(at, &at);
    }
    bound_each(
        interleaving, bars, !spacing.is_difference(), [&](double latest) { return interleaving.psi(latest); }, arena,
        bounds);
    return Status::ok;
}

Status bound_in_join(const FilterBounds& filter, const BarList& bars, const JoinShift& join, Arena& arena,
                     BarBounds* bounds, ScaleGrid* grid) {
    const HighScope scope(arena);
    Interleaving interleaving{Spacing()};
    const Status status = interleaving.open(filter, arena);
    if (status != Status::ok) return status;
    // From there on the join can move what is exact to where the mesh has cells.
    const double first = join.before(interleaving.first_scale()), end = interleaving.end_scale();
    grid->begin_at(first);
    for (std::uint32_t i = grid->cell_of(first); i < grid->count() && grid->from(i) <= end;)
        for (const std::uint64_t piece = arena.piece(i, grid->count(), 3000); i < piece && grid->from(i) <= end; ++i) {
            grid->add(i, interleaving.step_in_join(i == 0 ? first : grid->from(i), grid->next(i), join));
        }
    bound_each(
        interleaving, bars, true, [&](double latest) { return interleaving.psi(join.after(latest)); }, arena, bounds);
    return Status::ok;
}

namespace {

double double_below(double x) { return x > 0 && x < infinity ? double_of_bits(bits_of(x) - 1) : x; }
double double_above(double x) { return x < infinity ? double_of_bits(bits_of(x) + 1) : x; }

// Is 0 the true birth? A point enters there; another simplex may be told to, being too small for a double.
bool is_born_at_zero(const Pair& bar, const UniformBound& bound) {
    return bar.birth == 0 && (!bound.rounded || (bar.degree == 0 && bound.has_points));
}

// Ends that are true ones rounded to nearest: within half a unit in the last place, and different only where the true
// ones are.
BarBounds by_rounding(const Pair& bar, const UniformBound& bound) {
    const double latest = is_born_at_zero(bar, bound) ? 0 : double_above(bar.birth);
    return {double_below(bar.birth),         latest, double_below(bar.death), double_above(bar.death), latest,
            bar.death > bar.birth ? 1u : 0u, 0};
}

// By the ratio and the slack s for rounding: phi and psi of the head are x c s, and a bar is certified to exist when
// its death is after c^2 s^2 times its birth. Below the normal range the roundings of a value, and of a bound, are less
// than four times the least double together.
BarBounds by_ratio(const Pair& bar, const UniformBound& bound) {
    const bool zero = is_born_at_zero(bar, bound);  // whatever the ratio: 0 times infinity is no number
    const double slack = bound.rounded ? 1 + 0x1p-50 : 1, least = bound.rounded ? 0x1p-1072 : 0;
    const double most = bound.ratio * slack;
    const auto before = [=](double x) { return x / most >= least ? x / most - least : 0; };
    const auto after = [=](double x) { return (x + least) * most + least; };
    const double latest = zero ? 0 : after(bar.birth), real_after = zero ? 0 : after(latest) * slack;
    return {before(bar.birth),
            latest,
            bar.death < infinity ? before(bar.death) : infinity,
            bar.death > 0 || bound.rounded ? after(bar.death) : 0,
            real_after,
            bar.death > real_after ? 1u : 0u,
            0};
}

// Narrows what is known by the additive bound e. A sum is rounded by a share of what comes out, 2^-40 covers it; where
// the terms cancel, of the larger term.
void narrow(const Pair& bar, double e, BarBounds* bounds) {
    const bool ends = bar.death < infinity;
    const auto slack = [e](double x) { return (absolute(x) + e) * 0x1p-40; };
    const double birth_low = bar.birth - e - slack(bar.birth), birth_high = bar.birth + e + slack(bar.birth);
    const double after = bar.birth + 2 * e + 2 * slack(bar.birth);
    if (birth_low > bounds->birth_low) bounds->birth_low = birth_low;
    if (birth_high < bounds->birth_high) bounds->birth_high = birth_high;
    if (!ends) bounds->death_low = bounds->death_high = infinity;
    if (ends && bar.death - e - slack(bar.death) > bounds->death_low)
        bounds->death_low = bar.death - e - slack(bar.death);
    if (ends && bar.death + e + slack(bar.death) < bounds->death_high)
        bounds->death_high = bar.death + e + slack(bar.death);
    if (after < bounds->certain_after) bounds->certain_after = after;
    bounds->certain = bar.death > bounds->certain_after ? 1 : bounds->certain;
}

}  // namespace

Status bound_by_ratio(const UniformBound& bound, const BarList& bars, Arena& arena, BarBounds* bounds,
                      ScaleCurve* curve) {
    const double ratio = bound.ratio;
    const bool is_additive = bound.error >= 0, has_ratio = ratio < infinity || !is_additive;
    double from = 0;
    for (std::uint64_t i = 0; i < bars.count;)
        for (const std::uint64_t piece = arena.piece(i, bars.count, 80); i < piece; ++i) {
            bounds[i] = !has_ratio ? BarBounds{-infinity, infinity, -infinity, infinity, infinity, 0, 0}
                        : bound.rounded && ratio == 1 ? by_rounding(bars[i], bound)
                                                      : by_ratio(bars[i], bound);
            if (is_additive) narrow(bars[i], bound.error, &bounds[i]);
            if (bars[i].birth < from) from = bars[i].birth;
        }
    *curve = {arena.take_low<ScaleStep>(ratio > 1 ? 1 : 0), ratio > 1 ? 1u : 0u};
    if (curve->steps == nullptr) return Status::out_of_memory;
    if (ratio > 1)
        curve->steps[0] = {from,  has_ratio ? 0 : -infinity,           infinity, infinity,
                           ratio, is_additive ? bound.error : infinity};
    return Status::ok;
}

}  // namespace netmesh
