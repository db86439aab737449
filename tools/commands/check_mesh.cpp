#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_set>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/lines.hpp"

namespace netmesh::tool {

netmesh_status load_mesh(Session& session, const MeshFiles& files) {
    const NodeFile& node = files.node;
    return session.call(NETMESH_STAGE_DELAUNAY, [&] {
        const netmesh_status status =
            netmesh_load(session.context(), node.cloud.coordinates.data(), node.markers.data(), node.cloud.rows(),
                         files.cells.entries.data(), files.cells.lines.size(),
                         node.domain.empty() ? nullptr : node.domain.data(), &session.engine_options());
        if (status != NETMESH_OK || node.cages.empty()) return status;
        return netmesh_load_cages(session.context(), node.cages.data(), node.cages.size(), &session.engine_options());
    });
}

namespace {

// The markers a mesh with a domain may have, inputs first; without a domain all vertices are inputs.
Outcome settle_markers(MeshFiles* files) {
    NodeFile& node = files->node;
    if (node.domain.empty()) {
        std::fill(node.markers.begin(), node.markers.end(), std::uint8_t{0});
        return {};
    }
    bool input_over = false;
    for (std::size_t i = 0; i < node.markers.size(); i++) {
        if (node.markers[i] > 2)
            return line_error(node.cloud.name, node.cloud.lines[i], "a marker that is not 0, 1 or 2");
        if (node.markers[i] == 0 && input_over) {
            return line_error(node.cloud.name, node.cloud.lines[i], "an input (marker 0) behind other vertices");
        }
        input_over = input_over || node.markers[i] != 0;
    }
    return {};
}

// The .neigh file against the neighbours that loading found. Loading may reorder the vertices of a cell.
Outcome compare_neighbours(const MeshFiles& files, const ContextMesh& mesh) {
    const std::uint32_t columns = files.cells.columns;
    for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
        const netmesh_cell cell = mesh.cell(c);
        for (std::uint32_t i = 0; i < columns; i++) {
            const std::uint32_t opposite = files.cells.entries[c * columns + i];
            std::uint32_t j = 0;
            while (j + 1 < columns && cell.vertices[j] != opposite) j++;
            if (files.neighbours.entries[c * columns + i] == cell.neighbours[j]) continue;
            return {Exit::check, files.neighbours.name + ":" + std::to_string(files.neighbours.lines[c]) +
                                     ": check failed: neighbour " + std::to_string(i) +
                                     " is not the cell behind that facet"};
        }
    }
    return {};
}

// The inputs of the mesh must be the points, in their order, without repetitions, bit for bit.
Outcome compare_inputs(const MeshFiles& files, const PointCloud& points) {
    const NodeFile& node = files.node;
    if (points.dim != node.cloud.dim) return mismatch("the points have another dimension than the mesh");
    const std::size_t row_bytes = points.dim * sizeof(double);
    std::unordered_set<std::string> seen;
    std::size_t due = 0;
    for (std::size_t row = 0; row < points.rows(); row++) {
        const double* const x = points.coordinates.data() + row * points.dim;
        const std::string key(reinterpret_cast<const char*>(x), row_bytes);
        if (!seen.insert(key).second) continue;
        const bool there = due < node.cloud.rows() && node.markers[due] == 0;
        if (!there || std::memcmp(node.cloud.coordinates.data() + due * points.dim, x, row_bytes) != 0) {
            return mismatch("vertex " + std::to_string(due) + " of " + node.cloud.name + " is not the point of " +
                            points.where(row));
        }
        due++;
    }
    if (due < node.cloud.rows() && node.markers[due] == 0) {
        return mismatch(node.cloud.name + " has more inputs than " + points.name + " has different points");
    }
    return {};
}

// The vertex attribute against the values of each filter; *found says which.
Outcome compare_values(Session& session, const Options& options, const MeshFiles& files, std::string* found) {
    const NodeFile& node = files.node;
    for (const Candidate& candidate : candidates(options, true, false)) {
        const netmesh_status status = session.call(NETMESH_STAGE_CERTIFY, [&] {
            return netmesh_persist(session.context(), candidate.filter, candidate.values, 0, 0,
                                   &session.engine_options());
        });
        if (status == NETMESH_CANCELLED) return {Exit::cancelled, "netmesh: cancelled"};
        if (status != NETMESH_OK) continue;
        const ContextMesh mesh(session.context());
        bool equal = true;
        for (std::size_t i = 0; i < node.cloud.rows() && equal; i++) equal = node.attributes[i] == mesh.vertex(i).value;
        if (!equal) continue;
        *found = candidate_text(candidate);
        return {};
    }
    return mismatch("the values in " + node.cloud.name + " are those of no filter");
}

}  // namespace

Outcome check_mesh(const Options& options, MeshFiles& files, RunReport* run, Session& session) {
    Outcome outcome = settle_markers(&files);
    PointCloud points;
    if (outcome.good() && !options.points_path.empty()) {
        outcome = read_points(options.points_path, &points);
        if (outcome.good()) outcome = compare_inputs(files, points);
    }
    if (!outcome.good()) return outcome;
    if (!options.tau && files.node.tau > 0) session.set_tau(files.node.tau);
    const double ratio = options.ratio.value_or(files.node.ratio);
    session.set_goal(ratio, options.focus, options.from, options.to);
    if (options.eps == 0 || promises_accuracy(options)) session.set_eps(files.node.eps);
    outcome = session.run(NETMESH_JOB_PERSIST, files.node.cloud, [&](Session& s) {
        const netmesh_status status = load_mesh(s, files);
        if (status != NETMESH_OK) return status;
        return s.call(NETMESH_STAGE_CHECK,
                      [&] { return netmesh_check(s.context(), NETMESH_CHECK_ALL, &s.engine_options()); });
    });
    if (outcome.good()) outcome = compare_neighbours(files, ContextMesh(session.context()));
    if (!outcome.good()) return outcome;
    run->checked->push_back("facets shared by two, cells positively oriented, spheres empty, hull convex");
    run->checked->push_back(files.neighbours.name + " names the cells behind the facets");
    run->engine = session.report();
    run->clock = session.clock();
    if (!files.node.domain.empty() && ratio > 0) {
        run->checked->push_back("certified ratio at most " + rounded_text(ratio, 6) + " by the bounds of every cell");
    } else if (!files.node.domain.empty()) {
        run->checked->push_back("aspect ratio at most " + rounded_text(run->engine->aspect_ratio_max, 6) + " (tau " +
                                rounded_text(session.engine_options().tau, 6) + ")");
    }
    if (!files.node.cages.empty()) {
        run->checked->push_back(
            grouped_text(files.node.cages.size()) +
            " cages nested about inputs, none encroached; their cells and all others in their domains");
    }
    if (run->engine->size_ratio_max > 0) {
        run->checked->push_back("cells reach " + rounded_text(run->engine->size_ratio_max, 6) +
                                " of the size asked for (eps " +
                                rounded_text(session.engine_options().over_refine_eps, 6) + ")");
    }
    run->checked->push_back(files.node.domain.empty() || ratio > 0
                                ? "degrees within the bounds of fat cells (chapter 5)"
                                : "size and degrees within the bounds of chapters 3 and 5");
    if (!options.points_path.empty()) {
        run->checked->push_back("inputs equal " + points.name + " bit for bit, duplicates merged");
    }
    if (files.node.attribute_count == 1 && !files.node.domain.empty()) {
        std::string found;
        outcome = compare_values(session, options, files, &found);
        if (outcome.good()) run->checked->push_back("vertex values are those of " + found);
    }
    return outcome;
}

}  // namespace netmesh::tool
