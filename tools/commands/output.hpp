// Results on their way out of a command.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "netmesh.h"
#include "tools/io/diagram_file.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/outcome.hpp"

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

// The mesh inside a context.
class ContextMesh : public MeshSource {
public:
    explicit ContextMesh(const netmesh_context* context);
    netmesh_vertex vertex(std::uint64_t index) const override;
    netmesh_cell cell(std::uint64_t index) const override;
    // Fills ratios and domains; leaves them empty when there is no memory left for that.
    void measure(netmesh_context* context);

private:
    const netmesh_context* context_;
};

// Empty unless the context holds bounds.
Bounds bounds_of(const netmesh_context* context);
// The diagram inside a context.
std::vector<Bar> bars_of(const netmesh_context* context);

// Exit::usage unless `path` is empty (stdout, OFF) or has an ending that meshes can be written to; with a dimension
// other than 0 also when the format cannot hold it.
Outcome check_mesh_ending(const std::string& path, std::uint32_t dim);
// The files of a mesh by the ending of `path`: one, or three for .node.
void add_mesh_files(const MeshSource& mesh, const std::string& path, std::vector<FileJob>* jobs);

}  // namespace netmesh::tool
