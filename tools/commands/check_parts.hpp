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

// A filter and its kind of values, as a source that a file may come from.
struct Candidate {
    netmesh_filter filter;
    netmesh_values values;
};

// "filter complete, certified values"
std::string candidate_text(const Candidate& candidate);

// The candidates that --filter and --values leave, of those that work on a mesh or on a Delaunay triangulation.
std::vector<Candidate> candidates(const Options& options, bool on_mesh, bool on_delaunay);

Outcome mismatch(const std::string& what);  // Exit::check

// The engine's netmesh_load on the content of files.
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
