#include "diagram_judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>

#include "matching.hpp"

namespace referee {
namespace {

// Room for what is computed in doubles here: who may be left over.
constexpr double room = 1e-12;

Rational exact_square(double x) { return square(exact(x)); }

// Of squares of radii.
struct Range {
    Rational low, high;
    bool endless = false;  // `high` is infinity

    bool holds(const Rational& x) const { return low <= x && (endless || x <= high); }
};

Range between(double low, double high) {
    Range range;
    range.low = std::isinf(low) ? Rational(0) : exact_square(std::max(low, 0.0));
    range.endless = std::isinf(high);
    if (!range.endless) range.high = exact_square(high);
    return range;
}

Range within_factor(double x, double factor) {
    Range range;
    const Rational c2 = exact_square(factor), x2 = exact_square(x);
    range.low = x2 / c2;
    range.high = x2 * c2;
    return range;
}

Range both(const Range& a, const Range& b) {
    Range range;
    range.low = std::max(a.low, b.low);
    range.endless = a.endless && b.endless;
    if (!range.endless) range.high = a.endless ? b.high : b.endless ? a.high : std::min(a.high, b.high);
    return range;
}

// A bar of the file: where its true one may be, and whether there must be one.
struct Claim {
    Range birth, death;
    bool essential = false, must = false;
    const Bar* bar = nullptr;
};
struct TrueClaim {
    Rational birth, death;
    bool essential = false, must = false;
};

std::string text_of(const Bar& bar) {
    return "bar " + count_text(bar.degree) + " " + exact_text(bar.birth) + " " + exact_text(bar.death);
}
std::string text_of(const TrueClaim& bar, int degree) {
    return "true bar " + count_text(degree) + " " + exact_text(std::sqrt(bar.birth.get_d())) + " " +
           (bar.essential ? std::string("inf") : exact_text(std::sqrt(bar.death.get_d())));
}

std::vector<TrueClaim> true_bars(const Truth& truth, int degree) {
    std::vector<TrueClaim> bars;
    for (const TrueBar& bar : truth.bars)
        if (bar.degree == degree)
            bars.push_back({truth.squares[bar.birth], bar.death == never ? Rational(0) : truth.squares[bar.death],
                            bar.death == never, true});
    return bars;
}

std::vector<const Bar*> bars_of(const DiagramFile& diagram, int degree) {
    std::vector<const Bar*> bars;
    for (const Bar& bar : diagram.bars)
        if (bar.degree == degree && bar.birth < bar.death) bars.push_back(&bar);
    return bars;
}

void match(const std::vector<Claim>& claims, const std::vector<TrueClaim>& bars, int degree, const std::string& promise,
           Verdict* verdict) {
    Choices choices(claims.size());
    std::vector<char> left, right;
    for (std::size_t a = 0; a < claims.size(); a++) {
        left.push_back(claims[a].must ? 1 : 0);
        for (std::uint32_t b = 0; b < bars.size(); b++)
            if (claims[a].essential == bars[b].essential && claims[a].birth.holds(bars[b].birth) &&
                (bars[b].essential || claims[a].death.holds(bars[b].death)))
                choices[a].push_back(b);
    }
    for (const TrueClaim& bar : bars) right.push_back(bar.must ? 1 : 0);
    std::size_t missing;
    bool is_left;
    if (can_match_both(choices, left, right, &missing, &is_left)) return;
    verdict->add(promise, is_left ? text_of(*claims[missing].bar) + " has no true one left"
                                  : text_of(bars[missing], degree) + " has no bar left");
}

// The steps as a function of scale.
class Curve {
public:
    explicit Curve(const DiagramFile& diagram) : steps_(diagram.steps) {}

    const Step* at(double a) const {
        const Step* found = nullptr;
        for (const Step& step : steps_)
            if (step.from <= a) found = &step;
        return found;
    }
    Range range(double a) const {
        const Step* step = at(a);
        if (step == nullptr) return between(a, a);
        const Range bounds = between(std::min(step->low, a), std::max(step->high, a));
        return std::isinf(step->ratio) ? bounds : both(bounds, within_factor(a, step->ratio));
    }
    // Is there an a with birth >= a / c(a) and death <= a c(a)? Both sides grow with a within a step, so the largest a
    // of each step whose first side is not above `birth` decides.
    bool may_leave_over(double birth, double death) const {
        for (std::size_t i = 0; i < steps_.size(); i++) {
            const Step& step = steps_[i];
            const double end = i + 1 < steps_.size() ? steps_[i + 1].from : INFINITY;
            const double by_bounds =
                step.low <= birth ? INFINITY : std::max(birth, std::sqrt(step.high) * std::sqrt(birth));
            const double by_ratio = std::isinf(step.ratio) ? INFINITY : step.ratio * birth;
            const double a = std::max(step.from, std::min({end, by_bounds, by_ratio}) * (1 + room));
            if (std::isinf(a) || (earliest(step, a) <= birth * (1 + 4 * room) && death <= latest(step, a) * (1 + room)))
                return true;
        }
        return false;
    }
    bool must_be_real(const Bar& bar) const {
        const Step* step = at(bar.birth);
        return bar.death > bar.birth && (step == nullptr || bar.death > std::max(step->reach, bar.birth));
    }
    bool may_be_left_over(const Bar& bar) const {
        if (std::isinf(bar.death)) return false;
        const Step *birth = at(bar.birth), *death = at(bar.death);
        return (death == nullptr ? bar.death : earliest(*death, bar.death)) <=
               (birth == nullptr ? bar.birth : latest(*birth, bar.birth)) * (1 + room);
    }

private:
    // a / c(a) and a c(a).
    static double earliest(const Step& step, double a) {
        const double by_bounds = std::min({step.low, a, std::isinf(step.high) ? 0 : a / step.high * a});
        return std::max(by_bounds, a / step.ratio);
    }
    static double latest(const Step& step, double a) {
        const double by_bounds = std::max({step.high, a, a == 0 ? 0 : a / step.low * a});
        return std::isinf(step.ratio) ? by_bounds : std::min(by_bounds, a * step.ratio);
    }

    const std::vector<Step>& steps_;
};

}  // namespace

void judge_ratio(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict) {
    const double ratio = diagram.ratio(), from = diagram.number("certified-from", 0);
    if (!(ratio >= 1)) return verdict->add("ratio", "the certified ratio is " + exact_text(ratio));
    if (std::isinf(ratio)) return;
    const Rational c2 = exact_square(ratio), c4 = c2 * c2, from2 = exact_square(from);
    for (int degree = 0; degree <= top; degree++) {
        std::vector<Claim> claims;
        for (const Bar* bar : bars_of(diagram, degree)) {
            if (bar->death <= from) continue;
            Claim claim;
            claim.bar = bar;
            claim.essential = std::isinf(bar->death);
            const double birth = std::max(bar->birth, from);
            claim.birth = within_factor(birth, ratio);
            if (!claim.essential) claim.death = within_factor(bar->death, ratio);
            claim.must = claim.essential || exact_square(bar->death) > c4 * exact_square(birth);
            claims.push_back(claim);
        }
        std::vector<TrueClaim> bars;
        for (TrueClaim bar : true_bars(truth, degree)) {
            if (!bar.essential && bar.death <= from2) continue;
            bar.birth = std::max(bar.birth, from2);
            bar.must = bar.essential || bar.death > c4 * bar.birth;
            bars.push_back(bar);
        }
        match(claims, bars, degree, "ratio", verdict);
    }
}

void judge_scales(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict) {
    const Curve curve(diagram);
    for (int degree = 0; degree <= top; degree++) {
        std::vector<Claim> claims;
        for (const Bar* bar : bars_of(diagram, degree)) {
            Claim claim;
            claim.bar = bar;
            claim.essential = std::isinf(bar->death);
            claim.birth = curve.range(bar->birth);
            if (!claim.essential) claim.death = curve.range(bar->death);
            claim.must = !curve.may_be_left_over(*bar) || curve.must_be_real(*bar);
            claims.push_back(claim);
            if (bar->bounded && curve.must_be_real(*bar) && !bar->real)
                verdict->add("scale", text_of(*bar) + " dies after `reach` and is not said to exist");
        }
        std::vector<TrueClaim> bars = true_bars(truth, degree);
        for (TrueClaim& bar : bars) {
            const double birth = std::sqrt(bar.birth.get_d()), death = std::sqrt(bar.death.get_d());
            bar.must = bar.essential || !curve.may_leave_over(birth, death);
        }
        match(claims, bars, degree, "scale", verdict);
    }
}

void judge_bounds(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict) {
    const Curve curve(diagram);
    for (int degree = 0; degree <= top; degree++) {
        std::vector<Claim> real, all;
        for (const Bar* bar : bars_of(diagram, degree)) {
            if (!bar->bounded) return verdict->add("bounds", text_of(*bar) + " has no bounds");
            Claim claim;
            claim.bar = bar;
            claim.essential = std::isinf(bar->death);
            claim.birth = between(bar->birth_low, bar->birth_high);
            if (!claim.essential) claim.death = between(bar->death_low, bar->death_high);
            claim.must = bar->real;
            real.push_back(claim);
            claim.must = curve.must_be_real(*bar) || !curve.may_be_left_over(*bar);
            all.push_back(claim);
        }
        std::vector<TrueClaim> bars = true_bars(truth, degree);
        for (TrueClaim& bar : bars) bar.must = false;
        match(real, bars, degree, "bounds", verdict);
        if (!diagram.steps.empty()) match(all, bars, degree, "bounds", verdict);
    }
}

// The nearest double to the root, ties to even, of numbers that are far from the ends of the range.
double rounded_root(const Rational& square_of) {
    double x = std::sqrt(square_of.get_d());
    const auto beyond = [&](double a, double b) {  // the root less the middle of two neighbours
        const Rational middle = (exact(a) + exact(b)) / 2;
        const Rational excess = square_of - middle * middle;
        return sgn(excess);
    };
    const auto is_even = [](double a) {
        std::uint64_t bits;
        std::memcpy(&bits, &a, sizeof bits);
        return bits % 2 == 0;
    };
    for (;;) {
        const double above = std::nextafter(x, INFINITY), below = std::nextafter(x, 0.0);
        const int up = beyond(x, above), down = x > 0 ? beyond(below, x) : 1;
        if (up > 0 || (up == 0 && !is_even(x)))
            x = above;
        else if (down < 0 || (down == 0 && !is_even(x)))
            x = below;
        else
            return x;
    }
}

void judge_exact(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict) {
    using Entry = std::array<double, 3>;
    std::vector<Entry> found, due;
    for (const Bar& bar : diagram.bars)
        if (bar.birth != bar.death && bar.degree <= top)
            found.push_back({static_cast<double>(bar.degree), bar.birth, bar.death});
    for (const TrueBar& bar : truth.bars) {
        if (bar.degree > top) continue;
        const double birth = rounded_root(truth.squares[bar.birth]),
                     death = bar.death == never ? INFINITY : rounded_root(truth.squares[bar.death]);
        if (birth != death) due.push_back({static_cast<double>(bar.degree), birth, death});
    }
    std::sort(found.begin(), found.end());
    std::sort(due.begin(), due.end());
    if (found.size() != due.size())
        return verdict->add("exact", count_text(found.size()) + " bars, " + count_text(due.size()) + " are due");
    for (std::size_t i = 0; i < found.size(); i++)
        if (found[i] != due[i])
            return verdict->add("exact", "a bar from " + exact_text(found[i][1]) + " to " + exact_text(found[i][2]) +
                                             " where one from " + exact_text(due[i][1]) + " to " +
                                             exact_text(due[i][2]) + " is due");
}

void judge_near(const DiagramFile& diagram, const Truth& truth, int top, Verdict* verdict) {
    if (diagram.ratio() == 1) return judge_exact(diagram, truth, top, verdict);
    DiagramFile wide = diagram;
    wide.set("certified-ratio", exact_text(diagram.ratio() * (1 + 0x1p-51)));
    Verdict near;
    judge_ratio(wide, truth, top, &near);
    for (const Fault& fault : near.faults) verdict->add("near", fault.text);
}

double true_ratio(DiagramFile diagram, const Truth& truth, int top, double most) {
    const auto is_enough = [&](double ratio) {
        diagram.set("certified-ratio", exact_text(ratio));
        Verdict verdict;
        judge_ratio(diagram, truth, top, &verdict);
        return verdict.good();
    };
    if (!is_enough(most)) return most;
    double low = 1, high = most;
    while (high - low > 0x1p-12 * low) {
        const double middle = low + (high - low) / 2;
        (is_enough(middle) ? high : low) = middle;
    }
    return high;
}

void judge_form(const DiagramFile& diagram, const std::string& json, int top, Verdict* verdict) {
    const auto wrong = [&](const std::string& text) { verdict->add("form", text); };
    const auto comes_after = [](const Bar& a, const Bar& b) {
        return a.degree != b.degree ? a.degree > b.degree : a.birth != b.birth ? a.birth > b.birth : a.death > b.death;
    };
    std::vector<double> pairs(static_cast<std::size_t>(top) + 1, 0), essential = pairs, real = pairs, bounds, steps,
                                                                     bars;
    for (std::size_t i = 0; i < diagram.bars.size(); i++) {
        const Bar& bar = diagram.bars[i];
        if (bar.degree < 0 || bar.degree > top) return wrong(text_of(bar) + " is of another degree");
        if (!(bar.birth >= 0) || std::isinf(bar.birth) || !(bar.death >= bar.birth) ||
            (bar.death == bar.birth && !diagram.has("all")))
            wrong(text_of(bar) + " is none");
        if (i > 0 && comes_after(diagram.bars[i - 1], bar)) wrong(text_of(bar) + " is out of its order");
        bars.insert(bars.end(), {static_cast<double>(bar.degree), bar.birth, bar.death});
        if (bar.bounded != diagram.has("bounds")) wrong("bounds, and none asked for, or the reverse");
        if (bar.bounded) {
            for (const double x : {bar.birth_low, bar.birth_high, bar.death_low, bar.death_high}) bounds.push_back(x);
            bounds.push_back(bar.real ? 1 : 0);
            if (!(bar.birth_low <= bar.birth && bar.birth <= bar.birth_high && bar.death_low <= bar.death &&
                  bar.death <= bar.death_high))
                wrong(text_of(bar) + " is outside of its bounds");
        }
        pairs[static_cast<std::size_t>(bar.degree)]++;
        essential[static_cast<std::size_t>(bar.degree)] += std::isinf(bar.death) ? 1 : 0;
        real[static_cast<std::size_t>(bar.degree)] += bar.real ? 1 : 0;
    }
    for (std::size_t i = 0; i < diagram.steps.size(); i++) {
        const Step& step = diagram.steps[i];
        for (const double x : {step.from, step.low, step.high, step.reach, step.ratio}) steps.push_back(x);
        if (i > 0 && (step.from <= diagram.steps[i - 1].from || step.low < diagram.steps[i - 1].low ||
                      step.high < diagram.steps[i - 1].high || step.reach < diagram.steps[i - 1].reach))
            wrong("the scale from " + exact_text(step.from) + " does not ascend");
        if (step.from >= diagram.number("certified-from", 0) && step.ratio > diagram.ratio())
            wrong("the scale from " + exact_text(step.from) + " has a ratio above the certified one");
    }
    if (json.empty()) return;
    const auto same = [&](const char* name, std::vector<double> due) {
        std::vector<double> said = json_numbers(json_text(json, "diagram", name));
        said.resize(std::max(said.size(), due.size()), 0);
        due.resize(said.size(), 0);
        if (said != due) wrong(std::string("the report has another `") + name + "` than the file");
    };
    same("pairs", pairs);
    same("essential", essential);
    same("certified_ratio", {diagram.ratio()});
    same("certified_from", {diagram.number("certified-from", 0)});
    if (json_text(json, "diagram", "reference") != "\"" + diagram.text("reference") + "\"")
        wrong("the report has another `reference` than the file");
    if (diagram.has("bounds")) same("certain", real);
    if (json_text(json, "diagram", "bars").empty()) return;  // they went to the file alone
    same("bars", bars);
    if (!diagram.has("bounds")) return;
    same("scale_steps", steps);
    same("bounds", bounds);
}

}  // namespace referee
