#include "jobs/persist_alpha.hpp"

#include "homology/matrix/matrix.hpp"
#include "numerics/real.hpp"
#include "numerics/value_order.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Moves rows of `width` words so that row j is what row from[j] was. Sets and then ignores the top bit of from.
void permute_facets(std::uint32_t* row, std::uint32_t width, std::uint32_t* from, std::uint32_t count,
                    const Arena& arena) {
    constexpr std::uint32_t moved = 0x80000000u;
    for (std::uint32_t start = 0; start < count; ++start) {
        arena.step(start, 8);
        if ((from[start] & moved) != 0) continue;
        std::uint32_t first[dimension_most() + 1];
        for (std::uint32_t i = 0; i < width; ++i) first[i] = row[static_cast<std::size_t>(start) * width + i];
        std::uint32_t at = start;
        for (;;) {
            const std::uint32_t next = from[at];
            arena.step(at + 1, 10 + 4 * width);
            from[at] = next | moved;
            std::uint32_t* const to = row + static_cast<std::size_t>(at) * width;
            const std::uint32_t* const source = next == start ? first : row + static_cast<std::size_t>(next) * width;
            for (std::uint32_t i = 0; i < width; ++i) to[i] = source[i];
            if (next == start) break;
            at = next;
        }
    }
}

// Puts the k-faces, k >= 1, into the order of their values and renames them in the boundaries of the (k+1)-faces, if
// there are any.
Status order_faces(int k, int dimension, const std::uint32_t* face_count, std::uint32_t* const* facets,
                   double* const* value, Arena& arena) {
    const ArenaScope scope(arena);
    const std::uint32_t count = face_count[k];
    std::uint32_t* const from = arena.take_high<std::uint32_t>(count);
    if (from == nullptr || !sort_values(value[k], from, count, arena)) return Status::out_of_memory;
    if (k < dimension) {
        std::uint32_t* const place = arena.take_high<std::uint32_t>(count);
        if (place == nullptr) return Status::out_of_memory;
        for (std::uint32_t j = 0; j < count;)
            for (const std::uint64_t piece = arena.piece(j, count, 5); j < piece; ++j) {
                place[from[j]] = j;
            }
        const std::size_t words = std::size_t{face_count[k + 1]} * (static_cast<std::size_t>(k) + 2);
        std::uint32_t* const face = facets[k + 1];
        for (std::size_t i = 0; i < words;)
            for (const std::uint64_t piece = arena.piece(i, words, 5); i < piece; ++i) {
                face[i] = place[face[i]];
            }
    }
    permute_facets(facets[k], static_cast<std::uint32_t>(k) + 1, from, count, arena);
    return Status::ok;
}

// Drops the dimensions above `dimension` < dim; the values move down to where the facets of the others end. False: out
// of memory.
bool keep_dimensions(int dim, int dimension, std::uint32_t* face_count, std::uint32_t* const* facets, double** value,
                     Arena& arena) {
    arena.release_low(arena.offset_of(facets[dimension + 1]));
    for (int k = 0; k <= dimension; ++k) {
        double* const moved = arena.take_low<double>(face_count[k]);
        if (moved == nullptr) return false;
        move_bytes(moved, value[k], sizeof(double) * face_count[k], arena);
        value[k] = moved;
    }
    for (int k = dimension + 1; k <= dim; ++k) face_count[k] = 0;
    return true;
}

// Reverses the order of `count` words of 8 bytes, of whatever type.
void reverse_words(unsigned char* words, std::size_t count, const Arena& arena) {
    constexpr std::size_t word = 8;
    for (std::size_t i = 0; i < count / 2;)
        for (const std::uint64_t piece = arena.piece(i, count / 2, 8); i < piece; ++i) {
            unsigned char* const a = words + i * word;
            unsigned char* const b = words + (count - 1 - i) * word;
            unsigned char kept[word];
            __builtin_memcpy(kept, a, word);
            __builtin_memcpy(a, b, word);
            __builtin_memcpy(b, kept, word);
        }
}

// Exchanges two neighbouring pieces of memory of a and b words of 8 bytes.
void exchange_pieces(unsigned char* at, std::size_t a, std::size_t b, const Arena& arena) {
    reverse_words(at, a, arena);
    reverse_words(at + 8 * a, b, arena);
    reverse_words(at, a + b, arena);
}

// The facets of all dimensions stand before the values of all; from here on those of each dimension stand together, the
// highest last, so that they can be given up in that order. In place.
void stack_dimensions(int dimension, std::uint32_t** facets, double** value, Arena& arena) {
    for (int k = 0; k < dimension; ++k) {
        const std::size_t begin = arena.offset_of(facets[k + 1]), middle = arena.offset_of(value[k]),
                          end = arena.offset_of(value[k + 1]);
        unsigned char* const at = arena.at(begin);
        exchange_pieces(at, (middle - begin) / 8, (end - middle) / 8, arena);
        value[k] = reinterpret_cast<double*>(at);
        for (int i = k + 1; i <= dimension; ++i) facets[i] += (end - middle) / sizeof(std::uint32_t);
    }
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
    if (dimension < D && !keep_dimensions(D, dimension, faces.count, faces.facets, value, work.arena))
        return Status::out_of_memory;
    for (int k = 1; k <= dimension; ++k) {
        status = order_faces(k, dimension, faces.count, faces.facets, value, work.arena);
        if (status != Status::ok) return status;
    }
    if (D > 2) stack_dimensions(dimension, faces.facets, value, work.arena);
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
