/* The other half: the loops of a mesh on those points. Exits with 0 when there is one. */
#include "netmesh.h"

#include <stdio.h>

extern const double* points_of_user(unsigned* count);

static unsigned char memory[(1 << 20) + 15];

int main(void) {
    unsigned char* block = memory + (16 - (uintptr_t)memory % 16) % 16;
    netmesh_mesh_request mesh;
    netmesh_persist_request persist;
    netmesh_context* context;
    netmesh_report report;
    netmesh_pair pair;
    unsigned count, loops = 0;
    uint64_t i;

    netmesh_mesh_request_init(&mesh, sizeof mesh, 2);
    mesh.points = points_of_user(&count);
    mesh.point_count = count;
    mesh.purpose = NETMESH_PURPOSE_PERSIST;
    netmesh_persist_request_init(&persist, sizeof persist);
    if (netmesh_init(block, 1 << 20, &context) != NETMESH_OK) return 2;
    if (netmesh_mesh(context, &mesh) != NETMESH_OK || netmesh_persist(context, &persist) != NETMESH_OK) return 3;
    pair.struct_bytes = sizeof pair;
    for (i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i)
        loops += pair.degree == 1 && pair.death > 1.2 * pair.birth;
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    printf("%u loop, certified ratio %.3f\n", loops, report.diagram.certified_ratio);
    return loops == 1 ? 0 : 1;
}
