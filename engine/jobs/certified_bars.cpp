#include "jobs/certified_bars.hpp"

#include "homology/lower_star/lower_star.hpp"
#include "jobs/cover_claims.hpp"

namespace netmesh {
namespace {

constexpr int sequences_max = 8;

// Where the next sequence goes through: the first try of the longest bar worth it that has no claim, as far as no
// sequence went near there and it is not ruled out. Eighths come when no bar has another try.
class NextScale {
public:
    explicit NextScale(Spacing spacing) : spacing_(spacing) {}

    // False: nowhere.
    bool find(const ClaimLedger& ledger, const BarList& bars, std::uint32_t least_degree, double* scale) {
        const bool found = find_among(ledger, bars, least_degree, 0, ScaleTries::first_count, scale) ||
                           find_among(ledger, bars, least_degree, ScaleTries::first_count, ScaleTries::count, scale);
        if (found) gone_[count_++] = *scale;
        return found;
    }

private:
    // ScaleTries first..last-1 of the bars.
    bool find_among(const ClaimLedger& ledger, const BarList& bars, std::uint32_t least_degree, int first, int last,
                    double* scale) const {
        double best = least_length(spacing_);
        bool found = false;
        for (std::uint64_t i = 0; i < bars.count; ++i) {
            const Pair bar = bars[i];
            if (bar.degree < least_degree || ledger.claims(i) || !is_worth(bar, spacing_)) continue;
            const double length = length_of(bar, spacing_);
            if (!(length > best)) continue;
            const ScaleTries tries(bar, spacing_);
            for (int k = first; k < last; ++k) {
                if (ledger.rules_out(i, k) || was_near(tries.scale[k])) continue;
                *scale = tries.scale[k];
                best = length;
                found = true;
                break;
            }
        }
        return found;
    }
    bool was_near(double s) const {
        for (int i = 0; i < count_; ++i)
            if (s < spacing_.after(gone_[i], 1.05) && gone_[i] < spacing_.after(s, 1.05)) return true;
        return false;
    }

    Spacing spacing_;
    double gone_[sequences_max];
    int count_ = 0;
};

// The filter's values as shares of a half, in their order.
class HalfShare {
public:
    HalfShare(const FilterBounds& filter, Spacing spacing, const Arena& arena) {
        for (std::uint32_t v = 0; v < filter.count;)
            for (const std::uint64_t piece = arena.piece(v, filter.count, 8); v < piece; ++v) {
                const double t = filter.value[v];
                if (t > largest_) largest_ = t;
                if (t < least_) least_ = t;
            }
        if (!spacing.is_difference()) least_ = 0;
    }
    double of(double t) const {
        const double whole = largest_ - least_;
        return whole > 0 ? 0.5 * ((t - least_) / whole) : 0;
    }

private:
    double largest_ = -infinity, least_ = infinity;
};

// All but the diagrams of the sequences.
class CertifiedSearch {
public:
    CertifiedSearch(const FilterBounds& filter, Spacing spacing, const BarList& bars, bool has_zero_born,
                    const JoinShift* join, const Arena& arena)
        : filter_(filter), bars_(bars), arena_(arena), least_degree_(has_zero_born ? 1 : 0), spacing_(spacing),
          covers_(spacing), ledger_(join), next_(spacing), share_(filter, spacing, arena) {}

    Status open(const BarBounds* bounds, Arena& arena);
    // Another sequence: the level at which each vertex enters. False: there is none.
    bool next();
    const double* level() const { return level_; }
    std::uint32_t top_degree() const { return bars_[bars_.count - 1].degree; }
    // Its diagram.
    void consider(const PairList& pairs) {
        for (std::uint32_t degree = least_degree_; degree <= top_degree(); ++degree) {
            ledger_.consider(covers_, pairs, degree, number_ + 1);
            ledger_.rule_out(covers_, pairs, degree, spacing_);
        }
    }
    void conclude(BarBounds* bounds) const { ledger_.conclude(bounds); }

private:
    const FilterBounds& filter_;
    const BarList& bars_;
    const Arena& arena_;
    const std::uint32_t least_degree_;
    const Spacing spacing_;
    CoverSequence covers_;
    ClaimLedger ledger_;
    NextScale next_;
    const HalfShare share_;
    double* level_ = nullptr;
    int number_ = 0;
};

Status CertifiedSearch::open(const BarBounds* bounds, Arena& arena) {
    Status status = covers_.open(filter_, arena);
    if (status == Status::ok) status = ledger_.open(bars_, bounds, arena);
    level_ = arena.take_low<double>(filter_.count);
    return status == Status::ok && level_ == nullptr ? Status::out_of_memory : status;
}

bool CertifiedSearch::next() {
    double scale;
    if (number_ == sequences_max || !next_.find(ledger_, bars_, least_degree_, &scale)) return false;
    ++number_;
    covers_.go_through(scale, filter_, arena_);
    // The filter's values order the simplices of a level, which keeps the reduction short.
    for (std::uint32_t v = 0; v < filter_.count;)
        for (const std::uint64_t piece = arena_.piece(v, filter_.count, 30); v < piece; ++v) {
            level_[v] = covers_.level(filter_.interval[v]) + share_.of(filter_.value[v]);
        }
    return true;
}

}  // namespace

Status find_certified_bars(const CertifiedBarsRequest& request, const Work& work, BarBounds* bounds) {
    if (request.bars.count == 0) return Status::ok;
    const ArenaScope scope(work.arena);
    CertifiedSearch search(request.filter, request.spacing, request.bars, request.zero_born > 0, request.join,
                           work.arena);
    Status status = search.open(bounds, work.arena);
    while (status == Status::ok && search.next()) {
        const ArenaScope run(work.arena);
        CountedPairs found = {};
        status = persist_lower_star({request.complex, search.level(), request.zero_born, request.part},
                                    {search.top_degree()}, work, &found);
        if (status == Status::ok) search.consider(found.pairs);
    }
    if (status == Status::ok) search.conclude(bounds);
    return status;
}

}  // namespace netmesh
