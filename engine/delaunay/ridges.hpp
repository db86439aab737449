// From four dimensions on: which new cells border each other. Each ridge of a cavity's boundary lies in two of its
// facets, so the second new cell at a ridge finds the first in a hash table. A part of kernel.cpp.
#pragma once
#include "delaunay/store.hpp"

namespace netmesh {

#ifndef __OPTIMIZE_SIZE__

// A ridge is looked up by the sum of its vertices' hashes, whatever order they come in, and known by a tag, a part of
// that sum. Two ridges that are taken for one are noticed: nothing is taken out and each ridge is looked for twice, so
// the slot that they share is found at least three times, which happens to no other.
template <int D> class RidgeTable {
public:
    // In the gap, below what takes its first `above` bytes, a multiple of 8; no table where the gap is too small, were
    // `cells` cells made.
    RidgeTable(const Store<D>& store, std::uint32_t cells, std::size_t above) {
        int bits = 4;
        while ((std::size_t{1} << bits) < std::size_t{2 * D} * cells) ++bits;
        const Arena& arena = store.arena;
        const std::size_t bytes = sizeof(Slot) << bits, below = above + bytes;
        if (below + cells * sizeof(Cell<D>) > arena.high_mark() - arena.low_mark()) return;
        slots_ = reinterpret_cast<Slot*>(arena.at(arena.high_mark() - below));
        shift_ = 64 - bits;
        __builtin_memset(slots_, 0xFF, bytes);
    }
    bool is_there() const { return slots_ != nullptr; }
    // False: ridges were taken for one another, and nothing that has been linked counts.
    bool is_sound() const { return !mistaken_; }

    // Links new cell `made` to those of the cells before it that border it at the new vertex, which has position i. It
    // cannot be predicted which do, so all cells are treated as if there were one.
    void join(Cell<D>* cells, CellId made, std::uint32_t i) {
        Cell<D>& fresh = cells[made];
        std::uint64_t hash[D + 1], facet = 0;
        for (std::uint32_t j = 0; j <= D; ++j) facet += hash[j] = hash_of(fresh.vertex[j]);
        facet -= hash[i];
        const FacetId outer = fresh.neighbour[i];
        Slot* const slots = slots_;
        const std::uint64_t last = ~std::uint64_t{0} >> shift_;
        std::uint32_t mistaken = 0;
        for (std::uint32_t k = 0; k < D; ++k) {
            const std::uint32_t j = k + (k >= i);
            const std::uint64_t key = facet - hash[j];
            const std::uint32_t tag = static_cast<std::uint32_t>(key) & ~1u;
            std::uint64_t s = key >> shift_;
            while (is_for_another(slots[s].tag, tag)) s = (s + 1) & last;
            const std::uint32_t other = slots[s].facet.word(), second = 0u - (slots[s].tag == tag);
            const std::uint32_t alone = 0u - (other == FacetId(none).word());
            mistaken |= second & alone;
            slots[s].tag = tag;
            slots[s].facet = FacetId::from_word(FacetId(made, j).word() | second);
            fresh.neighbour[j] = FacetId::from_word(other);
            const FacetId back = FacetId::from_word((other & ~alone) | (FacetId(made, i).word() & alone));
            cells[back.cell()].neighbour[back.position()] = FacetId(made, j);
        }
        fresh.neighbour[i] = outer;
        mistaken_ |= mistaken != 0;
    }

private:
    static constexpr std::uint32_t vacant = ~0u;
    struct Slot {
        std::uint32_t tag;  // even, or `vacant`
        FacetId facet;      // the first one at the ridge, `none` when there was a second one
    };
    static std::uint64_t hash_of(VertexId v) {
        const std::uint64_t x = (std::uint64_t{v} + 1) * 0x9E3779B97F4A7C15u;
        return (x ^ x >> 32) * 0xBF58476D1CE4E5B9u;
    }
    // One condition, as a product is 0 either way.
    static bool is_for_another(std::uint32_t taken, std::uint32_t tag) {
        return std::uint64_t{taken ^ vacant} * (taken ^ tag) != 0;
    }

    Slot* slots_ = nullptr;
    int shift_ = 0;
    bool mistaken_ = false;
};

#endif

}  // namespace netmesh
