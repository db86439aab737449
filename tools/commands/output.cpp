#include "tools/commands/output.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>

#include "platform/clock.hpp"
#include "platform/files.hpp"
#include "platform/interrupt.hpp"
#include "platform/terminal.hpp"

namespace netmesh::tool {

namespace {

std::string stem_of(const std::string& path) { return path.substr(0, path.size() - ending_of(path).size()); }

Outcome write_fault(const std::string& path, const std::string& why) {
    if (platform::interrupted()) return {Exit::cancelled, "netmesh: cancelled while writing"};
    return file_error(path.empty() ? "<stdout>" : path, why);
}

// On stderr, on a terminal in colour: `escape` for what comes before the first `stop`, or for all.
void print_message(const std::string& text, const char* escape, const char* stop = nullptr) {
    if (!platform::stderr_has_colours()) {
        std::fputs(text.c_str(), stderr);
        return;
    }
    std::size_t at = 0;
    while (at < text.size()) {  // line by line
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::size_t plain = stop == nullptr ? end : std::min(text.find_first_of(stop, at), end);
        std::fprintf(stderr, "\x1b[%sm%s\x1b[0m%s\n", escape, text.substr(at, plain - at).c_str(),
                     text.substr(plain, end - plain).c_str());
        at = end + 1;
    }
}

}  // namespace

void tell_error(const Outcome& outcome, Command command, bool json) {
    if (outcome.good() || outcome.message.empty()) return;
    if (outcome.exit == Exit::cancelled) platform::take_interrupt();
    if (json) write_files({{"", [&](TextWriter& out) { out << json_error(command, outcome); }}});
    print_message(outcome.message + "\n", "31");
}

Outcome without_exceptions(const std::function<Outcome()>& run) {
    try {
        return run();
    } catch (const std::bad_alloc&) {
        // Not the engine, which has its own block: the tool's copy of the input or of the diagram.
        return {Exit::memory, "netmesh: no memory left to hold the input"};
    } catch (const std::exception& thrown) {
        return {Exit::internal, std::string("netmesh: internal error: ") + thrown.what()};
    }
}

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
        if (!path.empty() && path != "-" && !platform::can_write(path, &why))
            return file_error(path, "cannot write: " + why);
    }
    return {};
}

namespace {

// What is written or read besides `path`.
std::vector<std::string> with_companions(const std::string& path) {
    std::vector<std::string> paths = {path};
    const std::string ending = ending_of(path);
    if (ending == ".node")
        for (const char* const other : {".ele", ".neigh"}) paths.push_back(stem_of(path) + other);
    if (ending == ".mesh") paths.push_back(stem_of(path) + ".sol");
    return paths;
}

// FILE of FILE.npz:NAME.
std::string file_of(const std::string& input) {
    const std::size_t at = input.rfind(".npz:");
    return at == std::string::npos ? input : input.substr(0, at + 4);
}

}  // namespace

Outcome check_apart(const Options& options) {
    std::vector<std::string> inputs, outputs;
    std::vector<std::string> given = options.positionals;
    for (const std::string& path :
         {options.values_path, options.values_at, options.complex_path, options.points_path, options.mesh_path})
        given.push_back(path);
    for (const std::string& path : given)
        if (!path.empty() && path != "-")
            for (const std::string& one : with_companions(file_of(path))) inputs.push_back(one);
    for (const std::string& path : {options.out, options.svg, options.mesh_out, options.representatives, options.proof,
                                    options.pace_path, options.weighted_path}) {
        if (path.empty() || path == "-") continue;
        for (const std::string& one : with_companions(path)) {
            for (const std::string& input : inputs)
                if (platform::is_one_file(one, input))
                    return usage_error(one + ": would be written over the input; give the output another name");
            for (const std::string& other : outputs)
                if (platform::is_one_file(one, other))
                    return usage_error(one + ": two outputs would be written to this file");
        }
        for (const std::string& one : with_companions(path)) outputs.push_back(one);
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
    if (!run->options->quiet) print_message(text_report(*run), "1", " ");
    return {};
}

EngineMesh::EngineMesh(const Engine& engine, const netmesh_report& report) : engine_(engine) {
    dim = report.input.dim;
    vertex_count = report.mesh.vertices;
    cell_count = report.mesh.cells;
    tau = report.mesh.tau;
    ratio = report.mesh.goal.ratio;
    clipped = report.mesh.clipped != 0;
    eps = report.mesh.sizes.eps;
    for (std::uint32_t k = 0; k <= dim; k++) domain[k] = report.mesh.domain[k];
    has_thesis_cages = report.mesh.method == NETMESH_METHOD_THESIS;
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

BarSource bars_in(const Engine& engine) {
    std::uint64_t count = 0;
    engine.for_each_pair([&](std::uint64_t, const netmesh_pair&) { count++; });
    return {count, [&engine](const BarSource::Visit& visit) {
                engine.for_each_pair([&](std::uint64_t, const netmesh_pair& pair) {
                    visit({pair.degree, pair.birth, pair.death});
                });
            }};
}

std::vector<Bar> bars_of(const BarSource& bars) {
    std::vector<Bar> list;
    list.reserve(static_cast<std::size_t>(bars.size()));  // as it grows a vector holds all twice
    bars.for_each([&](const Bar& bar) { list.push_back(bar); });
    return list;
}

Bounds bounds_of(const Engine& engine, const netmesh_report& report) {
    Bounds bounds;
    bounds.by_error = report.diagram.filter == NETMESH_FILTER_FUNCTION;
    engine.for_each_bar_bounds([&](std::uint64_t, const netmesh_bar_bounds& b) { bounds.bars.push_back(b); });
    engine.for_each_scale_step([&](std::uint64_t, const netmesh_scale_step& step) { bounds.steps.push_back(step); });
    return bounds;
}

void tell_note(const Options& options, const std::string& file, const std::string& note) {
    if (!note.empty() && !options.quiet) print_message(file + ": " + note + "\n", "33");
}

void tell_warning(const std::string& file, const std::string& warning) {
    print_message(file + ": " + warning + "\n", "33");
}

// Whether an isometric copy of the points stands for them: an alpha complex is intrinsic. Not where coordinates come
// out again, and not beside a proof, whose verifier reads the file as it is.
bool is_of_points_alone(const Options& options) {
    const bool is_alpha = filter_of(options) == NETMESH_FILTER_ALPHA;
    if (options.command == Command::check) return is_alpha;
    return options.command == Command::persist && (is_alpha || options.request.filter == &netmesh_filter_auto) &&
           options.proof.empty() && options.mesh_out.empty() && options.pace_path.empty() &&
           options.weighted_path.empty() && !goes_by_pieces(options) && options.implies_mesh.empty();
}

Outcome read_cloud(const Options& options, const std::string& path, PointCloud* cloud) {
    const bool any = options.command == Command::persist && filter_of(options) == NETMESH_FILTER_RIPS;
    const Outcome outcome = read_points(path, options.table, cloud, any ? NETMESH_RIPS_DIM_MAX : dim_max);
    if (!outcome.good()) return outcome;
    if (cloud->has_slip)
        tell_warning(cloud->name, cloud->note);
    else
        tell_note(options, cloud->name, cloud->note);
    if (any || cloud->lattice.kind != Lattice::none) return {};
    if (is_of_points_alone(options)) {
        tell_note(options, cloud->name, cloud->leave_out_constant());
    } else if (options.command != Command::delaunay && filter_of(options) != NETMESH_FILTER_ALPHA) {
        tell_note(options, cloud->name, cloud->constant_coordinate());  // without a mesh they are refused, and told so
    }
    return {};
}

Outcome check_ending(const std::string& path, const char* ending, const char* what) {
    if (path.empty() || ending_of(path) == ending) return {};
    return usage_error(path + ": " + what + " is written to " + ending);
}

Outcome check_diagram_ending(const std::string& path) {
    const std::string ending = ending_of(path);
    for (const char* known : {".pers", ".csv", ".json", ".npy"})
        if (path.empty() || ending == known) return {};
    return usage_error(path + ": a diagram is written to .pers, .csv, .json or .npy");
}

Outcome check_picture_ending(const Options& options) {
    if (options.svg == "-" && options.out.empty() && was_given(options, "-o"))
        return usage_error("--svg - and -o -: only one of the two can go to stdout; give the other a name");
    if (options.svg == "-" && options.json) return usage_error("--svg -: with --json stdout is the report's");
    if (options.svg == "-") return {};
    return check_ending(options.svg, ".svg", "a picture");
}

Outcome check_cycles_ending(const std::string& path, bool has_places, std::uint32_t dim) {
    const std::string ending = ending_of(path);
    const bool shown = ending == ".vtu" || ending == ".obj" || ending == ".svg";
    if (path.empty() || ending.empty() || ending == ".txt" || ending == ".cycles") return {};
    if (!shown) return usage_error(path + ": cycles are written to .txt, .cycles, .vtu, .obj or .svg");
    if (!has_places) return usage_error(path + ": the vertices of a complex have no places; .txt holds them by number");
    if (dim <= 3) return {};
    return usage_error(path + ": " + ending + " holds 2 or 3 dimensions, these points have " + std::to_string(dim) +
                       "; .txt holds any");
}

std::vector<bool> chosen_bars(const Options& options, const BarSource& bars) {
    if (options.top == 0 && options.least == 0) return {};
    std::vector<bool> chosen(static_cast<std::size_t>(bars.size()));
    struct Long {
        double length;
        std::size_t bar;
        // Of two that are as long the first in the diagram.
        bool operator<(const Long& other) const {
            return length != other.length ? length > other.length : bar < other.bar;
        }
    };
    std::vector<std::vector<Long>> longest;  // of each degree a heap, the shortest at its top
    std::size_t i = 0;
    bars.for_each([&](const Bar& bar) {
        const Long found = {bar.death - bar.birth, i++};
        if (found.length < options.least) return;
        if (options.top == 0) {
            chosen[found.bar] = true;
            return;
        }
        if (longest.size() <= bar.degree) longest.resize(bar.degree + 1);
        std::vector<Long>& heap = longest[bar.degree];
        heap.push_back(found);
        std::push_heap(heap.begin(), heap.end());
        if (heap.size() <= options.top) return;
        std::pop_heap(heap.begin(), heap.end());
        heap.pop_back();
    });
    for (const std::vector<Long>& heap : longest)
        for (const Long& kept : heap) chosen[kept.bar] = true;
    return chosen;
}

BarSource chosen_of(const BarSource& bars, const std::vector<bool>& chosen) {
    if (chosen.empty()) return bars;
    const auto count = static_cast<std::uint64_t>(std::count(chosen.begin(), chosen.end(), true));
    return {count, [bars, &chosen](const BarSource::Visit& visit) {
                std::size_t i = 0;
                bars.for_each([&](const Bar& bar) {
                    if (chosen[i++]) visit(bar);
                });
            }};
}

void keep_chosen(const std::vector<bool>& chosen, Bounds* bounds) {
    if (chosen.empty() || bounds->bars.size() != chosen.size()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < chosen.size(); i++)
        if (chosen[i]) bounds->bars[kept++] = bounds->bars[i];
    bounds->bars.resize(kept);
}

FileJob diagram_job(const Options& options, const Head& head, const std::vector<bool>& chosen, const BarSource& bars,
                    const Bounds& bounds) {
    const std::string ending = ending_of(options.out);
    if (ending == ".csv") return {options.out, [&](TextWriter& out) { write_diagram_csv(bars, bounds, out); }};
    if (ending == ".json") return {options.out, [&](TextWriter& out) { write_diagram_json(bars, out); }};
    if (ending == ".npy") return {options.out, [&](TextWriter& out) { write_diagram_npy(bars, out); }};
    return {options.out, [&](TextWriter& out) {
                if (chosen.empty()) {
                    write_head(head, out);
                } else {  // what a head says is true of whole diagrams only
                    out << "# a choice of " << bars.size() << " of " << std::uint64_t{chosen.size()} << " bars";
                    if (options.least > 0)
                        out << (was_given(options, "--least") ? ", --least " : ", --min-persistence ") << options.least;
                    if (options.top > 0) out << ", --top " << options.top;
                    out << '\n';
                }
                write_diagram(bars, bounds, out);
            }};
}

Outcome check_mesh_ending(const std::string& path, std::uint32_t dim) {
    if (path.empty()) return {};
    const std::string ending = ending_of(path);
    const bool any_dim = ending == ".node" || ending == ".off";
    bool known = any_dim;
    for (const char* flat : {".vtu", ".ply", ".obj", ".msh", ".mesh"}) known = known || ending == flat;
    if (!known) return usage_error(path + ": a mesh is written to .node, .off, .vtu, .ply, .obj, .msh or .mesh");
    if (!any_dim && dim > 3) {
        return usage_error(path + ": " + ending + " holds 2 or 3 dimensions, these points have " + std::to_string(dim) +
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
    } else if (ending == ".ply") {
        jobs->push_back({path, [source](TextWriter& out) { write_ply(*source, out); }});
    } else if (ending == ".obj") {
        jobs->push_back({path, [source](TextWriter& out) { write_obj(*source, out); }});
    } else if (ending == ".msh") {
        jobs->push_back({path, [source](TextWriter& out) { write_msh(*source, out); }});
    } else if (ending == ".mesh") {
        jobs->push_back({path, [source](TextWriter& out) { write_medit(*source, out); }});
        if (mesh.has_values)
            jobs->push_back({stem_of(path) + ".sol", [source](TextWriter& out) { write_medit_values(*source, out); }});
    } else {
        jobs->push_back({path, [source](TextWriter& out) { write_off(*source, out); }});
    }
}

}  // namespace netmesh::tool
