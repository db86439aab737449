#include <cstdio>

#include "tools/io/numbers.hpp"
#include "tools/report/report.hpp"

namespace netmesh::tool {

namespace {

std::string counted(std::uint64_t count, const char* one, const char* many) {
    return grouped_text(count) + " " + (count == 1 ? one : many);
}

std::string seconds_text(double seconds) {
    char text[40];
    std::snprintf(text, sizeof text, seconds < 0.0995 ? "%.3f" : "%.2f", seconds);
    return text;
}

std::string mesh_lines(const netmesh_report& engine) {
    std::string text = "mesh     " + counted(engine.vertices, "vertex", "vertices");
    if (engine.is_mesh != 0) {
        text += " (" + counted(engine.steiner, "Steiner point", "Steiner points") + ", " + grouped_text(engine.exempt) +
                " on the boundary)";
    }
    text += ", " + counted(engine.cells, "cell", "cells") + "\n";
    if (engine.cages > 0) {
        text += "cages    " + grouped_text(engine.cages) + " kept of " + grouped_text(engine.cages_made) + " made\n";
    }
    if (engine.is_mesh != 0) {
        text += "quality  aspect ratio at most " + rounded_text(engine.aspect_ratio_max, 5) + " (tau " +
                rounded_text(engine.tau, 5) + ")\n";
    }
    return text;
}

std::string diagram_lines(const netmesh_report& engine) {
    std::string text = "diagram ";
    for (std::uint32_t degree = 0; degree <= engine.max_degree; degree++) {
        text += std::string(degree == 0 ? " " : ", ") + "H" + std::to_string(degree) + " " +
                grouped_text(engine.pairs[degree]);
    }
    text += std::string("; filter ") + filter_name(engine.filter);
    if (engine.filter != NETMESH_FILTER_ALPHA) text += std::string(", ") + values_name(engine.values) + " values";
    text += "\ncertified ratio " + rounded_text(engine.certified_ratio, 6);
    if (engine.certified_from > 0) text += " from radius " + rounded_text(engine.certified_from, 6);
    return text + " to the offsets of the points\n";
}

std::string cost_lines(const RunReport& run) {
    const netmesh_report& engine = *run.engine;
    std::string text = "memory   peak " + bytes_text(engine.peak_bytes) + " of " + bytes_text(engine.block_bytes) +
                       (run.options->memory_bytes == 0 ? " reserved\n" : " given\n");
    text += "time     " + seconds_text(run.total_seconds) + " s: read " + seconds_text(run.read_seconds);
    for (int stage = 1; stage < NETMESH_STAGE_COUNT && run.clock; stage++) {
        const netmesh_stage which = static_cast<netmesh_stage>(stage);
        const double seconds = run.clock->seconds(which);
        if (seconds > 0) text += std::string(", ") + stage_name(which) + " " + seconds_text(seconds);
    }
    text += ", write " + seconds_text(run.write_seconds) + "\n";
    char digits[48];
    std::snprintf(digits, sizeof digits, "result   fingerprint %016llx\n",
                  static_cast<unsigned long long>(engine.fingerprint));
    return text + digits;
}

}  // namespace

std::string text_report(const RunReport& run) {
    std::string text;
    if (run.engine) {
        const netmesh_report& engine = *run.engine;
        text += "input    " + counted(engine.points, "point", "points") + " in R^" + std::to_string(engine.dim);
        if (engine.duplicates > 0) text += ", " + counted(engine.duplicates, "duplicate", "duplicates") + " merged";
        text += "\n" + mesh_lines(engine);
        if (engine.has_diagram != 0) text += diagram_lines(engine);
    }
    if (run.checked) {
        for (const std::string& item : *run.checked) text += "checked  " + item + "\n";
    }
    if (run.engine) text += cost_lines(run);
    return text;
}

}  // namespace netmesh::tool
