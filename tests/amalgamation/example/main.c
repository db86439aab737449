/* The other half: the loops of a mesh on those points. Exits with 0 when there is one. */
#include "netmesh.h"

#include <stdio.h>

extern const double* points_of_user(unsigned* count);

static unsigned char memory[(1 << 20) + 15];

int main(void) {
    unsigned char* block = memory + (16 - (uintptr_t)memory % 16) % 16;
    netmesh_request request = netmesh_default_request();
    netmesh_context* context;
    netmesh_report report;
    netmesh_pair pair;
    unsigned count, loops = 0;
    uint64_t i;

    request.points.coordinates = points_of_user(&count);
    request.points.count = count;
    request.points.dim = 2;
    request.filter = &netmesh_filter_complete;
    if (netmesh_init(block, 1 << 20, &context) != NETMESH_OK) return 2;
    if (netmesh_persist(context, &request) != NETMESH_OK) return 3;
    pair.struct_bytes = sizeof pair;
    for (i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i)
        loops += pair.degree == 1 && pair.death > 1.2 * pair.birth;
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    printf("%u loop, certified ratio %.3f\n", loops, report.diagram.certified_ratio);
    return loops == 1 ? 0 : 1;
}
