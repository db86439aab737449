#include "pieces/join.hpp"

#include "numerics/random.hpp"
#include "pieces/cancel.hpp"

namespace netmesh {
namespace {

class Join {
public:
    explicit Join(const Work& work) : arena_(work.arena), work_(work) {}

    Status run(const netmesh_piece& one, const netmesh_piece& other, PieceBytes* out, const char** fault, int* at) {
        Status status = read(one, other, fault, at);
        if (status != Status::ok) return status;
        for (std::uint32_t k = 0; k <= top() && status == Status::ok; ++k) status = merge(k);
        for (std::uint32_t k = 1; k <= top() && status == Status::ok; ++k) status = make_columns(k);
        if (status == Status::ok) status = cancel_pairs(&piece_, work_);
        return status == Status::ok ? write_piece(piece_, work_, out) : status;
    }

private:
    std::uint32_t top() const { return piece_.job.top(); }

    Status read(const netmesh_piece& one, const netmesh_piece& other, const char** fault, int* at) {
        const netmesh_piece* const bytes[2] = {&one, &other};
        for (int i = 0; i < 2; ++i) {
            *at = i;
            Status status;
            *fault = read_piece(bytes[i]->bytes, bytes[i]->count, arena_, &part_[i], &status);
            if (*fault != nullptr) return Status::invalid_argument;
            if (status != Status::ok) return status;
        }
        if (!(part_[0].job == part_[1].job)) *fault = "the pieces are of different jobs";
        if (*fault == nullptr && (part_[0].node < 2 || (part_[0].node ^ 1u) != part_[1].node))
            *fault = "the pieces are not those of neighbours: nodes 2 n and 2 n + 1";
        if (*fault != nullptr) return Status::invalid_argument;
        if (part_[0].node > part_[1].node) {
            const Piece first = part_[1];
            part_[1] = part_[0];
            part_[0] = first;
        }
        piece_.job = part_[0].job;
        piece_.node = part_[0].node / 2;
        piece_.simplices = part_[0].simplices + part_[1].simplices;
        return Status::ok;
    }

    // The simplices of both in one order; those that both list become one.
    Status merge(std::uint32_t k) {
        const PieceSimplices &a = part_[0].of[k], &b = part_[1].of[k];
        const std::uint64_t most = std::uint64_t{a.count} + b.count;
        if (most >= none) return Status::out_of_memory;
        const auto room = static_cast<std::size_t>(most);
        PieceSimplices& s = piece_.of[k];
        number_[0][k] = arena_.take_low<std::uint32_t>(a.count);
        number_[1][k] = arena_.take_low<std::uint32_t>(b.count);
        s.value = arena_.take_low<double>(room);
        s.vertices = arena_.take_low<std::uint32_t>(room * (k + 1));
        s.home = arena_.take_low<PieceNode>(room);
        s.scope = arena_.take_low<PieceNode>(room);
        s.state = arena_.take_low<std::uint8_t>(room);
        if (number_[0][k] == nullptr || number_[1][k] == nullptr || s.value == nullptr || s.vertices == nullptr ||
            s.home == nullptr || s.scope == nullptr || s.state == nullptr)
            return Status::out_of_memory;
        s.count = 0;
        for (std::uint32_t i = 0, j = 0; i < a.count || j < b.count;) {
            arena_.step(i + j, 40);
            int which = i == a.count ? 1 : j == b.count ? -1 : 0;
            if (which == 0) {
                which = a.value[i] < b.value[j] ? -1 : a.value[i] > b.value[j] ? 1 : 0;
                if (which == 0) which = compare_vertices(a.vertices_of(k, i), b.vertices_of(k, j), k + 1);
            }
            if (which <= 0) number_[0][k][i] = s.count;
            if (which >= 0) number_[1][k][j] = s.count;
            const bool is_second = which > 0 || (which == 0 && (b.state[j] & piece_state::original) != 0);
            is_second ? append(k, b, j) : append(k, a, i);
            i += which <= 0;
            j += which >= 0;
        }
        return Status::ok;
    }
    void append(std::uint32_t k, const PieceSimplices& from, std::uint32_t i) {
        PieceSimplices& s = piece_.of[k];
        const std::uint32_t n = s.count++;
        s.value[n] = from.value[i];
        for (std::uint32_t j = 0; j <= k; ++j) s.vertices[std::size_t{n} * (k + 1) + j] = from.vertices_of(k, i)[j];
        s.home[n] = from.home[i];
        s.scope[n] = from.scope[i];
        // What is at home below and was not passed on is the end of a class.
        const bool is_gone = (from.state[i] & piece_state::original) == 0 && is_below(from.home[i], piece_.node);
        s.state[n] = is_gone ? std::uint8_t{0} : from.state[i];
    }

    std::uint32_t number_of(int part, std::uint32_t k, std::uint32_t i) const {
        return i == none ? std::uint32_t{none} : number_[part][k][i];
    }
    bool is_new(const PieceSimplices& s, std::uint32_t i) const {
        return s.home[i] == piece_.node && (s.state[i] & piece_state::original) != 0;
    }
    // Was it a column of that part, before?
    bool was_column(int part, const PieceSimplices& s, std::uint32_t i) const {
        return is_below(s.home[i], part_[part].node) && (s.state[i] & piece_state::original) != 0;
    }

    Status make_columns(std::uint32_t k) {
        const PieceJob& job = piece_.job;
        PieceSimplices& s = piece_.of[k];
        std::uint64_t entries = 0;
        if (job.has_ends(k)) s.ends = empty_sides(s.count);
        if (job.has_sides(k)) s.sides = empty_sides(s.count);
        if ((job.has_ends(k) && s.ends == nullptr) || (job.has_sides(k) && s.sides == nullptr))
            return Status::out_of_memory;
        if (job.is_middle(k)) {
            s.columns = arena_.take_low<PieceColumn>(s.count);
            if (s.columns == nullptr) return Status::out_of_memory;
            for (std::uint32_t i = 0; i < s.count; ++i) {
                s.columns[i] = {nullptr, 0};
                entries += is_new(s, i) ? k + 1 : 0;
            }
            for (const Piece& part : part_)
                for (std::uint32_t i = 0; i < part.of[k].count; ++i) entries += part.of[k].columns[i].count;
            entry_ = arena_.take_low<std::uint32_t>(static_cast<std::size_t>(entries));
            if (entry_ == nullptr) return Status::out_of_memory;
        }
        for (int part = 0; part < 2; ++part) take_over(part, k);
        return is_new_anywhere(s) ? begin_new(k) : Status::ok;
    }
    PieceSides* empty_sides(std::uint32_t count) {
        PieceSides* const sides = arena_.take_low<PieceSides>(count);
        if (sides != nullptr) arena_.each(count, 1, [sides](std::uint64_t i) { sides[i] = {{none, none}}; });
        return sides;
    }
    bool is_new_anywhere(const PieceSimplices& s) const {
        for (std::uint32_t i = 0; i < s.count; ++i)
            if (is_new(s, i)) return true;
        return false;
    }
    // Columns that stayed in a part.
    void take_over(int part, std::uint32_t k) {
        const PieceSimplices& from = part_[part].of[k];
        PieceSimplices& s = piece_.of[k];
        arena_.each(from.count, 12, [&](std::uint64_t index) {
            const auto i = static_cast<std::uint32_t>(index);
            const std::uint32_t n = number_[part][k][i];
            if ((from.state[i] & piece_state::original) == 0) return;
            if (s.sides != nullptr)
                for (int j = 0; j < 2; ++j) s.sides[n].of[j] = number_of(part, k + 1, from.sides[i].of[j]);
            if (!was_column(part, from, i)) return;
            if (s.ends != nullptr)
                for (int j = 0; j < 2; ++j) s.ends[n].of[j] = number_of(part, 0, from.ends[i].of[j]);
            if (s.columns == nullptr) return;
            s.columns[n] = {entry_, from.columns[i].count};
            for (std::uint32_t j = 0; j < from.columns[i].count; ++j)
                *entry_++ = number_[part][k - 1][from.columns[i].rows[j]];
        });
    }

    // Boundaries of simplices that are at home here, by the vertices of their facets.
    Status begin_new(std::uint32_t k) {
        PieceSimplices& s = piece_.of[k];
        if (s.ends == nullptr && s.columns == nullptr) return Status::ok;
        const HighScope scope(arena_);
        const PieceSimplices& below = piece_.of[k - 1];
        std::size_t slots = 16;
        while (slots < 2 * std::size_t{below.count}) slots *= 2;
        std::uint32_t* const table = arena_.take_high<std::uint32_t>(slots);
        if (table == nullptr) return Status::out_of_memory;
        arena_.each(slots, 1, [table](std::uint64_t i) { table[i] = none; });
        arena_.each(below.count, 30, [&](std::uint64_t i) {
            std::size_t at = hash_of(below.vertices_of(k - 1, static_cast<std::uint32_t>(i)), k) & (slots - 1);
            while (table[at] != none) at = (at + 1) & (slots - 1);
            table[at] = static_cast<std::uint32_t>(i);
        });
        const auto find = [&](const std::uint32_t* vertices) {
            std::size_t at = hash_of(vertices, k) & (slots - 1);
            while (table[at] != none && compare_vertices(below.vertices_of(k - 1, table[at]), vertices, k) != 0)
                at = (at + 1) & (slots - 1);
            return table[at];
        };
        for (std::uint32_t i = 0; i < s.count; ++i) {
            arena_.step(i, 40);
            if (!is_new(s, i)) continue;
            if (s.columns != nullptr) s.columns[i] = {entry_, 0};
            for (std::uint32_t without = 0; without <= k; ++without) {
                std::uint32_t facet[simplex_most];
                for (std::uint32_t j = 0, n = 0; j <= k; ++j)
                    if (j != without) facet[n++] = s.vertices_of(k, i)[j];
                const std::uint32_t found = find(facet);
                if (s.ends != nullptr) {
                    if (found == none) return Status::internal;
                    s.ends[i].of[without] = found;
                } else if (found != none) {  // else it is the end of a class
                    *entry_++ = found;
                    ++s.columns[i].count;
                }
            }
        }
        return Status::ok;
    }
    static std::uint64_t hash_of(const std::uint32_t* vertices, std::uint32_t count) {
        std::uint64_t hash = 0;
        for (std::uint32_t i = 0; i < count; ++i) hash = mix64(hash ^ vertices[i]) + i;
        return hash;
    }

    Arena& arena_;
    const Work& work_;
    Piece part_[2] = {}, piece_ = {};
    std::uint32_t* number_[2][simplex_most] = {};  // of a part's simplices among those of both
    std::uint32_t* entry_ = nullptr;
};

}  // namespace

Status join_pieces(const netmesh_piece& one, const netmesh_piece& other, const Work& work, PieceBytes* out,
                   const char** fault, int* at) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    *fault = nullptr;
    const Status status = Join(work).run(one, other, out, fault, at);
    work.arena.release_high(high);
    work.arena.release_low(low);
    return status == Status::ok ? move_piece_down(work.arena, out) : status;
}

}  // namespace netmesh
