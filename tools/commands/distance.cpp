// distance: the bottleneck or Wasserstein distance between two diagrams, degree by degree.
#include <cmath>
#include <set>

#include "platform/clock.hpp"
#include "platform/interrupt.hpp"
#include "platform/memory.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/logarithm.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/other_diagrams.hpp"

namespace netmesh::tool {

namespace {

Outcome read_pairs(const std::string& path, std::vector<netmesh_pair>* pairs, std::set<std::uint32_t>* degrees) {
    std::string content;
    std::vector<Bar> bars;
    Outcome outcome = read_content(path, &content);
    if (outcome.good()) outcome = parse_any_diagram(content, shown_name(path), &bars);
    if (!outcome.good()) return outcome;
    for (const Bar& bar : bars) {
        pairs->push_back({sizeof(netmesh_pair), bar.degree, bar.birth, bar.death});
        degrees->insert(bar.degree);
    }
    return {};
}

int poll(void*, const netmesh_progress*) { return platform::interrupted() ? 1 : 0; }

// One call, with its result in *found.
DegreeDistance call(const Bottleneck& request, netmesh_status* status) {
    netmesh_distance found = {};
    *status = bottleneck(request, &found);
    const bool logarithm = request.scale == NETMESH_SCALE_LOG && found.value < HUGE_VAL;
    const double value = logarithm ? natural_logarithm(found.value, found.exponent) : found.value;
    return {request.degree, value, value};
}
DegreeDistance call(const Wasserstein& request, netmesh_status* status) {
    netmesh_wasserstein_distance found = {};
    *status = wasserstein(request, &found);
    return {request.degree, found.value, found.lower};
}
std::size_t scratch_bytes(const Bottleneck& request) { return bottleneck_bytes(request); }
std::size_t scratch_bytes(const Wasserstein& request) { return wasserstein_bytes(request); }

// No distance is printed that is not as near as it was asked for.
Outcome broken(const Bottleneck&, netmesh_status status) {
    return {Exit::internal, std::string("netmesh: internal error: ") + netmesh_status_text(status)};
}
Outcome broken(const Wasserstein& request, netmesh_status status) {
    return {Exit::internal, "netmesh: internal error: the distance in degree " + std::to_string(request.degree) +
                                " is not known within --error " + number_text(request.relative_error) + ": " +
                                netmesh_status_text(status)};
}

// The distance in each of the degrees.
template <class Request>
Outcome measure(Request request, const std::vector<netmesh_pair> (&pairs)[2], const std::set<std::uint32_t>& degrees,
                std::vector<DegreeDistance>* distances) {
    request.monitor.poll = poll;
    request.pairs_a = pairs[0].data();
    request.pairs_b = pairs[1].data();
    request.count_a = pairs[0].size();
    request.count_b = pairs[1].size();
    request.scratch_bytes = scratch_bytes(request);
    platform::Reservation scratch;
    if (request.scratch_bytes == SIZE_MAX || !scratch.reserve(request.scratch_bytes)) {
        return {Exit::memory, "netmesh: no memory to compare diagrams of " + grouped_text(pairs[0].size()) + " and " +
                                  counted(pairs[1].size(), "bar", "bars")};
    }
    request.scratch = scratch.base();
    for (const std::uint32_t degree : degrees) {
        request.degree = degree;
        netmesh_status status;
        distances->push_back(call(request, &status));
        if (status == NETMESH_CANCELLED) return {Exit::cancelled, "netmesh: cancelled"};
        if (status != NETMESH_OK) return broken(request, status);
    }
    return {};
}

Outcome measure(const Options& options, const std::vector<netmesh_pair> (&pairs)[2],
                const std::set<std::uint32_t>& degrees, std::vector<DegreeDistance>* distances) {
    if (options.order == 0) {
        Bottleneck request;
        request.scale = options.log ? NETMESH_SCALE_LOG : NETMESH_SCALE_PLAIN;
        return measure(request, pairs, degrees, distances);
    }
    Wasserstein request;
    request.order = options.order;
    if (options.relative_error > 0) request.relative_error = options.relative_error;
    return measure(request, pairs, degrees, distances);
}

}  // namespace

Outcome run_distance(const Options& options) {
    const double start = platform::seconds_now();
    if (options.positionals[0] == "-" && options.positionals[1] == "-") {
        return usage_error("only one of the diagrams can come from stdin");
    }
    std::vector<netmesh_pair> pairs[2];
    std::set<std::uint32_t> degrees;
    for (int i = 0; i < 2; i++) {
        const Outcome outcome = read_pairs(options.positionals[i], &pairs[i], &degrees);
        if (!outcome.good()) return outcome;
        for (const netmesh_pair& pair : pairs[i])
            if (options.log && pair.birth < 0)
                return file_error(shown_name(options.positionals[i]),
                                  "a birth at " + number_text(pair.birth) + " has no logarithm; leave --log out");
    }
    RunReport run;
    run.options = &options;
    run.read_seconds = platform::seconds_now() - start;
    run.distances.emplace();
    const Outcome outcome = measure(options, pairs, degrees, &*run.distances);
    if (!outcome.good()) return outcome;
    run.total_seconds = platform::seconds_now() - start;
    return write_files({{"", [&](TextWriter& out) {
                             if (options.json) {
                                 out << json_report(run);
                                 return;
                             }
                             for (const DegreeDistance& d : *run.distances) out << d.degree << ' ' << d.value << '\n';
                         }}});
}

}  // namespace netmesh::tool
