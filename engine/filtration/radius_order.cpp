#include "filtration/radius_order.hpp"

#include "filtration/circumsphere_fast.hpp"
#include "numerics/close_values.hpp"
#include "numerics/real.hpp"
#include "numerics/sort.hpp"
#include "numerics/value_order.hpp"

namespace netmesh {
namespace {

[[gnu::cold]] bool simplex_radius(const double* const* point, int k, int dim, Radius* out) {
    if (k == 1) return edge_radius(distance2(dim, point[0], point[1]), static_cast<std::uint32_t>(dim), out);
    const std::uint32_t size = static_cast<std::uint32_t>(k), space = static_cast<std::uint32_t>(dim);
    Circumsphere sphere;
    if (!circumsphere_fast(size, space, point, &sphere)) return false;
    *out = {sphere.radius, radius_error(size, space, sphere.volume)};
    return true;
}

// How much the square of a radius differs from that of `base`, relative to the latter; below 2^-88 (1 + |result|) +
// 2^-53 |result| off. Not -0.
double deviation(const Floating& square, double base) {
    const int e = exponent_of(base), exponent = square.exponent - 2 * e;
    const double mantissa = base / power_of_two(e / 2) / power_of_two(e - e / 2);
    const double unit = power_of_two(exponent < -900 ? -900 : exponent > 900 ? 900 : exponent);
    const DoubleDouble ratio = scaled(square.mantissa / two_product(mantissa, mantissa), unit);
    return (ratio - DoubleDouble{1, 0}).high + 0.0;
}
// sqrt(base^2 (1 + x)), nearly always the nearest double.
double deviating(double base, double x) {
    const int e = exponent_of(base);
    const double near = power_of_two(e / 2), far = power_of_two(e - e / 2), mantissa = base / near / far;
    return kept_radius(square_root(two_product(mantissa, mantissa) * two_sum(1, x)) * near * far);
}
double deviation_error(double x) { return 0x1p-87 * (1 + absolute(x)) + 0x1p-52 * absolute(x); }

class RadiusOrder {
public:
    RadiusOrder(const FaceTable& faces, const PointRecords& points, const Work& work, double* const* value,
                const RadiusErrors& errors)
        : faces_(faces), points_(points), work_(work), value_(value), errors_(errors) {}

    Status run();
    const RadiusErrors& errors() const { return errors_; }
    bool has_ties() const { return tied_; }

private:
    static constexpr std::uint32_t few = 16;
    // What two radii below radius_min may be off by together. CloseValues allows for it: 5 units in the last place
    // each.
    static constexpr double spread_min = 0x1p-1072;

    // A face among all of them: those of dimension 1 first.
    struct Place {
        int k;
        std::uint32_t face;
    };
    Place place_of(std::uint32_t label) const {
        int k = 1;
        for (; label >= faces_.count[k]; ++k) label -= faces_.count[k];
        return {k, label};
    }
    [[gnu::cold, gnu::noinline]] ExactSphere sphere_of(std::uint32_t label) const {
        const Place place = place_of(label);
        const double* point[dimension_most() + 1];
        faces_.points(points_, place.k, place.face, point);
        return ExactSphere(point, place.k, faces_.dim);
    }
    Radius look_again(std::uint32_t i) const;

    Status part(std::uint32_t begin, std::uint32_t end);
    Status compute(std::uint32_t begin, std::uint32_t end);
    Status decide(std::uint32_t begin, std::uint32_t end, double base);
    bool compare_all(std::uint32_t begin, std::uint32_t end, double radius, double error);
    void settle(std::uint32_t begin, std::uint32_t end, double radius, double error);
    Status pass(bool all);
    bool collect(bool all);
    template <class Act> void each_radius(const CloseValues* close, Act act) const;
    bool stop(std::uint32_t work) { return work_.monitor.advance(done_, work); }

    const FaceTable faces_;
    const PointRecords& points_;
    const Work& work_;
    std::uint64_t* scratch_ = nullptr;
    double* const* const value_;
    RadiusErrors errors_;
    double spread_ = 0;     // relative
    double last_ = 0;       // the last radius that was settled
    double top_ = 0;        // what is settled now must not pass this: radii that were left out may be above it
    bool crowded_ = false;  // it did
    bool tied_ = false;     // two radii are equal, or were
    double* radius_ = nullptr;
    std::uint32_t* label_ = nullptr;
    std::uint32_t count_ = 0;
    std::uint64_t done_ = 0;
};

// Calls act(radius, label) for each radius, after asking for what `close`, if any, reads of it some before that. In two
// steps, as nobody could foresee which faces have one.
template <class Act> void RadiusOrder::each_radius(const CloseValues* close, Act act) const {
#ifdef __OPTIMIZE_SIZE__
    static_cast<void>(close);
    std::uint32_t label = 0;
    for (int k = 1; k <= faces_.dim; ++k)
        for (std::uint32_t i = 0; i < faces_.count[k]; ++i, ++label) {
            work_.arena.step(i, 30);
            if (value_[k][i] >= 0) act(value_[k][i], label);
        }
#else
    constexpr std::uint32_t ahead = 16, some = 128;
    double radius[some + ahead];
    std::uint32_t label[some], first = 0;
    for (int k = 1; k <= faces_.dim; first += faces_.count[k++])
        for (std::uint32_t begin = 0, end; begin < faces_.count[k]; begin = end) {
            end = faces_.count[k] - begin < some ? faces_.count[k] : begin + some;
            work_.arena.pass(some / 4);
            std::uint32_t count = 0;
            for (std::uint32_t i = begin; i < end; ++i) {
                radius[count] = value_[k][i];
                label[count] = first + i;
                count += value_[k][i] >= 0;
            }
            for (std::uint32_t i = 0; i < ahead; ++i) radius[count + i] = 0;
            for (std::uint32_t i = 0; i < count + ahead; ++i) {
                if (close != nullptr) close->fetch(radius[i]);
                if (i >= ahead) act(radius[i - ahead], label[i - ahead]);
            }
        }
#endif
}

// Takes radii and labels of those that may have another radius close by, or of all. False: out of memory.
bool RadiusOrder::collect(bool all) {
    count_ = 0;
    std::uint64_t faces = 0, radii = 0, room = 0;
    for (int k = 1; k <= faces_.dim; ++k) {
        faces += faces_.count[k];
        work_.arena.each(faces_.count[k], 5, [&](std::uint64_t i) { radii += value_[k][i] >= 0; });
    }
    if (faces > 0xFFFFFFFFu) return false;
    const std::size_t low = work_.arena.low_mark();
    CloseValues close;
    if (!all) {
        if (!close.take(radii, spread_, work_.arena)) return false;
        each_radius(&close, [&](double x, std::uint32_t) { room += 2 * close.add(x); });
    }
    if (all || room > radii) room = radii;
    radius_ = work_.arena.take_high<double>(static_cast<std::size_t>(room));
    label_ = work_.arena.take_high<std::uint32_t>(static_cast<std::size_t>(room));
    if (radius_ == nullptr || label_ == nullptr) {
        work_.arena.release_low(low);
        return false;
    }
    each_radius(all ? nullptr : &close, [&](double x, std::uint32_t label) {
        if (!all && !close.found(x)) return;
        radius_[count_] = x;
        label_[count_++] = label;
    });
    done_ = faces;
    work_.arena.release_low(low);
    return sort_labelled(radius_, label_, count_, work_.arena);
}

Status RadiusOrder::run() {
    spread_ = 1.01 * errors_.inner + 0x1p-51;
    const bool all = !(spread_ < CloseValues::spread_max);
    Status status = pass(all);
    if (status == Status::ok && crowded_ && !all) {
        spread_ = 1.01 * errors_.inner + 0x1p-51;
        status = pass(true);
    }
    return status;
}

Status RadiusOrder::pass(bool all) {
    const HighScope scope(work_.arena);
    if (!collect(all)) return Status::out_of_memory;
    scratch_ = work_.arena.take_high<std::uint64_t>(ExactSphere::room(faces_.dim));
    if (scratch_ == nullptr) return Status::out_of_memory;
    last_ = 0;
    const double low = 1 - spread_, high = 1 + spread_;
    for (std::uint32_t begin = 0, end; begin < count_; begin = end) {
        work_.arena.step(begin, 25);
        end = begin + 1;
        while (end < count_ && radius_[end] * low <= radius_[end - 1] * high + spread_min) {
            if (radius_[end] == radius_[end - 1]) tied_ = true;
            work_.arena.step(++end, 10);
        }
        top_ = radius_[end - 1] * (1 + spread_ / 2);
        if (end == begin + 1 && radius_[begin] > last_) {
            last_ = radius_[begin];
            continue;
        }
        const Status status = part(begin, end);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

// The radius at its place as the float stage knows it.
[[gnu::cold]] Radius RadiusOrder::look_again(std::uint32_t i) const {
    const Place place = place_of(label_[i]);
    const double* point[dimension_most() + 1];
    faces_.points(points_, place.k, place.face, point);
    Radius again;
    const bool known = simplex_radius(point, place.k, faces_.dim, &again);
    return known ? again : Radius{radius_[i], exact_radius_error(radius_[i])};
}

// Radii of which each meets the next by the common bound: cuts where all before are below all that follow.
[[gnu::cold]] Status RadiusOrder::part(std::uint32_t begin, std::uint32_t end) {
    if (end - begin > few || end - begin == 1 || crowded_) return compute(begin, end);
    double low[few], high[few];
    for (std::uint32_t i = 0; i < end - begin; ++i) {
        const double x = radius_[begin + i], error = 1.01 * look_again(begin + i).error + 0x1p-51;
        low[i] = x * (1 - error);
        high[i] = x * (1 + error);
    }
    for (std::uint32_t i = end - begin - 1; i-- > 0;) low[i] = low[i + 1] < low[i] ? low[i + 1] : low[i];
    double highest = 0;
    std::uint32_t from = 0;
    for (std::uint32_t i = 0; i < end - begin; ++i) {
        highest = high[i] > highest ? high[i] : highest;
        if (i + 1 < end - begin && low[i + 1] <= highest) continue;
        const Status status = compute(begin + from, begin + i + 1);
        if (status != Status::ok) return status;
        from = i + 1;
    }
    return Status::ok;
}

// Radii that nothing is known of but that they are above all before.
[[gnu::cold]] Status RadiusOrder::compute(std::uint32_t begin, std::uint32_t end) {
    // Of small ones too little is known: another pass may have moved them by their own size.
    if (end - begin == 1 && radius_[begin] >= radius_min) {
        settle(begin, end, radius_[begin], errors_.inner);
        return Status::ok;
    }
    const double base = radius_[begin];
    for (std::uint32_t i = begin; i < end; ++i) {
        const ExactSphere sphere = sphere_of(label_[i]);
        if (!sphere.in_range()) return Status::out_of_range;
        radius_[i] = deviation(sphere.radius_squared(scratch_), base);
        if (stop(64)) return Status::cancelled;
    }
    if (!sort_labelled(radius_ + begin, label_ + begin, end - begin, work_.arena)) return Status::out_of_memory;
    for (std::uint32_t from = begin, to; from < end; from = to) {
        to = from + 1;
        while (to < end &&
               radius_[to] - deviation_error(radius_[to]) <= radius_[to - 1] + deviation_error(radius_[to - 1]))
            work_.arena.step(to++, 40);
        const Status status = decide(from, to, base);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

// Radii whose leading digits agree. Each is held against some that are known to be equal; nearly always all are.
[[gnu::cold]] Status RadiusOrder::decide(std::uint32_t begin, std::uint32_t end, double base) {
    const double x = radius_[begin], radius = deviating(base, x);
    const double error = exact_radius_error(radius) + (radius_[end - 1] - x);
    if (end - begin == 1) {
        settle(begin, end, radius, error);
        return Status::ok;
    }
    const std::uint32_t first = label_[begin];
    std::uint32_t i;
#ifdef __OPTIMIZE_SIZE__
    for (i = begin; i < end; ++i) {
        const ExactSphere sphere = sphere_of(label_[i]), least = sphere_of(first);
        radius_[i] = 0;
        if (!ExactSphere::congruent(sphere, least) && !ExactSphere::excess(sphere, least, scratch_, &radius_[i]))
            return Status::out_of_range;
        if (stop(64)) return Status::cancelled;
    }
#else
    std::uint32_t equal[4] = {first}, kinds = 1;
    for (i = begin + 1; i < end; ++i) {
        const ExactSphere sphere = sphere_of(label_[i]);
        const double near = radius_[i] - x + deviation_error(radius_[i]) + deviation_error(x);
        bool found = false;
        for (std::uint32_t j = 0; j < kinds && !found; ++j) {
            work_.arena.pass(20);
            const ExactSphere other = sphere_of(equal[j]);
            found = ExactSphere::equal_if_within(sphere, other, near) || ExactSphere::congruent(sphere, other);
        }
        if (!found) {
            work_.arena.pass(100);
            double difference;
            if (!ExactSphere::excess(sphere, sphere_of(equal[0]), scratch_, &difference)) return Status::out_of_range;
            if (difference != 0) break;
            equal[kinds < 4 ? kinds++ : 1 + i % 3] = label_[i];
        }
        if (stop(16)) return Status::cancelled;
    }
    if (i == end) {
        settle(begin, end, radius, error);
        return Status::ok;
    }
    // Excess over the first, known once for all that are congruent.
    constexpr std::uint32_t slots = 32;
    std::uint32_t known[slots];
    double excess[slots];
    for (std::uint32_t& label : known) label = first;
    for (double& e : excess) e = 0;
    for (i = begin; i < end; ++i) {
        const ExactSphere sphere = sphere_of(label_[i]);
        const std::uint32_t slot = sphere.hash() % slots;
        if (!ExactSphere::congruent(sphere, sphere_of(known[slot]))) {
            if (!ExactSphere::excess(sphere, sphere_of(first), scratch_, &excess[slot])) return Status::out_of_range;
            known[slot] = label_[i];
        }
        radius_[i] = excess[slot];
        if (stop(64)) return Status::cancelled;
    }
#endif
    if (!sort_labelled(radius_ + begin, label_ + begin, end - begin, work_.arena)) return Status::out_of_memory;
    bool in_range = true;
    for (std::uint32_t from = begin, to; in_range && from < end; from = to) {
        to = from + 1;
        while (to < end && radius_[to] - radius_[to - 1] <= 0x1p-48 * absolute(radius_[to])) work_.arena.step(to++, 15);
        if (to - from == 1 || radius_[from] == 0) {
            settle(from, to, radius, error);
        } else {
            in_range = compare_all(from, to, radius, error);
        }
    }
    return in_range ? Status::ok : Status::out_of_range;
}

// The last resort: a comparison sort. False: out of range.
[[gnu::cold]] bool RadiusOrder::compare_all(std::uint32_t begin, std::uint32_t end, double radius, double error) {
    bool in_range = true;
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        work_.arena.pass(20);
        const ExactSphere x = sphere_of(a), y = sphere_of(b);
        double excess = 0;
        in_range = in_range && (ExactSphere::congruent(x, y) || ExactSphere::excess(x, y, scratch_, &excess));
        return excess < 0;
    };
#ifdef __OPTIMIZE_SIZE__
    insertion_sort(label_ + begin, end - begin, less);  // there are hardly ever more than two
#else
    bool sorted = true;
    for (std::uint32_t i = begin + 1; i < end && sorted; ++i) sorted = !less(label_[i], label_[i - 1]);
    if (!sorted) sort(label_ + begin, end - begin, less);
#endif
    for (std::uint32_t from = begin, to; in_range && from < end; from = to) {
        to = from + 1;
        while (to < end && !less(label_[to - 1], label_[to])) ++to;
        settle(from, to, radius, error);
    }
    return in_range;
}

// Equal radii, above those settled before.
[[gnu::cold]] void RadiusOrder::settle(std::uint32_t begin, std::uint32_t end, double radius, double error) {
    if (radius <= last_) {
        const double above = last_ < radius_max ? next_up(last_) : last_;
        // Relative to the true radius, which the error may make smaller: denormal ones may be off by their own size.
        error = above > last_ ? error + 1.01 * (1 + error) * ((above - radius) / radius) : infinity;
        radius = above;
    }
    last_ = radius;
    if (radius > top_) crowded_ = true;
    if (end - begin > 1) tied_ = true;
    errors_.note(radius, error);
    for (std::uint32_t i = begin; i < end;)
        for (const std::uint64_t piece = work_.arena.piece(i, end, 15); i < piece; ++i) {
            const Place place = place_of(label_[i]);
            const double before = value_[place.k][place.face];
            value_[place.k][place.face] = radius;
            if (!jumps_matter || before == radius || tied_) continue;
            faces_.each_without(static_cast<std::uint32_t>(place.k), place.face, (2u << place.k) - 1,
                                [&](std::uint32_t k, std::uint32_t face) {
                                    if (value_[k][face] == -before) value_[k][face] = -radius;
                                });
        }
}

}  // namespace

Status order_radii(const FaceTable& faces, const PointRecords& points, const Work& work, double* const* value,
                   RadiusErrors* errors, bool* tied) {
    RadiusOrder order(faces, points, work, value, *errors);
    const Status status = order.run();
    *errors = order.errors();
    *tied = !jumps_matter || order.has_ties();
    return status;
}

}  // namespace netmesh
