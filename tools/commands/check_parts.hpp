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

// The filters and values that a file may come from, as far as --filter, --values and --k leave them open, of those that
// go by a mesh, a Delaunay triangulation, scales or the points themselves.
std::vector<FilterChoice> candidates(const Options& options, netmesh_source made_of);

Outcome mismatch(const std::string& what);  // Exit::check

// The mesh of the files, with its cages, taken over by the engine.
netmesh_status load_mesh(Session& session, const MeshFiles& files);

// Everything that can be said about a mesh: all checkers of the engine, the .neigh file, the inputs (--points), the
// vertex values. What holds goes to run->checked, what the engine measured to run->engine; the mesh stays in the
// session.
Outcome check_mesh(const Options& options, MeshFiles& files, RunReport* run, Session& session);

// The diagram of the positional argument: by itself, or recomputed from --mesh or --points.
Outcome check_diagram(const Options& options, RunReport* run);

// The vineyard of the positional argument, likewise.
Outcome check_vines(const Options& options, RunReport* run);

}  // namespace netmesh::tool
