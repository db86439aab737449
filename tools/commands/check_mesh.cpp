#include <algorithm>
#include <cstring>
#include <unordered_set>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/option_use.hpp"
#include "tools/vertex_function.hpp"

namespace netmesh::tool {

netmesh_status load_mesh(Session& session, const MeshFiles& files) {
    const NodeFile& node = files.node;
    netmesh_load_request load = sized<netmesh_load_request>();
    load.dim = node.cloud.dim;
    load.vertices = node.cloud.coordinates.data();
    load.markers = node.markers.data();
    load.vertex_count = node.cloud.rows();
    load.cells = files.cells.entries.data();
    load.cell_count = files.cells.lines.size();
    load.domain = node.domain.empty() ? nullptr : node.domain.data();
    const netmesh_request promise = session.promise();
    load.promised = &promise;
    netmesh_cages_request cages = sized<netmesh_cages_request>();
    cages.cages = node.cages.data();
    cages.cage_count = node.cages.size();
    return session.call(NETMESH_STAGE_DELAUNAY, [&] {
        const netmesh_status status = session.engine().load(session.watched(load));
        if (status != NETMESH_OK || node.cages.empty()) return status;
        return session.engine().load_cages(session.watched(cages));
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
Outcome compare_neighbours(const MeshFiles& files, const EngineMesh& mesh) {
    const std::uint32_t columns = files.cells.columns;
    for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
        const netmesh_cell cell = mesh.cell(c);
        for (std::uint32_t i = 0; i < columns; i++) {
            const std::uint32_t opposite = files.cells.entries[c * columns + i];
            std::uint32_t j = 0;
            while (j + 1 < columns && cell.vertices[j] != opposite) j++;
            if (files.neighbours.entries[c * columns + i] == cell.neighbours[j]) continue;
            return line_error(files.neighbours.name, files.neighbours.lines[c],
                              "check failed: neighbour " + std::to_string(i) + " is not the cell behind that facet", 0,
                              Exit::check);
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

// What the mesh is checked against: the options, and the file where they say nothing. What its filter is matters to
// sizes alone, and how it was made to cages of the thesis and boundary nets.
netmesh_request promise_of(const Options& options, const NodeFile& node) {
    netmesh_request promise = promised(options.request);
    const auto take = [](double* asked, double said) {
        if (*asked == 0) *asked = said;
    };
    netmesh_sizes& sizes = promise.mesh.sizes;
    if (sizes.at_inputs == 0) sizes.growth = node.size_growth;
    take(&sizes.at_inputs, node.size_at_inputs);
    take(&sizes.eps, node.eps);
    take(&promise.mesh.tau, node.tau);
    // A file that says no tau is held to that of its dimension, however it was made.
    if (node.has_thesis_cages) take(&promise.mesh.tau, default_tau(node.cloud.dim));
    take(&promise.mesh.net_spacing, node.net_spacing);
    take(&promise.goal.ratio, node.ratio);
    if (promise.goal.ratio > 0 && !node.clipped) promise.mesh.whole_cells = 1;
    promise.mesh.finish = 0;
    if (promise.goal.eps == 0 && promise.goal.error == 0) promise.filter = nullptr;
    promise.mesh.method = node.has_thesis_cages                                       ? &netmesh_method_thesis
                          : promise.filter != nullptr && promise.mesh.net_spacing > 0 ? &netmesh_method_refine
                                                                                      : nullptr;
    return promise;
}

// What the engine's checkers have found to hold.
void add_findings(const MeshFiles& files, const netmesh_request& promise, const netmesh_mesh_report& report,
                  std::vector<std::string>* checked) {
    const netmesh_mesh_rules& mesh = promise.mesh;
    const double ratio = promise.goal.ratio, error = promise.goal.error;
    const bool is_mesh = !files.node.domain.empty();
    checked->push_back("facets shared by two, cells positively oriented, spheres empty, hull convex");
    checked->push_back(files.neighbours.name + " names the cells behind the facets");
    if (is_mesh && ratio > 0) {
        checked->push_back("certified ratio at most " + bound_text(ratio, 6) + " by the bounds of every cell" +
                           (mesh.whole_cells == 0 ? ", clipped" : ""));
    } else if (is_mesh) {
        checked->push_back("aspect ratio at most " + bound_text(report.aspect_ratio_max, 6) + " (tau " +
                           rounded_text(mesh.tau > 0 ? mesh.tau : default_tau(files.node.cloud.dim), 6) + ")");
    }
    if (!files.node.cages.empty()) {
        checked->push_back(counted(files.node.cages.size(), "cage", "cages") +
                           " nested about inputs, none encroached; their cells and all others " +
                           (files.node.has_thesis_cages ? "whole" : "in their domains") +
                           "; in-radii and feature sizes as in 4.6");
    }
    if (mesh.net_spacing > 0)
        checked->push_back("a boundary net of spacing " + number_text(mesh.net_spacing) +
                           ", and the domain that it needs (3.5)");
    if (report.sizes.ratio_max > 0) {
        std::string asked;
        if (mesh.sizes.eps > 0) asked = "eps " + rounded_text(mesh.sizes.eps, 6);
        if (mesh.sizes.at_inputs > 0)
            asked += (asked.empty() ? "cell-size " : ", cell-size ") + number_text(mesh.sizes.at_inputs) + ',' +
                     number_text(mesh.sizes.growth);
        if (error > 0) asked += (asked.empty() ? "error " : ", error ") + number_text(error);
        checked->push_back("cells reach " + bound_text(report.sizes.ratio_max, 6) + " of the size asked for (" + asked +
                           ")");
    }
    checked->push_back(is_mesh && ratio == 0 ? "size and degrees within the bounds of chapters 3 to 5"
                                             : "degrees within the bounds of fat cells (chapter 5)");
}

// Options that say of what filter the values are, where there are no values. Of a diagram they are about other things.
Outcome refuse_value_options(const Options& options, const std::string& name) {
    if (options.command != Command::check) return {};
    return refuse_options(options, {"--filter", "--values", "--k", "--function", "--lipschitz", "--cut"},
                          name + " has no values at its vertices");
}

}  // namespace

Outcome settle_mesh(const Options& options, MeshFiles* files, Session* session) {
    const NodeFile& node = files->node;
    const Outcome outcome = settle_markers(files);
    if (!outcome.good()) return outcome;
    if (node.has_thesis_cages && node.cloud.dim > 4)
        return file_error(node.cloud.name, "there are cages of the thesis in dimensions 2, 3 and 4 only");
    session->set_promise(promise_of(options, node));
    const bool by_ratio = session->promise().goal.ratio > 0;
    if (options.command == Command::check && options.request.mesh.whole_cells != 0 && (!node.clipped || !by_ratio))
        return usage_error("--whole-cells does nothing here: " + node.cloud.name +
                           (by_ratio ? " is certified for whole cells" : " is of no certified ratio"));
    return {};
}

Outcome read_values_at(const NodeFile& node, Options* options) {
    if (options->values_at.empty()) return {};
    const auto function = std::make_shared<VertexFunction>();
    const Outcome outcome = VertexFunction::read(options->values_at, node.cloud, function.get());
    if (outcome.good()) options->vertex_function = function;
    return outcome;
}

Outcome check_mesh(const Options& options, MeshFiles& files, RunReport* run, Session& session) {
    const NodeFile& node = files.node;
    Outcome outcome = settle_mesh(options, &files, &session);
    PointCloud points;
    if (outcome.good() && !options.points_path.empty()) {
        outcome = read_cloud(options, options.points_path, &points);
        if (outcome.good()) outcome = compare_inputs(files, points);
    }
    if (!outcome.good()) return outcome;
    outcome = session.run(plan_to_read(node.cloud.dim, node.cloud.rows()), node.cloud, [&](Session& s) {
        const netmesh_status status = load_mesh(s, files);
        return status == NETMESH_OK ? check_everything(s) : status;
    });
    if (outcome.good()) outcome = compare_neighbours(files, EngineMesh(session.engine()));
    if (!outcome.good()) return outcome;
    run->engine = session.report();
    run->clock = session.clock();
    add_findings(files, session.promise(), run->engine->mesh, &*run->checked);
    if (!options.points_path.empty()) {
        run->checked->push_back("inputs equal " + points.name + " bit for bit, duplicates merged");
    }
    return outcome;
}

Outcome check_vertex_values(const Options& options, const MeshFiles& files, RunReport* run, Session& session) {
    const NodeFile& node = files.node;
    if (node.attribute_count != 1 || node.domain.empty()) return refuse_value_options(options, node.cloud.name);
    for (const FilterChoice& choice : candidates(options)) {
        Request request(about(choice.filter).filter);
        request.values = choice.values;
        if (about(choice.filter).needs_k != 0) request.k = std::max(options.request.k, 1u);
        request.max_degree = 0;
        session.function().set_domain(session.report());
        const netmesh_status status = persist(session, request);
        if (status == NETMESH_CANCELLED) return {Exit::cancelled, "netmesh: cancelled"};
        if (status != NETMESH_OK) continue;
        const EngineMesh mesh(session.engine());
        bool equal = true;
        for (std::size_t i = 0; i < node.cloud.rows() && equal; i++) equal = node.attributes[i] == mesh.vertex(i).value;
        if (!equal) continue;
        run->checked->push_back("vertex values are those of " + choice_text(choice));
        return {};
    }
    return mismatch("the values in " + node.cloud.name + " are those of no filter " +
                    (options.request.filter != nullptr
                         ? "that was asked for"
                         : "that needs no more than the mesh; for knn, kdistance and function --filter and "
                           "the options that made them are needed"));
}

}  // namespace netmesh::tool
