// What stands behind the message stream.
#pragma once

namespace netmesh::platform {

// True when stderr is a terminal that a person may be looking at.
bool stderr_is_terminal();

// Columns of that terminal; 80 when it does not say.
int stderr_columns();

}  // namespace netmesh::platform
