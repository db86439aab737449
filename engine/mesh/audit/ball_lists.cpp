#include "mesh/audit/ball_lists.hpp"

#include "delaunay/any_kernel.hpp"
#include "numerics/random.hpp"
#include "vocabulary/validate.hpp"

namespace netmesh {

Status BallLists::open(int dim, Arena& arena, std::uint32_t inputs) {
    dim_ = dim;
    arena_ = &arena;
    inputs_ = inputs;
    [[maybe_unused]] const std::size_t low = arena.low_mark();
    std::uint32_t** const arrays[] = {&first_of_input_, &ply_, &waiting_next_, &stamp_, &touches_};
    for (std::uint32_t** const array : arrays) {
        *array = arena.take_low<std::uint32_t>(inputs);
        if (*array == nullptr) return Status::out_of_memory;
    }
    NETMESH_ASSERT(arena.low_mark() - low <= input_bytes * inputs + 5 * Arena::alignment);
    for (std::uint32_t p = 0; p < inputs;)
        for (const std::uint64_t piece = arena.piece(p, inputs, 8); p < piece; ++p) {
            first_of_input_[p] = none;
            ply_[p] = stamp_[p] = touches_[p] = 0;
        }
    // How long the lists may become is a share of the block.
    arena.use_all();
    std::size_t entries = arena.bytes_free() / 4 / sizeof(Entry);
    const std::size_t enough = (std::size_t{inputs} + 256) << (2 * dim);
    if (entries > enough) entries = enough;
    if (entries >= none) entries = none - 1;
    entries_max_ = static_cast<std::uint32_t>(entries);
    Entry* const pool = arena.take_low<Entry>(entries);
    std::size_t cells = arena.bytes_free() / (AnyStore::cell_bytes(dim) + 2 * sizeof(std::uint32_t)) + 1;
    if (cells > FacetId::cells_max) cells = FacetId::cells_max;
    cells_max_ = static_cast<std::uint32_t>(cells);
    first_of_cell_ = arena.take_low<std::uint32_t>(cells);
    load_of_cell_ = arena.take_low<std::uint32_t>(cells);
    if (pool == nullptr || first_of_cell_ == nullptr || load_of_cell_ == nullptr) return Status::out_of_memory;
    entries_ = pool;
    return Status::ok;
}

bool BallLists::store(CellId cell, std::uint32_t input) {
    std::uint32_t e = free_;
    if (e != none)
        free_ = entries_[e].next_of_cell;
    else if (entries_used_ < entries_max_)
        e = entries_used_++;
    else {
        arena_->refuse(16 * sizeof(Entry));
        return false;
    }
    entries_[e] = {cell, input, first_of_cell_[cell], first_of_input_[input]};
    first_of_cell_[cell] = first_of_input_[input] = e;
    ++load_of_cell_[cell];
    if (++ply_[input] > ply_max_) ply_max_ = ply_[input];
    return true;
}

// Stores the input in the cell's ball if that contains it.
bool BallLists::consider(const AnyStore& mesh, CellId cell, std::uint32_t input) {
    arena_->step(++tests_, 60 * dim_);
    return !in_conflict(mesh, cell, VertexId(input)) || store(cell, input);
}

// A new cell, with nothing in its ball yet.
bool BallLists::open_ball(CellId cell) {
    if (cell >= cells_max_) {
        arena_->refuse(16 * sizeof(Entry));
        return false;
    }
    first_of_cell_[cell] = none;
    load_of_cell_[cell] = 0;
    return true;
}

bool BallLists::start(const AnyStore& mesh) {
    for (CellId c(0); c < mesh.state.cell_slots;)
        for (const std::uint64_t piece = arena_->piece(c, mesh.state.cell_slots, 30); c < piece; ++c) {
            if (!open_ball(c)) return false;
            if (!mesh.is_live(c) || mesh.is_ghost(c)) continue;
            for (std::uint32_t p = 0; p < inputs_; ++p)
                if (!consider(mesh, c, p)) return false;
        }
    starting_ = tests_;
    tests_ = 0;
    return true;
}

void BallLists::unlink_from_input(std::uint32_t entry) {
    const std::uint32_t input = entries_[entry].input;
    std::uint32_t* link = &first_of_input_[input];
    while (*link != entry) link = &entries_[*link].next_of_input;
    *link = entries_[entry].next_of_input;
    --ply_[input];
}

// One touch for each insertion. Stamps: now_ for inputs out of balls that are gone, now_ + 1 for other ones looked at.
void BallLists::touch(std::uint32_t input, std::uint32_t stamp) {
    stamp_[input] = stamp;
    ++touches_[input];
}

void BallLists::detach(const AnyStore& mesh, const Cavity& cavity, std::uint32_t v) {
    now_ += 2;
    waiting_ = none;
    if (v < inputs_) {
        ply_sum_ += ply_[v];
        ++located_;
    }
    for (std::uint32_t k = 0; k < cavity.cells; ++k) {
        const CellId c = cavity_cell(mesh, k);
        for (std::uint32_t e = first_of_cell_[c]; e != none;) {
            const std::uint32_t p = entries_[e].input, next = entries_[e].next_of_cell;
            arena_->step(e, 80);
            unlink_from_input(e);
            entries_[e].next_of_cell = free_;
            free_ = e;
            e = next;
            if (p == v || stamp_[p] == now_) continue;
            touch(p, now_);
            waiting_next_[p] = waiting_;
            waiting_ = p;
        }
        first_of_cell_[c] = none;
        load_of_cell_[c] = 0;
    }
}

bool BallLists::attach(const AnyStore& mesh, const Cavity& cavity, std::uint32_t v) {
    for (std::uint32_t k = 0; k < cavity.facets; ++k)
        if (!open_ball(new_cell(mesh, k))) return false;
    for (std::uint32_t k = 0; k < cavity.facets; ++k) {
        const CellId c = new_cell(mesh, k);
        const AnyCell cell = mesh.cell(c);
        for (std::uint32_t p = waiting_; p != none; p = waiting_next_[p])
            if (!consider(mesh, c, p)) return false;
        int i = 0;
        while (cell.vertex[i] != v) ++i;
        const CellId outer = cell.neighbour[i].cell();
        if (mesh.is_ghost(outer)) continue;
        for (std::uint32_t e = first_of_cell_[outer]; e != none; e = entries_[e].next_of_cell) {
            const std::uint32_t p = entries_[e].input;
            if (stamp_[p] == now_) continue;
            if (stamp_[p] != now_ + 1) touch(p, now_ + 1);
            if (!consider(mesh, c, p)) return false;
        }
    }
    return true;
}

bool BallLists::agrees(const AnyStore& mesh, const Cavity& cavity, std::uint32_t input) const {
    if (ply_[input] != cavity.cells) return false;
    for (std::uint32_t e = first_of_input_[input]; e != none; e = entries_[e].next_of_input) {
        std::uint32_t k = 0;
        while (k < cavity.cells && cavity_cell(mesh, k) != entries_[e].cell) ++k;
        if (k == cavity.cells) return false;
    }
    return true;
}

std::uint32_t BallLists::load(const AnyStore& mesh) const {
    std::uint32_t most = 0;
    for (CellId c(0); c < mesh.state.cell_slots;)
        for (const std::uint64_t piece = arena_->piece(c, mesh.state.cell_slots, 30); c < piece; ++c) {
            if (mesh.is_live(c) && !mesh.is_ghost(c) && load_of_cell_[c] > most) most = load_of_cell_[c];
        }
    return most;
}

std::uint32_t BallLists::draw_nets(const AnyStore& mesh, std::uint32_t most, std::uint64_t seed,
                                   std::uint32_t* chosen) {
    std::uint32_t count = 0;
    std::uint64_t random = mix64(seed);
    // From a range net of size O(D log D) (4.7.1 with epsilon = 1 / (2 D)) what is left out by chance is drawn again.
    const std::uint32_t net_size = 4 * static_cast<std::uint32_t>(dim_);
    now_ += 2;
    for (CellId c(0); c < mesh.state.cell_slots;)
        for (const std::uint64_t piece = arena_->piece(c, mesh.state.cell_slots, 30); c < piece; ++c) {
            if (!mesh.is_live(c) || mesh.is_ghost(c) || load_of_cell_[c] <= most) continue;
            std::uint32_t left = 0;  // not drawn yet
            for (std::uint32_t e = first_of_cell_[c]; e != none; e = entries_[e].next_of_cell)
                left += stamp_[entries_[e].input] != now_;
            const std::uint32_t drawn = load_of_cell_[c] - left;
            std::uint32_t wanted = drawn < net_size ? net_size - drawn : 0;
            for (std::uint32_t e = first_of_cell_[c]; e != none && wanted > 0; e = entries_[e].next_of_cell) {
                const std::uint32_t p = entries_[e].input;
                if (stamp_[p] == now_) continue;
                random = mix64(random);
                if (random % left-- >= wanted) continue;
                --wanted;
                stamp_[p] = now_;
                chosen[count++] = p;
            }
        }
    return count;
}

void BallLists::report(LocationAudit* audit) const {
    std::uint64_t touches = 0;
    audit->touches_max = 0;
    for (std::uint32_t p = 0; p < inputs_;)
        for (const std::uint64_t piece = arena_->piece(p, inputs_, 100); p < piece; ++p) {
            touches += touches_[p];
            if (touches_[p] > audit->touches_max) audit->touches_max = touches_[p];
        }
    audit->ply_max = ply_max_;
    audit->ply_mean = located_ > 0 ? static_cast<double>(ply_sum_) / located_ : 0;
    audit->touches_mean = static_cast<double>(touches) / inputs_;
    audit->tests_mean = static_cast<double>(tests_) / inputs_;
}

}  // namespace netmesh
