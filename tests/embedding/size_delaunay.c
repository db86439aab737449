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
    netmesh_delaunay_request request;
    netmesh_cell cell;
    unsigned count = 0;
    if (netmesh_init(&block, sizeof block, &context) != NETMESH_OK) return 1;
    netmesh_delaunay_request_init(&request, sizeof request, 2);
    request.points = points[0];
    request.point_count = sizeof points / sizeof points[0];
    if (netmesh_delaunay(context, &request) != NETMESH_OK) return 1;
    cell.struct_bytes = sizeof cell;
    while (netmesh_get_cell(context, count, &cell) == NETMESH_OK) ++count;
    printf("%u\n", count);
    return 0;
}
