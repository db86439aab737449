#include "tools/commands/value_vineyard.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

netmesh_simplices complex_of(const ValueInput& input) {
    netmesh_simplices simplices = sized<netmesh_simplices>();
    simplices.vertices = input.complex.vertices.data();
    simplices.starts = input.complex.starts.data();
    simplices.simplex_count = input.complex.count();
    simplices.vertex_count = input.complex.vertices.size();
    return simplices;
}

netmesh_request request_of(const Options& options, const netmesh_simplices& simplices) {
    Request request(&netmesh_filter_simplices);
    request.simplices = &simplices;
    request.max_degree = options.request.max_degree;
    return request;
}

// The values of all simplices at a step, from 0 on.
std::vector<double> values_at(const ValueInput& input, std::size_t step) {
    const SimplexFile& complex = input.complex;
    const double* const given = input.values.values.data() + step * input.values.width;
    if (!input.values.by_vertex) return {given, given + complex.count()};
    std::vector<std::pair<std::uint32_t, double>> of;  // vertices
    for (std::size_t i = 0, n = 0; i < complex.count(); i++) {
        if (complex.starts[i + 1] - complex.starts[i] == 1)
            of.emplace_back(complex.vertices[complex.starts[i]], given[n++]);
    }
    std::sort(of.begin(), of.end());
    std::vector<double> values;
    for (std::size_t i = 0; i < complex.count(); i++) {
        double most = -HUGE_VAL;
        for (std::uint64_t v = complex.starts[i]; v < complex.starts[i + 1]; v++) {
            const auto at = std::lower_bound(of.begin(), of.end(), std::make_pair(complex.vertices[v], -HUGE_VAL));
            most = std::max(most, at->second);
        }
        values.push_back(most);
    }
    return values;
}

}  // namespace

Outcome explain_fault(const SimplexFile& file, const double* values, const netmesh_detail& detail) {
    const std::uint64_t at = detail.index_a;
    const std::string it = "simplex " + simplex_text(file, at) + ": ";
    switch (detail.fault) {
    case NETMESH_FAULT_FACE_MISSING:
        return file.lines.fault(at, it + "its face " + simplex_text(file, at, detail.index_b) + " is missing");
    case NETMESH_FAULT_FACE_LATER:
        return file.lines.fault(at, it + "enters at " + number_text(values[at]) + ", before its face " +
                                        simplex_text(file, detail.index_b) + " of " + file.lines.place(detail.index_b) +
                                        " at " + number_text(values[detail.index_b]));
    case NETMESH_FAULT_LISTED_TWICE:
        return file.lines.fault(at, it + "is listed in " + file.lines.place(detail.index_b) + " already");
    default: return file.lines.fault(at, it + detail.message);
    }
}

Outcome read_value_input(const Options& options, const std::string& complex_path, ValueInput* input) {
    for (const auto& [name, value] : options.given) {
        if (name == "--k" || name == "--filter" || name == "--tau" || name == "--seed")
            return usage_error("option " + name + " does not go with --values " + options.values_path +
                               ", values of the simplices of a complex");
    }
    if (complex_path == "-" && options.values_path == "-") return usage_error("two inputs cannot both come from stdin");
    std::string content;
    input->complex.lines.name = shown_name(complex_path);
    input->values.lines.name = shown_name(options.values_path);
    Outcome outcome = read_content(complex_path, &content);
    if (outcome.good()) outcome = parse_simplices(content, &input->complex);
    if (outcome.good()) outcome = read_content(options.values_path, &content);
    if (outcome.good()) outcome = parse_values(content, input->complex, &input->values);
    return outcome;
}

Outcome make_value_vineyard(const Options& options, const ValueInput& input, Session& session, Vines* vines) {
    netmesh_simplices simplices = complex_of(input);
    simplices.entries = input.values.values.data();
    simplices.step_count = input.values.count();
    simplices.by_vertex = input.values.by_vertex ? 1 : 0;
    netmesh_request request = request_of(options, simplices);
    request.vines = &netmesh_vines;
    const Outcome outcome = session.run(plan(request), input.complex.lines, [&](Session& s) {
        const netmesh_status status = persist(s, request);
        if (status == NETMESH_OK) *vines = vines_of(s.engine());
        return status;
    });
    const netmesh_detail detail = session.engine().detail();
    if (session.engine().status() != NETMESH_NOT_A_COMPLEX) return outcome;
    if (detail.step == 0) return explain_fault(input.complex, nullptr, detail);
    const Outcome fault =
        explain_fault(input.complex, input.values.values.data() + (detail.step - 1) * input.values.width, detail);
    return {fault.exit, input.values.lines.where(detail.step - 1) + ": " + fault.message};
}

Outcome check_value_vineyard(const Options& options, const ValueInput& input, const Vines& vines, Session& session,
                             std::string* fault) {
    netmesh_simplices simplices = complex_of(input);
    const netmesh_request request = request_of(options, simplices);
    for (std::size_t i = 0; i < input.values.count() && fault->empty(); i++) {
        const std::vector<double> values = values_at(input, i);
        simplices.entries = values.data();
        const Outcome outcome =
            session.run(plan(request), input.complex.lines, [&](Session& s) { return persist(s, request); });
        if (!outcome.good()) return outcome;
        const std::uint32_t step = static_cast<std::uint32_t>(i + 1);
        if (first_difference(diagram_at(vines, step), bars_of(session.engine())) != SIZE_MAX)
            *fault = "the diagram at step " + std::to_string(step) + " is not that of a fresh computation";
    }
    return {};
}

}  // namespace netmesh::tool
