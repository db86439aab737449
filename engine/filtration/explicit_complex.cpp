#include "filtration/explicit_complex.hpp"

#include "complex/faces.hpp"
#include "filtration/alpha.hpp"

namespace netmesh {
namespace {

// Faces as they are listed, with room for their values.
template <int D>
Status take_faces(const TriangulationView<D>& triangulation, std::uint32_t dimension, Arena& arena, Monitor& monitor,
                  Faces<D>* faces, ListedComplex* out) {
    *out = {};
    out->dimension = dimension;
    monitor.begin(NETMESH_STAGE_FILTER, 0);
    const Status status = enumerate_faces(triangulation, static_cast<int>(dimension), arena, monitor, faces);
    if (status != Status::ok) return status;
    for (std::uint32_t k = 0; k <= dimension; ++k) {
        out->count[k] = faces->count[k];
        out->rows[k] = k > 0 ? faces->facets[k] : arena.take_low<std::uint32_t>(faces->count[0]);
        out->value[k] = arena.take_low<double>(faces->count[k]);
        if (out->rows[k] == nullptr || out->value[k] == nullptr || out->count[k] > 0x7FFFFFFFu)
            return Status::out_of_memory;
    }
    for (std::uint32_t v = 0; v < out->count[0]; ++v) out->rows[0][v] = faces->last_vertex[0][v];
    return Status::ok;
}

}  // namespace

template <int D>
Status lower_star_complex(const TriangulationView<D>& triangulation, const double* value, std::uint32_t zero_born_count,
                          std::uint32_t dimension, Arena& arena, Monitor& monitor, ListedComplex* out) {
    const std::size_t high = arena.high_mark();
    Faces<D> faces;
    const Status status = take_faces<D>(triangulation, dimension, arena, monitor, &faces, out);
    arena.release_high(high);
    if (status != Status::ok) return status;
    for (std::uint32_t v = 0; v < out->count[0]; ++v) out->value[0][v] = value[out->rows[0][v]] + 0.0;
    for (std::uint32_t k = 1; k <= dimension; ++k) {
        for (std::uint32_t i = 0; i < out->count[k]; ++i) {
            // The first and the last facet together have all vertices.
            const std::uint32_t* const facets = out->rows[k] + std::size_t{i} * (k + 1);
            const double a = out->value[k - 1][facets[0]], b = out->value[k - 1][facets[k]];
            out->value[k][i] = a > b ? a : b;
        }
    }
    for (std::uint32_t v = 0; v < out->count[0]; ++v) {
        if (out->rows[0][v] < zero_born_count) out->value[0][v] = 0;
    }
    return Status::ok;
}

template <int D>
Status alpha_complex(const TriangulationView<D>& triangulation, const double* coordinates, std::ptrdiff_t stride_bytes,
                     std::uint32_t dimension, Arena& arena, Monitor& monitor, ListedComplex* out) {
    const std::size_t high = arena.high_mark();
    Faces<D> faces;
    Status status = take_faces<D>(triangulation, D, arena, monitor, &faces, out);
    if (status == Status::ok) status = alpha_values<D>(faces, coordinates, stride_bytes, monitor, out->value);
    arena.release_high(high);
    out->dimension = dimension;
    return status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status lower_star_complex<D>(const TriangulationView<D>&, const double*, std::uint32_t, std::uint32_t,    \
                                          Arena&, Monitor&, ListedComplex*);                                           \
    template Status alpha_complex<D>(const TriangulationView<D>&, const double*, std::ptrdiff_t, std::uint32_t,        \
                                     Arena&, Monitor&, ListedComplex*);
NETMESH_INSTANTIATE(2)
NETMESH_INSTANTIATE(3)
NETMESH_INSTANTIATE(4)
NETMESH_INSTANTIATE(5)
NETMESH_INSTANTIATE(6)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
