#include "tools/commands/output.hpp"

#include <cstdio>
#include <memory>

#include "platform/clock.hpp"
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

Outcome finish_run(const std::vector<FileJob>& jobs, double start, RunReport* run) {
    const double computed = platform::seconds_now();
    const Outcome outcome = write_files(jobs);
    if (!outcome.good()) return outcome;
    run->write_seconds = platform::seconds_now() - computed;
    run->total_seconds = platform::seconds_now() - start;
    if (run->options->json) return write_files({{"", [&](TextWriter& out) { out << json_report(*run); }}});
    if (!run->options->quiet) std::fputs(text_report(*run).c_str(), stderr);
    return {};
}

EngineMesh::EngineMesh(const Engine& engine, const netmesh_report& report) : engine_(engine) {
    dim = report.input.dim;
    vertex_count = report.mesh.vertices;
    cell_count = report.mesh.cells;
    tau = report.mesh.tau;
    ratio = report.mesh.certificate.ratio;
    clipped = report.mesh.clipped != 0;
    eps = report.mesh.sizes.eps;
    for (std::uint32_t k = 0; k <= dim; k++) domain[k] = report.mesh.domain[k];
    if (vertex_count > 0) has_values = vertex(0).has_value != 0;
    engine_.for_each_cage([&](std::uint64_t, const netmesh_cage& cage) { cages.push_back(cage); });
}

netmesh_vertex EngineMesh::vertex(std::uint64_t index) const {
    netmesh_vertex result = sized<netmesh_vertex>();
    netmesh_get_vertex(engine_.context(), index, &result);
    return result;
}

netmesh_cell EngineMesh::cell(std::uint64_t index) const {
    netmesh_cell result = sized<netmesh_cell>();
    netmesh_get_cell(engine_.context(), index, &result);
    return result;
}

void EngineMesh::measure() {
    ratios.resize(vertex_count);
    domains.resize(vertex_count);
    if (engine_.measure_cells(ratios.data(), domains.data()) == NETMESH_OK) return;
    ratios.clear();
    domains.clear();
}

MeshFiles files_of(const EngineMesh& mesh) {
    MeshFiles files;
    NodeFile& node = files.node;
    node.cloud.dim = mesh.dim;
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        node.cloud.coordinates.insert(node.cloud.coordinates.end(), vertex.coordinates, vertex.coordinates + mesh.dim);
        node.attributes.push_back(vertex.value);
        node.markers.push_back(static_cast<std::uint8_t>(vertex.marker));
    }
    if (mesh.domain[mesh.dim] > 0) node.domain.assign(mesh.domain, mesh.domain + mesh.dim + 1);
    node.clipped = mesh.clipped;
    files.cells.columns = mesh.dim + 1;
    for (std::uint64_t c = 0; c < mesh.cell_count; c++) {
        const netmesh_cell cell = mesh.cell(c);
        files.cells.entries.insert(files.cells.entries.end(), cell.vertices, cell.vertices + mesh.dim + 1);
        files.cells.lines.push_back(c + 1);
    }
    return files;
}

std::vector<Bar> bars_of(const Engine& engine) {
    std::vector<Bar> bars;
    engine.for_each_pair([&](std::uint64_t, const netmesh_pair& pair) {
        bars.push_back({pair.degree, pair.birth, pair.death});
    });
    return bars;
}

Bounds bounds_of(const Engine& engine, const netmesh_report& report) {
    Bounds bounds;
    bounds.by_error = report.diagram.filter == NETMESH_FILTER_FUNCTION;
    engine.for_each_bar_bounds([&](std::uint64_t, const netmesh_bar_bounds& b) { bounds.bars.push_back(b); });
    engine.for_each_scale_step([&](std::uint64_t, const netmesh_scale_step& step) { bounds.steps.push_back(step); });
    return bounds;
}

Outcome check_ending(const std::string& path, const char* ending, const char* what) {
    if (path.empty() || ending_of(path) == ending) return {};
    return usage_error(path + ": " + what + " is written to " + ending);
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
