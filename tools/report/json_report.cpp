#include "tools/io/numbers.hpp"
#include "tools/report/json.hpp"
#include "tools/report/report.hpp"

namespace netmesh::tool {

namespace {

void write_options(Json& json, const RunReport& run) {
    const Options& options = *run.options;
    const bool persists = options.command == Command::persist;
    json.key("options");
    json.open('{');
    const bool meshes = run.engine && run.engine->is_mesh != 0;
    json.key("tau");
    if (meshes) {
        json.value(run.engine->tau);
    } else if (options.tau) {
        json.value(*options.tau);
    } else {
        json.null();
    }
    json.key("method");
    meshes ? json.value(method_name(options.method)) : json.null();
    json.entry("finish", options.finish);
    json.key("filter");
    persists&& run.engine ? json.value(filter_name(run.engine->filter)) : json.null();
    json.key("values");
    persists&& run.engine ? json.value(values_name(run.engine->values)) : json.null();
    json.key("max_degree");
    persists&& run.engine ? json.value(run.engine->max_degree) : json.null();
    json.key("memory");
    options.memory_bytes != 0 ? json.value(static_cast<std::uint64_t>(options.memory_bytes)) : json.null();
    json.entry("seed", options.seed);
    json.entry("all", options.all);
    json.entry("check", options.check);
    json.close('}');
}

void write_input(Json& json, const RunReport& run) {
    json.key("input");
    if (!run.engine) {
        json.null();
        return;
    }
    json.open('{');
    json.entry("points", run.engine->points);
    json.entry("duplicates", run.engine->duplicates);
    json.entry("dim", run.engine->dim);
    json.key("fingerprint");
    json.fingerprint(run.engine->input_fingerprint);
    json.close('}');
}

void write_mesh(Json& json, const RunReport& run) {
    json.key("mesh");
    if (!run.engine) {
        json.null();
        return;
    }
    const netmesh_report& engine = *run.engine;
    json.open('{');
    json.entry("vertices", engine.vertices);
    json.entry("steiner", engine.steiner);
    json.entry("boundary", engine.exempt);
    json.entry("cells", engine.cells);
    if (engine.is_mesh != 0) {
        json.entry("aspect_ratio_max", engine.aspect_ratio_max);
        json.entry("tau", engine.tau);
        json.key("domain");
        json.open('[');
        for (std::uint32_t k = 0; k <= engine.dim; k++) json.value(engine.domain[k]);
        json.close(']');
        if (engine.method == NETMESH_METHOD_NETMESH) {
            json.entry("cages", engine.cages);
            json.entry("cages_made", engine.cages_made);
            json.entry("touches", engine.touches);
        }
    } else {
        json.null_entry("aspect_ratio_max");
        json.null_entry("tau");
        json.null_entry("domain");
    }
    json.close('}');
}

void write_bars(Json& json, const std::vector<Bar>& bars) {
    json.key("bars");
    json.open('[');
    for (const Bar& bar : bars) {
        json.open('[');
        json.value(bar.degree);
        json.value(bar.birth);
        json.value(bar.death);  // infinity is null
        json.close(']');
    }
    json.close(']');
}

void write_diagram(Json& json, const RunReport& run) {
    json.key("diagram");
    if (!run.engine || run.engine->has_diagram == 0) {
        json.null();
        return;
    }
    const netmesh_report& engine = *run.engine;
    json.open('{');
    json.key("pairs");
    json.open('[');
    for (std::uint32_t degree = 0; degree <= engine.max_degree; degree++) json.value(engine.pairs[degree]);
    json.close(']');
    json.entry("certified_ratio", engine.certified_ratio);
    json.entry("reference", "closed offsets of the points in R^" + std::to_string(engine.dim));
    json.entry("from", engine.certified_from);
    json.entry("units", "radius");
    json.entry("field", "Z/2");
    json.entry("simplices", engine.simplices);
    if (run.bars != nullptr) write_bars(json, *run.bars);
    json.close('}');
}

void write_predicates(Json& json, const char* name, const std::uint64_t* calls) {
    static constexpr const char* stages[] = {"cached", "float", "integer", "exact", "tie"};
    json.key(name);
    json.open('{');
    for (int i = 0; i < NETMESH_PREDICATE_STAGES; i++) json.entry(stages[i], calls[i]);
    json.close('}');
}

void write_costs(Json& json, const RunReport& run) {
    json.key("memory");
    if (run.engine || run.plan_bytes) {
        json.open('{');
        json.key("arena_bytes");
        run.engine ? json.value(run.engine->block_bytes) : json.null();
        json.key("peak_bytes");
        run.engine ? json.value(run.engine->peak_bytes) : json.null();
        if (run.plan_bytes) json.entry("plan_bytes", *run.plan_bytes);
        json.close('}');
    } else {
        json.null();
    }
    json.key("predicates");
    if (run.engine) {
        json.open('{');
        write_predicates(json, "in_ball", run.engine->predicate_calls);
        write_predicates(json, "orient", run.engine->orient_calls);
        json.close('}');
    } else {
        json.null();
    }
    json.key("seconds");
    json.open('{');
    json.entry("read", run.read_seconds);
    for (int stage = 1; stage < NETMESH_STAGE_COUNT; stage++) {
        const netmesh_stage which = static_cast<netmesh_stage>(stage);
        json.key(stage_name(which));
        run.clock ? json.value(run.clock->seconds(which)) : json.null();
    }
    json.entry("write", run.write_seconds);
    json.entry("total", run.total_seconds);
    json.close('}');
}

}  // namespace

std::string json_report(const RunReport& run) {
    Json json;
    json.open('{');
    json.entry("schema", std::uint64_t{1});
    std::string version = version_text();
    version = version.substr(version.find(' ') + 1);
    version.pop_back();
    json.entry("version", version);
    json.entry("command", command_name(run.options->command));
    write_options(json, run);
    write_input(json, run);
    write_mesh(json, run);
    write_diagram(json, run);
    if (run.checked) {
        json.key("checked");
        json.open('[');
        for (const std::string& item : *run.checked) json.value(item);
        json.close(']');
    }
    write_costs(json, run);
    json.key("fingerprint");
    run.engine ? json.fingerprint(run.engine->fingerprint) : json.null();
    json.close('}');
    return json.text();
}

}  // namespace netmesh::tool
