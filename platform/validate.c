/* What a check of the engine that fails in a build with NETMESH_VALIDATE calls, see engine/vocabulary/validate.hpp. */
#include <stdio.h>
#include <stdlib.h>

void netmesh_validate_failed(const char* file, int line, const char* what);

void netmesh_validate_failed(const char* file, int line, const char* what) {
    fflush(stdout);
    fprintf(stderr, "%s:%d: %s\n", file, line, what);
    abort();
}
