#include "jobs/alpha_of_triangulation.hpp"

#include "delaunay/spatial_order.hpp"
#include "filtration/point_records.hpp"
#include "homology/matrix/ball.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

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

// The facets of all dimensions stand before the values of all; from here on those of each dimension stand together, the
// highest last, so that they can be given up in that order. Scratch: the values of one dimension. False: out of memory.
bool stack_dimensions(int dimension, std::uint32_t** facets, double** value, Arena& arena) {
    for (int k = 0; k < dimension; ++k) {
        const HighScope scope(arena);
        const std::size_t begin = arena.offset_of(facets[k + 1]), middle = arena.offset_of(value[k]),
                          bytes = arena.offset_of(value[k + 1]) - middle;
        unsigned char* const at = arena.at(begin);
        unsigned char* const kept = arena.take_high<unsigned char>(bytes);
        if (kept == nullptr) return false;
        move_bytes(kept, arena.at(middle), bytes, arena);
        move_bytes(at + bytes, at, middle - begin, arena);
        move_bytes(at, kept, bytes, arena);
        value[k] = reinterpret_cast<double*>(at);
        for (int i = k + 1; i <= dimension; ++i) facets[i] += bytes / sizeof(std::uint32_t);
    }
    return true;
}

// Values by radii, or with weights by PowerValues.
struct Radii : NoWeights {};
template <int D>
Status values_of_faces(const Faces<D>& faces, const PointRecords& points, const Radii&, const Work& work,
                       double* const* value) {
    return alpha_values(faces, points.coordinates, points.stride_bytes, work, value);
}
template <int D>
Status values_of_faces(const Faces<D>& faces, const PointRecords& points, const PowerValues& powers, const Work& work,
                       double* const* value) {
    return alpha_values_weighted(faces, points.coordinates, points.stride_bytes, powers, work, value);
}

// Leaves the pairs somewhere above the arena's low mark, with what was taken on the way.
template <int D, class W>
Status diagram_of(const AlphaFiltration<D>& filtration, const W& weights, DiagramRequest request, const Work& work,
                  CountedPairs* out) {
    const std::size_t high = work.arena.high_mark();
    Faces<D> faces;
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    std::uint32_t* order = nullptr;
    Status status = Status::ok;
    if (jumps_matter) {
        const std::uint32_t count = filtration.complex.vertex_count;
        order = work.arena.take_high<std::uint32_t>(count);
        if (order == nullptr) return Status::out_of_memory;
        bool repeats;
        if (filtration.order != nullptr)
            move_bytes(order, filtration.order, sizeof(std::uint32_t) * count, work.arena);
        else
            status = spatial_order<D>(reinterpret_cast<const unsigned char*>(filtration.coordinates),
                                      filtration.stride_bytes, count, 0, work.arena, order, &repeats, false);
    }
    if (status == Status::ok)
        status = enumerate_faces_along(filtration.complex, filtration.hull_facets, order, filtration.drops_cells, work,
                                       &faces);
    if (status != Status::ok) return status;
    PointRecords points = {filtration.coordinates, filtration.stride_bytes};
    if constexpr (lists_follow_order<D>) {
        if (filtration.order != nullptr && faces.count[0] < filtration.complex.vertex_count) return Status::internal;
        if (filtration.order == nullptr &&
            !points.put_in_order<D + (W::has ? 1 : 0)>(order, faces.count[0], work.arena))
            return Status::out_of_memory;
    } else {
        // A cell's last vertex is that of the facet opposite its first one, too.
        work.arena.release_high(work.arena.offset_of(faces.last_vertex[D - 1]));
        faces.last_vertex[D] = nullptr;
    }

    double* value[D + 1];
    std::uint64_t total = 0;
    for (int k = 0; k <= D; ++k) {
        value[k] = work.arena.take_low<double>(faces.count[k]);
        if (value[k] == nullptr || faces.count[k] > 0x7FFFFFFFu) return Status::out_of_memory;
        total += faces.count[k];
    }
    work.monitor.begin(NETMESH_STAGE_FILTER, total);
    status = values_of_faces(faces, points, weights, work, value);
    if (status != Status::ok) return status;
    work.arena.release_high(high);

    const int dimension = static_cast<int>(request.max_degree) + 1;
    if (dimension < D && !keep_dimensions(D, dimension, faces.count, faces.facets, value, work.arena))
        return Status::out_of_memory;
    if (D > 2 && !stack_dimensions(dimension, faces.facets, value, work.arena)) return Status::out_of_memory;
    FilteredBall ball = {D, static_cast<std::uint32_t>(dimension), D > 2, {}, false};
    out->simplices = 0;
    for (int k = 0; k <= dimension; ++k) {
        ball.of[k] = {faces.count[k], faces.facets[k], value[k]};
        out->simplices += faces.count[k];
    }
    if constexpr (W::has)
        return D == 2 ? persist_signed_disk(ball, request, work, &out->pairs)
                      : persist_signed_ball(ball, request, work, &out->pairs);
    else
        return D == 2 ? persist_disk(ball, request, work, &out->pairs) : persist_ball(ball, request, work, &out->pairs);
}

template <int D, class W>
Status alpha_diagram(const AlphaFiltration<D>& filtration, const W& weights, DiagramRequest request, const Work& work,
                     CountedPairs* out) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    if (request.max_degree >= D) request.max_degree = D - 1;
    PairList& found = out->pairs;
    const Status status = diagram_of(filtration, weights, request, work, out);
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status == Status::ok ? move_pairs_down(low, work.arena, &found) : status;
}

}  // namespace

template <int D>
Status alpha_of_triangulation(const AlphaFiltration<D>& filtration, DiagramRequest request, const Work& work,
                              CountedPairs* out) {
    return alpha_diagram(filtration, Radii{}, request, work, out);
}

template <int D>
Status alpha_of_triangulation(const AlphaFiltration<D>& filtration, const PowerValues& powers, DiagramRequest request,
                              const Work& work, CountedPairs* out) {
    return alpha_diagram(filtration, powers, request, work, out);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status alpha_of_triangulation<D>(const AlphaFiltration<D>&, DiagramRequest, const Work&, CountedPairs*);  \
    template Status alpha_of_triangulation<D>(const AlphaFiltration<D>&, const PowerValues&, DiagramRequest,           \
                                              const Work&, CountedPairs*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
