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
#include "tools/io/points.hpp"
#include "tools/io/provenance.hpp"

namespace netmesh::tool {

namespace {

// What a diagram's births and deaths are, as far as its file says.
enum class Scale { unknown, radii, squares, values, diameters };

struct Diagram {
    std::string name;
    Scale scale = Scale::unknown;
    std::uint64_t squares_line = 0;
    std::vector<netmesh_pair> pairs;
};

void find_scale(std::string_view content, Diagram* diagram) {
    const Head head = head_lines(content);
    const HeadLine *const filter = find_line(head, "filter"), *const squares = find_line(head, "squares");
    if (is_of_ripser(content)) {
        diagram->scale = Scale::diameters;
    } else if (squares != nullptr) {
        diagram->scale = Scale::squares;
        diagram->squares_line = squares->number;
    } else if (filter != nullptr) {
        diagram->scale = filter->value == filter_name(NETMESH_FILTER_FUNCTION) ? Scale::values : Scale::radii;
    }
}

Outcome read_diagram(const std::string& path, Diagram* diagram, std::set<std::uint32_t>* degrees) {
    std::string content;
    std::vector<Bar> bars;
    diagram->name = shown_name(path);
    Outcome outcome = read_content(path, &content);
    if (outcome.good()) outcome = parse_any_diagram(content, diagram->name, &bars);
    if (!outcome.good()) return outcome;
    find_scale(content, diagram);
    for (const Bar& bar : bars) {
        diagram->pairs.push_back({sizeof(netmesh_pair), bar.degree, bar.birth, bar.death});
        degrees->insert(bar.degree);
    }
    return {};
}

// `one` beside `other`: squares have no distance to anything else, and diameters are twice the radii.
Outcome fit_scale(const Options& options, Diagram* one, const Diagram& other) {
    if (one->scale == other.scale || other.scale == Scale::squares) return {};
    if (one->scale == Scale::squares && other.scale != Scale::unknown)
        return line_error(one->name, one->squares_line,
                          "\"# squares\": births and deaths are squares, those of " + other.name +
                              " are not; make both diagrams with --squares, or both without");
    if (one->scale != Scale::diameters) return {};
    if (other.scale != Scale::radii) {
        tell_warning(one->name, "ripser's births and deaths are diameters; they are taken as they are, and " +
                                    other.name + " does not say whether its own are radii, which are half as large");
        return {};
    }
    tell_note(options, one->name,
              "ripser's births and deaths are diameters; they are halved, as those of " + other.name + " are radii");
    for (netmesh_pair& pair : one->pairs) {
        pair.birth /= 2;
        pair.death /= 2;
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
Outcome measure(Request request, const Diagram (&diagrams)[2], const std::set<std::uint32_t>& degrees,
                std::vector<DegreeDistance>* distances) {
    request.monitor.poll = poll;
    request.pairs_a = diagrams[0].pairs.data();
    request.pairs_b = diagrams[1].pairs.data();
    request.count_a = diagrams[0].pairs.size();
    request.count_b = diagrams[1].pairs.size();
    request.scratch_bytes = scratch_bytes(request);
    platform::Reservation scratch;
    if (request.scratch_bytes == SIZE_MAX || !scratch.reserve(request.scratch_bytes)) {
        return {Exit::memory, "netmesh: no memory to compare diagrams of " + grouped_text(diagrams[0].pairs.size()) +
                                  " and " + counted(diagrams[1].pairs.size(), "bar", "bars")};
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

Outcome measure(const Options& options, const Diagram (&diagrams)[2], const std::set<std::uint32_t>& degrees,
                std::vector<DegreeDistance>* distances) {
    if (options.order == 0) {
        Bottleneck request;
        request.scale = options.log ? NETMESH_SCALE_LOG : NETMESH_SCALE_PLAIN;
        return measure(request, diagrams, degrees, distances);
    }
    Wasserstein request;
    request.order = options.order;
    if (options.relative_error > 0) request.relative_error = options.relative_error;
    return measure(request, diagrams, degrees, distances);
}

}  // namespace

Outcome run_distance(const Options& options) {
    const double start = platform::seconds_now();
    if (options.positionals[0] == "-" && options.positionals[1] == "-") {
        return usage_error("only one of the diagrams can come from stdin");
    }
    Diagram diagrams[2];
    std::set<std::uint32_t> degrees;
    for (int i = 0; i < 2; i++) {
        const Outcome outcome = read_diagram(options.positionals[i], &diagrams[i], &degrees);
        if (!outcome.good()) return outcome;
        for (const netmesh_pair& pair : diagrams[i].pairs)
            if (options.log && pair.birth < 0)
                return file_error(diagrams[i].name,
                                  "a birth at " + number_text(pair.birth) + " has no logarithm; leave --log out");
    }
    Outcome outcome = fit_scale(options, &diagrams[0], diagrams[1]);
    if (outcome.good()) outcome = fit_scale(options, &diagrams[1], diagrams[0]);
    if (!outcome.good()) return outcome;
    RunReport run;
    run.options = &options;
    run.read_seconds = platform::seconds_now() - start;
    run.distances.emplace();
    outcome = measure(options, diagrams, degrees, &*run.distances);
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
