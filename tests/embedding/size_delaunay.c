/* The smallest program that triangulates: points in a static array to the number of triangles. */
#include <netmesh.h>
#include <stdio.h>

static const double points[][2] = {{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 3}, {2, 2}};
static union {
    unsigned char bytes[65536];
    double aligned[2];
} block __attribute__((aligned(16)));

int main(void) {
    netmesh_context* context;
    netmesh_request request = netmesh_default_request();
    netmesh_cell cell;
    unsigned count = 0;
    if (netmesh_init(&block, sizeof block, &context) != NETMESH_OK) return 1;
    request.points.coordinates = points[0];
    request.points.count = sizeof points / sizeof points[0];
    request.points.dim = 2;
    request.mesh.method = &netmesh_method_delaunay;
    if (netmesh_mesh(context, &request) != NETMESH_OK) return 1;
    cell.struct_bytes = sizeof cell;
    while (netmesh_get_cell(context, count, &cell) == NETMESH_OK) ++count;
    printf("%u\n", count);
    return 0;
}
