// Columns of a Rips complex of one dimension p under reduction: the cofaces of p-simplices, made from the edges
// whenever they are needed. The column at work is a heap of cofaces, or of many edges their matrix (edge_sum.hpp); a
// column that additions have changed is kept as the simplices whose cofaces were added.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/progress.hpp"
#include "homology/rips/edge_sum.hpp"
#include "homology/rips/key_heap.hpp"
#include "homology/rips/pivot_table.hpp"
#include "homology/rips/rips_simplices.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// For reduce_columns(). A pivot is owned by a column, or by the facet that it makes an apparent pair with, which is no
// column.
class RipsColumns {
public:
    RipsColumns(const RipsSimplices& simplices, Arena& arena, Progress& progress)
        : simplices_(simplices), arena_(arena), progress_(progress), heap_(arena), matrix_(simplices) {}

    // Columns `end`[-1], end[-2], .., end[-count] of p-simplices. From then on the arena's high end belongs to the
    // reduction. False: out of memory.
    bool begin(std::uint32_t p, const std::uint64_t* end, std::uint32_t count) {
        p_ = p;
        columns_ = end;
        many_ = matrix_.additions_of_a_heap();
        if (!pivots_.open(count, arena_)) return false;
        added_at_ = arena_.take_high<std::uint32_t>(count);
        added_ = reinterpret_cast<std::uint64_t*>(arena_.at(arena_.high_mark()));
        added_words_ = 0;
        return added_at_ != nullptr;
    }
    std::uint64_t column(std::uint32_t j) const { return columns_[-1 - static_cast<std::ptrdiff_t>(j)]; }
    PivotTable& pivots() { return pivots_; }

    Status open(std::uint32_t j) {
        at_work_ = j;
        is_matrix_ = false;
        adding_ = 0;
        heap_.open();
        RipsSimplex s;
        simplices_.read(column(j), p_, &s);
        const std::uint64_t first = simplices_.first_coface(s);
        if (first != no_key) {  // an emergent pair if nobody owns it: no coface comes before
            look_at(first);
            if (!has_owner()) return Status::ok;
        }
        return push_cofaces(s) ? take_pivot() : Status::out_of_memory;
    }
    bool has_owner() const { return pivot_.key != no_key && (owner_ != none || facet_ != no_key); }
    Status add_owner() {
        if (p_ == 1 && !is_matrix_ && adding_ + additions_of(owner_) >= many_ && !turn_into_matrix())
            return Status::out_of_memory;
        if (!is_matrix_ && !heap_.push(pivot_.key)) return Status::out_of_memory;
        return add_owning_column() ? take_pivot() : Status::out_of_memory;
    }
    bool is_zero() const { return pivot_.key == no_key; }
    std::uint64_t pivot() const { return pivot_.key; }

    // Column j, reduced, becomes the owner of its pivot. False: out of memory.
    bool own_pivot(std::uint32_t j) {
        if (is_matrix_ && !list_matrix(j)) return false;
        heap_.close();
        pivots_.insert(pivot_.key, j);
        return keep_added(j);
    }
    // The column at work was zero.
    void forget() {
        heap_.close();
        arena_.release_high(arena_.high_mark() + sizeof *added_ * static_cast<std::size_t>(adding_));
    }

#ifdef NETMESH_VALIDATE
    // The pivot of column j, the last one, is that of R = D V, added up anew, and nobody else's.
    const char* violation(std::uint32_t j) const {
        if (is_zero()) return nullptr;
        if (pivots_.find(pivot()) != j) return "a pivot is not owned by its column";
        SmallChain sum;
        add_cofaces(column(j), sum);
        const std::uint64_t* const list = added_ - added_at_[j];
        const std::uint64_t count = additions_of(j);
        for (std::uint64_t i = 1; i <= count && sum.is_known(); ++i) add_cofaces(list[i], sum);
        if (sum.is_known() && sum.least() != pivot()) return "a column owns a pivot that is not its own";
        return pivots_.violation();
    }
#endif

private:
#ifdef NETMESH_VALIDATE
    void add_cofaces(std::uint64_t key, SmallChain& sum) const {
        RipsSimplex s;
        simplices_.read(key, p_, &s);
        simplices_.each_coface(s, [&sum](std::uint64_t coface) {
            sum.toggle(coface);
            return true;
        });
    }
#endif
    // Makes `key` the pivot and finds its owner.
    void look_at(std::uint64_t key) {
        simplices_.read(key, p_ + 1, &pivot_);
        owner_ = pivots_.find(key);
        facet_ = owner_ == none ? simplices_.apparent_facet(pivot_) : no_key;
    }
    // The pivot is taken out of the heap.
    Status take_pivot() {
        if (progress_.stop(1 + work_)) return Status::cancelled;
        work_ = 0;
        if (is_matrix_) {
            const Status status = search_matrix();
            if (status != Status::ok) return status;
        } else {
            pivot_.key = heap_.pop_pivot();
        }
        if (pivot_.key != no_key) look_at(pivot_.key);
        return Status::ok;
    }
    // Makes the first triangle of the matrix the pivot's key. There is none before the pivot that was.
    [[gnu::noinline]] Status search_matrix() {
        constexpr std::uint32_t piece = 256;
        std::uint32_t e = simplices_.edge_of(pivot_.key);
        for (pivot_.key = no_key; pivot_.key == no_key && e < simplices_.edges();) {
            const std::uint32_t end = simplices_.edges() - e < piece ? simplices_.edges() : e + piece;
            pivot_.key = matrix_.first(e, end);
            e = end;
            if (progress_.stop(16 + simplices_.vertices() / 16)) return Status::cancelled;
        }
        return Status::ok;
    }
    // A column of edges goes on as a matrix. False: out of memory.
    [[gnu::noinline]] bool turn_into_matrix() {
        heap_.close();
        if (!matrix_.open(arena_)) return false;
        is_matrix_ = true;
        matrix_.toggle(simplices_.edge_of(column(at_work_)));
        arena_.each(adding_, 20, [this](std::uint64_t i) {
            matrix_.toggle(simplices_.edge_of(added_[-1 - static_cast<std::ptrdiff_t>(added_words_ + i)]));
        });
        arena_.release_high(arena_.high_mark() + sizeof *added_ * static_cast<std::size_t>(adding_));
        adding_ = 0;
        return true;
    }
    // The edges of the matrix become the list of what was added to column j. False: out of memory.
    [[gnu::noinline]] bool list_matrix(std::uint32_t j) {
        matrix_.toggle(simplices_.edge_of(column(j)));
        bool fits = true;
        arena_.each(simplices_.vertices(), 2 + simplices_.vertices() / 16, [&](std::uint64_t v) {
            fits = fits && matrix_.each_edge(static_cast<std::uint32_t>(v), [this](std::uint32_t edge) {
                if (!arena_.extend_high(sizeof *added_)) return false;
                const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(added_words_ + adding_++);
                added_[-1 - at] = simplices_.key_of(edge, nullptr, 0);
                return true;
            });
        });
        return fits;
    }
    // Adds the cofaces of a p-simplex to the column at work and notes it. False: out of memory.
    bool add(std::uint64_t key) {
        if (is_matrix_) {
            matrix_.toggle(simplices_.edge_of(key));
            ++work_;
            return true;
        }
        if (!arena_.extend_high(sizeof key)) return false;
        added_[-1 - static_cast<std::ptrdiff_t>(added_words_ + adding_++)] = key;
        RipsSimplex s;
        simplices_.read(key, p_, &s);
        return push_cofaces(s);
    }
    // Once in the program: it is large, and a call of it visits all vertices.
    [[gnu::noinline]] bool push_cofaces(const RipsSimplex& s) {
        arena_.pass(1 + simplices_.cost_of(s.vertex, s.count));
        return simplices_.each_coface(s, [this](std::uint64_t coface) { return heap_.push(coface); });
    }
    // How many simplices were added to column j; 0 of no column.
    std::uint64_t additions_of(std::uint32_t j) const {
        const std::uint32_t at = j == none ? 0 : added_at_[j];
        return at == 0 ? 0 : added_[-static_cast<std::ptrdiff_t>(at)];
    }
    bool add_owning_column() {
        if (owner_ == none) return add(facet_);
        if (!add(column(owner_))) return false;
        const std::uint64_t* const list = added_ - added_at_[owner_];
        const std::uint64_t count = additions_of(owner_);
        for (std::uint64_t i = 1; i <= count; ++i) {
            arena_.step(i, 20);
            if (!add(list[i])) return false;
        }
        return true;
    }
    // The list of what was added to column j, without what was added twice. False: out of memory.
    bool keep_added(std::uint32_t j) {
        std::uint64_t* const list = added_ - added_words_ - adding_;
        sort(list, adding_, [](std::uint64_t a, std::uint64_t b) { return a < b; });
        std::uint64_t kept = 0;
        for (std::uint64_t i = 0; i < adding_; ++i) {
            if (kept > 0 && list[kept - 1] == list[i]) {
                --kept;
            } else {
                list[kept++] = list[i];
            }
        }
        __builtin_memmove(list + (adding_ - kept), list, sizeof *list * static_cast<std::size_t>(kept));
        arena_.release_high(arena_.high_mark() + sizeof *list * static_cast<std::size_t>(adding_ - kept));
        added_at_[j] = 0;
        if (kept == 0) return true;
        if (added_words_ + kept + 1 >= none || !arena_.extend_high(sizeof *list)) return false;
        added_words_ += kept + 1;
        added_[-static_cast<std::ptrdiff_t>(added_words_)] = kept;
        added_at_[j] = static_cast<std::uint32_t>(added_words_);
        return true;
    }

    const RipsSimplices& simplices_;
    Arena& arena_;
    Progress& progress_;
    KeyHeap heap_;
    PivotTable pivots_;
    std::uint32_t p_ = 0;
    const std::uint64_t* columns_ = nullptr;
    std::uint32_t* added_at_ = nullptr;           // [column] where the list of what was added to it is, 0: nothing
    std::uint64_t* added_ = nullptr;              // the end of these lists, which grow downwards: count, then keys
    std::uint64_t added_words_ = 0, adding_ = 0;  // in them; in the list of the column at work
    EdgeSum matrix_;                              // of the column at work when is_matrix_, where the heap was
    bool is_matrix_ = false;
    std::uint32_t at_work_ = 0;     // the column
    std::uint64_t many_ = 0;        // additions after which it becomes a matrix
    RipsSimplex pivot_;             // of the column at work; its key is no_key: zero
    std::uint32_t owner_ = none;    // of the pivot: a column or
    std::uint64_t facet_ = no_key;  // a simplex that is none
    std::uint32_t work_ = 0;
};

}  // namespace netmesh
