#include "platform/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace netmesh::platform {

bool stderr_is_terminal() { return isatty(2) == 1; }

bool stderr_has_colours() {
    const char* const none = std::getenv("NO_COLOR");
    const char* const term = std::getenv("TERM");
    return stderr_is_terminal() && (none == nullptr || *none == 0) && term != nullptr && std::strcmp(term, "dumb") != 0;
}

int stderr_columns() {
    winsize size = {};
    if (ioctl(2, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    return 80;
}

}  // namespace netmesh::platform
