// Diagrams in pieces: what a leaf's triangulation costs over the plain one of its points, and what all tasks cost over
// one block; and by the times of the tasks what so many workers would take.
//
//   pieces [D, 3] [points, 1000000] [pieces, 32] [uniform | shell | clusters] [leaves to measure, all]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <queue>
#include <string>
#include <vector>

#include "common/block.hpp"
#include "delaunay/triangulate.hpp"
#include "pieces/in_memory.hpp"
#include "pieces/stars.hpp"

namespace {

using Clock = std::chrono::steady_clock;
double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

inputs::Points points_of(const std::string& kind, int dim, std::size_t n) {
    if (kind == "clusters") return inputs::clusters(dim, n);
    return kind == "shell" ? inputs::shell(dim, n, 0.95, 1, 9) : inputs::uniform(dim, n);
}

// The stars of some leaves, and the plain triangulations of their points.
template <int D> void measure_stars(const pieces::Split& split, std::uint32_t count, std::uint32_t leaves) {
    const std::size_t bytes = (std::size_t{3} << 10) * (split.source.count / count) + (std::size_t{64} << 20);
    Block block(bytes, Block::untouched);
    const netmesh::PointSource source = {split.source};
    netmesh::Monitor monitor;
    netmesh::StarsReport sum = {};
    double stars = 0, plain = 0;
    for (std::uint32_t i = 0; i < leaves; ++i) {
        const std::uint32_t node = count + count / leaves * i;
        {
            block.arena.adopt(block.arena.at(0), bytes);
            netmesh::StoreState state = {};
            netmesh::Store<D> store(block.arena, state);
            netmesh::StarsReport report;
            const auto start = Clock::now();
            if (netmesh::certified_stars<D>(store, source, node, {block.arena, monitor}, &report) !=
                netmesh::Status::ok)
                return;
            stars += since(start);
            sum.own += report.own;
            sum.halo += report.halo;
            sum.queries += report.queries;
            sum.visits += report.visits;
        }
        std::vector<double> own;
        const netmesh::PieceRange range = source.range(node);
        for (std::uint32_t k = range.first; k < range.last; ++k) {
            double x[D];
            std::uint32_t row;
            if (source.read({k, k + 1}, x, &row) != netmesh::Status::ok) return;
            own.insert(own.end(), x, x + D);
        }
        block.arena.adopt(block.arena.at(0), bytes);
        netmesh::StoreState state = {};
        netmesh::Store<D> store(block.arena, state);
        netmesh::InputReport input;
        const auto start = Clock::now();
        if (netmesh::triangulate<D>(store, own.data(), range.count(), 0, monitor, &input) != netmesh::Status::ok)
            return;
        plain += since(start);
    }
    const double each = sum.own;
    std::printf("stars of %u leaves of %u points: halo %.1f%%, cells asked for %.2f a point, boxes looked at %.1f "
                "each; %.0f ns a point, plain %.0f, ratio %.2f\n",
                leaves, sum.own / leaves, 100 * sum.halo / each, static_cast<double>(sum.queries) / each,
                static_cast<double>(sum.visits) / static_cast<double>(std::max<std::uint64_t>(sum.queries, 1)),
                stars / each * 1e9, plain / each * 1e9, stars / plain);
}

// How long so many workers take for the tasks, joins first.
double simulate(const std::map<std::uint32_t, double>& seconds, std::uint32_t count, std::size_t workers) {
    using End = std::pair<double, std::uint32_t>;
    std::priority_queue<End, std::vector<End>, std::greater<>> running;
    std::vector<std::uint32_t> ready;
    std::vector<int> below(2 * count);
    for (std::uint32_t node = count; node < 2 * count; ++node) ready.push_back(node);
    double now = 0;
    while (!ready.empty() || !running.empty()) {
        while (!ready.empty() && running.size() < workers) {
            const auto next = std::min_element(ready.begin(), ready.end());
            running.push({now + seconds.at(*next), *next});
            ready.erase(next);
        }
        now = running.top().first;
        const std::uint32_t node = running.top().second;
        running.pop();
        if (node > 1 && ++below[node / 2] == 2) ready.push_back(node / 2);
    }
    return now;
}

}  // namespace

int main(int argc, char** argv) {
    const int dim = argc > 1 ? std::atoi(argv[1]) : 3;
    const std::size_t n = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1000000;
    pieces::Options options;
    options.pieces = argc > 3 ? static_cast<std::uint32_t>(std::atoi(argv[3])) : 32;
    const std::string kind = argc > 4 ? argv[4] : "uniform";
    const std::uint32_t leaves = argc > 5 ? static_cast<std::uint32_t>(std::atoi(argv[5])) : options.pieces;
    const inputs::Points points = points_of(kind, dim, n);
    auto start = Clock::now();
    const pieces::Split split(dim, points, options.pieces);
    const double splitting = since(start);
    if (split.status != NETMESH_OK) return 1;
    std::printf("%s, D = %d, %zu points, %u pieces: split %.2f s\n", kind.c_str(), dim, n, options.pieces, splitting);
    if (dim == 2) measure_stars<2>(split, options.pieces, std::min(leaves, 8u));
    if (dim == 3) measure_stars<3>(split, options.pieces, std::min(leaves, 8u));
    if (dim == 4) measure_stars<4>(split, options.pieces, std::min(leaves, 8u));
    std::map<std::uint32_t, double> seconds;
    std::map<std::uint32_t, pieces::Bytes> all;
    std::uint64_t fingerprint = 0;
    double whole = 0;
    if (leaves == options.pieces) {
        Session session(dim);
        const netmesh::Request r = session.alpha_request(points);
        session.reserve(netmesh_plan(&r));
        start = Clock::now();
        if (session.persist(r) != NETMESH_OK) return 1;
        whole = since(start);
        fingerprint = session.report().fingerprint;
    }
    Session session(dim);
    session.reserve(std::size_t{1} << 32);
    double made = 0, joined = 0, join_share = 0;
    std::size_t bytes = 0, leaf_peak = 0;
    for (std::uint32_t i = 0; i < leaves; ++i) {
        const std::uint32_t node = options.pieces + i;
        start = Clock::now();
        if (make_leaf(session, split.source, options, node, &all[node]) != NETMESH_OK) return 1;
        made += seconds[node] = since(start);
        bytes += all[node].count();
        leaf_peak = std::max<std::size_t>(leaf_peak, session.report().memory.peak_bytes);
    }
    const double own = static_cast<double>(n) / options.pieces;
    std::printf("leaves %.2f s, %.0f ns a point, %.1f bytes a point; block %.0f bytes a point\n", made,
                made / (own * leaves) * 1e9, static_cast<double>(bytes) / (own * leaves),
                static_cast<double>(leaf_peak) / own);
    if (leaves < options.pieces) return 0;
    for (std::uint32_t node = options.pieces - 1; node > 0; --node) {
        start = Clock::now();
        if (make_join(session, all[2 * node], all[2 * node + 1], &all[node]) != NETMESH_OK) return 1;
        joined += seconds[node] = since(start);
        join_share = std::max(join_share, static_cast<double>(session.report().memory.peak_bytes) /
                                              static_cast<double>(all[2 * node].count() + all[2 * node + 1].count()));
    }
    start = Clock::now();
    if (pieces::collect(session, all) != NETMESH_OK) return 1;
    const double collected = since(start), sum = splitting + made + joined + collected;
    std::printf("joins %.2f s, that of node 1 %.3f, block %.2f times the pieces; collect %.2f s; %s\n", joined,
                seconds[1], join_share, collected,
                session.report().fingerprint == fingerprint ? "the diagram of one block" : "ANOTHER DIAGRAM");
    std::printf("one worker %.2f s, one block %.2f s, ratio %.2f; tasks alone with", sum, whole, sum / whole);
    for (const std::size_t workers : {2, 8, 64})
        std::printf(" %zu workers: %.2f times as fast", workers,
                    (made + joined) / simulate(seconds, options.pieces, workers));
    std::printf("\n");
    return 0;
}
