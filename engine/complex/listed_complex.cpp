#include "complex/listed_complex.hpp"

#include "memory/arena.hpp"
#include "numerics/random.hpp"
#include "numerics/value_order.hpp"

namespace netmesh {
namespace {

// The simplices of one dimension by their vertices, open addressing. What is found does not depend on the order inside.
class SimplexTable {
public:
    // False: out of memory.
    bool begin(const std::uint32_t* rows, std::uint32_t count, std::uint32_t width, Arena& arena) {
        rows_ = rows;
        width_ = width;
        std::uint64_t slots = 16;
        while (slots < 2 * std::uint64_t{count}) slots *= 2;
        mask_ = slots - 1;
        slot_ = slots > SIZE_MAX / 8 ? nullptr : arena.take_high<std::uint32_t>(static_cast<std::size_t>(slots));
        for (std::uint64_t i = 0; i < slots && slot_ != nullptr;)
            for (const std::uint64_t piece = arena.piece(i, slots, 3); i < piece && slot_ != nullptr; ++i) {
                slot_[i] = none;
            }
        return slot_ != nullptr;
    }
    // The index of the equal row that is there already; none when it was added.
    std::uint32_t add(std::uint32_t index) {
        const std::uint64_t at = place_of(rows_ + std::size_t{index} * width_, width_);
        const std::uint32_t before = slot_[at];
        if (before == none) slot_[at] = index;
        return before;
    }
    // The row that equals `row` without entry `skip` (width entries or more: none is skipped).
    std::uint32_t find(const std::uint32_t* row, std::uint32_t skip) const { return slot_[place_of(row, skip)]; }

private:
    std::uint64_t place_of(const std::uint32_t* row, std::uint32_t skip) const {
        std::uint64_t hash = 0;
        for (std::uint32_t i = 0; i < width_; ++i) hash = mix64(hash + row[i + (i >= skip)] + 0x9E3779B97F4A7C15u);
        for (std::uint64_t at = hash & mask_;; at = (at + 1) & mask_) {
            if (slot_[at] == none || equal(rows_ + std::size_t{slot_[at]} * width_, row, skip)) return at;
        }
    }
    bool equal(const std::uint32_t* a, const std::uint32_t* row, std::uint32_t skip) const {
        for (std::uint32_t i = 0; i < width_; ++i) {
            if (a[i] != row[i + (i >= skip)]) return false;
        }
        return true;
    }

    const std::uint32_t* rows_ = nullptr;
    std::uint32_t width_ = 0;
    std::uint32_t* slot_ = nullptr;
    std::uint64_t mask_ = 0;
};

// Remembers the fault of lowest dimension, then index: dimensions come from the top down.
void note(ComplexFault* fault, ComplexFault::Kind kind, std::uint32_t k, std::uint32_t index, std::uint32_t other) {
    if (fault->kind == ComplexFault::nothing || k < fault->dimension ||
        (k == fault->dimension && index < fault->index)) {
        *fault = {kind, k, index, other};
    }
}

Status fill_table(const ListedComplex& complex, std::uint32_t k, bool check, Arena& arena, SimplexTable* table,
                  ComplexFault* fault) {
    if (!table->begin(complex.rows[k], complex.count[k], k + 1, arena)) return Status::out_of_memory;
    for (std::uint32_t i = 0; i < complex.count[k];)
        for (const std::uint64_t piece = arena.piece(i, complex.count[k], 80 + 30 * k); i < piece; ++i) {
            const std::uint32_t before = table->add(i);
            if (check && before != none) note(fault, ComplexFault::repeated, k, i, before);
        }
    return Status::ok;
}

void link_simplex(ListedComplex& complex, std::uint32_t k, std::uint32_t i, const SimplexTable& table, bool check,
                  ComplexFault* fault) {
    std::uint32_t vertices[ListedComplex::dimension_max + 1];
    std::uint32_t* const row = complex.rows[k] + std::size_t{i} * (k + 1);
    for (std::uint32_t v = 0; v <= k; ++v) vertices[v] = row[v];
    for (std::uint32_t v = 0; v <= k; ++v) {
        const std::uint32_t face = table.find(vertices, v);
        row[v] = face;
        if (!check) continue;
        if (face == none) {
            note(fault, ComplexFault::face_missing, k, i, v);
        } else if (complex.value[k - 1][face] > complex.value[k][i]) {
            note(fault, ComplexFault::face_later, k, i, face);
        }
    }
}

// Moves rows of `width` words so that row j is what row from[j] was. Sets the top bit of from.
void permute_rows(std::uint32_t* rows, std::uint32_t width, std::uint32_t* from, std::uint32_t count,
                  const Arena& arena) {
    constexpr std::uint32_t moved = 0x80000000u;
    std::uint32_t first[ListedComplex::dimension_max + 1];
    std::uint32_t done = 0;  // rows, as those of a cycle need not have all last digits
    for (std::uint32_t start = 0; start < count; ++start) {
        arena.step(start, 20 + 5 * width);
        if ((from[start] & moved) != 0) continue;
        for (std::uint32_t i = 0; i < width; ++i) first[i] = rows[std::size_t{start} * width + i];
        std::uint32_t at = start;
        for (;;) {
            const std::uint32_t next = from[at];
            arena.step(done++, 20 + 5 * width);
            from[at] = next | moved;
            const std::uint32_t* const source = next == start ? first : rows + std::size_t{next} * width;
            for (std::uint32_t i = 0; i < width; ++i) rows[std::size_t{at} * width + i] = source[i];
            if (next == start) break;
            at = next;
        }
    }
}

}  // namespace

FilteredComplex ListedComplex::filtered() const {
    FilteredComplex f = {};
    f.dimension = dimension;
    for (std::uint32_t k = 0; k <= dimension; ++k) f.of[k] = {count[k], rows[k], value[k]};
    return f;
}

Status link_faces(ListedComplex& complex, bool check, const Work& work, ComplexFault* fault) {
    *fault = {};
    std::uint64_t total = 0, done = 0;
    for (std::uint32_t k = 0; k <= complex.dimension; ++k) total += complex.count[k];
    work.monitor.begin(NETMESH_STAGE_FILTER, total);
    if (check) {
        const HighScope scope(work.arena);
        SimplexTable table;
        const Status status = fill_table(complex, complex.dimension, true, work.arena, &table, fault);
        if (status != Status::ok) return status;
    }
    for (std::uint32_t k = complex.dimension; k > 0; --k) {
        const HighScope scope(work.arena);
        SimplexTable table;
        const Status status = fill_table(complex, k - 1, check, work.arena, &table, fault);
        if (status != Status::ok) return status;
        for (std::uint32_t i = 0; i < complex.count[k]; ++i, ++done) {
            if (work.monitor.advance(done, 1 + k * (k + 1) / 4)) return Status::cancelled;
            link_simplex(complex, k, i, table, check, fault);
        }
    }
    return fault->kind == ComplexFault::nothing ? Status::ok : Status::check_failed;
}

Status order_dimension(ListedComplex& complex, std::uint32_t k, Arena& arena) {
    const HighScope scope(arena);
    const std::uint32_t count = complex.count[k];
    std::uint32_t* const from = arena.take_high<std::uint32_t>(count);
    if (from == nullptr || !sort_values(complex.value[k], from, count, arena)) return Status::out_of_memory;
    if (k < complex.dimension) {
        std::uint32_t* const place = arena.take_high<std::uint32_t>(count);
        if (place == nullptr) return Status::out_of_memory;
        for (std::uint32_t j = 0; j < count;)
            for (const std::uint64_t piece = arena.piece(j, count, 5); j < piece; ++j) {
                place[from[j]] = j;
            }
        std::uint32_t* const facets = complex.rows[k + 1];
        const std::size_t words = std::size_t{complex.count[k + 1]} * (k + 2);
        for (std::size_t i = 0; i < words;)
            for (const std::uint64_t piece = arena.piece(i, words, 5); i < piece; ++i) {
                facets[i] = place[facets[i]];
            }
    }
    permute_rows(complex.rows[k], k + 1, from, count, arena);
    return Status::ok;
}

Status order_beside(const double* value, std::uint32_t count, std::uint32_t* rows, std::uint32_t width, Arena& arena) {
    const HighScope scope(arena);
    std::uint32_t* const from = arena.take_high<std::uint32_t>(count);
    double* const sorted = arena.take_high<double>(count);
    if (from == nullptr || sorted == nullptr) return Status::out_of_memory;
    move_bytes(sorted, value, sizeof(double) * count, arena);
    if (!sort_values(sorted, from, count, arena)) return Status::out_of_memory;
    permute_rows(rows, width, from, count, arena);
    return Status::ok;
}

Status order_by_value(ListedComplex& complex, Arena& arena) {
    for (std::uint32_t k = 0; k <= complex.dimension; ++k) {
        const Status status = order_dimension(complex, k, arena);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

namespace {

// facet(d, simplex, i): facet i of a d-simplex.
template <class Facet>
void find_vertices(Facet facet, const std::uint32_t* labels, std::uint32_t k, std::uint32_t simplex,
                   std::uint32_t* vertices) {
    for (std::uint32_t i = 0; i <= k; ++i) {
        std::uint32_t at = simplex, d = k;
        for (; d > i; --d) at = facet(d, at, d);
        for (; d > 0; --d) at = facet(d, at, 0);
        vertices[i] = labels[at];
    }
}

}  // namespace

void vertices_of(const FilteredComplex& complex, const std::uint32_t* labels, std::uint32_t k, std::uint32_t simplex,
                 std::uint32_t* vertices) {
    find_vertices([&complex](std::uint32_t d, std::uint32_t at,
                             std::uint32_t i) { return complex.of[d].faces[std::size_t{at} * (d + 1) + i]; },
                  labels, k, simplex, vertices);
}

void vertices_of(const ListedComplex& complex, std::uint32_t k, std::uint32_t simplex, std::uint32_t* vertices) {
    find_vertices([&complex](std::uint32_t d, std::uint32_t at,
                             std::uint32_t i) { return complex.rows[d][std::size_t{at} * (d + 1) + i]; },
                  complex.rows[0], k, simplex, vertices);
}

}  // namespace netmesh
