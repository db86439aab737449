#include "tools/io/numbers.hpp"
#include "tools/report/json.hpp"
#include "tools/report/report.hpp"

namespace netmesh::tool {

namespace {

void write_options(Json& json, const RunReport& run) {
    const Options& options = *run.options;
    const bool persists = options.command == Command::persist || options.command == Command::vineyard;
    json.key("options");
    json.open('{');
    const bool meshes = run.engine && run.engine->is_mesh != 0;
    json.key("tau");
    if (meshes && run.engine->tau > 0) {
        json.value(run.engine->tau);
    } else if (options.tau) {
        json.value(*options.tau);
    } else {
        json.null();
    }
    json.key("theta");
    options.theta > 0 ? json.value(options.theta) : json.null();
    json.key("eps");
    options.eps > 0 ? json.value(options.eps) : json.null();
    json.key("method");
    meshes ? json.value(run.engine->ratio > 0 ? "certificate" : method_name(run.engine->method)) : json.null();
    json.entry("finish", options.finish);
    json.key("filter");
    persists&& run.engine ? json.value(filter_name(run.engine->filter)) : json.null();
    json.key("values");
    persists&& run.engine ? json.value(values_name(run.engine->values)) : json.null();
    json.key("max_degree");
    run.engine&& run.engine->has_diagram != 0 ? json.value(run.engine->max_degree) : json.null();
    json.key("k");
    persists&& run.engine&& run.engine->k > 0 ? json.value(run.engine->k) : json.null();
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
    if (run.engine->dim == 0) {
        json.null_entry("points");
        json.null_entry("duplicates");
        json.null_entry("dim");
        json.entry("simplices", run.engine->simplices);
        json.key("fingerprint");
        json.fingerprint(run.engine->input_fingerprint);
        json.close('}');
        return;
    }
    json.entry("points", run.engine->points);
    json.entry("duplicates", run.engine->duplicates);
    json.entry("dim", run.engine->dim);
    json.key("fingerprint");
    json.fingerprint(run.engine->input_fingerprint);
    json.close('}');
}

void write_audit(Json& json, const netmesh_audit& audit) {
    json.key("audit");
    json.open('{');
    if ((audit.what & NETMESH_AUDIT_LOCATION) != 0) {
        json.key("location");
        json.open('{');
        json.key("load");
        json.open('[');
        for (std::uint32_t k = 0; k < audit.rounds; k++) json.value(static_cast<std::uint64_t>(audit.load[k]));
        json.close(']');
        json.entry("nets", audit.nets);
        json.entry("nets_max", audit.nets_max);
        json.entry("ply_max", audit.ply_max);
        json.entry("ply_mean", audit.ply_mean);
        json.entry("touches_max", audit.touches_max);
        json.entry("touches_mean", audit.touches_mean);
        json.entry("tests_mean", audit.tests_mean);
        json.close('}');
    }
    if ((audit.what & NETMESH_AUDIT_QUALITY) != 0) {
        json.key("quality");
        json.open('{');
        json.entry("meshes", audit.meshes);
        json.entry("aspect_ratio_max", audit.aspect_ratio_max);
        json.entry("feature_ratio", audit.feature_ratio);
        json.entry("cage_ratio", audit.cage_ratio);
        json.entry("steiner_ratio", audit.steiner_ratio);
        json.entry("input_ratio", audit.input_ratio);
        json.close('}');
    }
    json.close('}');
}

void write_mesh(Json& json, const RunReport& run) {
    json.key("mesh");
    if (!run.engine || run.engine->cells == 0) {
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
        engine.tau > 0 ? json.entry("tau", engine.tau) : json.null_entry("tau");
        if (engine.ratio > 0) json.entry("ratio", engine.ratio);
        if (engine.focus_ratio > 0) {
            json.entry("focus_ratio", engine.focus_ratio);
            json.entry("focus_from", engine.focus_from);
            json.entry("focus_to", engine.focus_to);
        }
        if (engine.size_ratio_max > 0) json.entry("size_ratio_max", engine.size_ratio_max);
        json.key("domain");
        json.open('[');
        for (std::uint32_t k = 0; k <= engine.dim; k++) json.value(engine.domain[k]);
        json.close(']');
        if (engine.method == NETMESH_METHOD_NETMESH) {
            json.entry("cages", engine.cages);
            json.entry("cages_made", engine.cages_made);
            json.entry("touches", engine.touches);
        }
        if (engine.audit.what != 0) write_audit(json, engine.audit);
    } else {
        json.null_entry("aspect_ratio_max");
        json.null_entry("tau");
        json.null_entry("domain");
    }
    json.close('}');
}

void write_numbers(Json& json, const char* name, const double* values, int count) {
    json.key(name);
    json.open('[');
    for (int k = 0; k < count; k++) json.value(values[k]);
    json.close(']');
}

void write_fatness(Json& json, const char* name, const netmesh_fatness& part) {
    json.key(name);
    json.open('{');
    json.entry("cells", part.cells);
    json.entry("beta_max", part.beta_max);
    json.entry("beta_mean", part.beta_mean);
    json.entry("aspect_ratio_max", part.aspect_ratio_max);
    json.entry("edges", part.edges);
    json.entry("edges_bound", part.edges_bound);
    json.entry("faces", part.faces);
    json.entry("faces_bound", part.faces_bound);
    json.entry("degree_max", part.degree_max);
    json.entry("degree_share", part.degree_share);
    json.entry("planar_share", part.planar_share);
    json.entry("corners_share", part.corners_share);
    json.close('}');
}

void write_size(Json& json, const netmesh_analysis& a) {
    json.key("size");
    if ((a.what & NETMESH_ANALYSE_SIZE) == 0) {
        json.null();
        return;
    }
    json.open('{');
    json.entry("vertices", a.size);
    json.entry("lower", a.size_lower);
    json.entry("upper", a.size_upper);
    json.entry("feature_ratio", a.feature_ratio);
    json.entry("feature_ratio_bound", a.feature_ratio_bound);
    json.entry("theta", a.theta);
    json.entry("theta_limit", a.theta_limit);
    json.entry("theta_log_sum", a.theta_log_sum);
    write_numbers(json, "radii", a.radius, 3);
    write_numbers(json, "integral_lower", a.integral_lower, 3);
    write_numbers(json, "integral_upper", a.integral_upper, 3);
    json.entry("pace_lower", a.pace_lower);
    json.entry("pace_upper", a.pace_upper);
    json.entry("boxes", a.boxes);
    json.close('}');
}

void write_analysis(Json& json, const netmesh_analysis& a) {
    json.key("analysis");
    json.open('{');
    write_size(json, a);
    json.key("structure");
    json.open('{');
    json.entry("degree_max", a.degree_max);
    json.entry("degree_mean", a.degree_mean);
    json.entry("star_max", a.star_max);
    json.entry("star_mean", a.star_mean);
    json.entry("ply_points", a.ply_points);
    json.entry("ply_max", a.ply_max);
    json.entry("ply_mean", a.ply_mean);
    json.entry("balls", a.balls);
    json.entry("intersections_max", a.intersections_max);
    json.entry("intersections_mean", a.intersections_mean);
    json.close('}');
    json.key("fatness");
    json.open('{');
    write_fatness(json, "bounded", a.bounded);
    write_fatness(json, "inside", a.inside);
    json.entry("clipped_cells", a.clipped_cells);
    json.entry("clipped_beta_max", a.clipped_beta_max);
    json.entry("clipped_beta_mean", a.clipped_beta_mean);
    json.close('}');
    json.key("fingerprint");
    json.fingerprint(a.fingerprint);
    json.close('}');
}

// Next to the bars, in their order: birth from, to, death from, to, and whether the bar is surely real.
void write_bounds(Json& json, const RunReport& run) {
    json.key("certain");
    json.open('[');
    for (const std::uint64_t count : run.certain) json.value(count);
    json.close(']');
    json.key("scale_steps");
    json.open('[');
    for (const netmesh_scale_step& step : run.bounds->steps) {
        json.open('[');
        for (const double x : {step.from, step.reach, step.ratio}) json.value(x);
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

// `extended_ball`: the least radius of a ball that belongs to a scale alone, in radii of the scale (7.6: at least
// (1 - theta) / (2 theta)); the joined diagram needs `extended_ball_needed`.
void write_scales(Json& json, const netmesh_report& engine) {
    json.key("scales");
    json.open('{');
    json.entry("count", engine.scales);
    json.entry("extended_ball", engine.separation);
    json.entry("extended_ball_needed", 2.0);
    json.entry("largest_points", engine.scale_points_max);
    json.entry("largest_vertices", engine.scale_vertices_max);
    json.entry("vertices", engine.scale_vertices);
    json.close('}');
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
    json.key("essential");
    json.open('[');
    for (std::uint32_t degree = 0; degree <= engine.max_degree; degree++) json.value(engine.essential[degree]);
    json.close(']');
    json.entry("certified_ratio", engine.certified_ratio);
    json.entry("reference", reference_name(engine));
    json.entry("from", engine.certified_from);
    json.entry("units", engine.dim == 0 ? "value" : "radius");
    json.entry("field", "Z/2");
    json.entry("simplices", engine.simplices);
    if (engine.scales > 0) write_scales(json, engine);
    if (run.bounds != nullptr) write_bounds(json, run);
    if (run.bars != nullptr) write_bars(json, *run.bars);
    json.close('}');
}

void write_vineyard(Json& json, const RunReport& run) {
    const netmesh_report& engine = *run.engine;
    json.key("vineyard");
    json.open('{');
    json.entry("k_first", engine.k_first);
    json.entry("k_last", engine.k_last);
    json.entry("vines", engine.vines);
    json.entry("points", engine.vine_points);
    json.entry("transpositions", engine.transpositions);
    json.key("certified_ratios");
    json.open('[');
    for (const double ratio : run.vines->ratios) json.value(ratio);
    json.close(']');
    json.entry("units", "radius");
    json.entry("field", "Z/2");
    json.entry("simplices", engine.simplices);
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
    if (run.engine && run.engine->cells > 0) {
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
    if (run.distances) {
        json.entry("scale", run.options->log ? "log" : "plain");
        json.key("distances");
        json.open('[');
        for (const DegreeDistance& d : *run.distances) {
            json.open('[');
            json.value(d.degree);
            json.value(d.value);  // infinity is null
            json.close(']');
        }
        json.close(']');
    }
    if (run.analysis) write_analysis(json, *run.analysis);
    if (run.vines != nullptr) write_vineyard(json, run);
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
