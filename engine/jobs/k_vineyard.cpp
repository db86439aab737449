#include "jobs/k_vineyard.hpp"

#include "complex/faces.hpp"
#include "memory/arena.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// The faces of a mesh, filtered as netmesh_persist does.
template <int D> struct FacesByNeighbours {
    const FilteredMesh<D>& mesh;
    const VineRequest& request;
    const Work& work;
    Faces<D> faces = {};
    ComplexView complex = {};
    double* vertex_value = nullptr;

    Status open() {
        const int top = static_cast<int>(request.max_degree) + 1;
        work.monitor.begin(NETMESH_STAGE_FILTER, 0);
        const Status status = enumerate_faces<D>(mesh.store.view(), top, work, &faces);
        if (status != Status::ok) return status;
        complex.dimension = static_cast<std::uint32_t>(top);
        for (int k = 0; k <= top; ++k) {
            complex.count[k] = faces.count[k];
            complex.facets[k] = faces.facets[k];
        }
        vertex_value = work.arena.take_high<double>(mesh.vertices());
        return vertex_value == nullptr ? Status::out_of_memory : Status::ok;
    }

    Status filter(std::uint32_t k, double* const* value, double* ratio) {
        Evaluation evaluation = {vertex_value};
        const Status status = evaluate(mesh, {request.filter, request.values, k}, work, &evaluation);
        if (status != Status::ok) return status;
        *ratio = evaluation.certificate.ratio;
        for (std::uint32_t f = 0; f < faces.count[0];)
            for (const std::uint64_t piece = work.arena.piece(f, faces.count[0], 10); f < piece; ++f) {
                value[0][f] = vertex_value[faces.last_vertex[0][f]];
            }
        raise_to_vertices(complex, value, work.arena);
        for (std::uint32_t f = 0; f < faces.count[0];)
            for (const std::uint64_t piece = work.arena.piece(f, faces.count[0], 10); f < piece; ++f) {
                if (faces.last_vertex[0][f] < evaluation.zero_born) value[0][f] = 0;
            }
        return Status::ok;
    }
};

}  // namespace

template <int D>
Status k_vineyard(const FilteredMesh<D>& mesh, const VineRequest& request, const Work& work, VineList* out) {
    FacesByNeighbours<D> faces = {mesh, request, work};
    VineRoom room(work.arena);
    Status status = room.open(request.k_last - request.k_first + 1);
    if (status == Status::ok) status = faces.open();
    if (status != Status::ok) return status;
    return room.follow(
        faces.complex, request.max_degree, request.k_first,
        [&](std::uint32_t k, double* const* value, double* ratio) { return faces.filter(k, value, ratio); }, work, out);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status k_vineyard<D>(const FilteredMesh<D>&, const VineRequest&, const Work&, VineList*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
