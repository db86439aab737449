// Every face of a triangulated D-ball, once, with its boundary. No coordinates.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/triangulation.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// How faces are numbered. lexicographic: those of one dimension by their ascending vertex lists, so numbers depend on
// the set of cells alone, not on the order in which cells are stored. local: the same, but as if vertices were numbered
// as they are first met in the cells; faces that are near each other then mostly have near numbers, as cells mostly do,
// so that less jumps about in memory. Built for small size: always lexicographic.
enum class FaceNumbers { lexicographic, local };

// The faces of dimension 0..dimension_max, those of one dimension numbered densely. Vertex lists ascend, whatever the
// numbers are.
template <int D> struct Faces {
    int dimension_max;
    std::uint32_t count[D + 1];         // by dimension; 0 above dimension_max
    std::uint32_t* last_vertex[D + 1];  // [count[k]], the greatest vertex of each k-face
    std::uint32_t* facets[D + 1];       // k >= 1: [count[k]][k+1], entry i is the (k-1)-face opposite the i-th vertex

    const std::uint32_t* facets_of(int k, std::uint32_t face) const {
        return facets[k] + static_cast<std::size_t>(face) * static_cast<std::size_t>(k + 1);
    }
    // The k+1 vertices of a face, ascending. O(k).
    void vertices(int k, std::uint32_t face, std::uint32_t* out) const {
        for (; k > 0; --k) {
            out[k] = last_vertex[k][face];
            face = facets_of(k, face)[k];
        }
        out[0] = last_vertex[0][face];
    }
};

// Lists the faces of dimension 0..dimension_max (0 <= dimension_max <= D) of a triangulation whose neighbour words are
// not read. Vertices that are in no cell are no faces. `facets` is left at the low end of the arena, ascending in k;
// `last_vertex` at the high end, so that it can be released alone. Nothing else stays.
// With local numbers a 0-face is not its vertex: last_vertex[0] says which one it is.
// Cost: O(sum over cells of 2^(D+1)) and a few words a simplex of scratch: one word per vertex of a cell while stars
// are walked, about two words a face while boundaries are made.
// drops_complex: the cells are the last piece at the arena's low end; they are given back once they are read, in any
// case.
// out_of_memory, cancelled: the arena is as before and *out is not written. A dimension with 2^32 - 1 faces or more
// counts as out_of_memory.
template <int D>
Status enumerate_faces(const TriangulationView<D>& complex, int dimension_max, const Work& work, Faces<D>* out,
                       bool drops_complex = false, FaceNumbers numbers = FaceNumbers::lexicographic);

}  // namespace netmesh
