// A face with a vertex that is whole is in, one with a vertex that is absent is not. That leaves faces whose vertices
// are all cut. Of those the part lists some; the others that are in are found from the cells that are in.
#include "complex/faces_in_part.hpp"

#include "memory/arena.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

class FaceMarks {
public:
    FaceMarks(const AnyPart& part, int dim, const std::uint32_t* vertex_of, const AnyFaces& faces)
        : part_(part), dim_(dim), vertex_of_(vertex_of), faces_(faces) {}

    // At the arena's high end. False: out of memory.
    bool reserve(std::uint32_t vertex_count, Arena& arena) {
        name_of_ = arena.take_high<std::uint32_t>(vertex_count);
        if (name_of_ == nullptr) return false;
        for (std::uint32_t v = 0; v < vertex_count;)
            for (const std::uint64_t piece = arena.piece(v, vertex_count, 5); v < piece; ++v) {
                name_of_[vertex_of_[v]] = v;
            }
        for (int k = 0; k <= faces_.dimension_max; ++k) {
            mark_[k] = arena.take_high<std::uint8_t>(faces_.count[k]);
            if (mark_[k] == nullptr) return false;
        }
        return true;
    }
    // Every face by its vertices and by the list.
    void mark_faces(const Arena& arena) {
        for (int k = 0; k <= faces_.dimension_max; ++k) {
            for (std::uint32_t face = 0; face < faces_.count[k];)
                for (const std::uint64_t piece = arena.piece(face, faces_.count[k], 60); face < piece; ++face) {
                    const std::uint8_t last = part_.vertex[vertex_of_[faces_.last_vertex[k][face]]];
                    const std::uint8_t rest =
                        k > 0 ? mark_[k - 1][faces_.facets_of(k, face)[k]] : std::uint8_t{all_cut};
                    const bool whole = rest == in || last == VertexPart::whole;
                    mark_[k][face] = rest == 0 || last == VertexPart::absent ? 0 : whole ? in : all_cut;
                    if (mark_[k][face] == all_cut && (k == 0 || is_listed(k, face))) mark_[k][face] |= in;
                }
        }
    }
    // The faces of a cell that is in.
    void mark_cell(const VertexId* cell) {
        std::uint32_t name[dimension_most() + 1], n = 0,
                                                  found[2u << dimension_most()];  // found: the face of each set of them
        for (int i = 0; i <= dim_; ++i) {
            if (part_.vertex[cell[i]] == VertexPart::cut) name[n++] = name_of_[cell[i]];
        }
        insertion_sort(name, n, Ascending{});
        std::uint8_t size[2u << dimension_most()] = {0};
        for (std::uint32_t j = 0; j < n; ++j) {
            for (std::uint32_t rest = 0, bit = 1u << j; rest < bit; ++rest) {
                size[rest | bit] = static_cast<std::uint8_t>(size[rest] + 1);
                if (size[rest] > faces_.dimension_max) continue;
                found[rest | bit] = find(size[rest], rest == 0 ? 0 : found[rest], name[j]);
                mark_[size[rest]][found[rest | bit]] |= in;
            }
        }
    }
    bool has(int k, std::uint32_t face) const { return (mark_[k][face] & in) != 0; }

private:
    enum : std::uint8_t { in = 1, all_cut = 2 };  // all_cut: so are its vertices

    bool is_listed(int k, std::uint32_t face) const {
        if (k == dim_) return false;
        std::uint32_t vertices[dimension_most() + 1];
        faces_.vertices(k, face, vertices);
        for (int i = 0; i <= k; ++i) vertices[i] = vertex_of_[vertices[i]];
        insertion_sort(vertices, static_cast<std::uint32_t>(k + 1), Ascending{});
        return part_.faces.contains(vertices, static_cast<std::uint32_t>(k + 1));
    }
    // The k-face that adds a greatest vertex to a face, by halving: there is one.
    std::uint32_t find(int k, std::uint32_t first, std::uint32_t last) const {
        std::uint32_t low = 0, high = faces_.count[k];
        while (high - low > 1) {
            const std::uint32_t middle = low + (high - low) / 2;
            const std::uint32_t is = k > 0 ? faces_.facets_of(k, middle)[k] : 0;
            const bool later = is != first ? is > first : faces_.last_vertex[k][middle] > last;
            (later ? high : low) = middle;
        }
        return low;
    }

    const AnyPart& part_;
    const int dim_;
    const std::uint32_t* vertex_of_;
    const AnyFaces& faces_;
    std::uint32_t* name_of_ = nullptr;               // [vertex_count], of each vertex of the triangulation
    std::uint8_t* mark_[dimension_most() + 1] = {};  // [count[k]]
};

// Moves the faces that are in to the front, all dimensions end to end. number: room for two dimensions. False: out of
// memory.
bool move_faces(const FaceMarks& marks, std::uint32_t* const* number, Arena& arena, AnyFaces* faces) {
    if (faces->dimension_max > 0) arena.release_low(arena.offset_of(faces->facets[1]));
    for (int k = 0; k <= faces->dimension_max; ++k) {
        const std::uint32_t *const below = number[(k + 1) & 1], *const from = faces->facets[k];
        std::uint32_t *const own = number[k & 1], count = 0;
        for (std::uint32_t face = 0; face < faces->count[k];)
            for (const std::uint64_t piece = arena.piece(face, faces->count[k], 25); face < piece; ++face) {
                own[face] = count;
                count += marks.has(k, face) ? 1 : 0;
            }
        const std::size_t width = static_cast<std::size_t>(k) + 1;
        if (k > 0) faces->facets[k] = arena.take_low<std::uint32_t>(count * width);
        if (k > 0 && faces->facets[k] == nullptr) return false;
        for (std::uint32_t face = 0; face < faces->count[k];)
            for (const std::uint64_t piece = arena.piece(face, faces->count[k], 25); face < piece; ++face) {
                if (!marks.has(k, face)) continue;
                faces->last_vertex[k][own[face]] = faces->last_vertex[k][face];
                for (std::size_t i = 0; k > 0 && i < width; ++i)
                    faces->facets[k][own[face] * width + i] = below[from[face * width + i]];
            }
        faces->count[k] = count;
    }
    return true;
}

}  // namespace

Status keep_faces_in_part(const AnyPart& part, const TriangulationView<any_dimension>& triangulation,
                          const std::uint32_t* vertex_of, const Work& work, AnyFaces* faces) {
    const HighScope scope(work.arena);
    std::uint32_t most = 0;
    for (int k = 0; k <= faces->dimension_max; ++k) most = faces->count[k] > most ? faces->count[k] : most;
    std::uint32_t* number[2];
    for (std::uint32_t*& n : number) {
        n = work.arena.take_high<std::uint32_t>(most);
        if (n == nullptr) return Status::out_of_memory;
    }
    FaceMarks marks(part, static_cast<int>(std::uint32_t{triangulation.dim}), vertex_of, *faces);
    if (!marks.reserve(triangulation.vertex_count, work.arena)) return Status::out_of_memory;
    marks.mark_faces(work.arena);
    for (CellId c(0); c < triangulation.cell_count; ++c) {
        if (part.cell[c] != 0) marks.mark_cell(triangulation.vertices(c));
        if (work.monitor.advance(c, 1)) return Status::cancelled;
    }
    return move_faces(marks, number, work.arena, faces) ? Status::ok : Status::out_of_memory;
}

}  // namespace netmesh
