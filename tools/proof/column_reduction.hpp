// The columns of a proof: a reduction of coboundary matrices, lowest degree first, which tells of each column what was
// added to it. See docs/proofs.md.
//
// A class Complex numbers the simplices of each dimension by keys, in their order, and has
//   no_key
//   each_column(p, f)        f(key) for the p-simplices that are in no shortcut pair, from the last to the first
//   each_coface(key, p, f)   f(key) for the cofaces of a p-simplex
//   shortcut_facet(key, q)   the facet that a q-simplex is in a shortcut pair with, or no_key
//   Matrix                   of edges, for sums of very many of them: EdgeMatrix or NoMatrix
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

#include "tools/proof/proof_bytes.hpp"

namespace netmesh::tool {

// From keys to numbers, by open addressing.
class KeyTable {
public:
    static constexpr std::uint32_t none = UINT32_MAX;

    KeyTable() : slots_(16, {~std::uint64_t{0}, none}) {}
    std::uint32_t find(std::uint64_t key) const { return slots_[place(key)].number; }
    void insert(std::uint64_t key, std::uint32_t number) {
        if (++count_ > slots_.size() / 2) {
            std::vector<Slot> old(2 * slots_.size(), {~std::uint64_t{0}, none});
            old.swap(slots_);
            for (const Slot& slot : old)
                if (slot.number != none) slots_[place(slot.key)] = slot;
        }
        slots_[place(key)] = {key, number};
    }

private:
    struct Slot {
        std::uint64_t key;
        std::uint32_t number;
    };
    std::size_t place(std::uint64_t key) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> 20) & mask;
        while (slots_[at].number != none && slots_[at].key != key) at = (at + 1) & mask;
        return at;
    }

    std::vector<Slot> slots_;
    std::size_t count_ = 0;
};

template <class Complex> class ColumnReduction {
public:
    using Key = std::uint64_t;
    // joins: which edges join two components.
    ColumnReduction(const Complex& complex, const std::vector<bool>& joins)
        : complex_(complex), joins_(joins), matrix_(complex) {}

    // Columns of dimension p, for p = 1, 2 and so on. Writes what is added to them.
    void reduce(std::uint32_t p, ProofBytes& out);

private:
    static constexpr Key no_key = Complex::no_key;
    struct Column {
        Key key;
        std::size_t begin, end;  // what is added, in added_
    };

    Key first_coface(Key key) const {
        Key first = no_key;
        complex_.each_coface(key, p_, [&](Key coface) { first = std::min(first, coface); });
        return first;
    }
    void add(Key key) {
        if (is_matrix_) return matrix_.toggle(key);
        work_.push_back(key);
        complex_.each_coface(key, p_, [&](Key coface) { heap_.push(coface); });
    }
    void add_column(const Column& column) {
        add(column.key);
        for (std::size_t i = column.begin; i < column.end; i++) add(added_[i]);
    }
    void turn_into_matrix(Key key) {
        matrix_.open();
        matrix_.toggle(key);
        for (const Key added : work_) matrix_.toggle(added);
        heap_ = {};
        is_matrix_ = true;
    }
    // The first one of the sum that is not before the pivot that was.
    Key take_pivot(Key before) {
        if (is_matrix_) return matrix_.first(before);
        while (!heap_.empty()) {
            const Key key = heap_.top();
            heap_.pop();
            if (heap_.empty() || heap_.top() != key) return key;
            heap_.pop();
        }
        return no_key;
    }
    Key reduce_column(Key key);
    void keep(Key key);

    const Complex& complex_;
    const std::vector<bool>& joins_;
    std::uint32_t p_ = 0;
    KeyTable pivots_, pivots_below_;  // owned by columns of this dimension, and of one less
    std::vector<Column> columns_;     // by descending keys
    std::vector<Key> added_;
    std::vector<Key> work_;  // what is added to the column at work, unless it is a matrix
    typename Complex::Matrix matrix_;
    bool is_matrix_ = false;
    std::priority_queue<Key, std::vector<Key>, std::greater<Key>> heap_;
};

// The pivot.
template <class Complex> std::uint64_t ColumnReduction<Complex>::reduce_column(Key key) {
    work_.clear();
    is_matrix_ = false;
    heap_ = {};
    Key pivot = first_coface(key);
    while (pivot != no_key) {
        const Key facet = complex_.shortcut_facet(pivot, p_ + 1);
        const std::uint32_t owner = facet == no_key ? pivots_.find(pivot) : KeyTable::none;
        if (facet == no_key && owner == KeyTable::none) break;
        const std::size_t more = facet != no_key ? 1 : 1 + columns_[owner].end - columns_[owner].begin;
        if (p_ == 1 && !is_matrix_ && work_.size() + more >= matrix_.many()) turn_into_matrix(key);
        if (!is_matrix_ && work_.empty())
            complex_.each_coface(key, p_, [&](Key coface) { heap_.push(coface); });
        else if (!is_matrix_)
            heap_.push(pivot);
        if (facet != no_key)
            add(facet);
        else
            add_column(columns_[owner]);
        pivot = take_pivot(pivot);
    }
    if (is_matrix_) {
        matrix_.toggle(key);
        work_.clear();
        matrix_.list(&work_);
    }
    return pivot;
}

// What was added twice was not added.
template <class Complex> void ColumnReduction<Complex>::keep(Key key) {
    std::sort(work_.begin(), work_.end());
    const std::size_t begin = added_.size();
    for (std::size_t i = 0; i < work_.size(); i++) {
        if (i + 1 < work_.size() && work_[i] == work_[i + 1])
            i++;
        else
            added_.push_back(work_[i]);
    }
    columns_.push_back({key, begin, added_.size()});
}

template <class Complex> void ColumnReduction<Complex>::reduce(std::uint32_t p, ProofBytes& out) {
    p_ = p;
    pivots_below_ = std::move(pivots_);
    pivots_ = {};
    columns_.clear();
    added_.clear();
    std::uint64_t plain = 0;
    const auto before = [](const Column& a, Key b) { return a.key > b; };
    complex_.each_column(p, [&](Key key) {
        // It ends a class: its column is zero.
        if (p == 1 ? bool{joins_[key]} : pivots_below_.find(key) != KeyTable::none) return;
        const Key pivot = reduce_column(key);
        keep(key);
        const auto number = static_cast<std::uint32_t>(columns_.size() - 1);
        if (pivot != no_key) pivots_.insert(pivot, number);
        // Ascending keys are descending columns. What is no column is of a shortcut pair.
        std::vector<std::uint32_t> numbers;
        const Column& column = columns_.back();
        for (std::size_t i = column.begin; i < column.end; i++) {
            const auto at = std::lower_bound(columns_.begin(), columns_.end(), added_[i], before);
            if (at != columns_.end() && at->key == added_[i])
                numbers.push_back(static_cast<std::uint32_t>(at - columns_.begin()));
        }
        if (numbers.empty()) {
            plain++;
            return;
        }
        out.number(plain + 1);
        plain = 0;
        out.number(numbers.size() - 1);
        std::uint32_t last = number;
        for (const std::uint32_t n : numbers) {
            out.number(last - n - 1);
            last = n;
        }
    });
    out.number(0);
}

}  // namespace netmesh::tool
