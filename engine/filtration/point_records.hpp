// The points of listed faces.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/faces.hpp"
#include "memory/arena.hpp"
#include "memory/prefetch.hpp"
#include "numerics/bits.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

// Coordinates at the start of each record: of each vertex, or of each 0-face where the lists of faces follow an order.
struct PointRecords {
    const double* coordinates;
    std::ptrdiff_t stride_bytes;
    const double* operator[](std::uint32_t v) const {
        return reinterpret_cast<const double*>(reinterpret_cast<const unsigned char*>(coordinates) +
                                               static_cast<std::ptrdiff_t>(v) * stride_bytes);
    }
    // The points by ascending vertex, whatever the order of the vertex list. place: where each is in that.
    // last_vertex[D] is not read.
    template <int K, int D>
    void of_face(const Faces<D>& faces, std::uint32_t face, const double** point, std::uint32_t* place) const {
        std::uint32_t vertex[K + 1];
        if constexpr (lists_follow_order<D>) {
            static_assert(D < 5, "a vertex and a position fit into one word: there are at most 2^28 points");
            ends_of<K>(faces, face, vertex);
            std::uint32_t key[K + 1];
            for (std::uint32_t i = 0; i <= K; ++i) key[i] = faces.last_vertex[0][vertex[i]] << 3 | i;
            sort_small<K + 1>(key);
            for (int i = 0; i <= K; ++i) {
                place[i] = key[i] & 7;
                point[i] = (*this)[faces.follows_order() ? vertex[place[i]] : key[i] >> 3];
            }
        } else {
            if constexpr (K == D) {
                const std::uint32_t* const all = faces.facets_of(K, face);
                vertex[D] = faces.last_vertex[D - 1][all[0]];
                faces.vertices(D - 1, all[D], vertex);
            } else {
                faces.vertices(K, face, vertex);
            }
            for (int i = 0; i <= K; ++i) {
                place[i] = static_cast<std::uint32_t>(i);
                point[i] = (*this)[vertex[i]];
            }
        }
    }

    // Copies the points, so many numbers each, in this order to the arena's high end. False: out of memory.
    template <int numbers> bool put_in_order(const std::uint32_t* order, std::uint32_t count, Arena& arena) {
        double* const copy = arena.template take_high<double>(std::size_t{count} * numbers);
        if (copy == nullptr) return false;
        arena.each(count, 20, [=](std::uint64_t i) {
            constexpr std::uint32_t far = 24;
            if (i + far < count) prefetch((*this)[order[i + far]]);
            __builtin_memcpy(copy + i * numbers, (*this)[order[i]], sizeof(double) * numbers);
        });
        coordinates = copy;
        stride_bytes = static_cast<std::ptrdiff_t>(sizeof(double) * numbers);
        return true;
    }

private:
    // The 0-faces of a face, from its first and its last edge; of one of five, the third from the edge between.
    template <int K, int D> static void ends_of(const Faces<D>& faces, std::uint32_t face, std::uint32_t* vertex) {
        std::uint32_t first = face, last = face, middle = face;
        for (int k = K; k > 1; --k) {
            if (k == 2) middle = faces.facets_of(2, first)[0];
            first = faces.facets_of(k, first)[k];
            last = faces.facets_of(k, last)[0];
        }
        const std::uint32_t *const two = faces.facets_of(1, first), *const others = faces.facets_of(1, last);
        if (K == 4) vertex[2] = faces.facets_of(1, middle)[0];
        vertex[K - 1] = others[1];
        vertex[K] = others[0];
        vertex[0] = two[1];
        vertex[1] = two[0];
    }
};

// Faces<D>, all of them, with the dimension as a number.
struct FaceTable {
    template <int D>
    explicit FaceTable(const Faces<D>& faces)
        : dim(D), count(faces.count), last_vertex(faces.last_vertex), facets(faces.facets),
          last_vertex_known_(!faces.follows_order()) {}
    const std::uint32_t* facets_of(int k, std::uint32_t face) const {
        return facets[k] + static_cast<std::size_t>(face) * static_cast<std::size_t>(k + 1);
    }

    // The points of a k-face by ascending vertex. The last vertex of a cell is that of the facet opposite its first
    // one, too.
    void points(const PointRecords& records, int k, std::uint32_t face, const double** point) const {
        std::uint32_t vertex[dimension_most() + 1];
        for (int i = k; i > 0; --i) {
            const std::uint32_t* const facet = facets_of(i, face);
            if (follows_order()) {
                vertex[i] = face;
                for (int j = i; j > 0; --j) vertex[i] = facets_of(j, vertex[i])[0];
            } else {
                vertex[i] = i == dim ? last_vertex[i - 1][facet[0]] : last_vertex[i][face];
            }
            face = facet[i];
        }
        vertex[0] = follows_order() ? face : last_vertex[0][face];
        if (follows_order())
            insertion_sort(vertex, static_cast<std::uint32_t>(k) + 1,
                           [this](std::uint32_t a, std::uint32_t b) { return last_vertex[0][a] < last_vertex[0][b]; });
        for (int i = 0; i <= k; ++i) point[i] = records[vertex[i]];
    }

    // Calls act(its dimension, its number) for each face of a k-face that lacks some of the vertices `within`, places
    // in its list of vertices, and no other; but for those below dimension `least`, 0 or 1.
    template <int least = 1, class Act>
    void each_without(std::uint32_t k, std::uint32_t face, std::uint32_t within, Act act) const {
        if (least == 1 && dimension_most() == 2) {
            for (std::uint32_t i = 0; i <= k && k == 2; ++i)
                if ((within >> i & 1u) != 0) act(1u, facets_of(2, face)[i]);
            return;
        }
        std::uint32_t without[2u << dimension_most()];
        without[0] = face;
        for (std::uint32_t absent = 0; absent != within;) {
            absent = (absent - within) & within;
            const std::uint32_t last = highest_bit(absent), others = absent ^ 1u << last, gone = count_bits(others);
            if (gone + least >= k) continue;
            without[absent] = facets_of(static_cast<int>(k - gone), without[others])[last - gone];
            act(k - gone - 1, without[absent]);
        }
    }

    const int dim;
    const std::uint32_t* const count;
    const std::uint32_t* const* const last_vertex;
    const std::uint32_t* const* const facets;

private:
    bool follows_order() const { return jumps_matter && !last_vertex_known_; }

    const bool last_vertex_known_;
};

}  // namespace netmesh
