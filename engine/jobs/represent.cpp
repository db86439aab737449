#include "jobs/represent.hpp"

#include "filtration/explicit_complex.hpp"
#include "jobs/mesh_filtration.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// The complex is listed simplex by simplex and reduced.
Status represent_listed(const AnyMesh& mesh, const RepresentRequest& request, std::uint32_t zero_born, const Work& work,
                        Representation* out) {
    const std::uint32_t degree = request.diagram.max_degree + 1;
    const bool alpha = find_filter(request.filter.filter)->source == FilterSource::delaunay;
    Status status = alpha ? alpha_complex({mesh.store.view(), mesh.store.point(0), mesh.store.point_stride()}, degree,
                                          work, &out->complex)
                          : lower_star_complex(mesh.store.view(), request.value, zero_born, degree,
                                               mesh.filtered_part(), work, &out->complex);
    if (status != Status::ok) return status;
    Representatives found = {};
    status = persist_with_cycles(out->complex.filtered(), request.diagram, work, &found);
    out->pairs = found.pairs;
    out->cycles = found.store;
    return status;
}

// The cycles are found without the complex.
Status represent_lower_star(const AnyMesh& mesh, const RepresentRequest& request, std::uint32_t zero_born,
                            const Work& work, Representation* out) {
    Representatives found = {};
    const Status status = lower_star_cycles(mesh_filtration(mesh, request.value, zero_born), request.diagram.max_degree,
                                            request.bars.count, work, &found);
    out->pairs = found.pairs;
    out->cycles = found.store;
    return status;
}

bool same_bars(const BarList& bars, const PairList& pairs, const Arena& arena) {
    if (pairs.count != bars.count) return false;
    for (std::uint64_t i = 0; i < pairs.count;)
        for (const std::uint64_t piece = arena.piece(i, pairs.count, 12); i < piece; ++i) {
            const Pair a = bars[i], &b = pairs.pairs[i];
            if (a.degree != b.degree || a.birth != b.birth || a.death != b.death) return false;
        }
    return true;
}

}  // namespace

Status represent(const AnyMesh& mesh, const RepresentRequest& request, const Work& work, Representation* out) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    const std::uint32_t zero_born = zero_born_count(request.filter.filter, request.filter.k, mesh.inputs);
    const bool alpha = find_filter(request.filter.filter)->source == FilterSource::delaunay;
    out->is_listed = alpha || request.diagram.keep_zero;
    AnyMesh filtered = mesh;
    Status status = clip_cells(request.filter, work, &filtered);
    if (status == Status::ok)
        status = out->is_listed ? represent_listed(filtered, request, zero_born, work, out)
                                : represent_lower_star(filtered, request, zero_born, work, out);
    if (status == Status::ok && !same_bars(request.bars, out->pairs, work.arena)) status = Status::internal;
    if (status == Status::ok && work.monitor.has_stopped()) status = Status::cancelled;
    if (status == Status::ok) return status;
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status;
}

}  // namespace netmesh
