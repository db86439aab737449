// Results on their way out of a command.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "netmesh.hpp"
#include "tools/io/diagram_file.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/io/provenance.hpp"
#include "tools/outcome.hpp"
#include "tools/report/report.hpp"

namespace netmesh::tool {

// One file to be written; an empty path is stdout.
struct FileJob {
    std::string path;
    std::function<void(TextWriter&)> write;
};

// How a run that fails ends: its message on stderr and, with --json, an object on stdout. Nothing where all has been
// said.
void tell_error(const Outcome& outcome, Command command, bool json);

// What `run` says, or what it throws as an outcome: where the tool has no memory for its copy of the input.
Outcome without_exceptions(const std::function<Outcome()>& run);

// All of them or, on the first fault or signal, none: the files get their names only when each is complete.
Outcome write_files(const std::vector<FileJob>& jobs);

// Exit::data unless each of the paths (empty ones are skipped) looks writable. For before the work begins.
Outcome check_writable(const std::vector<std::string>& paths);
// No output may be an input, or another output; .ele and .neigh go with .node, .sol with .mesh.
Outcome check_apart(const Options& options);

// The end of a run that began at `start`: writes the files and, with --json, the report on stdout, else on stderr.
Outcome finish_run(const std::vector<FileJob>& jobs, double start, RunReport* run);

// The mesh that an engine holds.
class EngineMesh : public MeshSource {
public:
    explicit EngineMesh(const Engine& engine) : EngineMesh(engine, engine.report()) {}
    EngineMesh(const Engine& engine, const netmesh_report& report);  // the engine's: each costs O(cells)
    netmesh_vertex vertex(std::uint64_t index) const override;
    netmesh_cell cell(std::uint64_t index) const override;
    // Fills ratios and domains; leaves them empty when there is no memory left for that.
    void measure();

private:
    Engine engine_;  // a handle
};

// The vertices and cells of a mesh as its files have them.
MeshFiles files_of(const EngineMesh& mesh);

// The diagram that an engine holds, read where it stands, and as a list; its bounds, empty unless there are some.
BarSource bars_in(const Engine& engine);
std::vector<Bar> bars_of(const BarSource& bars);
inline std::vector<Bar> bars_of(const Engine& engine) { return bars_of(bars_in(engine)); }
Bounds bounds_of(const Engine& engine, const netmesh_report& report);
inline Bounds bounds_of(const Engine& engine) { return bounds_of(engine, engine.report()); }

// "FILE: note" on stderr, unless there is none or --quiet was given.
void tell_note(const Options& options, const std::string& file, const std::string& note);
// The same whatever the options: what a caller must not miss.
void tell_warning(const std::string& file, const std::string& warning);

// read_points, and on stderr its note unless --quiet was given. Of filter rips with any number of columns.
Outcome read_cloud(const Options& options, const std::string& path, PointCloud* cloud);

// Exit::usage unless `path` is empty or has the ending: "FILE: WHAT is written to ENDING".
Outcome check_ending(const std::string& path, const char* ending, const char* what);

// The same for those that a diagram, a picture ("-" is stdout) and cycles can be written to; cycles have .vtu, .obj and
// .svg where their vertices have places, in 2 or 3 dimensions (0: not known yet).
Outcome check_diagram_ending(const std::string& path);
Outcome check_picture_ending(const Options& options);
Outcome check_cycles_ending(const std::string& path, bool has_places, std::uint32_t dim);

// Where rips_proof() makes none.
inline Outcome no_numbers_for_proof() {
    return usage_error("--proof: simplices of so many points in so high a degree cannot be numbered in 64 bits; "
                       "--threshold or --max-degree leave some out");
}

// Which bars --least and --top leave, in their order; empty when they leave all. Of each degree no more than --top are
// held at a time.
std::vector<bool> chosen_bars(const Options& options, const BarSource& bars);
// Those alone; `chosen` must outlive the source.
BarSource chosen_of(const BarSource& bars, const std::vector<bool>& chosen);
void keep_chosen(const std::vector<bool>& chosen, Bounds* bounds);
// The diagram by the ending of options.out; `head` goes in front of a whole one in .pers. `bars` are those chosen, and
// read when the job is done. All must outlive the job.
FileJob diagram_job(const Options& options, const Head& head, const std::vector<bool>& chosen, const BarSource& bars,
                    const Bounds& bounds);
// Whether somebody has to look at all bars at once: a picture, or JSON that holds them.
inline bool needs_list(const Options& options) { return !options.svg.empty() || (options.json && options.out.empty()); }
// A picture: its file, stdout for "-".
inline std::string picture_path(const std::string& svg) { return svg == "-" ? "" : svg; }
// Whether the data go out: not where only a picture does, or only JSON.
inline bool writes_data(const Options& options) {
    return !options.out.empty() || (!options.json && options.svg != "-");
}

// Exit::usage unless `path` is empty (stdout, OFF) or has an ending that meshes can be written to; with a dimension
// other than 0 also when the format cannot hold it.
Outcome check_mesh_ending(const std::string& path, std::uint32_t dim);
// The files of a mesh by the ending of `path`: one, or three for .node.
void add_mesh_files(const MeshSource& mesh, const std::string& path, std::vector<FileJob>* jobs);

}  // namespace netmesh::tool
