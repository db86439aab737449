#include "jobs/persist_alpha.hpp"

#include "homology/matrix/matrix.hpp"
#include "numerics/real.hpp"
#include "numerics/value_order.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Moves rows so that row j is what row from[j] was. Sets and then ignores the top bit of from.
template <int W> void permute_facets(std::uint32_t* row, std::uint32_t* from, std::uint32_t count, const Arena& arena) {
    constexpr std::uint32_t moved = 0x80000000u;
    for (std::uint32_t start = 0; start < count; ++start) {
        arena.step(start, 8);
        if ((from[start] & moved) != 0) continue;
        std::uint32_t first[W];
        for (int i = 0; i < W; ++i) first[i] = row[static_cast<std::size_t>(start) * W + i];
        std::uint32_t at = start;
        for (;;) {
            const std::uint32_t next = from[at];
            arena.step(at + 1, 10 + 4 * W);
            from[at] = next | moved;
            std::uint32_t* const to = row + static_cast<std::size_t>(at) * W;
            if (next == start) {
                for (int i = 0; i < W; ++i) to[i] = first[i];
                break;
            }
            for (int i = 0; i < W; ++i) to[i] = row[static_cast<std::size_t>(next) * W + i];
            at = next;
        }
    }
}

// Puts the K-faces into the order of their values and renames them in the boundaries of the (K+1)-faces.
template <int K, int D> Status order_faces(Faces<D>& faces, int dimension, double* const* value, Arena& arena) {
    const ArenaScope scope(arena);
    const std::uint32_t count = faces.count[K];
    std::uint32_t* const from = arena.take_high<std::uint32_t>(count);
    if (from == nullptr || !sort_values(value[K], from, count, arena)) return Status::out_of_memory;
    if constexpr (K < D) {
        if (K < dimension) {
            std::uint32_t* const place = arena.take_high<std::uint32_t>(count);
            if (place == nullptr) return Status::out_of_memory;
            for (std::uint32_t j = 0; j < count;)
                for (const std::uint64_t piece = arena.piece(j, count, 5); j < piece; ++j) {
                    place[from[j]] = j;
                }
            const std::size_t words = static_cast<std::size_t>(faces.count[K + 1]) * (K + 2);
            for (std::size_t i = 0; i < words;)
                for (const std::uint64_t piece = arena.piece(i, words, 5); i < piece; ++i) {
                    faces.facets[K + 1][i] = place[faces.facets[K + 1][i]];
                }
        }
    }
    permute_facets<K + 1>(faces.facets[K], from, count, arena);
    return Status::ok;
}

template <int K, int D> Status order_from(Faces<D>& faces, int dimension, double* const* value, Arena& arena) {
    const Status status = order_faces<K, D>(faces, dimension, value, arena);
    if constexpr (K < D) {
        if (status == Status::ok && K < dimension) return order_from<K + 1, D>(faces, dimension, value, arena);
    }
    return status;
}

// Drops the dimensions above `dimension` < D; the values move down to where the facets of the others end. False: out of
// memory.
template <int D> bool keep_dimensions(Faces<D>& faces, int dimension, double** value, Arena& arena) {
    arena.release_low(arena.offset_of(faces.facets[dimension + 1]));
    for (int k = 0; k <= dimension; ++k) {
        double* const moved = arena.take_low<double>(faces.count[k]);
        if (moved == nullptr) return false;
        move_bytes(moved, value[k], sizeof(double) * faces.count[k], arena);
        value[k] = moved;
    }
    for (int k = dimension + 1; k <= D; ++k) faces.count[k] = 0;
    faces.dimension_max = dimension;
    return true;
}

// The facets of all dimensions stand before the values of all; from here on those of each dimension stand together, the
// highest last, so that they can be given up in that order. Scratch: the values of one dimension. False: out of memory.
template <int D> bool stack_dimensions(Faces<D>& faces, int dimension, double** value, Arena& arena) {
    for (int k = 0; k < dimension; ++k) {
        const HighScope scope(arena);
        const std::size_t begin = arena.offset_of(faces.facets[k + 1]), middle = arena.offset_of(value[k]),
                          bytes = arena.offset_of(value[k + 1]) - middle;
        unsigned char* const at = arena.at(begin);
        unsigned char* const kept = arena.take_high<unsigned char>(bytes);
        if (kept == nullptr) return false;
        move_bytes(kept, arena.at(middle), bytes, arena);
        move_bytes(at + bytes, at, middle - begin, arena);
        move_bytes(at, kept, bytes, arena);
        value[k] = reinterpret_cast<double*>(at);
        for (int i = k + 1; i <= dimension; ++i) faces.facets[i] += bytes / sizeof(std::uint32_t);
    }
    return true;
}

// Leaves the pairs somewhere above the arena's low mark, with what was taken on the way.
template <int D>
Status diagram_of(const AlphaFiltration<D>& filtration, DiagramRequest request, const Work& work, CountedPairs* out,
                  double* error) {
    const std::size_t high = work.arena.high_mark();
    Faces<D> faces;
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    Status status = enumerate_faces(filtration.complex, D, work, &faces, filtration.drops_cells);
    if (status != Status::ok) return status;
    // A cell's last vertex is that of the facet opposite its first one, too.
    work.arena.release_high(work.arena.offset_of(faces.last_vertex[D - 1]));
    faces.last_vertex[D] = nullptr;

    double* value[D + 1];
    std::uint64_t total = 0;
    for (int k = 0; k <= D; ++k) {
        value[k] = work.arena.take_low<double>(faces.count[k]);
        if (value[k] == nullptr || faces.count[k] > 0x7FFFFFFFu) return Status::out_of_memory;
        total += faces.count[k];
    }
    work.monitor.begin(NETMESH_STAGE_FILTER, 2 * total);
    status = alpha_values(faces, filtration.coordinates, filtration.stride_bytes, work, value, error);
    if (status != Status::ok) return status;
    work.arena.release_high(high);

    const int dimension = static_cast<int>(request.max_degree) + 1;
    if (dimension < D && !keep_dimensions(faces, dimension, value, work.arena)) return Status::out_of_memory;
    status = order_from<1, D>(faces, dimension, value, work.arena);
    if (status != Status::ok) return status;
    if (D > 2 && !stack_dimensions(faces, dimension, value, work.arena)) return Status::out_of_memory;
    FilteredComplex filtered = {};
    filtered.stacked = D > 2;
    filtered.dimension = static_cast<std::uint32_t>(dimension);
    out->simplices = 0;
    for (int k = 0; k <= dimension; ++k) {
        filtered.of[k] = {faces.count[k], faces.facets[k], value[k]};
        out->simplices += faces.count[k];
    }
    return D == 2 ? persist_surface(filtered, request, work, &out->pairs)
                  : persist_homology(filtered, request, work, &out->pairs);
}

}  // namespace

template <int D>
Status persist_alpha(const AlphaFiltration<D>& filtration, DiagramRequest request, const Work& work, CountedPairs* out,
                     double* error) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    if (request.max_degree >= D) request.max_degree = D - 1;
    PairList& found = out->pairs;
    const Status status = diagram_of(filtration, request, work, out, error);
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status == Status::ok ? move_pairs_down(low, work.arena, &found) : status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status persist_alpha<D>(const AlphaFiltration<D>&, DiagramRequest, const Work&, CountedPairs*, double*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
