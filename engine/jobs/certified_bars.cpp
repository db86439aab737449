#include "jobs/certified_bars.hpp"

#include "homology/lower_star/lower_star.hpp"
#include "jobs/join_shift.hpp"
#include "jobs/value_table.hpp"
#include "numerics/sort.hpp"

namespace netmesh {
namespace {

constexpr int sequences_max = 8;
// By the spacing: as a factor, or a quarter of its difference.
constexpr double shortest = 1.25;       // from birth to death of a bar worth a sequence
constexpr double stride = 1.25;         // between scales of a sequence where no cell lies across
constexpr double between_ends = 1.125;  // of a window

// Around a scale b: least <= b <= most, and each cell with hi <= most has lo <= least. From b to most it has several
// ends.
struct Window {
    static constexpr int ends = 5;

    double least, most;
};

// The scales b_0 < b_1 < ... of a sequence of covers.
class CoverSequence {
public:
    static constexpr int scales_max = 96;

    explicit CoverSequence(Spacing spacing) : spacing_(spacing) {}
    Status open(const FilterBounds& filter, Arena& arena);
    // A sequence through scale s.
    void go_through(double s, const FilterBounds& filter, const Arena& arena);
    int scales() const { return scales_; }
    // -1: before all births, scales(): after all finite deaths; of a function of any sign where its values begin and
    // end.
    double scale(int i) const {
        if (i < 0) return spacing_.is_difference() ? by_low_.first() : 0;
        return i < scales_ ? scale_[i] : spacing_.is_difference() ? by_high_.last() : infinity;
    }
    // Of each scale the levels are X_i, X at the other ends of its window, Y where that begins, Y_i.
    static constexpr int levels = Window::ends + 2;
    // In nothing before this one.
    int level(const Interval& cell) const {
        const int y = scales_until(cell.lo);
        if (y == scales_) return levels * scales_;
        const int k = end_from(y, cell.hi);
        return levels * y + k + (k == Window::ends && cell.lo > window_[y].least ? 1 : 0);
    }
    double window_begin(int i) const { return window_[i].least; }
    // The first end of window i that is not before x; Window::ends for none.
    int end_from(int i, double x) const {
        if (x > window_[i].most) return Window::ends;
        int k = 0;
        for (double end = scale_[i]; k < Window::ends - 1 && x > end; ++k) end = spacing_.after(end, between_ends);
        return k;
    }

private:
    // How many scales are before x.
    int scales_until(double x) const {
        int y = 0;
        while (y < scales_ && scale_[y] < x) ++y;
        return y;
    }
    void find_windows(const FilterBounds& filter, const Arena& arena);

    ValueTable by_low_, by_high_;  // largest hi up to a lo, least lo from a hi on
    double scale_[scales_max];
    Window* window_ = nullptr;  // [scales_max]
    int scales_ = 0;
    Spacing spacing_;
};

Status CoverSequence::open(const FilterBounds& filter, Arena& arena) {
    const auto lo = [&](std::uint32_t v) { return filter.interval[v].lo; };
    const auto hi = [&](std::uint32_t v) { return filter.interval[v].hi; };
    const bool room =
        by_low_.open_largest(filter.count, lo, hi, arena) && by_high_.open_least(filter.count, hi, lo, arena);
    window_ = arena.take_high<Window>(scales_max);
    return room && window_ != nullptr ? Status::ok : Status::out_of_memory;
}

void CoverSequence::go_through(double s, const FilterBounds& filter, const Arena& arena) {
    constexpr int half = scales_max / 2;
    double below[half];
    int count = 0;
    for (double b = s; count < half && b >= by_high_.first();) {
        below[count++] = b;
        // The largest scale whose Y is in the X of this one.
        const double first = by_high_.least_after(b),
                     least = spacing_.is_difference() ? -next_up(-first) : first * down;
        const double next = spacing_.before(b, stride);
        b = first < infinity && least < next ? least : next;
    }
    scales_ = 0;
    while (count > 0) scale_[scales_++] = below[--count];
    if (scales_ == 0) scale_[scales_++] = s;
    const double top = by_high_.last();
    while (scales_ < scales_max && scale_[scales_ - 1] < top) {
        const double b = spacing_.after(scale_[scales_ - 1], stride);
        const double most = by_low_.largest_up_to(scale_[scales_ - 1], spacing_.least());
        const double next = most > b ? most : b;
        scale_[scales_++] = next < top ? next : top;
    }
    find_windows(filter, arena);
}

// From a stride below the scale as far above it as cells allow; where one is in the way, to the scale, from as far as
// cells allow.
void CoverSequence::find_windows(const FilterBounds& filter, const Arena& arena) {
    double least[scales_max], largest[scales_max];
    for (int i = 0; i < scales_; ++i) least[i] = spacing_.least(), largest[i] = infinity;
    // The largest lo of cells up to this hi; the least hi of those whose lo is past the scale less a stride.
    for (std::uint32_t v = 0; v < filter.count;)
        for (const std::uint64_t piece = arena.piece(v, filter.count, 60); v < piece; ++v) {
            const Interval cell = filter.interval[v];
            const int y = scales_until(cell.hi);
            if (y < scales_ && cell.lo > least[y]) least[y] = cell.lo;
            int last = scales_until(spacing_.after(cell.lo, stride));
            if (last < scales_) ++last;  // both ways are rounded
            while (last > 0 && !(spacing_.before(scale_[last - 1], stride) < cell.lo)) --last;
            if (last > 0 && cell.hi < largest[last - 1]) largest[last - 1] = cell.hi;
        }
    for (int i = 1; i < scales_; ++i)
        if (least[i - 1] > least[i]) least[i] = least[i - 1];
    for (int i = scales_ - 1; i-- > 0;)
        if (largest[i + 1] < largest[i]) largest[i] = largest[i + 1];
    for (int i = 0; i < scales_; ++i) {
        const double most = -next_up(-largest[i]);
        window_[i] = most >= scale_[i] ? Window{spacing_.before(scale_[i], stride), most} : Window{least[i], scale_[i]};
    }
}

double length_of(const Pair& bar, Spacing spacing) {
    return spacing.is_difference() ? bar.death - bar.birth : bar.death / bar.birth;
}
double least_length(Spacing spacing) { return spacing.after(spacing.is_difference() ? 0 : 1, shortest); }
bool is_worth(const Pair& bar, Spacing spacing) {
    return bar.death < infinity && (spacing.is_difference() || bar.birth > 0) &&
           length_of(bar, spacing) > least_length(spacing);
}

// The scales that a sequence for a bar may go through: its middle and its quarters, then its eighths.
struct Tries {
    static constexpr int count = 7, first_count = 3;

    Tries(const Pair& bar, Spacing spacing) {
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
struct Claim {
    double birth_low, birth_high, death_low, death_high;
    int sequence;  // 0: none, 1: by interleaving

    bool disjoint(const Claim& o) const {
        return birth_high < o.birth_low || o.birth_high < birth_low || death_high < o.death_low ||
               o.death_high < death_low;
    }
    bool contains(const Pair& bar) const {
        return birth_low <= bar.birth && bar.birth <= birth_high && death_low <= bar.death && bar.death <= death_high;
    }
};

// False: the bar is alive at no P_i for sure, or not as long as a join asks.
bool claim_of(const CoverSequence& covers, const JoinShift* join, const Pair& bar, int number, Claim* claim) {
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

// The claims about the bars of a diagram.
class Ledger {
public:
    explicit Ledger(const JoinShift* join) : join_(join) {}
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
    void clear(Claim* to) const {
        for (std::uint64_t i = begin_; i < end_;)
            for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
                to[i].sequence = 0;
            }
    }
    std::uint64_t keep_old(Claim* to, int number) const;
    std::uint64_t add_new(Claim* to, const CoverSequence& covers, const PairList& list, int number) const;
    bool keeps_interleaved(const Claim* set) const;
    bool excludes(const Claim* set, const Claim& claim, bool of_this_sequence, int number) const;

    const JoinShift* join_;
    const Arena* arena_ = nullptr;
    BarList bars_ = {};
    const BarBounds* bounds_ = nullptr;              // by interleaving
    std::uint64_t count_ = 0, begin_ = 0, end_ = 0;  // the degree's bars
    Claim *now_ = nullptr, *first_ = nullptr, *second_ = nullptr;
    std::uint8_t* ruled_out_ = nullptr;  // by the bar: a bit for each of its tries
};

Status Ledger::open(const BarList& bars, const BarBounds* bounds, Arena& arena) {
    const std::uint64_t count = bars.count;
    arena_ = &arena;
    bars_ = bars;
    bounds_ = bounds;
    count_ = count;
    now_ = arena.take_high<Claim>(static_cast<std::size_t>(count));
    first_ = arena.take_high<Claim>(static_cast<std::size_t>(count));
    second_ = arena.take_high<Claim>(static_cast<std::size_t>(count));
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
bool Ledger::excludes(const Claim* set, const Claim& claim, bool of_this_sequence, int number) const {
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            if (set[i].sequence != 0 && (set[i].sequence == number) == of_this_sequence && !claim.disjoint(set[i]))
                return false;
        }
    return true;
}

std::uint64_t Ledger::keep_old(Claim* to, int number) const {
    std::uint64_t kept = 0;
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            if (now_[i].sequence == 0 || to[i].sequence != 0 || !excludes(to, now_[i], true, number)) continue;
            to[i] = now_[i];
            ++kept;
        }
    return kept;
}

std::uint64_t Ledger::add_new(Claim* to, const CoverSequence& covers, const PairList& list, int number) const {
    std::uint64_t added = 0;
    for (std::uint64_t i = 0; i < list.count;)
        for (const std::uint64_t piece = arena_->piece(i, list.count, 40); i < piece; ++i) {
            Claim claim;
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
bool Ledger::keeps_interleaved(const Claim* set) const {
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            if (bounds_[i].certain && set[i].sequence == 0) return false;
        }
    return true;
}

void Ledger::consider(const CoverSequence& covers, const PairList& list, std::uint32_t degree, int number) {
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
    const Claim* const better = second > first ? second_ : first_;
    for (std::uint64_t i = begin_; i < end_;)
        for (const std::uint64_t piece = arena_->piece(i, end_, 12); i < piece; ++i) {
            now_[i] = better[i];
        }
}

void Ledger::rule_out(const CoverSequence& covers, const PairList& list, std::uint32_t degree, Spacing spacing) {
    constexpr int levels = CoverSequence::levels, ends = Window::ends;
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
        const Tries tries(bars_[i], spacing);
        for (int t = 0; t < Tries::count; ++t) {
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

void Ledger::conclude(BarBounds* bounds) const {
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

// Where the next sequence goes through: the first try of the longest bar worth it that has no claim, as far as no
// sequence went near there and it is not ruled out. Eighths come when no bar has another try.
class NextScale {
public:
    explicit NextScale(Spacing spacing) : spacing_(spacing) {}

    // False: nowhere.
    bool find(const Ledger& ledger, const BarList& bars, std::uint32_t least_degree, double* scale) {
        const bool found = find_among(ledger, bars, least_degree, 0, Tries::first_count, scale) ||
                           find_among(ledger, bars, least_degree, Tries::first_count, Tries::count, scale);
        if (found) gone_[count_++] = *scale;
        return found;
    }

private:
    // Tries first..last-1 of the bars.
    bool find_among(const Ledger& ledger, const BarList& bars, std::uint32_t least_degree, int first, int last,
                    double* scale) const {
        double best = least_length(spacing_);
        bool found = false;
        for (std::uint64_t i = 0; i < bars.count; ++i) {
            const Pair bar = bars[i];
            if (bar.degree < least_degree || ledger.claims(i) || !is_worth(bar, spacing_)) continue;
            const double length = length_of(bar, spacing_);
            if (!(length > best)) continue;
            const Tries tries(bar, spacing_);
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
    Ledger ledger_;
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
