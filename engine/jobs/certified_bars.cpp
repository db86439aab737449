#include "jobs/certified_bars.hpp"

#include "homology/lower_star/lower_star.hpp"
#include "homology/rank.hpp"
#include "jobs/diagram_of_packed.hpp"
#include "jobs/join_shift.hpp"

namespace netmesh {
namespace {

constexpr int sequences_max = 8;
// By the spacing: as a factor, or a quarter of its difference.
constexpr double shortest = 1.25;  // from birth to death of a bar worth a sequence
constexpr double stride = 1.25;    // between scales of a sequence where no cell lies across
constexpr double narrower = 1.75;  // what a window may gain when its cells are narrowed

// The scales b_0 < b_1 < ... of a sequence of covers.
class CoverSequence {
public:
    static constexpr int scales_max = 96;

    CoverSequence(const FilterBounds& filter, Spacing spacing, CellIntervals* cells, const Arena& arena);
    // A sequence through scale s.
    void go_through(double s);
    int scales() const { return scales_; }
    // -1: before all births, scales(): after all finite deaths; of a function of any sign where its values begin and
    // end.
    double scale(int i) const {
        if (i < 0) return spacing_.is_difference() ? least_low_ : 0;
        return i < scales_ ? scale_[i] : spacing_.is_difference() ? most_high_ : infinity;
    }
    // 2 i: in X_i, 2 i + 1: in Y_i, and in nothing before.
    int level(const Interval& cell) const {
        int y = 0;
        while (y < scales_ && scale_[y] < cell.lo) ++y;
        return y < scales_ && cell.hi <= scale_[y] ? 2 * y : y < scales_ ? 2 * y + 1 : 2 * scales_;
    }

private:
    // Over cells with lo up to b the largest hi, over cells with hi above b the least lo, of narrow intervals.
    double most_up_to(double b) const;
    double least_above(double b) const;

    const FilterBounds& filter_;
    CellIntervals* const cells_;
    const Arena& arena_;
    Spacing spacing_;
    double least_low_ = infinity, least_high_ = infinity, most_high_ = -infinity;
    double scale_[scales_max];
    int scales_ = 0;
};

CoverSequence::CoverSequence(const FilterBounds& filter, Spacing spacing, CellIntervals* cells, const Arena& arena)
    : filter_(filter), cells_(cells), arena_(arena), spacing_(spacing) {
    for (std::uint32_t v = 0; v < filter.count;)
        for (const std::uint64_t piece = arena.piece(v, filter.count, 8); v < piece; ++v) {
            const Interval& cell = filter.interval[v];
            if (cell.lo < least_low_) least_low_ = cell.lo;
            if (cell.hi < least_high_) least_high_ = cell.hi;
            if (cell.hi > most_high_) most_high_ = cell.hi;
        }
}

double CoverSequence::most_up_to(double b) const {
    double most = spacing_.least();
    for (std::uint32_t v = 0; v < filter_.count;)
        for (const std::uint64_t piece = arena_.piece(v, filter_.count, 8); v < piece; ++v) {
            const Interval& cell = filter_.interval[v];
            if (!(cell.lo <= b && cell.hi > most)) continue;
            if (cells_ != nullptr) {
                if (!cells_->reaches_down_to(v, b)) cells_->narrow_low(v, next_up(b));
                if (cell.lo <= b) cells_->narrow_high(v, most);
            }
            if (cell.lo <= b && cell.hi > most) most = cell.hi;
        }
    return most;
}

double CoverSequence::least_above(double b) const {
    double least = infinity;
    for (std::uint32_t v = 0; v < filter_.count;)
        for (const std::uint64_t piece = arena_.piece(v, filter_.count, 8); v < piece; ++v) {
            const Interval& cell = filter_.interval[v];
            if (!(cell.hi > b && cell.lo < least)) continue;
            if (cells_ != nullptr) {
                if (cells_->reaches_down_to(v, b)) cells_->narrow_high(v, b);
                if (cell.hi > b) cells_->narrow_low(v, least);
            }
            if (cell.hi > b && cell.lo < least) least = cell.lo;
        }
    return least;
}

void CoverSequence::go_through(double s) {
    constexpr int half = scales_max / 2;
    double below[half];
    int count = 0;
    for (double b = s; count < half && b >= least_high_;) {
        below[count++] = b;
        // The largest scale whose Y is in the X of this one.
        const double first = least_above(b), least = spacing_.is_difference() ? -next_up(-first) : first * down;
        const double next = spacing_.before(b, stride);
        b = first < infinity && least < next ? least : next;
    }
    scales_ = 0;
    while (count > 0) scale_[scales_++] = below[--count];
    if (scales_ == 0) scale_[scales_++] = s;
    const double top = most_high_;
    while (scales_ < scales_max && scale_[scales_ - 1] < top) {
        const double b = spacing_.after(scale_[scales_ - 1], stride);
        const double most = most_up_to(scale_[scales_ - 1]);
        const double next = most > b ? most : b;
        scale_[scales_++] = next < top ? next : top;
    }
}

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
    const int first = (born + 1) / 2, last = dies / 2 - 1;
    if (first > last) return false;
    if (join != nullptr && !(join->after(covers.scale(first)) <= covers.scale(last))) return false;
    const int before = born / 2 - 1, after = (dies + 1) / 2;
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
    if (now_ == nullptr || first_ == nullptr || second_ == nullptr) return Status::out_of_memory;
    for (std::uint64_t i = 0; i < count;)
        for (const std::uint64_t piece = arena.piece(i, count, 15); i < piece; ++i) {
            now_[i] = {bounds[i].birth_low, bounds[i].birth_high, bounds[i].death_low, bounds[i].death_high,
                       bounds[i].certain ? 1 : 0};
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

// Where a sequence may find the class of a bar: from `first`, where the cell of its birth is within the offset, to
// `last`, where that of its death is not yet around it.
struct Window {
    double first, last;
};

// Bars that a sequence may certify. A class that is in X_s and lasts in Y_s is in the filter's diagram too, mostly from
// the vertex on whose star begins the bar to that whose star ends it; where X_s lacks the one and Y_s has the other,
// there seldom is a class. Nothing certified depends on that, and where no cells can be narrowed it is not asked.
class Windows {
public:
    Status open(const FilterBounds& filter, const BarList& bars, std::uint32_t least_degree, Spacing spacing,
                CellIntervals* cells, Arena& arena);
    bool has(std::uint64_t bar) const { return window_[bar].first < infinity; }
    const Window& operator[](std::uint64_t bar) const { return window_[bar]; }

private:
    // The vertices with a value, by their places in the order.
    struct Places {
        std::uint32_t first, last;
    };
    Places places_of(double value) const;
    Window window_of(const Places& birth, const Places& death) const;

    const FilterBounds* filter_ = nullptr;
    const std::uint32_t* order_ = nullptr;
    Window* window_ = nullptr;  // [bars] none: first is infinite
};

Windows::Places Windows::places_of(double value) const {
    const auto first_where = [&](auto&& is) {
        std::uint32_t first = 0, last = filter_->count;
        while (first < last) {
            const std::uint32_t middle = first + (last - first) / 2;
            if (is(filter_->value[order_[middle]]))
                last = middle;
            else
                first = middle + 1;
        }
        return first;
    };
    const std::uint32_t first = first_where([=](double t) { return t >= value; });
    return {first, first_where([=](double t) { return t > value; })};
}

Window Windows::window_of(const Places& birth, const Places& death) const {
    Window window = {infinity, -infinity};
    for (std::uint32_t i = birth.first; i < birth.last; ++i) {
        const double hi = filter_->interval[order_[i]].hi;
        if (hi < window.first) window.first = hi;
    }
    for (std::uint32_t i = death.first; i < death.last; ++i) {
        const double lo = filter_->interval[order_[i]].lo;
        if (lo > window.last) window.last = lo;
    }
    return window;
}

Status Windows::open(const FilterBounds& filter, const BarList& bars, std::uint32_t least_degree, Spacing spacing,
                     CellIntervals* cells, Arena& arena) {
    filter_ = &filter;
    window_ = arena.take_high<Window>(static_cast<std::size_t>(bars.count));
    const HighScope scope(arena);
    std::uint32_t* const order = arena.take_high<std::uint32_t>(filter.count);
    std::uint32_t* const rank = arena.take_high<std::uint32_t>(filter.count);
    if (window_ == nullptr || order == nullptr || rank == nullptr ||
        !rank_vertices(filter.value, filter.count, arena, order, rank))
        return Status::out_of_memory;
    order_ = order;
    for (std::uint64_t i = 0; i < bars.count; ++i) {
        arena.step(i, 60);
        const Pair bar = bars[i];
        window_[i] = {infinity, -infinity};
        if (bar.degree < least_degree || !(bar.death < infinity)) continue;
        if (!spacing.is_difference() && !(bar.birth > 0)) continue;
        if (!(bar.death > spacing.after(bar.birth, shortest))) continue;
        window_[i] = {-infinity, infinity};
        if (cells == nullptr) continue;
        const Places birth = places_of(bar.birth), death = places_of(bar.death);
        Window window = window_of(birth, death);
        const auto is_worth = [&](double gain) { return spacing.after(window.last, gain) > window.first; };
        for (std::uint32_t k = birth.first; is_worth(narrower) && k < birth.last; ++k)
            if (filter.interval[order[k]].lo < window.first) cells->narrow_high(order[k], 0);
        window = window_of(birth, death);
        for (std::uint32_t k = death.first; is_worth(narrower) && k < death.last; ++k)
            if (filter.interval[order[k]].hi > window.last) cells->narrow_low(order[k], infinity);
        window = window_of(birth, death);
        window_[i] = is_worth(shortest) ? window : Window{infinity, -infinity};
    }
    return Status::ok;
}

// Where the next sequence goes through: of the longest bar that has a window and no claim the middle or a quarter, if
// it is in the window, or a place in that, as far as no sequence went near there.
class NextScale {
public:
    explicit NextScale(Spacing spacing) : spacing_(spacing) {}

    // False: nowhere.
    bool find(const Ledger& ledger, const Windows& windows, const BarList& bars, double* scale) {
        double best = spacing_.is_difference() ? 0 : 1;
        bool found = false;
        for (std::uint64_t i = 0; i < bars.count; ++i) {
            if (!windows.has(i) || ledger.claims(i)) continue;
            const Pair bar = bars[i];
            const double length = spacing_.is_difference() ? bar.death - bar.birth : bar.death / bar.birth;
            if (!(length > best) || !find_in(bar, windows[i], scale)) continue;
            best = length;
            found = true;
        }
        if (found) gone_[count_++] = *scale;
        return found;
    }

private:
    double middle(double from, double to) const {
        return spacing_.is_difference() ? from + 0.5 * (to - from) : square_root(from) * square_root(to);
    }
    bool find_in(const Pair& bar, const Window& window, double* scale) const {
        const double half = middle(bar.birth, bar.death);
        // A window that is empty is best where the cell of the death is just not there.
        const double inside = window.first < window.last ? middle(window.first, window.last) : -next_up(-window.last);
        const double tries[] = {half, middle(half, bar.death), middle(bar.birth, half), inside};
        const int count = window.last < infinity ? 4 : 3;
        for (int i = 0; i < count; ++i) {
            const double s = tries[i];
            if (i < 3 && !(window.first <= s && s < window.last)) continue;
            bool is_near = false;
            for (int k = 0; k < count_; ++k)
                is_near = is_near || (s < spacing_.after(gone_[k], 1.05) && gone_[k] < spacing_.after(s, 1.05));
            if (is_near) continue;
            *scale = s;
            return true;
        }
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
    CertifiedSearch(const CertifiedBarsRequest& request, const Arena& arena)
        : request_(request), filter_(request.filter), bars_(request.bars), arena_(arena),
          least_degree_(request.zero_born > 0 ? 1 : 0), covers_(request.filter, request.spacing, request.cells, arena),
          ledger_(request.join), next_(request.spacing), share_(request.filter, request.spacing, arena) {}

    Status open(const BarBounds* bounds, Arena& arena);
    // Another sequence: the level at which each vertex enters. False: there is none.
    bool next();
    const double* level() const { return level_; }
    std::uint32_t top_degree() const { return bars_[bars_.count - 1].degree; }
    // Its diagram.
    void consider(const PairList& pairs) {
        for (std::uint32_t degree = least_degree_; degree <= top_degree(); ++degree)
            ledger_.consider(covers_, pairs, degree, number_ + 1);
    }
    void conclude(BarBounds* bounds) const { ledger_.conclude(bounds); }

private:
    const CertifiedBarsRequest& request_;
    const FilterBounds& filter_;
    const BarList& bars_;
    const Arena& arena_;
    const std::uint32_t least_degree_;
    CoverSequence covers_;
    Ledger ledger_;
    Windows windows_;
    NextScale next_;
    const HalfShare share_;
    double* level_ = nullptr;
    int number_ = 0;
};

Status CertifiedSearch::open(const BarBounds* bounds, Arena& arena) {
    Status status = ledger_.open(bars_, bounds, arena);
    if (status == Status::ok)
        status = windows_.open(filter_, bars_, least_degree_, request_.spacing, request_.cells, arena);
    level_ = arena.take_low<double>(filter_.count);
    return status == Status::ok && level_ == nullptr ? Status::out_of_memory : status;
}

bool CertifiedSearch::next() {
    double scale = 0;
    if (number_ == sequences_max || !next_.find(ledger_, windows_, bars_, &scale)) return false;
    ++number_;
    covers_.go_through(scale);
    // The filter's values order the simplices of a level, which keeps the reduction short.
    for (std::uint32_t v = 0; v < filter_.count;)
        for (const std::uint64_t piece = arena_.piece(v, filter_.count, 30); v < piece; ++v) {
            // Cells across the scale decide; what is around others need not be known as well.
            const Interval& cell = filter_.interval[v];
            if (request_.cells != nullptr && cell.lo <= scale && scale < cell.hi) request_.cells->decide(v, scale);
            level_[v] = covers_.level(filter_.interval[v]) + share_.of(filter_.value[v]);
        }
    return true;
}

}  // namespace

Status find_certified_bars(const CertifiedBarsRequest& request, const Work& work, BarBounds* bounds) {
    if (request.bars.count == 0) return Status::ok;
    const ArenaScope scope(work.arena);
    CertifiedSearch search(request, work.arena);
    Status status = search.open(bounds, work.arena);
    while (status == Status::ok && search.next()) {
        const ArenaScope run(work.arena);
        const LowerStarFiltration<any_dimension> levels = {request.complex, search.level(), request.zero_born,
                                                           request.part};
        CountedPairs found = {};
        if (request.packs == nullptr) {
            status = persist_lower_star(levels, {search.top_degree()}, work, &found);
        } else {
            const AnyStore& store = *request.packs;
            const std::size_t end =
                work.arena.offset_of(store.first_cell()) + store.state.cell_slots * AnyStore::cell_bytes(store.dim);
            status = diagram_of_packed<false>(store, {end, work.arena.high_mark()}, levels, {search.top_degree()}, work,
                                              &found);
        }
        if (status == Status::ok) search.consider(found.pairs);
    }
    if (status == Status::ok) search.conclude(bounds);
    return status;
}

}  // namespace netmesh
