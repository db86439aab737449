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

std::string audit_lines(const netmesh_audit& audit) {
    std::string text;
    if ((audit.what & NETMESH_AUDIT_LOCATION) != 0) {
        text += "located  in " + counted(audit.rounds, "round", "rounds") + " of " +
                counted(audit.nets, "net", "nets") + ", load";
        for (std::uint32_t k = 0; k < audit.rounds; k++) text += " " + grouped_text(audit.load[k]);
        text += "\n         in " + rounded_text(audit.ply_mean, 4) + " D-balls (at most " +
                grouped_text(audit.ply_max) + "), touched " + rounded_text(audit.touches_mean, 4) + " times (" +
                grouped_text(audit.touches_max) + ") a point\n";
    }
    if ((audit.what & NETMESH_AUDIT_QUALITY) != 0)
        text += "audited  " + counted(audit.meshes, "mesh", "meshes") + ", aspect ratio at most " +
                rounded_text(audit.aspect_ratio_max, 4) + "; K " + rounded_text(audit.feature_ratio, 4) +
                ", when inserted: shells " + rounded_text(audit.cage_ratio, 4) + ", cleaning " +
                rounded_text(audit.steiner_ratio, 4) + ", inputs " + rounded_text(audit.input_ratio, 4) + "\n";
    return text;
}

std::string goal_text(const netmesh_report& engine) {
    std::string text = "ratio " + rounded_text(engine.ratio, 5);
    if (engine.focus_ratio > 0) {
        text += ", " + rounded_text(engine.focus_ratio, 5) + " from radius " + rounded_text(engine.focus_from, 4) +
                " to " + rounded_text(engine.focus_to, 4);
    }
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
        text += "quality  aspect ratio at most " + rounded_text(engine.aspect_ratio_max, 5);
        text += engine.ratio > 0 ? ", refined by the certificate to " + goal_text(engine) + "\n"
                                 : " (tau " + rounded_text(engine.tau, 5) + ")\n";
        if (engine.size_ratio_max > 0)
            text += "size     cells reach " + rounded_text(engine.size_ratio_max, 5) + " of the size asked for\n";
        text += audit_lines(engine.audit);
    }
    return text;
}

std::string range_text(double from, double to) { return rounded_text(from, 4) + " and " + rounded_text(to, 4); }

std::string analysis_lines(const netmesh_analysis& a, bool caged) {
    std::string text;
    if ((a.what & NETMESH_ANALYSE_SIZE) != 0) {
        text += "bounds   " + grouped_text(a.size) + " vertices";
        if (caged)
            text += "; size bounds are for meshes without cages";
        else
            text += ", between " + range_text(a.size_lower, a.size_upper);
        text += "; feature size ratio " + rounded_text(a.feature_ratio, 4) +
                (caged ? "\n" : " (at most " + rounded_text(a.feature_ratio_bound, 4) + ")\n");
        text += "pace     theta " + rounded_text(a.theta, 4) + " (at most " + rounded_text(a.theta_limit, 4) +
                " in any order), sum of ln 1/theta " + rounded_text(a.theta_log_sum, 4) +
                "; feature size integral between " + range_text(a.integral_lower[0], a.integral_upper[0]) + "\n";
    }
    text += "stars    " + rounded_text(a.degree_mean, 4) + " neighbours (at most " + grouped_text(a.degree_max) +
            "), " + rounded_text(a.star_mean, 4) + " cells (" + grouped_text(a.star_max) + ")\n";
    text += "balls    ply " + rounded_text(a.ply_mean, 4) + " (at most " + grouped_text(a.ply_max) + "), each meets " +
            rounded_text(a.intersections_mean, 4) + " (" + grouped_text(a.intersections_max) + ")\n";
    const bool whole = a.inside.cells == 0;
    const netmesh_fatness& part = whole ? a.bounded : a.inside;
    return text + "fatness  " + rounded_text(part.beta_mean, 4) + " (at most " + rounded_text(part.beta_max, 4) +
           ") of " + grouped_text(part.cells) + (whole ? " bounded cells\n" : " cells inside the domain\n");
}

std::string scales_lines(const netmesh_report& engine) {
    std::string text = "scales   " + counted(engine.scales, "scale", "scales") + ", " +
                       counted(engine.scale_vertices, "vertex", "vertices") + " in all, the largest of " +
                       counted(engine.scale_points_max, "point", "points") + " and " +
                       counted(engine.scale_vertices_max, "vertex", "vertices") + "\n";
    if (engine.scales > 1) {
        text += "apart    each scale has a ball of " + rounded_text(engine.separation, 5) +
                " of its radii to itself (2 are needed)\n";
    }
    return text;
}

std::string diagram_lines(const netmesh_report& engine) {
    std::string text = "diagram ";
    for (std::uint32_t degree = 0; degree <= engine.max_degree; degree++) {
        text += std::string(degree == 0 ? " " : ", ") + "H" + std::to_string(degree) + " " +
                grouped_text(engine.pairs[degree]);
    }
    if (engine.dim == 0) return text + "\n";
    text += std::string("; filter ") + filter_name(engine.filter);
    if (engine.is_mesh != 0 || engine.filter == NETMESH_FILTER_BARYCENTRIC_RIPS)
        text += std::string(", ") + values_name(engine.values) + " values";
    text += "\ncertified ratio " + rounded_text(engine.certified_ratio, 6);
    if (engine.certified_from > 0) text += " from radius " + rounded_text(engine.certified_from, 6);
    return text + " to the " + reference_name(engine) + "\n";
}

std::string vineyard_lines(const netmesh_report& engine) {
    return "vineyard k = " + std::to_string(engine.k_first) + " to " + std::to_string(engine.k_last) + ": " +
           counted(engine.vines, "vine", "vines") + ", " +
           counted(engine.transpositions, "transposition", "transpositions") + " of " + grouped_text(engine.simplices) +
           " simplices; filter " + filter_name(engine.filter) + ", " + values_name(engine.values) +
           " values\ncertified ratio at most " + rounded_text(engine.certified_ratio, 6) + "\n";
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

std::string betti_line(const netmesh_report& engine) {
    std::string text = "Betti   ";
    for (std::uint32_t degree = 0; degree <= engine.max_degree; degree++) {
        text += (degree == 0 ? " " : ", ") + grouped_text(engine.essential[degree]);
    }
    return text + "\n";
}

}  // namespace

std::string text_report(const RunReport& run) {
    std::string text;
    if (run.engine) {
        const netmesh_report& engine = *run.engine;
        text += "input    ";
        if (engine.dim == 0) {
            text += counted(engine.simplices, "simplex", "simplices") + " on " +
                    counted(engine.vertices, "vertex", "vertices");
        } else {
            text += counted(engine.points, "point", "points") + " in R^" + std::to_string(engine.dim);
        }
        if (engine.duplicates > 0) text += ", " + counted(engine.duplicates, "duplicate", "duplicates") + " merged";
        text += "\n";
        if (engine.scales > 0) {
            text += scales_lines(engine);
        } else if (engine.cells > 0) {
            text += mesh_lines(engine);
        }
        if (run.analysis) text += analysis_lines(*run.analysis, run.engine->cages > 0);
        if (engine.has_diagram != 0) text += diagram_lines(engine);
        if (engine.has_diagram != 0 && engine.dim == 0) text += betti_line(engine);
        for (std::size_t degree = 0; degree < run.certain.size(); degree++) {
            text +=
                (degree == 0 ? "real     H" : ", H") + std::to_string(degree) + " " + grouped_text(run.certain[degree]);
        }
        if (!run.certain.empty()) text += " bars surely real\n";
        if (engine.has_vineyard != 0) text += vineyard_lines(engine);
    }
    if (run.checked) {
        for (const std::string& item : *run.checked) text += "checked  " + item + "\n";
    }
    if (run.engine) text += cost_lines(run);
    return text;
}

}  // namespace netmesh::tool
