#include "laboratory/feature_integral.hpp"

#include "numerics/elementary.hpp"

namespace netmesh {
namespace {

constexpr double sum_rounding = 0x1p-26;  // more than that of sums of 2^24 terms
constexpr double mean_over_max =
    0.57736;  // mean distance from the centre of a box over half its diagonal, at most 1/sqrt(3)
constexpr int levels_max = 2200;

// How the value at the centre of a box bounds the mean over the box, h / f = eta: 1 / f^dim lies between those at f +
// |x
// - c| and f - |x - c|, both convex in |x - c|, whose mean is at most h / sqrt(3): Jensen below, the chord above.
double mean_at_least(int dim, double eta) { return 1 / power(1 + mean_over_max * eta, dim); }
double mean_at_most(int dim, double eta) { return 1 - mean_over_max + mean_over_max / power(1 - eta, dim); }

struct Share {
    double least, most;
};

class Boxes {
public:
    Boxes(const AnyStore& store, const AnyInputTree& tree, const IntegralRequest& request, double coarsest)
        : dim(store.dim), coarsest_(coarsest), store_(store), tree_(tree), centre_(request.centre),
          radius_(request.radius), balls_(request.balls) {}

    Status open(Arena& arena);
    Status run(double eta, Monitor& monitor, FeatureIntegral* integral);

private:
    double* at(int level) const { return centres_ + static_cast<std::size_t>(level * dim); }
    double feature_size(const double* x);
    Share share(const double* x, double half, double radius) const;
    bool settle(const double* x, double half, double eta, bool finest, FeatureIntegral* integral);
    void enter_root();
    bool fits_root(double reach);
    bool is_finest() const;
    bool enter_child();
    void leave() {
        --level_;
        half_ *= 2;
    }

    const int dim;
    const double coarsest_;  // eta, h / f_P(centre), of a box that is never split
    const AnyStore& store_;
    const AnyInputTree& tree_;
    const double* centre_;
    const double* radius_;
    int balls_;
    double* centres_;       // [levels][dim]
    std::uint8_t* child_;   // [levels]: the next child to go to
    int level_ = 0;         // of the box at hand
    double half_ = 0;       // of its side
    double feature_least_;  // f_P is nowhere smaller
    std::uint32_t first_ = none, second_ = none;
};

Status Boxes::open(Arena& arena) {
    centres_ = arena.take_high<double>(std::size_t{levels_max} * static_cast<std::size_t>(dim));
    child_ = arena.take_high<std::uint8_t>(levels_max);
    if (centres_ == nullptr || child_ == nullptr) return Status::out_of_memory;
    double least2 = infinity;
    for (std::uint32_t i = 0; i < tree_.root().end;)
        for (const std::uint64_t piece = arena.piece(i, tree_.root().end, 500 * dim); i < piece; ++i) {
            double d2;
            tree_.nearest(store_.point(tree_.item(i)), tree_.item(i > 0 ? i - 1 : 1), tree_.item(i), &d2);
            if (d2 < least2) least2 = d2;
        }
    feature_least_ = 0.5 * square_root(least2) * (1 - sum_rounding);
    return Status::ok;
}

double Boxes::feature_size(const double* x) {
    double d2;
    const std::uint32_t hint = first_;
    first_ = tree_.nearest(x, first_, none, &d2);
    if (second_ == first_) second_ = hint;  // the two were different
    second_ = tree_.nearest(x, second_, first_, &d2);
    return square_root(d2);
}

// Bounds on the share of a box inside the ball of this radius. Of two points opposite about the box's centre x at most
// one is inside when x is not, and at least one when |x - c|^2 + h^2 <= radius^2.
Share Boxes::share(const double* x, double half, double radius) const {
    double near2 = 0, far2 = 0, middle2 = 0;
    for (int k = 0; k < dim; ++k) {
        const double d = absolute(x[k] - centre_[k]), near = d > half ? d - half : 0;
        near2 += near * near;
        far2 += (d + half) * (d + half);
        middle2 += d * d;
    }
    const double r2 = radius * radius;
    if (far2 <= r2) return {1, 1};
    if (near2 >= r2) return {0, 0};
    if (middle2 >= r2) return {0, 0.5};
    return {middle2 + dim * half * half <= r2 ? 0.5 : 0, 1};
}

// Adds a box to the bounds unless it has to be split.
bool Boxes::settle(const double* x, double half, double eta, bool finest, FeatureIntegral* integral) {
    Share inside[FeatureIntegral::balls_max];
    bool crosses = false;
    for (int j = 0; j < balls_; ++j) {
        inside[j] = share(x, half, radius_[j]);
        crosses = crosses || inside[j].least != inside[j].most;
    }
    if (!(inside[balls_ - 1].most > 0)) return true;
    ++integral->boxes;
    const double f = feature_size(x), h = half * square_root(static_cast<double>(dim));
    if (h > (crosses && dim < 4 ? 0.5 * eta : eta) * f && !finest) return false;
    const double side = power(2 * half / f, dim), ratio = h / f;
    const double floor = f - h > feature_least_ ? f - h : feature_least_;
    const double greatest = power(f / floor, dim), least = 1 / power(1 + ratio, dim);
    const double mean_upper = ratio <= coarsest_ ? mean_at_most(dim, ratio) : greatest;
    for (int j = 0; j < balls_; ++j) {
        integral->lower[j] += side * inside[j].least * (inside[j].least == 1 ? mean_at_least(dim, ratio) : least);
        integral->upper[j] +=
            side * inside[j].most * (inside[j].most == 1 && inside[j].least == 1 ? mean_upper : greatest);
    }
    return true;
}

// The box around the largest ball that all others are parts of. Box corners are multiples of their sides, so centres
// are exact as long as doubles have them.
void Boxes::enter_root() {
    const double reach = radius_[balls_ - 1];
    half_ = 1;
    while (half_ < 2 * reach) half_ *= 2;
    while (half_ >= 4 * reach) half_ *= 0.5;
    while (!fits_root(reach)) half_ *= 2;
    level_ = 0;
}

// Does the box with sides of twice half_ contain the ball? Far from the origin its corner, which is known up to two
// roundings, may be too near to that of the ball.
bool Boxes::fits_root(double reach) {
    bool fits = true;
    for (int k = 0; k < dim; ++k) {
        const double corner = (centre_[k] - reach) / half_, doubt = absolute(corner) * 0x1p-51;
        const bool aligned = absolute(corner) < 0x1p51;
        double whole = aligned ? static_cast<double>(static_cast<std::int64_t>(corner)) : corner;
        if (whole > corner) whole -= 1;
        at(0)[k] = whole * half_ + half_;
        fits = fits && whole <= corner - doubt && corner + doubt + 2 * reach / half_ <= whole + 2;
    }
    return fits;
}

// Is there no smaller box, for want of levels or of digits?
bool Boxes::is_finest() const {
    bool finest = level_ + 1 == levels_max;
    for (int k = 0; k < dim; ++k) finest = finest || at(level_)[k] + 0.5 * half_ == at(level_)[k];
    return finest;
}

// False when the box has no child left.
bool Boxes::enter_child() {
    if (child_[level_] == 1u << dim) return false;
    const unsigned corner = child_[level_]++;
    half_ *= 0.5;
    for (int k = 0; k < dim; ++k) at(level_ + 1)[k] = at(level_)[k] + (corner >> k & 1u ? half_ : -half_);
    ++level_;
    return true;
}

// Depth first.
Status Boxes::run(double eta, Monitor& monitor, FeatureIntegral* integral) {
    *integral = {};
    enter_root();
    for (bool entered = true; level_ >= 0;) {
        const bool settled = entered && settle(at(level_), half_, eta, is_finest(), integral);
        if (entered && monitor.advance(integral->boxes, 4 * static_cast<std::uint32_t>(dim))) return Status::cancelled;
        if (entered && !settled) child_[level_] = 0;
        entered = !settled && enter_child();
        if (!entered) leave();
    }
    for (int j = 0; j < balls_; ++j) {
        integral->lower[j] *= 1 - sum_rounding;
        integral->upper[j] *= 1 + sum_rounding;
    }
    return Status::ok;
}

}  // namespace

Status feature_integral(const AnyStore& store, const AnyInputTree& tree, const IntegralRequest& request,
                        const Work& work, FeatureIntegral* integral) {
    ArenaScope scope(work.arena);
    const int dim = store.dim;
    const double coarsest = with_dimension(static_cast<std::uint32_t>(dim), [](auto dimension) {
        return figures<decltype(dimension)::value>.coarsest_box;
    });
    Boxes boxes(store, tree, request, coarsest);
    Status status = boxes.open(work.arena);
    if (status == Status::ok) status = boxes.run(coarsest, work.monitor, integral);
    if (status != Status::ok) return status;
    // The number of boxes grows by 2^(dim/2) a step.
    double eta = coarsest, boxes_next = static_cast<double>(integral->boxes);
    const double step = 0.70710678118654752, growth = square_root(static_cast<double>(1u << dim));
    while (mean_at_most(dim, eta) / mean_at_least(dim, eta) > 1 + request.tolerance &&
           boxes_next * growth <= static_cast<double>(request.boxes_max)) {
        eta *= step;
        boxes_next *= growth;
    }
    return eta < coarsest ? boxes.run(eta, work.monitor, integral) : Status::ok;
}

}  // namespace netmesh
