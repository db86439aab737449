// A boundary matrix whose rows have numbers of their own: what the loop of reduction.hpp asks of columns that stand as
// faces in the complex.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/matrix/reduction.hpp"
#include "memory/prefetch.hpp"

namespace netmesh {

// Whether a k-face has this facet an odd number of times.
inline bool is_in_boundary(const std::uint32_t* facets, std::uint32_t k, std::uint32_t facet) {
    std::uint32_t times = 0;
    for (std::uint32_t i = 0; i <= k; ++i) times += facets[i] == facet;
    return (times & 1u) != 0;
}

// Whether it has one more than once.
inline bool has_repeated_facets(const std::uint32_t* facets, std::uint32_t k) {
    bool found = false;
    for (std::uint32_t i = 1; i <= k; ++i)
        for (std::uint32_t other = 0; other < i; ++other) found |= facets[other] == facets[i];
    return found;
}

// Boundaries of k-faces. Rows have numbers of their own; faces without one count as absent. repeats: a face can be
// there more than once; twice is as good as not at all.
template <bool repeats = false> struct RankedMatrix {
    const std::uint32_t* faces;
    const std::uint32_t* rank;
    std::uint32_t k;
    // [rows][k], where jumps in memory matter: of a column that owns a row and is as it was, its other rows or none.
    std::uint32_t* others;
    bool has_any = repeats;  // such faces

    std::uint32_t pivot_of(std::uint32_t j) const {
        const std::uint32_t* const face = faces + std::size_t{j} * (k + 1);
        if (repeats && has_repeats(face)) return odd_pivot_of(face);
        std::uint32_t above = 0;  // rows + 1: 0 for none; no branches, which nobody could foresee
        for (std::uint32_t i = 0; i <= k; ++i) {
            const std::uint32_t next = rank[face[i]] + 1;
            above = next > above ? next : above;
        }
        return above - 1;
    }
    template <class Column> std::uint32_t add(std::uint32_t j, Column& to) const {
        const std::uint32_t* const face = faces + std::size_t{j} * (k + 1);
        for (std::uint32_t i = 0; i <= k; ++i) {
            const std::uint32_t row = rank[face[i]];
            if (row != none) to.toggle(row);
        }
        return 1;
    }
    template <class Column> std::uint32_t add_owner(std::uint32_t j, std::uint32_t pivot, Column& to) const {
        if (!jumps_matter) return add(j, to);
        to.toggle(pivot);
        const std::uint32_t* const other = others + std::size_t{pivot} * k;
        for (std::uint32_t i = 0; i < k; ++i) {
            if (other[i] != none) to.toggle(other[i]);
        }
        return 1;
    }
    bool has_repeats(const std::uint32_t* face) const { return has_any && has_repeated_facets(face, k); }
    [[gnu::noinline]] std::uint32_t odd_pivot_of(const std::uint32_t* face) const {
        std::uint32_t above = 0;
        for (std::uint32_t i = 0; i <= k; ++i) {
            const std::uint32_t next = rank[face[i]] + 1;
            if (next > above && is_in_boundary(face, k, face[i])) above = next;
        }
        return above - 1;
    }
    // Column j, as it is, owns its pivot.
    void note_owner(std::uint32_t j, std::uint32_t pivot) const {
        if (!jumps_matter) return;
        const std::uint32_t* const face = faces + std::size_t{j} * (k + 1);
        std::uint32_t* other = others + std::size_t{pivot} * k;
        for (std::uint32_t i = 0; i <= k; ++i) {
            const std::uint32_t row = rank[face[i]];
            if (row != pivot) *other++ = row;
        }
    }
};

}  // namespace netmesh
