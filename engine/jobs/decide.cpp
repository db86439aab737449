#include "jobs/decide.hpp"

namespace netmesh {
namespace {

// Up to here classes without a bar may reach that live longer than longer_than times their birth. A class of [b, d) is
// matched by the interleaving of bar_bounds.hpp unless d <= phi(psi(b)). Then it has b >= psi^-(a) and d <= phi(a) for
// a = psi(b): with a in a step, b >= min(low, a), d <= max(high, a), and d / b <= c(a)^2.
double hidden_reach(const DecisionView& view) {
    double reach = 0;
    const auto reaches = [&](double birth, double death) {
        if (!(death <= view.longer_than * birth * down) && death > reach) reach = death;
    };
    for (std::uint64_t i = 0; i < view.step_count; ++i) {
        const ScaleStep& s = view.steps[i];
        const double next = i + 1 < view.step_count ? view.steps[i + 1].from : infinity;
        if (s.ratio * s.ratio * up <= view.longer_than) continue;
        if (s.high >= s.from) reaches(s.low < s.from ? s.low : s.from, s.high);  // a <= high
        if (next > s.high && s.low < next) reaches(s.low, next);                 // a above: none unless low < a
    }
    return reach;
}

}  // namespace

double undecided_reach(const DecisionView& view) {
    double reach = 0;
    for (std::uint64_t i = 0; i < view.bars; ++i)
        if (is_undecided(view.bounds[i], view.longer_than) && view.bounds[i].death_high > reach)
            reach = view.bounds[i].death_high;
    return reach;
}

double decided_from(const DecisionView& view) {
    const double seen = undecided_reach(view), hidden = hidden_reach(view);
    return seen > hidden ? seen : hidden;
}

}  // namespace netmesh
