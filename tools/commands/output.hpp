// Results on their way out of a command.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "netmesh.hpp"
#include "tools/io/diagram_file.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/outcome.hpp"
#include "tools/report/report.hpp"

namespace netmesh::tool {

// One file to be written; an empty path is stdout.
struct FileJob {
    std::string path;
    std::function<void(TextWriter&)> write;
};

// All of them or, on the first fault or signal, none: the files get their names only when each is complete.
Outcome write_files(const std::vector<FileJob>& jobs);

// Exit::data unless each of the paths (empty ones are skipped) looks writable. For before the work begins.
Outcome check_writable(const std::vector<std::string>& paths);

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

// The diagram that an engine holds, and its bounds: empty unless there are some.
std::vector<Bar> bars_of(const Engine& engine);
Bounds bounds_of(const Engine& engine, const netmesh_report& report);
inline Bounds bounds_of(const Engine& engine) { return bounds_of(engine, engine.report()); }

// Exit::usage unless `path` is empty or has the ending: "FILE: WHAT is written to ENDING".
Outcome check_ending(const std::string& path, const char* ending, const char* what);

// Exit::usage unless `path` is empty (stdout, OFF) or has an ending that meshes can be written to; with a dimension
// other than 0 also when the format cannot hold it.
Outcome check_mesh_ending(const std::string& path, std::uint32_t dim);
// The files of a mesh by the ending of `path`: one, or three for .node.
void add_mesh_files(const MeshSource& mesh, const std::string& path, std::vector<FileJob>* jobs);

}  // namespace netmesh::tool
