#include <cmath>
#include <cstdio>

#include "platform/memory.hpp"
#include "tools/io/numbers.hpp"
#include "tools/report/report.hpp"

namespace netmesh::tool {

namespace {

std::string seconds_text(double seconds) {
    char text[40];
    std::snprintf(text, sizeof text, seconds < 0.0995 ? "%.3f" : "%.2f", seconds);
    return text;
}

std::string audit_lines(const netmesh_mesh_report& mesh) {
    const netmesh_audit_report& audit = mesh.audit;
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
        text += "audited  " + counted(audit.meshes, "mesh", "meshes") + ", aspect ratio " +
                (mesh.goal.ratio > 0 ? "of points at most " : "at most ") + rounded_text(audit.aspect_ratio_max, 4) +
                ", degree " + grouped_text(audit.degree_max) + "; K " + rounded_text(audit.feature_ratio, 4) +
                ", when inserted: shells " + rounded_text(audit.cage_ratio, 4) + ", cleaning " +
                rounded_text(audit.steiner_ratio, 4) + ", inputs " + rounded_text(audit.input_ratio, 4) + "\n";
    return text;
}

std::string goal_text(const netmesh_goal& goal) {
    std::string text = "ratio " + bound_text(goal.ratio, 5);
    if (goal.focus_ratio > 0) {
        text += ", " + rounded_text(goal.focus_ratio, 5) + " from radius " + rounded_text(goal.focus_from, 4) + " to " +
                rounded_text(goal.focus_to, 4);
    }
    return text;
}

std::string mesh_lines(const netmesh_mesh_report& mesh) {
    std::string text = "mesh     " + counted(mesh.vertices, "vertex", "vertices");
    if (mesh.is_mesh != 0) {
        text += " (" + counted(mesh.steiner, "Steiner point", "Steiner points") + ", " + grouped_text(mesh.exempt) +
                " on the boundary)";
    }
    text += ", " + counted(mesh.cells, "cell", "cells") + "\n";
    if (mesh.hierarchy.cages > 0) {
        text += "cages    " + grouped_text(mesh.hierarchy.cages) + " kept of " +
                grouped_text(mesh.hierarchy.cages_made) + " made\n";
    }
    if (mesh.is_mesh != 0) {
        text += "quality  aspect ratio at most " + bound_text(mesh.aspect_ratio_max, 5);
        text += mesh.goal.ratio > 0 ? ", refined by the certificate to " + goal_text(mesh.goal) +
                                          (mesh.clipped != 0 ? ", for clipped cells\n" : "\n")
                                    : " (tau " + rounded_text(mesh.tau, 5) + ")\n";
        if (mesh.sizes.ratio_max > 0)
            text += "size     cells reach " + bound_text(mesh.sizes.ratio_max, 5) + " of the size asked for\n";
        text += audit_lines(mesh);
    }
    return text;
}

std::string range_text(double from, double to) { return rounded_text(from, 4) + " and " + rounded_text(to, 4); }

std::string size_lines(const netmesh_size_analysis& size) {
    const bool caged = size.domains > 1;
    std::string text = "bounds   " + counted(size.vertices, "vertex", "vertices") + ", between " +
                       range_text(size.lower, size.upper) + ", " + rounded_text(size.upper_over_lower, 4) + " apart";
    if (caged) text += ", summed over " + grouped_text(size.domains) + " domains";
    text += "; feature size ratio " + rounded_text(size.feature_ratio, 4) +
            (caged ? "\n" : " (at most " + rounded_text(size.feature_ratio_bound, 4) + ")\n");
    return text + "pace     theta " + rounded_text(size.theta, 4) + " (at most " + rounded_text(size.theta_limit, 4) +
           " in any order), sum of ln 1/theta " + rounded_text(size.theta_log_sum, 4) +
           "; feature size integral between " + range_text(size.integral_lower[0], size.integral_upper[0]) + "\n";
}

// Of the largest number of intersections, when it is not that of all balls.
std::string sampled_text(const netmesh_structure_analysis& s) {
    return s.balls_stride > 1 ? " at one ball of " + grouped_text(s.balls_stride) : "";
}

std::string analysis_lines(const netmesh_analysis& a) {
    std::string text = a.size.present != 0 ? size_lines(a.size) : "";
    const netmesh_structure_analysis& s = a.structure;
    text += "stars    " + rounded_text(s.degree_mean, 4) + " neighbours (at most " + grouped_text(s.degree_max) +
            "), " + rounded_text(s.star_mean, 4) + " cells (" + grouped_text(s.star_max) + ")\n";
    text += "balls    ply " + rounded_text(s.ply_mean, 4) + " (at most " + grouped_text(s.ply_max) + " at " +
            counted(s.ply_points, "sampled point", "sampled points") + "), each meets " +
            rounded_text(s.intersections_mean, 4) + " (" + grouped_text(s.intersections_max) + sampled_text(s) + ")\n";
    if (a.boundary.balls > 0)
        text += "         " + grouped_text(a.boundary.balls) + " more at the boundary, which meet at most " +
                grouped_text(a.boundary.intersections_max) + sampled_text(s) + "\n";
    const bool whole = a.fatness.inside.cells == 0;
    const netmesh_fatness& part = whole ? a.fatness.bounded : a.fatness.inside;
    text += "fatness  " + rounded_text(part.beta_mean, 4) + " (at most " + rounded_text(part.beta_max, 4) + ") of " +
            grouped_text(part.cells) + (whole ? " bounded cells\n" : " cells inside the domain\n");
    const netmesh_fatness& all = a.all_cells.cells;
    text += "         " + rounded_text(all.beta_mean, 4) + " (at most " + rounded_text(all.beta_max, 4) + ") of all " +
            counted(all.cells, "cell", "cells");
    if (a.all_cells.left_out > 0) text += "; " + grouped_text(a.all_cells.left_out) + " are not known";
    return text + "\n";
}

std::string scales_lines(const netmesh_scales_report& scales) {
    std::string text = "scales   " + counted(scales.count, "scale", "scales") + ", " +
                       counted(scales.vertices, "vertex", "vertices") + " in all, the largest of " +
                       counted(scales.points_max, "point", "points") + " and " +
                       counted(scales.vertices_max, "vertex", "vertices") + "\n";
    if (scales.count > 1) {
        text += "apart    each scale has a ball of " + rounded_text(scales.separation, 5) +
                " of its radii to itself (2 are needed)\n";
    }
    return text;
}

// "H0 12, H1 3"
std::string by_degree(const std::uint64_t* counts, std::uint32_t max_degree, bool named) {
    std::string text;
    for (std::uint32_t degree = 0; degree <= max_degree; degree++) {
        text += (degree == 0 ? "" : ", ") + (named ? "H" + std::to_string(degree) + " " : "") +
                grouped_text(counts[degree]);
    }
    return text;
}

std::string decision_lines(const netmesh_decision_report& decision) {
    const std::string longer = "longer than " + rounded_text(decision.longer_than, 5) + " times their birth";
    std::string text =
        "undecided " + by_degree(decision.undecided, decision.max_degree, true) + " bars may live " + longer;
    if (decision.undecided_to > 0) text += ", up to radius " + bound_text(decision.undecided_to, 5);
    return text + "\ndecided  all classes that live " + longer + " and die after radius " +
           bound_text(decision.decided_from, 5) + " have a bar that is certified to exist\n";
}

bool is_exact(const netmesh_diagram_report& diagram) {
    return (diagram.filter == NETMESH_FILTER_ALPHA || is_on_points(diagram.filter)) && diagram.certified_ratio == 1;
}

std::string diagram_lines(const netmesh_report& engine) {
    const netmesh_diagram_report& diagram = engine.diagram;
    std::string text = "diagram  " + by_degree(diagram.pairs, diagram.max_degree, true);
    if (engine.input.dim == 0)
        return text + "\nBetti    " + by_degree(diagram.essential, diagram.max_degree, false) + "\n";
    text += "; " + reported_choice_text({diagram.filter, diagram.values});
    text += "\ncertified ratio " + bound_text(diagram.certified_ratio, 6);
    if (diagram.certified_from > 0) text += " from radius " + bound_text(diagram.certified_from, 6);
    text += " to the " + reference_name(engine) + "\n";
    if (diagram.filter == NETMESH_FILTER_FUNCTION) {
        text += "certified error " + bound_text(diagram.certified_error, 6) +
                ": births and deaths are off by at most that\n";
    }
    if (is_exact(diagram))
        text += std::string("exact    every birth and death is the exact one") +
                (engine.input.moved > 0 ? " of the moved numbers" : "") + ", rounded to the nearest double\n";
    if (engine.bounds.present != 0)
        text += "exist    " + by_degree(engine.bounds.certain, engine.bounds.max_degree, true) +
                " bars certified to exist, however short\n";
    if (engine.decision.present != 0) text += decision_lines(engine.decision);
    return text;
}

std::string vineyard_lines(const netmesh_vineyard_report& vineyard) {
    std::string text = ": " + counted(vineyard.vines, "vine", "vines");
    if (!is_on_points(vineyard.filter))
        text += ", " + counted(vineyard.transpositions, "transposition", "transpositions");
    text += " of " + counted(vineyard.simplices, "simplex", "simplices");
    if (vineyard.filter == NETMESH_FILTER_NONE)
        return "vineyard " + counted(vineyard.k_last, "step", "steps") + text + "\n";
    return "vineyard k = " + std::to_string(vineyard.k_first) + " to " + std::to_string(vineyard.k_last) + text + "; " +
           choice_text({vineyard.filter, vineyard.values}) + "\ncertified ratio at most " +
           bound_text(vineyard.certified_ratio, 6) + "\n";
}

std::string input_line(const netmesh_report& engine) {
    const netmesh_input_report& input = engine.input;
    std::string text = "input    ";
    if (input.dim == 0) {
        const std::uint64_t simplices =
            engine.vineyard.present != 0 ? engine.vineyard.simplices : engine.diagram.simplices;
        text += counted(simplices, "simplex", "simplices") + " on " +
                counted(engine.simplicial_complex.vertices, "vertex", "vertices");
    } else {
        text += counted(input.points, "point", "points") + " in R^" + std::to_string(input.dim);
    }
    if (input.duplicates > 0) text += ", " + counted(input.duplicates, "duplicate", "duplicates") + " merged";
    if (input.hidden > 0) text += ", " + counted(input.hidden, "ball", "balls") + " hidden by others";
    return text + "\n";
}

std::string periods_lines(const Lattice& lattice, const netmesh_input_report& input) {
    if (input.periods == 0) return {};
    std::string text = "periods  " + counted(input.periods, "vector", "vectors") + ", " + lattice.option() + " " +
                       lattice.text + "; with " + counted(input.copies, "copy", "copies") + " of points\n";
    if (input.moved > 0) text += "moved    by " + rounded_text(input.moved, 3) + " at most, so that copies are exact\n";
    return text;
}

std::string cost_lines(const RunReport& run) {
    const netmesh_report& engine = *run.engine;
    // What is only reserved costs nothing, and is not said.
    std::string text = "memory   peak " + bytes_text(engine.memory.peak_bytes) +
                       (run.options->memory_bytes == 0 ? "\n" : " of " + bytes_text(run.options->memory_bytes) + "\n");
    text += "time     " + seconds_text(run.total_seconds) + " s: read " + seconds_text(run.read_seconds);
    for (int stage = 1; stage < NETMESH_STAGE_COUNT && run.clock; stage++) {
        const netmesh_stage which = static_cast<netmesh_stage>(stage);
        const double seconds = run.clock->seconds(which);
        if (seconds > 0) text += std::string(", ") + stage_name(which) + " " + seconds_text(seconds);
    }
    text += ", write " + seconds_text(run.write_seconds);
    const std::size_t process = platform::peak_process_bytes();  // with points, results and the program itself
    if (process != 0) text += "; the whole process took " + bytes_text(process);
    const std::size_t worker = platform::peak_worker_bytes();  // of pieces
    if (worker != 0) text += ", the largest of its workers " + bytes_text(worker);
    text += '\n';
    char digits[48];
    std::snprintf(digits, sizeof digits, "result   fingerprint %016llx\n",
                  static_cast<unsigned long long>(engine.fingerprint));
    return text + digits;
}

std::string mesh_or_scales_lines(const netmesh_report& engine) {
    std::string text;
    if (engine.scales.present != 0) {
        text += scales_lines(engine.scales);
    } else if (engine.mesh.present != 0) {
        text += mesh_lines(engine.mesh);
    }
    return text;
}

}  // namespace

std::string text_report(const RunReport& run) {
    std::string text;
    if (run.engine) {
        const netmesh_report& engine = *run.engine;
        text +=
            input_line(engine) + periods_lines(run.options->table.lattice, engine.input) + mesh_or_scales_lines(engine);
        if (run.analysis) text += analysis_lines(*run.analysis);
        if (engine.diagram.present != 0) text += diagram_lines(engine);
        if (engine.vineyard.present != 0) text += vineyard_lines(engine.vineyard);
    }
    if (run.checked) {
        for (const std::string& item : *run.checked) text += "checked  " + item + "\n";
    }
    if (run.engine) text += cost_lines(run);
    return text;
}

}  // namespace netmesh::tool
