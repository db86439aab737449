#include "delaunay/plane_few.hpp"

#include "delaunay/independent_points.hpp"
#include "delaunay/insert_all.hpp"
#include "delaunay/plane.hpp"

namespace netmesh {
namespace {

template <int D>
Status few_of(StoreState& state, const InputRows& points, std::size_t n, std::uint64_t seed, const Work& work,
              InputReport* input, FewCells* out) {
    Arena& arena = work.arena;
    const std::size_t low = arena.low_mark();
    Store<D> store(arena, state);
    std::uint32_t* order;
    Status status = take_input<D>(store, points, n, seed, work.monitor, input, &order);
    if (status != Status::ok) return status;
    VertexId first[D + 1];
    if (!independent_points(store, order, state.vertex_count, first)) return Status::flat;
    PlaneRun<D, NoWeights, NarrowWords> run(store, PlaneEnd::close);
    status = run.open(order, low);
    if (status == Status::ok) status = run.start(first);
    if (status == Status::ok) status = insert_all(run, state, work.monitor, nullptr);
    if (status != Status::ok) return status;
    out->mesh = run.close();
    PlaneTriangulation<NarrowWords>& mesh = out->mesh;
    arena.each(mesh.cell_count, 20, [&mesh](std::uint64_t c) {
        for (NarrowWords::Vertex& v : mesh.cells[c].vertex) v = VertexId(mesh.order[VertexId(v)]);
    });
    std::uint16_t* const place = arena.template take_high<std::uint16_t>(mesh.point_count);
    if (place == nullptr) return Status::out_of_memory;
    arena.each(mesh.point_count, 6,
               [&mesh, place](std::uint64_t k) { place[mesh.order[k]] = static_cast<std::uint16_t>(k); });
    // It takes the place of the order.
    arena.release_high(arena.offset_of(mesh.points));
    out->place = arena.template take_high<std::uint16_t>(mesh.point_count);
    move_bytes(out->place, place, sizeof *place * mesh.point_count, arena);
    mesh.order = nullptr;
    state.cell_slots = mesh.cell_count;
    return arena.has_stopped() ? Status::cancelled : Status::ok;
}

}  // namespace

Status triangulate_few(StoreState& state, const InputRows& points, std::size_t n, std::uint64_t seed, const Work& work,
                       InputReport* input, FewCells* out) {
    return with_dimension(2, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        if constexpr (D == 2)
            return few_of<D>(state, points, n, seed, work, input, out);
        else
            return Status::internal;
    });
}

}  // namespace netmesh
