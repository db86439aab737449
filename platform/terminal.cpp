#include "platform/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

namespace netmesh::platform {

bool stderr_is_terminal() { return isatty(2) == 1; }

int stderr_columns() {
    winsize size = {};
    if (ioctl(2, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    return 80;
}

}  // namespace netmesh::platform
