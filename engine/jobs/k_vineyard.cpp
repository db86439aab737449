#include "jobs/k_vineyard.hpp"

#include "complex/faces.hpp"
#include "memory/arena.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// The faces of a mesh, filtered as netmesh_persist does.
struct FacesByNeighbours {
    const AnyMesh& mesh;
    const VineRequest& request;
    const Work& work;
    ComplexView complex = {};
    const std::uint32_t* vertex = nullptr;  // [complex.count[0]]
    double* vertex_value = nullptr;

    Status open() {
        const int top = static_cast<int>(request.max_degree) + 1;
        work.monitor.begin(NETMESH_STAGE_FILTER, 0);
        const Status status = with_dimension(static_cast<std::uint32_t>(mesh.store.dim), [&](auto dimension) {
            constexpr int D = decltype(dimension)::value;
            Faces<D> faces = {};
            const Status listed = enumerate_faces<D>(mesh.store.of_dimension<D>().view(), top, work, &faces);
            for (int k = 0; k <= top; ++k) {
                complex.count[k] = faces.count[k];
                complex.facets[k] = faces.facets[k];
            }
            vertex = faces.last_vertex[0];
            return listed;
        });
        if (status != Status::ok) return status;
        complex.dimension = static_cast<std::uint32_t>(top);
        vertex_value = work.arena.take_high<double>(mesh.vertices());
        return vertex_value == nullptr ? Status::out_of_memory : Status::ok;
    }

    Status filter(std::uint32_t k, double* const* value, double* ratio) {
        Evaluation evaluation = {vertex_value};
        const Status status = evaluate(mesh, {request.filter, request.on_mesh, request.values, k}, work, &evaluation);
        if (status != Status::ok) return status;
        *ratio = evaluation.certificate.ratio;
        for (std::uint32_t f = 0; f < complex.count[0];)
            for (const std::uint64_t piece = work.arena.piece(f, complex.count[0], 10); f < piece; ++f) {
                value[0][f] = vertex_value[vertex[f]];
            }
        raise_to_vertices(complex, value, work.arena);
        for (std::uint32_t f = 0; f < complex.count[0];)
            for (const std::uint64_t piece = work.arena.piece(f, complex.count[0], 10); f < piece; ++f) {
                if (vertex[f] < evaluation.zero_born) value[0][f] = 0;
            }
        return Status::ok;
    }
};

}  // namespace

Status k_vineyard(const AnyMesh& mesh, const VineRequest& request, const Work& work, VineList* out) {
    FacesByNeighbours faces = {mesh, request, work};
    VineRoom room(work.arena);
    Status status = room.open(request.k_last - request.k_first + 1);
    if (status == Status::ok) status = faces.open();
    if (status != Status::ok) return status;
    return room.follow(
        faces.complex, request.max_degree, request.k_first,
        [&](std::uint32_t k, double* const* value, double* ratio) { return faces.filter(k, value, ratio); }, work, out);
}

}  // namespace netmesh
