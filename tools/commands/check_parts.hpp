// The parts of `check`: a mesh from its files, a diagram from points or mesh.
#pragma once
#include <string>
#include <vector>

#include "tools/io/mesh_files.hpp"
#include "tools/options.hpp"
#include "tools/outcome.hpp"
#include "tools/report/report.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

// The filters on meshes, with their values, that vertex values may be of, as far as --filter, --values and --k leave
// them open.
std::vector<FilterChoice> candidates(const Options& options);

Outcome mismatch(const std::string& what);  // Exit::check

// The mesh of the files, with its cages, taken over by the engine.
netmesh_status load_mesh(Session& session, const MeshFiles& files);

// Everything that can be said about a mesh: all checkers of the engine, the .neigh file, the inputs (--points), the
// vertex values. What holds goes to run->checked, what the engine measured to run->engine; the mesh stays in the
// session.
Outcome check_mesh(const Options& options, MeshFiles& files, RunReport* run, Session& session);

// The diagram of the positional argument: its form; and, where its head or the options say how it was made, the same run
// of the engine again from --points, or from --mesh with a second opinion by other code.
Outcome check_diagram(const Options& options, RunReport* run);

// The vineyard of the positional argument, likewise.
Outcome check_vines(const Options& options, RunReport* run);

}  // namespace netmesh::tool
