// What a mesh request has to satisfy, and what it asks of the mesher.
#pragma once
#include "api/requests.hpp"

namespace netmesh {

// Numbers and enumerations, each by itself; what goes with the method and the purpose; the goal of the certificate.
Complaint complaint_about_numbers(const netmesh_mesh_request& request);
Complaint complaint_about_method(const netmesh_mesh_request& request);
Complaint complaint_about_goal(const netmesh_mesh_request& request);

// Is what it asks for, and has no complaints, in this build?
Complaint complaint_about_built_mesh(const netmesh_mesh_request& request);

// Of what the request says about a mesh that is there already: numbers and enumerations alone.
Complaint complaint_about_promises(const netmesh_mesh_request& request);

// Of a request without complaints. Sizes and domain are those of the tight filter where they are for it.
MeshRequest mesh_request_of(const netmesh_mesh_request& request);

// The sizes asked for: of the tight filter at least its own.
SizeRule sizes_of(const netmesh_mesh_request& request);

}  // namespace netmesh
