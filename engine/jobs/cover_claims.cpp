#include "jobs/cover_claims.hpp"

#include "numerics/sort.hpp"

namespace netmesh {
namespace {

// False: the bar is alive at no P_i for sure, or not as long as a join asks.
bool claim_of(const CoverSequence& covers, const JoinShift* join, const Pair& bar, int number, CoverClaim* claim) {
    if (!(bar.death < infinity)) return false;
    const int born = static_cast<int>(bar.birth), dies = static_cast<int>(bar.death);
    constexpr int levels = CoverSequence::levels;
    const int first = (born + levels - 1) / levels, last = dies / levels - 1;
    if (first > last) return false;
    if (join != nullptr && !(join->after(covers.scale(first)) <= covers.scale(last))) return false;
    const int before = born / levels - 1, after = (dies + levels - 1) / levels;
    *claim = {covers.scale(before), covers.scale(first), covers.scale(last), covers.scale(after), number};
    return true;
}

}  // namespace

Status ClaimLedger::open(const BarList& bars, const BarBounds* bounds, Arena& arena) {
    const std::uint64_t count = bars.count;
    arena_ = &arena;
    bars_ = bars;
    bounds_ = bounds;
    count_ = count;
    now_ = arena.take_high<CoverClaim>(static_cast<std::size_t>(count));
    first_ = arena.take_high<CoverClaim>(static_cast<std::size_t>(count));
    second_ = arena.take_high<CoverClaim>(static_cast<std::size_t>(count));
    ruled_out_ = arena.take_high<std::uint8_t>(static_cast<std::size_t>(count));
    const void* const taken[] = {now_, first_, second_, ruled_out_};
    for (const void* const p : taken)
        if (p == nullptr) return Status::out_of_memory;
    for (std::uint64_t i = 0; i < count;)
        for (const std::uint64_t piece = arena.piece(i, count, 15); i < piece; ++i) {
            now_[i] = {bounds[i].birth_low, bounds[i].birth_high, bounds[i].death_low, bounds[i].death_high,
                       bounds[i].certain ? 1 : 0};
            ruled_out_[i] = 0;
        }
    return Status::ok;
}

// Is the claim about another true bar than all claims of this sequence (of the others) in the set?
bool ClaimLedger::excludes(const CoverClaim* set, const CoverClaim& claim, bool of_this_sequence, int number) const {
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            if (set[i].sequence != 0 && (set[i].sequence == number) == of_this_sequence && !claim.disjoint(set[i]))
                return false;
        }
    return true;
}

std::uint64_t ClaimLedger::keep_old(CoverClaim* to, int number) const {
    std::uint64_t kept = 0;
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            if (now_[i].sequence == 0 || to[i].sequence != 0 || !excludes(to, now_[i], true, number)) continue;
            to[i] = now_[i];
            ++kept;
        }
    return kept;
}

std::uint64_t ClaimLedger::add_new(CoverClaim* to, const CoverSequence& covers, const PairList& list,
                                   int number) const {
    std::uint64_t added = 0;
    for (std::uint64_t i = 0; i < list.count;)
        for (const std::uint64_t piece = arena_->piece(i, list.count, 40); i < piece; ++i) {
            CoverClaim claim;
            if (list.pairs[i].degree != bars_[begin_].degree || !claim_of(covers, join_, list.pairs[i], number, &claim))
                continue;
            if (!excludes(to, claim, false, number)) continue;
            std::uint64_t best = end_;
            for (std::uint64_t j = begin_; j < end_;)
                for (const std::uint64_t piece = arena_->piece(j, end_, 12); j < piece; ++j) {
                    if (to[j].sequence == 0 && claim.contains(bars_[j]) &&
                        (best == end_ || bars_[j].death - bars_[j].birth > bars_[best].death - bars_[best].birth))
                        best = j;
                }
            if (best == end_) continue;
            to[best] = claim;
            ++added;
        }
    return added;
}

// Bars that are certain by interleaving stay certain, as reports say so of what dies after certain_after.
bool ClaimLedger::keeps_interleaved(const CoverClaim* set) const {
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            if (bounds_[i].certain && set[i].sequence == 0) return false;
        }
    return true;
}

void ClaimLedger::consider(const CoverSequence& covers, const PairList& list, std::uint32_t degree, int number) {
    begin_ = 0;
    while (begin_ < count_ && bars_[begin_].degree < degree) ++begin_;
    end_ = begin_;
    while (end_ < count_ && bars_[end_].degree == degree) ++end_;
    if (begin_ == end_) return;
    std::uint64_t now = 0;
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            now += now_[i].sequence != 0;
        }
    // What is there and what goes with it, or the other way round.
    clear(first_);
    std::uint64_t first = keep_old(first_, number);
    first += add_new(first_, covers, list, number);
    clear(second_);
    std::uint64_t second = add_new(second_, covers, list, number);
    second += keep_old(second_, number);
    if (!keeps_interleaved(second_)) second = 0;
    if (first <= now && second <= now) return;
    const CoverClaim* const better = second > first ? second_ : first_;
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            now_[i] = better[i];
        }
}

void ClaimLedger::rule_out(const CoverSequence& covers, const PairList& list, std::uint32_t degree, Spacing spacing) {
    constexpr int levels = CoverSequence::levels, ends = CoverWindow::ends;
    if (begin_ == end_) return;
    // How many bars are alive from the end of a window to where it begins.
    std::uint64_t alive[CoverSequence::scales_max][ends];
    for (int i = 0; i < covers.scales(); ++i)
        for (std::uint64_t& count : alive[i]) count = 0;
    for (std::uint64_t i = 0; i < list.count;)
        for (const std::uint64_t piece = arena_->piece(i, list.count, 40); i < piece; ++i) {
            const Pair& bar = list.pairs[i];
            if (bar.degree != degree) continue;
            const int born = static_cast<int>(bar.birth),
                      dies = bar.death < infinity ? static_cast<int>(bar.death) : levels * covers.scales();
            for (int at = born / levels; at < covers.scales() && levels * at + ends < dies; ++at)
                for (int k = 0; k < ends; ++k) alive[at][k] += born <= levels * at + k ? 1 : 0;
        }
    // Of claims; the lists that consider compares are no longer needed.
    double *const births = reinterpret_cast<double*>(first_), *const deaths = reinterpret_cast<double*>(second_);
    std::uint64_t claims = 0;
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            if (now_[i].sequence == 0) continue;
            births[claims] = now_[i].birth_high;
            deaths[claims++] = now_[i].death_low;
        }
    sort_alike(births, claims, Ascending{}, *arena_);
    sort_alike(deaths, claims, Ascending{}, *arena_);
    const auto count_before = [claims](const double* list, double s, bool or_at) {
        std::uint64_t first = 0, last = claims;
        while (first < last) {
            const std::uint64_t middle = first + (last - first) / 2;
            if (list[middle] < s || (or_at && list[middle] == s)) {
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        return first;
    };
    for (std::uint64_t i = begin_; i < end_; ++i) {
        arena_->step(i, 400);
        if (!is_worth(bars_[i], spacing)) continue;
        const ScaleTries tries(bars_[i], spacing);
        for (int t = 0; t < ScaleTries::count; ++t) {
            const double s = tries.scale[t];
            const std::uint64_t known = count_before(births, s, true) - count_before(deaths, s, false);
            for (int at = 0; at < covers.scales(); ++at) {
                const int k = covers.end_from(at, s);
                if (k < ends && covers.window_begin(at) <= s && alive[at][k] <= known)
                    ruled_out_[i] = static_cast<std::uint8_t>(ruled_out_[i] | 1u << t);
            }
        }
    }
}

void ClaimLedger::conclude(BarBounds* bounds) const {
    for (std::uint64_t i = 0; i < count_; ++i) {
        BarBounds& b = bounds[i];
        b.certain = claims(i);
        if (now_[i].sequence < 2) continue;
        b.birth_low = now_[i].birth_low;
        b.birth_high = now_[i].birth_high;
        b.death_low = now_[i].death_low;
        b.death_high = now_[i].death_high;
    }
}

}  // namespace netmesh
