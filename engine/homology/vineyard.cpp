#include "homology/vineyard.hpp"

#include "homology/rank.hpp"
#include "memory/high_scope.hpp"
#include "numerics/real.hpp"

namespace netmesh {

Status Vineyard::open(const ComplexView& complex, std::uint32_t max_degree, const double* const* value, Arena& arena,
                      Monitor& monitor) {
    complex_ = complex;
    arena_ = &arena;
    max_degree_ = max_degree < complex.dimension ? max_degree : complex.dimension;
    top_ = max_degree_ + 1 < complex.dimension ? max_degree_ + 1 : complex.dimension;
    std::uint32_t longest = 1;
    slots_ = 0;
    for (std::uint32_t k = 0; k <= top_; ++k) {
        const std::uint32_t n = complex.count[k];
        if (n > longest) longest = n;
        Dimension& d = of_[k];
        d.order = arena.take_high<std::uint32_t>(n);
        d.position = arena.take_high<std::uint32_t>(n);
        d.target = arena.take_high<std::uint32_t>(n);
        d.vine = arena.take_high<std::uint32_t>(n);
        d.low = arena.take_high<std::uint32_t>(n);
        d.owner = arena.take_high<std::uint32_t>(n);
        d.r = arena.take_high<SparseColumn>(n);
        d.v = arena.take_high<SparseColumn>(n);
        if (d.order == nullptr || d.position == nullptr || d.target == nullptr || d.vine == nullptr ||
            d.low == nullptr || d.owner == nullptr || d.r == nullptr || d.v == nullptr)
            return Status::out_of_memory;
        d.slot = slots_;
        slots_ += n > 0 ? n - 1 : 0;
    }
    tree_ = arena.take_high<Meeting>(2 * std::size_t{slots_} + 2);
    if (tree_ == nullptr) return Status::out_of_memory;
    for (std::uint32_t k = 0; k <= top_; ++k) {
        if (!rank_vertices(value[k], complex.count[k], arena, of_[k].order, of_[k].position))
            return Status::out_of_memory;
        for (std::uint32_t s = 0; s < complex.count[k]; ++s) {
            of_[k].low[s] = of_[k].owner[s] = of_[k].vine[s] = none;
            of_[k].r[s] = of_[k].v[s] = {none, 0};
        }
    }
    Status status = pool_.open(arena, longest);
    std::uint64_t total = 0;
    for (std::uint32_t k = 1; k <= top_; ++k) total += complex.count[k];
    monitor.begin(NETMESH_STAGE_REDUCE, total);
    work_ = 0;
    for (std::uint32_t k = top_; k >= 1 && status == Status::ok; --k) status = reduce(k, monitor);
    vine_count_ = 0;
    for (std::uint32_t k = 0; k <= max_degree_; ++k)
        for (std::uint32_t s = 0; s < complex.count[k]; ++s)
            if (is_positive(k, s)) of_[k].vine[s] = vine_count_++;
    return status;
}

// The row that comes last in the filtration.
std::uint32_t Vineyard::pivot_of(std::uint32_t k, const SparseColumn& column) const {
    const std::uint32_t* const rows = pool_.rows(column);
    const std::uint32_t* const position = of_[k - 1].position;
    std::uint32_t pivot = none, last = 0;
    for (std::uint32_t i = 0; i < column.length; ++i)
        if (pivot == none || position[rows[i]] > last) {
            pivot = rows[i];
            last = position[pivot];
        }
    return pivot;
}

// The columns of the k-simplices. Where the dimension above has found that one gives birth, the column that it is the
// pivot of is a cycle that it completes: R = 0 and V that cycle.
Status Vineyard::reduce(std::uint32_t k, Monitor& monitor) {
    Dimension& d = of_[k];
    for (std::uint32_t i = 0; i < complex_.count[k]; ++i) {
        const std::uint32_t s = d.order[i];
        std::uint64_t cost = 1;
        if (k < top_ && d.owner[s] != none) {
            const SparseColumn& cycle = of_[k + 1].r[d.owner[s]];
            if (!pool_.assign(d.v[s], pool_.rows(cycle), cycle.length)) return Status::out_of_memory;
        } else {
            std::uint32_t faces[ComplexView::dimension_max + 1];
            for (std::uint32_t j = 0; j <= k; ++j) {
                const std::uint32_t face = complex_.facets[k][std::size_t{k + 1} * s + j];
                std::uint32_t hole = j;
                for (; hole > 0 && faces[hole - 1] > face; --hole) faces[hole] = faces[hole - 1];
                faces[hole] = face;
            }
            if (!pool_.assign(d.r[s], faces, k + 1) || !pool_.assign(d.v[s], &s, 1)) return Status::out_of_memory;
            std::uint32_t pivot = pivot_of(k, d.r[s]);
            while (pivot != none && of_[k - 1].owner[pivot] != none) {
                const std::uint32_t other = of_[k - 1].owner[pivot];
                if (!pool_.add(d.r[s], d.r[other]) || !pool_.add(d.v[s], d.v[other])) return Status::out_of_memory;
                pivot = pivot_of(k, d.r[s]);
                cost += (d.r[s].length + d.v[s].length) / 16;
            }
            d.low[s] = pivot;
            if (pivot != none) of_[k - 1].owner[pivot] = s;
        }
        if (monitor.advance(++work_, cost < 1000 ? static_cast<std::uint32_t>(cost) : 1000)) return Status::cancelled;
    }
    return Status::ok;
}

std::uint32_t Vineyard::dimension_of(std::uint32_t slot) const {
    std::uint32_t k = top_;
    while (slot < of_[k].slot) --k;
    return k;
}

// When the simplices at positions i and i + 1 meet; infinity when they stay in this order.
double Vineyard::time_of(std::uint32_t k, std::uint32_t i) const {
    const std::uint32_t a = of_[k].order[i], b = of_[k].order[i + 1];
    if (of_[k].target[a] < of_[k].target[b]) return infinity;
    const double before = from_[k][b] - from_[k][a], after = to_[k][a] - to_[k][b];
    return before + after > 0 ? before / (before + after) : 0;
}

void Vineyard::play(std::uint32_t node) {
    tree_[node] = tree_[2 * node + 1].before(tree_[2 * node]) ? tree_[2 * node + 1] : tree_[2 * node];
}

// The times of positions first..last of dimension k have changed: all nodes above them are played again, level by level.
void Vineyard::update(std::uint32_t k, std::uint32_t first, std::uint32_t last) {
    const std::uint32_t shift = slots_ + of_[k].slot;
    std::uint32_t low = shift + first, high = shift + last;
    while (high > 1) {  // leaves may lie at two depths, so that the lower end can arrive at the root first
        low = low > 1 ? low / 2 : 1;
        high /= 2;
        for (std::uint32_t node = high; node >= low; --node) play(node);
    }
}

Status Vineyard::advance(const double* const* from, const double* const* to, Monitor& monitor) {
    from_ = from;
    to_ = to;
    for (std::uint32_t k = 0; k <= top_; ++k) {
        const HighScope scope(*arena_);
        std::uint32_t* const order = arena_->take_high<std::uint32_t>(complex_.count[k]);
        if (order == nullptr || !rank_vertices(to[k], complex_.count[k], *arena_, order, of_[k].target))
            return Status::out_of_memory;
    }
    if (slots_ == 0) return Status::ok;
    for (std::uint32_t k = 0; k <= top_; ++k)
        for (std::uint32_t i = 0; i + 1 < complex_.count[k]; ++i)
            tree_[slots_ + of_[k].slot + i] = {time_of(k, i), of_[k].slot + i, 0};
    for (std::uint32_t node = slots_ - 1; node >= 1; --node) play(node);
    monitor.begin(NETMESH_STAGE_REDUCE, 0);
    while (tree_[1].time < infinity) {
        const std::uint32_t slot = tree_[1].slot, k = dimension_of(slot);
        const Status status = play_out(k, slot - of_[k].slot, monitor);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

// From the meeting at position i, the first of all, on: as long as the next one is among the positions that have changed
// the tournament is not asked, and it is told of all of them in the end. Simplices that share their values, as those of a
// lower star do, meet others all at once. That the order is the tournament's: when this begins, positions before i have
// later times; those that have not changed since are not earlier, nor are they first where times are equal.
Status Vineyard::play_out(std::uint32_t k, std::uint32_t i, Monitor& monitor) {
    constexpr std::uint32_t span_max = 256;
    Dimension& d = of_[k];
    Meeting* const meeting = tree_ + slots_ + d.slot;
    const std::uint32_t last = complex_.count[k] - 2;
    std::uint32_t low = i, high = i;
    Status status = Status::ok;
    for (double now = meeting[i].time; status == Status::ok;) {
        const std::uint32_t a = d.order[i], b = d.order[i + 1];
        if (!transpose(k, a, b)) return Status::out_of_memory;
        d.order[i] = b;
        d.order[i + 1] = a;
        d.position[a] = i + 1;
        d.position[b] = i;
        meeting[i].time = infinity;
        std::uint32_t next = i;
        if (i < last) {
            meeting[i + 1].time = time_of(k, i + 1);
            if (i + 1 > high) high = i + 1;
            if (meeting[i + 1].time <= now) next = i + 1;
        }
        if (i > 0) {
            meeting[i - 1].time = time_of(k, i - 1);
            if (i - 1 < low) low = i - 1;
            if (meeting[i - 1].time <= now && meeting[i - 1].before(meeting[next])) next = i - 1;
        }
        ++transpositions_;
        if (monitor.advance(transpositions_)) status = Status::cancelled;
        if (high - low > span_max) break;
        for (std::uint32_t j = low, seen = next; seen == i && j <= high; ++j) {
            if (meeting[j].time <= now && meeting[j].time < meeting[next].time) next = j;
        }
        if (next == i) break;
        i = next;
        now = meeting[i].time;
    }
    update(k, low, high);
    return status;
}

// a stands just before b, both of dimension k. R and V become those of the order in which they are exchanged. False:
// out of memory.
bool Vineyard::transpose(std::uint32_t k, std::uint32_t a, std::uint32_t b) {
    const bool a_positive = is_positive(k, a), b_positive = is_positive(k, b);
    if (a_positive && b_positive) return transpose_positive(k, a, b);
    if (!a_positive && !b_positive) return transpose_negative(k, a, b);
    Dimension& d = of_[k];
    if (!pool_.has(d.v[b], a)) return true;
    if (a_positive) return pool_.add(d.v[b], d.v[a]);
    return exchange(k, a, b);
}

// Both give birth.
bool Vineyard::transpose_positive(std::uint32_t k, std::uint32_t a, std::uint32_t b) {
    Dimension& d = of_[k];
    if (k > 0 && pool_.has(d.v[b], a) && !pool_.add(d.v[b], d.v[a])) return false;
    if (k == top_ || d.owner[b] == none) return true;
    Dimension& above = of_[k + 1];
    const std::uint32_t later = d.owner[b], earlier = d.owner[a];
    if (!pool_.has(above.r[later], a)) return true;
    if (earlier != none && above.position[earlier] < above.position[later])
        return pool_.add(above.r[later], above.r[earlier]) && pool_.add(above.v[later], above.v[earlier]);
    if (earlier != none) {
        if (!pool_.add(above.r[earlier], above.r[later]) || !pool_.add(above.v[earlier], above.v[later])) return false;
        above.low[earlier] = b;
    }
    above.low[later] = a;
    d.owner[a] = later;
    d.owner[b] = earlier;
    const std::uint32_t vine = d.vine[a];
    d.vine[a] = d.vine[b];
    d.vine[b] = vine;
    return true;
}

// Both end a class.
bool Vineyard::transpose_negative(std::uint32_t k, std::uint32_t a, std::uint32_t b) {
    Dimension& d = of_[k];
    if (!pool_.has(d.v[b], a)) return true;
    const std::uint32_t low_a = d.low[a], low_b = d.low[b];
    const bool switches = of_[k - 1].position[low_a] > of_[k - 1].position[low_b];
    if (!switches) return pool_.add(d.r[b], d.r[a]) && pool_.add(d.v[b], d.v[a]);
    // b takes the sum, which has a's pivot, and a what b was.
    if (!pool_.add(d.r[a], d.r[b]) || !pool_.add(d.v[a], d.v[b])) return false;
    const SparseColumn r = d.r[a], v = d.v[a];
    d.r[a] = d.r[b];
    d.v[a] = d.v[b];
    d.r[b] = r;
    d.v[b] = v;
    d.low[a] = low_b;
    d.low[b] = low_a;
    of_[k - 1].owner[low_a] = b;
    of_[k - 1].owner[low_b] = a;
    return true;
}

// a ends a class, b gives birth to a cycle that contains a: the roles are exchanged.
bool Vineyard::exchange(std::uint32_t k, std::uint32_t a, std::uint32_t b) {
    Dimension& d = of_[k];
    if (!pool_.add(d.v[a], d.v[b])) return false;
    const SparseColumn v = d.v[a];
    d.v[a] = d.v[b];
    d.v[b] = v;
    d.r[b] = d.r[a];
    d.r[a] = {none, 0};
    d.low[b] = d.low[a];
    d.low[a] = none;
    of_[k - 1].owner[d.low[b]] = b;
    d.vine[a] = d.vine[b];
    d.vine[b] = none;
    if (k == top_) return true;
    d.owner[a] = d.owner[b];
    d.owner[b] = none;
    if (d.owner[a] != none) of_[k + 1].low[d.owner[a]] = a;
    return true;
}

}  // namespace netmesh
