#include "pieces/leaf_faces.hpp"

#include "delaunay/spatial_order.hpp"
#include "filtration/alpha.hpp"
#include "filtration/point_records.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// All faces of the triangulation, and their values. The cells are given back.
template <int D> Status find_values(const Store<D>& store, const Work& work, Faces<D>* faces, double** value) {
    Arena& arena = work.arena;
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    const std::uint32_t vertices = store.state.vertex_count;
    std::uint32_t* const order = arena.template take_high<std::uint32_t>(vertices);
    if (order == nullptr) return Status::out_of_memory;
    bool repeats;
    const auto* const first = reinterpret_cast<const unsigned char*>(store.point(0));
    Status status = spatial_order<D>(first, Store<D>::vertex_stride, vertices, 0, arena, order, &repeats, false);
    if (status != Status::ok) return status;
    status = enumerate_faces_along(store.view(), count_hull_facets(store.view(), arena), order, true, work, faces);
    if (status != Status::ok) return status;
    PointRecords points = {store.point(0), Store<D>::vertex_stride};
    if (lists_follow_order<D> && !points.template put_in_order<D>(order, faces->count[0], arena))
        return Status::out_of_memory;
    for (int k = 0; k <= D; ++k) {
        value[k] = arena.template take_low<double>(faces->count[k]);
        if (value[k] == nullptr) return Status::out_of_memory;
    }
    return alpha_values(*faces, points.coordinates, points.stride_bytes, work, value);
}

}  // namespace

template <int D>
Status list_leaf_faces(const PointSource& source, PieceNode node, const Work& work, LeafFaces* out,
                       StarsReport* report) {
    StoreState state = {};
    Store<D> store(work.arena, state);
    Faces<D> faces;
    Status status = certified_stars<D>(store, source, node, work, report);
    if (status == Status::ok) status = find_values<D>(store, work, &faces, out->value);
    if (status != Status::ok) return status;
    out->faces = faces.template of_dimension<any_dimension>();
    const std::uint32_t vertices = state.vertex_count, depth = depth_of(node);
    std::uint32_t* const row = out->row = work.arena.template take_low<std::uint32_t>(vertices);
    PieceNode* const leaf = out->leaf = work.arena.template take_low<PieceNode>(vertices);
    if (row == nullptr || leaf == nullptr) return Status::out_of_memory;
    work.arena.each(vertices, 30, [&](std::uint64_t v) {
        const Vertex<D>& vertex = store.vertex(static_cast<std::uint32_t>(v));
        row[v] = vertex.origin;
        leaf[v] = piece_at(vertex.next, depth, source.points());
    });
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status list_leaf_faces<D>(const PointSource&, PieceNode, const Work&, LeafFaces*, StarsReport*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
