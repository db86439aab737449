#include "jobs/diagram_of_distances.hpp"

#include "filtration/point_complexes.hpp"
#include "filtration/rips_graph.hpp"
#include "jobs/point_set.hpp"
#include "jobs/rips_tree.hpp"

namespace netmesh {
namespace {

// Half of all distances that edges tell, infinity of the others.
Status spread_edges(const RipsGraph& graph, const Work& work, DistanceSource* out) {
    const std::size_t pairs = DistanceSource::triangle(graph.vertices);
    double* const halves = work.arena.take_low<double>(pairs);
    if (halves == nullptr) return Status::out_of_memory;
    work.arena.each(pairs, 1, [halves](std::uint64_t i) { halves[i] = infinity; });
    graph.each_edge(work.arena, [&](std::uint32_t larger, std::uint32_t smaller, std::uint32_t e) {
        halves[DistanceSource::triangle(larger) + smaller] = graph.value[e];
    });
    *out = {DistanceSource::Kind::halves, graph.vertices, halves, 0, nullptr, nullptr};
    return Status::ok;
}

Status persist_listed_graph(const DistancesRequest& request, const RipsGraph& graph, double limit, const Work& work,
                            DistancesDiagram* out) {
    DistanceSource source;
    Status status = spread_edges(graph, work, &source);
    const std::uint32_t wanted = request.max_degree + 1, n = graph.vertices, dimension = wanted < n ? wanted : n - 1;
    if (status == Status::ok) status = distance_complex(source, dimension, limit, work, &out->complex);
    if (status != Status::ok) return status;
    ComplexRequest counted = {{request.max_degree, request.keep_zero}, true};
    counted.counted = request.max_degree > 1 ? request.max_degree : 1;
    return diagram_of_complex(out->complex, counted, work, &out->diagram);
}

Status persist_graph(const DistancesRequest& request, const Work& work, DistancesDiagram* out) {
    RipsGraph graph;
    DistanceLimits limits;
    const Status status = request.entries.count > 0
                              ? sparse_graph(request.entries, request.threshold, work, &graph, &limits, &out->fault)
                              : distance_graph(request.source, request.threshold, work, &graph, &limits, &out->fault);
    if (status != Status::ok) return status;
    out->input_fingerprint = limits.fingerprint;
    if (request.representatives) return persist_listed_graph(request, graph, limits.limit, work, out);
    CountedPairs found = {};
    const Status reduced = persist_rips(graph, {request.max_degree, request.keep_zero}, work, &found);
    out->diagram.pairs = found.pairs;
    out->diagram.simplices = found.simplices;
    return reduced;
}

}  // namespace

Status diagram_of_distances(const DistancesRequest& request, const Work& work, DistancesDiagram* out) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    *out = DistancesDiagram{};
    const bool is_tree = request.max_degree == 0 && request.entries.count == 0 && !request.representatives;
    DistanceLimits limits = {};
    const Status status = is_tree ? persist_tree(request.source, request.threshold, request.keep_zero, work,
                                                 &out->diagram, &limits, &out->fault)
                                  : persist_graph(request, work, out);
    if (is_tree) out->input_fingerprint = limits.fingerprint;
    if (status == Status::ok) {
        return request.representatives ? status : move_pairs_down(low, work.arena, &out->diagram.pairs);
    }
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status;
}

double distances_bytes(const DistancesRequest& request, std::uint64_t n) {
    const double points = static_cast<double>(n);
    double edges = points * (points - 1) / 2;
    const double entries = static_cast<double>(request.entries.entry_count);
    if (request.entries.count > 0 && entries < edges) edges = entries;
    if (request.representatives) {
        const std::uint64_t top = std::uint64_t{request.max_degree} + 1;
        const std::uint32_t dimension = static_cast<std::uint32_t>(top < n ? top : n - 1);
        return 1.1 * (12 * points * points + skeleton_count(n, dimension) * (8.0 * (dimension + 1) + 32));
    }
    if (request.entries.count == 0 && request.max_degree == 0) return 80 * points;
    const double bytes = rips_bytes(n, request.max_degree, edges);
    return entries > edges ? bytes + 12.6 * (entries - edges) : bytes;
}

}  // namespace netmesh
