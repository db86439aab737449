#include "filtration/explicit_complex.hpp"

#include "complex/faces.hpp"
#include "complex/faces_in_part.hpp"
#include "filtration/alpha.hpp"
#include "homology/rank.hpp"
#include "memory/arena.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

using AnyView = TriangulationView<any_dimension>;

// Faces as they are listed, with room for their values. keep(faces) leaves of them those that are wanted.
template <class Keep>
Status take_faces(const AnyView& triangulation, std::uint32_t dimension, const Work& work, AnyFaces* faces,
                  ListedComplex* out, Keep keep) {
    *out = {};
    out->dimension = dimension;
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    Status status = with_dimension(triangulation.dim, [&](auto number) {
        constexpr int D = decltype(number)::value;
        Faces<D> all = {};
        const Status listed =
            enumerate_faces<D>(triangulation.of_dimension<D>({}), static_cast<int>(dimension), work, &all);
        *faces = all.template of_dimension<any_dimension>();
        return listed;
    });
    if (status == Status::ok) status = keep(faces);
    if (status != Status::ok) return status;
    for (std::uint32_t k = 0; k <= dimension; ++k) {
        out->count[k] = faces->count[k];
        out->rows[k] = k > 0 ? faces->facets[k] : work.arena.take_low<std::uint32_t>(faces->count[0]);
        out->value[k] = work.arena.take_low<double>(faces->count[k]);
        if (out->rows[k] == nullptr || out->value[k] == nullptr || out->count[k] > 0x7FFFFFFFu)
            return Status::out_of_memory;
    }
    for (std::uint32_t v = 0; v < out->count[0];)
        for (const std::uint64_t piece = work.arena.piece(v, out->count[0], 10); v < piece; ++v) {
            out->rows[0][v] = faces->last_vertex[0][v];
        }
    return Status::ok;
}

// The same cells with vertices numbered by value from the last to the first, so that faces in lexicographic order, read
// backwards, are in order of value; vertex_of[n]: the vertex of each number. The copy stays at the arena's high end.
// False: out of memory.
bool rank_cells(const AnyView& triangulation, const double* value, Arena& arena, std::uint32_t* vertex_of,
                AnyView* out) {
    const std::uint32_t width = triangulation.dim + 1;
    const std::uint32_t n = triangulation.vertex_count, cells = triangulation.cell_count;
    std::uint32_t* const copy = arena.take_high<std::uint32_t>(std::size_t{cells} * width);
    const HighScope scope(arena);
    std::uint32_t* const rank = arena.take_high<std::uint32_t>(n);
    std::uint32_t* const place = arena.take_high<std::uint32_t>(std::size_t{n} + 1);
    if (copy == nullptr || rank == nullptr || place == nullptr || !rank_vertices(value, n, arena, vertex_of, rank))
        return false;
    for (std::uint32_t v = 0; v < n;)
        for (const std::uint64_t piece = arena.piece(v, n, 5); v < piece; ++v) {
            vertex_of[n - 1 - rank[v]] = v;
        }
    const auto first_of = [&](std::uint32_t c) {
        std::uint32_t first = n;
        for (std::uint32_t i = 0; i < width; ++i) {
            const std::uint32_t label = n - 1 - rank[triangulation.vertices(CellId(c))[i]];
            if (label < first) first = label;
        }
        return first;
    };
    // Cells of one first vertex lie together: the stars that are walked are found in few places.
    for (std::uint32_t v = 0; v <= n; ++v) {
        arena.step(v, 3);
        place[v] = 0;
    }
    for (std::uint32_t c = 0; c < cells;)
        for (const std::uint64_t piece = arena.piece(c, cells, 8 * width); c < piece; ++c) {
            ++place[first_of(c) + 1];
        }
    for (std::uint32_t v = 0; v < n;)
        for (const std::uint64_t piece = arena.piece(v, n, 5); v < piece; ++v) {
            place[v + 1] += place[v];
        }
    for (std::uint32_t c = 0; c < cells;)
        for (const std::uint64_t piece = arena.piece(c, cells, 16 * width); c < piece; ++c) {
            std::uint32_t* const to = copy + std::size_t{place[first_of(c)]++} * width;
            for (std::uint32_t i = 0; i < width; ++i) to[i] = n - 1 - rank[triangulation.vertices(CellId(c))[i]];
        }
    *out = {reinterpret_cast<const unsigned char*>(copy), sizeof(std::uint32_t) * width, cells, n, triangulation.dim};
    return true;
}

// Puts the simplices of one dimension, and what it says of their facets, in the opposite order.
void turn_round(ListedComplex& complex, std::uint32_t k, const Arena& arena) {
    const std::uint32_t width = k + 1, count = complex.count[k], last = k > 0 ? complex.count[k - 1] - 1 : 0;
    std::uint32_t* front = complex.rows[k];
    std::uint32_t* back = front + std::size_t{count} * width;
    for (std::uint32_t i = 0; i < count / 2;)
        for (const std::uint64_t piece = arena.piece(i, count / 2, 8 * width); i < piece; ++i) {
            back -= width;
            for (std::uint32_t w = 0; w < width; ++w) {
                const std::uint32_t t = front[w];
                front[w] = back[w];
                back[w] = t;
            }
            front += width;
        }
    std::uint32_t* const rows = complex.rows[k];
    for (std::size_t i = 0; k > 0 && i < std::size_t{count} * width; ++i) {
        arena.step(i, 4);
        rows[i] = last - rows[i];
    }
}

}  // namespace

Status lower_star_complex(const TriangulationView<any_dimension>& triangulation, const double* value,
                          std::uint32_t zero_born_count, std::uint32_t dimension, const AnyPart* part, const Work& work,
                          ListedComplex* out) {
    const std::size_t high = work.arena.high_mark();
    AnyFaces faces;
    AnyView ranked;
    std::uint32_t* const vertex_of = work.arena.take_high<std::uint32_t>(triangulation.vertex_count);
    Status status = vertex_of != nullptr && rank_cells(triangulation, value, work.arena, vertex_of, &ranked)
                        ? Status::ok
                        : Status::out_of_memory;
    const auto keep = [&](AnyFaces* all) {
        return part == nullptr ? Status::ok : keep_faces_in_part(*part, triangulation, vertex_of, work, all);
    };
    if (status == Status::ok) status = take_faces(ranked, dimension, work, &faces, out, keep);
    if (status == Status::ok) {
        for (std::uint32_t k = 0; k <= dimension; ++k) turn_round(*out, k, work.arena);
        for (std::uint32_t v = 0; v < out->count[0];)
            for (const std::uint64_t piece = work.arena.piece(v, out->count[0], 10); v < piece; ++v) {
                out->rows[0][v] = vertex_of[out->rows[0][v]];
                out->value[0][v] = value[out->rows[0][v]] + 0.0;
            }
        for (std::uint32_t k = 1; k <= dimension; ++k) {
            // The facet without the last vertex, which is the first to enter, has the one that is the last to enter.
            const std::uint32_t* const facets = out->rows[k];
            for (std::size_t i = 0; i < out->count[k];)
                for (const std::uint64_t piece = work.arena.piece(i, out->count[k], 12); i < piece; ++i) {
                    out->value[k][i] = out->value[k - 1][facets[i * (k + 1) + k]];
                }
        }
        for (std::uint32_t v = 0; v < out->count[0];)
            for (const std::uint64_t piece = work.arena.piece(v, out->count[0], 10); v < piece; ++v) {
                if (out->rows[0][v] < zero_born_count) out->value[0][v] = 0;
            }
    }
    work.arena.release_high(high);
    return status == Status::ok ? order_dimension(*out, 0, work.arena) : status;
}

Status alpha_complex(const AlphaFiltration<any_dimension>& filtration, std::uint32_t dimension, const Work& work,
                     ListedComplex* out) {
    const std::size_t high = work.arena.high_mark();
    AnyFaces faces;
    Status status =
        take_faces(filtration.complex, filtration.complex.dim, work, &faces, out, [](AnyFaces*) { return Status::ok; });
    if (status == Status::ok)
        status = with_dimension(filtration.complex.dim, [&](auto number) {
            constexpr int D = decltype(number)::value;
            return alpha_values<D>(faces.of_dimension<D>(), filtration.coordinates, filtration.stride_bytes, work,
                                   out->value);
        });
    work.arena.release_high(high);
    out->dimension = dimension;
    return status == Status::ok ? order_by_value(*out, work.arena) : status;
}

}  // namespace netmesh
