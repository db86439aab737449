// The columns at work in the sweep over lower stars, from the last star to the first.
//
// A column holds what is left of the boundary of a critical simplex: simplices of stars that the sweep has not visited
// yet, each as the ranks of its vertices in descending order. It waits at the star of its first simplex, the last one
// in the filtration. Its simplices are kept in up to four runs, each sorted with the last in the filtration first;
// equal simplices of one column cancel when their runs are merged or when both come to the head of their runs. New
// simplices are mostly close to the head, so a merge touches little: it ends with linking what is left of the longer
// run. Runs and columns live in blocks of 16 words, all of one pool:
//
//   block of a run   next block of the run | begin and end of its entries, 16 bits each | 14 words of entries, each
//                    entry within one block
//   column           next column of a list | age | creator's rank | dimension of the creator | 4 runs of (first block,
//                    last block, entries)
//
// A column that has taken a pivot has everything in its first run; its second run then holds, one word each, the
// positions of its simplices in the star at work.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/bit_tree.hpp"
#include "memory/arena.hpp"
#include "memory/prefetch.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

struct Run {
    std::uint32_t first, last, count;
};
constexpr Run no_run = {none, none, 0};

class Front {
public:
    static constexpr std::uint32_t ranks_max = dimension_most() - 1;

    // Takes a word a vertex at the arena's high end; from then on that end is the front's until it is done.
    bool reserve(std::uint32_t vertex_count, Arena& arena) {
        first_ = arena.take_high<std::uint32_t>(vertex_count);
        std::uint64_t* words = arena.take_high<std::uint64_t>(BitTree::words_needed(vertex_count));
        if (first_ == nullptr || words == nullptr) return false;
        for (std::uint32_t r = 0; r < vertex_count; ++r) first_[r] = none;
        waiting_.adopt(words, vertex_count);
        arena_ = &arena;
        top_ = arena.high_mark();
        return true;
    }

    // Stars to visit, by rank.
    BitTree& waiting() { return waiting_; }
    std::uint32_t column_count() const { return columns_; }
    [[gnu::always_inline]] void prefetch(std::uint32_t r) const {
        if (first_[r] != none) netmesh::prefetch(block(first_[r]));
    }

    // `none` when out of memory.
    std::uint32_t new_column(std::uint32_t age, std::uint32_t creator_rank, std::uint32_t dimension) {
        const std::uint32_t c = take();
        if (c == none) return none;
        std::uint32_t* w = block(c);
        w[0] = none;
        w[1] = age;
        w[2] = creator_rank;
        w[3] = dimension;
        for (std::uint32_t i = 0; i < runs_max; ++i) put_run(c, i, no_run);
        ++columns_;
        return c;
    }
    std::uint32_t& next(std::uint32_t i) { return block(i)[0]; }
    std::uint32_t age(std::uint32_t c) const { return block(c)[1]; }
    std::uint32_t creator_rank(std::uint32_t c) const { return block(c)[2]; }
    std::uint32_t dimension(std::uint32_t c) const { return block(c)[3]; }  // and words of its entries
    void drop(std::uint32_t c) {
        for (std::uint32_t i = 0; i < runs_max; ++i) give_back(run(c, i));
        give_back(c);
        --columns_;
    }

    // The columns that wait at star r, as a list.
    std::uint32_t arrive(std::uint32_t r) {
        const std::uint32_t c = first_[r];
        first_[r] = none;
        return c;
    }
    // Takes a simplex of star r out of column c: its ranks[dimension(c)]. False: none left.
    bool take_entry(std::uint32_t c, std::uint32_t r, std::uint32_t* ranks) {
        for (std::uint32_t i = 0; i < runs_max; ++i) {
            Run at = run(c, i);
            if (at.count == 0 || head(at, dimension(c))[0] != r) continue;
            copy(ranks, head(at, dimension(c)), dimension(c));
            pop(&at);
            put_run(c, i, at);
            return true;
        }
        return false;
    }
    // Adds a run to column c, which it is merged into or becomes part of. False: out of memory.
    bool add_run(std::uint32_t c, const Run& added) {
        Run runs[runs_max + 1];
        std::uint32_t count = 0;
        for (std::uint32_t i = 0; i <= runs_max; ++i) {
            const Run& r = i < runs_max ? run(c, i) : added;
            if (r.count > 0) runs[count++] = r;
        }
        while (count > 1 && (count > runs_max || runs[count - 2].count < 2 * runs[count - 1].count)) {
            if (!merge(runs[count - 2], runs[count - 1], dimension(c), &runs[count - 2])) return false;
            --count;
            if (runs[count - 1].count == 0) --count;
        }
        for (std::uint32_t i = 0; i < runs_max; ++i) put_run(c, i, i < count ? runs[i] : no_run);
        return true;
    }
    // Column c in one run, its first.
    bool unite_runs(std::uint32_t c) {
        Run all = no_run;
        for (std::uint32_t i = runs_max; i-- > 0;) {
            if (!merge(run(c, i), all, dimension(c), &all)) return false;
            put_run(c, i, no_run);
        }
        put_run(c, 0, all);
        return true;
    }
    // Adds what united column `from` has in stars not visited yet to column `to`.
    bool add_column(std::uint32_t to, std::uint32_t from) {
        const std::uint32_t n = dimension(from);
        Run copied = no_run;
        for (Cursor at = begin(run(from, 0)); at.left > 0; advance(&at)) {
            if (!append(&copied, entry(at, n), n)) return false;
        }
        return add_run(to, copied);
    }
    // Puts column c where its first simplex is. A column without one waits nowhere.
    void wait(std::uint32_t c) {
        const std::uint32_t n = dimension(c);
        Run runs[runs_max];
        for (std::uint32_t i = 0; i < runs_max; ++i) runs[i] = run(c, i);
        std::uint32_t best = none;
        for (bool again = true; again;) {
            again = false;
            best = none;
            for (std::uint32_t i = 0; i < runs_max; ++i) {
                if (runs[i].count == 0) continue;
                const int order = best == none ? 1 : compare(head(runs[i], n), head(runs[best], n), n);
                if (order > 0) best = i;
                if (order != 0) continue;
                pop(&runs[i]);
                pop(&runs[best]);
                again = true;
                break;
            }
        }
        for (std::uint32_t i = 0; i < runs_max; ++i) put_run(c, i, runs[i]);
        if (best == none) return;
        const std::uint32_t r = head(runs[best], n)[0];
        next(c) = first_[r];
        first_[r] = c;
        waiting_.insert(r);
    }

    bool append(Run* run, const std::uint32_t* entry, std::uint32_t n) {
        if (run->count == 0 || end_of(run->last) == data_words / n) {
            const std::uint32_t b = take();
            if (b == none) return false;
            block(b)[1] = 0;
            if (run->count == 0) {
                *run = Run{b, b, 0};
            } else {
                next(run->last) = b;
                run->last = b;
            }
        }
        copy(block(run->last) + 2 + end_of(run->last) * n, entry, n);
        block(run->last)[1] += 1u << 16;
        ++run->count;
        return true;
    }
    Run below(std::uint32_t c) const { return run(c, 0); }
    Run local(std::uint32_t c) const { return run(c, 1); }
    void put_local(std::uint32_t c, const Run& positions) { put_run(c, 1, positions); }

    // Reading a run without using it up.
    struct Cursor {
        std::uint32_t block, at, left;
    };
    Cursor begin(const Run& run) const {
        return Cursor{run.first, run.count == 0 ? 0 : begin_of(run.first), run.count};
    }
    const std::uint32_t* entry(const Cursor& at, std::uint32_t n) const { return block(at.block) + 2 + at.at * n; }
    void advance(Cursor* at) const {
        if (--at->left == 0 || ++at->at < end_of(at->block)) return;
        at->block = block(at->block)[0];
        at->at = begin_of(at->block);
    }

#ifdef NETMESH_VALIDATE
    // Between two stars, r the last one visited: every column waits at its first simplex, before r in the filtration,
    // was made at r or later, and has sorted runs. For small fronts. O(vertices + entries).
    const char* violation(std::uint32_t vertex_count, std::uint32_t r) const {
        constexpr std::uint32_t small = 1000;
        if (vertex_count > small || columns_ > small) return nullptr;
        std::uint32_t waiting = 0;
        for (std::uint32_t star = 0; star < vertex_count; ++star) {
            if (first_[star] != none && (star >= r || !waiting_.has(star))) return "a column waits where nobody comes";
            for (std::uint32_t c = first_[star]; c != none; c = block(c)[0]) {
                if (++waiting > columns_) return "there are more columns than were made";
                const char* const violation = column_violation(c, star, r);
                if (violation != nullptr) return violation;
            }
        }
        return waiting == columns_ ? nullptr : "a column waits nowhere";
    }
#endif

private:
#ifdef NETMESH_VALIDATE
    const char* column_violation(std::uint32_t c, std::uint32_t star, std::uint32_t r) const {
        const std::uint32_t n = dimension(c);
        if (n < 2 || n > ranks_max || creator_rank(c) < r) return "a column has no creator";
        bool is_at_star = false;
        for (std::uint32_t i = 0; i < runs_max; ++i) {
            std::uint32_t previous[ranks_max] = {none};
            for (Cursor at = begin(run(c, i)); at.left > 0; advance(&at)) {
                const std::uint32_t* const ranks = entry(at, n);
                for (std::uint32_t j = 1; j < n; ++j)
                    if (ranks[j] >= ranks[j - 1]) return "the ranks of a simplex do not descend";
                if (compare(ranks, previous, n) >= 0) return "a run is not sorted";
                if (ranks[0] > star) return "a column waits later than its first simplex";
                is_at_star |= ranks[0] == star;
                copy(previous, ranks, n);
            }
        }
        return is_at_star ? nullptr : "a column waits where it has no simplex";
    }
#endif
    static constexpr std::uint32_t block_words = 16, data_words = block_words - 2, runs_max = 4;
    static_assert(ranks_max <= data_words && 4 + 3 * runs_max <= block_words, "entries and columns must fit a block");

    std::uint32_t* block(std::uint32_t i) const {
        return reinterpret_cast<std::uint32_t*>(arena_->at(top_ - (std::size_t{i} + 1) * block_words * 4));
    }
    std::uint32_t begin_of(std::uint32_t b) const { return block(b)[1] & 0xFFFF; }
    std::uint32_t end_of(std::uint32_t b) const { return block(b)[1] >> 16; }
    const std::uint32_t* head(const Run& run, std::uint32_t n) const {
        return block(run.first) + 2 + begin_of(run.first) * n;
    }
    Run run(std::uint32_t c, std::uint32_t i) const {
        const std::uint32_t* w = block(c) + 4 + 3 * i;
        return Run{w[0], w[1], w[2]};
    }
    void put_run(std::uint32_t c, std::uint32_t i, const Run& r) {
        std::uint32_t* w = block(c) + 4 + 3 * i;
        w[0] = r.first;
        w[1] = r.last;
        w[2] = r.count;
    }
    static void copy(std::uint32_t* to, const std::uint32_t* from, std::uint32_t n) {
        for (std::uint32_t i = 0; i < n; ++i) to[i] = from[i];
    }
    static int compare(const std::uint32_t* a, const std::uint32_t* b, std::uint32_t n) {
        for (std::uint32_t i = 0; i < n; ++i) {
            if (a[i] != b[i]) return a[i] > b[i] ? 1 : -1;
        }
        return 0;
    }
    // Takes the head off; a block left behind goes back.
    void pop(Run* run) {
        const std::uint32_t b = run->first;
        ++block(b)[1];
        if (--run->count > 0 && begin_of(b) < end_of(b)) return;
        run->first = next(b);
        if (run->count == 0) *run = no_run;
        give_back(b);
    }
    // Uses a and b up. False: out of memory.
    bool merge(Run a, Run b, std::uint32_t n, Run* out) {
        Run sum = no_run;
        while (a.count > 0 && b.count > 0) {
            const int order = compare(head(a, n), head(b, n), n);
            if (order == 0) {
                pop(&a);
                pop(&b);
            } else {
                Run& from = order > 0 ? a : b;
                if (!append(&sum, head(from, n), n)) return false;
                pop(&from);
            }
        }
        Run& rest = a.count > 0 ? a : b;
        for (; sum.count > 0 && rest.count > 0 && rest.count < data_words / n; pop(&rest)) {
            if (!append(&sum, head(rest, n), n)) return false;
        }
        if (sum.count == 0) {
            sum = rest;
        } else if (rest.count > 0) {
            next(sum.last) = rest.first;
            sum.last = rest.last;
            sum.count += rest.count;
        }
        *out = sum;
        return true;
    }

    std::uint32_t take() {
        arena_->pass(1);  // for what a block full of entries has cost
        if (free_ != none) {
            const std::uint32_t i = free_;
            free_ = next(i);
            return i;
        }
        if (taken_ == none - 1 || arena_->take_high<std::uint32_t>(block_words) == nullptr) return none;
        return taken_++;
    }
    void give_back(std::uint32_t i) {
        next(i) = free_;
        free_ = i;
    }
    void give_back(const Run& run) {
        if (run.count == 0) return;
        next(run.last) = free_;
        free_ = run.first;
    }

    Arena* arena_ = nullptr;
    std::size_t top_ = 0;
    std::uint32_t* first_ = nullptr;  // [vertex_count] columns by the rank of their first simplex
    BitTree waiting_;
    std::uint32_t free_ = none, taken_ = 0, columns_ = 0;
};

}  // namespace netmesh
