// mesh, delaunay and persist: points in, a few calls of the engine, files out.
#include <set>

#include "platform/clock.hpp"
#include "platform/files.hpp"
#include "platform/folders.hpp"
#include "platform/workers.hpp"
#include "tools/asked_function.hpp"
#include "tools/commands/check_parts.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/cycles.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/rips_input.hpp"
#include "tools/commands/several.hpp"
#include "tools/commands/steps.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/provenance.hpp"
#include "tools/opinion/cell_values.hpp"
#include "tools/pieces/schedule.hpp"
#include "tools/plot/plots.hpp"
#include "tools/proof/column_proof.hpp"
#include "tools/proof/proof_writer.hpp"

namespace netmesh::tool {

namespace {

// Names of outputs, in which {} stands for the input's.
constexpr std::string Options::*outputs[] = {
    &Options::out,   &Options::svg,       &Options::mesh_out,     &Options::representatives,
    &Options::proof, &Options::pace_path, &Options::weighted_path};

bool persists(const Options& options) { return options.command == Command::persist; }

// What the diagram is of; of other commands like that of a filter that needs what they make.
netmesh_filter_info kind_of(const Options& options) {
    if (persists(options)) return about(filter_of(options));
    return about(options.command == Command::delaunay ? NETMESH_FILTER_ALPHA : NETMESH_FILTER_COMPLETE);
}
bool has_cells(const netmesh_filter_info& filter) { return filter.is_on_mesh != 0 || filter.is_on_triangulation != 0; }

// Of the filter function: are its figures possible, and is the error what was asked for?
Outcome check_error(const Options& options, const Engine& engine) {
    const Outcome outcome = check_claims(options, engine);
    const double asked = options.request.goal.error;
    if (!outcome.good() || asked == 0) return outcome;
    const double error = engine.report().diagram.certified_error;
    if (error <= asked) return outcome;
    return usage_error("--error " + number_text(asked) + ": the mesh made for it certifies " + bound_text(error, 6) +
                       " only");
}

// Once before the points are read, with dim 0, and once behind.
Outcome check_outputs(const Options& options, std::uint32_t dim) {
    Outcome outcome = check_picture_ending(options);
    if (outcome.good() && persists(options)) {
        outcome = check_diagram_ending(options.out);
        if (outcome.good()) outcome = check_cycles_ending(options.representatives, true, dim);
        if (!outcome.good()) return outcome;
        outcome = check_mesh_ending(options.mesh_out, dim);
        if (outcome.good() && !options.proof.empty())
            outcome = check_ending(options.out, ".pers", "a diagram with a proof");
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
    return check_writable({options.out, options.mesh_out, options.svg, options.representatives, options.proof,
                           options.pace_path, options.weighted_path});
}

// What a command starts from.
struct Input {
    PointCloud cloud;  // the points, or the vertices of the mesh
    MeshFiles mesh;    // with --values-at
    std::optional<Collection> pieces;
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
    if (options.request.bounds != nullptr && kind_of(options).is_on_points != 0)
        return usage_error(std::string("--bounds does not apply to filter ") + kind_of(options).name);
    Outcome outcome = check_outputs(options, 0);
    const bool has_values = persists(options) && !options.values_at.empty();
    if (!outcome.good() || goes_by_pieces(options)) return outcome;  // these read points themselves
    outcome = has_values ? read_mesh(asked, input) : read_cloud(options, options.positionals[0], cloud);
    if (outcome.good()) asked->table.lattice = cloud->lattice;  // with what --cell file stands for
    if (outcome.good()) outcome = check_outputs(options, cloud->dim);
    if (outcome.good()) outcome = check_coordinates(options, cloud->dim);
    return outcome;
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

netmesh_status analyse(Session& session, bool is_mesh, netmesh_analysis* analysis) {
    netmesh_analyse_request request = sized<netmesh_analyse_request>();
    const netmesh_request promise = session.promise();
    request.promised = &promise;
    if (!is_mesh) request.what = NETMESH_ANALYSE_STRUCTURE | NETMESH_ANALYSE_FATNESS;
    return session.call(NETMESH_STAGE_ANALYSE,
                        [&] { return session.engine().analyse(analysis, session.watched(request)); });
}

netmesh_status work(Session& session, const Options& options, Input& input, Measured* measured) {
    const PointCloud& cloud = input.cloud;
    netmesh_status status;
    if (input.pieces) {
        status = input.pieces->collect(session);
    } else if (persists(options)) {
        status = persist_as_asked(session, cloud, options.vertex_function ? &input.mesh : nullptr);
    } else {
        const bool is_mesh = options.command == Command::mesh;
        status = make_mesh(session, cloud);
        if (status == NETMESH_OK && options.analyse) status = analyse(session, is_mesh, &measured->analysis);
        if (status == NETMESH_OK) status = measure(session, options, measured);
    }
    if (status == NETMESH_OK && options.check && has_cells(kind_of(options))) status = check_everything(session);
    return status;
}

// The complex whose cycles are looked at; none where that is not asked for, or too large.
SimplexList complex_of(const Options& options, const Engine& engine, const PointCloud& cloud) {
    if (!options.check) return {};
    const netmesh_diagram_report diagram = engine.report().diagram;
    if (diagram.representatives == 0) return {};
    const std::uint32_t top = diagram.max_degree + 1;
    const netmesh_filter_info kind = kind_of(options);
    if (kind.is_by_scales != 0) return complex_of_points(cloud, false, top, joined_simplices_max);
    if (kind.is_on_points != 0) return complex_of_points(cloud, diagram.filter == NETMESH_FILTER_RIPS, top);
    const MeshFiles files = files_of(EngineMesh(engine));
    if (kind.is_on_triangulation != 0) return alpha_complex(files, top);
    const NodeFile& node = files.node;
    std::uint64_t unknown = 0;
    return mesh_complex(files, node.attributes, zero_born(node, diagram.filter, diagram.k), top, &unknown);
}

std::string checked_text(const Options& options, const SimplexList& complex) {
    const netmesh_filter_info kind = kind_of(options);
    if (kind.is_by_scales != 0)
        return std::string("bars sorted, with one essential class; every bar has a closed cycle of points that is born "
                           "with it within the ratio") +
               (complex ? " and dies with it so" : "; too many simplices, so nobody looked when it dies");
    if (kind.is_on_points != 0) return kind.has_representatives != 0 ? cycles_checked(complex) : "the diagram's form";
    if (!options.table.weights.empty()) return "combinatorics and orientation of the regular triangulation";
    if (options.command == Command::delaunay) return "combinatorics, orientation, Delaunay property";
    return std::string("combinatorics, orientation, Delaunay property, quality, bounds on size and degrees") +
           (options.representatives.empty() ? "" : "; " + cycles_checked(complex));
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
    const bool any_sign = diagram.filter == NETMESH_FILTER_FUNCTION || !cloud.weights.empty();
    std::string complaint = diagram_complaint(bars, nullptr, any_sign, may_end_beyond(diagram.filter));
    const bool cycles = diagram.representatives != 0;
    const bool by_scales = about(diagram.filter).is_by_scales != 0;
    if (complaint.empty() && cycles && by_scales) complaint = point_cycles_complaint(engine, complex, cloud);
    if (complaint.empty() && cycles && !by_scales) complaint = cycles_complaint(engine, complex, 0);
    if (complaint.empty()) return {};
    return {Exit::check, "netmesh: check failed: diagram: " + complaint};
}

// What goes out of an engine, read one item at a time.
struct Result {
    EngineMesh mesh;
    BarSource bars;         // those chosen
    std::vector<Bar> list;  // the same, where somebody looks at all at once
    Bounds bounds;
    std::vector<bool> chosen;  // bars of the engine's diagram that these are; empty: all
    Head head;
    CyclePlaces places;
    std::string proof;  // of a Rips or Cech diagram
};

// Cycles go by vertices of a mesh, or by points.
CyclePlaces places_of(const Options& options, const EngineMesh& mesh, const PointCloud& cloud,
                      const netmesh_report& report) {
    if (!has_cells(kind_of(options)) || report.input.periods > 0) return places_of(cloud);
    CyclePlaces places;
    places.dim = mesh.dim;
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        places.coordinates.insert(places.coordinates.end(), vertex.coordinates, vertex.coordinates + mesh.dim);
        places.inputs += vertex.marker == 0;
    }
    if (report.diagram.filter != NETMESH_FILTER_ALPHA || !cloud.weights.empty() || mesh.dim > 3) return places;
    for (std::uint64_t c = 0; c < mesh.cell_count; c++) {
        const netmesh_cell cell = mesh.cell(c);
        places.cells.insert(places.cells.end(), cell.vertices, cell.vertices + mesh.dim + 1);
    }
    return places;
}

std::vector<std::uint64_t> hidden_rows(const Engine& engine, const netmesh_report& report) {
    std::vector<std::uint64_t> rows(report.input.hidden);
    for (std::size_t i = 0; i < rows.size(); i++) netmesh_get_hidden(engine.context(), i, &rows[i]);
    return rows;
}

// Files, pictures, data on stdout: what the options ask for. All that is handed over must outlive the jobs.
std::vector<FileJob> diagram_jobs(const Options& options, const Engine& engine, const Result& result,
                                  const PointCloud& cloud, const netmesh_report& report) {
    std::vector<FileJob> jobs;
    if (!options.representatives.empty())
        jobs.push_back({options.representatives, [&](TextWriter& out) {
                            write_cycles(engine, options.representatives, result.chosen, result.places, out);
                        }});
    if (!options.mesh_out.empty()) add_mesh_files(result.mesh, options.mesh_out, &jobs);
    if (!options.proof.empty())
        jobs.push_back({options.proof, [&](TextWriter& out) {
                            if (!result.proof.empty()) {
                                out << result.proof;
                                return;
                            }
                            write_proof(result.mesh, cloud, hidden_rows(engine, report), result.bars,
                                        options.table.are_radii, out);
                        }});
    if (!options.svg.empty()) {
        const auto draw = [&](TextWriter& out) {
            out << diagram_picture(result.list, report, result.bounds, options.axis);
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
void take_focus(const netmesh_goal& made, Options* options) {
    options->focus_auto = false;
    options->request.fit = nullptr;
    options->request.goal = made;
}

// Whether what goes out says what is certified of the diagram: the head of a whole one, or the report.
bool says_ratio(const Options& options) {
    const bool is_whole = options.top == 0 && options.least == 0;
    const bool has_head = options.out.empty() || ending_of(options.out) == ".pers";
    return options.json || (is_whole && has_head && writes_data(options));
}

// The filter that the engine has taken, as if it had been asked for; and one line about it where none was asked for,
// also with --quiet where the diagram is not exact and nothing else says so.
void take_filter(const netmesh_diagram_report& diagram, std::uint32_t dim, Options* options) {
    const bool is_auto = options->request.filter == &netmesh_filter_auto;
    if (!persists(*options) || !(is_auto || !options->implies_mesh.empty())) return;
    const bool is_hidden = is_auto && diagram.certified_ratio != 1 && !says_ratio(*options);
    if (!options->quiet || is_hidden) {
        const std::string reason = is_auto ? netmesh_why_text(diagram.why) : options->implies_mesh + " asks for a mesh";
        // Of points on a line pairs of balls say all, and exactly; of few points all balls do.
        const bool is_flat = is_auto && diagram.why == NETMESH_WHY_FLAT;
        const std::string text = std::string("filter ") + filter_name(diagram.filter) + ": " + reason +
                                 (!is_flat   ? ""
                                  : dim == 2 ? "; on a line --filter rips is exact"
                                             : "; --filter cech is exact, for few points") +
                                 (is_hidden ? "; certified ratio " + bound_text(diagram.certified_ratio, 6) +
                                                  ", which a whole .pers alone says"
                                            : "") +
                                 "\n";
        std::fputs(text.c_str(), stderr);
    }
    options->request.filter = about(diagram.filter).filter;
}

// One line where the points have no classes of the degrees that were asked for.
void tell_highest_degree(const Options& options, const std::string& name, const netmesh_diagram_report& diagram) {
    const std::uint32_t asked = options.request.max_degree;
    if (!persists(options) || asked == NETMESH_OPEN || asked <= diagram.max_degree) return;
    tell_note(options, name,
              "--max-degree " + std::to_string(asked) + " is taken as " + std::to_string(diagram.max_degree) +
                  ": there is nothing of higher degree");
}

// One line where tau is so near 2 that spread points take long, before the work begins. The figures are those of
// netmesh_mesh in netmesh/mesh.h.
void tell_cost(const Options& options, const PointCloud& cloud) {
    constexpr double near = 0.25;
    const double above = options.request.mesh.tau - 2;
    if (!(above > 0 && above < near) || cloud.dim > 4) return;
    double each = 8;
    for (std::uint32_t d = 1; d < cloud.dim; ++d) each *= 5 / above;
    tell_note(options, cloud.name,
              "--tau " + number_text(options.request.mesh.tau) +
                  " is near 2: for every factor of ten between distances a mesh takes " + "some " +
                  grouped_text(static_cast<std::uint64_t>(each)) + " vertices around each cluster");
}

// A folder that stays where it was named, and is gone with this object where it was not.
class ScratchFolder {
public:
    explicit ScratchFolder(const std::string& named) : name_(named), stays_(!named.empty()) {
        if (!stays_) name_ = platform::temporary_folder(&why_);
    }
    ~ScratchFolder() {
        if (!stays_ && !name_.empty()) platform::remove_folder(name_);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const std::string& name() const { return name_; }
    const std::string& why() const { return why_; }

private:
    std::string name_, why_;
    bool stays_;
};

// Makes all pieces of the points. Their memory is each process's; that of the diagram is another.
Outcome make_pieces(Options* options, const ScratchFolder& scratch, Input* input, double* read_seconds) {
    if (scratch.name().empty()) return data_error("netmesh: " + scratch.why() + "; --scratch names a folder");
    const PiecesFolder folder(scratch.name());
    PointsFile points;
    Outcome outcome = split_task(*options, folder, options->positionals[0], read_seconds, &points);
    if (outcome.good()) input->cloud = nothing_of(points.job());
    const unsigned jobs = options->jobs > 0 ? options->jobs : platform::processors();
    if (outcome.good()) outcome = run_tasks(*options, folder, points.job(), jobs);
    input->pieces.emplace();
    if (outcome.good()) outcome = input->pieces->open(folder, points.job());
    options->memory_bytes = 0;
    return outcome;
}

Outcome make_and_finish(Options& options, Input& input, double start, double read_seconds);

Outcome run_one(const Options& from) {
    if (goes_by_distances(from)) return run_distances(from);
    const Outcome apart = check_apart(from);
    if (!apart.good()) return apart;
    const double start = platform::seconds_now();
    Options given = from;
    Input input;
    Outcome outcome = read_input(&given, &input);
    if (!outcome.good()) return outcome;
    double read_seconds = platform::seconds_now() - start;
    if (!goes_by_pieces(given)) return make_and_finish(given, input, start, read_seconds);
    const ScratchFolder scratch(given.scratch);
    outcome = make_pieces(&given, scratch, &input, &read_seconds);
    return outcome.good() ? make_and_finish(given, input, start, read_seconds) : outcome;
}

// What is asked for of an input that has been read, and what goes out.
Outcome make_and_finish(Options& options, Input& input, double start, double read_seconds) {
    const PointCloud& cloud = input.cloud;
    RunReport run;
    run.options = &options;
    run.read_seconds = read_seconds;
    Outcome outcome;

    Session session(options, cloud.dim);
    Measured measured;
    if (options.vertex_function) outcome = settle_mesh(options, &input.mesh, &session);
    if (!outcome.good()) return outcome;
    tell_cost(options, cloud);
    if (persists(options) && about(filter_of(options)).needs_k != 0 && about(filter_of(options)).is_on_mesh != 0 &&
        !was_given(options, "--k"))
        tell_note(options, cloud.name,
                  std::string("filter ") + filter_name(filter_of(options)) +
                      " with --k 1 is the distance to the points, outliers and all; --k 4 does not see single ones");
    const auto all_work = [&](Session& s) { return work(s, options, input, &measured); };
    outcome =
        session.run(input.pieces ? input.pieces->plan() : plan_of(options, cloud.dim, cloud.rows()), cloud, all_work);
    if (input.pieces && !input.pieces->explain(session.engine().detail()).good())
        return input.pieces->explain(session.engine().detail());
    if (outcome.good() && persists(options)) outcome = check_error(options, session.engine());
    if (!outcome.good()) return outcome;
    run.engine = session.report();
    if (options.focus_auto) take_focus(run.engine->mesh.goal, &options);
    take_filter(run.engine->diagram, cloud.dim, &options);
    tell_highest_degree(options, cloud.name, run.engine->diagram);
    run.clock = session.clock();
    if (options.analyse) run.analysis = measured.analysis;
    const SimplexList complex = complex_of(options, session.engine(), cloud);
    if (options.check) run.checked = std::vector<std::string>{checked_text(options, complex)};

    const BarSource bars = bars_in(session.engine());
    Result result{EngineMesh(session.engine(), *run.engine), bars, {}, {}, {}, {}, {}, {}};
    const std::string& mesh_path = persists(options) ? options.mesh_out : options.out;
    const netmesh_mesh_rules rules = session.promise().mesh;
    result.mesh.size_at_inputs = rules.sizes.at_inputs;
    result.mesh.size_growth = rules.sizes.growth;
    result.mesh.net_spacing = rules.net_spacing;
    if (run.engine->mesh.is_mesh != 0 && ending_of(mesh_path) == ".vtu") result.mesh.measure();
    if (!persists(options)) return finish_run(mesh_jobs(options, measured, result.mesh), start, &run);

    result.bounds = bounds_of(session.engine(), *run.engine);
    if (options.check) outcome = check_result(session.engine(), bars_of(bars), complex, cloud);
    if (!outcome.good()) return outcome;
    result.chosen = chosen_bars(options, bars);
    result.bars = chosen_of(bars, result.chosen);
    keep_chosen(result.chosen, &result.bounds);
    if (needs_list(options)) result.list = bars_of(result.bars);
    const std::uint32_t top = run.engine->diagram.max_degree;
    if (!options.proof.empty() && filter_of(options) == NETMESH_FILTER_CECH)
        result.proof = cech_proof(cloud, top, bars);
    if (!options.proof.empty() && filter_of(options) == NETMESH_FILTER_RIPS) {
        result.proof = rips_proof(cloud, options.request.threshold, top, bars);
        if (result.proof.empty()) return no_numbers_for_proof();
    }
    result.head = head_of(options, *run.engine);
    const std::string cycles_ending = ending_of(options.representatives);
    if (needs_places(cycles_ending)) result.places = places_of(options, result.mesh, cloud, *run.engine);
    result.places.all_chosen = !result.chosen.empty();
    if (options.request.bounds != nullptr) run.bounds = &result.bounds;
    if (options.json && options.out.empty()) run.bars = &result.list;
    return finish_run(diagram_jobs(options, session.engine(), result, cloud, *run.engine), start, &run);
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
    if (!options.scratch.empty()) return usage_error("--scratch is for one input: a folder belongs to one job");
    for (const std::string& path : options.positionals) {
        std::string why;
        if (!options.table.columns.empty() && path != "-" && path.find('.') == std::string::npos &&
            !platform::InputFile().open(path, &why))
            return usage_error(path + ": " + why + "; names of columns are joined by commas, without blanks");
    }
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

// The options and what there is of the input, from the folder.
Outcome collect(const Options& from) {
    const double start = platform::seconds_now();
    const PiecesFolder folder(from.positionals[1]);
    PointsFile points;
    Outcome outcome = points.open(folder.points());
    if (!outcome.good()) return outcome;
    const PiecesJob& job = points.job();
    for (const char* const name :
         {"--max-degree", "--all", "--pieces", "--columns", "--delimiter", "--skip", "--drop-missing"})
        if (was_given(from, name))
            return usage_error(std::string(name) + " does nothing here: split has said it of all pieces");
    Options options = persist_options(from, job);
    Input input;
    input.cloud = nothing_of(job);
    outcome = check_outputs(options, job.dim);
    input.pieces.emplace();
    if (outcome.good()) outcome = input.pieces->open(folder, job);
    return outcome.good() ? make_and_finish(options, input, start, platform::seconds_now() - start) : outcome;
}

Outcome split(const Options& options) {
    for (const char* const name : {"-o", "--least", "--min-persistence", "--top", "--svg", "--axis", "--json"})
        if (was_given(options, name)) return usage_error(std::string(name) + " does nothing here: it is of collect");
    const PiecesFolder folder(options.positionals[2]);
    const std::string makefile = folder.path() + "/Makefile";
    std::string there, why;
    if (platform::read_file(makefile, &there, &why) && there.compare(0, makefile_mark.size(), makefile_mark) != 0)
        return file_error(makefile, "a file of that name is there, which netmesh has not written; name another folder");
    double ignored;
    PointsFile points;
    Outcome outcome = split_task(options, folder, options.positionals[1], &ignored, &points);
    if (!outcome.good()) return outcome;
    outcome = write_files({{makefile, [&](TextWriter& out) { out << makefile_of(points.job()); }}});
    if (outcome.good() && !options.quiet)
        std::fprintf(stderr, "%s: %s in %u pieces; `make -C %s` makes the diagram\n", folder.path().c_str(),
                     counted(points.job().count, "point", "points").c_str(), points.job().pieces,
                     folder.path().c_str());
    return outcome;
}

}  // namespace

Outcome run_pieces(const Options& options) {
    const std::vector<std::string>& words = options.positionals;
    const std::string& task = words[0];
    const std::size_t due = task == "collect" ? 2 : 3;
    if (task != "split" && task != "leaf" && task != "join" && task != "collect")
        return usage_error("pieces " + task + ": there are split, leaf, join and collect");
    if (words.size() != due)
        return usage_error("pieces " + task + " takes " +
                           (task == "split"     ? "POINTS DIR"
                            : task == "collect" ? "DIR"
                                                : "DIR NODE"));
    if (task == "collect") return collect(options);
    if (task == "split") return split(options);
    for (const auto& given : options.given)
        if (given.first != "--memory" && given.first != "--quiet")
            return usage_error(given.first + " does nothing here: split has said it of all pieces");
    const PiecesFolder folder(words[1]);
    std::uint64_t node = 0;
    PointsFile points;
    const Outcome outcome = points.open(folder.points());
    if (!outcome.good()) return outcome;
    const bool is_leaf = task == "leaf";
    const std::uint64_t first = is_leaf ? points.job().pieces : 1;
    const std::uint64_t last = is_leaf ? 2 * std::uint64_t{first} - 1 : points.job().pieces - 1;
    if (!parse_unsigned(words[2], &node) || node < first || node > last)
        return usage_error("pieces " + task + " " + words[2] + ": nodes of this job are " + std::to_string(first) +
                           " to " + std::to_string(last));
    platform::Reservation block;
    return piece_task(options, folder, points.job(), static_cast<std::uint32_t>(node), &block);
}

Outcome run_engine_command(const Options& options) {
    const auto run = [&](const std::string& path) { return run_one(for_input(options, path)); };
    if (options.positionals.size() == 1) return run(options.positionals[0]);
    const Outcome outcome = check_several(options);
    if (!outcome.good()) return outcome;
    const bool side_by_side = options.jobs > 1 && !goes_by_pieces(options) && platform::has_processes();
    return side_by_side ? run_side_by_side(options, run) : run_one_by_one(options, run);
}

}  // namespace netmesh::tool
