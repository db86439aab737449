#include "tools/commands/rips_input.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "platform/memory.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/io/numbers.hpp"
#include "tools/opinion/exact_spheres.hpp"

namespace netmesh::tool {

namespace {

// A triangle of distances that is forgotten while the engine reads it, row by row, into its own edges.
struct ReleasedTriangle {
    std::vector<double>* lower;
    std::size_t released = 0;  // numbers

    static double evaluate(void* user, std::uint32_t i, std::uint32_t j) {
        constexpr std::size_t piece = std::size_t{1} << 17;
        ReleasedTriangle& self = *static_cast<ReleasedTriangle*>(user);
        const std::size_t at = std::size_t{i} * (i - 1) / 2 + j;
        if (at < self.released) return NAN;  // the engine reports it
        if (at - self.released >= piece) {
            platform::forget_pages(self.lower->data() + self.released, (at - self.released) * sizeof(double));
            self.released = at;
        }
        return (*self.lower)[at];
    }
};

// Leaves the first of equal points.
void merge(PointCloud* cloud) {
    std::set<std::vector<double>> seen;
    std::size_t kept = 0;
    for (std::size_t row = 0; row < cloud->rows(); row++) {
        const auto first = cloud->coordinates.begin() + static_cast<std::ptrdiff_t>(row * cloud->dim);
        if (!seen.emplace(first, first + cloud->dim).second) continue;
        std::copy(first, first + cloud->dim,
                  cloud->coordinates.begin() + static_cast<std::ptrdiff_t>(kept * cloud->dim));
        if (row < cloud->lines.size()) cloud->lines[kept] = cloud->lines[row];
        kept++;
    }
    cloud->coordinates.resize(kept * cloud->dim);
    if (!cloud->lines.empty()) cloud->lines.resize(kept);
}

netmesh_distances distances_of(const RipsInput& input) {
    netmesh_distances distances = sized<netmesh_distances>();
    distances.layout = input.file.layout;
    distances.numbers = input.file.numbers.data();
    distances.entries = input.file.entries.data();
    distances.entry_count = input.file.entries.size();
    distances.count = input.count();
    return distances;
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// Half of each finite distance within the threshold, by the points, the lower number in front.
std::map<Pair, double> edges_of(const RipsInput& input, const Options& options) {
    std::map<Pair, double> edges;
    const double most = options.request.threshold;
    const auto add = [&](std::uint32_t i, std::uint32_t j, double half) {
        if (i != j && half <= most && half < HUGE_VAL) edges[{std::min(i, j), std::max(i, j)}] = half;
    };
    for (const netmesh_distance_entry& entry : input.file.entries) add(entry.i, entry.j, entry.distance / 2);
    if (!input.of_points() && input.file.layout == NETMESH_DISTANCES_SPARSE) return edges;
    const std::uint64_t n = input.count();
    const PointCloud& cloud = input.cloud;
    const auto place = [&cloud](std::uint32_t i) { return cloud.coordinates.data() + std::size_t{i} * cloud.dim; };
    for (std::uint32_t i = 0; i < n; i++)
        for (std::uint32_t j = 0; j < i; j++) {
            const std::uint64_t at =
                input.file.layout == NETMESH_DISTANCES_FULL ? i * n + j : std::uint64_t{i} * (i - 1) / 2 + j;
            add(i, j, input.of_points() ? half_distance(place(i), place(j), cloud.dim) : input.file.numbers[at] / 2);
        }
    return edges;
}

}  // namespace

Outcome read_rips_input(const Options& options, const std::string& path, RipsInput* input) {
    *input = {};
    input->path = path;
    if (options.distances) {
        const Outcome outcome = read_distances(path, options.sparse, &input->file);
        if (outcome.good()) tell_note(options, input->file.place.name, input->file.note);
        input->rows = input->file.points;
        return outcome;
    }
    Outcome outcome = read_cloud(options, path, &input->cloud);
    if (!outcome.good()) return outcome;
    input->rows = input->cloud.rows();
    merge(&input->cloud);
    return {};
}

namespace {

Outcome persist_points_within(const RipsInput& input, Session& session, netmesh_report* report) {
    const PointCloud& cloud = input.cloud;
    std::vector<double> plane;  // points on a line, of which the engine wants another coordinate
    for (std::size_t i = 0; cloud.dim == 1 && i < cloud.rows(); i++)
        plane.insert(plane.end(), {cloud.coordinates[i], 0});
    netmesh_request request = on_points(session.request(), cloud);
    if (cloud.dim == 1) request.points = points_of(2, plane);
    const Outcome outcome = session.run(plan(request), cloud, [&](Session& s) { return persist(s, request); });
    if (!outcome.good()) return outcome;
    *report = session.report();
    report->input.dim = cloud.dim;
    report->input.points = input.rows;
    report->input.duplicates = input.rows - input.count();
    return {};
}

}  // namespace

Outcome persist_rips(RipsInput& input, Session& session, netmesh_report* report) {
    if (input.of_points()) return persist_points_within(input, session, report);
    netmesh_distances distances = distances_of(input);
    netmesh_request request = session.request();
    request.distances = &distances;
    ReleasedTriangle triangle = {&input.file.numbers};
    const std::uint64_t points = input.count();
    if (input.read_once && request.cycles == nullptr && distances.layout == NETMESH_DISTANCES_LOWER &&
        request.max_degree > 0 && input.path != "-") {
        distances.layout = NETMESH_DISTANCES_FUNCTION;
        distances.evaluate = ReleasedTriangle::evaluate;
        distances.user = &triangle;
    }
    const Outcome outcome = session.run(plan(request), input.file.place, [&](Session& s) {
        if (triangle.released > 0) {  // by the run in a smaller block
            if (!read_distances(input.path, false, &input.file).good() || input.count() != points)
                return NETMESH_OUT_OF_MEMORY;
            triangle.released = 0;
        }
        return persist(s, request);
    });
    const Engine& engine = session.engine();
    const netmesh_detail detail = engine.detail();
    const bool at_number = detail.field == NETMESH_FIELD_NUMBERS || detail.field == NETMESH_FIELD_ENTRIES;
    if (engine.status() == NETMESH_INVALID_ARGUMENT && at_number)
        return input.file.fault(detail.index_a, detail.index_b, detail.message);
    if (!outcome.good()) return outcome;
    *report = engine.report();
    return {};
}

SimplexList complex_of(const RipsInput& input, const Options& options, std::uint32_t top) {
    const std::uint64_t n = input.count();
    if (n > 4000) return {};
    const std::map<Pair, double> edges = edges_of(input, options);
    std::vector<std::vector<std::uint32_t>> later(n);  // neighbours of higher number
    for (const auto& edge : edges) later[edge.first.first].push_back(edge.first.second);
    std::vector<FilteredSimplex> list;
    for (std::uint32_t v = 0; v < n; v++) list.push_back({{v}, 0});
    for (std::size_t first = 0, last = list.size(), d = 0; d < top; d++, first = last, last = list.size()) {
        for (std::size_t s = first; s < last; s++) {
            for (const std::uint32_t v : later[list[s].vertices.back()]) {
                double value = list[s].value;
                bool joined = true;
                for (const std::uint32_t u : list[s].vertices) {
                    const auto edge = edges.find({u, v});
                    joined = joined && edge != edges.end();
                    if (joined) value = std::max(value, edge->second);
                }
                if (!joined) continue;
                FilteredSimplex cofacet{list[s].vertices, value};
                cofacet.vertices.push_back(v);
                list.push_back(std::move(cofacet));
                if (list.size() > opinion_simplices_max) return {};
            }
        }
    }
    return list;
}

}  // namespace netmesh::tool
