#include "homology/vineyard/vineyard.hpp"

#include "homology/check_reduction.hpp"
#include "homology/matrix/reduction.hpp"
#include "homology/rank.hpp"
#include "numerics/real.hpp"
#include "numerics/sort.hpp"

namespace netmesh {

#ifdef NETMESH_VALIDATE
// Of k-simplex s, k > 0: R = D V, V upper triangular with s itself, the pivot that of R, and owned by s.
const char* Vineyard::violation_at(std::uint32_t k, std::uint32_t s) const {
    const Record& record = of_[k].at[s];
    SmallChain boundary;
    const std::uint32_t* const v = pool_.rows(record.v);
    bool has_itself = false;
    for (std::uint32_t i = 0; i < record.v.length; ++i) {
        has_itself |= v[i] == s;
        if (of_[k].at[v[i]].position > record.position) return "V is not upper triangular";
        for (std::uint32_t j = 0; j <= k; ++j) boundary.toggle(complex_.facets[k][std::size_t{k + 1} * v[i] + j]);
    }
    if (!has_itself) return "V lacks its diagonal";
    if (!boundary.is_known()) return nullptr;
    const std::uint32_t* const r = pool_.rows(record.r);
    for (std::uint32_t i = 0; i < record.r.length; ++i)
        if (!boundary.has(r[i])) return "R is not D V";
    if (boundary.count() != record.r.length) return "R is not D V";
    if (record.low != pivot_of(k, record.r)) return "a pivot is not that of R";
    return record.low == none || of_[k - 1].at[record.low].owner == s ? nullptr : "two columns have the same pivot";
}

// Of a small vineyard: every column, and no simplex owned that is nobody's pivot.
const char* Vineyard::violation() const {
    std::uint32_t simplices = 0;
    for (std::uint32_t k = 0; k <= top_; ++k) simplices += complex_.count[k];
    for (std::uint32_t k = 0; simplices <= validated_columns_max / 2 && k <= top_; ++k)
        for (std::uint32_t s = 0; s < complex_.count[k]; ++s) {
            const std::uint32_t owner = of_[k].at[s].owner;
            if (of_[k].at[of_[k].order[of_[k].at[s].position]].position != of_[k].at[s].position ||
                of_[k].order[of_[k].at[s].position] != s)
                return "positions and order disagree";
            if (owner != none && (k == top_ || of_[k + 1].at[owner].low != s))
                return "the owner of a pivot has another";
            const char* const violation = k == 0 ? nullptr : violation_at(k, s);
            if (violation != nullptr) return violation;
        }
    return nullptr;
}
#endif

Status Vineyard::open(const ComplexView& complex, std::uint32_t max_degree, const double* const* value,
                      const Work& work) {
    complex_ = complex;
    arena_ = &work.arena;
    max_degree_ = max_degree < complex.dimension ? max_degree : complex.dimension;
    top_ = max_degree_ + 1 < complex.dimension ? max_degree_ + 1 : complex.dimension;
    std::uint32_t longest = 1;
    std::uint64_t simplices = 0;
    for (std::uint32_t k = 0; k <= top_; ++k) simplices += complex.count[k];
    if (simplices > none / 2) return Status::out_of_memory;
    slots_ = 0;
    for (std::uint32_t k = 0; k <= top_; ++k) {
        const std::uint32_t n = complex.count[k];
        if (n > longest) longest = n;
        Dimension& d = of_[k];
        d.order = work.arena.take_high<std::uint32_t>(n);
        d.vine = work.arena.take_high<std::uint32_t>(n);
        d.at = work.arena.take_high<Record>(n);
        if (d.order == nullptr || d.vine == nullptr || d.at == nullptr) return Status::out_of_memory;
        d.slot = slots_;
        slots_ += n > 0 ? n - 1 : 0;
    }
    time_ = work.arena.take_high<double>(std::size_t{slots_} + 1);
    winner_ = work.arena.take_high<std::uint32_t>(std::size_t{slots_} + 1);
    if (time_ == nullptr || winner_ == nullptr) return Status::out_of_memory;
    for (std::uint32_t k = 0; k <= top_; ++k) {
        const HighScope scope(work.arena);
        std::uint32_t* const position = work.arena.take_high<std::uint32_t>(complex.count[k]);
        if (position == nullptr || !rank_vertices(value[k], complex.count[k], work.arena, of_[k].order, position))
            return Status::out_of_memory;
        for (std::uint32_t s = 0; s < complex.count[k];)
            for (const std::uint64_t piece = work.arena.piece(s, complex.count[k], 20); s < piece; ++s) {
                of_[k].at[s] = {position[s], none, none, none, {none, 0}, {none, 0}, {0, 0}};
                of_[k].vine[s] = none;
            }
    }
    Status status = pool_.open(work.arena, longest);
    std::uint64_t total = 0;
    for (std::uint32_t k = 1; k <= top_; ++k) total += complex.count[k];
    work.monitor.begin(NETMESH_STAGE_REDUCE, total);
    work_ = 0;
    for (std::uint32_t k = top_; k >= 1 && status == Status::ok; --k) status = reduce(k, work.monitor);
    if (status == Status::ok) NETMESH_VALIDATE_WHOLE(violation());
    vine_count_ = 0;
    for (std::uint32_t k = 0; k <= max_degree_; ++k)
        for (std::uint32_t s = 0; s < complex.count[k];)
            for (const std::uint64_t piece = work.arena.piece(s, complex.count[k], 20); s < piece; ++s) {
                if (is_positive(k, s)) of_[k].vine[s] = vine_count_++;
            }
    return status;
}

// The row that comes last in the filtration.
std::uint32_t Vineyard::pivot_of(std::uint32_t k, const SparseColumn& column) const {
    const std::uint32_t* const rows = pool_.rows(column);
    const Record* const at = of_[k - 1].at;
    std::uint32_t pivot = none, last = 0;
    for (std::uint32_t i = 0; i < column.length; ++i)
        if (pivot == none || at[rows[i]].position > last) {
            pivot = rows[i];
            last = at[pivot].position;
        }
    return pivot;
}

// The columns of the k-simplices, in the order of the filtration.
class Vineyard::Columns {
public:
    Columns(Vineyard& vineyard, std::uint32_t k, Monitor& monitor) : v_(vineyard), k_(k), monitor_(monitor) {}

    Status open(std::uint32_t s) {
        std::uint32_t faces[ComplexView::dimension_max + 1];
        for (std::uint32_t j = 0; j <= k_; ++j) faces[j] = v_.complex_.facets[k_][std::size_t{k_ + 1} * s + j];
        insertion_sort(faces, k_ + 1, Ascending{});
        column_ = s;
        if (!v_.pool_.assign(at(s).r, faces, k_ + 1)) return Status::out_of_memory;
        v_.pool_.assign(at(s).v, &s, 1);  // a single row takes no memory
        pivot_ = v_.pivot_of(k_, at(s).r);
        return Status::ok;
    }
    bool has_owner() const { return pivot_ != none && below(pivot_).owner != none; }
    Status add_owner() {
        Record &r = at(column_), &owner = at(below(pivot_).owner);
        if (!v_.pool_.add(r.r, owner.r) || !v_.pool_.add(r.v, owner.v)) return Status::out_of_memory;
        pivot_ = v_.pivot_of(k_, r.r);
        v_.arena_->pass(2);
        return Status::ok;
    }
    bool is_zero() const { return pivot_ == none; }
#ifdef NETMESH_VALIDATE
    const char* violation(std::uint32_t s) const { return v_.violation_at(k_, s); }
#endif

    // As a recorder. Where the dimension above has found that a simplex gives birth, the column that it is the pivot
    // of is a cycle that it completes: R = 0 and V that cycle (clearing).
    bool next(std::uint32_t* s) {
        for (; status_ == Status::ok && next_ < v_.complex_.count[k_]; ++next_) {
            *s = v_.of_[k_].order[next_];
            if (k_ == v_.top_ || at(*s).owner == none) {
                ++next_;
                return true;
            }
            const SparseColumn& cycle = v_.of_[k_ + 1].at[at(*s).owner].r;
            const bool fits = v_.pool_.assign(at(*s).v, v_.pool_.rows(cycle), cycle.length);
            status_ = fits ? advance() : Status::out_of_memory;
        }
        return false;
    }
    Status pair(std::uint32_t s) {
        at(s).low = pivot_;
        below(pivot_).owner = s;
        return advance();
    }
    Status zero(std::uint32_t) { return advance(); }
    // What stopped next().
    Status status() const { return status_; }

private:
    Record& at(std::uint32_t s) const { return v_.of_[k_].at[s]; }
    Record& below(std::uint32_t row) const { return v_.of_[k_ - 1].at[row]; }
    Status advance() { return monitor_.advance(++v_.work_) ? Status::cancelled : Status::ok; }

    Vineyard& v_;
    std::uint32_t k_;
    Monitor& monitor_;
    Status status_ = Status::ok;
    std::uint32_t next_ = 0, column_ = 0, pivot_ = none;
};

Status Vineyard::reduce(std::uint32_t k, Monitor& monitor) {
    Columns columns(*this, k, monitor);
    const Status status = reduce_columns(columns, columns);
    return status == Status::ok ? columns.status() : status;
}

std::uint32_t Vineyard::dimension_of(std::uint32_t slot) const {
    std::uint32_t k = top_;
    while (slot < of_[k].slot) --k;
    return k;
}

// The values of the simplices at positions i and i + 1.
Crossing Vineyard::crossing(std::uint32_t k, std::uint32_t i) const {
    return {of_[k].at[of_[k].order[i]].value, of_[k].at[of_[k].order[i + 1]].value};
}

// When they cross; infinity when they stay in this order.
double Vineyard::crossing_time(std::uint32_t k, std::uint32_t i) const {
    const Record &a = of_[k].at[of_[k].order[i]], &b = of_[k].at[of_[k].order[i + 1]];
    return a.target < b.target ? infinity : time_of({a.value, b.value});
}

// The earlier crossing of the two below a node of the tournament, of equal times that of the lower slot.
void Vineyard::find_winner(std::uint32_t node) {
    const std::uint32_t a = slot_at(2 * node), b = slot_at(2 * node + 1);
    const double s = time_[a], t = time_[b];
    bool later = t < s || (t == s && b < a);
    const double least = t < s ? t : s, most = t < s ? s : t;
    if (most <= may_equal(least) && least < infinity) {
        arena_->pass(10);
        const std::uint32_t ka = dimension_of(a), kb = dimension_of(b);
        const int order = compare_times(crossing(ka, a - of_[ka].slot), crossing(kb, b - of_[kb].slot));
        later = order > 0 || (order == 0 && b < a);
    }
    winner_[node] = later ? b : a;
}

// The times at positions first..last of dimension k have changed: the winners above them are found again, level by
// level.
void Vineyard::update_winners(std::uint32_t k, std::uint32_t first, std::uint32_t last) {
    const std::uint32_t shift = slots_ + of_[k].slot;
    std::uint32_t low = shift + first, high = shift + last;
    while (high > 1) {  // leaves may lie at two depths, so that the lower end can arrive at the root first
        low = low > 1 ? low / 2 : 1;
        high /= 2;
        for (std::uint32_t node = high; node >= low; --node) find_winner(node);
    }
}

Status Vineyard::advance(const double* const* from, const double* const* to, Monitor& monitor) {
    for (std::uint32_t k = 0; k <= top_; ++k) {
        const HighScope scope(*arena_);
        std::uint32_t* const order = arena_->take_high<std::uint32_t>(complex_.count[k]);
        std::uint32_t* const target = arena_->take_high<std::uint32_t>(complex_.count[k]);
        if (order == nullptr || target == nullptr || !rank_vertices(to[k], complex_.count[k], *arena_, order, target))
            return Status::out_of_memory;
        for (std::uint32_t s = 0; s < complex_.count[k];)
            for (const std::uint64_t piece = arena_->piece(s, complex_.count[k], 12); s < piece; ++s) {
                of_[k].at[s].target = target[s];
                of_[k].at[s].value = {from[k][s], to[k][s]};
            }
        for (std::uint32_t i = 0; i + 1 < complex_.count[k]; ++i) {
            arena_->step(i, 60);
            time_[of_[k].slot + i] = crossing_time(k, i);
        }
    }
    if (slots_ == 0) return Status::ok;
    for (std::uint32_t node = slots_ - 1; node >= 1; --node) {
        arena_->step(node, 40);
        find_winner(node);
    }
    monitor.begin(NETMESH_STAGE_REDUCE, 0);
    for (std::uint32_t slot; time_[slot = slot_at(1)] < infinity;) {
        const std::uint32_t k = dimension_of(slot);
        const Status status = transpose_from(k, slot - of_[k].slot, monitor);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

// Transposes the simplices at positions i and i + 1, whose crossing is the first of all, and goes on as long as the
// next crossing is among the positions whose times have changed since; the tournament is told of all of these at the
// end. Simplices that share their values, as those of a lower star do, cross others all at once, so such runs are
// long. The order of transpositions is that of the tournament: by time, then slot. Values that meet at one time do so
// pair by pair, so no time that changes is earlier than the present one; the first of equal times is at position i - 1,
// or else at i + 1, or else farther up among those that have changed, and all others of this time come behind these.
Status Vineyard::transpose_from(std::uint32_t k, std::uint32_t i, Monitor& monitor) {
    constexpr std::uint32_t span_max = 256;
    Dimension& d = of_[k];
    double* const time = time_ + d.slot;
    const std::uint32_t last = complex_.count[k] - 2;
    const Crossing now = crossing(k, i);
    const double now_time = time[i], not_later = may_equal(now_time);
    const auto is_now = [&](std::uint32_t j) {
        return time[j] <= not_later && compare_times(crossing(k, j), now) == 0;
    };
    const auto renew = [&](std::uint32_t j) {
        const Record &a = d.at[d.order[j]], &b = d.at[d.order[j + 1]];
        time[j] = infinity;
        if (a.target < b.target) return false;
        arena_->pass(2);
        const Crossing next = {a.value, b.value};
        const bool same = are_equal(next, now);
        time[j] = same ? now_time : time_of(next);
        return same || (time[j] <= not_later && compare_times(next, now) == 0);
    };
    std::uint32_t low = i, high = i;
    for (Status status = Status::ok;;) {
        const std::uint32_t a = d.order[i], b = d.order[i + 1];
        if (!transpose(k, a, b)) return Status::out_of_memory;
        d.order[i] = b;
        d.order[i + 1] = a;
        d.at[a].position = i + 1;
        d.at[b].position = i;
        NETMESH_VALIDATE_WHOLE(violation());
        time[i] = infinity;
        std::uint32_t next = i;
        if (i < last) {
            if (i + 1 > high) high = i + 1;
            if (renew(i + 1)) next = i + 1;
        }
        if (i > 0) {
            if (i - 1 < low) low = i - 1;
            if (renew(i - 1)) next = i - 1;
        }
        ++transpositions_;
        if (monitor.advance(transpositions_)) status = Status::cancelled;
        if (status == Status::ok && high - low <= span_max) {
            for (std::uint32_t j = low; next == i && j <= high; ++j)
                if (is_now(j)) next = j;
            if (next != i) {
                i = next;
                continue;
            }
        }
        update_winners(k, low, high);
        return status;
    }
}

// a stands just before b, both of dimension k. R and V become those of the order in which they are exchanged. False:
// out of memory.
bool Vineyard::transpose(std::uint32_t k, std::uint32_t a, std::uint32_t b) {
    const bool a_positive = is_positive(k, a), b_positive = is_positive(k, b);
    if (a_positive && b_positive) return transpose_positive(k, a, b);
    if (!a_positive && !b_positive) return transpose_negative(k, a, b);
    Dimension& d = of_[k];
    if (!pool_.has(d.at[b].v, a)) return true;
    if (a_positive) return pool_.add(d.at[b].v, d.at[a].v);
    return exchange(k, a, b);
}

// Both give birth.
bool Vineyard::transpose_positive(std::uint32_t k, std::uint32_t a, std::uint32_t b) {
    Dimension& d = of_[k];
    if (k > 0 && pool_.has(d.at[b].v, a) && !pool_.add(d.at[b].v, d.at[a].v)) return false;
    if (k == top_ || d.at[b].owner == none) return true;
    Dimension& above = of_[k + 1];
    const std::uint32_t later = d.at[b].owner, earlier = d.at[a].owner;
    if (!pool_.has(above.at[later].r, a)) return true;
    if (earlier != none && above.at[earlier].position < above.at[later].position)
        return pool_.add(above.at[later].r, above.at[earlier].r) && pool_.add(above.at[later].v, above.at[earlier].v);
    if (earlier != none) {
        if (!pool_.add(above.at[earlier].r, above.at[later].r) || !pool_.add(above.at[earlier].v, above.at[later].v))
            return false;
        above.at[earlier].low = b;
    }
    above.at[later].low = a;
    d.at[a].owner = later;
    d.at[b].owner = earlier;
    const std::uint32_t vine = d.vine[a];
    d.vine[a] = d.vine[b];
    d.vine[b] = vine;
    return true;
}

// Both end a class.
bool Vineyard::transpose_negative(std::uint32_t k, std::uint32_t a, std::uint32_t b) {
    Dimension& d = of_[k];
    if (!pool_.has(d.at[b].v, a)) return true;
    const std::uint32_t low_a = d.at[a].low, low_b = d.at[b].low;
    const bool switches = of_[k - 1].at[low_a].position > of_[k - 1].at[low_b].position;
    if (!switches) return pool_.add(d.at[b].r, d.at[a].r) && pool_.add(d.at[b].v, d.at[a].v);
    // b takes the sum, which has a's pivot, and a what b was.
    if (!pool_.add(d.at[a].r, d.at[b].r) || !pool_.add(d.at[a].v, d.at[b].v)) return false;
    const SparseColumn r = d.at[a].r, v = d.at[a].v;
    d.at[a].r = d.at[b].r;
    d.at[a].v = d.at[b].v;
    d.at[b].r = r;
    d.at[b].v = v;
    d.at[a].low = low_b;
    d.at[b].low = low_a;
    of_[k - 1].at[low_a].owner = b;
    of_[k - 1].at[low_b].owner = a;
    return true;
}

// a ends a class, b gives birth to a cycle that contains a: the roles are exchanged.
bool Vineyard::exchange(std::uint32_t k, std::uint32_t a, std::uint32_t b) {
    Dimension& d = of_[k];
    if (!pool_.add(d.at[a].v, d.at[b].v)) return false;
    const SparseColumn v = d.at[a].v;
    d.at[a].v = d.at[b].v;
    d.at[b].v = v;
    d.at[b].r = d.at[a].r;
    d.at[a].r = {none, 0};
    d.at[b].low = d.at[a].low;
    d.at[a].low = none;
    of_[k - 1].at[d.at[b].low].owner = b;
    d.vine[a] = d.vine[b];
    d.vine[b] = none;
    if (k == top_) return true;
    d.at[a].owner = d.at[b].owner;
    d.at[b].owner = none;
    if (d.at[a].owner != none) of_[k + 1].at[d.at[a].owner].low = a;
    return true;
}

}  // namespace netmesh
