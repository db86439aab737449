#include "tools/commands/output.hpp"

#include <memory>

#include "platform/files.hpp"
#include "platform/interrupt.hpp"

namespace netmesh::tool {

namespace {

std::string stem_of(const std::string& path) { return path.substr(0, path.size() - ending_of(path).size()); }

Outcome write_fault(const std::string& path, const std::string& why) {
    if (platform::interrupted()) return {Exit::cancelled, "netmesh: cancelled while writing"};
    return data_error((path.empty() ? "<stdout>" : path) + ": " + why);
}

}  // namespace

Outcome write_files(const std::vector<FileJob>& jobs) {
    std::vector<std::unique_ptr<platform::OutputFile>> files;
    for (const FileJob& job : jobs) {
        files.push_back(std::make_unique<platform::OutputFile>());
        platform::OutputFile& file = *files.back();
        if (job.path.empty()) {
            file.open_stdout();
        } else if (!file.open(job.path)) {
            return write_fault(job.path, file.why());
        }
        {
            TextWriter writer(&file);
            job.write(writer);
        }
        if (!file.finish() || platform::interrupted()) return write_fault(job.path, file.why());
    }
    for (std::size_t i = 0; i < jobs.size(); i++) {
        if (!files[i]->publish()) return write_fault(jobs[i].path, files[i]->why());
    }
    return {};
}

Outcome check_writable(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
        std::string why;
        if (!path.empty() && !platform::can_write(path, &why)) return data_error(path + ": cannot write: " + why);
    }
    return {};
}

ContextMesh::ContextMesh(const netmesh_context* context) : context_(context) {
    netmesh_report report = {};
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    dim = report.dim;
    vertex_count = report.vertices;
    cell_count = report.cells;
    tau = report.tau;
    ratio = report.ratio;
    eps = report.over_refine_eps;
    for (std::uint32_t k = 0; k <= dim; k++) domain[k] = report.domain[k];
    if (vertex_count > 0) has_values = vertex(0).has_value != 0;
    netmesh_cage cage;
    for (std::uint64_t i = 0; netmesh_get_cage(context_, i, &cage) == NETMESH_OK; i++) cages.push_back(cage);
}

netmesh_vertex ContextMesh::vertex(std::uint64_t index) const {
    netmesh_vertex result = {};
    netmesh_get_vertex(context_, index, &result);
    return result;
}

netmesh_cell ContextMesh::cell(std::uint64_t index) const {
    netmesh_cell result = {};
    netmesh_get_cell(context_, index, &result);
    return result;
}

void ContextMesh::measure(netmesh_context* context) {
    ratios.resize(vertex_count);
    domains.resize(vertex_count);
    if (netmesh_measure_cells(context, ratios.data(), domains.data()) == NETMESH_OK) return;
    ratios.clear();
    domains.clear();
}

std::vector<Bar> bars_of(const netmesh_context* context) {
    std::vector<Bar> bars;
    netmesh_pair pair;
    for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; i++) {
        bars.push_back({pair.degree, pair.birth, pair.death});
    }
    return bars;
}

Bounds bounds_of(const netmesh_context* context) {
    Bounds bounds;
    netmesh_bar_bounds b;
    for (std::uint64_t i = 0; netmesh_get_bar_bounds(context, i, &b) == NETMESH_OK; i++) bounds.bars.push_back(b);
    netmesh_scale_step step;
    for (std::uint64_t i = 0; netmesh_get_scale_step(context, i, &step) == NETMESH_OK; i++) bounds.steps.push_back(step);
    return bounds;
}

Outcome check_mesh_ending(const std::string& path, std::uint32_t dim) {
    if (path.empty()) return {};
    const std::string ending = ending_of(path);
    if (ending != ".node" && ending != ".vtu" && ending != ".off") {
        return usage_error(path + ": a mesh is written to .node, .vtu or .off");
    }
    if (ending == ".vtu" && dim > 3) {
        return usage_error(path + ": .vtu holds 2 or 3 dimensions, these points have " + std::to_string(dim) +
                           "; .node and .off hold any");
    }
    return {};
}

void add_mesh_files(const MeshSource& mesh, const std::string& path, std::vector<FileJob>* jobs) {
    const MeshSource* const source = &mesh;
    const std::string ending = ending_of(path);
    if (ending == ".node") {
        jobs->push_back({path, [source](TextWriter& out) { write_node(*source, out); }});
        jobs->push_back({stem_of(path) + ".ele", [source](TextWriter& out) { write_ele(*source, out); }});
        jobs->push_back({stem_of(path) + ".neigh", [source](TextWriter& out) { write_neigh(*source, out); }});
    } else if (ending == ".vtu") {
        jobs->push_back({path, [source](TextWriter& out) { write_vtu(*source, out); }});
    } else {
        jobs->push_back({path, [source](TextWriter& out) { write_off(*source, out); }});
    }
}

}  // namespace netmesh::tool
