/* The smallest program with a certified diagram: points in a static array to a quality mesh to the number of pairs. */
#include <netmesh.h>
#include <stdio.h>

static const double points[][2] = {{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 3}, {2, 2}};
static union {
    unsigned char bytes[131072];
    double aligned[2];
} block __attribute__((aligned(16)));

int main(void) {
    netmesh_context* context;
    netmesh_mesh_request mesh;
    netmesh_persist_request persist;
    netmesh_pair pair;
    unsigned count = 0;
    if (netmesh_init(&block, sizeof block, &context) != NETMESH_OK) return 1;
    netmesh_mesh_request_init(&mesh, sizeof mesh, 2);
    mesh.points = points[0];
    mesh.point_count = sizeof points / sizeof points[0];
    mesh.purpose = NETMESH_PURPOSE_PERSIST;
    if (netmesh_mesh(context, &mesh) != NETMESH_OK) return 1;
    netmesh_persist_request_init(&persist, sizeof persist);
    if (netmesh_persist(context, &persist) != NETMESH_OK) return 1;
    pair.struct_bytes = sizeof pair;
    while (netmesh_get_pair(context, count, &pair) == NETMESH_OK) ++count;
    printf("%u\n", count);
    return 0;
}
