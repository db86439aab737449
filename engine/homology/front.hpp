// The columns at work in the sweep over lower stars, from the last star to the first.
//
// A column holds what is left of the boundary of a critical simplex: simplices of stars not visited yet, each kept with
// the star of its highest vertex and linked to the other simplices of its column. Adding modulo 2 is put off until the
// star is visited, when equal simplices meet. All of it is nodes of one pool, as words:
//
//   entry    next in its star | column (none: cancelled) | previous in column | next in column | ranks[D-1], descending
//   column   next in a list | age | creator's rank | first entry | dimension of the creator | first local entry
//   local    next | position in the star at work
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/bit_tree.hpp"
#include "memory/arena.hpp"

namespace netmesh {

template <int D> class Front {
public:
    static constexpr std::uint32_t ranks_max = D - 1;

    // Takes two words a vertex at the arena's high end; from then on the high end is the front's until it is done.
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

    // Columns created later are older in the filtration; `none` when out of memory.
    std::uint32_t new_column(std::uint32_t age, std::uint32_t creator_rank, std::uint32_t dimension) {
        const std::uint32_t c = take();
        if (c == none) return none;
        std::uint32_t* w = node(c);
        w[0] = none;
        w[1] = age;
        w[2] = creator_rank;
        w[3] = none;
        w[4] = dimension;
        w[5] = none;
        ++columns_;
        return c;
    }
    std::uint32_t& next(std::uint32_t i) { return node(i)[0]; }
    std::uint32_t age(std::uint32_t c) { return node(c)[1]; }
    std::uint32_t creator_rank(std::uint32_t c) { return node(c)[2]; }
    std::uint32_t dimension(std::uint32_t c) { return node(c)[4]; }
    std::uint32_t& local(std::uint32_t c) { return node(c)[5]; }
    std::uint32_t& place(std::uint32_t local_entry) { return node(local_entry)[1]; }
    const std::uint32_t* ranks(std::uint32_t entry) { return node(entry) + 4; }
    std::uint32_t column_of(std::uint32_t entry) { return node(entry)[1]; }

    // Adds the simplex of ranks[n], descending, to column c. False: out of memory.
    bool add(std::uint32_t c, const std::uint32_t* ranks, std::uint32_t n) {
        const std::uint32_t e = take();
        if (e == none) return false;
        std::uint32_t* w = node(e);
        w[0] = first_[ranks[0]];
        w[1] = c;
        w[2] = none;
        w[3] = node(c)[3];
        for (std::uint32_t i = 0; i < n; ++i) w[4 + i] = ranks[i];
        if (w[3] != none) node(w[3])[2] = e;
        node(c)[3] = e;
        first_[ranks[0]] = e;
        waiting_.insert(ranks[0]);
        return true;
    }
    // Adds what column `from` has in stars not visited yet to column `to`.
    bool add_column(std::uint32_t to, std::uint32_t from) {
        const std::uint32_t n = dimension(from);
        for (std::uint32_t e = node(from)[3]; e != none; e = node(e)[3]) {
            std::uint32_t ranks[ranks_max] = {};
            for (std::uint32_t i = 0; i < n; ++i) ranks[i] = node(e)[4 + i];
            if (!add(to, ranks, n)) return false;
        }
        return true;
    }
    bool add_local(std::uint32_t c, std::uint32_t position) {
        const std::uint32_t e = take();
        if (e == none) return false;
        next(e) = local(c);
        place(e) = position;
        local(c) = e;
        return true;
    }

    void prefetch(std::uint32_t r) {
        if (first_[r] != none) __builtin_prefetch(node(first_[r]));
    }
    // Takes the entries of star r, unlinked from their columns; cancelled ones are dropped. A list by next().
    std::uint32_t arrive(std::uint32_t r) {
        std::uint32_t arrived = none;
        for (std::uint32_t e = first_[r]; e != none;) {
            const std::uint32_t following = next(e);
            if (column_of(e) == none) {
                give_back(e);
            } else {
                unlink(e);
                next(e) = arrived;
                arrived = e;
            }
            e = following;
        }
        first_[r] = none;
        return arrived;
    }
    // A column that is done: its entries are cancelled.
    void drop(std::uint32_t c) {
        for (std::uint32_t e = node(c)[3]; e != none; e = node(e)[3]) node(e)[1] = none;
        for (std::uint32_t e = local(c); e != none;) {
            const std::uint32_t following = next(e);
            give_back(e);
            e = following;
        }
        give_back(c);
        --columns_;
    }
    void give_back(std::uint32_t i) {
        next(i) = free_;
        free_ = i;
    }

private:
    static constexpr std::size_t node_words = 4 + ranks_max;
    static_assert(node_words >= 6, "a column must fit a node");

    std::uint32_t* node(std::uint32_t i) const {
        return reinterpret_cast<std::uint32_t*>(arena_->at(top_ - (std::size_t{i} + 1) * node_words * 4));
    }
    void unlink(std::uint32_t e) {
        const std::uint32_t* w = node(e);
        (w[2] == none ? node(w[1])[3] : node(w[2])[3]) = w[3];
        if (w[3] != none) node(w[3])[2] = w[2];
    }
    // Four nodes fill the arena's alignment, so the pieces are adjacent.
    std::uint32_t take() {
        if (free_ == none) {
            if (taken_ >= none - 8 || arena_->template take_high<std::uint32_t>(4 * node_words) == nullptr) return none;
            for (int i = 0; i < 4; ++i) give_back(taken_ + 3 - static_cast<std::uint32_t>(i));
            taken_ += 4;
        }
        const std::uint32_t i = free_;
        free_ = next(i);
        return i;
    }

    Arena* arena_ = nullptr;
    std::size_t top_ = 0;
    std::uint32_t* first_ = nullptr;  // [vertex_count] entries by rank of their highest vertex
    BitTree waiting_;
    std::uint32_t free_ = none, taken_ = 0, columns_ = 0;
};

}  // namespace netmesh
