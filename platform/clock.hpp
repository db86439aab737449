// Time that only goes forward.
#pragma once

namespace netmesh::platform {

// Seconds since some moment before the program started. Never decreases.
double seconds_now();

}  // namespace netmesh::platform
