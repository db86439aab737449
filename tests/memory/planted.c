/* Hands the engine a coordinate that nobody has written: a checker that sees it ends the program. */
#include <stdio.h>
#include <stdlib.h>

#include "netmesh.h"

int main(void) {
    netmesh_context* context;
    netmesh_request request = netmesh_default_request();
    netmesh_report report;
    void* block = NULL;
    double* points = malloc(8 * sizeof *points);
    if (points == NULL || posix_memalign(&block, 16, 65536) != 0) return 0;
    for (int i = 0; i < 7; ++i) points[i] = i * i;
    request.points.coordinates = points;
    request.points.count = 4;
    request.points.dim = 2;
    request.mesh.method = &netmesh_method_delaunay;
    if (netmesh_init(block, 65536, &context) != NETMESH_OK) return 0;
    if (netmesh_mesh(context, &request) == NETMESH_OK) {
        report.struct_bytes = sizeof report;
        netmesh_get_report(context, &report);
        printf("%d cells\n", (int)report.mesh.cells);
    }
    return 0;
}
