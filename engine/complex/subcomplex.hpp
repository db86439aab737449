// A part of a triangulation: which of its simplices are in. No coordinates.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"
#include "numerics/random.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {

// A set of simplices of 1 to D vertices, given as ascending tuples, by open addressing. Its table stands at the arena's
// low end and is 3/8 to 3/4 full, 4 D bytes a slot; an empty set has none. What it contains does not depend on the
// order of insertion, and two simplices are equal only when all of their vertices are.
template <int D> class FaceSet {
public:
    FaceSet() = default;
    explicit FaceSet(DimensionOf<D> dim) : dim_(dim) {}
    // The same set, which stays where it is.
    template <int E>
    FaceSet(const FaceSet<E>& other, DimensionOf<D> dim)
        : table_(other.table_), slots_(other.slots_), count_(other.count_), dim_(dim) {}

    std::uint64_t count() const { return count_; }

    // Expected O(D).
    bool contains(const std::uint32_t* ascending, std::uint32_t n) const {
        return slots_ != 0 && row(place_of(ascending, n))[0] != none;
    }

    // Does nothing when the simplex is in. Doubles the table in place; for the time of that its old rows stand at the
    // high end too. False: out of memory, and the set is as before.
    // Requires: 1 <= n <= D; the table is the last piece at the low end of the arena, always of the same one.
    bool insert(const std::uint32_t* ascending, std::uint32_t n, Arena& arena) {
        NETMESH_ASSERT(1 <= n && n <= dim_);
        if (contains(ascending, n)) return true;
        if (4 * (count_ + 1) > 3 * std::uint64_t{slots_} && !grow(arena)) return false;
        put(ascending, n);
        ++count_;
        return true;
    }

    // Copies the table to the arena's high end and uses it there; nothing can be inserted after that. False: out of
    // memory, and the set is as before.
    bool move_high(Arena& arena) {
        if (slots_ == 0) return true;
        std::uint32_t* const high = arena.take_high<std::uint32_t>(slots_ * dim_);
        if (high == nullptr) return false;
        __builtin_memcpy(high, table_, slots_ * dim_ * sizeof(std::uint32_t));
        table_ = high;
        return true;
    }

private:
    template <int E> friend class FaceSet;
    static constexpr std::size_t slots_min = 64;

    std::uint32_t* row(std::size_t slot) const { return table_ + slot * dim_; }
    void clear() {
        for (std::size_t slot = 0; slot < slots_; ++slot) row(slot)[0] = none;
    }
    void put(const std::uint32_t* ascending, std::uint32_t n) {
        std::uint32_t* const to = row(place_of(ascending, n));
        for (std::uint32_t j = 0; j < dim_; ++j) to[j] = j < n ? ascending[j] : std::uint32_t{none};
    }

    // Where the simplex is or would be; some slot is free.
    std::size_t place_of(const std::uint32_t* ascending, std::uint32_t n) const {
        std::uint64_t hash = n;
        for (std::uint32_t j = 0; j < n; ++j) hash = mix64(hash ^ ascending[j]);
        for (std::size_t slot = static_cast<std::size_t>(hash);; ++slot) {
            slot &= slots_ - 1;
            const std::uint32_t* const is = row(slot);
            if (is[0] == none) return slot;
            std::uint32_t j = 0;
            while (j < n && is[j] == ascending[j]) ++j;
            if (j == n && (n == dim_ || is[n] == none)) return slot;
        }
    }

    bool grow(Arena& arena) {
        if (slots_ == 0) {
            table_ = arena.take_low<std::uint32_t>(slots_min * dim_);
            if (table_ == nullptr) return false;
            slots_ = slots_min;
            clear();
            return true;
        }
        const std::size_t words = slots_ * dim_, bytes = words * sizeof(std::uint32_t);
        NETMESH_ASSERT(arena.offset_of(table_) + bytes == arena.low_mark());
        const HighScope scope(arena);
        std::uint32_t* const old = arena.take_high<std::uint32_t>(words);
        if (old == nullptr || !arena.extend_low(bytes)) return false;
        __builtin_memcpy(old, table_, bytes);
        slots_ *= 2;
        clear();
        for (const std::uint32_t* from = old; from != old + words; from += dim_) {
            std::uint32_t n = 0;
            while (n < dim_ && from[n] != none) ++n;
            if (n > 0) put(from, n);
        }
        return true;
    }

    std::uint32_t* table_ = nullptr;  // [slots_][D], filled up with `none`; all `none`: a free slot
    std::size_t slots_ = 0;           // a power of two, or 0
    std::uint64_t count_ = 0;
    DimensionOf<D> dim_ = {};
};

// How much of the star of a vertex is in a part: nothing, some of it and the vertex, all of it.
struct VertexPart {
    static constexpr std::uint8_t absent = 0, cut = 1, whole = 2;
};

// A simplex of at most D vertices is in when a cell of it is in or `faces` contains it (it may contain faces of such
// cells too). Closed: all faces of a simplex that is in are in.
template <int D> struct Subcomplex {
    const std::uint8_t* cell;    // [cell_count] 1: the cell and all its faces are in
    FaceSet<D> faces;            // at least those faces that are in though no cell of theirs is
    const std::uint8_t* vertex;  // [vertex_count] VertexPart

    // The same part, its dimension a number or not.
    template <int E> Subcomplex<E> of_dimension(DimensionOf<E> dim) const { return {cell, {faces, dim}, vertex}; }
};
using AnyPart = Subcomplex<any_dimension>;

}  // namespace netmesh
