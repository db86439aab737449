#include "tools/report/figures.hpp"
#include "tools/report/report.hpp"

namespace netmesh::tool {

namespace {

// A member that is null unless there is something to say.
template <class T> void write_known(Json& json, const char* name, bool known, const T& value) {
    known ? json.entry(name, value) : json.null_entry(name);
}

// What the diagram or the vineyard is of; nothing for other commands.
struct Said {
    const char* filter = nullptr;
    const char* values = nullptr;
};

Said choice_of(const RunReport& run, const netmesh_report& engine) {
    const bool given = engine.vineyard.present != 0 && engine.vineyard.filter == NETMESH_FILTER_NONE;
    if (run.options->command == Command::vineyard && !given)
        return {filter_name(engine.vineyard.filter), values_name(engine.vineyard.values)};
    if (run.options->command != Command::persist) return {};
    return {filter_name(engine.diagram.filter), values_name(engine.diagram.values)};
}

// Its vectors.
void write_lattice(Json& json, const Lattice& lattice) {
    json.key("lattice");
    json.open('[');
    for (std::uint32_t i = 0; i < lattice.count(); i++) {
        json.open('[');
        for (std::uint32_t k = 0; k < lattice.dim; k++) json.value(lattice.vectors[i * lattice.dim + k]);
        json.close(']');
    }
    json.close(']');
}

void write_options(Json& json, const RunReport& run, const netmesh_report& engine) {
    const Options& options = *run.options;
    const netmesh_mesh_report& mesh = engine.mesh;
    const Said choice = choice_of(run, engine);
    json.key("options");
    json.open('{');
    const netmesh_request& asked = options.request;
    const netmesh_sizes& sizes = asked.mesh.sizes;
    const double tau = mesh.tau > 0 ? mesh.tau : asked.mesh.tau;
    write_known(json, "tau", tau > 0, tau);
    write_known(json, "theta", asked.goal.theta > 0, asked.goal.theta);
    const double eps = asked.goal.eps > 0 ? asked.goal.eps : sizes.eps;
    write_known(json, "eps", eps > 0, eps);
    write_known(json, "size_at_inputs", sizes.at_inputs > 0, sizes.at_inputs);
    write_known(json, "size_growth", sizes.at_inputs > 0, sizes.growth);
    write_known(json, "domain_factor", asked.mesh.domain_factor > 0, asked.mesh.domain_factor);
    write_known(json, "net_spacing", asked.mesh.net_spacing > 0, asked.mesh.net_spacing);
    // As --method has it: cages of the thesis are for cage_kind to say.
    const bool has_thesis_cages = mesh.method == NETMESH_METHOD_THESIS;
    write_known(json, "method", mesh.is_mesh != 0,
                method_name(has_thesis_cages ? NETMESH_METHOD_NETMESH : mesh.method));
    write_known(json, "cage_kind", !options.cages.empty(), options.cages.c_str());
    json.entry("finish", asked.mesh.finish != 0);
    write_known(json, "filter", choice.filter != nullptr, choice.filter);
    write_known(json, "values", choice.values != nullptr, choice.values);
    write_known(json, "max_degree", engine.diagram.present != 0, engine.diagram.max_degree);
    write_known(json, "k", options.command == Command::persist && engine.diagram.k > 0, engine.diagram.k);
    if (options.table.lattice.kind != Lattice::none) write_lattice(json, options.table.lattice);
    write_known(json, "memory", options.memory_bytes != 0, static_cast<std::uint64_t>(options.memory_bytes));
    json.entry("seed", asked.seed);
    json.entry("all", asked.keep_zero_pairs != 0);
    json.entry("check", options.check);
    json.close('}');
}

// The certificate by scale (netmesh_scale_step), with the error in place of the ratio for a function; with the bars, in
// their order: birth from, to, death from, to, and whether the bar is certified to exist.
void write_bounds(Json& json, const RunReport& run) {
    json.key("scale_steps");
    json.open('[');
    for (const netmesh_scale_step& step : run.bounds->steps) {
        json.open('[');
        const double last = run.bounds->by_error ? step.error : step.ratio;
        for (const double x : {step.from, step.low, step.high, step.reach, last}) json.value(x);
        json.close(']');
    }
    json.close(']');
    if (run.bars == nullptr) return;
    json.key("bounds");
    json.open('[');
    for (const netmesh_bar_bounds& b : run.bounds->bars) {
        json.open('[');
        for (const double x : {b.birth_low, b.birth_high, b.death_low, b.death_high}) json.value(x);
        json.value(b.certain != 0);
        json.close(']');
    }
    json.close(']');
}

// What JSON says of a diagram besides the library's figures. `separation`: the least radius of a ball that belongs
// to a scale alone, in radii of the scale (7.6: at least (1 - theta) / (2 theta)); the joined diagram needs 2.
void add_to_diagram(Json& json, const RunReport& run, std::string_view path) {
    if (path == "diagram.certified_ratio") {
        json.entry("reference", reference_name(*run.engine));
    } else if (path == "diagram.certified_from") {
        const bool by_values = run.engine->diagram.filter == NETMESH_FILTER_FUNCTION ||
                               (run.engine->input.dim == 0 && !run.options->distances);
        const bool by_squares = run.engine->input.squares != 0;
        json.entry("units", by_values ? "value" : by_squares ? "squared radius" : "radius");
        json.entry("field", "Z/2");
    } else if (path == "diagram.scales.separation") {
        json.entry("separation_needed", 2.0);
    } else if (path == "diagram.certain") {
        if (run.bounds != nullptr) write_bounds(json, run);
        if (run.bars != nullptr) write_json_bars(json, *run.bars);
    }
}

void add_to_vineyard(Json& json, const netmesh_vineyard_report& report, const Vines& vines, std::string_view path) {
    if (path != "vineyard.transpositions") return;
    json.key("certified_ratios");
    json.open('[');
    for (const double ratio : vines.ratios) json.value(ratio);
    json.close(']');
    json.entry("units", report.filter == NETMESH_FILTER_NONE ? "value" : "radius");
    json.entry("field", "Z/2");
}

// Infinity is null.
void write_distances(Json& json, const RunReport& run) {
    const auto write = [&](const char* name, double DegreeDistance::*number) {
        json.key(name);
        json.open('[');
        for (const DegreeDistance& d : *run.distances) {
            json.open('[');
            json.value(d.degree);
            json.value(d.*number);
            json.close(']');
        }
        json.close(']');
    };
    json.entry("scale", run.options->log ? "log" : "plain");
    if (run.options->order > 0) json.entry("order", run.options->order);
    write("distances", &DegreeDistance::value);
    if (run.options->order > 0) write("lower_bounds", &DegreeDistance::lower);
}

void write_checked(Json& json, const std::vector<std::string>& checked) {
    json.key("checked");
    json.open('[');
    for (const std::string& item : checked) json.value(item);
    json.close(']');
}

void write_seconds(Json& json, const RunReport& run) {
    json.key("seconds");
    json.open('{');
    json.entry("read", run.read_seconds);
    for (int stage = 1; stage < NETMESH_STAGE_COUNT; stage++) {
        const netmesh_stage which = static_cast<netmesh_stage>(stage);
        write_known(json, stage_name(which), run.clock.has_value(), run.clock ? run.clock->seconds(which) : 0);
    }
    json.entry("write", run.write_seconds);
    json.entry("total", run.total_seconds);
    json.close('}');
}

void open_report(Json& json, Command command) {
    json.open('{');
    json.entry("schema", std::uint64_t{1});
    json.entry("version", netmesh_version_text());
    write_known(json, "command", command != Command::none, command_name(command));
}

}  // namespace

std::string json_error(Command command, const Outcome& outcome) {
    constexpr std::string_view program = "netmesh: ";
    std::string_view message = outcome.message;
    if (message.substr(0, program.size()) == program) message.remove_prefix(program.size());
    Json json;
    open_report(json, command);
    json.key("error");
    json.open('{');
    json.entry("code", static_cast<std::uint64_t>(outcome.exit));
    json.entry("message", message);
    write_known(json, "file", !outcome.file.empty(), std::string_view(outcome.file));
    write_known(json, "line", outcome.line > 0, outcome.line);
    write_known(json, "field", outcome.field > 0, outcome.field);
    json.close('}');
    json.close('}');
    return json.text();
}

std::string json_text(Command command, const char* key, const std::string& text) {
    Json json;
    open_report(json, command);
    json.null_entry("error");
    if (key != nullptr) json.entry(key, std::string_view(text));
    json.close('}');
    return json.text();
}

std::string json_report(const RunReport& run) {
    const netmesh_report engine = run.engine.value_or(sized<netmesh_report>());
    const std::vector<netmesh_figure> figures = figures_of(engine);
    Json json;
    open_report(json, run.options->command);
    json.null_entry("error");
    write_options(json, run, engine);
    write_part(json, figures, "input", [&](std::string_view path) {
        if (path != "input.dim" || engine.input.dim != 0) return;
        json.entry("simplices", engine.vineyard.present != 0 ? engine.vineyard.simplices : engine.diagram.simplices);
    });
    write_part(json, figures, "mesh");
    write_part(json, figures, "diagram", [&](std::string_view path) { add_to_diagram(json, run, path); });
    if (run.distances) write_distances(json, run);
    if (run.analysis) {
        json.key("analysis");
        write_figures(json, figures_of(*run.analysis));
    }
    if (run.vines != nullptr) {
        const Vines& vines = *run.vines;
        write_part(json, figures, "vineyard",
                   [&](std::string_view path) { add_to_vineyard(json, engine.vineyard, vines, path); });
    }
    if (run.checked) write_checked(json, *run.checked);
    const auto add_plan = [&](std::string_view path) {
        if (path == "memory.peak_bytes" && run.plan_bytes) json.entry("plan_bytes", *run.plan_bytes);
    };
    write_part(json, figures, "memory", add_plan, run.plan_bytes.has_value());
    write_part(json, figures, "predicates");
    write_seconds(json, run);
    write_part(json, figures, "fingerprint");
    json.close('}');
    return json.text();
}

}  // namespace netmesh::tool
