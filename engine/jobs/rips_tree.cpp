#include "jobs/rips_tree.hpp"

#include "homology/rips/tree.hpp"

namespace netmesh {

Status persist_tree(const DistanceSource& source, double threshold, bool keep_zero, const Work& work,
                    ComplexDiagram* out, DistanceLimits* limits, DistanceFault* fault) {
    const Status status = measure_distances(source, threshold, work, limits, fault);
    if (status != Status::ok) return status;
    work.monitor.begin(NETMESH_STAGE_REDUCE, 0);
    PairPolls polls(work.monitor, source.cost() + 3);
    const auto half = [&source, threshold](std::uint32_t i, std::uint32_t j, double near, double limit) {
        const double h = source.kind == DistanceSource::Kind::points ? source.half_if_below(i, j, near, limit)
                                                                     : joins_at(source.rounded_half(i, j), threshold);
        return h >= 0 ? h : infinity;  // what is no distance the second time
    };
    const auto stop = [&polls](std::uint32_t v) { return polls.stop(v); };
    RipsTree<decltype(half), decltype(stop)> tree(source.count, limits->limit, half, stop, keep_zero, work.arena);
    const Status made = write_diagram(tree, work.arena, &out->pairs);
    out->simplices = tree.simplices();
    return made;
}

}  // namespace netmesh
