#include "filtration/sure_bars.hpp"

#include "certificate/cells.hpp"
#include "filtration/value_table.hpp"
#include "homology/persistence.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

constexpr int chains_max = 8;
constexpr double shortest = 1.25;  // death over birth of a bar worth a chain
constexpr double stride = 1.25;    // between scales of a chain where no cell lies across

// Scales of a chain, ascending.
class Chain {
public:
    static constexpr int scales_max = 96;

    Status open(const Interval* interval, std::uint32_t count, Arena& arena);
    // A chain through scale s > 0.
    void go_through(double s);
    int scales() const { return scales_; }
    double scale(int i) const { return scale_[i]; }
    // 2 i: in X_i, 2 i + 1: in Y_i, and in nothing before.
    int level(const Interval& cell) const {
        int y = 0;
        while (y < scales_ && scale_[y] < cell.lo) ++y;
        return y < scales_ && cell.hi <= scale_[y] ? 2 * y : y < scales_ ? 2 * y + 1 : 2 * scales_;
    }

private:
    ValueTable by_low_, by_high_;  // largest hi up to a lo, least lo from a hi on
    double scale_[scales_max];
    int scales_ = 0;
};

Status Chain::open(const Interval* interval, std::uint32_t count, Arena& arena) {
    const auto lo = [&](std::uint32_t v) { return interval[v].lo; };
    const auto hi = [&](std::uint32_t v) { return interval[v].hi; };
    const bool room = by_low_.open_largest(count, lo, hi, arena) && by_high_.open_least(count, hi, lo, arena);
    return room ? Status::ok : Status::out_of_memory;
}

void Chain::go_through(double s) {
    constexpr int half = scales_max / 2;
    double below[half];
    int count = 0;
    for (double b = s; count < half && b >= by_high_.first();) {
        below[count++] = b;
        // The largest scale whose Y is in the X of this one.
        const double least = by_high_.least_after(b) * down;
        b = least < b / stride ? least : b / stride;
    }
    scales_ = 0;
    while (count > 0) scale_[scales_++] = below[--count];
    if (scales_ == 0) scale_[scales_++] = s;
    const double top = by_high_.last();
    while (scales_ < scales_max && scale_[scales_ - 1] < top) {
        const double b = scale_[scales_ - 1] * stride, most = by_low_.largest_up_to(scale_[scales_ - 1]);
        const double next = most > b ? most : b;
        scale_[scales_++] = next < top ? next : top;
    }
}

// What a bar of a chain says about a true bar.
struct Claim {
    double birth_low, birth_high, death_low, death_high;
    int chain;  // 0: none, 1: by interleaving

    bool disjoint(const Claim& o) const {
        return birth_high < o.birth_low || o.birth_high < birth_low || death_high < o.death_low ||
               o.death_high < death_low;
    }
    bool contains(const Pair& bar) const {
        return birth_low <= bar.birth && bar.birth <= birth_high && death_low <= bar.death && bar.death <= death_high;
    }
};

// False: the bar is alive at no P_i for sure.
bool claim_of(const Chain& chain, const Pair& bar, int number, Claim* claim) {
    if (!(bar.death < infinity)) return false;
    const int born = static_cast<int>(bar.birth), dies = static_cast<int>(bar.death);
    const int first = (born + 1) / 2, last = dies / 2 - 1;
    if (first > last) return false;
    const int before = born / 2 - 1, after = (dies + 1) / 2;
    *claim = {before >= 0 ? chain.scale(before) : 0, chain.scale(first), chain.scale(last),
              after < chain.scales() ? chain.scale(after) : infinity, number};
    return true;
}

// The claims about the bars of a diagram.
class Ledger {
public:
    Status open(const Pair* pairs, std::uint64_t count, const BarBounds* bounds, Arena& arena);
    // Takes up what a chain says about one degree, if that makes claims more.
    void consider(const Chain& chain, const PairList& list, std::uint32_t degree, int number);
    bool claims(std::uint64_t bar) const { return now_[bar].chain != 0; }
    void conclude(BarBounds* bounds) const;

private:
    void clear(Claim* to) const {
        for (std::uint64_t i = begin_; i < end_; ++i) to[i].chain = 0;
    }
    std::uint64_t keep_old(Claim* to, int number) const;
    std::uint64_t add_new(Claim* to, const Chain& chain, const PairList& list, int number) const;
    bool excludes(const Claim* set, const Claim& claim, bool of_this_chain, int number) const;

    const Pair* pairs_ = nullptr;
    std::uint64_t count_ = 0, begin_ = 0, end_ = 0;  // the degree's bars
    Claim *now_ = nullptr, *first_ = nullptr, *second_ = nullptr;
};

Status Ledger::open(const Pair* pairs, std::uint64_t count, const BarBounds* bounds, Arena& arena) {
    pairs_ = pairs;
    count_ = count;
    now_ = arena.take_high<Claim>(static_cast<std::size_t>(count));
    first_ = arena.take_high<Claim>(static_cast<std::size_t>(count));
    second_ = arena.take_high<Claim>(static_cast<std::size_t>(count));
    if (now_ == nullptr || first_ == nullptr || second_ == nullptr) return Status::out_of_memory;
    for (std::uint64_t i = 0; i < count; ++i)
        now_[i] = {bounds[i].birth_low, bounds[i].birth_high, bounds[i].death_low, bounds[i].death_high,
                   bounds[i].certain ? 1 : 0};
    return Status::ok;
}

// Is the claim about another true bar than all claims of this chain (of the others) in the set?
bool Ledger::excludes(const Claim* set, const Claim& claim, bool of_this_chain, int number) const {
    for (std::uint64_t i = begin_; i < end_; ++i)
        if (set[i].chain != 0 && (set[i].chain == number) == of_this_chain && !claim.disjoint(set[i])) return false;
    return true;
}

std::uint64_t Ledger::keep_old(Claim* to, int number) const {
    std::uint64_t kept = 0;
    for (std::uint64_t i = begin_; i < end_; ++i) {
        if (now_[i].chain == 0 || to[i].chain != 0 || !excludes(to, now_[i], true, number)) continue;
        to[i] = now_[i];
        ++kept;
    }
    return kept;
}

std::uint64_t Ledger::add_new(Claim* to, const Chain& chain, const PairList& list, int number) const {
    std::uint64_t added = 0;
    for (std::uint64_t i = 0; i < list.count; ++i) {
        Claim claim;
        if (list.pairs[i].degree != pairs_[begin_].degree || !claim_of(chain, list.pairs[i], number, &claim)) continue;
        if (!excludes(to, claim, false, number)) continue;
        std::uint64_t best = end_;
        for (std::uint64_t j = begin_; j < end_; ++j)
            if (to[j].chain == 0 && claim.contains(pairs_[j]) &&
                (best == end_ || pairs_[j].death - pairs_[j].birth > pairs_[best].death - pairs_[best].birth))
                best = j;
        if (best == end_) continue;
        to[best] = claim;
        ++added;
    }
    return added;
}

void Ledger::consider(const Chain& chain, const PairList& list, std::uint32_t degree, int number) {
    begin_ = 0;
    while (begin_ < count_ && pairs_[begin_].degree < degree) ++begin_;
    end_ = begin_;
    while (end_ < count_ && pairs_[end_].degree == degree) ++end_;
    if (begin_ == end_) return;
    std::uint64_t now = 0;
    for (std::uint64_t i = begin_; i < end_; ++i) now += now_[i].chain != 0;
    // What is there and what goes with it, or the other way round.
    clear(first_);
    std::uint64_t first = keep_old(first_, number);
    first += add_new(first_, chain, list, number);
    clear(second_);
    std::uint64_t second = add_new(second_, chain, list, number);
    second += keep_old(second_, number);
    if (first <= now && second <= now) return;
    const Claim* const better = second > first ? second_ : first_;
    for (std::uint64_t i = begin_; i < end_; ++i) now_[i] = better[i];
}

void Ledger::conclude(BarBounds* bounds) const {
    for (std::uint64_t i = 0; i < count_; ++i) {
        BarBounds& b = bounds[i];
        b.certain = claims(i);
        if (now_[i].chain < 2) continue;
        b.birth_low = now_[i].birth_low;
        b.birth_high = now_[i].birth_high;
        b.death_low = now_[i].death_low;
        b.death_high = now_[i].death_high;
    }
}

// Where the next chain goes through: the middle, then the quarters, of the longest bar worth it that has no claim, as far as no
// chain went near there; 0 for nowhere.
double next_scale(const Ledger& ledger, const Pair* pairs, std::uint64_t count, std::uint32_t least_degree,
                  const double* gone, int chains) {
    double best = shortest, scale = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const Pair& bar = pairs[i];
        if (bar.degree < least_degree || ledger.claims(i) || !(bar.birth > 0) || !(bar.death < infinity)) continue;
        const double ratio = bar.death / bar.birth;
        if (!(ratio > best)) continue;
        const double from = square_root(bar.birth), to = square_root(bar.death), middle = from * to;
        const double tries[] = {middle, square_root(middle) * to, from * square_root(middle)};
        for (const double s : tries) {
            bool near = false;
            for (int k = 0; k < chains; ++k) near = near || (s < gone[k] * 1.05 && gone[k] < s * 1.05);
            if (near) continue;
            best = ratio;
            scale = s;
            break;
        }
    }
    return scale;
}

}  // namespace

template <int D>
Status find_sure_bars(const TriangulationView<D>& complex, const double* value, const Interval* interval,
                      std::uint32_t zero_born, const Pair* pairs, std::uint64_t pair_count, const Work& work, BarBounds* bounds) {
    if (pair_count == 0) return Status::ok;
    const ArenaScope scope(work.arena);
    const std::uint32_t count = complex.vertex_count;
    Chain chain;
    Ledger ledger;
    Status status = chain.open(interval, count, work.arena);
    if (status == Status::ok) status = ledger.open(pairs, pair_count, bounds, work.arena);
    double* const level = work.arena.take_low<double>(count);
    if (status == Status::ok && level == nullptr) status = Status::out_of_memory;
    if (status != Status::ok) return status;
    double largest = 0;
    for (std::uint32_t v = 0; v < count; ++v)
        if (value[v] > largest) largest = value[v];
    const std::uint32_t top_degree = pairs[pair_count - 1].degree, least_degree = zero_born > 0 ? 1 : 0;
    double gone[chains_max];
    for (int number = 0; number < chains_max; ++number) {
        const double s = next_scale(ledger, pairs, pair_count, least_degree, gone, number);
        if (!(s > 0)) break;
        gone[number] = s;
        chain.go_through(s);
        // The filter's values order the simplices of a level, which keeps the reduction short.
        for (std::uint32_t v = 0; v < count; ++v)
            level[v] = chain.level(interval[v]) + (largest > 0 ? 0.5 * (value[v] / largest) : 0);
        const ArenaScope run(work.arena);
        PairList list = {};
        std::uint64_t simplices;
        status = persist_lower_star<D>(complex, level, zero_born, top_degree, false, work, &list, &simplices);
        if (status != Status::ok) return status;
        for (std::uint32_t degree = least_degree; degree <= top_degree; ++degree)
            ledger.consider(chain, list, degree, number + 2);
    }
    ledger.conclude(bounds);
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status find_sure_bars<D>(const TriangulationView<D>&, const double*, const Interval*, std::uint32_t,      \
                                      const Pair*, std::uint64_t, const Work&, BarBounds*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
