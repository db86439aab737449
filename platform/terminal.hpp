// What stands behind the message stream.
#pragma once

namespace netmesh::platform {

// True when stderr is a terminal that a person may be looking at.
bool stderr_is_terminal();

// Whether it shows colours: it is a terminal, and neither NO_COLOR is set (no-color.org) nor TERM says that it is dumb.
bool stderr_has_colours();

// Columns of that terminal; 80 when it does not say.
int stderr_columns();

}  // namespace netmesh::platform
