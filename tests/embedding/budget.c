/* A budget of polls: a job that goes beyond it stops with a valid mesh of what it had inserted. There is no way to go
 * on from there: a second call starts anew, in the same block, and with a larger budget gives the result that it would
 * have given at first.
 *
 * From one poll to the next are about 0.3 M instructions: a tenth of a millisecond on a desktop. A small part has its
 * polls 0.1 to 0.4 M instructions apart, which are 1 to 6 milliseconds at 100 MHz and 1 to 1.5 cycles an instruction.
 * Some are several times as long: tools/docs/small-parts.md. */
#include <netmesh.h>
#include <stdio.h>

#define POINTS 40000
#define BLOCK_BYTES ((size_t)64 << 20)

static double points[3 * POINTS];
static uint64_t memory[BLOCK_BYTES / 8 + 2];

static int spend(void* user, const netmesh_progress* progress) {
    int* left = user;
    (void)progress;
    return (*left)-- <= 0;
}

int main(void) {
    const uintptr_t at = (uintptr_t)memory;
    uint64_t state = 1, partial;
    netmesh_context* context;
    netmesh_request request = netmesh_default_request(), persist = netmesh_default_request();
    netmesh_check_request check = {sizeof check, 0, {NULL, NULL}, NULL};
    netmesh_report report;
    int i, left;
    for (i = 0; i < 3 * POINTS; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        points[i] = (double)(state >> 40);
    }
    if (netmesh_init((unsigned char*)memory + (16 - at % 16) % 16, BLOCK_BYTES, &context) != NETMESH_OK) return 1;
    request.points.coordinates = points;
    request.points.count = POINTS;
    request.points.dim = 3;
    request.mesh.method = &netmesh_method_delaunay;
    request.monitor.poll = spend;
    request.monitor.user = &left;
    persist.filter = &netmesh_filter_alpha; /* of what the context holds */
    report.struct_bytes = sizeof report;

    left = 600;
    if (netmesh_mesh(context, &request) != NETMESH_CANCELLED) return 2;
    if (netmesh_get_report(context, &report) != NETMESH_OK || report.complete || report.mesh.vertices == 0) return 3;
    if (netmesh_check(context, &check) != NETMESH_OK) return 4;
    partial = report.mesh.cells;
    if (netmesh_persist(context, &persist) != NETMESH_NO_RESULT) return 5;

    left = 1000000;
    if (netmesh_mesh(context, &request) != NETMESH_OK) return 6;
    if (netmesh_get_report(context, &report) != NETMESH_OK || !report.complete || report.mesh.inputs != POINTS)
        return 7;
    printf("%u cells within the budget, %u in all\n", (unsigned)partial, (unsigned)report.mesh.cells);
    return partial < report.mesh.cells ? 0 : 8;
}
