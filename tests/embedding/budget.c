/* A budget of polls (about ten milliseconds of work each): a job that goes beyond it stops with a valid mesh of what it had
 * inserted. There is no way to go on from there: a second call starts anew, in the same block, and with a larger budget gives
 * the result that it would have given at first. */
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
    netmesh_options options;
    netmesh_report report;
    int i, left;
    for (i = 0; i < 3 * POINTS; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        points[i] = (double)(state >> 40);
    }
    if (netmesh_init((unsigned char*)memory + (16 - at % 16) % 16, BLOCK_BYTES, &context) != NETMESH_OK) return 1;
    netmesh_options_init(&options, 3);
    options.poll = spend;
    options.user = &left;
    report.struct_bytes = sizeof report;

    left = 1;
    if (netmesh_delaunay(context, points, POINTS, &options) != NETMESH_CANCELLED) return 2;
    options.poll = NULL;
    if (netmesh_get_report(context, &report) != NETMESH_OK || report.complete || report.vertices == 0) return 3;
    if (netmesh_check(context, NETMESH_CHECK_ALL, &options) != NETMESH_OK) return 4;
    partial = report.cells;
    if (netmesh_persist(context, NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED, 2, 0, &options) != NETMESH_NO_RESULT)
        return 5;

    options.poll = spend;
    left = 1000000;
    if (netmesh_delaunay(context, points, POINTS, &options) != NETMESH_OK) return 6;
    if (netmesh_get_report(context, &report) != NETMESH_OK || !report.complete || report.inputs != POINTS) return 7;
    printf("%u cells within the budget, %u in all\n", (unsigned)partial, (unsigned)report.cells);
    return partial < report.cells ? 0 : 8;
}
