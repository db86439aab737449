// What sequences of covers say about the bars of a diagram: claims, and scales at which nothing is to be found.
#pragma once
#include "jobs/bar_bounds.hpp"
#include "jobs/cover_sequence.hpp"
#include "jobs/join_shift.hpp"
#include "numerics/square_root.hpp"

namespace netmesh {

// From birth to death of a bar worth a sequence, by the spacing: a factor, or a quarter of its difference.
constexpr double shortest_worth = 1.25;

inline double length_of(const Pair& bar, Spacing spacing) {
    return spacing.is_difference() ? bar.death - bar.birth : bar.death / bar.birth;
}
inline double least_length(Spacing spacing) { return spacing.after(spacing.is_difference() ? 0 : 1, shortest_worth); }
inline bool is_worth(const Pair& bar, Spacing spacing) {
    return bar.death < infinity && (spacing.is_difference() || bar.birth > 0) &&
           length_of(bar, spacing) > least_length(spacing);
}

// The scales that a sequence for a bar may go through: its middle and its quarters, then its eighths.
struct ScaleTries {
    static constexpr int count = 7, first_count = 3;

    ScaleTries(const Pair& bar, Spacing spacing) {
        static constexpr double eighth[count] = {4, 6, 2, 5, 3, 7, 1};
        const double middle = square_root(bar.birth) * square_root(bar.death);
        const auto between = [](double a, double b) { return square_root(a) * square_root(b); };
        const double lower = between(bar.birth, middle), upper = between(middle, bar.death);
        const double by_factor[count] = {middle,
                                         upper,
                                         lower,
                                         between(middle, upper),
                                         between(lower, middle),
                                         between(upper, bar.death),
                                         between(bar.birth, lower)};
        for (int k = 0; k < count; ++k)
            scale[k] = spacing.is_difference() ? bar.birth + 0.125 * eighth[k] * (bar.death - bar.birth) : by_factor[k];
    }

    double scale[count];
};

// What a bar of a sequence says about a true bar.
struct CoverClaim {
    double birth_low, birth_high, death_low, death_high;
    int sequence;  // 0: none, 1: by interleaving

    bool disjoint(const CoverClaim& o) const {
        return birth_high < o.birth_low || o.birth_high < birth_low || death_high < o.death_low ||
               o.death_high < death_low;
    }
    bool contains(const Pair& bar) const {
        return birth_low <= bar.birth && bar.birth <= birth_high && death_low <= bar.death && bar.death <= death_high;
    }
};

// The claims about the bars of a diagram.
class ClaimLedger {
public:
    explicit ClaimLedger(const JoinShift* join) : join_(join) {}
    Status open(const BarList& bars, const BarBounds* bounds, Arena& arena);
    // Takes up what a sequence says about one degree if there are more claims then.
    void consider(const CoverSequence& covers, const PairList& list, std::uint32_t degree, int number);
    bool claims(std::uint64_t bar) const {
        arena_->step(bar, 60);
        return now_[bar].sequence != 0;
    }
    // Then: notes the scales that further sequences need not go through for bars of that degree.
    void rule_out(const CoverSequence& covers, const PairList& list, std::uint32_t degree, Spacing spacing);
    bool rules_out(std::uint64_t bar, int attempt) const { return (ruled_out_[bar] >> attempt & 1) != 0; }
    void conclude(BarBounds* bounds) const;

private:
    void clear(CoverClaim* to) const {
        for (std::uint64_t i = begin_; i < end_;)
            for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
                to[i].sequence = 0;
            }
    }
    std::uint64_t keep_old(CoverClaim* to, int number) const;
    std::uint64_t add_new(CoverClaim* to, const CoverSequence& covers, const PairList& list, int number) const;
    bool keeps_interleaved(const CoverClaim* set) const;
    bool excludes(const CoverClaim* set, const CoverClaim& claim, bool of_this_sequence, int number) const;

    const JoinShift* join_;
    const Arena* arena_ = nullptr;
    BarList bars_ = {};
    const BarBounds* bounds_ = nullptr;              // by interleaving
    std::uint64_t count_ = 0, begin_ = 0, end_ = 0;  // the degree's bars
    CoverClaim *now_ = nullptr, *first_ = nullptr, *second_ = nullptr;
    std::uint8_t* ruled_out_ = nullptr;  // by the bar: a bit for each of its tries
};

}  // namespace netmesh
