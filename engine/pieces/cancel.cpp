// Columns are reduced in their order by columns that have been cancelled. Let the lowest row of what comes out be p.
//
//   nothing is left        the column is the end of no class
//   p is in scope here     no column of another piece has it or will have it; and
//   and no column that     no earlier column that stays has it: then p and the column are a pair, whatever other
//   stays has p            pieces hold. Both are cancelled
//   else                   the column stays. Its other cancelled rows are removed, and its rows are from now on
//                          rows that a column that stays has
//
// Why it is a pair. Column operations from left to right keep the ranks of lower left parts of the matrix, and pairs
// depend on these alone. Let the columns before t, reduced in whatever way, have a sum whose lowest row is s, the
// lowest row of t. The columns of the sum that were cancelled with lowest rows greater than s: let p be the greatest of
// these rows. Something else in the sum has p. Not a column of another piece, as p is in scope here; not one that
// stays: not an earlier one, or p would have been a row that a column that stays has, nor a later one, from which p was
// removed. So there are none, and the same holds of s itself.
//
// Rows of columns that are ends of classes are left out wherever they occur: they are never lowest rows of reduced
// columns.
//
// Where a column has no more than two rows both are found as in union-find: a cancelled row leads to the other row of
// the column that it was cancelled with. A column whose rows are connected by earlier columns, whether those stay or
// not, is a sum of them and the end of no class.
//
// At the top the same is done to coboundaries from the last facet to the first: rows are cells, the lowest one is the
// first, and outside is above all.
#include "pieces/cancel.hpp"

#include "homology/bit_set.hpp"
#include "homology/bit_tree.hpp"
#include "homology/union_find.hpp"
#include "memory/prefetch.hpp"
#include "numerics/real.hpp"

namespace netmesh {
namespace {

class Cancellation {
public:
    Cancellation(Piece& piece, const Work& work) : piece_(piece), arena_(work.arena), monitor_(work.monitor) {}

    Status run() {
        const PieceJob& job = piece_.job;
        std::uint64_t columns = 0;
        std::uint32_t rows = 0;
        for (std::uint32_t k = 0; k <= job.top(); ++k) {
            columns += piece_.of[k].count;
            rows = piece_.of[k].count > rows ? piece_.of[k].count : rows;
        }
        monitor_.begin(NETMESH_STAGE_REDUCE, columns);
        one_ = arena_.take_high<std::uint32_t>(std::size_t{rows} + 1);
        other_ = arena_.take_high<std::uint32_t>(std::size_t{rows} + 1);
        std::uint64_t* const bits = arena_.take_high<std::uint64_t>(BitSet::words_needed(rows));
        tree_words_ = arena_.take_high<std::uint64_t>(BitTree::words_needed(rows > 0 ? rows : 1));
        Pair* const bars = arena_.take_high<Pair>(0);
        if (one_ == nullptr || other_ == nullptr || bits == nullptr || tree_words_ == nullptr || bars == nullptr)
            return Status::out_of_memory;
        bits_ = bits;
        bars_end_ = bars;
        Status status = Status::ok;
        if (job.has_cells()) status = cancel_cells();
        if (status == Status::ok) status = cancel_vertices();
        for (std::uint32_t k = job.middle_last(); k >= 2 && status == Status::ok; --k) status = cancel_columns(k);
        if (status == Status::ok && piece_.node == root_piece) status = finish();
        piece_.bars = bars_end_ - bar_count_;
        piece_.bar_count = bar_count_;
        return status;
    }

private:
    static void close(PieceSimplices& s, std::uint32_t i) { drop(s, i, piece_state::column | piece_state::row); }
    static void drop(PieceSimplices& s, std::uint32_t i, std::uint8_t what) {
        s.state[i] = static_cast<std::uint8_t>(s.state[i] & ~what);
    }
    bool is_here(const PieceSimplices& s, std::uint32_t i, std::uint8_t open) const {
        const std::uint8_t wanted = static_cast<std::uint8_t>(piece_state::original | open);
        return (s.state[i] & wanted) == wanted && is_below(s.home[i], piece_.node);
    }
    bool in_scope(const PieceSimplices& s, std::uint32_t i) const { return is_below(s.scope[i], piece_.node); }

    Status add_bar(double birth, double death, std::uint32_t degree) {
        if (degree > piece_.job.max_degree) return Status::ok;
        if (birth == death && (piece_.job.keep_zero == 0 || !(birth < infinity))) return Status::ok;
        if (!arena_.extend_high(sizeof(Pair))) return Status::out_of_memory;
        ++bar_count_;
        *(bars_end_ - bar_count_) = Pair{birth, death, degree, 0};
        return Status::ok;
    }

    // Two disjoint-set forests over rows: one_, along cancelled columns, and other_, along all.
    void begin_forests(std::uint32_t rows) {
        arena_.each(std::uint64_t{rows} + 1, 2,
                    [this](std::uint64_t i) { one_[i] = other_[i] = static_cast<std::uint32_t>(i); });
        touched_.adopt(bits_, rows);
    }

    static constexpr std::uint32_t far = 16;
    void prefetch_rows(const PieceSides& sides, std::uint32_t rows) const {
        for (const std::uint32_t i : sides.of) {
            if (!jumps_matter || i >= rows) continue;
            prefetch(one_ + i);
            prefetch(other_ + i);
        }
    }

    Status cancel_cells() {
        PieceSimplices& facets = piece_.of[piece_.job.dim - 1];
        PieceSimplices& cells = piece_.of[piece_.job.dim];
        const std::uint32_t outside = cells.count;
        begin_forests(outside);
        const auto is_older = [outside](std::uint32_t x, std::uint32_t y) {
            return x == outside || (y != outside && x > y);
        };
        for (std::uint32_t f = facets.count; f-- > 0;) {
            if (monitor_.advance(++done_, 1)) return Status::cancelled;
            if (f >= far) prefetch_rows(facets.sides[f - far], outside);
            if (!is_here(facets, f, piece_state::row)) continue;
            PieceSides& sides = facets.sides[f];
            std::uint32_t a = sides.of[0] == none ? outside : sides.of[0],
                          b = sides.of[1] == none ? outside : sides.of[1];
            std::uint32_t x = a, y = b;
            if (!unite(other_, x, y, is_older)) {
                drop(facets, f, piece_state::row);
                continue;
            }
            a = find_root(one_, a);
            b = find_root(one_, b);
            const std::uint32_t older = is_older(a, b) ? a : b, younger = older == a ? b : a;
            if (!touched_.has(younger) && in_scope(cells, younger)) {
                one_[younger] = older;
                const Status status = add_bar(facets.value[f], cells.value[younger], piece_.job.dim - 1);
                if (status != Status::ok) return status;
                close(facets, f);
                close(cells, younger);
                continue;
            }
            touched_.insert(younger);
            if (older != outside) touched_.insert(older);
            sides.of[0] = younger;
            sides.of[1] = older == outside ? std::uint32_t{none} : older;
        }
        return Status::ok;
    }

    Status cancel_vertices() {
        PieceSimplices& vertices = piece_.of[0];
        PieceSimplices& edges = piece_.of[1];
        begin_forests(vertices.count);
        const auto is_older = [](std::uint32_t x, std::uint32_t y) { return x < y; };
        for (std::uint32_t e = 0; e < edges.count; ++e) {
            if (monitor_.advance(++done_, 1)) return Status::cancelled;
            if (e + far < edges.count) prefetch_rows(edges.ends[e + far], vertices.count);
            if (!is_here(edges, e, piece_state::column)) continue;
            PieceSides& ends = edges.ends[e];
            std::uint32_t x = ends.of[0], y = ends.of[1];
            if (x == none || y == none) return Status::internal;
            if (!unite(other_, x, y, is_older)) {
                drop(edges, e, piece_state::column);
                continue;
            }
            const std::uint32_t a = find_root(one_, ends.of[0]), b = find_root(one_, ends.of[1]);
            const std::uint32_t older = a < b ? a : b, younger = a < b ? b : a;
            if (!touched_.has(younger) && in_scope(vertices, younger)) {
                one_[younger] = older;
                const Status status = add_bar(vertices.value[younger], edges.value[e], 0);
                if (status != Status::ok) return status;
                close(edges, e);
                close(vertices, younger);
                continue;
            }
            touched_.insert(younger);
            touched_.insert(older);
            ends = {{younger, older}};
        }
        return Status::ok;
    }

    // Boundaries of k-simplices that may have any number of rows.
    Status cancel_columns(std::uint32_t k) {
        PieceSimplices& rows = piece_.of[k - 1];
        PieceSimplices& columns = piece_.of[k];
        if (rows.count == 0) return Status::ok;
        std::uint32_t* const owner = one_;
        arena_.each(rows.count, 1, [owner](std::uint64_t i) { owner[i] = none; });
        arena_.each(columns.matched_count, 3, [owner, &columns](std::uint64_t i) {
            owner[columns.matched[i]] = columns.count + static_cast<std::uint32_t>(i);
        });
        touched_.adopt(bits_, rows.count);
        tree_.adopt(tree_words_, rows.count);
        for (std::uint32_t j = 0; j < columns.count; ++j) {
            if (monitor_.advance(++done_, 2)) return Status::cancelled;
            if (jumps_matter && j + 2 * far < columns.count) {
                prefetch(columns.columns[j + 2 * far].rows);
                const PieceColumn& later = columns.columns[j + far];
                for (std::uint32_t i = 0; i < later.count && i <= k; ++i) {
                    prefetch(rows.state + later.rows[i]);
                    prefetch(owner + later.rows[i]);
                }
            }
            if (!is_here(columns, j, piece_state::column)) continue;
            const Status status = cancel_column(k, j, owner);
            if (status != Status::ok) return status;
        }
        // A row that stays is closed only here: what has been cancelled above must find its way.
        for (std::uint32_t i = 0; i < rows.count; ++i) {
            if (owner[i] == none) continue;
            close(rows, i);
            if (owner[i] < columns.count) close(columns, owner[i]);
        }
        return Status::ok;
    }
    bool is_row(const PieceSimplices& rows, std::uint32_t i) const { return (rows.state[i] & piece_state::row) != 0; }
    void toggle(const PieceSimplices& rows, const PieceColumn& column) {
        for (std::uint32_t i = 0; i < column.count; ++i)
            if (is_row(rows, column.rows[i])) tree_.toggle(column.rows[i]);
        arena_.pass(1 + column.count / 16);
    }
    std::uint32_t lowest(const PieceSimplices& rows, const PieceColumn& column) const {
        std::uint32_t low = none;
        for (std::uint32_t i = 0; i < column.count; ++i) {
            const std::uint32_t r = column.rows[i];
            if (is_row(rows, r) && (low == none || r > low)) low = r;
        }
        return low;
    }
    bool can_cancel(const PieceSimplices& rows, std::uint32_t low) const {
        return !touched_.has(low) && in_scope(rows, low);
    }
    Status cancel_column(std::uint32_t k, std::uint32_t j, std::uint32_t* owner) {
        const PieceSimplices& rows = piece_.of[k - 1];
        PieceSimplices& columns = piece_.of[k];
        std::uint32_t low = lowest(rows, columns.columns[j]);
        const bool is_given = low != none && owner[low] == none;
        if (is_given && can_cancel(rows, low)) {
            owner[low] = j;
            return add_bar(rows.value[low], columns.value[j], k - 1);
        }
        toggle(rows, columns.columns[j]);
        while (low != none && owner[low] != none) {
            toggle(rows, columns.columns[owner[low]]);
            low = tree_.top();
        }
        if (low == none) {
            drop(columns, j, piece_state::column);
            return Status::ok;
        }
        const bool cancels = can_cancel(rows, low);
        if (!list_column(rows, columns, cancels ? nullptr : owner, &columns.columns[j])) return Status::out_of_memory;
        if (!cancels) return Status::ok;
        owner[low] = j;
        return add_bar(rows.value[low], columns.value[j], k - 1);
    }
    // Takes the column at work out of the tree. owner: cancelled rows are removed, and its rows are touched.
    bool list_column(const PieceSimplices& rows, const PieceSimplices& columns, const std::uint32_t* owner,
                     PieceColumn* out) {
        std::uint32_t* const first = arena_.take_low<std::uint32_t>(0);
        bool fits = first != nullptr;
        std::uint32_t count = 0, room = 0;
        while (!tree_.empty()) {
            const std::uint32_t r = tree_.top();
            if (owner != nullptr && owner[r] != none) {
                toggle(rows, columns.columns[owner[r]]);
                continue;
            }
            tree_.toggle(r);
            if (owner != nullptr) touched_.insert(r);
            if (count == room && fits) {
                fits = arena_.extend_low(2 * sizeof(std::uint32_t));
                room += 2;
            }
            if (fits) first[count++] = r;
        }
        if (fits) *out = {first, count};
        return fits;
    }
    // At the root all is decided: the first vertex alone is left.
    Status finish() {
        const PieceJob& job = piece_.job;
        for (std::uint32_t k = 0; k <= job.top(); ++k) {
            PieceSimplices& s = piece_.of[k];
            for (std::uint32_t i = 0; i < s.count; ++i) {
                if ((s.state[i] & piece_state::original) == 0) continue;
                if (k > 0 && (s.state[i] & piece_state::column) != 0) return Status::internal;
                const bool is_row = (s.state[i] & piece_state::row) != 0;
                if (k == 0 && is_row) {
                    const Status status = add_bar(s.value[i], infinity, 0);
                    if (status != Status::ok) return status;
                } else if (is_row && k < job.top()) {
                    return Status::internal;
                }
                close(s, i);
            }
        }
        return Status::ok;
    }

    Piece& piece_;
    Arena& arena_;
    Monitor& monitor_;
    std::uint32_t *one_ = nullptr, *other_ = nullptr;
    std::uint64_t *bits_ = nullptr, *tree_words_ = nullptr;
    BitSet touched_;
    BitTree tree_;
    Pair* bars_end_ = nullptr;
    std::uint64_t bar_count_ = 0, done_ = 0;
};

}  // namespace

Status cancel_pairs(Piece* piece, const Work& work) { return Cancellation(*piece, work).run(); }

}  // namespace netmesh
