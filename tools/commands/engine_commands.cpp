// mesh, delaunay and persist: points in, a few calls of the engine, files out.
#include <set>

#include "platform/clock.hpp"
#include "tools/commands/check_parts.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/cycles.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/provenance.hpp"
#include "tools/opinion/cell_values.hpp"
#include "tools/plot/plots.hpp"

namespace netmesh::tool {

namespace {

// Names of outputs, in which {} stands for the input's.
constexpr std::string Options::*outputs[] = {&Options::out,       &Options::svg,
                                             &Options::mesh_out,  &Options::representatives,
                                             &Options::pace_path, &Options::weighted_path};

bool persists(const Options& options) { return options.command == Command::persist; }

netmesh_source source_of(const Options& options) {
    if (persists(options)) return about(filter_of(options)).source;
    return options.command == Command::delaunay ? NETMESH_SOURCE_DELAUNAY : NETMESH_SOURCE_MESH;
}

// Not every filter has bounds, cycles and a mesh to be written.
Outcome check_filter(const Options& options) {
    if (!persists(options)) return {};
    const netmesh_filter_info& filter = about(filter_of(options));
    const std::string name = filter.name;
    if (!options.representatives.empty() && filter.has_representatives == 0)
        return usage_error("--representatives does not apply to filter " + name);
    if (!is_on_points(filter.filter)) return {};
    if (options.bounds) return usage_error("--bounds does not apply to filter " + name);
    if (!options.mesh_out.empty()) return usage_error("--mesh: filter " + name + " has no mesh");
    return check_max_degree(options);
}

// Of the filter function: are its figures possible, and is the error what was asked for?
Outcome check_error(const Options& options, const Engine& engine) {
    const Outcome outcome = check_claims(options, engine);
    if (!outcome.good() || options.error == 0) return outcome;
    const double error = engine.report().diagram.certified_error;
    if (error <= options.error) return outcome;
    return usage_error("--error " + number_text(options.error) + ": the mesh made for it certifies " +
                       rounded_text(error, 6) + " only");
}

// Once before the points are read, with dim 0, and once behind.
Outcome check_outputs(const Options& options, std::uint32_t dim) {
    Outcome outcome = check_picture_ending(options);
    if (outcome.good() && persists(options)) {
        outcome = check_diagram_ending(options.out);
        if (outcome.good()) outcome = check_cycles_ending(options.representatives, true, dim);
        if (!outcome.good()) return outcome;
        if (source_of(options) == NETMESH_SOURCE_SCALES && !options.mesh_out.empty()) {
            return usage_error("--mesh " + options.mesh_out + ": scales has one mesh after the other and keeps none");
        }
        outcome = check_mesh_ending(options.mesh_out, dim);
    } else if (outcome.good()) {
        outcome = check_mesh_ending(options.out, dim);
        if (!options.svg.empty() && dim > 3) {
            return usage_error("--svg " + options.svg + ": draws meshes in 2 or 3 dimensions, these points have " +
                               counted(dim, "dimension", "dimensions"));
        }
        if (options.voronoi && dim > 2) return usage_error("--voronoi: draws cells in 2 dimensions");
        if (options.voronoi && options.svg.empty()) return usage_error("--voronoi goes with --svg");
    }
    if (!outcome.good()) return outcome;
    return check_writable({options.out, options.mesh_out, options.svg, options.representatives, options.pace_path,
                           options.weighted_path});
}

// What a command starts from.
struct Input {
    PointCloud cloud;  // the points, or the vertices of the mesh
    MeshFiles mesh;    // with --values-at
};

Outcome read_mesh(Options* options, Input* input) {
    const std::string& path = options->positionals[0];
    if (ending_of(path) != ".node") return usage_error("--values-at goes with a mesh, MESH.node, not with " + path);
    Outcome outcome = read_mesh_files(path, &input->mesh);
    if (!outcome.good()) return outcome;
    const NodeFile& node = input->mesh.node;
    if (node.domain.empty())
        return file_error(node.cloud.name, "no mesh with a domain, as `netmesh mesh` makes it: no line `# domain`");
    if (!node.cages.empty())
        return file_error(node.cloud.name, "a mesh with cages, which have no filter; --finish removes them");
    input->cloud = node.cloud;
    return read_values_at(node, options);
}

// Everything that can be wrong before the work begins; reads the points, or mesh and values, in between.
Outcome read_input(Options* asked, Input* input) {
    const Options& options = *asked;
    PointCloud* const cloud = &input->cloud;
    Outcome outcome = check_accuracy(options);
    if (outcome.good()) outcome = check_ratio(options);
    if (outcome.good()) outcome = check_filter(options);
    if (outcome.good() && persists(options)) outcome = check_function(options);
    if (outcome.good()) outcome = check_outputs(options, 0);
    const bool has_values = persists(options) && !options.values_at.empty();
    if (outcome.good())
        outcome = has_values ? read_mesh(asked, input) : read_cloud(options, options.positionals[0], cloud);
    if (outcome.good()) outcome = check_outputs(options, cloud->dim);
    if (outcome.good()) outcome = check_coordinates(options, cloud->dim);
    return outcome;
}

std::size_t plan_of(const Options& options, const PointCloud& cloud) {
    if (persists(options)) return plan_diagram(options, filter_of(options), cloud.dim, cloud.rows());
    if (options.command == Command::mesh) {
        requests::Mesh mesh = mesh_request(options, cloud.dim);
        mesh.point_count = cloud.rows();
        return plan(mesh);
    }
    requests::Delaunay delaunay = delaunay_request(options, cloud.dim);
    delaunay.point_count = cloud.rows();
    return plan(delaunay);
}

// What is looked at besides the mesh and the diagram, as far as the options ask for it.
struct Measured {
    netmesh_analysis analysis = {};
    std::vector<std::uint32_t> order;  // --pace
    std::vector<double> theta;
    std::vector<netmesh_weighted_cell> cells;  // --weighted-cells
};

netmesh_status measure(Session& session, const Options& options, Measured* measured) {
    const Engine& engine = session.engine();
    netmesh_status status = NETMESH_OK;
    if (!options.pace_path.empty()) {
        const std::size_t inputs = engine.report().mesh.inputs;
        measured->order.resize(inputs);
        measured->theta.resize(inputs);
        status = session.call(NETMESH_STAGE_ANALYSE, [&] {
            return session.engine().well_paced_order(measured->order.data(), measured->theta.data());
        });
    }
    if (status != NETMESH_OK || options.weighted_path.empty()) return status;
    measured->cells.assign(engine.report().mesh.hierarchy.cages, {sizeof(netmesh_weighted_cell), 0, 0, 0, 0, 0, 0});
    if (measured->cells.empty()) return status;
    return session.call(NETMESH_STAGE_ANALYSE, [&] { return session.engine().weighted_cells(measured->cells.data()); });
}

netmesh_status analyse(Session& session, netmesh_source source, netmesh_analysis* analysis) {
    requests::Analyse request;
    request.mesh = &session.mesh();
    if (source == NETMESH_SOURCE_DELAUNAY) request.what &= ~static_cast<std::uint32_t>(NETMESH_ANALYSE_SIZE);
    return session.call(NETMESH_STAGE_ANALYSE,
                        [&] { return session.engine().analyse(analysis, session.watched(request)); });
}

netmesh_status work(Session& session, const Options& options, const Input& input, Measured* measured) {
    const PointCloud& cloud = input.cloud;
    const netmesh_source source = source_of(options);
    netmesh_status status;
    if (persists(options)) {
        status = persist_as_asked(session, options, cloud, options.vertex_function ? &input.mesh : nullptr);
    } else {
        status =
            source == NETMESH_SOURCE_MESH ? make_mesh(session, cloud) : make_triangulation(session, options, cloud);
        if (status == NETMESH_OK && options.analyse) status = analyse(session, source, &measured->analysis);
        if (status == NETMESH_OK) status = measure(session, options, measured);
    }
    const bool has_cells = source == NETMESH_SOURCE_MESH || source == NETMESH_SOURCE_DELAUNAY;
    if (status == NETMESH_OK && options.check && has_cells) status = check_everything(session);
    return status;
}

// The complex whose cycles are looked at; none where that is not asked for, or too large.
SimplexList complex_of(const Options& options, const Engine& engine, const PointCloud& cloud) {
    if (!options.check) return {};
    const netmesh_diagram_report diagram = engine.report().diagram;
    if (diagram.representatives == 0) return {};
    const std::uint32_t top = diagram.max_degree + 1;
    if (source_of(options) == NETMESH_SOURCE_SCALES) return complex_of_points(cloud, false, top, joined_simplices_max);
    if (source_of(options) == NETMESH_SOURCE_POINTS)
        return complex_of_points(cloud, diagram.filter == NETMESH_FILTER_RIPS, top);
    const MeshFiles files = files_of(EngineMesh(engine));
    if (source_of(options) == NETMESH_SOURCE_DELAUNAY) return alpha_complex(files, top);
    const NodeFile& node = files.node;
    std::uint64_t unknown = 0;
    return mesh_complex(files, node.attributes, zero_born(node, diagram.filter, diagram.k), top, &unknown);
}

std::string checked_text(const Options& options, const SimplexList& complex) {
    switch (source_of(options)) {
    case NETMESH_SOURCE_SCALES:
        return std::string("bars sorted, with one essential class; every bar has a closed cycle of points that is born "
                           "with it within the ratio") +
               (complex ? " and dies with it so" : "; too many simplices, so nobody looked when it dies");
    case NETMESH_SOURCE_POINTS:
        return about(filter_of(options)).has_representatives != 0 ? cycles_checked(complex) : "the diagram's form";
    default:
        return std::string("combinatorics, orientation, Delaunay property, quality, bounds on size and degrees") +
               (options.representatives.empty() ? "" : "; " + cycles_checked(complex));
    }
}

std::string point_cycles_complaint(const Engine& engine, const SimplexList& simplices, const PointCloud& cloud) {
    std::optional<FilteredComplex> complex;
    if (simplices) complex.emplace(*simplices, radius_tolerance);
    TextWriter text;
    std::vector<CycleEntry> cycles;
    write_cycles(engine, text);
    std::size_t at = 0;
    if (!parse_cycles(text.text(), "", &cycles).good()) return "cycles that cannot be read";
    const std::string complaint = point_cycles_complaint(cycles, engine.report().diagram.certified_ratio, cloud,
                                                         complex ? &*complex : nullptr, &at);
    return complaint.empty() ? "" : "bar " + bar_text({cycles[at].bar}, 0) + " " + complaint;
}

// What the tool itself finds wrong with the diagram.
Outcome check_result(const Engine& engine, const std::vector<Bar>& bars, const SimplexList& complex,
                     const PointCloud& cloud) {
    const netmesh_diagram_report diagram = engine.report().diagram;
    std::string complaint =
        diagram_complaint(bars, nullptr, diagram.filter == NETMESH_FILTER_FUNCTION, may_end_beyond(diagram.filter));
    const bool cycles = diagram.representatives != 0;
    const bool by_scales = about(diagram.filter).source == NETMESH_SOURCE_SCALES;
    if (complaint.empty() && cycles && by_scales) complaint = point_cycles_complaint(engine, complex, cloud);
    if (complaint.empty() && cycles && !by_scales) complaint = cycles_complaint(engine, complex, 0);
    if (complaint.empty()) return {};
    return {Exit::check, "netmesh: check failed: diagram: " + complaint};
}

// What goes out of an engine, read one item at a time.
struct Result {
    EngineMesh mesh;
    std::vector<Bar> bars;
    Bounds bounds;
    std::vector<bool> chosen;  // bars of the engine's diagram that these are; empty: all
    Head head;
    CyclePlaces places;
};

// Cycles go by vertices of a mesh, or by points.
CyclePlaces places_of(const Options& options, const EngineMesh& mesh, const PointCloud& cloud) {
    const netmesh_source source = source_of(options);
    if (source != NETMESH_SOURCE_MESH && source != NETMESH_SOURCE_DELAUNAY) return places_of(cloud);
    CyclePlaces places;
    places.dim = mesh.dim;
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        places.coordinates.insert(places.coordinates.end(), vertex.coordinates, vertex.coordinates + mesh.dim);
        places.inputs += vertex.marker == 0;
    }
    return places;
}

// Files, pictures, data on stdout: what the options ask for. All that is handed over must outlive the jobs.
std::vector<FileJob> diagram_jobs(const Options& options, const Engine& engine, const Result& result,
                                  const netmesh_report& report) {
    std::vector<FileJob> jobs;
    if (!options.representatives.empty())
        jobs.push_back({options.representatives, [&](TextWriter& out) {
                            write_cycles(engine, options.representatives, result.chosen, result.places, out);
                        }});
    if (!options.mesh_out.empty()) add_mesh_files(result.mesh, options.mesh_out, &jobs);
    if (!options.svg.empty()) {
        const auto draw = [&](TextWriter& out) {
            out << diagram_picture(result.bars, report, result.bounds, options.axis);
        };
        jobs.push_back({picture_path(options.svg), draw});
    }
    if (writes_data(options))
        jobs.push_back(diagram_job(options, result.head, result.chosen, result.bars, result.bounds));
    return jobs;
}

// Inputs in the order in which each is farthest from all before it, with their theta; with --theta those below it.
void write_pace(const Measured& measured, double theta, TextWriter& out) {
    out << "# input theta\n";
    for (std::size_t i = 0; i < measured.order.size(); i++)
        if (theta == 0 || measured.theta[i] < theta) out << measured.order[i] << ' ' << measured.theta[i] << '\n';
}

void write_weighted_cells(const Measured& measured, const MeshSource& mesh, TextWriter& out) {
    out << "# centre weight in_radius feature_size epsilon cage_in_radius cage_out_radius\n";
    for (std::size_t i = 0; i < measured.cells.size(); i++) {
        const netmesh_weighted_cell& cell = measured.cells[i];
        out << mesh.cages[i].centre << ' ' << cell.weight << ' ' << cell.in_radius << ' ' << cell.feature_size << ' '
            << cell.epsilon << ' ' << cell.cage_in_radius << ' ' << cell.cage_out_radius << '\n';
    }
}

std::vector<FileJob> mesh_jobs(const Options& options, const Measured& measured, const EngineMesh& mesh) {
    std::vector<FileJob> jobs;
    if (!options.pace_path.empty())
        jobs.push_back({options.pace_path, [&](TextWriter& out) { write_pace(measured, options.pace_theta, out); }});
    if (!options.weighted_path.empty())
        jobs.push_back({options.weighted_path, [&](TextWriter& out) { write_weighted_cells(measured, mesh, out); }});
    if (!options.svg.empty())
        jobs.push_back(
            {picture_path(options.svg), [&](TextWriter& out) { write_mesh_picture(mesh, options.voronoi, out); }});
    if (writes_data(options)) add_mesh_files(mesh, options.out, &jobs);
    return jobs;
}

// What --focus auto has chosen, as if it had been asked for: so the file says, and so `check` makes it again.
void take_focus(const netmesh_certificate_goal& goal, Options* options) {
    options->focus_auto = false;
    options->longer_than = 0;
    options->ratio = goal.ratio;
    options->focus = goal.focus_ratio;
    options->from = goal.focus_from;
    options->to = goal.focus_to;
}

// The filter that the engine has taken, as if it had been asked for; and one line about it where none was asked for.
void take_filter(const netmesh_diagram_report& diagram, Options* options) {
    if (options->filter || !persists(*options)) return;
    if (!options->quiet) {
        const std::string reason =
            options->auto_filter ? netmesh_why_text(diagram.why) : options->implies_mesh + " asks for a mesh";
        const std::string text = std::string("filter ") + filter_name(diagram.filter) + ": " + reason + "\n";
        std::fputs(text.c_str(), stderr);
    }
    options->filter = diagram.filter;
    options->auto_filter = false;
}

// One line where the points have no classes of the degrees that were asked for.
void tell_highest_degree(const Options& options, const std::string& name, const netmesh_diagram_report& diagram) {
    if (!persists(options) || options.max_degree.value_or(0) <= diagram.max_degree) return;
    tell_note(options, name,
              "--max-degree " + std::to_string(*options.max_degree) + " is taken as " +
                  std::to_string(diagram.max_degree) + ": there is nothing of higher degree");
}

// One line where tau is so near 2 that spread points take long, before the work begins. The figures are those of
// netmesh_mesh in netmesh/mesh.h.
void tell_cost(const Options& options, const PointCloud& cloud) {
    constexpr double near = 0.25;
    const double above = options.tau.value_or(0) - 2;
    if (!(above > 0 && above < near) || cloud.dim > 4) return;
    double each = 8;
    for (std::uint32_t d = 1; d < cloud.dim; ++d) each *= 5 / above;
    tell_note(options, cloud.name,
              "--tau " + number_text(*options.tau) +
                  " is near 2: for every factor of ten between distances a mesh takes " + "some " +
                  grouped_text(static_cast<std::uint64_t>(each)) + " vertices around each cluster");
}

Outcome run_one(const Options& from) {
    if (from.threshold) return run_distances(from);
    const Outcome apart = check_apart(from);
    if (!apart.good()) return apart;
    const double start = platform::seconds_now();
    Options given = from;
    Input input;
    Outcome outcome = read_input(&given, &input);
    if (!outcome.good()) return outcome;
    const PointCloud& cloud = input.cloud;
    Options options = suited(given, cloud.dim);
    options.bounds = options.bounds || options.focus_auto;
    RunReport run;
    run.options = &options;
    run.read_seconds = platform::seconds_now() - start;

    Session session(options, cloud.dim);
    Measured measured;
    if (options.vertex_function) outcome = settle_mesh(options, &input.mesh, &session);
    if (!outcome.good()) return outcome;
    tell_cost(options, cloud);
    const auto all_work = [&](Session& s) { return work(s, options, input, &measured); };
    outcome = session.run(plan_of(options, cloud), cloud, all_work);
    if (outcome.good() && persists(options)) outcome = check_error(options, session.engine());
    if (!outcome.good()) return outcome;
    run.engine = session.engine().report();
    if (options.focus_auto) take_focus(run.engine->mesh.certificate, &options);
    take_filter(run.engine->diagram, &options);
    tell_highest_degree(options, cloud.name, run.engine->diagram);
    run.clock = session.clock();
    if (options.analyse) run.analysis = measured.analysis;
    const SimplexList complex = complex_of(options, session.engine(), cloud);
    if (options.check) run.checked = std::vector<std::string>{checked_text(options, complex)};

    Result result{EngineMesh(session.engine(), *run.engine), {}, {}, {}, {}, {}};
    result.mesh.cage_kind = session.mesh().cage_kind;
    const std::string& mesh_path = persists(options) ? options.mesh_out : options.out;
    result.mesh.size_at_inputs = session.mesh().size_at_inputs;
    result.mesh.size_growth = session.mesh().size_growth;
    result.mesh.net_spacing = session.mesh().net_spacing;
    if (run.engine->mesh.is_mesh != 0 && ending_of(mesh_path) == ".vtu") result.mesh.measure();
    if (!persists(options)) return finish_run(mesh_jobs(options, measured, result.mesh), start, &run);

    result.bars = bars_of(session.engine());
    result.bounds = bounds_of(session.engine(), *run.engine);
    if (options.check) outcome = check_result(session.engine(), result.bars, complex, cloud);
    if (!outcome.good()) return outcome;
    result.chosen = chosen_bars(options, result.bars);
    keep_chosen(result.chosen, &result.bars, &result.bounds);
    result.head = head_of(options, *run.engine);
    const std::string cycles_ending = ending_of(options.representatives);
    if (needs_places(cycles_ending)) result.places = places_of(options, result.mesh, cloud);
    if (options.bounds) run.bounds = &result.bounds;
    if (options.json && options.out.empty()) run.bars = &result.bars;
    return finish_run(diagram_jobs(options, session.engine(), result, *run.engine), start, &run);
}

// The options of one of several inputs: {} in names of outputs is its name without folder and ending.
Options for_input(const Options& options, const std::string& path) {
    Options one = options;
    one.positionals = {path};
    std::string name = path.substr(path.rfind('/') + 1);
    if (ending_of(name) == ".gz") name.resize(name.size() - 3);
    name.resize(name.size() - ending_of(name).size());
    for (std::string Options::*output : outputs) {
        std::string& text = one.*output;
        for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}", at + name.size()))
            text.replace(at, 2, name);
    }
    return one;
}

// Several inputs need an output each.
Outcome check_several(const Options& options) {
    if (!options.values_at.empty()) return usage_error("--values-at goes with one mesh");
    if (options.out.empty() && !options.json)
        return usage_error(
            "several inputs need -o with {} in it, which stands for the name of each: -o 'out/{}.ENDING'");
    for (std::string Options::*output : outputs) {
        std::set<std::string> names;
        const std::string& given = options.*output;
        if (given == "-") return usage_error("--svg - is for one input");
        for (const std::string& path : options.positionals) {
            if (given.empty() || names.insert(for_input(options, path).*output).second) continue;
            return usage_error(given + ": several inputs would be written to one file; {} stands for the name of each");
        }
    }
    return {};
}

}  // namespace

// Of several inputs each is tried; the first that fails says how it ends.
Outcome run_engine_command(const Options& options) {
    if (options.positionals.size() == 1) return run_one(for_input(options, options.positionals[0]));
    Outcome ended = check_several(options);
    if (!ended.good()) return ended;
    for (const std::string& path : options.positionals) {
        const Outcome outcome = run_one(for_input(options, path));
        if (outcome.exit == Exit::usage || outcome.exit == Exit::cancelled) return outcome;
        tell_error(outcome, options.command, options.json);
        if (ended.good()) ended.exit = outcome.exit;
    }
    return ended;
}

}  // namespace netmesh::tool
