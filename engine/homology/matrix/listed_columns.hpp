// Columns of a listed matrix under reduction: the column at work as a set of rows, the others as they are in the matrix
// or, where additions have changed them, in a store.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/filtered_complex.hpp"
#include "homology/bit_set.hpp"
#include "homology/bit_tree.hpp"
#include "homology/check_reduction.hpp"
#include "homology/matrix/column_store.hpp"
#include "homology/progress.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// A set of rows or columns that knows its size.
class CountedColumn {
public:
    void adopt(std::uint64_t* words, std::uint32_t size) {
        tree_.adopt(words, size);
        members_ = 0;
    }
    void toggle(std::uint32_t i) {
        members_ += tree_.has(i) ? ~std::uint64_t{0} : 1;
        tree_.toggle(i);
    }
    std::uint32_t top() const { return members_ == 0 ? none : tree_.top(); }
    std::uint64_t members() const { return members_; }
    // Moves the members, from the largest down, to rows[members()].
    void take(std::uint32_t* rows) {
        while (members_ > 0) {
            *rows = tree_.top();
            toggle(*rows++);
        }
    }
    void clear() {
        while (members_ > 0) toggle(tree_.top());
    }

private:
    BitTree tree_;
    std::uint64_t members_ = 0;
};

// Boundaries of k-simplices; rows that are `dropped` (null: none) count as absent.
struct BoundaryMatrix {
    FilteredComplex::Simplices simplices;
    std::uint32_t k;
    const BitSet* dropped;

    bool is_dropped(std::uint32_t row) const { return dropped != nullptr && dropped->has(row); }
    std::uint32_t pivot_of(std::uint32_t j) const {
        const std::uint32_t* const faces = simplices.faces + std::size_t{j} * (k + 1);
        std::uint32_t pivot = none;
        for (std::uint32_t i = 0; i <= k; ++i) {
            if ((pivot == none || faces[i] > pivot) && !is_dropped(faces[i])) pivot = faces[i];
        }
        return pivot;
    }
    // Adds column j. Returns the cost in the monitor's units.
    template <class Column> std::uint32_t add(std::uint32_t j, Column& to) const {
        const std::uint32_t* const faces = simplices.faces + std::size_t{j} * (k + 1);
        for (std::uint32_t i = 0; i <= k; ++i) {
            if (!is_dropped(faces[i])) to.toggle(faces[i]);
        }
        return 1;
    }
    // Adds column j, which has this pivot.
    template <class Column> std::uint32_t add_owner(std::uint32_t j, std::uint32_t, Column& to) const {
        return add(j, to);
    }
};

// Cofaces of k-simplices. Rows are numbered from the last (k+1)-simplex to the first, so that the pivot is the first.
struct CoboundaryMatrix {
    const std::uint32_t* start;   // [columns + 1]
    const std::uint32_t* coface;  // rows of column j, the pivot first: coface[start[j] .. start[j+1])

    std::uint32_t pivot_of(std::uint32_t j) const { return start[j] < start[j + 1] ? coface[start[j]] : none; }
    template <class Column> std::uint32_t add(std::uint32_t j, Column& to) const {
        for (std::uint32_t i = start[j]; i < start[j + 1]; ++i) to.toggle(coface[i]);
        return 1 + (start[j + 1] - start[j]) / 16;
    }
};

// A changed column is kept as what it has become.
struct KeptSums {
    using Column = CountedColumn;
    ColumnStore* store;

    template <class Matrix>
    std::uint32_t add(const Matrix& matrix, std::uint32_t owner, std::uint32_t pivot, Column& to) {
        if (owner < ColumnStore::stored) return matrix.add_owner(owner, pivot, to);
        const std::uint32_t* const column = store->column(owner);
        for (std::uint32_t i = 0; i < column[1]; ++i) to.toggle(column[2 + i]);
        return 1 + column[1] / 16;
    }
    // Keeps column j, which is reduced, and empties it. *owner becomes its name. False: out of memory.
    bool keep(std::uint32_t j, Column& column, std::uint32_t* owner) {
        *owner = j;
        if (column.members() == 0) return true;
        std::uint32_t* const rows = store->append(column.members(), j, owner);
        if (rows == nullptr) return false;
        column.take(rows);
        return true;
    }
    void forget() {}
#ifdef NETMESH_VALIDATE
    // Whether the kept column `owner` has the pivot `row`. It is the matrix's own, or its rows descend from there.
    template <class Matrix> bool has_pivot(const Matrix& matrix, std::uint32_t owner, std::uint32_t row) const {
        if (owner < ColumnStore::stored) return matrix.pivot_of(owner) == row;
        const std::uint32_t* const column = store->column(owner);
        for (std::uint32_t i = 1; i < column[1]; ++i)
            if (column[2 + i] >= column[1 + i]) return false;
        return column[1] > 0 && column[2] == row;
    }
#endif
};

// A changed column is kept as the columns that were added to it, of which there are fewer where columns are long.
struct KeptSources {
    using Column = BitTree;
    ColumnStore* store;
    CountedColumn sources;  // of the column at work

    template <class Matrix> std::uint32_t add(const Matrix& matrix, std::uint32_t owner, std::uint32_t, Column& to) {
        if (owner < ColumnStore::stored) return add_source(matrix, owner, to);
        const std::uint32_t* const column = store->column(owner);
        std::uint32_t work = add_source(matrix, column[0], to);
        for (std::uint32_t i = 0; i < column[1]; ++i) work += add_source(matrix, column[2 + i], to);
        return work;
    }
    bool keep(std::uint32_t j, Column& column, std::uint32_t* owner) {
        *owner = j;
        while (!column.empty()) column.toggle(column.top());
        if (sources.members() == 0) return true;
        std::uint32_t* const list = store->append(sources.members(), j, owner);
        if (list == nullptr) return false;
        sources.take(list);
        return true;
    }
    void forget() { sources.clear(); }
#ifdef NETMESH_VALIDATE
    // Whether the kept column `owner` has the pivot `row`: R = D V, added up anew.
    template <class Matrix> bool has_pivot(const Matrix& matrix, std::uint32_t owner, std::uint32_t row) const {
        SmallChain sum;
        const bool is_given = owner < ColumnStore::stored;
        const std::uint32_t* const column = is_given ? nullptr : store->column(owner);
        matrix.add(is_given ? owner : column[0], sum);
        for (std::uint32_t i = 0; !is_given && i < column[1]; ++i) matrix.add(column[2 + i], sum);
        return !sum.is_known() || sum.largest() == row;
    }
#endif

private:
    template <class Matrix> std::uint32_t add_source(const Matrix& matrix, std::uint32_t j, Column& to) {
        sources.toggle(j);
        return matrix.add(j, to);
    }
};

// Columns for reduce_columns().
template <class Matrix, class Kept> class ListedColumns {
public:
    using Column = typename Kept::Column;

    // owner: [rows], words: [BitTree::words_needed(rows)]. Nobody owns a row yet.
    ListedColumns(const Matrix& matrix, const Kept& kept, std::uint32_t rows, std::uint32_t* owner,
                  std::uint64_t* words, Progress& progress)
        : matrix_(matrix), kept_(kept), owner_(owner), progress_(progress) {
#ifdef NETMESH_VALIDATE
        rows_ = rows;
#endif
        column_.adopt(words, rows);
        for (std::uint32_t i = 0; i < rows; ++i) {
            if (i % 4096 == 0) progress.monitor.pass(32);
            owner_[i] = none;
        }
    }

    // A column is copied into the set of rows when something has to be added to it.
    Status open(std::uint32_t j) {
        if (progress_.stop(1)) return Status::cancelled;
        pivot_ = matrix_.pivot_of(j);
        if (has_owner()) matrix_.add(j, column_);
        return Status::ok;
    }
    bool has_owner() const { return pivot_ != none && owner_[pivot_] != none; }
    Status add_owner() {
        if (progress_.stop(kept_.add(matrix_, owner_[pivot_], pivot_, column_))) return Status::cancelled;
        pivot_ = column_.top();
        return Status::ok;
    }
    bool is_zero() const { return pivot_ == none; }
    std::uint32_t pivot() const { return pivot_; }
    std::uint32_t owner() const { return owner_[pivot_]; }

    // Keeps column j, reduced, as the owner of its pivot. False: out of memory.
    bool own_pivot(std::uint32_t j) { return kept_.keep(j, column_, &owner_[pivot_]); }
    // The column at work was zero.
    void forget() { kept_.forget(); }

    // The sum of columns that a boundary is: column j as it is in the matrix becomes the one at work, even if its pivot
    // is its own.
    void load(std::uint32_t j) {
        matrix_.add(j, column_);
        pivot_ = column_.top();
    }
    void clear() { column_.clear(); }
    // The column that owns the pivot, by its number.
    std::uint32_t owner_number() const {
        return owner() < ColumnStore::stored ? owner() : kept_.store->column(owner())[0];
    }
    // Whether column j was never changed and owns its pivot.
    bool is_given(std::uint32_t j) const { return owner_[matrix_.pivot_of(j)] == j; }

#ifdef NETMESH_VALIDATE
    // Pivots are those of the columns that own them, and no column owns two. In full for column j, the last one; the
    // others have been looked at when it was their turn. O(rows) and what column j takes.
    const char* violation(std::uint32_t j) const {
        if (column_.top() != none) return "the column at work was not emptied";
        if (rows_ > validated_columns_max) return nullptr;
        std::uint32_t owned = 0;
        for (std::uint32_t row = 0; row < rows_; ++row) {
            const std::uint32_t owner = owner_[row];
            if (owner == none || (owner < ColumnStore::stored ? owner : kept_.store->column(owner)[0]) != j) continue;
            if (++owned > 1) return "a column owns two pivots";
            if (!kept_.has_pivot(matrix_, owner, row)) return "a column owns a pivot that is not its own";
        }
        return nullptr;
    }
#endif

private:
    Matrix matrix_;
    Kept kept_;
    Column column_;
    std::uint32_t* owner_;
    Progress& progress_;
    std::uint32_t pivot_ = none;
#ifdef NETMESH_VALIDATE
    std::uint32_t rows_ = 0;
#endif
};

}  // namespace netmesh
