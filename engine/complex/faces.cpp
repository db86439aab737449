// A face belongs to the star of its least vertex. Stars are walked one by one, by vertex or along an order, each depth
// first along ascending vertices:
//
//   v  ->  v w  ->  v w x ...        a node is a face; its children append one greater vertex
//
// and the children of every node are written to one stream in the order of the walk. The stream is then unfolded into
// one table a dimension, in which the children of a node lie together, ascending: a trie. Facet i of the face (p, x), p
// its first k vertices, is the child x of facet i of p, so boundaries come from boundaries one dimension below.
#include "complex/faces.hpp"

#include "complex/faces_along.hpp"
#include "complex/star_walk.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

constexpr std::uint32_t children_max = 0xFFFFFFFEu;

// Cells by vertex.
template <int D> struct Incidence {
    std::uint32_t* first;  // [vertex_count + 1]
    CellId* cell;          // [(D+1) * cell_count]
    std::uint32_t degree_max;
};

template <int D> bool build_incidence(const TriangulationView<D>& complex, Arena& arena, Incidence<D>* out) {
    const std::size_t n = complex.vertex_count;
    std::uint32_t* first = arena.take_high<std::uint32_t>(n + 1);
    CellId* cell = arena.take_high<CellId>(std::size_t{complex.cell_count} * (complex.dim + 1));
    if (first == nullptr || cell == nullptr) return false;
    arena.each(n + 1, 2, [first](std::uint64_t v) { first[v] = 0; });
    for (CellId c(0); c < complex.cell_count;)
        for (const std::uint64_t piece = arena.piece(c, complex.cell_count, 5 * (complex.dim + 1)); c < piece; ++c) {
            for (std::uint32_t i = 0; i <= complex.dim; ++i) ++first[complex.vertices(c)[i]];
        }
    std::uint32_t sum = 0, degree_max = 0;
    for (std::size_t v = 0; v < n;)
        for (const std::uint64_t piece = arena.piece(v, n, 8); v < piece; ++v) {
            if (first[v] > degree_max) degree_max = first[v];
            sum += first[v];
            first[v] = sum;
        }
    first[n] = sum;
    arena.each(complex.cell_count, 8 * (complex.dim + 1), [&](std::uint64_t k) {
        const CellId c(complex.cell_count - 1 - static_cast<std::uint32_t>(k));
        for (std::uint32_t i = 0; i <= complex.dim; ++i) cell[--first[complex.vertices(c)[i]]] = c;
    });
    *out = {first, cell, degree_max};
    return true;
}

// Asks for the cells of a star before they are needed: they are all over memory. Always inline, since a function that
// does nothing but prefetch is taken for one without effect and dropped.
template <int D>
__attribute__((always_inline)) inline void fetch_star(const TriangulationView<D>& complex,
                                                      const Incidence<D>& incidence, std::uint32_t v) {
    constexpr std::uint32_t ahead_max = jumps_matter ? 64 : 0;
    if (ahead_max == 0) return;
    const std::uint32_t begin = incidence.first[v], degree = incidence.first[v + 1] - begin;
    for (std::uint32_t i = 0; i < degree && i < ahead_max; ++i)
        __builtin_prefetch(complex.vertices(incidence.cell[begin + i]));
}

// Writes, for each used vertex, by number or along an order, the vertex and the records of its star; then `none`.
template <int D>
Status walk_stars(const TriangulationView<D>& complex, int dimension_max, const std::uint32_t* order, const Work& work,
                  WordStream& stream) {
    Incidence<D> incidence;
    StarWalk<D> star;
    const std::uint32_t count = complex.vertex_count;
    if (!build_incidence(complex, work.arena, &incidence)) return Status::out_of_memory;
    if (!star.reserve(complex, incidence.degree_max, dimension_max, work.arena)) return Status::out_of_memory;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t v = order == nullptr ? i : order[i];
        const std::uint32_t first = incidence.first[v], degree = incidence.first[v + 1] - first;
        if (i + 1 < count) fetch_star(complex, incidence, order == nullptr ? i + 1 : order[i + 1]);
        if (degree == 0) continue;
        if (!stream.reserve(1)) return Status::out_of_memory;
        stream.push(v);
        if (dimension_max > 0 && !star.walk(complex, v, incidence.cell + first, degree, stream))
            return Status::out_of_memory;
        if (work.monitor.advance(i, 1 + degree)) return Status::cancelled;
    }
    if (!stream.reserve(1)) return Status::out_of_memory;
    stream.push(none);
    return Status::ok;
}

// Where the children of each face start in the table one dimension up; one more entry at the end.
template <int D> struct Trie { std::uint32_t* first_child[DimensionOf<D>::most + 1]; };

// Reads the stream once. With `faces` null it only counts, else it fills last_vertex and first_child.
template <int D>
[[gnu::noinline]] bool unfold(DimensionOf<D> dim, const std::uint32_t* word, int dimension_max, std::uint32_t* count,
                              const Faces<D>* faces, const Trie<D>* trie, const Arena& arena) {
    std::uint32_t at[DimensionOf<D>::most + 2], end[DimensionOf<D>::most + 2];
    for (std::uint32_t k = 0; k <= dim; ++k) count[k] = 0;
    while (*word != none) {
        arena.pass(std::uint64_t{4} << dim);
        end[0] = count[0] + 1;
        at[0] = count[0]++;
        if (faces) faces->last_vertex[0][at[0]] = *word;
        ++word;
        for (int level = 0; level >= 0 && dimension_max > 0;) {
            if (at[level] == end[level]) {
                --level;
                continue;
            }
            const std::uint32_t face = at[level]++, start = count[level + 1];
            std::uint32_t next = start;
            if (*word == none) {
                ++word;
            } else {
                for (bool more = true; more; ++word, ++next) {
                    if (next == children_max) return false;
                    more = (*word & last_sibling) == 0;
                    if (faces) faces->last_vertex[level + 1][next] = *word & ~last_sibling;
                }
            }
            if (trie) trie->first_child[level][face] = start;
            count[level + 1] = next;
            if (level + 1 < dimension_max) {
                ++level;
                at[level] = start;
                end[level] = next;
            }
        }
    }
    if (trie)
        for (int k = 0; k < dimension_max; ++k) trie->first_child[k][count[k]] = count[k + 1];
    return true;
}

// Position of x in the ascending list a[from, to), which holds it. Galloping: O(log of the distance).
std::uint32_t seek(const std::uint32_t* a, std::uint32_t from, std::uint32_t to, std::uint32_t x) {
    if (a[from] >= x) return from;
    std::uint32_t low = from, step = 1;
    while (step < to - low && a[low + step] < x) {
        low += step;
        step *= 2;
    }
    std::uint32_t high = step < to - low ? low + step : to;
    while (high - low > 1) {
        const std::uint32_t middle = low + (high - low) / 2;
        if (a[middle] < x) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return high;
}

// Asks for what link_facets reads out of order: children of the facet opposite the first vertex, which is in another
// star than all the rest.
template <int D>
__attribute__((always_inline)) inline void fetch_children(const Faces<D>& faces, const Trie<D>& trie, int k,
                                                          std::uint32_t p) {
    constexpr std::uint32_t near = 8, far = 16;
    if (!jumps_matter || k < 2 || p + far >= faces.count[k - 1]) return;
    __builtin_prefetch(trie.first_child[k - 2] + faces.facets_of(k - 1, p + far)[0]);
    __builtin_prefetch(faces.last_vertex[k - 1] + trie.first_child[k - 2][faces.facets_of(k - 1, p + near)[0]]);
}

// Boundaries of the k-faces from those of the (k-1)-faces. place: the 0-face of each vertex; null where 0-faces ascend.
template <int D>
void link_facets(DimensionOf<D> dim, const Faces<D>& faces, const Trie<D>& trie, int k, std::uint32_t vertex_count,
                 const std::uint32_t* place, const Arena& arena) {
    const bool all_used = place == nullptr && faces.count[0] == vertex_count;
    const std::uint32_t* last = faces.last_vertex[k];
    std::uint32_t* facets = faces.facets[k];
    for (std::uint32_t p = 0; p < faces.count[k - 1];)
        for (const std::uint64_t piece = arena.piece(p, faces.count[k - 1], 60 * dim); p < piece; ++p) {
            const std::uint32_t begin = trie.first_child[k - 1][p], end = trie.first_child[k - 1][p + 1];
            fetch_children(faces, trie, k, p);
            std::uint32_t* const row = facets + static_cast<std::size_t>(begin) * static_cast<std::size_t>(k + 1);
            for (int i = 0; i < k; ++i) {
                const std::uint32_t f = k == 1 ? none : faces.facets_of(k - 1, p)[i];
                std::uint32_t at = k == 1 ? p : trie.first_child[k - 2][f];
                const std::uint32_t to = k == 1 ? faces.count[0] : trie.first_child[k - 2][f + 1];
                std::uint32_t* entry = row + i;
                for (std::uint32_t face = begin; face < end; ++face, entry += k + 1) {
                    if (k == 1 && place != nullptr) {
                        at = place[last[face]];
                    } else if (k == 1 && all_used) {
                        at = last[face];
                    } else {
                        at = seek(faces.last_vertex[k - 1], at, to, last[face]);
                    }
                    *entry = at;
                }
            }
            std::uint32_t* entry = row + k;
            for (std::uint32_t face = begin; face < end; ++face, entry += k + 1) *entry = p;
        }
}

template <int D>
Status enumerate(const TriangulationView<D>& complex, int dimension_max, std::uint32_t* order, const Work& work,
                 std::size_t low, Faces<D>* out) {
    const std::size_t high = work.arena.high_mark();
    WordStream stream(work.arena);
    const Status status = walk_stars(complex, dimension_max, order, work, stream);
    if (status != Status::ok) return status;
    work.arena.release_high(high);

    Faces<D> faces = {};
    Trie<D> trie = {};
    faces.dimension_max = dimension_max;
    if (!unfold<D>(complex.dim, stream.words(), dimension_max, faces.count, nullptr, nullptr, work.arena))
        return Status::out_of_memory;
    for (int k = 0; k <= dimension_max; ++k) {
        faces.last_vertex[k] = k == 0 && order != nullptr ? order : work.arena.take_high<std::uint32_t>(faces.count[k]);
        if (faces.last_vertex[k] == nullptr) return Status::out_of_memory;
    }
    const std::size_t high_kept = work.arena.high_mark();
    for (int k = 0; k < dimension_max; ++k) {
        trie.first_child[k] = work.arena.take_high<std::uint32_t>(static_cast<std::size_t>(faces.count[k]) + 1);
        if (trie.first_child[k] == nullptr) return Status::out_of_memory;
    }
    std::uint32_t* place = nullptr;
    if (order != nullptr) {
        place = work.arena.take_high<std::uint32_t>(complex.vertex_count);
        if (place == nullptr) return Status::out_of_memory;
    }
    std::uint32_t count[DimensionOf<D>::most + 1];
    unfold<D>(complex.dim, stream.words(), dimension_max, count, &faces, &trie, work.arena);
    work.arena.release_low(low);
    for (int k = 1; k <= dimension_max; ++k) {
        faces.facets[k] = work.arena.take_low<std::uint32_t>(static_cast<std::size_t>(faces.count[k]) *
                                                             static_cast<std::size_t>(k + 1));
        if (faces.facets[k] == nullptr) return Status::out_of_memory;
    }
    if (order != nullptr)
        work.arena.each(faces.count[0], 5,
                        [&](std::uint64_t i) { place[faces.last_vertex[0][i]] = static_cast<std::uint32_t>(i); });
    for (int k = 1; k <= dimension_max; ++k) {
        link_facets(complex.dim, faces, trie, k, complex.vertex_count, place, work.arena);
        if (work.monitor.advance(complex.vertex_count, 1)) return Status::cancelled;
    }
    work.arena.release_high(high_kept);
    *out = faces;
    return Status::ok;
}

// The same, for D or for all dimensions.
template <int D>
Status enumerate_shared(const TriangulationView<D>& complex, int dimension_max, std::uint32_t* order, const Work& work,
                        std::size_t low, Faces<D>* out) {
    if constexpr (shared_dimension<D> == D) {
        return enumerate(complex, dimension_max, order, work, low, out);
    } else {
        Faces<any_dimension> faces;
        const Status status =
            enumerate(complex.template of_dimension<any_dimension>(D), dimension_max, order, work, low, &faces);
        if (status != Status::ok) return status;
        *out = faces.template of_dimension<D>();
        return status;
    }
}

}  // namespace

template <int D>
Status enumerate_faces(const TriangulationView<D>& complex, int dimension_max, const Work& work, Faces<D>* out) {
    if (dimension_max < 0 || dimension_max > D) return Status::invalid_argument;
    const std::size_t high = work.arena.high_mark(), low = work.arena.low_mark();
    const Status status = enumerate_shared(complex, dimension_max, nullptr, work, low, out);
    if (status != Status::ok) {
        work.arena.release_low(low);
        work.arena.release_high(high);
    }
    return status;
}

template <int D>
Status enumerate_faces_along(const TriangulationView<D>& complex, [[maybe_unused]] const FaceCounting& counting,
                             std::uint32_t* order, bool drops_complex, const Work& work, Faces<D>* out) {
    const std::size_t high = work.arena.high_mark();
    const std::size_t low = drops_complex ? work.arena.offset_of(complex.cells) : work.arena.low_mark();
    Status status;
    if constexpr (lists_follow_order<D>) {
        status = enumerate_along(complex, counting, order, work, low, out);
    } else {
        status = enumerate_shared(complex, D, jumps_matter ? order : nullptr, work, low, out);
    }
    if (status != Status::ok) {
        work.arena.release_low(low);
        work.arena.release_high(high);
    }
    return status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status enumerate_faces<D>(const TriangulationView<D>&, int, const Work&, Faces<D>*);                      \
    template Status enumerate_faces_along<D>(const TriangulationView<D>&, const FaceCounting&, std::uint32_t*, bool,   \
                                             const Work&, Faces<D>*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
