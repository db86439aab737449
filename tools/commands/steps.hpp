// Calls of the engine that several commands make, each a step inside the work of a session.
#pragma once
#include "tools/io/mesh_files.hpp"
#include "tools/io/vine_file.hpp"
#include "tools/requests.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

// What the filter needs before its diagram: a mesh (session.mesh()), a Delaunay triangulation, or nothing.
netmesh_status prepare_for(Session& session, const Options& options, netmesh_filter filter, const PointCloud& cloud);
netmesh_status make_mesh(Session& session, const PointCloud& cloud);
netmesh_status make_triangulation(Session& session, const Options& options, const PointCloud& cloud);

// The diagram, of what the session holds or of the points, whichever its filter goes by.
netmesh_status make_diagram(Session& session, const Options& options, const DiagramRequest& diagram,
                            const PointCloud& cloud);
// What `persist` does with the points: the mesh where there is one, the diagram, and bounds and cycles as far as the
// options ask for them. `mesh`: one that was read, in place of one made of the points; `cloud` is that of its vertices.
netmesh_status persist_as_asked(Session& session, const Options& options, const PointCloud& cloud,
                                const MeshFiles* mesh = nullptr);
// The vineyard of the mesh that the session holds or of the points, whichever its filter goes by; takes the vines out.
netmesh_status make_vineyard(Session& session, const VineyardRequest& vineyard, const PointCloud& cloud, Vines* vines);

netmesh_status bound_bars(Session& session);
netmesh_status find_cycles(Session& session);

// All checkers, with what session.mesh() promises.
netmesh_status check_everything(Session& session);

}  // namespace netmesh::tool
