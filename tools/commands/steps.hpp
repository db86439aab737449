// Calls of the engine that several commands make, each a step inside the work of a session.
#pragma once
#include "tools/io/mesh_files.hpp"
#include "tools/io/vine_file.hpp"
#include "tools/requests.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

netmesh_status make_mesh(Session& session, const PointCloud& cloud);
// A diagram or vines, with the session's function.
netmesh_status persist(Session& session, netmesh_request request);

// What `persist` does with the session's request: of the points, or of a mesh that was read, whose vertices then are
// the cloud. A mesh that is made promises what the engine has made it for.
netmesh_status persist_as_asked(Session& session, const PointCloud& cloud, const MeshFiles* mesh = nullptr);

// All checkers, with what the session promises.
netmesh_status check_everything(Session& session);

}  // namespace netmesh::tool
